"""scikit-fem assembles; active set, CHOLMOD."""

from importlib.metadata import version

import skfem
from skfem.models.elasticity import linear_elasticity
from sksparse.cholmod import analyze

import scene
from active_set import primal_dual
from qp import ClosedSystem, bound_qp
from report import Run

run = Run("scikit-fem")
with run.phase("mesh"):
    mesh = scene.mesh(run.n)
    triangulation = skfem.MeshTri(mesh.points.T, mesh.triangles.T)


@skfem.LinearForm
def traction(v, w):
    return scene.pressure(w.x[0]) * v[1]


with run.phase("assembly"):
    element = skfem.ElementVector(skfem.ElementTriP1())
    # Gradients are constant: one point is exact.
    basis = skfem.Basis(triangulation, element, intorder=0)
    top = skfem.FacetBasis(triangulation, element, facets=triangulation.facets_satisfying(lambda x: x[1] == 1.0), intorder=2)
    stiffness = linear_elasticity(scene.LAMBDA, scene.MU).assemble(basis)
    qp = bound_qp(mesh, stiffness, traction.assemble(top))
with run.phase("setup"):
    system = ClosedSystem(qp)
    factor = analyze(qp.stiffness)


def solve(closed):
    matrix, load = system.at(closed)
    factor.cholesky_inplace(matrix)
    return factor(load)


with run.phase("solve"):
    outcome = primal_dual(qp, solve)

run.finish(
    qp.displacements(outcome.x),
    version=f"scikit-fem {version('scikit-fem')}, scikit-sparse {version('scikit-sparse')}",
    iterations=outcome.steps,
    closed=int(outcome.closed.sum()),
    note="active set, CHOLMOD: one symbolic analysis, a numeric factorisation in each step",
)
