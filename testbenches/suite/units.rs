//! Parameters of all units together: which values are refused, and whether the suggested remedy
//! works.

use fixpath::format::{Format, Overflow, Round};
use fixpath::function::Function;
use fixpath::measure::{Basis, Inputs, Report, measure};
use fixpath::netlist::{Builder, Quantity};
use fixpath::table::{self, Scheme, Tabulated};
use fixpath::units::fragment::Port;
use fixpath::units::{
    Bound, Bounds, Design, Draw, Golden, HardCase, Kind, Param, Reflection, Role, Sampler, Shading,
    Shape, UNITS, Unit, Values,
};
use fixpath::verify::Proof;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// A legal value of a parameter; tables stay small, so that builds are fast.
fn legal(param: &Param, random: &mut Pcg64Mcg) -> String {
    let mut below = |n: u64| random.next_u64() % n;
    match &param.kind {
        &Kind::Int { min, max, .. } => {
            let is_table = param.role == Role::TableSize;
            let max = if is_table { max.min(min.max(7)) } else { max };
            // Wide words are refused, so every other value is the greatest.
            let value = min + i64::try_from(below((max - min + 1).unsigned_abs())).unwrap();
            (if below(2) == 0 && !is_table { max } else { value }).to_string()
        }
        Kind::Real { min, max } => (0.5 * (min + max)).to_string(),
        Kind::Choice(names) => {
            names[usize::try_from(below(names.len() as u64)).unwrap()].to_string()
        }
    }
}

/// Names between backticks after the verb.
fn named(message: &str, verb: &str) -> Vec<String> {
    let Some((_, rest)) = message.split_once(&format!(": {verb} `")) else { return Vec::new() };
    rest.trim_end_matches('`').split("` or `").map(str::to_owned).collect()
}

/// Follows the remedies of a refusal until the unit builds, or is refused for another reason.
fn cure(unit: &Unit, mut values: Values) {
    let mut tries = 0;
    while let Err(error) = values.build() {
        let message = error.to_string();
        if !message.contains(" needs ") {
            // Values that don't go together name a parameter and its legal values.
            assert!(message.starts_with("parameter `"), "{}: {message}", unit.name);
            return;
        }
        tries += 1;
        assert!(tries < 400, "{}: no end of {message}", unit.name);
        let (lower, raise) = (named(&message, "lower"), named(&message, "raise"));
        let (name, step) = match (lower.first(), raise.first()) {
            (Some(name), _) => (name, -1),
            (None, Some(name)) => (name, 1),
            (None, None) => panic!("{}: no parameter is named: {message}", unit.name),
        };
        let value = values.int(name).unwrap() + step;
        values.set(name, &value.to_string()).unwrap();
    }
}

#[test]
fn words_that_are_too_wide_name_parameters_whose_change_cures_them() {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    for unit in UNITS.iter() {
        for _ in 0..12 {
            let mut values = unit.defaults();
            for param in &unit.params {
                values.set(&param.name, &legal(param, &mut random)).unwrap();
            }
            cure(unit, values);
        }
    }
}

fn refusal(unit: &str, assignments: &[&str]) -> String {
    let values = Unit::find(unit).unwrap().values(assignments).unwrap();
    values.build().unwrap_err().to_string()
}

#[test]
fn the_first_word_that_is_too_wide_is_told() {
    // 2 (4 + 24 + 2 + 1) bits of a square, and two more for the sum of three.
    let message = refusal("peercy", &["normalise=reciprocal-root", "frac_bits=24"]);
    assert!(message.contains("needs 64 bits"), "{message}");
    assert_eq!(named(&message, "lower"), ["frac_bits", "guard_bits"], "{message}");
    for variant in ["variant=printed", "variant=corrected"] {
        let set = ["frac_bits=24", "atan_int_bits=12", "recip_int_bits=14", "angle_bits=20"];
        let set: Vec<&str> = set.into_iter().chain([variant, "scheme=linear"]).collect();
        let message = refusal("rotation", &set);
        let lower = named(&message, "lower");
        for name in ["frac_bits", "recip_int_bits"] {
            assert!(lower.iter().any(|known| known == name), "{message}");
        }
    }
}

