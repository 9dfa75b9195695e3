//! Draws a [`ZoneChart`]: two panels over one linear axis.

use super::axis::Tick;
use super::canvas::{Anchor, Canvas};
use super::chart::{Colour, MarkKind, Shape};
use super::draw::{Drawn, LEADING, MARGIN, TEXT, heading, remarks};
use super::encode::WIDTH;
use super::linear::LinearRange;
use super::zone_chart::{Trace, ZoneChart};
use crate::error::ReportError;
use crate::format::significant;
use plotters::prelude::DrawingBackend;

/// Share of the height that the gap takes.
const LOWER: f64 = 0.3;
/// Between two labels of an axis.
const APART: f64 = 45.0;

/// Shortest stroke of a line.
const STRIDE: f64 = 8.0;

/// A panel in pixels (downwards), and what its sides stand for.
struct Panel {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    x: LinearRange,
    y: LinearRange,
}

impl Panel {
    fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (
            self.left + self.x.share(x) * (self.right - self.left),
            self.bottom - self.y.share(y) * (self.bottom - self.top),
        )
    }

    fn y_ticks(&self) -> Vec<Tick> {
        self.y.ticks(self.bottom - self.top, APART)
    }
}

/// Draws the chart on a canvas of the usual size.
pub(crate) fn draw<DB: DrawingBackend>(chart: &ZoneChart, canvas: &Canvas<DB>) -> Drawn {
    let (low, high) = chart.window;
    let inside = |t: &Trace| -> Vec<f64> {
        t.points.iter().filter(|(x, _)| (low..=high).contains(x)).map(|(_, y)| *y).collect()
    };
    let pressures = LinearRange::around_zero(chart.pressure.iter().flat_map(inside));
    let gaps = LinearRange::around_zero(inside(&chart.gap).into_iter());
    let top = heading(&chart.title, &chart.subtitle, &format!("contact pressure{}", pressures.unit()), canvas)?;
    let bottom = remarks(&chart.remarks, canvas)?;
    let middle = bottom - LOWER * (bottom - top);
    let x = LinearRange { low, high };
    let panel = |top, bottom, y| Panel { left: MARGIN, right: f64::from(WIDTH) - MARGIN - 28.0, top, bottom, x, y };
    let mut panels = [panel(top, middle - 1.6 * LEADING, pressures), panel(middle, bottom, gaps)];
    let mut widest: f64 = 0.0;
    for tick in panels.iter().flat_map(Panel::y_ticks) {
        widest = widest.max(canvas.text_width(&tick.label, TEXT)?);
    }
    panels.iter_mut().for_each(|p| p.left = MARGIN + widest + 14.0);
    legend(chart, canvas, panels[0].right, top - LEADING)?;
    let above = (MARGIN, middle - 0.75 * LEADING);
    canvas.text(&format!("gap{}", gaps.unit()), above, Anchor::Left, TEXT, Colour::Grey)?;
    for p in &panels {
        axes(p, canvas, chart.edge)?;
    }
    x_labels(chart, canvas, &panels[1])?;
    for t in &chart.pressure {
        trace(t, canvas, &panels[0])?;
    }
    trace(&chart.gap, canvas, &panels[1])
}

fn axes<DB: DrawingBackend>(p: &Panel, canvas: &Canvas<DB>, edge: Option<f64>) -> Drawn {
    for tick in p.x.ticks(p.right - p.left, 2.5 * APART) {
        let (at, _) = p.at((tick.value, 0.0));
        canvas.line(&[(at, p.top), (at, p.bottom)], Colour::Pale, 1.0, 1.0)?;
        canvas.line(&[(at, p.bottom), (at, p.bottom + 7.0)], Colour::Black, 1.0, 1.0)?;
    }
    for tick in p.y_ticks() {
        let (_, at) = p.at((p.x.low, tick.value));
        canvas.line(&[(p.left, at), (p.right, at)], Colour::Pale, 1.0, 1.0)?;
        canvas.line(&[(p.left - 7.0, at), (p.left, at)], Colour::Black, 1.0, 1.0)?;
        canvas.text(&tick.label, (p.left - 14.0, at), Anchor::Right, TEXT, Colour::Black)?;
    }
    if p.y.low < 0.0 {
        let (_, zero) = p.at((p.x.low, 0.0));
        canvas.line(&[(p.left, zero), (p.right, zero)], Colour::Black, 1.0, 1.0)?;
    }
    if let Some(x) = edge.filter(|x| (p.x.low..=p.x.high).contains(x)) {
        let (at, _) = p.at((x, 0.0));
        canvas.line(&[(at, p.top), (at, p.bottom)], Colour::Vermillion, 1.5, 0.6)?;
    }
    canvas.line(&[(p.left, p.top), (p.left, p.bottom), (p.right, p.bottom)], Colour::Black, 1.5, 1.0)
}

