//! Falk's splitting on a solved level, for every admissible field at hand.
//!
//! | `v ∈ K` | `v_h ∈ K_h` |
//! | --- | --- |
//! | the solution `u` | the discrete solution `u_h` |
//! | where `K_h ⊂ K`: every field on the right, random ones drawn anew | the interpolant of `u` |
//! | else random fields, the bodies pushed apart until they overlap nowhere | the discrete solution of the next coarser mesh, where `K_{2h} ⊂ K_h` |
//! | against a discrete reference: random fields of its own set | random fields |
//!
//! (1.2) takes `v = u_h`, whether `K_h ⊂ K` or not: what it says then is the study's question.
//!
//! Random fields lie around `u_h` at the distance of its error, or of its size.

use super::{Solved, Task, algebraic_error};
use crate::error::RunError;
use crate::record::{Estimate, Splitting};
use crate::reference::exact::Pair;
use crate::reference::overkill::Overkill;
use crate::splitting::{Forms, Named, Random, Sides, SplittingPlan, dot, opened, worst_of_each_kind};
use signorini_contact::mesh::{Hierarchy, Mesh};
use signorini_contact::{Vec2, assembly};

/// Random fields of each set.
const DRAWS: u64 = 3;

/// Streams of random numbers: those of `v` and those of `v_h`.
const STREAM_V: u64 = 1 << 32;

/// Rounding of the sums, as a share of the energies that enter.
const ROUNDING: f64 = 1e-14;

const SOLUTION: &str = "solution u";
const DISCRETE: &str = "discrete solution uₕ";
const INTERPOLANT: &str = "interpolant u_I";
const COARSER: &str = "solution of the next coarser mesh";
const RANDOM: &str = "random";
const RANDOM_OPENED: &str = "random, opened";

/// The two sides for `v` (none: `u` itself) and `v_h`, and what quadrature and solver may make of the slack.
type Evaluate<'a> = dyn Fn(Option<&[Vec2]>, &[Vec2]) -> (Sides, f64) + 'a;

/// A level and what the splitting is measured with.
pub(super) struct Measured<'a> {
    pub task: &'a Task<'a>,
    pub plan: SplittingPlan,
    pub hierarchy: &'a Hierarchy,
    pub solved: &'a Solved,
    /// Whether `K_h ⊂ K`.
    pub inside: bool,
}

