//! Hardware files of a design: module, tables, testbench, vectors and makefiles. The head of each
//! file lists the parameters and figures of the design.

pub mod vectors;

use crate::base::error::{Error, Result};
use crate::base::output::{self, Set};
use crate::design::{Design, Sampler};
use crate::hardware::hdl::testbench::{companions, vectors_file};
use crate::hardware::hdl::{File, LANGUAGES, Language, Memories, Module, Options, Tables, cycles};
use crate::hardware::rtl::Rtl;
use crate::measure::{self, Basis, BoundCheck, Inputs};
use crate::schedule::Rom;
use std::path::Path;
use std::sync::Arc;
use vectors::Vectors;

/// Samples measured for the figures in heads.
const HEADER_SAMPLES: u64 = 1 << 16;
/// Largest width of a line in a head.
const LINE: usize = 96;

/// What to write.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Name of the module; the unit's name if `None`.
    pub name: Option<String>,
    /// Where table words are placed; chosen by their number if `None`.
    pub tables: Option<Tables>,
    /// Where memories are placed.
    pub memories: Memories,
    /// Languages.
    pub languages: Vec<&'static dyn Language>,
    /// Random vectors after the hard cases.
    pub random: u64,
    /// Seed of the random vectors.
    pub seed: u64,
    /// Largest number of hard cases of each group; all if `None`.
    pub hard_per_group: Option<usize>,
    /// True to measure errors for the heads.
    pub figures: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            name: None,
            tables: None,
            memories: Memories::default(),
            languages: LANGUAGES.to_vec(),
            random: 1000,
            seed: 1,
            hard_per_group: None,
            figures: true,
        }
    }
}

/// The files of a design; vectors are generated as they are written.
#[derive(Debug)]
pub struct Package {
    /// The hardware.
    pub rtl: Arc<Rtl>,
    /// The module.
    pub module: Module,
    /// Modules and tables.
    pub hardware: Vec<File>,
    /// Testbenches, makefiles and lists that accompany them.
    pub companions: Vec<File>,
    /// The vectors.
    pub vectors: Vectors,
}

impl Package {
    /// Lowers a design and prints it in each language.
    ///
    /// # Errors
    /// If the pipeline can't be built, the name isn't legal, or the module would be too large.
    pub fn new(design: &Design, settings: &Settings) -> Result<Self> {
        design.netlist.check_bound()?;
        let rtl = Arc::new(design.rtl()?);
        let header = header(design, &rtl, settings.figures)?;
        let options = Options {
            name: settings.name.clone(),
            tables: settings.tables,
            memories: settings.memories,
            header,
        };
        let module = Module::new(&rtl, &options)?;
        let most = settings.hard_per_group.unwrap_or(usize::MAX);
        let vectors = Vectors::new(design, most, settings.random, settings.seed);
        let mut hardware: Vec<File> =
            settings.languages.iter().map(|language| module.file(*language)).collect();
        hardware.extend(module.table_files());
        let companions = companions(&module, &settings.languages, vectors.count());
        Ok(Self { rtl, module, hardware, companions, vectors })
    }

    /// Writes all files into a folder. They replace an earlier package of the same name.
    ///
    /// # Errors
    /// If a file can't be written, or another run is writing them.
    pub fn write(&mut self, folder: &Path) -> Result<()> {
        let set = Set::open(folder, &self.set_name())?;
        self.write_texts(&set.path(), &set.path())?;
        self.write_vectors(&set.path())?;
        set.commit()
    }

    /// Name of the file set in an output folder.
    pub(crate) fn set_name(&self) -> String {
        format!("hdl-{}", self.module.name)
    }

    /// Writes all files but the vectors.
    ///
    /// # Errors
    /// If a file can't be written.
    pub fn write_texts(&self, hardware: &Path, companions: &Path) -> Result<()> {
        for (folder, files) in [(hardware, &self.hardware), (companions, &self.companions)] {
            output::make_folder(folder)?;
            for file in files {
                output::write_text(&folder.join(&file.name), &file.text)?;
            }
        }
        Ok(())
    }

    /// Writes the vectors.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn write_vectors(&mut self, folder: &Path) -> Result<()> {
        let path = folder.join(vectors_file(&self.module));
        output::write_file(&path, |to| self.vectors.write(to).map_err(output::at(&path)))
    }
}

