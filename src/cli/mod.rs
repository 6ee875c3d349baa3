//! The command line. Exit codes: 0 done, 1 a check failed, 2 wrong use, unreadable input, or an
//! outside tool that could not finish.

mod compare;
mod cost;
mod demo;
mod hardware;
mod help;
mod ladder;
mod number;
mod options;
mod print;
mod progress;
mod render;
mod schedule;
mod shell;
mod show;
mod signals;
mod sim;
mod sweep;
mod texgen;
mod text;
mod verify;
mod wave;

use crate::base::error::{Error, Result};
use crate::base::{cast, escape, json, output, whole};
use crate::design::{Design, Unit};
use crate::hardware::wave::Options;
use crate::measure::{Basis, Cone, eval};
use crate::sweep::{Axis, Sweep};
use crate::units;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use options::{BasisArg, ErrorArg, InputArgs, TableArgs, UnitArgs};
use print::{note, note_clipped, note_unused, print, printed};
use progress::progress_bar;
use sim::{Sim, with_profile, write_cases};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use sweep::run_sweep;
use wave::{MAX_SAMPLES, read_stimulus, stimulus, write_wave};

/// Largest number of threads.
const MAX_THREADS: u64 = 1024;

/// Generator and bit-true simulator of fixed-point datapaths.
#[derive(Parser)]
#[command(
    name = "fixpath",
    bin_name = "fixpath",
    version,
    disable_help_subcommand = true,
    max_term_width = 100,
    after_help = "Examples:\n  \
        fixpath list rotation\n  \
        fixpath show rotation -p variant=corrected\n  \
        fixpath sim rotation -p scheme=linear --samples 1000000\n  \
        fixpath sim rotation --hard\n  \
        fixpath wave rotation --out rotation.vcd && gtkwave rotation.vcd rotation.gtkw\n  \
        fixpath sweep rotation --axis table_addr_bits=6..14:2 --axis variant=corrected,exact --out sweep\n  \
        fixpath demo\n\n\
        Formats of files: fixpath help scene, netlist, samples, memory or texgen."
)]
struct Cli {
    /// Number of threads; default: RAYON_NUM_THREADS if set, otherwise one per core.
    #[arg(long, global = true, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(1..=MAX_THREADS))]
    threads: Option<u64>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// List the units, or one unit's formula, ports and parameters with their defaults and legal
    /// ranges.
    #[command(
        after_help = "Examples:\n  fixpath list\n  fixpath list rotation\n  fixpath list rotation --json"
    )]
    List {
        /// Unit to describe.
        unit: Option<String>,
        /// As JSON.
        #[arg(long)]
        json: bool,
    },
    /// Show a datapath: formats, tables, operator counts, ROM bits, stages, netlist.
    #[command(
        after_help = "Examples:\n  fixpath show rotation\n  fixpath show rotation -p variant=corrected -p scheme=linear --json\n  fixpath show rotation --dot | dot -Tsvg > rotation.svg\n  fixpath show rotation --netlist > rotation.netlist && fixpath sim ./rotation.netlist"
    )]
    Show {
        #[command(flatten)]
        unit: UnitArgs,
        /// As JSON.
        #[arg(long, conflicts_with = "dot")]
        json: bool,
        /// Print the netlist as a Graphviz graph.
        #[arg(long)]
        dot: bool,
        /// Print the netlist in the file format that every command accepts in place of a unit.
        #[arg(long, conflicts_with_all = ["dot", "json"])]
        netlist: bool,
    },
    /// Print a time-shared schedule: the operation of each unit in each cycle, and the hardware it
    /// needs.
    #[command(
        after_help = "Cycles count from 1. A unit with operand registers loads in the cycle before it computes.\n\nExamples:\n  fixpath schedule bump -p schedule=shared -p share_mul=2 -p share_add=2\n  fixpath schedule emboss -p schedule=shared -p share_dot=2 -p interval=8 --json\n  fixpath schedule emboss -p schedule=printed -p l_sign=vertex-light     the schedule of US 6,980,218"
    )]
    Schedule(schedule::ScheduleArgs),
    /// Run a unit on a CSV of real inputs.
    #[command(
        after_help = "Input columns are named by port P (see `fixpath list`); for rotation phi_a,theta_a,phi_n,theta_n.\nEach port may be given as its word P_raw, its quantised value P_q or a real number P. If several are\npresent, the first of these counts and the others must agree. Separators: commas, semicolons or tabs.\nOutput: P_q and P_raw per input port, P, P_raw and P_golden per output port, and in `clipped` the\ninput ports whose value was out of range. The output can be read again as input.\n\nExamples:\n  fixpath eval rotation -p scheme=linear --in vectors.csv --out results.csv --angle degrees\n  fixpath eval rotation --in - --out - < vectors.csv | head -3"
    )]
    Eval {
        #[command(flatten)]
        unit: UnitArgs,
        /// CSV to read; - reads standard input. A named pipe blocks until its other end opens.
        #[arg(long = "in", value_name = "FILE")]
        input: PathBuf,
        /// CSV to write; - writes to standard output. A named pipe blocks until its other end
        /// opens.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        #[command(flatten)]
        table: TableArgs,
    },
    /// Measure errors against the golden model (the same function in double precision), with the
    /// worst-case inputs.
    #[command(
        after_help = "Examples:\n  fixpath sim rotation --samples 10000000\n  fixpath sim rotation -p variant=corrected --json\n  fixpath sim rotation -p angle_bits=5 --sampler exhaustive\n  fixpath sim rotation -p variant=corrected -p angle_bits=10 --cone sin_theta_x\n  fixpath sim rotation --basis total --samples 100000000\n  fixpath sim rotation --hard --cases cases.csv"
    )]
    Sim {
        #[command(flatten)]
        unit: UnitArgs,
        #[command(flatten)]
        inputs: InputArgs,
        /// Run the hard-case list: each case with f32 and f64 results and a verdict.
        #[arg(long, conflicts_with = "sampler")]
        hard: bool,
        /// Write every hard case with its results to a CSV.
        #[arg(long, value_name = "FILE", requires = "hard")]
        cases: Option<PathBuf>,
        /// Measure one node only, against its value on reals, over every combination of the words
        /// that it depends on (up to 2^32). NODE is its name, the name of an output port, or its
        /// number in `fixpath show`.
        #[arg(long, value_name = "NODE", conflicts_with_all = ["hard", "samples", "seed", "cases", "sampler"])]
        cone: Option<String>,
        /// Measure errors on these bases only, which is faster. `total` is always included, since
        /// bounds refer to it.
        #[arg(
            long,
            value_name = "BASIS",
            value_enum,
            value_delimiter = ',',
            default_value = "total,arithmetic,algorithm,end-to-end",
            conflicts_with = "cone"
        )]
        basis: Vec<BasisArg>,
        /// Print the share of time spent in each part.
        #[arg(long)]
        profile: bool,
        /// As JSON.
        #[arg(long)]
        json: bool,
    },
    /// Simulate the pipeline cycle by cycle and write a VCD, with a GTKWave save file beside it.
    #[command(
        after_help = "In a pipeline the words of one sample appear in successive cycles. To see them in one cycle, with\nthe node where an error arises, add -p stages=0 -p rom=distributed.\n\nExamples:\n  fixpath wave rotation --out rotation.vcd\n  fixpath wave rotation --in vectors.csv --cycles 0..50 --signals 'x*' --out short.vcd\n  fixpath wave rotation --signals '*error' --out errors.vcd\n  fixpath wave rotation -p stages=0 -p rom=distributed --out combinational.vcd"
    )]
    Wave {
        #[command(flatten)]
        unit: UnitArgs,
        /// CSV of inputs in the format of `eval`, one row per sample (a cycle or an interval); -
        /// reads standard input. Without it, hard cases and random vectors.
        #[arg(long = "in", value_name = "FILE")]
        input: Option<PathBuf>,
        #[command(flatten)]
        table: TableArgs,
        /// VCD to write; FILE.gtkw is written beside it.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        /// Number of samples without a CSV; default 200.
        #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(1..=MAX_SAMPLES))]
        samples: Option<u64>,
        /// Seed of the random vectors; default 1.
        #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(0..=u64::MAX))]
        seed: Option<u64>,
        /// Cycles to write, as FIRST..END; END is excluded.
        #[arg(long, value_name = "A..B", allow_hyphen_values = true, value_parser = number::window)]
        cycles: Option<std::ops::Range<u64>>,
        /// Signals to write, as scope.name without the unit; * matches any text, so *error selects
        /// all errors.
        #[arg(long, value_name = "PATTERN", value_delimiter = ',')]
        signals: Vec<String>,
        /// Include unnamed nodes and pipeline registers.
        #[arg(long)]
        all: bool,
        /// Omit the real-valued copies of words.
        #[arg(long)]
        words_only: bool,
    },
    /// Measure a grid of parameter settings; write CSV, JSON, Markdown and plots.
    #[command(
        after_help = "Results are saved as points finish. After an interruption, the same command resumes.\n\nExamples:\n  fixpath sweep rotation --axis table_addr_bits=6..14:2 --axis variant=printed,corrected,exact --out sweep\n  fixpath sweep rotation -p scheme=linear --axis frac_bits=8..20 --samples 100000 --out widths\n  fixpath sweep bump --scene sphere --axis angle_bits=8..16:2 --axis scheme=direct,linear --out sphere\n  fixpath sweep bump --scene plane --error flip --axis exponent=8,32,128 --axis light_scheme=direct,linear --out light"
    )]
    Sweep {
        #[command(flatten)]
        unit: UnitArgs,
        /// Axis: key=v,v,… or key=a..b[:step]. Several axes make a grid.
        #[arg(long = "axis", value_name = "KEY=VALUES", required = true)]
        axes: Vec<String>,
        #[command(flatten)]
        inputs: InputArgs,
        /// Take the inputs from the pixels of a scene: a scene file, or a built-in scene. The
        /// error is then that of the picture. Material parameters default to the scene's. One set
        /// by `-p` or an axis also changes the golden picture.
        #[arg(long, value_name = "SCENE", conflicts_with_all = ["samples", "seed", "sampler"])]
        scene: Option<PathBuf>,
        /// Error that ranks the pictures; every point records all errors.
        #[arg(long, value_enum, default_value = "max", requires = "scene")]
        error: ErrorArg,
        /// Folder to write.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Start over and discard earlier results in the folder.
        #[arg(long)]
        fresh: bool,
        /// Print the share of time spent in each part.
        #[arg(long, conflicts_with = "scene")]
        profile: bool,
    },
    /// Write a unit as hardware: module, tables, self-checking testbench, vectors, makefiles.
    #[command(
        after_help = "Examples:\n  fixpath hdl rotation --out rtl && make -C rtl -f rotation_icarus.mk\n  fixpath hdl rotation -p variant=corrected --name corrected --tables files --out rtl\n  fixpath hdl rotation --language vhdl --vectors 100000 --out rtl"
    )]
    Hdl(hardware::HdlArgs),
    /// Run a unit's hardware in the outside simulators that are installed, and compare every output
    /// bit.
    #[command(
        after_help = "Icarus, Verilator and GHDL run the hard-case list and random vectors; Yosys checks the\nmodule and proves it equal to its combinational reference at small widths, within 60 s.\n\nExamples:\n  fixpath verify rotation\n  fixpath verify rotation -p scheme=linear --with verilator --vectors 10000000\n  fixpath verify rotation -p variant=corrected --keep files --json"
    )]
    Verify(verify::VerifyArgs),
    /// Synthesise a unit: LUTs, flip-flops, block RAMs, DSPs and the clock it reaches.
    #[command(
        after_help = "Yosys counts the cells. If nextpnr is installed, it places and routes the unit between registers.\nCounting rules: an ECP5 CCU2C is two LUTs, a Xilinx SRL16E is one; a RAMB36E1 is two\nblock RAMs (RAMB18E1). The estimate is the one that `fixpath show` prints.\n\nExamples:\n  fixpath cost rotation\n  fixpath cost rotation -p table_addr_bits=8 --target ice40\n  fixpath cost rotation -p variant=corrected --target ecp5,xilinx --json"
    )]
    Cost(cost::CostArgs),
    /// Rebuild Table 1 of Lee et al.: operator counts beside the paper's, and the errors that its
    /// table lacks.
    #[command(
        after_help = "Counts come from the netlists of peercy, kugler, kim, ernst and of every pipeline of bump.\n\nExamples:\n  fixpath compare\n  fixpath compare -p scheme=linear --samples 1000000\n  fixpath compare -p map_addr_bits=20 -p exponent=64 --out table1.md"
    )]
    Compare(compare::CompareArgs),
    /// Render a scene with fixed-point pipelines: fixed, golden and difference pictures, and
    /// figures.
    #[command(
        after_help = "Examples:\n  fixpath render sphere --out sphere\n  fixpath render scene.toml --pipelines exact-polar -p angle_bits=12 -p scheme=linear --out pictures\n  fixpath render plane --ladder --out ladder\n  fixpath render sphere --ladder=8,12,16 --pipelines exact-polar,exact-cartesian -p scheme=linear --exponents 8,64 --out ladder\n  fixpath render lettering-raised --pipelines emboss-gx,emboss-nv --out emboss\n  fixpath render light-orbit --pipelines emboss-gx --out frames\n  fixpath render mirrored --pipelines tangent-smooth,tangent-faceted -p mirror=handed --out set-up\n  fixpath render mirrored --pipelines exact-polar --frames setup -p component_bits=12 --out frames"
    )]
    Render(render::RenderArgs),
    /// Check calls to a texture-coordinate interface: GXSetTexCoordGen, GL_NV_texgen_emboss.
    #[command(after_help = texgen::HELP)]
    Texgen(texgen::TexgenArgs),
    /// Print the JSON Schema of all JSON output.
    #[command(
        after_help = "Every document identifies itself: its first fields are tool, version, document and schema_version.\n\nExample:\n  fixpath schema > fixpath.schema.json"
    )]
    Schema,
    /// Print the help of a command, or the format of a file with every key and its default.
    #[command(
        after_help = "Examples:\n  fixpath help sweep\n  fixpath help scene\n  fixpath help netlist"
    )]
    Help(help::HelpArgs),
    /// Run measurements, waves, hardware, scenes and a sweep on built-in settings, in under half a
    /// minute.
    #[command(after_help = "Example:\n  fixpath demo --out demo_out")]
    Demo {
        /// Folder to write.
        #[arg(long, value_name = "DIR", default_value = "demo_out")]
        out: PathBuf,
    },
}

