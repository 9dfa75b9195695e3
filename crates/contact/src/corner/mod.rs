//! Exponents of the solution at a corner: `u ~ r^λ U(θ)`, and the smallest `Re λ` decides how fast errors fall.
//!
//! ```text
//!                 face at θ = to
//!                /                    Near a corner the bodies are wedges. Loads and smooth data do not matter there:
//!               /   wedge             r^λ U(θ) solves Lamé's equations without forces and the homogeneous conditions
//!              / ω                    on the faces for a discrete set of λ. Only 0 < Re λ < 1 is singular; r^λ U lies in
//!   ──────────x────────────           H^{1+Re λ−δ}, so linear elements on quasi-uniform meshes converge like
//!              face at θ = from       h^{min(1, Re λ)} in H¹.
//! ```
//!
//! With `u = r^λ (U_r, U_θ)(θ)` the strains are `r^{λ−1}` times
//!
//! ```text
//! e_rr = λ U_r,   e_θθ = U_θ' + U_r,   2 e_rθ = U_r' + (λ − 1) U_θ,   in short  e = (B_0 + λ B_1) U
//! ```
//!
//! and equilibrium with natural conditions on the faces, tested with `r^{−λ} V(θ)`, reads
//!
//! ```text
//! ∫ ((B_0 − λ B_1) V)ᵀ C (B_0 + λ B_1) U dθ = 0      for all V
//! ```
//!
//! a quadratic eigenvalue problem in `λ`, for any Hooke's law `C`. It is solved by piecewise polynomials in `θ`; the modes
//! are analytic there, so few suffice.
//!
//! Frictionless contact joins two wedges along a ray: `U_θ` is the same on both sides and `σ_θθ` balances, `σ_rθ = 0`.

mod pencil;
#[cfg(test)]
mod tests;

use crate::Error;
use crate::material::Material;
use nalgebra::Complex;
use std::f64::consts::TAU;

/// The condition on a face of a wedge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// `u = 0`.
    Clamped,
    /// `u_n = 0`, no tangential traction.
    Sliding,
    /// No traction.
    Free,
    /// Frictionless contact that stays closed: `u_n` and `T_n` as on the face of the other wedge in the same direction,
    /// `T_t = 0`.
    Contact,
}

/// A body near a corner: the sector `from ≤ θ ≤ to` about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wedge {
    /// Its material.
    pub material: Material,
    /// Angle of the first face, in radians from the `x`-axis.
    pub from: f64,
    /// Angle of the second face, `from < to ≤ from + 2π`.
    pub to: f64,
    /// Conditions on the two faces.
    pub faces: [Face; 2],
}

/// Two directions are one if their angles differ by less than this.
const SAME_ANGLE: f64 = 1e-7;

/// Exponents below this are taken for the rigid translations, `λ = 0`.
pub const SMALLEST: f64 = 1e-3;

/// Exponents closer to 1 than this are 1: a rotation or a constant strain, and no singularity.
pub const CLOSE_TO_ONE: f64 = 1e-5;

impl Wedge {
    /// The angle `ω`.
    pub fn angle(&self) -> f64 {
        self.to - self.from
    }

    /// The angle of one of the two faces.
    fn face_angle(&self, end: usize) -> f64 {
        [self.from, self.to][end]
    }
}

/// All exponents with [`SMALLEST`] `< Re λ < 2` and `Im λ ≥ 0` of one wedge, or of two in contact, by ascending real part.
/// Rotations (`λ = 1`) are among them.
///
/// # Errors
/// [`Error::Mesh`] for a wedge without an angle or beyond a full turn, and for contact faces that do not meet.
pub fn exponents(wedges: &[Wedge]) -> Result<Vec<Complex<f64>>, Error> {
    wedges.iter().try_for_each(check_angle)?;
    let contacts = contacts(wedges)?;
    let mut found: Vec<Complex<f64>> = pencil::Pencil::new(wedges, &contacts).eigenvalues();
    found.retain(|l| l.re > SMALLEST && l.re < 2.0 && l.im >= 0.0);
    found.sort_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im)));
    Ok(found)
}

/// The exponent with the smallest real part below 1; none if the corner has no singularity.
///
/// # Errors
/// As [`exponents`].
pub fn singular_exponent(wedges: &[Wedge]) -> Result<Option<Complex<f64>>, Error> {
    Ok(exponents(wedges)?.into_iter().find(|l| l.re < 1.0 - CLOSE_TO_ONE))
}

/// A face of a wedge: the wedge's number, and 0 for `from`, 1 for `to`.
type FaceOf = (usize, usize);

fn check_angle(wedge: &Wedge) -> Result<(), Error> {
    let angle = wedge.angle();
    if angle > SAME_ANGLE && angle < TAU + SAME_ANGLE {
        return Ok(());
    }
    Err(Error::Mesh(format!(
        "a wedge of {}° at a corner; its angle has to lie between 0° and 360°",
        angle.to_degrees()
    )))
}

/// Which contact faces belong together.
fn contacts(wedges: &[Wedge]) -> Result<Vec<[FaceOf; 2]>, Error> {
    let faces =
        || (0..wedges.len()).flat_map(|w| [(w, 0), (w, 1)]).filter(|(w, e)| wedges[*w].faces[*e] == Face::Contact);
    let angle = |(w, e): FaceOf| wedges[w].face_angle(e);
    let mut pairs = Vec::new();
    for a in faces() {
        // a wedge lies to the left of its face `from` and to the right of its face `to`
        let mut partners = faces().filter(|b| b.0 != a.0 && b.1 != a.1 && same_direction(angle(a), angle(*b)));
        match (partners.next(), partners.next()) {
            (Some(b), None) if a < b => pairs.push([a, b]),
            (Some(_), None) => {}
            _ => {
                return Err(Error::Mesh(format!(
                    "a contact face in the direction {}° that no other wedge meets",
                    angle(a).to_degrees()
                )));
            }
        }
    }
    Ok(pairs)
}

/// Whether two angles are the same up to full turns.
fn same_direction(a: f64, b: f64) -> bool {
    let turns = (a - b) / TAU;
    (turns - turns.round()).abs() * TAU < SAME_ANGLE
}
