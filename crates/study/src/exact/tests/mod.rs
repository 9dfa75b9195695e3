//! Every built-in solution against its closed forms, against differences, and against broken twins.

mod closed_forms;
mod curved;
mod curved_formulas;
mod derivatives;
mod green;
mod names;
mod rejected;
mod tied;

use super::{Exact, GapShape, arc, built_in};
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

/// The solutions on the arc and on the graphs.
const ON_CURVES: [(&str, &[(&str, f64)]); 10] = [
    ("arcP", &[]),
    ("arcR", &[("alpha", 0.4)]),
    ("arcR", &[("alpha", 1.0)]),
    ("arcR", &[("alpha", 1.5)]),
    ("graphP", &[]),
    ("graphP", &[("gap", 1.0)]),
    ("graphP", &[("gap", 2.0)]),
    ("graphR", &[("alpha", 0.4)]),
    ("graphR", &[("alpha", 1.05), ("gap", 1.0)]),
    ("graphR", &[("alpha", 1.5), ("gap", 2.0)]),
];

/// The shape of the gap that the parameters ask for.
fn shape(list: &[(&str, f64)]) -> GapShape {
    let gap = list.iter().find(|(name, _)| *name == "gap").map_or(0.0, |p| p.1);
    GapShape::from_parameter(gap).unwrap()
}

/// The contact zone of a solution of [`ON_CURVES`].
fn zone(name: &str, list: &[(&str, f64)]) -> ContactLine {
    if name.starts_with("arc") { arc::contact_line() } else { shape(list).contact_line() }
}

/// `(t)_+^n`; zero for `t ≤ 0` even for `n ≤ 0`.
fn positive(t: f64, n: f64) -> f64 {
    if t > 0.0 { t.powf(n) } else { 0.0 }
}

/// Gap and contact force of a solution of [`ON_CURVES`] at the parameter `s` of its zone, the angle or the height.
fn gap_and_force(name: &str, list: &[(&str, f64)], s: f64) -> (f64, f64) {
    let alpha = list.iter().find(|(name, _)| *name == "alpha").map_or(f64::NAN, |p| p.1);
    let (low, high) = (-1.0 / 5.0f64.sqrt(), 1.0 / 3.0f64.sqrt());
    match name {
        "arcP" => (positive(s - 0.9, 3.0), -4.0 * positive(0.9 - s, 2.0)),
        "arcR" => (0.4 * positive(s - 0.9, alpha), -2.0 * positive(0.9 - s, alpha - 1.0)),
        "graphP" => {
            (positive(low - s, 3.0) + positive(s - high, 3.0), -12.0 * positive(s - low, 2.0) * positive(high - s, 2.0))
        }
        _ => (0.4 * positive(s - high, alpha), -2.0 * positive(high - s, alpha - 1.0)),
    }
}
