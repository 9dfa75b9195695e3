//! Which of many exact solutions the discrete ones are compared with, where a body may slide.

use crate::error::RunError;
use crate::study::Scene;
use signorini_contact::Vec2;
use signorini_contact::problem::SlideCondition;
use signorini_contact::quadrature::GAUSS_8;

/// Panels of the composite rule along `Γ`.
const PANELS: u32 = 64;
/// `|p(u)|` below this times `∫_Γ |u|` is rounding.
const ROUNDING: f64 = 1e-9;

/// A norm that sees a slide compares `u_h` with the one exact solution that has `p(u) = 0`. The interpolant need not:
/// `p(u_I) = O(h²)`. Ceiling and ledger hold energies and normal jumps, which no slide changes, so there it makes no difference.
///
/// # Errors
/// [`RunError::Exact`] if the exact solution has another slide and `norm` sees it.
pub fn verify(scene: &Scene, norm: &str) -> Result<(), RunError> {
    let (Some(condition), Some(exact)) = (&scene.slide, &scene.exact) else { return Ok(()) };
    if !["h1", "l2"].contains(&norm) {
        return Ok(());
    }
    let [p, size] = integrals(condition, |x| exact.solution.value(condition.body, x));
    if p.abs() <= ROUNDING * size {
        return Ok(());
    }
    Err(RunError::Exact(format!(
        "p(u) = ∫ u_t ds = {p:.6e} on the part that [slide] names, and must vanish within {:.1e}: the claim judges `{norm}`, \
         which sees a slide; take the solution with p(u) = 0, or judge `strain` or `energy`",
        ROUNDING * size
    )))
}

/// `∫_Γ u_t ds` and `∫_Γ |u| ds`.
fn integrals(condition: &SlideCondition, u: impl Fn(Vec2) -> Vec2) -> [f64; 2] {
    let (a, along) = (condition.along.a, condition.along.b - condition.along.a);
    let mut sums = [0.0; 2];
    for panel in 0..PANELS {
        for (t, w) in GAUSS_8 {
            let value = u(a + (f64::from(panel) + t) / f64::from(PANELS) * along);
            let ds = w * along.norm() / f64::from(PANELS);
            sums[0] += ds * value.dot(&along.normalize());
            sums[1] += ds * value.norm();
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use signorini_contact::geometry::Segment;
    use signorini_contact::{Body, Point};

    #[test]
    fn the_tangential_part_is_integrated_along_the_part() {
        let along = Segment { a: Point::new(1.0, 1.0), b: Point::new(4.0, 5.0) };
        let condition = SlideCondition { body: Body::Second, along };
        // u = (x, 0): ∫ u·t ds = (3/5) ∫ x ds = (3/5)·5·2.5; along (0, 1): (4/5)·5
        let [p, size] = integrals(&condition, |x| Vec2::new(x.x, 0.0));
        assert!((p - 7.5).abs() < 1e-13 && (size - 12.5).abs() < 1e-13);
        assert!((integrals(&condition, |_| Vec2::y())[0] - 4.0).abs() < 1e-13);
    }
}
