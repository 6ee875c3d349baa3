//! Table schemes over every word of their arguments, against plain `std` mathematics.

use fixpath::format::{Format, Round};
use fixpath::function::Function;
use fixpath::measure::{TableFigures, table_figures};
use fixpath::netlist::{Builder, Netlist, Quantity};
use fixpath::table::{Scheme, emit};
use fixpath::units::Tabulated;
use std::f64::consts::{PI, TAU};

/// The functions that units tabulate, and others of the same kinds.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Known {
    Sin,
    Cos,
    HalfRecipSin,
    HalfRecipCos,
    Asin,
    Atan,
    Prop,
    Recip,
    Secant,
    Sqrt,
    RecipSqrt,
    Light,
}

impl Known {
    const ALL: [Self; 12] = [
        Self::Sin,
        Self::Cos,
        Self::HalfRecipSin,
        Self::HalfRecipCos,
        Self::Asin,
        Self::Atan,
        Self::Prop,
        Self::Recip,
        Self::Secant,
        Self::Sqrt,
        Self::RecipSqrt,
        Self::Light,
    ];

    fn expression(self) -> Function {
        let half_recip_sin = || Function::new("half_recip_sin", |x| 0.5 / x.sin_turns());
        match self {
            Self::Sin => Function::sin(),
            Self::Cos => Function::cos(),
            Self::HalfRecipSin => half_recip_sin().with_quarter_wave(),
            Self::HalfRecipCos => Function::new("half_recip_cos", |x| 0.5 / x.cos_turns())
                .advanced_of(&half_recip_sin()),
            Self::Asin => Function::asin(),
            Self::Atan => Function::atan(),
            Self::Prop => Function::new("prop", |x| 4.0 * x.asin_turns()),
            Self::Recip => Function::recip(),
            Self::Secant => Function::new("secant", |x| (&x * &x + 1.0).sqrt()),
            Self::Sqrt => Function::sqrt(),
            Self::RecipSqrt => Function::recip_sqrt(),
            Self::Light => Function::new("light", |x| 0.1 + 0.8 * x.max(0.0).pow(33.0)),
        }
    }
}

/// The function in `std` mathematics. At a pole, the limit from above.
fn real(function: Known, x: f64) -> f64 {
    let half_turns = 2.0 * x;
    let quarter_turns = 4.0 * x;
    let odd = |n: f64| n.rem_euclid(2.0) == 1.0;
    match function {
        Known::Sin => (TAU * x).sin(),
        Known::Cos => (TAU * x).cos(),
        Known::HalfRecipSin if half_turns.fract() == 0.0 => {
            if odd(half_turns) {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            }
        }
        Known::HalfRecipSin => 1.0 / (2.0 * (TAU * x).sin()),
        Known::HalfRecipCos if odd(quarter_turns) => {
            // cos falls through 0 at ¼ and rises through it at ¾ = -¼.
            if quarter_turns.rem_euclid(4.0) == 1.0 { f64::NEG_INFINITY } else { f64::INFINITY }
        }
        Known::HalfRecipCos => 1.0 / (2.0 * (TAU * x).cos()),
        Known::Asin => x.clamp(-1.0, 1.0).asin() / TAU,
        Known::Atan => x.atan() / TAU,
        Known::Prop => 1.0 - x.clamp(-1.0, 1.0).acos() / (PI / 2.0),
        Known::Recip => 1.0 / x,
        Known::Secant => 1.0 / x.atan().cos(),
        Known::Sqrt => x.max(0.0).powf(0.5),
        Known::RecipSqrt => x.max(0.0).powf(-0.5),
        Known::Light => {
            let mut power = 1.0;
            for _ in 0..33 {
                power *= x.max(0.0);
            }
            0.1 + 0.8 * power
        }
    }
}

fn format(text: &str) -> Format {
    text.parse().unwrap()
}

