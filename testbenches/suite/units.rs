//! Parameters of all units together: what is refused, and whether its remedy is one.

use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Quantity};
use fixpath::units::fragment::Port;
use fixpath::units::{Design, Golden, Kind, Param, Reflection, Role, Shading, UNITS, Unit, Values};
use fixpath::verify::Proof;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A legal value of a parameter; tables stay small, so that builds take no time.
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

/// Names between back ticks after the verb.
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
            // Values that don't go together name a parameter and the legal ones.
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
            // Names are for people, who go by these ends.
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
        // One parameter at most says which datapath it is, and each part of a formula is one.
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

/// A unit whose parameters aren't named as those of others are.
fn odd() -> Unit {
    Unit::new("odd", "")
        .param(Param::bits("breadth", 2..=12).default(12))
        .param(Param::int("only_told_bits", 0..=99).role(Role::Label).default(99))
        .design(|values| {
            assert_eq!(values.int("only_told_bits"), Some(99), "told alone, it is no width");
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
