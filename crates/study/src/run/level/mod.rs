//! One level of a case: mesh, solve, measure.

mod against_exact;
mod against_located;
mod against_overkill;
pub(super) mod bilateral;
mod defects;
mod discretise;
mod external;
mod inside;
#[cfg(test)]
mod located_tests;
mod parts;
mod projection;
mod second;
mod splitting;
#[cfg(test)]
mod tests;

use super::contact::{self, ContactState};
use super::profile;
use super::timing::{LevelTimes, Stopwatch};
use crate::error::RunError;
use crate::external::External;
use crate::family::{self, Level as MeshLevel};
use crate::fields::{self, Keep};
use crate::record::{Budget, Errors, Kkt, Level, SolverRecord};
use crate::reference::exact::Pair;
use crate::reference::overkill::Overkill;
use crate::study::{Case, ExactScene, Scene};
use against_exact::ExactMeasurement;
use inside::is_inside;
use signorini_contact::material::Material;
use signorini_contact::mesh::{Hierarchy, Mesh};
use signorini_contact::problem::{Discrete, Problem, Solution, Support};
use signorini_contact::qp;
use signorini_contact::quadrature::Cubature;
use signorini_contact::solver::{Accuracy, Method, Prepared, QpSolution, Settings};
use signorini_contact::sum::ordered_sum;
use signorini_contact::zone::{Zone, side_length};
use signorini_contact::{Vec2, assembly, norm};
use splitting::Measured;

/// A solved level: what every measurement starts from.
struct Solved {
    discrete: Discrete,
    solution: Solution,
    state: ContactState,
}

impl Solved {
    fn new(problem: &Problem, discrete: Discrete, raw: QpSolution) -> Self {
        let solution = discrete.recover(problem.mesh, &problem.materials, raw);
        let state = ContactState::new(problem.mesh, &discrete, &solution);
        Self { discrete, solution, state }
    }
}

/// What is being measured: a case at a list of mesh parameters.
pub struct Task<'a> {
    /// The case.
    pub case: &'a Case,
    /// Its scene.
    pub scene: &'a Scene,
    /// Cells of every level, coarsest first.
    pub cells: &'a [usize],
    /// Solver settings, the study's or the command line's.
    pub settings: Settings,
    /// How the contact zone of a mesh is constrained: [`Zone::new`], unless a test plants a defect.
    pub constrain: fn(&Mesh) -> Zone,
    /// Which levels keep their fields.
    pub keep: Keep,
    /// The program that solves the levels in place of this one.
    pub external: Option<External>,
}

impl<'a> Task<'a> {
    /// Levels solved and constrained as the scene has it; no fields are kept.
    pub fn new(case: &'a Case, scene: &'a Scene, cells: &'a [usize], settings: Settings) -> Self {
        Self { case, scene, cells, settings, constrain: Zone::new, keep: Keep::default(), external: None }
    }
}

