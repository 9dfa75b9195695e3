//! Fields as NumPy's `.npy` files (format 1.0), one array each.
//!
//! | file | rows | columns |
//! | --- | --- | --- |
//! | `nodes`, `displacement` | nodes | `x, y` |
//! | `triangles` | triangles | three nodes, from 0, counterclockwise |
//! | `body` | triangles | 1 for `Ω'`, 2 for `Ω''` |
//! | `area`, `von_mises` | triangles | |
//! | `strain`, `stress` | triangles | `11, 22, 12` |
//! | `sides`, `side_part` | boundary sides outside the zone | two nodes; the number of the part in the study |
//! | `s`, `pressure`, `gap`, `status` | points of the contact zone | |
//! | `zone_nodes`, `normal` | points of the contact zone | nodes of `Ω'` and `Ω''`; `x, y` |

use super::Fields;
use super::arrays::Array;

/// The files of a level: name with its ending, contents.
pub fn files(fields: &Fields) -> Vec<(String, Vec<u8>)> {
    arrays(fields).iter().map(|a| (format!("{}.npy", a.name), npy(a))).collect()
}

fn arrays(f: &Fields) -> Vec<Array> {
    let body: Vec<u8> = bodies(f);
    let zone = &f.zone;
    vec![
        Array::new("nodes", &f.nodes),
        Array::new("triangles", &f.triangles),
        Array::new("body", &body),
        Array::new("area", &f.areas),
        Array::new("displacement", &f.displacement),
        Array::new("strain", &f.strain),
        Array::new("stress", &f.stress),
        Array::new("von_mises", &f.von_mises),
        Array::new("sides", &f.sides),
        Array::new("side_part", &f.side_parts),
        Array::new("s", &zone.s),
        Array::new("zone_nodes", &zone.nodes),
        Array::new("normal", &zone.normal),
        Array::new("pressure", &zone.pressure),
        Array::new("gap", &zone.gap),
        Array::new("status", &zone.status),
    ]
}

/// 1 for a triangle of `Ω'`, 2 for one of `Ω''`.
pub(super) fn bodies(f: &Fields) -> Vec<u8> {
    (0..f.triangles.len()).map(|t| f.body(t).index() as u8 + 1).collect()
}

/// Magic number, version, length of the header, header, numbers row by row.
fn npy(array: &Array) -> Vec<u8> {
    let shape = match array.components {
        1 => format!("({},)", array.rows),
        columns => format!("({}, {columns})", array.rows),
    };
    let mut header = format!("{{'descr': '{}', 'fortran_order': False, 'shape': {shape}, }}", array.numpy);
    // with the ten bytes before it, and the end of line, the header fills a multiple of 64 bytes
    let missing = (64 - (10 + header.len() + 1) % 64) % 64;
    header.extend(std::iter::repeat_n(' ', missing));
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(&array.bytes);
    bytes
}
