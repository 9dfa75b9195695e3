//! A lemma in place of a scene.

use crate::file::fixed::Fixed;
use crate::file::number::Finite;
use crate::file::spanned::Spanned;
use schemars::JsonSchema;
use serde::Deserialize;

/// A lemma on meshes or intervals, where nothing is solved.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawLemma {
    /// Which lemma.
    pub kind: LemmaName,
    /// Of `boundary-interpolation` and `strip`: [a, b] of the ellipse, the longer first, at most 3 to 1.
    pub semi_axes: Option<Spanned<Fixed<Finite, 2>>>,
    /// Of `boundary-interpolation`: the function to interpolate, in x, y and r, the distance from a point of the boundary.
    pub function: Option<Spanned<String>>,
    /// Of `strip`: on which side of the chords the arcs lie.
    pub side: Option<Spanned<SideName>>,
    /// Of `inverse-inequality`: [a, b].
    pub interval: Option<Spanned<Fixed<Finite, 2>>>,
    /// Of `inverse-inequality`: the norms on both sides.
    pub norms: Option<Spanned<NormsName>>,
    /// Of `inverse-inequality`: of the division and of the random functions.
    pub seed: Option<Spanned<u64>>,
}

/// A lemma.
#[derive(Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LemmaName {
    /// Lemma 3.2.
    BoundaryInterpolation,
    /// Lemma 3.3.
    InverseInequality,
    /// Lemma 3.4.
    Strip,
}

/// Where arcs lie.
#[derive(Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SideName {
    /// They bulge out of their triangles.
    Inside,
    /// They bite into their triangles.
    Outside,
}

/// Norms of the inverse inequality.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum NormsName {
    /// Seminorms on both sides.
    Seminorms,
    /// The full norm on the right.
    FullRight,
    /// Full norms on both sides.
    Full,
}
