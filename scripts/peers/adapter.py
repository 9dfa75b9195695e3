"""What the adapters share: a level as `signorini run STUDY --solver` hands it over, in a form that finite element codes take.

    mesh.msh, problem.json ──► Level ──► the code's own stiffness K ──► Reduction ──► BoundQp ──► displacement.csv

An adapter that cannot do what a level asks for says so and ends with status 2.
"""

import json
import sys
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from scipy.linalg import qr

from qp import BoundQp

CHORDS = "--chords"


def refuse(words: str) -> None:
    """Ends the program: the level asks for what the adapter cannot do."""
    print(f"refused: {words}", file=sys.stderr)
    raise SystemExit(2)


@dataclass(frozen=True)
class Level:
    """One level. Nodes count from 0, both bodies together; component c of node i has the number 2 i + c."""

    points: np.ndarray  # (nodes, 2)
    triangles: np.ndarray  # (elements, 3), counter-clockwise
    bodies: np.ndarray  # (elements,), 0 or 1
    hooke: np.ndarray  # (2, 3, 3): C of each body, (τ11, τ22, τ12) = C (ε11, ε22, 2ε12)
    load: np.ndarray  # (2 nodes,): body forces and tractions, integrated
    supports: list[dict]
    pairs: list[dict]

    def nodes_of(self, body: int) -> np.ndarray:
        return np.unique(self.triangles[self.bodies == body])


def read() -> Level:
    """The level in the current folder. Refuses curved bodies, unless `--chords` takes their chords instead, and bodies that slide freely."""
    with open("problem.json", encoding="utf-8") as file:
        problem = json.load(file)
    if problem["curved"] and CHORDS not in sys.argv[1:]:
        refuse(f"sides are curved, and the mesh has only their chords; adapter_qp.py takes the matrices, {CHORDS} the chords")
    if problem["free_motions"] > 0:
        refuse("a body may move freely both ways, so the stiffness is singular; adapter_qp.py takes N.mtx")
    points, triangles, bodies = read_mesh("mesh.msh")
    hooke = np.array([body["hooke"] for body in problem["bodies"]])
    load = np.array(problem["nodal_load"]).ravel()
    return Level(points, triangles, bodies, hooke, load, problem["supports"], problem["pairs"])


