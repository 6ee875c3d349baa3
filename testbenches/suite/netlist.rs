//! Building netlists, their text forms and their counts.

use crate::common::design;
use crate::engines::Random;
use expect_test::expect;
use fixpath::cycle::Cycle;
use fixpath::format::{Format, Overflow, Round};
use fixpath::measure::{Inputs, measure};
use fixpath::netlist::{Builder, Column, Counts, Netlist, NodeId, Part, Quantity, Table};
use fixpath::op::Op;
use fixpath::rtl::Rtl;
use fixpath::schedule::{Depth, Rom, Schedule};
use fixpath::sim::batch::{BLOCK, Program, Word};
use fixpath::units::{Kind, Sampler, UNITS, Unit};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
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
        memory: None,
    }
}

/// A bit of everything: a table with two columns, scopes, dead nodes, shared nodes.
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
    // Operations that would change nothing are not built, but symmetric saturation changes a word.
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

    // Ports stay in order, used or not.
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

/// Message of a netlist with input `x`, s8f4, and output `y`, on which `wrong` is run; without its
/// place in the code.
fn refusal<R>(wrong: impl FnOnce(&mut Builder, NodeId) -> R) -> String {
    let mut b = Builder::new("wrong");
    let x = b.input("x", format("s8f4"), Quantity::Number);
    b.output("y", x);
    wrong(&mut b, x);
    assert!(b.has_failed());
    // Calls after the first mistake neither panic nor change the message.
    let flag = b.less(x, x);
    let other = b.operation(Op::And, &[x, flag], Format::FLAG);
    b.name(other, "NO NAME");
    b.output("y", other);
    message(b.build())
}

fn message(built: fixpath::error::Result<Netlist>) -> String {
    let error = built.unwrap_err();
    let text = error.to_string();
    let Some(caller) = error.caller() else { return text };
    assert!(caller.file().ends_with("netlist.rs"), "{caller} of {text}");
    let place = format!(" ({}:{})", caller.file(), caller.line());
    text.strip_suffix(&place).unwrap_or(&text).to_owned()
}

const RULE: &str = "a name is a letter a to z, then a to z, 0 to 9 and single _ between them, at most 64 characters";

#[test]
fn names_that_hardware_languages_refuse_are_refused() {
    let long = "a".repeat(65);
    let names = ["", "A", "1a", "a-b", "a__b", "a_", "_a", "é", "a b", "a\nb", &long];
    for name in names {
        let shown = message(Builder::new(name).build());
        assert!(shown.starts_with("netlist `") && shown.ends_with(RULE), "{shown}");
        let given = |what: &str| {
            format!("{what} {}: {RULE}", shown.split('`').nth(1).map(|n| format!("`{n}`")).unwrap())
        };
        let of = |what: &str, wrong: &dyn Fn(&mut Builder, NodeId)| {
            assert_eq!(refusal(|b, x| wrong(b, x)), given(what));
        };
        of("input", &|b, _| {
            b.input(name, Format::FLAG, Quantity::Number);
        });
        of("output", &|b, x| b.output(name, x));
        of("node", &|b, x| {
            b.name(x, name);
        });
        of("scope", &|b, _| b.scope(name, |_| ()));
        of("scope", &|b, _| b.part(Part::Dot, name, |_| ()));
        of("table", &|b, _| {
            b.table(Table { name: name.to_owned(), ..square_table() });
        });
        of("table `squares`: column", &|b, _| {
            let mut table = square_table();
            table.columns[1].name = name.to_owned();
            b.table(table);
        });
    }
    // The longest legal names, and keywords, which the hardware renames.
    for name in [&"a".repeat(64), "module", "signal", "x9", "a_b_c", "z"] {
        let mut b = Builder::new("legal");
        let x = b.input(name, Format::FLAG, Quantity::Number);
        b.output("out", x);
        assert_eq!(b.build().unwrap().input_name(0), name);
    }
}

