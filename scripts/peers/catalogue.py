"""Which peers there are and how each is started."""

import glob
import os
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDER = Path(os.environ.get("SIGNORINI_PEERS", HERE.parents[1] / "peers"))
VENV, DEBIAN = str(FOLDER / "venv/bin/python"), "/usr/bin/python3"
# Debian's PETSc modules are not on Python's path unless an alternative is set up.
PETSC = glob.glob("/usr/lib/petscdir/petsc*/*-real/lib/python3/dist-packages")


@dataclass(frozen=True)
class Peer:
    name: str
    python: str  # the interpreter that has its modules
    limit: float = float("inf")  # seconds, where the driver's are not worth waiting for

    @property
    def file(self) -> Path:
        return HERE / f"peer_{self.name.replace('-', '_')}.py"


PEERS = {
    peer.name: peer
    for peer in [
        Peer("signorini-condensed", VENV),
        Peer("signorini-multigrid", VENV),
        Peer("condensed", VENV),
        Peer("scikit-fem", VENV),
        Peer("scipy", VENV),
        Peer("freefem-active", VENV),
        Peer("freefem-ipopt", VENV),
        Peer("getfem", DEBIAN),
        Peer("ngsolve", VENV),
        Peer("petsc-vi", DEBIAN),
        Peer("petsc-gamg", DEBIAN),
        Peer("petsc-hypre", DEBIAN),
        Peer("clarabel", VENV),
        Peer("piqp", VENV),
        Peer("proxqp", VENV),
        Peer("osqp", VENV),
        # Its null space is a dense matrix: 10 s at n = 24, six times as much at n = 32.
        Peer("highs", VENV, limit=60),
    ]
}


def command(peer: Peer, n: int) -> list[str]:
    return [peer.python, str(peer.file), str(n)]


def environment(peer: Peer, threads: int) -> dict[str, str]:
    """The caller's, with the number of threads that BLAS and OpenMP may use, and Debian's modules for Debian's Python."""
    env = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    env |= {"OMP_NUM_THREADS": str(threads), "OPENBLAS_NUM_THREADS": str(threads)}
    if peer.python == DEBIAN and PETSC:
        env["PYTHONPATH"] = PETSC[-1]
    return env
