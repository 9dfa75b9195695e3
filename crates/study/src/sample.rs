//! Made-up levels and records for the tests of rates, verdicts and stores, and shipped studies for those of scenes.

use crate::file::library::shipped;
use crate::rate;
use crate::record::{
    Bounds, Budget, ClaimKind, Errors, Kkt, Level, Outcome, Reference, SCHEMA, SolverRecord, StudyRecord, Verdict,
};
use crate::study::{Case, Study};

/// `count` sound levels, `h = 1/8, 1/16, …`, whose energy error is `error(h)`; the strain error is 0.7 of it, the
/// interpolation error 1.1 times it, `‖u‖_A = 1`.
pub(crate) fn levels(count: usize, error: impl Fn(f64) -> f64) -> Vec<Level> {
    (0..count).map(|k| level(k, error(0.125 * 0.5_f64.powi(k as i32)))).collect()
}

/// A sound level with the given energy error.
pub(crate) fn level(k: usize, error: f64) -> Level {
    let n = 8 << k;
    Level {
        level: k,
        cells: n,
        h: 0.125 * 0.5_f64.powi(k as i32),
        min_angle: 45.0,
        side_ratio: 2.0_f64.sqrt(),
        straight_over_chord: None,
        nested: k > 0,
        dofs: 4 * n * n,
        contact_pairs: n + 1,
        constraints: n + 1,
        active: n / 2,
        switch_sides: Some(1),
        energy: -0.5,
        two_way: Some(1e-12),
        mesh_hash: format!("{:016x}", 77 + k),
        errors: Errors {
            strain: Some(0.7 * error),
            energy: Some(error),
            interpolation: Some(1.1 * error),
            ..Errors::default()
        },
        ledger: None,
        splitting: Vec::new(),
        inside: None,
        kkt: Kkt { stationarity: 1e-15, ..Kkt::default() },
        budget: Budget {
            algebraic: Some(1e-8),
            quadrature: Some(1e-7),
            geometry: Some(0.0),
            reference: Some(0.0),
            unresolved: None,
        },
        solver: SolverRecord {
            name: "condensed".into(),
            status: "converged".into(),
            solved: true,
            iterations: 4,
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

/// A record with these levels, their rates, gate 1 and a passing verdict.
pub(crate) fn record(study: &str, case: &str, levels: Vec<Level>) -> StudyRecord {
    StudyRecord {
        schema: SCHEMA,
        study: study.into(),
        case: case.into(),
        several: case != study,
        title: "A sample".into(),
        question: String::new(),
        setup: String::new(),
        refuted_by: String::new(),
        parameters: [("k".to_string(), 3.0)].into(),
        claim: "theorem-3-1".into(),
        statement: "|u − u_h| ≤ c h".into(),
        hypotheses: vec!["regular family".into()],
        kind: ClaimKind::Rate,
        norm: "strain".into(),
        family: "structured".into(),
        reference: Reference::Exact,
        profile: "quick".into(),
        seed: 0,
        rates: rate::all(&levels, "strain"),
        levels,
        bounds: Bounds { paper: Some(1.0), today: Some(1.0), expected: Some(1.0) },
        verdict: Verdict { outcome: Outcome::Pass, reasons: vec!["sample".into()] },
        expect: None,
        expected_inconclusive: None,
        notes: Vec::new(),
        zone: None,
        corners: Vec::new(),
        extrapolation: None,
        refusal: None,
        changed: None,
    }
}

/// A shipped study.
pub(crate) fn study(id: &str) -> Study {
    let sources = shipped().select(&[id.to_string()]).unwrap();
    sources[0].load().unwrap_or_else(|e| panic!("{e}"))
}

/// A case of a shipped study.
pub(crate) fn case(id: &str, name: &str) -> Case {
    let found = study(id).cases.into_iter().find(|c| c.name == name);
    found.unwrap_or_else(|| panic!("{id} has no case {name}"))
}

/// Seeded noise (SplitMix64), the same on every machine.
pub(crate) struct Noise(u64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Uniform in `(0, 1)`.
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 2.0_f64.powi(-53) + 2.0_f64.powi(-54)
    }

    /// Standard normal (Box and Muller).
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }
}
