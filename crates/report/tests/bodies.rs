//! Pictures of the bodies: what stands in them, how large their files are, and that a page can take the SVG in.

mod common;

use signorini_report::plot::{self, Colour, HEIGHT, WIDTH, viridis};
use signorini_report::render_with;
use signorini_study::fields::{Condition, FieldPart, Fields, ZoneFields};
use std::collections::BTreeSet;
use std::error::Error;

/// Two unit squares of `n × n` cells, one on the other and `gap` apart, each moved by `u`; stress grows with height.
fn squares(n: usize, gap: f64, u: [[f64; 2]; 2]) -> Fields {
    let at = |k: usize| k as f64 / n as f64;
    let row = n as u32 + 1;
    let (mut nodes, mut triangles, mut displacement) = (Vec::new(), Vec::new(), Vec::new());
    for (body, low) in [(0, gap), (1, -1.0)] {
        let first = nodes.len() as u32;
        for j in 0..=n {
            nodes.extend((0..=n).map(|i| [at(i), low + at(j)]));
            displacement.extend((0..=n).map(|_| u[body]));
        }
        for corner in (0..n as u32).flat_map(|j| (0..n as u32).map(move |i| first + j * row + i)) {
            triangles.push([corner, corner + 1, corner + row + 1]);
            triangles.push([corner, corner + row + 1, corner + row]);
        }
    }
    let von_mises: Vec<f64> = (0..triangles.len()).map(|t| 1.0 + t as f64).collect();
    let upper = row * row;
    let zone_nodes: Vec<[u32; 2]> = (0..row).map(|i| [i, 2 * upper - row + i]).collect();
    let boundary = boundary(&triangles, row);
    let part = |[a, _]: [u32; 2], t: u32| match t < 2 * (n * n) as u32 {
        true => u32::from(nodes[a as usize][1] != gap + 1.0 || a == upper - row),
        false => 2,
    };
    let owner = |i: u32| [2 * i, 2 * (n * n) as u32 + 2 * ((n - 1) * n) as u32 + 2 * i + 1];
    Fields {
        level: 2,
        asked: false,
        bodies: ["upper".into(), "lower".into()],
        areas: vec![0.5 / (n * n) as f64; triangles.len()],
        first_triangles: 2 * n * n,
        arcs: Vec::new(),
        strain: vec![[0.0; 3]; triangles.len()],
        stress: vec![[0.0; 3]; triangles.len()],
        parts: [(0, "top", Condition::Traction), (0, "rest", Condition::Free), (1, "rest", Condition::Fixed)]
            .map(|(body, name, condition)| FieldPart { body, name: name.into(), condition })
            .into(),
        sides: boundary.iter().map(|b| b.0).collect(),
        side_triangles: boundary.iter().map(|b| b.1).collect(),
        side_parts: boundary.iter().map(|(ends, t)| part(*ends, *t)).collect(),
        zone: ZoneFields {
            across_gap: false,
            s: (0..=n).map(at).collect(),
            normal: vec![[0.0, -1.0]; n + 1],
            pressure: vec![0.1; n + 1],
            gap: vec![gap + u[0][1] - u[1][1]; n + 1],
            status: vec![1; n + 1],
            sides: (0..n as u32).map(|i| [i, i + 1]).collect(),
            side_triangles: (0..n as u32).map(owner).collect(),
            nodes: zone_nodes,
        },
        nodes,
        triangles,
        displacement,
        von_mises,
    }
}

/// The sides that belong to one triangle, but for those of the zone: the lowest row of the first body, the highest of the second.
fn boundary(triangles: &[[u32; 3]], row: u32) -> Vec<([u32; 2], u32)> {
    let sides = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let all: BTreeSet<[u32; 2]> = triangles.iter().flat_map(sides).collect();
    let of_zone = |[a, b]: &[u32; 2]| [a, b].into_iter().all(|i| *i < row || *i >= 2 * row * row - row);
    let free = |side: &[u32; 2]| !all.contains(&[side[1], side[0]]) && !of_zone(side);
    let with_owner = |(k, t): (usize, &[u32; 3])| sides(t).map(|side| (side, k as u32));
    triangles.iter().enumerate().flat_map(with_owner).filter(|(side, _)| free(side)).collect()
}