#[test]
fn every_parameter_has_a_role_that_fits_its_kind_and_its_name() {
    for unit in UNITS.iter() {
        for param in unit.all_params() {
            let context = format!("{}: {} is {:?}", unit.name, param.name, param.role);
            let fits = match param.role {
                Role::Width
                | Role::TableSize
                | Role::MapSize
                | Role::Iterations
                | Role::Count
                | Role::Label
                | Role::Share(_) => matches!(param.kind, Kind::Int { .. }),
                Role::Variant
                | Role::Pipeline
                | Role::Scheme
                | Role::Rounding
                | Role::Overflow
                | Role::Switch
                | Role::Schedule => matches!(param.kind, Kind::Choice(_)),
                Role::Constant | Role::Material(_) => !matches!(param.kind, Kind::Choice(_)),
                Role::Timing | Role::Sharing => !matches!(param.kind, Kind::Real { .. }),
            };
            assert!(fits, "{context}: {:?}", param.kind);
            // Names follow these suffixes, which people rely on.
            let by_name = match param.name.as_str() {
                name if name.ends_with("_addr_bits") => Some(Role::TableSize),
                name if name.ends_with("_bits") => Some(Role::Width),
                name if name.ends_with("_iterations") => Some(Role::Iterations),
                name if name.ends_with("scheme") => Some(Role::Scheme),
                _ => None,
            };
            let spelled = [Role::TableSize, Role::Width, Role::Iterations, Role::Scheme];
            assert!(by_name.is_some() || !spelled.contains(&param.role), "{context}");
            assert!(by_name.is_none_or(|role| role == param.role), "{context}");
        }
        // At most one parameter selects the datapath, and each part of the reflection formula has
        // one parameter.
        let variants = |param: &&Param| matches!(param.role, Role::Variant | Role::Pipeline);
        assert!(unit.params.iter().filter(variants).count() <= 1, "{}", unit.name);
        let count = |role| unit.all_params().filter(|param| param.role == role).count();
        let lit = unit.params.iter().any(|param| matches!(param.role, Role::Material(_)));
        use Reflection::{Ambient, Diffuse, Exponent, Specular};
        for part in [Ambient, Diffuse, Specular, Exponent] {
            assert_eq!(count(Role::Material(part)), usize::from(lit), "{}: {part:?}", unit.name);
        }
        for (kind, name) in fixpath::schedule::Kind::ALL {
            let share = unit.find_param(&format!("share_{name}")).unwrap();
            assert_eq!((share.role, count(share.role)), (Role::Share(*kind), 1));
        }
    }
}

#[test]
fn the_units_that_shade_take_fragments_and_give_light() {
    for unit in UNITS.iter() {
        let netlist = unit.defaults().build().unwrap().netlist;
        let mut inputs = (0..netlist.inputs().len()).map(|at| netlist.input_name(at));
        let takes = inputs.clone().all(|name| Port::of(name).is_some());
        let gives = netlist.outputs().iter().any(|output| output.name == "diffuse");
        let shades = match takes && gives {
            false => Shading::None,
            true if inputs.any(|name| name.ends_with("_lt")) => Shading::Part,
            true => Shading::Pipeline,
        };
        assert_eq!(unit.shades, shades, "{}", unit.name);
    }
}

/// A unit whose parameters have unusual names.
fn odd() -> Unit {
    Unit::new("odd", "")
        .param(Param::bits("breadth", 2..=12).default(12))
        .param(Param::int("only_told_bits", 0..=99).role(Role::Label).default(99))
        .design(|values| {
            assert_eq!(values.int("only_told_bits"), Some(99), "a label isn't a width");
            let mut b = Builder::new("odd");
            let format = Format::unsigned(values.bits("breadth"), 0)?;
            let input = b.input("a", format, Quantity::Number);
            let sum = b.add(input, input);
            let word = b.narrow(sum, b.format(input), Round::Floor, Overflow::Saturate);
            b.output("x", word);
            Ok(Design::new(values, b.build()?).golden(|_| Golden::each(|[a]: [f64; 1]| [2.0 * a])))
        })
}

