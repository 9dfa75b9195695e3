//! The corners of a scene and the exponents of the solution there.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A point where the boundary of a body turns, its condition changes, or the contact zone ends, with the local exponents
/// `λ` of `u ~ r^λ`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Corner {
    /// Where; across a gap, the point of `Ω'`.
    pub point: [f64; 2],
    /// One entry for each body that has its boundary there.
    pub wedges: Vec<CornerWedge>,
    /// What the contact may do there; one state without a name away from the zone.
    pub states: Vec<CornerState>,
    /// Index of the state that the discrete solution takes there; `None` where it does not tell, or nothing is solved.
    pub governing: Option<usize>,
}

/// One body near a corner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CornerWedge {
    /// Name of the body.
    pub body: String,
    /// Inner angle in degrees.
    pub angle: f64,
    /// Conditions on the two sides, counterclockwise around the point: `clamped`, `free`, `sliding` or `contact`.
    pub faces: [String; 2],
}

/// One state of the contact at a corner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CornerState {
    /// `open` or `closed` for each ray of contact from the corner, in the order of the zone; empty away from the zone.
    pub rays: Vec<RayState>,
    /// The smallest `Re λ` below 1; `None` where there is none, so that the corner does not limit the rate.
    pub exponent: Option<f64>,
    /// `Im λ` of that exponent, not zero where the solution oscillates.
    pub oscillation: Option<f64>,
    /// The smallest `Re λ` that was passed over because its mode would pull on a ray that is closed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulling: Option<f64>,
}

/// Whether the bodies touch along a ray from a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RayState {
    /// Apart: both faces are free.
    Open,
    /// In contact.
    Closed,
}

impl RayState {
    /// `open` or `closed`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Closed => "closed",
        }
    }
}

impl CornerState {
    /// The rate that this state allows in the strain, energy and `H¹` norms, `min(1, Re λ)`.
    pub fn rate(&self) -> f64 {
        self.exponent.map_or(1.0, |l| l.min(1.0))
    }
}

impl Corner {
    /// The rate that the corner allows: that of the governing state, else the smallest.
    pub fn rate(&self) -> f64 {
        match self.governing.and_then(|i| self.states.get(i)) {
            Some(state) => state.rate(),
            None => self.states.iter().map(CornerState::rate).fold(1.0, f64::min),
        }
    }

    /// The bodies, their angles and the conditions on their faces, in words.
    pub fn describe(&self) -> String {
        let wedge = |w: &CornerWedge| format!("{} {} {}–{}", w.body, degrees(w.angle), w.faces[0], w.faces[1]);
        self.wedges.iter().map(wedge).collect::<Vec<_>>().join(", ")
    }

    /// The states with their exponents, in words; the governing one is marked by an arrow.
    pub fn describe_states(&self) -> String {
        let words = |(i, s): (usize, &CornerState)| {
            let rays: Vec<&str> = s.rays.iter().map(|r| r.word()).collect();
            let name = if rays.is_empty() { String::new() } else { format!("{} ", rays.join("–")) };
            let mark = if self.governing == Some(i) && self.states.len() > 1 { "→ " } else { "" };
            format!("{mark}{name}{}", exponent(s))
        };
        self.states.iter().enumerate().map(words).collect::<Vec<_>>().join(", ")
    }
}

/// The rate that all corners together allow, `min(1, Re λ)`.
pub fn corner_rate(corners: &[Corner]) -> f64 {
    corners.iter().map(Corner::rate).fold(1.0, f64::min)
}

fn degrees(angle: f64) -> String {
    let rounded = (10.0 * angle).round() / 10.0;
    format!("{rounded}°")
}

fn exponent(state: &CornerState) -> String {
    let own = match (state.exponent, state.oscillation) {
        (None, _) => "none below 1".into(),
        (Some(re), Some(im)) => format!("{re:.4} ± {im:.4}i"),
        (Some(re), None) => format!("{re:.4}"),
    };
    own + &state.pulling.map_or_else(String::new, |l| format!(" ({l:.4} would pull)"))
}
