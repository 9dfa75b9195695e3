"""PETSc: SNES for variational inequalities (reduced-space Newton) with a direct solver."""

import sys

import numpy as np
import petsc4py

petsc4py.init(sys.argv[:1])
from petsc4py import PETSc  # PETSc must be initialised first

import scene
from qp import ClosedSystem, bound_qp
from report import Run


def cholesky(a: PETSc.Mat) -> PETSc.KSP:
    solver = PETSc.KSP().create(comm=PETSc.COMM_SELF)
    solver.setOperators(a)
    solver.setType("preonly")
    solver.getPC().setType("cholesky")
    solver.getPC().setFactorSolverType("cholmod")
    return solver


def to_petsc(matrix) -> PETSc.Mat:
    rows = matrix.tocsr()
    csr = (rows.indptr.astype(PETSc.IntType), rows.indices.astype(PETSc.IntType), rows.data)
    return PETSc.Mat().createAIJ(rows.shape, csr=csr, comm=PETSc.COMM_SELF)


def vector(values: np.ndarray) -> PETSc.Vec:
    return PETSc.Vec().createWithArray(values.copy(), comm=PETSc.COMM_SELF)


run = Run("petsc-vi")
with run.phase("mesh"):
    mesh = scene.mesh(run.n)
with run.phase("assembly"):
    qp = bound_qp(mesh, scene.stiffness(mesh), scene.load(mesh))
    a, f = to_petsc(qp.stiffness), vector(qp.load)
with run.phase("setup"):
    # Newton starts from all pairs closed: with none, one body floats and the matrix is singular.
    tied, load = ClosedSystem(qp).at(np.ones(len(qp.bounded), dtype=bool))
    x = vector(np.zeros(len(load)))
    cholesky(to_petsc(tied)).solve(vector(load), x)
with run.phase("solve"):
    upper = np.full(len(qp.load), PETSc.INFINITY)
    upper[qp.bounded] = 0.0
    residual = f.duplicate()

    def gradient(_snes, at, out):
        a.mult(at, out)
        out.axpy(-1.0, f)

    snes = PETSc.SNES().create(comm=PETSc.COMM_SELF)
    snes.setType("vinewtonrsls")
    snes.setFunction(gradient, residual)
    snes.setJacobian(lambda _snes, _at, _jacobian, _preconditioner: None, a)
    lower = np.full(len(qp.load), PETSc.NINFINITY)
    snes.setVariableBounds(vector(lower), vector(upper))
    PETSc.Options().setValue("snes_linesearch_type", "basic")
    snes.setFromOptions()
    snes.getKSP().setType("preonly")
    snes.getKSP().getPC().setType("cholesky")
    snes.getKSP().getPC().setFactorSolverType("cholmod")
    # The residual of a direct solver stalls at rounding, which grows with the size; the step is the better measure.
    snes.setTolerances(rtol=1e-9, atol=0.0, stol=1e-12, max_it=100)
    snes.solve(None, x)
if snes.getConvergedReason() <= 0:
    raise RuntimeError(f"SNES ended with reason {snes.getConvergedReason()}")

at_bound = x.array[qp.bounded] >= 0.0
run.finish(
    qp.displacements(x.array),
    version="PETSc " + ".".join(map(str, PETSc.Sys.getVersion())),
    iterations=snes.getIterationNumber(),
    closed=int(at_bound.sum()),
    note="numpy assembly; SNESVINEWTONRSLS, CHOLMOD in each step, relative residual 1e-9",
)
