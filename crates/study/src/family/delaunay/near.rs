//! Which sides of the boundary are near a point: a grid of buckets.

use signorini_contact::Point;
use signorini_contact::geometry::Segment;

/// Most buckets in one direction.
const MOST: f64 = 1024.0;

/// The boundary's sides in buckets by place.
pub(super) struct Near {
    sides: Vec<Segment>,
    origin: Point,
    /// Width of a bucket.
    width: f64,
    /// Buckets in the two directions.
    counts: [usize; 2],
    buckets: Vec<Vec<u32>>,
}

impl Near {
    /// Buckets about as wide as a side is long.
    pub fn new(boundary: &[Point], bounds: [Point; 2]) -> Self {
        let n = boundary.len();
        let sides: Vec<_> = (0..n).map(|k| Segment { a: boundary[k], b: boundary[(k + 1) % n] }).collect();
        let extent = bounds[1] - bounds[0];
        let mean = sides.iter().map(Segment::length).sum::<f64>() / n as f64;
        let width = mean.max(extent.max() / MOST);
        let counts = [extent.x, extent.y].map(|e| (e / width) as usize + 1);
        let buckets = vec![Vec::new(); counts[0] * counts[1]];
        let mut near = Self { sides, origin: bounds[0], width, counts, buckets };
        for k in 0..n {
            let Segment { a, b } = near.sides[k];
            for bucket in near.over(a.inf(&b), a.sup(&b)) {
                near.buckets[bucket].push(k as u32);
            }
        }
        near
    }

    /// Whether a side lies nearer to `x` than `reach`.
    pub fn within(&self, x: Point, reach: f64) -> bool {
        let r = Point::new(reach, reach);
        self.over(x - r, x + r).any(|b| self.buckets[b].iter().any(|&k| self.sides[k as usize].distance(x) < reach))
    }

    /// The buckets that meet a box.
    fn over(&self, low: Point, high: Point) -> impl Iterator<Item = usize> + use<> {
        let index = |x: f64, count: usize| ((x / self.width).max(0.0) as usize).min(count - 1);
        let [from, to] =
            [low - self.origin, high - self.origin].map(|p| [index(p.x, self.counts[0]), index(p.y, self.counts[1])]);
        let across = self.counts[0];
        (from[1]..=to[1]).flat_map(move |j| (from[0]..=to[0]).map(move |i| j * across + i))
    }
}
