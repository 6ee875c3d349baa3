//! Terms, graphs of them, expressions, and functions, which are expressions with a name.

use super::primitive::Primitive;
use super::rows::Rows;
use crate::base::{cast, escape, name};
use std::collections::HashMap;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops;
use std::sync::Arc;

/// A finite `f64` that is ordered and can be a key; equal is bit for bit, and there is no -0.
#[derive(Clone, Copy, Debug)]
pub struct Number(f64);

impl Number {
    /// The number.
    #[must_use]
    pub fn get(self) -> f64 {
        self.0
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Self(value + 0.0) // -0 becomes 0
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Number {}

impl std::hash::Hash for Number {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.0.to_bits().hash(state);
    }
}

/// A term of a graph; operands are positions of earlier terms.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Term {
    /// A number.
    Constant(Number),
    /// A variable by its number.
    Variable(u32),
    /// A primitive of as many earlier terms as it takes; the rest are 0.
    Of(Primitive, [TermId; 3]),
    /// A named function of an earlier term. In a graph, only one with a kernel of its own: others
    /// are what they are made of.
    Call(Function, TermId),
    /// The value of rows at an earlier term.
    Row(Rows, TermId),
}

impl Term {
    /// The earlier terms that it is made of.
    #[must_use]
    pub fn operands(&self) -> &[TermId] {
        match self {
            Self::Constant(_) | Self::Variable(_) => &[],
            Self::Of(primitive, of) => &of[..primitive.arity()],
            Self::Call(_, of) | Self::Row(_, of) => std::slice::from_ref(of),
        }
    }
}

/// Position of a term in its graph.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub struct TermId(u32);

impl TermId {
    /// Position as an index.
    #[must_use]
    pub fn index(self) -> usize {
        cast::index_of_u32(self.0)
    }
}

/// Terms, each of which stands once; operands come first.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    terms: Vec<Term>,
    known: HashMap<Term, TermId>,
}

impl PartialEq for Graph {
    fn eq(&self, other: &Self) -> bool {
        self.terms == other.terms
    }
}

impl Graph {
    /// The terms in order.
    #[must_use]
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// Position of a term, which is added if it isn't there.
    pub fn add(&mut self, term: Term) -> TermId {
        let next = TermId(cast::id_of(self.terms.len()));
        *self.known.entry(term).or_insert_with_key(|term| {
            self.terms.push(term.clone());
            next
        })
    }

    /// A number.
    pub fn constant(&mut self, value: f64) -> TermId {
        self.add(Term::Constant(value.into()))
    }

    /// A primitive of terms.
    ///
    /// # Panics
    /// If they are more or fewer than it takes.
    pub fn of(&mut self, primitive: Primitive, of: &[TermId]) -> TermId {
        assert_eq!(of.len(), primitive.arity(), "bug: operands of {}", primitive.name());
        let mut operands = [TermId::default(); 3];
        operands[..of.len()].copy_from_slice(of);
        self.add(Term::Of(primitive, operands))
    }

    /// Adds an expression whose variables are these terms; a function without a kernel becomes what
    /// it is made of.
    ///
    /// # Panics
    /// If the expression has more variables.
    pub fn insert(&mut self, expr: &Expr, variables: &[TermId]) -> TermId {
        let variable = |_: &mut Self, number| variables[cast::index_of_u32(number)];
        self.copy(expr, variable, |graph, function, of| match function.kernel() {
            Some(_) => graph.call(function, of),
            None => graph.insert(function.expr(), &[of]),
        })
    }

    fn call(&mut self, function: &Function, of: TermId) -> TermId {
        self.add(Term::Call(function.clone(), of))
    }

    /// Adds the terms of an expression; what its variables and calls become is up to the caller.
    fn copy(
        &mut self,
        expr: &Expr,
        mut variable: impl FnMut(&mut Self, u32) -> TermId,
        mut call: impl FnMut(&mut Self, &Function, TermId) -> TermId,
    ) -> TermId {
        let mut at: Vec<TermId> = Vec::with_capacity(expr.0.len());
        for term in expr.terms() {
            let id = match term {
                Term::Constant(_) => self.add(term.clone()),
                Term::Variable(number) => variable(self, *number),
                Term::Of(primitive, _) => {
                    let of: Vec<TermId> = term.operands().iter().map(|id| at[id.index()]).collect();
                    self.of(*primitive, &of)
                }
                Term::Call(function, of) => call(self, function, at[of.index()]),
                Term::Row(rows, of) => self.add(Term::Row(rows.clone(), at[of.index()])),
            };
            at.push(id);
        }
        at.last().copied().expect("bug: an expression has a term")
    }

