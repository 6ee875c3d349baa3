//! Where inputs come from.

use crate::base::cast;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A group of hard cases.
#[derive(Clone, Debug)]
pub struct HardCase {
    /// What is hard about them.
    pub name: &'static str,
    /// Input words, one vector per case.
    pub words: Vec<Vec<i64>>,
}

/// Where inputs come from.
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

    /// True if it draws, so that a number of samples and a seed mean something.
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

/// Random numbers: a stream for each seed, the same everywhere.
#[derive(Debug)]
pub struct Uniform(Pcg64Mcg);

impl Uniform {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// The next number, uniform in 0 to 1 without 1, of 53 bits.
    #[inline]
    pub fn draw(&mut self) -> f64 {
        cast::f64_of(cast::word_of_bits(self.0.next_u64() >> 11)) * 2f64.powi(-53)
    }
}
