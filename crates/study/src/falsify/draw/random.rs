//! Random scenes, target by target.

use super::super::dice::{Dice, rounded};
use super::super::target::Target;
use super::{Draw, Faces, Law, Mesh, Place, Pushed, Solution, TraceDraw};

/// The switch point of the built-in solutions on straight zones, `1/√6`.
pub(super) const BUILT_IN_SWITCH: f64 = 0.408_248_290_463_863_1;

/// Draw number `index` of a target: the same for the same three arguments, whatever else is drawn.
pub fn draw(target: Target, seed: u64, index: usize) -> Draw {
    let mut dice = Dice::new(target.about().id, seed, index);
    let laws = laws(&mut dice);
    match target {
        Target::Theorem33 => arc(target, laws, &mut dice),
        Target::Theorem34 => graph(target, laws, &mut dice),
        Target::Lemma21 => polyline(target, laws, &mut dice),
        Target::Falk => match index % 3 {
            0 => line(target, laws, &mut dice),
            1 => arc(target, laws, &mut dice),
            _ => graph(target, laws, &mut dice),
        },
        Target::Bent => bent(target, laws, &mut dice),
        _ => line(target, laws, &mut dice),
    }
}

/// Stiffness ratios over six decades, Poisson's ratio from 0 to 0.45.
fn laws(dice: &mut Dice) -> [Law; 2] {
    let ratio = if dice.below(4) == 0 { 1.0 } else { dice.decades(-3.0, 3.0) };
    [1.0, ratio].map(|young| Law { young, poisson: dice.between(0.0, 0.45) })
}

fn line(target: Target, laws: [Law; 2], dice: &mut Dice) -> Draw {
    let solution = match (target, dice.below(4)) {
        (Target::ManySwitches, _) => Solution::Traces(TraceDraw::draw(dice, 1, 6)),
        (Target::Remark32a, 0) => Solution::BuiltIn("many-switches", vec![("cells", dice.pick(&[1.0, 2.0, 3.0, 4.0]))]),
        (Target::Remark32a, 1) => alpha("R", 1.55, dice),
        (Target::Remark32a, _) => Solution::Traces(TraceDraw::draw(dice, 1, 6)),
        (Target::Remark32b, 0) => tiles(dice),
        (_, 0) => Solution::BuiltIn("P", vec![("k", dice.pick(&[3.0, 4.0])), ("m", dice.pick(&[2.0, 3.0]))]),
        (_, 1) if dice.coin() => Solution::BuiltIn("W", Vec::new()),
        (_, 1) => alpha("R", 1.1, dice),
        _ => Solution::Traces(TraceDraw::draw(dice, 1, 4)),
    };
    let fits_one_place = matches!(solution, Solution::BuiltIn(..));
    let place = if fits_one_place {
        let split = dice.coin().then(|| dice.between(0.25, 0.75));
        Place::Line { width: 1.0, heights: [1.0, 1.0], split }
    } else {
        Place::Line {
            width: dice.between(0.6, 2.0),
            heights: [dice.between(0.6, 2.0), dice.between(0.6, 2.0)],
            split: None,
        }
    };
    let mesh = straight_mesh(dice);
    let fine = matches!(place, Place::Line { split: Some(_), .. });
    let levels = match mesh {
        Mesh::Delaunay(_) | Mesh::RefinedDelaunay(_) => vec![4, 8, 16, 32],
        _ if fine => vec![2, 4, 8, 16, 32],
        _ if fits_one_place => vec![4, 8, 16, 32, 64],
        _ => vec![6, 12, 24, 48],
    };
    Draw { target, laws, place, solution, mesh, levels }
}

fn straight_mesh(dice: &mut Dice) -> Mesh {
    match dice.below(8) {
        0 | 1 => Mesh::Structured,
        2 => Mesh::CrissCross,
        3 => Mesh::UnionJack,
        4 => Mesh::Perturbed(dice.seed(), dice.pick(&[0.1, 0.2, 0.3])),
        5 => Mesh::Refined(dice.seed(), dice.pick(&[0.1, 0.2, 0.3])),
        6 => Mesh::RefinedDelaunay(dice.seed()),
        _ => Mesh::Delaunay(dice.seed()),
    }
}

fn alpha(name: &'static str, least: f64, dice: &mut Dice) -> Solution {
    Solution::BuiltIn(name, vec![("alpha", dice.between(least, 1.99))])
}

