//! The text file format for exchanging netlists.
//!
//! The code of functions ([`Function::with_kernel`]) isn't written: functions that are read have
//! only their expressions.
//!
#![doc = include_str!("../../docs/files/netlist.md")]

use super::{
    Builder, Column, Meaning, Memory, Netlist, NodeId, Part, Quantity, Rate, ScopeId, Table,
    TableId,
};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::{escape, name};
use crate::netlist::op::Op;
use crate::number::format::{Format, Overflow, Round};
use crate::number::function::Function;
use crate::number::real::{Expr, Primitive, Term};
use std::collections::{BTreeSet, HashMap};
use std::fmt::Write as _;
use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;

/// First line.
const HEAD: &str = "fixpath netlist 1";

impl Part {
    /// Every part.
    pub const ALL: &'static [Self] =
        &[Self::Scheme, Self::Divider, Self::SquareRoot, Self::ReciprocalRoot, Self::Dot];

    /// Name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scheme => "scheme",
            Self::Divider => "divider",
            Self::SquareRoot => "square_root",
            Self::ReciprocalRoot => "reciprocal_root",
            Self::Dot => "dot",
        }
    }
}

impl Quantity {
    /// Every quantity.
    pub const ALL: &'static [Self] = &[Self::Number, Self::Turns, Self::Float20];

    /// Name in listings and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Turns => "turns",
            Self::Float20 => "float20",
        }
    }
}

impl Netlist {
    /// The whole netlist as a file; [`Netlist::parse`] reads it back to an equal netlist.
    #[must_use]
    pub fn to_file(&self) -> String {
        let mut text = format!("{HEAD}\nname {}\n", self.name);
        for (index, scope) in self.scopes.iter().enumerate().skip(1) {
            let path = self.scope_path(ScopeId(cast::id_of(index))).join(".");
            let part = scope.part.map(|part| format!(" {}", part.name())).unwrap_or_default();
            let _ = writeln!(text, "scope {path}{part}");
        }
        let functions = self.functions();
        for (id, function) in &functions {
            let named = |function: &Function| name_of(&functions, function);
            let expr = function.expr().to_text(&|_| "x".to_owned(), &named);
            let _ = writeln!(text, "function {}= {expr}", heading(id, function.name()));
        }
        let ids = unique(self.tables.iter().map(|table| table.name.as_str()), &|_| false);
        for (id, table) in ids.iter().zip(&self.tables) {
            let kind = if table.memory.is_some() { "memory" } else { "table" };
            let _ = write!(text, "{kind} {}{}", heading(id, &table.name), table.addr_bits);
            if let Some(Memory { latency }) = table.memory {
                let _ = write!(text, " latency {latency}");
            }
            for column in &table.columns {
                let _ = write!(text, " {}:{}", column.name, column.format);
            }
            text.push('\n');
            let rows = if table.memory.is_some() { 0 } else { 1usize << table.addr_bits };
            for row in 0..rows {
                for (i, column) in table.columns.iter().enumerate() {
                    let space = if i == 0 { "  " } else { " " };
                    let _ = write!(text, "{space}{}", column.words[row]);
                }
                text.push('\n');
            }
        }
        for (id, node) in self.ids().zip(&self.nodes) {
            let _ = write!(text, "%{} = {}", id.number, self.describe(node, &ids));
            for operand in &node.operands {
                let _ = write!(text, " %{}", operand.number);
            }
            let _ = write!(text, " : {}", node.format);
            if node.quantity != Quantity::Number {
                let _ = write!(text, " {}", node.quantity.name());
            }
            if node.op == Op::Input && node.rate != Rate::default() {
                let _ = write!(text, " per {}", node.rate);
            }
            if node.scope != ScopeId::ROOT || node.name.is_some() {
                text.push_str(" @");
                for name in self.scope_path(node.scope) {
                    let _ = write!(text, "{name}.");
                }
                text.push_str(node.name.as_deref().unwrap_or_default());
            }
            if let Some(Meaning { expr, of }) = &node.meaning {
                let variable = |number: u32| format!("%{}", of[cast::index_of_u32(number)].number);
                let expr = expr.to_text(&variable, &|function| name_of(&functions, function));
                let _ = write!(text, " means {expr}");
            }
            text.push('\n');
        }
        for output in &self.outputs {
            let _ = writeln!(text, "output {} = %{}", output.name, output.node.number);
        }
        text
    }

