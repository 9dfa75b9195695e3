"""Runs freefem.edp and reads what it prints."""

import os
import subprocess
import tempfile
import time
from pathlib import Path

from report import PHASES, Run

# Where Debian keeps plug-ins and headers; its FreeFEM looks elsewhere.
PLACES = {"FF_LOADPATH": "/usr/lib/freefem++", "FF_INCLUDEPATH": "/usr/include/freefem++/idp"}
SCRIPT = Path(__file__).with_name("freefem.edp")


def version() -> str:
    # The program itself still says 4.9 in Debian's 4.11.
    query = ["dpkg-query", "-W", "-f=${Version}", "freefem++"]
    answer = subprocess.run(query, capture_output=True, text=True, check=False)
    return f"FreeFEM {answer.stdout.strip() or '(version unknown)'}"


def main(peer: str, method: str, note: str) -> None:
    """The whole peer; `method` is active or ipopt."""
    run = Run(peer)
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "u.txt"
        # Line by line, or all lines would arrive at the end.
        command = ["stdbuf", "-oL", "FreeFem++", "-ne", "-nw", "-v", "0", str(SCRIPT)]
        command += ["-n", str(run.n), "-method", method, "-out", str(out)]
        counts = watch(run, command)
        run.stop()
        import numpy as np

        run.finish(np.loadtxt(out), version=version(), note=note, **counts)


def watch(run: Run, command: list[str]) -> dict[str, int | None]:
    """Runs the command; phases end when their lines arrive. Returns iterations and active pairs."""
    counts = {}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=os.environ | PLACES) as process:
        last = time.perf_counter()
        for line in process.stdout:
            match line.split():
                case ["phase", name, cpu]:
                    now = time.perf_counter()
                    if name in PHASES:
                        run.took(name, now - last, float(cpu))
                    last = now
                case ["iterations" | "active" as name, count]:
                    counts[name] = int(count)
    if process.returncode != 0 or len(counts) < 2:
        raise RuntimeError(f"FreeFEM ended with status {process.returncode}")
    # IPOPT does not tell.
    return {"iterations": counts["iterations"] or None, "closed": counts["active"]}
