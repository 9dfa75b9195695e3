"""peers.json as a page."""

import os
import platform
from collections.abc import Callable
from statistics import median

AGREEMENT = 1e-9
PHASES = ("mesh", "assembly", "setup", "solve")
NONE = "–"


def machine() -> dict:
    """What the times depend on."""
    with open("/proc/cpuinfo") as file:
        models = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return {
        "processor": models[0] if models else platform.processor(),
        "processors": os.cpu_count(),
        "memory_bytes": memory,
        "system": platform.platform(),
    }


def sizes(data: dict) -> list[int]:
    return sorted({run["n"] for run in data["runs"]})


def peers(data: dict) -> list[str]:
    """In the order in which they first ran."""
    return list(dict.fromkeys(run["peer"] for run in data["runs"]))


def runs_of(data: dict, peer: str, n: int) -> list[dict]:
    return [run for run in data["runs"] if run["peer"] == peer and run["n"] == n]


def agreed(data: dict, n: int) -> float | None:
    """The median energy of a size; at the solution ½A(u,u) is its negative."""
    energies = [run["energy"] for run in data["runs"] if run["n"] == n and "energy" in run]
    return median(energies) if energies else None


def difference(data: dict, run: dict) -> float:
    """Of a run's energy from the agreed one, relative to ½A(u,u)."""
    energy = agreed(data, run["n"])
    return (run["energy"] - energy) / abs(energy)


def disagreements(data: dict) -> list[dict]:
    """Runs whose energy differs by more than 1e-9."""
    return [run for run in data["runs"] if "energy" in run and abs(difference(data, run)) > AGREEMENT]


def markdown(data: dict) -> str:
    parts = [
        HEAD.format(threads=data["threads"]),
        overview(data, "Seconds from mesh to displacements", lambda r: r["seconds"]["total"]),
        overview(data, "CPU seconds of the process", lambda r: r["cpu_seconds"]["process"]),
    ]
    parts += [one_size(data, n) for n in sizes(data)]
    parts += [explained(data), versions(data), describe_machine(data)]
    return "\n\n".join(parts) + "\n"


HEAD = """# Other solvers on the same problem

The *two squares* of `studies/two-squares.toml`: the same triangles, the same linear functions, the same quadratic problem.
Each run is a process of its own with {threads} thread(s); medians. What is measured, and how to run it again:
`scripts/peers/README.md`."""


def overview(data: dict, title: str, value: Callable[[dict], float]) -> str:
    """One number by peer and size."""
    columns = sizes(data)
    lines = [f"## {title}", ""]
    lines.append(row(["peer"] + [f"n = {n} ({dofs(data, n)} dofs)" for n in columns]))
    lines.append(rule(len(columns)))
    for peer in peers(data):
        cells = [cell(runs_of(data, peer, n), value) for n in columns]
        lines.append(row([peer] + cells))
    return "\n".join(lines)


def cell(runs: list[dict], value: Callable[[dict], float | None], form: str = ".3g") -> str:
    """Median over the runs that ended well."""
    values = [value(run) for run in runs if "failure" not in run]
    values = [v for v in values if v is not None]
    return format(median(values), form) if values else NONE


def one_size(data: dict, n: int) -> str:
    energy = agreed(data, n)
    head = ["peer", "wall", "min–max", *PHASES, "CPU s", "peak MB", "iterations", "active", "energy differs by", "penetration"]
    title = f"## n = {n}" + (f": energy {energy:.15g}" if energy is not None else "")
    lines = [title, "", row(head), rule(len(head) - 1)]
    for peer in peers(data):
        runs = runs_of(data, peer, n)
        good = [run for run in runs if "failure" not in run]
        if good:
            lines.append(row([peer] + measured(data, good)))
        elif runs:
            lines.append(row([peer, runs[-1]["failure"]] + [""] * (len(head) - 2)))
    return "\n".join(lines)


def measured(data: dict, runs: list[dict]) -> list[str]:
    walls = [run["seconds"]["wall"] for run in runs]
    spread = f"{min(walls):.3g}–{max(walls):.3g} of {len(walls)}" if len(walls) > 1 else "once"
    worst = max((difference(data, run) for run in runs), key=abs)
    mark = "" if abs(worst) <= AGREEMENT else " ✗"
    return [
        cell(runs, lambda r: r["seconds"]["wall"]),
        spread,
        *(cell(runs, lambda r, p=phase: r["seconds"][p]) for phase in PHASES),
        cell(runs, lambda r: r["cpu_seconds"]["process"]),
        cell(runs, lambda r: r["peak_bytes"] / 1e6, ".0f"),
        cell(runs, lambda r: r["iterations"], ".0f"),
        cell(runs, lambda r: r["active"], ".0f"),
        f"{worst:.1e}{mark}",
        cell(runs, lambda r: r.get("penetration"), ".1e"),
    ]


def explained(data: dict) -> str:
    """How to read it, and which energies disagree."""
    text = """## How to read this

`wall` is the whole process with the start of its interpreter; the phases are the peer's own. `CPU s` and `peak MB` belong to the
process. *Energy differs by*: from the median of the size, relative to ½A(u,u), computed from the displacements by
one function for all peers; ✗ marks more than 1e-9. *Penetration* is relative to the largest displacement; a
penetrating answer may have an energy below the minimum."""
    wrong = sorted({f"{run['peer']} at n = {run['n']}" for run in disagreements(data)})
    verdict = f"Disagreeing: {', '.join(wrong)}." if wrong else "All energies agree to 1e-9."
    return f"{text}\n\n{verdict}"


def versions(data: dict) -> str:
    lines = ["## Versions, methods, commands", "", row(["peer", "version", "method", "command"]), rule(3, ":--")]
    for peer in peers(data):
        good = [run for run in data["runs"] if run["peer"] == peer and "failure" not in run]
        command = f"`scripts/peers/run --peers {peer}`"
        if good:
            lines.append(row([peer, good[-1]["version"], good[-1]["note"], command]))
        else:
            failure = next(run["failure"] for run in data["runs"] if run["peer"] == peer)
            lines.append(row([peer, NONE, failure, command]))
    return "\n".join(lines)


def describe_machine(data: dict) -> str:
    of = data["machine"]
    memory = of["memory_bytes"] / 2**30
    load = f"Load average before and after: {of['load_before']:.1f}, {of['load_after']:.1f}."
    return f"## Machine\n\n{of['processor']}, {of['processors']} processors, {memory:.0f} GiB, {of['system']}. {load}"


def row(cells: list[str]) -> str:
    return "| " + " | ".join(str(c).replace("|", "\\|") for c in cells) + " |"


def rule(numbers: int, align: str = "--:") -> str:
    return row(["---"] + [align] * numbers)


def dofs(data: dict, n: int) -> str:
    """Of a size, with thousands apart."""
    number = next((run["dofs"] for run in data["runs"] if run["n"] == n and "dofs" in run), None)
    return NONE if number is None else f"{number:,}".replace(",", " ")
