//! In which order a sweep visits the slots, and what may run side by side.
//!
//! The slots inside a macro-triangle meet those of other macro-triangles only across its sides. So a sweep takes first the
//! interface (nodes on sides and corners of macro-triangles), one after the other, and then all insides at once: the same numbers
//! for any number of threads.

use super::Disorder;
use crate::sparse::BlockMatrix;
use std::ops::Range;

/// Consecutive slots.
pub type Slots = Range<u32>;

/// The order of a forward sweep; a backward sweep runs through it from the end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Order {
    /// Slots that are visited first, one after the other.
    interface: Vec<Slots>,
    /// Groups without couplings between them, each visited one after the other.
    parts: Vec<Vec<Slots>>,
}

impl Order {
    /// The natural order of `slots` slots.
    pub fn natural(slots: usize) -> Self {
        Self { interface: std::iter::once(0..slots as u32).collect(), parts: Vec::new() }
    }

    /// The order with these independent parts; all other slots of `matrix` are interface.
    ///
    /// # Errors
    /// [`Disorder`] for a slot that lies in two parts or outside the matrix, or couples with another part's.
    pub fn new(matrix: &BlockMatrix, parts: Vec<Vec<Slots>>) -> Result<Self, Disorder> {
        let owner = owners(matrix.rows(), &parts)?;
        check_independence(matrix, &owner)?;
        Ok(Self { interface: gaps(&owner), parts })
    }

    /// The interface without these slots.
    pub fn without(mut self, mut slots: Vec<u32>) -> Self {
        slots.sort_unstable();
        let mut kept = Vec::with_capacity(self.interface.len() + slots.len());
        for range in self.interface {
            let mut start = range.start;
            let first = slots.partition_point(|&s| s < range.start);
            for &slot in slots[first..].iter().take_while(|s| **s < range.end) {
                kept.push(start..slot);
                start = slot + 1;
            }
            kept.push(start..range.end);
        }
        self.interface = kept.into_iter().filter(|r| !r.is_empty()).collect();
        self
    }

    /// Slots visited first.
    pub fn interface(&self) -> &[Slots] {
        &self.interface
    }

    /// Independent groups.
    pub fn parts(&self) -> &[Vec<Slots>] {
        &self.parts
    }
}

/// No part.
const INTERFACE: u32 = u32::MAX;

fn owners(rows: usize, parts: &[Vec<Slots>]) -> Result<Vec<u32>, Disorder> {
    let mut owner = vec![INTERFACE; rows];
    for (part, slots) in parts.iter().enumerate() {
        for slot in slots.iter().cloned().flatten() {
            match owner.get_mut(slot as usize) {
                Some(owner) if *owner == INTERFACE => *owner = part as u32,
                _ => return Err(Disorder { slot, other: slot }),
            }
        }
    }
    Ok(owner)
}

fn check_independence(matrix: &BlockMatrix, owner: &[u32]) -> Result<(), Disorder> {
    use rayon::prelude::*;
    let meets_another = |&i: &usize| {
        owner[i] != INTERFACE && matrix.columns_of(i).iter().any(|&j| is_another(owner[i], owner[j as usize]))
    };
    let found = (0..matrix.rows()).into_par_iter().with_min_len(4096).find_first(meets_another);
    let Some(i) = found else { return Ok(()) };
    let other = matrix.row(i).map(|(j, _)| j).find(|&j| is_another(owner[i], owner[j])).unwrap_or(i);
    Err(Disorder { slot: i as u32, other: other as u32 })
}

fn is_another(part: u32, other: u32) -> bool {
    other != INTERFACE && other != part
}

/// Runs of slots without a part.
fn gaps(owner: &[u32]) -> Vec<Slots> {
    let mut gaps: Vec<Slots> = Vec::new();
    for slot in (0..owner.len()).filter(|&i| owner[i] == INTERFACE).map(|i| i as u32) {
        match gaps.last_mut() {
            Some(last) if last.end == slot => last.end += 1,
            _ => gaps.push(slot..slot + 1),
        }
    }
    gaps
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of seven slots.
    fn chain() -> BlockMatrix {
        let (mut row_start, mut columns) = (vec![0], Vec::new());
        for i in 0..7_u32 {
            columns.extend(i.saturating_sub(1)..=(i + 1).min(6));
            row_start.push(columns.len() as u32);
        }
        let blocks = vec![[1.0; 4]; columns.len()];
        BlockMatrix::new(row_start, columns, blocks)
    }

    #[test]
    fn what_no_part_claims_is_interface() {
        let order = Order::new(&chain(), vec![vec![0..2], vec![3..5, 5..6]]).unwrap();
        assert_eq!(order.interface(), [2..3, 6..7]);
        assert!(order.without(vec![6]).interface().iter().eq(std::iter::once(&(2..3))));
        let order = Order::natural(7).without(vec![0, 3, 4]);
        assert_eq!(order.interface(), [1..3, 5..7]);
    }

    #[test]
    fn parts_that_meet_are_refused() {
        let refused = |parts| Order::new(&chain(), parts).unwrap_err();
        assert_eq!(refused(vec![vec![0..3], vec![3..7]]), Disorder { slot: 2, other: 3 });
        assert_eq!(refused(vec![vec![0..3], vec![2..4]]), Disorder { slot: 2, other: 2 });
        assert_eq!(refused(vec![vec![5..8]]), Disorder { slot: 7, other: 7 });
    }
}
