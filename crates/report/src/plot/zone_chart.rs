//! What a picture of the contact zone shows, as data: pressure above, gap below, over the same coordinate.

use super::chart::Colour;

/// Points joined by a line, or shown by marks.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Name in the legend.
    pub label: String,
    /// Colour of line or marks.
    pub colour: Colour,
    /// Marks if true, else a line.
    pub marks: bool,
    /// Coordinate and value, in the order of the coordinate.
    pub points: Vec<(f64, f64)>,
}

/// The picture of one zone.
#[derive(Clone, Debug, PartialEq)]
pub struct ZoneChart {
    /// Study and case.
    pub title: String,
    /// What came out, one line each.
    pub subtitle: Vec<String>,
    /// What the coordinate is.
    pub x_label: String,
    /// The part of the zone that is shown.
    pub window: (f64, f64),
    /// The pressures.
    pub pressure: Vec<Trace>,
    /// The discrete gap.
    pub gap: Trace,
    /// Where a formula lets the contact end.
    pub edge: Option<f64>,
    /// What the reader should know beside.
    pub remarks: Vec<String>,
}
