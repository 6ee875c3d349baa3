//! `fixpath hdl`: a design as HDL files.

use super::options::UnitArgs;
use super::print::{note, note_unused};
use super::{number, shell};
use crate::base::error::Result;
use crate::design::Design;
use crate::hardware::emit::{Package, Settings};
use crate::hardware::hdl::testbench::vectors_file;
use crate::hardware::hdl::{LANGUAGES, Language, Memories, Tables};
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

#[derive(Args)]
pub(super) struct HdlArgs {
    #[command(flatten)]
    unit: UnitArgs,
    /// Folder to write. Files that an earlier run wrote there under the same name are removed;
    /// other modules stay.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Name of the module and of the files; default: the unit's.
    #[arg(long)]
    name: Option<String>,
    /// Languages to write.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "verilog,vhdl")]
    language: Vec<LanguageArg>,
    /// Where the words of tables are stored.
    #[arg(long, value_enum, default_value = "auto")]
    tables: TablesArg,
    /// Where memories are placed; their words aren't part of the datapath.
    #[arg(long, value_enum, default_value = "ports")]
    memories: MemoriesArg,
    /// Random vectors after the hard-case list.
    #[arg(long, value_name = "N", default_value_t = 10_000, allow_negative_numbers = true, value_parser = number::whole(0..=100_000_000))]
    vectors: u64,
    /// Seed of the random vectors; default 1.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(0..=u64::MAX))]
    seed: Option<u64>,
}

/// An index into [`LANGUAGES`].
#[derive(Clone, Copy, PartialEq, Eq)]
struct LanguageArg(usize);

impl LanguageArg {
    fn language(self) -> &'static dyn Language {
        LANGUAGES[self.0]
    }
}

impl ValueEnum for LanguageArg {
    fn value_variants<'a>() -> &'a [Self] {
        static ALL: LazyLock<Vec<LanguageArg>> =
            LazyLock::new(|| (0..LANGUAGES.len()).map(LanguageArg).collect());
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.language().name()).help(self.language().summary()))
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum TablesArg {
    /// Inline up to 4096 rows in total, otherwise files.
    Auto,
    /// An array initialised in the source.
    Inline,
    /// Hexadecimal files, loaded at start.
    Files,
    /// A function with one case per address. It is slow in simulators, and each read has a table of
    /// its own. From Verilog it takes up to twice the block RAM of an array, which two reads share;
    /// from VHDL through GHDL it becomes logic.
    Case,
}

impl TablesArg {
    pub(super) fn tables(self) -> Option<Tables> {
        match self {
            Self::Auto => None,
            Self::Inline => Some(Tables::Inline),
            Self::Files => Some(Tables::Files),
            Self::Case => Some(Tables::Case),
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum MemoriesArg {
    /// Outside the module, which has ports for each read address and for the words read.
    Ports,
    /// In the module: a RAM with a write port.
    Ram,
}

impl MemoriesArg {
    pub(super) fn memories(self) -> Memories {
        match self {
            Self::Ports => Memories::Ports,
            Self::Ram => Memories::Ram,
        }
    }
}

/// Fills memories without bound words with random ones, so that the design can be verified.
///
/// # Errors
/// If a memory has too many words.
pub(super) fn with_memories(mut design: Design) -> Result<Design> {
    for name in design.fill_memories()? {
        note(&format!("no words are bound to memory `{name}`: the vectors use random ones"));
    }
    Ok(design)
}

/// Writes the files; returns the text to print.
pub(super) fn run(args: &HdlArgs) -> Result<String> {
    let mut languages: Vec<LanguageArg> = Vec::new();
    for language in &args.language {
        if !languages.contains(language) {
            languages.push(*language);
        }
    }
    if args.vectors == 0 {
        note_unused(&[("--seed", args.seed)], "no vectors are drawn");
    }
    let settings = Settings {
        name: args.name.clone(),
        tables: args.tables.tables(),
        memories: args.memories.memories(),
        languages: languages.into_iter().map(LanguageArg::language).collect(),
        random: args.vectors,
        seed: args.seed.unwrap_or(1),
        ..Settings::default()
    };
    let mut package = Package::new(&with_memories(args.unit.design()?)?, &settings)?;
    let count = package.vectors.count();
    package.write(&args.out)?;
    Ok(told(&package, count, &args.out))
}

fn told(package: &Package, vectors: u64, out: &Path) -> String {
    let module = &package.module;
    let mut text = format!("written to {}\n", out.display());
    for file in package.hardware.iter().chain(&package.companions) {
        let _ = writeln!(text, "  {}", file.name);
    }
    let _ = writeln!(text, "  {}: {vectors} vectors", vectors_file(module));
    for (was, is) in &module.renamed {
        let _ = writeln!(
            text,
            "renamed, since a language or another word uses the name: {was} to {is}"
        );
    }
    let makefile = package.companions.iter().find(|file| file.name.ends_with(".mk"));
    if let Some(makefile) = makefile {
        let out = shell::word(out);
        let _ = writeln!(text, "run its testbench with: make -C {out} -f {}", makefile.name);
    }
    text
}
