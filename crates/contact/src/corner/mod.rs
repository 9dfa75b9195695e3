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
use pencil::Pencil;
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

/// A solution `r^λ U(θ)` of the local problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// `λ`.
    pub exponent: Complex<f64>,
    /// The contact pressure `−σ_θθ/r^{λ−1}` on each closed ray, up to one common factor of either sign; `None` where `λ` is complex
    /// or belongs to several modes, which then combine.
    pub pressures: Option<Vec<f64>>,
}

/// A pressure below this share of the largest on any ray is none.
const NO_PRESSURE: f64 = 1e-6;

impl Mode {
    /// Whether the mode can govern a solution whose rays stay closed: a pressure that oscillates or pulls on one ray while it
    /// presses on another would have to open it. The leading coefficient of such a mode is zero.
    pub fn may_press(&self, contacts: usize) -> bool {
        if contacts > 0 && self.exponent.im != 0.0 {
            return false;
        }
        let Some(pressures) = &self.pressures else { return true };
        let largest = pressures.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
        let has = |sign: f64| pressures.iter().any(|p| sign * p > NO_PRESSURE * largest);
        !(has(1.0) && has(-1.0))
    }
}

/// What a corner lets expect.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Singularity {
    /// The exponent with the smallest real part below 1 whose mode can press on all closed rays; none if the corner has no
    /// singularity.
    pub exponent: Option<Complex<f64>>,
    /// The smallest one that was passed over because its mode would pull on a closed ray.
    pub pulling: Option<Complex<f64>>,
}

/// All exponents with [`SMALLEST`] `< Re λ < 2` and `Im λ ≥ 0` of one wedge, or of two in contact, by ascending real part.
/// Rotations (`λ = 1`) are among them.
///
/// # Errors
/// [`Error::Mesh`] for a wedge without an angle or beyond a full turn, and for contact faces that do not meet.
pub fn exponents(wedges: &[Wedge]) -> Result<Vec<Complex<f64>>, Error> {
    Ok(in_order(&pencil(wedges)?.0))
}

/// The governing exponent below 1.
///
/// # Errors
/// As [`exponents`].
pub fn singularity(wedges: &[Wedge]) -> Result<Singularity, Error> {
    let (pencil, contacts) = pencil(wedges)?;
    let mut found = Singularity::default();
    for exponent in in_order(&pencil).into_iter().filter(|l| l.re < 1.0 - CLOSE_TO_ONE) {
        let mode = Mode { exponent, pressures: pencil.pressures(exponent, wedges, &contacts) };
        if mode.may_press(contacts.len()) {
            found.exponent = Some(exponent);
            break;
        }
        found.pulling.get_or_insert(exponent);
    }
    Ok(found)
}

fn pencil(wedges: &[Wedge]) -> Result<(Pencil, Vec<[FaceOf; 2]>), Error> {
    wedges.iter().try_for_each(check_angle)?;
    let contacts = contacts(wedges)?;
    Ok((Pencil::new(wedges, &contacts), contacts))
}

fn in_order(pencil: &Pencil) -> Vec<Complex<f64>> {
    let mut found = pencil.eigenvalues();
    found.retain(|l| l.re > SMALLEST && l.re < 2.0 && l.im >= 0.0);
    found.sort_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im)));
    found
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
