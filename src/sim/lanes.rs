//! The lane width of each node, and which of its bits must be right.
//!
//! Two analyses decide. Forwards: the words that a node can hold ([`ranges`]), which are fewer than
//! its format has. Backwards: the bits that its users read. A sum of angles modulo a turn needs
//! only its low bits, and then so do its operands, because low bits of two's complement sums,
//! products and selections depend only on low bits. A lane is the narrowest that holds the bits
//! needed.
//!
//! A node whose lane holds all of its words is *whole*: extending the lane, by its sign or by
//! zeros, gives the word in any wider lane. For other nodes only the requested low bits are right,
//! and nothing reads the rest.

use crate::netlist::op::Op;
use crate::netlist::ranges::ranges;
use crate::netlist::words::Words;
use crate::netlist::{Netlist, NodeId};
use crate::number::format::{Format, Overflow, Round, rounded};

/// Bits of a lane.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub(super) enum Width {
    W16,
    W32,
    W64,
}

impl Width {
    const ALL: [Self; 3] = [Self::W16, Self::W32, Self::W64];

    pub(super) fn bits(self) -> u32 {
        match self {
            Self::W16 => 16,
            Self::W32 => 32,
            Self::W64 => 64,
        }
    }

    /// The narrowest with this many bits.
    fn of_bits(bits: u32) -> Self {
        Self::ALL.into_iter().find(|width| width.bits() >= bits).unwrap_or(Self::W64)
    }

    /// The narrowest whose signed words hold an interval; `None` beyond 64 bits.
    fn signed(lo: i128, hi: i128) -> Option<Self> {
        let holds = |width: &Self| {
            let half = 1i128 << (width.bits() - 1);
            lo >= -half && hi < half
        };
        Self::ALL.into_iter().find(holds)
    }

    /// The narrowest that holds an interval of words, and whether only its unsigned words do.
    fn of_words((lo, hi): (i64, i64)) -> (Self, bool) {
        let (lo, hi) = (i128::from(lo), i128::from(hi));
        let holds = |width: &Self| {
            let half = 1i128 << (width.bits() - 1);
            (lo >= -half && hi < half) || (lo >= 0 && hi < 2 * half)
        };
        let width = Self::ALL.into_iter().find(holds).unwrap_or(Self::W64);
        (width, hi >= 1i128 << (width.bits() - 1))
    }
}

/// How a node is computed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Way {
    /// Nothing reads it.
    Unused,
    /// Always this word.
    Constant(i64),
    /// It shares its operand's lanes.
    Same(usize),
    /// The low bits of its operand, as wide as its own lane: nothing to compute.
    Low(usize),
    /// An instruction on lanes of `Placed::compute`.
    Computed,
}

/// Lane and computation of a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) way: Way,
    /// Lane of the result.
    pub(super) width: Width,
    /// Lane of the operands.
    pub(super) compute: Width,
    /// True if the lane is extended by zeros, not by its sign.
    pub(super) zero: bool,
    /// Least and greatest word.
    pub(super) range: (i64, i64),
}

/// What users need of a node.
#[derive(Clone, Copy, Default)]
struct Asked {
    /// The word.
    whole: bool,
    /// This many low bits.
    low: u32,
    /// The word, as an address of a table. If the other fields are unset, only tables read it.
    address: bool,
}

/// `narrow` as an engine computes it: `((a << up) + bias) >> down`, then limits.
pub(super) struct Narrowed {
    /// Shift to the left.
    pub(super) up: u32,
    /// Shift to the right.
    pub(super) down: u32,
    /// Lanes in which no intermediate bit is lost; `None` if there are none.
    pub(super) compute: Option<Width>,
    /// True if a word can overflow.
    pub(super) overflows: bool,
    /// True if rounded words, before limiting, fit 32 bits.
    pub(super) halves: bool,
}

/// The least word that doesn't overflow.
pub(super) fn least(to: Format, overflow: Overflow) -> i64 {
    match overflow {
        Overflow::Symmetric if to.is_signed() => -to.max_raw(),
        Overflow::Symmetric | Overflow::Wrap | Overflow::Saturate | Overflow::Error => to.min_raw(),
    }
}

