//! Random traces on a contact line: who presses where, how hard, and how far the rest gapes.
//!
//! ```text
//!  p ≤ 0   ╲   pressed    ╱ open ╲  pressed  ╱
//!           ‾‾‾──____──‾‾‾       ‾‾──____──‾‾        on each piece a power of a bubble that vanishes at its switch points
//!  g ≥ 0                  ╱‾‾╲
//! ```
//!
//! The powers are whole numbers, from 2 for the pressure and from 3 for the gap: `u ∈ H^{5/2−δ}`. Fractional ones would make the
//! continued displacement singular along whole lines, where quadrature is costly; rough solutions are drawn from the built-in ones.

use super::super::dice::{Dice, rounded};

/// `amplitude · cos(frequency · x + phase)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Wave {
    /// Amplitude; 0: no wave.
    pub amplitude: f64,
    /// Radians per length of the zone.
    pub frequency: f64,
    /// Radians.
    pub phase: f64,
}

impl Wave {
    /// No wave.
    pub const NONE: Self = Self { amplitude: 0.0, frequency: 0.0, phase: 0.0 };

    fn draw(dice: &mut Dice) -> Self {
        let sign = if dice.coin() { 1.0 } else { -1.0 };
        Self {
            amplitude: sign * dice.decades(-2.0, -0.5),
            frequency: dice.between(0.5, 5.0),
            phase: dice.between(0.0, 6.2),
        }
    }

    /// The wave over a zone of that length, in the parameter called `name`.
    fn text(&self, name: &str, length: f64) -> String {
        if self.amplitude == 0.0 {
            return "0".into();
        }
        let frequency = rounded(self.frequency / length, 3);
        format!("{}*cos({frequency}*{name} + {})", self.amplitude, self.phase)
    }
}

/// What happens between two neighbouring switch points.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Pressure in units of the smaller shear modulus, or gap, that the bubble has where it is 1.
    pub amplitude: f64,
    /// Power of the bubble.
    pub exponent: f64,
}

/// Traces of a displacement with contact on every other piece of the zone.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceDraw {
    /// Switch points as shares of the zone, rising.
    pub switches: Vec<f64>,
    /// One more than switch points.
    pub pieces: Vec<Piece>,
    /// Whether the first piece is pressed.
    pub pressed_first: bool,
    /// The displacement across the line that both bodies have in common.
    pub common: Wave,
    /// The displacements along it.
    pub slips: [Wave; 2],
    /// Share of the gap that `Ω'` makes.
    pub share: f64,
}

/// Neighbouring switch points, and the ends of the zone, are at least this share of the zone apart.
const APART: f64 = 0.12;

impl TraceDraw {
    /// With `least` to `most` switch points.
    pub(in crate::falsify) fn draw(dice: &mut Dice, least: usize, most: usize) -> Self {
        let count = least + dice.below(most - least + 1);
        let pressed_first = dice.coin();
        let pieces = (0..=count).map(|k| piece(dice, k.is_multiple_of(2) == pressed_first)).collect();
        Self {
            switches: switches(dice, count),
            pieces,
            pressed_first,
            common: Wave::draw(dice),
            slips: [Wave::draw(dice), Wave::draw(dice)],
            share: dice.between(0.0, 1.0),
        }
    }

    /// Whether piece `k` is in contact.
    pub fn is_pressed(&self, k: usize) -> bool {
        k.is_multiple_of(2) == self.pressed_first
    }

    /// The largest `‖T_n‖_∞` and `|[u]_n|_{1,∞}` in closed form: amplitude, and amplitude times the steepest slope of the bubble.
    /// `unit` is the stress of a unit of pressure, `length` that of the zone.
    pub fn bounds(&self, unit: f64, length: f64) -> [f64; 2] {
        let mut bounds = [0.0_f64; 2];
        for (k, piece) in self.pieces.iter().enumerate() {
            if self.is_pressed(k) {
                bounds[0] = bounds[0].max(piece.amplitude * self.height(k) * unit);
            } else {
                let slope = steepest(piece.exponent, self.is_inner(k)) / (self.length(k) * length);
                bounds[1] = bounds[1].max(piece.amplitude * self.height(k) * slope);
            }
        }
        bounds
    }

    fn is_inner(&self, k: usize) -> bool {
        k > 0 && k < self.switches.len()
    }

    /// Of piece `k`, as a share of the zone.
    fn length(&self, k: usize) -> f64 {
        let left = if k == 0 { 0.0 } else { self.switches[k - 1] };
        self.switches.get(k).copied().unwrap_or(1.0) - left
    }

    /// The largest value of the bubble of piece `k` to its power.
    fn height(&self, k: usize) -> f64 {
        let share = self.length(k);
        (if self.is_inner(k) { 0.5 * share } else { share }).powf(self.pieces[k].exponent)
    }
}

