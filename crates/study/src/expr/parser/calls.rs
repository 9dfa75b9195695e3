//! Names and function calls.

use super::super::ExprError;
use super::super::build::folded;
use super::super::functions::{CONSTANTS, Callable, FUNCTIONS};
use super::super::tree::{Condition, Node};
use super::{Item, Parsed, Parser, raised};
use crate::nearest::nearest;

impl Parser<'_> {
    pub(super) fn name(&mut self, name: &str) -> Parsed<Node> {
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

    pub(super) fn call(&mut self, name: &str) -> Parsed<Item> {
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

fn wanted(fewest: usize, most: usize) -> String {
    match (fewest, most) {
        (1, 1) => "1 argument".to_string(),
        (n, m) if n == m => format!("{n} arguments"),
        (n, _) => format!("at least {n} arguments"),
    }
}
