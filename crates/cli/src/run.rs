//! `signorini run`: studies in, records, tables, plots and a verdict out.

use crate::args::{ProfileArg, RunArgs, SolverArg};
use crate::change::load_changed;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use serde::Serialize;
use signorini_report::{CaseDrift, drift_text, summary_text};
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
    run_and_tell(args).inspect_err(|failure| args.gate.tell_failure(failure))
}

fn run_and_tell(args: &RunArgs) -> Result<u8, Failure> {
    args.gate.prepare()?;
    let studies = load_changed(&args.studies, &args.change.changes()?)?;
    let (runs, drift) = execute(args, &studies)?;
    args.gate.tell(&studies, &runs, &drift, args.strict)?;
    let records: Vec<StudyRecord> = runs.into_iter().flatten().map(|r| r.record).collect();
    signorini_report::render_summary(&records, &args.out)?;
    say!("{}", summary_text(&records));
    say_drift(&drift, args.strict);
    if !args.quiet {
        sayln!("tables and plots: {}", args.out.join("summary.md").display());
        sayln!("all on one page:  {}", args.out.join("index.html").display());
    }
    let status = verdict::exit_status(&records);
    let drifted = drift.iter().any(|(_, drift)| !drift.is_empty());
    Ok(if args.strict && drifted { 1 } else { status })
}

/// A line for each difference from the baselines; with `strict`, where they decide, a table that shows what is allowed.
fn say_drift(cases: &[CaseDrift], strict: bool) {
    if strict {
        let table = drift_text(cases);
        if !table.is_empty() {
            sayln!("\ndrift from the baselines in reference/; `signorini bless` takes this run as the new ones:");
            sayln!("{table}");
        }
        return;
    }
    for (name, drift) in cases {
        drift.iter().for_each(|drift| sayln!("drift: {name}: {drift}"));
    }
}

/// The library of studies around the current folder.
pub fn library() -> Result<Library, Failure> {
    let here = std::env::current_dir().map_err(|e| {
        Failure::new(format!("the current folder cannot be read: {e}"), "run from a folder that exists")
    })?;
    Ok(find_studies(&here))
}

/// Runs the studies side by side and writes each study's files as soon as it is done. Returns the runs in the order of
/// the studies, and what drifted from the baselines, case by case.
pub fn execute(args: &RunArgs, studies: &[Study]) -> Result<(Vec<Vec<CaseRun>>, Vec<CaseDrift>), Failure> {
    use_threads(args.threads)?;
    interrupt::listen()?;
    let settings = settings(args)?;
    let progress = Progress::new(studies.iter().map(|s| run::work(s, &settings)).sum(), args.quiet);
    let results = run::each_case(studies, &settings, |study, case| {
        let run = run::run_case(study, case, &settings, &progress);
        let run = run.map_err(|e| Failure::of_run(study, &e.in_case(study, case)))?;
        write_case(run, args, &progress)
    });
    progress.finish();
    run::tidy(&settings);
    if results.iter().flatten().any(|case| case.as_ref().is_err_and(Failure::is_interruption)) {
        return Err(interrupt::failure(&args.out));
    }
    let mut all = Vec::new();
    let mut drifted = Vec::new();
    for (study, cases) in studies.iter().zip(results) {
        let cases: Result<Vec<_>, Failure> = cases.into_iter().collect();
        let (runs, drift): (Vec<CaseRun>, Vec<CaseDrift>) = cases?.into_iter().unzip();
        write_timings(study, &runs, &args.out)?;
        all.push(runs);
        drifted.extend(drift);
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

fn settings(args: &RunArgs) -> Result<RunSettings, Failure> {
    Ok(RunSettings {
        profile: profile(args.profile),
        levels: args.levels.map(usize::from),
        solver: args.solver.solver(&args.out)?,
        partial: Some(args.out.join(".partial")),
        keep: args.fields.keep(),
    })
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
fn write_case(mut run: CaseRun, args: &RunArgs, progress: &Progress) -> Result<(CaseRun, CaseDrift), Failure> {
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
fn drift(run: &mut CaseRun) -> Result<CaseDrift, Failure> {
    let record = &mut run.record;
    let name = format!("{}/{}", record.study, record.case);
    let Some(baseline) = reference_folder().map(|f| Baseline::read(&f, &record.study)).transpose()?.flatten() else {
        return Ok((name, Vec::new()));
    };
    let drift = store::drift(&baseline, record);
    record.notes.extend(drift.iter().map(|d| format!("drift from the baseline: {d}")));
    Ok((name, drift))
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

/// Seconds of a case: all phases of its levels and its reference.
pub fn seconds_of(run: &CaseRun) -> f64 {
    run.times.iter().chain(&run.reference_times).flat_map(LevelTimes::phases).sum()
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
