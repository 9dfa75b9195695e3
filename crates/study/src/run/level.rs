//! One level of a case: mesh, solve, measure.

use super::contact::{self, ContactErrors, ContactState};
use super::timing::{LevelTimes, Stopwatch};
use crate::error::RunError;
use crate::family::{self, Level as MeshLevel};
use crate::record::{Budget, Errors, Kkt, Ledger, Level, SolverRecord};
use crate::reference::exact::{Integrals, Pair};
use crate::reference::overkill::Overkill;
use crate::study::{Case, ExactScene};
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::problem::{Discrete, Problem, Solution, Support};
use signorini_contact::qp;
use signorini_contact::quadrature::Cubature;
use signorini_contact::solver::{Prepared, Settings};
use signorini_contact::zone::{Zone, side_length};
use signorini_contact::{Vec2, assembly};

/// Below this share of `A(u,u)` a squared error is rounding, and a relative difference of it means nothing.
const ROUNDING: f64 = 1e-12;

/// A solved level: what every measurement starts from.
struct Solved {
    discrete: Discrete,
    solution: Solution,
    state: ContactState,
}

/// What is being measured: a case at a list of mesh parameters.
pub struct Task<'a> {
    /// The case.
    pub case: &'a Case,
    /// Cells of every level, coarsest first.
    pub cells: &'a [usize],
    /// Solver settings, the study's or the command line's.
    pub settings: Settings,
    /// How the contact zone of a mesh is constrained: [`Zone::new`], unless a test plants a defect.
    pub constrain: fn(&Mesh) -> Zone,
}

