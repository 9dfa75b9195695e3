//! `signorini run`: studies in, records, tables, plots and a verdict out.

use crate::args::{ProfileArg, RunArgs, SolverArg};
use crate::failure::Failure;
use crate::progress::Progress;
use serde::Serialize;
use signorini_report::summary_text;
use signorini_study::fields::store::write_fields;
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
    use_threads(args.threads)?;
    let settings = settings(args);
    let progress = Progress::new(studies.iter().map(|s| run::work(s, &settings)).sum(), args.quiet);
    let results = run::each_case(studies, &settings, |study, case| {
        let run = run::run_case(study, case, &settings, &progress);
        let run = run.map_err(|e| Failure::of_run(study, &e.in_case(study, case)))?;
        write_case(run, args, &progress)
    });
    progress.finish();
    run::tidy(&settings);
    let mut all = Vec::new();
    let mut drifted = Vec::new();
    for (study, cases) in studies.iter().zip(results) {
        let cases: Result<Vec<_>, Failure> = cases.into_iter().collect();
        let (runs, drift): (Vec<CaseRun>, Vec<Vec<String>>) = cases?.into_iter().unzip();
        write_timings(study, &runs, &args.out)?;
        all.push(runs);
        drifted.extend(drift.into_iter().flatten());
    }
    Ok((all, drifted))
}

/// Sets the number of threads, if one is asked for.
pub fn use_threads(threads: Option<u16>) -> Result<(), Failure> {
    let Some(threads) = threads else { return Ok(()) };
    // Only the first pool of a process can be set; this is the first.
    let built = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads)).build_global();
    built.map_err(|e| Failure::new(format!("no pool of {threads} threads: {e}"), "leave --threads out"))
}

fn settings(args: &RunArgs) -> RunSettings {
    RunSettings {
        profile: profile(args.profile),
        levels: args.levels.map(usize::from),
        solver: args.solver.map(method),
        partial: Some(args.out.join(".partial")),
        keep: args.fields.keep(),
    }
}

/// The solver that a word of the command line means.
pub fn method(arg: SolverArg) -> Method {
    match arg {
        SolverArg::Condensed => Method::Condensed,
        SolverArg::InteriorPoint => Method::InteriorPoint,
        SolverArg::Multigrid => Method::Multigrid,
    }
}

/// The profile that a word of the command line means.
pub fn profile(arg: ProfileArg) -> Profile {
    match arg {
        ProfileArg::Quick => Profile::Quick,
        ProfileArg::Full => Profile::Full,
    }
}

/// Writes the record, tables and plots of a case, with what drifted from its baseline.
fn write_case(mut run: CaseRun, args: &RunArgs, progress: &Progress) -> Result<(CaseRun, Vec<String>), Failure> {
    let drift = drift(&mut run)?;
    store::write_record(&args.out, &run.record)?;
    let folder = store::record_folder(&args.out, &run.record)?;
    args.fields.missing(&run.record).iter().for_each(|words| complain!("{words}"));
    write_fields(&folder, &run.fields)?;
    signorini_report::render_with(&run.record, &run.fields, &folder)?;
    run.is_written();
    progress.case_done(&run.record);
    Ok((run, drift))
}

/// Compares with the stored baseline of the study, and notes the differences in the record.
fn drift(run: &mut CaseRun) -> Result<Vec<String>, Failure> {
    let record = &mut run.record;
    let Some(baseline) = reference_folder().map(|f| Baseline::read(&f, &record.study)).transpose()?.flatten() else {
        return Ok(Vec::new());
    };
    let lines = store::drift(&baseline, record);
    record.notes.extend(lines.iter().map(|l| format!("drift from the baseline: {l}")));
    Ok(lines.into_iter().map(|l| format!("{}/{}: {l}", record.study, record.case)).collect())
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
