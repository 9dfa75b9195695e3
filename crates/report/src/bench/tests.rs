//! A made-up measurement, rendered.

use super::{bench_table, bench_text, markdown, render_bench, scaling, work_precision};
use crate::plot::{HEIGHT, WIDTH};
use signorini_study::bench::machine::Machine;
use signorini_study::bench::record::{
    Bandwidth, BenchRecord, BenchStudy, ErrorSource, Exponent, LeftOut, Linear, Measured, SCHEMA, Seconds, Size,
    SolverCurve,
};
use signorini_study::bench::spread::Spread;

fn spread(x: f64) -> Spread {
    Spread { median: x, min: 0.9 * x, max: 1.4 * x, runs: 3 }
}

fn run(level: usize, dofs: usize, factor: f64) -> Measured {
    let t = |share: f64| spread(1e-6 * share * factor * dofs as f64);
    let seconds = Seconds {
        mesh: t(0.3),
        assembly: t(1.0),
        setup: t(2.0),
        solve: t(1.0),
        error: t(1.5),
        system: t(3.0),
        solution: t(4.3),
        total: t(5.8),
    };
    let linear = Linear {
        iterations: 1,
        work: None,
        wall: t(2.5),
        processor: Some(t(2.4)),
        ratio: 1.2,
        ratio_processor: Some(1.25),
    };
    Measured {
        level,
        status: "converged in 4 steps".into(),
        iterations: 4,
        factorizations: 1,
        work: None,
        error: Some(3.0 / (dofs as f64).sqrt()),
        relative_error: Some(2.0 / (dofs as f64).sqrt()),
        wall: seconds,
        processor: Some(seconds),
        peak_bytes: Some(spread(1.2e7 + 1500.0 * dofs as f64)),
        linear: Some(linear),
        closed: Some(0.5),
    }
}

fn curve(solver: &str, sizes: &[Size], factor: f64, left_out: Vec<LeftOut>) -> SolverCurve {
    let measured = sizes.iter().filter(|s| left_out.iter().all(|l| l.level != s.level));
    SolverCurve {
        solver: solver.into(),
        linear_solver: Some("condensed".into()),
        runs: measured.map(|s| run(s.level, s.dofs, factor)).collect(),
        left_out,
        growth_total: Some(Exponent { value: 1.07, stderr: 0.02, sizes: 4 }),
        growth_system: Some(Exponent { value: 1.12, stderr: 0.03, sizes: 4 }),
        seconds_to_target: vec![Some(0.02), None],
    }
}

pub(super) fn study(id: &str) -> BenchStudy {
    let size = |level: usize| {
        let dofs = 1000 << (2 * level);
        let product = Some(spread(1.2e-8 * dofs as f64));
        Size { level, cells: 8 << level, h: Some(0.2), dofs, product, matrix_bytes: Some(130 * dofs as u64) }
    };
    let sizes: Vec<Size> = (0..4).map(size).collect();
    let refused = LeftOut { level: 3, reason: "more than 20000 unknowns".into() };
    BenchStudy {
        study: id.into(),
        case: "structured".into(),
        title: "A sample".into(),
        family: "structured".into(),
        error: ErrorSource::Exact,
        targets: vec![0.05, 0.02],
        solvers: vec![curve("condensed", &sizes, 1.0, vec![]), curve("interior-point", &sizes, 9.0, vec![refused])],
        sizes,
        changed: None,
    }
}

pub(super) fn record() -> BenchRecord {
    BenchRecord {
        schema: SCHEMA,
        version: "0.0.0 (test)".into(),
        machine: Machine {
            processor: Some("Sample CPU".into()),
            processors: 2,
            memory_bytes: Some(8 << 30),
            system: "linux".into(),
        },
        threads: 2,
        repeat: 3,
        bandwidth: Bandwidth { one_thread: Some(spread(1e10)), all_threads: Some(spread(1.8e10)) },
        studies: vec![study("one"), study("two")],
    }
}

#[test]
fn the_page_states_ratios_floors_growth_and_what_is_left_out() {
    let page = markdown::page(&record());
    for words in [
        "Sample CPU, 2 processors, 8.0 GiB, linux; 2 threads, medians of 3 rounds. Signorini 0.0.0 (test).",
        "| one thread | 10.0 (9.00–14.0) |",
        "| condensed | 1000 | 6.32 | 4 | – | 0.00300 (0.00270–0.00420) | 0.00250 | 1.20 |",
        "- `interior-point` is left out at 64000 unknowns: more than 20000 unknowns",
        "| solver | 5 % | 2 % |",
        "| condensed | 0.0200 | – |",
        "| condensed | 1.12 ± 0.03 (4 meshes) | 1.07 ± 0.02 (4 meshes) |",
        "(work-precision.png)",
        "(scaling-two.png)",
    ] {
        assert!(page.contains(words), "no {words:?} in\n{page}");
    }
    assert!(bench_text(&record()).contains("is left out at 64000 unknowns"));
}

