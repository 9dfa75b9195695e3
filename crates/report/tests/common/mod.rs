//! Records built by hand, with rates known in advance.

#![allow(dead_code, reason = "each test file uses its own part")]

use signorini_study::record::{
    Bounds, Budget, ClaimKind, ContactMeasure, Errors, FormulaValues, Kkt, Ledger, Level, Outcome, PressureSource,
    Rate, Reference, ReferencePressure, SCHEMA, SolverRecord, StudyRecord, Verdict, ZoneProfile,
};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// `C h^p`
pub type Power = (f64, f64);

/// Errors `C h^p` of strain, energy, `H¹` and `L²` on `h = √2/8, √2/16, …`.
pub fn record(levels: usize, strain: Power, energy: Power, h1: Power, l2: Power) -> StudyRecord {
    let at = |(c, p): Power, h: f64| Some(c * h.powf(p));
    let errors = |h: f64| Errors {
        strain: at(strain, h),
        energy: at(energy, h),
        h1: at(h1, h),
        l2: at(l2, h),
        pressure_l2: at((0.7, 0.5), h),
        contact_set: at((0.4, 1.0), h),
        ..Errors::default()
    };
    let levels: Vec<Level> = (0..levels).map(|k| level(k, errors)).collect();
    let mut record = blank(levels);
    for (key, (c, p)) in [("strain", strain), ("energy", energy), ("h1", h1), ("l2", l2)] {
        if record.levels.len() >= 4 {
            record.rates.insert(key.into(), rate(&record.levels, c, p));
        }
    }
    record
}

/// Rate one in energy, two in `L²`, a ledger, seven levels.
pub fn healthy() -> StudyRecord {
    let mut record = record(7, (0.21, 1.0), (0.44, 1.0), (0.235, 1.0), (0.09, 2.0));
    for level in &mut record.levels {
        let square = level.errors.energy.unwrap_or(0.0).powi(2);
        level.ledger = Some(Ledger {
            lhs: 0.5 * square,
            a: 0.52 * square,
            b: 0.03 * square * (1.0 + 0.5 * (level.level as f64).sin()),
            c: 0.0,
            parts: Default::default(),
            delta: 1e-9 * square,
            holds: Some(true),
        });
        level.two_way = Some(1e-9);
    }
    record
}

/// Theorem 3.3: a ledger whose parts fall like `h²`, `|b|` and `|c|` nearly equal and of opposite signs, rates by the
/// program's own fit, meshes too irregular for the theorem.
pub fn arc() -> StudyRecord {
    let parts = |h: f64| {
        [
            ("trace_interpolation", 0.021 * h.powi(2)),
            ("jump_minus_chord", 0.08 * h.powf(1.9)),
            ("nodal_minus_chord", 0.0805 * h.powf(1.9)),
            ("nodal_minus_jump", 0.004 * h.powi(2)),
        ]
    };
    let mut record = with_parts(parts, |h| [0.0045 * h * h, -0.0046 * h * h * (1.0 + h)]);
    (record.claim, record.study) = ("theorem-3-3".into(), "theorem-3-3".into());
    record.hypotheses = vec!["u ∈ H²".into(), "strongly regular family".into()];
    record.bounds = Bounds { paper: Some(0.75), today: None, expected: Some(1.0) };
    for level in &mut record.levels {
        (level.side_ratio, level.straight_over_chord) = (7.4 + 0.01 * level.level as f64, Some(3.1));
    }
    record
}

/// Theorem 3.4: `b` of full sides negative, that of switch sides wherever the switch point sits.
pub fn gap() -> StudyRecord {
    let parts = |h: f64| {
        let k = (std::f64::consts::SQRT_2 / h / 8.0).log2();
        let switch = 0.004 * h * h * (1.5 + (2.1 * k).sin());
        [("b_gap", -0.03 * h * h), ("b_switch", switch), ("gap_interpolation", 0.01 * h * h), ("unused", 0.0)]
    };
    let mut record = with_parts(parts, |h| [-0.027 * h * h, 0.0002 * h.powi(3)]);
    (record.claim, record.study) = ("theorem-3-4".into(), "theorem-3-4".into());
    record.levels.iter_mut().for_each(|l| l.straight_over_chord = Some(1.2));
    record
}

