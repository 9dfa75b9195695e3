//! The answer of a program: `displacement.csv` or `x.mtx`, taken only if it is whole.

use super::matrix_market::read_column;
use signorini_contact::Vec2;
use signorini_contact::problem::Discrete;
use std::fs;
use std::path::Path;

/// Names of the two kinds of answer.
pub(super) const DISPLACEMENT: &str = "displacement.csv";
pub(super) const UNKNOWNS: &str = "x.mtx";

/// Bytes that a row of an answer may have.
const ROW: u64 = 256;
/// A supported node may be off its place by this share of the largest displacement.
const OFF: f64 = 1e-6;

/// The unknowns of the answer in a folder; in words why there are none.
pub(super) fn read(folder: &Path, discrete: &Discrete) -> Result<Vec<f64>, String> {
    let (displacement, unknowns) = (folder.join(DISPLACEMENT), folder.join(UNKNOWNS));
    match (displacement.exists(), unknowns.exists()) {
        (true, true) => Err(format!("it left both {DISPLACEMENT} and {UNKNOWNS}; which is the answer?")),
        (false, false) => {
            Err(format!("it ended well but left no answer: neither {DISPLACEMENT} nor {UNKNOWNS} is there"))
        }
        (true, false) => from_displacement(&displacement, discrete).map_err(|why| format!("{DISPLACEMENT}: {why}")),
        (false, true) => from_unknowns(&unknowns, discrete).map_err(|why| format!("{UNKNOWNS}: {why}")),
    }
}

fn text_of(path: &Path, rows: usize) -> Result<String, String> {
    let most = ROW * (rows as u64 + 16);
    let bytes = fs::metadata(path).map_err(|e| e.to_string())?.len();
    if bytes > most {
        return Err(format!("it has {bytes} bytes; {rows} rows need no more than {most}"));
    }
    fs::read_to_string(path).map_err(|e| e.to_string())
}

fn from_unknowns(path: &Path, discrete: &Discrete) -> Result<Vec<f64>, String> {
    let n = discrete.qp.matrix.dimension();
    let mut x = read_column(&text_of(path, n)?, n)?;
    if let Some(i) = x.iter().position(|v| !v.is_finite()) {
        return Err(format!("unknown {} is {}", i + 1, x[i]));
    }
    x.iter_mut().zip(&discrete.basis.fixed).filter(|(_, fixed)| **fixed).for_each(|(x, _)| *x = 0.0);
    Ok(x)
}

fn from_displacement(path: &Path, discrete: &Discrete) -> Result<Vec<f64>, String> {
    let nodes = discrete.basis.nodes();
    let u = nodal(&text_of(path, nodes)?, nodes)?;
    let basis = &discrete.basis;
    let homogeneous: Vec<Vec2> = u.iter().enumerate().map(|(i, u)| u - basis.offset(i)).collect();
    let x = basis.coordinates(&homogeneous);
    let largest = u.iter().map(|u| u.amax()).fold(0.0, f64::max);
    let taken = basis.displacement(&x);
    match (0..nodes).find(|&i| (taken[i] - u[i]).amax() > OFF * largest) {
        None => Ok(x),
        Some(i) => Err(format!(
            "node {} moves by ({:e}, {:e}), but its support or a bilateral contact holds it at ({:e}, {:e})",
            i + 1,
            u[i].x,
            u[i].y,
            taken[i].x,
            taken[i].y
        )),
    }
}

/// The displacement of each node; the first line may be a heading.
fn nodal(text: &str, nodes: usize) -> Result<Vec<Vec2>, String> {
    let mut found: Vec<Option<Vec2>> = vec![None; nodes];
    for (k, line) in text.lines().enumerate().filter(|(_, l)| !l.trim().is_empty()) {
        if k == 0 && line.trim_start().starts_with(|c: char| c.is_alphabetic()) {
            continue;
        }
        let (node, u) = row(line).ok_or_else(|| format!("line {}: `{line}` is no `node,ux,uy`", k + 1))?;
        let Some(place) = node.checked_sub(1).and_then(|i| found.get_mut(i)) else {
            return Err(format!("line {}: there is no node {node}; nodes are 1 … {nodes}, as in mesh.msh", k + 1));
        };
        if !(u.x.is_finite() && u.y.is_finite()) {
            return Err(format!("node {node} moves by ({}, {})", u.x, u.y));
        }
        if place.replace(u).is_some() {
            return Err(format!("line {}: node {node} is there twice", k + 1));
        }
    }
    let missing = found.iter().filter(|u| u.is_none()).count();
    match found.iter().position(Option::is_none) {
        None => Ok(found.into_iter().flatten().collect()),
        Some(i) => Err(format!("it is partial: {missing} of {nodes} nodes are missing, the first of them {}", i + 1)),
    }
}

fn row(line: &str) -> Option<(usize, Vec2)> {
    let mut cells = line.split(',').map(str::trim);
    let node = cells.next()?.parse().ok()?;
    let u = Vec2::new(cells.next()?.parse().ok()?, cells.next()?.parse().ok()?);
    cells.next().is_none().then_some((node, u))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_in_any_order_under_a_heading_or_none() {
        let u = nodal("node,ux,uy\n2, 0.5 ,-1e-3\n1,1,2\n\n", 2).unwrap();
        assert_eq!(u, [Vec2::new(1.0, 2.0), Vec2::new(0.5, -1e-3)]);
        assert_eq!(nodal("2,0.5,-1e-3\n1,1,2", 2).unwrap(), u);
    }

    #[test]
    fn a_partial_or_broken_answer_is_refused_by_name() {
        let cases = [
            ("1,1,2\n", "it is partial: 1 of 2 nodes are missing, the first of them 2"),
            ("1,1,2\n1,1,2\n", "line 2: node 1 is there twice"),
            ("1,1,2\n2,nan,0\n", "node 2 moves by (NaN, 0)"),
            ("1,1,2\n2,inf,0\n", "node 2 moves by (inf, 0)"),
            ("0,1,2\n", "line 1: there is no node 0"),
            ("1,1,2\n3,1,2\n", "line 2: there is no node 3; nodes are 1 … 2"),
            ("1,1\n", "line 1: `1,1` is no `node,ux,uy`"),
            ("1,1,2,3\n", "line 1: `1,1,2,3` is no"),
            ("node,ux,uy\nx,1,2\n", "line 2: `x,1,2` is no"),
            ("", "it is partial: 2 of 2"),
        ];
        for (text, expected) in cases {
            let why = nodal(text, 2).unwrap_err();
            assert!(why.starts_with(expected), "{text:?}: {why}");
        }
    }
}
