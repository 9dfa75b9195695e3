//! The tables of one case: what was measured on each level, and the fitted rates.

use crate::format;
use crate::formula;
use crate::ledger;
use crate::norm::{self, Norm, Trust};
use crate::table::{Cell, Column, Row, Table};
use signorini_study::record::{ClaimKind, Level, Rate, SecondOpinion, StudyRecord};

/// Norms that carry a pairwise rate (EOC) beside them in [`errors`].
const WITH_RATE: [&str; 4] = ["energy", "strain", "h1", "l2"];

/// Quantities that have their column in [`contact`].
const SHOWN_WITH_CONTACT: [&str; 5] = ["pressure_l2", "pressure_dual", "penetration_l2", "contact_set", "energy_gap"];

/// The cell of the level at an index.
type CellOf<'a> = dyn Fn(usize, &Level) -> Cell + 'a;

/// A column and how its cell follows from the level at an index.
pub(crate) struct Measured<'a> {
    column: Column,
    cell: Box<CellOf<'a>>,
}

/// A column that means nothing where no contact problem was solved.
fn solved(key: &str, heading: &str, cell: fn(&Level) -> Cell) -> Measured<'static> {
    measured(key, heading, move |level| if level.has_solution() { cell(level) } else { Cell::Missing })
}

/// A column of that key and heading, and its cell on a level.
pub(crate) fn measured<'a>(key: &str, heading: &str, cell: impl Fn(&Level) -> Cell + 'a) -> Measured<'a> {
    Measured { column: Column::new(key, heading), cell: Box::new(move |_, level| cell(level)) }
}

/// The same with a cell that depends on the position of the level too.
pub(crate) fn measured_at<'a>(key: &str, heading: &str, cell: impl Fn(usize, &Level) -> Cell + 'a) -> Measured<'a> {
    Measured { column: Column::new(key, heading), cell: Box::new(cell) }
}

/// Everything measured, one row per level: the table of CSV and JSON.
pub fn all(record: &StudyRecord) -> Table {
    let mut columns = size_columns();
    columns.extend(error_columns(record));
    columns.extend(contact_columns());
    columns.extend(formula::columns());
    columns.extend(ledger::columns(record));
    columns.extend(solution_columns());
    columns.extend(second_columns(record));
    build(record, columns)
}

/// Mesh size and errors, each norm with its rate between successive levels; the judged quantity among them. Columns
/// without a value are left out.
pub fn errors(record: &StudyRecord) -> Table {
    let mut columns = size_columns();
    columns.extend(error_columns(record));
    if let Some(judged) = norm::norm(&record.norm).filter(|n| SHOWN_WITH_CONTACT.contains(&n.key)) {
        let rate = columns.iter().position(|c| c.column.key == format!("{}_rate", judged.key));
        columns.insert(rate.unwrap_or(columns.len()), error_column(judged));
    }
    without_empty(build(record, columns))
}

/// Contact pairs, active constraints, pressure, penetration and contact set.
pub fn contact(record: &StudyRecord) -> Table {
    let mut columns = vec![level_column(), h_column()];
    columns.extend(contact_columns());
    let table = without_empty(build(record, columns));
    // level and h alone are no table
    if table.columns.len() > 2 { table } else { Table::default() }
}

/// Mesh quality, certificate, error budget and solver. What only curved bodies have is left out where it says nothing.
pub fn solution(record: &StudyRecord) -> Table {
    let mut columns = vec![level_column()];
    columns.extend(solution_columns().into_iter().filter(|m| tells(record, &m.column.key)));
    columns.extend(second_columns(record));
    let table = build(record, columns);
    // what belongs to a solution is not shown where there is none
    if has_solution(record) { table } else { without_empty(table) }
}

/// Straight sides are compared with chords where there are any, and the geometry's share is shown where it is not zero.
fn tells(record: &StudyRecord, key: &str) -> bool {
    match key {
        "straight_over_chord" => record.levels.iter().any(|l| l.straight_over_chord.is_some()),
        "budget_geometry" => record.levels.iter().any(|l| l.budget.geometry.is_some_and(|share| share > 0.0)),
        _ => true,
    }
}

/// Whether the case is a contact problem, and not a lemma.
pub fn has_solution(record: &StudyRecord) -> bool {
    record.levels.iter().all(Level::has_solution)
}

