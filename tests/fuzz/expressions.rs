//! Random expressions: sentences of the grammar, and spoilt ones.

use super::random::Random;

const NAMES: [&str; 8] = ["x", "y", "s", "pi", "e", "z", "sin", "1e-3"];
const FUNCTIONS: [&str; 12] = ["sin", "cos", "exp", "log", "sqrt", "abs", "pos", "sign", "atan2", "min", "max", "if"];
const OPERATORS: [&str; 8] = ["+", "-", "*", "/", "^", "<", "and", "=="];
const PIECES: [&str; 14] = ["(", ")", ",", "^", "-", "--", "1e999", ".", "e", "not", "\u{3bb}", "\0", "if(", "<="];

/// An expression that is often sound.
pub fn random(random: &mut Random) -> String {
    let text = sentence(random, 5);
    if random.once_in(2) { text } else { spoilt(&text, random) }
}

fn sentence(random: &mut Random, depth: usize) -> String {
    let inner = |random: &mut Random| sentence(random, depth.saturating_sub(1));
    match if depth == 0 { 0 } else { random.below(5) } {
        0 => random.pick(&NAMES).to_string(),
        1 => format!("{:?}", random.between(-10.0, 10.0)),
        2 => format!("{} {} {}", inner(random), random.pick(&OPERATORS), inner(random)),
        3 => format!("({})", inner(random)),
        _ => {
            let name = *random.pick(&FUNCTIONS);
            let (a, b) = (inner(random), inner(random));
            match name {
                "if" => format!("if({a} < {b}, {a}, {b})"),
                "min" | "max" | "atan2" => format!("{name}({a}, {b})"),
                _ => format!("{name}({a})"),
            }
        }
    }
}

/// A piece put in, taken out, or repeated.
fn spoilt(text: &str, random: &mut Random) -> String {
    let mut chars: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(3) {
        let at = random.below(chars.len() + 1);
        match random.below(3) {
            0 => drop(chars.splice(at..at, random.pick(&PIECES).chars())),
            1 => drop(chars.drain(at..(at + random.below(4)).min(chars.len()))),
            _ => {
                let copy: Vec<char> = chars[at..(at + random.below(20)).min(chars.len())].to_vec();
                chars.splice(at..at, copy);
            }
        }
    }
    chars.into_iter().collect()
}