fn x_labels<DB: DrawingBackend>(chart: &ZoneChart, canvas: &Canvas<DB>, p: &Panel) -> Drawn {
    for tick in p.x.ticks(p.right - p.left, 2.5 * APART) {
        let (at, _) = p.at((tick.value, 0.0));
        canvas.text(&tick.label, (at, p.bottom + 26.0), Anchor::Centre, TEXT, Colour::Black)?;
    }
    let middle = (0.5 * (p.left + p.right), p.bottom + 26.0 + 1.1 * LEADING);
    let words = format!("{}{}", chart.x_label, p.x.unit());
    canvas.text(&words, middle, Anchor::Centre, TEXT, Colour::Grey)
}

/// The traces inside the window; a line is cut where it leaves it.
fn trace<DB: DrawingBackend>(t: &Trace, canvas: &Canvas<DB>, p: &Panel) -> Drawn {
    let inside = |(x, _): &(f64, f64)| (p.x.low..=p.x.high).contains(x);
    let pixels: Vec<(f64, f64)> = t.points.iter().copied().filter(inside).map(|xy| p.at(xy)).collect();
    if !t.marks {
        return canvas.line(&thinned(&pixels), t.colour, 2.5, 1.0);
    }
    canvas.line(&pixels, t.colour, 1.0, 0.35)?;
    let mut noted: Option<(f64, f64)> = None;
    for (x, y) in t.points.iter().copied().filter(inside) {
        let at = p.at((x, y));
        // nobody can point at one of two places that are closer than this
        if noted.is_none_or(|last| (at.0 - last.0).hypot(at.1 - last.1) >= STRIDE) {
            canvas.note(at, || format!("{}: {} at {}", t.label, significant(y, 5), significant(x, 5)));
            noted = Some(at);
        }
    }
    let radius = radius(&pixels);
    pixels.iter().try_for_each(|at| canvas.mark(*at, radius, Shape::Circle, t.colour, MarkKind::Used))
}

/// Points at least [`STRIDE`] apart, and the last one: shorter strokes would show the rounding to whole dots.
fn thinned(pixels: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::with_capacity(pixels.len());
    for (i, at) in pixels.iter().enumerate() {
        let far = kept.last().is_none_or(|k| (at.0 - k.0).hypot(at.1 - k.1) >= STRIDE);
        if far || i + 1 == pixels.len() {
            kept.push(*at);
        }
    }
    kept
}

/// Small enough that neighbours can be told apart, large enough to be seen.
fn radius(pixels: &[(f64, f64)]) -> f64 {
    let mut apart: Vec<f64> = pixels.windows(2).map(|w| (w[1].0 - w[0].0).hypot(w[1].1 - w[0].1)).collect();
    apart.sort_by(f64::total_cmp);
    apart.get(apart.len() / 2).map_or(6.0, |d| (0.4 * d).clamp(3.0, 6.5))
}

/// The names of the pressures and of the formula's edge, in one row that ends at `right`.
fn legend<DB: DrawingBackend>(chart: &ZoneChart, canvas: &Canvas<DB>, right: f64, y: f64) -> Drawn {
    let mut x = right;
    let mut entry = |label: &str, colour: Colour, sample: &dyn Fn(f64) -> Drawn| -> Result<(), ReportError> {
        canvas.text(label, (x, y), Anchor::Right, TEXT, colour)?;
        x -= canvas.text_width(label, TEXT)? + 10.0;
        sample(x)?;
        x -= 60.0;
        Ok(())
    };
    if chart.edge.is_some() {
        let upright = |x: f64| canvas.line(&[(x - 6.0, y - 12.0), (x - 6.0, y + 12.0)], Colour::Vermillion, 1.5, 0.6);
        entry("its half width", Colour::Vermillion, &upright)?;
    }
    for t in &chart.pressure {
        let sample = |x: f64| match t.marks {
            true => canvas.mark((x - 8.0, y), 6.0, Shape::Circle, t.colour, MarkKind::Used),
            false => canvas.line(&[(x - 34.0, y), (x, y)], t.colour, 2.5, 1.0),
        };
        entry(&t.label, t.colour, &sample)?;
    }
    Ok(())
}