/// One row per fitted norm: slope, interval, window and quality of the fit. A rate that is not asymptotic is marked; one
/// whose errors scatter shows no numbers but R².
pub fn rates(record: &StudyRecord) -> Table {
    let columns = [
        ("norm", "error"),
        ("slope", "rate"),
        ("stderr", "standard error"),
        ("low", "95 % from"),
        ("high", "95 % to"),
        ("levels", "levels"),
        ("r2", "R²"),
        ("curvature", "curvature"),
        ("dofs_slope", "rate in dofs^(−1/2)"),
    ];
    let rows = norm::rates_in_order(record).into_iter().map(|(key, rate)| rate_row(record, key, rate));
    Table { rows: rows.collect(), columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec() }
}

fn rate_row(record: &StudyRecord, key: &str, r: &Rate) -> Row {
    let words = match key {
        "dofs" => format!("{}, fitted against dofs^(−1/2)", norm::words(&record.norm)),
        _ => norm::words(key),
    };
    let trust = Trust::of(r);
    let shown = |cell: Cell| if trust == Trust::Scattered { Cell::Missing } else { cell };
    Row {
        cells: vec![
            Cell::text(words),
            shown(Cell::Rate(r.slope)),
            shown(Cell::Number(r.stderr)),
            shown(Cell::Rate(r.low)),
            shown(Cell::Rate(r.high)),
            Cell::text(format::levels(&r.levels)),
            Cell::Number(r.r2),
            shown(Cell::Rate(r.curvature)),
            shown(Cell::Rate(r.dofs_slope)),
        ],
        excluded: trust.remark().map(String::from),
    }
}

pub(crate) fn build(record: &StudyRecord, measured: Vec<Measured<'_>>) -> Table {
    let rows = record.levels.iter().enumerate().map(|(i, level)| Row {
        cells: measured.iter().map(|m| (m.cell)(i, level)).collect(),
        excluded: level.excluded.clone(),
    });
    Table { rows: rows.collect(), columns: measured.into_iter().map(|m| m.column).collect() }
}

/// Drops the columns in which no row has a value.
pub(crate) fn without_empty(table: Table) -> Table {
    let filled = |c: usize| table.rows.iter().any(|row| row.cells[c] != Cell::Missing);
    let keep: Vec<usize> = (0..table.columns.len()).filter(|&c| filled(c)).collect();
    let rows = table
        .rows
        .iter()
        .map(|row| Row { cells: keep.iter().map(|&c| row.cells[c].clone()).collect(), excluded: row.excluded.clone() });
    Table { rows: rows.collect(), columns: keep.iter().map(|&c| table.columns[c].clone()).collect() }
}

pub(crate) fn level_column() -> Measured<'static> {
    measured("level", "level", |l| Cell::Count(l.level))
}

pub(crate) fn h_column() -> Measured<'static> {
    measured("h", "h", |l| Cell::Number(l.h))
}

fn size_columns() -> Vec<Measured<'static>> {
    vec![
        level_column(),
        h_column(),
        measured("dofs", "dofs", |l| Cell::Count(l.dofs)),
        solved("contact_pairs", "pairs", |l| Cell::Count(l.contact_pairs)),
    ]
}

fn error_columns(record: &StudyRecord) -> Vec<Measured<'_>> {
    let mut columns = Vec::new();
    for norm in WITH_RATE.iter().filter_map(|key| norm::norm(key)) {
        columns.push(error_column(norm));
        columns.push(rate_column(record, norm));
    }
    if !WITH_RATE.contains(&record.norm.as_str()) {
        columns.extend(judged_columns(record));
    }
    columns
}

/// The judged quantity where it is none of the usual norms, with its rate where a rate is asked for.
fn judged_columns(record: &StudyRecord) -> Vec<Measured<'_>> {
    let Some(norm) = norm::norm(&record.norm) else {
        return Vec::new();
    };
    let mut columns = Vec::new();
    if !SHOWN_WITH_CONTACT.contains(&norm.key) {
        columns.push(error_column(norm));
    }
    if matches!(record.kind, ClaimKind::Rate | ClaimKind::Convergence) {
        columns.push(rate_column(record, norm));
    }
    if record.kind == ClaimKind::Exact && norm.key == "constant" {
        columns.push(measured("constant_off", "c − 1", |l| Cell::number(l.errors.constant.map(|c| c - 1.0))));
    }
    columns
}

