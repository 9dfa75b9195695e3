//! Must-fail twins of whole runs: a planted defect has to turn the verdict, and the healthy twin has to pass.
//!
//! Defects of the contact constraints themselves (a swapped sign, one normal at a corner) cannot be typed into a study; they
//! are planted between mesh and basis, in the tests of `signorini_study::run`.

mod common;

use common::{Ended, Folder, SMOOTH, edit};
use signorini_study::record::StudyRecord;

/// Runs one study under the id `smooth`.
fn run(test: &str, study: &str) -> (Ended, Folder) {
    let folder = Folder::with_study(test, study);
    (folder.signorini("run smooth"), folder)
}

/// The defect must leave the study unjudged, for this reason.
fn doubted(test: &str, study: &str, reason: &str) -> StudyRecord {
    let (ended, folder) = run(test, study);
    let ended = ended.expect(2);
    let record = folder.record("reports/smooth");
    assert!(record.verdict.reasons.iter().any(|r| r.contains(reason)), "no {reason:?} in {:?}", record.verdict.reasons);
    assert!(ended.out.contains("0 pass, 0 fail, 1 inconclusive"), "{}", ended.out);
    // A control that expects this verdict passes when it gets it, and one that expects failure does not.
    let control = edit(study, "id = \"smooth\"\n", "id = \"smooth\"\nexpect = \"inconclusive\"\n");
    folder.add(&control);
    folder.signorini("run smooth").expect(0);
    folder.add(&control.replace("expect = \"inconclusive\"", "expect = \"fail\""));
    folder.signorini("run smooth").expect(2);
    record
}

fn passes(test: &str, study: &str) -> StudyRecord {
    let (ended, folder) = run(test, study);
    ended.expect(0);
    folder.record("reports/smooth")
}

/// Loads and errors for μ = 2 below, and the discrete problem with another μ there.
fn with_mu(mu: f64) -> String {
    let planted = "builtin = \"P\"\nmaterials = [{ lame = [1.5, 1.0] }, { lame = [3.0, 2.0] }]\n";
    let study = edit(
        SMOOTH,
        "name = \"lower\"\nmaterial = { lame = [3.0, 2.0] }",
        &format!("name = \"lower\"\nmaterial = {{ lame = [3.0, {mu}] }}"),
    );
    // Other materials than the bodies' are a planted defect, which only a control may have.
    edit(
        &edit(&study, "builtin = \"P\"\n", planted),
        "id = \"smooth\"\n",
        "id = \"smooth\"\nexpect = \"inconclusive\"\n",
    )
}

#[test]
fn a_wrong_shear_modulus_in_one_body() {
    let (ended, folder) = run("mu-4", &with_mu(4.0));
    ended.expect(0);
    let record = folder.record("reports/smooth");
    let reasons = record.verdict.reasons.join("\n");
    assert!(reasons.contains("A(e,e) by quadrature and by energies differ"), "{reasons}");

    // The same file with the right modulus passes, so as a control that expects doubt it fails.
    let (ended, folder) = run("mu-2", &with_mu(2.0));
    ended.expect(1);
    let healthy = folder.record("reports/smooth");
    assert!(healthy.levels.iter().all(|l| l.two_way < Some(1e-6)), "{:?}", healthy.verdict);
}

#[test]
fn the_same_mesh_twice() {
    let repeated = SMOOTH.replace("[8, 16, 32, 64]", "[8, 16, 32, 32, 64]");
    // Outside controls the file itself is refused.
    run("repeated", &repeated).0.complains(2, &["does not refine"]);
    let control = edit(&repeated, "id = \"smooth\"\n", "id = \"smooth\"\nexpect = \"inconclusive\"\n");
    let (ended, folder) = run("repeated-control", &control);
    ended.expect(0);
    let reasons = folder.record("reports/smooth").verdict.reasons.join("\n");
    assert!(reasons.contains("levels 2 and 3 have the same mesh"), "{reasons}");
    passes("refined", SMOOTH);
}

#[test]
fn too_few_levels() {
    doubted("few", &SMOOTH.replace("[8, 16, 32, 64]", "[8, 16, 32]"), "3 usable levels, 4 are needed");
    passes("enough", SMOOTH);
}

#[test]
fn an_interior_point_that_stops_too_early() {
    let with = |settings: &str| SMOOTH.to_owned() + "\n[solver]\nname = \"interior-point\"\n" + settings;
    let record = doubted("loose", &with("tolerance = 1e-2\ncrossover = false\n"), "algebraic error is");
    assert!(record.levels.iter().any(|l| l.budget.algebraic > Some(0.05)));
    // A tight tolerance and the crossover both heal it.
    let polished = passes("polished", &with("tolerance = 1e-2\n"));
    assert!(polished.levels.iter().all(|l| l.budget.algebraic < Some(1e-6)));
}

