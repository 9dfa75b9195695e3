//! Meshes, constants and errors against closed forms, and the defects that must turn a verdict.