/// Numbers never make a name too long, so whatever is built can be built again.
#[test]
fn numbered_names_stay_legal() {
    let mut b = Builder::new("long");
    let x = b.input("x", format("s8f4"), Quantity::Number);
    let name = format!("{}_{}", "a".repeat(61), "b".repeat(2));
    for i in 0..12 {
        let word = b.constant(i, format("s8f4"));
        let sum = b.add(x, word);
        b.name(sum, &name);
        b.output(&format!("out{i}"), sum);
    }
    let netlist = b.build().unwrap();
    let mut again = Builder::new("again");
    let names: BTreeSet<&str> = netlist.nodes().iter().filter_map(|n| n.name.as_deref()).collect();
    assert_eq!(names.len(), 13);
    for name in &names {
        again.input(name, Format::FLAG, Quantity::Number);
    }
    assert!(!again.has_failed(), "{names:?}");
}

#[test]
fn ports_have_names_of_their_own() {
    let flag = Format::FLAG;
    let port = |b: &mut Builder, name| {
        b.input(name, flag, Quantity::Number);
    };
    assert_eq!(
        refusal(|b, _| port(b, "x")),
        "input `x` of `wrong`: another input has this name: rename one of them"
    );
    assert_eq!(
        refusal(|b, _| port(b, "y")),
        "input `y` of `wrong`: an output has this name: rename one of them"
    );
    assert_eq!(
        refusal(|b, x| b.output("y", x)),
        "output `y` of `wrong`: another output has this name: rename one of them"
    );
    assert_eq!(
        refusal(|b, x| b.output("x", x)),
        "output `x` of `wrong`: an input has this name: rename one of them"
    );
    // In any scope.
    assert_eq!(
        refusal(|b, _| b.scope("inner", |b| port(b, "x"))),
        "input `x` of `wrong`: another input has this name: rename one of them"
    );
    assert_eq!(message(Builder::new("empty").build()), "netlist `empty`: it has no output");
}

#[test]
fn tables_are_whole() {
    let tables = |change: &dyn Fn(&mut Table)| {
        refusal(|b, _| {
            let mut table = square_table();
            change(&mut table);
            let table = b.table(table);
            let address = b.constant(3, format("u3f0"));
            b.read(table, 0, address);
        })
    };
    for bits in [0, 31, 63, 64, u32::MAX] {
        assert_eq!(
            tables(&|t| t.addr_bits = bits),
            format!("table `squares`: {bits} address bits: legal is 1 to 30")
        );
    }
    assert_eq!(
        tables(&|t| t.addr_bits = 4),
        "table `squares`: column `square` has 8 words and must have one for each of 16 addresses"
    );
    assert_eq!(
        tables(&|t| t.columns[1].words = Arc::from([])),
        "table `squares`: column `half` has 0 words and must have one for each of 8 addresses"
    );
    assert_eq!(
        tables(&|t| t.columns[0].format = format("u5f3")),
        "table `squares`: column `square` has word 36 at address 6, outside u5f3 (0..=31)"
    );
    assert_eq!(
        tables(&|t| t.columns[1].name = "square".to_owned()),
        "table `squares`: two columns are called `square`"
    );
    assert_eq!(
        refusal(|b, x| {
            let table = b.table(square_table());
            let address = b.slice(x, 0, 3);
            b.name(address, "address");
            b.read(table, 2, address);
        }),
        "read of address (u3f0): table `squares` has no column 2: its columns from 0 are square, half"
    );
    assert_eq!(
        refusal(|b, x| {
            let table = b.table(square_table());
            b.read(table, 0, x);
        }),
        "node `read of x (s8f4)`: `squares` takes addresses in format u3f0"
    );
}

