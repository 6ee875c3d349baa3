//! Nodes with operators, and formats of nodes by name.

use crate::engines::{Random, check};
use fixpath::error::Result;
use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{
    Builder, Column, Netlist, NodeId, Overrides, Part, Quantity, Table, Wire, Wires, with_formats,
};
use std::collections::BTreeMap;
use std::sync::Arc;

fn format(text: &str) -> Format {
    text.parse().unwrap()
}

fn doubles() -> Table {
    let words: Vec<i64> = (0..16).map(|i| 2 * i).collect();
    let column =
        Column { name: "twice".to_owned(), format: format("u5f0"), words: Arc::from(words) };
    Table { name: "doubles".to_owned(), addr_bits: 4, columns: vec![column], memory: None }
}

/// Each operator is the builder's operation: both give the same netlist.
#[test]
fn operators_are_the_builders_operations() {
    let w = Wires::new("both");
    let (a, b) = (w.input("a", format("s8f4")), w.input("b", format("s8f4")));
    let phase = w.angle("phase", format("u6f6"));
    let table = w.table(doubles());
    let sum = &a + &b;
    let product = w.scope("inner", || (&a * &b).named("product"));
    let mixed = a.clone() * 0.75 - (1.5 - &b) + &sum;
    let bits = w.part(Part::Scheme, "bits", || phase.bits(0..4).read(table, 0));
    let flag = a.lt(&b) ^ b.gt(&a) & a.equals(&b) | a.negative();
    let chosen = flag.mux(&(-&a).abs(), &(b.clone() >> 3));
    let moved = flag.addsub(&chosen, &(&product << 2));
    let turned = (&phase + w.word(16, format("u6f6"))).modulo(format("u6f6")).turns();
    let zeros = phase.bits(1..6).leading_zeros();
    let up = bits.shift_left(&zeros, 3).concat(&phase.bits(0..1));
    let small = mixed.narrow(format("s9f4"), Round::HalfEven, Overflow::Saturate).named("small");
    for (name, wire) in [("small", &small), ("moved", &moved), ("turned", &turned), ("up", &up)] {
        w.output(&format!("{name}_out"), wire);
    }
    let by_wires = w.build().unwrap();

    let mut n = Builder::new("both");
    let a = n.input("a", format("s8f4"), Quantity::Number);
    let b = n.input("b", format("s8f4"), Quantity::Number);
    let phase = n.input("phase", format("u6f6"), Quantity::Turns);
    let table = n.table(doubles());
    let sum = n.add(a, b);
    let product = n.scope("inner", |n| {
        let product = n.mul(a, b);
        n.name(product, "product")
    });
    let three_quarters = n.constant(3, format("u2f2"));
    let mixed = n.mul(a, three_quarters);
    let one_and_half = n.constant(3, format("u2f1"));
    let rest = n.sub(one_and_half, b);
    let mixed = n.sub(mixed, rest);
    let mixed = n.add(mixed, sum);
    let bits = n.part(Part::Scheme, "bits", |n| {
        let address = n.slice(phase, 0, 4);
        n.read(table, 0, address)
    });
    let below = n.less(a, b);
    let above = n.less(a, b);
    let same = n.equal(a, b);
    let both = n.and(above, same);
    let flag = n.xor(below, both);
    let sign = n.negative(a);
    let flag = n.or(flag, sign);
    let minus = n.neg(a);
    let size = n.abs(minus);
    let down = n.shift(b, -3);
    let chosen = n.mux(flag, size, down);
    let left = n.shift(product, 2);
    let moved = n.addsub(flag, chosen, left);
    let quarter = n.constant(16, format("u6f6"));
    let turned = n.add(phase, quarter);
    let turned = n.modulo(turned, format("u6f6"));
    n.turns(turned);
    let upper = n.slice(phase, 1, 5);
    let zeros = n.leading_zeros(upper);
    let up = n.shift_left(bits, zeros, 3);
    let low = n.slice(phase, 0, 1);
    let up = n.concat(up, low);
    let small = n.narrow(mixed, format("s9f4"), Round::HalfEven, Overflow::Saturate);
    n.name(small, "small");
    for (name, node) in [("small", small), ("moved", moved), ("turned", turned), ("up", up)] {
        n.output(&format!("{name}_out"), node);
    }
    assert_eq!(by_wires.to_text(), n.build().unwrap().to_text());
    check(&by_wires, 1, 300).unwrap();
}

