//! Draws a [`Chart`]: axes, fitted lines, curves with labels at their ends, slope triangles, words.

use super::annotate::{labels, triangles};
use super::axis::{LogRange, Tick, ticks};
use super::canvas::{Anchor, Canvas};
use super::chart::{Band, Chart, Colour, Curve, Guide, Weight};
use super::encode::{HEIGHT, WIDTH};
use super::frame::Frame;
use super::place::dashes;
use crate::error::ReportError;
use crate::format::significant;
use plotters::prelude::DrawingBackend;

/// Text sizes in plotters' unit, 1.16 of the em: nothing below an em of 20 pixels.
const TITLE: f64 = 36.0;
pub(super) const TEXT: f64 = 24.0;
/// From line to line.
pub(super) const LEADING: f64 = 31.0;
/// Between the sides of the picture and anything in it.
pub(super) const MARGIN: f64 = 30.0;
/// Length of a dash, and of the space behind it.
pub(super) const DASH: f64 = 9.0;
/// From the frame's right side to the curves' labels.
pub(super) const LEADER: f64 = 40.0;

pub(super) type Drawn = Result<(), ReportError>;

/// Draws the chart on a canvas of [`WIDTH`] × [`HEIGHT`]. A chart without marks says so in words.
pub(crate) fn draw<DB: DrawingBackend>(chart: &Chart, canvas: &Canvas<DB>) -> Drawn {
    let top = heading(&chart.title, &chart.subtitle, &chart.y_label, canvas)?;
    let bottom = remarks(&chart.remarks, canvas)?;
    let Some(frame) = frame(chart, canvas, top, bottom)? else {
        let middle = (f64::from(WIDTH) / 2.0, (top + bottom) / 2.0);
        return canvas.text("nothing to plot: no positive value", middle, Anchor::Centre, TEXT, Colour::Grey);
    };
    axes(&chart.x_label, canvas, &frame)?;
    for band in &chart.bands {
        draw_band(band, canvas, &frame)?;
    }
    for guide in &chart.guides {
        draw_guide(guide, canvas, &frame)?;
    }
    for curve in &chart.curves {
        draw_curve(curve, canvas, &frame)?;
    }
    labels(chart, canvas, &frame)?;
    triangles(chart, canvas, &frame)
}

/// Title and subtitle; returns where the frame may begin.
pub(super) fn heading<DB: DrawingBackend>(
    title: &str,
    subtitle: &[String],
    y_label: &str,
    canvas: &Canvas<DB>,
) -> Result<f64, ReportError> {
    let width = f64::from(WIDTH) - 2.0 * MARGIN;
    let title = canvas.cut(title, TITLE, width)?;
    canvas.text(&title, (MARGIN, 40.0), Anchor::Left, TITLE, Colour::Black)?;
    let mut y = 40.0 + 1.3 * LEADING;
    for line in subtitle {
        let parts = canvas.wrap(line, TEXT, width)?;
        let parts = ended(canvas, parts, 2, width)?;
        for part in parts {
            canvas.text(&part, (MARGIN, y), Anchor::Left, TEXT, Colour::Black)?;
            y += LEADING;
        }
    }
    canvas.text(y_label, (MARGIN, y + 14.0), Anchor::Left, TEXT, Colour::Grey)?;
    Ok(y + 14.0 + LEADING)
}

/// Remarks at the foot, at most four lines; returns where the frame has to end.
pub(super) fn remarks<DB: DrawingBackend>(words: &[String], canvas: &Canvas<DB>) -> Result<f64, ReportError> {
    let width = f64::from(WIDTH) - 2.0 * MARGIN;
    let mut lines = Vec::new();
    for remark in words {
        lines.extend(canvas.wrap(remark, TEXT, width)?);
    }
    let lines = ended(canvas, lines, 4, width)?;
    let top = f64::from(HEIGHT) - MARGIN - LEADING * lines.len() as f64 + 0.5 * LEADING;
    for (i, line) in lines.iter().enumerate() {
        let at = (MARGIN, top + i as f64 * LEADING);
        canvas.text(line, at, Anchor::Left, TEXT, Colour::Grey)?;
    }
    Ok(top - 3.1 * LEADING)
}

/// The first `most` lines, with `…` if there are more.
fn ended<DB: DrawingBackend>(
    canvas: &Canvas<DB>,
    mut lines: Vec<String>,
    most: usize,
    width: f64,
) -> Result<Vec<String>, ReportError> {
    if lines.len() > most {
        lines.truncate(most);
        if let Some(last) = lines.last_mut() {
            *last = canvas.cut(&format!("{last} …"), TEXT, width)?;
        }
    }
    Ok(lines)
}