#[test]
fn a_proof_shrinks_widths_whatever_they_are_called() {
    let proofs = Proof::all(&odd().defaults().build().unwrap()).unwrap();
    for (proof, port) in proofs.iter().zip(["[3:0] a", "[2:0] a"]) {
        let text = &proof.files[0].text;
        assert!(text.contains(port), "{text}");
    }
    assert_eq!(proofs.len(), 2);
}

/// Values of a parameter to sweep, as text: names, ends of ranges and values in between. Tables
/// stay small.
fn some_values(param: &Param) -> Vec<String> {
    match &param.kind {
        Kind::Choice(names) => names.iter().map(ToString::to_string).collect(),
        Kind::Real { min, max } => {
            [*min, 0.25 * (3.0 * min + max), *max].map(|x| x.to_string()).to_vec()
        }
        Kind::Int { min, max, auto } => {
            let max = if param.role == Role::TableSize { (*max).min(min + 5) } else { *max };
            let mut all: Vec<i64> = vec![*min, min + (max - min) / 3, min + (max - min) / 2, max];
            all.dedup();
            let auto = auto.iter().map(|_| "auto".to_owned());
            auto.chain(all.iter().map(ToString::to_string)).collect()
        }
    }
}

/// Points of a sweep over a parameter: their number, and those whose figures differ from the ones
/// that they have alone.
fn apart(unit: &Unit, setting: &[String], param: &Param) -> (usize, Vec<String>) {
    let inputs = Inputs { sampler: Sampler::Lit, samples: 300, seed: 5 };
    let design = |value: String| {
        let assignment = format!("{}={value}", param.name);
        // Not all values go together.
        unit.values(&[setting, &[assignment]].concat()).unwrap().build().ok()
    };
    let designs: Vec<Design> = some_values(param).into_iter().filter_map(design).collect();
    let together = measure(&designs.iter().collect::<Vec<_>>(), &inputs, &|_| ());
    // A word under overflow mode `error` may end the run.
    let Ok(together) = together else { return (0, Vec::new()) };
    let pairs = designs.iter().zip(&together).filter(|(design, together)| {
        let alone = measure(&[*design], &inputs, &|_| ()).unwrap().remove(0);
        // Compared as text, in which NaNs are equal.
        format!("{:?}", together.figures) != format!("{:?}", alone.figures)
    });
    let told =
        pairs.map(|(design, _)| format!("{}={}", param.name, design.values.get(&param.name)));
    (designs.len(), told.collect())
}

