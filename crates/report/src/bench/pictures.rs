//! The two pictures of a study, as data.

use super::words::{error_source, exponent, machine, name, rounds, threads};
use crate::plot::{Colour, Panel, PanelChart, Series, Shape, Style};
use signorini_study::bench::record::{BenchRecord, BenchStudy, Measured, SolverCurve};

/// Error against seconds and error against unknowns, one curve per solver.
pub fn work_precision(record: &BenchRecord, study: &BenchStudy) -> PanelChart {
    let error = |run: &Measured| run.relative_error.map(|e| 100.0 * e);
    let panel = |x_label: &str, x: &dyn Fn(&Measured) -> f64| Panel {
        x_label: x_label.into(),
        y_label: "relative error, energy norm (%)".into(),
        series: solvers(study, &|run| Some((x(run), error(run)?))),
    };
    PanelChart {
        title: format!("Speed against error: {}", name(study)),
        subtitle: vec![format!("{}; {}, {}", machine(record), threads(record), rounds(record))],
        panels: [
            panel("wall seconds to the solution", &|run| run.wall.solution.median),
            panel("unknowns", &|run| study.sizes[run.level].dofs as f64),
        ],
        remarks: vec![
            error_source(study).into(),
            "Seconds of mesh, assembly, set-up and solve; solvers of equal errors coincide on the right.".into(),
        ],
    }
}

/// Seconds and bytes per unknown, with what no solver can beat.
pub fn scaling(record: &BenchRecord, study: &BenchStudy) -> PanelChart {
    let dofs = |level: usize| study.sizes[level].dofs as f64;
    let micro = |run: &Measured| Some((dofs(run.level), 1e6 * run.wall.system.median / dofs(run.level)));
    let mut seconds = solvers(study, &micro);
    seconds.extend(linear(study));
    seconds.extend(products(record, study));
    let mut bytes = solvers(study, &|run| Some((dofs(run.level), run.peak_bytes?.median / dofs(run.level))));
    bytes.push(floor(
        "floor: the matrix",
        Colour::Black,
        over_sizes(study, |s| Some(s.matrix_bytes? as f64 / s.dofs as f64)),
    ));
    let panel = |y_label: &str, series| Panel { x_label: "unknowns N".into(), y_label: y_label.into(), series };
    let grown = |c: &SolverCurve| {
        let [system, total] = [c.growth_system, c.growth_total].map(exponent);
        format!("Seconds of {} grow like {system} in set-up and solve, {total} in all phases.", c.solver)
    };
    PanelChart {
        title: format!("Seconds and bytes per unknown: {}", name(study)),
        subtitle: vec![format!("{}; {}, {}", machine(record), threads(record), rounds(record))],
        panels: [panel("set-up and solve (µs per unknown)", seconds), panel("peak memory (bytes per unknown)", bytes)],
        remarks: study.solvers.iter().filter(|c| c.growth_total.is_some()).map(grown).collect(),
    }
}

/// Colour and shape of each solver.
fn look(solver: &str) -> (Colour, Shape) {
    match solver {
        "condensed" => (Colour::Blue, Shape::Circle),
        "multigrid" => (Colour::Vermillion, Shape::Square),
        "interior-point" => (Colour::Green, Shape::Triangle),
        "monotone" => (Colour::Purple, Shape::Diamond),
        _ => (Colour::Orange, Shape::Diamond),
    }
}

/// Colours and shapes of other programs, in their order.
const OTHERS: [(Colour, Shape); 5] = [
    (Colour::Green, Shape::Triangle),
    (Colour::Orange, Shape::Diamond),
    (Colour::Purple, Shape::Square),
    (Colour::Black, Shape::Circle),
    (Colour::Grey, Shape::Triangle),
];

fn solvers(study: &BenchStudy, point: &dyn Fn(&Measured) -> Option<(f64, f64)>) -> Vec<Series> {
    let series = |(rank, curve): (usize, &SolverCurve)| {
        let others = study.solvers[..rank].iter().filter(|c| c.linear_solver.is_none()).count();
        let is_other = curve.linear_solver.is_none();
        let (colour, shape) = if is_other { OTHERS[others % OTHERS.len()] } else { look(&curve.solver) };
        let points = curve.runs.iter().filter_map(point).collect();
        Series { label: curve.solver.clone(), colour, style: Style::Marks(shape, rank.min(3) as u8), points }
    };
    study.solvers.iter().enumerate().map(series).collect()
}

/// The linear problem, once for each solver that it was solved with.
fn linear(study: &BenchStudy) -> Vec<Series> {
    let mut names: Vec<&str> = study.solvers.iter().filter_map(|c| c.linear_solver.as_deref()).collect();
    names.sort_unstable();
    names.dedup();
    let dofs = |run: &Measured| study.sizes[run.level].dofs as f64;
    let of = |run: &Measured| Some((dofs(run), 1e6 * run.linear?.wall.median / dofs(run)));
    let series = |name: &&str| {
        let sharing = study.solvers.iter().filter(|c| c.linear_solver.as_deref() == Some(*name));
        let longest = sharing.max_by_key(|c| c.runs.len()).map(|c| c.runs.iter().filter_map(of).collect());
        floor(&format!("floor: all pairs tied, {name}"), look(name).0, longest.unwrap_or_default())
    };
    names.iter().map(series).collect()
}

/// One product with the finest matrix, as measured and as the bandwidth of the memory allows.
fn products(record: &BenchRecord, study: &BenchStudy) -> [Series; 2] {
    let measured = over_sizes(study, |s| Some(1e6 * s.product?.median / s.dofs as f64));
    let bandwidth = record.bandwidth.all_threads.map(|b| b.median);
    let read = over_sizes(study, |s| Some(1e6 * s.matrix_bytes? as f64 / bandwidth? / s.dofs as f64));
    [
        floor("floor: one product", Colour::Black, measured),
        floor("floor: the matrix at full bandwidth", Colour::Grey, read),
    ]
}

fn over_sizes(
    study: &BenchStudy,
    value: impl Fn(&signorini_study::bench::record::Size) -> Option<f64>,
) -> Vec<(f64, f64)> {
    study.sizes.iter().filter_map(|s| Some((s.dofs as f64, value(s)?))).collect()
}

fn floor(label: &str, colour: Colour, points: Vec<(f64, f64)>) -> Series {
    Series { label: label.into(), colour, style: Style::Dashes, points }
}
