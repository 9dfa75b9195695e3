//! One level of a family, and the hierarchy that holds every level and the reference mesh.

use super::Family;
use super::perturb::{Guard, perturb, turn_diagonals};
use super::random::Random;
use super::{imported, unstructured};
use crate::study::{Discretisation, Shape};
use signorini_contact::geometry::InitialGap;
use signorini_contact::mesh::blocks::{QuadBlock, triangulate};
use signorini_contact::mesh::{CurvedSides, Hierarchy, Mesh, PartOutline, Quality, Triangulation};
use signorini_contact::{ContactLine, Error, Point};

/// A level of a family and its certificate.
#[derive(Clone, Debug)]
pub struct Level {
    /// The level's mesh is the finest one; the coarser ones are there for multigrid and prolongation.
    pub hierarchy: Hierarchy,
    /// Mesh size and regularity, measured.
    pub quality: Quality,
    /// Whether the mesh refines the one of the previous level, so that `V_{k−1} ⊂ V_k` by construction. `false` for the first
    /// level and for fresh meshes, even where the spaces happen to be nested.
    pub nested: bool,
    /// Name of the mesh, see [`Mesh::hash`]; of a mesh mapped anew with the numbers that it was made with, by which the same mesh has
    /// the same name whether there are levels below it or not.
    pub hash: String,
}

/// How many red refinements lead from `coarse` cells to `n`: `k` with `n = 2^k · coarse`, if there is one.
pub fn refinements(coarse: usize, n: usize) -> Option<usize> {
    let ratio = (coarse > 0 && n.is_multiple_of(coarse)).then(|| n / coarse)?;
    ratio.is_power_of_two().then(|| ratio.trailing_zeros() as usize)
}

/// What is meshed: the bodies, the names of their boundary parts, the contact zone.
#[derive(Clone, Debug)]
pub struct Domain<'a> {
    /// Shapes of `Ω'` and `Ω''`.
    pub shapes: &'a [Shape; 2],
    /// Boundary parts, as [`Mesh::build`] wants them.
    pub outlines: Vec<PartOutline>,
    /// The contact zone.
    pub contact: &'a ContactLine,
    /// The initial distance along it.
    pub initial_gap: Option<&'a InitialGap>,
    /// What curved sides become.
    pub discretisation: Discretisation,
}

impl Domain<'_> {
    /// Whether a side of a body is curved.
    pub fn is_curved(&self) -> bool {
        self.shapes.iter().any(Shape::is_curved)
    }

    /// Whether the levels of a family hold the fields of the coarser ones. New nodes of curved sides leave their chords, so on
    /// curved bodies no family does.
    pub fn nests(&self, family: &Family) -> bool {
        family.is_nested() && !self.is_curved()
    }
}

/// The mesh of level `index`, with `cells[index]` cells per unit of the blocks' divisions.
///
/// `cells` lists all levels and must not descend. A level depends on `cells[0]`, `cells[index]` and, for `nested` alone, on
/// `cells[index − 1]`. On curved bodies only a refined family is made by refinement; the others are fresh meshes. Fresh structured
/// meshes whose cells were doubled at least twice stand above those with fewer cells, for multigrid.
///
/// # Errors
/// [`Error::Mesh`] for cells that descend or are 0, an index without cells, an amount outside `[0, ½)`, a refined family whose
/// cells are no `2^k cells[0]`, and whatever [`triangulate`] and [`Mesh::build`] refuse.
pub fn build_level(family: &Family, domain: &Domain, cells: &[usize], index: usize) -> Result<Level, Error> {
    check(family, cells)?;
    imported::check_size(domain, cells[cells.len() - 1])?;
    let Some(&n) = cells.get(index) else {
        return refuse(format!("level {index} does not exist; there are {} levels, from 0", cells.len()));
    };
    let scene = Scene { family, domain };
    let by_refinement = family.is_refined() || domain.nests(family);
    let (hierarchy, name) = match refinements(cells[0], n) {
        Some(steps) if by_refinement => (scene.refined(cells[0], steps)?, None),
        None if family.is_refined() => {
            return refuse(not_a_refinement(cells[0], n));
        }
        Some(steps) if steps > 1 && *family == Family::Structured => scene.mapped(cells[0], steps)?,
        _ => (Hierarchy::new(scene.fresh(n)?), None),
    };
    let finest = hierarchy.finest();
    let (quality, hash) = rayon::join(|| finest.quality(), || name.unwrap_or_else(|| finest.hash()));
    Ok(Level { quality, hash, nested: domain.nests(family) && index > 0 && follows(cells, index), hierarchy })
}

/// The reference mesh of `reference_n` cells as the finest of a hierarchy. Where the family is nested the hierarchy holds every
/// level: level `i` of `cells` is mesh [`refinements`]`(cells[0], cells[i])`, equal to the last bit to that of [`build_level`].
/// Elsewhere it is a level like the others, of `reference_n` cells.
///
/// # Errors
/// [`Error::Mesh`] as for [`build_level`], for a reference that is coarser than a level, and in a nested family for cells that are
/// not `2^k cells[0]`.
pub fn build_reference(
    family: &Family,
    domain: &Domain,
    cells: &[usize],
    reference_n: usize,
) -> Result<Hierarchy, Error> {
    check(family, cells)?;
    let (coarse, finest) = (cells[0], cells[cells.len() - 1]);
    if reference_n < finest {
        return refuse(format!(
            "the reference has {reference_n} cells, fewer than the finest level's {finest}; give it more"
        ));
    }
    if !domain.nests(family) {
        return Ok(build_level(family, domain, &[coarse, reference_n], 1)?.hierarchy);
    }
    if let Some(&n) = cells.iter().find(|&&n| refinements(coarse, n).is_none()) {
        return refuse(not_a_refinement(coarse, n));
    }
    match refinements(coarse, reference_n) {
        Some(steps) => Scene { family, domain }.refined(coarse, steps),
        None => refuse(not_a_refinement(coarse, reference_n)),
    }
}

