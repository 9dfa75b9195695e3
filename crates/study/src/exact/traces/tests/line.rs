//! On a straight line: the built-in P(3, 2) again.

use super::*;
use crate::exact::verify::{Condition, verify};
use crate::exact::{Exact, Jet2, Polynomial};
use signorini_contact::{Body, Material};

const S: f64 = 0.408_248_290_463_863;

fn as_traces() -> Traces {
    let mut p = traces(&P, &[("s", 1.0 / 6.0f64.sqrt())], [SOFT, STIFF]);
    (p.switches, p.breaks) = (vec![1.0 / 6.0f64.sqrt()], vec![1.0 / 6.0f64.sqrt()]);
    p
}

fn entries(j: &Jet2) -> Vec<f64> {
    let first = j.value.iter().chain(j.gradient.iter().flatten());
    first.chain(j.hessian.iter().flatten().flatten()).copied().collect()
}

#[test]
fn p_by_traces_is_the_built_in_p() {
    let (ours, built) = (as_traces(), Polynomial::new(3.0, 2.0, [SOFT, STIFF]).unwrap());
    for i in 0..200 {
        let x = (f64::from(i) + 0.3) / 200.0;
        for height in [0.0, 1e-6, 0.2, 0.5, 0.93, 1.0] {
            for (body, y) in [(Body::First, height), (Body::Second, -height)] {
                let at = Point::new(x, y);
                let all = |e: &dyn Exact| {
                    let (jet, jet2) = (e.jet(body, at), e.jet2(body, at));
                    let mut list: Vec<f64> = e.value(body, at).iter().copied().collect();
                    list.extend(jet.value.iter().chain(jet.gradient.iter().flatten()));
                    list.extend(entries(&jet2));
                    list
                };
                for (a, b) in all(&ours).into_iter().zip(all(&built)) {
                    assert!((a - b).abs() < 1e-13, "{body:?} {at:?}: {a} ≠ {b}");
                }
            }
        }
    }
    assert!((ours.switch_points()[0] - Point::new(S, 0.0)).norm() < 1e-15);
    let (line, expected) = (Exact::break_lines(&ours)[0], Exact::break_lines(&built)[0]);
    assert!((line.a - expected.a).norm() < 1e-15 && (line.b - expected.b).norm() < 1e-15);
}

#[test]
fn the_pointwise_verification_accepts_it_and_refuses_a_flipped_gap() {
    let materials = [SOFT, STIFF].map(|l| Material::lame(l.lambda, l.mu).unwrap());
    let line = signorini_contact::ContactLine::polyline([Point::new(0.0, 0.0), Point::new(1.0, 0.0)]);
    let seen = verify(&as_traces(), &materials, &line).unwrap_or_else(|e| panic!("{e}"));
    assert!(seen.tangential < 1e-14 && seen.reaction < 1e-14, "{seen:?}");

    let flipped = TraceTexts { w: [P.w[1], P.w[0]], ..P };
    let flipped = traces(&flipped, &[("s", 1.0 / 6.0f64.sqrt())], [SOFT, STIFF]);
    assert_eq!(verify(&flipped, &materials, &line).unwrap_err().condition, Condition::NoPenetration);
}