/// Each function over its whole domain.
fn tabulated(function: Known, scheme: Scheme, addr_bits: u32, quarter_wave: bool) -> Tabulated {
    let (argument, output, origin): (_, _, f64) = match function {
        Known::Sin | Known::Cos => ("u11f11", "s14f12", 0.0),
        Known::HalfRecipSin | Known::HalfRecipCos => ("s11f11", "s16f11", 0.0),
        Known::Asin => ("s11f10", "s13f13", 0.0),
        Known::Atan => ("s12f8", "s13f13", 0.0),
        Known::Prop => ("s11f10", "s13f11", 0.0),
        Known::Recip => ("u10f11", "u14f12", 0.5),
        Known::Secant => ("u10f10", "u13f12", 0.0),
        Known::Sqrt => ("u10f10", "u13f12", 0.25),
        Known::RecipSqrt => ("u10f10", "u14f12", 0.25),
        Known::Light => ("u10f10", "u13f13", 0.0),
    };
    Tabulated {
        name: "table".to_owned(),
        functions: vec![function.expression()],
        scheme,
        addr_bits,
        quarter_wave,
        origin,
        output: format(output),
        round: Round::HalfUp,
        argument: format(argument),
    }
}

fn netlist(tabulated: &Tabulated) -> Netlist {
    let mut b = Builder::new("alone");
    let argument = b.input("argument", tabulated.argument, Quantity::Number);
    for (i, node) in emit(&mut b, &tabulated.spec(), argument).into_iter().enumerate() {
        b.output(&format!("f{i}"), node);
    }
    b.build().unwrap()
}

/// Argument words, their real values and the words of the first function, from the reference.
fn sweep(tabulated: &Tabulated) -> Vec<(i64, f64, i64)> {
    let netlist = netlist(tabulated);
    let (argument, out) = (tabulated.argument, netlist.outputs()[0].node);
    assert_eq!(netlist.node(out).format, tabulated.output);
    (argument.min_raw()..=argument.max_raw())
        .map(|raw| {
            let x = tabulated.origin + raw as f64 / 2f64.powi(argument.frac_bits());
            (raw, x, netlist.eval(&[raw]).unwrap().0[out.index()])
        })
        .collect()
}

/// The function, saturated to the output format.
fn target(tabulated: &Tabulated, x: f64) -> f64 {
    let output = tabulated.output;
    let ulp = 2f64.powi(-output.frac_bits());
    let (lo, hi) = (output.min_raw() as f64 * ulp, output.max_raw() as f64 * ulp);
    let name = tabulated.functions[0].name();
    let function = Known::ALL.into_iter().find(|known| known.expression().name() == name);
    real(function.expect("a known function"), x).clamp(lo, hi)
}

fn figures(tabulated: &Tabulated) -> TableFigures {
    table_figures(tabulated).unwrap().expect("narrow arguments").remove(0)
}

#[test]
fn worst_errors_are_as_measured() {
    for function in Known::ALL {
        for scheme in Scheme::ALL {
            for addr_bits in [2, 3, 4, 5, 6, 8, 10, 11, 12] {
                for quarter_wave in [false, true] {
                    let tabulated = tabulated(function, *scheme, addr_bits, quarter_wave);
                    let ulp = 2f64.powi(-tabulated.output.frac_bits());
                    let (mut worst, mut jump) = (0f64, 0f64);
                    let mut before: Option<f64> = None;
                    for (_, x, raw) in sweep(&tabulated) {
                        let error = raw as f64 * ulp - target(&tabulated, x);
                        worst = worst.max(error.abs());
                        jump = jump.max(before.map_or(0.0, |before| (error - before).abs()));
                        before = Some(error);
                    }
                    let figures = figures(&tabulated);
                    let label = format!("{function:?} {scheme} {addr_bits} {quarter_wave}");
                    assert!((figures.worst - worst).abs() < 1e-11, "{label}: {worst} {figures:?}");
                    assert!((figures.jump - jump).abs() < 1e-11, "{label}: {jump} {figures:?}");
                    assert!((figures.worst_ulp - figures.worst / ulp).abs() < 1e-9);
                    // The witness gives the worst error.
                    let x = figures.witness;
                    let word = netlist(&tabulated).eval(&[figures.witness_raw]).unwrap().0;
                    let is = word[netlist(&tabulated).outputs()[0].node.index()] as f64 * ulp;
                    assert!(((is - target(&tabulated, x)).abs() - worst).abs() < 1e-11, "{label}");
                }
            }
        }
    }
}

