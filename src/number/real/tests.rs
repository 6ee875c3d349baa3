//! Compares the readings: intervals and floats against the high-precision evaluation.

use super::*;

/// Numbers of all magnitudes, and near where primitives end, jump or turn.
const NUMBERS: [f64; 34] = [
    0.0,
    -0.0,
    5e-324,
    -1e-310,
    1e300,
    1.0,
    -1.0,
    0.5,
    -0.5,
    0.25,
    -0.25,
    0.75,
    2.0,
    -2.0,
    3.0,
    1e-3,
    -1e-3,
    1e-9,
    -1e-9,
    0.1,
    -0.1,
    0.3,
    -0.7,
    0.999_999_999_999,
    1.000_000_000_001,
    -0.999_999_999_999,
    12.75,
    -12.75,
    100.125,
    -31.4,
    0.250_000_000_01,
    0.499_999_999_99,
    1e5,
    7.389,
];

fn precise(primitive: Primitive, of: [f64; 3]) -> Option<Big> {
    let reading = Precise::new(200);
    let [a, b, c] = of.map(|x| reading.constant(x));
    reading.of(primitive, [&a, &b, &c])
}

/// False for residues of magnitudes so different that the bits used here can't resolve them, and
/// for exponents of numbers that aren't normal.
fn is_told(primitive: Primitive, of: [f64; 3]) -> bool {
    let usual = |x: f64| x == 0.0 || (1e-12..1e12).contains(&x.abs());
    let modulo = primitive == Primitive::Modulo && !of.into_iter().all(usual);
    let exponent = primitive == Primitive::Exponent && !of[0].is_normal();
    !modulo && !exponent
}

/// Every combination of operands; unused ones are arbitrary.
fn operands(primitive: Primitive) -> Vec<[f64; 3]> {
    let mut all = Vec::new();
    for a in NUMBERS {
        for b in &NUMBERS[..if primitive.arity() > 1 { NUMBERS.len() } else { 1 }] {
            for c in &NUMBERS[..if primitive.arity() > 2 { 12 } else { 1 }] {
                all.push([a, *b, *c]);
            }
        }
    }
    all
}

/// The error in units in the last place of the nearest float, or in units of 2^-54 where that is
/// more, as for sine and cosine.
fn off(is: f64, should: &Big) -> f64 {
    let nearest = should.nearest();
    if nearest.is_infinite() {
        return if is == nearest { 0.0 } else { f64::INFINITY };
    }
    let ulp = (nearest.abs().next_up() - nearest.abs()).max(2f64.powi(-54));
    ((is - nearest) - should.less(nearest)).abs() / ulp
}

#[test]
fn floats_are_near_the_value() {
    for primitive in Primitive::ALL {
        let mut compared = 0;
        for of in operands(primitive) {
            let Some(exact) = precise(primitive, of).filter(|_| is_told(primitive, of)) else {
                continue;
            };
            let spans = (of[0] - of[1]) / of[2];
            // Residues of non-dyadic numbers lose digits by cancellation, and their error in floats
            // is unbounded at the joints.
            if primitive == Primitive::Modulo
                && (of[2] <= 0.0
                    || of[2].log2().fract() != 0.0
                    || (spans - spans.round()).abs() < 1e-9)
            {
                continue;
            }
            compared += 1;
            let [a, b, c] = of;
            let limit = if primitive == Primitive::Modulo { 2.0 * a.abs() / c } else { 0.0 } + 4.0;
            for (name, is) in
                [("twin", primitive.twin(a, b, c)), ("scalar", Scalar.of(primitive, [&a, &b, &c]))]
            {
                // In blocks, numbers are normal, and angles are below 2^40 turns.
                let subnormal = of.iter().any(|x| x.is_subnormal());
                let wave = matches!(primitive, Primitive::Sin | Primitive::Cos);
                let half_turn = primitive == Primitive::Atan2 && a == 0.0 && b < 0.0;
                if name == "twin" && (wave && a.abs() > 1e12 || half_turn || subnormal) {
                    continue;
                }
                assert!(
                    off(is, &exact) <= limit,
                    "{primitive:?} {of:?} {name}: {is} for {exact:?}"
                );
            }
        }
        assert!(compared > 10, "{primitive:?}");
    }
}

