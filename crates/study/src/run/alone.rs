//! One level of a case by itself, for measurements of time and memory that nothing else may disturb.

use super::Solver;
use super::level::Task;
use super::timing::LevelTimes;
use crate::error::RunError;
use crate::family;
use crate::record::Level;
use crate::study::{Case, ReferencePlan, Scene};
use signorini_contact::assembly;
use signorini_contact::problem::Problem;
use signorini_contact::solver::{Accuracy, Method, Settings};
use signorini_contact::sparse::BlockMatrix;
use signorini_contact::zone::Zone;

/// What the constraints of the contact zone ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constraints {
    /// What the scene says: a contact problem.
    OfScene,
    /// `n·d = g` at every pair: the linear problem on the same mesh.
    AllBilateral,
}

/// The share of the discretisation error, in the energy norm, that is left to iterative solvers. Enough for that norm; the L² norm
/// and the contact pressure, which fall faster, would show it, so runs solve to the end.
const SHARE: f64 = 0.01;

/// A level to be computed alone.
#[derive(Clone, Copy)]
pub struct Alone<'a> {
    /// The case.
    pub case: &'a Case,
    /// Its scene.
    pub scene: &'a Scene,
    /// Cells of the levels, from the coarsest of the family to the one that is meant.
    pub cells: &'a [usize],
}

impl Alone<'_> {
    /// Meshes, assembles, solves and measures the level, in the phases of a run: against the exact solution where the case has
    /// one, else for its energy and certificate alone. A second solver and the splitting are no part of a level's time and left out.
    ///
    /// # Errors
    /// As [`run_case`](super::run_case).
    pub fn run(&self, solver: &Solver, constraints: Constraints) -> Result<(Level, LevelTimes), RunError> {
        let case = Case { second: None, splitting: None, ..self.case.clone() };
        let mut scene = self.scene.clone();
        if constraints == Constraints::AllBilateral {
            scene.bilateral = (0..scene.contact.pieces().len()).collect();
        }
        let method = solver.own().unwrap_or(case.solver.method);
        let settings = Settings { method, accuracy: Accuracy::Discretisation(SHARE), ..case.solver };
        let external = if let Solver::External(external) = solver { Some(external.clone()) } else { None };
        let task = Task { external, ..Task::new(&case, &scene, self.cells, settings) };
        let index = self.cells.len() - 1;
        match (&scene.exact, constraints) {
            (Some(exact), Constraints::OfScene) if case.reference == ReferencePlan::Exact => {
                task.against_exact(exact, index)
            }
            _ => task.without_reference(index),
        }
    }

    /// Solves the level by two methods, both as well as double precision allows, and compares the answers; with it, how many coarser
    /// levels there are.
    ///
    /// # Errors
    /// As [`Alone::run`].
    pub fn compare(&self, first: Method, second: Method) -> Result<(Level, usize), RunError> {
        let case = Case { second: Some(second), splitting: None, ..self.case.clone() };
        let settings = Settings { method: first, accuracy: Accuracy::Floor, ..case.solver };
        let task = Task::new(&case, self.scene, self.cells, settings);
        let index = self.cells.len() - 1;
        let hierarchy = family::build_level(&case.family, &self.scene.domain(), self.cells, index)?.hierarchy;
        Ok((task.without_reference(index)?.0, hierarchy.levels().len() - 1))
    }

    /// The stiffness matrix of the level, in the basis in which contact bounds single components.
    ///
    /// # Errors
    /// As [`Alone::run`].
    pub fn matrix(&self) -> Result<BlockMatrix, RunError> {
        let meshed = family::build_level(&self.case.family, &self.scene.domain(), self.cells, self.cells.len() - 1)?;
        let (mesh, supports) = (meshed.hierarchy.finest(), self.scene.supports());
        let cubature = self.scene.cubature(0, self.case.fixed_quadrature);
        let materials = self.scene.materials;
        let problem = Problem { mesh, materials, supports: &supports, data: self.scene, cubature: &cubature };
        let load = assembly::loads(mesh, &supports, self.scene, &cubature)?;
        Ok(self.scene.discretise(&problem, load, Zone::new(mesh))?.qp.matrix)
    }

    /// Cells, measured mesh size and unknowns of the level; nothing is solved.
    ///
    /// # Errors
    /// As [`Alone::run`].
    pub fn check(&self) -> Result<super::CheckedLevel, RunError> {
        super::level_without_solve(self.case, self.scene, self.cells, self.cells.len() - 1)
    }
}
