//! `deformed`: both bodies of one level as they are deformed, with the stress of von Mises.

use super::body_chart::{Area, Bar, BodyChart, Stroke, XY, bounds, round_down};
use super::chart::Colour;
use super::mesh::{names, whole, zone_strokes};
use super::viridis;
use crate::format;
use crate::summary::name;
use signorini_study::fields::Fields;
use signorini_study::record::StudyRecord;

/// The largest displacement that is drawn, as a share of the smaller body's extent.
const SEEN: f64 = 0.1;
/// The same where displacements are not magnified.
const LARGE: f64 = 0.5;
/// A stress that so small a share of the area exceeds does not set the scale.
const PEAK: f64 = 0.01;
/// The scale is cut where the largest stress exceeds the rest by this factor.
const EXCEEDS: f64 = 1.6;

/// The deformed bodies, displacements magnified by a round factor, each triangle in the colour of its stress, on the outlines at
/// rest.
pub fn deformed(record: &StudyRecord, fields: &Fields) -> BodyChart {
    let (stretch, stretched) = whole(fields);
    let magnified = Magnified::new(fields, stretch);
    let factor = magnified.factor;
    let scale = Scale::new(fields);
    let (inside, outside) = names(fields, factor);
    let mut strokes: Vec<Stroke> = boundary(fields, 0.0, Colour::Grey, 1.5);
    strokes.extend(boundary(fields, factor, Colour::Black, 1.5));
    let remarks = [Some(magnified.words()), stretched, scale.words()];
    BodyChart {
        title: format!("{}: deformed bodies", name(record)),
        subtitle: vec![record.title.clone(), numbers(fields, factor, scale.highest)],
        areas: shaded(fields, factor, &scale),
        strokes,
        labels: outside,
        names: inside,
        bar: Some(Bar { name: "von Mises stress".into(), top: scale.top, cut: scale.cut() }),
        stretch,
        remarks: vec![remarks.into_iter().flatten().collect::<Vec<_>>().join(" ")],
    }
}

/// `level 3 · displacements × 50, the largest 0.0123 · von Mises stress up to 0.456`
fn numbers(fields: &Fields, factor: f64, highest: f64) -> String {
    let largest = format::significant(largest_displacement(fields), 3);
    let highest = format::significant(highest, 3);
    format!(
        "level {} · displacements × {factor}, the largest {largest} · von Mises stress up to {highest}",
        fields.level
    )
}

fn largest_displacement(fields: &Fields) -> f64 {
    fields.displacement.iter().map(|u| u[0].hypot(u[1])).fold(0.0, f64::max)
}

/// How displacements are magnified.
struct Magnified {
    factor: f64,
    /// Whether bodies were apart, or inside one another, before they were loaded.
    apart: bool,
    /// Whether the outlines at rest show it, as across a gap.
    drawn: bool,
}

impl Magnified {
    fn new(fields: &Fields, stretch: XY) -> Self {
        let extent = smaller_extent(fields, stretch);
        let largest =
            fields.displacement.iter().map(|u| (stretch[0] * u[0]).hypot(stretch[1] * u[1])).fold(0.0, f64::max);
        let apart = largest_gap(fields) > 1e-9 * smaller_extent(fields, [1.0; 2]);
        // magnified displacements would close a gap too far, which is not magnified with them
        let wanted = if apart { (LARGE * extent / largest).min(1.0) } else { SEEN * extent / largest };
        let factor = if wanted.is_finite() && wanted > 0.0 { round_down(wanted) } else { 1.0 };
        Self { factor, apart, drawn: fields.zone.across_gap }
    }

    fn words(&self) -> String {
        let at_rest = "Grey: outlines at rest.";
        match (self.apart, self.drawn, self.factor == 1.0) {
            (false, ..) => at_rest.into(),
            (_, false, _) => {
                format!("{at_rest} The initial gap is not drawn: bodies in contact stand that far from one another.")
            }
            (_, _, true) => format!("{at_rest} Displacements are to scale, so that bodies in contact just touch."),
            _ => format!("{at_rest} Displacements are made smaller and the initial gap is not."),
        }
    }
}

/// The larger side of the rectangle about a body, of the smaller body.
fn smaller_extent(fields: &Fields, stretch: XY) -> f64 {
    let extent = |body: usize| {
        let nodes = fields.triangles_of(body).flat_map(|t| fields.triangles[t]).map(|i| &fields.nodes[i as usize]);
        let [low, high] = bounds(nodes);
        (stretch[0] * (high[0] - low[0])).max(stretch[1] * (high[1] - low[1]))
    };
    extent(0).min(extent(1))
}

/// The largest initial distance, `ε = gap + n·(u' − u'')`, of either sign.
fn largest_gap(fields: &Fields) -> f64 {
    let zone = &fields.zone;
    let gap = |k: usize| {
        let [a, b] = zone.nodes[k].map(|i| fields.displacement[i as usize]);
        let jump: f64 = (0..2).map(|i| zone.normal[k][i] * (a[i] - b[i])).sum();
        (zone.gap[k] + jump).abs()
    };
    (0..zone.s.len()).map(gap).fold(0.0, f64::max)
}

/// Which stress has which colour.
struct Scale {
    top: f64,
    highest: f64,
}

impl Scale {
    fn new(fields: &Fields) -> Self {
        let mut by_stress: Vec<usize> = (0..fields.triangles.len()).collect();
        by_stress.sort_by(|a, b| fields.von_mises[*b].total_cmp(&fields.von_mises[*a]));
        let total: f64 = fields.areas.iter().sum();
        let highest = by_stress.first().map_or(0.0, |t| fields.von_mises[*t]);
        let mut above = 0.0;
        let mut typical = highest;
        for t in by_stress {
            typical = fields.von_mises[t];
            above += fields.areas[t];
            if above > PEAK * total {
                break;
            }
        }
        let top = if highest > EXCEEDS * typical && typical > 0.0 { typical } else { highest };
        Self { top: if top > 0.0 { top } else { 1.0 }, highest }
    }

    fn step(&self, stress: f64) -> u8 {
        let steps = f64::from(viridis::STEPS) + 1.0;
        (steps * stress / self.top).floor().clamp(0.0, f64::from(viridis::STEPS)) as u8
    }

    fn cut(&self) -> bool {
        self.highest > self.top
    }

    fn words(&self) -> Option<String> {
        let [top, highest] = [self.top, self.highest].map(|x| format::significant(x, 3));
        self.cut()
            .then(|| format!("Stresses between {top} and {highest}, on 1 % of the area, have the colour of {top}."))
    }
}

/// The triangles from the lowest stress to the highest, those of one colour together.
fn shaded(fields: &Fields, factor: f64, scale: &Scale) -> Vec<Area> {
    let step = |t: usize| scale.step(fields.von_mises[t]);
    let mut order: Vec<usize> = (0..fields.triangles.len()).collect();
    order.sort_by_key(|t| step(*t));
    let area = |t: usize| Area { outline: fields.outline(t, factor), colour: Colour::Shade(step(t)), strength: 1.0 };
    order.into_iter().map(area).collect()
}

/// The outlines of both bodies, moved by `factor · u_h`.
fn boundary(fields: &Fields, factor: f64, colour: Colour, width: f64) -> Vec<Stroke> {
    let side = |k: usize| -> Vec<XY> { fields.side(fields.side_triangles[k] as usize, fields.sides[k], factor) };
    let sides = (0..fields.sides.len()).map(|k| Stroke { points: side(k), colour, width, strength: 1.0 });
    sides.chain(zone_strokes(fields, colour, width, factor)).collect()
}
