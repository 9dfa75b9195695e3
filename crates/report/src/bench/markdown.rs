//! The page and what the terminal shows.

use super::data::told;
use super::picture_names;
use super::sweep::{Group, groups};
use super::words::{error_source, machine, median, name, number, plain_exponent, rounds, scaled, spread, threads};
use crate::format::significant;
use crate::table::{Cell, Column, Row, Table};
use signorini_study::bench::record::{BenchRecord, BenchStudy, Measured, Size, SolverCurve};

const TEXT_WIDTH: usize = 150;

/// `bench.md`.
pub(super) fn page(record: &BenchRecord) -> String {
    let mut out = format!("# Speed against error\n\n{}\n\n{METHOD}\n\n", head(record));
    out += &format!("## The memory\n\n{}\n", bandwidth(record).to_markdown());
    let mut sweeps = 0;
    for group in groups(record) {
        match group {
            Group::One(position, study) => out += &study_page(position, study),
            Group::Sweep(sweep) => {
                let picture = sweep.chart(record).map(|_| sweep.picture_name(sweeps));
                out += &sweep.page(picture.as_deref());
                sweeps += 1;
            }
        }
    }
    out
}

/// The same in short, for the terminal.
pub fn bench_text(record: &BenchRecord) -> String {
    let mut out = String::new();
    for group in groups(record) {
        out += &match group {
            Group::One(_, study) => study_text(study),
            Group::Sweep(sweep) => sweep.text(),
        };
    }
    out + &head(record) + "\n"
}

fn study_text(study: &BenchStudy) -> String {
    let tables = [runs(study), growth(study)].map(|t| t.to_text(TEXT_WIDTH) + "\n").concat();
    format!("{}\n{tables}{}", name(study), left_out(study))
}

const METHOD: &str = "Every measurement is a process of its own; a round visits all of them once, forwards and backwards in turn. \
Numbers are medians, in brackets the smallest and the largest. *Solve* is set-up and solve together; *linear* is the same with every pair \
tied (`n·d = g`), so that nothing has to be decided, under the solver named; *ratio* is the contact problem over the linear one, in wall and in processor seconds. *Work* counts products with \
the finest matrix. Of another program *solve* is its process from start to end, with what it reads and assembles; \
writing the level down for it and reading its answer are in none of the times. *Peak* is the largest resident memory of the process, the program itself included.";

const FLOORS: &str =
    "A matrix that fits in the caches is read faster than the memory allows; from there on the triad is the limit.";

fn head(record: &BenchRecord) -> String {
    format!("{}; {}, {}. Signorini {}.", machine(record), threads(record), rounds(record), record.version)
}

fn columns(headings: &[&str]) -> Vec<Column> {
    headings.iter().map(|h| Column::new(*h, *h)).collect()
}

fn row(cells: Vec<Cell>) -> Row {
    Row { cells, excluded: None }
}

fn bandwidth(record: &BenchRecord) -> Table {
    let b = &record.bandwidth;
    let cells = |threads: &str, found| row(vec![Cell::text(threads), Cell::figure(spread(found))]);
    let giga = |found: Option<_>| found.map(|s| scaled(s, 1e-9));
    Table {
        columns: columns(&["a = b + s c", "GB/s"]),
        rows: vec![
            cells("one thread", giga(b.one_thread)),
            cells(&format!("all ({})", record.threads), giga(b.all_threads)),
        ],
    }
}

fn study_page(position: usize, study: &BenchStudy) -> String {
    let [precision, scaled] = picture_names(position, study);
    let mut out =
        format!("## {}\n\n{}. Family `{}`. {}\n\n", name(study), study.title, study.family, error_source(study));
    if let Some(changed) = &study.changed {
        out += &format!("Changed: `{}`.\n\n", changed.options.join(" "));
    }
    out += &format!("{}\n{}", runs(study).to_markdown(), left_out(study));
    out += &format!("\n![Error against seconds and against unknowns]({precision})\n\n");
    out += &format!("### Phases\n\nWall seconds, in brackets processor seconds.\n\n{}\n", phases(study).to_markdown());
    if !study.targets.is_empty() {
        out += &format!(
            "### Seconds to a relative error\n\nInterpolated between the levels.\n\n{}\n",
            targets(study).to_markdown()
        );
    }
    out += &format!("### Growth\n\n`c N^p`, fitted on the finest meshes.\n\n{}\n", growth(study).to_markdown());
    out += &format!("### Floors\n\n{FLOORS}\n\n{}\n", floors(study).to_markdown());
    out + &format!("![Seconds and bytes per unknown]({scaled})\n\n")
}