/// A node and a table of another builder, and a node of a finished netlist, with indices that exist
/// here, too.
#[test]
fn what_is_another_builders_is_seen() {
    let mut other = Builder::new("other");
    let node = other.input("x", format("s8f4"), Quantity::Number);
    let table = other.table(square_table());
    other.output("y", node);
    let finished = other.build().unwrap();
    let [first, last] = [node, finished.outputs()[0].node];
    assert_ne!(first, last, "of a builder, and of what it built");
    for id in [first, last] {
        type Wrong = fn(&mut Builder, NodeId, NodeId) -> NodeId;
        let cases: [(&str, Wrong); 16] = [
            ("add of x (s8f4), a node of another builder", |b, x, id| b.add(x, id)),
            ("sub of a node of another builder, x (s8f4)", |b, x, id| b.sub(id, x)),
            ("neg of a node of another builder", |b, _, id| b.neg(id)),
            ("shift of a node of another builder", |b, _, id| b.shift(id, 1)),
            ("slice of a node of another builder", |b, _, id| b.slice(id, 0, 1)),
            ("narrow of a node of another builder", |b, _, id| {
                b.narrow(id, format("s8f4"), Round::Floor, Overflow::Wrap)
            }),
            ("modulo of a node of another builder", |b, _, id| b.modulo(id, format("s8f4"))),
            ("mux of x (s8f4), a node of another builder, x (s8f4)", |b, x, id| b.mux(x, id, x)),
            ("name in `wrong`", |b, _, id| b.name(id, "z")),
            ("turns in `wrong`", |b, _, id| b.turns(id)),
            ("means in `wrong`", |b, x, id| b.means(id, [x], |[of]| of.floor())),
            ("format in `wrong`", |b, x, id| if b.format(id) == Format::FLAG { id } else { x }),
            ("format in `wrong`", |b, _, id| b.negative(id)),
            ("output `z` in `wrong`", |b, x, id| {
                b.output("z", id);
                x
            }),
            ("x (s8f4)", |b, x, id| b.means(x, [id], |[of]| of.floor())),
            ("less of a node of another builder, a node of another builder", |b, _, id| {
                b.less(id, id)
            }),
        ];
        for (start, wrong) in cases {
            let message = refusal(|b, x| wrong(b, x, id));
            assert!(message.starts_with(&format!("{start}: ")), "{message}");
            assert!(message.contains("builder"), "{message}");
        }
    }
    let message = refusal(|b, x| {
        b.table(square_table());
        let address = b.slice(x, 0, 3);
        b.read(table, 0, address);
    });
    assert_eq!(
        message,
        "read of %1 (u3f0): the table belongs to another builder: use one builder per netlist"
    );
}

#[test]
fn operations_are_asked_what_they_can() {
    assert_eq!(
        refusal(|b, _| {
            let flag = b.constant(1, Format::FLAG);
            b.negative(flag);
        }),
        "slice of %1 (u1f0): an unsigned word has no sign"
    );
    assert_eq!(
        refusal(|b, x| b.slice(x, 3, 0)),
        "slice of x (s8f4): a slice needs at least one bit"
    );
    let far = refusal(|b, x| b.slice(x, u32::MAX, 63));
    assert!(far.starts_with("node `slice of x (s8f4)`: bits "), "{far}");
    let far = refusal(|b, x| {
        let count = b.slice(x, 0, 3);
        b.shift_left(x, count, u32::MAX);
    });
    assert!(far.starts_with("node `shift_left of x (s8f4), %1 (u3f0)` needs "), "{far}");
    for left in [i32::MIN, i32::MAX, 200, -200] {
        assert_eq!(
            refusal(|b, x| b.shift(x, left)),
            "node `shift of x (s8f4)`: the binary point moves past 127 places"
        );
    }
    assert_eq!(
        refusal(|b, _| b.constant(200, format("s8f4"))),
        "node `const`: word 200 is outside s8f4"
    );
    assert_eq!(
        refusal(|b, x| b.operation(Op::Add, &[x], Format::FLAG)),
        "add of x (s8f4): it takes 2 operands"
    );
    assert_eq!(
        refusal(|b, _| b.operation(Op::Input, &[], Format::FLAG)),
        "input: a port has a name: use `input`"
    );
    // A meaning may refer only to earlier nodes and to nodes that are kept.
    assert_eq!(
        refusal(|b, x| b.means(x, [x], |[of]| of.floor())),
        "x (s8f4): its meaning refers to x (s8f4): that must be an earlier node"
    );
    let mut b = Builder::new("wrong");
    let x = b.input("x", format("s8f4"), Quantity::Number);
    let dead = b.mul(x, x);
    let y = b.neg(x);
    b.means(y, [dead], |[of]| of.floor());
    b.output("y", y);
    assert_eq!(
        message(b.build()),
        "%2 (s9f4): its meaning refers to %1 (s16f8), which no output needs: make that an output too, or omit the meaning"
    );
}

