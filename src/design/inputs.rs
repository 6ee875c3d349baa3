//! Sources of inputs.

use crate::base::cast;
use crate::netlist::Netlist;
use crate::number::format::Format;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A group of hard cases.
#[derive(Clone, Debug)]
pub struct HardCase {
    /// What makes these cases hard.
    pub name: String,
    /// Input words, one vector per case.
    pub words: Vec<Vec<i64>>,
}

impl HardCase {
    /// A group of cases.
    #[must_use]
    pub fn new(name: impl Into<String>, words: Vec<Vec<i64>>) -> Self {
        Self { name: name.into(), words }
    }

    /// Words at and next to the ends of the formats: in all ports, in one port at a time, and
    /// alternating.
    #[must_use]
    pub fn extremes(netlist: &Netlist) -> Vec<Self> {
        let formats: Vec<Format> =
            netlist.inputs().iter().map(|id| netlist.node(*id).format).collect();
        let each = |word: &dyn Fn(usize, Format) -> i64| -> Vec<i64> {
            let fit = |(port, format): (usize, &Format)| {
                word(port, *format).clamp(format.min_raw(), format.max_raw())
            };
            formats.iter().enumerate().map(fit).collect()
        };
        let alone = |word: &dyn Fn(Format) -> i64| -> Vec<Vec<i64>> {
            (0..formats.len())
                .map(|at| each(&|port, f| if port == at { word(f) } else { 0 }))
                .collect()
        };
        vec![
            Self::new("all words 0", vec![each(&|_, _| 0)]),
            Self::new("one word, of one LSB", [alone(&|_| 1), alone(&|_| -1)].concat()),
            Self::new("the most negative words", vec![each(&|_, f| f.min_raw())]),
            Self::new("the largest words, and alternating ends", {
                let turn = |of: usize| {
                    each(&move |port, f| if port % of == 0 { f.min_raw() } else { f.max_raw() })
                };
                vec![each(&|_, f| f.max_raw()), turn(2), turn(3), turn(4), turn(6)]
            }),
            Self::new("one word alone at an end", {
                [alone(&|f: Format| f.min_raw()), alone(&|f: Format| f.max_raw())].concat()
            }),
            Self::new("one huge word beside words of one LSB", {
                let huge =
                    |at: usize| each(&|port, f| if port % 3 == at { f.max_raw() } else { 1 });
                let least =
                    |at: usize| each(&|port, f| if port % 3 == at { f.min_raw() } else { -1 });
                (0..3).flat_map(|at| [huge(at), least(at)]).collect()
            }),
        ]
    }
}

/// Source of inputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sampler {
    /// Vectors uniform on the sphere, with the light on the lit side of the surface.
    Lit,
    /// Vectors uniform on the sphere.
    Sphere,
    /// Every combination of input words.
    Exhaustive,
    /// The hard-case list.
    Hard,
}

impl Sampler {
    /// Names on the command line.
    pub const ALL: &'static [(Self, &'static str)] = &[
        (Self::Lit, "lit"),
        (Self::Sphere, "sphere"),
        (Self::Exhaustive, "exhaustive"),
        (Self::Hard, "hard"),
    ];

    /// True for random samplers, which use a number of samples and a seed.
    #[must_use]
    pub fn is_random(self) -> bool {
        match self {
            Self::Lit | Self::Sphere => true,
            Self::Exhaustive | Self::Hard => false,
        }
    }

    /// Name on the command line.
    ///
    /// # Panics
    /// Never: every sampler is listed.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(known, _)| *known == self).expect("bug: every sampler is listed").1
    }
}

/// Random numbers: one stream per seed, the same on all machines.
#[derive(Debug)]
pub struct Uniform(Pcg64Mcg);

impl Uniform {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// The next number with 53 bits, uniform from 0 to below 1.
    #[inline]
    pub fn draw(&mut self) -> f64 {
        cast::f64_of(cast::word_of_bits(self.0.next_u64() >> 11)) * 2f64.powi(-53)
    }
}