fn tiles(dice: &mut Dice) -> Solution {
    let (beta, power) = (dice.between(0.55, 2.0), dice.pick(&[1.0, 1.0, 1.25, 1.5]));
    Solution::BuiltIn("tiles", vec![("beta", beta), ("power", power), ("tiles", 6.0)])
}

fn arc(target: Target, laws: [Law; 2], dice: &mut Dice) -> Draw {
    let solution = match dice.below(4) {
        0 => Solution::BuiltIn("arcP", Vec::new()),
        1 => alpha("arcR", 1.1, dice),
        _ => Solution::Traces(TraceDraw::draw(dice, 1, 2)),
    };
    // the families that are strongly regular with β ≤ 2 on this scene
    let (mesh, levels) = if dice.coin() {
        (Mesh::RefinedDelaunay(dice.seed()), vec![2, 4, 8, 16])
    } else {
        (Mesh::Delaunay(dice.seed()), vec![3, 6, 12, 24])
    };
    Draw { target, laws, place: Place::Arc, solution, mesh, levels }
}

fn graph(target: Target, laws: [Law; 2], dice: &mut Dice) -> Draw {
    let (faces, solution) = match dice.below(4) {
        0 => (Faces::Shape(dice.below(3)), Solution::BuiltIn("graphP", Vec::new())),
        1 => (Faces::Shape(dice.below(3)), alpha("graphR", 1.1, dice)),
        _ => (cubic(dice), Solution::Traces(TraceDraw::draw(dice, 1, 2))),
    };
    let (mesh, levels) = match dice.below(4) {
        0 => (Mesh::RefinedDelaunay(dice.seed()), vec![4, 8, 16, 32]),
        1 => (Mesh::Delaunay(dice.seed()), vec![4, 8, 16, 32]),
        2 => (Mesh::Perturbed(dice.seed(), 0.2), vec![4, 8, 16, 32]),
        _ => (Mesh::Structured, vec![4, 8, 16, 32]),
    };
    Draw { target, laws, place: Place::Graph(faces), solution, mesh, levels }
}

/// A gap that closes at its narrowest place, or nearly.
fn cubic(dice: &mut Dice) -> Faces {
    let (e2, e3) = (dice.between(-0.4, 0.4), dice.between(-0.2, 0.2));
    let least = (0..=200).map(|k| f64::from(k) / 100.0 - 1.0).map(|y| y * y * (e2 + e3 * y)).fold(0.0, f64::min);
    let e0 = rounded((1000.0 * -least).ceil() / 1000.0 + dice.pick(&[0.0, 0.0, 0.05]), 3);
    Faces::Cubic([e0, e2, e3, dice.between(-0.2, 0.2), dice.between(-0.2, 0.2)])
}

fn polyline(target: Target, laws: [Law; 2], dice: &mut Dice) -> Draw {
    let inner: Vec<f64> = match dice.below(3) {
        0 => Vec::new(),
        1 => vec![dice.between(-0.5, 0.5)],
        _ => vec![dice.between(-0.6, -0.2), dice.between(0.2, 0.6)],
    };
    let x: Vec<f64> = [-1.0].into_iter().chain(inner).chain([1.0]).collect();
    let corners = x.into_iter().map(|x| [x, dice.between(-0.4, 0.4)]).collect();
    let pushed = Pushed {
        corners,
        top: [dice.between(-0.1, 0.1), dice.between(-0.1, 0.05)],
        forces: [
            [dice.between(-0.3, 0.1), dice.between(-0.3, 0.3)],
            [dice.between(-0.1, 0.3), dice.between(-0.3, 0.3)],
        ],
    };
    let mesh = straight_mesh(dice);
    Draw { target, laws, place: Place::Polyline(pushed), solution: Solution::None, mesh, levels: vec![4, 8, 16, 32] }
}

/// The switch point is a node of every mesh: elsewhere its place in its side would hide the loss of rate.
fn bent(target: Target, laws: [Law; 2], dice: &mut Dice) -> Draw {
    let solution = Solution::BuiltIn("R", vec![("alpha", dice.between(0.4, 0.8))]);
    let place = Place::Line { width: 1.0, heights: [1.0, 1.0], split: Some(BUILT_IN_SWITCH) };
    Draw { target, laws, place, solution, mesh: Mesh::Structured, levels: vec![4, 8, 16, 32] }
}
