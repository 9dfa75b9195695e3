//! The fields of a solved level: mesh, displacement, strain, stress, and what happens on the contact zone.
//!
//! [`Fields`] is data. Pictures are drawn from it, [`vtu`] and [`npy`] turn it into files for ParaView and NumPy, and [`store`] keeps it
//! beside the record, so that pictures can be drawn again without solving.

mod arrays;
mod check;
mod collect;
mod keep;
pub mod npy;
mod packed;
pub mod store;
#[cfg(test)]
mod tests;
pub mod vtu;

pub use collect::collect;
pub use keep::{Keep, page_level};

use serde::{Deserialize, Serialize};
use signorini_contact::Body;

/// The fields of one level. Values have the units of the study: lengths those of its coordinates, stresses those of its moduli.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fields {
    /// Number of the level, from 0, the coarsest.
    pub level: usize,
    /// Whether the level was asked for by name, and not kept for the page alone: then it has pictures and arrays of its own.
    pub asked: bool,
    /// Names of `Ω'` and `Ω''` in the study.
    pub bodies: [String; 2],
    /// Node positions. Nodes on the contact zone are doubled, one for each body.
    #[serde(with = "packed")]
    pub nodes: Vec<[f64; 2]>,
    /// Corners of each triangle, counterclockwise; the triangles of `Ω'` come first.
    #[serde(with = "packed")]
    pub triangles: Vec<[u32; 3]>,
    /// How many triangles belong to `Ω'`.
    pub first_triangles: usize,
    /// Areas of the triangles, of curved ones the exact areas.
    #[serde(with = "packed")]
    pub areas: Vec<f64>,
    /// Curved sides, by ascending triangle.
    pub arcs: Vec<Arc>,
    /// `u_h` at the nodes.
    #[serde(with = "packed")]
    pub displacement: Vec<[f64; 2]>,
    /// `ε_11, ε_22, ε_12` of each triangle; at the centroid where strains vary, on isoparametric triangles.
    #[serde(with = "packed")]
    pub strain: Vec<[f64; 3]>,
    /// `τ_11, τ_22, τ_12` of each triangle, at the same point.
    #[serde(with = "packed")]
    pub stress: Vec<[f64; 3]>,
    /// The stress of von Mises of each triangle, with the stress across the plane where that is strained plane.
    #[serde(with = "packed")]
    pub von_mises: Vec<f64>,
    /// Boundary parts outside the contact zone.
    pub parts: Vec<FieldPart>,
    /// The two nodes of each boundary side outside the contact zone, the body on the left.
    #[serde(with = "packed")]
    pub sides: Vec<[u32; 2]>,
    /// The triangle that owns each of these sides.
    #[serde(with = "packed")]
    pub side_triangles: Vec<u32>,
    /// The part of each of these sides, an index into `parts`.
    #[serde(with = "packed")]
    pub side_parts: Vec<u32>,
    /// The contact zone.
    pub zone: ZoneFields,
}

impl Fields {
    /// The body of triangle `t`.
    pub fn body(&self, t: usize) -> Body {
        if t < self.first_triangles { Body::First } else { Body::Second }
    }

    /// The triangles of `Ω'` (0) or `Ω''` (1).
    pub fn triangles_of(&self, body: usize) -> std::ops::Range<usize> {
        if body == 0 { 0..self.first_triangles } else { self.first_triangles..self.triangles.len() }
    }

    /// The curved side of triangle `t`, if it has one.
    pub fn arc(&self, t: usize) -> Option<&Arc> {
        let found = self.arcs.binary_search_by_key(&(t as u32), |a| a.triangle);
        found.ok().map(|k| &self.arcs[k])
    }

    /// The outline of triangle `t` moved by `factor · u_h`, counterclockwise: three corners, and points between along a curved side.
    pub fn outline(&self, t: usize, factor: f64) -> Vec<[f64; 2]> {
        let mut outline = Vec::with_capacity(3);
        for k in 0..3 {
            let node = self.triangles[t][k] as usize;
            outline.push(moved(self.nodes[node], self.displacement[node], factor));
            if let Some(arc) = self.arc(t).filter(|a| (usize::from(a.apex) + 1) % 3 == k) {
                outline.extend(arc.moved(factor));
            }
        }
        outline
    }

