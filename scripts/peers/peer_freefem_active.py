"""FreeFEM: its own mesh, forms and matrices; active set; MUMPS."""

from freefem import main

main("freefem-active", "active", "active set, symmetric MUMPS in each step")
