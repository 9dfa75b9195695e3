//! The rectangle of a chart and the map from values to pixels.

use super::axis::LogRange;

/// Pixels of the four sides (downwards), and what they stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    /// Left side.
    pub left: f64,
    /// Right side.
    pub right: f64,
    /// Upper side.
    pub top: f64,
    /// Lower side.
    pub bottom: f64,
    /// Mesh sizes from left to right.
    pub x: LogRange,
    /// Values from bottom to top.
    pub y: LogRange,
}

impl Frame {
    /// Pixel of mesh size `h` and value `e`.
    pub fn at(&self, h: f64, e: f64) -> (f64, f64) {
        (self.left + self.x.share(h) * self.width(), self.bottom - self.y.share(e) * self.height())
    }

    /// Pixels per decade of `h` and of `e`.
    pub fn pixels_per_decade(&self) -> [f64; 2] {
        [self.width() / self.x.decades(), self.height() / self.y.decades()]
    }

    /// Pixels from left to right.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Pixels from bottom to top.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }
}
