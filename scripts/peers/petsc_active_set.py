"""Active set with PETSc's conjugate gradients, preconditioned by an algebraic multigrid for elasticity.

Two components per node throughout: a closed pair ties u'_y to u''_y, and its own row becomes the identity, as the rows of
supports do. So block size and rigid motions stay what multigrid expects.
"""

import sys

import numpy as np
import petsc4py
import scipy.sparse as sp

petsc4py.init(sys.argv[:1])
from petsc4py import PETSc  # PETSc must be initialised first

import scene
from report import Run

LOOSE, TIGHT = 1e-6, 1e-11


def version() -> str:
    return "PETSc " + ".".join(map(str, PETSc.Sys.getVersion()))


class Elasticity:
    """The linear problems of the active set."""

    def __init__(self, mesh: scene.Mesh, options: dict[str, str]):
        self._mesh = mesh
        self.stiffness = scene.stiffness(mesh)
        self.load = scene.load(mesh)
        self.upper, self.lower = 2 * mesh.upper_zone + 1, 2 * mesh.lower_zone + 1
        self._diagonal = float(self.stiffness.diagonal().mean())
        self._u = np.zeros(len(self.load))
        for key, value in options.items():
            PETSc.Options().setValue(key, value)
        self.iterations = 0

    def solve(self, closed: np.ndarray, tolerance: float) -> np.ndarray:
        """Nodal displacements with the closed pairs tied, starting from the last ones."""
        tie = self._tie(closed)
        held = self._mesh.fixed()
        held[self.upper[closed]] = True
        matrix = tie.T @ self.stiffness @ tie + sp.diags(held * self._diagonal)
        solver = self._solver(matrix.tocsr(), held, tolerance)
        b, x = (PETSc.Vec().createWithArray(v.copy(), comm=PETSc.COMM_SELF) for v in (tie.T @ self.load, self._u))
        x.array[held] = 0.0
        solver.solve(b, x)
        if solver.getConvergedReason() <= 0:
            raise RuntimeError(f"conjugate gradients ended with reason {solver.getConvergedReason()}")
        self.iterations += solver.getIterationNumber()
        self._u = tie @ x.array
        solver.destroy()
        return self._u

    def _tie(self, closed: np.ndarray) -> sp.csr_matrix:
        """u = tie @ x: supports give zero, closed pairs u'_y = u''_y."""
        size = len(self.load)
        keep = ~self._mesh.fixed()
        keep[self.upper[closed]] = False
        rows = np.concatenate([np.flatnonzero(keep), self.upper[closed]])
        columns = np.concatenate([np.flatnonzero(keep), self.lower[closed]])
        return sp.csr_matrix((np.ones(len(rows)), (rows, columns)), shape=(size, size))

    def _solver(self, matrix: sp.csr_matrix, held: np.ndarray, tolerance: float) -> PETSc.KSP:
        index = PETSc.IntType
        csr = (matrix.indptr.astype(index), matrix.indices.astype(index), matrix.data)
        a = PETSc.Mat().createAIJ(matrix.shape, bsize=2, csr=csr, comm=PETSc.COMM_SELF)
        a.setNearNullSpace(self._rigid_motions(held))
        a.setOption(PETSc.Mat.Option.SPD, True)
        solver = PETSc.KSP().create(comm=PETSc.COMM_SELF)
        solver.setOperators(a)
        solver.setInitialGuessNonzero(True)
        solver.setTolerances(rtol=tolerance, max_it=2000)
        solver.setNormType(PETSc.KSP.NormType.UNPRECONDITIONED)
        solver.setFromOptions()
        return solver

    def _rigid_motions(self, held: np.ndarray) -> PETSc.NullSpace:
        x, y = self._mesh.points.T
        zero, one = np.zeros(len(x)), np.ones(len(x))
        modes = np.array([np.column_stack(m).ravel() for m in ((one, zero), (zero, one), (-y, x))])
        modes[:, held] = 0.0
        basis = np.linalg.qr(modes.T)[0]
        vectors = [PETSc.Vec().createWithArray(basis[:, k].copy(), comm=PETSc.COMM_SELF) for k in range(3)]
        return PETSc.NullSpace().create(vectors=vectors, comm=PETSc.COMM_SELF)


def settle(problem: Elasticity, limit: int = 60) -> tuple[np.ndarray, np.ndarray, int]:
    """Displacements, closed mask, steps. Solves loosely until the set rests, then tightly until it rests again."""
    closed = np.ones(len(problem.upper), dtype=bool)
    tolerance = LOOSE
    for step in range(1, limit + 1):
        u = problem.solve(closed, tolerance)
        force = (problem.stiffness @ u - problem.load)[problem.upper]
        gap = u[problem.upper] - u[problem.lower]
        following = np.where(closed, force > 0, gap < 0)
        if np.array_equal(following, closed):
            if tolerance == TIGHT:
                return u, closed, step
            tolerance = TIGHT
        closed = following
    raise RuntimeError(f"no active set after {limit} steps")


def main(peer: str, options: dict[str, str], note: str) -> None:
    """The whole peer; PETSc's options choose the preconditioner."""
    run = Run(peer)
    with run.phase("mesh"):
        mesh = scene.mesh(run.n)
    with run.phase("assembly"):
        problem = Elasticity(mesh, options)
    with run.phase("solve"):
        u, closed, steps = settle(problem)
    note = f"{note}; {problem.iterations} CG iterations in all, relative residual {TIGHT:g} at the end"
    run.finish(u.reshape(-1, 2), version=version(), iterations=steps, closed=int(closed.sum()), note=note)
