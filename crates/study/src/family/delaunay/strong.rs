//! Coarse meshes of a body with curved sides that are strongly regular with `β ≤ 2` and whose longest chord bounds every side.

use super::chain::Loop;
use super::score::accept;
use super::wish::Wish;
use super::{outline, refuse};
use signorini_contact::mesh::Triangulation;
use signorini_contact::{Error, Point};

/// A coarse mesh and its boundary.
#[derive(Clone, Debug)]
pub struct Strong {
    /// The boundary with the steps chosen for straight pieces.
    pub outline: Loop,
    /// The mesh.
    pub triangulation: Triangulation,
    /// The shortest and the longest side, chords included.
    pub sides: [f64; 2],
}

/// x
pub fn strongly_regular(outline: &Loop, seed: u64) -> Result<Strong, Error> {
    let Some([_, chord]) = outline.chords() else {
        return refuse("no curved".into());
    };
    let share = std::env::var("SHARE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.7);
    let mut outline = outline.clone();
    for run in outline.runs.iter_mut().filter(|r| r.piece.curve().is_none()) {
        run.steps = (run.piece.length() / (share * chord)).round() as usize;
    }
    let boundary = outline.nodes();
    outline::check(&boundary)?;
    let size = chord / std::f64::consts::SQRT_2;
    let size = move |_: Point| size;
    let wish = Wish::new(&boundary, &size)?;
    let (triangulation, score) = super::search(&wish, seed, 100, [0.85, 1.35], 0.97)?;
    eprintln!("score {score:?}");
    accept(&triangulation, boundary.len(), &score)?;
    let mut sides = [f64::INFINITY, 0.0];
    for t in &triangulation.triangles {
        for k in 0..3 {
            let l = (triangulation.points[t[k] as usize] - triangulation.points[t[(k + 1) % 3] as usize]).norm();
            sides = [l.min(sides[0]), l.max(sides[1])];
        }
    }
    Ok(Strong { outline, triangulation, sides })
}
