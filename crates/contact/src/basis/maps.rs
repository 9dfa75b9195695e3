//! The maps of a basis: from unknowns to displacements and back, from forces to the loads of unknowns.

use super::{Basis, PairBlock, Slot, slots_of};
use crate::geometry::Vec2;
use rayon::prelude::*;

const IDENTITY: [f64; 4] = [1.0, 0.0, 0.0, 1.0];
const NO_SLOT: Slot = (0, [0.0; 4]);

impl Basis {
    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.special.len()
    }

    /// Whether the unknowns at a node are its displacement in the plane, both free.
    #[inline]
    pub fn is_plain(&self, node: usize) -> bool {
        !self.special[node] && !self.fixed[2 * node] && !self.fixed[2 * node + 1]
    }

    /// The nodes of the pairs.
    pub fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.pairs.iter().map(|p| p.nodes)
    }

    /// The two nodes of the pair that a node belongs to, if it does.
    pub fn pair_nodes(&self, node: usize) -> Option<[u32; 2]> {
        self.pair(node).map(|p| p.nodes)
    }

    /// `u_D` at a node.
    pub fn offset(&self, node: usize) -> Vec2 {
        self.offset.get(&(node as u32)).copied().unwrap_or_default()
    }

    /// `u_D` at every node, if it does not vanish.
    pub fn offsets(&self) -> Option<Vec<Vec2>> {
        if self.offset.is_empty() {
            return None;
        }
        let mut all = vec![Vec2::zeros(); self.nodes()];
        self.offset.iter().for_each(|(node, offset)| all[*node as usize] = *offset);
        Some(all)
    }

    /// The blocks of `x` that the displacement of `node` depends on: one, or two in a pair.
    pub fn slots(&self, node: usize) -> ([Slot; 2], usize) {
        let Some(pair) = self.pair(node) else {
            return ([(node as u32, self.own(node)), NO_SLOT], 1);
        };
        (pair.blocks_of(node, &pair.t), 2)
    }

    /// The nodes whose displacements the unknowns of block `slot` are made of, `x_slot = Σ block · (u − u_D)_node`; the rows of
    /// fixed components mean nothing.
    pub fn inverse_slots(&self, slot: usize) -> ([Slot; 2], usize) {
        let Some(pair) = self.pair(slot) else {
            // The own block is orthogonal (columns of fixed components included), so its inverse is its transpose.
            let [a, b, c, d] = self.own(slot);
            return ([(slot as u32, [a, c, b, d]), NO_SLOT], 1);
        };
        (pair.blocks_of(slot, &pair.r), 2)
    }

    /// The same basis on the first `nodes` nodes, those of a coarser mesh; a pair has both of its nodes among them or none.
    pub fn on_first(&self, nodes: usize) -> Self {
        let end = nodes as u32;
        let pairs: Vec<PairBlock> =
            self.pairs.iter().filter(|pair| pair.nodes.iter().all(|&n| n < end)).cloned().collect();
        let numbered = pairs.iter().zip(0..).flat_map(|(pair, p)| pair.nodes.map(|node| (node, p)));
        Self {
            fixed: self.fixed[..2 * nodes].to_vec(),
            held: self.held.iter().filter(|h| h.dof < 2 * end).copied().collect(),
            special: self.special[..nodes].to_vec(),
            offset: self.offset.range(..end).map(|(n, o)| (*n, *o)).collect(),
            own: self.own.range(..end).map(|(n, b)| (*n, *b)).collect(),
            pair_of: numbered.collect(),
            pairs,
        }
    }

    /// The nodal displacements `T x + u_D`.
    pub fn displacement(&self, x: &[f64]) -> Vec<Vec2> {
        let at = |node: usize| {
            if !self.special[node] {
                return Vec2::zeros() + block_of(x, node as u32);
            }
            let (slots, n) = self.slots(node);
            slots[..n].iter().fold(self.offset(node), |u, (slot, b)| u + times(b, block_of(x, *slot)))
        };
        (0..self.nodes()).into_par_iter().with_min_len(4096).map(at).collect()
    }

    /// `Tᵀ r` for a nodal force `r`, zero in the fixed components.
    pub fn force(&self, r: &[Vec2]) -> Vec<f64> {
        let mut x = self.full_force(r);
        self.clear_fixed(&mut x);
        x
    }

    /// `Tᵀ r` in all components: in a fixed one, what holds it.
    pub fn full_force(&self, r: &[Vec2]) -> Vec<f64> {
        let mut x = vec![0.0; 2 * self.nodes()];
        for (node, r) in r.iter().enumerate() {
            if !self.special[node] {
                x[2 * node] += r.x;
                x[2 * node + 1] += r.y;
                continue;
            }
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
        for (node, v) in v.iter().enumerate().filter(|(node, _)| self.pair(*node).is_none()) {
            let [a, b, c, d] = self.own(node);
            // The own block is orthogonal (columns of fixed components included), so its inverse is its transpose.
            (x[2 * node], x[2 * node + 1]) = (a * v.x + c * v.y, b * v.x + d * v.y);
        }
        for pair in &self.pairs {
            let [a, b] = pair.nodes.map(|i| v[i as usize]);
            let u = [a.x, a.y, b.x, b.y];
            for (row, dof) in pair.r.iter().zip(slots_of(pair.nodes)) {
                x[dof] = (0..4).map(|k| row[k] * u[k]).sum();
            }
        }
        self.clear_fixed(&mut x);
        x
    }

    fn clear_fixed(&self, x: &mut [f64]) {
        x.iter_mut().zip(&self.fixed).filter(|(_, fixed)| **fixed).for_each(|(x, _)| *x = 0.0);
    }

    /// The node's own 2×2 block of `T`.
    fn own(&self, node: usize) -> [f64; 4] {
        if self.special[node] { self.own.get(&(node as u32)).copied().unwrap_or(IDENTITY) } else { IDENTITY }
    }

    fn pair(&self, node: usize) -> Option<&PairBlock> {
        let pair = if self.special[node] { self.pair_of.get(&(node as u32)) } else { None };
        pair.map(|&p| &self.pairs[p as usize])
    }
}

impl PairBlock {
    /// The two 2×2 blocks of `matrix` in the rows of `node`.
    fn blocks_of(&self, node: usize, matrix: &[[f64; 4]; 4]) -> [Slot; 2] {
        let top = if self.nodes[0] as usize == node { 0 } else { 2 };
        let [upper, lower] = [matrix[top], matrix[top + 1]];
        let block = |left: usize| [upper[left], upper[left + 1], lower[left], lower[left + 1]];
        [(self.nodes[0], block(0)), (self.nodes[1], block(2))]
    }
}

fn times(b: &[f64; 4], x: Vec2) -> Vec2 {
    Vec2::new(b[0] * x.x + b[1] * x.y, b[2] * x.x + b[3] * x.y)
}

fn block_of(x: &[f64], slot: u32) -> Vec2 {
    Vec2::new(x[2 * slot as usize], x[2 * slot as usize + 1])
}
