//! `signorini check`: everything but the solve.

use crate::args::CheckArgs;
use crate::change::load_changed;
use crate::failure::Failure;
use crate::run::profile;
use signorini_study::error::RunError;
use signorini_study::record::Corner;
use signorini_study::run::{CheckedLevel, Profile, check_case, check_corners, check_refusal};
use signorini_study::study::{Case, Study};

/// Prints what each case would do, level by level.
pub fn check(args: &CheckArgs) -> Result<u8, Failure> {
    for study in load_changed(&args.studies, &args.change.changes()?)? {
        sayln!("{}: {} ({})", study.id, study.title, study.claim.statement);
        study.claim.hypotheses.iter().for_each(|h| sayln!("  needs: {h}"));
        for case in &study.cases {
            check_one(&study, case, profile(args.profile))?;
        }
    }
    sayln!("sound: everything but the solve was tried");
    Ok(0)
}

fn check_one(study: &Study, case: &Case, profile: Profile) -> Result<(), Failure> {
    let mend = |e: RunError| Failure::of_run(study, &e.in_case(study, case));
    if let Some(refusal) = check_refusal(case, profile).map_err(mend)? {
        sayln!("  {}: {} of {} levels refused, as all should be", case.name, refusal.refused, refusal.levels);
        refusal.message.iter().for_each(|m| sayln!("      {m}"));
        return Ok(());
    }
    let levels = check_case(case, profile).map_err(mend)?;
    sayln!("  {}: {} family, {} levels", case.name, case.family_name(), levels.len());
    levels.iter().for_each(print_level);
    check_corners(case, profile).map_err(mend)?.iter().for_each(print_corner);
    Ok(())
}

fn print_level(l: &CheckedLevel) {
    sayln!(
        "    n = {:<5} h = {:.4e}  {}β = {:.2}  {}  {} dofs{}",
        l.cells,
        l.h,
        if l.min_angle > 0.0 { format!("smallest angle {:.1}°  ", l.min_angle) } else { String::new() },
        l.side_ratio,
        if l.nested { "nested" } else { "not nested" },
        l.dofs,
        if l.contact_pairs > 0 {
            format!(", {} pairs, {} constraints", l.contact_pairs, l.constraints)
        } else {
            String::new()
        }
    );
    l.warnings.iter().for_each(|w| sayln!("      warning: {w}"));
}

fn print_corner(corner: &Corner) {
    let [x, y] = corner.point;
    sayln!("    corner ({x:.4}, {y:.4}): {}; exponent {}", corner.describe(), corner.describe_states());
}
