//! Strokes, areas, marks and text in the pixels of the picture, on any plotters backend.

use super::chart::{Colour, MarkKind, Shape};
use crate::error::ReportError;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::cell::RefCell;
use std::sync::OnceLock;

/// The font of every picture: embedded, so that no font of the system is asked for.
const FONT: &str = "DejaVu Sans";
static FONT_BYTES: &[u8] = include_bytes!("../../assets/DejaVuSans.ttf");

/// Where a text is fixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    /// Left end at the point.
    Left,
    /// Centre at the point.
    Centre,
    /// Right end at the point.
    Right,
}

/// A drawing area whose backend has `scale` dots for each pixel of the picture.
pub(crate) struct Canvas<DB: DrawingBackend> {
    area: DrawingArea<DB, Shift>,
    scale: f64,
    notes: RefCell<Vec<Note>>,
}

/// Words that a reader sees who points at a place.
pub(crate) struct Note {
    /// In pixels.
    pub at: At,
    /// What is there.
    pub words: String,
}

/// Pixels, downwards.
pub(crate) type At = (f64, f64);

impl<DB: DrawingBackend> Canvas<DB> {
    /// A white canvas.
    pub fn new(backend: DB, scale: f64) -> Result<Self, ReportError> {
        use_embedded_font()?;
        let area = backend.into_drawing_area();
        area.fill(&WHITE).map_err(refused)?;
        Ok(Self { area, scale, notes: RefCell::default() })
    }

    /// Hands the picture to the backend.
    pub fn finish(&self) -> Result<(), ReportError> {
        self.area.present().map_err(refused)
    }

    /// Words for who points there; bitmaps have none.
    pub fn note(&self, at: At, words: impl FnOnce() -> String) {
        self.notes.borrow_mut().push(Note { at, words: words() });
    }

    /// The notes so far.
    pub fn notes(&self) -> Vec<Note> {
        self.notes.take()
    }

    /// A broken line, `width` pixels wide; `strength` 0 (invisible) to 1.
    pub fn line(&self, points: &[At], colour: Colour, width: f64, strength: f64) -> Result<(), ReportError> {
        let stroke = (width * self.scale).round().max(1.0) as u32;
        let style = rgb(colour).mix(strength).stroke_width(stroke);
        // One segment at a time: a thick broken line through plotters' polygons spikes at sharp turns.
        for pair in points.windows(2) {
            let ends: Vec<_> = pair.iter().map(|p| self.dot(*p)).collect();
            self.area.draw(&PathElement::new(ends, style)).map_err(refused)?;
        }
        Ok(())
    }

    /// A filled polygon.
    pub fn polygon(&self, points: &[At], colour: Colour, strength: f64) -> Result<(), ReportError> {
        let dots: Vec<_> = points.iter().map(|p| self.dot(*p)).collect();
        let style = rgb(colour).mix(strength).filled();
        self.area.draw(&Polygon::new(dots, style)).map_err(refused)
    }

    /// A mark of `radius` pixels: filled, hollow for a negative number, grey for a level left out.
    pub fn mark(&self, at: At, radius: f64, shape: Shape, colour: Colour, kind: MarkKind) -> Result<(), ReportError> {
        let colour = if kind == MarkKind::Greyed { Colour::Grey } else { colour };
        self.polygon(&outline(at, radius, shape), colour, 1.0)?;
        if kind != MarkKind::Used {
            self.polygon(&outline(at, radius * 0.6, shape), Colour::White, 1.0)?;
        }
        Ok(())
    }

    /// A mark that is open in the middle, so that others can be seen in it; grey for a level left out.
    pub fn ring(&self, at: At, radius: f64, shape: Shape, colour: Colour, kind: MarkKind) -> Result<(), ReportError> {
        let colour = if kind == MarkKind::Greyed { Colour::Grey } else { colour };
        let corners = outline(at, radius, shape);
        let closed: Vec<At> = corners.iter().chain(corners.first()).copied().collect();
        self.line(&closed, colour, 2.0, 1.0)
    }

    /// One line of text, its capitals centred on `at`; what stands in `^{…}` is raised, in `_{…}` lowered.
    pub fn text(&self, text: &str, at: At, anchor: Anchor, size: f64, colour: Colour) -> Result<(), ReportError> {
        let width = self.text_width(text, size)?;
        let mut x = match anchor {
            Anchor::Left => at.0,
            Anchor::Centre => at.0 - 0.5 * width,
            Anchor::Right => at.0 - width,
        };
        for run in runs(text) {
            let (size, raise) = run.size(size);
            self.plain_text(run.text, (x, at.1 - raise), size, colour)?;
            x += self.plain_width(run.text, size)?;
        }
        Ok(())
    }

    fn plain_text(&self, text: &str, at: At, size: f64, colour: Colour) -> Result<(), ReportError> {
        // plotters draws the baseline half a size below the point; capitals reach 0.63 sizes above it.
        let dots = self.dot((at.0, at.1 - 0.19 * size));
        let colour = rgb(colour);
        let style = font(size * self.scale).color(&colour);
        self.area.draw_text(text, &style, dots).map_err(refused)
    }