/// With one entry per word, a table is the correctly rounded function in every scheme.
#[test]
fn tables_of_every_word_are_correctly_rounded() {
    for function in Known::ALL {
        for scheme in Scheme::ALL {
            for quarter_wave in [false, true] {
                let tabulated = tabulated(function, *scheme, 12, quarter_wave);
                let scale = 2f64.powi(tabulated.output.frac_bits());
                for (raw, x, word) in sweep(&tabulated) {
                    let mut exact = target(&tabulated, x) * scale;
                    if quarter_wave && exact == tabulated.output.min_raw() as f64 {
                        exact += 1.0; // folding stores magnitudes; this one doesn't fit
                    }
                    let distance = (word as f64 - exact).abs();
                    assert!(
                        distance <= 0.5 + 1e-9,
                        "{function:?} {scheme} {quarter_wave}: {raw} is {word}, {exact}"
                    );
                }
            }
        }
    }
}

#[test]
fn direct_entries_are_the_rounded_mean_of_the_cells_ends() {
    let mut ties = 0;
    for function in Known::ALL {
        for addr_bits in [2, 5, 8] {
            let tabulated = tabulated(function, Scheme::Direct, addr_bits, false);
            let words = sweep(&tabulated);
            let scale = 2f64.powi(tabulated.output.frac_bits());
            // Cells are runs of words with the same top bits; within each sign, words are ordered
            // like their patterns.
            let per_cell = words.len() >> addr_bits;
            for cell in words.chunks(per_cell) {
                let (first, last) = (cell[0], cell[per_cell - 1]);
                let mean = 0.5 * (target(&tabulated, first.1) + target(&tabulated, last.1)) * scale;
                let near_tie = ((mean - mean.floor()) - 0.5).abs() < 1e-6;
                ties += u32::from(near_tie);
                for (raw, _, word) in cell {
                    if near_tie {
                        assert!((*word as f64 - mean).abs() < 0.5 + 1e-5);
                    } else {
                        assert_eq!(*word as f64, mean.round(), "{function:?} at {raw}");
                    }
                }
            }
        }
    }
    assert!(ties < 200, "{ties} ties leave too little to compare");
}

#[test]
fn direct_halves_the_error_of_the_left_edge() {
    for function in [Known::Sin, Known::Cos, Known::Recip, Known::Secant, Known::Atan] {
        for addr_bits in [4, 5, 6] {
            let tabulated = tabulated(function, Scheme::Direct, addr_bits, false);
            let words = sweep(&tabulated);
            let per_cell = words.len() >> addr_bits;
            let left_edge = words
                .chunks(per_cell)
                .flat_map(|cell| {
                    let left = target(&tabulated, cell[0].1);
                    cell.iter().map(move |(_, x, _)| (x, left))
                })
                .map(|(x, left)| (target(&tabulated, *x) - left).abs())
                .fold(0.0, f64::max);
            let worst = figures(&tabulated).worst;
            let half_ulp = 0.5 * 2f64.powi(-tabulated.output.frac_bits());
            // The cell of an extreme lies on one side of the mean of its ends.
            let limit = if matches!(function, Known::Sin | Known::Cos) { 0.52 } else { 0.5 };
            assert!(worst <= limit * left_edge + half_ulp, "{function:?}: {worst} of {left_edge}");
            assert!(worst >= 0.5 * left_edge - half_ulp, "{function:?}: {worst} of {left_edge}");
        }
    }
}

