//! The linear cycle on a face: what corrects a fine level from the coarser ones.

use super::block::{self, Block};
use super::coarsest::{Coarsest, frozen_dofs};
use super::order::Order;
use super::sweep::{Direction, Limits, Sweep};
use super::transfer::Transfer;
use super::truncate::Undo;
use super::{Levels, motion, vector};
use crate::qp::{Bound, BoundQp};
use crate::sparse::BlockMatrix;
use std::borrow::Cow;
use std::cell::{Ref, RefCell};

/// Coarse corrections on each level, and sweeps before and after them, at most.
const MOST_REPEATS: usize = 2;

/// One level with everything a sweep needs.
pub struct Grid<'a> {
    /// A coarse level's changes with the active set.
    matrix: RefCell<Cow<'a, BlockMatrix>>,
    pub bounds: Cow<'a, [Bound]>,
    blocks: Vec<Block>,
    order: Order,
    /// From the next coarser level; none on the coarsest.
    pub transfer: Option<Transfer<'a>>,
}

impl<'a> Grid<'a> {
    fn new(
        matrix: Cow<'a, BlockMatrix>,
        bounds: Cow<'a, [Bound]>,
        pairs: &[[u32; 2]],
        order: Order,
        transfer: Option<Transfer<'a>>,
    ) -> Self {
        let blocks = block::blocks(pairs, &bounds);
        let apart = blocks.iter().flat_map(|b| b.slots).filter(|&s| s != block::NONE).collect();
        Self { matrix: RefCell::new(matrix), bounds, order: order.without(apart), blocks, transfer }
    }

    /// All levels, coarsest first.
    pub fn all(qp: &'a BoundQp, levels: Levels<'a>) -> Vec<Self> {
        let mut grids = Vec::with_capacity(levels.coarse.len() + 1);
        let mut below = None;
        for level in levels.coarse {
            let (matrix, bounds) = (Cow::Owned(level.matrix), Cow::Owned(level.bounds));
            grids.push(Self::new(matrix, bounds, &level.pairs, level.order, below.replace(level.transfer)));
        }
        let (matrix, bounds) = (Cow::Borrowed(&qp.matrix), Cow::Borrowed(&qp.bounds[..]));
        grids.push(Self::new(matrix, bounds, &levels.pairs, levels.order, below));
        grids
    }

    /// The matrix as it is now.
    pub fn matrix(&self) -> Ref<'_, Cow<'a, BlockMatrix>> {
        self.matrix.borrow()
    }

    pub fn dimension(&self) -> usize {
        self.matrix().dimension()
    }

    /// Relaxes every slot once.
    pub fn sweep(&self, direction: Direction, limits: Limits, load: &[f64], x: &mut [f64]) {
        let matrix = self.matrix();
        Sweep { matrix: &matrix, blocks: &self.blocks, order: &self.order }.run(direction, limits, load, x);
    }

    /// `r = f − Kx`.
    pub fn residual(&self, load: &[f64], x: &[f64], r: &mut [f64]) {
        self.matrix().apply(x, r);
        vector::subtract_from(r, load);
    }

    /// Entries of the matrix: what a product costs.
    pub fn entries(&self) -> usize {
        self.matrix().entries()
    }
}

/// What is left of the function of a bounded component.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    /// All of it.
    Whole,
    /// A part, on the components that are not frozen.
    Cut,
    /// Nothing.
    Frozen,
}

fn find(bounds: &[Bound], dof: u32) -> Option<usize> {
    bounds.binary_search_by_key(&dof, |b| b.dof).ok()
}

/// The states of a level's bounded components from those of the next finer level's.
fn below(coarse: &[Bound], fine: &[Bound], transfer: &Transfer, above: &[State]) -> Vec<State> {
    let mut left = vec![[false; 2]; coarse.len()];
    for (bound, state) in fine.iter().zip(above) {
        for origin in transfer.origins(bound.dof) {
            if let Some(b) = find(coarse, origin) {
                // whether anything is left, whether anything is missing
                left[b][0] |= *state != State::Frozen;
                left[b][1] |= *state != State::Whole;
            }
        }
    }
    let state = |[left, missing]: &[bool; 2]| match (left, missing) {
        (_, false) => State::Whole,
        (true, true) => State::Cut,
        (false, true) => State::Frozen,
    };
    left.iter().map(state).collect()
}

