"""Clarabel, an interior-point method."""

import clarabel
import numpy as np
import scipy.sparse as sp

from qp import BoundQp
from qp_peer import SCALE, main

TOLERANCE = 1e-11


def solve(qp: BoundQp) -> tuple[np.ndarray, int]:
    m, size = len(qp.bounded), len(qp.load)
    # A x + s = b, s >= 0: only the bounds that exist.
    select = sp.csc_matrix((np.ones(m), (np.arange(m), qp.bounded)), shape=(m, size))
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.max_threads = 1
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = TOLERANCE
    cones = [clarabel.NonnegativeConeT(m)]
    objective = (sp.triu(SCALE * qp.stiffness, format="csc"), -SCALE * qp.load)
    answer = clarabel.DefaultSolver(*objective, select, np.zeros(m), cones, settings).solve()
    if str(answer.status) not in ("Solved", "AlmostSolved"):
        raise RuntimeError(f"Clarabel ended with {answer.status}")
    return np.array(answer.x), answer.iterations


main("clarabel", "clarabel", solve, f"numpy assembly; objective scaled by {SCALE:g}, tolerances {TOLERANCE:g}")
