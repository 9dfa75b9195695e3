//! The elements of a mesh one batch after the other: sums and loads are added up in the order of the elements, and of each element
//! only little is kept.

use super::curved::CurvedPart;
use super::element::Element;
use super::kept::Kept;
use rayon::prelude::*;
use signorini_contact::Vec2;
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use std::ops::AddAssign;

/// Elements of one task, whose sums are added up first; the order of summation depends on this number and on nothing else.
const CHUNK: usize = 64;

/// Tasks whose results wait at the same time.
const BATCH: usize = 512;

/// Sums over elements by one quadrature.
#[derive(Clone, Copy, Default)]
pub struct Sums {
    /// Squares of `u − u_I`.
    pub interpolation: Squares,
    /// Squares of `u`.
    pub solution: Squares,
    /// `∫ F·u`.
    pub work: f64,
}

impl AddAssign for Sums {
    fn add_assign(&mut self, other: Self) {
        self.interpolation += other.interpolation;
        self.solution += other.solution;
        self.work += other.work;
    }
}

impl AddAssign<&Element> for Sums {
    fn add_assign(&mut self, element: &Element) {
        self.interpolation += element.interpolation;
        self.solution += element.solution;
        self.work += element.work;
    }
}

/// Everything that is left of the elements, by the coarser and the finer quadrature.
pub struct Gathered {
    /// Sums over all elements.
    pub sums: [Sums; 2],
    /// Nodal loads `∫ F φ_i`.
    pub load: [Vec<Vec2>; 2],
    /// What each straight element leaves; of one with a curved side nothing.
    pub kept: Vec<Kept>,
}

/// The results of one task.
struct Chunk {
    sums: [Sums; 2],
    loads: Vec<[[Vec2; 3]; 2]>,
    kept: Vec<Kept>,
}

impl Gathered {
    /// Integrates every straight element; `curved` are the others, by their numbers in ascending order.
    pub fn new(
        mesh: &Mesh,
        curved: &[(u32, [CurvedPart; 2])],
        straight: impl Fn(usize) -> [Element; 2] + Sync,
    ) -> Self {
        let count = mesh.triangles.len();
        let nothing = || vec![Vec2::zeros(); mesh.points.len()];
        let mut all = Self { sums: Default::default(), load: [nothing(), nothing()], kept: Vec::with_capacity(count) };
        let chunk = |first: usize| {
            let mut chunk = Chunk { sums: Default::default(), loads: Vec::new(), kept: Vec::new() };
            (first..(first + CHUNK).min(count)).for_each(|t| match of_curved(curved, t) {
                Some(parts) => chunk.add(&parts.map(|p| p.element), Kept::default()),
                None => {
                    let pair = straight(t);
                    chunk.add(&pair, Kept::new(&pair));
                }
            });
            chunk
        };
        for batch in (0..count).step_by(BATCH * CHUNK) {
            let last = (batch + BATCH * CHUNK).min(count);
            let firsts: Vec<usize> = (batch..last).step_by(CHUNK).collect();
            let chunks: Vec<Chunk> = firsts.into_par_iter().map(chunk).collect();
            chunks.into_iter().for_each(|c| all.take(mesh, c));
        }
        all
    }

    fn take(&mut self, mesh: &Mesh, chunk: Chunk) {
        let first = self.kept.len();
        (0..2).for_each(|k| self.sums[k] += chunk.sums[k]);
        for (nodes, loads) in mesh.triangles[first..].iter().zip(&chunk.loads) {
            for (load, of_element) in self.load.iter_mut().zip(loads) {
                nodes.iter().zip(of_element).for_each(|(&i, l)| load[i as usize] += l);
            }
        }
        self.kept.extend(chunk.kept);
    }
}

impl Chunk {
    fn add(&mut self, pair: &[Element; 2], kept: Kept) {
        (0..2).for_each(|k| self.sums[k] += &pair[k]);
        self.loads.push(pair.each_ref().map(|e| e.load));
        self.kept.push(kept);
    }
}

/// What the element `t` with a curved side contributes.
pub fn of_curved(curved: &[(u32, [CurvedPart; 2])], t: usize) -> Option<&[CurvedPart; 2]> {
    if curved.is_empty() {
        return None;
    }
    curved.binary_search_by_key(&(t as u32), |(number, _)| *number).ok().map(|k| &curved[k].1)
}
