//! Pages, tables and summaries hold the record's numbers.

mod common;

use signorini_report::{ReportError, levels, markdown, render, render_summary, summary_text, table};
use signorini_study::record::{Budget, ClaimKind, Errors, Outcome, SolverRecord, StudyRecord};
use std::fs;

type Tested = Result<(), Box<dyn std::error::Error>>;

#[test]
fn csv_reads_back_as_the_same_numbers() -> Tested {
    let record = common::healthy();
    let bytes = levels::all(&record).to_csv()?;
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    let header = reader.headers()?.clone();
    let column = |key: &str| header.iter().position(|h| h == key).ok_or(format!("no column {key}"));
    let (h, strain, rate, lhs, b) =
        (column("h")?, column("strain")?, column("strain_rate")?, column("ledger_lhs")?, column("ledger_b")?);
    let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>()?;
    assert_eq!(rows.len(), 7);
    for (row, level) in rows.iter().zip(&record.levels) {
        let ledger = level.ledger.as_ref().ok_or("no ledger")?;
        assert_eq!(row[h].parse::<f64>()?, level.h);
        assert_eq!(Some(row[strain].parse::<f64>()?), level.errors.strain);
        assert_eq!(row[lhs].parse::<f64>()?, ledger.lhs);
        assert_eq!(row[b].parse::<f64>()?, ledger.b);
    }
    // The record's own pairwise rate; the coarsest level has none.
    assert_eq!(&rows[0][rate], "");
    assert_eq!(rows[1][rate].parse::<f64>()?, 1.0);
    Ok(())
}

#[test]
fn rates_follow_from_the_errors_where_the_record_has_no_fit() {
    let mut record = common::record(3, (0.2, 0.8), (0.4, 1.1), (0.2, 0.8), (0.1, 2.0));
    assert!(record.rates.is_empty());
    let rate = |record: &StudyRecord, key: &str, level: usize| {
        let table = levels::all(record);
        let column = table.columns.iter().position(|c| c.key == key);
        column.map(|c| table.rows[level].cells[c].display())
    };
    assert_eq!(rate(&record, "energy_rate", 0).as_deref(), Some("–"));
    assert_eq!(rate(&record, "energy_rate", 2).as_deref(), Some("1.100"));
    // An excluded level carries no rate into the next: level 2 is then compared with level 0.
    record.levels[1].excluded = Some("budget".into());
    record.levels[1].errors.energy = Some(1e9);
    assert_eq!(rate(&record, "energy_rate", 2).as_deref(), Some("1.100"));
}

#[test]
fn json_has_null_where_there_is_no_value() -> Tested {
    let record = common::record(4, (0.2, 1.0), (0.4, 1.0), (0.2, 1.0), (0.1, 2.0));
    let rows = levels::all(&record).to_json()?;
    assert_eq!(rows[2]["strain"].as_f64(), record.levels[2].errors.strain);
    assert!(rows[2]["ledger_lhs"].is_null());
    assert!(rows[2]["excluded"].is_null());
    assert_eq!(rows[2]["dofs"].as_u64(), Some(4 * 32 * 32));
    Ok(())
}

#[test]
fn a_number_that_is_none_is_refused_and_named() {
    let mut record = common::healthy();
    record.levels[3].errors.l2 = Some(f64::NAN);
    match levels::all(&record).to_csv() {
        Err(ReportError::NonFinite { place, value }) => {
            assert_eq!(place, "column l2, row 3");
            assert!(value.is_nan());
        }
        other => unreachable!("accepted: {other:?}"),
    }
}

#[test]
fn page_answers_in_the_order_of_the_questions() {
    let record = common::healthy();
    let page =
        markdown::page(&record, markdown::Pictures { rates: true, ledger: true, parts: false, ..Default::default() });
    let order = [
        "# Two blocks in flat contact",
        "**pass**",
        "## Question",
        "## Claim",
        "|u − u_h| ≤ c h",
        "Hypotheses: u ∈ H²; regular family.",
        "| paper | 1 |",
        "| **observed** | 1.000 | 0.996 | 1.004 |",
        "## Set-up",
        "exact, a closed form",
        "alpha = 1.5",
        "## Verdict",
        "the interval lies above 0.95",
        "## What would refute it",
        "![Errors against mesh size](rates.png)",
        "| 0.17678 |",
        "![Terms of the ledger",
        "## Notes",
        "signorini run thm31-flat-contact\n",
    ];
    let mut from = 0;
    for words in order {
        let at = page[from..].find(words);
        assert!(at.is_some(), "{words:?} is missing after\n{}", &page[..from]);
        from += at.unwrap_or(0);
    }
}

