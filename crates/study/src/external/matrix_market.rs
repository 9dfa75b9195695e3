//! Matrices and vectors in the exchange format of the Matrix Market: text, indices from 1, numbers that read back to the last bit.

use signorini_contact::basis::Basis;
use signorini_contact::sparse::BlockMatrix;
use std::io::{self, Write};

/// The lower triangle of a symmetric matrix.
pub(super) fn write_symmetric(matrix: &BlockMatrix, to: &mut impl Write) -> io::Result<()> {
    let n = matrix.dimension();
    writeln!(to, "%%MatrixMarket matrix coordinate real symmetric\n{n} {n} {}", lower(matrix).count())?;
    lower(matrix).try_for_each(|(i, j, v)| writeln!(to, "{} {} {v:?}", i + 1, j + 1))
}

/// The entries on and below the diagonal that do not vanish.
fn lower(matrix: &BlockMatrix) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
    let of_block = |i: usize, (j, b): (usize, &[f64; 4])| {
        let b = *b;
        (0..4).map(move |k| (2 * i + k / 2, 2 * j + k % 2, b[k])).filter(|&(i, j, v)| j <= i && v != 0.0)
    };
    (0..matrix.rows()).flat_map(move |i| matrix.row(i).flat_map(move |entry| of_block(i, entry)))
}

/// `T` of `u = T x + u_D`: two rows for each node. Columns of fixed components are empty.
pub(super) fn write_basis(basis: &Basis, to: &mut impl Write) -> io::Result<()> {
    let n = 2 * basis.nodes();
    writeln!(to, "%%MatrixMarket matrix coordinate real general\n{n} {n} {}", entries(basis).count())?;
    entries(basis).try_for_each(|(i, j, v)| writeln!(to, "{} {} {v:?}", i + 1, j + 1))
}

fn entries(basis: &Basis) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
    let of_node = |node: usize| {
        let (slots, n) = basis.slots(node);
        let entry = move |slot: u32, b: [f64; 4], k: usize| (2 * node + k / 2, 2 * slot as usize + k % 2, b[k]);
        slots.into_iter().take(n).flat_map(move |(slot, b)| (0..4).map(move |k| entry(slot, b, k)))
    };
    (0..basis.nodes()).flat_map(of_node).filter(|&(_, j, v)| v != 0.0 && !basis.fixed[j])
}

/// Columns of equal length, one after the other; absent bounds are `inf`.
pub(super) fn write_columns(columns: &[impl AsRef<[f64]>], to: &mut impl Write) -> io::Result<()> {
    let rows = columns.first().map_or(0, |c| c.as_ref().len());
    writeln!(to, "%%MatrixMarket matrix array real general\n{rows} {}", columns.len())?;
    columns.iter().flat_map(|c| c.as_ref()).try_for_each(|v| writeln!(to, "{v:?}"))
}

/// Reads one column in the array format; in words what is wrong otherwise.
pub(super) fn read_column(text: &str, rows: usize) -> Result<Vec<f64>, String> {
    let mut lines = text.lines().enumerate().map(|(k, l)| (k + 1, l.trim()));
    let head = lines.next().map_or("", |(_, l)| l).to_ascii_lowercase();
    if !head.starts_with("%%matrixmarket matrix array real") {
        return Err(format!("line 1 is `{head}` where `%%MatrixMarket matrix array real general` is expected"));
    }
    let mut lines = lines.filter(|(_, l)| !l.is_empty() && !l.starts_with('%'));
    let size = lines.next().map_or("", |(_, l)| l);
    if size.split_whitespace().collect::<Vec<_>>() != [rows.to_string(), "1".into()] {
        return Err(format!("its size is `{size}` where `{rows} 1` is expected, one entry per unknown"));
    }
    let number = |(line, text): (usize, &str)| -> Result<f64, String> {
        text.parse().map_err(|_| format!("line {line}: `{text}` is no number"))
    };
    let values: Vec<f64> = lines.map(number).collect::<Result<_, _>>()?;
    if values.len() != rows {
        return Err(format!("it has {} entries where {rows} are expected", values.len()));
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lower_triangle_is_written_without_its_zeros() {
        let blocks =
            vec![[2.0, 0.5, 0.5, 3.0], [-1.0, 0.0, 0.25, -1.0], [-1.0, 0.25, 0.0, -1.0], [1e-9, 0.0, 0.0, 4.0]];
        let matrix = BlockMatrix::new(vec![0, 2, 4], vec![0, 1, 0, 1], blocks);
        let mut text = Vec::new();
        write_symmetric(&matrix, &mut text).unwrap();
        let expected = "%%MatrixMarket matrix coordinate real symmetric\n4 4 8\n1 1 2.0\n2 1 0.5\n2 2 3.0\n\
                        3 1 -1.0\n3 2 0.25\n4 2 -1.0\n3 3 1e-9\n4 4 4.0\n";
        assert_eq!(String::from_utf8(text).unwrap(), expected);
    }

    #[test]
    fn a_column_reads_back_to_the_last_bit() {
        let column = vec![1.0 / 3.0, -2.5e-310, 0.0, 6e22];
        let mut text = Vec::new();
        write_columns(&[&column], &mut text).unwrap();
        assert_eq!(read_column(&String::from_utf8(text).unwrap(), 4).unwrap(), column);
    }

    #[test]
    fn a_column_that_is_none_is_refused() {
        let of = |text: &str| read_column(text, 2).unwrap_err();
        assert!(of("1\n2\n").starts_with("line 1 is `1` where"), "{}", of("1\n2\n"));
        let head = "%%MatrixMarket matrix array real general\n% made by hand\n";
        assert!(of(&format!("{head}3 1\n1\n2\n3\n")).starts_with("its size is `3 1` where `2 1`"));
        assert!(of(&format!("{head}2 1\n1\n")).starts_with("it has 1 entries"));
        assert!(of(&format!("{head}2 1\n1\ntwo\n")).starts_with("line 5: `two` is no number"));
    }
}