/// The frame between the words, with room for the ticks at its left and the curves' labels at its right.
fn frame<DB: DrawingBackend>(
    chart: &Chart,
    canvas: &Canvas<DB>,
    top: f64,
    bottom: f64,
) -> Result<Option<Frame>, ReportError> {
    let (Some(x), Some(y)) =
        (LogRange::around(chart.marks().map(|m| m.h), 0.05), LogRange::around(chart.values(), 0.06))
    else {
        return Ok(None);
    };
    let mut widest: f64 = 0.0;
    for curve in chart.curves.iter().filter(|c| !c.marks.is_empty()) {
        for text in [&curve.label, &curve.detail] {
            widest = widest.max(canvas.text_width(text, TEXT)?);
        }
    }
    let right = f64::from(WIDTH) - MARGIN - (widest + LEADER).min(0.45 * f64::from(WIDTH));
    let mut scale: f64 = 0.0;
    for tick in y_ticks(y, bottom - top) {
        scale = scale.max(canvas.text_width(&tick.label, TEXT)?);
    }
    let left = MARGIN + scale + 14.0;
    Ok(Some(Frame { left, right, top, bottom, x, y }))
}

pub(super) fn y_ticks(range: LogRange, height: f64) -> Vec<Tick> {
    ticks(range, height, 14.0, |_| TEXT)
}

/// Grid, ticks, the two axes and the name of the lower one.
pub(super) fn axes<DB: DrawingBackend>(x_label: &str, canvas: &Canvas<DB>, frame: &Frame) -> Drawn {
    let Frame { left, right, top, bottom, x, y } = *frame;
    let width = |label: &str| canvas.text_width(label, TEXT).unwrap_or(100.0);
    for tick in ticks(x, frame.width(), 18.0, width) {
        let at = frame.left + x.share(tick.value) * frame.width();
        canvas.line(&[(at, top), (at, bottom)], Colour::Pale, 1.0, 1.0)?;
        canvas.line(&[(at, bottom), (at, bottom + 7.0)], Colour::Black, 1.0, 1.0)?;
        canvas.text(&tick.label, (at, bottom + 26.0), Anchor::Centre, TEXT, Colour::Black)?;
    }
    for tick in y_ticks(y, frame.height()) {
        let at = bottom - y.share(tick.value) * frame.height();
        canvas.line(&[(left, at), (right, at)], Colour::Pale, 1.0, 1.0)?;
        canvas.line(&[(left - 7.0, at), (left, at)], Colour::Black, 1.0, 1.0)?;
        canvas.text(&tick.label, (left - 14.0, at), Anchor::Right, TEXT, Colour::Black)?;
    }
    let corners = [(left, top), (left, bottom), (right, bottom)];
    canvas.line(&corners, Colour::Black, 1.5, 1.0)?;
    let middle = (0.5 * (left + right), bottom + 26.0 + 1.1 * LEADING);
    canvas.text(x_label, middle, Anchor::Centre, TEXT, Colour::Grey)
}

/// The fitted line over its window, and its 95 % band.
fn draw_band<DB: DrawingBackend>(band: &Band, canvas: &Canvas<DB>, frame: &Frame) -> Drawn {
    let (low, high) = band.ends();
    if !(low > 0.0 && high > low && band.half_width.is_finite()) {
        return Ok(());
    }
    let steps: Vec<f64> = (0..=24).map(|i| low.ln() + (high.ln() - low.ln()) * f64::from(i) / 24.0).collect();
    let edge = |x: f64, side: f64| {
        let (px, py) = frame.at(x.exp(), (band.line_at(x) + side * band.half_width_at(x)).exp());
        (px, py.clamp(frame.top, frame.bottom))
    };
    let upper = steps.iter().map(|&x| edge(x, 1.0));
    let lower = steps.iter().rev().map(|&x| edge(x, -1.0));
    canvas.polygon(&upper.chain(lower).collect::<Vec<_>>(), band.colour, 0.18)?;
    let line = [edge(low.ln(), 0.0), edge(high.ln(), 0.0)];
    canvas.line(&line, band.colour, 6.0, 0.35)
}

fn draw_curve<DB: DrawingBackend>(curve: &Curve, canvas: &Canvas<DB>, frame: &Frame) -> Drawn {
    let (width, strength, radius) = match curve.weight {
        Weight::Thin => (1.5, 1.0, 6.0),
        Weight::Strong => (2.5, 1.0, 8.0),
        Weight::Halo => (9.0, 0.2, 14.0),
    };
    canvas.line(&pixels(curve, frame), curve.colour, width, strength)?;
    for mark in &curve.marks {
        let at = frame.at(mark.h, mark.value);
        canvas.note(at, || format!("{}: {} at {}", curve.label, significant(mark.value, 5), significant(mark.h, 5)));
        match curve.weight {
            Weight::Halo => canvas.ring(at, radius, curve.shape, curve.colour, mark.kind)?,
            _ => canvas.mark(at, radius, curve.shape, curve.colour, mark.kind)?,
        }
    }
    Ok(())
}

/// Dashes along the guide.
fn draw_guide<DB: DrawingBackend>(guide: &Guide, canvas: &Canvas<DB>, frame: &Frame) -> Drawn {
    let [from, to] = guide.ends().map(|(h, value)| frame.at(h, value));
    for dash in dashes(from, to, DASH) {
        canvas.line(&dash, guide.colour, 1.5, 0.8)?;
    }
    Ok(())
}

/// The marks in pixels.
pub(super) fn pixels(curve: &Curve, frame: &Frame) -> Vec<(f64, f64)> {
    curve.marks.iter().map(|m| frame.at(m.h, m.value)).collect()
}