/// The clap command, for example to generate completions and manual pages.
#[must_use]
pub fn command() -> clap::Command {
    Cli::command()
}

/// Runs the command line with the caller's units added to those of [`crate::units`]. A program's
/// `main` needs nothing else.
///
/// ```no_run
/// use fixpath::format::{Overflow, Round};
/// use fixpath::netlist::Quantity;
/// use fixpath::units::{Design, Golden, Unit};
/// use std::process::ExitCode;
///
/// fn half() -> Unit {
///     Unit::new("half", "half of a word, rounded").design(|p| {
///         let mut b = p.builder("half");
///         let x = b.input("x", "s8f4".parse()?, Quantity::Number);
///         let exact = b.shift(x, -1);
///         let y = b.narrow(exact, "s8f4".parse()?, Round::HalfEven, Overflow::Saturate);
///         b.output("y", y);
///         Ok(Design::new(p, b.build()?).golden(|_| Golden::each(|[x]: [f64; 1]| [0.5 * x])))
///     })
/// }
///
/// fn main() -> ExitCode {
///     fixpath::main(&[half()])
/// }
/// ```
#[must_use]
pub fn main(units: &[Unit]) -> ExitCode {
    let done = match Cli::try_parse() {
        Ok(cli) => signals::watch()
            .and_then(|()| units::add(units))
            .and_then(|()| start_threads(cli.threads))
            .and_then(|()| run(&cli.command)),
        // --help and --version.
        Err(told) if !told.use_stderr() => printed(told.print()).map(|()| true),
        Err(error) => return refuse(&error),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) if error.is_broken_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            // The message without its source chain: it already includes the cause. A failed write
            // to stderr is ignored.
            let _ = writeln!(io::stderr(), "error: {error}");
            ExitCode::from(if error.is_failed_check() { 1 } else { 2 })
        }
    }
}

