//! Nodes as values with operators.

use super::{Builder, Netlist, NodeId, Overrides, Part, Quantity, Rate, Table, TableId};
use crate::base::cast;
use crate::base::error::Result;
use crate::number::format::{Format, Overflow, Round};
use std::cell::RefCell;
use std::ops::{Add, BitAnd, BitOr, BitXor, Mul, Neg, Range, Shl, Shr, Sub};
use std::rc::Rc;

/// A netlist written with operators: a thin layer over a [`Builder`], with the same rules.
///
/// Nodes are [`Wire`]s. Operations are exact, a real operand becomes a constant of exactly its
/// value, and only [`Wire::narrow`] loses bits. [`Wires::build`] returns the first mistake, with
/// the source line that made it.
///
/// ```
/// use fixpath::format::{Format, Overflow::Saturate, Round::HalfEven};
/// use fixpath::netlist::Wires;
///
/// let w = Wires::new("complex_product");
/// let format = Format::signed(12, 11)?;
/// let [a, b, c, d] = ["a", "b", "c", "d"].map(|name| w.input(name, format));
/// let real = (&a * &c - &b * &d).narrow(format, HalfEven, Saturate).named("real");
/// let imaginary = (&a * &d + &b * &c).narrow(format, HalfEven, Saturate).named("imaginary");
/// let larger = real.lt(&imaginary).mux(&imaginary, &real);
/// w.output("re", &real);
/// w.output("im", &imaginary);
/// w.output("quarter", &(&larger >> 2));
/// w.output("above", &(larger - 0.25));
/// let netlist = w.build()?;
/// assert_eq!(netlist.counts().datapath.multipliers, 4);
///
/// // A wire of another netlist is an error of the one that met it.
/// let (one, other) = (Wires::new("one"), Wires::new("other"));
/// let x = one.input("x", format) + other.input("y", format);
/// one.output("sum", &x);
/// let why = one.build().unwrap_err().to_string();
/// assert!(why.starts_with("add of x (s12f11), a node of another builder: "), "{why}");
/// # Ok::<(), fixpath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Wires(Rc<RefCell<Builder>>);

/// A node of a netlist under construction.
#[derive(Clone, Debug)]
pub struct Wire {
    wires: Wires,
    id: NodeId,
}

impl Wires {
    /// Starts an empty netlist.
    #[must_use]
    #[track_caller]
    pub fn new(name: &str) -> Self {
        Self(Rc::new(RefCell::new(Builder::new(name))))
    }

    /// As [`Wires::new`], with overridden formats for some nodes.
    #[must_use]
    #[track_caller]
    pub fn with(name: &str, overrides: &Overrides) -> Self {
        Self(Rc::new(RefCell::new(Builder::with(name, overrides))))
    }

    /// Wraps a builder's node as a wire.
    #[must_use]
    pub fn wire(&self, id: NodeId) -> Wire {
        Wire { wires: self.clone(), id }
    }

    /// Gives access to the builder, for parts that are written for it. Wires can't be used
    /// meanwhile.
    #[track_caller]
    pub fn builder<R>(&self, body: impl FnOnce(&mut Builder) -> R) -> R {
        let mut builder = self.0.replace(Builder::new("resting"));
        let result = body(&mut builder);
        if let Some(error) = self.0.replace(builder).into_error() {
            self.0.borrow().fail(error);
        }
        result
    }

    /// Builds the nodes of `body` in a named scope.
    #[track_caller]
    pub fn scope<R>(&self, name: &str, body: impl FnOnce() -> R) -> R {
        self.in_scope(name, None, body)
    }

    /// As [`Wires::scope`], for nodes that count as one operator.
    #[track_caller]
    pub fn part<R>(&self, part: Part, name: &str, body: impl FnOnce() -> R) -> R {
        self.in_scope(name, Some(part), body)
    }