def read_mesh(path: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points, triangles and the body of each triangle from Gmsh 4.1 text whose nodes are numbered from 1 without gaps."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    at = lines.index("$Nodes") + 1
    blocks, count = (int(word) for word in lines[at].split()[:2])
    points = np.empty((count, 2))
    at += 1
    for _ in range(blocks):
        size = int(lines[at].split()[3])
        tags = np.array(lines[at + 1 : at + 1 + size], dtype=int)
        values = np.array(" ".join(lines[at + 1 + size : at + 1 + 2 * size]).split(), dtype=float)
        points[tags - 1] = values.reshape(size, 3)[:, :2]
        at += 1 + 2 * size
    at = lines.index("$Elements") + 1
    blocks = int(lines[at].split()[0])
    at += 1
    triangles, bodies = [], []
    for _ in range(blocks):
        dimension, entity, _, size = (int(word) for word in lines[at].split())
        if dimension == 2:
            rows = np.array(" ".join(lines[at + 1 : at + 1 + size]).split(), dtype=int).reshape(size, 4)
            triangles.append(rows[:, 1:] - 1)
            bodies.append(np.full(size, entity - 1))
        at += 1 + size
    return points, np.concatenate(triangles), np.concatenate(bodies)


@dataclass(frozen=True)
class Equations:
    """Rows of A u = a, or of A u <= a, on all displacement components."""

    matrix: sp.csr_matrix
    right: np.ndarray


def equations(level: Level) -> tuple[Equations, Equations]:
    """What always holds (supports, bilateral pairs), and the constraints of contact, n·(u' - u'') <= gap."""
    held = [([(s["node"], n)], float(np.dot(n, s["displacement"]))) for s in level.supports for n in held_directions(s)]
    contact = []
    for pair in level.pairs:
        for c in pair["constraints"]:
            row = ([(pair["first"], c["normal"]), (pair["second"], np.negative(c["normal"]))], c["gap"])
            (held if c["bilateral"] else contact).append(row)
    return rows(held, len(level.load)), rows(contact, len(level.load))


def held_directions(support: dict) -> list:
    """Unit vectors in which a held node may not move."""
    if not support["free"]:
        return [[1.0, 0.0], [0.0, 1.0]]
    (x, y), = support["free"]
    return [[-y, x]]


def rows(found: list, size: int) -> Equations:
    entries = [(k, 2 * (node - 1) + c, n[c]) for k, (terms, _) in enumerate(found) for node, n in terms for c in (0, 1)]
    row, column, value = zip(*entries) if entries else ((), (), ())
    matrix = sp.csr_matrix((value, (row, column)), shape=(len(found), size), dtype=float)
    return Equations(matrix, np.array([right for _, right in found], dtype=float))


@dataclass(frozen=True)
class Reduction:
    """u = back @ x + offset, where every constraint that is left reads x_c <= 0 for one unknown c of `bounded`."""

    back: sp.csr_matrix
    offset: np.ndarray
    bounded: np.ndarray

    def qp(self, stiffness: sp.spmatrix, load: np.ndarray) -> BoundQp:
        """min ½ uᵀKu - fᵀu in the unknowns x."""
        reduced = sp.csc_matrix(self.back.T @ stiffness @ self.back)
        reduced.sort_indices()
        return BoundQp(reduced, self.back.T @ (load - stiffness @ self.offset), self.bounded, self.back)

    def displacements(self, x: np.ndarray) -> np.ndarray:
        """Nodal displacements (nodes, 2)."""
        return (self.back @ x + self.offset).reshape(-1, 2)


def reduction(level: Level) -> Reduction:
    """Solves the supports and gives each contact pair unknowns in which its constraints bound single ones."""
    builder = Builder(level)
    for pair in level.pairs:
        builder.add_pair(pair)
    return builder.finish()


class Builder:
    """Collects the columns of a Reduction, pair by pair; what no pair takes stays as it is."""

    def __init__(self, level: Level):
        size = len(level.load)
        self.offset = np.zeros(size)
        # the free directions (2, k) of each held node
        self.directions = {}
        for support in level.supports:
            node = support["node"] - 1
            self.directions[node] = np.array(support["free"], dtype=float).reshape(-1, 2).T
            self.offset[2 * node : 2 * node + 2] = support["displacement"]
        self.taken = set()
        self.entries = ([], [], [])
        self.columns, self.bounded = 0, []
        self.nodes = size // 2

    def add_pair(self, pair: dict) -> None:
        nodes = [pair["first"] - 1, pair["second"] - 1]
        if self.taken & set(nodes):
            refuse(f"a node of the pair {pair['first']}, {pair['second']} belongs to another pair as well")
        self.taken |= set(nodes)
        local = np.concatenate([[2 * node, 2 * node + 1] for node in nodes])
        # u of both nodes = free @ z + offset
        free = block(*(self.directions.get(node, np.eye(2)) for node in nodes))
        constraints = Constraints(free.shape[1])
        for c in pair["constraints"]:
            normal = np.concatenate([c["normal"], np.negative(c["normal"])])
            constraints.add(normal @ free, c["gap"] - normal @ self.offset[local], c["bilateral"], pair)
        # x = basis @ z, the constrained ones first; z = inverse @ x
        inverse = free @ np.linalg.inv(complete(constraints.rows, free.shape[1]))
        for k, (right, tied) in enumerate(zip(constraints.right, constraints.tied)):
            self.offset[local] += inverse[:, k] * right
            if not tied:
                self.bounded.append(self.columns)
                self.append(local, inverse[:, k])
        for k in range(len(constraints.rows), free.shape[1]):
            self.append(local, inverse[:, k])

    def append(self, local: np.ndarray, column: np.ndarray) -> None:
        for row, value in zip(local, column):
            if value != 0.0:
                for store, entry in zip(self.entries, (row, self.columns, value)):
                    store.append(entry)
        self.columns += 1

    def finish(self) -> Reduction:
        for node, directions in self.directions.items():
            if node not in self.taken:
                for column in directions.T:
                    self.append(np.array([2 * node, 2 * node + 1]), column)
        others = np.setdiff1d(np.arange(self.nodes), np.fromiter(self.taken | set(self.directions), dtype=int))
        plain = (2 * others[:, None] + np.arange(2)).ravel()
        row = np.concatenate([np.array(self.entries[0], dtype=int), plain])
        column = np.concatenate([np.array(self.entries[1], dtype=int), self.columns + np.arange(len(plain))])
        value = np.concatenate([np.array(self.entries[2], dtype=float), np.ones(len(plain))])
        shape = (2 * self.nodes, self.columns + len(plain))
        return Reduction(sp.csr_matrix((value, (row, column)), shape=shape), self.offset, np.array(self.bounded, dtype=int))


class Constraints:
    """The constraints of a pair on its free components: rows·z <= right, = where tied; independent rows only."""

    SMALL = 1e-10

    def __init__(self, free: int):
        self.rows, self.right, self.tied = np.zeros((0, free)), [], []

    def add(self, row: np.ndarray, right: float, tied: bool, pair: dict) -> None:
        size = np.linalg.norm(row)
        name = f"the pair {pair['first']}, {pair['second']}"
        if size < self.SMALL:
            # the supports have decided
            if right < -self.SMALL or (tied and right > self.SMALL):
                refuse(f"the supports of {name} break its constraint by {abs(right):g}")
            return
        row, right = row / size, right / size
        for k, other in enumerate(self.rows):
            if abs(np.linalg.norm(row - other)) < self.SMALL and not tied and not self.tied[k]:
                self.right[k] = min(self.right[k], right)
                return
            if abs(row @ other) > 1 - self.SMALL:
                refuse(f"the supports of {name} leave it two constraints in one direction")
        self.rows = np.vstack([self.rows, row])
        self.right.append(right)
        self.tied.append(tied)


def block(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """first and second on the diagonal; either may have no columns."""
    out = np.zeros((4, first.shape[1] + second.shape[1]))
    out[:2, : first.shape[1]] = first
    out[2:, first.shape[1] :] = second
    return out


def complete(constraints: np.ndarray, size: int) -> np.ndarray:
    """An invertible matrix that begins with the constraints and goes on with unit vectors, those furthest from them."""
    # I - Rᵀ(RRᵀ)⁻¹R: what the constraints leave of each unit vector
    left = np.eye(size) - np.linalg.pinv(constraints) @ constraints
    _, _, order = qr(left, pivoting=True)
    return np.vstack([constraints, np.eye(size)[order[: size - len(constraints)]]])


def write(displacements: np.ndarray) -> None:
    """Leaves the answer: every node once, numbers that read back to the last bit."""
    with open("displacement.csv", "w", encoding="utf-8") as out:
        out.write("node,ux,uy\n")
        out.writelines(f"{i + 1},{float(x)!r},{float(y)!r}\n" for i, (x, y) in enumerate(displacements))
