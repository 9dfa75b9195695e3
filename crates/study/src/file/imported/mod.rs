//! Bodies, boundary parts and contact zone out of a mesh file: physical surfaces and curves by name.

use super::boundary::body_of;
use super::curve::Curves;
use super::error::{Fault, refuse};
use super::layer::Layer;
use super::raw::{RawBody, RawBoundary, RawMesh};
use super::spanned::Spanned;
use crate::msh::body::{BodyMesh, lower_first};
use crate::msh::chain::{along, rows, straight};
use crate::msh::zone::{Faces, zone};
use crate::msh::{Msh, MshError};
use crate::study::{Part, Shape};
use signorini_contact::geometry::{Path, SharedCurve};
use signorini_contact::{Body, ContactLine};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

mod parts;
mod plan;

pub use plan::{check_levels, family};

/// What a mesh file and the study's names for it make together.
pub struct Geometry {
    pub bodies: [Shape; 2],
    pub parts: Vec<Part>,
    pub contact: ContactLine,
}

/// The geometry of a scene whose mesh comes from a file.
pub fn geometry(raw: &RawMesh, layer: &Layer<'_>, curves: &Curves, place: Range<usize>) -> Result<Geometry, Fault> {
    let file = File { raw, msh: Msh::read(&raw.content).map_err(|e| fault(raw, raw.file.span(), e))? };
    let of_body = |b: &Spanned<RawBody>| file.body(b.get_ref());
    let [first, second] = layer.body.unwrap_or_default() else {
        return refuse(place, "a mesh file needs two tables [[body]]", "name a `physical` surface of the file in each");
    };
    let mut bodies = [of_body(first)?, of_body(second)?];
    let names = [first, second].map(|b| b.get_ref().name.get_ref().as_str());
    let mut groups = Vec::new();
    for boundary in layer.boundary.unwrap_or_default() {
        groups.push(file.group(boundary, names, &bodies, curves)?);
    }
    let (path, span) = file.zone(layer, curves, &mut bodies, place)?;
    file.check_covered(&bodies, &groups, &path, span)?;
    // curves first: their ends are corners of the straight parts
    let mut paths: Vec<Vec<Path>> = vec![Vec::new(); groups.len()];
    for curved in [true, false] {
        for (group, found) in groups.iter().zip(&mut paths).filter(|(g, _)| g.curve.is_some() == curved) {
            *found = file.paths(group, &mut bodies[group.body.index()])?;
        }
    }
    let parts = parts::parts(&groups, &paths, layer)?;
    let shape = |b: usize| Shape {
        name: names[b].to_string(),
        blocks: Vec::new(),
        imported: Some(Arc::new(parts::imported(&bodies[b], Body::BOTH[b], &parts, &path.path))),
    };
    Ok(Geometry { bodies: [shape(0), shape(1)], parts, contact: ContactLine::Common(path.path) })
}

/// A boundary part: its sides in rows, and the curve that it follows.
struct Group<'a> {
    raw: &'a RawBoundary,
    body: Body,
    sides: Vec<[u32; 2]>,
    curve: Option<(String, SharedCurve)>,
}

/// The zone and the sides that lie on it, by body.
struct Zone {
    path: Path,
    sides: [Vec<[u32; 2]>; 2],
}

struct File<'a> {
    raw: &'a RawMesh,
    msh: Msh,
}

fn fault(raw: &RawMesh, span: Range<usize>, error: MshError) -> Fault {
    Fault::new(span, format!("{}: {error}", raw.file.get_ref()), error.next)
}