#[test]
fn every_markdown_table_has_equal_rows() {
    for (name, record) in common::hard() {
        let page = markdown::page(&record, markdown::Pictures::default());
        assert!(!page.contains(".png"), "{name}: a picture that is not there");
        let bars = |line: &str| line.replace("\\|", "").matches('|').count();
        let lines: Vec<&str> = page.lines().collect();
        for pair in lines.windows(2).filter(|p| p.iter().all(|line| line.starts_with("| "))) {
            assert_eq!(bars(pair[0]), bars(pair[1]), "{name}: {pair:?}");
        }
    }
}

#[test]
fn greyed_levels_are_marked_with_their_reason() {
    let mut record = common::healthy();
    record.levels[6].excluded = Some("reference contamination 7 %".into());
    let text = levels::errors(&record).to_markdown();
    assert!(text.contains("| *6* † |"), "{text}");
    assert!(text.contains("† level 6 is left out of the fit: reference contamination 7 %."), "{text}");
}

/// A control that fails as wanted, one that does not, an announced doubt.
fn several() -> Vec<StudyRecord> {
    let mut records = vec![common::healthy(), common::healthy(), common::healthy(), common::healthy()];
    records[1].expect = Some(Outcome::Fail);
    records[1].verdict.outcome = Outcome::Fail;
    records[2].expect = Some(Outcome::Fail);
    records[3].verdict.outcome = Outcome::Inconclusive;
    records[3].expected_inconclusive = Some("the tiles shrink faster than the meshes".into());
    records[3].rates.clear();
    records[3].case = "a-case-with-a-long-name".into();
    records
}

#[test]
fn terminal_summary_is_aligned_and_narrow() {
    let text = summary_text(&several());
    assert!(text.lines().all(|line| line.chars().count() <= 110), "{text}");
    assert!(text.contains("thm31-flat-contact · criss-cross "), "{text}");
    assert!(text.contains("strain  1.000 ± 0.004 "), "{text}");
    assert!(
        text.ends_with("4 cases: 1 pass, 0 fail, 1 inconclusive (1 expected at this size); 1 of 2 controls met\n"),
        "{text}"
    );
    let head: Vec<char> = text.lines().next().unwrap_or("").chars().collect();
    let verdict = head.len() - "verdict".len();
    let rows: Vec<&str> = text.lines().skip(2).take(4).collect();
    let column = |row: &str| row.chars().skip(verdict).collect::<String>();
    assert_eq!(column(rows[0]), "pass", "{text}");
    assert_eq!(column(rows[1]), "fail (wanted)", "{text}");
    assert_eq!(column(rows[2]), "pass (wanted fail)", "{text}");
    assert!(summary_text(&[]).starts_with("0 cases"));
}

#[test]
fn summary_has_one_row_per_case() -> Tested {
    let dir = common::folder("summary");
    let files = render_summary(&several(), &dir)?;
    assert_eq!(
        files,
        ["summary.md", "summary.tex", "statements.md", "summary.json", "index.html"].map(|f| dir.join(f))
    );
    let rows: serde_json::Value = serde_json::from_slice(&fs::read(dir.join("summary.json"))?)?;
    assert_eq!(rows.as_array().map(Vec::len), Some(4));
    assert_eq!(rows[0]["rate"].as_f64(), Some(1.0));
    assert_eq!(rows[1]["expect"], "fail");
    assert!(rows[3]["rate"].is_null());
    let page = fs::read_to_string(dir.join("summary.md"))?;
    assert!(page.contains("(thm31-flat-contact/criss-cross/report.md)"), "{page}");
    assert!(page.contains("expected at this size: the tiles shrink faster"), "{page}");
    Ok(())
}

#[test]
fn render_writes_whole_files_and_the_same_bytes_twice() -> Tested {
    let dir = common::folder("render");
    let record = common::healthy();
    let files = render(&record, &dir)?;
    let names: Vec<_> = files.iter().filter_map(|f| f.file_name()?.to_str()).collect();
    assert_eq!(
        names,
        ["report.md", "table.csv", "table.json", "table.tex", "rates.png", "rates.svg", "ledger.png", "ledger.svg"]
    );
    let read = || files.iter().map(fs::read).collect::<Result<Vec<_>, _>>();
    let first = read()?;
    render(&record, &dir)?;
    assert_eq!(first, read()?);
    assert_eq!(fs::read_dir(&dir)?.count(), files.len(), "temporary files are left");
    // A record without anything to plot takes its old pictures away.
    let mut empty = record;
    empty.levels.clear();
    render(&empty, &dir)?;
    assert!(!dir.join("rates.png").exists() && !dir.join("ledger.svg").exists());
    Ok(())
}

