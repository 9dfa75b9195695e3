//! Coarse meshes on either side of an ellipse, near equilateral triangles as far as the curve allows.
//!
//! ```text
//!        inside: a strip of triangles                 around: one more layer outside, cut off straight
//!
//!        P2 ──── P1            sides between             Q ──── R ──── Q        Q above the middles of the arcs,
//!       ╱  ╲    ╱  ╲           neighbours on               ╲  ╱  ╲  ╱           R above the nodes P, one side length
//!     P3 ── C2 ── C1 ── P0     the curve are arcs      P ─── P ──── P ── P      away; the arcs bite into it
//! ```
//!
//! All arcs have the same length. The number of centres `C` follows from the ratio of the axes: one in a disc, whose
//! coarse mesh is the regular hexagon.

use super::ellipse::Ellipse;
use super::mesh::{BoundarySide, DomainMesh};
use signorini_contact::Point;
use std::f64::consts::{PI, TAU};

/// On which side of the curve the meshed domain lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Convex: the arcs bulge out of their triangles.
    Inside,
    /// The arcs bite into their triangles.
    Outside,
}

/// What is meshed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The curve.
    pub ellipse: Ellipse,
    /// Where the domain lies.
    pub side: Side,
}

impl Domain {
    /// The mesh whose coarse sides are divided into `2^refinements`, by red refinement with new nodes on the true curve.
    pub fn mesh(&self, refinements: u32) -> DomainMesh {
        (0..refinements)
            .fold(self.coarse(), |mesh, _| mesh.refined(|arc| self.ellipse.at(self.ellipse.divide(arc, 0.5))))
    }

    /// Arcs of the coarse mesh. The outer layer fans out at the tips, the less the shorter the arcs: there are twice as many.
    pub fn coarse_arcs(&self) -> usize {
        let inside = 2 * (self.centres() + 2);
        if self.side == Side::Inside { inside } else { 2 * inside }
    }

    /// The angles of the ends of the first coarse arc.
    pub fn first_arc(&self) -> [f64; 2] {
        let angles = self.angles();
        [angles[0], angles[1]]
    }

    /// The angles of the coarse nodes, the last one a full turn after the first.
    fn angles(&self) -> Vec<f64> {
        let half = self.coarse_arcs() / 2;
        let share = |j: usize| j as f64 / half as f64;
        let upper = (0..half).map(|j| self.ellipse.divide([0.0, PI], share(j)));
        let lower = (0..half).map(|j| PI + self.ellipse.divide([0.0, PI], share(j)));
        upper.chain(lower).chain([TAU]).collect()
    }

    /// Centres on the long axis: they part it into pieces about as long as the short semi-axis.
    fn centres(&self) -> usize {
        let [a, b] = self.ellipse.semi_axes;
        ((2.0 * a / b).round() as usize).max(2) - 1
    }

    fn coarse(&self) -> DomainMesh {
        let angles = self.angles();
        let mut points: Vec<Point> = angles[..self.coarse_arcs()].iter().map(|&t| self.ellipse.at(t)).collect();
        let triangles = match self.side {
            Side::Inside => self.strip(&mut points),
            Side::Outside => self.ring(&mut points, &angles),
        };
        let arcs = self.coarse_arcs() as u32;
        let side = |j: u32| {
            let nodes = [j, (j + 1) % arcs];
            let owner = triangles.iter().position(|t: &[u32; 3]| nodes.iter().all(|n| t.contains(n)));
            let angles = [angles[j as usize], angles[j as usize + 1]];
            BoundarySide { nodes, angles, triangle: owner.expect("every arc has a triangle") as u32 }
        };
        let boundary = (0..arcs).map(side).collect();
        DomainMesh { points, triangles, boundary, ellipse: self.ellipse }
    }

    /// The strips between the axis `P_0, C_1, …, C_m, P_half` and the upper and the lower half of the curve.
    fn strip(&self, points: &mut Vec<Point>) -> Vec<[u32; 3]> {
        let (m, arcs) = (self.centres(), self.coarse_arcs());
        let a = self.ellipse.semi_axes[0];
        points.extend((1..=m).map(|i| Point::new(a - 2.0 * a * i as f64 / (m + 1) as f64, 0.0)));
        let upper = |j: usize| j as u32;
        let lower = |j: usize| ((arcs - j) % arcs) as u32;
        let axis = |i: usize| match i {
            0 => 0,
            i if i == m + 1 => (arcs / 2) as u32,
            i => (arcs + i - 1) as u32,
        };
        let mut triangles = Vec::new();
        for i in 0..=m {
            triangles.push([axis(i), upper(i + 1), axis(i + 1)]);
            triangles.push([axis(i), axis(i + 1), lower(i + 1)]);
            if i < m {
                triangles.push([axis(i + 1), upper(i + 1), upper(i + 2)]);
                triangles.push([axis(i + 1), lower(i + 2), lower(i + 1)]);
            }
        }
        triangles
    }

    /// One layer of triangles around the curve: `P_j P_{j+1} Q_j`, `P_j Q_j R_j`, `P_{j+1} R_{j+1} Q_j`.
    fn ring(&self, points: &mut Vec<Point>, angles: &[f64]) -> Vec<[u32; 3]> {
        let n = self.coarse_arcs();
        let chord = (points[1] - points[0]).norm();
        let outward = |t: f64, distance: f64| {
            let v = self.ellipse.velocity(t).normalize();
            self.ellipse.at(t) + distance * Point::new(v.y, -v.x)
        };
        for j in 0..n {
            let middle = self.ellipse.divide([angles[j], angles[j + 1]], 0.5);
            points.push(outward(middle, 0.75_f64.sqrt() * chord));
        }
        for &t in &angles[..n] {
            points.push(outward(t, chord));
        }
        let triangles = |j: usize| {
            let next = (j + 1) % n;
            let [p, p1, q, r, r1] = [j, next, n + j, 2 * n + j, 2 * n + next].map(|i| i as u32);
            [[p1, p, q], [p, r, q], [p1, q, r1]]
        };
        (0..n).flat_map(triangles).collect()
    }
}
