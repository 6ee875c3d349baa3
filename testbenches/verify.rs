//! Units in outside simulators, at what is committed and at random parameters.

use crate::committed::COMMITTED;
use crate::engines::Random;
use fixpath::hdl::Tables;
use fixpath::units::{Design, Kind, UNITS, Unit};
use fixpath::verify::{self, Request};
use std::collections::BTreeSet;
use std::time::Duration;

/// All tools take a design, and each of them agrees.
fn agrees(design: &Design, tables: Option<Tables>, context: &str) {
    let limit = Duration::from_secs(300);
    let request = Request { tables, limit, ..Request::default() };
    let rows = verify::verify(design, &request, &|_| {}).unwrap();
    for row in &rows {
        assert!(row.agrees(), "{context}: {row:#?}");
    }
    let hard: usize = design.hard.iter().map(|case| case.words.len()).sum();
    for (row, random) in rows.iter().zip([10_000, 1_000_000, 10_000]) {
        assert_eq!((row.vectors, row.mismatches), (hard as u64 + random, 0), "{context}: {row:#?}");
    }
}

/// The whole hard-case list, 10^6 random vectors in Verilator, 10^4 in Icarus and GHDL.
#[test]
#[ignore = "needs verilator, iverilog, ghdl and yosys: testbenches/run installs them"]
fn committed_settings_agree_in_every_tool() {
    for (name, unit, assignments) in COMMITTED {
        let design = Unit::find(unit).unwrap().values(assignments).unwrap().build().unwrap();
        agrees(&design, None, name);
    }
}

/// A value for each parameter, legal alone: the ends of ranges, and any.
fn random_assignments(unit: &'static Unit, random: &mut Random) -> Vec<String> {
    let assignment = |param: &fixpath::units::Param| {
        let value = match param.kind {
            Kind::Choice(names) => names[random.below(names.len())].to_owned(),
            Kind::Int { auto: Some(_), .. } if random.below(2) == 0 => "auto".to_owned(),
            Kind::Int { min, max, .. } => {
                // Large tables take long in slow simulators and show nothing new; a period of
                // a microsecond is as good as none.
                let max = match param.name {
                    name if name.ends_with("addr_bits") => max.min(11),
                    "period_ps" => 10_000,
                    "stages" => 20,
                    _ => max,
                };
                let any = min + random.below((max - min + 1) as usize) as i64;
                [min, max, any, any, any, any][random.below(6)].to_string()
            }
        };
        format!("{}={value}", param.name)
    };
    unit.all_params().map(assignment).collect()
}

/// Legal sets of parameters that are drawn with a seed, each with its design.
fn random_designs(unit: &'static Unit, count: usize, seed: u64) -> Vec<(Vec<String>, Design)> {
    let mut random = Random::new(seed);
    let mut designs = Vec::new();
    while designs.len() < count {
        let assignments = random_assignments(unit, &mut random);
        let design = unit.values(&assignments).and_then(|values| values.build());
        // Widths that don't go together, or too few stages.
        if let Ok(design) = design
            && design.rtl().is_ok()
        {
            designs.push((assignments, design));
        }
    }
    designs
}

const SETS: usize = 12;
const SEED: u64 = 7;

/// The sets drawn have every choice of every parameter among them.
#[test]
fn random_parameters_have_every_choice() {
    for unit in UNITS {
        let drawn: BTreeSet<String> =
            random_designs(unit, SETS, SEED).into_iter().flat_map(|(set, _)| set).collect();
        for param in unit.all_params() {
            if let Kind::Choice(names) = param.kind {
                for name in names {
                    let choice = format!("{}={name}", param.name);
                    assert!(drawn.contains(&choice), "{}: {choice} was never drawn", unit.name);
                }
            }
        }
    }
}

/// Tables stand in every place that they can.
#[test]
#[ignore = "needs verilator, iverilog, ghdl and yosys: testbenches/run installs them"]
fn random_parameters_agree_in_every_tool() {
    let places = [None, Some(Tables::Inline), Some(Tables::Files), Some(Tables::Case)];
    for unit in UNITS {
        for (number, (set, design)) in random_designs(unit, SETS, SEED).iter().enumerate() {
            agrees(design, places[number % places.len()], &set.join(" "));
        }
    }
}