/// A real number beside a wire is a constant of exactly that value, in the smallest format that
/// holds it.
#[test]
fn constants_are_exact() {
    let cases = [
        (0.0, 0, "u1f0"),
        (-0.0, 0, "u1f0"),
        (1.0, 1, "u1f0"),
        (-1.0, -1, "s1f0"),
        (6.0, 6, "u3f0"),
        (-8.0, -8, "s4f0"),
        (0.375, 3, "u2f3"),
        (-0.375, -3, "s3f3"),
        (1e6, 1_000_000, "u20f0"),
        (0.1, 0xc_cccc_cccc_cccd, "u52f55"),
        (9_223_372_036_854_774_784.0, 9_223_372_036_854_774_784, "u63f0"),
        (9_223_372_036_854_775_808.0, 1, "u1e63"),
        (-4_611_686_018_427_387_904.0, -(1 << 62), "s63f0"),
        (2f64.powi(-127), 1, "u1f127"),
        (2f64.powi(127), 1, "u1e127"),
    ];
    for (value, raw, text) in cases {
        let w = Wires::new("constant");
        let constant = w.constant(value);
        assert_eq!(constant.format(), format(text), "{value}");
        w.output("out", &constant);
        let netlist = w.build().unwrap();
        let word = netlist.eval(&[]).unwrap().0[0];
        assert_eq!(word, raw, "{value}");
        assert_eq!(format(text).value(word), value);
    }
    let none = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e-300, 5e-324, f64::MAX, 2f64.powi(128)];
    for value in none {
        let w = Wires::new("constant");
        let x = w.input("x", format("s4f0"));
        w.output("out", &(x + value));
        let why = w.build().unwrap_err().to_string();
        let start = format!(
            "constant {value}: no format of up to 63 bits and 127 fraction bits has exactly this value ("
        );
        assert!(why.starts_with(&start) && why.contains("wires.rs:"), "{why}");
    }
}

/// Expressions of random wires against the same expressions in integers.
#[test]
fn expressions_are_exact() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let w = Wires::new("random");
        // Values in units of 2^-8.
        let ports: Vec<Wire> = (0..3).map(|i| w.input(&format!("in{i}"), format("s5f2"))).collect();
        let words: Vec<i64> = (0..3).map(|_| random.within(-16, 15)).collect();
        let mut known: Vec<(Wire, i128, u32)> = ports
            .iter()
            .zip(&words)
            .map(|(port, word)| (port.clone(), i128::from(*word) * 64, 1))
            .collect();
        for _ in 0..12 {
            let [(a, x, m), (b, y, n)] = [0; 2].map(|_| known[random.below(known.len())].clone());
            let c = random.within(-20, 20);
            let next = match random.below(6) {
                0 => (&a + b, x + y, m.max(n)),
                1 => (a - &b, x - y, m.max(n)),
                2 => (-a, -x, m),
                3 => (a + c as f64 * 0.25, x + i128::from(c) * 64, m),
                4 => (c as f64 - &a, i128::from(c) * 256 - x, m),
                _ if m + n <= 4 => (&a * &b, x * y / 256, m + n),
                _ => (a.lt(&b).mux(&b, &a), x.max(y), m.max(n)),
            };
            known.push(next);
        }
        let (last, value, _) = known.pop().unwrap();
        w.output("out", &last);
        let out = last.format();
        let netlist = w.build().unwrap();
        let word = netlist.eval(&words).unwrap().0[netlist.outputs()[0].node.index()];
        assert_eq!(
            i128::from(word) << (8 - out.frac_bits()).max(0),
            value,
            "{}",
            netlist.to_text()
        );
    }
}

