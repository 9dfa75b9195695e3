//! A made-up sweep of two keys: what stands on the page is what was put in.

use super::super::tests::{record, study};
use super::{Group, Sweep, groups};
use crate::bench::bench_table;
use signorini_study::bench::record::{BenchRecord, BenchStudy};
use signorini_study::record::{Changed, Setting};

fn setting(key: &str, name: &str, value: f64) -> Setting {
    Setting { key: key.into(), name: name.into(), value: value.to_string(), number: Some(value), swept: true }
}

/// Work 20 at ν = 0.3 and 50 at ν = 0.49, one more where the lower body is stiff; the linear problem takes 16.
fn case(nu: f64, young: f64) -> BenchStudy {
    let mut study = study("two-squares");
    study.changed = Some(Changed {
        study: "two-squares".into(),
        case: "two-squares".into(),
        options: vec!["--sweep 'body.*.material.poisson=0.3,0.49'".into()],
        settings: vec![
            setting("body.*.material.poisson", "poisson", nu),
            setting("body.lower.material.young", "young", young),
        ],
    });
    study.solvers.truncate(1);
    for run in &mut study.solvers[0].runs {
        run.work = Some(if nu < 0.4 { 20.0 } else { 50.0 } + if young > 1.0 { 1.0 } else { 0.0 });
        run.linear = run.linear.map(|l| signorini_study::bench::record::Linear { work: Some(16.0), ..l });
    }
    study
}

fn swept() -> BenchRecord {
    let studies =
        vec![study("one"), case(0.3, 1.0), case(0.3, 100.0), case(0.49, 1.0), case(0.49, 100.0), study("two")];
    BenchRecord { studies, ..record() }
}

fn sweep(record: &BenchRecord) -> Sweep<'_> {
    let mut found = groups(record);
    assert_eq!(found.len(), 3, "the cases of the sweep stand together");
    match found.remove(1) {
        Group::Sweep(sweep) => sweep,
        Group::One(..) => panic!("a sweep"),
    }
}

#[test]
fn each_value_is_held_against_the_first_with_all_else_equal() {
    let record = swept();
    let page = sweep(&record).page(Some("sweep.png"));
    for words in [
        "## Sweep of two-squares",
        "| poisson | solver | solved | iterations | work |",
        "| 0.3 | condensed | 8 of 8 | 4 | 20–21 |",
        // 50/20 and 51/21; 50/16 and 51/16
        "| 0.49 | condensed | 8 of 8 | 4 | 50–51 | 3 | 3.12–3.19 | 2.43–2.50 |",
        "work over that at 1 |",
        "| 0.49 | 100 | condensed | 1000 | 6.32 | 50.0 | 4 | 51.0 |",
        "triangles lock",
        "(sweep.png)",
    ] {
        assert!(page.contains(words), "no {words:?} in\n{page}");
    }
}

#[test]
fn what_was_not_solved_is_counted_and_says_why() {
    let mut record = swept();
    let curve = &mut record.studies[4].solvers[0];
    let lost = curve.runs.pop().unwrap().level;
    let reason = "1000 iterations were not enough".to_owned();
    curve.left_out.push(signorini_study::bench::record::LeftOut { level: lost, reason });
    let page = sweep(&record).page(None);
    assert!(
        page.contains("| 0.49 | condensed | 7 of 8 |") && page.contains("| 1000 iterations were not enough |"),
        "{page}"
    );
    assert!(!page.contains(".png"));
}

#[test]
fn below_the_ratio_where_triangles_lock_nothing_is_said_of_it() {
    let studies = vec![case(0.3, 1.0), case(0.45, 1.0)];
    let record = BenchRecord { studies, ..record() };
    assert!(matches!(&groups(&record)[..], [Group::Sweep(s)] if !s.page(None).contains("lock")));
}

#[test]
fn the_picture_has_a_curve_for_each_value_of_the_shorter_sweep() {
    let mut record = swept();
    record.studies.insert(3, case(0.3, 1e4));
    record.studies.insert(6, case(0.49, 1e4));
    let chart = sweep(&record).chart(&record).unwrap();
    let labels: Vec<&str> = chart.panels[0].series.iter().map(|s| s.label.as_str()).collect();
    assert_eq!((labels, chart.panels[0].x_label.as_str()), (vec!["poisson = 0.3", "poisson = 0.49"], "young"));
    assert_eq!(chart.panels[0].series[1].points, [(1.0, 50.0), (100.0, 51.0), (1e4, 51.0)]);
}

#[test]
fn swept_values_are_the_last_columns_of_the_csv() {
    let text = String::from_utf8(bench_table(&swept()).to_csv().unwrap()).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|l| l.split(',').collect()).collect();
    let width = rows[0].len();
    assert!(rows.iter().all(|r| r.len() == width), "{text}");
    let last = |row: usize| &rows[row][width - 4..];
    assert_eq!(last(0)[0], "closed");
    let poisson = rows[0].iter().position(|k| *k == "body.*.material.poisson").unwrap();
    // the first study has 8 rows and nothing swept
    assert_eq!((rows[1][poisson], rows[9][poisson], rows[9][poisson + 1]), ("", "0.3", "1"));
    assert_eq!((rows[24][poisson], rows[24][poisson + 1]), ("0.49", "100"));
}