/// The value at points, and at points inside wide intervals.
#[test]
fn intervals_hold_the_value() {
    let holds = |interval: Interval, exact: &Big| {
        let nearest = exact.nearest();
        if nearest.is_infinite() {
            return interval.contains(nearest);
        }
        let left = exact.less(nearest);
        let above = interval.lo < nearest || interval.lo == nearest && left >= 0.0;
        let below = interval.hi > nearest || interval.hi == nearest && left <= 0.0;
        above && below
    };
    for primitive in Primitive::ALL {
        let mut narrow = 0;
        for of in operands(primitive) {
            let points = of.map(Interval::from);
            let [a, b, c] = points.each_ref();
            let interval = Outward.of(primitive, [a, b, c]);
            let Some(exact) = precise(primitive, of).filter(|_| is_told(primitive, of)) else {
                continue;
            };
            assert!(holds(interval, &exact), "{primitive:?} {of:?}: {interval:?} for {exact:?}");
            let size = exact.nearest().abs().max(1e-300);
            narrow += usize::from(interval.hi - interval.lo <= 1e-14 * size);
            for (down, up) in [(0.0, 0.01), (1e-12, 0.0), (0.3, 0.4), (0.0, 30.0), (1e6, 1e6)] {
                let wide = of.map(|x| Interval::new(x - down, x + up));
                let [a, b, c] = wide.each_ref();
                let interval = Outward.of(primitive, [a, b, c]);
                assert!(
                    holds(interval, &exact),
                    "{primitive:?} {wide:?}: {interval:?} at {of:?} {exact:?}"
                );
                for share in [0.25, 0.5, 0.875, 1.0] {
                    let inside = wide.map(|wide| wide.lo + share * (wide.hi - wide.lo));
                    let inside = [0, 1, 2].map(|i| inside[i].clamp(wide[i].lo, wide[i].hi));
                    if let Some(exact) =
                        precise(primitive, inside).filter(|_| is_told(primitive, inside))
                    {
                        assert!(
                            holds(interval, &exact),
                            "{primitive:?} {wide:?}: {interval:?} at {inside:?}"
                        );
                    }
                }
            }
        }
        assert!(narrow > 10, "{primitive:?}: {narrow}");
    }
}

/// The result of one primitive enters the next with all its bits, also if it is 0 or whole.
#[test]
fn precision_is_kept_from_primitive_to_primitive() {
    let x = Expr::variable(0);
    let whole = [
        (&x * 10.0).floor(),
        x.pow(0.0),
        (&x * 0.0).atan2_turns(&x * 0.0),
        (&x * 0.0).exp2(),
        (&x * 4.0).exp2(),
        (&x * 3.0).modulo(0.0, 1.0),
        x.exponent(),
        x.less(2.0),
        (&x * 0.0).sqrt(),
    ];
    let after: [fn(&Expr) -> Expr; 5] = [
        |x| (x + 3.0).sqrt(),
        |x| (x + 7.0).log2(),
        |x| (x + 0.3).sin_turns(),
        |x| 1.0 / (x + 3.0),
        |x| (x * 0.1 + 0.01).exp2().cos_turns(),
    ];
    let (low, high) = (Precise::new(160), Precise::new(400));
    for first in &whole {
        for second in after {
            let expr = second(first);
            for at in [0.5, 0.75, 1.25] {
                let value =
                    |reading: &Precise| expr.read(reading, &[reading.constant(at)]).unwrap();
                let (near, exact) = (value(&low), value(&high));
                let off = near.plus(&exact.times(&high.constant(-1.0).unwrap())).nearest().abs();
                assert!(off <= 1e-45 * exact.nearest().abs(), "{expr} at {at}: {off:e}");
                let scalar = expr.eval(&[at]);
                assert!(
                    (scalar - exact.nearest()).abs() <= 1e-14 * scalar.abs().max(1.0),
                    "{expr} at {at}"
                );
                assert!(
                    expr.read(&Outward, &[at.into()]).contains(exact.nearest()),
                    "{expr} at {at}"
                );
            }
        }
    }
}

