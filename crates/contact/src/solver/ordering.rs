//! Elimination order: approximate minimum degree, with chosen unknowns last.

use super::compress::{Numbering, REMOVED};
use crate::sparse::BlockMatrix;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// The order in which the kept unknowns are eliminated: those outside `trailing` by approximate minimum degree on the
/// graph of the nodes (both components of a node side by side), then `trailing` as given.
///
/// Returns reduced numbers, `order[step] = unknown`.
pub fn elimination_order(matrix: &BlockMatrix, numbering: &Numbering, trailing: &[u32]) -> Vec<usize> {
    let leading = leading_numbers(numbering, trailing);
    let nodes: Vec<usize> =
        (0..matrix.rows()).filter(|&i| leading[2 * i] != REMOVED || leading[2 * i + 1] != REMOVED).collect();
    let reduced = |full: u32| numbering.reduced[full as usize] as usize;
    minimum_degree(matrix, &nodes)
        .into_iter()
        .flat_map(|step| [leading[2 * nodes[step]], leading[2 * nodes[step] + 1]])
        .filter(|&number| number != REMOVED)
        .map(|number| number as usize)
        .chain(trailing.iter().map(|&full| reduced(full)))
        .collect()
}

/// The reduced numbers with those of `trailing` taken out.
fn leading_numbers(numbering: &Numbering, trailing: &[u32]) -> Vec<u32> {
    let mut leading = numbering.reduced.clone();
    for &full in trailing {
        leading[full as usize] = REMOVED;
    }
    leading
}

/// Approximate minimum degree on the graph of the given nodes.
fn minimum_degree(matrix: &BlockMatrix, nodes: &[usize]) -> Vec<usize> {
    let (column_start, rows) = node_graph(matrix, nodes);
    let n = nodes.len();
    let graph = SymbolicSparseColMatRef::new_checked(n, n, &column_start, None, &rows);
    let (mut order, mut inverse) = (vec![0; n], vec![0; n]);
    let mut memory = MemBuffer::new(amd::order_maybe_unsorted_scratch::<usize>(n, rows.len()));
    amd::order_maybe_unsorted(&mut order, &mut inverse, graph, amd::Control::default(), MemStack::new(&mut memory))
        .expect("the graph of a mesh that fits in memory has fewer than 2^63 edges");
    order
}

/// The block pattern restricted to the given nodes, as compressed columns.
fn node_graph(matrix: &BlockMatrix, nodes: &[usize]) -> (Vec<usize>, Vec<usize>) {
    let mut number = vec![REMOVED; matrix.rows()];
    for (k, &i) in nodes.iter().enumerate() {
        number[i] = k as u32;
    }
    let mut column_start = vec![0];
    let mut rows = Vec::with_capacity(matrix.entries());
    for &i in nodes {
        let neighbours = matrix.row(i).map(|(j, _)| number[j]);
        rows.extend(neighbours.filter(|&k| k != REMOVED).map(|k| k as usize));
        column_start.push(rows.len());
    }
    (column_start, rows)
}
