//! A study with everything resolved: what to build, solve, measure and judge, case by case.

use crate::claim::Claim;
use crate::exact::Exact;
use crate::family::Family;
use crate::lemma::Lemma;
use crate::record::{Bounds, Changed, FormulaValues, Outcome};
use crate::splitting::SplittingPlan;
use signorini_contact::element::CurvedElement;
use signorini_contact::geometry::{InitialGap, Piece, SharedCurve};
use signorini_contact::mesh::Triangulation;
use signorini_contact::problem::SlideCondition;
use signorini_contact::{Body, ContactLine, Material, Path, Point, Vec2, mesh, solver};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

/// A study: a question, a claim and the cases that answer it.
#[derive(Clone)]
pub struct Study {
    /// Id, the file's stem.
    pub id: String,
    /// One line.
    pub title: String,
    /// What is asked.
    pub question: String,
    /// What is set up.
    pub setup: String,
    /// What would refute the claim.
    pub refuted_by: String,
    /// The claim that is judged.
    pub claim: Claim,
    /// Where the study was read.
    pub source: PathBuf,
    /// The cases in file order, each complete in itself.
    pub cases: Vec<Case>,
}

/// One scene, one family, one reference.
#[derive(Clone)]
pub struct Case {
    /// Name, unique in the study.
    pub name: String,
    /// What is measured.
    pub subject: Subject,
    /// Family of triangulations of a contact problem; a lemma has its own.
    pub family: Family,
    /// Cells per unit of the coarse block division on each level, coarsest first: quick profile.
    pub quick: Vec<usize>,
    /// The same for the full profile.
    pub full: Vec<usize>,
    /// What the errors are measured against.
    pub reference: ReferencePlan,
    /// Solver settings.
    pub solver: solver::Settings,
    /// Who is asked for a second opinion on every level.
    pub second: Option<solver::Method>,
    /// How sharply to judge.
    pub gates: Gates,
    /// The three bounds, with the case's own in place of the claim's where it states them.
    pub bounds: Bounds,
    /// Whether a rate above the expected one is reported and not gated.
    pub expected_is_asymptotic: bool,
    /// Whether the expected rate is that of the scene's corners, filled in by the run.
    pub expected_from_corners: bool,
    /// Whether the levels project the reference onto `K_h` in the energy norm, in place of solving the scene's own problem.
    pub projects: bool,
    /// Whether the regularity is borderline: fits with a logarithm are then reported beside the rate.
    pub borderline: bool,
    /// Numbers that define the case, for the record.
    pub parameters: BTreeMap<String, f64>,
    /// What a control expects.
    pub expect: Option<Outcome>,
    /// Whether the scene has no solution and the case passes by being refused.
    pub refused: bool,
    /// Why the case cannot be judged at the quick profile's sizes.
    pub inconclusive_at_quick: Option<String>,
    /// Falk's splitting, if it is measured.
    pub splitting: Option<SplittingPlan>,
    /// Fixed quadrature depth in place of the graded one at singular points (a control's defect).
    pub fixed_quadrature: bool,
    /// Remarks of the reader's interest, e.g. a dropped tail.
    pub notes: Vec<String>,
    /// Everything of the case that can change a number or the verdict, one fact per line: what
    /// [`Case::fingerprint`] hashes.
    pub canonical: String,
    /// What options changed of the case in the file.
    pub changed: Option<Changed>,
}

impl Study {
    /// The id of the file, also where options changed the study.
    pub fn id_of_file(&self) -> &str {
        self.cases.first().and_then(|c| c.changed.as_ref()).map_or(&self.id, |c| &c.study)
    }
}

/// What a case measures.
#[derive(Clone)]
pub enum Subject {
    /// A contact problem, solved on every level.
    Contact(Box<Scene>),
    /// A lemma, measured on every level; nothing is solved.
    Lemma(Lemma),
}

