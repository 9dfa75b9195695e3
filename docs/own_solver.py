"""A contact solver of its own, for signorini to judge: NumPy and SciPy, the mesh, the problem, an active set.

    signorini run theorem-3-1-smooth --solver 'python3 docs/own_solver.py' --out /tmp/own

It assembles linear triangles from mesh.msh and problem.json and writes displacement.csv. Straight bodies; see own-solver.md.
"""

import json
import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu


def read_mesh(path):
    """Points and triangles (with the body of each) of a Gmsh 4.1 text file whose nodes are numbered from 1."""
    lines = iter(open(path).read().split("\n"))
    points, triangles, bodies = {}, [], []
    for line in lines:
        if line == "$Nodes":
            for _ in range(int(next(lines).split()[0])):
                count = int(next(lines).split()[3])
                tags = [int(next(lines)) for _ in range(count)]
                points |= {tag: [float(x) for x in next(lines).split()[:2]] for tag in tags}
        if line == "$Elements":
            for _ in range(int(next(lines).split()[0])):
                dimension, entity, _, count = map(int, next(lines).split())
                rows = [next(lines).split() for _ in range(count)]
                if dimension == 2:
                    triangles += [[int(i) - 1 for i in row[1:]] for row in rows]
                    bodies += [entity - 1] * count
    return np.array([points[i + 1] for i in range(len(points))]), np.array(triangles), np.array(bodies)


problem = json.load(open("problem.json"))
assert not problem["curved"], "straight triangles only"
points, triangles, bodies = read_mesh("mesh.msh")
n = len(points)

# stiffness: K_e = |T| BᵀCB with the strains (ε11, ε22, 2ε12)
p = points[triangles]
edge = np.roll(p, -2, axis=1) - np.roll(p, -1, axis=1)  # the side opposite each corner
twice = (edge[:, 0, 0] * edge[:, 1, 1] - edge[:, 0, 1] * edge[:, 1, 0])[:, None]
gx, gy = -edge[:, :, 1] / twice, edge[:, :, 0] / twice
B = np.zeros((len(triangles), 3, 6))
B[:, 0, 0::2], B[:, 1, 1::2], B[:, 2, 0::2], B[:, 2, 1::2] = gx, gy, gy, gx
C = np.array([body["hooke"] for body in problem["bodies"]])[bodies]
Ke = 0.5 * twice[:, :, None] * np.einsum("tki,tkl,tlj->tij", B, C, B)
dofs = (2 * triangles[:, :, None] + np.arange(2)).reshape(-1, 6)
K = sp.csr_matrix((Ke.ravel(), (np.repeat(dofs, 6, 1).ravel(), np.tile(dofs, 6).ravel())), (2 * n, 2 * n))
f = np.array(problem["nodal_load"]).ravel()

# equations A u = a that always hold (supports, bilateral pairs), and those of contact, n·(u' − u'') ≤ g
held, contact = [], []
for support in problem["supports"]:
    free = np.array(support["free"] or np.zeros((0, 2)))
    for normal in np.eye(2) if len(free) == 0 else [[-free[0][1], free[0][0]]]:
        held.append(([(support["node"], normal)], np.dot(normal, support["displacement"])))
for pair in problem["pairs"]:
    for c in pair["constraints"]:
        row = ([(pair["first"], c["normal"]), (pair["second"], np.negative(c["normal"]))], c["gap"])
        (held if c["bilateral"] else contact).append(row)


def rows(equations):
    entries = [(k, 2 * node - 2 + i, v[i]) for k, (terms, _) in enumerate(equations) for node, v in terms for i in (0, 1)]
    k, j, v = zip(*entries) if entries else ((), (), ())
    return sp.csr_matrix((v, (k, j)), (len(equations), 2 * n)), np.array([g for _, g in equations])


A, a = rows(held)
N, g = rows(contact)
active = np.ones(len(g), bool)
for _ in range(50):  # primal-dual active set: [K Gᵀ; G 0] [u; λ] = [f; …]
    G, rhs = sp.vstack([A, N[active]]), np.concatenate([a, g[active]])
    weak = 1e-13 * abs(K).max() * sp.eye(len(rhs))  # constraints that repeat one another do no harm
    solution = splu(sp.bmat([[K, G.T], [G, -weak / abs(K).max() ** 2]], format="csc")).solve(np.concatenate([f, rhs]))
    u, force = solution[: 2 * n], np.zeros(len(g))
    force[active] = solution[2 * n + len(a) :]
    next_active = force + abs(K).max() * (N @ u - g) > 0
    if (next_active == active).all():
        break
    active = next_active

with open("displacement.csv", "w") as out:
    out.write("node,ux,uy\n")
    out.writelines(f"{i + 1},{float(x)!r},{float(y)!r}\n" for i, (x, y) in enumerate(u.reshape(-1, 2)))
