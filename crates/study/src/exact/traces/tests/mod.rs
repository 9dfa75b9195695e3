//! Traces against the built-in P, against formulas in plain numbers, and against what the lemmas promise.

mod formulas;
mod line;
mod promises;
mod refused;

use super::{LineText, TraceTexts, Traces};
use signorini_contact::{Point, material::Lame};
use std::collections::BTreeMap;

const SOFT: Lame = Lame { lambda: 1.5, mu: 1.0 };
const STIFF: Lame = Lame { lambda: 3.0, mu: 2.0 };
const ODD: [Lame; 2] = [Lame { lambda: 7.0, mu: 0.4 }, Lame { lambda: 0.2, mu: 1.3 }];

fn traces(texts: &TraceTexts, parameters: &[(&str, f64)], lame: [Lame; 2]) -> Traces {
    let parameters: BTreeMap<String, f64> = parameters.iter().map(|&(k, v)| (k.to_string(), v)).collect();
    Traces::parse(texts, &parameters, lame).unwrap_or_else(|e| panic!("{e}"))
}

/// P(3, 2): `g = (x−s)_+³`, `p = −6 (s−x)_+²`.
const P: TraceTexts = TraceTexts {
    line: LineText::Straight,
    w: ["cos(2*x)/20 + 0.6*pos(x - s)^3", "cos(2*x)/20 - 0.4*pos(x - s)^3"],
    a: ["sin(2*x)/10", "-x^2/20"],
    p: "-6*pos(s - x)^2",
    cutoff: Some(["1 - y", "1 + y"]),
};

const UNIT_CIRCLE: LineText = LineText::Arc { centre: Point::new(0.0, 0.0), radius: 1.0, middle: 0.0 };

/// `g = (θ−0.9)_+³`, `p = −4 (0.9−θ)_+²` on the unit circle, `Ω'` inside, clamped on `x + y = 1/2`, `Ω''` on `x = 2`, `y = 2`.
const ARC: TraceTexts = TraceTexts {
    line: UNIT_CIRCLE,
    w: ["cos(2*theta)/20 - 0.6*pos(theta - 0.9)^3", "cos(2*theta)/20 + 0.4*pos(theta - 0.9)^3"],
    a: ["sin(2*theta + 1)/5", "-theta^2/10"],
    p: "-4*pos(0.9 - theta)^2",
    cutoff: Some(["x + y - 1/2", "(2 - x)*(2 - y)"]),
};

/// Contact for `η ∈ [−c_1, c_2]` between two graphs, clamped on `x = ±2`. `W = ε − g`.
const GRAPH: TraceTexts = TraceTexts {
    line: LineText::Graph { f: ["eta^2/4 + eta^3/20", "-3*eta^2/20"] },
    w: [
        "cos(2*eta)/20 - (2*eta^2/5 + eta^3/20 - pos(-c1 - eta)^3 - pos(eta - c2)^3)/2",
        "cos(2*eta)/20 + (2*eta^2/5 + eta^3/20 - pos(-c1 - eta)^3 - pos(eta - c2)^3)/2",
    ],
    a: ["sin(2*eta)/10", "-eta^2/20"],
    p: "-12*pos((eta + c1)*(c2 - eta))^2",
    cutoff: Some(["2 - x", "2 + x"]),
};

/// `1/√5` and `1/√3`.
fn ends() -> [(&'static str, f64); 2] {
    [("c1", 1.0 / 5.0f64.sqrt()), ("c2", 1.0 / 3.0f64.sqrt())]
}
