//! Removes and inserts inner nodes where sides are too short or too long.

use super::draft::Draft;
use super::score::{Fault, fault};
use super::wish::Wish;
use signorini_contact::{Error, Point};

/// Shares of the wished length below which a side is contracted and above which it is halved (M. Botsch, L. Kobbelt: *A
/// remeshing approach to multiresolution modeling*, 2004, have 4/5 and 4/3).
const SHORT: f64 = 0.72;
const LONG: f64 = 1.40;

/// One round: the worst sides first, each node touched at most once.
pub(super) fn clean(draft: &Draft, wish: &Wish) -> Result<Draft, Error> {
    let mut round = Round {
        draft,
        touched: vec![false; draft.points.len()],
        removed: vec![false; draft.points.len()],
        points: draft.points.clone(),
    };
    let sizes: Vec<f64> = draft.points.iter().map(|&p| wish.size(p)).collect();
    round.open_corners();
    for [a, b] in worst_first(draft, &sizes) {
        let share = length(draft, a, b) / mean(&sizes, a, b);
        if share < SHORT {
            round.contract(a, b);
        } else if share > LONG {
            round.halve(a, b);
        }
    }
    if !round.touched.contains(&true) {
        return Ok(draft.clone());
    }
    let removed = &round.removed;
    let kept = round.points.iter().enumerate().filter(|(i, _)| !removed.get(*i).copied().unwrap_or(false));
    Draft::new(kept.map(|(_, &p)| p).collect(), draft.fixed)
}

fn length(draft: &Draft, a: u32, b: u32) -> f64 {
    (draft.points[a as usize] - draft.points[b as usize]).norm()
}

fn mean(sizes: &[f64], a: u32, b: u32) -> f64 {
    0.5 * (sizes[a as usize] + sizes[b as usize])
}

/// Sides that are too long or too short, by how much they miss; equal ones in the order of their nodes.
fn worst_first(draft: &Draft, sizes: &[f64]) -> Vec<[u32; 2]> {
    let inner = draft.sides().filter(|&[a, b]| !draft.is_boundary_side(a, b));
    let miss = |[a, b]: [u32; 2]| {
        let share = length(draft, a, b) / mean(sizes, a, b);
        (share / LONG).max(SHORT / share)
    };
    let mut bad: Vec<_> = inner.map(|s| (miss(s), s)).filter(|(m, _)| *m > 1.0).collect();
    bad.sort_by(|x, y| y.0.total_cmp(&x.0).then(x.1.cmp(&y.1)));
    bad.into_iter().map(|(_, s)| s).collect()
}

struct Round<'a> {
    draft: &'a Draft,
    touched: Vec<bool>,
    removed: Vec<bool>,
    points: Vec<Point>,
}

impl Round<'_> {
    /// Claims both nodes, unless one is taken.
    fn claim(&mut self, a: u32, b: u32) -> bool {
        let free = !self.touched[a as usize] && !self.touched[b as usize];
        if free {
            self.touched[a as usize] = true;
            self.touched[b as usize] = true;
        }
        free
    }

    /// Two inner nodes become one in the middle; a boundary node swallows an inner one; two boundary nodes stay.
    fn contract(&mut self, a: u32, b: u32) {
        let fixed = self.draft.fixed;
        let [a, b] = [a.min(b), a.max(b)];
        if (b as usize) < fixed || !self.claim(a, b) {
            return;
        }
        self.removed[b as usize] = true;
        if a as usize >= fixed {
            self.points[a as usize] = 0.5 * (self.points[a as usize] + self.points[b as usize]);
        }
    }

    fn halve(&mut self, a: u32, b: u32) {
        if self.claim(a, b) {
            let middle = 0.5 * (self.points[a as usize] + self.points[b as usize]);
            self.points.push(middle);
        }
    }

    /// Puts a node before each boundary node whose two sides belong to one triangle though the corner is not sharp.
    fn open_corners(&mut self) {
        for &triangle in &self.draft.triangles {
            let Fault::Corner { node, inward, .. } = fault(self.draft, triangle) else { continue };
            if !std::mem::replace(&mut self.touched[node as usize], true) {
                let corner = self.draft.points[node as usize];
                // √3/2 of the sides: an equilateral triangle's height.
                self.points.push(corner + 0.866 * inward);
            }
        }
    }
}
