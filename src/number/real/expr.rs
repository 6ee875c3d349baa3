//! Terms, graphs, expressions, and functions, which are named expressions.

use super::primitive::Primitive;
use super::rows::Rows;
use crate::base::{cast, escape, name};
use std::collections::HashMap;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops;
use std::sync::Arc;

/// An `f64` that can be ordered and used as a key. Equality is bitwise, and there is no -0.
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

/// A term of a graph; its operands are earlier terms.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Term {
    /// A number.
    Constant(Number),
    /// A variable by its number.
    Variable(u32),
    /// A primitive of earlier terms; unused operands are 0.
    Of(Primitive, [TermId; 3]),
    /// A named function of an earlier term. In a graph, only a function with its own kernel; other
    /// calls are expanded.
    Call(Function, TermId),
    /// The value of rows at an earlier term.
    Row(Rows, TermId),
}

impl Term {
    /// Its operands.
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

/// Terms without duplicates; operands come before their users.
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

    /// Position of a term, which is added if missing.
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
    /// If their number isn't the primitive's arity.
    pub fn of(&mut self, primitive: Primitive, of: &[TermId]) -> TermId {
        assert_eq!(of.len(), primitive.arity(), "bug: operands of {}", primitive.name());
        let mut operands = [TermId::default(); 3];
        operands[..of.len()].copy_from_slice(of);
        self.add(Term::Of(primitive, operands))
    }

    /// Adds an expression with these terms as its variables. Functions without a kernel are
    /// expanded.
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

    /// Adds the terms of an expression; the callbacks map its variables and calls.
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

    /// Values of all terms in a reading, given those of the variables.
    ///
    /// # Panics
    /// If a variable has no value.
    #[must_use]
    pub fn values<R: Reading>(&self, reading: &R, variables: &[R::Value]) -> Vec<R::Value> {
        values(&self.terms, reading, variables)
    }
}

/// An expression: a graph whose last term is its value.
///
/// Operators accept expressions and numbers:
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
    /// A constant, which must not be NaN.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self(Arc::new([Term::Constant(value.into())]))
    }

    /// A variable by its number.
    #[must_use]
    pub fn variable(number: u32) -> Self {
        Self(Arc::new([Term::Variable(number)]))
    }

    /// Variables 0 to `N` - 1.
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
    /// If their number isn't the primitive's arity.
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

    /// Renumbers the variables. `number` is called in the order in which variables first occur.
    #[must_use]
    pub fn renumbered(&self, mut number: impl FnMut(u32) -> u32) -> Self {
        let mut graph = Graph::default();
        let renumbered = |graph: &mut Graph, old| graph.add(Term::Variable(number(old)));
        graph.copy(self, renumbered, Graph::call);
        graph.into_expr()
    }

    /// What makes it unusable, if anything: a number that isn't finite, more terms than allowed
    /// with everything that it calls, or too deep nesting.
    pub(crate) fn problem(&self) -> Option<String> {
        let infinite = |term: &Term| matches!(term, Term::Constant(x) if !x.get().is_finite());
        if self.0.iter().any(infinite) {
            return Some("a number in it is not finite".to_owned());
        }
        let Extent { terms, depth } = self.extent();
        if terms > Extent::MOST.terms {
            return Some(format!("it has more than {} terms", Extent::MOST.terms));
        }
        (depth > Extent::MOST.depth)
            .then(|| format!("its operands are nested more than {} deep", Extent::MOST.depth))
    }

    /// As [`Self::problem`], and for the functions that it calls.
    pub(crate) fn problem_with_calls(&self) -> Option<String> {
        let called = |term: &Term| match term {
            Term::Call(function, _) => function.problem(),
            Term::Constant(_) | Term::Variable(_) | Term::Of(..) | Term::Row(..) => None,
        };
        // Check the size first: then the search below is bounded.
        self.problem().or_else(|| self.0.iter().find_map(called))
    }

    /// Its number of terms including those of calls, and its nesting depth.
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

    /// The highest variable number plus one; 0 without variables.
    #[must_use]
    pub fn arity(&self) -> usize {
        let number = |term: &Term| match term {
            Term::Variable(number) => cast::index_of_u32(*number) + 1,
            Term::Constant(_) | Term::Of(..) | Term::Call(..) | Term::Row(..) => 0,
        };
        self.0.iter().map(number).max().unwrap_or(0)
    }
}

/// The size of an expression.
#[derive(Clone, Copy)]
struct Extent {
    terms: u32,
    depth: u32,
}

impl Extent {
    /// The limits; a larger expression is refused before anything evaluates it.
    const MOST: Self = Self { terms: 1 << 16, depth: 500 };
}

impl Graph {
    /// The expression whose value is the last term.
    pub(super) fn into_expr(self) -> Expr {
        Expr(self.terms.into())
    }

