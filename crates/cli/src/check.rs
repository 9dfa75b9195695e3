//! `signorini check`: everything but the solve.

use crate::args::CheckArgs;
use crate::failure::Failure;
use crate::run::{load, profile};
use signorini_study::run::{CheckedLevel, check_case};

/// Prints what each case would do, level by level.
pub fn check(args: &CheckArgs) -> Result<u8, Failure> {
    for study in load(&args.studies)? {
        sayln!("{}: {} ({})", study.id, study.title, study.claim.statement);
        study.claim.hypotheses.iter().for_each(|h| sayln!("  needs: {h}"));
        for case in &study.cases {
            let levels = check_case(case, profile(args.profile))
                .map_err(|e| Failure::of_run(&study, &e.in_case(&study, case)))?;
            sayln!("  {}: {} family, {} levels", case.name, case.family.name(), levels.len());
            levels.iter().for_each(print_level);
        }
    }
    sayln!("sound: everything but the solve was tried");
    Ok(0)
}

fn print_level(l: &CheckedLevel) {
    sayln!(
        "    n = {:<5} h = {:.4e}  smallest angle {:.1}°  β = {:.2}  {}  {} dofs, {} pairs, {} constraints",
        l.cells,
        l.h,
        l.min_angle,
        l.side_ratio,
        if l.nested { "nested" } else { "not nested" },
        l.dofs,
        l.contact_pairs,
        l.constraints
    );
    l.warnings.iter().for_each(|w| sayln!("      warning: {w}"));
}