/// Any calls in any order, with ids from anywhere: never a panic, and whatever is built runs.
#[test]
fn builders_take_anything() {
    let mut built = 0;
    for seed in 0..4000 {
        let mut random = Random::new(seed);
        let mut other = Builder::new("other");
        let foreign = other.input("f", format("s8f4"), Quantity::Number);
        let mut b = Builder::new("any");
        let mut ids = vec![b.input("x", format("s8f4"), Quantity::Number)];
        let mut tables = vec![b.table(square_table())];
        if random.chance(5) {
            tables.push(other.table(square_table()));
        }
        if random.chance(10) {
            ids.push(foreign);
        }
        for step in 0..random.below(12) {
            let [p, q, r] = [0; 3].map(|_| random.pick(&ids));
            let word = random.pick(&[0, 1, 3, 8, 62, 63, 64, u32::MAX]);
            let bits = 1 + random.below(63) as u32;
            let to = Format::new(random.chance(50), bits, random.within(-127, 127) as i32).unwrap();
            let name = random.pick(&["x", "y", "ok", "Bad", ""]);
            let id = match random.below(14) {
                0 => b.slice(p, word, random.pick(&[0, 1, 8, 63, 64, u32::MAX])),
                1 => b.shift(p, random.pick(&[1, -3, 130, i32::MIN, i32::MAX])),
                2 => b.shift_left(p, q, word),
                3 => b.narrow(p, to, random.pick(Round::ALL), random.pick(Overflow::ALL)),
                4 => b.modulo(p, to),
                5 => b.read(random.pick(&tables), random.below(3), p),
                6 => b.negative(p),
                7 => b.name(p, name),
                8 => b.means(p, [q], |[of]| of.floor()),
                9 => b.constant(random.pick(&[0, 1, -1, i64::MAX, i64::MIN]), to),
                10 => b.scope(name, |b| b.add(p, q)),
                11 => {
                    let mut table = square_table();
                    table.addr_bits = random.pick(&[3, 0, 5, 31, 200]);
                    let read = b.table(table);
                    tables.push(read);
                    b.read(read, 0, p)
                }
                12 if random.chance(30) => b.input(name, to, Quantity::Turns),
                _ => {
                    let op = random.pick(Op::ALL);
                    let of = [p, q, r];
                    let arity = if random.chance(95) { op.arity() } else { random.below(4) };
                    b.operation(op, &of[..arity], to)
                }
            };
            ids.push(id);
            if random.chance(20) {
                b.output(&format!("out{step}"), id);
            }
        }
        let last = ids[ids.len() - 1];
        b.output("last", last);
        let failed = b.has_failed();
        match b.build() {
            Ok(netlist) => {
                assert!(!failed);
                built += 1;
                crate::engines::check(&netlist, seed, 3).unwrap();
            }
            Err(error) => {
                let text = error.to_string();
                assert!(!text.contains("bug:"), "{text}");
            }
        }
    }
    assert!((200..3800).contains(&built), "{built}");
}

