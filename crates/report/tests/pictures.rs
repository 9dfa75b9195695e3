//! Pictures: size, determinism, records that a careless picture stumbles over.

mod common;

use signorini_report::ReportError;
use signorini_report::plot::{self, HEIGHT, WIDTH};
use std::fs;

const PNG_HEAD: [u8; 8] = [0x89, b'P', b'N', b'G', 0x0d, 0x0a, 0x1a, 0x0a];

/// Width and height from the picture's own header.
fn size(png: &[u8]) -> (u32, u32) {
    let number = |at: usize| u32::from_be_bytes([png[at], png[at + 1], png[at + 2], png[at + 3]]);
    (number(16), number(20))
}

#[test]
fn png_has_its_size_and_the_same_bytes_twice() -> Result<(), ReportError> {
    let chart = plot::rates(&common::healthy()).ok_or_else(|| ReportError::Picture("no chart".into()))?;
    let (first, second) = (plot::png(&chart)?, plot::png(&chart)?);
    assert_eq!(first[..8], PNG_HEAD);
    assert_eq!(size(&first), (WIDTH, HEIGHT));
    assert_eq!(first, second);
    assert_eq!(plot::svg(&chart)?, plot::svg(&chart)?);
    Ok(())
}

#[test]
fn hard_records_are_drawn_or_declined() -> Result<(), Box<dyn std::error::Error>> {
    let dir = common::folder("hard");
    fs::create_dir_all(&dir)?;
    for (name, record) in common::hard() {
        for (kind, chart) in
            [("rates", plot::rates(&record)), ("ledger", plot::ledger(&record)), ("parts", plot::parts(&record))]
        {
            if let Some(chart) = chart {
                let png = plot::png(&chart)?;
                assert_eq!(size(&png), (WIDTH, HEIGHT), "{name}");
                fs::write(dir.join(format!("{name}-{kind}.png")), png)?;
                let svg = plot::svg(&chart)?;
                assert!(svg.trim_end().ends_with("</svg>"), "{name}");
                fs::write(dir.join(format!("{name}-{kind}.svg")), svg)?;
            }
        }
    }
    Ok(())
}

#[test]
fn nothing_to_plot_gives_no_picture() {
    for (name, record) in common::hard() {
        let empty = ["no-level", "all-null", "all-zero"].contains(&name);
        assert_eq!(plot::rates(&record).is_none(), empty, "{name}");
    }
    assert!(plot::ledger(&common::record(5, (1.0, 1.0), (1.0, 1.0), (1.0, 1.0), (1.0, 2.0))).is_none());
}

#[test]
fn chart_holds_the_numbers_of_the_record() -> Result<(), &'static str> {
    let record = common::healthy();
    let chart = plot::rates(&record).ok_or("no chart")?;
    let strain = &chart.curves[0];
    assert_eq!(strain.marks.len(), 7);
    assert_eq!(strain.marks[3].h, record.levels[3].h);
    assert_eq!(Some(strain.marks[3].value), record.levels[3].errors.strain);
    assert_eq!(strain.detail, "1.000 [0.996, 1.004]");
    // Levels 1 to 6 are in the window, and the fitted line runs through its exact data.
    let band = &chart.bands[0];
    assert_eq!(band.window.len(), 6);
    for mark in &strain.marks[1..] {
        assert!((band.line_at(mark.h.ln()) - mark.value.ln()).abs() < 1e-12);
    }
    assert_eq!(chart.slopes.len(), 1);
    assert_eq!((chart.slopes[0].label.as_str(), chart.slopes[0].source.as_str()), ("O(h)", "paper, today, expected"));
    Ok(())
}

#[test]
fn ledger_sums_its_terms_and_squares_the_bound() -> Result<(), &'static str> {
    let mut record = common::healthy();
    record.bounds.paper = Some(0.75);
    let chart = plot::ledger(&record).ok_or("no chart")?;
    let value = |label: &str| chart.curves.iter().find(|c| c.label == label).map(|c| c.marks[2].value);
    let (Some(sum), Some(a), Some(b)) = (value("a + b"), value("a"), value("b")) else {
        return Err("a term is missing");
    };
    assert!((sum - (a + b)).abs() < 1e-15);
    assert_eq!(chart.slopes[0].label, "O(h^{3/2})");
    assert!(chart.subtitle[1].contains("holds on levels 0–6"));
    Ok(())
}

#[test]
fn greyed_levels_and_zero_terms_are_said() -> Result<(), &'static str> {
    let (_, record) = common::hard().into_iter().find(|(n, _)| *n == "broken-ledger").ok_or("no record")?;
    let rates = plot::rates(&record).ok_or("no chart")?;
    let grey = |m: &plot::Mark| m.kind == plot::MarkKind::Greyed;
    assert_eq!(rates.curves[0].marks.iter().filter(|m| grey(m)).count(), 2);
    assert!(rates.remarks[0].contains("levels 5–6: reference contamination"), "{:?}", rates.remarks);
    let ledger = plot::ledger(&record).ok_or("no chart")?;
    assert!(ledger.curves.iter().all(|c| c.label != "b"));
    assert!(ledger.remarks.iter().any(|r| r.contains("zero or rounding: b on levels 0–6")), "{:?}", ledger.remarks);
    assert!(ledger.subtitle[1].contains("BROKEN on levels 2, 5"), "{:?}", ledger.subtitle);
    Ok(())
}

#[test]
fn the_zone_is_shown_where_the_bodies_touch() -> Result<(), Box<dyn std::error::Error>> {
    let chart = plot::pressure(&common::pressed(1.0)).ok_or("no chart")?;
    // from the axis to 1.6 times the edge of the contact
    assert_eq!(chart.edge, Some(0.1));
    assert!(chart.window.0 == 0.0 && (chart.window.1 - 0.16).abs() < 1e-12, "{:?}", chart.window);
    let marks = chart.pressure.iter().find(|t| t.marks).ok_or("no marks")?;
    assert!((marks.points[0].1 - 2.04).abs() < 1e-15 && marks.points.len() == 101);
    assert!(chart.subtitle[1].contains("half width 0.09950 (formula 0.1000, −0.50 %)"), "{:?}", chart.subtitle);
    assert!(chart.remarks[0].contains("Level 6: 10 of 101 nodes"), "{:?}", chart.remarks);
    let (first, second) = (plot::zone_png(&chart)?, plot::zone_png(&chart)?);
    assert_eq!((size(&first), first == second), ((WIDTH, HEIGHT), true));
    Ok(())
}

#[test]
fn hard_zones_are_drawn_or_declined() -> Result<(), Box<dyn std::error::Error>> {
    assert!(plot::pressure(&common::healthy()).is_none());
    let dir = common::folder("zones");
    fs::create_dir_all(&dir)?;
    let mut open = common::pressed(1.0);
    let mut alone = common::pressed(1e-9);
    let mut one = common::pressed(1.0);
    if let (Some(open), Some(alone), Some(one)) = (&mut open.zone, &mut alone.zone, &mut one.zone) {
        open.pressure.iter_mut().for_each(|p| *p = 0.0);
        (alone.reference, alone.symmetric) = (None, false);
        one.coordinate.truncate(1);
    }
    assert!(plot::pressure(&one).is_none());
    for (name, record) in [("open", open), ("alone", alone), ("large", common::pressed(3e7))] {
        let chart = plot::pressure(&record).ok_or("no chart")?;
        fs::write(dir.join(format!("{name}.png")), plot::zone_png(&chart)?)?;
        assert!(plot::zone_svg(&chart)?.trim_end().ends_with("</svg>"), "{name}");
    }
    Ok(())
}
