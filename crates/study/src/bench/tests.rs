//! Whole measurements on made-up outcomes and, once, on real ones.

use super::job::{Job, Outcome, Product, Task, TimedLevel, carry_out};
use super::plan::{Plan, Sizes, Subject};
use super::record::{BenchRecord, ErrorSource};
use super::{measure, plan};
use crate::change::Changes;
use crate::error::RunError;
use crate::external::{External, Limits};
use crate::run::{Method, Solver};
use crate::sample;

fn plan(study: &str, case: Option<&str>, repeat: usize, most: usize) -> Plan {
    Plan {
        subjects: vec![Subject::new(study.into(), sample::study(study), case).unwrap()],
        solvers: vec![Method::Condensed.into(), Method::InteriorPoint.into()],
        sizes: Sizes { least: 0, most, levels: None },
        repeat,
        threads: 1,
        version: "test".into(),
    }
}

/// Seconds as if on a machine: linear in the unknowns, the contact problem twice the linear one, `noise` on top.
fn made_up(job: &Job, noise: f64) -> Outcome {
    let n = *job.cells.last().unwrap_or(&0);
    let k = job.cells.len().saturating_sub(1);
    let seconds = |factor: f64| 1e-6 * factor * (4 * n * n) as f64 + noise;
    let level = |system: f64| {
        let mut level = sample::level(k, 1.0 / n as f64);
        level.inside = Some(true);
        level.energy = -0.5 + 0.5 / (n * n) as f64;
        let wall = [0.0, seconds(1.0), 0.0, seconds(system), 0.0];
        Outcome::Level(Box::new(TimedLevel {
            level,
            work: None,
            wall,
            processor: Some(wall),
            peak_bytes: Some(1 << 20),
        }))
    };
    match &job.task {
        Task::Bandwidth => Outcome::Bandwidth([1e10, 2e10]),
        Task::Product => Outcome::Product(Product { seconds: seconds(0.01), matrix_bytes: 1000 }),
        Task::Linear(_) => level(2.0),
        Task::Contact(_) => level(4.0),
    }
}

fn record(plan: &Plan) -> (BenchRecord, Vec<Job>) {
    let (mut visited, mut noise) = (Vec::new(), 0.0);
    let made = measure(
        plan,
        |_| (),
        |job| {
            visited.push(job.clone());
            // every fourth visit is disturbed
            noise = if visited.len() % 4 == 0 { 1.0 } else { 0.0 };
            Ok(made_up(job, noise))
        },
    );
    (made.unwrap(), visited)
}

#[test]
fn medians_ratios_exponents_and_targets_come_out_as_put_in() {
    let plan = plan("theorem-3-1-smooth", None, 5, 40_000);
    let (record, _) = record(&plan);
    let study = &record.studies[0];
    assert_eq!((study.case.as_str(), study.error, study.sizes.len()), ("structured", ErrorSource::Exact, 4));
    let condensed = &study.solvers[0];
    for run in &condensed.runs {
        let n = f64::from(8 << run.level);
        let linear = run.linear.unwrap();
        assert!((linear.ratio - 2.0).abs() < 1e-12, "{linear:?}");
        assert!((run.wall.solution.median - 2e-5 * n * n).abs() < 1e-12, "{:?}", run.wall);
        assert!((run.error.unwrap() - 1.0 / n).abs() < 1e-15);
    }
    let grown = condensed.growth_total.unwrap();
    assert!((grown.value - 1.0).abs() < 1e-12, "{grown:?}");
    // t = 2e-5 n² = 2e-5 e^{-2}
    assert_eq!(study.targets, [0.1, 0.05, 0.02]);
    for (target, seconds) in study.targets.iter().zip(&condensed.seconds_to_target) {
        assert!((seconds.unwrap() * target * target / 2e-5 - 1.0).abs() < 1e-10);
    }
    assert_eq!(record.bandwidth.all_threads.unwrap().median, 2e10);
    assert!(!record.is_incomplete());
    let text = record.to_json().unwrap();
    assert_eq!(serde_json::from_str::<BenchRecord>(&text).unwrap(), record);
}

#[test]
fn rounds_go_forwards_and_backwards_and_every_job_is_in_each() {
    let plan = plan("theorem-3-1-smooth", None, 2, 1000);
    let (_, mut visited) = record(&plan);
    let second = visited.split_off(visited.len() / 2);
    visited.reverse();
    assert_eq!(visited, second);
}

#[test]
fn a_job_that_fails_is_left_out_with_its_reason_and_not_tried_again() {
    let plan = plan("theorem-3-1-smooth", None, 3, 3000);
    let mut tries = 0;
    let made = measure(
        &plan,
        |_| (),
        |job| match &job.task {
            Task::Contact(solver) if solver.name() == "condensed" && job.cells.len() == 2 => {
                tries += 1;
                Err("killed".into())
            }
            _ => Ok(made_up(job, 0.0)),
        },
    );
    let record = made.unwrap();
    let left = &record.studies[0].solvers[0].left_out;
    assert_eq!((tries, left.len(), left[0].level, left[0].reason.as_str()), (1, 1, 1, "killed"));
    assert!(record.is_incomplete());
}

