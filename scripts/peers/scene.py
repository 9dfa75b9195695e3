"""The scene that every peer solves: two elastic squares pressed together, `studies/two-squares.toml`.

      y =  1  o---------o   traction (0, -0.1 (1 - 1.75 x))
              |  upper  |
      u_x = 0 |         |   free
      y =  0  o=========o   contact, frictionless: gap u'_y - u''_y >= 0 at each pair of nodes
              |  lower  |   free on both sides
      y = -1  o---------o   clamped

Plane strain, E = 1, nu = 0.3. Right triangles, diagonals from lower left to upper right, n cells per side, linear
functions. Nodes are numbered row by row from below, the upper body first; component c of node i has number 2 i + c.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

YOUNG, POISSON = 1.0, 0.3
LAMBDA = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
MU = YOUNG / (2 * (1 + POISSON))


def pressure(x):
    """Traction on the top, second component."""
    return -0.1 * (1 - 1.75 * x)


@dataclass(frozen=True)
class Mesh:
    """Both bodies; no node is shared."""

    n: int
    points: np.ndarray  # (nodes, 2)
    triangles: np.ndarray  # (4 n², 3), counter-clockwise

    @property
    def nodes_per_body(self) -> int:
        return (self.n + 1) ** 2

    @property
    def upper_zone(self) -> np.ndarray:
        """Upper nodes on y = 0, from left to right."""
        return np.arange(self.n + 1)

    @property
    def lower_zone(self) -> np.ndarray:
        """The lower nodes that face them."""
        return self.nodes_per_body + self.n * (self.n + 1) + np.arange(self.n + 1)

    @property
    def top(self) -> np.ndarray:
        """Nodes under the traction, from left to right."""
        return self.n * (self.n + 1) + np.arange(self.n + 1)

    def fixed(self) -> np.ndarray:
        """For each displacement component, whether a support holds it."""
        fixed = np.zeros((len(self.points), 2), dtype=bool)
        fixed[np.arange(self.n + 1) * (self.n + 1), 0] = True
        fixed[self.nodes_per_body + np.arange(self.n + 1), :] = True
        return fixed.ravel()


def mesh(n: int) -> Mesh:
    """Structured triangles, n cells per side of each square."""
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n)
    upper = np.column_stack([x.ravel(), y.ravel()])
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    below = np.column_stack([corner, corner + 1, corner + n + 2])
    above = np.column_stack([corner, corner + n + 2, corner + n + 1])
    one = np.concatenate([below, above])
    return Mesh(n, np.concatenate([upper, upper - [0, 1]]), np.concatenate([one, one + len(upper)]))


def gradients(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gradients (elements, 3, 2) of the hat functions, and areas."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    twice = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])
    opposite = np.stack([c - b, a - c, b - a], axis=1)
    rotated = np.stack([-opposite[..., 1], opposite[..., 0]], axis=-1)
    return rotated / twice[:, None, None], twice / 2


def stiffness(mesh: Mesh) -> sp.csr_matrix:
    """A(phi_j, phi_i) for all components, supports not yet applied."""
    size = 2 * len(mesh.points)
    grad, area = gradients(mesh.points, mesh.triangles)
    # lambda div u div v + 2 mu e(u):e(v), with u = phi_j e_l and v = phi_i e_k
    outer = np.einsum("t,tik,tjl->tikjl", area, grad, grad)
    dots = np.einsum("tikjk->tij", outer)
    local = LAMBDA * outer + MU * np.einsum("tiljk->tikjl", outer)
    for k in range(2):
        local[:, :, k, :, k] += MU * dots
    numbers = (2 * mesh.triangles[:, :, None] + np.arange(2)).reshape(-1, 6).astype(np.int32)
    rows = np.repeat(numbers, 6, axis=1).ravel()
    columns = np.tile(numbers, (1, 6)).ravel()
    return sp.coo_matrix((local.ravel(), (rows, columns)), shape=(size, size)).tocsr()


def load(mesh: Mesh) -> np.ndarray:
    """The traction's work on each hat function; exact, since the traction is linear."""
    f = np.zeros(2 * len(mesh.points))
    left, right = mesh.top[:-1], mesh.top[1:]
    t_left, t_right = pressure(mesh.points[left, 0]), pressure(mesh.points[right, 0])
    np.add.at(f, 2 * left + 1, (t_left / 3 + t_right / 6) / mesh.n)
    np.add.at(f, 2 * right + 1, (t_left / 6 + t_right / 3) / mesh.n)
    return f


@dataclass(frozen=True)
class Grade:
    """What the displacements of a peer are worth, computed from strains and without any peer's matrix."""

    energy: float  # L(u) = ½ A(u, u) - f·u
    half_norm: float  # ½ A(u, u)
    penetration: float  # largest penetration of a pair over the largest displacement
    support: float  # largest displacement that a support should have held, over the same


def grade(mesh: Mesh, u: np.ndarray) -> Grade:
    """Judges nodal displacements u (nodes, 2)."""
    grad, area = gradients(mesh.points, mesh.triangles)
    # Differences to the first node: rigid motions of the element cancel before they are multiplied.
    du = u[mesh.triangles] - u[mesh.triangles[:, :1]]
    slope = np.einsum("tik,til->tkl", du, grad)
    strain = (slope + np.swapaxes(slope, 1, 2)) / 2
    trace = strain[:, 0, 0] + strain[:, 1, 1]
    density = LAMBDA / 2 * trace**2 + MU * np.einsum("tkl,tkl->t", strain, strain)
    half_norm = float(np.sum(area * density))
    size = float(np.max(np.abs(u)))
    gap = u[mesh.upper_zone, 1] - u[mesh.lower_zone, 1]
    return Grade(
        energy=half_norm - float(load(mesh) @ u.ravel()),
        half_norm=half_norm,
        penetration=max(0.0, float(-gap.min())) / size,
        support=float(np.abs(u.ravel()[mesh.fixed()]).max()) / size,
    )
