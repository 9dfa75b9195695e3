"""ProxQP, a proximal augmented Lagrangian method."""

import numpy as np
import scipy.sparse as sp
from proxsuite import proxqp

from qp import BoundQp
from qp_peer import SCALE, main

TOLERANCE = 1e-9


def solve(qp: BoundQp) -> tuple[np.ndarray, int]:
    m, size = len(qp.bounded), len(qp.load)
    select = sp.csc_matrix((np.ones(m), (np.arange(m), qp.bounded)), shape=(m, size))
    solver = proxqp.sparse.QP(size, 0, m)
    # Left to itself it turns to an iterative solver where the factor is large, and does not end.
    solver.settings.sparse_backend = proxqp.SparseBackend.SparseCholesky
    solver.settings.eps_abs = TOLERANCE
    solver.settings.eps_rel = 0.0
    solver.init(SCALE * qp.stiffness, -SCALE * qp.load, None, None, select, np.full(m, -1e20), np.zeros(m))
    solver.solve()
    if solver.results.info.status != proxqp.PROXQP_SOLVED:
        raise RuntimeError(f"ProxQP ended with {solver.results.info.status}")
    return np.array(solver.results.x), solver.results.info.iter


main("proxqp", "proxsuite", solve, f"numpy assembly; objective scaled by {SCALE:g}, absolute tolerance {TOLERANCE:g}")
