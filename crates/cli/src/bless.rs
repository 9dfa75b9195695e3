//! `signorini bless`: this run's numbers become the baselines that later runs are compared with.

use crate::args::RunArgs;
use crate::change::load_changed;
use crate::failure::Failure;
use crate::run::{execute, reference_folder};
use signorini_study::change::Changes;
use signorini_study::run::Solver;
use signorini_study::store::Baseline;
use std::path::PathBuf;

/// Runs the studies and stores energies, errors and rates in `reference/`.
pub fn bless(args: &RunArgs) -> Result<u8, Failure> {
    if args.levels.is_some() {
        return Err(Failure::new("a baseline needs all levels of its profile", "leave --levels out"));
    }
    if args.gate.is_asked() {
        return Err(Failure::new(
            "--junit and --annotations belong to `run`: `bless` judges nothing",
            "leave them out",
        ));
    }
    if !args.change.changes()?.is_none() {
        let hint = "leave --set and --sweep out, or write the changed study into a file and bless that";
        return Err(Failure::new("a baseline is that of a study as its file has it", hint));
    }
    if let Some(Solver::External(external)) = args.solver.solver(&args.out)? {
        let what = format!("a baseline is what this program computes, not what {} does", external.name);
        return Err(Failure::new(what, "leave --solver out, or name one of this program's own"));
    }
    let studies = load_changed(&args.studies, &Changes::default())?;
    let folder = reference_folder().unwrap_or_else(|| PathBuf::from("reference"));
    let (runs, _) = execute(args, &studies)?;
    for (study, runs) in studies.iter().zip(runs) {
        let records: Vec<_> = runs.into_iter().map(|r| r.record).collect();
        let hashes = study.cases.iter().map(|c| (c.name.clone(), c.fingerprint())).collect();
        if let Some(baseline) = Baseline::from_records(&records, &hashes, env!("CARGO_PKG_VERSION")) {
            sayln!("blessed: {}", baseline.write(&folder)?.display());
        }
    }
    Ok(0)
}