    /// The side of triangle `t` from node `a` to node `b`, moved by `factor · u_h`: two points, more on a curved side.
    pub fn side(&self, t: usize, [a, b]: [u32; 2], factor: f64) -> Vec<[f64; 2]> {
        let at = |i: u32| moved(self.nodes[i as usize], self.displacement[i as usize], factor);
        let corners = self.triangles[t];
        let arc = self.arc(t).filter(|arc| ![a, b].contains(&corners[usize::from(arc.apex)]));
        let mut between: Vec<[f64; 2]> = arc.map_or_else(Vec::new, |arc| arc.moved(factor).collect());
        if arc.is_some_and(|arc| corners[(usize::from(arc.apex) + 1) % 3] != a) {
            between.reverse();
        }
        [at(a)].into_iter().chain(between).chain([at(b)]).collect()
    }
}

/// `x + factor · u`.
fn moved(x: [f64; 2], u: [f64; 2], factor: f64) -> [f64; 2] {
    [x[0] + factor * u[0], x[1] + factor * u[1]]
}

/// A curved side of a triangle, by points between its ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc {
    /// The triangle.
    pub triangle: u32,
    /// Its corner opposite the side, which runs from the corner after it to the one after that.
    pub apex: u8,
    /// Points on the curve in that direction, the ends left out.
    #[serde(with = "packed")]
    pub points: Vec<[f64; 2]>,
    /// `u_h` there.
    #[serde(with = "packed")]
    pub displacement: Vec<[f64; 2]>,
}

impl Arc {
    fn moved(&self, factor: f64) -> impl Iterator<Item = [f64; 2]> {
        self.points.iter().zip(&self.displacement).map(move |(x, u)| moved(*x, *u, factor))
    }
}

/// A boundary part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FieldPart {
    /// 0 for `Ω'`, 1 for `Ω''`.
    pub body: u8,
    /// Its name in the study.
    pub name: String,
    /// What holds on it.
    pub condition: Condition,
}

/// The condition on a boundary part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Condition {
    /// `Γ_u`: the displacement is prescribed.
    Fixed,
    /// `Γ_0`: no normal displacement, no tangential traction.
    Sliding,
    /// `Γτ`: the traction is prescribed.
    Traction,
    /// `Γτ` without traction.
    Free,
}

/// The contact zone node by node, in the order of the zone. The lists of points have the same length; a corner with two normals stands twice.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ZoneFields {
    /// Whether the zone is measured by its width in `η`, across a gap, and not by its length.
    pub across_gap: bool,
    /// Distance from the start of the zone in that measure, `s`.
    #[serde(with = "packed")]
    pub s: Vec<f64>,
    /// The nodes of `Ω'` and `Ω''`.
    #[serde(with = "packed")]
    pub nodes: Vec<[u32; 2]>,
    /// The normal `n` of the constraint, outward from `Ω'`, or `−e_ξ`.
    #[serde(with = "packed")]
    pub normal: Vec<[f64; 2]>,
    /// The contact pressure `λ_i/m_i`; negative only where the bodies are tied.
    #[serde(with = "packed")]
    pub pressure: Vec<f64>,
    /// The gap that is left, `ε − n·(u'_h − u''_h)`, not negative but for rounding.
    #[serde(with = "packed")]
    pub gap: Vec<f64>,
    /// Number of the state, see [`ContactStatus`].
    #[serde(with = "packed")]
    pub status: Vec<u8>,
    /// The sides of the zone, by the numbers of their two points in the lists above.
    #[serde(with = "packed")]
    pub sides: Vec<[u32; 2]>,
    /// The triangles in `Ω'` and `Ω''` that own each side.
    #[serde(with = "packed")]
    pub side_triangles: Vec<[u32; 2]>,
}

/// What a node of the contact zone does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum ContactStatus {
    /// No force.
    Open = 0,
    /// The bodies press on one another.
    Contact = 1,
    /// The bodies may not part.
    Bilateral = 2,
    /// The supports decide the distance: there is no constraint, and no pressure is known.
    Held = 3,
}
