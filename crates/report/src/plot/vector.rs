//! SVG text as a drawing backend: neighbours of the same colour become one path, text stays text.
//!
//! Colours of the palette are classes, `c-ink`, `c-blue`, …, and stand beside them as plain attributes; strokes and fills are
//! `currentColor`. So a page that inlines a picture recolours it by one rule for each class, `.plot .c-ink { color: … }`, and a file by itself is
//! seen as it is. There are no ids that two pictures on a page could share.

use super::canvas::Note;
use super::chart::Colour;
use plotters::prelude::DrawingBackend;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};
use std::convert::Infallible;
use std::fmt::Write;

/// Dots of the drawing for each pixel of the picture.
pub(crate) const DOTS: u32 = 10;
/// Size of a text in plotters' unit over its em: ascent and descent of the embedded font.
const SIZE_OVER_EM: f64 = 1.164;

/// How a path is painted. Fills have no width.
#[derive(Clone, Copy, PartialEq)]
struct Paint {
    rgb: (u8, u8, u8),
    alpha: f64,
    width: Option<u32>,
}

/// Writes a picture into a string.
pub(crate) struct Vector<'a> {
    text: &'a mut String,
    size: (u32, u32),
    paint: Option<Paint>,
    path: String,
    /// Where the last path ended.
    pen: Option<BackendCoord>,
    done: bool,
}

impl<'a> Vector<'a> {
    /// A picture of `size` pixels, with what it shows in words for who cannot see it.
    pub fn new(text: &'a mut String, size: (u32, u32), words: &str) -> Self {
        let (width, height) = size;
        let words = escaped(words);
        // writing into a string does not fail
        let _ = writeln!(
            text,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{words}\" stroke-linejoin=\"round\" \
             font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<title>{words}</title>",
            width * DOTS,
            height * DOTS
        );
        Self { text, size, paint: None, path: String::new(), pen: None, done: false }
    }

    /// Continues the path of the same paint, or begins another.
    fn with(&mut self, paint: Paint) {
        if self.paint != Some(paint) {
            self.flush();
            self.paint = Some(paint);
        }
    }

    /// Writes the path that was collected.
    fn flush(&mut self) {
        if let Some(paint) = self.paint.take() {
            let path = std::mem::take(&mut self.path);
            let how = match paint.width {
                None => format!("fill=\"currentColor\"{}", self.overlap(paint)),
                Some(width) => format!("fill=\"none\" stroke=\"currentColor\" stroke-width=\"{width}\""),
            };
            let _ = writeln!(self.text, "<path {}{} {how} d=\"{path}\"/>", colour(paint.rgb), opacity(paint.alpha));
        }
        self.pen = None;
    }

    /// Shades lie side by side: a hair's breadth of their own colour about them hides the seams.
    fn overlap(&self, paint: Paint) -> String {
        if class(paint.rgb).is_some() { String::new() } else { " stroke=\"currentColor\" stroke-width=\"6\"".into() }
    }

    /// Appends corners, relative to one another.
    fn corners(&mut self, points: impl IntoIterator<Item = BackendCoord>, close: bool) {
        let mut last = None;
        for (x, y) in points {
            let _ = match last {
                None if self.pen == Some((x, y)) && !close => Ok(()),
                None => write!(self.path, "M{x} {y}"),
                Some((a, b)) if (a, b) == (x, y) => Ok(()),
                Some((a, b)) => write!(self.path, "l{}{}{}", x - a, if y < b { "" } else { " " }, y - b),
            };
            last = Some((x, y));
        }
        if close {
            self.path.push('z');
        }
        self.pen = last.filter(|_| !close);
    }
}

/// `class="c-ink" color="#141414"`; shades of a scale have no class.
fn colour((r, g, b): (u8, u8, u8)) -> String {
    let class = class((r, g, b)).map_or_else(String::new, |name| format!("class=\"c-{name}\" "));
    format!("{class}color=\"#{r:02x}{g:02x}{b:02x}\"")
}

fn class((r, g, b): (u8, u8, u8)) -> Option<&'static str> {
    Colour::PALETTE.iter().find(|(_, c)| c.rgb() == [r, g, b]).map(|(name, _)| *name)
}

fn opacity(alpha: f64) -> String {
    if alpha < 1.0 { format!(" opacity=\"{alpha}\"") } else { String::new() }
}

/// The text as XML wants it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

type Outcome = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Vector<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.size.0 * DOTS, self.size.1 * DOTS)
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        if !self.done {
            self.done = true;
            self.flush();
            self.text.push_str("</svg>\n");
        }
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Outcome {
        self.fill_polygon([(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)], &color)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Outcome {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, style: &S, fill: bool) -> Outcome {
        let corners = [a, (b.0, a.1), b, (a.0, b.1)];
        if fill { self.fill_polygon(corners, style) } else { self.draw_path(corners.into_iter().chain([a]), style) }
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Outcome {
        let BackendColor { rgb, alpha } = style.color();
        self.with(Paint { rgb, alpha, width: Some(style.stroke_width()) });
        self.corners(path, false);
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Outcome {
        let BackendColor { rgb, alpha } = style.color();
        self.with(Paint { rgb, alpha, width: None });
        self.corners(corners, true);
        Ok(())
    }

    /// The text takes the width that it has in the embedded font, whatever font the viewer has.
    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, (x, y): BackendCoord) -> Outcome {
        if text.trim().is_empty() {
            return Ok(());
        }
        self.flush();
        let (width, _) = self.estimate_text_size(text, style)?;
        let BackendColor { rgb, alpha } = style.color();
        let (size, baseline) = (style.size() / SIZE_OVER_EM, f64::from(y) + 0.5 * style.size());
        let _ = writeln!(
            self.text,
            "<text {}{} fill=\"currentColor\" x=\"{x}\" y=\"{baseline:.0}\" font-size=\"{size:.0}\" \
             textLength=\"{width}\" lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\">{}</text>",
            colour(rgb),
            opacity(alpha),
            escaped(text)
        );
        Ok(())
    }
}

/// Radius of the place that shows a note, in dots.
const REACH: u32 = 14 * DOTS;

/// Lays a place to point at over each of the notes of a finished picture.
pub(crate) fn annotate(text: &mut String, notes: &[Note]) {
    let Some(end) = text.rfind("</svg>").filter(|_| !notes.is_empty()) else { return };
    text.truncate(end);
    text.push_str("<g class=\"notes\" fill-opacity=\"0\">\n");
    for Note { at: (x, y), words } in notes {
        let (x, y) = (x * f64::from(DOTS), y * f64::from(DOTS));
        let words = escaped(words);
        let _ = writeln!(text, "<circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"{REACH}\"><title>{words}</title></circle>");
    }
    text.push_str("</g>\n</svg>\n");
}
