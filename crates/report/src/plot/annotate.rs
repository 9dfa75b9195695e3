//! Words and triangles inside a chart: curves named at their ends, bounds as slopes.

use super::canvas::{Anchor, Canvas};
use super::chart::{Chart, Colour, Curve};
use super::draw::{Drawn, LEADER, LEADING, MARGIN, TEXT, pixels};
use super::encode::WIDTH;
use super::frame::Frame;
use super::place::{Rect, along, free_place, spread};
use super::triangle::Triangle;
use plotters::prelude::DrawingBackend;

/// Names at the right ends of the curves, moved apart, with a leader to the end that each belongs to.
pub(super) fn labels<DB: DrawingBackend>(chart: &Chart, canvas: &Canvas<DB>, frame: &Frame) -> Drawn {
    let end = |curve: &Curve| pixels(curve, frame).into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let mut ends: Vec<_> = chart.curves.iter().filter_map(|c| end(c).map(|at| (at, c))).collect();
    ends.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
    let wanted: Vec<f64> = ends.iter().map(|(at, _)| at.1).collect();
    let room = (frame.height() - LEADING) / ends.len().max(1) as f64;
    let gap = (2.0 * LEADING + 6.0).min(room);
    let places = spread(&wanted, gap, frame.top + 0.5 * LEADING, frame.bottom - 0.5 * LEADING);
    for ((at, curve), y) in ends.into_iter().zip(places) {
        let left = frame.right + LEADER;
        let width = f64::from(WIDTH) - MARGIN - left;
        let leader = [(at.0 + 12.0, at.1), (frame.right + 8.0, y), (left - 8.0, y)];
        canvas.line(&leader, curve.colour, 1.0, 0.6)?;
        let lift = if curve.detail.is_empty() { 0.0 } else { 0.45 * LEADING };
        for (text, y) in [(&curve.label, y - lift), (&curve.detail, y + lift)] {
            let text = canvas.cut(text, TEXT, width)?;
            canvas.text(&text, (left, y), Anchor::Left, TEXT, curve.colour)?;
        }
    }
    Ok(())
}

/// The bounds as slope triangles, in the free space nearest to the strong curves.
pub(super) fn triangles<DB: DrawingBackend>(chart: &Chart, canvas: &Canvas<DB>, frame: &Frame) -> Drawn {
    let path = |c: &Curve| along(&pixels(c, frame), 6.0);
    let mut obstacles: Vec<_> = chart.curves.iter().flat_map(path).collect();
    obstacles.extend(chart.guides.iter().flat_map(|g| along(&g.ends().map(|(h, value)| frame.at(h, value)), 6.0)));
    let near: Vec<_> = chart.curves.iter().filter(|c| c.judged).flat_map(path).collect();
    for slope in &chart.slopes {
        let triangle = Triangle::new(slope.exponent, frame);
        let words = canvas.text_width(&slope.label, TEXT)?.max(canvas.text_width(&slope.source, TEXT)?);
        let size = (triangle.width + 12.0 + words, triangle.height.abs().max(2.0 * LEADING));
        let area = Rect {
            left: frame.left + 14.0,
            top: frame.top + 8.0,
            width: frame.width() - 28.0,
            height: frame.height() - 22.0,
        };
        let place = free_place(area, size, &obstacles, &near);
        obstacles.extend(place.points(10.0));
        let corners = triangle.corners(place.left, place.top + 0.5 * (place.height + triangle.height.abs()));
        draw_triangle(canvas, &corners)?;
        let left = place.left + triangle.width + 12.0;
        let middle = place.top + 0.5 * place.height;
        for (text, shift) in [(&slope.label, -0.5), (&slope.source, 0.5)] {
            canvas.text(text, (left, middle + shift * LEADING), Anchor::Left, TEXT, Colour::Black)?;
        }
    }
    Ok(())
}

fn draw_triangle<DB: DrawingBackend>(canvas: &Canvas<DB>, corners: &[(f64, f64); 3]) -> Drawn {
    let [a, b, c] = *corners;
    canvas.polygon(&[a, b, c], Colour::Grey, 0.15)?;
    canvas.line(&[a, b, c, a], Colour::Black, 1.5, 1.0)
}
