//! The bilateral part `Γ_K0` of the contact zone, where the bodies may slide along each other but neither part nor overlap.
//!
//! ```text
//!    Γ_K0: n·d = g        Γ_K: n·d ≤ g        Γ_K0 is closed: the node where it ends is bilateral. At a corner each
//!   ══●═════●═════●────────●────────●──       of the two constraints keeps the kind of its own segment.
//! ```

use super::Zone;
use crate::mesh::Mesh;

/// What a constraint asks of the jump `d = u' − u''`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConstraintKind {
    /// `n·d ≤ gap`: the bodies may part.
    #[default]
    Unilateral,
    /// `n·d = gap`: they may not (Remark 3.3). Tension is a legitimate answer.
    Bilateral,
}

impl Zone {
    /// Makes every constraint on these pieces of the zone bilateral, the nodes at their ends included. `pieces` are
    /// numbers of pieces `Γ_K,i` in the order of the contact line, from 0; numbers that do not occur say nothing.
    pub fn make_bilateral(&mut self, mesh: &Mesh, pieces: &[usize]) {
        for (side, ends) in mesh.contact.iter().zip(&self.side_ends) {
            if pieces.contains(&usize::from(side.segment)) {
                for &(pair, constraint) in ends {
                    self.pairs[pair].constraints[constraint].kind = ConstraintKind::Bilateral;
                }
            }
        }
    }
}