#[test]
fn wrong_use_of_wires_is_an_error_with_its_line() {
    let why = |wrong: &dyn Fn(&Wires, &Wire)| {
        let w = Wires::new("wrong");
        let x = w.input("x", format("s40f0"));
        w.output("y", &x);
        wrong(&w, &x);
        let error = w.build().unwrap_err();
        let caller = error.caller().unwrap();
        assert!(caller.file().ends_with("wires.rs"), "{caller}");
        (error.to_string(), caller.line())
    };
    let (text, line) = why(&|_, x| drop(x * x));
    assert!(text.starts_with("node `mul of x (s40f0), x (s40f0)` needs 80 bits"), "{text}");
    assert_eq!(line, line!() - 2);
    let (text, line) = why(&|_, x| drop(x.lt(x) & x));
    assert!(text.ends_with("`: bitwise operands must have the same format"), "{text}");
    assert_eq!(line, line!() - 2);
    let (text, line) = why(&|_, x| drop(x.bits(7..7)));
    assert!(text.starts_with("slice of x (s40f0): a slice needs at least one bit ("), "{text}");
    assert_eq!(line, line!() - 2);
    #[expect(clippy::reversed_empty_ranges, reason = "wrong on purpose")]
    let (text, _) = why(&|_, x| drop(x.bits(9..7)));
    assert!(text.starts_with("slice of x (s40f0): a slice needs at least one bit ("), "{text}");
    let (text, _) = why(&|w, x| drop(w.word(9, format("s4f0")) + x));
    assert!(text.starts_with("node `const`: word 9 is outside s4f0"), "{text}");
    let (text, _) = why(&|_, x| drop(x.clone().named("Sum")));
    assert!(text.starts_with("node `Sum`: a name is a letter a to z"), "{text}");

    // Wires of two netlists: an error of the netlist that received the other's wire, in any order
    // and place.
    for swapped in [false, true] {
        let (one, other) = (Wires::new("one"), Wires::new("other"));
        let (x, y) = (one.input("x", format("s4f0")), other.input("x", format("s4f0")));
        other.output("y", &y);
        let sum = if swapped { &y + &x } else { &x + &y };
        one.output("y", &sum);
        let built = [one.build(), other.build()];
        let errors: Vec<bool> = built.iter().map(Result::is_err).collect();
        assert_eq!(errors, [true, swapped]);
        let text = built[0].as_ref().unwrap_err().to_string();
        assert!(text.contains("another builder"), "{text}");
    }

    // Wires may outlive their netlist: they are then useless but harmless.
    let w = Wires::new("over");
    let (again, x) = (w.clone(), w.input("x", format("s4f0")));
    w.output("y", &x);
    let inside = again.clone();
    w.scope("inner", || inside.build()).unwrap();
    let sum = &x + &x;
    let _ = (sum.format(), sum.named("z"), w.constant(3.0));
    assert!(w.build().is_err() && again.build().is_err());

    // Wires can't be used while the builder itself is in use.
    let w = Wires::new("rests");
    let x = w.input("x", format("s4f0"));
    let y = w.builder(|b| b.neg(x.id()));
    w.output("y", &w.wire(y));
    w.builder(|_| drop(&x + &x));
    let text = w.build().unwrap_err().to_string();
    assert!(text.contains("another builder"), "{text}");
}

/// Narrows of all kinds: named and unnamed, in scopes, repeated, without effect, and unused.
fn recipe(overrides: &Overrides) -> Result<Netlist> {
    let w = Wires::with("recipe", overrides);
    let (floor, wrap, even) = (Round::Floor, Overflow::Wrap, Round::HalfEven);
    let (x, y) = (w.input("x", format("s8f4")), w.input("y", format("s8f4")));
    let first = (&x * &y).narrow(format("s10f5"), even, Overflow::Saturate);
    let named = (&first + &x).narrow(format("s12f6"), floor, wrap).named("named");
    let inner = w.scope("inner", || {
        let dead = (&x + &y).narrow(format("s3f1"), floor, wrap);
        drop(dead);
        let one = (&named * &named).narrow(format("s12f4"), floor, wrap);
        // Without effect, and repeated: no nodes of their own.
        let same = one.narrow(format("s12f4"), floor, wrap);
        let again = (&named * &named).narrow(format("s12f4"), floor, wrap);
        let last = (&same - &y).narrow(format("s9f3"), floor, wrap);
        again + last
    });
    w.scope("inner", || w.output("inner", &inner.narrow(format("s9f2"), floor, wrap)));
    // Beside a name that equals its automatic name.
    let other = (&x - &y).narrow(format("s6f2"), floor, wrap);
    let taken = (&y + &y).narrow(format("s6f1"), floor, wrap).named("narrow_3");
    w.output("sum", &(other + taken));
    let size = w.builder(|b| b.table_format("roots", format("u9f8")));
    w.output("size", &(first * w.word(1, size)));
    w.build()
}

fn formats(netlist: &Netlist) -> BTreeMap<&str, String> {
    let choices = netlist.choices().iter();
    choices.map(|choice| (&choice.name[..], choice.format.to_string())).collect()
}

