//! Falk's splitting and the angles of the meshes on a page.

mod common;

use signorini_report::markdown::{Pictures, page};
use signorini_study::record::{Estimate, Splitting};

fn entry(v: &str, right: f64) -> Splitting {
    Splitting {
        estimate: Estimate::Halved,
        v: v.into(),
        v_h: "random".into(),
        tried: 9,
        load_u: 0.25,
        load_v: -0.125,
        energy: right,
        stress_v: 0.125,
        stress_u: -0.25,
        left: 0.5,
        right,
        delta: 1e-12,
        holds: Some(right >= 0.5),
    }
}

#[test]
fn the_splitting_stands_on_the_page_term_by_term() {
    let mut record = common::healthy();
    assert!(!page(&record, Pictures::default()).contains("Falk"));
    for level in &mut record.levels {
        level.splitting = vec![entry("solution u", 0.75), entry("random", 0.625)];
    }
    let text = page(&record, Pictures::default());
    assert!(text.contains("## Falk's splitting") && text.contains(Estimate::Halved.formula()), "{text}");
    let row = "| random | random | 9 | 0.25000 | -0.12500 | 0.62500 | 0.12500 | -0.25000 | 0.50000 | 0.62500 | 1.0000e-12 | yes |";
    assert!(text.contains(row), "{text}");
    // (0.625 − 0.5)/0.5
    assert!(text.contains("level 6: 0.25 (v = random, vₕ = random)"), "{text}");
    record.levels[6].splitting[0] = entry("solution u", 0.25);
    assert!(page(&record, Pictures::default()).contains("| 1.0000e-12 | no |"));
}

#[test]
fn angles_that_fall_are_said_to_violate_the_hypothesis() {
    let mut record = common::healthy();
    record.hypotheses = vec!["polygonal bodies, regular family".into()];
    let steady = page(&record, Pictures::default());
    assert!(steady.contains("- Angles: the smallest angle is at least"), "{steady}");
    for level in &mut record.levels {
        level.min_angle = 20.0 * level.h;
    }
    let falling = page(&record, Pictures::default());
    assert!(falling.contains("like h^1.000: not a regular family, the claim's hypothesis is violated"), "{falling}");
    record.hypotheses.clear();
    assert!(!page(&record, Pictures::default()).contains("Angles"));
}
