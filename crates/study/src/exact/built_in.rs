//! The built-in solutions by name.

use super::parameters::{Parameter, Values};
use super::{
    ArcPolynomial, ArcPowerLaw, CornerPatch, Exact, GapShape, GraphPolynomial, GraphPowerLaw, ManySwitches, Natural,
    Polynomial, PowerLaw, Slanted, Slide, Tiles,
};
use crate::nearest::nearest;
use signorini_contact::material::Lame;
use std::collections::BTreeMap;
use std::sync::Arc;

type Built = Result<Arc<dyn Exact>, String>;

/// A built-in solution as the documentation lists it.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// Its name in study files.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// Its parameters.
    pub parameters: &'static [Parameter],
    /// Its Sobolev order in words: `u ∈ H^{s−δ}` on each body.
    pub regularity: &'static str,
    sobolev: fn(&Values) -> Option<f64>,
    build: fn(&Values, [Lame; 2]) -> Built,
}

/// Every built-in solution. Those of the arc and of the graphs live on the bodies that [`super::arc`] and
/// [`super::graph`] draw; all others but the patches and `bilateral` on `Ω' = (0,1)×(0,1)`, `Ω'' = (0,1)×(−1,0)` with contact on
/// `y = 0`, and they vanish on `y = ±1`; of `slide` only the normal component does on `y = −1`.
pub const BUILT_INS: &[BuiltIn] = &[
    BuiltIn {
        name: "P",
        about: "gap (x−s)^k and pressure 6 (s−x)^m on the two sides of one switch point s = 1/√6",
        parameters: &[
            Parameter { name: "k", meaning: "exponent of the gap, 2 < k ≤ 12", default: Some(3.0) },
            Parameter { name: "m", meaning: "exponent of the pressure, 1 < m ≤ 12", default: Some(2.0) },
        ],
        regularity: "s = min(k, m+1) − 1/2",
        sobolev: |v| Some(v.optional("k")?.min(v.optional("m")? + 1.0) - 0.5),
        build: |v, lame| Ok(Arc::new(Polynomial::new(v.get("k")?, v.get("m")?, lame)?)),
    },
    BuiltIn {
        name: "W",
        about: "the natural singularity of one switch point: gap ~ (x−s)^{3/2}, pressure (s−x)^{1/2}",
        parameters: &[],
        regularity: "s = 5/2",
        sobolev: |_| Some(2.5),
        build: |_, lame| Ok(Arc::new(Natural::new(lame))),
    },
    BuiltIn {
        name: "R",
        about: "one switch point of chosen regularity: gap 0.4 (x−s)^α, pressure 2 (s−x)^{α−1}",
        parameters: &[ALPHA],
        regularity: "s = 1 + alpha",
        sobolev: |v| Some(1.0 + v.optional("alpha")?),
        build: |v, lame| Ok(Arc::new(PowerLaw::new(v.get("alpha")?, lame)?)),
    },
    BuiltIn {
        name: "many-switches",
        about: "N cells with two switch points each, |u|_2 independent of N",
        parameters: &[Parameter {
            name: "cells",
            meaning: "number N of cells, 1 ≤ cells ≤ 4096, whole",
            default: Some(8.0),
        }],
        regularity: "s = 5/2",
        sobolev: |_| Some(2.5),
        build: |v, lame| Ok(Arc::new(ManySwitches::new(v.get("cells")?, lame)?)),
    },
    BuiltIn {
        name: "tiles",
        about: "shrinking cells of width d_j = 2^{−j}/4: switch points accumulate at 1/√6",
        parameters: &[
            Parameter { name: "beta", meaning: "decay (j+1)^{−beta}, 0 ≤ beta ≤ 4", default: Some(1.0) },
            Parameter { name: "power", meaning: "power of d_j, 1/2 < power ≤ 2", default: Some(1.0) },
            Parameter {
                name: "tiles",
                meaning: "number of tiles kept, 1 ≤ tiles ≤ 24, whole; give it or smallest, else 12",
                default: None,
            },
            Parameter {
                name: "smallest",
                meaning: "keep tiles up to the first with d_j < smallest/8, the smallest mesh size; 1e-6 ≤ smallest ≤ 1",
                default: None,
            },
        ],
        regularity: "s = min(1 + power, 5/2); for power = 1 in H² itself iff beta > 1/2 (of the whole sum)",
        sobolev: |v| Some((1.0 + v.optional("power")?).min(2.5)),
        build: tiles,
    },
    BuiltIn {
        name: "corner-patch-1",
        about: "τ = −I; contact line y = −0.2x for x < 0, y = 0.5x for x > 0 (any line through the origin will do)",
        parameters: &[],
        regularity: "linear in each body",
        sobolev: |_| None,
        build: |_, lame| Ok(Arc::new(CornerPatch::first(lame))),
    },
    BuiltIn {
        name: "corner-patch-2",
        about: "pressure 3 for x < 0, 1 for x > 0 on the contact line y = |x|",
        parameters: &[],
        regularity: "linear in each body",
        sobolev: |_| None,
        build: |_, lame| Ok(Arc::new(CornerPatch::second(lame))),
    },
    BuiltIn {
        name: "arcP",
        about: "gap (θ−0.9)^3 and pressure 4 (0.9−θ)^2 on the quarter of the unit circle",
        parameters: &[],
        regularity: "s = 5/2",
        sobolev: |_| Some(2.5),
        build: |_, lame| Ok(Arc::new(ArcPolynomial::new(lame))),
    },
    BuiltIn {
        name: "arcR",
        about: "gap 0.4 (θ−0.9)^α and pressure 2 (0.9−θ)^{α−1} on the quarter of the unit circle",
        parameters: &[ALPHA],
        regularity: "s = 1 + alpha",
        sobolev: |v| Some(1.0 + v.optional("alpha")?),
        build: |v, lame| Ok(Arc::new(ArcPowerLaw::new(v.get("alpha")?, lame)?)),
    },
    BuiltIn {
        name: "graphP",
        about: "contact for −1/√5 ≤ y ≤ 1/√3 between the graphs x = f'(y) and x = f''(y), powers 3 and 2 at its ends",
        parameters: &[SHAPE],
        regularity: "s = 5/2",
        sobolev: |_| Some(2.5),
        build: |v, lame| Ok(Arc::new(GraphPolynomial::new(GapShape::from_parameter(v.get("gap")?)?, lame))),
    },
    BuiltIn {
        name: "graphR",
        about: "gap 0.4 (y−c)^α and pressure 2 (c−y)^{α−1}, c = 1/√3, between the graphs x = f'(y) and x = f''(y)",
        parameters: &[ALPHA, SHAPE],
        regularity: "s = 1 + alpha",
        sobolev: |v| Some(1.0 + v.optional("alpha")?),
        build: |v, lame| {
            Ok(Arc::new(GraphPowerLaw::new(v.get("alpha")?, GapShape::from_parameter(v.get("gap")?)?, lame)?))
        },
    },
    BuiltIn {
        name: "slide",
        about: "P(3, 2) with Ω'' on a smooth floor y = −1, where it may slide; ∫ u_1 = slide there",
        parameters: &[Parameter {
            name: "slide",
            meaning: "constant slide added to u_1 of Ω'': another solution for the same load, −10 ≤ slide ≤ 10",
            default: Some(0.0),
        }],
        regularity: "s = 5/2",
        sobolev: |_| Some(2.5),
        build: |v, lame| Ok(Arc::new(Slide::new(v.get("slide")?, lame)?)),
    },
    BuiltIn {
        name: "bilateral",
        about: "contact line y = 0.3x, tied for x < 1/4 with tension there; Ω'' on a smooth floor y = −1",
        parameters: &[],
        regularity: "s = 5/2",
        sobolev: |_| Some(2.5),
        build: |_, lame| Ok(Arc::new(Slanted::new(lame))),
    },
];

