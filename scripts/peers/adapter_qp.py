"""The algebraic hand-over under `--solver`: K.mtx, f.mtx, upper.mtx and, where bodies move freely, N.mtx; active set.

Hears nothing of meshes, so curved bodies and free motions are no different. Needs SciPy only; where scikit-sparse is there,
CHOLMOD takes the place of SuperLU, in far less time.
"""

import os

import numpy as np
import scipy.sparse as sp
from scipy.linalg import qr
from scipy.sparse.linalg import splu

from active_set import primal_dual
from qp import BoundQp, ClosedSystem

try:
    from sksparse.cholmod import analyze
except ImportError:
    analyze = None


def numbers(path: str) -> tuple[list[int], np.ndarray]:
    """The line of sizes of a Matrix Market file, and all numbers behind it."""
    with open(path, encoding="utf-8") as file:
        lines = (line for line in file if not line.startswith("%") and line.strip())
        sizes = [int(word) for word in next(lines).split()]
        return sizes, np.array("".join(lines).split(), dtype=float)


def columns(path: str) -> np.ndarray:
    sizes, values = numbers(path)
    return values.reshape(sizes[1], sizes[0]).T


def symmetric(path: str) -> sp.csc_matrix:
    """A symmetric matrix of which the lower triangle is stored."""
    (size, _, count), values = numbers(path)
    row, column, value = values.reshape(count, 3).T
    row, column = row.astype(int) - 1, column.astype(int) - 1
    lower = sp.csc_matrix((value, (row, column)), shape=(size, size))
    return sp.csc_matrix(lower + sp.tril(lower, -1).T)


def pinned(motions: np.ndarray, bounded: np.ndarray) -> np.ndarray:
    """Unknowns to hold so that none of the motions is left: as many as there are motions, none of them bounded."""
    free = np.setdiff1d(np.arange(len(motions)), bounded)
    _, _, order = qr(motions[free].T, pivoting=True, mode="economic")
    return free[order[: motions.shape[1]]]


stiffness, load, upper = symmetric("K.mtx"), columns("f.mtx")[:, 0], columns("upper.mtx")[:, 0]
held = np.zeros(0, dtype=int)
bounded = np.flatnonzero(np.isfinite(upper))
if os.path.exists("N.mtx"):
    held = pinned(columns("N.mtx"), bounded)
# x = back @ y + offset with y_c <= 0; pinned unknowns stay at 0
offset = np.where(np.isfinite(upper), upper, 0.0)
kept = np.setdiff1d(np.arange(len(load)), held)
back = sp.identity(len(load), format="csr")[:, kept]
reduced = sp.csc_matrix(back.T @ stiffness @ back)
reduced.sort_indices()
qp = BoundQp(reduced, back.T @ (load - stiffness @ offset), np.searchsorted(kept, bounded), back)
system = ClosedSystem(qp)
factor = analyze(qp.stiffness) if analyze else None


def solve(closed):
    matrix, right = system.at(closed)
    if factor:
        factor.cholesky_inplace(matrix)
        return factor(right)
    # The settings that SuperLU recommends for symmetric matrices.
    options = {"SymmetricMode": True}
    return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options).solve(right)


x = back @ primal_dual(qp, solve).x + offset
with open("x.mtx", "w", encoding="utf-8") as out:
    out.write(f"%%MatrixMarket matrix array real general\n{len(x)} 1\n")
    out.writelines(f"{float(value)!r}\n" for value in x)
