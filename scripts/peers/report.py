"""Clock of phases, and the one line of JSON that a peer prints. Imports no numpy: not every peer is written in Python."""

import argparse
import json
import os
import resource
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict

PHASES = ("mesh", "assembly", "setup", "solve")


class Run:
    """One measured run of one peer."""

    def __init__(self, peer: str):
        parser = argparse.ArgumentParser(description=f"Solves the two squares with {peer}; prints one line of JSON.")
        parser.add_argument("n", type=int, help="cells per side of each square, at least 1")
        self.peer = peer
        self.n = parser.parse_args().n
        if self.n < 1:
            parser.error(f"n is {self.n}, but a square needs at least 1 cell per side")
        # The driver says when it started this process, so that imports count into the wall time.
        self._started = float(os.environ.get("PEERS_STARTED", time.monotonic()))
        self._seconds: dict[str, float | None] = dict.fromkeys(PHASES)
        self._measured: tuple[float, float, int] | None = None
        self._cpu: dict[str, float | None] = dict.fromkeys(PHASES)

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        """Takes the time spent inside as the phase's."""
        start, cpu = time.perf_counter(), time.process_time()
        yield
        self.took(name, time.perf_counter() - start, time.process_time() - cpu)

    def took(self, name: str, seconds: float, cpu: float | None = None) -> None:
        """For a peer that takes its own times; without CPU seconds where it has none."""
        self._seconds[name], self._cpu[name] = seconds, cpu

    def finish(self, u, *, version: str, iterations: int | None, closed: int, note: str) -> None:
        """Prints the record. `u` is an array (nodes, 2) in the scene's numbering; its grading is not measured."""
        self.stop()
        import scene

        grade = asdict(scene.grade(scene.mesh(self.n), u))
        self.emit(grade, version=version, iterations=iterations, closed=closed, note=note)

    def emit(self, grade: dict, *, version: str, iterations: int | None, closed: int | None, note: str) -> None:
        """Prints the record of a peer that knows its energy but hands over no displacements."""
        self.stop()
        wall, cpu, peak = self._measured
        total = sum(seconds for seconds in self._seconds.values() if seconds is not None)
        record = {
            "peer": self.peer,
            "version": version,
            "n": self.n,
            "dofs": free_components(self.n),
            **grade,
            "seconds": {**self._seconds, "total": total, "wall": wall},
            "cpu_seconds": {**self._cpu, "process": cpu},
            "peak_bytes": peak,
            "iterations": iterations,
            "active": closed,
            "note": note,
        }
        print(json.dumps(record), flush=True)

    def stop(self) -> None:
        """Measures wall and CPU seconds and the peak once, when the answer is there; what follows does not count."""
        if self._measured is None:
            self._measured = (time.monotonic() - self._started, *usage())


def free_components(n: int) -> int:
    """Displacement components that no support holds: those of both bodies without the left side and the bottom."""
    return 4 * (n + 1) ** 2 - 3 * (n + 1)


def usage() -> tuple[float, int]:
    """CPU seconds of this process and its finished children; the larger of their peaks in bytes."""
    parts = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(p.ru_utime + p.ru_stime for p in parts), 1024 * max(p.ru_maxrss for p in parts)
