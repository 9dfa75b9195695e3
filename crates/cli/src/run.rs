//! `signorini run`: studies in, records, tables, plots and a verdict out.

use crate::args::{ProfileArg, RunArgs, SolverArg};
use crate::failure::Failure;
use crate::progress::Progress;
use rayon::prelude::*;
use serde::Serialize;
use signorini_report::summary_text;
use signorini_study::file::{Library, find_studies};
use signorini_study::record::{StudyRecord, to_json};
use signorini_study::run::timing::LevelTimes;
use signorini_study::run::{self, CaseRun, Method, Profile, RunSettings};
use signorini_study::store::{self, Baseline, StoreError};
use signorini_study::study::Study;
use signorini_study::verdict;
use std::path::Path;

/// Runs studies and returns the exit status.
pub fn run(args: &RunArgs) -> Result<u8, Failure> {
    let studies = load(&args.studies)?;
    let (runs, drifted) = execute(args, &studies)?;
    let records: Vec<StudyRecord> = runs.into_iter().flatten().map(|r| r.record).collect();
    signorini_report::render_summary(&records, &args.out)?;
    say!("{}", summary_text(&records));
    drifted.iter().for_each(|line| sayln!("drift: {line}"));
    if !args.quiet {
        sayln!("tables and plots: {}", args.out.join("summary.md").display());
    }
    let status = verdict::exit_status(&records);
    Ok(if args.strict && !drifted.is_empty() { 1 } else { status })
}

/// The library of studies around the current folder.
pub fn library() -> Result<Library, Failure> {
    let here = std::env::current_dir().map_err(|e| {
        Failure::new(format!("the current folder cannot be read: {e}"), "run from a folder that exists")
    })?;
    Ok(find_studies(&here))
}

/// Reads the studies that the names stand for.
pub fn load(names: &[String]) -> Result<Vec<Study>, Failure> {
    let sources = library()?.select(names)?;
    sources.iter().map(|s| s.load().map_err(Failure::from)).collect()
}

/// Runs the studies side by side and writes each study's files as soon as it is done. Returns the runs in the order of
/// the studies, and what drifted from the baselines.
pub fn execute(args: &RunArgs, studies: &[Study]) -> Result<(Vec<Vec<CaseRun>>, Vec<String>), Failure> {
    if let Some(threads) = args.threads {
        // Only the first pool of a process can be set; this is the first.
        let built = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads)).build_global();
        built.map_err(|e| Failure::new(format!("no pool of {threads} threads: {e}"), "leave --threads out"))?;
    }
    let settings = settings(args);
    let progress = Progress::new(studies.iter().map(|s| run::work(s, &settings)).sum(), args.quiet);
    let one = |study: &Study| run_and_write(study, &settings, &args.out, &progress);
    let results: Vec<_> = studies.par_iter().with_max_len(1).map(one).collect();
    progress.finish();
    run::tidy(&settings);
    let mut runs = Vec::new();
    let mut drifted = Vec::new();
    for result in results {
        let (run, drift) = result?;
        runs.push(run);
        drifted.extend(drift);
    }
    Ok((runs, drifted))
}

fn settings(args: &RunArgs) -> RunSettings {
    RunSettings {
        profile: profile(args.profile),
        levels: args.levels.map(usize::from),
        solver: args.solver.map(|s| match s {
            SolverArg::Condensed => Method::Condensed,
            SolverArg::InteriorPoint => Method::InteriorPoint,
        }),
        partial: Some(args.out.join(".partial")),
    }
}

/// The profile that a word of the command line means.
pub fn profile(arg: ProfileArg) -> Profile {
    match arg {
        ProfileArg::Quick => Profile::Quick,
        ProfileArg::Full => Profile::Full,
    }
}

type StudyRun = (Vec<CaseRun>, Vec<String>);

fn run_and_write(study: &Study, settings: &RunSettings, out: &Path, progress: &Progress) -> Result<StudyRun, Failure> {
    let mut runs = run::run_study(study, settings, progress).map_err(|e| Failure::of_run(study, &e))?;
    let drift = drift(&mut runs)?;
    for run in &runs {
        store::write_record(out, &run.record)?;
        signorini_report::render(&run.record, &store::record_folder(out, &run.record)?)?;
    }
    write_timings(study, &runs, out)?;
    let outcomes = runs.iter().map(|r| verdict::effective(r.record.verdict.outcome, r.record.expect));
    progress.study_done(&study.id, &format!("{:?}", verdict::worst(outcomes)).to_lowercase());
    Ok((runs, drift))
}

/// Compares with the stored baseline of the study, and notes the differences in the records.
fn drift(runs: &mut [CaseRun]) -> Result<Vec<String>, Failure> {
    let Some(study) = runs.first().map(|r| r.record.study.clone()) else { return Ok(Vec::new()) };
    let Some(baseline) = reference_folder().map(|f| Baseline::read(&f, &study)).transpose()?.flatten() else {
        return Ok(Vec::new());
    };
    let mut all = Vec::new();
    for run in runs {
        let lines = store::drift(&baseline, &run.record);
        run.record.notes.extend(lines.iter().map(|l| format!("drift from the baseline: {l}")));
        all.extend(lines.into_iter().map(|l| format!("{study}/{}: {l}", run.record.case)));
    }
    Ok(all)
}

/// `reference/` in the current folder or the nearest parent that has one.
pub fn reference_folder() -> Option<std::path::PathBuf> {
    let here = std::env::current_dir().ok()?;
    here.ancestors().map(|f| f.join("reference")).find(|f| f.is_dir())
}

#[derive(Serialize)]
struct Timings<'a> {
    threads: usize,
    cases: Vec<CaseTimings<'a>>,
}

#[derive(Serialize)]
struct CaseTimings<'a> {
    case: &'a str,
    reference: Option<&'a LevelTimes>,
    levels: &'a [LevelTimes],
}

/// `<id>/timings.json`: seconds per level, apart from the records, which must not change from run to run.
fn write_timings(study: &Study, runs: &[CaseRun], out: &Path) -> Result<(), Failure> {
    let case = |r: &'_ CaseRun| -> (String, Option<LevelTimes>, Vec<LevelTimes>) {
        (r.record.case.clone(), r.reference_times.clone(), r.times.clone())
    };
    let owned: Vec<_> = runs.iter().map(case).collect();
    let cases =
        owned.iter().map(|(case, reference, levels)| CaseTimings { case, reference: reference.as_ref(), levels });
    let timings = Timings { threads: rayon::current_num_threads(), cases: cases.collect() };
    let path = out.join(&study.id).join("timings.json");
    let text = to_json(&timings).map_err(|source| StoreError::Content { path: path.clone(), source })?;
    Ok(store::write_atomic(&path, &text)?)
}
