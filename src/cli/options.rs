//! Options shared by several commands.

use super::number;
use super::print::note_unused;
use crate::base::error::Result;
use crate::base::input;
use crate::design::{Design, Sampler, Values};
use crate::measure::samples::{AngleUnit, SampleFile};
use crate::measure::{Basis, Inputs};
use crate::report::record::RankBy;
use crate::units;
use clap::{Args, ValueEnum};
use std::io;
use std::path::Path;

#[derive(Args)]
pub(super) struct UnitArgs {
    /// Unit name (see `fixpath list`), or a netlist file written by `fixpath show UNIT --netlist`.
    pub(super) unit: String,
    /// Set a parameter. format.NODE=s20f18 sets the format of a node that rounds or of a table's
    /// words, scheme.TABLE=linear the scheme of a table; `fixpath show` lists the names.
    /// memory.NAME=FILE.csv sets the words of a memory: one CSV column for each of its columns, one
    /// line per address.
    #[arg(short = 'p', long = "param", value_name = "KEY=VALUE")]
    pub(super) params: Vec<String>,
}

impl UnitArgs {
    pub(super) fn values(&self) -> Result<Values> {
        units::named(&self.unit)?.values(&self.params)
    }

    pub(super) fn design(&self) -> Result<Design> {
        self.values()?.build()
    }
}

#[derive(Args)]
pub(super) struct InputArgs {
    /// Number of random samples; default 1e6.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(1..=u64::MAX))]
    pub(super) samples: Option<u64>,
    /// Seed of the random samples; default 1.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(0..=u64::MAX))]
    pub(super) seed: Option<u64>,
    /// Where samples come from.
    #[arg(long, value_enum, default_value = "lit")]
    pub(super) sampler: SamplerArg,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum AngleArg {
    /// 2π per turn.
    Radians,
    /// 360 per turn.
    Degrees,
    /// Turns.
    Turns,
}

impl AngleArg {
    pub(super) fn unit(self) -> AngleUnit {
        match self {
            Self::Radians => AngleUnit::Radians,
            Self::Degrees => AngleUnit::Degrees,
            Self::Turns => AngleUnit::Turns,
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum SamplerArg {
    /// Samples suited to the unit's inputs. Units that shade: vectors uniform on the sphere, with
    /// the light on the lit side of the surface. Other units draw as `fixpath list UNIT` says; if
    /// it doesn't, as do netlist files: half of the samples uniform, half log-uniform.
    Lit,
    /// The same without regard to the lit side: vectors uniform on the sphere.
    Sphere,
    /// Every combination of input words (up to 2^32).
    Exhaustive,
}

/// [`RankBy`] on the command line.
#[derive(Clone, Copy)]
pub(super) struct ErrorArg(pub(super) RankBy);

impl ValueEnum for ErrorArg {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [ErrorArg; 6] = {
            let mut all = [ErrorArg(RankBy::Max); 6];
            let mut i = 0;
            while i < all.len() {
                all[i] = ErrorArg(RankBy::ALL[i].0);
                i += 1;
            }
            all
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        let known = RankBy::ALL.iter().find(|(error, ..)| *error == self.0);
        known.map(|(_, name, help)| clap::builder::PossibleValue::new(*name).help(*help))
    }
}

/// A basis by its name in reports.
#[derive(Clone, Copy)]
pub(super) struct BasisArg(pub(super) Basis);

impl clap::ValueEnum for BasisArg {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [BasisArg; 4] = [
            BasisArg(Basis::ALL[0]),
            BasisArg(Basis::ALL[1]),
            BasisArg(Basis::ALL[2]),
            BasisArg(Basis::ALL[3]),
        ];
        &ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(clap::builder::PossibleValue::new(self.0.name()).help(self.0.meaning()))
    }
}

impl InputArgs {
    pub(super) fn inputs(&self, hard: bool) -> Inputs {
        let sampler = match self.sampler {
            SamplerArg::Lit => Sampler::Lit,
            SamplerArg::Sphere => Sampler::Sphere,
            SamplerArg::Exhaustive => Sampler::Exhaustive,
        };
        let sampler = if hard { Sampler::Hard } else { sampler };
        if !sampler.is_random() {
            let why = format!("sampler {} draws no random samples", sampler.name());
            note_unused(&[("--samples", self.samples), ("--seed", self.seed)], &why);
        }
        Inputs { sampler, samples: self.samples.unwrap_or(1_000_000), seed: self.seed.unwrap_or(1) }
    }
}

/// How to read a table of values.
#[derive(Args)]
pub(super) struct TableArgs {
    /// Unit of the angles in tables.
    #[arg(long, value_enum, default_value = "radians")]
    pub(super) angle: AngleArg,
    /// Ignore input columns that have no meaning here.
    #[arg(long)]
    pub(super) ignore_columns: bool,
}

impl TableArgs {
    pub(super) fn open<'a>(
        &self,
        path: &'a Path,
        design: &'a Design,
    ) -> Result<SampleFile<'a, Box<dyn io::Read>>> {
        let (from, path): (Box<dyn io::Read>, _) = if path == Path::new("-") {
            (Box::new(input::stdin()?), Path::new("standard input"))
        } else {
            (Box::new(input::open(path)?), path)
        };
        SampleFile::open(from, path, design, self.angle.unit(), self.ignore_columns)
    }
}