#[test]
fn plain_text_is_cut_to_its_width() {
    let column = table::Column::new("words", "words");
    let row = |text: &str| table::Row { cells: vec![table::Cell::text(text)], excluded: None };
    let table = table::Table { columns: vec![column], rows: vec![row("a rather long text"), row("short")] };
    assert_eq!(table.to_text(10), "words\n──────────\na rather …\nshort\n");
}

/// A rate that still drifts is marked, one that scatters is not shown; the record keeps both.
#[test]
fn rates_that_are_not_firm_say_so() {
    let mut record = common::healthy();
    let page = |r: &StudyRecord| markdown::page(r, markdown::Pictures::default());
    assert!(!page(&record).contains("Not asymptotic"));
    if let Some(energy) = record.rates.get_mut("energy") {
        energy.asymptotic = false;
    }
    let wide = common::rate(&record.levels, 0.4, -0.562);
    record.rates.insert("contact_set".into(), signorini_study::record::Rate { low: -2.8, high: 1.7, ..wide });
    let text = page(&record);
    assert!(text.contains("| *energy √A(e,e)* † | *1.000* |"), "{text}");
    assert!(text.contains("| *contact set \\|C △ Cₕ\\|* † | *–* |") && !text.contains("-0.562"), "{text}");
    assert!(text.contains("† Not asymptotic"), "{text}");
    let strain = text.find("| strain |u").or(text.find("| strain \\|u"));
    assert!(strain < text.find("| *contact set"), "the norms have their own order");
}

/// Where the error is rounding there is neither a rate nor a ledger to look at.
#[test]
fn rounding_has_no_rates_and_no_ledger_picture() {
    let mut record = common::healthy();
    record.rates.clear();
    for level in &mut record.levels {
        level.errors =
            common::record(1, (1e-16, 0.0), (1e-15, 0.0), (1e-15, 0.0), (1e-16, 0.0)).levels[0].errors.clone();
        if let Some(ledger) = &mut level.ledger {
            (ledger.lhs, ledger.a, ledger.b) = (1e-30, 1e-30, -1e-19);
        }
    }
    assert!(!levels::errors(&record).columns.iter().any(|c| c.key.ends_with("_rate")));
    assert!(signorini_report::plot::ledger(&record).is_none());
    let rates = signorini_report::plot::rates(&record);
    assert!(rates.is_some_and(|c| c.remarks.iter().any(|r| r.starts_with("Rounding"))));
}

/// A lemma solves nothing: its page has no contact zone, no certificate and no reference, and its tables no zeros for them.
#[test]
fn a_lemma_shows_only_what_was_measured() -> Tested {
    let mut record = common::healthy();
    record.norm = "constant".into();
    record.kind = ClaimKind::Bounded;
    record.rates.clear();
    for level in &mut record.levels {
        level.solver = SolverRecord::nothing_to_solve();
        level.errors = Errors { constant: Some(0.125 + level.h), ..Errors::default() };
        (level.ledger, level.switch_sides, level.budget) = (None, None, Budget::default());
    }
    let page = markdown::page(&record, markdown::Pictures::default());
    for absent in ["## Contact", "KKT", "pairs", "Reference:", "L(uₕ)", "solver", "log(e₁/e₂)"] {
        assert!(!page.contains(absent), "{absent}:\n{page}");
    }
    for there in ["## Constants", "constant c", "## Mesh and quadrature", "45.000", "0.30178"] {
        assert!(page.contains(there), "{there}:\n{page}");
    }
    let rows = levels::all(&record).to_json()?;
    assert!(rows[0]["kkt_stationarity"].is_null() && rows[0]["contact_pairs"].is_null(), "{}", rows[0]);
    assert_eq!(rows[0]["constant"].as_f64(), record.levels[0].errors.constant);
    // of an equality the distance from 1 is shown beside the constant
    record.kind = ClaimKind::Exact;
    assert!(markdown::page(&record, markdown::Pictures::default()).contains("c − 1"));
    // intervals have no angle
    record.levels.iter_mut().for_each(|l| l.min_angle = 0.0);
    assert!(!markdown::page(&record, markdown::Pictures::default()).contains("min angle"));
    Ok(())
}

#[test]
fn a_formula_stands_beside_what_was_measured() {
    let record = common::pressed(1.0);
    let pictures = markdown::Pictures { pressure: true, ..Default::default() };
    let page = markdown::page(&record, pictures);
    let section = page.split("## Contact pressure").nth(1).unwrap_or("");
    assert!(section.contains("![Contact pressure and gap along the zone](pressure.png)"));
    let row = "| 6 | 0.0027621 | 0.099500 | 0.10000 | -0.0050000 | 2.0400 | 2.0000 | 0.020000 | 0.30000 |";
    assert!(section.contains(row), "{section}");
    assert!(!markdown::page(&common::healthy(), markdown::Pictures::default()).contains("## Contact pressure"));
}