#[test]
fn quadrature_that_ignores_a_singular_point() {
    let rough = edit(SMOOTH, "builtin = \"P\"", "builtin = \"R\"");
    let rough = edit(&rough, "k = 3\nm = 2\n", "alpha = 0.5\n");
    let rough = edit(&rough, "rate = 1\n", "rate = 0.5\npaper = \"none\"\ntoday = \"none\"\n");
    let control = edit(&rough, "id = \"smooth\"\n", "id = \"smooth\"\nexpect = \"inconclusive\"\n");
    let (ended, folder) =
        run("fixed", &(control + "\n[gates]\nfixed_quadrature = true\nreason = \"the planted defect\"\n"));
    ended.expect(0);
    let record = folder.record("reports/smooth");
    assert!(record.levels.iter().all(|l| l.budget.quadrature > Some(0.05)), "{:?}", record.verdict);
    assert!(record.verdict.reasons[0].contains("quadrature error is"), "{:?}", record.verdict);
    // Graded towards the point, the quadrature is as good as anywhere. (Its switch roams, so the rate is not judged here.)
    let (_, folder) = run("graded", &rough);
    let healthy = folder.record("reports/smooth");
    assert!(healthy.levels.iter().all(|l| l.budget.quadrature < Some(0.01)), "{:?}", healthy.verdict);
    assert!(healthy.verdict.reasons.iter().all(|r| !r.contains("quadrature")), "{:?}", healthy.verdict);
}

/// The line lemma by hand, contact for `x < 0.4`: the gap `±(x − 0.4)_+³` opens, or lets the bodies overlap.
fn by_expressions(sign: &str) -> String {
    let (w1, w2) = (format!("({sign}0.6)*pos(x-0.4)^3"), format!("({sign}-0.4)*pos(x-0.4)^3"));
    let (d1, d2) = (format!("({sign}1.8)*pos(x-0.4)^2"), format!("({sign}-1.2)*pos(x-0.4)^2"));
    let p = "-6*pos(0.4-x)^2";
    let exact = format!(
        "first = [\"-y*{d1}*(1-y^2)\", \"({w1} + y*{p}/3.5)*(1-y^2)\"]\n\
         second = [\"-y*{d2}*(1-y^2)\", \"({w2} + y*{p}/7)*(1-y^2)\"]\n\
         switches = [[0.4, 0]]\nbreaks = [[[0.4, -1], [0.4, 1]]]\n"
    );
    edit(&edit(SMOOTH, "builtin = \"P\"\n", &exact), "[parameters]\nk = 3\nm = 2\n", "")
}

#[test]
fn an_exact_solution_that_overlaps_is_refused_before_anything_is_solved() {
    let (ended, folder) = run("overlap", &by_expressions("-"));
    ended.complains(
        2,
        &["smooth.toml", "jump n·(u' − u'')", "must not exceed 0", "check the sign of the gap", "at x = (0.40"],
    );
    assert!(!folder.path("reports").exists());
    let healthy = passes("gap", &by_expressions("+"));
    assert!(healthy.levels.iter().all(|l| l.ledger.as_ref().is_some_and(|t| t.holds == Some(true))));
}

#[test]
fn an_exact_solution_that_pulls_is_refused() {
    let pulled = by_expressions("+").replace("-6*pos(0.4-x)^2", "6*pos(0.4-x)^2");
    run("pull", &pulled).0.complains(2, &["contact stress T_n", "must not exceed 0", "check the sign of the pressure"]);
}

#[test]
fn a_load_that_is_no_number_on_a_part_of_the_boundary() {
    let right = "along = [[1, -1], [1, 0]]\ncondition = \"traction\"";
    let given = |expression: &str| edit(SMOOTH, right, &format!("{right}\nvalue = [\"0\", \"{expression}\"]"));
    let words = ["smooth.toml", "traction on part 'right' near", "NaN)", "is no number", "check its expression there"];
    let (ended, folder) = run("nan", &given("sqrt(-0.5 - y)"));
    ended.complains(2, &words);
    assert!(!folder.path("reports/smooth").exists());
    // A number everywhere, but not the traction of the solution: the ledger sees it.
    let (ended, folder) = run("other-load", &given("sqrt(1.5 + y)"));
    assert_ne!(ended.status, 0, "{}", ended.out);
    assert!(!folder.record("reports/smooth").verdict.reasons.is_empty());
}