impl Task<'_> {
    /// The mesh of a level.
    fn mesh(&self, index: usize) -> Result<MeshLevel, RunError> {
        Ok(family::build_level(&self.case.family, &self.scene.domain(), self.cells, index)?)
    }

    /// Measures a level against the exact solution.
    pub fn against_exact(&self, exact: &ExactScene, index: usize) -> Result<(Level, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let meshed = self.mesh(index)?;
        let mesh = meshed.hierarchy.finest();
        watch.lap(|t| &mut t.mesh);
        let interpolant: Vec<Vec2> =
            mesh.points.iter().zip(&mesh.node_bodies).map(|(x, body)| exact.solution.value(*body, *x)).collect();
        let fixed = self.case.fixed_quadrature;
        let pair = Pair::new(self.scene, exact, mesh, &interpolant, fixed)?;
        let fine = &pair.fine;
        let cubature = self.scene.cubature(1, fixed);
        let supports = self.scene.supports();
        let problem = self.problem(mesh, &supports, &cubature);
        let load = if self.case.projects { fine.projection_load() } else { fine.load.clone() };
        let discrete = self.scene.discretise(&problem, load, (self.constrain)(mesh))?;
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(index, &problem, &meshed.hierarchy, discrete, &mut watch)?;
        let measured = ExactMeasurement {
            task: self,
            mesh,
            pair: &pair,
            exact,
            cubature: &cubature,
            interpolant: &interpolant,
            solved: &solved,
        };
        let contact = contact::against_exact(exact, mesh, &solved.state, &cubature);
        let mut level = self.level(index, &meshed, &solved);
        let squares = measured.fill(&mut level, &contact);
        if let Some(splitting) = self.splitting(&meshed, &solved, &level) {
            level.splitting = splitting.against_exact(&pair, &interpolant, squares)?;
        }
        if self.case.projects {
            projection::of_exact(&mut level, fine.solution.energy);
        }
        watch.lap(|t| &mut t.error);
        Ok((level, watch.finish()))
    }

    /// Measures a level against a discrete reference on a finer mesh; `at` is the level's place in its hierarchy, if that is
    /// nested.
    pub fn against_overkill(
        &self,
        reference: &Overkill,
        at: Option<usize>,
        index: usize,
    ) -> Result<(Level, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let meshed = self.mesh(index)?;
        let mesh = meshed.hierarchy.finest();
        watch.lap(|t| &mut t.mesh);
        let supports = self.scene.supports();
        let cubature = self.scene.cubature(0, self.case.fixed_quadrature);
        let fine = cubature.finer();
        let problem = self.problem(mesh, &supports, &fine);
        let coarse_load = assembly::loads(mesh, &supports, self.scene, &cubature)?;
        let projected = at.filter(|_| self.case.projects);
        let discrete = match projected {
            Some(at) => {
                let load = reference.projection_load(&self.scene.materials, at);
                self.scene.discretise(&problem, load, Zone::new(mesh))?
            }
            None => self.discretise(&problem)?,
        };
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(index, &problem, &meshed.hierarchy, discrete, &mut watch)?;
        let mut level = self.level(index, &meshed, &solved);
        match at {
            Some(at) => {
                let square = self.fill_from_overkill(&mut level, reference, at, mesh, &solved, &coarse_load);
                if let Some(splitting) = self.splitting(&meshed, &solved, &level) {
                    level.splitting = splitting.against_overkill(reference, at, square)?;
                }
            }
            None => self.fill_from_located(&mut level, reference, mesh, &solved, &coarse_load),
        }
        if projected.is_some() {
            projection::of_discrete(&mut level, reference.solution.strain_energy);
        }
        watch.lap(|t| &mut t.error);
        Ok((level, watch.finish()))
    }

    /// Solves a level and keeps energies and certificates alone.
    pub fn without_reference(&self, index: usize) -> Result<(Level, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let meshed = self.mesh(index)?;
        let mesh = meshed.hierarchy.finest();
        watch.lap(|t| &mut t.mesh);
        let supports = self.scene.supports();
        let cubature = self.scene.cubature(1, self.case.fixed_quadrature);
        let problem = self.problem(mesh, &supports, &cubature);
        let discrete = self.discretise(&problem)?;
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(index, &problem, &meshed.hierarchy, discrete, &mut watch)?;
        let level = self.level(index, &meshed, &solved);
        watch.lap(|t| &mut t.error);
        Ok((level, watch.finish()))
    }

    /// Solves the reference on the finest mesh of a hierarchy.
    pub fn overkill(&self, cells: usize) -> Result<(Overkill, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let scene = self.scene;
        let hierarchy = family::build_reference(&self.case.family, &scene.domain(), self.cells, cells)?;
        watch.lap(|t| &mut t.mesh);
        let supports = scene.supports();
        let cubature = scene.cubature(0, self.case.fixed_quadrature);
        let problem = self.problem(hierarchy.finest(), &supports, &cubature);
        let discrete = self.discretise(&problem)?;
        watch.lap(|t| &mut t.assembly);
        // what a reference leaves undone, every level that is measured against it would show
        let settings = Settings { accuracy: Accuracy::Floor, ..self.settings };
        let solved = self.solve_with(&settings, &problem, &hierarchy, discrete, &mut watch);
        if !solved.solution.raw.status.is_solved() {
            return Err(RunError::Reference(format!(
                "the reference solve ended with '{}'",
                solved.solution.raw.status
            )));
        }
        let Solved { discrete, solution, .. } = solved;
        Ok((Overkill { hierarchy, discrete, solution }, watch.finish()))
    }

    fn problem<'b>(&'b self, mesh: &'b Mesh, supports: &'b [Support], cubature: &'b Cubature) -> Problem<'b> {
        let scene = self.scene;
        Problem { mesh, materials: scene.materials, supports, data: scene, cubature }
    }

    /// The problem with its loads and constraints, as the scene ties and fixes them.
    fn discretise(&self, problem: &Problem) -> Result<Discrete, RunError> {
        let load = assembly::loads(problem.mesh, problem.supports, problem.data, problem.cubature)?;
        Ok(self.scene.discretise(problem, load, Zone::new(problem.mesh))?)
    }

    /// Solves a level, or has it solved.
    fn solve(
        &self,
        index: usize,
        problem: &Problem,
        hierarchy: &Hierarchy,
        discrete: Discrete,
        watch: &mut Stopwatch,
    ) -> Result<Solved, RunError> {
        match &self.external {
            None => Ok(self.solve_with(&self.settings, problem, hierarchy, discrete, watch)),
            Some(external) => self.have_solved(external, index, problem, discrete, watch),
        }
    }

    fn solve_with(
        &self,
        settings: &Settings,
        problem: &Problem,
        hierarchy: &Hierarchy,
        discrete: Discrete,
        watch: &mut Stopwatch,
    ) -> Solved {
        // where another solver is asked too, as in the hard cases, the first answer is to be exact row by row
        let coarser = if self.case.second.is_some() { 0 } else { hierarchy.levels().len() - 1 };
        let method = settings.method.for_problem(discrete.dofs(), coarser);
        let prepared = prepared(method, &discrete, hierarchy, &problem.materials);
        watch.lap(|t| &mut t.setup);
        let mut raw = prepared.solve(settings);
        if settings.method == Method::Automatic && !raw.status.is_solved() && raw.method == Method::Multigrid {
            raw = Prepared::new(&discrete.qp, Method::Condensed).solve(settings);
        }
        watch.lap(|t| &mut t.solve);
        Solved::new(problem, discrete, raw)
    }

    fn solver_record(&self, solution: &Solution) -> SolverRecord {
        let raw = &solution.raw;
        SolverRecord {
            name: self.external.as_ref().map_or_else(|| raw.method.name().to_owned(), |e| e.name.clone()),
            status: raw.status.to_string(),
            solved: raw.status.is_solved(),
            iterations: raw.iterations,
            factorizations: raw.factorizations,
            work: (raw.work > 0.0).then_some(raw.work),
        }
    }

    /// What the splitting is measured with, if the case wants it.
    fn splitting<'b>(&'b self, meshed: &'b MeshLevel, solved: &'b Solved, level: &Level) -> Option<Measured<'b>> {
        let inside = level.inside == Some(true);
        Some(Measured { task: self, plan: self.case.splitting?, hierarchy: &meshed.hierarchy, solved, inside })
    }

    /// The part of a record that needs no reference.
    fn level(&self, index: usize, meshed: &MeshLevel, solved: &Solved) -> Level {
        let Solved { discrete, solution, state } = solved;
        let finest = meshed.hierarchy.finest();
        let second = self.second_opinion(&meshed.hierarchy, solved);
        let mut kkt = certificate(discrete, solution);
        kkt.componentwise = kkt.componentwise.filter(|_| second.is_some());
        let with_profile = index + 1 == self.cells.len();
        let contact = profile::measure(self.scene, finest, discrete, solution, state, with_profile);
        let mut errors = Errors { penetration_l2: Some(state.penetration()), ..Default::default() };
        profile::compare(&contact, &mut errors);
        let kept = self.keep.wants(index, self.cells.len(), finest.triangles.len());
        let fields = kept.then(|| fields::collect(index, self.scene, finest, discrete, solution, state)).flatten();
        Level {
            fields: fields.map(Box::new),
            level: index,
            cells: self.cells[index],
            h: meshed.quality.h,
            min_angle: meshed.quality.min_angle,
            side_ratio: meshed.quality.side_ratio,
            straight_over_chord: meshed.quality.straight_over_chord,
            nested: meshed.nested,
            dofs: discrete.dofs(),
            contact_pairs: discrete.zone.pairs.len(),
            constraints: discrete.qp.bounds.len(),
            active: state.active_constraints,
            switch_sides: None,
            energy: solution.energy,
            solution_energy: Some(solution.strain_energy.sqrt()),
            solution_h1: Some(norm::of_linear(finest, &self.scene.materials, &solution.displacement).h1_norm()),
            solution_trace: Some(largest_component(&solution.displacement) * zone_length(finest).sqrt()),
            two_way: None,
            mesh_hash: meshed.hash.clone(),
            errors,
            ledger: None,
            splitting: Vec::new(),
            inside: Some(is_inside(self.scene, finest)),
            kkt,
            budget: Budget::default(),
            solver: self.solver_record(solution),
            warnings: discrete.warnings.clone(),
            excluded: None,
            contact: Some(contact),
            second,
        }
    }
}

