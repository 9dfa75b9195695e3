//! The rules: nodes and weights on one triangle and on one side.

use crate::geometry::{Point, twice_area};

/// The 3-point rule of degree 2 with its points inside the triangle.
pub fn three_points(t: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let area = 0.5 * twice_area(t[0], t[1], t[2]).abs();
    let centroid = (t[0] + t[1] + t[2]) / 3.0;
    for corner in t {
        visit(0.5 * (centroid + corner), area / 3.0);
    }
}

/// The 6-point rule of degree 4 (Cowper 1973): two orbits, with closed forms in `√10`.
pub fn six_points(t: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let area = 0.5 * twice_area(t[0], t[1], t[2]).abs();
    let centroid = (t[0] + t[1] + t[2]) / 3.0;
    for (a, w) in
        [(0.445_948_490_915_964_9, 0.223_381_589_678_011_47), (0.091_576_213_509_770_74, 0.109_951_743_655_321_87)]
    {
        for corner in t {
            visit(centroid + (1.0 - 3.0 * a) * (corner - centroid), w * area);
        }
    }
}

/// The 7-point rule of degree 5 (Radon 1948): the centroid and two orbits at `(6 ∓ √15)/21`.
pub fn seven_points(t: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let area = 0.5 * twice_area(t[0], t[1], t[2]).abs();
    let centroid = (t[0] + t[1] + t[2]) / 3.0;
    visit(centroid, 9.0 / 40.0 * area);
    let root = f64::sqrt(15.0);
    for (a, w) in [((6.0 - root) / 21.0, (155.0 - root) / 1200.0), ((6.0 + root) / 21.0, (155.0 + root) / 1200.0)] {
        // Barycentric (1−2a, a, a) = centroid + (1−3a)(corner − centroid).
        for corner in t {
            visit(centroid + (1.0 - 3.0 * a) * (corner - centroid), w * area);
        }
    }
}

/// The 16-point rule of degree 8 (Dunavant 1985): the centroid, three orbits of three points and one of six, its digits from
/// the ten symmetric moment equations.
pub fn sixteen_points(t: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let area = 0.5 * twice_area(t[0], t[1], t[2]).abs();
    let centroid = (t[0] + t[1] + t[2]) / 3.0;
    visit(centroid, 0.144_315_607_677_787_17 * area);
    for (a, w) in [
        (0.459_292_588_292_723_2, 0.095_091_634_267_284_62),
        (0.170_569_307_751_760_2, 0.103_217_370_534_718_25),
        (0.050_547_228_317_030_98, 0.032_458_497_623_198_08),
    ] {
        for corner in t {
            visit(centroid + (1.0 - 3.0 * a) * (corner - centroid), w * area);
        }
    }
    let (a, b, w) = (0.008_394_777_409_957_605, 0.263_112_829_634_638_1, 0.027_230_314_174_434_994);
    for (i, j) in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)] {
        let k = 3 - i - j;
        visit(a * t[i] + b * t[j] + (1.0 - a - b) * t[k], w * area);
    }
}

/// The conical product of two Gauss–Legendre rules of 6 points, exact to degree 10: for integrands that one rule of
/// degree 5 does not resolve. `x = a + s((b − a) + t(c − b))`, Jacobian `2|T| s`.
pub fn conical_points([a, b, c]: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let twice = twice_area(a, b, c).abs();
    for (s, ws) in GAUSS_6 {
        for (t, wt) in GAUSS_6 {
            visit(a + s * ((b - a) + t * (c - b)), twice * s * ws * wt);
        }
    }
}

/// Nodes and weights of the Gauss–Legendre rule of 4 points on `(0, 1)`, exact to degree 7.
pub const GAUSS_4: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_9, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// Nodes and weights of the Gauss–Legendre rule of 6 points on `(0, 1)`, exact to degree 11.
pub const GAUSS_6: [(f64, f64); 6] = [
    (0.033_765_242_898_423_99, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_4, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_3, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

/// The Gauss–Legendre rule of 5 points.
pub(super) fn five_points(a: Point, b: Point, visit: &mut impl FnMut(Point, f64)) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let length = half.norm();
    visit(middle, 128.0 / 225.0 * length);
    let (r, s) = (2.0 * f64::sqrt(10.0 / 7.0), 13.0 * f64::sqrt(70.0));
    for (x, w) in [((5.0 - r).sqrt() / 3.0, (322.0 + s) / 900.0), ((5.0 + r).sqrt() / 3.0, (322.0 - s) / 900.0)] {
        visit(middle - x * half, w * length);
        visit(middle + x * half, w * length);
    }
}

/// Nodes and weights of the Gauss–Legendre rule of 8 points on `(0, 1)`, exact to degree 15.
pub const GAUSS_8: [(f64, f64); 8] = [
    (0.019_855_071_751_231_884, 0.050_614_268_145_188_13),
    (0.101_666_761_293_186_63, 0.111_190_517_226_687_24),
    (0.237_233_795_041_835_5, 0.156_853_322_938_943_64),
    (0.408_282_678_752_175_1, 0.181_341_891_689_181),
    (0.591_717_321_247_825, 0.181_341_891_689_181),
    (0.762_766_204_958_164_5, 0.156_853_322_938_943_64),
    (0.898_333_238_706_813_4, 0.111_190_517_226_687_24),
    (0.980_144_928_248_768_1, 0.050_614_268_145_188_13),
];