/// A healthy record with these parts and `[b, c]` on each level, and the rates that follow.
fn with_parts(parts: impl Fn(f64) -> [(&'static str, f64); 4], zone: impl Fn(f64) -> [f64; 2]) -> StudyRecord {
    let mut record = healthy();
    for level in &mut record.levels {
        let h = level.h;
        if let Some(ledger) = &mut level.ledger {
            [ledger.b, ledger.c] = zone(h);
            ledger.parts = parts(h).into_iter().filter(|p| p.0 != "unused").map(|(n, x)| (n.to_string(), x)).collect();
        }
    }
    record.rates = signorini_study::rate::all(&record.levels, "strain");
    record
}

/// Hertz's ellipse with half width 0.1 and peak 2 on a zone of length 1, pressed 2 % too hard, with an exponent to scale by.
pub fn pressed(scale: f64) -> StudyRecord {
    let mut record = healthy();
    let coordinate: Vec<f64> = (0..=100).map(|i| f64::from(i) * 0.01).collect();
    let formula = |x: &f64| scale * 2.0 * (1.0 - (x / 0.1).powi(2)).max(0.0).sqrt();
    let reference: Vec<f64> = coordinate.iter().map(formula).collect();
    record.zone = Some(ZoneProfile {
        across_gap: true,
        symmetric: true,
        points: coordinate.iter().map(|x| [*x, 0.0]).collect(),
        pressure: reference.iter().map(|p| 1.02 * p).collect(),
        gap: coordinate.iter().map(|x| scale * (x - 0.1).max(0.0).powf(1.5)).collect(),
        reference: Some(ReferencePressure {
            source: PressureSource::Formula,
            pressure: reference.into_iter().map(Some).collect(),
        }),
        coordinate,
    });
    for level in &mut record.levels {
        let half_width = if level.level < 3 { 0.11 } else { 0.0995 };
        let formula = FormulaValues { force: None, half_width: Some(0.1), peak_pressure: Some(2.0 * scale) };
        let (force, peak_pressure) = (0.3 * scale, 2.04 * scale);
        level.contact =
            Some(ContactMeasure { force, half_width, peak_pressure, formula: Some(formula), profile: None });
        level.errors.half_width = Some(half_width / 0.1 - 1.0);
        level.errors.peak_pressure = Some(0.02);
    }
    record
}

/// An empty record of one case with these levels.
pub fn blank(levels: Vec<Level>) -> StudyRecord {
    StudyRecord {
        schema: SCHEMA,
        study: "thm31-flat-contact".into(),
        case: "criss-cross".into(),
        several: true,
        title: "Two blocks in flat contact with one switch point".into(),
        question: "Does the strain seminorm of the error fall like h?".into(),
        setup: "Two unit blocks, the upper pressed on the lower.".into(),
        refuted_by: "A rate below 0.95 on regular meshes.".into(),
        parameters: BTreeMap::from([("alpha".into(), 1.5), ("N".into(), 3.0)]),
        claim: "theorem-3.1".into(),
        statement: "|u − u_h| ≤ c h".into(),
        hypotheses: vec!["u ∈ H²".into(), "regular family".into()],
        kind: ClaimKind::Rate,
        norm: "strain".into(),
        family: "criss-cross".into(),
        reference: Reference::Exact,
        profile: "quick".into(),
        seed: 0,
        levels,
        rates: BTreeMap::new(),
        bounds: Bounds { paper: Some(1.0), today: Some(1.0), expected: Some(1.0) },
        verdict: Verdict { outcome: Outcome::Pass, reasons: vec!["the interval lies above 0.95".into()] },
        expect: None,
        expected_inconclusive: None,
        notes: vec!["the mesh is symmetric".into()],
        zone: None,
        corners: Vec::new(),
        extrapolation: None,
        refusal: None,
        changed: None,
    }
}

fn level(k: usize, errors: impl Fn(f64) -> Errors) -> Level {
    let n = 8_usize << k;
    let h = std::f64::consts::SQRT_2 / n as f64;
    Level {
        level: k,
        cells: n,
        h,
        min_angle: 45.0,
        side_ratio: std::f64::consts::SQRT_2,
        straight_over_chord: None,
        nested: k > 0,
        dofs: 4 * n * n,
        contact_pairs: n + 1,
        constraints: n,
        active: n / 2,
        switch_sides: Some(1),
        energy: -0.123,
        two_way: None,
        mesh_hash: format!("{k:016x}"),
        errors: errors(h),
        ledger: None,
        splitting: Vec::new(),
        inside: None,
        kkt: Kkt { stationarity: 1.3e-14, ..Kkt::default() },
        budget: Budget { algebraic: Some(1e-9), geometry: Some(0.0), ..Budget::default() },
        solver: SolverRecord {
            name: "condensed".into(),
            status: "converged".into(),
            solved: true,
            iterations: 4 + k,
            factorizations: 1,
            work: None,
        },
        warnings: Vec::new(),
        excluded: None,
        solution_energy: Some(1.0),
        solution_h1: None,
        solution_trace: Some(1.0),
        contact: None,
        second: None,
        fields: None,
    }
}

/// The exact rate `p` of `C h^p`, with an interval of ±0.004.
pub fn rate(levels: &[Level], c: f64, p: f64) -> Rate {
    let window: Vec<usize> = levels.iter().map(|l| l.level).skip(1).collect();
    Rate {
        slope: p,
        stderr: 0.0015,
        low: p - 0.004,
        high: p + 0.004,
        pairwise: window.iter().map(|&k| (k, p)).collect(),
        levels: window,
        intercept: c.ln(),
        r2: 0.99999,
        curvature: 0.0007,
        dofs_slope: p,
        asymptotic: true,
        log_alternatives: Vec::new(),
    }
}

/// A healthy record and those that a careless picture stumbles over, by name.
pub fn hard() -> Vec<(&'static str, StudyRecord)> {
    let flat = |c: f64| record(6, (c, 0.0), (c, 0.0), (c, 0.0), (c, 0.0));
    let mut exact = flat(1e-16);
    exact.kind = ClaimKind::Exact;
    exact.rates.clear();
    exact.bounds = Bounds::default();
    let mut null = healthy();
    let mut zero = healthy();
    let mut one_mesh = healthy();
    let mut negative = healthy();
    let mut broken = healthy();
    for (k, level) in null.levels.iter_mut().enumerate() {
        level.errors = Errors::default();
        level.ledger = None;
        zero.levels[k].errors = Errors { strain: Some(0.0), ..Errors::default() };
        zero.levels[k].ledger =
            Some(Ledger { lhs: 0.0, a: 0.0, b: 0.0, c: 0.0, parts: Default::default(), delta: 0.0, holds: None });
        one_mesh.levels[k].h = 0.1;
        if let Some(ledger) = &mut negative.levels[k].ledger {
            ledger.b *= if k % 2 == 0 { -1.0 } else { 1.0 };
            ledger.c = ledger.lhs * if k < 2 { -0.3 } else { 0.2 };
        }
        if let Some(ledger) = &mut broken.levels[k].ledger {
            ledger.b = 0.0;
            ledger.holds = [Some(true), None, Some(false)][k % 3];
        }
        if k > 4 {
            broken.levels[k].excluded = Some("reference contamination 7.1 % of the energy error, above 5 %".into());
        }
    }
    null.rates.clear();
    let mut two_bounds = record(6, (0.3, 0.97), (0.31, 0.96), (0.3, 0.97), (0.31, 1.9));
    two_bounds.bounds.paper = Some(0.75);
    for level in &mut two_bounds.levels {
        let wobble = 1.0 + 0.3 * (level.level as f64 * 2.2).sin();
        for e in [&mut level.errors.strain, &mut level.errors.energy] {
            *e = e.map(|x| x * wobble);
        }
    }
    for rate in two_bounds.rates.values_mut() {
        (rate.low, rate.high) = (rate.slope - 0.4, rate.slope + 0.4);
    }
    let mut wild = record(5, (1e-3, -40.0), (1e150, 40.0), (1.0, 1.0), (1e-250, 2.0));
    wild.bounds.today = Some(0.0);
    let mut words = healthy();
    words.title =
        "A title | with a bar, far longer than any picture is wide, so that it has to be broken into lines ".repeat(3);
    words.study = "a-study-of-a-name-that-goes-on-and-on-without-any-need-for-it-at-all-until-nobody-reads-it".into();
    for level in &mut words.levels {
        level.excluded =
            Some(format!("reason {} of a length that fills the foot of the picture by itself", level.level));
    }
    let mut unknown = healthy();
    unknown.norm = "no-such-norm".into();
    let mut pressure = healthy();
    pressure.norm = "pressure_l2".into();
    pressure.bounds = Bounds { paper: None, today: None, expected: Some(0.5) };
    vec![
        ("healthy", healthy()),
        ("one-level", record(1, (0.2, 1.0), (0.4, 1.0), (0.2, 1.0), (0.1, 2.0))),
        ("no-level", blank(Vec::new())),
        ("all-null", null),
        ("all-zero", zero),
        ("rounding", exact),
        ("equal", flat(0.37)),
        ("one-mesh", one_mesh),
        ("negative-terms", negative),
        ("broken-ledger", broken),
        ("two-bounds", two_bounds),
        ("wild", wild),
        ("long-words", words),
        ("unknown-norm", unknown),
        ("pressure", pressure),
        ("arc", arc()),
        ("gap", gap()),
    ]
}

/// An empty folder of that name for one test.
pub fn folder(name: &str) -> PathBuf {
    let dir = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&dir);
    dir
}
