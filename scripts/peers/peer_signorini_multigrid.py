"""Signorini, multigrid."""

from signorini import main

main("signorini-multigrid", "multigrid", "wall and CPU of the process include a coarse level, its errors, tables and plots")