const AT_REST: [[f64; 2]; 2] = [[0.0; 2]; 2];

#[test]
fn the_set_up_names_bodies_parts_and_zone_and_draws_every_side_once() {
    let fields = squares(4, 0.0, AT_REST);
    assert_eq!(fields.check(), Ok(()));
    let chart = plot::mesh(&common::healthy(), &fields);
    let labels: Vec<_> = chart.labels.iter().map(|l| (l.text.as_str(), l.detail.as_str())).collect();
    assert_eq!(
        labels,
        [("Γ_{τ} top", "traction"), ("Γ_{τ} rest", "free"), ("Γ_{u} rest", "fixed"), ("Γ_{K}", "contact zone"),]
    );
    assert_eq!(chart.names.iter().map(|n| n.0.as_str()).collect::<Vec<_>>(), ["Ω′ upper", "Ω″ lower"]);
    // Euler: 25 nodes and 32 triangles of a square have 56 sides, 16 of them on its boundary
    assert_eq!(chart.strokes.len(), 2 * 56 + 2 * 16);
    // each body is one polygon, and its triangles where the boundary does not close
    assert_eq!(chart.areas.iter().map(|a| a.outline.len()).collect::<Vec<_>>(), [16, 16]);
    let mut open = fields.clone();
    open.sides.pop();
    open.side_triangles.pop();
    open.side_parts.pop();
    assert_eq!(plot::mesh(&common::healthy(), &open).areas.len(), 1 + 32);
    assert!(chart.subtitle[1].starts_with("level 2: 64 triangles, 50 nodes, h = "), "{:?}", chart.subtitle);
}

#[test]
fn displacements_are_magnified_by_a_round_factor_that_is_stated() {
    let record = common::healthy();
    let chart = plot::deformed(&record, &squares(2, 0.0, [[0.0, -0.004], [0.0; 2]]));
    // a tenth of a square's side over 0.004 is 25
    assert!(chart.subtitle[1].contains("displacements × 20, the largest 0.00400"), "{:?}", chart.subtitle);
    let lowest = chart.areas.iter().flat_map(|a| &a.outline).map(|p| p[1]).filter(|y| *y > -0.5).fold(1.0, f64::min);
    assert!((lowest + 20.0 * 0.004).abs() < 1e-15, "{lowest}");
    // across a gap a factor would let the bodies overlap
    let mut fields = squares(2, 0.004, [[0.0, -0.004], [0.0; 2]]);
    let closed = plot::deformed(&record, &fields);
    assert!(closed.remarks[0].contains("The initial gap is not drawn"), "{:?}", closed.remarks);
    fields.zone.across_gap = true;
    let closed = plot::deformed(&record, &fields);
    assert!(closed.subtitle[1].contains("displacements × 1,"), "{:?}", closed.subtitle);
    assert!(closed.remarks[0].contains("to scale"), "{:?}", closed.remarks);
}

#[test]
fn colours_follow_the_stress_and_a_peak_does_not_darken_the_rest() {
    let shades = |fields: &Fields| -> Vec<Colour> {
        plot::deformed(&common::healthy(), fields).areas.iter().map(|a| a.colour).collect()
    };
    let mut fields = squares(8, 0.0, AT_REST);
    assert_eq!(shades(&fields).last(), Some(&Colour::Shade(viridis::STEPS)));
    let even = shades(&fields).into_iter().filter(|c| *c == Colour::Shade(0)).count();
    let last = fields.von_mises.len() - 1;
    fields.von_mises[last] = 1e6;
    let chart = plot::deformed(&common::healthy(), &fields);
    assert!(chart.bar.as_ref().is_some_and(|b| b.cut && b.top < 300.0), "{:?}", chart.bar);
    assert!(chart.remarks[0].contains("have the colour of"), "{:?}", chart.remarks);
    assert!(shades(&fields).into_iter().filter(|c| *c == Colour::Shade(0)).count() <= even + 1);
}

