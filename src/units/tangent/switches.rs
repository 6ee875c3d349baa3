//! The switches of the unit.

use crate::base::cast;
use crate::design::Values;

/// The vector that changes its sign with mirrored textures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Mirror {
    Handed,
    Printed,
    Off,
}

/// The switches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switches {
    pub(super) faceted: bool,
    pub(super) mirror: Mirror,
    pub(super) orthonormal: bool,
    pub(super) lights: usize,
}

impl Switches {
    pub(super) fn new(values: &Values) -> Self {
        Self {
            faceted: values.choice("frame") == "faceted",
            mirror: match values.choice("mirror") {
                "handed" => Mirror::Handed,
                "printed" => Mirror::Printed,
                _ => Mirror::Off,
            },
            orthonormal: values.choice("basis") == "orthonormal",
            lights: cast::index_of(i64::from(values.bits("lights"))),
        }
    }

    /// Which rows of the map change their sign where the texture is mirrored. T comes from
    /// `dv2 e1 - dv1 e2`, which already has the sign of det. B comes from `N x` that or from
    /// `du1 e2 - du2 e1`, and N from `e1 x e2`.
    pub(super) fn turned(self) -> [bool; 3] {
        let t = self.mirror != Mirror::Printed;
        match (self.faceted, self.orthonormal) {
            (false, _) => [t, self.mirror == Mirror::Off, false],
            // N x T is dP/dv already, with the sign of the exact e1 x e2.
            (true, true) => [t, false, self.mirror == Mirror::Off],
            (true, false) => [t, true, self.mirror == Mirror::Off],
        }
    }
}

pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// Maximum number of lights.
pub(super) const MOST_LIGHTS: u8 = 8;

/// Names of the mapped vectors: the view vector, then each light.
pub(super) fn mapped(lights: usize) -> impl Iterator<Item = String> {
    std::iter::once("view".to_owned()).chain((0..lights).map(|light| format!("light{light}")))
}