#[test]
fn an_answer_that_is_no_solution_is_left_out_however_fast_it_came() {
    let mut plan = plan("theorem-3-1-smooth", None, 3, 3000);
    plan.solvers.truncate(1);
    let left_out = |share: f64| {
        let mut visits = 0;
        let spoilt = |job: &Job| {
            let mut outcome = made_up(job, 0.0);
            if let (Outcome::Level(timed), Task::Contact(_), 2) = (&mut outcome, &job.task, job.cells.len()) {
                visits += 1;
                // once is enough
                timed.level.budget.algebraic = Some(if visits == 2 { share } else { 0.0 });
            }
            Ok(outcome)
        };
        measure(&plan, |_| (), spoilt).unwrap().studies[0].solvers[0].left_out.clone()
    };
    assert!(left_out(0.049).is_empty());
    let left = left_out(0.08);
    assert_eq!((left.len(), left[0].level), (1, 1));
    assert!(left[0].reason.starts_with("algebraic error is 8.0 % of the measured error"), "{left:?}");
}

#[test]
fn another_program_that_fails_is_not_tried_on_finer_meshes_and_has_no_linear_problem() {
    let external = External::parse("sh -c 'exit 1'", "out".into(), Limits::default()).unwrap();
    let mut plan = plan("theorem-3-1-smooth", None, 2, 10_000);
    plan.solvers = vec![Method::Condensed.into(), Solver::External(external)];
    let mut tries = Vec::new();
    let made = measure(
        &plan,
        |_| (),
        |job| match &job.task {
            Task::Contact(Solver::External(_)) => {
                tries.push(job.cells.len());
                if job.cells.len() == 2 { Err("it took too long".into()) } else { Ok(made_up(job, 0.0)) }
            }
            _ => Ok(made_up(job, 0.0)),
        },
    );
    let record = made.unwrap();
    let [own, theirs] = &record.studies[0].solvers[..] else { panic!("two solvers") };
    assert_eq!((own.solver.as_str(), own.runs.len(), theirs.solver.as_str()), ("condensed", 3, "sh"));
    assert_eq!((tries, theirs.runs.len(), theirs.linear_solver.as_ref()), (vec![1, 2, 1], 1, None));
    assert!(theirs.runs[0].linear.is_none() && own.runs[0].linear.is_some());
    let reasons: Vec<&str> = theirs.left_out.iter().map(|l| l.reason.as_str()).collect();
    assert_eq!(reasons, ["it took too long", "not tried, since it failed on a coarser mesh"]);
    assert!(record.is_incomplete());
}

#[test]
fn without_an_exact_solution_errors_come_from_the_energies() {
    let mut plan = plan("two-squares", None, 1, 70_000);
    plan.solvers = vec![Method::Condensed.into()];
    let (record, _) = record(&plan);
    let study = &record.studies[0];
    assert_eq!((study.error, study.sizes.len()), (ErrorSource::Energies, 5));
    // L = −½ + ½n⁻²: e = 1/n
    for run in &study.solvers[0].runs {
        let n = f64::from(8 << run.level);
        assert!((run.error.unwrap() * n - 1.0).abs() < 1e-6, "{run:?}");
    }
}

#[test]
fn a_real_level_is_that_of_a_run_and_its_linear_twin_has_no_bounds() {
    let study = sample::study("theorem-3-1-smooth");
    let job = |task| Job {
        study: study.id.clone(),
        case: "structured".into(),
        cells: vec![4, 8],
        task,
        changes: Changes::default(),
    };
    let outcome = |task| carry_out::<RunError>(&job(task), |_| Ok(study.clone())).unwrap();
    let level = |task| match outcome(task) {
        Outcome::Level(timed) => *timed,
        other => panic!("{other:?}"),
    };
    let contact = level(Task::Contact(Method::Condensed.into()));
    let linear = level(Task::Linear(Method::Condensed.into()));
    assert!(contact.level.errors.energy.unwrap() < 0.5 && contact.level.constraints == 9);
    assert_eq!((linear.level.constraints, linear.level.dofs), (0, contact.level.dofs - 9));
    assert!(linear.level.solver.solved && linear.wall[2] + linear.wall[3] > 0.0);
    let Outcome::Product(product) = outcome(Task::Product) else { panic!("a product") };
    assert!(product.seconds > 0.0 && product.matrix_bytes > 36 * 2 * 81);
}

#[test]
fn what_cannot_be_timed_is_refused_with_the_way_out() {
    let refuse = |study: &str, case| Subject::new(study.into(), sample::study(study), case).err().unwrap().to_string();
    assert!(refuse("lemma-3-2", None).contains("no contact problem to solve"));
    let unknown = refuse("theorem-3-1-smooth", Some("rough"));
    assert!(unknown.contains("no case `rough`") && unknown.contains("structured, perturbed"), "{unknown}");
    let subject = Subject::new("two-squares".into(), sample::study("two-squares"), None).unwrap();
    let none = plan::sizes(&subject, &Sizes { least: 10, most: 20, levels: None }).unwrap_err().to_string();
    assert!(none.contains("no level of 'two-squares' has between 10 and 20 unknowns"), "{none}");
}
