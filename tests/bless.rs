//! Baselines: `bless` stores them, a run is compared with them, and only `--strict` makes a difference count.

mod common;

use common::{Folder, SMOOTH, edit};

#[test]
fn drift_from_a_blessed_baseline_is_told_and_counts_only_if_strict() {
    let folder = Folder::with_study("drift", SMOOTH);
    folder.signorini("run smooth --strict").expect(0);
    let blessed = folder.signorini("bless smooth").expect(0);
    assert!(blessed.out.contains("reference/smooth.json"), "{}", blessed.out);

    let same = folder.signorini("run smooth --strict").expect(0);
    assert!(!same.out.contains("drift"), "{}", same.out);
    assert!(folder.record("reports/smooth").notes.is_empty());

    let energy = folder.record("reports/smooth").levels[2].energy;
    let baseline = folder.text("reference/smooth.json");
    let moved = edit(&baseline, &format!("{energy}"), &format!("{}", energy * (1.0 + 1e-7)));
    folder.write("reference/smooth.json", &moved);
    let told = folder.signorini("run smooth").expect(0);
    assert!(told.out.contains("drift: smooth/smooth: level 2: energy"), "{}", told.out);
    assert!(folder.record("reports/smooth").notes[0].contains("drift from the baseline: level 2"));
    folder.signorini("run smooth --strict").expect(1);

    // The baseline is compared with, never written by a run; blessing again takes the change back.
    assert_eq!(folder.text("reference/smooth.json"), moved);
    folder.signorini("bless smooth").expect(0);
    assert_eq!(folder.text("reference/smooth.json"), baseline);
}

#[test]
fn a_baseline_needs_all_levels_and_must_be_one() {
    let folder = Folder::with_study("needs", SMOOTH);
    folder.signorini("bless smooth --levels 4").complains(2, &["all levels", "leave --levels out"]);
    assert!(!folder.path("reference/smooth.json").exists());
    folder.write("reference/smooth.json", "{}");
    folder.signorini("run smooth").complains(2, &["reference/smooth.json", "hint:"]);
}
