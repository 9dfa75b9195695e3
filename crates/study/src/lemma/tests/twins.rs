//! Must-fail twins: a defect in the mesh, or a claim that is too bold, turns the verdict; the healthy twin passes.

use super::boundary::function;
use super::*;
use crate::lemma::inverse::{Intervals, Norms};
use crate::lemma::mesh::DomainMesh;
use crate::lemma::{interpolation_level, interval_level, strip_level};
use crate::record::{Bounds, ClaimKind, Level, Outcome, Verdict};
use crate::study::Gates;
use crate::verdict::{JudgeInput, judge};

const LEVELS: u32 = 6;

fn verdict(kind: ClaimKind, norm: &str, paper: Option<f64>, levels: &[Level]) -> Verdict {
    let gates = Gates { ceiling: None, ..Gates::default() };
    let bounds = Bounds { paper, ..Bounds::default() };
    judge(&JudgeInput { kind, norm, levels, bounds: &bounds, gates: &gates, expected_is_asymptotic: false })
}

fn healthy(domain: &Domain) -> Vec<DomainMesh> {
    (1..1 + LEVELS).map(|k| domain.mesh(k)).collect()
}

/// New boundary nodes stay on the chords of the coarse mesh.
fn off_the_arc(domain: &Domain) -> Vec<DomainMesh> {
    let chord = |mesh: &DomainMesh| {
        let at = |angles: [f64; 2]| {
            let side = mesh.boundary.iter().find(|s| s.angles == angles).unwrap();
            0.5 * side.nodes.map(|i| mesh.points[i as usize]).iter().sum::<signorini_contact::Point>()
        };
        mesh.refined(at)
    };
    let mut meshes = vec![domain.mesh(1)];
    (1..LEVELS).for_each(|k| meshes.push(chord(&meshes[k as usize - 1])));
    meshes
}

fn interpolated(text: &str, meshes: &[DomainMesh]) -> Vec<Level> {
    let u = function(text, &disc());
    meshes.iter().enumerate().map(|(k, m)| interpolation_level(m, &u, 2 << k, k).unwrap()).collect()
}

fn strips(meshes: &[DomainMesh]) -> Vec<Level> {
    meshes.iter().enumerate().map(|(k, m)| strip_level(m, 2 << k, k)).collect()
}

#[test]
fn the_exponent_of_the_lemma_is_sharp_and_two_is_refused() {
    let levels = interpolated("r + 0.2*sin(2*x + y)", &healthy(&disc()));
    let outcome = |claimed| verdict(ClaimKind::Rate, "boundary_l2", Some(claimed), &levels).outcome;
    assert_eq!((outcome(1.5), outcome(2.0)), (Outcome::Pass, Outcome::Fail));
    // a function that is not in H² does not have the lemma's rate
    let rough = interpolated("r^0.75", &healthy(&disc()));
    assert_eq!(verdict(ClaimKind::Rate, "boundary_l2", Some(1.5), &rough).outcome, Outcome::Fail);
}

#[test]
fn nodes_off_the_arc_stop_the_convergence_on_the_boundary() {
    let levels = interpolated("sin(2*x + y)", &off_the_arc(&disc()));
    let found = verdict(ClaimKind::Rate, "boundary_l2", Some(1.5), &levels);
    assert_eq!(found.outcome, Outcome::Fail, "{:?}", found.reasons);
    let smooth = interpolated("sin(2*x + y)", &healthy(&disc()));
    assert_eq!(verdict(ClaimKind::Rate, "boundary_l2", Some(1.5), &smooth).outcome, Outcome::Pass);
}

#[test]
fn nodes_off_the_arc_let_the_constant_of_the_strip_grow() {
    for domain in domains().into_iter().take(2) {
        let sound = verdict(ClaimKind::Bounded, "constant", None, &strips(&healthy(&domain)));
        assert_eq!(sound.outcome, Outcome::Pass, "{:?}", sound.reasons);
        let found = verdict(ClaimKind::Bounded, "constant", None, &strips(&off_the_arc(&domain)));
        assert_eq!(found.outcome, Outcome::Fail, "{:?}", found.reasons);
    }
}

/// The full norm in place of the seminorm: near 1, but no equality.
#[test]
fn the_wrong_norm_is_no_equality() {
    let outcome = |norms| {
        let intervals = Intervals { whole: [0.2, 1.7], norms, seed: 1 };
        let levels: Vec<Level> = (0..6).map(|k| interval_level(&intervals, 2 << k, k)).collect();
        verdict(ClaimKind::Exact, "constant", None, &levels).outcome
    };
    assert_eq!(outcome(Norms::Seminorms), Outcome::Pass);
    assert_eq!(outcome(Norms::FullRight), Outcome::Fail);
    assert_eq!(outcome(Norms::Full), Outcome::Fail);
}
