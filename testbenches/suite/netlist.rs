//! Building netlists, their text forms and their counts.

use crate::common::design;
use expect_test::expect;
use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Column, Counts, Netlist, Part, Quantity, Table};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

fn format(text: &str) -> Format {
    text.parse().unwrap()
}

fn square_table() -> Table {
    let words: Vec<i64> = (0..8).map(|i| i * i).collect();
    let column = |name: &str, words: Vec<i64>, text: &str| Column {
        name: name.to_owned(),
        format: format(text),
        words: Arc::from(words),
    };
    let halves = words.iter().map(|word| word / 2 - 12).collect();
    Table {
        name: "squares".to_owned(),
        addr_bits: 3,
        columns: vec![column("square", words, "u6f3"), column("half", halves, "s5f1")],
    }
}

/// One of most things: a table with two columns, scopes, dead nodes, shared nodes.
fn small() -> Netlist {
    let mut b = Builder::new("small");
    let a = b.input("a", format("u3f0"), Quantity::Number);
    let phase = b.input("phase", format("u8f8"), Quantity::Turns);
    let table = b.table(square_table());
    let unused = b.table(Table { name: "unused".to_owned(), ..square_table() });
    let dead = b.read(unused, 0, a);
    let _ = b.mul(dead, dead);
    let sum = b.part(Part::Scheme, "lookup", |b| {
        let square = b.read(table, 0, a);
        let half = b.read(table, 1, a);
        b.name(half, "half");
        b.add(square, half)
    });
    let top = b.scope("tail", |b| {
        let top = b.slice(phase, 6, 2);
        let product = b.mul(sum, top);
        b.name(product, "product");
        product
    });
    let small = b.narrow(top, format("s6f1"), Round::HalfEven, Overflow::Saturate);
    b.name(small, "result");
    b.output("result", small);
    let turned = b.constant(64, format("u8f8"));
    let turned = b.add(phase, turned);
    let turned = b.modulo(turned, format("u8f8"));
    b.turns(turned);
    b.output("turned", turned);
    b.build().unwrap()
}

