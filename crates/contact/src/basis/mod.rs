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
mod maps;
mod supports;
#[cfg(test)]
mod tests;

pub use supports::{NodeSupport, NodeSupports};

use crate::geometry::{Vec2, tangent_of};
use crate::zone::ContactPair;
use crate::{Error, qp::Bound};
use choose::choose_basis;
use std::collections::BTreeMap;

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
///
/// Almost every node is *plain*: its unknowns are its displacement. Blocks and offsets are kept for the others alone, so a
/// basis takes 2½ bytes per node and what the supports and the zone add.
#[derive(Clone, Debug)]
pub struct Basis {
    /// For each scalar component of `x`, whether it is fixed at zero.
    pub fixed: Vec<bool>,
    /// The bilateral constraints, in the order of the pairs.
    pub held: Vec<Held>,
    /// For each node, whether it has an entry in one of the maps below.
    special: Vec<bool>,
    /// `u_D` where it does not vanish: prescribed displacements, and the gaps of bilateral constraints.
    offset: BTreeMap<u32, Vec2>,
    /// A node's own 2×2 block of `T`, by rows, where it is not the identity.
    own: BTreeMap<u32, [f64; 4]>,
    /// The pair of a node that has one.
    pair_of: BTreeMap<u32, u32>,
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
    pub fn new(supports: &NodeSupports) -> Self {
        let nodes = supports.nodes();
        let mut basis = Self {
            fixed: vec![false; 2 * nodes],
            held: Vec::new(),
            special: vec![false; nodes],
            offset: BTreeMap::new(),
            own: BTreeMap::new(),
            pair_of: BTreeMap::new(),
            pairs: Vec::new(),
        };
        for (node, support) in supports.held() {
            let (i, free) = (node as usize, &support.free);
            (basis.fixed[2 * i], basis.fixed[2 * i + 1]) = (free.is_empty(), free.len() < 2);
            basis.special[i] = true;
            if let [t] = free.as_slice() {
                let n = tangent_of(*t);
                basis.own.insert(node, [t.x, n.x, t.y, n.y]);
            }
            if support.offset != Vec2::zeros() {
                basis.offset.insert(node, support.offset);
            }
        }
        basis
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
            self.pair_of.insert(node, self.pairs.len() as u32);
            self.special[node as usize] = true;
        }
        let block = chosen.block(nodes, supports)?;
        let dofs = slots_of(nodes);
        for &(row, value, constraint) in &chosen.held {
            self.fixed[dofs[row]] = true;
            self.held.push(Held { dof: dofs[row] as u32, origin: BoundOrigin { pair: index, constraint } });
            // u_D += T e_c g
            for (node, top) in nodes.into_iter().zip([0, 2]) {
                *self.offset.entry(node).or_default() += value * Vec2::new(block.t[top][row], block.t[top + 1][row]);
            }
        }
        self.pairs.push(block);
        let bound = |&(row, upper, constraint): &(usize, f64, usize)| {
            (Bound { dof: dofs[row] as u32, upper }, BoundOrigin { pair: index, constraint })
        };
        Ok(chosen.bounds.iter().map(bound).collect())
    }
}

/// The scalar components of `x` that belong to a pair: node `a`'s, then node `b`'s.
fn slots_of(nodes: [u32; 2]) -> [usize; 4] {
    let [a, b] = nodes.map(|i| i as usize);
    [2 * a, 2 * a + 1, 2 * b, 2 * b + 1]
}
