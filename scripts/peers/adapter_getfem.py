"""GetFEM under `--solver`: its own assembly, its nodal contact brick between two bodies, and its own Newton iteration."""

import getfem as gf
import numpy as np
import scipy.sparse as sp
from scipy.spatial import cKDTree

import adapter

RESIDUAL = 1e-10
BODIES = ("first", "second")


class Body:
    """The mesh of one body, linear displacements on it, and their numbers."""

    def __init__(self, level: adapter.Level, body: int):
        triangles = level.triangles[level.bodies == body]
        self.mesh = gf.Mesh("empty", 2)
        self.mesh.add_convex(gf.GeoTrans("GT_PK(2,1)"), level.points[triangles].transpose(2, 1, 0))
        self.fem = gf.MeshFem(self.mesh, 2)
        self.fem.set_classical_fem(1)
        self.rule = gf.MeshIm(self.mesh, gf.Integ("IM_TRIANGLE(1)"))
        # GetFEM numbers nodes in its own way; ours are found by their place.
        nodes = level.nodes_of(body)
        theirs = self.fem.basic_dof_nodes()[:, ::2].T
        distance, place = cKDTree(theirs).query(level.points[nodes])
        assert distance.max() < 1e-12 and len(theirs) == len(nodes)
        self.ours = (2 * nodes[:, None] + np.arange(2)).ravel()
        self.theirs = (2 * place[:, None] + np.arange(2)).ravel()

    def matrix(self, rows: sp.csr_matrix):
        """Rows on all components of the level, as GetFEM's matrix on those of this body."""
        part = rows.tocsc()[:, self.ours].tocoo()
        out = gf.Spmat("empty", rows.shape[0], len(self.ours))
        for row, column, value in zip(part.row.tolist(), self.theirs[part.col].tolist(), part.data.tolist()):
            out.add(row, column, value)
        return out

    def vector(self, values: np.ndarray) -> np.ndarray:
        out = np.empty(len(self.ours))
        out[self.theirs] = values[self.ours]
        return out


def elasticity(name: str, hooke: np.ndarray) -> str:
    """(Cε)·ε in GetFEM's language."""
    def strain(u):
        return [f"Grad_{u}(1,1)", f"Grad_{u}(2,2)", f"(Grad_{u}(1,2)+Grad_{u}(2,1))"]

    mine, test = strain(name), strain(f"Test_{name}")
    terms = [f"({float(hooke[i, j])!r})*{mine[j]}*{test[i]}" for i in range(3) for j in range(3) if hooke[i, j] != 0]
    return "+".join(terms)


gf.util_trace_level(0)
level = adapter.read()
held, contact = adapter.equations(level)
bodies = [Body(level, k) for k in range(2)]
model = gf.Model("real")
for name, body, hooke in zip(BODIES, bodies, level.hooke):
    model.add_fem_variable(name, body.fem)
    model.add_linear_term(body.rule, elasticity(name, hooke))
    model.add_explicit_rhs(name, body.vector(level.load))
# Supports and bilateral pairs: B u = a with multipliers.
model.add_variable("held", len(held.right))
for name, body in zip(BODIES, bodies):
    model.add_explicit_matrix("held", name, body.matrix(held.matrix), 1)
model.add_explicit_rhs("held", held.right)
# B u <= gap at each pair
model.add_variable("force", len(contact.right))
model.add_initialized_data("r", [float(level.hooke.max())])
model.add_initialized_data("gap", contact.right)
first, second = (body.matrix(contact.matrix) for body in bodies)
model.add_basic_contact_brick_two_deformable_bodies("first", "second", "force", "r", first, second, "gap")
# All pairs closed at the start: with none, a body may float.
model.set_variable("force", np.full(len(contact.right), -1.0))
full_steps = ("lsearch", "simplest", "alpha max ratio", 1e20, "alpha min", 1.0)
steps, converged = model.solve("max_res", RESIDUAL, "max_iter", 60, *full_steps)
if not converged:
    raise RuntimeError(f"GetFEM's Newton iteration did not converge in {steps} steps")

u = np.empty(len(level.load))
for name, body in zip(BODIES, bodies):
    u[body.ours] = model.variable(name)[body.theirs]
adapter.write(u.reshape(-1, 2))