#[test]
fn text_form() {
    expect![[r#"
        netlist small
          table squares[8]: square u6f3, half s5f1
          %0 = input : u3f0  # a
          %1 = input : u8f8 turns  # phase
          %2 = read squares.square %0 : u6f3
          %3 = read squares.half %0 : s5f1  # lookup.half
          %4 = add %2 %3 : s8f3
          %5 = slice[7:6] %1 : u2f0
          %6 = mul %4 %5 : s10f3  # tail.product
          %7 = narrow half-even saturate %6 : s6f1  # result
          %8 = const 64 : u8f8
          %9 = add %1 %8 : u9f8
          %10 = modulo %9 : u8f8 turns
          output result = %7
          output turned = %10
    "#]]
    .assert_eq(&small().to_text());
}

#[test]
fn dot_form() {
    expect![[r##"
        digraph small {
          rankdir=LR;
          node [shape=box, fontname="sans-serif", fontsize=10];
          n0 [label="a\ninput\nu3f0", shape=cds];
          n1 [label="phase\ninput\nu8f8", shape=cds];
          n7 [label="result\nnarrow half-even saturate\ns6f1"];
          n8 [label="const 64\nu8f8"];
          n9 [label="add\nu9f8"];
          n10 [label="modulo\nu8f8"];
          subgraph cluster_1 { label="lookup"; color=gray;
            n2 [label="read squares.square\nu6f3", shape=cylinder];
            n3 [label="half\nread squares.half\ns5f1", shape=cylinder];
            n4 [label="add\ns8f3", style=dotted];
          }
          subgraph cluster_2 { label="tail"; color=gray;
            n5 [label="slice[7:6]\nu2f0"];
            n6 [label="product\nmul\ns10f3", style=filled, fillcolor="#ffd9b3"];
          }
          n0 -> n2;
          n0 -> n3;
          n2 -> n4;
          n3 -> n4;
          n1 -> n5;
          n4 -> n6;
          n5 -> n6;
          n6 -> n7;
          n1 -> n9;
          n8 -> n9;
          n9 -> n10;
          out_result [label="result", shape=cds]; n7 -> out_result;
          out_turned [label="turned", shape=cds]; n10 -> out_turned;
        }
    "##]]
    .assert_eq(&small().to_dot());
}

#[test]
fn the_same_operation_is_built_once() {
    let mut b = Builder::new("shared");
    let a = b.input("a", format("u3f0"), Quantity::Number);
    let other = b.input("other", format("u3f0"), Quantity::Number);
    let table = b.table(square_table());
    assert_eq!(b.table(square_table()), table, "an equal table is the same");
    let read = b.read(table, 0, a);
    assert_eq!(b.scope("elsewhere", |b| b.read(table, 0, a)), read);
    assert_ne!(b.read(table, 1, a), read, "another column");
    assert_ne!(b.read(table, 0, other), read, "another address");
    assert_ne!(a, other, "ports of one format are two");
    let sum = b.add(a, other);
    assert_eq!(b.add(a, other), sum);
    assert_eq!(b.constant(3, format("u3f0")), b.constant(3, format("u3f0")));
    assert_ne!(b.constant(3, format("u3f0")), b.constant(3, format("u3f1")));
    let narrow = |b: &mut Builder, round| b.narrow(sum, format("u2f0"), round, Overflow::Wrap);
    let floor = narrow(&mut b, Round::Floor);
    assert_eq!(narrow(&mut b, Round::Floor), floor);
    assert_ne!(narrow(&mut b, Round::HalfUp), floor);
    // What would change nothing is not built, but symmetric saturation changes a word.
    let (same, signed) = (format("u4f0"), format("s4f0"));
    assert_eq!(b.narrow(sum, same, Round::Floor, Overflow::Error), sum);
    assert_eq!(b.modulo(sum, same), sum);
    assert_eq!(b.shift(sum, 0), sum);
    let cut = b.narrow(sum, signed, Round::Floor, Overflow::Wrap);
    assert_ne!(b.narrow(cut, signed, Round::Floor, Overflow::Symmetric), cut);
    b.output("sum", sum);
    let read_again = b.read(table, 0, a);
    b.output("read", read_again);
    let netlist = b.build().unwrap();
    assert_eq!(netlist.counts().reads, 1);
    assert_eq!(netlist.counts().ports, 1);
}

#[test]
fn what_no_output_needs_is_dropped() {
    let netlist = small();
    let tables: Vec<&str> = netlist.tables().iter().map(|table| table.name.as_str()).collect();
    assert_eq!(tables, ["squares"]);
    assert!(!netlist.to_text().contains("unused"));
    let mut needed: BTreeSet<usize> = netlist.outputs().iter().map(|o| o.node.index()).collect();
    for (i, node) in netlist.nodes().iter().enumerate().rev() {
        if needed.contains(&i) {
            needed.extend(node.operands.iter().map(|id| id.index()));
        }
        assert!(node.operands.iter().all(|id| id.index() < i), "operands come first");
    }
    assert_eq!(needed.len(), netlist.nodes().len());

    // Ports stay, used or not, in their order.
    let mut b = Builder::new("idle");
    let a = b.input("a", format("u3f0"), Quantity::Number);
    b.input("idle", format("u5f0"), Quantity::Number);
    b.output("same", a);
    let netlist = b.build().unwrap();
    assert_eq!((netlist.input_name(0), netlist.input_name(1)), ("a", "idle"));
    assert_eq!(netlist.eval(&[5, 9]).unwrap().0, [5, 9]);
}

#[test]
fn names_stay_unique_in_their_scope() {
    let mut b = Builder::new("names");
    let a = b.input("a", format("s4f0"), Quantity::Number);
    let mut nodes = Vec::new();
    for i in 0..3 {
        let constant = b.constant(i, format("s4f0"));
        let sum = b.add(a, constant);
        b.name(sum, "sum");
        b.name(sum, "second");
        nodes.push(sum);
    }
    let inner = b.scope("inner", |b| {
        let product = b.mul(a, a);
        b.name(product, "sum")
    });
    let taken = b.abs(a);
    b.name(taken, "sum_2");
    nodes.extend([inner, taken]);
    let nameless = b.neg(a);
    nodes.push(nameless);
    for (i, node) in nodes.iter().enumerate() {
        b.output(&format!("out{i}"), *node);
    }
    let netlist = b.build().unwrap();
    let labels: Vec<String> = netlist.outputs().iter().map(|o| netlist.label(o.node)).collect();
    assert_eq!(labels[..5], ["sum", "sum_2", "sum_3", "inner.sum", "sum_2_2"]);
    assert!(labels[5].starts_with('%'), "{labels:?}");
    let unique: BTreeSet<&String> = labels.iter().collect();
    assert_eq!(unique.len(), labels.len());
}

/// Names from `<what>: <text>` messages that wrong code gets.
fn panic_of(body: impl FnOnce() + std::panic::UnwindSafe) -> String {
    let payload = std::panic::catch_unwind(body).unwrap_err();
    match payload.downcast_ref::<String>() {
        Some(text) => text.clone(),
        None => (*payload.downcast_ref::<&str>().unwrap()).to_owned(),
    }
}

#[test]
fn names_that_hardware_languages_refuse_are_bugs() {
    for name in ["", "A", "1a", "a-b", "a__b", "a_", "_a", "é", "a b"] {
        let message = panic_of(move || {
            let mut b = Builder::new("names");
            let a = b.input("a", Format::FLAG, Quantity::Number);
            b.output(name, a);
            drop(b.build());
        });
        assert_eq!(message, format!("bug: output name `{name}`"));
    }
    let message = panic_of(|| {
        let mut b = Builder::new("names");
        let a = b.input("a", Format::FLAG, Quantity::Number);
        b.output("twice", a);
        b.output("twice", a);
        drop(b.build());
    });
    assert_eq!(message, "bug: output name `twice`");
    let message = panic_of(|| drop(Builder::new("empty").build()));
    assert_eq!(message, "bug: `empty` has no output");
}

#[test]
fn tables_of_no_or_too_many_address_bits_are_refused() {
    let mut b = Builder::new("tables");
    let a = b.input("a", Format::FLAG, Quantity::Number);
    b.output("a_out", a);
    let column = Column { name: "c".to_owned(), format: Format::FLAG, words: Arc::from([1]) };
    b.table(Table { name: "tiny".to_owned(), addr_bits: 0, columns: vec![column] });
    let message = b.build().unwrap_err().to_string();
    assert_eq!(message, "node `tiny`: 0 address bits: legal is 1 to 30");
}

fn rotation(assignments: &[&str]) -> Netlist {
    Netlist::clone(&design("rotation", assignments).netlist)
}

#[test]
fn the_seeds_hardware_is_counted() {
    for variant in ["printed", "corrected"] {
        let counts = rotation(&[&format!("variant={variant}")]).counts();
        assert_eq!(
            (counts.datapath.multipliers, counts.datapath.adders, counts.tables),
            (3, 8, 6),
            "{variant}"
        );
        assert_eq!(counts.schemes.multipliers + counts.schemes.adders, 0);
    }
    let counts = rotation(&["variant=exact", "output=cartesian", "scheme=direct"]).counts();
    assert_eq!(counts.datapath.multipliers, 0);
    assert_eq!((counts.tables, counts.reads, counts.ports), (1, 14, 8));
    // 2^10 rows of sin and cos, 20 bits each (two whole bits with the sign, 18 fraction bits).
    assert_eq!(counts.rom_bits, 1024 * 2 * 20);
    assert_eq!(counts.rom_bits_dual_port, 4 * counts.rom_bits);
}

/// Counts again from the text form, which shows no scopes: schemes and datapath together.
fn recount(text: &str) -> BTreeMap<&'static str, u64> {
    let mut counts = BTreeMap::new();
    let mut rows: BTreeMap<&str, (u64, u64)> = BTreeMap::new();
    let mut ports: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    let mut add = |what, count: u64| *counts.entry(what).or_insert(0) += count;
    for line in text.lines().map(str::trim) {
        if let Some(table) = line.strip_prefix("table ") {
            let (head, columns) = table.split_once(": ").unwrap();
            let (name, rest) = head.split_once('[').unwrap();
            let row: u64 = columns
                .split(", ")
                .map(|column| column.split(' ').next_back().unwrap().parse::<Format>().unwrap())
                .map(|format| u64::from(format.bits()))
                .sum();
            rows.insert(name, (rest.trim_end_matches(']').parse().unwrap(), row));
            add("tables", 1);
        } else if let Some((_, operation)) =
            line.split_once(" = ").filter(|(id, _)| id.starts_with('%'))
        {
            let words: Vec<&str> = operation.split_whitespace().collect();
            match words[0] {
                "mul" => add("multipliers", 1),
                "add" | "sub" | "addsub" => add("adders", 1),
                "neg" | "abs" => add("negations", 1),
                "equal" | "less" => add("comparators", 1),
                "mux" => add("multiplexers", 1),
                "shift_left" | "leading_zeros" => add("shifters", 1),
                "narrow" => add("narrows", 1),
                "read" => {
                    add("reads", 1);
                    let table = words[1].split_once('.').unwrap().0;
                    ports.entry(table).or_default().insert(words[2]);
                }
                _ => {}
            }
        }
    }
    for (name, (entries, row)) in rows {
        let ports = ports[name].len() as u64;
        add("ports", ports);
        add("rom_bits", entries * row);
        add("rom_bits_dual_port", entries * row * ports.div_ceil(2));
    }
    counts
}

fn flat(counts: &Counts) -> BTreeMap<&'static str, u64> {
    let (d, s) = (&counts.datapath, &counts.schemes);
    [
        ("multipliers", d.multipliers + s.multipliers),
        ("adders", d.adders + s.adders),
        ("negations", d.negations + s.negations),
        ("comparators", d.comparators + s.comparators),
        ("multiplexers", d.multiplexers + s.multiplexers),
        ("shifters", d.shifters + s.shifters),
        ("narrows", d.narrows + s.narrows),
        ("tables", counts.tables),
        ("reads", counts.reads),
        ("ports", counts.ports),
        ("rom_bits", counts.rom_bits),
        ("rom_bits_dual_port", counts.rom_bits_dual_port),
    ]
    .into_iter()
    .filter(|(_, count)| *count > 0)
    .collect()
}

#[test]
fn counts_are_those_of_the_text() {
    assert_eq!(flat(&small().counts()), recount(&small().to_text()));
    for form in [
        "printed,auto",
        "corrected,auto",
        "exact,cartesian",
        "exact,polar-cordic",
        "exact,polar-table",
    ] {
        for scheme in ["direct", "linear", "bipartite"] {
            for wave in ["off", "on"] {
                let (variant, output) = form.split_once(',').unwrap();
                let netlist = rotation(&[
                    &format!("variant={variant}"),
                    &format!("output={output}"),
                    &format!("scheme={scheme}"),
                    &format!("quarter_wave={wave}"),
                ]);
                let label = format!("{form} {scheme} {wave}");
                assert_eq!(flat(&netlist.counts()), recount(&netlist.to_text()), "{label}");
            }
        }
    }
}

/// Multipliers of the datapath do not change with the scheme of its tables.
#[test]
fn schemes_are_counted_apart() {
    let datapath = |scheme: &str, wave: &str| {
        let counts = rotation(&[
            "variant=corrected",
            &format!("scheme={scheme}"),
            &format!("quarter_wave={wave}"),
        ])
        .counts();
        (counts.datapath.multipliers, counts.datapath.adders)
    };
    for scheme in ["direct", "linear", "bipartite"] {
        for wave in ["off", "on"] {
            assert_eq!(datapath(scheme, wave), (3, 8), "{scheme} {wave}");
        }
    }
}

/// The text of a netlist is the same in every run: nothing is in the order of a hash map.
#[test]
fn text_is_reproducible() {
    let text = |scheme: &str| rotation(&["output=polar-table", scheme]).to_text();
    for scheme in ["scheme=direct", "scheme=linear", "scheme=bipartite"] {
        assert_eq!(text(scheme), text(scheme));
    }
}

/// Hardware has one name for a port.
#[test]
fn an_input_and_an_output_of_one_name_are_refused() {
    let format = Format::signed(8, 4).unwrap();
    let mut b = Builder::new("echo");
    let x = b.input("x", format, Quantity::Number);
    let y = b.neg(x);
    b.output("x", y);
    let why = b.build().unwrap_err().to_string();
    assert_eq!(why, "`x` is an input and an output of `echo`: give one of them another name");
}
