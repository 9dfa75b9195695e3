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
//!
//! A bilateral constraint `n·d = g` is an unknown by the same rule, and then fixed: `u_D` takes its value, `x` has zero there.

mod choose;
#[cfg(test)]
mod tests;

use crate::geometry::{Vec2, tangent_of};
use crate::zone::ContactPair;
use crate::{Error, qp::Bound};
use choose::choose_basis;

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

/// A bilateral constraint: a component of `x` that is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Scalar component of `x`.
    pub dof: u32,
    /// The constraint.
    pub origin: BoundOrigin,
}

/// `u = T x + u_D`, with its left inverse on the free components.
#[derive(Clone, Debug)]
pub struct Basis {
    /// For each node, `u_D`: prescribed displacements, and the gaps of bilateral constraints.
    pub offset: Vec<Vec2>,
    /// For each scalar component of `x`, whether it is fixed at zero.
    pub fixed: Vec<bool>,
    /// The bilateral constraints, in the order of the pairs.
    pub held: Vec<Held>,
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
        Self { offset, fixed, held: Vec::new(), own, pair_of: vec![None; supports.len()], pairs: Vec::new() }
    }

    /// Ties a contact pair: its unilateral constraints become upper bounds on components of `x`, returned with their
    /// constraint; its bilateral ones are added to [`Basis::held`].
    ///
    /// # Errors
    /// [`Error::Boundary`] for supports that contradict a constraint, or bound one component from both sides.
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
        let block = chosen.block(nodes, supports)?;
        let dofs = slots_of(nodes);
        for &(row, value, constraint) in &chosen.held {
            self.fixed[dofs[row]] = true;
            self.held.push(Held { dof: dofs[row] as u32, origin: BoundOrigin { pair: index, constraint } });
            // u_D += T e_c g
            for (node, top) in nodes.into_iter().zip([0, 2]) {
                self.offset[node as usize] += value * Vec2::new(block.t[top][row], block.t[top + 1][row]);
            }
        }
        self.pairs.push(block);
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

    /// The nodes whose displacements the unknowns of block `slot` are made of, `x_slot = Σ block · u_node`; the rows of fixed
    /// components mean nothing.
    pub fn inverse_slots(&self, slot: usize) -> ([Slot; 2], usize) {
        let Some(p) = self.pair_of[slot] else {
            let [a, b, c, d] = self.own[slot];
            return ([(slot as u32, [a, c, b, d]), (0, [0.0; 4])], 1);
        };
        let pair = &self.pairs[p as usize];
        let top = if pair.nodes[0] as usize == slot { 0 } else { 2 };
        let block =
            |left: usize| [pair.r[top][left], pair.r[top][left + 1], pair.r[top + 1][left], pair.r[top + 1][left + 1]];
        ([(pair.nodes[0], block(0)), (pair.nodes[1], block(2))], 2)
    }

    /// Whether the unknowns at a node are its displacement in the plane, both free.
    pub fn is_plain(&self, node: usize) -> bool {
        self.pair_of[node].is_none() && self.own[node] == IDENTITY && !self.fixed[2 * node] && !self.fixed[2 * node + 1]
    }

    /// The nodes of the pairs.
    pub fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.pairs.iter().map(|p| p.nodes)
    }

    /// The same basis on the first `nodes` nodes, those of a coarser mesh; a pair has both of its nodes among them or none.
    pub fn on_first(&self, nodes: usize) -> Self {
        let is_kept = |pair: &PairBlock| pair.nodes.iter().all(|&n| (n as usize) < nodes);
        let mut coarse = Self {
            offset: self.offset[..nodes].to_vec(),
            fixed: self.fixed[..2 * nodes].to_vec(),
            held: self.held.iter().filter(|h| (h.dof as usize) < 2 * nodes).copied().collect(),
            own: self.own[..nodes].to_vec(),
            pair_of: vec![None; nodes],
            pairs: self.pairs.iter().filter(|p| is_kept(p)).cloned().collect(),
        };
        for (p, pair) in coarse.pairs.iter().enumerate() {
            pair.nodes.iter().for_each(|&n| coarse.pair_of[n as usize] = Some(p as u32));
        }
        coarse
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
        let mut x = self.full_force(r);
        x.iter_mut().zip(&self.fixed).filter(|(_, fixed)| **fixed).for_each(|(x, _)| *x = 0.0);
        x
    }

    /// `Tᵀ r` in all components: in a fixed one, what holds it.
    pub fn full_force(&self, r: &[Vec2]) -> Vec<f64> {
        let mut x = vec![0.0; 2 * self.nodes()];
        for (node, r) in r.iter().enumerate() {
            let (slots, n) = self.slots(node);
            for (slot, b) in &slots[..n] {
                let s = *slot as usize;
                x[2 * s] += b[0] * r.x + b[2] * r.y;
                x[2 * s + 1] += b[1] * r.x + b[3] * r.y;
            }
        }
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

/// The scalar components of `x` that belong to a pair: node `a`'s, then node `b`'s.
fn slots_of(nodes: [u32; 2]) -> [usize; 4] {
    let [a, b] = nodes.map(|i| i as usize);
    [2 * a, 2 * a + 1, 2 * b, 2 * b + 1]
}

const IDENTITY: [f64; 4] = [1.0, 0.0, 0.0, 1.0];

fn own_block(free: &[Vec2]) -> [f64; 4] {
    match free {
        [t] => {
            let n = tangent_of(*t);
            [t.x, n.x, t.y, n.y]
        }
        _ => IDENTITY,
    }
}

fn times(b: &[f64; 4], x: Vec2) -> Vec2 {
    Vec2::new(b[0] * x.x + b[1] * x.y, b[2] * x.x + b[3] * x.y)
}

fn block_of(x: &[f64], slot: u32) -> Vec2 {
    Vec2::new(x[2 * slot as usize], x[2 * slot as usize + 1])
}
