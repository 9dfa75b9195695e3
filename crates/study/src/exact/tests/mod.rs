//! Every built-in solution against its closed forms, against differences, and against broken twins.

mod closed_forms;
mod derivatives;
mod names;
mod rejected;

use super::{Exact, built_in};
use signorini_contact::{ContactLine, Material, Point, material::Lame};
use std::collections::BTreeMap;
use std::sync::Arc;

const SOFT: Lame = Lame { lambda: 1.5, mu: 1.0 };
const STIFF: Lame = Lame { lambda: 3.0, mu: 2.0 };
/// The usual pair, the same swapped, and two unrelated Poisson's ratios.
const PAIRS: [[Lame; 2]; 3] =
    [[SOFT, STIFF], [STIFF, SOFT], [Lame { lambda: 7.0, mu: 0.4 }, Lame { lambda: 0.2, mu: 1.3 }]];

fn parameters(list: &[(&str, f64)]) -> BTreeMap<String, f64> {
    list.iter().map(|&(k, v)| (k.to_string(), v)).collect()
}

fn made(name: &str, list: &[(&str, f64)], lame: [Lame; 2]) -> Arc<dyn Exact> {
    built_in(name, &parameters(list), lame).unwrap_or_else(|e| panic!("{e}"))
}

fn materials(lame: [Lame; 2]) -> [Material; 2] {
    lame.map(|l| Material::lame(l.lambda, l.mu).unwrap())
}

/// The solutions on two unit squares.
const ON_SQUARES: [(&str, &[(&str, f64)]); 14] = [
    ("P", &[]),
    ("P", &[("k", 4.0), ("m", 3.0)]),
    ("P", &[("k", 2.6), ("m", 1.6)]),
    ("W", &[]),
    ("R", &[("alpha", 0.4)]),
    ("R", &[("alpha", 0.75)]),
    ("R", &[("alpha", 1.0)]),
    ("R", &[("alpha", 1.5)]),
    ("R", &[("alpha", 1.9)]),
    ("many-switches", &[("cells", 1.0)]),
    ("many-switches", &[("cells", 7.0)]),
    ("tiles", &[]),
    ("tiles", &[("beta", 0.6), ("smallest", 0.01)]),
    ("tiles", &[("beta", 0.0), ("power", 1.5), ("tiles", 4.0)]),
];

/// The line `y = 0` with `Ω'` on its left.
fn line() -> ContactLine {
    ContactLine::polyline([Point::new(0.0, 0.0), Point::new(1.0, 0.0)])
}

/// Contact polylines of the two patches.
fn corner(patch: u32) -> ContactLine {
    let (left, right) = if patch == 1 { (0.2, 0.5) } else { (1.0, 1.0) };
    ContactLine::polyline([Point::new(-1.0, left), Point::new(0.0, 0.0), Point::new(1.0, right)])
}
