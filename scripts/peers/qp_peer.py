"""What the general solvers of quadratic problems have in common: the scene as min ½ xᵀPx + qᵀx with bounds."""

from collections.abc import Callable
from importlib.metadata import version

import numpy as np

import scene
from qp import BoundQp, bound_qp
from report import Run

# The objective is about 1e-3 in the scene's units; stopping tests are absolute below 1, so it is brought to order 1.
SCALE = 1e3

# Returns x and the number of iterations.
Solver = Callable[[BoundQp], tuple[np.ndarray, int]]


def main(peer: str, package: str, solver: Solver, note: str) -> None:
    """Assembles by numpy and hands the problem over."""
    run = Run(peer)
    with run.phase("mesh"):
        mesh = scene.mesh(run.n)
    with run.phase("assembly"):
        qp = bound_qp(mesh, scene.stiffness(mesh), scene.load(mesh))
    with run.phase("solve"):
        x, iterations = solver(qp)
    run.finish(
        qp.displacements(x),
        version=f"{package} {version(package)}",
        iterations=iterations,
        closed=int(pressing(qp, x).sum()),
        note=note,
    )


def pressing(qp: BoundQp, x: np.ndarray) -> np.ndarray:
    """Which pairs press: force and gap are both nearly zero somewhere, the larger one in units of force decides."""
    force = qp.load[qp.bounded] - qp.stiffness[:, qp.bounded].T @ x
    return force > -qp.stiffness.diagonal()[qp.bounded] * x[qp.bounded]
