//! From tokens to the tree, by recursive descent.

use super::ExprError;
use super::functions::{CONSTANTS, Callable, FUNCTIONS};
use super::lexer::{Token, tokens};
use super::nearest::nearest;
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

/// Names and calls.
impl Parser<'_> {
    fn name(&mut self, name: &str) -> Parsed<Node> {
        let node = if let Some(i) = self.variables.iter().position(|v| *v == name) {
            Node::Variable(i)
        } else if let Some(value) = self.parameters.get(name) {
            Node::Constant(*value)
        } else if let Some((_, value)) = CONSTANTS.iter().find(|(n, _)| *n == name) {
            Node::Constant(*value)
        } else {
            return Err(self.unknown_name(name));
        };
        self.at += 1;
        Ok(node)
    }

    fn unknown_name(&self, name: &str) -> ExprError {
        if FUNCTIONS.iter().any(|(f, _)| *f == name) {
            return self.wrong(format!("`{name}` is a function; its arguments follow in parentheses"));
        }
        if matches!(name, "and" | "or" | "not") {
            return self.wrong(format!("`{name}` stands where a number is expected"));
        }
        let known: Vec<&str> = self.known_names();
        let hint = match nearest(name, known.iter().copied()) {
            Some(meant) => format!("did you mean `{meant}`? "),
            None => String::new(),
        };
        self.wrong(format!("unknown name `{name}`; {hint}known here: {}", known.join(", ")))
    }

    fn known_names(&self) -> Vec<&str> {
        let parameters = self.parameters.keys().map(String::as_str);
        let constants = CONSTANTS.iter().map(|(n, _)| *n);
        self.variables.iter().copied().chain(parameters).chain(constants).collect()
    }

    fn call(&mut self, name: &str) -> Parsed<Item> {
        let Some(&(_, callable)) = FUNCTIONS.iter().find(|(f, _)| *f == name) else {
            return Err(self.unknown_function(name));
        };
        let start = self.column();
        self.at += 1;
        let open = self.column();
        self.at += 1;
        let arguments = self.nested(|p| p.arguments(open))?;
        let (fewest, most) = callable.arity();
        if arguments.len() < fewest || arguments.len() > most {
            return Err(
                self.wrong_at(start, format!("`{name}` takes {}, found {}", wanted(fewest, most), arguments.len()))
            );
        }
        self.apply(callable, arguments)
    }

    fn unknown_function(&self, name: &str) -> ExprError {
        if self.known_names().contains(&name) {
            return self.wrong(format!("`{name}` is not a function; to multiply write `{name}*(…)`"));
        }
        let names = FUNCTIONS.iter().map(|(f, _)| *f);
        let hint = match nearest(name, names.clone()) {
            Some(meant) => format!("did you mean `{meant}`? "),
            None => String::new(),
        };
        let list: Vec<&str> = names.collect();
        self.wrong(format!("unknown function `{name}`; {hint}known: {}", list.join(", ")))
    }

    /// The arguments up to and with the closing parenthesis, each with its column.
    fn arguments(&mut self, open: usize) -> Parsed<Vec<(Item, usize)>> {
        let mut all = Vec::new();
        if self.is_symbol(")") {
            self.at += 1;
            return Ok(all);
        }
        loop {
            let column = self.column();
            all.push((self.condition()?, column));
            if !self.is_symbol(",") {
                self.close(open)?;
                return Ok(all);
            }
            self.at += 1;
        }
    }

    fn apply(&self, callable: Callable, arguments: Vec<(Item, usize)>) -> Parsed<Item> {
        let mut arguments = arguments.into_iter();
        let mut condition = None;
        if callable == Callable::Choice
            && let Some((item, column)) = arguments.next()
        {
            condition = Some(self.truth_of(item, column)?);
        }
        let numbers = arguments.map(|(item, column)| self.number_of(item, column)).collect::<Parsed<Vec<Node>>>()?;
        Ok(Item::Number(applied(callable, condition, numbers)))
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

fn applied(callable: Callable, condition: Option<Condition>, mut numbers: Vec<Node>) -> Node {
    let constant = condition.is_none() && numbers.iter().all(|n| n.constant().is_some());
    let node = match (callable, condition) {
        (Callable::Minimum, _) => Node::Minimum(numbers),
        (Callable::Maximum, _) => Node::Maximum(numbers),
        (Callable::Unary(f), _) => Node::Apply(f, Box::new(numbers.remove(0))),
        (_, condition) => {
            let a = numbers.remove(0);
            let b = numbers.remove(0);
            match (callable, condition) {
                (_, Some(c)) => Node::If(Box::new(c), Box::new(a), Box::new(b)),
                (Callable::Power, None) => return raised(a, b),
                _ => Node::Atan2(Box::new(a), Box::new(b)),
            }
        }
    };
    folded(node, constant)
}

fn raised(base: Node, exponent: Node) -> Node {
    let constant = base.constant().is_some() && exponent.constant().is_some();
    folded(Node::Power(Box::new(base), Box::new(exponent)), constant)
}

/// A node whose operands are constants becomes a constant.
fn folded(node: Node, constant: bool) -> Node {
    if constant { Node::Constant(node.eval::<f64>(&[])) } else { node }
}

fn wanted(fewest: usize, most: usize) -> String {
    match (fewest, most) {
        (1, 1) => "1 argument".to_string(),
        (n, m) if n == m => format!("{n} arguments"),
        (n, _) => format!("at least {n} arguments"),
    }
}

fn describe(token: &Token) -> String {
    match token {
        Token::Number(value) => format!("the number {value}"),
        Token::Name(name) => format!("`{name}`"),
        Token::Symbol(symbol) => format!("`{symbol}`"),
        Token::End => "the end".to_string(),
    }
}
