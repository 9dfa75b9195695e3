"""PETSc: active set, conjugate gradients with smoothed aggregation (GAMG)."""

from petsc_active_set import main

main(
    "petsc-gamg",
    {"ksp_type": "cg", "pc_type": "gamg", "pc_gamg_threshold": "0.01"},
    "numpy assembly; active set; CG with GAMG and rigid motions",
)
