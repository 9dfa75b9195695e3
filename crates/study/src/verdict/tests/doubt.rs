//! What cannot be judged, and what leaves the fit.

use super::*;

#[test]
fn too_few_levels_cannot_be_judged() {
    expect(&of_rate(sample::levels(3, |h| h)), Inconclusive, "3 usable levels");
    expect(&of_rate(Vec::new()), Inconclusive, "no levels");
    expect(&of_kind(ClaimKind::Rate, "h1", sample::levels(5, |h| h)), Inconclusive, "0 usable levels");
    expect(&of_rate(sample::levels(4, |h| h)), Pass, "levels 0–3");
}

#[test]
fn broken_numbers_cannot_be_judged() {
    expect(&of_rate(spoilt(1.0, |l| l[2].errors.strain = Some(f64::NAN))), Inconclusive, "errors.strain is NaN");
    expect(&of_rate(spoilt(1.0, |l| l[4].errors.strain = Some(f64::INFINITY))), Inconclusive, "is inf");
    expect(&of_rate(spoilt(1.0, |l| l[4].kkt.tension = f64::NAN)), Inconclusive, "kkt.tension is NaN");
    expect(&of_rate(spoilt(1.0, |l| l[1].errors.strain = Some(0.0))), Inconclusive, "level 1: the error is 0");
    let repeated = spoilt(1.0, |l| l[3].errors.strain = l[2].errors.strain);
    expect(&of_rate(repeated), Inconclusive, "levels 2 and 3 have the same error");
    let rounding = spoilt(1.0, |l| l.iter_mut().for_each(|l| l.solution_energy = Some(1e10)));
    expect(&of_rate(rounding), Inconclusive, "is rounding");
}

#[test]
fn a_mesh_that_did_not_refine_cannot_be_judged() {
    let reused = spoilt(1.0, |l| l[3].mesh_hash = l[2].mesh_hash.clone());
    expect(&of_rate(reused.clone()), Inconclusive, "levels 2 and 3 have the same mesh");
    expect(&of_kind(ClaimKind::Convergence, "energy", reused.clone()), Inconclusive, "the same mesh");
    expect(&of_kind(ClaimKind::Bounded, "energy", reused), Inconclusive, "the same mesh");
    expect(&of_rate(spoilt(1.0, |l| l[3].h = l[2].h)), Inconclusive, "no refinement");
}

#[test]
fn an_unfinished_solve_cannot_be_judged() {
    let unfinished = spoilt(1.0, |l| {
        l[0].solver.solved = false;
        l[0].solver.status = "iteration limit".into();
    });
    for kind in [
        ClaimKind::Rate,
        ClaimKind::Inequality,
        ClaimKind::Exact,
        ClaimKind::Convergence,
        ClaimKind::Bounded,
        ClaimKind::Agreement,
    ] {
        expect(&of_kind(kind, "energy", unfinished.clone()), Inconclusive, "did not finish (iteration limit");
    }
    expect(&of_rate(spoilt(1.0, |l| l[4].kkt.tension = 1e-4)), Inconclusive, "scaled tension");
    expect(&of_rate(spoilt(1.0, |l| l[4].kkt.tension = 1e-9)), Pass, "rate 1.000");
}

#[test]
fn our_own_broken_budget_cannot_be_judged() {
    expect(&of_rate(spoilt(1.0, |l| l[4].budget.algebraic = Some(0.2))), Inconclusive, "algebraic error is 20.0 %");
    expect(&of_rate(spoilt(1.0, |l| l[0].budget.quadrature = Some(0.06))), Inconclusive, "quadrature error is 6.0 %");
    expect(&of_rate(spoilt(1.0, |l| l[0].budget.geometry = Some(0.06))), Inconclusive, "geometry error");
    expect(&of_rate(spoilt(1.0, |l| l[0].budget.quadrature = Some(0.05))), Pass, "rate 1.000");
}

#[test]
fn a_contaminated_level_leaves_the_fit() {
    // the finest level stagnates because the reference is too near; the budget knows
    let near = spoilt(1.0, |l| {
        l[4].errors.strain = l[4].errors.strain.map(|e| 1.5 * e);
        l[4].budget.reference = Some(0.3);
    });
    expect(&of_rate(near), Pass, "on levels 0–3");
    // the twin: nobody noticed
    let unnoticed = spoilt(1.0, |l| l[4].errors.strain = l[4].errors.strain.map(|e| 1.5 * e));
    expect(&of_rate(unnoticed), Inconclusive, "not asymptotic");
    let two_lost = spoilt(1.0, |l| l[3..].iter_mut().for_each(|l| l.budget.reference = Some(0.3)));
    expect(&of_rate(two_lost), Inconclusive, "3 usable levels");
}

#[test]
fn exclusion_states_its_reason_and_keeps_marks_already_set() {
    let gates = Gates::default();
    let mut levels = spoilt(1.0, |l| {
        l[0].excluded = Some("by hand".into());
        l[1].budget.reference = Some(0.07);
        l[2].solver.solved = false;
        l[3].budget.algebraic = Some(f64::NAN);
    });
    exclude_levels(&mut levels, &gates);
    let marks: Vec<_> = levels.iter().map(|l| l.excluded.as_deref().unwrap_or("")).collect();
    assert_eq!(marks[0], "by hand");
    assert!(marks[1].contains("reference error is 7.0 %") && marks[2].contains("not solved"));
    assert!(marks[3].contains("algebraic error is NaN"));
    assert_eq!(marks[4], "");
}

#[test]
fn energies_and_quadrature_must_agree() {
    expect(&of_rate(spoilt(1.0, |l| l[2].two_way = Some(1e-3))), Inconclusive, "A(e,e) by quadrature and by energies");
    let budgeted = spoilt(1.0, |l| {
        l[2].two_way = Some(1e-3);
        l[2].budget.quadrature = Some(6e-4);
    });
    expect(&of_rate(budgeted), Pass, "rate 1.000");
    // rounding of the energies grows with ‖u‖²/‖e‖²: 1e-7 is a defect beside an error of 0.1, rounding beside 1e-4
    let large = sample::levels(5, |h| h);
    let small = sample::levels(5, |h| 1e-3 * h);
    let with = |mut l: Vec<Level>| {
        l.iter_mut().for_each(|l| (l.two_way, l.budget.quadrature) = (Some(1e-7), None));
        of_rate(l)
    };
    expect(&with(large), Inconclusive, "differ by 1.0e-7");
    expect(&with(small), Pass, "rate 1.000");
}
