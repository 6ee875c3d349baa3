//! Parameters of all units together: what is refused, and whether its remedy is one.

use fixpath::units::{Kind, Param, UNITS, Unit, Values};
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A legal value of a parameter; tables stay small, so that builds take no time.
fn legal(param: &Param, random: &mut Pcg64Mcg) -> String {
    let mut below = |n: u64| random.next_u64() % n;
    match param.kind {
        Kind::Int { min, max, .. } => {
            let is_table = param.name.ends_with("addr_bits");
            let max = if is_table { max.min(min.max(7)) } else { max };
            // Wide words are refused, so every other value is the greatest.
            let value = min + i64::try_from(below((max - min + 1).unsigned_abs())).unwrap();
            (if below(2) == 0 && !is_table { max } else { value }).to_string()
        }
        Kind::Real { min, max } => (0.5 * (min + max)).to_string(),
        Kind::Choice(names) => {
            names[usize::try_from(below(names.len() as u64)).unwrap()].to_owned()
        }
    }
}

/// Names between back ticks after the verb.
fn named(message: &str, verb: &str) -> Vec<String> {
    let Some((_, rest)) = message.split_once(&format!(": {verb} `")) else { return Vec::new() };
    rest.trim_end_matches('`').split("` or `").map(str::to_owned).collect()
}

/// Follows the remedies of a refusal until the unit builds, or is refused for another reason.
fn cure(unit: &'static Unit, mut values: Values) {
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
    for unit in UNITS {
        for _ in 0..12 {
            let mut values = unit.defaults();
            for param in unit.params {
                values.set(param.name, &legal(param, &mut random)).unwrap();
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