    /// The functions used in nodes' meanings, each after those that it calls, with unique ids.
    fn functions(&self) -> Vec<(String, Function)> {
        fn collect(expr: &Expr, found: &mut Vec<Function>) {
            for term in expr.terms() {
                if let Term::Call(function, _) = term
                    && !found.contains(function)
                {
                    collect(function.expr(), found);
                    found.push(function.clone());
                }
            }
        }
        let mut found = Vec::new();
        for meaning in self.nodes.iter().filter_map(|node| node.meaning.as_ref()) {
            collect(&meaning.expr, &mut found);
        }
        let primitive =
            |name: &str| Primitive::ALL.into_iter().any(|primitive| primitive.name() == name);
        let ids = unique(found.iter().map(Function::name), &primitive);
        ids.into_iter().zip(found).collect()
    }

    /// Parses a file; `path` is for messages.
    ///
    /// # Errors
    /// If it is malformed or not a valid netlist; the error gives line and column.
    pub fn parse(text: &str, path: &Path) -> Result<Self> {
        Reader::default().read(text, path)
    }
}

fn name_of(functions: &[(String, Function)], function: &Function) -> String {
    let found = functions.iter().find(|(_, known)| known == function);
    found.expect("bug: every function is collected").0.clone()
}

/// `ID named NAME `, or `NAME ` if both are the same.
fn heading(id: &str, name: &str) -> String {
    if id == name { format!("{name} ") } else { format!("{id} named {name} ") }
}

/// The names, with a number appended to those that are taken.
fn unique<'a>(names: impl Iterator<Item = &'a str>, taken: &dyn Fn(&str) -> bool) -> Vec<String> {
    let mut used = BTreeSet::new();
    let mut id = |name| name::numbered(name, |id| !taken(id) && used.insert(id.to_owned()));
    names.map(&mut id).collect()
}

/// An error at a byte offset in the line.
struct Wrong {
    at: usize,
    problem: String,
}

type Read<T> = std::result::Result<T, Wrong>;

fn wrong<T>(at: usize, problem: impl Into<String>) -> Read<T> {
    Err(Wrong { at, problem: problem.into() })
}

/// The words of a line with their positions.
struct Line<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Line<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// The next word; `None` at the end.
    fn next(&mut self) -> Option<(usize, &'a str)> {
        self.at += self.rest().len() - self.rest().trim_start().len();
        let end = self.rest().find(char::is_whitespace).unwrap_or(self.rest().len());
        let word = &self.rest()[..end];
        let at = self.at;
        self.at += end;
        (!word.is_empty()).then_some((at, word))
    }

    fn word(&mut self, what: &str) -> Read<(usize, &'a str)> {
        match self.next() {
            Some(word) => Ok(word),
            None => wrong(self.at, format!("the line ends, and {what} is missing")),
        }
    }

    /// Parses the next word; returns its position and value.
    fn placed<T: FromStr>(&mut self, what: &str) -> Read<(usize, T)> {
        let (at, word) = self.word(what)?;
        match word.parse() {
            Ok(value) => Ok((at, value)),
            Err(_) => wrong(at, format!("`{word}` is not {what}")),
        }
    }

    fn parse<T: FromStr>(&mut self, what: &str) -> Read<T> {
        self.placed(what).map(|(_, value)| value)
    }

    fn expect(&mut self, token: &str) -> Read<()> {
        let (at, word) = self.word(&format!("`{token}`"))?;
        if word == token {
            Ok(())
        } else {
            wrong(at, format!("expected `{token}` before `{word}`"))
        }
    }

    fn end(&mut self) -> Read<()> {
        match self.next() {
            None => Ok(()),
            Some((at, word)) => wrong(at, format!("expected the end of the line before `{word}`")),
        }
    }

    /// Parses `NAME` or `ID named NAME`, and returns the position, the id and the name.
    fn names(&mut self, what: &str) -> Read<(usize, &'a str, &'a str)> {
        let (at, id) = self.word(what)?;
        let before = self.at;
        if matches!(self.next(), Some((_, "named"))) {
            return Ok((at, id, self.word(what)?.1));
        }
        self.at = before;
        Ok((at, id, id))
    }
}

/// A table whose words are being read.
struct Pending {
    id: String,
    name: String,
    addr_bits: u32,
    columns: Vec<(String, Format, Vec<i64>)>,
    /// The line that declares it.
    line: usize,
}

