"""FreeFEM under `--solver`: it reads the mesh in its own form, assembles, and runs an active set with MUMPS (adapter.edp)."""

import os
import subprocess
from pathlib import Path

import numpy as np

import adapter
from freefem import PLACES

SCRIPT = Path(__file__).with_name("adapter.edp")


def lines(path: str, head: str, *columns: np.ndarray) -> None:
    """One line for each row of the columns, below a heading; numbers that read back to the last bit."""
    with open(path, "w", encoding="utf-8") as out:
        out.write(head)
        out.writelines(" ".join(map(repr, row)) + "\n" for row in zip(*(column.tolist() for column in columns)))


def write_mesh(path: str, points: np.ndarray, triangles: np.ndarray) -> None:
    """FreeFEM's own form: vertices x y label, triangles i j k label, no boundary sides."""
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"{len(points)} {len(triangles)} 0\n")
        out.writelines(f"{x!r} {y!r} 0\n" for x, y in points.tolist())
        out.writelines(f"{a} {b} {c} 0\n" for a, b, c in (triangles + 1).tolist())


level = adapter.read()
reduction = adapter.reduction(level)
# FreeFEM takes no mesh with two nodes in one place, so each body is a mesh of its own.
bodies = [level.nodes_of(body) for body in range(2)]
for body, (name, nodes) in enumerate(zip(("first.msh", "second.msh"), bodies)):
    write_mesh(name, level.points[nodes], np.searchsorted(nodes, level.triangles[level.bodies == body]))
# Their order: the nodes of the first body, then those of the second.
nodes = np.concatenate(bodies)
order = (2 * nodes[:, None] + np.arange(2)).ravel()
lines("hooke.txt", "", *level.hooke.reshape(2, 9).T)
lines("load.txt", "", level.load[order])
lines("offset.txt", "", reduction.offset[order])
back = reduction.back[order].tocoo()
lines("back.txt", f"{back.shape[1]} {back.nnz}\n", back.row, back.col, back.data)
lines("bounded.txt", f"{len(reduction.bounded)}\n", reduction.bounded)
subprocess.run(["FreeFem++", "-ne", "-nw", "-v", "0", str(SCRIPT)], env=os.environ | PLACES, check=True)
u = np.empty_like(level.points)
u[nodes] = np.loadtxt("u.txt")
adapter.write(u)
