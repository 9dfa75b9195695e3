//! Random scenes: two bodies of one or two blocks each, on a straight or kinked zone, with any supports and loads.

use super::random::Random;
use std::fmt::Write;

/// A study and what can be said of it beforehand.
pub struct Scene {
    /// The study file.
    pub text: String,
    /// Whether the zero displacement respects supports and constraints, so that `L(u_h) ≤ 0`.
    pub zero_is_admissible: bool,
}

/// One random scene, the same for the same random numbers.
pub fn random(random: &mut Random) -> Scene {
    let mut scene = Scene { text: head(random), zero_is_admissible: true };
    let outline = Outline::random(random);
    for (name, blocks) in [("upper", outline.upper()), ("lower", outline.lower())] {
        body(&mut scene.text, name, &blocks, outline.divisions, random);
    }
    for (body, name, along) in outline.parts() {
        part(&mut scene, body, name, &along, random);
    }
    let _ = writeln!(scene.text, "[contact]\nalong = {}", path(&outline.zone));
    initial_gap(&mut scene, random);
    scene
}

fn head(random: &mut Random) -> String {
    let levels = random.pick(&["[1]", "[1, 2]", "[2]", "[3]", "[2, 3]"]);
    let family = random.pick(&["structured", "criss-cross", "union-jack"]);
    let first = random.pick(&["condensed", "monotone"]);
    format!(
        r#"id = "random"
title = "random"
question = "random"
setup = "random"
refuted_by = "random"
claim = "certificate"
family = {{ name = "{family}" }}
levels = {{ quick = {levels}, full = {levels} }}
reference = {{ kind = "none" }}
solver = {{ name = "{first}", second = "interior-point" }}

"#
    )
}

/// The zone from left to right, and how far the bodies reach from it.
struct Outline {
    zone: Vec<[f64; 2]>,
    top: f64,
    bottom: f64,
    /// Both far sides are moved by this along the zone: bodies lean.
    lean: f64,
    divisions: [usize; 2],
}

impl Outline {
    fn random(random: &mut Random) -> Self {
        let width = random.between(0.2, 3.0);
        let kink = [0.0, 0.1, -0.3, 0.8][random.below(4)];
        let middle = [random.between(0.3, 0.7) * width, -kink * width * 0.5];
        let zone = match kink == 0.0 {
            true => vec![[0.0, 0.0], [width, 0.0]],
            false => vec![[0.0, 0.0], middle, [width, 0.0]],
        };
        let height = |random: &mut Random| width * random.between(0.9, 2.0);
        Self {
            zone,
            top: height(random),
            bottom: -height(random),
            lean: width * random.between(-0.4, 0.4),
            divisions: [1 + random.below(2), 1 + random.below(2)],
        }
    }

    fn far(&self, x: f64, y: f64) -> [f64; 2] {
        [x + self.lean, y]
    }

    /// Corners of the blocks, counterclockwise.
    fn upper(&self) -> Vec<[[f64; 2]; 4]> {
        let block = |w: &[[f64; 2]]| [w[0], w[1], self.far(w[1][0], self.top), self.far(w[0][0], self.top)];
        self.zone.windows(2).map(block).collect()
    }

    fn lower(&self) -> Vec<[[f64; 2]; 4]> {
        let block = |w: &[[f64; 2]]| [self.far(w[0][0], self.bottom), self.far(w[1][0], self.bottom), w[1], w[0]];
        self.zone.windows(2).map(block).collect()
    }

    /// Body, name and path of every side outside the zone.
    fn parts(&self) -> Vec<(&'static str, &'static str, Vec<[f64; 2]>)> {
        let (left, right) = (self.zone[0], self.zone[self.zone.len() - 1]);
        let across = |y: f64| self.zone.iter().map(|p| self.far(p[0], y)).collect::<Vec<_>>();
        let side = |from: [f64; 2], y: f64| vec![from, self.far(from[0], y)];
        vec![
            ("upper", "far", across(self.top)),
            ("upper", "left", side(left, self.top)),
            ("upper", "right", side(right, self.top)),
            ("lower", "far", across(self.bottom)),
            ("lower", "left", side(left, self.bottom)),
            ("lower", "right", side(right, self.bottom)),
        ]
    }
}

fn path(points: &[[f64; 2]]) -> String {
    let words: Vec<String> = points.iter().map(|p| format!("[{:?}, {:?}]", p[0], p[1])).collect();
    format!("[{}]", words.join(", "))
}

fn body(text: &mut String, name: &str, blocks: &[[[f64; 2]; 4]], divisions: [usize; 2], random: &mut Random) {
    let young = 10.0_f64.powf(random.between(-4.0, 4.0));
    let poisson = random.pick(&[0.0, 0.3, 0.45, 0.499, -0.5]);
    let _ = writeln!(text, "[[body]]\nname = \"{name}\"\nmaterial = {{ young = {young:?}, poisson = {poisson:?} }}");
    let block = |b: &[[f64; 2]; 4]| format!("{{ corners = {}, divisions = {divisions:?} }}", path(b));
    let _ = writeln!(text, "blocks = [{}]", blocks.iter().map(block).collect::<Vec<_>>().join(", "));
    if random.once_in(3) {
        let _ = writeln!(
            text,
            "force = [\"{:?}\", \"{:?} * (1 + x)\"]",
            random.between(-0.1, 0.1),
            random.between(-1.0, 1.0)
        );
    }
    text.push('\n');
}

fn part(scene: &mut Scene, body: &str, name: &str, along: &[[f64; 2]], random: &mut Random) {
    // the far sides are held more often than the others, or nothing would hold
    let conditions: &[&str] = match name {
        "far" => &["fixed", "fixed", "fixed", "traction", "given"],
        _ => &["free", "free", "sliding", "traction", "fixed"],
    };
    let condition = *random.pick(conditions);
    let word = if condition == "given" { "fixed" } else { condition };
    let _ = writeln!(
        scene.text,
        "[[boundary]]\nbody = \"{body}\"\nname = \"{name}\"\nalong = {}\ncondition = \"{word}\"",
        path(along)
    );
    let (a, b) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
    if condition == "traction" {
        let _ = writeln!(scene.text, "value = [\"{a:?} * ny\", \"{b:?} - 0.5 * x\"]");
    }
    if condition == "given" {
        scene.zero_is_admissible = false;
        let _ = writeln!(scene.text, "value = [\"{:?}\", \"{:?} + 0.01 * x\"]", 0.1 * a, 0.1 * b);
    }
    scene.text.push('\n');
}

fn initial_gap(scene: &mut Scene, random: &mut Random) {
    let size = random.between(0.0, 0.05);
    let gap = match random.below(5) {
        0 => format!("{size:?}"),
        1 => format!("{:?}", -size),
        2 => format!("{size:?} * sin(7 * x)"),
        _ => return,
    };
    scene.zero_is_admissible &= !gap.starts_with('-') && !gap.contains("sin");
    let _ = writeln!(scene.text, "initial_gap = \"{gap}\"");
}
