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
//! # Two blocks in contact
//!
//! ```
//! use signorini_contact::mesh::{Mesh, PartOutline, blocks::{Pattern, QuadBlock, triangulate}};
//! use signorini_contact::problem::{Data, Problem, Support};
//! use signorini_contact::{Body, ContactLine, Error, Material, Path, Point, Vec2, material::Plane, quadrature::Cubature, solver::Settings};
//!
//! struct Press; // a traction of 0.1 downwards on every loaded part
//! impl Data for Press {
//!     fn traction(&self, _part: usize, _x: Point, _normal: Vec2) -> Vec2 { Vec2::new(0.0, -0.1) }
//! }
//!
//! # fn main() -> Result<(), Error> {
//! let square = |y: f64| [[0.0, y], [1.0, y], [1.0, y + 1.0], [0.0, y + 1.0]].map(|[x, y]| Point::new(x, y));
//! let block = |y| triangulate(&[QuadBlock::straight(square(y), [8, 8])], Pattern::Structured);
//! let part = |body, name: &str, y: f64, corners: [usize; 2]| PartOutline {
//!     body, name: name.into(), along: Path::polyline(corners.map(|k| square(y)[k])),
//! };
//! let (parts, supports): (Vec<_>, Vec<_>) = [
//!     (part(Body::First, "right", 0.0, [1, 2]), Support::Free),
//!     (part(Body::First, "top", 0.0, [2, 3]), Support::Traction),
//!     (part(Body::First, "left", 0.0, [3, 0]), Support::Sliding),
//!     (part(Body::Second, "left", -1.0, [3, 0]), Support::Free),
//!     (part(Body::Second, "bottom", -1.0, [0, 1]), Support::Fixed),
//!     (part(Body::Second, "right", -1.0, [1, 2]), Support::Free),
//! ].into_iter().unzip();
//! let mesh = Mesh::build([block(0.0)?, block(-1.0)?], &parts, &ContactLine::polyline(&square(0.0)[..2]))?;
//! let material = Material::isotropic(1.0, 0.3, Plane::Strain)?;
//! let problem = Problem { mesh: &mesh, materials: [material; 2], supports: &supports, data: &Press, cubature: &Cubature::default() };
//! let (_, solution) = problem.solve(&Settings::default())?;
//! assert!(solution.raw.status.is_solved());
//! // Contact carries the whole load: the forces sum to the resultant.
//! let carried: f64 = solution.contact_forces.iter().flatten().sum();
//! assert!((carried - 0.1).abs() < 1e-12);
//! # Ok(()) }
//! ```
//!
//! The crate is the mathematics alone: it opens no file, reads no clock, prints nothing and knows no study.
//! The modules in reading order: [`geometry`], [`quadrature`], [`material`], [`mesh`], [`element`], [`zone`],
//! [`basis`], [`data`], [`assembly`], [`sparse`], [`qp`], [`solver`], [`rigid`], [`problem`], [`norm`], [`corner`].

pub mod assembly;
pub mod basis;
pub mod corner;
pub mod data;
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
pub use geometry::{ContactLine, Path, Point, Vec2};
pub use material::Material;
pub use mesh::Body;
