//! Where labels and triangles find room.

/// Moves positions apart to at least `gap`, each as little as possible (least squares), inside `[low, high]`; keeps
/// their order. Positions are sorted on entry.
pub(crate) fn spread(wanted: &[f64], gap: f64, low: f64, high: f64) -> Vec<f64> {
    // With y_i = p_i − i·gap the condition p_{i+1} ≥ p_i + gap reads y_{i+1} ≥ y_i: pool adjacent violators.
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for (i, p) in wanted.iter().enumerate() {
        pools.push((p - i as f64 * gap, 1));
        while let [.., (before, n), (last, m)] = pools[..]
            && before > last
        {
            let mean = (before * n as f64 + last * m as f64) / (n + m) as f64;
            pools.truncate(pools.len() - 2);
            pools.push((mean, n + m));
        }
    }
    let room = (high - gap * wanted.len().saturating_sub(1) as f64).max(low);
    let flat = pools.iter().flat_map(|&(y, n)| std::iter::repeat_n(y.clamp(low, room), n));
    flat.enumerate().map(|(i, y)| y + i as f64 * gap).collect()
}

/// A rectangle of pixels, `y` downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    /// Left side.
    pub left: f64,
    /// Upper side.
    pub top: f64,
    /// Pixels to the right.
    pub width: f64,
    /// Pixels downwards.
    pub height: f64,
}

impl Rect {
    /// Square of the distance of a point from the rectangle; 0 inside.
    fn squared_distance(&self, (x, y): (f64, f64)) -> f64 {
        let dx = (self.left - x).max(x - self.left - self.width).max(0.0);
        let dy = (self.top - y).max(y - self.top - self.height).max(0.0);
        dx * dx + dy * dy
    }

    /// Points along the sides and inside, at most `step` apart: the rectangle as an obstacle.
    pub fn points(&self, step: f64) -> Vec<(f64, f64)> {
        let along = |length: f64| (length / step).ceil().max(1.0) as usize;
        let (nx, ny) = (along(self.width), along(self.height));
        let grid = (0..=nx).flat_map(|i| (0..=ny).map(move |j| (i as f64 / nx as f64, j as f64 / ny as f64)));
        grid.map(|(s, t)| (self.left + s * self.width, self.top + t * self.height)).collect()
    }
}

/// Points at most `step` apart along a broken line.
pub(crate) fn along(line: &[(f64, f64)], step: f64) -> Vec<(f64, f64)> {
    let mut points = line.to_vec();
    for pair in line.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let n = ((b.0 - a.0).hypot(b.1 - a.1) / step).ceil().max(1.0) as usize;
        points.extend((1..n).map(|i| i as f64 / n as f64).map(|t| (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1))));
    }
    points
}

/// Dashes of that length from one point to another, spaces as long between them; a dash stands at each end.
pub(crate) fn dashes(from: (f64, f64), to: (f64, f64), length: f64) -> Vec<[(f64, f64); 2]> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    // n dashes and n − 1 spaces
    let count = (0.5 * (dx.hypot(dy) / length + 1.0)).round().max(1.0) as usize;
    let pieces = (2 * count - 1) as f64;
    let at = |piece: usize| (from.0 + dx * piece as f64 / pieces, from.1 + dy * piece as f64 / pieces);
    (0..count).map(|i| [at(2 * i), at(2 * i + 1)]).collect()
}

/// Free space asked for around a box.
const CLEAR: f64 = 24.0;
/// Step of the search.
const STEP: f64 = 8.0;

/// A place for a box of `width × height` inside `area`: the one nearest to `near` that is [`CLEAR`] of all
/// `obstacles`, or the clearest if none is.
pub(crate) fn free_place(
    area: Rect,
    (width, height): (f64, f64),
    obstacles: &[(f64, f64)],
    near: &[(f64, f64)],
) -> Rect {
    let count = |room: f64| (room / STEP).max(0.0) as usize;
    let (nx, ny) = (count(area.width - width), count(area.height - height));
    let boxes = (0..=ny).flat_map(|j| (0..=nx).map(move |i| (i, j))).map(|(i, j)| Rect {
        left: area.left + i as f64 * STEP,
        top: area.top + j as f64 * STEP,
        width,
        height,
    });
    let mut best: Option<(f64, Rect)> = None;
    let mut blocker = 0;
    for candidate in boxes {
        let least = best.map_or(f64::INFINITY, |(least, _)| least);
        let score = score(&candidate, obstacles, near, least, &mut blocker);
        if score < least {
            best = Some((score, candidate));
        }
    }
    best.map_or(area, |(_, rect)| rect)
}

