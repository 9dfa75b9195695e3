//! Levels that have no solution though others do.
//!
//! On a curved zone `K_h` constrains the nodes alone, so on coarse meshes it may hold rigid motions that `K` does not, and a
//! load that `K` bears pushes the body away. Such a level is left out, with the reason, and nothing is judged without it: the
//! verdict of the other levels is at best inconclusive. Where every level is refused, the study is.

use crate::error::RunError;
use crate::record::{Outcome, Verdict};
use signorini_contact::Error;

/// The levels that have a solution, and in words those that have none.
pub struct Parted<T> {
    pub solved: Vec<T>,
    pub refused: Vec<String>,
}

/// Parts the results of all levels, in their order; `cells` are the mesh parameters.
///
/// # Errors
/// The first error that is neither a refusal of a load nor an external solver without an answer, or the first of all if no level has a
/// solution.
pub fn part<T>(results: Vec<Result<T, RunError>>, cells: &[usize]) -> Result<Parted<T>, RunError> {
    let mut parted = Parted { solved: Vec::new(), refused: Vec::new() };
    let mut first = None;
    for (index, (result, n)) in results.into_iter().zip(cells).enumerate() {
        match result {
            Ok(level) => parted.solved.push(level),
            Err(RunError::Contact(Error::Solvability(why))) => {
                parted.refused.push(format!("level {index} (n = {n}) is refused: {why}"));
                first.get_or_insert(RunError::Contact(Error::Solvability(why)));
            }
            Err(RunError::External(why)) => {
                parted.refused.push(format!("level {index} (n = {n}) has no answer: {why}"));
                first.get_or_insert(RunError::External(why));
            }
            Err(other) => return Err(other),
        }
    }
    match first {
        Some(error) if parted.solved.is_empty() => Err(error),
        _ => Ok(parted),
    }
}

/// The verdict of the other levels, made no better than inconclusive by those that were refused.
pub fn doubted(verdict: Verdict, refused: &[String]) -> Verdict {
    if refused.is_empty() {
        return verdict;
    }
    let outcome = verdict.outcome.max(Outcome::Inconclusive);
    Verdict { outcome, reasons: refused.iter().cloned().chain(verdict.reasons).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(why: &str) -> Result<usize, RunError> {
        Err(RunError::Contact(Error::Solvability(why.into())))
    }

    #[test]
    fn refused_levels_are_left_out_with_their_reason() {
        let parted = part(vec![refused("it tips"), Ok(1), Ok(2)], &[2, 4, 8]).unwrap();
        assert_eq!((parted.solved, parted.refused), (vec![1, 2], vec!["level 0 (n = 2) is refused: it tips".into()]));
    }

    #[test]
    fn a_case_with_no_solution_at_all_is_refused_and_other_errors_are_errors() {
        let none = part(vec![refused("it tips"), refused("it slides")], &[2, 4]).err().unwrap();
        assert_eq!(none.to_string(), refused("it tips").unwrap_err().to_string());
        let other = part(vec![Ok(0), Err(RunError::Study("no".into()))], &[2, 4]).err().unwrap();
        assert!(matches!(other, RunError::Study(_)));
    }

    #[test]
    fn nothing_passes_without_its_refused_levels() {
        let verdict = |outcome| Verdict { outcome, reasons: vec!["rate 1".into()] };
        let told = ["level 0".to_owned()];
        let of = |outcome, refused: &[String]| doubted(verdict(outcome), refused);
        assert_eq!(of(Outcome::Pass, &told).outcome, Outcome::Inconclusive);
        assert_eq!(of(Outcome::Fail, &told).outcome, Outcome::Fail);
        assert_eq!(of(Outcome::Pass, &[]), verdict(Outcome::Pass));
        assert_eq!(of(Outcome::Pass, &told).reasons, ["level 0", "rate 1"]);
    }
}
