//! The triangle that shows a slope in pixels.

use super::frame::Frame;

/// Width asked for, and what the height may be, in pixels.
const WIDTH: f64 = 120.0;
const HIGHEST: f64 = 190.0;
const LOWEST: f64 = 34.0;
const WIDEST: f64 = 200.0;

/// A right triangle, its hypotenuse along the slope: `foot` at the left, the right angle below or above its other end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Triangle {
    /// Pixels to the right.
    pub width: f64,
    /// Pixels upwards; negative for a negative slope.
    pub height: f64,
}

impl Triangle {
    /// The triangle of exponent `s` in the frame: `height/width = s · (pixels per decade of e)/(pixels per decade of h)`.
    pub fn new(exponent: f64, frame: &Frame) -> Self {
        let [per_decade_h, per_decade_e] = frame.pixels_per_decade();
        let steepness = exponent * per_decade_e / per_decade_h;
        let mut width = WIDTH;
        if steepness.abs() * width > HIGHEST {
            width = HIGHEST / steepness.abs();
        } else if steepness != 0.0 && steepness.abs() * width < LOWEST {
            width = (LOWEST / steepness.abs()).min(WIDEST);
        }
        Self { width, height: steepness * width }
    }

    /// The three corners with the box's lower left corner at `(left, bottom)`: start of the hypotenuse, right angle,
    /// end of the hypotenuse. Pixels grow downwards.
    pub fn corners(&self, left: f64, bottom: f64) -> [(f64, f64); 3] {
        let start = bottom + self.height.min(0.0);
        [(left, start), (left + self.width, start), (left + self.width, start - self.height)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::axis::LogRange;
    use super::*;

    fn frame(decades_h: f64, decades_e: f64) -> Frame {
        Frame {
            left: 100.0,
            right: 900.0,
            top: 100.0,
            bottom: 700.0,
            x: LogRange { low: -2.0, high: -2.0 + decades_h },
            y: LogRange { low: -4.0, high: -4.0 + decades_e },
        }
    }

    /// The hypotenuse has to be parallel to the curve e = h^s drawn through the same frame.
    #[test]
    fn hypotenuse_is_parallel_to_the_power() {
        for (decades_h, decades_e) in [(0.3, 0.3), (1.2, 1.2), (1.0, 9.0), (3.0, 0.4)] {
            let frame = frame(decades_h, decades_e);
            for exponent in [0.5, 0.75, 1.0, 1.5, 2.0, -0.5] {
                let [a, _, b] = Triangle::new(exponent, &frame).corners(200.0, 600.0);
                let (p, q) = (frame.at(0.01, 1e-3), frame.at(0.02, 1e-3 * 2f64.powf(exponent)));
                let drawn = (b.1 - a.1) / (b.0 - a.0);
                let curve = (q.1 - p.1) / (q.0 - p.0);
                assert!((drawn - curve).abs() < 1e-9 * curve.abs(), "{exponent}: {drawn} against {curve}");
            }
        }
    }

    #[test]
    fn stays_of_readable_size() {
        for exponent in [0.1, 0.75, 1.0, 2.0, 8.0] {
            let t = Triangle::new(exponent, &frame(1.2, 1.2));
            assert!(t.height <= HIGHEST + 1e-9 && t.width <= WIDEST, "{t:?}");
            assert!(t.height >= 15.0, "{t:?}");
        }
    }
}
