//! Rows of sides become boundary parts, and a body what a study knows of it.

use super::super::boundary::condition;
use super::super::error::{Fault, refuse};
use super::super::layer::Layer;
use super::Group;
use crate::msh::body::BodyMesh;
use crate::study::{Imported, Part};
use signorini_contact::geometry::{Path, Piece, right_normal};
use signorini_contact::{Body, Point};

/// A part for each row of sides: `free`, `free (2)`, ….
pub(super) fn parts(groups: &[Group<'_>], paths: &[Vec<Path>], layer: &Layer<'_>) -> Result<Vec<Part>, Fault> {
    let mut parts: Vec<Part> = Vec::new();
    for (group, paths) in groups.iter().zip(paths) {
        let name = group.raw.name.get_ref();
        for (k, path) in paths.iter().enumerate() {
            let name = if k == 0 { name.clone() } else { format!("{name} ({})", k + 1) };
            if parts.iter().any(|p| p.body == group.body && p.name == name) {
                let message = format!("body `{}` has two boundary parts `{name}`", group.raw.body.get_ref());
                return refuse(group.raw.name.span(), message, "rename one of them");
            }
            let condition = condition(group.raw, &layer.parameters)?;
            parts.push(Part { body: group.body, name, along: path.clone(), condition });
        }
    }
    Ok(parts)
}

/// The body with its boundary from corner to corner.
pub(super) fn imported(body: &BodyMesh, which: Body, parts: &[Part], zone: &Path) -> Imported {
    let own = || parts.iter().filter(move |p| p.body == which);
    let paths = || own().map(|p| (p.name.as_str(), &p.along)).chain([("the contact zone", zone)]);
    Imported {
        mesh: body.mesh.clone(),
        boundary: paths().flat_map(|(_, p)| p.pieces().collect::<Vec<Piece>>()).collect(),
        notes: paths().filter_map(|(name, path)| shallow(&body.name, name, path)).collect(),
    }
}

/// Corners that turn by less than 30° one after the other look like a curve that nobody named.
fn shallow(body: &str, name: &str, path: &Path) -> Option<String> {
    let normal = |w: &[Point]| right_normal(w[0], w[1]);
    let turn = |w: &[Point]| normal(&w[..2]).dot(&normal(&w[1..]));
    let count = path.corners.windows(3).filter(|w| turn(w) > 0.75_f64.sqrt()).count();
    (count > 2 && !path.is_curved()).then(|| {
        format!("{name} of \"{body}\" is taken as a polygon with {count} corners of less than 30°; if it is a curve, name that in `curves`")
    })
}
