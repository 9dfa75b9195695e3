//! Simpler scenes than a given one, the greatest simplification first.

use super::super::dice::rounded;
use super::{Draw, Faces, Law, Mesh, Place, Pushed, Solution, TraceDraw, Wave};

/// One step of simplification each; none that would change nothing.
pub fn simpler(draw: &Draw) -> Vec<Draw> {
    let mut all = Vec::new();
    let mut try_with = |change: &dyn Fn(&mut Draw)| {
        let mut changed = draw.clone();
        change(&mut changed);
        if changed != *draw && !all.contains(&changed) {
            all.push(changed);
        }
    };
    if let Solution::Traces(traces) = &draw.solution {
        for k in 0..traces.switches.len() {
            try_with(&|d| with_traces(d, |t| drop_switch(t, k)));
        }
        try_with(&|d| with_traces(d, |t| t.slips = [Wave::NONE, Wave::NONE]));
        try_with(&|d| with_traces(d, |t| t.common = Wave::NONE));
        try_with(&|d| with_traces(d, |t| t.share = 0.5));
    }
    try_with(&|d| d.mesh = plain(d));
    try_with(&|d| d.laws = [Law { young: 1.0, poisson: 0.3 }; 2]);
    for k in 0..2 {
        try_with(&|d| d.laws[k].poisson = 0.3);
        try_with(&|d| d.laws[k].young = 10.0_f64.powf(d.laws[k].young.log10().round()));
    }
    try_with(&place);
    for digits in [1, 2] {
        try_with(&|d| round(d, digits));
    }
    all
}

fn with_traces(draw: &mut Draw, change: impl Fn(&mut TraceDraw)) {
    if let Solution::Traces(traces) = &mut draw.solution {
        change(traces);
    }
}

/// Takes switch point `k` away. At an end of the zone the outer piece goes with it; inside, the next switch point and both
/// pieces between, so that contact and gap still alternate.
fn drop_switch(traces: &mut TraceDraw, k: usize) {
    let last = traces.switches.len() - 1;
    if last == 0 {
        return;
    }
    traces.switches.remove(k);
    if k == 0 {
        traces.pieces.remove(0);
        traces.pressed_first = !traces.pressed_first;
    } else if k == last {
        traces.pieces.pop();
    } else if last > 1 {
        traces.switches.remove(k);
        traces.pieces.drain(k..k + 2);
    }
}

/// The plainest family that the hypotheses allow.
fn plain(draw: &Draw) -> Mesh {
    match draw.place {
        Place::Arc => Mesh::RefinedDelaunay(1),
        _ => Mesh::Structured,
    }
}

fn place(draw: &mut Draw) {
    match &mut draw.place {
        Place::Line { width, heights, split } => {
            let at_switch = *split == Some(super::random::BUILT_IN_SWITCH);
            if !at_switch {
                *split = split.map(|_| 0.5);
            }
            (*width, *heights) = (1.0, [1.0, 1.0]);
        }
        Place::Arc => {}
        Place::Graph(faces) => {
            if let Faces::Cubic([e0, e2, _, t1, t2]) = faces {
                // without its odd part the gap is narrowest in the middle or at the ends
                *e0 = if *e2 < 0.0 { -*e2 } else { *e0 };
                *faces = Faces::Cubic([*e0, *e2, 0.0, 0.0 * *t1, 0.0 * *t2]);
            }
        }
        Place::Polyline(pushed) => pushed.forces = [[0.0; 2]; 2],
    }
}

/// All numbers of the solution to so many digits.
fn round(draw: &mut Draw, digits: usize) {
    let to = |x: &mut f64| *x = rounded(*x, digits);
    match &mut draw.solution {
        Solution::BuiltIn(_, values) => values.iter_mut().for_each(|(name, x)| *x = parameter(name, *x)),
        Solution::Traces(t) => {
            t.switches.iter_mut().for_each(|s| *s = rounded(*s, digits.max(2)));
            t.pieces.iter_mut().for_each(|p| to(&mut p.amplitude));
            for wave in t.slips.iter_mut().chain([&mut t.common]) {
                [&mut wave.amplitude, &mut wave.frequency, &mut wave.phase].into_iter().for_each(to);
            }
            to(&mut t.share);
        }
        Solution::None => {}
    }
    for law in &mut draw.laws {
        to(&mut law.young);
        // 0.45 must not become 0.5
        law.poisson = rounded(law.poisson.min(0.44), digits);
    }
    if let Place::Polyline(Pushed { corners, top, forces }) = &mut draw.place {
        corners.iter_mut().flatten().chain(top).chain(forces.iter_mut().flatten()).for_each(to);
    }
}

/// Exponents to one decimal, upwards: the scene becomes no rougher than the hypotheses allow.
fn parameter(name: &str, x: f64) -> f64 {
    let up = rounded((10.0 * x).ceil() / 10.0, 2);
    match name {
        "alpha" if up > 1.95 => x,
        "alpha" | "beta" => up,
        _ => x,
    }
}
