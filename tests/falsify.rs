//! The search for counterexamples and the measured coverage, from the outside.

mod common;

use common::{Folder, same_tree, tree};

#[test]
fn a_search_goes_on_to_the_same_bytes_for_any_number_of_threads() {
    let folder = Folder::new("falsify");
    let whole = folder.signorini("falsify lemma-2-1 --budget 3 --seed 4 --out whole --threads 1").expect(0);
    assert!(whole.out.contains("no counterexample found") && whole.out.contains("lemma-2-1"), "{}", whole.out);
    folder.signorini("falsify lemma-2-1 --budget 1 --seed 4 --out parts --quiet").expect(0);
    folder.signorini("falsify lemma-2-1 --budget 3 --seed 4 --out parts --quiet --threads 3").expect(0);
    same_tree(&tree(&folder.path("whole"), ""), &tree(&folder.path("parts"), ""));
    let page = folder.text("whole/falsify/summary.md");
    assert!(page.contains("signorini falsify lemma-2-1 --budget 3 --seed 4"), "{page}");
    // the saved study is one that anybody can run
    folder.signorini("run whole/falsify/lemma-2-1/worst-constant.toml --quiet").expect(0);
}

#[test]
fn bent_hypotheses_end_with_status_1_and_a_study_that_fails() {
    let folder = Folder::new("bent");
    let found = folder.signorini("falsify bent-theorem-3-1 --budget 1 --seed 2 --quiet").expect(1);
    assert!(found.out.contains("CANDIDATE") && found.out.contains("too slow"), "{}", found.out);
    folder.signorini("run reports/falsify/bent-theorem-3-1/candidate-0.toml --quiet").expect(1);
}

#[test]
fn what_cannot_be_searched_is_refused_with_a_suggestion() {
    let folder = Folder::new("unsearchable");
    folder.signorini("falsify theorem-31 --budget 1").complains(2, &["no claim `theorem-31`", "theorem-3-1"]);
    folder.signorini("falsify theorem-3-1 --budget 0").complains(2, &["--budget"]);
    folder.signorini("falsify theorem-3-1").complains(2, &["--budget"]);
}

#[test]
fn coverage_is_a_table_that_a_seed_makes_again() {
    let folder = Folder::new("coverage");
    let [a, b, c] = ["1", "1", "2"].map(|s| folder.signorini(&format!("coverage --draws 50 --seed {s}")).expect(0).out);
    assert!(a == b && a != c && a.contains("| t(h) | levels |") && a.contains("h/(1 + 4h)"), "{a}");
}
