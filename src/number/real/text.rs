//! Writes and parses expressions as text: `add(mul(x, x), 1)`.
//!
//! A term that is used several times gets a name at its first use: `mul(t := sin_turns(x), t)`.

use super::expr::{Expr, Function, Graph, Term, TermId};
use super::primitive::Primitive;
use std::collections::HashMap;
use std::fmt;
use std::fmt::Write as _;

/// A parse error and its position.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParseError {
    /// Byte offset.
    pub at: usize,
    /// What is wrong.
    pub problem: String,
}

impl Expr {
    /// Writes the expression; the callbacks give the names of variables and functions.
    #[must_use]
    pub fn to_text(
        &self,
        variable: &dyn Fn(u32) -> String,
        function: &dyn Fn(&Function) -> String,
    ) -> String {
        let terms = self.terms();
        let mut uses = vec![0u32; terms.len()];
        for term in terms {
            term.operands().iter().for_each(|id| uses[id.index()] += 1);
        }
        let (names, text) = (HashMap::new(), String::new());
        let mut writer = Writer { terms, uses, variable, function, names, text };
        writer.write(terms.len() - 1);
        writer.text
    }

    /// Parses text; `variable` and `function` resolve names. A function can't have a primitive's
    /// name.
    ///
    /// # Errors
    /// If it is malformed; the error has the position.
    pub fn parse(
        text: &str,
        variable: &dyn Fn(&str) -> Option<u32>,
        function: &dyn Fn(&str) -> Option<Function>,
    ) -> Result<Self, ParseError> {
        let mut reader = Reader {
            text,
            at: 0,
            variable,
            function,
            names: HashMap::new(),
            graph: Graph::default(),
        };
        let last = reader.expression(0)?;
        reader.space();
        if reader.at < text.len() {
            return Err(reader.problem("expected the end of the expression"));
        }
        if last.index() + 1 != reader.graph.terms().len() {
            // Happens only if the whole equals one of its named parts, as in `t := x`.
            return Err(reader.problem("an expression can't be one of its own parts"));
        }
        Ok(reader.graph.into_expr())
    }
}

/// Uses `x` for a single variable, otherwise `x0`, `x1` and so on.
impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let one = self.arity() < 2;
        let variable = |number| if one { "x".to_owned() } else { format!("x{number}") };
        f.write_str(&self.to_text(&variable, &|function| function.name().to_owned()))
    }
}

struct Writer<'a> {
    terms: &'a [Term],
    uses: Vec<u32>,
    variable: &'a dyn Fn(u32) -> String,
    function: &'a dyn Fn(&Function) -> String,
    names: HashMap<usize, String>,
    text: String,
}

impl Writer<'_> {
    fn write(&mut self, index: usize) {
        if let Some(name) = self.names.get(&index) {
            self.text.push_str(name);
            return;
        }
        let term = &self.terms[index];
        if self.uses[index] > 1 && !term.operands().is_empty() {
            let name = format!("t{}", self.names.len());
            let _ = write!(self.text, "{name} := ");
            self.names.insert(index, name);
        }
        let name = match term {
            Term::Constant(number) => {
                let _ = write!(self.text, "{}", number.get());
                return;
            }
            Term::Variable(number) => {
                self.text.push_str(&(self.variable)(*number));
                return;
            }
            Term::Of(primitive, _) => primitive.name().to_owned(),
            Term::Call(function, _) => (self.function)(function),
            Term::Row(rows, _) => rows.name().to_owned(),
        };
        self.text.push_str(&name);
        for (i, id) in term.operands().iter().enumerate() {
            self.text.push_str(if i == 0 { "(" } else { ", " });
            self.write(id.index());
        }
        self.text.push(')');
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    variable: &'a dyn Fn(&str) -> Option<u32>,
    function: &'a dyn Fn(&str) -> Option<Function>,
    names: HashMap<&'a str, TermId>,
    graph: Graph,
}

/// Maximum nesting depth.
const DEPTH: usize = 1000;

