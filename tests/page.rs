//! `index.html`: everything of a run on one page that asks nobody for anything.

mod common;

use common::{Folder, LOADED, SMOOTH, edit};

const TWO_CASES: &str =
    "\n[[case]]\nname = \"structured\"\n\n[[case]]\nname = \"union-jack\"\nfamily = { name = \"union-jack\" }\n";

/// The part of a page between two marks.
fn between<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    let start = page.find(from).unwrap_or_else(|| panic!("no {from} on the page"));
    let length = page[start..].find(to).unwrap_or_else(|| panic!("no {to} behind {from}"));
    &page[start..start + length]
}

#[test]
fn every_study_stands_on_the_page_with_its_pictures_and_nothing_else_is_needed() {
    let folder = Folder::with_study("page", &(SMOOTH.to_owned() + TWO_CASES));
    folder.add(LOADED);
    folder.signorini("run --levels 2 --quiet");
    let page = folder.text("reports/index.html");
    for (place, pictures) in [("smooth/structured", 5), ("smooth/union-jack", 5), ("loaded", 5)] {
        let case = between(&page, &format!("<details id=\"{place}\">"), "</details>");
        assert_eq!(case.matches("<svg ").count(), pictures, "{place}");
        for words in
            ["Question", "Claim", "Set-up", "Verdict", "Errors", "Certificate", "Reproduce", "signorini run", "Times"]
        {
            assert!(case.contains(words), "{place}: {words}");
        }
        assert!(
            case.contains("class=\"notes\"") && case.contains("<title>strain |u−uₕ|: "),
            "{place}: no values to point at"
        );
        assert!(page.contains(&format!("href=\"#{place}\"")), "no link to {place}");
    }
    for outside in ["<img", "<link", "src=", "@import", "url(", "fetch(", "href=\"http"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert_eq!(page.matches("<details").count(), page.matches("</details>").count());
    assert_eq!(page.matches("<svg ").count(), page.matches("</svg>").count());
    // what is on the page is what the files say
    let report = folder.text("reports/loaded/report.md");
    let error = folder.record("reports/loaded").levels[1].errors.energy.expect("an error");
    let shown = format!("{error:.5}");
    assert!(
        report.contains(&shown[..6]) && between(&page, "<details id=\"loaded\">", "</details>").contains(&shown[..6])
    );
}

#[test]
fn words_of_a_study_cannot_break_the_page() {
    let title = edit(LOADED, "title = \"Loaded\"", "title = \"<b>Loaded</b> & <script>alert(1)</script>\"");
    let folder = Folder::with_study(
        "page-words",
        &edit(&title, "\"A square pressed on another one.\"", "\"</details><img src=x>\""),
    );
    folder.signorini("run --levels 1 --quiet");
    let page = folder.text("reports/index.html");
    assert!(!page.contains("<b>Loaded") && !page.contains("<script>alert") && !page.contains("<img"));
    assert_eq!(page.matches("</details>").count(), 1);
}

#[test]
fn without_times_the_page_is_the_records_own() {
    let folder = Folder::with_study("page-times", SMOOTH);
    folder.signorini("run --levels 2 --quiet");
    let with = folder.text("reports/index.html");
    std::fs::remove_file(folder.path("reports/smooth/timings.json")).expect("the times");
    folder.signorini("report reports");
    let without = folder.text("reports/index.html");
    assert!(with.contains("peak MB") && !without.contains("peak MB"));
    assert_eq!(common::timeless(&with), common::timeless(&without));
}