    /// Values of all terms in a reading, from those of the variables.
    ///
    /// # Panics
    /// If a variable has no value.
    #[must_use]
    pub fn values<R: Reading>(&self, reading: &R, variables: &[R::Value]) -> Vec<R::Value> {
        values(&self.terms, reading, variables)
    }
}

/// An expression: a graph of its own, whose last term is its value.
///
/// Operators take expressions and numbers:
///
/// ```
/// use fixpath::real::Expr;
/// let x = Expr::variable(0);
/// let secant = (&x * &x + 1.0).sqrt();
/// assert_eq!(secant.eval(&[0.75]), 1.25);
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Expr(Arc<[Term]>);

impl Expr {
    /// A number, which must not be NaN.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self(Arc::new([Term::Constant(value.into())]))
    }

    /// A variable by its number.
    #[must_use]
    pub fn variable(number: u32) -> Self {
        Self(Arc::new([Term::Variable(number)]))
    }

    /// The first so many variables.
    #[must_use]
    pub fn variables<const N: usize>() -> [Self; N] {
        std::array::from_fn(|i| Self::variable(cast::id_of(i)))
    }

    /// The terms in order; the last is the expression's value.
    #[must_use]
    pub fn terms(&self) -> &[Term] {
        &self.0
    }

    /// A primitive of expressions.
    ///
    /// # Panics
    /// If they are more or fewer than it takes.
    #[must_use]
    pub fn of<const N: usize>(primitive: Primitive, of: [&Self; N]) -> Self {
        let mut graph = Graph::default();
        let ids = of.map(|expr| graph.merge(expr));
        graph.of(primitive, &ids);
        graph.into_expr()
    }

    /// A function of an expression.
    #[must_use]
    pub fn call(function: &Function, of: &Self) -> Self {
        let mut graph = Graph::default();
        let id = graph.merge(of);
        graph.add(Term::Call(function.clone(), id));
        graph.into_expr()
    }

    /// Value in a reading.
    ///
    /// # Panics
    /// If a variable has no value.
    #[must_use]
    pub fn read<R: Reading>(&self, reading: &R, variables: &[R::Value]) -> R::Value {
        values(&self.0, reading, variables).pop().expect("bug: an expression has a term")
    }

    /// With other numbers of variables, which are asked for in the order in which variables first
    /// stand.
    #[must_use]
    pub fn renumbered(&self, mut number: impl FnMut(u32) -> u32) -> Self {
        let mut graph = Graph::default();
        let renumbered = |graph: &mut Graph, old| graph.add(Term::Variable(number(old)));
        graph.copy(self, renumbered, Graph::call);
        graph.into_expr()
    }

    /// Why it can't be used, if it can't: a number in it isn't finite, it is too large with all
    /// that it calls, or operands stand too deep in operands.
    pub(crate) fn problem(&self) -> Option<String> {
        let infinite = |term: &Term| matches!(term, Term::Constant(x) if !x.get().is_finite());
        if self.0.iter().any(infinite) {
            return Some("a number in it is not finite".to_owned());
        }
        let Extent { terms, depth } = self.extent();
        if terms > Extent::MOST.terms {
            return Some(format!("it is made of more than {} terms", Extent::MOST.terms));
        }
        (depth > Extent::MOST.depth)
            .then(|| format!("operands stand more than {} deep in it", Extent::MOST.depth))
    }

    /// As [`Self::problem`], and of the functions that it calls.
    pub(crate) fn problem_with_calls(&self) -> Option<String> {
        let called = |term: &Term| match term {
            Term::Call(function, _) => function.problem(),
            Term::Constant(_) | Term::Variable(_) | Term::Of(..) | Term::Row(..) => None,
        };
        // Too large comes first: then nothing else is gone through.
        self.problem().or_else(|| self.0.iter().find_map(called))
    }

    /// Its terms with those of what it calls, and how deep they stand.
    fn extent(&self) -> Extent {
        let mut depths: Vec<u32> = Vec::with_capacity(self.0.len());
        let mut terms = 0u32;
        for term in self.terms() {
            let below = term.operands().iter().map(|id| depths[id.index()]).max().unwrap_or(0);
            let own = match term {
                Term::Call(function, _) => function.0.extent,
                Term::Constant(_) | Term::Variable(_) | Term::Of(..) | Term::Row(..) => {
                    Extent { terms: 1, depth: 1 }
                }
            };
            terms = terms.saturating_add(own.terms);
            depths.push(below.saturating_add(own.depth));
        }
        Extent { terms, depth: depths.last().copied().unwrap_or(0) }
    }

    /// How many variables there are up to the last one.
    #[must_use]
    pub fn arity(&self) -> usize {
        let number = |term: &Term| match term {
            Term::Variable(number) => cast::index_of_u32(*number) + 1,
            Term::Constant(_) | Term::Of(..) | Term::Call(..) | Term::Row(..) => 0,
        };
        self.0.iter().map(number).max().unwrap_or(0)
    }
}