const ALPHA: Parameter = Parameter { name: "alpha", meaning: "exponent of the gap, 0 < alpha < 2", default: None };

const SHAPE: Parameter = Parameter {
    name: "gap",
    meaning: "shape of the initial gap: 0 convex, 1 concave, 2 of both signs of curvature",
    default: Some(0.0),
};

/// The built-in solution `name` for the Lamé constants of `Ω'`, `Ω''`.
///
/// # Errors
/// An unknown name or parameter, a missing value, or one outside its range; the message lists what is allowed.
pub fn built_in(name: &str, parameters: &BTreeMap<String, f64>, lame: [Lame; 2]) -> Result<Arc<dyn Exact>, String> {
    let entry = find(name)?;
    let told = |message: String| format!("exact solution {name}: {message}");
    let values = Values::new(entry.parameters, parameters).map_err(told)?;
    (entry.build)(&values, lame).map_err(told)
}

/// The Sobolev order `s` of a built-in solution, `u ∈ H^{s−δ}`; `None` if it is linear in each body.
///
/// # Errors
/// An unknown name or parameter.
pub fn sobolev_order(name: &str, parameters: &BTreeMap<String, f64>) -> Result<Option<f64>, String> {
    let entry = find(name)?;
    Ok((entry.sobolev)(&Values::new(entry.parameters, parameters)?))
}

fn find(name: &str) -> Result<&'static BuiltIn, String> {
    BUILT_INS.iter().find(|b| b.name == name).ok_or_else(|| {
        let names: Vec<&str> = BUILT_INS.iter().map(|b| b.name).collect();
        let hint = match nearest(name, names.iter().copied()) {
            Some(meant) => format!("did you mean {meant}? "),
            None => String::new(),
        };
        format!("unknown exact solution {name}; {hint}known: {}", names.join(", "))
    })
}

fn tiles(v: &Values, lame: [Lame; 2]) -> Built {
    let kept = match (v.optional("tiles"), v.optional("smallest")) {
        (Some(_), Some(_)) => {
            return Err("tiles and smallest exclude each other; give one of them".to_string());
        }
        (Some(tiles), None) => tiles,
        (None, Some(smallest)) => Tiles::visible(smallest)?,
        (None, None) => 12.0,
    };
    Ok(Arc::new(Tiles::new(v.get("beta")?, v.get("power")?, kept, lame)?))
}
