"""FreeFEM: its own mesh, forms and matrices; IPOPT, as in FreeFEM's contact examples."""

from freefem import main

main("freefem-ipopt", "ipopt", "IPOPT, objective scaled by 1000, tolerance 1e-11")