    #[track_caller]
    fn in_scope<R>(&self, name: &str, part: Option<Part>, body: impl FnOnce() -> R) -> R {
        let outer = self.0.borrow_mut().open(name, part);
        let owner = self.0.borrow().owner();
        let result = body();
        let mut builder = self.0.borrow_mut();
        // Unless the body built the netlist.
        if builder.owner() == owner {
            builder.enter(outer);
        }
        result
    }

    /// Adds an input port.
    #[track_caller]
    pub fn input(&self, name: &str, format: Format) -> Wire {
        let id = self.0.borrow_mut().input(name, format, Quantity::Number);
        self.wire(id)
    }

    /// Adds an input port for an angle in turns.
    #[track_caller]
    pub fn angle(&self, name: &str, format: Format) -> Wire {
        let id = self.0.borrow_mut().input(name, format, Quantity::Turns);
        self.wire(id)
    }

    /// Adds an output port.
    #[track_caller]
    pub fn output(&self, name: &str, wire: &Wire) {
        self.0.borrow_mut().output(name, wire.id);
    }

    /// Adds a table.
    #[track_caller]
    pub fn table(&self, table: Table) -> TableId {
        self.0.borrow_mut().table(table)
    }

    /// Adds a memory, as [`Builder::memory`].
    #[track_caller]
    pub fn memory(
        &self,
        name: &str,
        addr_bits: u32,
        columns: &[(&str, Format)],
        latency: u32,
    ) -> TableId {
        self.0.borrow_mut().memory(name, addr_bits, columns, latency)
    }

    /// The constant word `raw`.
    #[track_caller]
    pub fn word(&self, raw: i64, format: Format) -> Wire {
        let id = self.0.borrow_mut().constant(raw, format);
        self.wire(id)
    }

    /// The constant of exactly this value, in the smallest format that holds it.
    #[track_caller]
    pub fn constant(&self, value: f64) -> Wire {
        let mut builder = self.0.borrow_mut();
        let id = match dyadic(value) {
            Some((raw, format)) => builder.constant(raw, format),
            None => {
                builder.misuse(
                    format!("constant {value}"),
                    "no format of up to 63 bits and 127 fraction bits has exactly this value",
                );
                builder.constant(0, Format::FLAG)
            }
        };
        drop(builder);
        self.wire(id)
    }

    /// Verifies and freezes the netlist; its wires can't be used afterwards.
    ///
    /// # Errors
    /// The first mistake, as for [`Builder::build`].
    #[track_caller]
    pub fn build(self) -> Result<Netlist> {
        let builder = self.0.replace(Builder::new("built"));
        builder.build()
    }
}

/// The word of exactly this value, and the smallest format that holds it. An integer has no
/// fraction bits if it fits that way.
fn dyadic(value: f64) -> Option<(i64, Format)> {
    if value == 0.0 {
        return Some((0, Format::FLAG));
    }
    if !value.is_finite() {
        return None;
    }
    let bits = value.abs().to_bits();
    let exponent = i32::try_from(bits >> 52).ok()?;
    let mantissa = bits & ((1 << 52) - 1) | if exponent == 0 { 0 } else { 1 << 52 };
    let zeros = mantissa.trailing_zeros();
    let magnitude = i128::from(mantissa >> zeros);
    // |value| = magnitude * 2^-frac
    let frac = 1075 - exponent.max(1) - cast::signed_count(zeros);
    let word = |frac: i32, magnitude: i128| -> Option<(i64, Format)> {
        let signed = if value < 0.0 { -magnitude } else { magnitude };
        // Check the limits of 63 bits and 127 places before making a format.
        (frac.abs() <= 127).then_some(())?;
        Some((i64::try_from(signed).ok()?, Format::spanning(signed, signed, frac).ok()?))
    };
    match frac {
        ..0 if frac > -63 => {
            word(0, magnitude << frac.unsigned_abs()).or_else(|| word(frac, magnitude))
        }
        _ => word(frac, magnitude),
    }
}

