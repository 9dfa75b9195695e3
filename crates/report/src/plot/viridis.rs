//! The scale that stresses are shown on: viridis, which is even to the eye, in grey, and to who sees few colours.

/// The highest step; steps are even.
pub const STEPS: u8 = 63;

/// Red, green, blue at 17 even places, from low to high.
const PLACES: [[u8; 3]; 17] = [
    [68, 1, 84],
    [72, 24, 106],
    [71, 45, 123],
    [66, 64, 134],
    [59, 82, 139],
    [51, 99, 141],
    [44, 114, 142],
    [38, 130, 142],
    [33, 145, 140],
    [31, 160, 136],
    [40, 174, 128],
    [63, 188, 115],
    [94, 201, 98],
    [132, 212, 75],
    [173, 220, 48],
    [216, 226, 25],
    [253, 231, 37],
];

/// The colour of a step, linear between the places.
pub(crate) fn shade(step: u8) -> [u8; 3] {
    let place = f64::from(step.min(STEPS)) / f64::from(STEPS) * 16.0;
    let below = (place as usize).min(15);
    let share = place - below as f64;
    let mixed = |k: usize| {
        let [a, b] = [PLACES[below][k], PLACES[below + 1][k]].map(f64::from);
        (a + share * (b - a)).round() as u8
    };
    [0, 1, 2].map(mixed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_begins_and_ends_at_its_places_and_grows_lighter() {
        assert_eq!((shade(0), shade(STEPS)), (PLACES[0], PLACES[16]));
        let light = |step: u8| {
            let [r, g, b] = shade(step).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((0..STEPS).all(|k| light(k) < light(k + 1)));
    }
}
