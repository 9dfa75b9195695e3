"""GetFEM: its contact brick for two deformable bodies, nodal with multipliers, and its own Newton iteration."""

import getfem as gf
import numpy as np

import scene
from report import Run

RESIDUAL = 1e-10
TOP, LEFT, BOTTOM = 1, 2, 3


def body(points: np.ndarray, triangles: np.ndarray):
    """A mesh of one body and linear displacements on it. (GetFEM's own regular simplices have the other diagonals.)"""
    mesh = gf.Mesh("empty", 2)
    mesh.add_convex(gf.GeoTrans("GT_PK(2,1)"), points[triangles].transpose(2, 1, 0))
    displacement = gf.MeshFem(mesh, 2)
    displacement.set_classical_fem(1)
    return mesh, displacement


def numbers(displacement, points: np.ndarray) -> np.ndarray:
    """GetFEM's numbers (nodes, 2) of the displacement components at the scene's nodes."""
    theirs = displacement.basic_dof_nodes()[:, ::2]
    order_theirs, order_ours = np.lexsort(np.round(theirs, 9)), np.lexsort(np.round(points.T, 9))
    first = np.empty(len(points), dtype=int)
    first[order_ours] = 2 * order_theirs
    return np.column_stack([first, first + 1])


def rows_at(columns: np.ndarray, sign: float, size: int):
    """B with B u = sign u_y at the contact nodes."""
    rows = gf.Spmat("empty", len(columns), size)
    for row, column in enumerate(columns):
        rows.add(row, int(column), sign)
    return rows


run = Run("getfem")
gf.util_trace_level(0)
with run.phase("mesh"):
    ours = scene.mesh(run.n)
    count = ours.nodes_per_body
    half = len(ours.triangles) // 2
    upper_mesh, upper = body(ours.points, ours.triangles[:half])
    lower_mesh, lower = body(ours.points, ours.triangles[half:])
    upper_numbers, lower_numbers = numbers(upper, ours.points[:count]), numbers(lower, ours.points[count:])
    upper_mesh.set_region(TOP, upper_mesh.outer_faces_with_direction([0, 1], 0.01))
    upper_mesh.set_region(LEFT, upper_mesh.outer_faces_with_direction([-1, 0], 0.01))
    lower_mesh.set_region(BOTTOM, lower_mesh.outer_faces_with_direction([0, -1], 0.01))
with run.phase("assembly"):
    # Bricks are lazy: matrices are assembled in the solve.
    upper_rule, lower_rule = (gf.MeshIm(m, gf.Integ("IM_TRIANGLE(2)")) for m in (upper_mesh, lower_mesh))
    model = gf.Model("real")
    model.add_fem_variable("upper", upper)
    model.add_fem_variable("lower", lower)
    model.add_initialized_data("lambda", [scene.LAMBDA])
    model.add_initialized_data("mu", [scene.MU])
    model.add_isotropic_linearized_elasticity_brick(upper_rule, "upper", "lambda", "mu")
    model.add_isotropic_linearized_elasticity_brick(lower_rule, "lower", "lambda", "mu")
    model.add_source_term_brick(upper_rule, "upper", "[0; -0.1*(1-1.75*X(1))]", TOP)
    model.add_normal_Dirichlet_condition_with_multipliers(upper_rule, "upper", 1, LEFT)
    model.add_Dirichlet_condition_with_simplification("lower", BOTTOM)
    # u''_y - u'_y <= 0 at each pair
    upper_rows = rows_at(upper_numbers[ours.upper_zone, 1], -1.0, upper.nbdof())
    lower_rows = rows_at(lower_numbers[ours.lower_zone - count, 1], 1.0, lower.nbdof())
    model.add_variable("force", run.n + 1)
    model.add_initialized_data("r", [scene.YOUNG])
    model.add_basic_contact_brick_two_deformable_bodies("upper", "lower", "force", "r", upper_rows, lower_rows)
    # All pairs closed at the start: with none, the upper body floats.
    model.set_variable("force", np.full(run.n + 1, -1.0))
with run.phase("solve"):
    full_steps = ("lsearch", "simplest", "alpha max ratio", 1e20, "alpha min", 1.0)
    steps, converged = model.solve("max_res", RESIDUAL, "max_iter", 60, *full_steps)
if not converged:
    raise RuntimeError(f"GetFEM's Newton iteration did not converge in {steps} steps")

u = np.vstack([model.variable("upper")[upper_numbers], model.variable("lower")[lower_numbers]])
run.finish(
    u,
    version=f"GetFEM {gf.getfem_env('version')}",
    iterations=steps,
    closed=int((model.variable("force") < 0).sum()),
    note=f"basic contact brick, matching nodes, Alart-Curnier, residual {RESIDUAL:g}",
)
