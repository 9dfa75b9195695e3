//! The linear cycle on a face: what corrects a fine level from the coarser ones.

use super::block::{self, Block};
use super::coarsest::{Coarsest, frozen_dofs};
use super::order::Order;
use super::sweep::{Direction, Limits, Sweep};
use super::transfer::Transfer;
use super::{Levels, motion, vector};
use crate::qp::{Bound, BoundQp};
use crate::sparse::BlockMatrix;

/// Sweeps before and after each coarse correction, at most.
const MOST_SWEEPS: usize = 2;

/// One level with everything a sweep needs.
pub struct Grid<'a> {
    pub matrix: &'a BlockMatrix,
    pub bounds: &'a [Bound],
    pub blocks: Vec<Block>,
    pub order: Order,
    /// From the next coarser level; none on the coarsest.
    pub transfer: Option<&'a Transfer<'a>>,
}

impl<'a> Grid<'a> {
    fn new(
        matrix: &'a BlockMatrix,
        bounds: &'a [Bound],
        pairs: &[[u32; 2]],
        order: &Order,
        transfer: Option<&'a Transfer<'a>>,
    ) -> Self {
        let blocks = block::blocks(pairs, bounds);
        let apart = blocks.iter().flat_map(|b| b.slots).filter(|&s| s != block::NONE).collect();
        Self { matrix, bounds, order: order.clone().without(apart), blocks, transfer }
    }

    /// All levels, coarsest first.
    pub fn all(qp: &'a BoundQp, levels: &'a Levels<'a>) -> Vec<Self> {
        let below = |k: usize| (k > 0).then(|| &levels.coarse[k - 1].transfer);
        let coarse = levels.coarse.iter().enumerate();
        let mut grids: Vec<Self> =
            coarse.map(|(k, l)| Self::new(&l.matrix, &l.bounds, &l.pairs, &l.order, below(k))).collect();
        grids.push(Self::new(&qp.matrix, &qp.bounds, &levels.pairs, &levels.order, below(levels.coarse.len())));
        grids
    }

    pub fn dimension(&self) -> usize {
        self.matrix.dimension()
    }

    pub fn sweep(&self) -> Sweep<'_> {
        Sweep { matrix: self.matrix, blocks: &self.blocks, order: &self.order }
    }

    /// `r = f − Kx`.
    pub fn residual(&self, load: &[f64], x: &[f64], r: &mut [f64]) {
        self.matrix.apply(x, r);
        vector::subtract_from(r, load);
    }

    /// Entries of the matrix: what a product costs.
    pub fn entries(&self) -> usize {
        self.matrix.entries()
    }
}

/// Workspace of a coarse level.
#[derive(Default)]
struct Room {
    x: Vec<f64>,
    load: Vec<f64>,
    rest: Vec<f64>,
    frozen: Vec<bool>,
}

/// The V-cycle over all levels below a fine one.
pub struct Cycle<'a> {
    grids: &'a [Grid<'a>],
    motions: &'a [Vec<f64>],
    rooms: Vec<Room>,
    coarsest: Coarsest,
    /// Sweeps before and after each coarse correction.
    sweeps: usize,
    /// Matrix entries visited on the coarse levels so far.
    pub visited: usize,
}

