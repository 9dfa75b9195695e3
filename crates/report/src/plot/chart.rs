//! What a picture shows, as data: a log–log chart against the mesh size.

use super::viridis;

/// Colour-blind-safe colours (Okabe and Ito), with black and a grey for what does not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Blue.
    Blue,
    /// Vermillion.
    Vermillion,
    /// Bluish green.
    Green,
    /// Reddish purple.
    Purple,
    /// Orange.
    Orange,
    /// Black.
    Black,
    /// Grey: levels left out of the fit, secondary text.
    Grey,
    /// Light grey: the grid.
    Pale,
    /// The background.
    White,
    /// A step of the scale that stresses are shown on, 0 (lowest) to [`viridis::STEPS`].
    Shade(u8),
}

impl Colour {
    /// The colours that have a name, by which a page finds them in an SVG.
    pub const PALETTE: [(&'static str, Self); 9] = [
        ("blue", Self::Blue),
        ("vermillion", Self::Vermillion),
        ("green", Self::Green),
        ("purple", Self::Purple),
        ("orange", Self::Orange),
        ("ink", Self::Black),
        ("grey", Self::Grey),
        ("pale", Self::Pale),
        ("paper", Self::White),
    ];

    /// Red, green, blue.
    pub fn rgb(self) -> [u8; 3] {
        match self {
            Self::Blue => [0, 114, 178],
            Self::Vermillion => [213, 94, 0],
            Self::Green => [0, 138, 100],
            Self::Purple => [173, 84, 136],
            Self::Orange => [190, 130, 0],
            Self::Black => [20, 20, 20],
            Self::Grey => [120, 120, 120],
            Self::Pale => [226, 226, 226],
            Self::White => [255, 255, 255],
            Self::Shade(step) => viridis::shade(step),
        }
    }
}

/// Shape of a curve's marks, so that colour is never the only difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// ●
    Circle,
    /// ■
    Square,
    /// ▲
    Triangle,
    /// ◆
    Diamond,
}

/// What a mark stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// A level that counts.
    Used,
    /// A level left out of the fit.
    Greyed,
    /// The absolute value of a negative number.
    Negative,
}

/// One measured value, `value > 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Mesh size.
    pub h: f64,
    /// Error or ledger term.
    pub value: f64,
    /// How to draw it.
    pub kind: MarkKind,
}

/// How heavily a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// Thin, small marks.
    Thin,
    /// Strong, large marks.
    Strong,
    /// A wide pale line and rings, which show around a curve that coincides with it.
    Halo,
}

/// Measured values joined by a line and labelled at its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name, e.g. `strain |u−uₕ|`.
    pub label: String,
    /// Second line of the label, e.g. the rate with its interval; may be empty.
    pub detail: String,
    /// Colour of marks, line and label.
    pub colour: Colour,
    /// Shape of the marks.
    pub shape: Shape,
    /// How heavily the curve is drawn.
    pub weight: Weight,
    /// Whether the claim is about this curve, so that the bounds stand near it.
    pub judged: bool,
    /// The values, in the order of the levels.
    pub marks: Vec<Mark>,
}

impl Curve {
    /// Whether two mesh sizes differ, without which no slope can be seen.
    pub fn has_slope(&self) -> bool {
        self.marks.windows(2).any(|pair| pair[0].h != pair[1].h)
    }
}

/// A fitted line with its 95 % band: `log e = intercept + slope log h`, natural logarithms.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Colour of line and shade.
    pub colour: Colour,
    /// Slope of the line.
    pub slope: f64,
    /// `log e` at `h = 1`.
    pub intercept: f64,
    /// Mesh sizes of the window.
    pub window: Vec<f64>,
    /// Half the width of the slope's 95 % interval.
    pub half_width: f64,
}

