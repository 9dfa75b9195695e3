"""Signorini, direct."""

from signorini import main

main("signorini-condensed", "condensed", "wall and CPU of the process include a coarse level, its errors, tables and plots")