impl Task<'_> {
    /// The mesh of a level.
    fn mesh(&self, index: usize) -> Result<MeshLevel, RunError> {
        let scene = &self.case.scene;
        Ok(family::build_level(
            &self.case.family,
            &scene.bodies,
            &scene.part_outlines(),
            &scene.contact,
            self.cells,
            index,
        )?)
    }

    /// Measures a level against the exact solution.
    pub fn against_exact(&self, exact: &ExactScene, index: usize) -> Result<(Level, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let meshed = self.mesh(index)?;
        let mesh = meshed.hierarchy.finest();
        watch.lap(|t| &mut t.mesh);
        let interpolant: Vec<Vec2> =
            mesh.points.iter().zip(&mesh.node_bodies).map(|(x, body)| exact.solution.value(*body, *x)).collect();
        let zone = Zone::new(mesh);
        let fixed = self.case.fixed_quadrature;
        let Pair { base, fine } = Pair::new(&self.case.scene, exact, mesh, &zone, &interpolant, fixed);
        let cubature = self.case.scene.cubature(1, fixed);
        let supports = self.case.scene.supports();
        let problem = self.problem(mesh, &supports, &cubature);
        let discrete = problem.discretise_zone(fine.load.clone(), (self.constrain)(mesh))?;
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(&problem, discrete, &mut watch);
        let measured =
            ExactMeasurement { task: self, mesh, base: &base, fine: &fine, interpolant: &interpolant, solved: &solved };
        let contact = contact::against_exact(exact, mesh, &solved.discrete.zone, &solved.state, &cubature);
        let mut level = self.level(index, &meshed, &solved);
        measured.fill(&mut level, &contact);
        watch.lap(|t| &mut t.error);
        Ok((level, watch.finish()))
    }

    /// Measures a level against a discrete reference on a nested finer mesh; `at` is the level's place in its hierarchy.
    pub fn against_overkill(
        &self,
        reference: &Overkill,
        at: usize,
        index: usize,
    ) -> Result<(Level, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let meshed = self.mesh(index)?;
        let mesh = meshed.hierarchy.finest();
        watch.lap(|t| &mut t.mesh);
        let supports = self.case.scene.supports();
        let cubature = self.case.scene.cubature(0, self.case.fixed_quadrature);
        let fine = cubature.finer();
        let problem = self.problem(mesh, &supports, &fine);
        let coarse_load = assembly::loads(mesh, &supports, &self.case.scene, &cubature)?;
        let discrete = problem.discretise()?;
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(&problem, discrete, &mut watch);
        let mut level = self.level(index, &meshed, &solved);
        self.fill_from_overkill(&mut level, reference, at, mesh, &solved, &coarse_load);
        watch.lap(|t| &mut t.error);
        Ok((level, watch.finish()))
    }

    /// Solves a level and keeps energies and certificates alone.
    pub fn without_reference(&self, index: usize) -> Result<(Level, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let meshed = self.mesh(index)?;
        let mesh = meshed.hierarchy.finest();
        watch.lap(|t| &mut t.mesh);
        let supports = self.case.scene.supports();
        let cubature = self.case.scene.cubature(1, self.case.fixed_quadrature);
        let problem = self.problem(mesh, &supports, &cubature);
        let discrete = problem.discretise()?;
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(&problem, discrete, &mut watch);
        let level = self.level(index, &meshed, &solved);
        Ok((level, watch.finish()))
    }

    /// Solves the reference on the finest mesh of a hierarchy.
    pub fn overkill(&self, cells: usize) -> Result<(Overkill, LevelTimes), RunError> {
        let mut watch = Stopwatch::start();
        let scene = &self.case.scene;
        let hierarchy = family::build_reference(
            &self.case.family,
            &scene.bodies,
            &scene.part_outlines(),
            &scene.contact,
            self.cells,
            cells,
        )?;
        watch.lap(|t| &mut t.mesh);
        let supports = scene.supports();
        let cubature = scene.cubature(0, self.case.fixed_quadrature);
        let problem = self.problem(hierarchy.finest(), &supports, &cubature);
        let discrete = problem.discretise()?;
        watch.lap(|t| &mut t.assembly);
        let solved = self.solve(&problem, discrete, &mut watch);
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
        let scene = &self.case.scene;
        Problem { mesh, materials: scene.materials, supports, data: scene, cubature }
    }

    fn solve(&self, problem: &Problem, discrete: Discrete, watch: &mut Stopwatch) -> Solved {
        let prepared = Prepared::new(&discrete.qp, self.settings.method);
        watch.lap(|t| &mut t.setup);
        let raw = prepared.solve(&self.settings);
        watch.lap(|t| &mut t.solve);
        let solution = discrete.recover(problem.mesh, &problem.materials, raw);
        let state = ContactState::new(problem.mesh, &discrete, &solution);
        Solved { discrete, solution, state }
    }

    /// The part of a record that needs no reference.
    fn level(&self, index: usize, meshed: &MeshLevel, solved: &Solved) -> Level {
        let Solved { discrete, solution, state } = solved;
        let raw = &solution.raw;
        let scales = qp::CertificateScales {
            displacement: solution.displacement.iter().map(|u| u.x.abs().max(u.y.abs())).fold(0.0, f64::max),
            energy: solution.strain_energy,
        };
        let certificate = qp::certify(&discrete.qp, &raw.x, &raw.multipliers, &scales);
        Level {
            level: index,
            cells: self.cells[index],
            h: meshed.quality.h,
            min_angle: meshed.quality.min_angle,
            side_ratio: meshed.quality.side_ratio,
            nested: meshed.nested,
            dofs: discrete.dofs(),
            contact_pairs: discrete.zone.pairs.len(),
            constraints: discrete.qp.bounds.len(),
            active: state.active_constraints,
            switch_sides: None,
            energy: solution.energy,
            solution_energy: Some(solution.strain_energy.sqrt()),
            solution_trace: Some(scales.displacement * zone_length(meshed.hierarchy.finest()).sqrt()),
            two_way: None,
            mesh_hash: meshed.hash.clone(),
            errors: Errors { penetration_l2: Some(state.penetration(meshed.hierarchy.finest())), ..Default::default() },
            ledger: None,
            kkt: Kkt {
                stationarity: certificate.stationarity,
                penetration: certificate.penetration,
                tension: certificate.tension,
                complementarity: certificate.complementarity,
                weakly_active: certificate.weakly_active,
            },
            budget: Budget::default(),
            solver: SolverRecord {
                name: self.settings.method.name().to_owned(),
                status: raw.status.to_string(),
                solved: raw.status.is_solved(),
                iterations: raw.iterations,
                factorizations: raw.factorizations,
            },
            warnings: discrete.warnings.clone(),
            excluded: None,
        }
    }

    fn fill_from_overkill(
        &self,
        level: &mut Level,
        reference: &Overkill,
        at: usize,
        mesh: &Mesh,
        solved: &Solved,
        coarse_load: &[Vec2],
    ) {
        let materials = &self.case.scene.materials;
        let (discrete, solution) = (&solved.discrete, &solved.solution);
        let fine_mesh = reference.hierarchy.finest();
        let v = reference.prolong(at, &solution.displacement);
        let u_i = reference.prolong(at, reference.interpolant(at));
        let error = reference.error(materials, &v);
        let interpolation = reference.error(materials, &u_i);
        let fine_state = ContactState::new(fine_mesh, &reference.discrete, &reference.solution);
        let contact = contact::against_reference(mesh, &solved.state, fine_mesh, &fine_state);
        let gap = solution.energy - reference.solution.energy;
        set_errors(&mut level.errors, &error, &contact, interpolation.energy_norm(), gap);
        level.switch_sides = Some(contact.switch_sides);
        // A(e,e) = 2(L(u_h) − L(u_ref)) − 2 (A(u_ref,w) − f(w)),  w = u_h − u_ref
        let by_energies = 2.0 * gap - 2.0 * reference.contact_work(&v);
        level.two_way = relative_difference(error.energy, by_energies, reference.solution.strain_energy);
        let b = reference.contact_work(&u_i);
        let work = |load: &[Vec2], u: &[Vec2]| load.iter().zip(u).map(|(f, u)| f.dot(u)).sum::<f64>();
        let load_gap = (work(&discrete.load, &solution.displacement) - work(&reference.discrete.load, &v)).abs();
        let load_change = dual_norm(discrete, &differences(&discrete.load, coarse_load));
        let delta = load_gap + 1e-14 * reference.solution.strain_energy;
        level.ledger =
            Some(ledger(0.5 * error.energy, 0.5 * interpolation.energy, b, delta, reference.solution.strain_energy));
        let e = error.energy_norm();
        level.budget = Budget {
            algebraic: share(qp::algebraic_error(&discrete.qp, &solution.raw.x, &solution.raw.multipliers), e),
            quadrature: share(load_change + load_gap / e.max(f64::MIN_POSITIVE), e),
            geometry: Some(0.0),
            reference: None,
        };
    }
}

