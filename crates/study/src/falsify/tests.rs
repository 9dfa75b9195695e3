//! Small searches: the same for any number of threads, resumed, reproduced; bent hypotheses are found out.

use super::*;
use crate::store::scratch::Scratch;

#[test]
fn show() {
    let targets: Vec<Target> = Target::CLAIMS.into_iter().chain([Target::Bent]).collect();
    for target in targets {
        for index in 0..10 {
            let d = draw(target, 1, index);
            let text = d.text("draw", &[]);
            let t = std::time::Instant::now();
            let m = measure::measure(target, index, &d.words(), &text);
            eprintln!(
                "{:?} {index} {:.2}s {} | {:?} sound {} settled {} rate {:?} pair {:?} c {:?} slack {:?} | {}",
                target,
                t.elapsed().as_secs_f64(),
                m.scene,
                m.outcome,
                m.sound,
                m.settled,
                m.rate,
                m.smallest_pair,
                m.constant,
                m.slack,
                m.reason
            );
        }
    }
    let _ = Scratch::new("x");
}
