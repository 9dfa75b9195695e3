use super::*;

fn integrate(c: &Cubature, t: [Point; 3], f: impl Fn(Point) -> f64) -> f64 {
    let mut sum = 0.0;
    c.triangle(t, &mut |x, w| sum += w * f(x));
    sum
}

fn unit() -> [Point; 3] {
    [Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(0.0, 1.0)]
}

fn factorial(n: u32) -> f64 {
    (1..=n).map(f64::from).product()
}

#[test]
fn monomials_to_degree_five_are_exact_and_degree_six_is_not() {
    // ∫ x^p y^q over the unit triangle = p! q! / (p+q+2)!
    let error = |p: u32, q: u32| {
        let exact = factorial(p) * factorial(q) / factorial(p + q + 2);
        (integrate(&Cubature::default(), unit(), |x| x.x.powi(p as i32) * x.y.powi(q as i32)) - exact).abs()
    };
    for p in 0..=5 {
        for q in 0..=5 - p {
            assert!(error(p, q) < 1e-16, "x^{p} y^{q}: {}", error(p, q));
        }
    }
    assert!(error(6, 0) > 1e-6);
}

#[test]
fn sixteen_points_are_exact_to_degree_eight() {
    let error = |p: u32, q: u32| {
        let mut sum = 0.0;
        sixteen_points(unit(), &mut |x, w| sum += w * x.x.powi(p as i32) * x.y.powi(q as i32));
        (sum - factorial(p) * factorial(q) / factorial(p + q + 2)).abs()
    };
    for p in 0..=8 {
        for q in 0..=8 - p {
            assert!(error(p, q) < 1e-16, "x^{p} y^{q}: {}", error(p, q));
        }
    }
    assert!(error(9, 0) > 1e-9, "{}", error(9, 0));
}

#[test]
fn the_conical_product_is_exact_to_degree_ten() {
    let error = |p: u32, q: u32| {
        let mut sum = 0.0;
        conical_points(unit(), &mut |x, w| sum += w * x.x.powi(p as i32) * x.y.powi(q as i32));
        (sum - factorial(p) * factorial(q) / factorial(p + q + 2)).abs()
    };
    for p in 0..=10 {
        for q in 0..=10 - p {
            assert!(error(p, q) < 1e-15, "x^{p} y^{q}: {}", error(p, q));
        }
    }
    assert!(error(6, 7) > 1e-15, "degree 13 is beyond the rule: {}", error(6, 7));
}

/// A rule that calls back with points and weights.
type Rule<'a> = &'a dyn Fn(&mut dyn FnMut(Point, f64));

/// Largest error of a rule on the monomials of a degree, on the unit triangle.
fn worst(rule: Rule, degree: u32) -> f64 {
    let error = |p: u32| {
        let (q, mut sum) = (degree - p, 0.0);
        rule(&mut |x, w| sum += w * x.x.powi(p as i32) * x.y.powi(q as i32));
        (sum - factorial(p) * factorial(q) / factorial(degree + 2)).abs()
    };
    (0..=degree).map(error).fold(0.0, f64::max)
}

#[test]
fn rules_are_exact_to_their_degree_and_no_further() {
    let three: Rule = &|visit| three_points(unit(), &mut |x, w| visit(x, w));
    let six: Rule = &|visit| six_points(unit(), &mut |x, w| visit(x, w));
    for (rule, degree, beyond) in [(three, 2, 1e-4), (six, 4, 1e-5)] {
        for d in 0..=degree {
            assert!(worst(rule, d) < 1e-15, "degree {d} of {degree}: {:e}", worst(rule, d));
        }
        assert!(worst(rule, degree + 1) > beyond, "{:e}", worst(rule, degree + 1));
    }
}

#[test]
fn sides_are_exact_to_degree_nine() {
    let (a, b) = (Point::new(1.0, 2.0), Point::new(4.0, 6.0));
    for p in 0..=10 {
        let mut sum = 0.0;
        Cubature::default().side(a, b, &mut |x, w| sum += w * ((x.x - 1.0) / 3.0).powi(p));
        let error = (sum - 5.0 / f64::from(p + 1)).abs();
        assert_eq!(error < 1e-13, p < 10, "degree {p}: {error}");
    }
}