#[test]
fn an_svg_is_small_text_is_text_and_a_page_can_recolour_it() -> Result<(), Box<dyn Error>> {
    let fields = squares(28, 0.0, [[0.001, 0.0], [0.0; 2]]);
    assert!(fields.triangles.len() > 3000);
    for chart in [plot::mesh(&common::healthy(), &fields), plot::deformed(&common::healthy(), &fields)] {
        let svg = plot::body_svg(&chart)?;
        assert!(svg.len() < 300_000, "{} bytes", svg.len());
        // one path per colour and a few for labels, not one per triangle
        assert!(svg.matches("<path").count() < 300, "{}", svg.matches("<path").count());
        assert!(svg.contains(">Ω′ upper</text>") && svg.contains("sans-serif"));
        assert!(!svg.contains(" id=") && !svg.contains("<style"), "what two pictures of a page would share");
        // every stroke and fill is the current colour, and what is black or white has its class
        let painted = svg.matches("stroke=\"").count() + svg.matches("fill=\"").count();
        assert_eq!(painted, svg.matches("\"currentColor\"").count() + svg.matches("fill=\"none\"").count());
        for (class, colour) in [("ink", "#141414"), ("paper", "#ffffff")] {
            let with_class = format!("class=\"c-{class}\" color=\"{colour}\"");
            assert_eq!(svg.matches(colour).count(), svg.matches(&with_class).count());
        }
        assert_eq!(svg, plot::body_svg(&chart)?);
        assert_eq!(plot::body_png(&chart)?, plot::body_png(&chart)?);
    }
    Ok(())
}

/// Charts are drawn by the same code into both formats; the vector picture holds every word of the bitmap's.
#[test]
fn charts_keep_their_words_in_svg() -> Result<(), Box<dyn Error>> {
    let chart = plot::rates(&common::healthy()).ok_or("no chart")?;
    let svg = plot::svg(&chart)?;
    for word in [&chart.title, &chart.x_label, &chart.y_label, &chart.curves[0].label] {
        assert!(svg.contains(&format!(">{word}</text>")), "{word}");
    }
    assert!(svg.contains(&format!("width=\"{WIDTH}\" height=\"{HEIGHT}\"")) && svg.trim_end().ends_with("</svg>"));
    Ok(())
}

#[test]
fn thin_bodies_and_extreme_units_are_drawn() -> Result<(), Box<dyn Error>> {
    let dir = common::folder("bodies");
    for (name, scale) in [("slender", [1e3, 1.0]), ("nano", [1e-9; 2]), ("giga", [1e9; 2])] {
        let mut fields = squares(6, 0.0, [[1e-3, -2e-3], [0.0; 2]]);
        for x in fields.nodes.iter_mut().chain(&mut fields.displacement) {
            *x = [x[0] * scale[0], x[1] * scale[1]];
        }
        fields.asked = true;
        let written = render_with(&common::healthy(), &[fields], &dir.join(name))?;
        let names: BTreeSet<String> =
            written.iter().filter_map(|p| Some(p.file_name()?.to_string_lossy().into_owned())).collect();
        for file in ["mesh.png", "mesh.svg", "deformed.png", "deformed.svg", "level-2-mesh.png", "level-2-pressure.svg"]
        {
            assert!(names.contains(file), "{name}: {names:?}");
        }
        let page = std::fs::read_to_string(dir.join(name).join("report.md"))?;
        assert!(page.contains("(mesh.svg)") && page.contains("(deformed.svg)"));
    }
    // without fields the pictures of an earlier run go
    render_with(&common::healthy(), &[], &dir.join("nano"))?;
    assert!(!dir.join("nano/mesh.png").exists() && !dir.join("nano/deformed.svg").exists());
    Ok(())
}
