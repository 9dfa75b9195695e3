//! Curves, and how they are discretised.

use super::RawPoint;
use crate::file::number::Finite;
use crate::file::spanned::Spanned;
use schemars::JsonSchema;
use serde::Deserialize;

/// A curve by one of: `circle`, `graph`, `through`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawCurve {
    /// For blocks, boundary parts and the contact zone.
    pub name: Spanned<String>,
    /// An arc.
    pub circle: Option<Spanned<RawCircle>>,
    /// The graph of an expression.
    pub graph: Option<Spanned<RawGraph>>,
    /// Points: the natural cubic spline through them.
    pub through: Option<Spanned<Vec<RawPoint>>>,
}

/// An arc of a circle.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawCircle {
    /// Its centre.
    pub centre: RawPoint,
    /// Its radius, positive.
    pub radius: Finite,
    /// Angle of its first point in degrees.
    pub from: Finite,
    /// Angle of its last point; counterclockwise if larger than `from`.
    pub to: Finite,
}

/// A graph ξ = f(η).
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawGraph {
    /// An expression in `eta` and the parameters.
    pub xi: Spanned<String>,
    /// η of its first point.
    pub from: Finite,
    /// η of its last point.
    pub to: Finite,
    /// e_ξ; default [1, 0].
    pub direction: Option<RawPoint>,
}

/// How curved sides are discretised.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawDiscretisation {
    /// The elements on curved sides.
    pub element: Option<ElementName>,
    /// The geometry that is integrated over.
    pub geometry: Option<GeometryName>,
    /// The normals of the constraints.
    pub normals: Option<NormalsName>,
    /// Of isoparametric elements: the arc's parameter departs from a multiple of the reference coordinate t by skew·t(1 − t); default 0.
    pub skew: Option<Spanned<Finite>>,
}

/// Elements on curved sides.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ElementName {
    /// Linear in x, y on the exact curved triangle: common zones.
    Physical,
    /// Zlámal's map: gaps.
    Isoparametric,
}

/// Geometry of curved sides.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum GeometryName {
    /// The curve.
    Exact,
    /// Straight sides between the nodes on the curve.
    Chords,
}

/// Normals of the constraints on curves.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum NormalsName {
    /// Of the curve.
    True,
    /// The mean of both chords at the node.
    Averaged,
    /// Of one chord.
    Chord,
}
