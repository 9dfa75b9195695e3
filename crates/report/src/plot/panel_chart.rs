//! What a picture of two log–log panels side by side shows, as data.

use super::chart::{Colour, Shape};

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Marks joined by a line. Series of higher rank have larger, open marks, so that those that coincide can all be seen.
    Marks(Shape, u8),
    /// Dashes without marks: something to compare with.
    Dashes,
}

/// Positive values over positive values.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name in the legend; series of the same name in both panels share an entry.
    pub label: String,
    /// Colour of line, marks and name.
    pub colour: Colour,
    /// How it is drawn.
    pub style: Style,
    /// The values.
    pub points: Vec<(f64, f64)>,
}

/// One panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What the horizontal axis shows.
    pub x_label: String,
    /// What the vertical axis shows; stands above it.
    pub y_label: String,
    /// The series, drawn in this order.
    pub series: Vec<Series>,
}

/// The picture.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelChart {
    /// Study and case.
    pub title: String,
    /// What came out, one line each.
    pub subtitle: Vec<String>,
    /// Left and right.
    pub panels: [Panel; 2],
    /// What the reader should know beside.
    pub remarks: Vec<String>,
}

impl PanelChart {
    /// One series for each name, in the order of their first appearance; series without a value are left out.
    pub(crate) fn legend(&self) -> Vec<&Series> {
        let mut entries: Vec<&Series> = Vec::new();
        for series in self.panels.iter().flat_map(|p| &p.series).filter(|s| s.has_values()) {
            if !entries.iter().any(|e| e.label == series.label) {
                entries.push(series);
            }
        }
        entries
    }
}

impl Series {
    /// The points that a logarithmic axis can show.
    pub(crate) fn shown(&self) -> impl Iterator<Item = (f64, f64)> {
        let positive = |v: f64| v > 0.0 && v.is_finite();
        self.points.iter().copied().filter(move |p| positive(p.0) && positive(p.1))
    }

    fn has_values(&self) -> bool {
        self.shown().next().is_some()
    }
}
