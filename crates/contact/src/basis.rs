//! The change of basis in which supports fix components and contact constraints are bounds.
//!
//! ```text
//! u = T x + u_D,   T block diagonal but for pairs
//! node on Γ_0:     u = (n | t) x,  x_n fixed
//! contact pair:    x = (n·d, t·d, u'')      or at a corner (n¹·d, n²·d, u''),   d = u' − u''
//! ```
//!
//! A pair whose nodes are held by `Γ_u` or `Γ_0` follows one rule. Let `z` be the free displacement components of its
//! two nodes. A constraint whose row `∂(n·d)/∂z` vanishes is decided by the supports: it is dropped, and the fixed gap
//! must then be admissible. The other rows become the first unknowns; the basis is completed greedily by the
//! components of `d`, then of `u''`, then of `u'`. So a pair clamped in `Ω''` keeps `x = d = u'`.

use crate::geometry::{Vec2, tangent_of};
use crate::zone::{Constraint, ContactPair};
use crate::{Error, qp::Bound};
use nalgebra::{DMatrix, DVector};

/// A row of `∂(n·d)/∂z` shorter than this vanishes.
const NO_ROW: f64 = 1e-10;

/// What a node may do: the orthonormal directions left free and the prescribed displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeSupport {
    /// Free directions: two, one (on `Γ_0`) or none (on `Γ_u`).
    pub free: Vec<Vec2>,
    /// The prescribed part `u_D`, zero unless on `Γ_u`.
    pub offset: Vec2,
}

impl NodeSupport {
    /// A node that is not held.
    pub fn unsupported() -> Self {
        Self { free: vec![Vec2::x(), Vec2::y()], offset: Vec2::zeros() }
    }
}

/// A bound with the constraint it came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundOrigin {
    /// Pair in the zone.
    pub pair: usize,
    /// Constraint of the pair.
    pub constraint: usize,
}

/// `u = T x + u_D`, with its left inverse on the free components.
#[derive(Clone, Debug)]
pub struct Basis {
    /// For each node, `u_D`.
    pub offset: Vec<Vec2>,
    /// For each scalar component of `x`, whether it is fixed at zero.
    pub fixed: Vec<bool>,
    /// For each node, its own 2×2 block of `T`, by rows.
    own: Vec<[f64; 4]>,
    /// For each node, its pair if it has one.
    pair_of: Vec<Option<u32>>,
    /// The blocks of the pairs.
    pairs: Vec<PairBlock>,
}

#[derive(Clone, Debug)]
struct PairBlock {
    nodes: [u32; 2],
    /// `(u'_a, u''_b) = T (x_a, x_b)`, 4×4 by rows.
    t: [[f64; 4]; 4],
    /// `(x_a, x_b) = R (u'_a, u''_b)`.
    r: [[f64; 4]; 4],
}

/// One unknown block that a node's displacement depends on: `u_node += block · x_slot`.
pub type Slot = (u32, [f64; 4]);

impl Basis {
    /// The basis of single nodes alone: rotated on `Γ_0`, the identity elsewhere.
    pub fn new(supports: &[NodeSupport]) -> Self {
        let own = supports.iter().map(|s| own_block(&s.free)).collect();
        let fixed = supports.iter().flat_map(|s| [s.free.is_empty(), s.free.len() < 2]).collect();
        let offset = supports.iter().map(|s| s.offset).collect();
        Self { offset, fixed, own, pair_of: vec![None; supports.len()], pairs: Vec::new() }
    }

    /// Ties a contact pair: its constraints become upper bounds on components of `x`, returned with their constraint.
    pub fn tie(
        &mut self,
        index: usize,
        pair: &ContactPair,
        supports: [&NodeSupport; 2],
    ) -> Result<Vec<(Bound, BoundOrigin)>, Error> {
        let nodes = [pair.first, pair.second];
        let chosen = choose_basis(pair, supports)?;
        for (k, &dof) in slots_of(nodes).iter().enumerate() {
            self.fixed[dof] = k >= chosen.rows.nrows();
        }
        for node in nodes {
            self.pair_of[node as usize] = Some(self.pairs.len() as u32);
        }
        self.pairs.push(chosen.block(nodes, supports)?);
        let dofs = slots_of(nodes);
        let bound = |&(row, upper, constraint): &(usize, f64, usize)| {
            (Bound { dof: dofs[row] as u32, upper }, BoundOrigin { pair: index, constraint })
        };
        Ok(chosen.bounds.iter().map(bound).collect())
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.own.len()
    }

    /// The blocks of `x` that the displacement of `node` depends on: one, or two in a pair.
    pub fn slots(&self, node: usize) -> ([Slot; 2], usize) {
        let Some(p) = self.pair_of[node] else {
            return ([(node as u32, self.own[node]), (0, [0.0; 4])], 1);
        };
        let pair = &self.pairs[p as usize];
        let top = if pair.nodes[0] as usize == node { 0 } else { 2 };
        let block =
            |left: usize| [pair.t[top][left], pair.t[top][left + 1], pair.t[top + 1][left], pair.t[top + 1][left + 1]];
        ([(pair.nodes[0], block(0)), (pair.nodes[1], block(2))], 2)
    }

    /// The nodal displacements `T x + u_D`.
    pub fn displacement(&self, x: &[f64]) -> Vec<Vec2> {
        let at = |node: usize| {
            let (slots, n) = self.slots(node);
            slots[..n].iter().fold(self.offset[node], |u, (slot, b)| u + times(b, block_of(x, *slot)))
        };
        (0..self.nodes()).map(at).collect()
    }