#[test]
fn a_row_of_the_csv_has_every_column() {
    let text = String::from_utf8(bench_table(&record()).to_csv().unwrap()).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|l| l.split(',').collect()).collect();
    assert!(rows.len() == 17 && rows.iter().all(|r| r.len() == rows[0].len()), "{text}");
    let at = |row: usize, key: &str| rows[row][rows[0].iter().position(|k| *k == key).unwrap()];
    assert_eq!(
        (at(1, "solver"), at(1, "dofs"), at(1, "wall_system"), at(1, "ratio")),
        ("condensed", "1000", "0.003", "1.2")
    );
    let largest: f64 = at(4, "wall_total_max").parse().unwrap();
    assert!((largest - 1.4 * 5.8e-6 * 64_000.0).abs() < 1e-12 && at(4, "matrix_bytes") == "8.32e6", "{largest}");
    assert_eq!(
        (at(8, "solver"), at(8, "wall_total"), at(8, "excluded")),
        ("interior-point", "", "more than 20000 unknowns")
    );
}

#[test]
fn curves_and_floors_have_a_point_for_each_mesh() {
    let record = record();
    let study = &record.studies[0];
    let count = |chart: &crate::plot::PanelChart, panel: usize| -> Vec<(String, usize)> {
        chart.panels[panel].series.iter().map(|s| (s.label.clone(), s.points.len())).collect()
    };
    let named = |list: &[(&str, usize)]| list.iter().map(|(l, n)| ((*l).to_owned(), *n)).collect::<Vec<_>>();
    let precision = work_precision(&record, study);
    assert_eq!(count(&precision, 0), named(&[("condensed", 4), ("interior-point", 3)]));
    let (seconds, percent) = precision.panels[0].series[0].points[0];
    assert!((seconds - 4.3e-3).abs() < 1e-15 && (percent - 200.0 / 1000f64.sqrt()).abs() < 1e-13);
    let scaled = scaling(&record, study);
    let floors = [
        ("floor: all pairs tied, condensed", 4),
        ("floor: one product", 4),
        ("floor: the matrix at full bandwidth", 4),
    ];
    assert_eq!(count(&scaled, 0)[2..], named(&floors)[..]);
    // 130 bytes at 18 GB/s
    let (_, read) = scaled.panels[0].series[4].points[0];
    assert!((read - 130.0 / 1.8e4).abs() < 1e-15, "{read}");
    assert_eq!(count(&scaled, 1), named(&[("condensed", 4), ("interior-point", 3), ("floor: the matrix", 4)]));
}

#[test]
fn everything_is_written_and_the_pictures_decode() {
    let dir = std::env::temp_dir().join(format!("signorini-bench-{}", std::process::id()));
    let files = render_bench(&record(), &dir).unwrap();
    let names: Vec<String> = files.iter().map(|f| f.file_name().unwrap().to_string_lossy().into_owned()).collect();
    let pictures = ["work-precision.png", "scaling.png", "work-precision-two.png", "scaling-two.png"];
    assert_eq!(names, [&["bench.json", "bench.csv", "bench.md"][..], &pictures[..]].concat());
    for file in &files[3..] {
        let bytes = std::fs::read(file).unwrap();
        let mut picture = png::Decoder::new(bytes.as_slice()).read_info().unwrap();
        let mut pixels = vec![0; picture.output_buffer_size()];
        let info = picture.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (WIDTH, HEIGHT));
        let blue = pixels.chunks_exact(3).filter(|p| *p == [0, 114, 178]).count();
        assert!(blue > 100, "a curve of the colour of `condensed`: {blue} pixels");
    }
    std::fs::remove_dir_all(dir).unwrap();
}

#[test]
fn a_measurement_without_a_value_is_drawn_as_such() {
    let mut record = record();
    for curve in record.studies.iter_mut().flat_map(|s| &mut s.solvers) {
        curve.runs.clear();
    }
    let chart = work_precision(&record, &record.studies[0]);
    assert!(chart.legend().is_empty());
    assert!(crate::plot::panel_png(&chart).is_ok());
}
