"""The quadratic problem: min ½ xᵀKx - fᵀx subject to x_c <= 0 on the contact unknowns c.

The normal component of an upper contact node is replaced by d = u''_y - u'_y, so that the constraint is a bound;
components held by a support are left out.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from scene import Mesh


@dataclass(frozen=True)
class BoundQp:
    stiffness: sp.csc_matrix  # K, symmetric; positive definite once one bound is active
    load: np.ndarray  # f
    bounded: np.ndarray  # numbers c of the bounded unknowns, from left to right
    back: sp.csr_matrix  # all nodal displacements = back @ x

    def displacements(self, x: np.ndarray) -> np.ndarray:
        """Nodal displacements (nodes, 2) in the scene's numbering."""
        return (self.back @ x).reshape(-1, 2)


def bound_qp(mesh: Mesh, stiffness: sp.spmatrix, load: np.ndarray) -> BoundQp:
    """Eliminates supports and changes the basis of nodal matrices in the scene's numbering."""
    size = len(load)
    upper, lower = 2 * mesh.upper_zone + 1, 2 * mesh.lower_zone + 1
    # u'_y = u''_y - d
    ones = np.ones(size)
    ones[upper] = -1
    change = sp.diags(ones).tocoo()
    rows = np.concatenate([change.row, upper])
    columns = np.concatenate([change.col, lower])
    values = np.concatenate([change.data, np.ones(len(upper))])
    free = np.flatnonzero(~mesh.fixed())
    back = sp.csr_matrix((values, (rows, columns)), shape=(size, size))[:, free]
    reduced = sp.csc_matrix(back.T @ stiffness @ back)
    reduced.sort_indices()
    return BoundQp(reduced, back.T @ load, np.searchsorted(free, upper), back)


class ClosedSystem:
    """K with the closed unknowns held at zero, always on the pattern of K, so that one symbolic analysis serves all."""

    def __init__(self, qp: BoundQp):
        self._qp = qp
        matrix = qp.stiffness
        self._columns = np.repeat(np.arange(matrix.shape[1]), np.diff(matrix.indptr))
        touched = np.zeros(matrix.shape[0], dtype=bool)
        touched[qp.bounded] = True
        # Only entries in a row or column of a contact unknown ever change; its diagonal entry stays.
        near = touched[matrix.indices] | touched[self._columns]
        self._entries = np.flatnonzero(near & (matrix.indices != self._columns))

    def at(self, closed: np.ndarray) -> tuple[sp.csc_matrix, np.ndarray]:
        """Matrix and right-hand side for a mask `closed` over the bounded unknowns."""
        matrix, load = self._qp.stiffness.copy(), self._qp.load.copy()
        held = np.zeros(len(load), dtype=bool)
        held[self._qp.bounded[closed]] = True
        drop = held[matrix.indices[self._entries]] | held[self._columns[self._entries]]
        matrix.data[self._entries[drop]] = 0.0
        load[held] = 0.0
        return matrix, load
