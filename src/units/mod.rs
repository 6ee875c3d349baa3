//! Units: parameterised datapaths with their golden models.
//!
//! A unit is one file and one row of [`UNITS`]: its parameters with their legal
//! ranges, its netlist, its golden function in plain floating point (written
//! from the mathematics and not from the netlist), its input sampler, its hard
//! cases and its stated error bound. The command line, the suite, the sweep and
//! the reports know units only through this table.
//!
//! What they are made of, [`Design`] and its like, has its public names here too.

pub mod basis;
pub mod bump;
pub mod combine;
pub mod cross;
pub mod dot;
pub mod emboss;
pub mod ernst;
pub mod illumination;
pub mod kim;
pub mod kugler;
pub mod normalise;
mod parts;
pub mod peercy;
pub mod rotation;
pub mod rsqrt;
pub mod sampler;
pub mod tangent;
mod vertex;

pub use crate::design::{
    Bound, BoundFn, Bounds, Design, Draw, Golden, Group, HardCase, Kind, PIPELINE, Param,
    Reflection, Role, Sampler, Scale, Shading, Shape, Uniform, Unit, Value, Values,
};
pub use crate::number::function::Number;
pub use crate::table::Tabulated;
pub use parts::fragment;

use crate::base::error::{Error, Result};

/// Every unit.
pub static UNITS: &[&Unit] = &[
    &rotation::ROTATION,
    &illumination::ILLUMINATION,
    &bump::BUMP,
    &peercy::PEERCY,
    &ernst::ERNST,
    &kim::KIM,
    &kugler::KUGLER,
    &dot::DOT,
    &normalise::NORMALISE,
    &rsqrt::RSQRT,
    &cross::CROSS,
    &basis::BASIS,
    &emboss::EMBOSS,
    &sampler::SAMPLER,
    &combine::COMBINE,
    &tangent::TANGENT,
];

impl Unit {
    /// The unit of this name.
    ///
    /// # Errors
    /// If there is none; the message names the nearest.
    pub fn find(name: &str) -> Result<&'static Self> {
        UNITS
            .iter()
            .find(|unit| unit.name == name)
            .copied()
            .ok_or_else(|| Error::unknown_unit(name, UNITS.iter().map(|unit| unit.name)))
    }
}
