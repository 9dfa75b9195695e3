//! The lemmas of the paper that measure functions on meshes: no contact problem is solved in them.
//!
//! | lemma | what is measured | module |
//! | --- | --- | --- |
//! | 3.2 | `‖u − u_I‖_{0,∂Ω}` on discs and ellipses | [`boundary`] |
//! | 3.3 | the constant of the inverse inequality on intervals | [`inverse`] |
//! | 3.4 | the constant of the strip between arc and chord | [`strip`] |
//!
//! A lemma's level has the form of any other one, so that rates, verdicts, tables and plots are the same; what only a
//! solved problem has is zero there and not shown (see [`NO_SOLVER`](crate::record::NO_SOLVER)).

pub mod boundary;
pub mod domain;
pub mod ellipse;
mod gram;
pub mod inverse;
pub mod mesh;
pub mod strip;
#[cfg(test)]
mod tests;

use crate::error::RunError;
use crate::record::{Budget, Errors, Kkt, Level, SolverRecord};
use boundary::BoundaryFunction;
use domain::Domain;
use inverse::Intervals;
use mesh::{DomainMesh, Quality};
use signorini_contact::mesh::fnv1a;

/// What a lemma's case measures.
#[derive(Clone, Debug)]
pub enum Lemma {
    /// Lemma 3.2: interpolation of a function on the boundary of a convex domain.
    BoundaryInterpolation {
        /// The domain, [`domain::Side::Inside`] of its curve.
        domain: Domain,
        /// The function.
        function: BoundaryFunction,
    },
    /// Lemma 3.3: the inverse inequality on a family of intervals.
    InverseInequality(Intervals),
    /// Lemma 3.4: the strips between the arcs and chords of a mesh.
    Strip(Domain),
}

/// A mesh or a division of an interval, measured.
struct Certificate {
    quality: Quality,
    nodes: usize,
    hash: String,
}

impl Lemma {
    /// The field of [`Errors`] that is measured.
    pub fn norm(&self) -> &'static str {
        match self {
            Self::BoundaryInterpolation { .. } => "boundary_l2",
            Self::InverseInequality(_) | Self::Strip(_) => "constant",
        }
    }

    /// The family of meshes: `refined` (red refinement, new nodes on the true curve) or `intervals`.
    pub fn family(&self) -> &'static str {
        match self {
            Self::InverseInequality(_) => "intervals",
            _ => "refined",
        }
    }

    /// The seed of a random family, 0 where nothing is random.
    pub fn seed(&self) -> u64 {
        match self {
            Self::InverseInequality(intervals) => intervals.seed,
            _ => 0,
        }
    }

    /// Whether levels must be powers of two: numbers of parts of each coarse side under red refinement.
    pub fn halves(&self) -> bool {
        !matches!(self, Self::InverseInequality(_))
    }

    /// Everything that can change a number, in words.
    pub fn describe(&self) -> String {
        let curve = |d: &Domain| format!("{:?} of semi-axes {:?}", d.side, d.ellipse.semi_axes);
        match self {
            Self::BoundaryInterpolation { domain, function } => {
                format!("boundary interpolation of {}, {}", function.expression.text(), curve(domain))
            }
            Self::InverseInequality(i) => format!("inverse inequality {:?} on {:?}, seed {}", i.norms, i.whole, i.seed),
            Self::Strip(domain) => format!("strip, {}", curve(domain)),
        }
    }

    /// Measures level `index` of those with the given numbers of cells.
    ///
    /// # Errors
    /// [`RunError::Study`] for a function that is not finite, and for cells that are no power of two where the mesh is
    /// refined by halving.
    pub fn measure(&self, cells: &[usize], index: usize) -> Result<Level, RunError> {
        let n = cells[index];
        match self {
            Self::BoundaryInterpolation { domain, function } => {
                let mesh = domain.mesh(halvings(n)?);
                interpolation_level(&mesh, function, n, index)
            }
            Self::InverseInequality(intervals) => Ok(interval_level(intervals, n, index)),
            Self::Strip(domain) => Ok(strip_level(&domain.mesh(halvings(n)?), n, index)),
        }
    }
}

/// `log2 n`.
fn halvings(n: usize) -> Result<u32, RunError> {
    if n.is_power_of_two() {
        return Ok(n.ilog2());
    }
    Err(RunError::Study(format!("{n} parts of a coarse side do not arise by halving; take a power of two")))
}

fn interpolation_level(
    mesh: &DomainMesh,
    function: &BoundaryFunction,
    n: usize,
    index: usize,
) -> Result<Level, RunError> {
    let [error, change] = boundary::error(mesh, function)?;
    let errors = Errors { boundary_l2: Some(error), ..Errors::default() };
    let budget = Budget { quadrature: (error > 0.0).then(|| change / error), ..Budget::default() };
    Ok(level(index, n, mesh_certificate(mesh), errors, budget))
}

fn strip_level(mesh: &DomainMesh, n: usize, index: usize) -> Level {
    let certificate = mesh_certificate(mesh);
    let constant = strip::constant(mesh, certificate.quality.h);
    level(index, n, certificate, Errors { constant: Some(constant), ..Errors::default() }, Budget::default())
}

fn interval_level(intervals: &Intervals, n: usize, index: usize) -> Level {
    let points = intervals.points(n);
    let lengths = || points.windows(2).map(|w| w[1] - w[0]);
    let h = lengths().fold(0.0, f64::max);
    let side_ratio = h / lengths().fold(f64::INFINITY, f64::min);
    let quality = Quality { h, min_angle: 0.0, side_ratio };
    let bytes: Vec<u8> = points.iter().flat_map(|x| x.to_le_bytes()).collect();
    let certificate = Certificate { quality, nodes: points.len(), hash: format!("{:016x}", fnv1a(&bytes)) };
    let errors = Errors { constant: Some(intervals.constant(&points)), ..Errors::default() };
    level(index, n, certificate, errors, Budget::default())
}

fn mesh_certificate(mesh: &DomainMesh) -> Certificate {
    Certificate { quality: mesh.quality(), nodes: mesh.points.len(), hash: mesh.hash() }
}

/// A level on which nothing was solved.
fn level(index: usize, cells: usize, certificate: Certificate, errors: Errors, budget: Budget) -> Level {
    let Certificate { quality, nodes, hash } = certificate;
    Level {
        level: index,
        cells,
        h: quality.h,
        min_angle: quality.min_angle,
        side_ratio: quality.side_ratio,
        straight_over_chord: None,
        nested: false,
        // two components in every node
        dofs: 2 * nodes,
        contact_pairs: 0,
        constraints: 0,
        active: 0,
        switch_sides: None,
        energy: 0.0,
        two_way: None,
        mesh_hash: hash,
        errors,
        ledger: None,
        splitting: Vec::new(),
        inside: None,
        kkt: Kkt::default(),
        budget,
        solver: SolverRecord::nothing_to_solve(),
        warnings: Vec::new(),
        excluded: None,
        solution_energy: None,
        solution_h1: None,
        solution_trace: None,
        contact: None,
        second: None,
        fields: None,
    }
}