impl Measured<'_> {
    /// Against the exact solution, with the two quadratures of which the second is finer and used. `squares` is `A(e,e)` by
    /// both.
    pub fn against_exact(
        &self,
        pair: &Pair,
        interpolant: &[Vec2],
        squares: [f64; 2],
    ) -> Result<Vec<Splitting>, RunError> {
        let (mesh, materials) = (self.hierarchy.finest(), &self.task.scene.materials);
        let forms = pair.forms(mesh, materials, interpolant);
        let discrete = self.discrete_fields(interpolant, squares[1])?;
        let mut admissible = vec![Named { kind: SOLUTION, values: None }];
        if self.inside || self.plan.estimate == Estimate::Contained {
            admissible.extend(self.others(&discrete, squares[1]));
        } else {
            let random = self.random(mesh);
            let draw = |k| random.components(self.plan.seed, STREAM_V + k, self.distance(k, squares[1]));
            let fields = (0..DRAWS).filter_map(|k| opened(&self.solved.discrete, mesh, draw(k)));
            admissible.extend(fields.map(|f| Named::nodal(RANDOM_OPENED, f)));
        }
        let entry = |v: Option<&[Vec2]>, v_h: &[Vec2]| {
            let u_h = &self.solved.solution.displacement;
            let [base, fine] = [0, 1].map(|k| Sides::new(self.plan.estimate, &forms[k], u_h, v, v_h, squares[k]));
            let change = (fine.slack() - base.slack()).abs();
            (fine, change + self.solver_share(&forms[1], u_h, v_h))
        };
        Ok(self.all(&forms[1], &admissible, &discrete, &entry))
    }

    /// Against a discrete reference `u` on a nested finer mesh, with `K` its own discrete set; `at` is the level's place in its
    /// hierarchy. Everything lives on the reference's mesh. `square` is `A(e,e)`.
    pub fn against_overkill(&self, reference: &Overkill, at: usize, square: f64) -> Result<Vec<Splitting>, RunError> {
        let (mesh, materials) = (reference.hierarchy.finest(), &self.task.scene.materials);
        let u = &reference.solution.displacement;
        let forms = Forms::of_nodal(mesh, materials, reference.discrete.load.clone(), u);
        let coarse = self.discrete_fields(reference.interpolant(at), square)?;
        let lift = |field: &Named| Named {
            kind: field.kind,
            values: field.values.as_ref().map(|values| reference.prolong(at, values)),
        };
        let lifted: Vec<Named> = coarse.iter().map(lift).collect();
        let mut admissible = vec![Named { kind: SOLUTION, values: None }];
        admissible.extend(lifted.iter().filter(|f| f.kind != RANDOM).map(clone));
        let random = Random { discrete: &reference.discrete, mesh, materials, centre: &reference.solution.raw.x };
        admissible.extend(
            (0..DRAWS)
                .map(|k| Named::nodal(RANDOM, random.field(self.plan.seed, STREAM_V + k, self.distance(k, square)))),
        );
        let u_h = reference.prolong(at, &self.solved.solution.displacement);
        // what the level's own quadrature makes of the loads
        let own = |v: &[Vec2]| dot(&self.solved.discrete.load, &v[..self.solved.discrete.load.len()]);
        let of_reference = algebraic_error(&reference.discrete, &reference.solution);
        let entry = |v: Option<&[Vec2]>, v_h: &[Vec2]| {
            let sides = Sides::new(self.plan.estimate, &forms, &u_h, v, v_h, square);
            let loads = (forms.load(v_h) - forms.load(&u_h) - own(v_h) + own(&u_h)).abs();
            let distance = v.map_or(0.0, |v| distance(&forms, v, u));
            (sides, loads + of_reference * distance + self.solver_share(&forms, &u_h, v_h))
        };
        Ok(self.all(&forms, &admissible, &lifted, &entry))
    }

    /// Every pair, of random fields the worst.
    fn all(&self, forms: &Forms, admissible: &[Named], discrete: &[Named], entry: &Evaluate) -> Vec<Splitting> {
        let contained = self.plan.estimate == Estimate::Contained;
        // (1.2) is (1.1) with v = u_h
        let chosen = admissible.iter().filter(|v| !contained || v.kind == DISCRETE);
        let pairs = chosen.flat_map(|v| discrete.iter().map(move |v_h| (v, v_h)));
        let entries = pairs.filter_map(|(v, v_h)| {
            let (values, values_h) = (v.values.as_deref(), v_h.values.as_deref()?);
            let (sides, share) = entry(values, values_h);
            let energy = |w: Option<&[Vec2]>| w.map_or(forms.energy, |w| forms.product(w, w));
            let delta = share + ROUNDING * (energy(None) + energy(values) + energy(Some(values_h)));
            Some(sides.record(self.plan.estimate, [v.kind, v_h.kind], delta))
        });
        worst_of_each_kind(entries.collect())
    }

    /// The fields of `K_h`, random ones last.
    fn discrete_fields(&self, interpolant: &[Vec2], square: f64) -> Result<Vec<Named>, RunError> {
        let mut fields = vec![
            Named::nodal(DISCRETE, self.solved.solution.displacement.clone()),
            Named::nodal(INTERPOLANT, interpolant.to_vec()),
        ];
        fields.extend(self.coarser()?.map(|field| Named::nodal(COARSER, field)));
        fields.extend(self.draws(0, square));
        Ok(fields)
    }

    /// The deterministic fields of `K_h` and random ones drawn anew: what `v` may be where `K_h ⊂ K`.
    fn others(&self, discrete: &[Named], square: f64) -> Vec<Named> {
        discrete.iter().filter(|f| f.kind != RANDOM).map(clone).chain(self.draws(STREAM_V, square)).collect()
    }

    fn draws(&self, stream: u64, square: f64) -> impl Iterator<Item = Named> {
        let random = self.random(self.hierarchy.finest());
        let draw = move |k| Named::nodal(RANDOM, random.field(self.plan.seed, stream + k, self.distance(k, square)));
        (0..DRAWS).map(draw)
    }

    fn random<'b>(&'b self, mesh: &'b Mesh) -> Random<'b> {
        let Solved { discrete, solution, .. } = self.solved;
        Random { discrete, mesh, materials: &self.task.scene.materials, centre: &solution.raw.x }
    }

    /// The error's size, for the last draw that of the solution.
    fn distance(&self, draw: u64, square: f64) -> f64 {
        if draw + 1 < DRAWS { square.sqrt() } else { self.solved.solution.strain_energy.sqrt() }
    }

    /// The discrete solution one mesh up, where its set is part of this one.
    fn coarser(&self) -> Result<Option<Vec<Vec2>>, RunError> {
        let levels = self.hierarchy.levels();
        let Some(at) = levels.len().checked_sub(2).filter(|_| self.inside) else { return Ok(None) };
        let (task, mesh) = (self.task, &levels[at]);
        let (supports, cubature) = (task.scene.supports(), task.scene.cubature(0, task.case.fixed_quadrature));
        let (_, solution) = task.problem(mesh, &supports, &cubature).solve(&task.settings)?;
        Ok(Some(self.hierarchy.prolong(at, at + 1, &solution.displacement)))
    }

    /// `|r(v_h − u_h)|` of the solver's residual is at most its dual norm times this distance.
    fn solver_share(&self, forms: &Forms, u_h: &[Vec2], v_h: &[Vec2]) -> f64 {
        algebraic_error(&self.solved.discrete, &self.solved.solution) * distance(forms, u_h, v_h)
    }
}

fn clone(field: &Named) -> Named {
    Named { kind: field.kind, values: field.values.clone() }
}

/// `√A(a−b, a−b)`.
fn distance(forms: &Forms, a: &[Vec2], b: &[Vec2]) -> f64 {
    let difference = super::parts::differences(a, b);
    dot(&assembly::internal_forces(forms.mesh, forms.materials, &difference), &difference).max(0.0).sqrt()
}
