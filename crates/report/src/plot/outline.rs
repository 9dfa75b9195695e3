//! The boundary of a body as one closed line, so that it can be filled as a whole and not triangle by triangle.

use super::body_chart::XY;
use signorini_study::fields::Fields;
use std::collections::BTreeMap;

/// The outline of `Ω'` (0) or `Ω''` (1) at rest, counterclockwise; none where the boundary is not one closed line: a body of two pieces, or
/// with a hole.
pub(super) fn outline(fields: &Fields, body: usize) -> Option<Vec<XY>> {
    let sides = sides(fields, body);
    let next: BTreeMap<u32, ([u32; 2], u32)> = sides.iter().map(|side| (side.0[0], *side)).collect();
    let start = sides.first()?.0[0];
    let (mut at, mut walked, mut line) = (start, 0, Vec::new());
    loop {
        let (ends, triangle) = next.get(&at)?;
        let mut points = fields.side(*triangle as usize, *ends, 0.0);
        points.pop();
        line.extend(points);
        (at, walked) = (ends[1], walked + 1);
        if at == start || walked > sides.len() {
            break;
        }
    }
    (walked == sides.len()).then_some(line)
}

/// The sides of the body's boundary, the body on the left, with their triangles.
fn sides(fields: &Fields, body: usize) -> Vec<([u32; 2], u32)> {
    let own = |t: &u32| fields.body(*t as usize).index() == body;
    let outside = fields.sides.iter().copied().zip(fields.side_triangles.iter().copied()).filter(|(_, t)| own(t));
    let zone = &fields.zone;
    let inside = zone.sides.iter().zip(&zone.side_triangles).map(|(side, triangles)| {
        let [a, b] = side.map(|i| zone.nodes[i as usize][body]);
        // the zone runs with Ω' on its left
        (if body == 0 { [a, b] } else { [b, a] }, triangles[body])
    });
    outside.chain(inside).collect()
}
