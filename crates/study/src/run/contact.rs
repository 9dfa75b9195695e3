//! What happens on the contact zone: pressure, penetration, contact set and switch points of a discrete solution.

use crate::study::ExactScene;
use signorini_contact::geometry::{Piece, Point, Vec2};
use signorini_contact::mesh::Mesh;
use signorini_contact::mesh::side::ContactView;
use signorini_contact::problem::{Discrete, Solution};
use signorini_contact::quadrature::Cubature;
use signorini_contact::zone::{ConstraintKind, side_length};

/// A constraint is active when its force exceeds this share of the largest.
const ACTIVE: f64 = 1e-8;

/// The discrete contact zone, side by side.
pub struct ContactState {
    /// Pressure `λ_i/m_i` at the two ends of every side, one value per segment at a corner.
    pub pressure: Vec<[f64; 2]>,
    /// Whether the two ends are active.
    pub active: Vec<[bool; 2]>,
    /// `‖([u_h]_n − ε)_+‖` squared, side by side.
    penetration: Vec<f64>,
    /// Number of active constraints.
    pub active_constraints: usize,
}

impl ContactState {
    /// Reads the contact forces and jumps off a solution.
    pub fn new(mesh: &Mesh, discrete: &Discrete, solution: &Solution) -> Self {
        let largest = solution.raw.multipliers.iter().fold(0.0, |m: f64, l| m.max(l.abs()));
        let is_active = |force: f64| force > ACTIVE * largest;
        let zone = &discrete.zone;
        // where the bodies may not part there is contact, whatever the sign of the force
        let is_tied = |(pair, k): (usize, usize)| zone.pairs[pair].constraints[k].kind == ConstraintKind::Bilateral;
        let force = |(pair, k): (usize, usize)| solution.contact_forces[pair][k];
        let pressure = |(pair, k): (usize, usize)| force((pair, k)) / zone.pairs[pair].constraints[k].mass;
        Self {
            pressure: zone.side_ends.iter().map(|ends| ends.map(pressure)).collect(),
            active: zone.side_ends.iter().map(|ends| ends.map(|e| is_tied(e) || is_active(force(e)))).collect(),
            penetration: (0..mesh.contact.len()).map(|side| penetration(mesh, side, &solution.displacement)).collect(),
            active_constraints: solution.raw.multipliers.iter().filter(|l| is_active(**l)).count(),
        }
    }

    /// Sides with one active and one open end.
    pub fn switch_sides(&self) -> usize {
        self.active.iter().filter(|[a, b]| a != b).count()
    }

    /// Where contact switches on or off: a node owns its half sides, so the middles of the sides with one active end.
    pub fn switch_points(&self, mesh: &Mesh) -> Vec<Point> {
        let middle = |side: usize| mesh.contact_view(side).at(0.5).at[0];
        (0..self.active.len()).filter(|&side| self.active[side][0] != self.active[side][1]).map(middle).collect()
    }

    /// `‖([u_h]_n − ε)_+‖_{0,Γ_K}`.
    pub fn penetration(&self) -> f64 {
        self.penetration.iter().sum::<f64>().sqrt()
    }
}

/// `∫ ([u_h]_n − ε)_+² dμ` over a side: in closed form where the jump is linear and there is no gap, by quadrature elsewhere.
fn penetration(mesh: &Mesh, side: usize, u: &[Vec2]) -> f64 {
    let view = mesh.contact_view(side);
    let touching = mesh.direction.is_none() && mesh.initial_gap.is_none();
    if touching && matches!(view.sides[0].piece, Piece::Straight(_)) {
        return view.measure() * positive_square([0.0, 1.0].map(|t| view.jump(t, &view.at(t), u)));
    }
    let mut square = 0.0;
    view.points(&Cubature { depth: 3, ..Default::default() }, &mut |t, point, weight| {
        square += weight * (view.jump(t, point, u) - point.gap).max(0.0).powi(2);
    });
    square
}