impl Narrowed {
    pub(super) fn new(
        (lo, hi): (i64, i64),
        from: Format,
        to: Format,
        round: Round,
        overflow: Overflow,
    ) -> Self {
        let dropped = from.frac_bits() - to.frac_bits();
        let whole = |raw| rounded(raw, from.frac_bits(), to.frac_bits(), round);
        // Rounding is monotone, so the ends decide.
        let (first, last) = (whole(lo), whole(hi));
        let overflows = first < i128::from(least(to, overflow)) || last > i128::from(to.max_raw());
        let shift = dropped.unsigned_abs();
        let fits = |width: &Width| shift + 2 <= width.bits();
        let compute = if dropped > 0 {
            let half = 1i128 << (shift.min(100) - 1);
            let bias = match round {
                Round::Floor => 0,
                // Added to negative words only.
                Round::TowardZero => 0,
                Round::HalfUp | Round::HalfAway | Round::HalfEven => half,
            };
            Width::signed(lo.into(), i128::from(hi) + bias)
                .and_then(|least| Width::ALL.into_iter().find(|w| *w >= least && fits(w)))
        } else {
            Width::signed(first.min(lo.into()), last.max(hi.into()))
                .and_then(|least| Width::ALL.into_iter().find(|w| *w >= least && fits(w)))
        };
        let (up, down) = if dropped > 0 { (0, shift) } else { (shift, 0) };
        let halves =
            down <= 32 && Width::signed(first, last).is_some_and(|width| width <= Width::W32);
        Self { up, down, compute, overflows, halves }
    }
}

/// Shifts that align two operands to the finer one.
pub(super) fn alignment(a: Format, b: Format) -> [u32; 2] {
    let frac = a.frac_bits().max(b.frac_bits());
    [a, b].map(|format| frac.abs_diff(format.frac_bits()))
}