    /// Pixels that a line of text takes, with its raised parts.
    pub fn text_width(&self, text: &str, size: f64) -> Result<f64, ReportError> {
        let widths = runs(text).into_iter().map(|run| self.plain_width(run.text, run.size(size).0));
        widths.sum()
    }

    fn plain_width(&self, text: &str, size: f64) -> Result<f64, ReportError> {
        let style = font(size * self.scale);
        let (width, _) = self.area.estimate_text_size(text, &style).map_err(refused)?;
        Ok(f64::from(width) / self.scale)
    }

    /// The text in lines of at most `width` pixels, broken at blanks.
    pub fn wrap(&self, text: &str, size: f64, width: f64) -> Result<Vec<String>, ReportError> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            let longer = lines.last().map(|line| format!("{line} {word}"));
            match (longer, lines.last_mut()) {
                (Some(longer), Some(line)) if self.text_width(&longer, size)? <= width => *line = longer,
                _ => lines.push(word.to_string()),
            }
        }
        Ok(lines)
    }

    /// The text cut to `width` pixels, with `…` where something is missing.
    pub fn cut(&self, text: &str, size: f64, width: f64) -> Result<String, ReportError> {
        let mut shown: Vec<char> = text.chars().collect();
        let mut out = text.to_string();
        while !shown.is_empty() && self.text_width(&out, size)? > width {
            shown.pop();
            out = shown.iter().collect::<String>().trim_end().to_string() + "…";
        }
        Ok(out)
    }

    fn dot(&self, at: At) -> (i32, i32) {
        let dot = |x: f64| (x * self.scale).round() as i32;
        (dot(at.0), dot(at.1))
    }
}

/// A part of a line of text.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run<'a> {
    text: &'a str,
    place: Place,
}

/// Where a part of a line stands.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    Line,
    Raised,
    Lowered,
}

impl Run<'_> {
    /// Size of the text and by how many pixels it is raised; negative where lowered.
    fn size(&self, size: f64) -> (f64, f64) {
        match self.place {
            Place::Line => (size, 0.0),
            Place::Raised => (0.72 * size, 0.3 * size),
            Place::Lowered => (0.72 * size, -0.2 * size),
        }
    }
}

/// The line cut at `^{…}` and `_{…}`.
fn runs(line: &str) -> Vec<Run<'_>> {
    let mut runs = Vec::new();
    let mut rest = line;
    while let Some((before, place, inside, after)) = cut(rest) {
        runs.push(Run { text: before, place: Place::Line });
        runs.push(Run { text: inside, place });
        rest = after;
    }
    runs.push(Run { text: rest, place: Place::Line });
    runs
}

/// What stands before the first `^{…}` or `_{…}`, in it and behind it.
fn cut(line: &str) -> Option<(&str, Place, &str, &str)> {
    let found = |mark: &str, place| line.find(mark).map(|at| (at, place));
    let (at, place) =
        [found("^{", Place::Raised), found("_{", Place::Lowered)].into_iter().flatten().min_by_key(|f| f.0)?;
    let (inside, after) = line[at + 2..].split_once('}')?;
    Some((&line[..at], place, inside, after))
}

fn font(size: f64) -> TextStyle<'static> {
    TextStyle::from((FONT, size).into_font())
}

fn rgb(colour: Colour) -> RGBColor {
    let [r, g, b] = colour.rgb();
    RGBColor(r, g, b)
}

/// Corners of a mark; a circle has 32.
fn outline((x, y): At, r: f64, shape: Shape) -> Vec<At> {
    let ring = |n: usize, turn: f64, r: f64| {
        let angle = move |i: usize| turn + std::f64::consts::TAU * i as f64 / n as f64;
        (0..n).map(move |i| (x + r * angle(i).cos(), y + r * angle(i).sin())).collect()
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    match shape {
        Shape::Circle => ring(32, 0.0, r),
        Shape::Square => ring(4, quarter / 2.0, 1.25 * r),
        Shape::Triangle => ring(3, -quarter, 1.3 * r),
        Shape::Diamond => ring(4, 0.0, 1.3 * r),
    }
}

/// Makes the embedded font known to plotters, once.
fn use_embedded_font() -> Result<(), ReportError> {
    static KNOWN: OnceLock<bool> = OnceLock::new();
    let known = KNOWN.get_or_init(|| register_font(FONT, FontStyle::Normal, FONT_BYTES).is_ok());
    if *known { Ok(()) } else { Err(ReportError::Picture("the embedded font cannot be read".into())) }
}

fn refused(error: impl std::fmt::Display) -> ReportError {
    ReportError::Picture(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_cut_out() {
        let parts = |line| runs(line).iter().map(|r| (r.text, r.place)).collect::<Vec<_>>();
        assert_eq!(parts("O(h^{3/4})"), [("O(h", Place::Line), ("3/4", Place::Raised), (")", Place::Line)]);
        assert_eq!(parts("plain"), [("plain", Place::Line)]);
        assert_eq!(parts("open ^{end"), [("open ^{end", Place::Line)]);
        assert_eq!(parts("Γ_{u} left")[..2], [("Γ", Place::Line), ("u", Place::Lowered)]);
    }
}