/// How large an expression is.
#[derive(Clone, Copy)]
struct Extent {
    terms: u32,
    depth: u32,
}

impl Extent {
    /// The most that is used: more is an error, before anything runs through it.
    const MOST: Self = Self { terms: 1 << 16, depth: 500 };
}

impl Graph {
    /// The expression that is the last term.
    pub(super) fn into_expr(self) -> Expr {
        Expr(self.terms.into())
    }

    /// Adds the terms of an expression with its own variables.
    pub(crate) fn merge(&mut self, expr: &Expr) -> TermId {
        self.copy(expr, |graph, number| graph.add(Term::Variable(number)), Self::call)
    }
}

impl From<f64> for Expr {
    fn from(value: f64) -> Self {
        Self::constant(value)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $primitive:ident) => {
        operator!(@of $trait, $method, $primitive; Expr, Expr; &Expr, Expr; Expr, &Expr; &Expr, &Expr);
        impl ops::$trait<f64> for Expr {
            type Output = Expr;
            fn $method(self, other: f64) -> Expr {
                Expr::of(Primitive::$primitive, [&self, &Expr::constant(other)])
            }
        }
        impl ops::$trait<f64> for &Expr {
            type Output = Expr;
            fn $method(self, other: f64) -> Expr {
                Expr::of(Primitive::$primitive, [self, &Expr::constant(other)])
            }
        }
        impl ops::$trait<Expr> for f64 {
            type Output = Expr;
            fn $method(self, other: Expr) -> Expr {
                Expr::of(Primitive::$primitive, [&Expr::constant(self), &other])
            }
        }
        impl ops::$trait<&Expr> for f64 {
            type Output = Expr;
            fn $method(self, other: &Expr) -> Expr {
                Expr::of(Primitive::$primitive, [&Expr::constant(self), other])
            }
        }
    };
    (@of $trait:ident, $method:ident, $primitive:ident; $($left:ty, $right:ty);+) => {$(
        impl ops::$trait<$right> for $left {
            type Output = Expr;
            #[allow(clippy::needless_borrow, reason = "one text for values and references")]
            fn $method(self, other: $right) -> Expr {
                Expr::of(Primitive::$primitive, [&self, &other])
            }
        }
    )+};
}

operator!(Add, add, Add);
operator!(Sub, sub, Sub);
operator!(Mul, mul, Mul);
operator!(Div, div, Div);

impl ops::Neg for Expr {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of(Primitive::Neg, [&self])
    }
}

impl ops::Neg for &Expr {
    type Output = Expr;
    fn neg(self) -> Expr {
        Expr::of(Primitive::Neg, [self])
    }
}

macro_rules! methods {
    ($($name:ident($($other:ident),*) $primitive:ident $text:literal;)+) => {
        impl Expr {$(
            #[doc = $text]
            #[must_use]
            pub fn $name(&self $(, $other: impl Into<Expr>)*) -> Self {
                $(let $other = $other.into();)*
                Self::of(Primitive::$primitive, [self $(, &$other)*])
            }
        )+}
    };
}