    /// `Tᵀ r` for a nodal force `r`, zero in the fixed components.
    pub fn force(&self, r: &[Vec2]) -> Vec<f64> {
        let mut x = vec![0.0; 2 * self.nodes()];
        for (node, r) in r.iter().enumerate() {
            let (slots, n) = self.slots(node);
            for (slot, b) in &slots[..n] {
                let s = *slot as usize;
                x[2 * s] += b[0] * r.x + b[2] * r.y;
                x[2 * s + 1] += b[1] * r.x + b[3] * r.y;
            }
        }
        x.iter_mut().zip(&self.fixed).filter(|(_, fixed)| **fixed).for_each(|(x, _)| *x = 0.0);
        x
    }

    /// The components `x` with `T x = v`, for a nodal field `v` that respects the supports with zero data.
    pub fn coordinates(&self, v: &[Vec2]) -> Vec<f64> {
        let mut x = vec![0.0; 2 * self.nodes()];
        for (node, b) in self.own.iter().enumerate().filter(|(node, _)| self.pair_of[*node].is_none()) {
            // The own block is orthogonal (columns of fixed components included), so its inverse is its transpose.
            x[2 * node] = b[0] * v[node].x + b[2] * v[node].y;
            x[2 * node + 1] = b[1] * v[node].x + b[3] * v[node].y;
        }
        for pair in &self.pairs {
            let [a, b] = pair.nodes.map(|i| v[i as usize]);
            let u = [a.x, a.y, b.x, b.y];
            for (row, dof) in pair.r.iter().zip(slots_of(pair.nodes)) {
                x[dof] = (0..4).map(|k| row[k] * u[k]).sum();
            }
        }
        x.iter_mut().zip(&self.fixed).filter(|(_, fixed)| **fixed).for_each(|(x, _)| *x = 0.0);
        x
    }
}

/// The rows of `x = rows · z`, the bounds `(row, upper, constraint)`, and which coordinates `z` stands for.
struct Chosen {
    rows: DMatrix<f64>,
    bounds: Vec<(usize, f64, usize)>,
}

fn choose_basis(pair: &ContactPair, supports: [&NodeSupport; 2]) -> Result<Chosen, Error> {
    let free = supports[0].free.len() + supports[1].free.len();
    let mut rows: Vec<DVector<f64>> = Vec::with_capacity(4);
    let mut bounds: Vec<(usize, f64, usize)> = Vec::new();
    let fixed_jump = supports[0].offset - supports[1].offset;
    for (k, c) in pair.constraints.iter().enumerate() {
        let row = jump_row(c.normal, supports);
        let upper = c.gap - c.normal.dot(&fixed_jump);
        if row.norm() < NO_ROW {
            refuse_inadmissible(c, upper, fixed_jump.norm())?;
        } else if is_independent(&rows, &row) {
            bounds.push((rows.len(), upper, k));
            rows.push(row);
        } else {
            merge_bound(&rows[0], &row, upper, k, &mut bounds)?;
        }
    }
    let normal = pair.constraints[0].normal;
    let coordinates = (0..free).rev().map(|k| DVector::from_fn(free, |i, _| f64::from(u8::from(i == k))));
    // Greedy completion: the jump's tangential and normal part, then u'' (the later coordinates) in order, then u'.
    let second = supports[0].free.len();
    let mut candidates: Vec<DVector<f64>> = vec![jump_row(tangent_of(normal), supports), jump_row(normal, supports)];
    let all: Vec<_> = coordinates.collect();
    candidates.extend((second..free).map(|k| all[free - 1 - k].clone()));
    candidates.extend((0..second).map(|k| all[free - 1 - k].clone()));
    for candidate in candidates {
        if rows.len() < free && candidate.norm() > NO_ROW && is_independent(&rows, &candidate) {
            rows.push(candidate);
        }
    }
    let matrix = DMatrix::from_fn(rows.len(), free, |i, j| rows[i][j]);
    Ok(Chosen { rows: matrix, bounds })
}

impl Chosen {
    /// `T` and its left inverse in the components of the two nodes' displacements.
    fn block(&self, nodes: [u32; 2], supports: [&NodeSupport; 2]) -> Result<PairBlock, Error> {
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

fn refuse_inadmissible(c: &Constraint, upper: f64, size: f64) -> Result<(), Error> {
    if upper >= -1e-12 * (1.0 + size) {
        return Ok(());
    }
    Err(Error::Boundary(format!(
        "the prescribed displacements of a contact pair penetrate by {:.3e} along the normal ({}, {}) and no free component \
         can change that; make the data on both bodies admissible there",
        -upper, c.normal.x, c.normal.y
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

/// The scalar components of `x` that belong to a pair: node `a`'s, then node `b`'s.
fn slots_of(nodes: [u32; 2]) -> [usize; 4] {
    let [a, b] = nodes.map(|i| i as usize);
    [2 * a, 2 * a + 1, 2 * b, 2 * b + 1]
}

fn own_block(free: &[Vec2]) -> [f64; 4] {
    match free {
        [t] => {
            let n = tangent_of(*t);
            [t.x, n.x, t.y, n.y]
        }
        _ => [1.0, 0.0, 0.0, 1.0],
    }
}

fn times(b: &[f64; 4], x: Vec2) -> Vec2 {
    Vec2::new(b[0] * x.x + b[1] * x.y, b[2] * x.x + b[3] * x.y)
}

fn block_of(x: &[f64], slot: u32) -> Vec2 {
    Vec2::new(x[2 * slot as usize], x[2 * slot as usize + 1])
}

#[cfg(test)]
#[path = "basis_tests.rs"]
mod tests;
