use super::*;
use signorini_contact::geometry::{CircularArc, Piece, Segment, SharedCurve};
use std::sync::Arc;

fn straight(a: [f64; 2], b: [f64; 2], steps: usize) -> Run {
    Run { piece: Piece::Straight(Segment { a: Point::new(a[0], a[1]), b: Point::new(b[0], b[1]) }), steps }
}
fn arc(span: [f64; 2], steps: usize) -> Run {
    let c: SharedCurve = Arc::new(CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: std::f64::consts::FRAC_PI_2 });
    Run { piece: Piece::Curved { curve: c, span }, steps }
}
fn inner(m: usize, s: f64) -> Loop {
    let k = |l: f64| (l / s).round() as usize;
    Loop { runs: vec![straight([0.5, 0.0], [1.0, 0.0], k(0.5)), arc([0.0, 1.0], m), straight([0.0, 1.0], [0.0, 0.5], k(0.5)), straight([0.0, 0.5], [0.5, 0.0], k(0.5_f64.sqrt()))] }
}
fn outer(m: usize, s: f64) -> Loop {
    let k = |l: f64| (l / s).round() as usize;
    Loop { runs: vec![arc([1.0, 0.0], m), straight([1.0, 0.0], [2.0, 0.0], k(1.0)), straight([2.0, 0.0], [2.0, 2.0], k(2.0)), straight([2.0, 2.0], [0.0, 2.0], k(2.0)), straight([0.0, 2.0], [0.0, 1.0], k(1.0))] }
}
fn report(name: &str, points: &[Point], size: &(dyn Fn(Point) -> f64 + Sync), seed: u64) {
    let t = std::time::Instant::now();
    match fill(points, size, seed) {
        Err(e) => println!("{name} seed {seed}: {e}"),
        Ok(m) => {
            let (mut lo, mut hi, mut cot, mut st) = (f64::INFINITY, 0.0_f64, 0.0_f64, 0.0_f64);
            let n = points.len() as u32;
            for t in &m.triangles {
                cot = cot.max(signorini_contact::mesh::quality::largest_cotangent(t.map(|i| m.points[i as usize])));
                for k in 0..3 {
                    let l = (m.points[t[k] as usize] - m.points[t[(k + 1) % 3] as usize]).norm();
                    lo = lo.min(l); hi = hi.max(l);
                    if t[k] >= n || t[(k + 1) % 3] >= n { st = st.max(l) }
                }
            }
            println!("{name} seed {seed}: nodes {} angle {:.2} beta {:.3} inner longest {:.4}  {:.2}s", m.points.len(), f64::atan2(1.0, cot).to_degrees(), hi / lo, st, t.elapsed().as_secs_f64());
        }
    }
}

#[test]
fn explore() {
    for n in [8, 16, 32, 64, 128] {
        let s = 1.0 / n as f64;
        let sq = Loop { runs: vec![straight([0., 0.], [1., 0.], n), straight([1., 0.], [1., 1.], n), straight([1., 1.], [0., 1.], n), straight([0., 1.], [0., 0.], n)] };
        for seed in 0..3 { report(&format!("square {n}"), &sq.nodes(), &|_| s, seed); }
    }
    for m in [6, 8, 12, 24, 48] {
        let c = 2.0 * (std::f64::consts::FRAC_PI_4 / m as f64).sin();
        for seed in 0..2 {
            report(&format!("inner {m}"), &inner(m, c).nodes(), &|_| c, seed);
            report(&format!("outer {m}"), &outer(m, c).nodes(), &|_| c, seed);
        }
    }
}

#[test]
fn explore_strong() {
    for m in 6..=12 {
        let c = 2.0 * (std::f64::consts::FRAC_PI_4 / m as f64).sin();
        for l in [inner(m, c), outer(m, c)] {
            match strongly_regular(&l, 1) {
                Ok(s) => println!("m {m} c {c:.4}: {} nodes, sides / c {:.4} .. {:.4}", s.triangulation.points.len(), s.sides[0] / c, s.sides[1] / c),
                Err(e) => println!("m {m}: {e}"),
            }
        }
    }
}