/// Workspace of a coarse level.
#[derive(Default)]
struct Room {
    x: Vec<f64>,
    load: Vec<f64>,
    rest: Vec<f64>,
    frozen: Vec<bool>,
    /// How to bring back the matrix of whole functions.
    undo: Undo,
}

/// The cycle over all levels below a fine one: a V-cycle, or a W-cycle where that is too little.
pub struct Cycle<'a> {
    grids: &'a [Grid<'a>],
    motions: &'a [Vec<f64>],
    rooms: Vec<Room>,
    /// Those of the motions that the frozen components leave free, on the coarsest level.
    free: Vec<Vec<f64>>,
    /// Those that leave the coarsest level's own frozen components at rest. On curved bodies these are others: a turn of the coarse mesh in
    /// its hollow is none of the fine one.
    own: Vec<Vec<f64>>,
    /// The level and the active set that the coarse levels stand for.
    face: Option<(usize, Vec<bool>)>,
    coarsest: Coarsest,
    /// Coarse corrections on each level, and sweeps before and after them.
    repeats: usize,
    /// Matrix entries visited on the coarse levels so far.
    pub visited: usize,
}

impl<'a> Cycle<'a> {
    pub fn new(grids: &'a [Grid<'a>], motions: &'a [Vec<f64>]) -> Self {
        let room = |g: &Grid| {
            let zeros = || vec![0.0; g.dimension()];
            Room {
                x: zeros(),
                load: zeros(),
                rest: zeros(),
                frozen: vec![false; g.bounds.len()],
                undo: Undo::default(),
            }
        };
        let rooms = grids[..grids.len() - 1].iter().map(room).collect();
        Self {
            grids,
            motions,
            rooms,
            free: Vec::new(),
            own: Vec::new(),
            face: None,
            coarsest: Coarsest::default(),
            repeats: 1,
            visited: 0,
        }
    }

    /// The correction on grid `fine` for the residual `rest` there, with the components held that [`freeze`](Self::freeze) was
    /// told of: `rest` is used up and becomes the correction.
    pub fn correct(&mut self, fine: usize, frozen: &[bool], rest: &mut [f64]) {
        self.correct_from_below(fine, frozen, rest);
    }

    /// Where a V-cycle with one sweep on each side is too little, as near incompressibility: from now on a W-cycle with two.
    pub fn work_harder(&mut self) {
        self.repeats = MOST_REPEATS;
    }

    /// Whether the supports leave any rigid motion free.
    pub fn has_motions(&self) -> bool {
        !self.motions.is_empty()
    }

    /// The rigid motions that supports and frozen components leave free, on grid `fine`.
    pub fn free_motions(&self, fine: usize) -> Vec<Vec<f64>> {
        let mut motions = self.free.clone();
        for grid in &self.grids[1..=fine] {
            for motion in &mut motions {
                let mut finer = vec![0.0; grid.dimension()];
                if let Some(transfer) = &grid.transfer {
                    transfer.prolong(motion, &mut finer);
                }
                *motion = finer;
            }
        }
        motions
    }

    /// The frozen bounds of a coarse level.
    #[cfg(test)]
    pub fn frozen(&self, level: usize) -> &[bool] {
        &self.rooms[level].frozen
    }

    /// Factorisations on the coarsest level.
    pub fn factorizations(&self) -> usize {
        self.coarsest.factorizations()
    }

    /// Passes the frozen components down. A coarse function that keeps nothing is frozen as well; one that keeps a part is cut short,
    /// and the coarse matrix with it.
    pub fn freeze(&mut self, fine: usize, frozen: &[bool]) {
        if self.face.as_ref().is_some_and(|(level, face)| *level == fine && face == frozen) {
            return;
        }
        self.face = Some((fine, frozen.to_vec()));
        self.coarsest.forget();
        for (room, grid) in self.rooms.iter_mut().zip(self.grids) {
            room.undo.restore(grid.matrix.borrow_mut().to_mut());
        }
        let mut above: Vec<State> = frozen.iter().map(|f| if *f { State::Frozen } else { State::Whole }).collect();
        for k in (0..fine).rev() {
            let grid = &self.grids[k + 1];
            let Some(transfer) = &grid.transfer else { return };
            let states = below(&self.grids[k].bounds, &grid.bounds, transfer, &above);
            let is_frozen = |dof: u32| find(&grid.bounds, dof).is_some_and(|b| above[b] == State::Frozen);
            let (mut coarse, matrix) = (self.grids[k].matrix.borrow_mut(), grid.matrix());
            for (bound, _) in self.grids[k].bounds.iter().zip(&states).filter(|(_, s)| **s == State::Cut) {
                self.rooms[k].undo.cut_short(coarse.to_mut(), &matrix, transfer, &is_frozen, bound.dof);
            }
            self.rooms[k].frozen = states.iter().map(|s| *s == State::Frozen).collect();
            above = states;
        }
        if self.has_motions() {
            self.free = self.motions_left(fine, frozen);
            self.own = self.rooms.first().map_or_else(Vec::new, |room| self.motions_left(0, &room.frozen));
        }
    }

    /// The motions on which every frozen component of grid `fine` vanishes. A cut function holds a body as well, so the coarsest level's
    /// own frozen components would not tell.
    fn motions_left(&self, fine: usize, frozen: &[bool]) -> Vec<Vec<f64>> {
        let held = frozen_dofs(&self.grids[fine].bounds, frozen);
        let mut rows: Vec<motion::Row> = held.into_iter().map(|i| [(i as u32, 1.0)].into()).collect();
        for transfer in self.grids[1..=fine].iter().rev().filter_map(|g| g.transfer.as_ref()) {
            rows = rows.iter().map(|row| transfer.pull_back(row)).collect();
        }
        motion::free(self.motions, &rows)
    }

    /// `rest = P (cycle on the next coarser level) Pᵀ rest`, without the frozen components.
    fn correct_from_below(&mut self, fine: usize, frozen: &[bool], rest: &mut [f64]) {
        let grid = &self.grids[fine];
        let Some(transfer) = &grid.transfer else { return };
        let held = frozen_dofs(&grid.bounds, frozen);
        held.iter().for_each(|&i| rest[i] = 0.0);
        let mut room = std::mem::take(&mut self.rooms[fine - 1]);
        transfer.restrict(&grid.matrix(), rest, &mut room.load);
        self.cycle(fine - 1, &mut room);
        transfer.prolong(&room.x, rest);
        held.iter().for_each(|&i| rest[i] = 0.0);
        self.rooms[fine - 1] = room;
    }

    /// `x ≈ K⁻¹ f` on the face.
    fn cycle(&mut self, k: usize, room: &mut Room) {
        let grid = &self.grids[k];
        let Room { x, load, rest, frozen, .. } = room;
        frozen_dofs(&grid.bounds, frozen).into_iter().for_each(|i| load[i] = 0.0);
        if k == 0 {
            x.copy_from_slice(load);
            self.coarsest.solve(&grid.matrix(), &grid.bounds, frozen, [&self.free, &self.own], x);
            return;
        }
        x.fill(0.0);
        let limits = Limits::Frozen(frozen);
        (0..self.repeats).for_each(|_| grid.sweep(Direction::Forward, limits, load, x));
        for _ in 0..self.repeats {
            grid.residual(load, x, rest);
            self.visited += grid.entries();
            self.correct_from_below(k, frozen, rest);
            vector::add(x, 1.0, rest);
        }
        (0..self.repeats).for_each(|_| grid.sweep(Direction::Backward, limits, load, x));
        self.visited += 2 * self.repeats * grid.entries();
    }
}