impl<'a> Reader<'a> {
    fn problem(&self, problem: impl Into<String>) -> ParseError {
        ParseError { at: self.at, problem: problem.into() }
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn space(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    fn taken(&mut self, token: &str) -> bool {
        self.space();
        let is = self.rest().starts_with(token);
        self.at += if is { token.len() } else { 0 };
        is
    }

    fn expect(&mut self, token: &str) -> Result<(), ParseError> {
        if self.taken(token) { Ok(()) } else { Err(self.problem(format!("expected `{token}`"))) }
    }

    /// Letters, digits and the other characters of variables and numbers.
    fn word(&mut self) -> &'a str {
        self.space();
        let rest = self.rest();
        let inside = |c: char| c.is_ascii_alphanumeric() || "_.%+-".contains(c);
        let end = rest.find(|c| !inside(c)).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn expression(&mut self, depth: usize) -> Result<TermId, ParseError> {
        if depth > DEPTH {
            return Err(self.problem(format!("operands are nested more than {DEPTH} deep")));
        }
        self.space();
        let start = self.at;
        let word = self.word();
        if word.is_empty() {
            return Err(self.problem("expected a number, a variable or an operation"));
        }
        if self.taken(":=") {
            let id = self.expression(depth + 1)?;
            self.names.insert(word, id);
            return Ok(id);
        }
        if self.taken("(") {
            return self.operation(word, start, depth);
        }
        if let Some(id) = self.names.get(word) {
            return Ok(*id);
        }
        if let Some(number) = (self.variable)(word) {
            return Ok(self.graph.add(Term::Variable(number)));
        }
        match word.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(self.graph.constant(value)),
            Ok(_) | Err(_) => {
                self.at = start;
                Err(self.problem(format!("`{word}` is neither a finite number nor a known name")))
            }
        }
    }

    fn operation(&mut self, name: &str, start: usize, depth: usize) -> Result<TermId, ParseError> {
        let mut of = vec![self.expression(depth + 1)?];
        while self.taken(",") {
            of.push(self.expression(depth + 1)?);
        }
        self.expect(")")?;
        let primitive = Primitive::ALL.into_iter().find(|primitive| primitive.name() == name);
        let takes = |count: usize| {
            let given = of.len();
            let at = start;
            let problem = format!("`{name}` takes {count} operands, and {given} are given");
            if count == given { Ok(()) } else { Err(ParseError { at, problem }) }
        };
        if let Some(primitive) = primitive {
            takes(primitive.arity())?;
            Ok(self.graph.of(primitive, &of))
        } else if let Some(function) = (self.function)(name) {
            takes(1)?;
            Ok(self.graph.add(Term::Call(function, of[0])))
        } else {
            let names: Vec<&str> =
                Primitive::ALL.iter().map(|primitive| primitive.name()).collect();
            let problem = format!("there is no operation `{name}`: legal are {}", names.join(", "));
            Err(ParseError { at: start, problem })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Expr, ParseError> {
        let variable = |name: &str| (name == "x").then_some(0);
        Expr::parse(text, &variable, &|_| None)
    }

    #[test]
    fn what_is_written_is_read_back() {
        let x = Expr::variable(0);
        let shared = x.sin_turns();
        let cases = [
            &x * &x + 1.0,
            x.cos_turns() + &shared * &shared,
            (-&x).exp2() / (0.1 + x.abs()).pow(33.0).modulo(-0.5, 1.0),
            x.less(0.0).select(&shared, 1e-300 - &shared),
            Expr::constant(-0.1),
            x,
        ];
        for expr in cases {
            let text = expr.to_string();
            assert_eq!(read(&text), Ok(expr), "{text}");
        }
    }

    #[test]
    fn malformed_text_is_refused_with_its_place() {
        let cases = [
            ("", 0, "expected a number"),
            ("add(x)", 0, "takes 2 operands, and 1 are given"),
            ("add(x, 1", 8, "expected `)`"),
            ("add(x, y)", 7, "`y` is neither a finite number"),
            ("add(x, inf)", 7, "`inf` is neither a finite number"),
            ("x x", 2, "the end of the expression"),
            ("tan(x)", 0, "no operation `tan`"),
            ("add(x, )", 7, "expected a number"),
            ("add(t := x, t := ", 17, "expected a number"),
        ];
        for (text, at, part) in cases {
            let error = read(text).expect_err(text);
            assert_eq!(error.at, at, "{text}: {}", error.problem);
            assert!(error.problem.contains(part), "{text}: {}", error.problem);
        }
        let deep = "neg(".repeat(100_000);
        assert!(read(&deep).is_err_and(|error| error.problem.contains("deep")));
    }
}
