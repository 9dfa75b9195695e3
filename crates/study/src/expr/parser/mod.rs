//! From tokens to the tree, by recursive descent.

mod calls;

use super::ExprError;
use super::build::folded;
use super::lexer::{Token, tokens};
use super::tree::{Condition, Node, Relation};
use std::collections::BTreeMap;

/// How deep parentheses, signs and powers may nest.
const DEEPEST: usize = 64;

const RELATIONS: [(&str, Relation); 6] = [
    ("<", Relation::Less),
    ("<=", Relation::LessEqual),
    (">", Relation::Greater),
    (">=", Relation::GreaterEqual),
    ("==", Relation::Equal),
    ("!=", Relation::NotEqual),
];

/// The tree of `text`, which must be one number-valued expression.
pub(super) fn parse(text: &str, variables: &[&str], parameters: &BTreeMap<String, f64>) -> Result<Node, ExprError> {
    let mut parser = Parser { text, tokens: tokens(text)?, at: 0, depth: 0, variables, parameters };
    let node = parser.number()?;
    match parser.peek().clone() {
        Token::End => Ok(node),
        Token::Symbol(")") => Err(parser.wrong("`)` closes no parenthesis; remove it or add the `(` it belongs to")),
        token => Err(parser
            .wrong(format!("{} follows a complete expression; an operator such as `*` is missing", describe(&token)))),
    }
}

/// What a piece of text means.
enum Item {
    Number(Node),
    Truth(Condition),
}

struct Parser<'a> {
    text: &'a str,
    tokens: Vec<(Token, usize)>,
    at: usize,
    depth: usize,
    variables: &'a [&'a str],
    parameters: &'a BTreeMap<String, f64>,
}

type Parsed<T> = Result<T, ExprError>;

/// Conditions.
impl Parser<'_> {
    fn condition(&mut self) -> Parsed<Item> {
        self.joined("or", Self::both, Condition::Any)
    }

    fn both(&mut self) -> Parsed<Item> {
        self.joined("and", Self::negation, Condition::All)
    }

    /// `part { word part }`
    fn joined(
        &mut self,
        word: &str,
        part: fn(&mut Self) -> Parsed<Item>,
        join: fn(Vec<Condition>) -> Condition,
    ) -> Parsed<Item> {
        let column = self.column();
        let first = part(self)?;
        if !self.is_word(word) {
            return Ok(first);
        }
        let mut all = vec![self.truth_of(first, column)?];
        while self.is_word(word) {
            self.at += 1;
            let column = self.column();
            let next = part(self)?;
            all.push(self.truth_of(next, column)?);
        }
        Ok(Item::Truth(join(all)))
    }

    fn negation(&mut self) -> Parsed<Item> {
        if !self.is_word("not") {
            return self.comparison();
        }
        self.at += 1;
        let column = self.column();
        let inner = self.nested(Self::negation)?;
        let inner = self.truth_of(inner, column)?;
        Ok(Item::Truth(Condition::Not(Box::new(inner))))
    }

    fn comparison(&mut self) -> Parsed<Item> {
        let column = self.column();
        let left = self.sum()?;
        let Some(relation) = self.relation() else {
            return Ok(left);
        };
        let left = self.number_of(left, column)?;
        self.at += 1;
        let column = self.column();
        let right = self.sum()?;
        let right = self.number_of(right, column)?;
        if self.relation().is_some() {
            return Err(self.wrong("comparisons do not chain; write `a < b and b < c` in place of `a < b < c`"));
        }
        Ok(Item::Truth(Condition::Compare(relation, left, right)))
    }

    fn relation(&self) -> Option<Relation> {
        let Token::Symbol(symbol) = self.peek() else {
            return None;
        };
        RELATIONS.iter().find(|(s, _)| s == symbol).map(|&(_, relation)| relation)
    }
}

