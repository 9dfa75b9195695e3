"""Everything by numpy and scipy: vectorised assembly, active set, SuperLU."""

import scipy
from scipy.sparse.linalg import splu

import scene
from active_set import primal_dual
from qp import ClosedSystem, bound_qp
from report import Run

run = Run("scipy")
with run.phase("mesh"):
    mesh = scene.mesh(run.n)
with run.phase("assembly"):
    qp = bound_qp(mesh, scene.stiffness(mesh), scene.load(mesh))
with run.phase("setup"):
    system = ClosedSystem(qp)


def solve(closed):
    matrix, load = system.at(closed)
    # The settings that SuperLU recommends for symmetric matrices.
    options = {"SymmetricMode": True}
    return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options).solve(load)


with run.phase("solve"):
    outcome = primal_dual(qp, solve)

run.finish(
    qp.displacements(outcome.x),
    version=f"scipy {scipy.__version__}",
    iterations=outcome.steps,
    closed=int(outcome.closed.sum()),
    note="active set, SuperLU with minimum degree of AᵀA+A in each step",
)