impl Case {
    /// The scene of a contact problem.
    pub fn scene(&self) -> Option<&Scene> {
        match &self.subject {
            Subject::Contact(scene) => Some(scene),
            Subject::Lemma(_) => None,
        }
    }

    /// The name of the family of meshes.
    pub fn family_name(&self) -> &'static str {
        match &self.subject {
            Subject::Contact(_) => self.family.name(),
            Subject::Lemma(lemma) => lemma.family(),
        }
    }

    /// The seed of a random family, 0 where nothing is random.
    pub fn seed(&self) -> u64 {
        match &self.subject {
            Subject::Contact(_) => self.family.seed(),
            Subject::Lemma(lemma) => lemma.seed(),
        }
    }
}

/// Reference solution of a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReferencePlan {
    /// The scene's exact solution.
    Exact,
    /// The discrete solution with this many cells, on straight bodies and in nested families nested above every level: quick and
    /// full profile.
    Overkill {
        /// Cells of the reference mesh at the quick profile.
        quick: usize,
        /// Cells at the full profile.
        full: usize,
    },
    /// None: energies and certificates only.
    None,
}

/// Tolerances of the verdict, the defaults in brackets.
#[derive(Clone, Debug, PartialEq)]
pub struct Gates {
    /// Tolerance on the rate (0.05).
    pub rate_tolerance: f64,
    /// Error ceiling: `energy ≤ ceiling · interpolation error` (1.5; `None`: no ceiling).
    pub ceiling: Option<f64>,
    /// Kind `exact`: error ≤ this · ‖u‖_A (1e-11).
    pub exact_tolerance: f64,
    /// Kind `convergence`: each error at most this times the previous (0.9).
    pub fall: f64,
    /// Kind `bounded`: largest over smallest constant, or largest over `constant` where that is given (2).
    pub spread: f64,
    /// Kind `bounded`: the reference constant of an upper bound that may vanish on some meshes; kind `agreement`: the largest
    /// relative difference (none).
    pub constant: Option<f64>,
    /// Largest share of a budget item (0.05).
    pub share: f64,
}

impl Default for Gates {
    fn default() -> Self {
        Self {
            rate_tolerance: 0.05,
            ceiling: Some(1.5),
            exact_tolerance: 1e-11,
            fall: 0.9,
            spread: 2.0,
            constant: None,
            share: 0.05,
        }
    }
}

/// Two bodies, their materials, boundary conditions, loads and contact zone.
#[derive(Clone)]
pub struct Scene {
    /// Shapes of `Ω'` and `Ω''`.
    pub bodies: [Shape; 2],
    /// Materials of the discrete problem.
    pub materials: [Material; 2],
    /// Boundary parts outside the contact zone.
    pub parts: Vec<Part>,
    /// The contact zone.
    pub contact: ContactLine,
    /// Numbers of the pieces of the zone where the bodies may not part, `Γ_K0`, ascending.
    pub bilateral: Vec<usize>,
    /// The condition that picks one solution where a body may slide; `None`: the program's own.
    pub slide: Option<SlideCondition>,
    /// The initial distance of the bodies along a straight common zone; none where they just touch.
    pub initial_gap: Option<InitialGap>,
    /// How curved sides and the contact zone are discretised.
    pub discretisation: Discretisation,
    /// Body forces given by expressions; `None`: zero, or from the exact solution if there is one.
    pub body_force: [Option<VectorField>; 2],
    /// The exact solution, with the materials that it solves for.
    pub exact: Option<ExactScene>,
    /// Whether the scene is one half of a symmetric one and the contact zone starts on the axis.
    pub symmetric: bool,
    /// What a formula says of the contact.
    pub formula: Option<Formula>,
}

/// What a formula of engineering says of the contact. It neglects something; nothing is solved with it.
#[derive(Clone)]
pub struct Formula {
    /// Force, half width and peak pressure.
    pub values: FormulaValues,
    /// The pressure at a point of `∂Ω'` in the zone, per length or, across a gap, per width in `η`.
    pub pressure: Option<Arc<dyn Fn(Point) -> f64 + Send + Sync>>,
}