impl Wire {
    /// The node.
    #[must_use]
    pub fn id(&self) -> NodeId {
        self.id
    }

    /// Its format.
    #[must_use]
    #[track_caller]
    pub fn format(&self) -> Format {
        self.wires.0.borrow().format(self.id)
    }

    /// Names the node within its scope; a node keeps its first name.
    #[must_use]
    #[track_caller]
    pub fn named(self, name: &str) -> Self {
        self.wires.0.borrow_mut().name(self.id, name);
        self
    }

    /// Marks the node as an angle in turns.
    #[must_use]
    #[track_caller]
    pub fn turns(self) -> Self {
        self.wires.0.borrow_mut().turns(self.id);
        self
    }

    /// The word in `format`; the only operation that loses bits.
    #[must_use]
    #[track_caller]
    pub fn narrow(&self, format: Format, round: Round, overflow: Overflow) -> Self {
        let id = self.wires.0.borrow_mut().narrow(self.id, format, round, overflow);
        self.wires.wire(id)
    }

    /// Sets how often this input port gets a new word.
    #[must_use]
    #[track_caller]
    pub fn per(self, rate: Rate) -> Self {
        self.wires.0.borrow_mut().rate(self.id, rate);
        self
    }

    /// The word of `samples` samples earlier, as [`Builder::delay`].
    #[must_use]
    #[track_caller]
    pub fn delay(&self, samples: u32) -> Self {
        let id = self.wires.0.borrow_mut().delay(self.id, samples);
        self.wires.wire(id)
    }

    /// The residue modulo the span of `format`.
    #[must_use]
    #[track_caller]
    pub fn modulo(&self, format: Format) -> Self {
        let id = self.wires.0.borrow_mut().modulo(self.id, format);
        self.wires.wire(id)
    }

    /// The magnitude.
    #[must_use]
    #[track_caller]
    pub fn abs(&self) -> Self {
        let id = self.wires.0.borrow_mut().abs(self.id);
        self.wires.wire(id)
    }

    /// The sign bit of a signed word as a flag.
    #[must_use]
    #[track_caller]
    pub fn negative(&self) -> Self {
        let id = self.wires.0.borrow_mut().negative(self.id);
        self.wires.wire(id)
    }

    /// The bits in `range`, as an integer; bit 0 is the lowest.
    #[must_use]
    #[track_caller]
    pub fn bits(&self, range: Range<u32>) -> Self {
        let count = range.end.saturating_sub(range.start);
        let id = self.wires.0.borrow_mut().slice(self.id, range.start, count);
        self.wires.wire(id)
    }

    /// This integer's bits above those of `low`.
    #[must_use]
    #[track_caller]
    pub fn concat(&self, low: &Self) -> Self {
        let id = self.wires.0.borrow_mut().concat(self.id, low.id);
        self.wires.wire(id)
    }

    /// Flag: less than `other`.
    #[must_use]
    #[track_caller]
    pub fn lt(&self, other: &Self) -> Self {
        let id = self.wires.0.borrow_mut().less(self.id, other.id);
        self.wires.wire(id)
    }

    /// Flag: greater than `other`.
    #[must_use]
    #[track_caller]
    pub fn gt(&self, other: &Self) -> Self {
        let id = self.wires.0.borrow_mut().less(other.id, self.id);
        self.wires.wire(id)
    }

    /// Flag: equal in value to `other`.
    #[must_use]
    #[track_caller]
    pub fn equals(&self, other: &Self) -> Self {
        let id = self.wires.0.borrow_mut().equal(self.id, other.id);
        self.wires.wire(id)
    }

    /// `a` where this flag is set, otherwise `b`.
    #[must_use]
    #[track_caller]
    pub fn mux(&self, a: &Self, b: &Self) -> Self {
        let id = self.wires.0.borrow_mut().mux(self.id, a.id, b.id);
        self.wires.wire(id)
    }