/// Reports an error in the command line.
fn refuse(error: &clap::Error) -> ExitCode {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = error.print();
        return ExitCode::from(2);
    }
    // One line, like every other error, then clap's tips, without the usage.
    let text = error.to_string();
    let ends = |line: &str| line.starts_with("Usage:") || line.starts_with("For more info");
    let lines = text.lines().take_while(|line| !ends(line));
    let parts = lines.map(str::trim).filter(|line| !line.is_empty());
    let (tips, parts): (Vec<&str>, Vec<&str>) = parts.partition(|line| line.starts_with("tip:"));
    let whole = Cli::command();
    let mut given = std::env::args_os().skip(1);
    let command = given.find(|name| whole.find_subcommand(name).is_some());
    let command = command.map(|name| format!("{} ", name.display())).unwrap_or_default();
    let told = escape::message(&parts.join(" "));
    let _ = writeln!(io::stderr(), "{told}: see `fixpath {command}--help`");
    // A tip repeats the argument: a long one is no help.
    for tip in tips.iter().filter(|tip| tip.len() < 200) {
        let _ = writeln!(io::stderr(), "  {}", escape::message(tip));
    }
    ExitCode::from(2)
}

/// Starts the thread pool here, because rayon would accept any number from its environment variable
/// and panic if the threads can't start.
fn start_threads(asked: Option<u64>) -> Result<()> {
    const VARIABLE: &str = "RAYON_NUM_THREADS";
    let given = std::env::var(VARIABLE).ok();
    let number = given.as_deref().and_then(|text| whole::parse(text.trim()));
    if let (None, None, Some(text)) = (asked, number, &given) {
        note(&format!(
            "{VARIABLE} = {} is not a number of threads and is ignored",
            escape::short(text)
        ));
    }
    let threads = match (asked, number) {
        (Some(asked), _) => asked,
        (None, Some(given)) if given > MAX_THREADS => {
            let text =
                format!("{VARIABLE} = {given}: legal is 1 to {MAX_THREADS}; or give --threads");
            return Err(Error::usage(text));
        }
        (None, Some(given @ 1..)) => given,
        (None, Some(0) | None) => std::thread::available_parallelism()
            .map_or(1, |cores| cast::count_of(cores.get()).min(MAX_THREADS)),
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(cast::index_of_bits(threads))
        .build_global()
        .map_err(|why| {
            let why = std::error::Error::source(&why).map_or(why.to_string(), ToString::to_string);
            let remedy = "set fewer with --threads, or raise the limit on processes (ulimit -u)";
            Error::usage(format!("can't start {threads} threads: {why}: {remedy}"))
        })
}

/// Runs a command; false means that a check failed.
fn run(command: &Command) -> Result<bool> {
    match command {
        Command::List { unit, json } => {
            let one = unit.as_deref().map(units::named).transpose()?;
            let units: Vec<&Unit> = match &one {
                Some(unit) => vec![unit],
                None => units::all().collect(),
            };
            print(&match &one {
                _ if *json => json::text(&text::list_json(&units)),
                Some(unit) => text::list_unit(unit),
                None => text::list(&units),
            })?;
        }
        Command::Show { unit, json, dot, netlist } => {
            let design = unit.design()?;
            print(&if *netlist {
                design.netlist.to_file()
            } else if *dot {
                design.netlist.to_dot()
            } else if *json {
                json::text(&show::show_json(&design)?)
            } else {
                show::show(&design)?
            })?;
        }
        Command::Eval { unit, input, out, table } => {
            eval_command(&unit.design()?, input, out, table)?;
        }
        Command::Sim { unit, cone: Some(label), profile, json, .. } => {
            let design = unit.design()?;
            let cone = Cone::new(&design.netlist, label)?;
            let bar = progress_bar(cone.samples(), &design.values.unit().name);
            let measured = cone.measure(&design, &|done| bar.set_position(done))?;
            bar.finish_and_clear();
            let times = profile.then_some(&measured.report.speed.profile);
            print(&if *json {
                json::text(&with_profile(text::cone_json(&design, &cone, &measured), times))
            } else {
                text::cone(&design, &cone, &measured)
                    + &times.map(text::profile).unwrap_or_default()
            })?;
        }
        Command::Sim { unit, inputs, hard, cases, cone: None, basis, profile, json } => {
            let inputs = inputs.inputs(*hard);
            let asked = |known: &Basis| {
                *known == Basis::Total || basis.iter().any(|asked| asked.0 == *known)
            };
            let bases: Vec<Basis> = Basis::ALL.into_iter().filter(asked).collect();
            let sim = Sim::run(unit.design()?, &inputs, &bases)?;
            if let Some(path) = cases {
                output::write_file(path, |to| write_cases(&sim, to, path))?;
            }
            let times = profile.then_some(&sim.report.speed.profile);
            print(&if *json {
                json::text(&with_profile(text::sim_json(&sim), times))
            } else {
                text::sim(&sim) + &times.map(text::profile).unwrap_or_default()
            })?;
            return Ok(sim.passed());
        }
        Command::Wave {
            unit,
            input,
            table,
            out,
            samples,
            seed,
            cycles,
            signals,
            all,
            words_only,
        } => {
            let design = unit.design()?;
            // Samples after the window aren't needed.
            let end = cycles.as_ref().map_or(u64::MAX, |cycles| cycles.end);
            let stimulus = match input {
                Some(path) => {
                    let why = "--in gives the samples";
                    note_unused(&[("--samples", *samples), ("--seed", *seed)], why);
                    read_stimulus(table.open(path, &design)?, end)?
                }
                None => stimulus(&design, samples.unwrap_or(200).min(end), *seed)?,
            };
            let options = Options {
                cycles: cycles.clone(),
                signals: signals.clone(),
                all: *all,
                words_only: *words_only,
            };
            print(&write_wave(&design, options, &stimulus, out)?)?;
        }
        Command::Sweep { unit, axes, inputs, scene, error, out, fresh, profile } => {
            let base = unit.values()?;
            let axes: Result<Vec<Axis>> =
                axes.iter().map(|axis| Axis::parse(axis, base.unit())).collect();
            let axes = axes?;
            for axis in &axes {
                let fixed =
                    |set: &String| set.split_once('=').is_some_and(|(k, _)| k == axis.key());
                if unit.params.iter().any(fixed) {
                    let text =
                        format!("parameter `{}` is set with -p and swept by an axis", axis.key());
                    return Err(Error::usage(text));
                }
            }
            let sweep = match scene {
                None => Sweep::new(base, axes, inputs.inputs(false))?,
                Some(path) => {
                    let keys = unit.params.iter().filter_map(|set| set.split_once('='));
                    let set: Vec<&str> = keys.map(|(key, _)| key).collect();
                    Sweep::over_scene(base, &set, axes, render::view_of(path, error.0)?)?
                }
            };
            print(&run_sweep(&sweep, out, *fresh, *profile)?)?;
        }
        Command::Schedule(args) => print(&schedule::run(args)?)?,
        Command::Hdl(args) => print(&hardware::run(args)?)?,
        Command::Verify(args) => {
            let (told, ended) = verify::run(args)?;
            print(&told)?;
            return ended;
        }
        Command::Cost(args) => print(&cost::run(args)?)?,
        Command::Compare(args) => print(&compare::run(args)?)?,
        Command::Render(args) => {
            let (told, same) = render::run(args)?;
            print(&told)?;
            return Ok(same);
        }
        Command::Texgen(args) => {
            let (told, broken) = texgen::run(args)?;
            print(&told)?;
            return broken.map_or(Ok(true), Err);
        }
        Command::Schema => print(json::SCHEMA)?,
        Command::Help(args) => help::run(args, Cli::command())?,
        Command::Demo { out } => return demo::run(out),
    }
    Ok(true)
}

fn eval_command(design: &Design, input: &Path, out: &Path, table: &TableArgs) -> Result<()> {
    let dash = Path::new("-");
    let mut samples = table.open(input, design)?;
    if out == dash {
        let path = Path::new("standard output");
        eval::eval(design, &mut samples, &mut io::stdout().lock(), path)?;
    } else {
        output::write_file(out, |to| eval::eval(design, &mut samples, to, out).map(|_| ()))?;
    }
    note_clipped(&samples);
    Ok(())
}