/// Places every node. `outputs` are needed as words. Every `narrow` that can overflow and is
/// `counted` is computed so that its overflows can be counted.
pub(super) fn place(netlist: &Netlist, outputs: &[NodeId], counted: &[bool]) -> Vec<Placed> {
    let nodes = netlist.nodes();
    let all: Vec<Words> =
        netlist.inputs().iter().map(|id| Words::all(netlist.node(*id).format)).collect();
    let words: Vec<(i64, i64)> =
        ranges(netlist, &all).iter().map(|words| (words.lo(), words.hi())).collect();
    let mut asked = vec![Asked::default(); nodes.len()];
    for id in outputs {
        asked[id.index()].whole = true;
    }
    let unused = Placed {
        way: Way::Unused,
        width: Width::W16,
        compute: Width::W16,
        zero: false,
        range: (0, 0),
    };
    let mut placed = vec![unused; nodes.len()];
    for index in (0..nodes.len()).rev() {
        let want = asked[index];
        let node = &nodes[index];
        let range = words[index];
        let (natural, natural_zero) = Width::of_words(range);
        let of = |i: usize| node.operands[i].index();
        let format = |i: usize| netlist.node(node.operands[i]).format;
        let narrowed = if let Op::Narrow { round, overflow } = node.op {
            Some(Narrowed::new(words[of(0)], format(0), node.format, round, overflow))
        } else {
            None
        };
        let counts = counted[index] && narrowed.as_ref().is_some_and(|narrowed| narrowed.overflows);
        let place = &mut placed[index];
        place.range = range;
        if !want.whole && want.low == 0 && !want.address && !counts {
            continue;
        }
        if range.0 == range.1 && !counts {
            place.way = Way::Constant(range.0);
            place.width = natural;
            place.zero = natural_zero;
            continue;
        }
        // The low bits that must be right, and the narrowest lane with them. A user that needs more
        // bits than the natural lane has extends it, and so needs the whole word.
        let is_whole = want.whole || want.address || want.low > natural.bits();
        let low = if is_whole { natural.bits() } else { want.low.max(1) };
        let mut width = Width::of_bits(low);
        let mut compute = None;
        let mut way = Way::Computed;
        // A lane must have more bits than the shift, so that the shift is defined.
        let above = |width: Width, shift: u32| width.max(Width::of_bits(shift + 1));
        // A whole word must fill a lane that is wider than it needs.
        let filled = |width: Width| if is_whole { width.bits() } else { low };
        let mut ask_low = |i: usize, bits: u32| {
            let low = &mut asked[of(i)].low;
            *low = (*low).max(bits.clamp(1, 64));
        };
        // Whole operands are collected here because both closures would borrow `asked`.
        let mut whole: Vec<usize> = Vec::new();
        match node.op {
            Op::Input => {}
            Op::Const { .. } => unreachable!("bug: constants have one word"),
            Op::Add | Op::Sub => {
                let shifts = alignment(format(0), format(1));
                width = above(width, shifts[0].max(shifts[1]));
                for (i, shift) in shifts.into_iter().enumerate() {
                    ask_low(i, filled(width).saturating_sub(shift));
                }
            }
            Op::AddSub | Op::Mux => {
                let shifts = alignment(format(1), format(2));
                width = above(width, shifts[0].max(shifts[1]));
                whole.push(0);
                for (i, shift) in shifts.into_iter().enumerate() {
                    ask_low(i + 1, filled(width).saturating_sub(shift));
                }
            }
            Op::Mul => {
                if wide_product(width, words[of(0)], words[of(1)]) {
                    whole.extend([0, 1]);
                } else {
                    ask_low(0, low);
                    ask_low(1, low);
                }
            }
            Op::Neg => ask_low(0, low),
            Op::And | Op::Or | Op::Xor => {
                ask_low(0, low);
                ask_low(1, low);
            }
            Op::Abs if words[of(0)].0 >= 0 => way = Way::Same(of(0)),
            Op::Abs => {
                let (lo, hi) = words[of(0)];
                width = width.max(Width::signed(lo.into(), hi.into()).unwrap_or(Width::W64));
                whole.push(0);
            }
            Op::Equal | Op::Less => {
                let shifts = alignment(format(0), format(1));
                let mut lanes = Width::W16;
                for (i, shift) in shifts.into_iter().enumerate() {
                    let (lo, hi) = words[of(i)];
                    let fit = Width::signed(i128::from(lo) << shift, i128::from(hi) << shift);
                    lanes = above(lanes.max(fit.unwrap_or(Width::W64)), shift);
                    whole.push(i);
                }
                width = lanes;
            }
            Op::Slice { lo } => {
                let bits = node.format.bits();
                let inside = |(least, most): (i64, i64)| {
                    least >= 0 && i128::from(most) < 1i128 << (lo + bits)
                };
                if lo == 0 && (inside(words[of(0)]) || (!is_whole && low <= bits)) {
                    way = Way::Same(of(0));
                } else {
                    width = width.max(Width::of_bits(lo + bits));
                    ask_low(0, lo + bits);
                    if lo == 0 && width.bits() == bits {
                        way = Way::Low(of(0));
                    } else if !want.whole && want.low == 0 && width == Width::W32 {
                        // Used only as an address: narrow lanes let four be read at once.
                        compute = Some(width);
                        width = natural;
                    }
                }
            }
            Op::Concat => {
                let low_bits = format(1).bits();
                if low <= low_bits && !is_whole {
                    way = Way::Same(of(1));
                } else {
                    width = above(width, low_bits);
                    ask_low(0, filled(width).saturating_sub(low_bits));
                    whole.push(1);
                }
            }
            Op::Shift { .. } => way = Way::Same(of(0)),
            Op::LeadingZeros => {
                width = width.max(Width::of_words(words[of(0)]).0);
                whole.push(0);
            }
            Op::ShiftLeft { max } => {
                width = above(width.max(Width::W32), max).max(Width::of_words(words[of(1)]).0);
                // The count is compared as a signed number.
                let (lo, hi) = words[of(1)];
                width = width.max(Width::signed(lo.into(), hi.into()).unwrap_or(Width::W64));
                ask_low(0, filled(width));
                whole.push(1);
            }
            Op::Read { .. } => asked[of(0)].address = true,
            Op::Delay { .. } => whole.push(0),
            Op::Modulo => {
                let bits = node.format.bits();
                let (lo, hi) = words[of(0)];
                if (node.format.contains(lo) && node.format.contains(hi))
                    || (!is_whole && low <= bits)
                {
                    way = Way::Same(of(0));
                } else {
                    width = width.max(Width::of_bits(bits));
                    ask_low(0, bits);
                    if width.bits() == bits {
                        way = Way::Low(of(0));
                    }
                }
            }
            Op::Narrow { .. } => {
                let narrowed = narrowed.as_ref().expect("bug: made above");
                if narrowed.up == 0 && narrowed.down == 0 && !narrowed.overflows {
                    way = Way::Same(of(0));
                } else {
                    // Intermediate words are twice as wide as the result: give the result its own
                    // lane.
                    let lanes = narrowed.compute.unwrap_or(Width::W64);
                    let own = Width::signed(range.0.into(), range.1.into()).unwrap_or(Width::W64);
                    let lanes = lanes.max(own);
                    compute = Some(lanes);
                    let halves = lanes == Width::W64 && own <= Width::W32;
                    width = if halves && narrowed.compute.is_some() { Width::W32 } else { lanes };
                    whole.push(0);
                }
            }
        }
        match way {
            Way::Same(operand) if is_whole => asked[operand].whole = true,
            Way::Same(operand) => {
                let bits = &mut asked[operand].low;
                *bits = (*bits).max(low);
            }
            Way::Unused | Way::Constant(_) | Way::Low(_) | Way::Computed => {}
        }
        for operand in whole {
            asked[of(operand)].whole = true;
        }
        *place = Placed {
            way,
            width,
            compute: compute.unwrap_or(width),
            zero: if let Way::Low(_) = way {
                !node.format.is_signed()
            } else {
                width == natural && natural_zero
            },
            range,
        };
    }
    placed
}

/// True if a 64-bit lane holds a product of two whole 32-bit lanes.
pub(super) fn wide_product(width: Width, a: (i64, i64), b: (i64, i64)) -> bool {
    let narrow = |(lo, hi): (i64, i64)| {
        Width::signed(lo.into(), hi.into()).is_some_and(|width| width <= Width::W32)
    };
    width == Width::W64 && narrow(a) && narrow(b)
}