#[test]
fn nodes_have_stable_names() {
    let plain = recipe(&Overrides::default()).unwrap();
    let expected = [
        ("inner.narrow_2", "s12f4"),
        ("inner.narrow_5", "s9f3"),
        ("inner.narrow_6", "s9f2"),
        ("named", "s12f6"),
        ("narrow", "s10f5"),
        ("narrow_3", "s6f1"),
        ("narrow_3_here", "s6f2"),
        ("roots", "u9f8"),
    ];
    let expected: BTreeMap<&str, String> = expected.map(|(n, f)| (n, f.to_owned())).into();
    assert_eq!(formats(&plain), expected);
    for choice in plain.choices() {
        assert!(!choice.overridden);
        if let Some(node) = choice.node {
            assert_eq!(plain.stable_name(node), Some(&choice.name[..]));
            assert_eq!(plain.node(node).format, choice.format);
        }
    }
    assert_eq!(plain.stable_name(plain.inputs()[0]), None);
    // Names are kept beside the netlist: its text has none.
    assert!(!plain.to_text().contains("inner.narrow_2"));
}

/// One format is overridden: that node has it, all others keep theirs, and dependent formats
/// follow.
#[test]
fn a_format_by_name_changes_that_node() {
    let plain = recipe(&Overrides::default()).unwrap();
    for choice in plain.choices() {
        for bits in [2, 7, 13] {
            let to = Format::new(choice.format.is_signed(), bits, 3).unwrap();
            let name = &choice.name[..];
            let changed = with_formats(&[(name, to)], recipe).unwrap();
            check(&changed, 5, 200).unwrap();
            let (mut before, mut after) = (formats(&plain), formats(&changed));
            assert_eq!(after.remove(name), Some(to.to_string()), "{name}");
            before.remove(name);
            // A narrow that had no effect may have one now.
            after.remove("inner.narrow_3");
            assert_eq!(before, after, "{name} {to}");
            let overridden: Vec<&str> = changed
                .choices()
                .iter()
                .filter(|choice| choice.overridden)
                .map(|choice| &choice.name[..])
                .collect();
            assert_eq!(overridden, [name]);
            let ports =
                |n: &Netlist| n.inputs().iter().map(|id| n.node(*id).format).collect::<Vec<_>>();
            assert_eq!(ports(&plain), ports(&changed));
        }
    }
    // All set at once, each to its own format, give the recipe itself.
    let own: Vec<(&str, Format)> =
        plain.choices().iter().map(|choice| (&choice.name[..], choice.format)).collect();
    let same = with_formats(&own, recipe).unwrap();
    assert_eq!(same.to_text(), plain.to_text());
    assert_eq!(formats(&same), formats(&plain));
    let none: &[(&str, Format)] = &[];
    assert_eq!(with_formats(none, recipe).unwrap().to_text(), plain.to_text());
}

#[test]
fn formats_of_nodes_that_are_not_there_are_refused() {
    let why = |formats: &[(&str, Format)]| with_formats(formats, recipe).unwrap_err().to_string();
    let to = format("s5f2");
    let text = why(&[("inner.narow_2", to)]);
    let start = "netlist `recipe` has no node `inner.narow_2` whose format can be set, did you mean `inner.narrow_2`: there are narrow, named, ";
    assert!(text.starts_with(start), "{text}");
    assert!(
        why(&[("x", to)]).starts_with("netlist `recipe` has no node `x` whose format can be set: ")
    );
    assert_eq!(why(&[("named", to), ("named", to)]), "the format of node `named` is given twice");
    let long = "z".repeat(100_000);
    assert!(why(&[(&long, to)]).len() < 2000);
    // A recipe whose nodes depend on formats.
    let moody = |overrides: &Overrides| {
        let w = Wires::with("moody", overrides);
        let x = w.input("x", format("s8f4"));
        let y = (&x * &x).narrow(format("s8f4"), Round::Floor, Overflow::Wrap).named("y");
        let z = if y.format().bits() > 4 {
            (&y + &x).narrow(format("s6f2"), Round::Floor, Overflow::Wrap).named("z")
        } else {
            y
        };
        w.output("out", &z);
        w.build()
    };
    with_formats(&[("z", to), ("y", to)], moody).unwrap();
    let gone = with_formats(&[("z", to), ("y", format("s3f0"))], moody).unwrap_err().to_string();
    assert_eq!(gone, "with these formats, `moody` has no node `z`: leave its format out");
    // A word that becomes too wide downstream is an ordinary error.
    let wide = with_formats(&[("named", format("s40f20"))], recipe).unwrap_err().to_string();
    assert!(
        wide.starts_with("node `mul of named (s40f20), named (s40f20)` needs 80 bits"),
        "{wide}"
    );
    let empty = |_: &Overrides| {
        let mut b = Builder::new("empty");
        let x: NodeId = b.input("x", format("s8f4"), Quantity::Number);
        b.output("y", x);
        b.build()
    };
    let none = with_formats(&[("y", to)], empty).unwrap_err().to_string();
    assert_eq!(none, "netlist `empty` has no node `y` whose format can be set: there is none");
}