#[derive(Default)]
struct Reader {
    builder: Option<Builder>,
    scopes: HashMap<String, ScopeId>,
    functions: HashMap<String, Function>,
    tables: HashMap<String, (TableId, Vec<String>)>,
    pending: Option<Pending>,
    nodes: Vec<NodeId>,
    inputs: usize,
    outputs: usize,
}

impl Reader {
    fn read(mut self, text: &str, path: &Path) -> Result<Netlist> {
        let mut last = 0;
        for (index, whole) in text.lines().enumerate() {
            last = index;
            let code = whole.split('#').next().unwrap_or_default();
            let mut line = Line { text: code, at: 0 };
            let failed = |at: usize, problem: String| {
                let column = cast::count_of(code[..at.min(code.len())].chars().count()) + 1;
                Error::place(path, cast::count_of(index) + 1, column, problem)
            };
            if index == 0 {
                if code.trim_end() != HEAD {
                    return Err(failed(0, format!("a netlist file begins with `{HEAD}`")));
                }
                continue;
            }
            self.line(&mut line, index).map_err(|wrong| failed(wrong.at, wrong.problem))?;
            if let Some(error) = self.builder.as_mut().and_then(Builder::take_error) {
                return Err(failed(0, error.without_place().to_string()));
            }
        }
        let end =
            |problem: &str| Error::place(path, cast::count_of(last) + 1, 1, problem.to_owned());
        if let Some(Pending { name, line, .. }) = self.pending {
            return Err(end(&format!(
                "the file ends inside table `{name}`, which starts in line {}",
                line + 1
            )));
        }
        if text.trim().is_empty() {
            return Err(end(&format!("it is empty; a netlist file begins with `{HEAD}`")));
        }
        if self.inputs == 0 {
            return Err(end("the netlist has no input"));
        }
        let Some(builder) = self.builder.filter(|_| self.outputs > 0) else {
            return Err(end("the netlist has no output"));
        };
        builder.build().map_err(|error| Error::file(path, error.without_place().to_string()))
    }

    fn line(&mut self, line: &mut Line<'_>, index: usize) -> Read<()> {
        if self.pending.is_some() && !line.rest().trim().is_empty() {
            return self.row(line);
        }
        let Some((at, word)) = line.next() else { return Ok(()) };
        if self.builder.is_none() {
            let (name_at, name) = match word {
                "name" => line.word("the netlist's name")?,
                _ => return wrong(at, "the second line must be `name` and the netlist's name"),
            };
            self.builder = Some(Builder::new(identifier(name_at, name)?));
            return line.end();
        }
        match word {
            "scope" => self.scope(line),
            "function" => self.function(line),
            "table" => self.table(line, index),
            "memory" => self.memory(line),
            "output" => self.output(line),
            _ if word.starts_with('%') => self.node(line, at, word),
            _ => wrong(
                at,
                format!(
                    "`{word}` can't start a line: legal are scope, function, table, memory, %N and output"
                ),
            ),
        }
    }

    fn b(&mut self) -> &mut Builder {
        self.builder.as_mut().expect("bug: lines are read after the name's")
    }

    fn scope(&mut self, line: &mut Line<'_>) -> Read<()> {
        let (at, path) = line.word("the scope's path")?;
        let (parent, name) = path.rsplit_once('.').unwrap_or(("", path));
        let parent = self.scope_at(at, parent)?;
        let name = identifier(at, name)?;
        let part = match line.next() {
            None => None,
            Some((at, word)) => {
                let names: Vec<&str> = Part::ALL.iter().map(|part| part.name()).collect();
                let part = Part::ALL.iter().find(|part| part.name() == word);
                let unknown = || format!("`{word}` is not a part: legal are {}", names.join(", "));
                Some(*part.ok_or_else(|| Wrong { at, problem: unknown() })?)
            }
        };
        let id = self.b().declare_scope(parent, name, part);
        if self.scopes.insert(path.to_owned(), id).is_some() {
            return wrong(at, format!("scope `{path}` is declared twice"));
        }
        line.end()
    }

    fn scope_at(&self, at: usize, path: &str) -> Read<ScopeId> {
        if path.is_empty() {
            return Ok(ScopeId::ROOT);
        }
        match self.scopes.get(path) {
            Some(id) => Ok(*id),
            None => wrong(at, format!("there is no scope `{path}`: declare it first")),
        }
    }

