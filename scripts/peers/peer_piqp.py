"""PIQP, a proximal interior-point method."""

import numpy as np
import piqp

from qp import BoundQp
from qp_peer import SCALE, main

TOLERANCE = 1e-11


def solve(qp: BoundQp) -> tuple[np.ndarray, int]:
    upper = np.full(len(qp.load), np.inf)
    upper[qp.bounded] = 0.0
    solver = piqp.SparseSolver()
    solver.settings.verbose = False
    solver.settings.eps_abs = solver.settings.eps_duality_gap_abs = TOLERANCE
    solver.settings.eps_rel = solver.settings.eps_duality_gap_rel = 0.0
    solver.setup(SCALE * qp.stiffness, -SCALE * qp.load, x_u=upper)
    status = solver.solve()
    if status != piqp.PIQP_SOLVED:
        raise RuntimeError(f"PIQP ended with {status}")
    return np.array(solver.result.x), solver.result.info.iter


main("piqp", "piqp", solve, f"numpy assembly; objective scaled by {SCALE:g}, absolute tolerance {TOLERANCE:g}")