impl<'a> Cycle<'a> {
    pub fn new(grids: &'a [Grid<'a>], motions: &'a [Vec<f64>]) -> Self {
        let room = |g: &Grid| {
            let zeros = || vec![0.0; g.dimension()];
            Room { x: zeros(), load: zeros(), rest: zeros(), frozen: vec![false; g.bounds.len()] }
        };
        let rooms = grids[..grids.len() - 1].iter().map(room).collect();
        Self { grids, motions, rooms, coarsest: Coarsest::default(), sweeps: 1, visited: 0 }
    }

    /// The correction on grid `fine` for the residual `rest` there, with the components held that [`freeze`](Self::freeze) was
    /// told of: `rest` is used up and becomes the correction.
    pub fn correct(&mut self, fine: usize, frozen: &[bool], rest: &mut [f64]) {
        self.from_below(fine, frozen, rest);
    }

    /// Where one sweep on each side is too little, as near incompressibility.
    pub fn sweep_more(&mut self) {
        self.sweeps = MOST_SWEEPS;
    }

    /// Whether the supports leave any rigid motion free.
    pub fn has_motions(&self) -> bool {
        !self.motions.is_empty()
    }

    /// The rigid motions that supports and frozen components leave free, on grid `fine`.
    pub fn free_motions(&self, fine: usize) -> Vec<Vec<f64>> {
        let held = match self.rooms.first() {
            Some(room) => frozen_dofs(self.grids[0].bounds, &room.frozen),
            None => Vec::new(),
        };
        let mut motions = motion::free(self.motions, &held);
        for grid in &self.grids[1..=fine] {
            for motion in &mut motions {
                let mut finer = vec![0.0; grid.dimension()];
                if let Some(transfer) = grid.transfer {
                    transfer.prolong(motion, &mut finer);
                }
                *motion = finer;
            }
        }
        motions
    }

    /// Factorisations on the coarsest level.
    pub fn factorizations(&self) -> usize {
        self.coarsest.factorizations()
    }

    /// Passes the frozen components down: a coarse bound is frozen where a frozen fine component depends on it.
    pub fn freeze(&mut self, fine: usize, frozen: &[bool]) {
        let mut above = frozen.to_vec();
        for k in (0..fine).rev() {
            let (coarse, grid) = (&self.grids[k], &self.grids[k + 1]);
            let mut below = vec![false; coarse.bounds.len()];
            if let Some(transfer) = grid.transfer {
                for dof in frozen_dofs(grid.bounds, &above) {
                    for origin in transfer.origins(dof as u32) {
                        if let Ok(found) = coarse.bounds.binary_search_by_key(&origin, |b| b.dof) {
                            below[found] = true;
                        }
                    }
                }
            }
            self.rooms[k].frozen.clone_from(&below);
            above = below;
        }
    }

    /// `rest = P (cycle on the next coarser level) Pᵀ rest`, without the frozen components.
    fn from_below(&mut self, fine: usize, frozen: &[bool], rest: &mut [f64]) {
        let grid = &self.grids[fine];
        let Some(transfer) = grid.transfer else { return };
        let held = frozen_dofs(grid.bounds, frozen);
        held.iter().for_each(|&i| rest[i] = 0.0);
        let mut room = std::mem::take(&mut self.rooms[fine - 1]);
        transfer.restrict(grid.matrix, rest, &mut room.load);
        self.cycle(fine - 1, &mut room);
        transfer.prolong(&room.x, rest);
        held.iter().for_each(|&i| rest[i] = 0.0);
        self.rooms[fine - 1] = room;
    }

    /// `x ≈ K⁻¹ f` on the face.
    fn cycle(&mut self, k: usize, room: &mut Room) {
        let grid = &self.grids[k];
        let Room { x, load, rest, frozen } = room;
        frozen_dofs(grid.bounds, frozen).into_iter().for_each(|i| load[i] = 0.0);
        if k == 0 {
            x.copy_from_slice(load);
            self.coarsest.solve(grid.matrix, grid.bounds, frozen, self.motions, x);
            return;
        }
        x.fill(0.0);
        let limits = Limits::Frozen(frozen);
        (0..self.sweeps).for_each(|_| grid.sweep().run(Direction::Forward, limits, load, x));
        grid.residual(load, x, rest);
        self.from_below(k, frozen, rest);
        vector::add(x, 1.0, rest);
        (0..self.sweeps).for_each(|_| grid.sweep().run(Direction::Backward, limits, load, x));
        self.visited += (2 * self.sweeps + 1) * grid.entries();
    }
}
