//! Curves by property: derivatives against differences, foot points against search, lengths against closed forms.

use super::*;
use std::f64::consts::PI;
use std::sync::Arc;

fn parabola() -> Graph {
    // ξ = η²/4 + η³/20 in coordinates turned by 30°
    let function: GraphFn = Arc::new(|y| [y * y / 4.0 + y.powi(3) / 20.0, y / 2.0 + 0.15 * y * y, 0.5 + 0.3 * y]);
    let direction = Vec2::new(0.75f64.sqrt(), 0.5);
    Graph { function, name: "η²/4 + η³/20".into(), direction, from: 1.0, to: -1.0 }
}

fn spline() -> Spline {
    let points = [[0.0, 0.0], [0.4, 0.3], [1.0, 0.2], [1.5, 0.6], [1.6, 1.2]].map(|[x, y]| Point::new(x, y));
    Spline::through(points.to_vec()).unwrap()
}

fn curves() -> Vec<SharedCurve> {
    let arc = CircularArc { centre: Point::new(0.3, -0.2), radius: 1.5, from: 0.4, to: 2.9 };
    let clockwise = CircularArc { from: 3.5, to: 2.2, ..arc };
    vec![Arc::new(arc), Arc::new(clockwise), Arc::new(parabola()), Arc::new(spline())]
}

#[test]
fn derivatives_are_those_of_differences() {
    let step = 1e-5;
    for curve in curves() {
        for s in [0.03, 0.21, 0.5, 0.77, 0.96] {
            let [d1, d2] = curve.derivatives(s);
            let (left, middle, right) = (curve.point(s - step), curve.point(s), curve.point(s + step));
            assert!((d1 - (right - left) / (2.0 * step)).norm() < 1e-8 * d1.norm(), "{}", curve.describe());
            assert!((d2 - (left - 2.0 * middle + right) / (step * step)).norm() < 1e-4 * (1.0 + d2.norm()));
        }
    }
}

#[test]
fn the_foot_of_a_point_beside_the_curve_is_where_it_was_dropped_from() {
    for curve in curves() {
        for s in [0.0, 0.004, 0.31, 0.5, 0.87, 1.0] {
            for height in [-0.02, 0.0, 0.05] {
                let found = curve.foot(curve.point(s) + height * curve.normal(s));
                assert!((found - s).abs() < 1e-12, "{}: {found} for {s}", curve.describe());
            }
        }
    }
}

#[test]
fn a_circle_has_its_curvature_length_and_outward_normal() {
    let arc = CircularArc { centre: Point::new(1.0, 2.0), radius: 0.5, from: 0.0, to: 0.5 * PI };
    assert!((arc.curvature(0.3) - 2.0).abs() < 1e-14);
    assert!((arc.normal(0.0) - Vec2::x()).norm() < 1e-15, "the disc lies on the left");
    assert!((arc_length(&arc, [0.0, 1.0]) - 0.25 * PI).abs() < 1e-15);
    assert!((arc_length(&arc, [1.0, 0.5]) + 0.125 * PI).abs() < 1e-15);
    let clockwise = CircularArc { from: 0.5 * PI, to: 0.0, ..arc };
    assert!((clockwise.curvature(0.3) + 2.0).abs() < 1e-14 && (clockwise.normal(1.0) + Vec2::x()).norm() < 1e-15);
}

#[test]
fn the_parameter_of_a_graph_is_affine_in_eta() {
    let graph = parabola();
    let eta = tangent_of(graph.direction);
    for s in [0.0, 0.25, 0.6, 1.0] {
        assert!((graph.point(s).dot(&eta) - (1.0 - 2.0 * s)).abs() < 1e-15);
    }
}

#[test]
fn a_spline_passes_through_its_points_and_is_straight_on_a_line() {
    let curve = spline();
    assert_eq!((curve.point(0.0), curve.point(1.0)), (Point::new(0.0, 0.0), Point::new(1.6, 1.2)));
    assert!((curve.point(curve.foot(Point::new(1.0, 0.2))) - Point::new(1.0, 0.2)).norm() < 1e-14);
    // γ'' is continuous across the knots and vanishes at the ends
    assert!(curve.derivatives(0.0)[1].norm() < 1e-14 && curve.derivatives(1.0)[1].norm() < 1e-12);
    let line = Spline::through(vec![Point::new(0.0, 0.0), Point::new(1.0, 2.0), Point::new(3.0, 6.0)]).unwrap();
    assert!((line.point(0.7) - 0.7 * Point::new(3.0, 6.0)).norm() < 1e-15);
    assert!(Spline::through(vec![Point::zeros(); 2]).unwrap_err().to_string().contains("points 0 and 1"));
}

#[test]
fn a_path_takes_the_part_of_its_curve_between_its_corners() {
    let circle: SharedCurve = Arc::new(CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: PI });
    let (a, b) = (circle.point(0.75), circle.point(0.25));
    let path = Path { corners: vec![Point::new(-2.0, 0.0), a, b], curves: vec![None, Some(circle)] };
    let pieces: Vec<Piece> = path.pieces().collect();
    assert!(matches!(pieces[0], Piece::Straight(_)) && (pieces[1].length() - 0.5 * PI).abs() < 1e-14);
    assert!((pieces[1].point(0.5) - Point::new(0.0, 1.0)).norm() < 1e-15);
    // from left to right over the top, the normal to the right points inward
    assert!((pieces[1].normal(0.5) + Vec2::y()).norm() < 1e-15);
    assert!((pieces[1].distance(Point::new(0.0, 1.25)) - 0.25).abs() < 1e-15);
}

#[test]
fn across_a_gap_the_conormals_are_forces_per_width() {
    let graph = |c: f64, from: f64| -> SharedCurve {
        let function: GraphFn = Arc::new(move |y| [c * y * y, 2.0 * c * y, 2.0 * c]);
        Arc::new(Graph { function, name: format!("{c} η²"), direction: Vec2::x(), from, to: -from })
    };
    // Ω'' given in the other direction than Ω'
    let line = ContactLine::Gap { curves: [graph(0.25, 1.0), graph(-0.15, -1.0)], direction: Vec2::x() };
    let pieces = line.pieces();
    let point = LinePoint::new([&pieces[0][0], &pieces[0][1]], line.direction(), 0.2);
    // η = 0.6: F' = 0.3, F'' = −0.18
    assert!((point.at[0] - Point::new(0.09, 0.6)).norm() < 1e-15);
    assert!((point.at[1] - Point::new(-0.054, 0.6)).norm() < 1e-15);
    assert!((point.gap - 0.144).abs() < 1e-15 && (point.measure - 2.0).abs() < 1e-15);
    assert!((point.conormals[0] - Vec2::new(-1.0, 0.3)).norm() < 1e-14);
    assert!((point.conormals[1] - Vec2::new(1.0, 0.18)).norm() < 1e-14);
    assert_eq!(point.normal, Vec2::new(-1.0, 0.0));
}
