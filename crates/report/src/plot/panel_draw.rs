//! Draws a [`PanelChart`]: words, a legend in rows, two frames.

use super::axis::LogRange;
use super::canvas::{Anchor, Canvas};
use super::chart::{Colour, MarkKind};
use super::draw::{DASH, Drawn, LEADING, MARGIN, TEXT, axes, heading, remarks, y_ticks};
use super::encode::WIDTH;
use super::frame::Frame;
use super::panel_chart::{Panel, PanelChart, Series, Style};
use super::place::dashes;
use crate::error::ReportError;
use plotters::prelude::DrawingBackend;

/// Length of the sample of a line in the legend.
const SAMPLE: f64 = 54.0;
/// Between two entries of the legend.
const APART: f64 = 36.0;
/// Between the panels.
const GUTTER: f64 = 34.0;
/// Radius of the marks of the first series, and how much larger those of the next are.
const RADIUS: [f64; 2] = [6.5, 4.0];

/// Draws the chart on a canvas of the usual size.
pub(crate) fn draw<DB: DrawingBackend>(chart: &PanelChart, canvas: &Canvas<DB>) -> Drawn {
    let top = heading(&chart.title, &chart.subtitle, "", canvas)? - LEADING;
    let top = legend(chart, canvas, top)?;
    let bottom = remarks(&chart.remarks, canvas)?;
    let half = 0.5 * (f64::from(WIDTH) - 2.0 * MARGIN - GUTTER);
    for (k, panel) in chart.panels.iter().enumerate() {
        let left = MARGIN + k as f64 * (half + GUTTER);
        draw_panel(panel, canvas, [left, left + half], [top, bottom])?;
    }
    Ok(())
}

/// The entries in rows from the left; returns where the panels may begin.
fn legend<DB: DrawingBackend>(chart: &PanelChart, canvas: &Canvas<DB>, top: f64) -> Result<f64, ReportError> {
    let right = f64::from(WIDTH) - MARGIN;
    let (mut x, mut y) = (MARGIN, top);
    for series in chart.legend() {
        let width = SAMPLE + 12.0 + canvas.text_width(&series.label, TEXT)?;
        if x > MARGIN && x + width > right {
            (x, y) = (MARGIN, y + LEADING);
        }
        stroke(series, canvas, &[(x, y), (x + SAMPLE, y)])?;
        mark(series, canvas, (x + 0.5 * SAMPLE, y))?;
        canvas.text(&series.label, (x + SAMPLE + 12.0, y), Anchor::Left, TEXT, series.colour)?;
        x += width + APART;
    }
    Ok(y + 1.2 * LEADING)
}

/// A panel between `left` and `right`, its words included.
fn draw_panel<DB: DrawingBackend>(
    panel: &Panel,
    canvas: &Canvas<DB>,
    [left, right]: [f64; 2],
    [top, bottom]: [f64; 2],
) -> Drawn {
    let label = canvas.cut(&panel.y_label, TEXT, right - left)?;
    canvas.text(&label, (left, top), Anchor::Left, TEXT, Colour::Grey)?;
    let top = top + 0.9 * LEADING;
    let points = || panel.series.iter().flat_map(Series::shown);
    let ranges = (LogRange::around(points().map(|p| p.0), 0.06), LogRange::around(points().map(|p| p.1), 0.06));
    let (Some(x), Some(y)) = ranges else {
        let middle = (0.5 * (left + right), 0.5 * (top + bottom));
        return canvas.text("nothing to plot", middle, Anchor::Centre, TEXT, Colour::Grey);
    };
    let mut scale: f64 = 0.0;
    for tick in y_ticks(y, bottom - top) {
        scale = scale.max(canvas.text_width(&tick.label, TEXT)?);
    }
    let frame = Frame { left: left + scale + 14.0, right, top, bottom, x, y };
    axes(&panel.x_label, canvas, &frame)?;
    for series in &panel.series {
        let pixels: Vec<(f64, f64)> = series.shown().map(|(x, y)| frame.at(x, y)).collect();
        stroke(series, canvas, &pixels)?;
        pixels.iter().try_for_each(|at| mark(series, canvas, *at))?;
    }
    Ok(())
}

/// The line of a series.
fn stroke<DB: DrawingBackend>(series: &Series, canvas: &Canvas<DB>, points: &[(f64, f64)]) -> Drawn {
    match series.style {
        Style::Marks(..) => canvas.line(points, series.colour, 2.5, 0.8),
        Style::Dashes => points.windows(2).try_for_each(|ends| {
            dashes(ends[0], ends[1], DASH).iter().try_for_each(|dash| canvas.line(dash, series.colour, 2.0, 0.9))
        }),
    }
}

fn mark<DB: DrawingBackend>(series: &Series, canvas: &Canvas<DB>, at: (f64, f64)) -> Drawn {
    let [first, more] = RADIUS;
    match series.style {
        Style::Marks(shape, 0) => canvas.mark(at, first, shape, series.colour, MarkKind::Used),
        Style::Marks(shape, rank) => {
            canvas.ring(at, first + more * f64::from(rank), shape, series.colour, MarkKind::Used)
        }
        Style::Dashes => Ok(()),
    }
}