fn error_column(norm: &'static Norm) -> Measured<'static> {
    measured(norm.key, &norm.label(), |l| Cell::number(norm.value(l)))
}

fn rate_column<'a>(record: &'a StudyRecord, norm: &'static Norm) -> Measured<'a> {
    Measured {
        column: Column::new(format!("{}_rate", norm.key), format!("rate, {}", norm.words)),
        cell: Box::new(move |i, _| Cell::rate(norm::pairwise(record, norm, i))),
    }
}

fn contact_columns() -> Vec<Measured<'static>> {
    vec![
        solved("constraints", "constraints", |l| Cell::Count(l.constraints)),
        solved("active", "active", |l| Cell::Count(l.active)),
        measured("switch_sides", "switch sides", |l| Cell::count(l.switch_sides)),
        measured("pressure_l2", "pressure ‖p−pₕ‖₀", |l| Cell::number(l.errors.pressure_l2)),
        measured("pressure_dual", "pressure, dual norm", |l| Cell::number(l.errors.pressure_dual)),
        measured("penetration_l2", "penetration", |l| Cell::number(l.errors.penetration_l2)),
        measured("contact_set", "contact set |C △ Cₕ|", |l| Cell::number(l.errors.contact_set)),
        measured("switch_position", "switch point", |l| Cell::number(l.errors.switch_position)),
        measured("energy_gap", "L(uₕ)−L(u)", |l| Cell::number(l.errors.energy_gap)),
    ]
}

fn solution_columns() -> Vec<Measured<'static>> {
    vec![
        measured("min_angle", "min angle (°)", min_angle),
        measured("side_ratio", "β", |l| Cell::Number(l.side_ratio)),
        measured("straight_over_chord", "straight/chord", |l| Cell::number(l.straight_over_chord)),
        measured("two_way", "two-way", |l| Cell::number(l.two_way)),
        solved("energy_value", "L(uₕ)", |l| Cell::Number(l.energy)),
        solved("kkt_stationarity", "KKT stationarity", |l| Cell::Number(l.kkt.stationarity)),
        solved("kkt_penetration", "KKT penetration", |l| Cell::Number(l.kkt.penetration)),
        solved("kkt_tension", "KKT tension", |l| Cell::Number(l.kkt.tension)),
        solved("kkt_complementarity", "KKT compl.", |l| Cell::Number(l.kkt.complementarity)),
        solved("weakly_active", "weakly active", |l| Cell::Count(l.kkt.weakly_active)),
        measured("budget_algebraic", "algebraic", |l| Cell::number(l.budget.algebraic)),
        measured("budget_quadrature", "quadrature", |l| Cell::number(l.budget.quadrature)),
        measured("budget_geometry", "geometry", |l| Cell::number(l.budget.geometry)),
        measured("budget_reference", "reference", |l| Cell::number(l.budget.reference)),
        solved("solver", "solver", |l| Cell::text(&l.solver.name)),
        solved("status", "status", |l| Cell::text(&l.solver.status)),
        solved("iterations", "iterations", |l| Cell::Count(l.solver.iterations)),
        measured("mesh_hash", "mesh", |l| Cell::text(&l.mesh_hash)),
    ]
}

/// What a second solver says; no columns where none was asked.
fn second_columns(record: &StudyRecord) -> Vec<Measured<'static>> {
    if record.levels.iter().all(|l| l.second.is_none()) {
        return Vec::new();
    }
    vec![
        measured("kkt_componentwise", "KKT row by row", |l| Cell::number(l.kkt.componentwise)),
        second("second", "second solver", |s| Cell::text(&s.name)),
        second("second_status", "its status", |s| Cell::text(&s.status)),
        second("second_energy", "ΔL", |s| Cell::Number(s.energy_difference)),
        second("second_displacement", "Δu", |s| Cell::Number(s.displacement_difference)),
        second("second_active", "contact differs", |s| Cell::Count(s.active_difference)),
        second("cancellation", "cancellation", |s| Cell::Number(s.cancellation)),
    ]
}

/// A column of the second opinion.
fn second(key: &str, heading: &str, cell: fn(&SecondOpinion) -> Cell) -> Measured<'static> {
    measured(key, heading, move |l| l.second.as_ref().map_or(Cell::Missing, cell))
}

/// Intervals have no angle.
fn min_angle(level: &Level) -> Cell {
    if level.has_solution() || level.min_angle > 0.0 { Cell::Number(level.min_angle) } else { Cell::Missing }
}
