//! Finite elements for the frictionless contact of two plane elastic bodies.
//!
//! Given are two bodies `Ω'` ([`Body::First`]) and `Ω''` ([`Body::Second`]) that share the contact zone `Γ_K`.
//! Find the displacement `u ∈ K` that minimises the energy
//!
//! ```text
//! L(v) = ½ A(v,v) − f(v),   A(u,v) = ∫_Ω τ_ij(u) ε_ij(v) dx,   f(v) = ∫_Ω F_i v_i dx + ∫_Γτ P_i v_i ds
//! K    = { v : v = u_D on Γ_u,  v_n = 0 on Γ_0,  n·(v' − v'') ≤ 0 on Γ_K }        (n = n', outward from Ω')
//! ```
//!
//! discretised as in J. Haslinger, I. Hlaváček, *Contact between elastic bodies — II. Finite element analysis*:
//! continuous piecewise linear displacements, one constraint per contact node and normal.
//!
//! The crate is the mathematics alone: it opens no file, reads no clock, prints nothing and knows no study.
//! The modules in reading order: [`geometry`], [`quadrature`], [`material`], [`mesh`], [`element`], [`zone`],
//! [`assembly`], [`sparse`], [`qp`], [`solver`], [`rigid`], [`problem`], [`norm`].

pub mod assembly;
pub mod basis;
pub mod element;
pub mod error;
pub mod geometry;
pub mod material;
pub mod mesh;
pub mod norm;
pub mod problem;
pub mod qp;
pub mod quadrature;
pub mod rigid;
pub mod solver;
pub mod sparse;
pub mod sum;
pub mod zone;

pub use error::Error;
pub use geometry::{Point, Vec2};
pub use material::Material;
pub use mesh::Body;
