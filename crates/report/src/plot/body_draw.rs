//! Draws a [`BodyChart`]: bodies in the middle, names in columns at both sides with lines to what they name, the scale of
//! colours at the right.

use super::body_chart::{Bar, BodyChart, Label, XY, bounds};
use super::canvas::{Anchor, Canvas};
use super::chart::Colour;
use super::draw::{Drawn, LEADING, MARGIN, TEXT, heading, remarks};
use super::encode::WIDTH;
use super::linear::LinearRange;
use super::place::spread;
use super::viridis;
use crate::error::ReportError;
use plotters::prelude::DrawingBackend;

/// Between a name and the bodies.
const LEADER: f64 = 46.0;
/// Width of the scale of colours.
const BAR: f64 = 26.0;
/// Between two ticks of the scale.
const APART: f64 = 48.0;

/// From the plane to pixels, downwards.
struct View {
    low: XY,
    corner: XY,
    scale: XY,
}

impl View {
    /// The largest view of the points inside the rectangle of pixels, in its middle.
    fn new(points: [XY; 2], stretch: XY, [left, right]: XY, [top, bottom]: XY) -> Self {
        let [low, high] = points;
        let size = [0, 1].map(|i| ((high[i] - low[i]) * stretch[i]).max(f64::MIN_POSITIVE));
        let scale = ((right - left) / size[0]).min((bottom - top) / size[1]);
        let corner = [0.5 * (left + right - scale * size[0]), 0.5 * (top + bottom + scale * size[1])];
        Self { low, corner, scale: stretch.map(|s| s * scale) }
    }

    fn at(&self, p: XY) -> (f64, f64) {
        (self.corner[0] + self.scale[0] * (p[0] - self.low[0]), self.corner[1] - self.scale[1] * (p[1] - self.low[1]))
    }

    fn all(&self, points: &[XY]) -> Vec<(f64, f64)> {
        points.iter().map(|p| self.at(*p)).collect()
    }
}

/// Draws the chart on a canvas of the usual size.
pub(crate) fn draw<DB: DrawingBackend>(chart: &BodyChart, canvas: &Canvas<DB>) -> Drawn {
    let top = heading(&chart.title, &chart.subtitle, "", canvas)? - LEADING;
    // what the charts with axes leave for their ticks belongs to the bodies
    let bottom = remarks(&chart.remarks, canvas)? + 2.0 * LEADING;
    let points = chart.areas.iter().flat_map(|a| &a.outline).chain(chart.strokes.iter().flat_map(|s| &s.points));
    let box_ = bounds(points);
    let columns = columns(&chart.labels, box_);
    let mut sides = [MARGIN + 10.0, f64::from(WIDTH) - MARGIN - 10.0];
    let widths = [width(&columns[0], canvas)?, width(&columns[1], canvas)?];
    sides[0] += widths[0];
    sides[1] -= widths[1];
    if let Some(bar) = &chart.bar {
        sides[1] -= draw_bar(bar, canvas, sides[1], top, bottom)? + LEADER;
    }
    let view = View::new(box_, chart.stretch, sides, [top, bottom]);
    for area in &chart.areas {
        canvas.polygon(&view.all(&area.outline), area.colour, area.strength)?;
    }
    for stroke in &chart.strokes {
        canvas.line(&view.all(&stroke.points), stroke.colour, stroke.width, stroke.strength)?;
    }
    for (text, at) in &chart.names {
        name(text, view.at(*at), canvas)?;
    }
    for (column, edge, outward) in [(&columns[0], sides[0], -1.0), (&columns[1], sides[1], 1.0)] {
        draw_column(column, canvas, &view, (edge, outward), [top, bottom])?;
    }
    Ok(())
}

/// The labels at the left and at the right: by the side on which what they name lies, and about as many on both.
fn columns(labels: &[Label], [low, high]: [XY; 2]) -> [Vec<&Label>; 2] {
    let middle = 0.5 * (low[0] + high[0]);
    let centre = |l: &Label| l.anchors.iter().map(|p| p[0]).sum::<f64>() / l.anchors.len().max(1) as f64 - middle;
    let mut sorted: Vec<&Label> = labels.iter().filter(|l| !l.anchors.is_empty()).collect();
    sorted.sort_by(|a, b| centre(a).total_cmp(&centre(b)));
    let share = 1e-6 * (high[0] - low[0]);
    let left = sorted.iter().filter(|l| centre(l) < -share).count();
    let right = sorted.iter().filter(|l| centre(l) > share).count();
    // those in the middle go where there are fewer
    let all = sorted.len();
    let cut = (all / 2).clamp(left.min(all - right), all - right);
    let (left, right) = sorted.split_at(cut);
    [left.to_vec(), right.to_vec()]
}