    /// `a - b` where this flag is set, otherwise `a + b`.
    #[must_use]
    #[track_caller]
    pub fn addsub(&self, a: &Self, b: &Self) -> Self {
        let id = self.wires.0.borrow_mut().addsub(self.id, a.id, b.id);
        self.wires.wire(id)
    }

    /// The number of zero bits above the highest one bit of an unsigned word.
    #[must_use]
    #[track_caller]
    pub fn leading_zeros(&self) -> Self {
        let id = self.wires.0.borrow_mut().leading_zeros(self.id);
        self.wires.wire(id)
    }

    /// The word times 2^min(n, max) for an unsigned integer n: a barrel shifter.
    #[must_use]
    #[track_caller]
    pub fn shift_left(&self, n: &Self, max: u32) -> Self {
        let id = self.wires.0.borrow_mut().shift_left(self.id, n.id, max);
        self.wires.wire(id)
    }

    /// The word of a table's column at this address.
    #[must_use]
    #[track_caller]
    pub fn read(&self, table: TableId, column: usize) -> Self {
        let id = self.wires.0.borrow_mut().read(table, column, self.id);
        self.wires.wire(id)
    }
}

impl Neg for &Wire {
    type Output = Wire;

    #[track_caller]
    fn neg(self) -> Wire {
        let id = self.wires.0.borrow_mut().neg(self.id);
        self.wires.wire(id)
    }
}

impl Neg for Wire {
    type Output = Self;

    #[track_caller]
    fn neg(self) -> Self {
        -&self
    }
}

/// Implements an operator for two wires, owned or borrowed.
macro_rules! operators {
    ($($operator:ident $method:ident $build:ident;)*) => {$(
        impl $operator<&Wire> for &Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: &Wire) -> Wire {
                let id = self.wires.0.borrow_mut().$build(self.id, other.id);
                self.wires.wire(id)
            }
        }

        impl $operator<Wire> for &Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: Wire) -> Wire {
                $operator::$method(self, &other)
            }
        }

        impl $operator<&Wire> for Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: &Wire) -> Wire {
                $operator::$method(&self, other)
            }
        }

        impl $operator<Wire> for Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: Wire) -> Wire {
                $operator::$method(&self, &other)
            }
        }
    )*};
}

macro_rules! operators_with_reals {
    ($($operator:ident $method:ident;)*) => {$(
        impl $operator<f64> for &Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: f64) -> Wire {
                $operator::$method(self, &self.wires.constant(other))
            }
        }

        impl $operator<f64> for Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: f64) -> Wire {
                $operator::$method(&self, other)
            }
        }

        impl $operator<&Wire> for f64 {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: &Wire) -> Wire {
                $operator::$method(&other.wires.constant(self), other)
            }
        }

        impl $operator<Wire> for f64 {
            type Output = Wire;

            #[track_caller]
            fn $method(self, other: Wire) -> Wire {
                $operator::$method(self, &other)
            }
        }
    )*};
}

/// Operators that move the binary point.
macro_rules! shifts {
    ($($operator:ident $method:ident $left:expr;)*) => {$(
        impl $operator<i32> for &Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, places: i32) -> Wire {
                let left: fn(i32) -> i32 = $left;
                let id = self.wires.0.borrow_mut().shift(self.id, left(places));
                self.wires.wire(id)
            }
        }

        impl $operator<i32> for Wire {
            type Output = Wire;

            #[track_caller]
            fn $method(self, places: i32) -> Wire {
                $operator::$method(&self, places)
            }
        }
    )*};
}

operators! {
    Add add add;
    Sub sub sub;
    Mul mul mul;
    BitAnd bitand and;
    BitOr bitor or;
    BitXor bitxor xor;
}

operators_with_reals! {
    Add add;
    Sub sub;
    Mul mul;
}

shifts! {
    Shl shl |places| places;
    Shr shr i32::saturating_neg;
}
