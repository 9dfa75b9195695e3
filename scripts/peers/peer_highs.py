"""HiGHS, whose solver of quadratic problems is an active set method with a dense null space."""

import highspy
import numpy as np
import scipy.sparse as sp

from qp import BoundQp
from qp_peer import SCALE, main

TOLERANCE = 1e-10


def solve(qp: BoundQp) -> tuple[np.ndarray, int]:
    size = len(qp.load)
    model = highspy.HighsModel()
    lp, hessian = model.lp_, model.hessian_
    lp.num_col_, lp.num_row_ = size, 0
    lp.col_cost_ = -SCALE * qp.load
    lp.col_lower_ = np.full(size, -highspy.kHighsInf)
    upper = np.full(size, highspy.kHighsInf)
    upper[qp.bounded] = 0.0
    lp.col_upper_ = upper
    lp.a_matrix_.start_ = np.zeros(size + 1, dtype=np.int32)
    triangle = sp.tril(SCALE * qp.stiffness, format="csc")
    hessian.dim_ = size
    hessian.format_ = highspy.HessianFormat.kTriangular
    hessian.start_, hessian.index_, hessian.value_ = triangle.indptr, triangle.indices, triangle.data
    solver = highspy.Highs()
    solver.silent()
    for option in ("primal_feasibility_tolerance", "dual_feasibility_tolerance"):
        solver.setOptionValue(option, TOLERANCE)
    # Everything free spans the null space, whose dimension HiGHS limits to 4000 by default.
    solver.setOptionValue("qp_nullspace_limit", size)
    solver.passModel(model)
    solver.run()
    if solver.getModelStatus() != highspy.HighsModelStatus.kOptimal:
        raise RuntimeError(f"HiGHS ended with {solver.getModelStatus()}")
    return np.array(solver.getSolution().col_value), solver.getInfo().qp_iteration_count


main("highs", "highspy", solve, f"numpy assembly; objective scaled by {SCALE:g}, tolerances {TOLERANCE:g}")