/// Lines for the head of each file, which don't change from run to run.
///
/// # Errors
/// If a figure can't be measured.
fn header(design: &Design, rtl: &Rtl, figures: bool) -> Result<Vec<String>> {
    let unit = design.values.unit();
    let schedule = rtl.schedule();
    let mut lines = vec![format!("{}: {}", unit.name, unit.summary)];
    let made = match unit.source.as_str() {
        "" => format!("made by fixpath {}", env!("CARGO_PKG_VERSION")),
        source => format!("made by fixpath {}; {source}", env!("CARGO_PKG_VERSION")),
    };
    lines.extend(wrapped("", made.split(' ').map(str::to_owned)));
    let parameters = design.values.told().map(|(name, value)| format!("{name}={value}"));
    lines.extend(wrapped("  ", parameters));
    let rom = match schedule.rom() {
        _ if rtl.netlist().roms().next().is_none() => "no tables",
        Rom::Block => "tables read on the clock",
        Rom::Distributed => "tables read without a clock",
    };
    lines.push(match schedule.latency() {
        0 => format!("combinational; {rom}"),
        latency => {
            let interval = cycles(schedule.interval());
            format!("latency {}, interval {interval}; {rom}", cycles(latency))
        }
    });
    let timings = schedule.timings();
    for pair in timings.windows(2) {
        lines.push(format!(
            "a word of rate {} applies to those of rate {} that enter {} later or after, until the next is held",
            pair[0].rate,
            pair[1].rate,
            cycles(pair[0].latency)
        ));
    }
    // Bits that have no real value have no error.
    let judged = design.judged();
    if figures
        && !design.is_filled()
        && design.netlist.first_delay().is_none()
        && judged.iter().all(|id| design.netlist.node(*id).real.is_some())
    {
        lines.extend(error_figures(design)?);
    }
    Ok(lines)
}

/// Words on lines of at most [`LINE`] columns.
fn wrapped(indent: &str, words: impl Iterator<Item = String>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= LINE => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(format!("{indent}{word}")),
        }
    }
    lines
}

/// Errors over random inputs, each with the input words of the worst case, and the stated bounds.
fn error_figures(design: &Design) -> Result<Vec<String>> {
    let inputs = Inputs { sampler: Sampler::Sphere, samples: HEADER_SAMPLES, seed: 1 };
    let report = match measure::measure(&[design], &inputs, &|_| {}) {
        Ok(mut reports) => reports.pop().expect("bug: one report per design"),
        Err(why) if Error::is_failed_check(&why) => return Ok(vec![format!("errors: {why}")]),
        Err(why) => return Err(why),
    };
    let errors = if report.figures.iter().all(|f| f.over.is_none()) {
        "absolute errors"
    } else {
        "errors, absolute unless a scale is named,"
    };
    let mut lines = vec![
        format!(
            "{errors} against the golden model of the quantised inputs, over {HEADER_SAMPLES} random inputs"
        ),
        "(sampler sphere, seed 1), and the input words of the worst case:".to_owned(),
    ];
    for f in report.figures.iter().filter(|f| f.basis == Basis::Total) {
        let unit =
            if ["1", "rel"].contains(&f.unit) { String::new() } else { format!(" {}", f.unit) };
        let ulp = f.max_ulp.map(|ulp| format!(" ({ulp:.1} ulp)")).unwrap_or_default();
        let at: Vec<String> = f
            .witness
            .iter()
            .flat_map(|witness| witness.words.iter().enumerate())
            .map(|(port, word)| format!("{}={word}", design.netlist.input_name(port)))
            .collect();
        let over = f.over.as_ref().map(|what| format!(" over {what},")).unwrap_or_default();
        lines.push(format!(
            "  {}: mean {:.2e}{unit}, largest seen {:.2e}{unit}{ulp}{over} at {}",
            f.quantity,
            f.mean,
            f.max,
            at.join(" ")
        ));
    }
    let bounds = BoundCheck::new(design)?;
    lines.extend(bounds.why_none.map(|why| format!("no bound is stated: {why}")));
    lines.extend(bounds.stated.iter().map(|bound| match bound.quantity.as_str() {
        "angle" => format!("stated bound on the angle: {:.2e} rad", bound.bound),
        _ => format!("stated bound on {}: {:.2e}", bound.subject(), bound.bound),
    }));
    lines.extend(bounds.inputs.map(|inputs| format!("bounds hold for {inputs}")));
    Ok(lines)
}