methods! {
    abs() Abs "`|self|`.";
    min(other) Min "The smaller of two.";
    max(other) Max "The larger of two.";
    floor() Floor "The greatest whole number that is not above.";
    modulo(low, span) Modulo "Less as many spans as keep it from `low` to below `low + span`.";
    sqrt() Sqrt "Square root.";
    exp2() Exp2 "`2^self`.";
    log2() Log2 "Logarithm to base 2.";
    pow(exponent) Pow "`self^exponent` of what is not below 0; `0^0` is 1.";
    exponent() Exponent "The whole number `e` with `2^e <= |self| < 2^(e + 1)`.";
    sin_turns() Sin "Sine of an angle in turns.";
    cos_turns() Cos "Cosine of an angle in turns.";
    asin_turns() Asin "Arc of a sine in turns, -¼ to ¼; what is beyond ±1 is taken to it.";
    acos_turns() Acos "Arc of a cosine in turns, 0 to ½; what is beyond ±1 is taken to it.";
    atan_turns() Atan "Arc of a tangent in turns, -¼ to ¼.";
    atan2_turns(x) Atan2 "Direction of `(x, self)` in turns, -½ to ½.";
    less(other) Less "1 if `self < other`, else 0.";
    equal(other) Equal "1 if `self = other`, else 0.";
    select(yes, no) Select "`yes` where this isn't 0, else `no`.";
}

impl From<&Expr> for Expr {
    fn from(expr: &Expr) -> Self {
        expr.clone()
    }
}

/// What primitives do with values of some kind.
pub trait Reading {
    /// A value.
    type Value: Clone;

    /// A number, without error.
    fn constant(&self, value: f64) -> Self::Value;

    /// A primitive of as many values as it takes; the rest are any.
    fn of(&self, primitive: Primitive, of: [&Self::Value; 3]) -> Self::Value;

    /// The value of rows at a value.
    fn row(&self, rows: &Rows, of: &Self::Value) -> Self::Value;

    /// A named function: its kernel where the reading has one, else its expression.
    fn call(&self, function: &Function, of: &Self::Value) -> Self::Value
    where
        Self: Sized,
    {
        function.expr().read(self, std::slice::from_ref(of))
    }
}

fn values<R: Reading>(terms: &[Term], reading: &R, variables: &[R::Value]) -> Vec<R::Value> {
    let mut values: Vec<R::Value> = Vec::with_capacity(terms.len());
    for term in terms {
        let value = match term {
            Term::Constant(number) => reading.constant(number.get()),
            Term::Variable(number) => variables[cast::index_of_u32(*number)].clone(),
            Term::Of(primitive, of) => {
                let operand = |i: usize| {
                    let i = if i < primitive.arity() { i } else { 0 };
                    &values[of[i].index()]
                };
                reading.of(*primitive, [operand(0), operand(1), operand(2)])
            }
            Term::Call(function, of) => reading.call(function, &values[of.index()]),
            Term::Row(rows, of) => reading.row(rows, &values[of.index()]),
        };
        values.push(value);
    }
    values
}

/// A real function of one variable: an expression with a name.
///
/// ```
/// use fixpath::function::Function;
/// let sigmoid = Function::new("sigmoid", |x| 1.0 / (1.0 + (-x * std::f64::consts::LOG2_E).exp2()));
/// assert_eq!(sigmoid.eval(0.0), 0.5);
/// ```
#[derive(Clone)]
pub struct Function(Arc<Named>);

struct Named {
    name: String,
    expr: Expr,
    /// Of name and expression.
    hash: u64,
    /// Of the expression.
    extent: Extent,
    quarter_wave: Option<QuarterWave>,
    kernel: Option<Kernel>,
}

/// The symmetry of sine and cosine: `f(½ - x) = f(x)` and `f(x + ½) = -f(x)`, perhaps a quarter
/// turn on.
#[derive(Clone)]
enum QuarterWave {
    /// This function has it.
    Own,
    /// It is such a function a quarter turn on: `self(x) = other(x + ¼)`.
    Advanced(Function),
}

