//! A second algorithm for isotropic wedges: the closed form of the modes, the determinant of the conditions on the faces,
//! and its zeros by Newton's method and by the argument principle.
//!
//! With Kolosov's functions `φ = a z^λ`, `ψ = b z^λ` the four solutions in a wedge are, up to `1/(2μ)` and the powers of `r`,
//!
//! ```text
//!         U_r                      U_θ                        σ_θθ / λ                  σ_rθ / λ
//! A   cos (1+λ)θ              −sin (1+λ)θ               −cos (1+λ)θ              −sin (1+λ)θ
//! B   sin (1+λ)θ               cos (1+λ)θ               −sin (1+λ)θ               cos (1+λ)θ
//! C   (κ−λ) cos (1−λ)θ        −(κ+λ) sin (1−λ)θ         (1+λ) cos (1−λ)θ         (1−λ) sin (1−λ)θ
//! D   (κ−λ) sin (1−λ)θ         (κ+λ) cos (1−λ)θ         (1+λ) sin (1−λ)θ        −(1−λ) cos (1−λ)θ
//! ```
//!
//! with `κ = (λ_L + 3μ)/(λ_L + μ)`, `λ_L` and `μ` Lamé's constants of plane strain.

use super::super::{Face, Wedge, contacts};
use nalgebra::{Complex, DMatrix};

type C = Complex<f64>;

/// `U_r, U_θ, σ_θθ/λ, σ_rθ/λ` of the four solutions at the angle `θ` of a wedge.
fn fields(wedge: &Wedge, lambda: C, theta: f64) -> [[C; 4]; 4] {
    let lame = wedge.material.lame_constants().expect("isotropic");
    let kappa = C::from((lame.lambda + 3.0 * lame.mu) / (lame.lambda + lame.mu));
    let soft = C::from(0.5 / lame.mu);
    let one = C::from(1.0);
    let (cp, sp) = (((one + lambda) * theta).cos(), ((one + lambda) * theta).sin());
    let (cm, sm) = (((one - lambda) * theta).cos(), ((one - lambda) * theta).sin());
    let (minus, plus) = (kappa - lambda, kappa + lambda);
    [
        [soft * cp, -soft * sp, -cp, -sp],
        [soft * sp, soft * cp, -sp, cp],
        [soft * minus * cm, -soft * plus * sm, (one + lambda) * cm, (one - lambda) * sm],
        [soft * minus * sm, soft * plus * cm, (one + lambda) * sm, -(one - lambda) * cm],
    ]
}

/// The determinant of the conditions on all faces; its zeros besides `λ = 0` are the exponents.
pub(super) fn determinant(wedges: &[Wedge], lambda: C) -> C {
    let mut rows: Vec<Vec<C>> = Vec::new();
    let mut put = |entries: &[(usize, [C; 4])]| {
        let mut row = vec![C::from(0.0); 4 * wedges.len()];
        entries.iter().for_each(|(w, four)| (0..4).for_each(|k| row[4 * w + k] += four[k]));
        rows.push(row);
    };
    let at = |w: usize, e: usize, field: usize| {
        let theta = [wedges[w].from, wedges[w].to][e];
        let all = fields(&wedges[w], lambda, theta);
        [0, 1, 2, 3].map(|k| all[k][field])
    };
    for (w, wedge) in wedges.iter().enumerate() {
        for e in 0..2 {
            let fixed: &[usize] = match wedge.faces[e] {
                Face::Clamped => &[0, 1],
                Face::Sliding => &[1, 3],
                Face::Free => &[2, 3],
                Face::Contact => &[3],
            };
            fixed.iter().for_each(|&field| put(&[(w, at(w, e, field))]));
        }
    }
    for [a, b] in contacts(wedges).unwrap() {
        for field in [1, 2] {
            put(&[(a.0, at(a.0, a.1, field)), (b.0, at(b.0, b.1, field).map(|x| -x))]);
        }
    }
    let n = rows.len();
    DMatrix::from_fn(n, n, |i, j| rows[i][j]).determinant()
}

/// Newton's method for a zero of the determinant, its derivative by differences.
pub(super) fn polish(wedges: &[Wedge], start: C) -> C {
    let mut lambda = start;
    for _ in 0..20 {
        let step = C::new(1e-6, 0.0);
        let slope = (determinant(wedges, lambda + step) - determinant(wedges, lambda - step)) / (step + step);
        let change = determinant(wedges, lambda) / slope;
        lambda -= change;
        if change.norm() < 1e-14 {
            break;
        }
    }
    lambda
}

/// How many zeros the determinant has in a rectangle, by the change of its argument along the border.
pub(super) fn zeros(wedges: &[Wedge], from: C, to: C) -> i32 {
    let corners = [from, C::new(to.re, from.im), to, C::new(from.re, to.im), from];
    let parts = 400;
    let mut turned = 0.0;
    let mut last = determinant(wedges, from);
    for side in corners.windows(2) {
        for k in 1..=parts {
            let next = determinant(wedges, side[0] + (side[1] - side[0]) * (f64::from(k) / f64::from(parts)));
            turned += (next / last).arg();
            last = next;
        }
    }
    (turned / std::f64::consts::TAU).round() as i32
}