/// Numbers.
impl Parser<'_> {
    fn sum(&mut self) -> Parsed<Item> {
        self.chain("+", "-", Self::term, Node::Sum)
    }

    fn term(&mut self) -> Parsed<Item> {
        self.chain("*", "/", Self::sign, Node::Product)
    }

    /// `part { (plain | inverse) part }`
    fn chain(
        &mut self,
        plain: &str,
        inverse: &str,
        part: fn(&mut Self) -> Parsed<Item>,
        join: fn(Box<Node>, Vec<(bool, Node)>) -> Node,
    ) -> Parsed<Item> {
        let column = self.column();
        let first = part(self)?;
        if !self.is_symbol(plain) && !self.is_symbol(inverse) {
            return Ok(first);
        }
        let first = self.number_of(first, column)?;
        let mut rest = Vec::new();
        while self.is_symbol(plain) || self.is_symbol(inverse) {
            let inverted = self.is_symbol(inverse);
            self.at += 1;
            let column = self.column();
            let next = part(self)?;
            rest.push((inverted, self.number_of(next, column)?));
        }
        let constant = std::iter::once(&first).chain(rest.iter().map(|(_, n)| n)).all(|n| n.constant().is_some());
        Ok(Item::Number(folded(join(Box::new(first), rest), constant)))
    }

    fn sign(&mut self) -> Parsed<Item> {
        let negative = self.is_symbol("-");
        if !negative && !self.is_symbol("+") {
            return self.power();
        }
        self.at += 1;
        let column = self.column();
        let inner = self.nested(Self::sign)?;
        let inner = self.number_of(inner, column)?;
        if !negative {
            return Ok(Item::Number(inner));
        }
        let constant = inner.constant().is_some();
        Ok(Item::Number(folded(Node::Negative(Box::new(inner)), constant)))
    }

    fn power(&mut self) -> Parsed<Item> {
        let column = self.column();
        let base = self.primary()?;
        if !self.is_symbol("^") {
            return Ok(base);
        }
        let base = self.number_of(base, column)?;
        self.at += 1;
        let column = self.column();
        let exponent = self.nested(Self::sign)?;
        let exponent = self.number_of(exponent, column)?;
        Ok(Item::Number(raised(base, exponent)))
    }

    fn primary(&mut self) -> Parsed<Item> {
        match self.peek().clone() {
            Token::Number(value) => {
                self.at += 1;
                Ok(Item::Number(Node::Constant(value)))
            }
            Token::Symbol("(") => {
                let open = self.column();
                self.at += 1;
                let inner = self.nested(Self::condition)?;
                self.close(open)?;
                Ok(inner)
            }
            Token::Name(name) if self.tokens[self.at + 1].0 == Token::Symbol("(") => self.call(&name),
            Token::Name(name) => self.name(&name).map(Item::Number),
            Token::End if self.at == 0 => Err(self.wrong("the expression is empty")),
            token => Err(self.wrong(format!("expected a number, a name or `(`, found {}", describe(&token)))),
        }
    }
}

/// Reading along.
impl Parser<'_> {
    fn number(&mut self) -> Parsed<Node> {
        let column = self.column();
        let item = self.condition()?;
        self.number_of(item, column)
    }

    fn number_of(&self, item: Item, column: usize) -> Parsed<Node> {
        match item {
            Item::Number(node) => Ok(node),
            Item::Truth(_) => Err(self
                .wrong_at(column, "a condition stands where a number is expected; choose with `if(condition, a, b)`")),
        }
    }

    fn truth_of(&self, item: Item, column: usize) -> Parsed<Condition> {
        match item {
            Item::Truth(condition) => Ok(condition),
            Item::Number(_) => {
                Err(self.wrong_at(column, "a number stands where a condition such as `x < 1` is expected"))
            }
        }
    }

    /// Runs `part` one level deeper.
    fn nested<T>(&mut self, part: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth == DEEPEST {
            return Err(self.wrong(format!("nested deeper than {DEEPEST} levels; simplify")));
        }
        self.depth += 1;
        let result = part(self);
        self.depth -= 1;
        result
    }

    fn close(&mut self, open: usize) -> Parsed<()> {
        match self.peek().clone() {
            Token::Symbol(")") => {
                self.at += 1;
                Ok(())
            }
            Token::End => Err(self.wrong_at(open, "this `(` is never closed; a `)` is missing")),
            token => Err(self.wrong(format!("expected `)` or an operator, found {}", describe(&token)))),
        }
    }

    fn peek(&self) -> &Token {
        &self.tokens[self.at].0
    }

    fn column(&self) -> usize {
        self.tokens[self.at].1
    }

    fn is_symbol(&self, symbol: &str) -> bool {
        matches!(self.peek(), Token::Symbol(s) if *s == symbol)
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Token::Name(name) if name == word)
    }

    fn wrong(&self, message: impl Into<String>) -> ExprError {
        self.wrong_at(self.column(), message)
    }

    fn wrong_at(&self, column: usize, message: impl Into<String>) -> ExprError {
        ExprError { message: message.into(), column, text: self.text.to_string() }
    }
}

fn raised(base: Node, exponent: Node) -> Node {
    let constant = base.constant().is_some() && exponent.constant().is_some();
    folded(Node::Power(Box::new(base), Box::new(exponent)), constant)
}

fn describe(token: &Token) -> String {
    match token {
        Token::Number(value) => format!("the number {value}"),
        Token::Name(name) => format!("`{name}`"),
        Token::Symbol(symbol) => format!("`{symbol}`"),
        Token::End => "the end".to_string(),
    }
}
