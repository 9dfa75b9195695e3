"""PETSc: active set, conjugate gradients with hypre's BoomerAMG."""

from petsc_active_set import main

main(
    "petsc-hypre",
    {"ksp_type": "cg", "pc_type": "hypre", "pc_hypre_type": "boomeramg"},
    "numpy assembly; active set; CG with BoomerAMG",
)
