//! Bytes changed at random: a file is read or refused, and nothing panics.

use super::super::body::BodyMesh;
use super::super::chain::{rows, straight};
use super::super::zone::{Faces, zone};
use super::encode::binary;
use super::*;
use crate::sample::Noise;

fn mangle(bytes: &[u8], noise: &mut Noise) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..1 + (4.0 * noise.uniform()) as usize {
        let at = (noise.uniform() * bytes.len() as f64) as usize;
        match (noise.uniform() * 4.0) as usize {
            0 => bytes[at] = (noise.uniform() * 256.0) as u8,
            1 => bytes[at] = b"0123456789-. \n$"[(noise.uniform() * 15.0) as usize],
            2 => _ = bytes.remove(at),
            _ => bytes.truncate(at.max(bytes.len() / 2)),
        }
    }
    bytes
}

fn everything(bytes: &[u8]) -> bool {
    let Ok(msh) = Msh::read(bytes) else { return false };
    let bodies = ["upper", "lower"].map(|name| BodyMesh::new(&msh, name));
    let [Ok(mut upper), Ok(lower)] = bodies else { return false };
    if let Ok(sides) = upper.sides(&msh, "upper:top") {
        rows(&sides).iter().for_each(|row| drop(straight(&mut upper, row)));
    }
    let faces = [Faces { groups: ["upper:contact".into(), "lower:contact".into()], curve: None }];
    zone(&msh, &mut [upper, lower], &faces).is_ok()
}

#[test]
fn mangled_files_are_read_or_refused() {
    let text = squares(2);
    let originals = [text.clone().into_bytes(), binary(&text, false), binary(&text, true)];
    assert!(originals.iter().all(|o| everything(o)));
    let mut noise = Noise::new(5);
    let read = (0..3000).filter(|k| everything(&mangle(&originals[k % 3], &mut noise))).count();
    assert!((10..2000).contains(&read), "{read}");
}