#[test]
fn linear_is_within_its_textbook_error_for_sin() {
    for addr_bits in [2, 3, 4, 5, 6, 8] {
        for quarter_wave in [false, true] {
            let tabulated = tabulated(Known::Sin, Scheme::Linear, addr_bits, quarter_wave);
            let cell_turns = 2f64.powi(-(addr_bits as i32));
            let ulp = 2f64.powi(-tabulated.output.frac_bits());
            // Error of the chord: h²/8 max|f''|, centred h²/16. Rounding of bases and slopes: ¼ ulp
            // / 2 each; of the sum: ½ ulp. Plus 1 % for extremes between the tested words.
            let smooth = cell_turns * cell_turns / 16.0 * TAU * TAU * 1.01;
            let worst = figures(&tabulated).worst;
            assert!(worst <= smooth + ulp * (0.5 + 0.125 + 0.125), "{addr_bits}: {worst}");
            if matches!(addr_bits, 4 | 5) {
                assert!(worst >= 0.9 * smooth - ulp, "{addr_bits}: {worst} of {smooth}");
            }
        }
    }
}

/// Where the function is smooth, bipartite is between direct and linear, without multipliers.
#[test]
fn schemes_in_order_of_error() {
    for function in [Known::Sin, Known::Atan, Known::Recip, Known::Secant] {
        let worst = |scheme| figures(&tabulated(function, scheme, 6, false)).worst;
        let (direct, bipartite, linear) =
            (worst(Scheme::Direct), worst(Scheme::Bipartite), worst(Scheme::Linear));
        assert!(linear <= bipartite && 2.0 * bipartite < direct, "{function:?}");
    }
    let counts = |scheme| netlist(&tabulated(Known::Sin, scheme, 6, false)).counts().schemes;
    assert_eq!(counts(Scheme::Direct), Default::default());
    assert_eq!((counts(Scheme::Linear).multipliers, counts(Scheme::Linear).adders), (1, 1));
    assert_eq!((counts(Scheme::Bipartite).multipliers, counts(Scheme::Bipartite).adders), (0, 1));
}

#[test]
fn poles_saturate_to_both_ends() {
    for scheme in Scheme::ALL {
        for quarter_wave in [false, true] {
            for (function, above, below) in
                [(Known::HalfRecipSin, 0, 1024), (Known::HalfRecipCos, 1536, 512)]
            {
                let tabulated = tabulated(function, *scheme, 11, quarter_wave);
                let netlist = netlist(&tabulated);
                let at = |pattern: i64| {
                    let raw = tabulated.argument.wrap(pattern);
                    let (words, _) = netlist.eval(&[raw]).unwrap();
                    words[netlist.outputs()[0].node.index()]
                };
                let (lo, hi) = (tabulated.output.min_raw(), tabulated.output.max_raw());
                // Folding stores magnitudes; the magnitude of the least word isn't representable.
                let folded_lo = if quarter_wave { -hi } else { lo };
                assert_eq!((at(above), at(below)), (hi, folded_lo), "{function:?} {scheme}");
                assert!((lo..=folded_lo).contains(&at(above - 1)), "{function:?} {scheme}");
                assert_eq!(at(below - 1), hi, "{function:?} {scheme}");
            }
        }
    }
}

#[test]
fn arcsines_end_at_a_quarter_turn() {
    for scheme in Scheme::ALL {
        for addr_bits in [4, 8, 11] {
            let tabulated = tabulated(Known::Asin, *scheme, addr_bits, false);
            let words = sweep(&tabulated);
            let ends = [words[0], words[words.len() - 1]];
            for (_, x, word) in ends {
                let value = word as f64 / 8192.0;
                assert!(value.abs() <= 0.2501, "asin({x}) is {value} turns");
                assert!((value - target(&tabulated, x)).abs() <= figures(&tabulated).worst + 1e-12);
            }
            if addr_bits == 11 {
                assert_eq!(ends[0].2, -2048, "asin(-1) is -¼");
            }
        }
    }
}