impl Band {
    /// Half the width of the 95 % band of the fitted line, in `log e`, at `log h = x`.
    ///
    /// With `t·se(slope) = t·s/√Sxx`: `t·s·√(1/n + (x−x̄)²/Sxx) = half_width · √(Sxx/n + (x−x̄)²)`.
    pub fn half_width_at(&self, x: f64) -> f64 {
        let n = self.window.len() as f64;
        let mean = self.window.iter().map(|h| h.ln()).sum::<f64>() / n;
        let sxx: f64 = self.window.iter().map(|h| (h.ln() - mean).powi(2)).sum();
        self.half_width * (sxx / n + (x - mean).powi(2)).sqrt()
    }

    /// `log e` on the line at `log h = x`.
    pub fn line_at(&self, x: f64) -> f64 {
        self.intercept + self.slope * x
    }

    /// Smallest and largest mesh size of the window.
    pub fn ends(&self) -> (f64, f64) {
        let fold = |f: fn(f64, f64) -> f64, start: f64| self.window.iter().copied().fold(start, f);
        (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY))
    }
}

/// A bound drawn as a dashed line beside its curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// Colour of the curve that it belongs to.
    pub colour: Colour,
    /// The exponent of `h`.
    pub exponent: f64,
    /// Mesh size and value where it begins.
    pub from: (f64, f64),
    /// Mesh size where it ends.
    pub to: f64,
}

impl Guide {
    /// Mesh sizes and values of both ends.
    pub fn ends(&self) -> [(f64, f64); 2] {
        let (h, value) = self.from;
        [self.from, (self.to, value * (self.to / h).powf(self.exponent))]
    }
}

/// A bound drawn as a slope triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Slope {
    /// The exponent of `h`.
    pub exponent: f64,
    /// The order, e.g. `O(h)`, `O(h^{3/4})`.
    pub label: String,
    /// Whose bound, e.g. `paper, today`.
    pub source: String,
}

/// A log–log chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Study and case.
    pub title: String,
    /// What came out, one line each.
    pub subtitle: Vec<String>,
    /// What the horizontal axis shows.
    pub x_label: String,
    /// What the vertical axis shows.
    pub y_label: String,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Fitted lines.
    pub bands: Vec<Band>,
    /// Bounds of single curves.
    pub guides: Vec<Guide>,
    /// Bounds.
    pub slopes: Vec<Slope>,
    /// What the reader should know beside: levels left out, curves not drawn.
    pub remarks: Vec<String>,
}

impl Chart {
    /// Every mark of every curve.
    pub(crate) fn marks(&self) -> impl Iterator<Item = &Mark> {
        self.curves.iter().flat_map(|c| &c.marks)
    }

    /// Every value that has to lie in the frame: those of the marks and the ends of the guides.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        let ends = self.guides.iter().flat_map(Guide::ends).map(|(_, value)| value);
        self.marks().map(|m| m.value).chain(ends)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_guide_ends_on_its_power() {
        let guide = Guide { colour: Colour::Blue, exponent: 1.5, from: (0.4, 8.0), to: 0.1 };
        let [from, to] = guide.ends();
        assert_eq!(from, (0.4, 8.0));
        assert!((to.1 - 1.0).abs() < 1e-14 && to.0 == 0.1, "{to:?}");
    }

    /// Textbook case by hand: x = log h = 0, 1, 2 gives x̄ = 1, Sxx = 2, so at x̄ the band is half_width·√(2/3).
    #[test]
    fn band_is_narrowest_at_the_mean() {
        let e = std::f64::consts::E;
        let band =
            Band { colour: Colour::Blue, slope: 1.0, intercept: 0.0, window: vec![1.0, e, e * e], half_width: 0.3 };
        assert!((band.half_width_at(1.0) - 0.3 * (2.0_f64 / 3.0).sqrt()).abs() < 1e-14);
        assert!((band.half_width_at(3.0) - 0.3 * (2.0_f64 / 3.0 + 4.0).sqrt()).abs() < 1e-14);
        assert!((band.line_at(2.0) - 2.0).abs() < 1e-15);
    }
}