/// Values of a function of as many arguments, to within [`Function::KERNEL_ULP`].
pub type Kernel = fn(&[f64], &mut [f64]);

impl Function {
    /// A function by its name and its expression of one variable.
    ///
    /// The name is that of table columns, so it follows the rule of names in netlists.
    #[must_use]
    pub fn new(name: impl Into<String>, expr: impl FnOnce(Expr) -> Expr) -> Self {
        let (name, expr) = (name.into(), expr(Expr::variable(0)));
        let mut hasher = DefaultHasher::new();
        (&name, &expr).hash(&mut hasher);
        let (hash, extent) = (hasher.finish(), expr.extent());
        Self(Arc::new(Named { name, expr, hash, extent, quarter_wave: None, kernel: None }))
    }

    /// Why it can't be used, if it can't: its name is none, or as [`Expr::problem`].
    pub(crate) fn problem(&self) -> Option<String> {
        if !name::is_legal(self.name()) {
            let given = escape::short(self.name());
            return Some(format!("function `{given}`: a name is {}", name::RULE));
        }
        if self.expr().arity() > 1 {
            return Some(format!("function `{}` has more than one variable", self.name()));
        }
        let why = self.expr().problem_with_calls();
        why.map(|why| format!("function `{}`: {why}", self.name()))
    }

    /// A function by its name and its expression, of variable 0 alone.
    pub(crate) fn of_expr(name: &str, expr: Expr) -> Self {
        Self::new(name, |_| expr)
    }

    fn with(self, change: impl FnOnce(&mut Named)) -> Self {
        let Named { name, expr, hash, extent, quarter_wave, kernel } = &*self.0;
        let mut named = Named {
            name: name.clone(),
            expr: expr.clone(),
            hash: *hash,
            extent: *extent,
            quarter_wave: quarter_wave.clone(),
            kernel: *kernel,
        };
        change(&mut named);
        Self(Arc::new(named))
    }

    /// With `f(½ - x) = f(x)` and `f(x + ½) = -f(x)`, as the sine of an angle in turns has it: a
    /// table may hold a quarter turn only.
    #[must_use]
    pub fn with_quarter_wave(self) -> Self {
        self.with(|named| named.quarter_wave = Some(QuarterWave::Own))
    }

    /// As [`Self::with_quarter_wave`] where it is `other` a quarter turn on, as the cosine is the
    /// sine.
    #[must_use]
    pub fn advanced_of(self, other: &Self) -> Self {
        self.with(|named| named.quarter_wave = Some(QuarterWave::Advanced(other.clone())))
    }

    /// With code of its own for evaluation in blocks, where the expression would be slow or would
    /// cancel. It must be within [`Self::KERNEL_ULP`] of the expression's value
    /// ([`Self::check_kernel`]) and give each argument the same value wherever it stands in a
    /// block.
    #[must_use]
    pub fn with_kernel(self, kernel: Kernel) -> Self {
        self.with(|named| named.kernel = Some(kernel))
    }

    /// Name in table names, listings and files.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.0.name
    }

    /// Its expression of variable 0.
    #[must_use]
    pub fn expr(&self) -> &Expr {
        &self.0.expr
    }

    /// The function of an expression.
    #[must_use]
    pub fn of(&self, x: &Expr) -> Expr {
        Expr::call(self, x)
    }

    /// Its code for blocks, if it brings any.
    pub(crate) fn kernel(&self) -> Option<Kernel> {
        self.0.kernel
    }

    /// The function on the first quarter turn that gives this one by symmetry, and whether this one
    /// is it a quarter turn on.
    pub(crate) fn quarter_wave(&self) -> Option<(&Self, bool)> {
        match self.0.quarter_wave.as_ref()? {
            QuarterWave::Own => Some((self, false)),
            QuarterWave::Advanced(other) => Some((other, true)),
        }
    }
}

impl fmt::Debug for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}(x) = {}", self.name(), self.expr())
    }
}

/// Functions are the same if their names and expressions are.
impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.name() == other.name() && self.expr() == other.expr()
    }
}

impl Eq for Function {}

impl Hash for Function {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.hash.hash(state);
    }
}
