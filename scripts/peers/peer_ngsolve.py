"""NGSolve assembles and factorises; the active set is ours."""

import netgen.meshing as netgen
import ngsolve
import numpy as np
import scipy.sparse as sp
from ngsolve.la import SparseMatrixd

import scene
from active_set import primal_dual
from qp import ClosedSystem, bound_qp
from report import Run


def triangulation(mesh: scene.Mesh) -> ngsolve.Mesh:
    """Both bodies in one mesh; the top is boundary 1."""
    out = netgen.Mesh(dim=2)
    out.AddPoints(np.column_stack([mesh.points, np.zeros(len(mesh.points))]))
    out.Add(netgen.FaceDescriptor(surfnr=1, domin=1, bc=1))
    out.AddElements(dim=2, index=1, data=mesh.triangles.astype(np.int32), base=0)
    # Seen from the body, the top runs from right to left.
    sides = np.column_stack([mesh.top[1:], mesh.top[:-1]])
    out.AddElements(dim=1, index=1, data=sides.astype(np.int32), base=0)
    return ngsolve.Mesh(out)


def to_scipy(matrix) -> sp.csr_matrix:
    """An NGSolve matrix of 2 by 2 blocks or of numbers."""
    values, columns, starts = matrix.CSR()
    return sp.csr_matrix((np.array(values), np.array(columns), np.array(starts)), shape=(matrix.height, matrix.width))


run = Run("ngsolve")
ngsolve.SetNumThreads(1)
with run.phase("mesh"):
    mesh = scene.mesh(run.n)
    native = triangulation(mesh)
with run.phase("assembly"):
    space = ngsolve.VectorH1(native, order=1)
    u, v = space.TnT()
    strain, test = ngsolve.Sym(ngsolve.Grad(u)), ngsolve.Sym(ngsolve.Grad(v))
    energy = scene.LAMBDA * ngsolve.div(u) * ngsolve.div(v) + 2 * scene.MU * ngsolve.InnerProduct(strain, test)
    a = ngsolve.BilinearForm(energy * ngsolve.dx).Assemble()
    f = ngsolve.LinearForm(scene.pressure(ngsolve.x) * v[1] * ngsolve.ds).Assemble()
    # Component by component there, node by node here.
    ours = np.arange(2 * len(mesh.points)).reshape(-1, 2).T.ravel()
    stiffness, load = to_scipy(a.mat).tocoo(), np.empty(len(ours))
    stiffness = sp.csr_matrix((stiffness.data, (ours[stiffness.row], ours[stiffness.col])), shape=stiffness.shape)
    load[ours] = f.vec.FV().NumPy()
    qp = bound_qp(mesh, stiffness, load)
with run.phase("setup"):
    system = ClosedSystem(qp)


def solve(closed):
    matrix, load = system.at(closed)
    size, entries = len(load), matrix.tocoo()
    native_matrix = SparseMatrixd.CreateFromCOO(entries.row, entries.col, entries.data, size, size)
    b, x = native_matrix.CreateColVector(), native_matrix.CreateColVector()
    b.FV().NumPy()[:] = load
    x.data = native_matrix.Inverse(inverse="sparsecholesky") * b
    return np.array(x.FV().NumPy())


with run.phase("solve"):
    outcome = primal_dual(qp, solve)

run.finish(
    qp.displacements(outcome.x),
    version=f"NGSolve {ngsolve.__version__}",
    iterations=outcome.steps,
    closed=int(outcome.closed.sum()),
    note="active set, sparsecholesky in each step",
)