/// Points that share inputs and golden values have the figures that they have alone.
#[test]
fn a_sweep_over_any_parameter_gives_each_point_what_it_has_alone() {
    let mut compared = 0;
    for unit in UNITS.iter() {
        let is_variant = |param: &&Param| matches!(param.role, Role::Variant | Role::Pipeline);
        let variants = unit.params.iter().find(is_variant);
        let settings: Vec<Vec<String>> = variants.map_or(vec![Vec::new()], |param| {
            let values = some_values(param).into_iter();
            values.map(|value| vec![format!("{}={value}", param.name)]).collect()
        });
        for setting in settings {
            for param in &unit.params {
                // The parameter that selects the variant is swept by itself.
                let setting = if is_variant(&param) { &[] } else { &setting[..] };
                let (points, apart) = apart(unit, setting, param);
                assert!(apart.is_empty(), "{} {setting:?}: {apart:?}", unit.name);
                compared += points;
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// The comparison above detects a golden that depends on a parameter without reading it through
/// `Values`.
#[test]
fn a_read_that_is_not_noted_shows() {
    static K: Mutex<f64> = Mutex::new(0.0);
    let param = Param::real("k", 0.0..=4.0);
    let unit = Unit::new("smuggler", "").param(param.clone()).design(|p| {
        *K.lock().unwrap() = p.real("k");
        let mut b = Builder::new("smuggler");
        let x = b.input("x", "s8f4".parse()?, Quantity::Number);
        b.output("y", x);
        Ok(Design::new(p, b.build()?).golden(|_| {
            let k = *K.lock().unwrap();
            Golden::each(move |[x]: [f64; 1]| [k * x])
        }))
    });
    let (points, apart) = apart(&unit, &[], &param);
    assert_eq!((points, apart), (3, vec!["k=1".to_owned(), "k=4".to_owned()]));
}

/// A golden that captures a part of the design may depend on any parameter.
#[test]
fn a_golden_that_captures_shares_nothing() {
    let unit = Unit::new("scaled", "").param(Param::real("k", 0.0..=4.0)).design(|p| {
        let mut b = Builder::new("scaled");
        let x = b.input("x", "s8f4".parse()?, Quantity::Number);
        b.output("y", x);
        let k = p.real("k");
        Ok(Design::new(p, b.build()?).golden(move |_| Golden::each(move |[x]: [f64; 1]| [k * x])))
    });
    let design = |k: &str| unit.values(&[k]).unwrap().build().unwrap();
    let inputs = Inputs { sampler: Sampler::Exhaustive, samples: 0, seed: 0 };
    let reports = measure(&[&design("k=1"), &design("k=2")], &inputs, &|_| ()).unwrap();
    let max = |at: usize| reports[at].figures("y", Basis::Total).max;
    assert_eq!([max(0), max(1)], [0.0, 8.0]);
}

/// The message with which a unit is refused.
fn refused(unit: &Unit) -> String {
    unit.defaults().build().unwrap_err().to_string()
}

#[test]
fn a_unit_that_is_no_unit_says_why() {
    let design = |p: &Values| {
        let mut b = Builder::new("half");
        let x = b.input("x", "s8f4".parse()?, Quantity::Number);
        b.output("y", x);
        Ok(Design::new(p, b.build()?).golden(|_| Golden::each(|[x]: [f64; 1]| [x])))
    };
    let unit = |name: &str| Unit::new(name, "").design(design);
    let with = |param| refused(&unit("half").param(param));
    assert_eq!(
        refused(&Unit::new("half", "")),
        "unit `half`: it has no datapath: give it a `design`"
    );
    for name in ["", "Half", "half_", "1st", "two words", "a__b", "half/1"] {
        let message = refused(&unit(name));
        assert!(
            message.starts_with(&format!("unit `{name}`: a name is a letter a to z")),
            "{message}"
        );
    }
    assert_eq!(
        refused(&unit("half").source("a\nb")),
        "unit `half`: `a\\nb` must be one line of text"
    );
    assert_eq!(
        refused(&unit("half").params([Param::flag("a"), Param::flag("a")])),
        "unit `half`: parameter `a`: two parameters of this name"
    );
    assert_eq!(
        with(Param::flag("stages")),
        "unit `half`: parameter `stages`: every unit has one of this name"
    );
    assert_eq!(
        with(Param::bits("a", 2..=8).default(9)),
        "unit `half`: parameter `a`: its default 9 isn't legal; legal is 2 to 8"
    );
    assert_eq!(
        with(Param::choice("a", ["x", "y"]).default("z")),
        "unit `half`: parameter `a`: its default z isn't legal; legal is x, y"
    );
    let (more, less) = (8, 2);
    assert_eq!(
        with(Param::bits("a", more..=less)),
        "unit `half`: parameter `a`: 8 to 2 is not a range"
    );
    assert_eq!(
        with(Param::real("a", 0.0..=f64::NAN)),
        "unit `half`: parameter `a`: 0 to NaN is not a range"
    );
    let none: [&str; 0] = [];
    assert_eq!(with(Param::choice("a", none)), "unit `half`: parameter `a`: it has no choices");
    assert_eq!(
        with(Param::choice("a", ["x", "x"])),
        "unit `half`: parameter `a`: it has the name `x` twice"
    );
    assert!(with(Param::choice("a", ["x,y"])).contains("`x,y` can't be written"));
    assert!(with(Param::flag("A")).contains("parameter `A`: a name is a letter a to z"));
}

#[test]
fn a_design_that_does_not_fit_together_says_why() {
    let made = |change: fn(Design) -> Design| {
        let unit = Unit::new("pair", "").design(move |p| {
            let mut b = Builder::new("pair");
            let [x, y] =
                ["x", "y"].map(|name| b.input(name, "s8f4".parse().unwrap(), Quantity::Number));
            let sum = b.add(x, y);
            b.output("sum", sum);
            b.output("x_again", x);
            let design = Design::new(p, b.build()?);
            Ok(change(design.golden(|_| Golden::each(|[x, y]: [f64; 2]| [x + y, x]))))
        });
        unit.defaults().build().map(|_| ()).map_err(|why| why.to_string())
    };
    let refused = |change| made(change).unwrap_err();
    assert_eq!(made(|design| design), Ok(()));
    assert_eq!(
        refused(|design| design.golden(|_| Golden::each(|[x]: [f64; 1]| [x, x]))),
        "unit `pair`: its golden takes 1 inputs, but there are 2"
    );
    assert_eq!(
        refused(|design| design.golden(|_| Golden::each(|[x, _]: [f64; 2]| [x]))),
        "unit `pair`: its golden gives 1 columns, but the groups have 2"
    );
    assert_eq!(
        refused(|design| design.golden(|_| Golden::new(|_, columns| columns[1].clear()))),
        "unit `pair`: its golden model doesn't fill each column to its length"
    );
    assert_eq!(
        refused(|design| design.draw(|_, _| Draw::new(|_, _, columns, _| columns[0].clear()))),
        "unit `pair`: its sampler doesn't fill each column to its length"
    );
    assert_eq!(
        refused(|design| {
            let groups = design.groups.iter().rev().cloned().collect();
            design.groups(groups)
        }),
        "unit `pair`: its groups don't start with the output ports in order"
    );
    assert_eq!(
        refused(|mut design| {
            design.groups[0].shape = Shape::Polar;
            design
        }),
        "unit `pair`: group `sum` needs 2 nodes and has 1"
    );
    assert_eq!(
        refused(|design| design.hard(vec![HardCase::new("few", vec![vec![1]])])),
        "unit `pair`: a hard case of `few` has 1 words for 2 ports"
    );
    assert_eq!(
        refused(|design| design.hard(vec![HardCase::new("far", vec![vec![1, 128]])])),
        "unit `pair`: a hard case of `far` has the word 128 for `y`, which has format s8f4"
    );
    assert_eq!(
        refused(|design| {
            design.bounds(Bounds::Stated(vec![Bound::new("sum", ["sun"], |_, _| 0.0)]))
        }),
        "unit `pair`: its bound on `sum` is on `sun`, which isn't measured; measured are sum, x_again"
    );
    assert_eq!(
        refused(|design| design.golden(|p| {
            let k = p.real("k");
            Golden::each(move |[x, y]: [f64; 2]| [k * x, y])
        })),
        "unit `pair`: unit `pair` has no parameter `k`: `fixpath list pair` names them all"
    );
    let table = |design: Design| {
        design.bounds(Bounds::Stated(vec![Bound::new("sum", ["sum"], |_, worst| worst("t"))]))
    };
    assert_eq!(made(table), Ok(()));
}

#[test]
fn what_is_read_and_not_there_is_an_error() {
    let reads = |read: fn(&Values) -> String| {
        let unit = Unit::new("reader", "")
            .param(Param::int("n", -4..=4))
            .param(Param::choice("c", ["x", "y"]))
            .design(move |p| {
                read(p);
                let mut b = Builder::new("reader");
                let x = b.input("x", "s8f4".parse()?, Quantity::Number);
                b.output("y", x);
                Ok(Design::new(p, b.build()?).golden(|_| Golden::each(|[x]: [f64; 1]| [x])))
            });
        unit.defaults().build().map(|_| ()).map_err(|why| why.to_string())
    };
    let read_as = |name: &str, what: &str, value: &str| {
        Err(format!("unit `reader` reads its parameter `{name}` as {what}, but it is {value}"))
    };
    assert_eq!(reads(|p| format!("{:?}", (p.int("n"), p.choice("c"), p.int("stages")))), Ok(()));
    let missing = reads(|p| format!("{:?}", p.int("m"))).unwrap_err();
    assert!(missing.starts_with("unit `reader` has no parameter `m`"), "{missing}");
    assert_eq!(reads(|p| format!("{:?}", p.bits("n"))), read_as("n", "a count", "-4 of -4 to 4"));
    assert_eq!(
        reads(|p| format!("{:?}", p.real("n"))),
        read_as("n", "a number with fractions", "-4 of -4 to 4")
    );
    assert_eq!(reads(|p| format!("{:?}", p.int("c"))), read_as("c", "a whole number", "x of x, y"));
    assert_eq!(reads(|p| format!("{:?}", p.choice("n"))), read_as("n", "a name", "-4 of -4 to 4"));
    assert_eq!(
        reads(|p| format!("{:?}", p.flag("c"))),
        read_as("c", "a switch, off or on", "x of x, y")
    );
    assert_eq!(
        reads(|p| format!("{:?}", p.scheme("c"))),
        read_as("c", "a table scheme", "x of x, y")
    );
    assert_eq!(
        reads(|p| format!("{:?}", p.rounding("c"))),
        read_as("c", "a rounding", "x of x, y")
    );
    assert_eq!(
        reads(|p| format!("{:?}", p.overflow("c"))),
        read_as("c", "an overflow mode", "x of x, y")
    );
}

/// Formats by name, of any kind: a design or an error, no panic. The engines agree on every built
/// design, and an unknown name is refused with the nearest one.
#[test]
fn formats_of_nodes_are_taken_or_refused() {
    let formats = [
        "u1f0", "s2f0", "u3f5", "s7f0", "s20f18", "u40f39", "s63f62", "u63f0", "s20f120", "s10f127",
    ];
    let mut built = 0;
    for unit in UNITS.iter() {
        for setting in ["", "rounding=floor"] {
            let set: Vec<&str> = setting.split_terminator(' ').collect();
            let Ok(values) = unit.values(&set) else { continue };
            let plain = values.build().unwrap();
            let choices = plain.netlist.choices();
            for (at, choice) in choices.iter().enumerate() {
                for format in [formats[at % formats.len()], formats[(at * 5 + 3) % formats.len()]] {
                    let given = format!("format.{}={format}", choice.name);
                    let mut all = set.clone();
                    all.push(&given);
                    let Ok(design) = unit.values(&all).unwrap().build() else { continue };
                    built += 1;
                    let found = design.netlist.choices().iter().find(|c| c.name == choice.name);
                    let found = found.unwrap_or_else(|| panic!("{} {given}", unit.name));
                    assert_eq!(found.format.to_string(), format, "{} {given}", unit.name);
                    assert!(found.overridden);
                    crate::engines::check(&design.netlist, 1, 20)
                        .unwrap_or_else(|text| panic!("{} {given}: {text}", unit.name));
                }
            }
        }
    }
    assert!(built > 200, "{built}");
    let refused = |set: &str| design_error("rotation", set);
    let text = refused("format.sincos.narow=s20f18");
    assert!(text.contains("has no node `sincos.narow`"), "{text}");
    let text = refused("format.phi=20");
    assert!(text.contains("parameter `format.phi` = `20`: legal is a format"), "{text}");
}

#[test]
fn schemes_of_tables_are_taken_or_refused() {
    let mut built = 0;
    for unit in UNITS.iter() {
        let plain = unit.defaults().build().unwrap();
        for choice in plain.netlist.schemes() {
            for scheme in Scheme::ALL {
                let given = format!("scheme.{}={scheme}", choice.table);
                let design = unit.values(&[&given]).unwrap().build().unwrap();
                let found = design.netlist.schemes().iter().find(|c| c.table == choice.table);
                let found = found.unwrap();
                assert_eq!((&found.scheme[..], found.overridden), (scheme.name(), true), "{given}");
                let table = design.tabulated.iter().find(|table| table.name == choice.table);
                if let Some(table) = table {
                    assert_eq!(table.scheme, *scheme, "{} {given}", unit.name);
                }
                if choice.scheme == scheme.name() {
                    assert!(design.netlist == plain.netlist, "{} {given}", unit.name);
                }
                crate::engines::check(&design.netlist, 1, 20).unwrap();
                built += 1;
            }
        }
    }
    assert!(built > 30, "{built}");
    // Setting every table by name equals setting the parameter for all.
    for scheme in ["linear", "bipartite"] {
        let kim = Unit::find("kim").unwrap();
        let all = ["sincos", "recip", "atan"].map(|table| format!("scheme.{table}={scheme}"));
        let by_name = kim.values(&all).unwrap().build().unwrap();
        let by_parameter = kim.values(&[format!("scheme={scheme}")]).unwrap().build().unwrap();
        assert!(by_name.netlist == by_parameter.netlist, "{scheme}");
        for variant in ["printed", "corrected", "exact"] {
            let rotation = Unit::find("rotation").unwrap();
            let build = |more: &[String]| {
                let sets: Vec<String> =
                    [format!("variant={variant}")].iter().chain(more).cloned().collect();
                rotation.values(&sets).unwrap().build().unwrap()
            };
            let by_parameter = build(&[format!("scheme={scheme}")]);
            let tables = by_parameter.netlist.schemes().iter();
            let all: Vec<String> = tables.map(|c| format!("scheme.{}={scheme}", c.table)).collect();
            let by_name = build(&all);
            assert!(by_name.netlist == by_parameter.netlist, "{variant} {scheme}");
            let joints = |design: &Design| format!("{:?}", design.hard);
            assert_eq!(joints(&by_name), joints(&by_parameter), "{variant} {scheme}");
        }
        for unit in ["illumination", "bump", "kim", "ernst"].map(|name| Unit::find(name).unwrap()) {
            let by_parameter = unit.values(&[format!("light_scheme={scheme}")]).unwrap();
            let by_parameter = by_parameter.build().unwrap();
            let tables = by_parameter.netlist.schemes().iter();
            let light = tables.filter(|c| ["diffuse", "specular"].contains(&&c.table[..]));
            let all: Vec<String> = light.map(|c| format!("scheme.{}={scheme}", c.table)).collect();
            assert!(!all.is_empty());
            let by_name = unit.values(&all).unwrap().build().unwrap();
            assert!(by_name.netlist == by_parameter.netlist, "{} {all:?}", unit.name);
        }
    }
    let refused = |set: &str| design_error("kim", set);
    let text = refused("scheme.sincs=linear");
    assert!(
        text.contains("has no table `sincs` whose scheme can be set, did you mean `sincos`"),
        "{text}"
    );
    let text = refused("scheme.sincos=lineer");
    assert!(
        text.contains("parameter `scheme.sincos` = `lineer`: legal is direct, linear, bipartite"),
        "{text}"
    );
}

/// A recipe that starts with its own builder can't know formats set by name, and reports that.
#[test]
fn a_builder_of_its_own_takes_nothing_by_name() {
    let own = |p: &Values, mut b: Builder| {
        let format = Format::unsigned(8, 8)?;
        let x = b.input("x", format, Quantity::Number);
        let table = Tabulated {
            name: "root".to_owned(),
            functions: vec![Function::new("root", |x| x.sqrt())],
            scheme: table::chosen(&mut b, "root", Scheme::Direct),
            addr_bits: 4,
            quarter_wave: false,
            origin: 0.0,
            output: Format::unsigned(9, 8)?,
            round: Round::HalfEven,
            argument: format,
        };
        let root = table::emit(&mut b, &table.spec(), x)[0];
        let y = b.narrow(root, Format::unsigned(5, 4)?, Round::HalfEven, Overflow::Saturate);
        b.name(y, "y");
        b.output("y", y);
        Ok(Design::new(p, b.build()?).golden(|_| Golden::each(|[x]: [f64; 1]| [x.sqrt()])))
    };
    let new = Unit::new("own", "").design(move |p| own(p, Builder::new("own")));
    let given = Unit::new("own", "").design(move |p| own(p, p.builder("own")));
    for (set, what) in [
        ("scheme.root=linear", "scheme for table `root`"),
        ("format.y=u4f3", "format for node `y`"),
    ] {
        let error = new.values(&[set]).unwrap().build().unwrap_err().to_string();
        assert!(error.contains(&format!("unit `own` ignores the {what}")), "{error}");
        given.values(&[set]).unwrap().build().unwrap();
    }
}

fn design_error(unit: &str, set: &str) -> String {
    let values = Unit::find(unit).unwrap().values(&[set]);
    values.and_then(|values| values.build().map(|_| ())).unwrap_err().to_string()
}

/// With a format set by name the golden stays, errors grow, and every report mentions the format.
#[test]
fn a_coarser_node_is_worse_and_is_told() {
    let design =
        |set: &[&str]| Unit::find("rotation").unwrap().values(set).unwrap().build().unwrap();
    let (plain, coarse) = (design(&[]), design(&["format.sincos=s7f5"]));
    let inputs = Inputs { sampler: Sampler::Sphere, samples: 4096, seed: 1 };
    let reports = measure(&[&plain, &coarse], &inputs, &|_| ()).unwrap();
    let max = |report: &Report| report.figures("angle", Basis::Total).max;
    assert!(max(&reports[1]) > 3.0 * max(&reports[0]));
    let told: Vec<String> =
        coarse.values.told().map(|(name, value)| format!("{name}={value}")).collect();
    assert_eq!(told.last().unwrap(), "format.sincos=s7f5");
    assert!(matches!(&coarse.bounds, Bounds::Unstated(_)));
}

/// A netlist file in place of a unit: its words are the unit's, and its total error is its
/// arithmetic error.
#[test]
fn a_netlist_stands_for_a_unit() {
    let netlist = Unit::find("rotation")
        .unwrap()
        .values(&["output=polar-table"])
        .unwrap()
        .build()
        .unwrap()
        .netlist;
    let unit = Unit::of_netlist((*netlist).clone());
    unit.check().unwrap();
    let design = unit.defaults().build().unwrap();
    assert!(*design.netlist == *netlist);
    let inputs = Inputs { sampler: Sampler::Sphere, samples: 4096, seed: 1 };
    let report = measure(&[&design], &inputs, &|_| ()).unwrap().remove(0);
    for port in ["phi", "theta"] {
        let total = report.figures(port, Basis::Total);
        assert_eq!(total.max, report.figures(port, Basis::Arithmetic).max, "{port}");
        assert_eq!(report.figures(port, Basis::Algorithm).max, 0.0, "{port}");
    }
    // Angles are compared modulo a turn: a value next to 0 is also next to 1.
    assert!(report.figures("phi", Basis::Total).max < 0.5);
    assert!(report.figures("theta", Basis::Total).max < 1e-3);
}

/// A formula defines each output, in names of ports and parameters.
#[test]
fn every_unit_has_a_formula_in_its_own_names() {
    for unit in UNITS.iter() {
        assert!(!unit.formula.is_empty(), "{}", unit.name);
        let longest = unit.formula.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest <= 150, "{}: a line of {longest}", unit.name);
        // Words with an underscore are names; ports may be those of another setting.
        let mut names: BTreeSet<String> = unit.params.iter().map(|p| p.name.clone()).collect();
        let mut ports = |design: &Design| {
            let netlist = &design.netlist;
            names.extend((0..netlist.inputs().len()).map(|at| netlist.input_name(at).to_owned()));
            names.extend(netlist.outputs().iter().map(|output| output.name.clone()));
        };
        ports(&unit.values::<&str>(&[]).unwrap().build().unwrap());
        for param in &unit.params {
            if let Kind::Choice(choices) = &param.kind {
                for choice in choices {
                    let set = format!("{}={choice}", param.name);
                    if let Ok(design) = unit.values(&[set]).and_then(|values| values.build()) {
                        ports(&design);
                    }
                }
            }
        }
        let word = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
        for name in unit.formula.split(word).filter(|word| word.contains('_')) {
            // The formula may define some itself.
            let defined = unit.formula.contains(&format!("{name} = "));
            assert!(
                names.contains(name) || defined,
                "{}: `{name}` in\n{}",
                unit.name,
                unit.formula
            );
        }
    }
}
