"""scikit-fem under `--solver`: it assembles on the mesh that is handed over; active set, CHOLMOD."""

import skfem
from sksparse.cholmod import analyze

import adapter
from active_set import primal_dual
from qp import ClosedSystem

level = adapter.read()
mesh = skfem.MeshTri(level.points.T, level.triangles.T)
# Gradients are constant: one point is exact.
basis = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementTriP1()), intorder=0)
# Both bodies are one mesh that does not hang together; C is constant on each element.
hooke = level.hooke[level.bodies].transpose(1, 2, 0)[..., None]


def strain(gradient):
    """(ε11, ε22, 2ε12)"""
    return gradient[0, 0], gradient[1, 1], gradient[0, 1] + gradient[1, 0]


@skfem.BilinearForm
def elasticity(u, v, _):
    mine, test = strain(u.grad), strain(v.grad)
    return sum(hooke[i, j] * mine[j] * test[i] for i in range(3) for j in range(3))


reduction = adapter.reduction(level)
# Component c of node i is number 2 i + c there as well.
assert (basis.nodal_dofs.T.ravel() == range(len(level.load))).all()
qp = reduction.qp(elasticity.assemble(basis), level.load)
system = ClosedSystem(qp)
factor = analyze(qp.stiffness)


def solve(closed):
    matrix, load = system.at(closed)
    factor.cholesky_inplace(matrix)
    return factor(load)


adapter.write(reduction.displacements(primal_dual(qp, solve).x))
