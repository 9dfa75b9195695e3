//! From text to tokens with columns.

use super::ExprError;

/// One token.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// A finite number.
    Number(f64),
    /// A name: a letter or `_`, then letters, digits and `_`.
    Name(String),
    /// An operator, parenthesis or comma.
    Symbol(&'static str),
    /// The end of the text.
    End,
}

/// Longer symbols first, so that `<=` is not read as `<`.
const SYMBOLS: [&str; 14] = ["<=", ">=", "==", "!=", "<", ">", "+", "-", "*", "/", "^", "(", ")", ","];

/// The tokens with their columns (characters from 1); the last one is [`Token::End`].
pub(super) fn tokens(text: &str) -> Result<Vec<(Token, usize)>, ExprError> {
    let chars: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        if chars[at].is_whitespace() {
            at += 1;
            continue;
        }
        let (token, length) =
            next(&chars[at..]).map_err(|message| ExprError { message, column: at + 1, text: text.to_string() })?;
        found.push((token, at + 1));
        at += length;
    }
    found.push((Token::End, chars.len() + 1));
    Ok(found)
}

/// The token that `rest` starts with and its length.
fn next(rest: &[char]) -> Result<(Token, usize), String> {
    let first = rest[0];
    if first.is_ascii_digit() || first == '.' {
        number(rest)
    } else if first.is_alphabetic() || first == '_' {
        let length = count(rest, |c| c.is_alphanumeric() || c == '_');
        Ok((Token::Name(rest[..length].iter().collect()), length))
    } else {
        symbol(rest)
    }
}

fn symbol(rest: &[char]) -> Result<(Token, usize), String> {
    for s in SYMBOLS {
        if s.chars().eq(rest.iter().copied().take(s.len())) {
            return Ok((Token::Symbol(s), s.len()));
        }
    }
    Err(match rest[0] {
        '=' => "`=` assigns nothing here; equality is `==`".to_string(),
        '&' | '|' | '!' => format!("unexpected `{}`; write `and`, `or`, `not`", rest[0]),
        '[' | ']' | '{' | '}' => {
            format!("unexpected `{}`; only round parentheses group", rest[0])
        }
        c => format!("unexpected character `{}`", c.escape_debug()),
    })
}

/// Digits with at most one point, then an optional exponent `e±digits`.
fn number(rest: &[char]) -> Result<(Token, usize), String> {
    let mut length = count(rest, |c| c.is_ascii_digit() || c == '.');
    if matches!(rest.get(length), Some('e' | 'E')) {
        let sign = usize::from(matches!(rest.get(length + 1), Some('+' | '-')));
        let digits = count(&rest[length + 1 + sign..], |c| c.is_ascii_digit());
        if digits > 0 {
            length += 1 + sign + digits;
        }
    }
    let text: String = rest[..length].iter().collect();
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok((Token::Number(value), length)),
        Ok(_) => Err(format!("the number {text} is too large")),
        Err(_) => Err(format!("`{text}` is not a number")),
    }
}

fn count(rest: &[char], keep: impl Fn(char) -> bool) -> usize {
    rest.iter().take_while(|&&c| keep(c)).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_names_and_symbols_keep_their_columns() {
        let read = tokens("1e-3<=x_1 *.5").unwrap();
        assert_eq!(
            read,
            [
                (Token::Number(1e-3), 1),
                (Token::Symbol("<="), 5),
                (Token::Name("x_1".into()), 7),
                (Token::Symbol("*"), 11),
                (Token::Number(0.5), 12),
                (Token::End, 14),
            ]
        );
    }

    #[test]
    fn malformed_tokens_are_named() {
        for (text, column, part) in [
            ("1.2.3", 1, "not a number"),
            ("x + 1e999", 5, "too large"),
            ("x = 1", 3, "=="),
            ("x && y", 3, "and"),
            ("é·2", 2, "·"),
        ] {
            let error = tokens(text).unwrap_err();
            assert_eq!(error.column, column, "{error}");
            assert!(error.message.contains(part), "{error}");
        }
    }
}
