//! Which combinations of a pair's free displacement components become its unknowns.

use super::{NodeSupport, PairBlock};
use crate::Error;
use crate::geometry::{Vec2, tangent_of};
use crate::zone::{Constraint, ConstraintKind, ContactPair};
use nalgebra::{DMatrix, DVector};

/// A row of `∂(n·d)/∂z` shorter than this vanishes.
const NO_ROW: f64 = 1e-10;

/// `(row, value, constraint)`: which row of `x` a constraint became, and its upper bound or, if bilateral, its value.
type Constrained = Vec<(usize, f64, usize)>;

/// The rows of `x = rows · z`, the constraints among them, and which coordinates `z` stands for.
pub(super) struct Chosen {
    pub rows: DMatrix<f64>,
    pub bounds: Constrained,
    pub held: Constrained,
}

pub(super) fn choose_basis(pair: &ContactPair, supports: [&NodeSupport; 2]) -> Result<Chosen, Error> {
    let Rows { mut rows, bounds, held } = constraint_rows(pair, supports)?;
    complete(&mut rows, pair.constraints[0].normal, supports);
    let free = supports[0].free.len() + supports[1].free.len();
    Ok(Chosen { rows: DMatrix::from_fn(rows.len(), free, |i, j| rows[i][j]), bounds, held })
}

#[derive(Default)]
struct Rows {
    rows: Vec<DVector<f64>>,
    bounds: Constrained,
    held: Constrained,
}

/// The rows of the constraints that the supports do not decide; bilateral ones first, since they decide others.
fn constraint_rows(pair: &ContactPair, supports: [&NodeSupport; 2]) -> Result<Rows, Error> {
    let mut chosen = Rows::default();
    let fixed_jump = supports[0].offset - supports[1].offset;
    let size = supports.map(|s| s.offset.norm()).iter().sum();
    for kind in [ConstraintKind::Bilateral, ConstraintKind::Unilateral] {
        for (k, c) in pair.constraints.iter().enumerate().filter(|(_, c)| c.kind == kind) {
            let row = jump_row(c.normal, supports);
            let value = c.gap - c.normal.dot(&fixed_jump);
            if row.norm() < NO_ROW {
                refuse_inadmissible(c, value, size)?;
            } else if is_independent(&chosen.rows, &row) {
                let of_kind = if kind == ConstraintKind::Bilateral { &mut chosen.held } else { &mut chosen.bounds };
                of_kind.push((chosen.rows.len(), value, k));
                chosen.rows.push(row);
            } else if let Some(&(_, held, _)) = chosen.held.first() {
                // n·d = ratio · n_held·d is known
                let ratio = row.dot(&chosen.rows[0]) / chosen.rows[0].norm_squared();
                refuse_inadmissible(c, value - ratio * held, size)?;
            } else {
                merge_bound(&chosen.rows[0], &row, value, k, &mut chosen.bounds)?;
            }
        }
    }
    Ok(chosen)
}

/// Greedy completion: the jump's tangential and normal part, then `u''` in order, then `u'`.
fn complete(rows: &mut Vec<DVector<f64>>, normal: Vec2, supports: [&NodeSupport; 2]) {
    let (first, free) = (supports[0].free.len(), supports[0].free.len() + supports[1].free.len());
    let coordinate = |k: usize| DVector::from_fn(free, |i, _| f64::from(u8::from(i == k)));
    let jump = [tangent_of(normal), normal].map(|m| jump_row(m, supports));
    for candidate in jump.into_iter().chain((first..free).chain(0..first).map(coordinate)) {
        if rows.len() < free && candidate.norm() > NO_ROW && is_independent(rows, &candidate) {
            rows.push(candidate);
        }
    }
}