    fn function(&mut self, line: &mut Line<'_>) -> Read<()> {
        let (at, id, name) = line.names("the function's name")?;
        identifier(at, id)?;
        line.expect("=")?;
        let expr = self.expression(line, &|name| (name == "x").then_some(0))?;
        let function = Function::of_expr(name, expr);
        if let Some(problem) = function.problem() {
            return wrong(at, problem);
        }
        if self.functions.insert(id.to_owned(), function).is_some() {
            return wrong(at, format!("function `{id}` is defined twice"));
        }
        Ok(())
    }

    /// Parses an expression up to the end of the line.
    fn expression(
        &self,
        line: &mut Line<'_>,
        variable: &dyn Fn(&str) -> Option<u32>,
    ) -> Read<Expr> {
        let start = line.at;
        let text = line.rest();
        line.at = line.text.len();
        Expr::parse(text, variable, &|name| self.functions.get(name).cloned())
            .map_err(|error| Wrong { at: start + error.at, problem: error.problem })
    }

    /// Parses the id, name and address bits of a table or memory.
    fn table_head<'a>(&self, line: &mut Line<'a>) -> Read<(&'a str, &'a str, u32)> {
        let (at, id, name) = line.names("the table's name")?;
        if self.tables.contains_key(id) {
            return wrong(at, format!("table `{id}` is declared twice"));
        }
        identifier(at, id)?;
        identifier(at, name)?;
        let (bits_at, addr_bits) = line.placed::<u32>("a number of address bits")?;
        let most = Table::MAX_ADDR_BITS;
        if !(1..=most).contains(&addr_bits) {
            return wrong(bits_at, format!("{addr_bits} address bits: legal is 1 to {most}"));
        }
        Ok((id, name, addr_bits))
    }

    /// Parses the names and formats of columns, up to the end of the line.
    fn columns(line: &mut Line<'_>) -> Read<Vec<(String, Format)>> {
        let mut columns: Vec<(String, Format)> = Vec::new();
        while let Some((at, word)) = line.next() {
            let Some((name, format)) = word.split_once(':') else {
                return wrong(at, format!("`{word}` is not a column: write NAME:FORMAT"));
            };
            let name = identifier(at, name)?;
            if columns.iter().any(|(known, _)| known == name) {
                return wrong(at, format!("column `{name}` is declared twice"));
            }
            columns.push((name.to_owned(), format_at(at + name.len() + 1, format)?));
        }
        if columns.is_empty() {
            return wrong(line.at, "a table needs a column: write NAME:FORMAT");
        }
        Ok(columns)
    }

    fn table(&mut self, line: &mut Line<'_>, index: usize) -> Read<()> {
        let (id, name, addr_bits) = self.table_head(line)?;
        let columns = Self::columns(line)?;
        let columns =
            columns.into_iter().map(|(name, format)| (name, format, Vec::new())).collect();
        let (id, name) = (id.to_owned(), name.to_owned());
        self.pending = Some(Pending { id, name, addr_bits, columns, line: index });
        Ok(())
    }

    fn memory(&mut self, line: &mut Line<'_>) -> Read<()> {
        let (id, name, addr_bits) = self.table_head(line)?;
        line.expect("latency")?;
        let latency = line.parse("a number of cycles")?;
        let columns = Self::columns(line)?;
        let names = columns.iter().map(|(name, _)| name.clone()).collect();
        let columns: Vec<(&str, Format)> =
            columns.iter().map(|(name, format)| (&name[..], *format)).collect();
        let built = self.b().memory(name, addr_bits, &columns, latency);
        self.tables.insert(id.to_owned(), (built, names));
        Ok(())
    }

    fn row(&mut self, line: &mut Line<'_>) -> Read<()> {
        let table = self.pending.as_mut().expect("bug: asked for by the caller");
        for (name, format, words) in &mut table.columns {
            let (at, word) = line.placed::<i64>(&format!("a word of column `{name}`"))?;
            if !format.contains(word) {
                return wrong(at, format!("word {word} of column `{name}` is outside {format}"));
            }
            words.push(word);
        }
        line.end()?;
        if table.columns[0].2.len() < 1 << table.addr_bits {
            return Ok(());
        }
        let table = self.pending.take().expect("bug: taken above");
        let columns: Vec<Column> = table
            .columns
            .into_iter()
            .map(|(name, format, words)| Column { name, format, words: Arc::from(words) })
            .collect();
        let names = columns.iter().map(|column| column.name.clone()).collect();
        let Pending { id, name, addr_bits, .. } = Pending { columns: Vec::new(), ..table };
        let built = self.b().table(Table { name, addr_bits, columns, memory: None });
        self.tables.insert(id, (built, names));
        Ok(())
    }

    fn node_at(&self, at: usize, word: &str) -> Read<NodeId> {
        let number = word.strip_prefix('%').and_then(|number| number.parse::<usize>().ok());
        match number.and_then(|number| self.nodes.get(number)) {
            Some(id) => Ok(*id),
            None => {
                let legal = match self.nodes.len().checked_sub(1) {
                    Some(last) => format!("legal is %0 to %{last}"),
                    None => "there is none yet".to_owned(),
                };
                wrong(at, format!("`{word}` is not a node before this line: {legal}"))
            }
        }
    }

    fn node(&mut self, line: &mut Line<'_>, at: usize, word: &str) -> Read<()> {
        let expected = format!("%{}", self.nodes.len());
        if word != expected {
            return wrong(
                at,
                format!("nodes are numbered from %0 up: expected `{expected}` before `{word}`"),
            );
        }
        line.expect("=")?;
        let (op_at, op) = line.word("an operation")?;
        let op = self.operation(line, op_at, op)?;
        let mut operands = Vec::new();
        loop {
            let (at, word) = line.word("`:` and a format")?;
            if word == ":" {
                break;
            }
            operands.push(self.node_at(at, word)?);
        }
        let arity = op.arity();
        if operands.len() != arity {
            let given = operands.len();
            return wrong(
                op_at,
                format!("`{}` takes {arity} operands, and {given} are given", op.name()),
            );
        }
        let (format_at_byte, text) = line.word("a format")?;
        let format = format_at(format_at_byte, text)?;
        let op = if let Op::Slice { lo } = op { slice(op_at, lo, format)? } else { op };

        let (mut quantity, mut scope, mut name) = (None, ScopeId::ROOT, None);
        let (mut rate, mut has_rate) = (Rate::default(), false);
        let mut meaning: Option<(Expr, Vec<NodeId>)> = None;
        let mut name_at = 0;
        while let Some((at, word)) = line.next() {
            if let Some(path) = word.strip_prefix('@') {
                let (path, own) = path.rsplit_once('.').unwrap_or(("", path));
                scope = self.scope_at(at, path)?;
                if !own.is_empty() {
                    name = Some(identifier(at, own)?);
                    name_at = at;
                }
            } else if word == "per" {
                if std::mem::replace(&mut has_rate, true) {
                    return wrong(at, "a port has only one rate");
                }
                if op != Op::Input {
                    return wrong(
                        at,
                        "only ports have a rate: other nodes have the fastest rate of their operands",
                    );
                }
                let (rate_at, word) = line.word("a rate")?;
                let names: Vec<&str> = Rate::ALL.iter().map(|rate| rate.name()).collect();
                let unknown = || format!("`{word}` is not a rate: legal are {}", names.join(", "));
                rate = word.parse().or_else(|_| wrong(rate_at, unknown()))?;
            } else if word == "means" {
                meaning = Some(self.meaning(line)?);
            } else if let Some(known) = Quantity::ALL.iter().find(|known| known.name() == word) {
                quantity = Some(*known);
            } else {
                return wrong(
                    at,
                    format!("expected number, turns, float20, per, @NAME or means, not `{word}`"),
                );
            }
        }
        let b = self.b();
        b.enter(scope);
        let id = if op == Op::Input {
            let Some(name) = name else { return wrong(op_at, "name the input: write @NAME") };
            if scope != ScopeId::ROOT {
                return wrong(name_at, "an input can't be in a scope: write @NAME");
            }
            let id = b.input(name, format, quantity.unwrap_or_default());
            b.rate(id, rate)
        } else {
            let id = b.operation(op, &operands, format);
            let is = b.format(id);
            if !b.has_failed() && is != format {
                return wrong(
                    format_at_byte,
                    format!("the result of `{}` is {is}, not {format}", op.name()),
                );
            }
            if let Some(name) = name {
                b.name(id, name);
            }
            if let Some(quantity) = quantity {
                b.measures(id, quantity);
            }
            id
        };
        if let Some((expr, of)) = meaning {
            b.stands_for(id, &expr, &of);
        }
        self.nodes.push(id);
        self.inputs += usize::from(op == Op::Input);
        Ok(())
    }

    /// Parses what a node stands for: an expression of earlier nodes.
    fn meaning(&self, line: &mut Line<'_>) -> Read<(Expr, Vec<NodeId>)> {
        let of = std::cell::RefCell::new(Vec::new());
        let variable = |name: &str| {
            let number: usize = name.strip_prefix('%')?.parse().ok()?;
            let id = *self.nodes.get(number)?;
            let mut of = of.borrow_mut();
            let known = of.iter().position(|known| *known == id);
            let position = known.unwrap_or_else(|| {
                of.push(id);
                of.len() - 1
            });
            Some(cast::id_of(position))
        };
        let expr = self.expression(line, &variable)?;
        Ok((expr, of.into_inner()))
    }

    /// Parses an operation with the attributes between its name and its operands.
    fn operation(&self, line: &mut Line<'_>, at: usize, word: &str) -> Read<Op> {
        let (name, bits) =
            word.split_once('[').map_or((word, None), |(name, bits)| (name, Some(bits)));
        let is_slice = |op: &Op| matches!(op, Op::Slice { .. });
        let known = Op::ALL.iter().find(|op| op.name() == name && (bits.is_none() || is_slice(op)));
        let Some(op) = known.copied() else {
            return wrong(at, format!("there is no operation `{}`", escape::short(word)));
        };
        // Operations without attributes need only their name.
        if let Op::Const { .. } = op {
            Ok(Op::Const { raw: line.parse("a word")? })
        } else if let Op::Slice { .. } = op {
            let lo = bits.and_then(|bits| bits.strip_suffix(']')?.split_once(':')?.1.parse().ok());
            match lo {
                Some(lo) => Ok(Op::Slice { lo }),
                None => wrong(at, "a slice is written slice[HIGH:LOW]"),
            }
        } else if let Op::Shift { .. } = op {
            Ok(Op::Shift { left: line.parse("a number of places, such as +3")? })
        } else if let Op::ShiftLeft { .. } = op {
            line.expect("max")?;
            Ok(Op::ShiftLeft { max: line.parse("the largest shift")? })
        } else if let Op::Delay { .. } = op {
            Ok(Op::Delay { samples: line.parse("a number of samples")? })
        } else if let Op::Read { .. } = op {
            self.table_column(line)
        } else if let Op::Narrow { .. } = op {
            let round: Round = line.parse("a rounding mode, such as half-even")?;
            let overflow: Overflow = line.parse("an overflow mode, such as saturate")?;
            Ok(Op::Narrow { round, overflow })
        } else {
            Ok(op)
        }
    }

    fn table_column(&self, line: &mut Line<'_>) -> Read<Op> {
        let (at, word) = line.word("TABLE.COLUMN")?;
        let (table, column) = word.split_once('.').unwrap_or((word, ""));
        let Some((id, columns)) = self.tables.get(table) else {
            return wrong(at, format!("there is no table `{table}` before this line"));
        };
        let Some(column) = columns.iter().position(|known| known == column) else {
            let names = columns.join(", ");
            let problem =
                format!("table `{table}` has no column `{column}`: its columns are {names}");
            return wrong(at, problem);
        };
        Ok(Op::Read { table: *id, column: cast::id_of(column) })
    }

    fn output(&mut self, line: &mut Line<'_>) -> Read<()> {
        let (at, name) = line.word("the port's name")?;
        let name = identifier(at, name)?;
        line.expect("=")?;
        let (at, word) = line.word("a node")?;
        let id = self.node_at(at, word)?;
        self.b().output(name, id);
        self.outputs += 1;
        line.end()
    }
}

fn slice(at: usize, lo: u32, format: Format) -> Read<Op> {
    match lo.checked_add(format.bits()) {
        Some(end) if end <= Format::MAX_BITS => Ok(Op::Slice { lo }),
        Some(_) | None => {
            wrong(at, format!("bit {lo} is past the {} bits of a word", Format::MAX_BITS))
        }
    }
}

fn format_at(at: usize, text: &str) -> Read<Format> {
    text.parse().or_else(|error: Error| wrong(at, error.to_string()))
}

fn identifier(at: usize, name: &str) -> Read<&str> {
    if name::is_legal(name) {
        return Ok(name);
    }
    wrong(at, format!("`{}` is not a name: a name is {}", escape::short(name), name::RULE))
}