/// Every run of every solver.
fn runs(study: &BenchStudy) -> Table {
    let headings = [
        "solver",
        "unknowns",
        "error (%)",
        "iterations",
        "work",
        "solve (s)",
        "linear (s)",
        "ratio",
        "ratio (CPU)",
        "to the solution (s)",
        "peak (MB)",
    ];
    let of = |curve: &SolverCurve, run: &Measured| {
        let linear = run.linear.as_ref();
        row(vec![
            Cell::text(&curve.solver),
            Cell::Count(study.sizes[run.level].dofs),
            Cell::figure(number(run.relative_error.map(|e| 100.0 * e))),
            Cell::count(told(curve, run.iterations)),
            Cell::figure(number(run.work)),
            Cell::figure(spread(Some(run.wall.system))),
            Cell::figure(median(linear.map(|l| l.wall))),
            Cell::figure(number(linear.map(|l| l.ratio))),
            Cell::figure(number(linear.and_then(|l| l.ratio_processor))),
            Cell::figure(spread(Some(run.wall.solution))),
            Cell::figure(median(run.peak_bytes.map(|p| scaled(p, 1e-6)))),
        ])
    };
    let rows = study.solvers.iter().flat_map(|c| c.runs.iter().map(move |r| of(c, r))).collect();
    Table { columns: columns(&headings), rows }
}

/// One line for each solver and mesh without a time.
fn left_out(study: &BenchStudy) -> String {
    let line = |c: &SolverCurve| -> Vec<String> {
        let of = |l: &signorini_study::bench::record::LeftOut| {
            format!("- `{}` is left out at {} unknowns: {}\n", c.solver, study.sizes[l.level].dofs, l.reason.trim())
        };
        c.left_out.iter().map(of).collect()
    };
    study.solvers.iter().flat_map(line).collect()
}

fn phases(study: &BenchStudy) -> Table {
    let headings = ["solver", "unknowns", "mesh", "assembly", "set-up", "solve", "error", "total"];
    let of = |curve: &SolverCurve, run: &Measured| {
        let wall = [&run.wall].map(|s| [s.mesh, s.assembly, s.setup, s.solve, s.error, s.total])[0];
        let used = run.processor.as_ref().map(|s| [s.mesh, s.assembly, s.setup, s.solve, s.error, s.total]);
        let cell = |k: usize| {
            let used = used.map_or(String::new(), |u| format!(" ({})", significant(u[k].median, 2)));
            Cell::figure(median(Some(wall[k])) + &used)
        };
        let head = [Cell::text(&curve.solver), Cell::Count(study.sizes[run.level].dofs)];
        row(head.into_iter().chain((0..wall.len()).map(cell)).collect())
    };
    let rows = study.solvers.iter().flat_map(|c| c.runs.iter().map(move |r| of(c, r))).collect();
    Table { columns: columns(&headings), rows }
}

fn targets(study: &BenchStudy) -> Table {
    let headings: Vec<String> = study.targets.iter().map(|t| format!("{} %", significant(100.0 * t, 1))).collect();
    let names: Vec<&str> = std::iter::once("solver").chain(headings.iter().map(String::as_str)).collect();
    let of = |c: &SolverCurve| {
        let times = c.seconds_to_target.iter().map(|t| Cell::figure(number(*t)));
        row(std::iter::once(Cell::text(&c.solver)).chain(times).collect())
    };
    Table { columns: columns(&names), rows: study.solvers.iter().map(of).collect() }
}

fn growth(study: &BenchStudy) -> Table {
    let of = |c: &SolverCurve| {
        row(vec![
            Cell::text(&c.solver),
            Cell::figure(plain_exponent(c.growth_system)),
            Cell::figure(plain_exponent(c.growth_total)),
        ])
    };
    let rows = study.solvers.iter().map(of).collect();
    Table { columns: columns(&["solver", "p of set-up and solve", "p of all phases"]), rows }
}

fn floors(study: &BenchStudy) -> Table {
    let headings = ["unknowns", "n", "h", "one product (ms)", "matrix (bytes per unknown)", "read at (GB/s)"];
    let of = |s: &Size| {
        let bytes = s.matrix_bytes.map(|b| b as f64);
        let rate = bytes.zip(s.product).map(|(b, p)| 1e-9 * b / p.median);
        row(vec![
            Cell::Count(s.dofs),
            Cell::Count(s.cells),
            Cell::figure(number(s.h)),
            Cell::figure(spread(s.product.map(|p| scaled(p, 1e3)))),
            Cell::figure(number(bytes.map(|b| b / s.dofs as f64))),
            Cell::figure(number(rate)),
        ])
    };
    Table { columns: columns(&headings), rows: study.sizes.iter().map(of).collect() }
}