/// The largest derivative of the bubble to the power `m`, with the largest value 1, on an interval of length 1: `(4t(1−t))^m` between
/// two switch points, `t^m` beside one.
fn steepest(m: f64, inner: bool) -> f64 {
    if !inner {
        return m;
    }
    // d/dt q^m with q = 1 − (2t−1)²; at (2t−1)² = s: 4m √s (1−s)^{m−1}, largest at s = 1/(2m−1)
    let s = 1.0 / (2.0 * m - 1.0);
    4.0 * m * s.sqrt() * (1.0 - s).powf(m - 1.0)
}

fn piece(dice: &mut Dice, pressed: bool) -> Piece {
    if pressed {
        Piece { amplitude: dice.decades(-0.5, 1.0), exponent: dice.pick(&[2.0, 2.0, 3.0]) }
    } else {
        Piece { amplitude: dice.decades(-1.0, 0.5), exponent: dice.pick(&[3.0, 3.0, 4.0]) }
    }
}

fn switches(dice: &mut Dice, count: usize) -> Vec<f64> {
    // the free length between points that keep their distance, cut at random
    let free = 1.0 - APART * (count + 1) as f64;
    let mut cuts: Vec<f64> = (0..count).map(|_| dice.between(0.0, 1.0)).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.iter().enumerate().map(|(k, c)| rounded(free * c + APART * (k + 1) as f64, 3)).collect()
}

/// A component from the common part, the gap, and the shares of `Ω'` and `Ω''` in it.
type Across = fn(&str, &str, f64, f64) -> String;

/// The interval of the parameter, its name, and the sign and form of the gap.
pub struct Place<'a> {
    /// Name of the parameter.
    pub name: &'a str,
    /// From.
    pub from: f64,
    /// To.
    pub to: f64,
    /// What `w'` is, given the common part, the gap, and the shares of `Ω'` and `Ω''` in it; then `w''`.
    pub across: [Across; 2],
    /// The stress of a unit of pressure.
    pub unit: f64,
}

/// The expressions of `[exact.traces]`.
pub struct TraceLines {
    /// `w`, `a` of both bodies.
    pub w: [String; 2],
    /// Along the line.
    pub a: [String; 2],
    /// The stress.
    pub p: String,
    /// The switch points.
    pub switches: Vec<f64>,
}

impl TraceDraw {
    /// As expressions on a line.
    pub fn lines(&self, place: &Place) -> TraceLines {
        let length = place.to - place.from;
        let switches: Vec<f64> = self.switches.iter().map(|s| rounded(place.from + s * length, 5)).collect();
        let gather = |pressed: bool, unit: f64| {
            let terms: Vec<String> = (0..self.pieces.len())
                .filter(|&k| self.is_pressed(k) == pressed)
                .map(|k| {
                    bubble(
                        &self.pieces[k],
                        place,
                        k.checked_sub(1).map(|k| switches[k]),
                        switches.get(k).copied(),
                        unit,
                    )
                })
                .collect();
            if terms.is_empty() { "0".into() } else { terms.join(" + ") }
        };
        let (gap, pressure) = (gather(false, 1.0), gather(true, place.unit));
        let common = self.common.text(place.name, length);
        let shares = [self.share, rounded(1.0 - self.share, 3)];
        TraceLines {
            w: place.across.map(|across| across(&common, &gap, shares[0], shares[1])),
            a: self.slips.each_ref().map(|wave| wave.text(place.name, length)),
            p: if pressure == "0" { pressure } else { format!("-({pressure})") },
            switches,
        }
    }
}

/// `A · bubble^m`: `(x − l)(r − x) / (½ (r − l) |Γ_K|)` between two switch points, the distance from it over `|Γ_K|` beside one. A
/// short piece is then as smooth as a long one, and weaker: it does not govern `‖u‖_2`.
fn bubble(piece: &Piece, place: &Place, left: Option<f64>, right: Option<f64>, unit: f64) -> String {
    let x = place.name;
    let amplitude = rounded(piece.amplitude * unit, 3);
    let length = rounded(place.to - place.from, 5);
    match (left, right) {
        (None, None) => format!("{amplitude}"),
        (None, Some(r)) => format!("{amplitude}*(pos({r} - {x})/{length})^{}", piece.exponent),
        (Some(l), None) => format!("{amplitude}*(pos({x} - {l})/{length})^{}", piece.exponent),
        (Some(l), Some(r)) => {
            let scale = rounded(0.5 * (r - l) * length, 5);
            format!("{amplitude}*(pos({x} - {l})*pos({r} - {x})/{scale})^{}", piece.exponent)
        }
    }
}