/// A problem made ready for a method; multigrid gets the levels below it.
fn prepared<'a>(
    method: Method,
    discrete: &'a Discrete,
    hierarchy: &'a Hierarchy,
    materials: &[Material; 2],
) -> Prepared<'a> {
    match method {
        Method::Multigrid => Prepared::with_levels(&discrete.qp, discrete.levels(hierarchy, materials)),
        method => Prepared::new(&discrete.qp, method),
    }
}

/// The certificate, recomputed from the raw data.
pub(super) fn certificate(discrete: &Discrete, solution: &Solution) -> Kkt {
    let scales = qp::CertificateScales {
        displacement: largest_component(&solution.displacement),
        energy: solution.strain_energy,
    };
    let c = qp::certify(&discrete.qp, &solution.raw.x, &solution.raw.multipliers, &scales);
    Kkt {
        stationarity: c.stationarity,
        componentwise: Some(c.componentwise),
        penetration: c.penetration,
        tension: c.tension,
        complementarity: c.complementarity,
        weakly_active: c.weakly_active,
        bilateral: bilateral::measure(discrete, solution, scales.displacement),
    }
}

/// How far a solution is from that of its discrete problem, in the energy norm: the solver's last residual, measured by the solver's
/// own cycle where that is far cheaper than a measurement from outside.
pub(super) fn algebraic_error(discrete: &Discrete, solution: &Solution) -> f64 {
    let raw = &solution.raw;
    raw.distance.unwrap_or_else(|| qp::algebraic_error(&discrete.qp, &raw.x, &raw.multipliers))
}

