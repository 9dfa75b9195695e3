"""The primal-dual active set method for a BoundQp; how to solve the linear system is the peer's."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qp import BoundQp


@dataclass(frozen=True)
class Outcome:
    x: np.ndarray
    closed: np.ndarray  # mask over the bounded unknowns
    steps: int


def primal_dual(qp: BoundQp, solve: Callable[[np.ndarray], np.ndarray], limit: int = 60) -> Outcome:
    """Starts with every pair closed; `solve(closed)` returns x with x = 0 where closed.

    Raises RuntimeError if a set comes back (a cycle) or the limit is reached.
    """
    rows = qp.stiffness[:, qp.bounded].T.tocsr()
    closed = np.ones(len(qp.bounded), dtype=bool)
    seen = set()
    for step in range(1, limit + 1):
        seen.add(closed.tobytes())
        x = solve(closed)
        # Force of a closed pair: (f - K x)_c.
        force = qp.load[qp.bounded] - rows @ x
        following = np.where(closed, force > 0, x[qp.bounded] > 0)
        if np.array_equal(following, closed):
            return Outcome(x, closed, step)
        if following.tobytes() in seen:
            raise RuntimeError(f"the active set came back after {step} steps: it cycles")
        closed = following
    raise RuntimeError(f"no active set after {limit} steps")