/// Everything that turns a solved level into errors against the exact solution.
struct ExactMeasurement<'a> {
    task: &'a Task<'a>,
    mesh: &'a Mesh,
    base: &'a Integrals,
    fine: &'a Integrals,
    interpolant: &'a [Vec2],
    solved: &'a Solved,
}

impl ExactMeasurement<'_> {
    fn fill(&self, level: &mut Level, contact: &ContactErrors) {
        let materials = &self.task.case.scene.materials;
        let (discrete, solution) = (&self.solved.discrete, &self.solved.solution);
        let d = differences(self.interpolant, &solution.displacement);
        let (base, fine) = (self.base.error(self.mesh, materials, &d), self.fine.error(self.mesh, materials, &d));
        set_errors(
            &mut level.errors,
            &fine,
            contact,
            self.fine.interpolation.energy_norm(),
            solution.energy - self.fine.energy,
        );
        level.switch_sides = Some(contact.switch_sides);
        let (by_base, by_fine) = (self.error_from_energies(self.base), self.error_from_energies(self.fine));
        level.two_way = relative_difference(fine.energy, by_fine, self.fine.solution.energy);
        let e = fine.energy_norm();
        let load_change = dual_norm(discrete, &differences(&self.fine.load, &self.base.load));
        let energy_change = (by_fine - by_base).abs() / (2.0 * e.max(f64::MIN_POSITIVE));
        level.budget = Budget {
            algebraic: share(qp::algebraic_error(&discrete.qp, &solution.raw.x, &solution.raw.multipliers), e),
            quadrature: share(load_change + energy_change + (e - base.energy_norm()).abs(), e),
            geometry: Some(0.0),
            reference: Some(0.0),
        };
        level.ledger = Some(self.ledger(&base, &fine));
    }

    /// `A(e,e) = 2(L(u_h) − L(u)) − 2∫_{Γ_K} T_n [u_h]_n ds − 2∫_{Γ_u} τ(u)n·(u_h − u) ds`.
    fn error_from_energies(&self, with: &Integrals) -> f64 {
        let u = &self.solved.solution.displacement;
        let work: f64 = with.load.iter().zip(u).map(|(f, u)| f.dot(u)).sum();
        let energy = 0.5 * self.solved.solution.strain_energy - work;
        2.0 * (energy - with.energy) - 2.0 * with.contact_work(&self.solved.state.jump) - 2.0 * with.reaction_work(u)
    }

    /// Theorem 3.1: `½A(e,e) ≤ ½A(u−u_I, u−u_I) + ∫ T_n [u_I]_n ds`.
    fn ledger(&self, base: &Squares, fine: &Squares) -> Ledger {
        let jump = contact::jumps(self.mesh, &self.solved.discrete.zone, self.interpolant);
        let (b, b_base) = (self.fine.contact_work(&jump), self.base.contact_work(&jump));
        let a = [self.base, self.fine].map(|i| 0.5 * i.interpolation.energy);
        let delta = 0.5 * (fine.energy - base.energy).abs() + (a[1] - a[0]).abs() + (b - b_base).abs();
        ledger(0.5 * fine.energy, a[1], b, delta, self.fine.solution.energy)
    }
}