#[test]
fn gauss_rules_are_exact_to_their_degree_and_no_further() {
    for (rule, beyond) in [(GAUSS_4.as_slice(), 1e-5), (&GAUSS_6, 1e-8), (&GAUSS_8, 1e-11)] {
        let error = |p: u32| {
            let sum: f64 = rule.iter().map(|&(x, w)| w * x.powi(p as i32)).sum();
            (sum - 1.0 / f64::from(p + 1)).abs()
        };
        let first = 2 * rule.len() as u32;
        (0..first).for_each(|p| assert!(error(p) < 2e-16, "{first}, degree {p}: {:e}", error(p)));
        assert!(error(first) > beyond, "degree {first}: {:e}", error(first));
    }
}

#[test]
fn a_kink_on_a_declared_line_costs_nothing() {
    let s = 0.3;
    let cut = Segment { a: Point::new(s, -1.0), b: Point::new(s, 1.0) };
    let c = Cubature { breaks: vec![cut], ..Default::default() };
    // ∫ (x−s)_+ over the unit triangle = (1−s)³/6.
    let f = |x: Point| (x.x - s).max(0.0);
    let exact = (1.0_f64 - s).powi(3) / 6.0;
    assert!((integrate(&c, unit(), f) - exact).abs() < 1e-16);
    assert!((integrate(&Cubature::default(), unit(), f) - exact).abs() > 1e-5);
    let mut sum = 0.0;
    c.side(unit()[0], unit()[1], &mut |x, w| sum += w * f(x));
    assert!((sum - 0.5 * (1.0 - s) * (1.0 - s)).abs() < 1e-16);
}

#[test]
fn grading_integrates_a_singularity_inside_and_reports_its_error() {
    // ∫ r^{-1/2} over the square (−1,1)² cut into two triangles, singular point on their common diagonal.
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Point::new(x, y));
    let f = |x: Point| x.norm().powf(-0.5);
    let over = |c: &Cubature| {
        integrate(c, [square[0], square[1], square[2]], f) + integrate(c, [square[0], square[2], square[3]], f)
    };
    // 8 ∫_0^{π/4} ∫_0^{1/cos θ} r^{1/2} dr dθ = (16/3) ∫_0^{π/4} cos^{-3/2} θ dθ by a fine midpoint rule.
    let n = 200_000;
    let step = std::f64::consts::FRAC_PI_4 / f64::from(n);
    let exact: f64 = (0..n).map(|i| ((f64::from(i) + 0.5) * step).cos().powf(-1.5) * step).sum::<f64>() * 16.0 / 3.0;
    let graded = Cubature { singular: vec![Point::zeros()], ..Default::default() };
    let error = (over(&graded) - exact).abs();
    assert!(error < 1e-5, "{error}");
    let estimate = (over(&graded) - over(&graded.finer())).abs();
    assert!(error < 3.0 * estimate + 1e-9, "{error} against the estimate {estimate}");
    assert!((over(&Cubature::default()) - exact).abs() > 1e-2, "a fixed rule must be visibly worse");
}

#[test]
fn weights_sum_to_the_area_however_it_is_cut() {
    let c = Cubature {
        singular: vec![Point::new(0.2, 0.1)],
        breaks: vec![Segment { a: Point::new(-1.0, 0.35), b: Point::new(2.0, 0.1) }],
        depth: 1,
        ..Default::default()
    };
    let error = (integrate(&c, unit(), |_| 1.0) - 0.5).abs();
    assert!(error < 1e-13, "{error:e}");
}

/// A mesh node that stands for a singular point misses it by rounding: no point of the rule may fall on it.
#[test]
fn a_singular_point_next_to_the_end_of_a_piece_is_the_end() {
    let piece = crate::geometry::Piece::Straight(Segment { a: Point::new(0.55, 0.2), b: Point::new(0.577, 0.2) });
    let end = piece.point(1.0);
    let singular = Point::new(end.x - 1.2e-15, 0.2);
    let rule = Cubature { singular: vec![singular], ..Default::default() };
    let (mut sum, mut nearest) = (0.0, f64::INFINITY);
    rule.along(&piece, &mut |t, weight| {
        sum += weight;
        nearest = f64::min(nearest, (piece.point(t) - singular).norm());
    });
    assert!((sum - 1.0).abs() < 1e-13 && nearest > 0.0, "{sum} {nearest:e}");
}
