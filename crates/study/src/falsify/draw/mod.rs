//! A draw: a random scene that meets the hypotheses of its target, and the study file that it is.
//!
//! Everything is a function of target, seed and number. Numbers are short, so that the file says exactly what was drawn.

mod random;
mod simpler;
mod text;
mod traces;

pub use random::draw;
pub use simpler::simpler;
pub use traces::TraceDraw;
use traces::Wave;

use super::target::Target;

/// Cells along the zone beyond which no level is added.
const FINEST: usize = 128;

/// Young's modulus and Poisson's ratio, plane strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// Young's modulus.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl Law {
    /// `μ = E / (2 (1 + ν))`.
    pub fn shear(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }
}

/// A family of triangulations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mesh {
    /// Right triangles.
    Structured,
    /// Both diagonals.
    CrissCross,
    /// Alternating diagonals.
    UnionJack,
    /// Nodes moved by a share of the cell.
    Perturbed(u64, f64),
    /// Refinement of a perturbed coarse mesh.
    Refined(u64, f64),
    /// Refinement of a Delaunay mesh.
    RefinedDelaunay(u64),
    /// Independent Delaunay meshes.
    Delaunay(u64),
}

/// Where the bodies meet.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// `y = 0`, `0 ≤ x ≤ width`.
    Line {
        /// Length of the zone.
        width: f64,
        /// Heights of the bodies.
        heights: [f64; 2],
        /// Both bodies consist of two blocks that meet at this `x`.
        split: Option<f64>,
    },
    /// A quarter of the unit circle.
    Arc,
    /// Two graphs `x = f(y)`, `−1 ≤ y ≤ 1`.
    Graph(Faces),
    /// A polyline from `x = −1` to `x = 1`; no exact solution.
    Polyline(Pushed),
}

/// The two faces of a gap: `f'' = t_1 η + t_2 η²`, `f' = f'' + ε`, `ε = e_0 + e_2 η² + e_3 η³`.
#[derive(Clone, Debug, PartialEq)]
pub enum Faces {
    /// One of the three shapes of the built-in solutions.
    Shape(usize),
    /// `[e_0, e_2, e_3, t_1, t_2]`.
    Cubic([f64; 5]),
}

/// Bodies pressed together along a polyline.
#[derive(Clone, Debug, PartialEq)]
pub struct Pushed {
    /// Corners of the zone, rising in `x`.
    pub corners: Vec<[f64; 2]>,
    /// Displacement of the top of `Ω'`.
    pub top: [f64; 2],
    /// Forces per area in units of the smaller shear modulus, of `Ω'` and `Ω''`: `[constant, times x]` in each direction.
    pub forces: [[f64; 2]; 2],
}

/// The exact solution.
#[derive(Clone, Debug, PartialEq)]
pub enum Solution {
    /// Built in: name and parameters.
    BuiltIn(&'static str, Vec<(&'static str, f64)>),
    /// By its traces.
    Traces(TraceDraw),
    /// None.
    None,
}

/// A scene with its meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    /// What it is drawn for.
    pub target: Target,
    /// Materials of `Ω'` and `Ω''`.
    pub laws: [Law; 2],
    /// The zone.
    pub place: Place,
    /// The solution.
    pub solution: Solution,
    /// The family.
    pub mesh: Mesh,
    /// Cells per unit on each level.
    pub levels: Vec<usize>,
}

impl Draw {
    /// The smaller shear modulus: the unit of stress.
    pub fn unit(&self) -> f64 {
        self.laws[0].shear().min(self.laws[1].shear())
    }

    /// The same scene with one more level, twice as fine as the finest; none where that would be too many cells.
    pub fn finer(&self) -> Option<Self> {
        let last = *self.levels.last()?;
        let cells = match &self.place {
            Place::Line { split: Some(_), .. } | Place::Arc | Place::Graph(_) => 2 * last,
            _ => last,
        };
        let levels = self.levels.iter().copied().chain([2 * last]).collect();
        (cells < FINEST).then(|| Self { levels, ..self.clone() })
    }

    /// The scene in a few words.
    pub fn words(&self) -> String {
        let solution = match &self.solution {
            Solution::BuiltIn(name, values) => {
                let values: Vec<String> = values.iter().map(|(k, v)| format!("{k} = {v}")).collect();
                format!("{name} {}", values.join(", ")).trim_end().to_owned()
            }
            Solution::Traces(t) => format!("traces, {} switch points", t.switches.len()),
            Solution::None => "loads".into(),
        };
        let ratio = self.laws[1].shear() / self.laws[0].shear();
        let mesh = match self.mesh {
            Mesh::Structured => "structured",
            Mesh::CrissCross => "criss-cross",
            Mesh::UnionJack => "union-jack",
            Mesh::Perturbed(..) => "perturbed",
            Mesh::Refined(..) => "refined",
            Mesh::RefinedDelaunay(_) => "refined Delaunay",
            Mesh::Delaunay(_) => "delaunay",
        };
        format!("{solution}; μ''/μ' = {}; {mesh}", super::dice::rounded(ratio, 2))
    }
}
