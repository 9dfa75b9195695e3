//! `signorini falsify`: scenes drawn at random, and the worst of them.

use crate::VERSION;
use crate::args::FalsifyArgs;
use crate::failure::Failure;
use crate::progress::Count;
use crate::run::use_threads;
use signorini_study::falsify::{Found, Plan, Summary, Target, search};
use signorini_study::nearest::nearest;
use signorini_study::store;

/// The word for every claim.
const ALL: &str = "all";

/// Searches and returns the exit status: 1 if a claim was broken, 2 if some claim has no draw that could be judged, else 0.
pub fn falsify(args: &FalsifyArgs) -> Result<u8, Failure> {
    let targets = targets(&args.claim)?;
    use_threads(args.threads)?;
    let folder = args.out.join("falsify");
    let budget = args.budget as usize;
    let progress = Count::new(targets.len() * budget, "draws", args.quiet);
    let one = |target: &Target| -> Result<Found, Failure> {
        let state = folder.join(target.about().id);
        let plan = Plan { budget, seed: args.seed, state: Some(&state), version: VERSION };
        Ok(search(*target, &plan, &|| progress.done())?)
    };
    let found: Vec<Found> = targets.iter().map(one).collect::<Result<_, _>>()?;
    progress.finish();
    let summary = Summary::write(&folder, &found)?;
    let page = folder.join("summary.md");
    store::write_atomic(&page, signorini_report::falsify_markdown(&summary))?;
    say!("{}", signorini_report::falsify_text(&summary));
    if !args.quiet {
        sayln!("page and studies: {}", page.display());
    }
    Ok(status(&summary))
}

fn status(summary: &Summary) -> u8 {
    let judged = summary.rows.iter().all(|r| r.judged > 0);
    if summary.has_candidates() { 1 } else { u8::from(!judged) * 2 }
}

fn targets(claim: &str) -> Result<Vec<Target>, Failure> {
    if claim == ALL {
        return Ok(Target::CLAIMS.to_vec());
    }
    if let Some(target) = Target::find(claim) {
        return Ok(vec![target]);
    }
    let known: Vec<&str> = Target::CLAIMS.iter().chain(&[Target::Bent]).map(|t| t.about().id).chain([ALL]).collect();
    let hint = match nearest(claim, known.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("choose one of: {}", known.join(", ")),
    };
    Err(Failure::new(format!("no claim `{claim}` to search"), hint))
}