/// `∫_0^1 (linear from a to b)_+² ds`.
fn positive_square([a, b]: [f64; 2]) -> f64 {
    let cube = |x: f64| x.max(0.0).powi(3);
    if a > 0.0 && b > 0.0 {
        (a * a + a * b + b * b) / 3.0
    } else if a != b {
        // One end is positive: (a³ − b³)/(3(a − b)) over the positive part.
        (cube(a) - cube(b)) / (3.0 * (a - b))
    } else {
        0.0
    }
}

/// Errors on the contact zone against the exact solution.
pub struct ContactErrors {
    /// `‖p − p_h‖_{0,Γ_K}`.
    pub pressure: f64,
    /// `(Σ h_s ‖p − p_h‖²_{0,s})^{1/2}`.
    pub pressure_dual: f64,
    /// Length of the symmetric difference of the contact sets; a node owns its half sides.
    pub contact_set: f64,
    /// Sides that hold a switch point of the exact solution inside.
    pub switch_sides: usize,
    /// Largest distance of a switch point of the reference from the nearest discrete one.
    pub switch_position: Option<f64>,
}

/// Measures the discrete zone against the exact solution.
pub fn against_exact(exact: &ExactScene, mesh: &Mesh, state: &ContactState, cubature: &Cubature) -> ContactErrors {
    let switches = exact.solution.switch_points();
    let mut errors = ContactErrors {
        pressure: 0.0,
        pressure_dual: 0.0,
        contact_set: 0.0,
        switch_sides: 0,
        switch_position: farthest(&switches, &state.switch_points(mesh)),
    };
    for side in 0..mesh.contact.len() {
        let view = mesh.contact_view(side);
        let (length, piece) = (view.measure(), &view.sides[0].piece);
        let square = pressure_error(exact, &view, state.pressure[side], cubature);
        errors.pressure += square;
        errors.pressure_dual += length * square;
        let inside: Vec<f64> = switches
            .iter()
            .filter(|p| piece.distance(**p) < 1e-9 * length)
            .map(|p| piece.foot(*p))
            .filter(|s| (1e-9..=1.0 - 1e-9).contains(s))
            .collect();
        errors.switch_sides += usize::from(!inside.is_empty());
        let closed = |t: f64| is_closed(exact, &view, t);
        errors.contact_set += length * wrong_share(&inside, state.active[side], closed);
    }
    errors.pressure = errors.pressure.sqrt();
    errors.pressure_dual = errors.pressure_dual.sqrt();
    errors
}

/// Whether the exact solution is in contact at the share `t` of a side, to rounding.
fn is_closed(exact: &ExactScene, view: &ContactView, t: f64) -> bool {
    let point = view.at(t);
    let size = exact.solution.value(signorini_contact::Body::First, point.at[0]).norm();
    exact.opening(&point) >= -1e-14 * size.max(point.gap).max(1e-3)
}

/// `∫ (p − p_h)² dμ` over a side with the discrete pressure at its two ends.
fn pressure_error(exact: &ExactScene, view: &ContactView, [p0, p1]: [f64; 2], cubature: &Cubature) -> f64 {
    let mut square = 0.0;
    view.points(cubature, &mut |t, point, weight| {
        let difference = -exact.contact_stress(point) - ((1.0 - t) * p0 + t * p1);
        square += weight * difference * difference;
    });
    square
}

/// The largest distance of a point of `from` from the nearest of `to`; nothing where either is empty.
pub(super) fn farthest(from: &[Point], to: &[Point]) -> Option<f64> {
    let nearest = |p: &Point| to.iter().map(|q| (p - q).norm()).fold(f64::INFINITY, f64::min);
    (!to.is_empty()).then(|| from.iter().map(nearest).reduce(f64::max)).flatten()
}

