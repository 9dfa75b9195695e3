//! `problem.json`: what a finite element code needs beside the mesh.

use serde::{Deserialize, Serialize};

/// The version of the form.
pub const SCHEMA: u32 = 1;

/// The problem of one level. Nodes are tags of `mesh.msh`, from 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Problem {
    /// [`SCHEMA`].
    pub schema: u32,
    /// Level, 0 the coarsest.
    pub level: usize,
    /// Cells of the level.
    pub cells: usize,
    /// `Ω'` and `Ω''`.
    pub bodies: [Body; 2],
    /// Boundary parts outside the contact zone.
    pub boundary: Vec<Part>,
    /// Whether sides are curved: the mesh file has their chords, and the matrices the true elements.
    pub curved: bool,
    /// Nodes that are held.
    pub supports: Vec<Support>,
    /// `f(φ_i)` for every node: body forces and tractions, integrated; component by component.
    pub nodal_load: Vec<[f64; 2]>,
    /// The contact pairs in the order of the zone.
    pub pairs: Vec<Pair>,
    /// Unknowns that are not fixed.
    pub dofs: usize,
    /// Rigid motions that nothing resists, the columns of `N.mtx`; any of the solutions will do.
    pub free_motions: usize,
}

/// A body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Name, and that of its physical surface.
    pub name: String,
    /// Tag of its physical surface.
    pub surface: usize,
    /// Tag of the physical curve of its contact face.
    pub contact_curve: usize,
    /// `C` in `(τ11, τ22, τ12) = C (ε11, ε22, 2ε12)`.
    pub hooke: [[f64; 3]; 3],
    /// `λ` of an isotropic law `τ = λ tr ε I + 2μ ε` in the plane.
    pub lambda: Option<f64>,
    /// `μ` of it.
    pub mu: Option<f64>,
}

/// A boundary part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Name, unique within the body.
    pub name: String,
    /// Name of the body.
    pub body: String,
    /// Tag of its physical curve.
    pub curve: usize,
    /// `fixed`, `sliding`, `traction` or `free`; its loads are in [`Problem::nodal_load`].
    pub condition: String,
}

/// A node that is held.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Support {
    /// The node.
    pub node: usize,
    /// Directions in which it may still move: none, or one unit vector.
    pub free: Vec<[f64; 2]>,
    /// Its displacement in the other directions.
    pub displacement: [f64; 2],
}

/// Two nodes that face each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// The node of `Ω'`.
    pub first: usize,
    /// The node of `Ω''`.
    pub second: usize,
    /// One constraint; two at a corner of the zone.
    pub constraints: Vec<Constraint>,
}

/// `normal·(u' − u'') ≤ gap`, or `=` where it is bilateral.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Constraint {
    /// Unit normal, outward from `Ω'`.
    pub normal: [f64; 2],
    /// Initial gap.
    pub gap: f64,
    /// The length that the pair stands for: its force over this is the pressure.
    pub mass: f64,
    /// Whether the bodies may not part.
    pub bilateral: bool,
}