/// Pixels that a column takes with the lines to the bodies; none without a label.
fn width<DB: DrawingBackend>(column: &[&Label], canvas: &Canvas<DB>) -> Result<f64, ReportError> {
    let mut widest: f64 = 0.0;
    for label in column {
        widest = widest.max(canvas.text_width(&label.text, TEXT)?).max(canvas.text_width(&label.detail, TEXT)?);
    }
    Ok(if column.is_empty() { 0.0 } else { widest + LEADER })
}

/// Names from top to bottom, each near what it names; `edge` is where the bodies' room ends.
fn draw_column<DB: DrawingBackend>(
    column: &[&Label],
    canvas: &Canvas<DB>,
    view: &View,
    (edge, outward): (f64, f64),
    [top, bottom]: XY,
) -> Drawn {
    let mut places: Vec<_> = column.iter().map(|l| (anchor(&view.all(&l.anchors), outward), *l)).collect();
    places.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
    let wanted: Vec<f64> = places.iter().map(|(at, _)| at.1).collect();
    let gap = (2.0 * LEADING + 8.0).min((bottom - top) / column.len().max(1) as f64);
    let ys = spread(&wanted, gap, top + 0.5 * LEADING, bottom - LEADING);
    for ((at, label), y) in places.into_iter().zip(ys) {
        let x = edge + outward * LEADER;
        let end = (x - outward * 8.0, y);
        canvas.line(&[end, at], label.colour, 1.5, 1.0)?;
        canvas.mark(at, 4.0, super::chart::Shape::Circle, label.colour, super::chart::MarkKind::Used)?;
        let side = if outward < 0.0 { Anchor::Right } else { Anchor::Left };
        let lift = if label.detail.is_empty() { 0.0 } else { 0.45 * LEADING };
        canvas.text(&label.text, (x, y - lift), side, TEXT, label.colour)?;
        canvas.text(&label.detail, (x, y + lift), side, TEXT, label.colour)?;
    }
    Ok(())
}

/// The point nearest to the column, or in the middle of those that are as near.
fn anchor(points: &[(f64, f64)], outward: f64) -> (f64, f64) {
    let n = points.len().max(1) as f64;
    let centre = points.iter().fold((0.0, 0.0), |c, p| (c.0 + p.0 / n, c.1 + p.1 / n));
    let cost = |p: &(f64, f64)| 0.35 * (p.0 - centre.0).hypot(p.1 - centre.1) - outward * p.0;
    points.iter().copied().min_by(|a, b| cost(a).total_cmp(&cost(b))).unwrap_or(centre)
}

/// A name on white, so that it can be read on a mesh.
fn name<DB: DrawingBackend>(text: &str, (x, y): (f64, f64), canvas: &Canvas<DB>) -> Drawn {
    let half = 0.5 * canvas.text_width(text, TEXT)? + 8.0;
    let (top, bottom) = (y - 0.6 * LEADING, y + 0.6 * LEADING);
    let corners = [(x - half, top), (x + half, top), (x + half, bottom), (x - half, bottom)];
    canvas.polygon(&corners, Colour::White, 0.85)?;
    canvas.text(text, (x, y), Anchor::Centre, TEXT, Colour::Black)
}

/// The scale with its ticks, its right end at `right`; returns its width.
fn draw_bar<DB: DrawingBackend>(
    bar: &Bar,
    canvas: &Canvas<DB>,
    right: f64,
    top: f64,
    bottom: f64,
) -> Result<f64, ReportError> {
    let range = LinearRange { low: 0.0, high: bar.top };
    let (top, bottom) = (top + 1.6 * LEADING, bottom - 0.5 * LEADING);
    let ticks = range.ticks(bottom - top, APART);
    let mut labels: f64 = 0.0;
    for tick in &ticks {
        labels = labels.max(canvas.text_width(&tick.label, TEXT)?);
    }
    let words = format!("{}{}", bar.name, range.unit());
    canvas.text(&words, (right, top - 1.5 * LEADING), Anchor::Right, TEXT, Colour::Grey)?;
    let left = right - labels - 14.0 - BAR;
    let steps = f64::from(viridis::STEPS) + 1.0;
    for step in 0..=viridis::STEPS {
        let y = |k: f64| bottom - (bottom - top) * k / steps;
        let (low, high) = (y(f64::from(step)), y(f64::from(step) + 1.0));
        let corners = [(left, low), (left + BAR, low), (left + BAR, high), (left, high)];
        canvas.polygon(&corners, Colour::Shade(step), 1.0)?;
    }
    if bar.cut {
        let tip = [(left, top - 2.0), (left + 0.5 * BAR, top - 0.6 * BAR), (left + BAR, top - 2.0)];
        canvas.polygon(&tip, Colour::Shade(viridis::STEPS), 1.0)?;
    }
    for tick in ticks {
        let y = bottom - range.share(tick.value) * (bottom - top);
        canvas.line(&[(left + BAR, y), (left + BAR + 7.0, y)], Colour::Black, 1.0, 1.0)?;
        canvas.text(&tick.label, (left + BAR + 12.0, y), Anchor::Left, TEXT, Colour::Black)?;
    }
    Ok(right - left)
}
