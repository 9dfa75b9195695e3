//! Plain text in LaTeX: what LaTeX reads as commands is escaped, mathematical characters become its own.

/// The text for LaTeX's text mode. `^{…}` and digits below or above the line are set there; a `_` before a single letter
/// or digit makes it an index.
pub fn tex(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        match c {
            '^' if let Some((raised, after)) = rest.strip_prefix('{').and_then(|r| r.split_once('}')) => {
                out += &format!("$^{{\\mathrm{{{}}}}}$", mathematics(raised));
                rest = after;
            }
            '_' if let Some(index) = single(rest) => {
                out += &format!("$_{{{index}}}$");
                rest = &rest[index.len_utf8()..];
            }
            _ => out += &character(c),
        }
    }
    out
}

/// The first character, if it is a letter or digit that stands alone.
fn single(text: &str) -> Option<char> {
    let mut characters = text.chars();
    let first = characters.next().filter(char::is_ascii_alphanumeric)?;
    (!characters.next().is_some_and(|c| c.is_ascii_alphanumeric() || c == '_')).then_some(first)
}

/// The characters of an exponent: letters, digits, `/`, `.`, a minus sign; others are left out.
fn mathematics(text: &str) -> String {
    let plain = text.chars().map(|c| if c == '−' { '-' } else { c });
    plain.filter(|c| c.is_ascii_alphanumeric() || "/.+-".contains(*c)).collect()
}

fn character(c: char) -> String {
    match c {
        '&' | '%' | '#' | '$' | '{' | '}' | '_' => format!("\\{c}"),
        '\\' => r"\textbackslash{}".into(),
        '~' => r"\textasciitilde{}".into(),
        '^' => r"\textasciicircum{}".into(),
        '|' | '<' | '>' => format!("${c}$"),
        '\n' | '\r' => " ".into(),
        ' '..='~' => c.into(),
        _ => beyond_ascii(c),
    }
}

/// Latin letters with accents are LaTeX's own; of others, what has no translation is named by its number.
fn beyond_ascii(c: char) -> String {
    match SYMBOLS.iter().find(|(symbol, _)| *symbol == c) {
        Some((_, words)) => (*words).into(),
        None if ('\u{a1}'..='\u{17f}').contains(&c) && c.is_alphabetic() => c.into(),
        None => format!("[U+{:04X}]", u32::from(c)),
    }
}

const SYMBOLS: [(char, &str); 92] = [
    ('–', "--"),
    ('—', "---"),
    ('…', r"\ldots{}"),
    ('†', r"$\dagger$"),
    ('°', r"$^\circ$"),
    ('·', r"$\cdot$"),
    ('×', r"$\times$"),
    ('±', r"$\pm$"),
    ('−', "$-$"),
    ('½', r"$\frac12$"),
    ('‖', r"$\|$"),
    ('∥', r"$\|$"),
    ('√', r"$\surd$"),
    ('∞', r"$\infty$"),
    ('∂', r"$\partial$"),
    ('∇', r"$\nabla$"),
    ('∫', r"$\int$"),
    ('∩', r"$\cap$"),
    ('∪', r"$\cup$"),
    ('∈', r"$\in$"),
    ('∉', r"$\notin$"),
    ('⊂', r"$\subset$"),
    ('⊃', r"$\supset$"),
    ('⊄', r"$\not\subset$"),
    ('≤', r"$\le$"),
    ('≥', r"$\ge$"),
    ('≠', r"$\ne$"),
    ('≈', r"$\approx$"),
    ('→', r"$\to$"),
    ('△', r"$\triangle$"),
    ('⁰', "$^0$"),
    ('¹', "$^1$"),
    ('²', "$^2$"),
    ('³', "$^3$"),
    ('⁴', "$^4$"),
    ('⁵', "$^5$"),
    ('⁶', "$^6$"),
    ('⁷', "$^7$"),
    ('⁸', "$^8$"),
    ('⁹', "$^9$"),
    ('⁻', "$^-$"),
    ('₀', "$_0$"),
    ('₁', "$_1$"),
    ('₂', "$_2$"),
    ('₊', "$_+$"),
    ('₋', "$_-$"),
    ('ₕ', "$_h$"),
    ('ₙ', "$_n$"),
    ('ᵢ', "$_i$"),
    ('α', r"$\alpha$"),
    ('β', r"$\beta$"),
    ('γ', r"$\gamma$"),
    ('δ', r"$\delta$"),
    ('ε', r"$\varepsilon$"),
    ('ζ', r"$\zeta$"),
    ('η', r"$\eta$"),
    ('θ', r"$\theta$"),
    ('ϑ', r"$\vartheta$"),
    ('ι', r"$\iota$"),
    ('κ', r"$\kappa$"),
    ('λ', r"$\lambda$"),
    ('μ', r"$\mu$"),
    ('ν', r"$\nu$"),
    ('ξ', r"$\xi$"),
    ('ο', "o"),
    ('π', r"$\pi$"),
    ('ρ', r"$\rho$"),
    ('σ', r"$\sigma$"),
    ('ς', r"$\varsigma$"),
    ('τ', r"$\tau$"),
    ('υ', r"$\upsilon$"),
    ('φ', r"$\varphi$"),
    ('χ', r"$\chi$"),
    ('ψ', r"$\psi$"),
    ('ω', r"$\omega$"),
    ('Γ', r"$\Gamma$"),
    ('Δ', r"$\Delta$"),
    ('Θ', r"$\Theta$"),
    ('Λ', r"$\Lambda$"),
    ('Ξ', r"$\Xi$"),
    ('Π', r"$\Pi$"),
    ('Σ', r"$\Sigma$"),
    ('Φ', r"$\Phi$"),
    ('Ψ', r"$\Psi$"),
    ('Ω', r"$\Omega$"),
    ('“', "``"),
    ('”', "''"),
    ('‘', "`"),
    ('’', "'"),
    ('\u{a0}', "~"),
    ('\u{2009}', r"\,"),
    ('\u{202f}', r"\,"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_becomes_latex() {
        for (text, latex) in [
            ("50 % of a_b & c#d", r"50 \% of a$_{b}$ \& c\#d"),
            ("b_over_h2", r"b\_over\_h2"),
            ("O(h^{3/4})", r"O(h$^{\mathrm{3/4}}$)"),
            ("‖u−uₕ‖₀ ≤ ε", r"$\|$u$-$u$_h$$\|$$_0$ $\le$ $\varepsilon$"),
            (r"\input{x}~^", r"\textbackslash{}input\{x\}\textasciitilde{}\textasciicircum{}"),
            ("Hlaváček < |x|", r"Hlaváček $<$ $|$x$|$"),
            ("two\nlines", "two lines"),
            ("漢", "[U+6F22]"),
        ] {
            assert_eq!(tex(text), latex);
        }
    }
}