/// Whether level `index` and the one before are refinements of the coarsest mesh.
fn follows(cells: &[usize], index: usize) -> bool {
    [index - 1, index].iter().all(|&i| refinements(cells[0], cells[i]).is_some())
}

fn check(family: &Family, cells: &[usize]) -> Result<(), Error> {
    if cells.is_empty() || cells[0] == 0 || !cells.is_sorted() {
        return refuse(format!("the cells {cells:?} of the levels must be positive and must not descend"));
    }
    match family.amount() {
        Some(amount) if !(0.0..0.5).contains(&amount) => refuse(format!(
            "the family {} moves nodes by {amount} of a cell; give an amount of at least 0 and below 0.5",
            family.name()
        )),
        _ => Ok(()),
    }
}

fn not_a_refinement(coarse: usize, n: usize) -> String {
    format!("{n} cells are no refinement of the coarsest level's {coarse}: use {coarse} times a power of two")
}

fn refuse<T>(message: String) -> Result<T, Error> {
    Err(Error::Mesh(message))
}

/// What all levels of a case have in common.
struct Scene<'a> {
    family: &'a Family,
    domain: &'a Domain<'a>,
}

impl Scene<'_> {
    fn refined(&self, coarse: usize, steps: usize) -> Result<Hierarchy, Error> {
        let mut hierarchy = Hierarchy::new(self.fresh(coarse)?);
        (0..steps).for_each(|_| hierarchy.refine());
        Ok(hierarchy)
    }

    /// Every level a fresh mesh, numbered like a refinement of the one below; and the name of the finest as it was made.
    fn mapped(&self, coarse: usize, steps: usize) -> Result<(Hierarchy, Option<String>), Error> {
        let mut hierarchy = Hierarchy::new(self.fresh(coarse)?);
        for step in 1..steps {
            hierarchy.refine_onto(&self.fresh(coarse << step)?)?;
        }
        let finest = self.fresh(coarse << steps)?;
        hierarchy.refine_onto(&finest)?;
        Ok((hierarchy, Some(finest.hash())))
    }

    /// The mesh of `n` cells by itself. Random numbers depend on the seed and on `n` alone.
    fn fresh(&self, n: usize) -> Result<Mesh, Error> {
        let mut bodies = match *self.family {
            Family::Delaunay { seed } => unstructured::independent(self.domain, n, seed)?,
            Family::RefinedDelaunay { seed } => unstructured::coarse(self.domain, n, seed)?,
            Family::Imported => imported::coarse(self.domain, n)?,
            Family::Graded { seed, towards, strength } => {
                unstructured::graded(self.domain, n, seed, towards, strength)?
            }
            _ => [self.triangulate(0, n)?, self.triangulate(1, n)?],
        };
        let guard = Guard::of(&bodies);
        let mut random = Random::new(self.family.seed(), n as u64);
        if matches!(self.family, Family::Refined { .. }) {
            bodies.iter_mut().for_each(|b| turn_diagonals(b, guard, &mut random));
        }
        let mut mesh = Mesh::build(bodies, &self.domain.outlines, self.domain.contact)?;
        mesh.initial_gap = self.domain.initial_gap.cloned();
        mesh.curved.element = self.domain.discretisation.element;
        if let Some(amount) = self.family.amount() {
            perturb(&mut mesh, &self.fixed(), amount, guard, &mut random);
        }
        if self.domain.discretisation.chords {
            mesh.curved = CurvedSides::default();
        }
        Ok(mesh)
    }

    fn triangulate(&self, body: usize, n: usize) -> Result<Triangulation, Error> {
        let shape = &self.domain.shapes[body];
        let block = |b: &crate::study::Block| QuadBlock {
            corners: b.corners,
            cells: match self.family {
                Family::Degenerate(d) => d.cells(b.divisions, n),
                _ => b.divisions.map(|d| d.saturating_mul(n)),
            },
            curves: b.curves.clone(),
            grading: b.grading,
        };
        let blocks: Vec<_> = shape.blocks.iter().map(block).collect();
        triangulate(&blocks, self.family.pattern()).map_err(|error| match error {
            Error::Mesh(message) => Error::Mesh(format!("body \"{}\": {message}", shape.name)),
            other => other,
        })
    }

    /// Points that keep their place on the boundary: corners and ends of parts, of the contact polyline and of blocks.
    fn fixed(&self) -> Vec<Point> {
        let parts = self.domain.outlines.iter().flat_map(|p| &p.along.corners);
        let blocks = self.domain.shapes.iter().flat_map(|s| &s.blocks).flat_map(|b| &b.corners);
        parts.chain(&self.domain.contact.corners()).chain(blocks).copied().collect()
    }
}
