//! What triangles give their corners, added up.

use crate::geometry::Vec2;
use crate::mesh::Mesh;
use rayon::prelude::*;
use std::ops::Range;

/// Triangles computed before any is added: enough to keep threads busy, and few enough to stay in the cache.
const CHUNK: usize = 1 << 14;

/// Adds to `nodal` what each triangle of the range gives its three corners, or nothing. Triangles are computed in parallel and
/// added in order, so the sums do not depend on threads.
///
/// # Errors
/// The first in the order of the triangles.
pub(crate) fn scatter<E: Send>(
    mesh: &Mesh,
    triangles: Range<usize>,
    nodal: &mut [Vec2],
    give: impl Fn(usize) -> Result<Option<[Vec2; 3]>, E> + Sync,
) -> Result<(), E> {
    let mut gifts = Vec::with_capacity(CHUNK.min(triangles.len()));
    for start in triangles.clone().step_by(CHUNK) {
        let chunk = start..(start + CHUNK).min(triangles.end);
        chunk.clone().into_par_iter().with_min_len(64).map(&give).collect_into_vec(&mut gifts);
        for (t, gift) in chunk.zip(gifts.drain(..)) {
            let Some(gift) = gift? else { continue };
            mesh.triangles[t].iter().zip(&gift).for_each(|(&i, g)| nodal[i as usize] += g);
        }
    }
    Ok(())
}
