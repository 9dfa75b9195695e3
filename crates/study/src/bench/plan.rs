//! Which levels of which cases under which solvers.

use super::job::{Job, Task};
use crate::change::Changes;
use crate::error::RunError;
use crate::run::{Alone, Method, Solver};
use crate::study::{Case, Scene, Study, Subject as Measured};

/// Unknowns above which the interior point is left out: its factorisations grow past those of the other solvers many times over.
pub const MOST_INTERIOR_POINT: usize = 20_000;
/// Unknowns above which the sparse factorisation is left out: its factor takes about 1.7 kB for each.
pub const MOST_CONDENSED: usize = 1_500_000;
/// More doublings than any memory holds.
const DOUBLINGS: usize = 24;

/// Unknowns above which a solver is left out.
pub fn most_unknowns(solver: &Solver) -> usize {
    match solver {
        Solver::Own(Method::InteriorPoint) => MOST_INTERIOR_POINT,
        Solver::Own(Method::Condensed | Method::Monotone) => MOST_CONDENSED,
        // another program has its own limits of time
        Solver::Own(Method::Automatic | Method::Multigrid) | Solver::External(_) => usize::MAX,
    }
}

/// The solver that a solver's linear problem is solved with: itself, or the factorisation where it has nothing of its own to offer. None
/// of another program: its linear problem would cost as much again, and say nothing of the programs beside it.
pub fn linear_solver(solver: &Solver) -> Option<Solver> {
    match solver.own()? {
        Method::InteriorPoint | Method::Monotone => Some(Method::Condensed.into()),
        own => Some(own.into()),
    }
}

/// Which sizes, by unknowns; cells double from the coarsest mesh of the study on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Fewest unknowns.
    pub least: usize,
    /// Most unknowns.
    pub most: usize,
    /// This many levels from the first that has enough unknowns; `None`: as many as there are.
    pub levels: Option<usize>,
}

/// A case that is timed.
#[derive(Clone)]
pub struct Subject {
    /// The word by which another process finds the study: an id or a path.
    pub name: String,
    /// The study.
    pub study: Study,
    /// Which of its cases, by position.
    pub case: usize,
    /// What options changed of the study, so that another process can do the same.
    pub changes: Changes,
}

impl Subject {
    /// The case of that name, or the first with a contact problem that has a solution.
    ///
    /// # Errors
    /// No such case, or nothing in it to solve.
    pub fn new(name: String, study: Study, case: Option<&str>) -> Result<Self, RunError> {
        let solvable = |c: &Case| c.scene().is_some() && !c.refused;
        let known: Vec<&str> = study.cases.iter().filter(|c| solvable(c)).map(|c| c.name.as_str()).collect();
        let refuse = |what: String| Err(RunError::Study(what));
        if known.is_empty() {
            return refuse(format!(
                "study '{}' has no contact problem to solve, so no solver can be timed on it",
                study.id
            ));
        }
        let wanted = case.unwrap_or(known[0]);
        match study.cases.iter().position(|c| c.name == wanted && solvable(c)) {
            Some(case) => Ok(Self { name, study, case, changes: Changes::default() }),
            None => {
                refuse(format!("study '{}' has no case `{wanted}` to time; use one of: {}", study.id, known.join(", ")))
            }
        }
    }

    /// Every case that the changes made of one case of the file: that of the name `case`, or the first that can be timed.
    ///
    /// # Errors
    /// As [`Subject::new`].
    pub fn changed(name: &str, study: &Study, case: Option<&str>, changes: &Changes) -> Result<Vec<Self>, RunError> {
        let of_file = |c: &Case| c.changed.as_ref().map_or(c.name.clone(), |m| m.case.clone());
        let named = |wanted: &str| study.cases.iter().find(|c| of_file(c) == wanted).map(|c| c.name.clone());
        // a name of the file stands for all that was made of it; any other is refused with those there are
        let first = case.map(|wanted| named(wanted).unwrap_or_else(|| wanted.to_owned()));
        let first = Self::new(name.to_owned(), study.clone(), first.as_deref())?;
        let wanted = of_file(first.case());
        let of_wanted = (0..study.cases.len()).filter(|&k| of_file(&study.cases[k]) == wanted);
        let subject = |k| Self { name: name.to_owned(), study: study.clone(), case: k, changes: changes.clone() };
        Ok(of_wanted.map(subject).collect())
    }

    /// Whether it is one of several that differ in swept values.
    pub fn is_swept(&self) -> bool {
        self.changes.sweeps()
    }

    /// The case.
    pub fn case(&self) -> &Case {
        &self.study.cases[self.case]
    }

    fn scene(&self) -> Option<&Scene> {
        match &self.case().subject {
            Measured::Contact(scene) => Some(scene),
            Measured::Lemma(_) => None,
        }
    }
}

/// A level to be timed.
#[derive(Clone, Debug, PartialEq)]
pub struct Size {
    /// Cells of the levels up to this one, coarsest first.
    pub cells: Vec<usize>,
    /// Unknowns: on uniform meshes exactly, on others about.
    pub dofs: usize,
}