/// How curved sides and the contact zone are discretised: as in the paper, unless a control plants a defect.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Discretisation {
    /// The element on triangles with a curved side.
    pub element: CurvedElement,
    /// Straight sides in place of the curved ones.
    pub chords: bool,
    /// The normals of the constraints.
    pub normals: Normals,
}

/// Which normal a constraint at a node of a curved zone takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// That of the curve at the node (2.5).
    #[default]
    True,
    /// The mean of the normals of the two adjacent chords.
    Averaged,
    /// That of the chord before the node.
    Chord,
}

/// A body: quadrilateral blocks, corners counterclockwise, sharing whole sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its name in the study.
    pub name: String,
    /// The blocks and how each is divided; none of a body out of a mesh file.
    pub blocks: Vec<Block>,
    /// The body as a mesh file has it, in place of blocks.
    pub imported: Option<Arc<Imported>>,
}

/// A body out of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Its coarsest mesh.
    pub mesh: Triangulation,
    /// Its boundary: parts and contact zone, from corner to corner.
    pub boundary: Vec<Piece>,
    /// What the reader should know of how it was read.
    pub notes: Vec<String>,
}

impl Shape {
    /// Whether a side of the body is curved.
    pub fn is_curved(&self) -> bool {
        let blocks = self.blocks.iter().flat_map(|b| &b.curves).any(Option::is_some);
        blocks || self.imported.iter().flat_map(|i| &i.boundary).any(|p| p.curve().is_some())
    }
}

/// A quadrilateral, divided into `divisions[0]·n × divisions[1]·n` cells at mesh parameter `n`.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Corners, counterclockwise; cells run along `corner 0 → 1` first and along `0 → 3` second.
    pub corners: [Point; 4],
    /// Cells per unit of `n` in the two directions.
    pub divisions: [usize; 2],
    /// The curve of side `k`, from corner `k` to corner `k + 1`; none where it is straight.
    pub curves: [Option<SharedCurve>; 4],
    /// How many times as long the last cell is as the first, in the two directions; `[1, 1]` is even.
    pub grading: [f64; 2],
}

/// A named boundary part and its condition.
#[derive(Clone)]
pub struct Part {
    /// Body.
    pub body: Body,
    /// Name, unique within the body.
    pub name: String,
    /// The path that it covers.
    pub along: Path,
    /// The condition on it.
    pub condition: PartCondition,
}

/// Conditions of the study file.
#[derive(Clone)]
pub enum PartCondition {
    /// `Γ_u` with `u = 0`, or given data; with an exact solution and no data, its trace.
    Fixed(Option<VectorField>),
    /// `Γ_0`: `u_n = 0`, no tangential traction.
    Sliding,
    /// `Γτ` with given traction; with an exact solution and no data, `τ(u) n`.
    Traction(Option<VectorField>),
    /// `Γτ` without traction.
    Free,
}

/// A vector field given by the study: two expressions in `x, y` and, on the boundary, the normal `nx, ny`.
pub type VectorField = Arc<dyn Fn(Point, Vec2) -> Vec2 + Send + Sync>;

/// An exact solution and the materials it was built for.
#[derive(Clone)]
pub struct ExactScene {
    /// The solution.
    pub solution: Arc<dyn Exact>,
    /// The materials that turn it into loads. Those of the scene unless a control plants a defect.
    pub materials: [Material; 2],
}

impl Scene {
    /// The parts as the mesh wants them: body, name, path.
    pub fn part_outlines(&self) -> Vec<mesh::PartOutline> {
        self.parts
            .iter()
            .map(|p| mesh::PartOutline { body: p.body, name: p.name.clone(), along: p.along.clone() })
            .collect()
    }
}