fn ledger(lhs: f64, a: f64, b: f64, delta: f64, solution: f64) -> Ledger {
    let excess = lhs - (a + b + 1e-14 * solution);
    let holds = if excess <= delta {
        Some(true)
    } else if excess <= 10.0 * delta {
        None
    } else {
        Some(false)
    };
    Ledger { lhs, a, b, c: 0.0, delta, holds }
}

fn set_errors(errors: &mut Errors, e: &Squares, contact: &ContactErrors, interpolation: f64, energy_gap: f64) {
    errors.strain = Some(e.strain_seminorm());
    errors.energy = Some(e.energy_norm());
    errors.h1 = Some(e.h1_norm());
    errors.l2 = Some(e.l2_norm());
    errors.pressure_l2 = Some(contact.pressure);
    errors.pressure_dual = Some(contact.pressure_dual);
    errors.contact_set = Some(contact.contact_set);
    errors.energy_gap = Some(energy_gap);
    errors.strain_bodies = Some(e.strain.map(f64::sqrt));
    errors.interpolation = Some(interpolation);
}

/// The length of `Γ_K`.
fn zone_length(mesh: &Mesh) -> f64 {
    (0..mesh.contact.len()).map(|side| side_length(mesh, side)).sum()
}

fn differences(a: &[Vec2], b: &[Vec2]) -> Vec<Vec2> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Block-Jacobi estimate of the energy norm of the solution's change under a change of load, `(δfᵀ D⁻¹ δf)^{1/2}`: sharp for
/// the rough changes that a local quadrature error makes.
fn dual_norm(discrete: &Discrete, change: &[Vec2]) -> f64 {
    let force = discrete.basis.force(change);
    let node = |i: usize| {
        let [a, b, c, d] = discrete.qp.matrix.diagonal_block(i);
        let (x, y) = (force[2 * i], force[2 * i + 1]);
        (d * x * x - (b + c) * x * y + a * y * y) / (a * d - b * c)
    };
    (0..discrete.qp.matrix.rows()).map(node).sum::<f64>().sqrt()
}

/// `|a − b|/a`, or nothing where `a` is rounding.
fn relative_difference(a: f64, b: f64, scale: f64) -> Option<f64> {
    (a > ROUNDING * scale).then(|| (a - b).abs() / a)
}

fn share(part: f64, whole: f64) -> Option<f64> {
    (whole > 0.0).then_some(part / whole)
}