impl Chosen {
    /// `T` and its left inverse in the components of the two nodes' displacements.
    pub fn block(&self, nodes: [u32; 2], supports: [&NodeSupport; 2]) -> Result<PairBlock, Error> {
        let free = self.rows.ncols();
        let directions: Vec<(usize, Vec2)> =
            (0..2).flat_map(|body| supports[body].free.iter().map(move |&f| (2 * body, f))).collect();
        // F: z → (u', u''), with orthonormal columns.
        let f = DMatrix::from_fn(4, free, |i, j| {
            let (top, direction) = directions[j];
            if i == top {
                direction.x
            } else if i == top + 1 {
                direction.y
            } else {
                0.0
            }
        });
        let inverse = self.rows.clone().try_inverse().filter(|_| self.rows.nrows() == free).ok_or_else(|| {
            Error::Boundary(format!(
                "contact pair of nodes {} and {}: its change of basis is singular",
                nodes[0], nodes[1]
            ))
        })?;
        let (t, r) = (&f * inverse, &self.rows * f.transpose());
        let mut block = PairBlock { nodes, t: [[0.0; 4]; 4], r: [[0.0; 4]; 4] };
        for i in 0..4 {
            for j in 0..free {
                block.t[i][j] = t[(i, j)];
                block.r[j][i] = r[(j, i)];
            }
        }
        Ok(block)
    }
}

/// `∂(m·d)/∂z` for a direction `m`.
fn jump_row(m: Vec2, supports: [&NodeSupport; 2]) -> DVector<f64> {
    let first = supports[0].free.iter().map(|f| m.dot(f));
    let second = supports[1].free.iter().map(|f| -m.dot(f));
    DVector::from_iterator(supports[0].free.len() + supports[1].free.len(), first.chain(second))
}

/// Whether `row` keeps a share of its length after projection off the span of `rows`.
fn is_independent(rows: &[DVector<f64>], row: &DVector<f64>) -> bool {
    let mut basis: Vec<DVector<f64>> = Vec::with_capacity(rows.len());
    for r in rows.iter().chain(std::iter::once(row)) {
        let mut rest = r.clone();
        // Twice is enough for orthogonality to rounding.
        for _ in 0..2 {
            for b in &basis {
                rest -= b * b.dot(&rest);
            }
        }
        let length = rest.norm();
        if length < crate::zone::SAME_NORMAL * r.norm() {
            return false;
        }
        basis.push(rest / length);
    }
    true
}

/// A constraint that something else decides must hold: what is left of the gap, `slack`, may not be negative, and must
/// vanish where the constraint is bilateral. `size` is that of the prescribed displacements: their difference is the gap only to
/// rounding.
fn refuse_inadmissible(c: &Constraint, slack: f64, size: f64) -> Result<(), Error> {
    let rounding = 1e-12 * (c.gap.abs() + size);
    if slack.abs() <= rounding || (slack > 0.0 && c.kind == ConstraintKind::Unilateral) {
        return Ok(());
    }
    if slack > 0.0 {
        return Err(Error::Boundary(format!(
            "the prescribed displacements of a bilateral contact pair part by {slack:.3e} along the normal ({}, {}) and no free \
             component can change that; make the data of both bodies agree there, or let the bilateral part end before it",
            c.normal.x, c.normal.y
        )));
    }
    Err(Error::Boundary(format!(
        "the prescribed displacements of a contact pair penetrate by {:.3e} along the normal ({}, {}) and no free component \
         can change that; make the data on both bodies admissible there",
        -slack, c.normal.x, c.normal.y
    )))
}

/// Two constraints on one scalar: the tighter bound stays. Opposite ones would bound it from both sides.
fn merge_bound(
    row: &DVector<f64>,
    other: &DVector<f64>,
    upper: f64,
    k: usize,
    bounds: &mut [(usize, f64, usize)],
) -> Result<(), Error> {
    let ratio = row.dot(other) / row.norm_squared();
    if ratio < 0.0 {
        return Err(Error::Boundary(
            "a contact corner is held by its supports so that its two constraints bound one component from both sides; \
             move the corner off the support or support both bodies there"
                .into(),
        ));
    }
    if upper / ratio < bounds[0].1 {
        bounds[0] = (bounds[0].0, upper / ratio, k);
    }
    Ok(())
}
