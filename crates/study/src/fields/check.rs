//! Whether fields that were read fit together, before anything is drawn from them.

use super::Fields;

impl Fields {
    /// What does not fit, in words: lists of other lengths, numbers of nodes that there are not, numbers that are none.
    pub fn check(&self) -> Result<(), String> {
        let (nodes, triangles, zone) = (self.nodes.len(), self.triangles.len(), &self.zone);
        let lengths = [
            ("displacement", self.displacement.len(), nodes),
            ("areas", self.areas.len(), triangles),
            ("strain", self.strain.len(), triangles),
            ("stress", self.stress.len(), triangles),
            ("von_mises", self.von_mises.len(), triangles),
            ("side_triangles", self.side_triangles.len(), self.sides.len()),
            ("side_parts", self.side_parts.len(), self.sides.len()),
            ("zone.nodes", zone.nodes.len(), zone.s.len()),
            ("zone.normal", zone.normal.len(), zone.s.len()),
            ("zone.pressure", zone.pressure.len(), zone.s.len()),
            ("zone.gap", zone.gap.len(), zone.s.len()),
            ("zone.status", zone.status.len(), zone.s.len()),
            ("zone.side_triangles", zone.side_triangles.len(), zone.sides.len()),
        ];
        if let Some((name, found, wanted)) = lengths.into_iter().find(|(_, found, wanted)| found != wanted) {
            return Err(format!("{name} has {found} rows and must have {wanted}"));
        }
        let all = |lists: &[u32], bound: usize| lists.iter().all(|i| (*i as usize) < bound);
        let indices = [
            ("triangles", all(self.triangles.as_flattened(), nodes)),
            ("sides", all(self.sides.as_flattened(), nodes)),
            ("side_triangles", all(&self.side_triangles, triangles)),
            ("side_parts", all(&self.side_parts, self.parts.len())),
            ("zone.nodes", all(zone.nodes.as_flattened(), nodes)),
            ("zone.sides", all(zone.sides.as_flattened(), zone.s.len())),
            ("zone.side_triangles", all(zone.side_triangles.as_flattened(), triangles)),
            ("arcs", self.arcs.iter().all(|a| (a.triangle as usize) < triangles && a.apex < 3)),
        ];
        if let Some((name, _)) = indices.into_iter().find(|(_, sound)| !sound) {
            return Err(format!("{name} names a row that there is not"));
        }
        if self.is_finite() { Ok(()) } else { Err("a number is NaN or infinite".into()) }
    }

    /// Whether all numbers are numbers.
    pub(super) fn is_finite(&self) -> bool {
        let zone = &self.zone;
        let single = [&self.von_mises, &self.areas, &zone.s, &zone.pressure, &zone.gap].into_iter().flatten();
        let arcs = self.arcs.iter().flat_map(|a| a.points.iter().chain(&a.displacement));
        let pairs = self.nodes.iter().chain(&self.displacement).chain(&zone.normal).chain(arcs).flatten();
        let triples = self.strain.iter().chain(&self.stress).flatten();
        single.chain(pairs).chain(triples).all(|x| x.is_finite())
    }
}