/// `|ρ·(v − u_h)|` with the residual `ρ = f − Kx − λ` that the solver left: what a proof that takes `u_h` for the discrete solution
/// misses when it is tested with `v`.
pub(super) fn residual_work(discrete: &Discrete, solution: &Solution, v: &[Vec2]) -> f64 {
    let raw = &solution.raw;
    let mut rest = qp::residual(&discrete.qp, &raw.x);
    for (bound, force) in discrete.qp.bounds.iter().zip(&raw.multipliers) {
        rest[bound.dof as usize] -= force;
    }
    let homogeneous: Vec<Vec2> = match discrete.basis.offsets() {
        Some(offsets) => v.iter().zip(&offsets).map(|(v, o)| v - o).collect(),
        None => v.to_vec(),
    };
    let apart = discrete.basis.coordinates(&homogeneous);
    let work = |i: usize| rest[i] * (apart[i] - raw.x[i]);
    ordered_sum(rest.len(), work).abs()
}

fn largest_component(displacement: &[Vec2]) -> f64 {
    displacement.iter().map(|u| u.amax()).fold(0.0, f64::max)
}

/// The length of `Γ_K`.
fn zone_length(mesh: &Mesh) -> f64 {
    (0..mesh.contact.len()).map(|side| side_length(mesh, side)).sum()
}