/// The share of a side on which the discrete contact set (by halves) and the exact one differ.
fn wrong_share(switches: &[f64], active: [bool; 2], closed: impl Fn(f64) -> bool) -> f64 {
    let mut cuts = vec![0.0, 0.5, 1.0];
    cuts.extend(switches);
    cuts.sort_by(f64::total_cmp);
    let wrong = |w: &&[f64]| {
        let middle = 0.5 * (w[0] + w[1]);
        closed(middle) != active[usize::from(middle > 0.5)]
    };
    cuts.windows(2).filter(wrong).map(|w| w[1] - w[0]).sum()
}

/// Errors on the contact zone of a coarse solution against a discrete reference on a nested finer mesh.
pub fn against_reference(mesh: &Mesh, state: &ContactState, fine: &Mesh, reference: &ContactState) -> ContactErrors {
    let mut errors = ContactErrors {
        pressure: 0.0,
        pressure_dual: 0.0,
        contact_set: 0.0,
        switch_sides: state.switch_sides(),
        switch_position: farthest(&reference.switch_points(fine), &state.switch_points(mesh)),
    };
    // Refinement splits every contact side into the same number of pieces, in order.
    let pieces = fine.contact.len() / mesh.contact.len();
    for (k, [r0, r1]) in reference.pressure.iter().enumerate() {
        let (side, piece) = (k / pieces, k % pieces);
        let at = |i: usize| i as f64 / pieces as f64;
        let [p0, p1] = state.pressure[side];
        let coarse = |s: f64| (1.0 - s) * p0 + s * p1;
        let (d0, d1) = (r0 - coarse(at(piece)), r1 - coarse(at(piece + 1)));
        let length = side_length(fine, k);
        let square = length * (d0 * d0 + d0 * d1 + d1 * d1) / 3.0;
        errors.pressure += square;
        errors.pressure_dual += side_length(mesh, side) * square;
        let half = |end: usize| {
            let s = at(piece) + (0.25 + 0.5 * end as f64) / pieces as f64;
            state.active[side][usize::from(s > 0.5)] != reference.active[k][end]
        };
        errors.contact_set += 0.5 * length * (0..2).filter(|&end| half(end)).count() as f64;
    }
    errors.pressure = errors.pressure.sqrt();
    errors.pressure_dual = errors.pressure_dual.sqrt();
    errors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_positive_part_of_a_linear_function_integrates_in_closed_form() {
        for ends in [[0.3, 0.7], [-0.2, 0.5], [0.4, -0.1], [-0.3, -0.4], [0.0, 0.0], [0.0, 1.0], [0.5, 0.5]] {
            let n = 20_000;
            let at = |i: i32| (f64::from(i) + 0.5) / f64::from(n);
            let sum: f64 = (0..n).map(|i| (ends[0] + at(i) * (ends[1] - ends[0])).max(0.0).powi(2)).sum();
            assert!((positive_square(ends) - sum / f64::from(n)).abs() < 1e-8, "{ends:?}");
        }
    }

    #[test]
    fn the_contact_sets_differ_by_the_length_between_switch_and_half_side() {
        // Exact contact up to s = 0.3, discrete contact on the first half: 0.2 differ.
        assert!((wrong_share(&[0.3], [true, false], |s| s < 0.3) - 0.2).abs() < 1e-15);
        assert!((wrong_share(&[], [true, true], |_| true)).abs() < 1e-15);
        assert!((wrong_share(&[], [true, true], |_| false) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_farthest_switch_counts_and_none_without_a_partner() {
        let at = |xs: &[f64]| xs.iter().map(|x| Point::new(*x, 0.0)).collect::<Vec<_>>();
        assert_eq!(farthest(&at(&[0.3, 0.9]), &at(&[0.25, 0.5])), Some(0.4));
        assert_eq!(farthest(&at(&[0.3]), &[]), None);
        assert_eq!(farthest(&[], &at(&[0.3])), None);
    }
}