impl File<'_> {
    fn body(&self, raw: &RawBody) -> Result<BodyMesh, Fault> {
        let other = raw.rectangle.as_ref().map(|r| r.span()).or(raw.blocks.as_ref().map(|b| b.span()));
        if let Some(span) = other.or(raw.divisions.as_ref().map(|d| d.span())) {
            return refuse(
                span,
                "a body beside [mesh] is made of the file's triangles",
                "leave this out, and [mesh] in if it is meant",
            );
        }
        let Some(physical) = &raw.physical else {
            let message =
                format!("body `{}` does not say which physical surface of the file it is", raw.name.get_ref());
            return refuse(raw.name.span(), message, "add `physical = \"…\"`");
        };
        BodyMesh::new(&self.msh, physical.get_ref()).map_err(|e| fault(self.raw, physical.span(), e))
    }

    fn group<'b>(
        &self,
        raw: &'b RawBoundary,
        names: [&str; 2],
        bodies: &[BodyMesh; 2],
        curves: &Curves,
    ) -> Result<Group<'b>, Fault> {
        let body = body_of(&raw.body, names)?;
        if let Some(along) = &raw.along {
            let next = "name the physical curve instead: `physical = \"…\"`";
            return refuse(along.span(), "a boundary part beside [mesh] is a physical curve of the file", next);
        }
        let Some(physical) = &raw.physical else {
            let message =
                format!("boundary `{}` does not say which physical curve of the file it is", raw.name.get_ref());
            return refuse(raw.name.span(), message, "add `physical = \"…\"`");
        };
        let sides = bodies[body.index()].sides(&self.msh, physical.get_ref());
        let sides = sides.map_err(|e| fault(self.raw, physical.span(), e))?;
        if let Some(extra) = raw.curves.get(1) {
            let next = "let each physical curve follow one curve of the study; make two parts of it";
            return refuse(extra.span(), format!("{} curves for one physical curve", raw.curves.len()), next);
        }
        Ok(Group { raw, body, sides, curve: named(raw.curves.first(), curves)? })
    }

    fn zone(
        &self,
        layer: &Layer<'_>,
        curves: &Curves,
        bodies: &mut [BodyMesh; 2],
        place: Range<usize>,
    ) -> Result<(Zone, Range<usize>), Fault> {
        const NAME: &str = "name the faces, of the first body and of the second: `physical = [[\"…\", \"…\"]]`";
        let Some(raw) = layer.contact else { return refuse(place, "no [contact]: the two bodies never meet", NAME) };
        let Some(physical) = raw.physical.as_ref().filter(|p| !p.get_ref().is_empty()) else {
            return refuse(place, "[contact] does not say which physical curves of the file meet", NAME);
        };
        if let Some(span) = raw.along.as_ref().map(|a| a.span()).or(raw.gap.as_ref().map(|g| g.span())) {
            return refuse(
                span,
                "`along` and `gap` beside [mesh]: the zone is where the physical curves are",
                "leave it out",
            );
        }
        let pairs = physical.get_ref();
        if let Some(extra) = raw.curves.get(pairs.len()) {
            let message = format!("{} curves for {} pairs of faces", raw.curves.len(), pairs.len());
            return refuse(extra.span(), message, "name at most one curve for each pair; \"\" is straight");
        }
        let mut faces = Vec::new();
        for (k, pair) in pairs.iter().enumerate() {
            let groups = pair.0.each_ref().map(|g| g.get_ref().clone());
            faces.push(Faces { groups, curve: named(raw.curves.get(k), curves)? });
        }
        let found = |e| fault(self.raw, physical.span(), e);
        let path = zone(&self.msh, bodies, &faces).map_err(found)?;
        let sides = |b: usize| {
            let of = |f: &Faces| bodies[b].sides(&self.msh, &f.groups[b]);
            faces.iter().map(of).collect::<Result<Vec<_>, _>>().map(|s| s.concat()).map_err(found)
        };
        Ok((Zone { path, sides: [sides(0)?, sides(1)?] }, physical.span()))
    }

    /// Every boundary side belongs to one group of the study.
    fn check_covered(
        &self,
        bodies: &[BodyMesh; 2],
        groups: &[Group<'_>],
        zone: &Zone,
        span: Range<usize>,
    ) -> Result<(), Fault> {
        for (body, mesh) in Body::BOTH.into_iter().zip(bodies) {
            let mut owners: BTreeMap<[u32; 2], &str> = BTreeMap::new();
            let own = groups.iter().filter(|g| g.body == body);
            let parts = own.map(|g| (g.raw.name.get_ref().as_str(), &g.sides, g.raw.name.span()));
            let all = std::iter::once(("the contact zone", &zone.sides[body.index()], span.clone())).chain(parts);
            for (name, sides, span) in all {
                for side in sides {
                    if let Some(other) = owners.insert(lower_first(*side), name) {
                        let [a, b] = side.map(|n| mesh.at(n));
                        let message = format!("the side from {a} to {b} belongs to {other} and to {name}");
                        return refuse(span, message, "let every side of the boundary be in one group");
                    }
                }
            }
            if let Some([a, b]) = mesh.boundary.keys().find(|side| !owners.contains_key(*side)) {
                let message = format!(
                    "{}: the side of \"{}\" from {} to {} is in no boundary part and not in the contact zone",
                    self.raw.file.get_ref(),
                    mesh.name,
                    mesh.at(*a),
                    mesh.at(*b)
                );
                return refuse(
                    self.raw.file.span(),
                    message,
                    "add it to a physical curve, and name that in a [[boundary]]",
                );
            }
        }
        Ok(())
    }

    fn paths(&self, group: &Group<'_>, body: &mut BodyMesh) -> Result<Vec<Path>, Fault> {
        let path = |row: Vec<u32>| match &group.curve {
            None => Ok(straight(body, &row)),
            Some((name, curve)) => along(body, &row, name, curve),
        };
        let paths: Result<Vec<Path>, MshError> = rows(&group.sides).into_iter().map(path).collect();
        paths.map_err(|e| fault(self.raw, group.raw.name.span(), e))
    }
}

fn named(name: Option<&Spanned<String>>, curves: &Curves) -> Result<Option<(String, SharedCurve)>, Fault> {
    let Some(name) = name else { return Ok(None) };
    Ok(curves.find(name)?.map(|curve| (name.get_ref().clone(), curve)))
}
