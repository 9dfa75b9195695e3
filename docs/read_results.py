"""Reads what a run leaves behind, with NumPy alone, and computes two of its numbers again.

    signorini run two-squares --fields last --out /tmp/mine
    python3 docs/read_results.py /tmp/mine/two-squares

The folder is that of one case: it holds record.json. See reading-results.md.
"""

import csv
import json
import sys
from pathlib import Path

import numpy as np

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "reports/two-squares")

# %% The record: everything about the case, level by level.
record = json.loads((folder / "record.json").read_text(encoding="utf-8"))
levels = record["levels"]
print(f"{record['study']} · {record['case']}: {record['verdict']['outcome']}")
for level in levels:
    print(f"  n = {level['cells']:4d}  h = {level['h']:.4f}  {level['dofs']:7d} dofs  L(u_h) = {level['energy']:.12g}")

# %% The table: the same levels, one row each; an empty field is a value that there is not.
with open(folder / "table.csv", encoding="utf-8") as file:
    table = list(csv.DictReader(file))
energies = [float(row["energy_value"]) for row in table]
assert energies == [level["energy"] for level in levels], "table and record hold the same numbers"

# %% The rate: the slope of log(error) over log(h), on the levels that the fit has used.
norm = record["norm"]
rate = record["rates"].get(norm)
failed = False
if rate is None:
    print(f"no rate of the {norm} error: {len(levels)} levels")
else:
    used = [level for level in levels if level["level"] in rate["levels"]]
    h = np.array([level["h"] for level in used])
    error = np.array([level["errors"][norm] for level in used])
    slope, _ = np.polyfit(np.log(h), np.log(error), 1)
    print(f"rate of the {norm} error on {len(used)} levels: {slope:.6f}, in the record {rate['slope']:.6f}")
    failed |= not np.isclose(slope, rate["slope"], rtol=0, atol=1e-9)

# %% The fields of the levels that kept theirs: one .npy file for each array.
for path in sorted(path for path in folder.glob("fields/level-*") if path.is_dir()):
    level = next(entry for entry in levels if path.name == f"level-{entry['level']}")
    field = {file.stem: np.load(file) for file in path.glob("*.npy")}
    # A(u,u) = Σ |T| τ:ε with τ:ε = τ11 ε11 + τ22 ε22 + 2 τ12 ε12
    density = (field["stress"] * field["strain"]) @ [1.0, 1.0, 2.0]
    energy = float(np.sum(field["area"] * density))
    expected = level["solution_energy"] ** 2
    print(f"{path.name}: A(u,u) = {energy:.12g} from stress and strain, in the record {expected:.12g}")
    failed |= not np.isclose(energy, expected, rtol=1e-9, atol=0)
    # ε of each triangle, from the displacement of its nodes
    p, u = field["nodes"][field["triangles"]], field["displacement"][field["triangles"]]
    sides, du = p[:, 1:] - p[:, :1], u[:, 1:] - u[:, :1]
    gradient = np.linalg.solve(sides, du)  # rows: ∂/∂x, ∂/∂y
    strain = np.stack([gradient[:, 0, 0], gradient[:, 1, 1], (gradient[:, 0, 1] + gradient[:, 1, 0]) / 2], axis=1)
    print(f"  largest difference of the strains: {abs(strain - field['strain']).max():.1e}")
    closed = field["pressure"] > 0
    print(f"  {closed.sum()} of {len(closed)} points of the zone press; largest pressure {field['pressure'].max():.6g}")

if failed:
    sys.exit("a number does not come out as in the record")