    /// Adds the terms of an expression and keeps its variables.
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
    floor() Floor "The greatest whole number not above it.";
    modulo(low, span) Modulo "Reduced by multiples of the span to at least `low` and less than `low + span`.";
    sqrt() Sqrt "Square root.";
    exp2() Exp2 "`2^self`.";
    log2() Log2 "Logarithm to base 2.";
    pow(exponent) Pow "`self^exponent` for `self >= 0`; `0^0` is 1.";
    exponent() Exponent "The whole number `e` with `2^e <= |self| < 2^(e + 1)`.";
    sin_turns() Sin "Sine of an angle in turns.";
    cos_turns() Cos "Cosine of an angle in turns.";
    asin_turns() Asin "Arcsine in turns, -¼ to ¼; arguments beyond ±1 are clamped.";
    acos_turns() Acos "Arccosine in turns, 0 to ½; arguments beyond ±1 are clamped.";
    atan_turns() Atan "Arctangent in turns, -¼ to ¼.";
    atan2_turns(x) Atan2 "Direction of `(x, self)` in turns, -½ to ½.";
    less(other) Less "1 if `self < other`, otherwise 0.";
    equal(other) Equal "1 if `self = other`, otherwise 0.";
    select(yes, no) Select "`yes` where this isn't 0, otherwise `no`.";
}

impl From<&Expr> for Expr {
    fn from(expr: &Expr) -> Self {
        expr.clone()
    }
}

/// Defines the primitives on some type of value.
pub trait Reading {
    /// A value.
    type Value: Clone;

    /// An exact number.
    fn constant(&self, value: f64) -> Self::Value;

    /// A primitive; operands beyond its arity are arbitrary.
    fn of(&self, primitive: Primitive, of: [&Self::Value; 3]) -> Self::Value;

    /// The value of rows at a value.
    fn row(&self, rows: &Rows, of: &Self::Value) -> Self::Value;

    /// A named function: its kernel if the reading uses kernels, otherwise its expression.
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

/// A real function of one variable: a named expression.
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
    /// Hash of name and expression.
    hash: u64,
    /// Extent of the expression.
    extent: Extent,
    quarter_wave: Option<QuarterWave>,
    kernel: Option<Kernel>,
}

/// The symmetry of sine and cosine: `f(½ - x) = f(x)` and `f(x + ½) = -f(x)`, possibly shifted by a
/// quarter turn.
#[derive(Clone)]
enum QuarterWave {
    /// The function has the symmetry itself.
    Own,
    /// The function is such a function a quarter turn ahead: `self(x) = other(x + ¼)`.
    Advanced(Function),
}

/// Writes a function's value for each argument, within [`Function::KERNEL_ULP`].
pub type Kernel = fn(&[f64], &mut [f64]);

impl Function {
    /// Makes a function from its name and its expression of one variable.
    ///
    /// The name is also used for tables, so it follows the rule of names in netlists.
    #[must_use]
    pub fn new(name: impl Into<String>, expr: impl FnOnce(Expr) -> Expr) -> Self {
        let (name, expr) = (name.into(), expr(Expr::variable(0)));
        let mut hasher = DefaultHasher::new();
        (&name, &expr).hash(&mut hasher);
        let (hash, extent) = (hasher.finish(), expr.extent());
        Self(Arc::new(Named { name, expr, hash, extent, quarter_wave: None, kernel: None }))
    }

    /// What makes it unusable, if anything: an illegal name, or [`Expr::problem`].
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

    /// Makes a function from its name and its expression of variable 0.
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

    /// Declares `f(½ - x) = f(x)` and `f(x + ½) = -f(x)`, as for the sine of an angle in turns. A
    /// table may then hold only a quarter turn.
    #[must_use]
    pub fn with_quarter_wave(self) -> Self {
        self.with(|named| named.quarter_wave = Some(QuarterWave::Own))
    }

    /// Declares that the function is `other` a quarter turn ahead, as the cosine is of the sine;
    /// see [`Self::with_quarter_wave`].
    #[must_use]
    pub fn advanced_of(self, other: &Self) -> Self {
        self.with(|named| named.quarter_wave = Some(QuarterWave::Advanced(other.clone())))
    }

    /// Adds code for evaluation in blocks, for an expression that would be slow or lose digits by
    /// cancellation. The kernel must be within [`Self::KERNEL_ULP`] of the expression's value
    /// ([`Self::check_kernel`]), and its result for an argument must not depend on the position in
    /// a block.
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

    /// Applies the function to an expression.
    #[must_use]
    pub fn of(&self, x: &Expr) -> Expr {
        Expr::call(self, x)
    }

    /// Its kernel, if it has one.
    pub(crate) fn kernel(&self) -> Option<Kernel> {
        self.0.kernel
    }

    /// The function whose first quarter turn gives this one by symmetry, and whether this function
    /// is a quarter turn ahead of it.
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

/// Functions are equal if their names and expressions are.
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
