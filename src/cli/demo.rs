//! `fixpath demo`: everything that needs no outside tool, on built-in settings, into one folder.

use super::print::print;
use super::render::{self, RenderArgs};
use super::sim::Sim;
use super::sweep::run_sweep;
use super::wave::{stimulus, write_wave};
use super::{show, text};
use crate::base::error::Result;
use crate::base::json;
use crate::base::output::{self, Set};
use crate::design::{Sampler, Unit};
use crate::hardware::emit::{Package, Settings};
use crate::hardware::wave::Options;
use crate::measure::eval;
use crate::measure::samples::{AngleUnit, SampleFile};
use crate::measure::{Basis, Inputs};
use crate::shading::render::EMBOSS_PIPELINES;
use crate::sweep::{Axis, Sweep};
use std::fmt::Write as _;
use std::path::Path;

/// Samples per figure.
const SAMPLES: u64 = 2_000_000;
/// Samples per point of the sweep.
const SWEEP_SAMPLES: u64 = 200_000;

/// The paper's unit as printed and as corrected, and the exact unit with several schemes.
const SETTINGS: [(&str, &[&str]); 6] = [
    ("printed", &["variant=printed"]),
    ("corrected", &["variant=corrected"]),
    ("exact_direct", &["variant=exact"]),
    ("exact_bipartite", &["variant=exact", "scheme=bipartite"]),
    ("exact_linear", &["variant=exact", "scheme=linear"]),
    ("exact_polar", &["variant=exact", "output=polar-table", "scheme=linear"]),
];

/// The paper's scenes.
const SCENES: [&str; 3] = ["plane", "cube", "sphere"];
/// A scene for the emboss pipelines.
const EMBOSSED: &str = "lettering-raised";

