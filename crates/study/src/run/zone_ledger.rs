//! The terms of the ledger that live on a curved contact zone: what `K_h ⊄ K` costs, and what the proofs bound it by.
//!
//! With `U_h = n·(u'_h − u''_h)` on the zone,
//!
//! * on a common arc (Theorem 3.3), `c = ∫ T_n (Φ − U_h) ds`. On each side let `Q(x)` be the foot of `x` on the chord. Then
//!   `Ũ_h(x) = n(x)·(u'_h − u''_h)(Q(x))`, with `u_h` of the bitten body continued linearly, and `Φ(x)` is the value at `Q(x)`
//!   of the linear function on the chord that agrees with `U_h` at the nodes (3.34)–(3.39);
//! * across a gap (Theorem 3.4), `c = −∫ T_ξ (U_h − ε)_+ dη ≥ 0`, and `b` splits into the sides in full contact,
//!   `∫ T_ξ (ε_I − ε) dη` (3.41), and those that hold a switch point (3.43).

use crate::study::ExactScene;
use signorini_contact::Vec2;
use signorini_contact::element::hats;
use signorini_contact::geometry::{Piece, Segment};
use signorini_contact::mesh::Mesh;
use signorini_contact::mesh::side::ContactView;
use signorini_contact::quadrature::Cubature;
use std::collections::BTreeMap;

/// `c` and the parts, each with its change under one refinement of the quadrature in `delta`.
#[derive(Default)]
pub struct ZoneLedger {
    /// The third term.
    pub c: f64,
    /// Change of `c` under one refinement.
    pub delta: f64,
    /// See [`Ledger::PARTS`](crate::record::Ledger::PARTS).
    pub parts: BTreeMap<String, f64>,
}

/// What is integrated over the zone.
#[derive(Clone, Copy, Default)]
struct Sums {
    c: f64,
    /// Squares of norms.
    trace_interpolation: f64,
    jump_minus_chord: f64,
    nodal_minus_chord: f64,
    nodal_minus_jump: f64,
    gap_interpolation: f64,
    b_gap: f64,
    b_switch: f64,
}

impl ZoneLedger {
    /// Empty on polygons.
    pub fn new(exact: &ExactScene, mesh: &Mesh, interpolant: &[Vec2], u_h: &[Vec2], cubature: &Cubature) -> Self {
        let curved = |view: &ContactView| matches!(view.sides[0].piece, Piece::Curved { .. });
        let views: Vec<ContactView> = (0..mesh.contact.len()).map(|side| mesh.contact_view(side)).collect();
        if mesh.direction.is_none() && !views.iter().any(curved) {
            return Self::default();
        }
        let zone = Zone { exact, mesh, interpolant, u_h };
        let [coarse, fine] = [cubature.clone(), cubature.finer()].map(|c| zone.sums(&views, &c));
        let norms: &[(&str, f64)] = if mesh.direction.is_some() {
            &[("b_gap", fine.b_gap), ("b_switch", fine.b_switch), ("gap_interpolation", fine.gap_interpolation.sqrt())]
        } else {
            &[
                ("trace_interpolation", fine.trace_interpolation.sqrt()),
                ("jump_minus_chord", fine.jump_minus_chord.sqrt()),
                ("nodal_minus_chord", fine.nodal_minus_chord.sqrt()),
                ("nodal_minus_jump", fine.nodal_minus_jump.sqrt()),
            ]
        };
        let parts = norms.iter().map(|(name, value)| (name.to_string(), *value)).collect();
        Self { c: fine.c, delta: (fine.c - coarse.c).abs(), parts }
    }
}

/// What the terms are made of.
struct Zone<'a> {
    exact: &'a ExactScene,
    mesh: &'a Mesh,
    interpolant: &'a [Vec2],
    u_h: &'a [Vec2],
}

impl Zone<'_> {
    fn sums(&self, views: &[ContactView], cubature: &Cubature) -> Sums {
        let mut sums = Sums::default();
        for (side, view) in views.iter().enumerate() {
            match (self.mesh.direction, &view.sides[0].piece) {
                (Some(_), _) => self.add_gap_side(view, cubature, &mut sums),
                (None, Piece::Curved { .. }) => self.add_arc_side(side, view, cubature, &mut sums),
                // straight pieces of a common zone keep their constraints between the nodes
                (None, Piece::Straight(_)) => {}
            }
        }
        sums
    }

    fn add_arc_side(&self, side: usize, view: &ContactView, cubature: &Cubature, sums: &mut Sums) {
        let chord = Segment { a: view.at(0.0).at[0], b: view.at(1.0).at[0] };
        let ends = [0.0, 1.0].map(|t| view.jump(t, &view.at(t), self.u_h));
        view.points(cubature, &mut |t, point, weight| {
            let s = chord.parameter(point.at[0]);
            let foot = chord.a + s * (chord.b - chord.a);
            let jump = view.jump(t, point, self.u_h);
            let on_chord = point.normal.dot(&self.difference_at(side, foot));
            let nodal = (1.0 - s) * ends[0] + s * ends[1];
            let interpolation = view.jump(t, point, self.interpolant) - self.exact.opening(point);
            sums.c += weight * self.exact.contact_stress(point) * (nodal - jump);
            sums.trace_interpolation += weight * interpolation * interpolation;
            sums.jump_minus_chord += weight * (jump - on_chord).powi(2);
            sums.nodal_minus_chord += weight * (nodal - on_chord).powi(2);
            sums.nodal_minus_jump += weight * (nodal - jump).powi(2);
        });
    }

    /// `(u'_h − u''_h)(x)`, each body's linear function on the triangle of this side continued to `x`.
    fn difference_at(&self, side: usize, x: Vec2) -> Vec2 {
        let value = |t: u32| -> Vec2 {
            let (corners, nodes) = (self.mesh.corners(t as usize), self.mesh.triangles[t as usize]);
            hats(corners, x).iter().zip(nodes).map(|(h, i)| *h * self.u_h[i as usize]).sum()
        };
        let [first, second] = self.mesh.contact[side].triangles;
        value(first) - value(second)
    }

    fn add_gap_side(&self, view: &ContactView, cubature: &Cubature, sums: &mut Sums) {
        let gaps = [0.0, 1.0].map(|t| view.at(t).gap);
        let mut b = 0.0;
        view.points(cubature, &mut |t, point, weight| {
            let stress = self.exact.contact_stress(point);
            let gap_interpolation = (1.0 - t) * gaps[0] + t * gaps[1] - point.gap;
            sums.c -= weight * stress * (view.jump(t, point, self.u_h) - point.gap).max(0.0);
            sums.gap_interpolation += weight * gap_interpolation * gap_interpolation;
            b += weight * stress * (view.jump(t, point, self.interpolant) - point.gap);
        });
        // open sides have no stress and add nothing to either
        *if self.holds_switch(view) { &mut sums.b_switch } else { &mut sums.b_gap } += b;
    }

    /// Whether a switch point of the exact solution lies within a side.
    fn holds_switch(&self, view: &ContactView) -> bool {
        let (piece, size) = (&view.sides[0].piece, view.measure());
        let within = |x: &Vec2| piece.distance(*x) < 1e-9 * size && (1e-9..=1.0 - 1e-9).contains(&piece.foot(*x));
        self.exact.solution.switch_points().iter().any(within)
    }
}

#[cfg(test)]
mod tests;