/// Words outside a port's format are an error of every consumer.
#[test]
fn words_outside_a_port_are_refused() {
    let netlist = Arc::new(small());
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(&netlist, &outputs);
    let run = |a: &[i64], phase: &[i64]| {
        let mut out = vec![Vec::new(); outputs.len()];
        program.runner().run(&program, &[a, phase], &mut out).map(|()| out)
    };
    // Anywhere in a block, including the last block.
    for count in [1, 2, 700, BLOCK, BLOCK + 1, 2 * BLOCK + 5] {
        for at in [0, count / 2, count - 1] {
            for wrong in [8, 9, -1, 1 << 16, 1 << 32, i64::MIN, i64::MAX, (1 << 32) + 3, 1 << 62] {
                let (mut a, phase) = (vec![7; count], vec![255; count]);
                assert!(run(&a, &phase).is_ok());
                a[at] = wrong;
                assert_eq!(
                    run(&a, &phase).unwrap_err().to_string(),
                    format!("input `a`: word {wrong} of sample {at} is outside u3f0 (0..=7)")
                );
            }
        }
    }
    let narrow = |a: u16, phase: u16| {
        let mut out: Vec<Vec<i32>> = vec![Vec::new(); 2];
        program.runner().run_words(&program, &[&[a][..], &[phase]], &mut out)
    };
    assert!(narrow(7, 255).is_ok());
    let why = narrow(7, 256).unwrap_err().to_string();
    assert_eq!(why, "input `phase`: word 256 of sample 0 is outside u8f8 (0..=255)");
    let mut out: Vec<Vec<u16>> = vec![Vec::new(); 2];
    let why = program.runner().run_words(&program, &[&[7u16][..], &[1]], &mut out);
    let why = why.unwrap_err().to_string();
    assert_eq!(
        why,
        "words of `result` are s6f1 and its column holds 0 to 65535: use a wider number type"
    );
    let mut out = vec![Vec::new(); 2];
    let mut wrong = |columns: &[&[i64]]| {
        program.runner().run(&program, columns, &mut out).unwrap_err().to_string()
    };
    assert_eq!(wrong(&[&[1]]), "1 columns of input words: one is needed for each of a, phase");
    let why =
        "the column of port `phase` has 1 words and that of `a` has 2: give each the same number";
    assert_eq!(wrong(&[&[1, 2], &[3]]), why);
    let why = program.runner().run(&program, &[&[1], &[1]], &mut []).unwrap_err().to_string();
    assert_eq!(why, "0 columns of output words: one is needed for each of result, turned");

    let outside = "input `a`: word 8 is outside u3f0 (0..=7)";
    assert_eq!(netlist.eval(&[8, 0]).unwrap_err().to_string(), outside);
    let few = "1 words for `small`: it takes one for each of a, phase";
    assert_eq!(netlist.eval(&[8]).unwrap_err().to_string(), few);
    let schedule = Schedule::pipeline(&netlist, Rom::Distributed, Depth::Stages(1)).unwrap();
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(&netlist), schedule)));
    assert_eq!(cycle.settle(&[8, 0], true).unwrap_err().to_string(), outside);
    assert_eq!(cycle.settle(&[8], true).unwrap_err().to_string(), few);
    cycle.settle(&[7, 0], true).unwrap();
}