/// Runs the demo; false means that a check failed.
pub(super) fn run(out: &Path) -> Result<bool> {
    let unit = Unit::find("rotation")?;
    let (set, place) = (Set::open(out, "demo")?, out);
    let out = &*set.path();
    for folder in ["sim", "waves", "netlists"] {
        output::make_folder(&out.join(folder))?;
    }
    let write = output::write_text;
    let mut story = String::from(
        "# fixpath demo\n\nThe polar rotation unit of Lee et al., over lit vectors uniform on the sphere. \
         Errors are the angle between\nvectors, against the golden model (the same function in double precision) of the quantised inputs; *algorithm* \
         is the error of the method in exact arithmetic,\n*arithmetic* the error that words and tables add.\n\n\
         | setting | algorithm | arithmetic | total | multipliers | ROM bits | with one copy per two read ports |\n|---|---|---|---|---|---|---|\n",
    );
    let mut passed = true;
    let inputs = Inputs { sampler: Sampler::Lit, samples: SAMPLES, seed: 1 };
    let hard = Inputs { sampler: Sampler::Hard, ..inputs };
    let mut hard_text = String::new();
    for (name, assignments) in SETTINGS {
        let design = || unit.values(assignments)?.build();
        let sim = Sim::run(design()?, &inputs, &Basis::ALL)?;
        write(&out.join(format!("sim/{name}.txt")), &text::sim(&sim))?;
        write(&out.join(format!("sim/{name}.json")), &json::text(&text::sim_json(&sim)))?;
        let counts = sim.design.netlist.counts();
        let line = |basis| text::angle_line(&sim.report, basis);
        let _ = writeln!(
            story,
            "| {name} | {} | {} | {} | {} | {} | {} |",
            line(Basis::Algorithm),
            line(Basis::Arithmetic),
            line(Basis::Total),
            counts.datapath.multipliers + counts.schemes.multipliers,
            counts.rom_bits,
            counts.rom_bits_dual_port,
        );
        let hard = Sim::run(design()?, &hard, &Basis::ALL)?;
        passed &= sim.passed() && hard.passed();
        hard_text.push_str(&text::hard_cases(&hard));
        hard_text.push('\n');
        let netlist = &sim.design.netlist;
        write(&out.join(format!("netlists/{name}.txt")), &show::show(&sim.design)?)?;
        write(&out.join(format!("netlists/{name}.dot")), &netlist.to_dot())?;
        let wave = out.join(format!("waves/{name}.vcd"));
        write_wave(&sim.design, Options::default(), &stimulus(&sim.design, 200, None)?, &wave)?;
        let settings = Settings {
            name: Some(format!("rotation_{name}")),
            hard_per_group: Some(10),
            ..Settings::default()
        };
        let hardware = out.join("hdl").join(name);
        Package::new(&sim.design, &settings)?.write(&hardware)?;
    }
    write(&out.join("hard_cases.txt"), &hard_text)?;

    let vectors = "phi_a,theta_a,phi_n,theta_n\n0,45,0,0\n30,60,10,20\n350,10,10,170\n90,90,0,90\n";
    write(&out.join("vectors.csv"), vectors)?;
    let results = out.join("results.csv");
    let design = unit.values(&["scheme=linear"])?.build()?;
    output::write_file(&results, |to| {
        let (from, path) = (vectors.as_bytes(), Path::new("vectors.csv"));
        let mut samples = SampleFile::open(from, path, &design, AngleUnit::Degrees, false)?;
        eval::eval(&design, &mut samples, to, &results).map(|_| ())
    })?;

    let axes = [
        "table_addr_bits=6..14",
        "variant=printed,corrected,exact",
        "scheme=direct,bipartite,linear",
    ];
    let axes: Result<Vec<Axis>> = axes.iter().map(|axis| Axis::parse(axis, unit)).collect();
    let sweep_inputs = Inputs { samples: SWEEP_SAMPLES, ..inputs };
    let sweep = Sweep::new(unit.defaults(), axes?, sweep_inputs)?;
    run_sweep(&sweep, &out.join("sweep"), true, false)?;

    story.push_str(
        "\n# Scenes\n\nThe paper's three pictures by complete bump-mapping pipelines, and letters by emboss, each against its float golden: the largest and the mean\n\
         difference in linear light, in 1/255, and the share of covered\n\
         pixels that differ in 8 bits; means are over covered pixels, those that see an object.\n\n\
         | scene | pipeline | max | mean | differing | covered pixels |\n|---|---|---|---|---|---|\n",
    );
    let scenes = SCENES.map(|name| (name, &[][..]));
    for (name, pipelines) in scenes.into_iter().chain([(EMBOSSED, &EMBOSS_PIPELINES[..])]) {
        let args = RenderArgs::of_builtin(name, pipelines, &out.join("scenes").join(name));
        let (rows, held) = render::demo_rows(&args)?;
        passed &= held;
        for row in rows {
            let _ = writeln!(story, "| {name} | {row} |");
        }
    }

    story.push_str(
        "\n- `sim/`: all figures with the worst-case inputs, as text and JSON\n\
         - `hard_cases.txt`: the hard-case list with f32 and f64 results and a verdict\n\
         - `waves/`: open with `gtkwave waves/exact_linear.vcd waves/exact_linear.gtkw`\n\
         - `hdl/`: Verilog, VHDL, testbenches; `make -C hdl/exact_linear -f rotation_exact_linear_icarus.mk`\n\
         - `netlists/`: formats, tables, operators, stages; `.dot` for Graphviz\n\
         - `vectors.csv`, `results.csv`: `eval` on four vectors in degrees\n\
         - `scenes/`: `sheet.png` of each scene has the golden, each pipeline and its difference side by side\n\
         - `sweep/`: table sizes, variants and schemes as CSV, JSON, `report.md` and plots\n",
    );
    write(&out.join("README.md"), &story)?;
    set.commit()?;
    print(&format!("{story}\nwritten to {}\n", place.display()))?;
    if !passed {
        print("a stated bound is BROKEN: see sim/ and hard_cases.txt\n")?;
    }
    Ok(passed)
}