/// The levels of a subject within the wanted sizes.
///
/// # Errors
/// No level has so many unknowns; what the coarsest meshes are refused for.
pub fn sizes(subject: &Subject, wanted: &Sizes) -> Result<Vec<Size>, RunError> {
    let case = subject.case();
    let scene = subject.scene().ok_or_else(|| RunError::Study("a lemma has no sizes".into()))?;
    let coarsest = case.quick[0];
    let cells: Vec<usize> = (0..DOUBLINGS).map(|k| coarsest << k).collect();
    let measured = |k: usize| Ok(Alone { case, scene, cells: &cells[..=k] }.check()?.dofs as f64);
    let first: Result<Vec<f64>, RunError> = (0..3).map(measured).collect();
    let dofs = extended(first?);
    let enough = (0..DOUBLINGS).filter(|&k| (wanted.least..=wanted.most).contains(&dofs[k]));
    let size = |k: usize| Size { cells: cells[..=k].to_vec(), dofs: dofs[k] };
    let found: Vec<Size> = enough.map(size).take(wanted.levels.unwrap_or(usize::MAX)).collect();
    if found.is_empty() {
        return Err(RunError::Study(format!(
            "no level of '{}' has between {} and {} unknowns: it has {}, {}, {}, … as the cells double from {coarsest}",
            subject.study.id, wanted.least, wanted.most, dofs[0], dofs[1], dofs[2]
        )));
    }
    Ok(found)
}

/// Unknowns of all levels from those of the first three, by the quadratic polynomial in the number of cells through them.
fn extended(first: Vec<f64>) -> Vec<usize> {
    // with n = 1, 2, 4: a n² + b n + c
    let [d1, d2, d4] = [first[0], first[1], first[2]];
    let a = ((d4 - d2) / 2.0 - (d2 - d1)) / 3.0;
    let b = d2 - d1 - 3.0 * a;
    let c = d1 - a - b;
    let at = |k: usize| {
        let n = 2f64.powi(k as i32);
        (a * n * n + b * n + c).round() as usize
    };
    (0..DOUBLINGS).map(at).collect()
}

/// Everything that is to be measured.
pub struct Plan {
    /// The cases.
    pub subjects: Vec<Subject>,
    /// The solvers, in the order of the tables.
    pub solvers: Vec<Solver>,
    /// The sizes.
    pub sizes: Sizes,
    /// Rounds.
    pub repeat: usize,
    /// Threads of each process.
    pub threads: usize,
    /// The program's version.
    pub version: String,
}

/// The jobs of one level, each once: contact problems and, once for each solver of theirs, linear problems; one product.
pub(super) fn jobs(subject: &Subject, size: &Size, solvers: &[Solver]) -> Vec<Job> {
    let fitting = solvers.iter().filter(|s| size.dofs <= most_unknowns(s));
    let mut tasks: Vec<Task> = Vec::new();
    for solver in fitting {
        tasks.push(Task::Contact(solver.clone()));
        let linear = linear_solver(solver).map(Task::Linear);
        tasks.extend(linear.filter(|l| !tasks.contains(l)));
    }
    // of many cases on the same meshes the product is no floor worth its time
    if !subject.is_swept() {
        tasks.push(Task::Product);
    }
    let job = |task| Job { task, ..job_of(subject, size) };
    tasks.into_iter().map(job).collect()
}

/// A job of a level whose task is still to be named.
fn job_of(subject: &Subject, size: &Size) -> Job {
    let (study, case) = (subject.name.clone(), subject.case().name.clone());
    Job { study, case, cells: size.cells.clone(), task: Task::Product, changes: subject.changes.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two squares of n × n cells, clamped below: 2·2(n+1)² − 2(n+1) unknowns.
    #[test]
    fn unknowns_of_uniform_meshes_are_foretold() {
        let exact = |n: usize| 4 * (n + 1) * (n + 1) - 2 * (n + 1);
        let dofs = extended([8, 16, 32].iter().map(|&n| exact(n) as f64).collect());
        for (k, n) in [8, 16, 32, 64, 1024, 8192].iter().map(|n| ((n / 8usize).ilog2() as usize, *n)) {
            assert_eq!(dofs[k], exact(n), "n = {n}");
        }
    }

    #[test]
    fn the_interior_point_leaves_large_levels_alone_and_borrows_its_floor() {
        let study = crate::sample::study("two-squares");
        let subject = Subject::new("two-squares".into(), study, None).unwrap();
        let solvers = [Method::Condensed, Method::InteriorPoint].map(Solver::from);
        let names = |dofs| -> Vec<Task> {
            let size = Size { cells: vec![4, 8], dofs };
            jobs(&subject, &size, &solvers).into_iter().map(|j| j.task).collect()
        };
        let [condensed, interior] = solvers.clone().map(Task::Contact);
        let linear = Task::Linear(Method::Condensed.into());
        assert_eq!(names(20_000), [condensed.clone(), linear.clone(), interior, Task::Product]);
        assert_eq!(names(20_001), [condensed, linear, Task::Product]);
        assert_eq!(names(1_500_001), [Task::Product]);
    }
}
