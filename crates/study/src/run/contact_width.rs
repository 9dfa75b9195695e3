//! The measure of a discrete contact set, with the switch points placed inside their sides.
//!
//! ```text
//!   gap^{2/3}                      /  o3      On a smooth boundary the gap opens like s^{3/2}, so
//!                              /   o2         its power 2/3 is a straight line in s. The line through
//!                          /                  the second and third open node says where it starts:
//!   ────●────────●─────x────○────○────○──     the first one is still bent by the last active node.
//!    active   active  switch o1               The switch stays between ● and o1.
//! ```

use signorini_contact::zone::Zone;

/// The zone, side by side.
pub struct Sides<'a> {
    /// Where the ends of the sides find their constraint.
    pub zone: &'a Zone,
    /// The measure of each side.
    pub length: Vec<f64>,
    /// Whether the two ends are active.
    pub active: &'a [[bool; 2]],
    /// The discrete gap at the two ends.
    pub gap: Vec<[f64; 2]>,
}

impl Sides<'_> {
    /// The measure of the contact set: sides with two active ends, and the shares of those with one.
    pub fn contact(&self) -> f64 {
        (0..self.length.len()).map(|side| self.share(side) * self.length[side]).sum()
    }

    fn share(&self, side: usize) -> f64 {
        match self.active[side] {
            [true, true] => 1.0,
            [false, false] => 0.0,
            // half a side where too few open nodes follow: every node owns its half sides
            [_, open_last] => self.share_by_gaps(side, !open_last).unwrap_or(0.5),
        }
    }

    /// The active share of a side from the gaps at the next two nodes beyond its open end, which is the last one if
    /// `forward`.
    fn share_by_gaps(&self, side: usize, forward: bool) -> Option<f64> {
        let second = self.beyond(side, forward)?;
        let third = self.beyond(second, forward)?;
        let far = usize::from(forward);
        let [q2, q3] = [second, third].map(|s| self.gap[s][far].max(0.0).powf(2.0 / 3.0));
        // distance of the line's zero from the second open node, back towards the active one
        let back = (q3 > q2).then(|| q2 * self.length[third] / (q3 - q2))?;
        Some((1.0 + (self.length[second] - back) / self.length[side]).clamp(0.0, 1.0))
    }

    /// The next side in a direction, if it is open and no corner lies between.
    fn beyond(&self, side: usize, forward: bool) -> Option<usize> {
        let next = if forward { side + 1 } else { side.checked_sub(1)? };
        let [before, after] = if forward { [side, next] } else { [next, side] };
        let ends = &self.zone.side_ends;
        let joined = ends.get(after).is_some_and(|e| e[0] == ends[before][1]);
        (joined && self.active[next] == [false, false]).then_some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sides of length 1 whose nodes are pairs 0, 1, 2, …; the gap is `(s − switch)^{3/2}` beyond the switch, and 99 at the
    /// first open node, which must not matter.
    fn width(count: usize, switch: f64, mirrored: bool) -> f64 {
        let at = |i: usize| if mirrored { count as f64 - i as f64 } else { i as f64 };
        let is_active = |i: usize| at(i) < switch;
        let gap = |i: usize| match at(i) - switch {
            s if s <= 0.0 => 0.0,
            s if s < 1.0 => 99.0,
            s => s.powf(1.5),
        };
        let side_ends = (0..count).map(|i| [(i, 0), (i + 1, 0)]).collect();
        let active: Vec<[bool; 2]> = (0..count).map(|i| [is_active(i), is_active(i + 1)]).collect();
        let zone = Zone { side_ends, ..Zone::default() };
        let gap = (0..count).map(|i| [gap(i), gap(i + 1)]).collect();
        Sides { zone: &zone, length: vec![1.0; count], active: &active, gap }.contact()
    }

    #[test]
    fn a_switch_point_is_found_inside_its_side_from_either_end() {
        for mirrored in [false, true] {
            for switch in [0.4, 2.1, 2.5, 2.99, 5.3] {
                assert!((width(8, switch, mirrored) - switch).abs() < 1e-12, "{switch} {mirrored}");
            }
        }
    }

    #[test]
    fn with_fewer_than_three_open_nodes_it_is_the_middle() {
        assert_eq!(width(8, 6.2, false), 6.5);
        assert_eq!(width(8, 7.9, true), 7.5);
        assert_eq!(width(8, 9.0, false), 8.0);
        assert_eq!(width(8, -1.0, false), 0.0);
    }

    #[test]
    fn a_corner_of_the_zone_breaks_the_line() {
        let zone = Zone { side_ends: vec![[(0, 0), (1, 0)], [(1, 1), (2, 0)], [(2, 0), (3, 0)]], ..Zone::default() };
        let active = [[true, false], [false, false], [false, false]];
        let gap = vec![[0.0, 0.1], [0.1, 2.0], [2.0, 4.0]];
        assert_eq!(Sides { zone: &zone, length: vec![1.0; 3], active: &active, gap }.contact(), 0.5);
    }
}