#[test]
fn direct_tables_are_monotone_where_the_function_is() {
    for (function, rising) in [
        (Known::Asin, true),
        (Known::Atan, true),
        (Known::Prop, true),
        (Known::Secant, true),
        (Known::Recip, false),
    ] {
        for addr_bits in [2, 4, 7, 10, 11] {
            let tabulated = tabulated(function, Scheme::Direct, addr_bits, false);
            let words = sweep(&tabulated);
            for pair in words.windows(2) {
                let step = pair[1].2 - pair[0].2;
                assert!(
                    if rising { step >= 0 } else { step <= 0 },
                    "{function:?} at {}",
                    pair[1].0
                );
            }
            assert_eq!(figures(&tabulated).not_monotone, 0);
        }
    }
    // The test isn't idle: a coarse bipartite table steps back at joints near the crests.
    let mut coarse = tabulated(Known::Sin, Scheme::Bipartite, 6, false);
    coarse.output = format("s18f16");
    let sine = sweep(&coarse);
    let back = sine
        .windows(2)
        .filter(|pair| {
            let own = target(&coarse, pair[1].1) - target(&coarse, pair[0].1);
            (pair[1].2 - pair[0].2) as f64 * own < 0.0
        })
        .count();
    assert!(back > 0, "the table steps back somewhere");
    assert_eq!(figures(&coarse).not_monotone, back as u64);
}

#[test]
fn stored_bits_follow_the_widths() {
    let counts = |scheme, addr_bits, quarter_wave| {
        netlist(&tabulated(Known::Sin, scheme, addr_bits, quarter_wave)).counts()
    };
    for addr_bits in [3, 6, 10] {
        // 14-bit words; a quarter turn of 13-bit magnitudes.
        assert_eq!(counts(Scheme::Direct, addr_bits, false).rom_bits, 14 << addr_bits);
        assert_eq!(counts(Scheme::Direct, addr_bits, true).rom_bits, 13 << (addr_bits - 2));
    }
    for scheme in [Scheme::Linear, Scheme::Bipartite] {
        let netlist = netlist(&tabulated(Known::Sin, scheme, 6, false));
        let mut bits = 0;
        for table in netlist.tables() {
            for column in &table.columns {
                assert_eq!(column.words.len(), 64);
                // Each column has the narrowest format for its words.
                let (lo, hi) =
                    (column.words.iter().min().unwrap(), column.words.iter().max().unwrap());
                let narrower = Format::new(
                    column.format.is_signed(),
                    column.format.bits() - 1,
                    column.format.frac_bits(),
                );
                assert!(narrower.is_ok_and(|f| !(f.contains(*lo) && f.contains(*hi))));
                bits += 64 * u64::from(column.format.bits());
            }
        }
        assert_eq!(netlist.counts().rom_bits, bits);
    }
    // A table never has more addresses than its argument has words.
    let sizes = |addr_bits| counts(Scheme::Direct, addr_bits, false).rom_bits;
    assert_eq!(sizes(20), sizes(11));
}

#[test]
fn identical_tables_are_stored_once() {
    let tabulated = tabulated(Known::Sin, Scheme::Linear, 6, false);
    let mut b = Builder::new("shared");
    let [p, q] = ["p", "q"].map(|name| b.input(name, tabulated.argument, Quantity::Number));
    for (i, argument) in [p, q, p].into_iter().enumerate() {
        let node = emit(&mut b, &tabulated.spec(), argument)[0];
        b.output(&format!("f{i}"), node);
    }
    let netlist = b.build().unwrap();
    let counts = netlist.counts();
    assert_eq!((counts.tables, counts.reads, counts.ports), (1, 4, 2));
    assert_eq!(counts.rom_bits, counts.rom_bits_dual_port);
    assert_eq!(netlist.outputs()[0].node, netlist.outputs()[2].node);
    assert_eq!(counts.schemes.multipliers, 2);
}

/// On reals a table is its function of the argument, for every word.
#[test]
fn tables_stand_for_their_functions() {
    for function in Known::ALL {
        for scheme in Scheme::ALL {
            let tabulated = tabulated(function, *scheme, 6, false);
            let netlist = netlist(&tabulated);
            let out = netlist.outputs()[0].node;
            assert_eq!(netlist.node(out).real.is_some(), tabulated.origin == 0.0, "{function:?}");
            if tabulated.origin != 0.0 {
                continue;
            }
            for (_, x, _) in sweep(&tabulated) {
                let (is, should) = (netlist.eval_reals(&[x])[out.index()], real(function, x));
                let close = is == should || (is - should).abs() <= 1e-11 * should.abs().max(1.0);
                assert!(close, "{function:?} {scheme} at {x}: {is} and not {should}");
            }
        }
    }
}
