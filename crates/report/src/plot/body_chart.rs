//! What a picture of the two bodies shows, as data, in the coordinates of the study.

use super::chart::Colour;

/// A point of the plane.
pub type XY = [f64; 2];

/// A filled polygon.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Its corners.
    pub outline: Vec<XY>,
    /// Its colour.
    pub colour: Colour,
    /// 0 (invisible) to 1.
    pub strength: f64,
}

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Its points.
    pub points: Vec<XY>,
    /// Its colour.
    pub colour: Colour,
    /// Its width in pixels.
    pub width: f64,
    /// 0 (invisible) to 1.
    pub strength: f64,
}

/// A name beside the picture, with a line to what it names.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The name.
    pub text: String,
    /// Second line.
    pub detail: String,
    /// The colour of what it names.
    pub colour: Colour,
    /// Where the line may end.
    pub anchors: Vec<XY>,
}

/// The scale of colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// What is shown.
    pub name: String,
    /// The value of the highest colour; the lowest is that of 0.
    pub top: f64,
    /// Whether values above `top` have its colour as well.
    pub cut: bool,
}

/// The picture of two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyChart {
    /// Study, case and what is shown.
    pub title: String,
    /// What came out, one line each.
    pub subtitle: Vec<String>,
    /// Polygons, drawn first and in this order.
    pub areas: Vec<Area>,
    /// Lines, drawn in this order.
    pub strokes: Vec<Stroke>,
    /// Names at the sides.
    pub labels: Vec<Label>,
    /// Names inside the bodies.
    pub names: Vec<(String, XY)>,
    /// The scale of colours, if areas have shades.
    pub bar: Option<Bar>,
    /// How many times `x` and `y` are magnified against one another: `[1, 1]` unless the bodies are thin.
    pub stretch: [f64; 2],
    /// What the reader should know beside.
    pub remarks: Vec<String>,
}

/// Bodies this many times as long as high can be seen as they are.
const THIN: f64 = 10.0;
/// What magnification of a thin body's height leaves.
const SHOWN: f64 = 2.5;

impl BodyChart {
    /// The magnification of bodies that fill `low` to `high`, and what to say of it.
    pub(super) fn stretched(low: XY, high: XY) -> ([f64; 2], Option<String>) {
        let extent = [high[0] - low[0], high[1] - low[1]];
        for (long, thin, word) in [(0, 1, "high"), (1, 0, "wide")] {
            if extent[thin] > 0.0 && extent[long] > THIN * extent[thin] {
                let factor = round_down(extent[long] / (SHOWN * extent[thin]));
                let mut stretch = [1.0; 2];
                stretch[thin] = factor;
                return (stretch, Some(format!("Drawn {factor} times as {word} as it is.")));
            }
        }
        ([1.0; 2], None)
    }
}

/// The largest of 1, 2, 5 × 10^k that does not exceed `x > 0`.
pub(super) fn round_down(x: f64) -> f64 {
    let exponent = x.log10().floor() as i32;
    let candidate = |m: f64, k: i32| format!("{m}e{k}").parse().unwrap_or(m);
    let below = [1.0, 2.0, 5.0, 10.0].map(|m| candidate(m, exponent)).into_iter().rev().find(|c| *c <= x);
    below.unwrap_or_else(|| candidate(5.0, exponent - 1))
}

/// The corners of the smallest rectangle about the points.
pub(super) fn bounds<'a>(points: impl Iterator<Item = &'a XY>) -> [XY; 2] {
    points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
        [[low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])]]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_round_and_do_not_exceed() {
        for (x, expected) in
            [(1.0, 1.0), (1.99, 1.0), (2.0, 2.0), (49.0, 20.0), (50.0, 50.0), (0.003, 0.002), (1e-7, 1e-7)]
        {
            assert_eq!(round_down(x), expected, "{x}");
        }
    }

    #[test]
    fn thin_bodies_are_magnified_and_say_so() {
        assert_eq!(BodyChart::stretched([0.0; 2], [3.0, 1.0]), ([1.0; 2], None));
        let (stretch, words) = BodyChart::stretched([0.0; 2], [1000.0, 1.0]);
        assert_eq!((stretch, words.as_deref()), ([1.0, 200.0], Some("Drawn 200 times as high as it is.")));
        assert_eq!(BodyChart::stretched([0.0; 2], [1.0, 100.0]).0, [20.0, 1.0]);
    }
}
