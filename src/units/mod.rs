//! Units: parameterised datapaths with their golden models.
//!
//! A unit is one file and one row of [`UNITS`]. It has parameters with legal ranges, a netlist, a
//! golden model (the same function in plain floating point, written from the mathematics and not
//! from the netlist), an input sampler, hard cases and a stated error bound. The command line, the
//! sweep and the reports see units only through [`all`]: this table, and the units that another
//! crate passed to [`crate::main`].
//!
//! [`Design`] and the other types that a unit is built from are re-exported here.

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
    Bound, BoundFn, Bounds, Design, Draw, Golden, Group, HardCase, InputPorts, Kind, PIPELINE,
    Param, Recipe, Reflection, Role, Sampler, Scale, Shading, Shape, Uniform, Unit, Value, Values,
};
pub use crate::number::function::Number;
pub use crate::table::Tabulated;
pub use parts::fragment;

use crate::base::error::{Error, Result};
use crate::base::input;
use crate::netlist::Netlist;
use std::path::Path;
use std::sync::{LazyLock, OnceLock};

/// The units of this crate.
pub static UNITS: LazyLock<Vec<Unit>> = LazyLock::new(|| {
    vec![
        rotation::unit(),
        illumination::unit(),
        bump::unit(),
        peercy::unit(),
        ernst::unit(),
        kim::unit(),
        kugler::unit(),
        dot::unit(),
        normalise::unit(),
        rsqrt::unit(),
        cross::unit(),
        basis::unit(),
        emboss::unit(),
        sampler::unit(),
        combine::unit(),
        tangent::unit(),
    ]
});

/// Units of other crates, as passed to [`crate::main`].
static OTHERS: OnceLock<Vec<Unit>> = OnceLock::new();

/// Every unit that the commands know.
pub fn all() -> impl Iterator<Item = &'static Unit> + Clone {
    UNITS.iter().chain(OTHERS.get().into_iter().flatten())
}

/// The unit of this crate with this name.
pub(crate) fn built_in(name: &str) -> &'static Unit {
    UNITS.iter().find(|unit| unit.name == name).expect("bug: a unit of this crate")
}

/// Adds units to those of [`UNITS`]. Call it once, before any unit is looked up.
pub(crate) fn add(units: &[Unit]) -> Result<()> {
    for (at, unit) in units.iter().enumerate() {
        unit.check()?;
        let same = |known: &Unit| known.name == unit.name;
        let whose = match (UNITS.iter().any(same), units[..at].iter().any(same)) {
            (true, _) => "this name is taken by a unit of fixpath",
            (false, true) => "two units have this name",
            (false, false) => continue,
        };
        let text = format!("unit `{}`: {whose}; give it another", unit.name);
        return Err(Error::usage(text));
    }
    let known = || Error::usage("the units of the command line are set once".to_owned());
    OTHERS.set(units.to_vec()).map_err(|_| known())
}

/// The unit with this name, or the netlist in this file. Unit names contain neither a dot nor a
/// slash.
pub(crate) fn named(name: &str) -> Result<Unit> {
    if !name.contains(['.', '/', '\\']) {
        return Unit::find(name).cloned();
    }
    let path = Path::new(name);
    let text = input::text(path, MAX_FILE_BYTES)?;
    Ok(Unit::of_netlist(Netlist::parse(&text, path)?))
}

/// Largest size of a netlist file.
const MAX_FILE_BYTES: u64 = 1 << 28;

impl Unit {
    /// The unit with this name, among all that the commands know.
    ///
    /// # Errors
    /// If there is none; the message suggests the nearest name.
    pub fn find(name: &str) -> Result<&'static Self> {
        all()
            .find(|unit| unit.name == name)
            .ok_or_else(|| Error::unknown_unit(name, all().map(|unit| unit.name.as_str())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_are_taken_are_refused() {
        let own =
            |name: &str| Unit::new(name, "").design(|_| Err(Error::usage("only its name counts")));
        let refused = |units: &[Unit]| add(units).unwrap_err().to_string();
        assert_eq!(
            refused(&[own("mine"), dot::unit()]),
            "unit `dot`: this name is taken by a unit of fixpath; give it another"
        );
        assert_eq!(
            refused(&[own("mine"), own("mine")]),
            "unit `mine`: two units have this name; give it another"
        );
        assert!(refused(&[own("Mine")]).starts_with("unit `Mine`: a name is a letter a to z"));
        assert!(Unit::find("mine").is_err());
    }
}
