//! Every run in one row, for programs.

use crate::table::{Cell, Column, Row, Table};
use signorini_study::bench::record::{BenchRecord, BenchStudy, LeftOut, Measured, Seconds, SolverCurve};
use signorini_study::bench::spread::Spread;
use signorini_study::record::{Changed, Setting};

/// Columns before the times.
const HEAD: [&str; 15] = [
    "study",
    "case",
    "family",
    "solver",
    "level",
    "cells",
    "h",
    "dofs",
    "status",
    "iterations",
    "factorizations",
    "work",
    "error",
    "relative_error",
    "runs",
];
/// Phases and sums, in the order of [`phases`].
const PHASES: [&str; 8] = ["mesh", "assembly", "setup", "solve", "error", "system", "solution", "total"];
/// Columns behind the times; those of swept values follow.
const TAIL: [&str; 13] = [
    "peak_bytes",
    "peak_bytes_min",
    "peak_bytes_max",
    "linear_solver",
    "linear_iterations",
    "linear_work",
    "linear_wall",
    "linear_processor",
    "ratio",
    "ratio_processor",
    "product",
    "matrix_bytes",
    "closed",
];

/// The table: a row for each solver and mesh; where a solver was left out, the reason stands in `excluded`.
pub fn table(record: &BenchRecord) -> Table {
    let wall = PHASES.iter().flat_map(|p| [format!("wall_{p}"), format!("wall_{p}_min"), format!("wall_{p}_max")]);
    let processor = PHASES.iter().map(|p| format!("processor_{p}"));
    let head = HEAD.iter().map(|c| (*c).to_owned());
    let swept = swept(record);
    let tail = TAIL.iter().map(|c| (*c).to_owned()).chain(swept.iter().cloned());
    let keys = head.chain(wall).chain(processor).chain(tail);
    let columns: Vec<Column> = keys.map(|key| Column::new(key.clone(), key)).collect();
    let width = columns.len();
    let mut rows = Vec::new();
    for study in &record.studies {
        for curve in &study.solvers {
            rows.extend(curve.runs.iter().map(|run| row(study, curve, run, &swept)));
            rows.extend(curve.left_out.iter().map(|left| left_out(study, curve, left, width, &swept)));
        }
    }
    Table { columns, rows }
}

/// The keys that are swept in any of the studies.
fn swept(record: &BenchRecord) -> Vec<String> {
    let mut keys: Vec<String> = Vec::new();
    for setting in record.studies.iter().filter_map(|s| s.changed.as_ref()).flat_map(Changed::swept) {
        if !keys.contains(&setting.key) {
            keys.push(setting.key.clone());
        }
    }
    keys
}

fn swept_cells(study: &BenchStudy, swept: &[String]) -> Vec<Cell> {
    let settings: Vec<&Setting> = study.changed.iter().flat_map(Changed::swept).collect();
    let cell = |s: &Setting| s.number.map_or_else(|| Cell::text(&s.value), Cell::Number);
    swept.iter().map(|key| settings.iter().find(|s| s.key == *key).map_or(Cell::Missing, |s| cell(s))).collect()
}

fn row(study: &BenchStudy, curve: &SolverCurve, run: &Measured, swept: &[String]) -> Row {
    let mut cells = mesh_cells(study, curve, run.level);
    cells.extend([
        Cell::text(&run.status),
        Cell::count(told(curve, run.iterations)),
        Cell::count(told(curve, run.factorizations)),
        Cell::number(run.work),
        Cell::number(run.error),
        Cell::number(run.relative_error),
        Cell::Count(run.wall.total.runs),
    ]);
    cells.extend(phases(&run.wall).into_iter().flat_map(three));
    let processor = run.processor.as_ref().map(phases);
    cells.extend((0..PHASES.len()).map(|k| Cell::number(processor.map(|p| p[k].median))));
    cells.extend(run.peak_bytes.map_or([Cell::Missing, Cell::Missing, Cell::Missing], three));
    let linear = run.linear.as_ref();
    let size = &study.sizes[run.level];
    cells.extend([
        curve.linear_solver.as_ref().map_or(Cell::Missing, Cell::text),
        Cell::count(linear.map(|l| l.iterations)),
        Cell::number(linear.and_then(|l| l.work)),
        Cell::number(linear.map(|l| l.wall.median)),
        Cell::number(linear.and_then(|l| l.processor).map(|p| p.median)),
        Cell::number(linear.map(|l| l.ratio)),
        Cell::number(linear.and_then(|l| l.ratio_processor)),
        Cell::number(size.product.map(|p| p.median)),
        Cell::number(size.matrix_bytes.map(|b| b as f64)),
        Cell::number(run.closed),
    ]);
    cells.extend(swept_cells(study, swept));
    Row { cells, excluded: None }
}

/// A count that another program does not tell.
pub(super) fn told(curve: &SolverCurve, count: usize) -> Option<usize> {
    curve.linear_solver.is_some().then_some(count)
}

/// Study, solver and mesh.
fn mesh_cells(study: &BenchStudy, curve: &SolverCurve, level: usize) -> Vec<Cell> {
    let size = &study.sizes[level];
    vec![
        Cell::text(&study.study),
        Cell::text(&study.case),
        Cell::text(&study.family),
        Cell::text(&curve.solver),
        Cell::Count(level),
        Cell::Count(size.cells),
        Cell::number(size.h),
        Cell::Count(size.dofs),
    ]
}

fn left_out(study: &BenchStudy, curve: &SolverCurve, left: &LeftOut, width: usize, swept: &[String]) -> Row {
    let mut cells = mesh_cells(study, curve, left.level);
    cells.resize(width - swept.len(), Cell::Missing);
    cells.extend(swept_cells(study, swept));
    Row { cells, excluded: Some(left.reason.clone()) }
}

fn phases(s: &Seconds) -> [Spread; 8] {
    [s.mesh, s.assembly, s.setup, s.solve, s.error, s.system, s.solution, s.total]
}

fn three(spread: Spread) -> [Cell; 3] {
    [spread.median, spread.min, spread.max].map(Cell::Number)
}
