"""One CHOLMOD factorisation with the contact unknowns last; active set on the Schur complement."""

from importlib.metadata import version

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
from sksparse.cholmod import analyze

import scene
from qp import BoundQp, bound_qp
from report import Run


def contact_last(qp: BoundQp) -> np.ndarray:
    """CHOLMOD's own fill-reducing order of the other unknowns, then the contact unknowns."""
    others = np.setdiff1d(np.arange(len(qp.load)), qp.bounded)
    inner = analyze(qp.stiffness[np.ix_(others, others)].tocsc(), mode="supernodal").P()
    return np.concatenate([others[inner], qp.bounded])


def shifted(qp: BoundQp, order: np.ndarray, sigma: float) -> sp.csc_matrix:
    """K + sigma I on the contact unknowns, in the given order; definite although one body floats."""
    extra = np.zeros(len(qp.load))
    extra[qp.bounded] = sigma
    return (qp.stiffness + sp.diags(extra)).tocsc()[np.ix_(order, order)].tocsc()


def dense_active_set(schur: np.ndarray, load: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Primal-dual active set for min ½ xᵀSx - gᵀx, x <= 0: the answer, the closed mask, the steps."""
    closed = np.ones(len(load), dtype=bool)
    for step in range(1, 61):
        x = np.zeros(len(load))
        if not closed.all():
            x[~closed] = la.solve(schur[np.ix_(~closed, ~closed)], load[~closed], assume_a="pos")
        following = np.where(closed, load - schur @ x > 0, x > 0)
        if np.array_equal(following, closed):
            return x, closed, step
        closed = following
    raise RuntimeError("no active set after 60 steps")


run = Run("condensed")
with run.phase("mesh"):
    mesh = scene.mesh(run.n)
with run.phase("assembly"):
    qp = bound_qp(mesh, scene.stiffness(mesh), scene.load(mesh))
with run.phase("setup"):
    m = len(qp.bounded)
    sigma = float(qp.stiffness.diagonal().mean())
    order = contact_last(qp)
    matrix = shifted(qp, order, sigma)
    factor = analyze(matrix, mode="supernodal", ordering_method="natural")
    factor.cholesky_inplace(matrix)
with run.phase("solve"):
    load = qp.load[order]
    # A supernodal factor may still postorder what it was given; the contact unknowns have to stay last.
    inner = factor.P()
    assert np.array_equal(np.sort(inner[-m:]), np.arange(len(load) - m, len(load)))
    # L y = P f; the trailing block is the triangle of S + sigma I.
    y = factor.solve_L(factor.apply_P(load), use_LDLt_decomposition=False)
    last = factor.L()[-m:, -m:].toarray()
    schur = last @ last.T - sigma * np.eye(m)
    x_contact, closed, steps = dense_active_set(schur, last @ y[-m:])
    # With x_c known, Lᵀ x = y on the other rows: replace the last entries of y by L_ccᵀ x_c.
    y[-m:] = last.T @ x_contact
    x = np.empty(len(load))
    x[order] = factor.apply_Pt(factor.solve_Lt(y, use_LDLt_decomposition=False))

run.finish(
    qp.displacements(x),
    version=f"scikit-sparse {version('scikit-sparse')}",
    iterations=steps,
    closed=int(closed.sum()),
    note="numpy assembly; CHOLMOD once, contact unknowns last; active set on the dense Schur complement",
)