/// Every format near the ends of each kind of number.
#[test]
fn all_words_of_a_format_pass_and_no_others() {
    fn check<W: Word>(widest: i128) {
        for bits in (1..=20).chain([30, 31, 32, 33, 62, 63]) {
            for signed in [false, true] {
                let format = Format::new(signed, bits, 0).unwrap();
                let mut b = Builder::new("port");
                let x = b.input("x", format, Quantity::Number);
                let y = b.slice(x, 0, 1);
                b.output("y", y);
                let netlist = b.build().unwrap();
                let program = Program::compile(&netlist, &[netlist.outputs()[0].node]);
                let (lo, hi) = (format.min_raw(), format.max_raw());
                let ends = [
                    lo,
                    hi,
                    lo.wrapping_sub(1),
                    hi.wrapping_add(1),
                    0,
                    -1,
                    1 << 15,
                    1 << 16,
                    -(1 << 31),
                    1 << 31,
                    i64::MIN,
                    i64::MAX,
                ];
                for word in ends {
                    let there = W::of_word(word).word() == word && i128::from(word) <= widest;
                    if there {
                        let mut out: Vec<Vec<i64>> = vec![Vec::new()];
                        let ran = program.runner().run_words(
                            &program,
                            &[&[W::of_word(word)][..]],
                            &mut out,
                        );
                        assert_eq!(ran.is_ok(), format.contains(word), "{format} {word}");
                    }
                }
            }
        }
    }
    check::<i64>(i64::MAX.into());
    check::<i32>(i32::MAX.into());
    check::<u16>(u16::MAX.into());
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
    // 2^10 rows of sin and cos, 20 bits each (two integer bits with the sign, 18 fraction bits).
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

/// The scheme of the tables doesn't change the number of multipliers of the datapath.
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

/// The text of a netlist is the same in every run: nothing depends on the order of a hash map.
#[test]
fn text_is_reproducible() {
    let text = |scheme: &str| rotation(&["output=polar-table", scheme]).to_text();
    for scheme in ["scheme=direct", "scheme=linear", "scheme=bipartite"] {
        assert_eq!(text(scheme), text(scheme));
    }
}

fn read(text: &str) -> Result<Netlist, String> {
    Netlist::parse(text, Path::new("n.txt")).map_err(|error| error.to_string())
}

/// A written netlist reads back as the same netlist: every unit at its defaults and with each other
/// choice of each parameter.
#[test]
fn files_of_units_are_read_back() {
    for unit in UNITS.iter() {
        let mut settings: Vec<String> = vec![String::new()];
        for param in &unit.params {
            if let Kind::Choice(names) = &param.kind {
                settings.extend(names.iter().map(|name| format!("{}={name}", param.name)));
            }
        }
        for setting in settings {
            let set: Vec<&str> = setting.split_terminator(' ').collect();
            // Some choices require others.
            let Ok(design) = unit.values(&set).unwrap().build() else { continue };
            let text = design.netlist.to_file();
            let again =
                read(&text).unwrap_or_else(|error| panic!("{} {setting}: {error}", unit.name));
            assert!(again == *design.netlist, "{} {setting}", unit.name);
        }
    }
}

#[test]
fn files_of_random_netlists_are_read_back() {
    let machines = (0..300).map(crate::engines::random_machine);
    for netlist in (0..300).map(crate::engines::random_netlist).chain(machines) {
        let text = netlist.to_file();
        let again = read(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!(again == netlist, "{text}\n{}", again.to_file());
    }
}

/// Files that are large or deep with few lines, and functions that a builder makes but no file can
/// hold.
#[test]
fn functions_that_call_too_much_are_refused() {
    let head = "fixpath netlist 1\nname n\nfunction f0 = add(x, 1)\n";
    for (call, part) in
        [("add(f(x), f(add(x, 1)))", "more than 65536 terms"), ("f(x)", "more than 500 deep")]
    {
        let mut text = head.to_owned();
        for i in 1..2000 {
            let call = call.replace("f(", &format!("f{}(", i - 1));
            text.push_str(&format!("function f{i} = {call}\n"));
        }
        let error = read(&text).expect_err(part);
        assert!(error.contains(part), "{error}");
    }
    let text = format!("{head}function g named !x = add(x, 1)\n");
    assert!(read(&text).is_err_and(|error| error.contains("function `!x`: a name is")));
    let mut b = Builder::new("twice");
    let x = b.input("x", format("s8f4"), Quantity::Number);
    let y = b.scope("s", |b| b.neg(x));
    let z = b.part(Part::Dot, "s", |b| b.mul(x, y));
    b.output("z", z);
    assert!(
        b.build()
            .unwrap_err()
            .to_string()
            .starts_with("scope `s`: it is a different part elsewhere")
    );
    assert!(read("").is_err_and(|error| error.contains("it is empty")));
    let text = SMALL_FILE.replace("input : u1f0 @a", "const 0 : u1f0");
    assert!(read(&text).is_err_and(|error| error.contains("the netlist has no input")));
}

/// Ports of 63 bits are measured, too.
#[test]
fn a_netlist_of_wide_ports_is_measured() {
    for format in ["s63f0", "s63f62", "u63f63", "s54f0"] {
        let text = format!(
            "fixpath netlist 1\nname wide\n%0 = input : {format} @a\n%1 = narrow half-even saturate %0 : s20f4\noutput y = %1\n"
        );
        let design = Unit::of_netlist(read(&text).unwrap()).defaults().build().unwrap();
        let inputs = Inputs { sampler: Sampler::Sphere, samples: 1000, seed: 1 };
        measure(&[&design], &inputs, &|_| ()).unwrap();
    }
}

const SMALL_FILE: &str = "\
fixpath netlist 1
name small
scope tail
scope tail.lookup scheme # a comment
function light = add(0.1, mul(0.8, max(x, 0)))
table rom 1 up:s4f1 down:s4f1
  7 -4
  -8 6
%0 = input : u1f0 @a
%1 = read rom.up %0 : s4f1 @tail.lookup.value means light(%0)
%2 = mul %1 %1 : s8f2 @tail.

%3 = narrow half-even saturate %2 : u5f1
output y = %3
";

#[test]
fn a_small_file() {
    let netlist = read(SMALL_FILE).unwrap();
    assert_eq!(netlist.name(), "small");
    assert_eq!(netlist.label(netlist.outputs()[0].node), "%3");
    assert_eq!(netlist.eval(&[1]).unwrap().0[3], 31, "(-4)² = 16 saturates");
    assert_eq!(netlist.eval_reals(&[1.0])[3], 0.9f64 * 0.9);
    assert_eq!(read(&netlist.to_file()).unwrap(), netlist);
}

/// Each case has a part of its message; the place is that of the first difference.
#[test]
fn malformed_files_are_refused_with_their_place() {
    let cases = [
        ("fixpath netlist 1", "fixpath netlist 2", "line 1, column 1: a netlist file begins with"),
        ("name small", "nam small", "line 2, column 1: the second line must be `name`"),
        ("name small", "name Small", "line 2, column 6: `Small` is not a name"),
        ("scope tail\n", "scope tail 2\n", "line 3, column 12: `2` is not a part"),
        (
            "scope tail\n",
            "scope tail\nscope tail\n",
            "line 4, column 7: scope `tail` is declared twice",
        ),
        ("scope tail.lookup", "scope head.lookup", "line 4, column 7: there is no scope `head`"),
        ("max(x, 0)", "max(y, 0)", "line 5, column 40: `y` is neither a finite number"),
        ("table rom 1", "table rom 31", "line 6, column 11: 31 address bits: legal is 1 to 30"),
        ("up:s4f1", "up", "line 6, column 13: `up` is not a column"),
        ("up:s4f1", "down:s4f1", "line 6, column 23: column `down` is declared twice"),
        ("up:s4f1", "up:s64f1", "line 6, column 16: format of 64 bits"),
        ("  7 -4", "  7", "line 7, column 4: the line ends"),
        ("  7 -4", "  7 -4 5", "line 7, column 8: expected the end of the line before `5`"),
        ("  7 -4", "  8 -4", "line 7, column 3: word 8 of column `up` is outside s4f1"),
        ("  7 -4", "  x -4", "line 7, column 3: `x` is not a word of column `up`"),
        (
            "%0 = input",
            "%1 = input",
            "line 9, column 1: nodes are numbered from %0 up: expected `%0`",
        ),
        ("%0 = input : u1f0 @a", "%0 = input : u1f0", "line 9, column 6: name the input"),
        (
            "%0 = input : u1f0 @a",
            "%0 = input : u1f0 @tail.a",
            "line 9, column 19: an input can't be in a scope",
        ),
        ("@a\n", "@1a\n", "line 9, column 19: `1a` is not a name"),
        ("rom.up", "ram.up", "line 10, column 11: there is no table `ram`"),
        ("rom.up", "rom.left", "line 10, column 11: table `rom` has no column `left`"),
        ("light(%0)", "light(%1)", "`%1` is neither a finite number"),
        ("light(%0)", "light(%0, 1)", "`light` takes 1 operands, and 2 are given"),
        ("mul %1 %1", "mul %1", "line 11, column 6: `mul` takes 2 operands, and 1 are given"),
        (
            "mul %1 %1",
            "mul %1 %2",
            "line 11, column 13: `%2` is not a node before this line: legal is %0 to %1",
        ),
        ("mul %1 %1", "cube %1", "line 11, column 6: there is no operation `cube`"),
        (": s8f2", ": s9f2", "line 11, column 18: the result of `mul` is s8f2, not s9f2"),
        (": s8f2 @tail.", ": s8f2 tail", "line 11, column 23: expected number"),
        ("half-even", "half", "line 13, column 13: `half` is not a rounding"),
        (
            "output y = %3",
            "output y = %4",
            "line 14, column 12: `%4` is not a node before this line: legal is %0 to %3",
        ),
        ("output y = %3", "outputs y = %3", "line 14, column 1: `outputs` can't start a line"),
        ("output y = %3\n", "", "line 13, column 1: the netlist has no output"),
    ];
    for (from, to, message) in cases {
        assert!(SMALL_FILE.contains(from), "{from}");
        let error = read(&SMALL_FILE.replacen(from, to, 1)).expect_err(to);
        assert!(error.contains(message), "{to}: {error}");
    }
    let cut = SMALL_FILE.split("  -8 6").next().unwrap();
    assert!(
        read(cut)
            .is_err_and(|error| error.contains("ends inside table `rom`, which starts in line 6"))
    );
    // For any truncation or change: an error or a netlist, no panic.
    for at in 0..SMALL_FILE.len() {
        let _ = read(&SMALL_FILE[..at]);
        for other in ["%", "9", ".", " ", "\n", "@", "-"] {
            let _ = read(&format!("{}{other}{}", &SMALL_FILE[..at], &SMALL_FILE[at + 1..]));
        }
    }
}
