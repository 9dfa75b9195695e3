"""OSQP, an operator splitting method (ADMM) with polishing."""

import numpy as np
import osqp
import scipy.sparse as sp

from qp import BoundQp
from qp_peer import SCALE, main

TOLERANCE = 1e-8


def solve(qp: BoundQp) -> tuple[np.ndarray, int]:
    m, size = len(qp.bounded), len(qp.load)
    select = sp.csc_matrix((np.ones(m), (np.arange(m), qp.bounded)), shape=(m, size))
    solver = osqp.OSQP()
    solver.setup(
        sp.triu(SCALE * qp.stiffness, format="csc"),
        -SCALE * qp.load,
        select,
        np.full(m, -np.inf),
        np.zeros(m),
        eps_abs=TOLERANCE,
        eps_rel=TOLERANCE,
        max_iter=1_000_000,
        polishing=True,
        verbose=False,
    )
    answer = solver.solve()
    if answer.info.status != "solved":
        raise RuntimeError(f"OSQP ended with {answer.info.status}")
    return answer.x, answer.info.iter


main("osqp", "osqp", solve, f"numpy assembly; objective scaled by {SCALE:g}, tolerances {TOLERANCE:g}, polished")