/// Scores of boxes that are not clear lie above this one.
const CROWDED: f64 = 1e5;

/// Smaller is better: distance to `near` for a clear box, a large number that falls with the clearance otherwise. Infinite for
/// a box that is seen early to be no better than `least`; what blocked the last box, `blocker`, is asked first, for it mostly
/// blocks the next one.
fn score(rect: &Rect, obstacles: &[(f64, f64)], near: &[(f64, f64)], least: f64, blocker: &mut usize) -> f64 {
    let centre = (rect.left + rect.width / 2.0, rect.top + rect.height / 2.0);
    let reach = || near.iter().map(|p| (p.0 - centre.0).hypot(p.1 - centre.1)).fold(CROWDED, f64::min);
    if least <= CROWDED {
        // a clear box is known: one obstacle too near decides
        let blocks = |obstacle: &(f64, f64)| rect.squared_distance(*obstacle) < CLEAR * CLEAR;
        if obstacles.get(*blocker).is_some_and(blocks) {
            return f64::INFINITY;
        }
        let Some(found) = obstacles.iter().position(blocks) else { return reach() };
        *blocker = found;
        return f64::INFINITY;
    }
    let clearance = obstacles.iter().map(|o| rect.squared_distance(*o)).fold(f64::INFINITY, f64::min).sqrt();
    if clearance < CLEAR { 10.0 * CROWDED - clearance } else { reach() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_moves_no_more_than_needed() {
        assert_eq!(spread(&[10.0, 100.0], 20.0, 0.0, 200.0), [10.0, 100.0]);
        assert_eq!(spread(&[50.0, 50.0], 20.0, 0.0, 200.0), [40.0, 60.0]);
        assert_eq!(spread(&[50.0, 50.0, 65.0], 20.0, 0.0, 200.0), [35.0, 55.0, 75.0]);
        assert_eq!(spread(&[195.0, 198.0], 20.0, 0.0, 200.0), [180.0, 200.0]);
        assert_eq!(spread(&[1.0, 2.0], 20.0, 0.0, 200.0), [0.0, 20.0]);
        assert!(spread(&[], 20.0, 0.0, 1.0).is_empty());
    }

    #[test]
    fn dashes_begin_and_end_at_the_ends() {
        let found = dashes((0.0, 0.0), (30.0, 40.0), 10.0);
        assert_eq!(found.len(), 3);
        assert_eq!((found[0][0], found[2][1]), ((0.0, 0.0), (30.0, 40.0)));
        assert_eq!(found[1], [(12.0, 16.0), (18.0, 24.0)]);
        assert_eq!(dashes((0.0, 0.0), (3.0, 0.0), 10.0), [[(0.0, 0.0), (3.0, 0.0)]]);
    }

    #[test]
    fn a_box_finds_the_free_half() {
        let area = Rect { left: 0.0, top: 0.0, width: 400.0, height: 400.0 };
        let diagonal = along(&[(0.0, 400.0), (400.0, 0.0)], 5.0);
        let place = free_place(area, (100.0, 80.0), &diagonal, &[(200.0, 200.0)]);
        let clearance = diagonal.iter().map(|p| place.squared_distance(*p)).fold(f64::INFINITY, f64::min);
        assert!(clearance >= CLEAR * CLEAR, "{place:?}");
        assert!(place.left >= 0.0 && place.left + place.width <= 400.0);
        let inside = Rect { left: 10.0, top: 10.0, width: 5.0, height: 5.0 };
        assert_eq!(inside.squared_distance((12.0, 12.0)), 0.0);
        assert_eq!(inside.squared_distance((18.0, 19.0)), 25.0);
    }
}