#[test]
fn zeros_that_are_rounded_are_not_exact() {
    let x = Expr::variable(0);
    let interval = |expr: &Expr, at: f64| expr.read(&Outward, &[at.into()]);
    for (expr, at) in [(x.exp2(), -1100.0), (x.pow(2.0), 1e-200), (x.atan_turns(), 5e-324)] {
        let interval = interval(&expr, at);
        assert!(interval.hi > 0.0, "{expr} at {at}: {interval:?}");
    }
    let infinite = Expr::constant(f64::INFINITY).log2().min(3.0);
    assert!(!interval(&infinite, 0.0).lo.is_nan());
}

#[test]
fn a_term_stands_once_and_functions_without_kernels_dissolve() {
    let x = Expr::variable(0);
    let square = &x * &x;
    let sum = &square + &square * 2.0;
    assert_eq!(sum.terms().len(), 5);
    let sin = Function::sin();
    let mut graph = Graph::default();
    let port = graph.add(Term::Variable(0));
    let called = graph.insert(&sin.of(&x), &[port]);
    assert_eq!(graph.terms()[called.index()], Term::Of(Primitive::Sin, [port; 3]));
}

#[test]
fn a_branch_that_is_not_taken_may_be_a_pole() {
    let x = Expr::variable(0);
    let guarded = x.equal(0.0).select(0.0, 1.0 / &x);
    let reading = Precise::new(100);
    let at = |x: f64| guarded.read(&reading, &[reading.constant(x)]).map(|big| big.nearest());
    assert_eq!((at(0.0), at(4.0)), (Some(0.0), Some(0.25)));
    assert!((1.0 / &x).read(&reading, &[reading.constant(0.0)]).is_none());
}

/// All readings treat rows alike: the argument is rounded down, and the rows repeat past their end.
#[test]
fn rows_are_read_at_numbers_rounded_down() {
    let values: Vec<f64> = (0..8).map(|i| f64::from(i * i % 7) - 2.5).collect();
    let rows = Rows::new("t.c".to_owned(), values.iter().copied());
    let at = |x: f64| {
        let row = x.floor().rem_euclid(8.0);
        (0_u8..).zip(&values).find(|&(i, _)| f64::from(i) == row).map_or(f64::NAN, |(_, &v)| v)
    };
    let precise = Precise::new(160);
    for x in [-17.5, -8.0, -0.25, 0.0, 0.999, 1.0, 5.5, 7.999, 8.0, 1e15 + 3.0, -1e15 + 1.0] {
        assert_eq!(rows.at(x), at(x), "{x}");
        assert_eq!(Twin.row(&rows, &x), at(x));
        assert_eq!(Scalar.row(&rows, &x), at(x));
        let big = precise.row(&rows, &precise.constant(x)).unwrap();
        assert_eq!(big.nearest(), at(x));
        for width in [0.0, 0.5, 3.25, 7.0, 9.0, 1e9] {
            let over = Outward.row(&rows, &Interval::new(x, x + width));
            let inside = (0..40).map(|i| at(x + width * f64::from(i) / 40.0));
            assert!(inside.into_iter().all(|value| over.contains(value)), "{x} {width}: {over:?}");
            if width == 0.0 {
                assert_eq!(over, Interval::from(at(x)));
            }
        }
    }
    assert!(rows.at(f64::NAN).is_nan() && rows.at(f64::INFINITY).is_nan());
    assert_eq!(Outward.row(&rows, &Interval::ALL), Interval::new(-2.5, 1.5));
    assert_eq!(precise.row(&rows, &None).map(|big| big.nearest()), None);
    let mut graph = Graph::default();
    let x = graph.add(Term::Variable(0));
    let same = Rows::new("t.c".to_owned(), values.iter().copied());
    let [a, b] = [rows.clone(), same].map(|rows| graph.add(Term::Row(rows, x)));
    assert_eq!(a, b, "the same rows at the same place are one term");
    let other = Rows::new("t.c".to_owned(), values.iter().map(|value| value + 1.0));
    assert_ne!(graph.add(Term::Row(other, x)), a);
}
