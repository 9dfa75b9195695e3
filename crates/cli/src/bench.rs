//! `signorini bench`: speed against error, every measurement in a process of its own.
//!
//! The program calls itself with `bench-one`, writes a job to that process's standard input and reads the outcome from its standard
//! output, both as JSON.

use crate::VERSION;
use crate::args::{BenchArgs, SolverArg};
use crate::change::load_changed;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Count;
use crate::run::{method, use_threads};
use crate::solver::EXCHANGE;
use clap::ValueEnum;
use signorini_study::bench::{BenchRecord, Job, Outcome, Plan, Sizes, Subject, carry_out, measure};
use signorini_study::change::Changes;
use signorini_study::record::to_json;
use signorini_study::run::Solver;
use signorini_study::study::Study;
use signorini_study::verdict;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// What is measured when nothing is named: one case against its exact solution, one without.
const DEFAULT: [&str; 2] = ["theorem-3-1-smooth", "two-squares"];

/// Measures and returns the exit status: 2 if something that was to be measured could not be, else 0.
pub fn bench(args: &BenchArgs) -> Result<u8, Failure> {
    let plan = plan(args)?;
    // refused now, not after all the measurements
    std::fs::create_dir_all(&args.out)
        .map_err(|e| Failure::new(format!("{}: {e}", args.out.display()), "name another folder with --out"))?;
    let program = std::env::current_exe()
        .map_err(|e| Failure::new(format!("the program cannot find itself: {e}"), "start it by its full path"))?;
    let mut progress = Count::new(0, "measurements", true);
    let record = {
        let progress = std::cell::RefCell::new(&mut progress);
        measure(
            &plan,
            |number| **progress.borrow_mut() = Count::new(number, "measurements", args.quiet),
            |job| {
                let outcome = in_its_own_process(&program, job, plan.threads);
                progress.borrow().done();
                outcome
            },
        )
    };
    progress.finish();
    // empty unless something failed, whose files stay
    let _ = std::fs::remove_dir(args.out.join(EXCHANGE));
    let record = record
        .map_err(|e| Failure::new(e.to_string(), "`signorini bench --help` shows how sizes and cases are chosen"))?;
    report(&record, args)
}

fn report(record: &BenchRecord, args: &BenchArgs) -> Result<u8, Failure> {
    signorini_report::render_bench(record, &args.out)?;
    say!("{}", signorini_report::bench_text(record));
    if !args.quiet {
        sayln!("tables and plots: {}", args.out.join("bench.md").display());
    }
    Ok(if record.is_incomplete() { verdict::BAD_INPUT } else { 0 })
}

/// Carries out the job on standard input.
pub fn one() -> Result<u8, Failure> {
    let broken = |why: String| Failure::new(why, "`bench-one` is for `bench` alone; call that");
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|e| broken(format!("no job: {e}")))?;
    let (threads, job): (u16, Job) = serde_json::from_str(&text).map_err(|e| broken(format!("no job: {e}")))?;
    use_threads(Some(threads))?;
    interrupt::take_along()?;
    let outcome = carry_out(&job, |job: &Job| load_one(&job.study, &job.changes))?;
    let text = to_json(&outcome).map_err(|e| broken(format!("the outcome cannot be told: {e}")))?;
    say!("{text}");
    Ok(0)
}

fn plan(args: &BenchArgs) -> Result<Plan, Failure> {
    let changes = args.change.changes()?;
    let default = DEFAULT.map(str::to_owned);
    let names = if args.studies.is_empty() { &default[..] } else { &args.studies };
    let mut solvers = Vec::new();
    let chosen = if args.solvers.is_empty() { SolverArg::value_variants() } else { &args.solvers };
    for solver in chosen.iter().map(|s| method(*s)) {
        if !solvers.contains(&solver) {
            solvers.push(solver);
        }
    }
    let mut solvers: Vec<Solver> = solvers.into_iter().map(Solver::Own).collect();
    solvers.extend(args.external.solvers(&args.out)?);
    let sizes = Sizes {
        least: args.dofs.least,
        most: args.max_dofs.unwrap_or(args.dofs.most),
        levels: args.levels.map(usize::from),
    };
    let processors = || std::thread::available_parallelism().map_or(1, usize::from);
    Ok(Plan {
        subjects: names.iter().map(|n| subjects(n, &changes)).collect::<Result<Vec<_>, _>>()?.concat(),
        solvers,
        sizes,
        repeat: usize::from(args.repeat),
        threads: args.threads.map_or_else(processors, usize::from),
        version: VERSION.to_owned(),
    })
}

/// `STUDY` or `STUDY/CASE`, and what the changes made of it; a path to a file has blanks and slashes of its own.
fn subjects(name: &str, changes: &Changes) -> Result<Vec<Subject>, Failure> {
    let (study, case) = match name.rsplit_once('/') {
        Some((study, case)) if !is_file(name) => (study, Some(case)),
        _ => (name, None),
    };
    let loaded = load_one(study, changes)?;
    // the case of another process is found by name, so the whole word is checked here
    Subject::changed(study, &loaded, case, changes).map_err(|e| {
        Failure::new(e.to_string(), "`signorini list` shows every study, `signorini check STUDY` its cases")
    })
}

fn is_file(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|e| e == "toml")
}

/// The one study that a name stands for.
fn load_one(name: &str, changes: &Changes) -> Result<Study, Failure> {
    let mut studies = load_changed(&[name.to_owned()], changes)?;
    match (studies.pop(), studies.is_empty()) {
        (Some(study), true) => Ok(study),
        _ => Err(Failure::new(
            format!("`{name}` is a group of studies, and every study is timed by itself"),
            "name studies by their ids",
        )),
    }
}

/// The outcome of a job, or why there is none.
fn in_its_own_process(program: &PathBuf, job: &Job, threads: usize) -> Result<Outcome, String> {
    let told = serde_json::to_vec(&(threads, job)).map_err(|e| e.to_string())?;
    let mut child = Command::new(program)
        .arg("bench-one")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| format!("no process: {e}"))?;
    // the pipe closes at the end of the statement; a child that reads nothing tells why on standard error
    let _ = child.stdin.take().map(|mut pipe| pipe.write_all(&told));
    let output = child.wait_with_output().map_err(|e| format!("no outcome: {e}"))?;
    if !output.status.success() {
        return Err(reason(&output));
    }
    serde_json::from_slice(&output.stdout).map_err(|e| format!("an outcome that cannot be read: {e}"))
}

/// What the process said, with the last words of a program that failed it; or how it ended: without a word where the system killed it, as it does when memory runs out.
fn reason(output: &Output) -> String {
    let said = String::from_utf8_lossy(&output.stderr);
    match said.lines().find_map(|l| l.strip_prefix("error: ")) {
        Some(error) => {
            let last = said.lines().filter_map(|l| l.strip_prefix("  | ")).next_back();
            last.map_or_else(|| error.to_owned(), |l| format!("{error}: {}", l.trim()))
        }
        None => format!("ended by the system ({}); if memory ran out, choose smaller sizes", output.status),
    }
}
