//! The switches of the unit.

use crate::base::cast;
use crate::design::Values;

/// What mirrored textures turn.
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

    /// Which rows of the map change their sign where the texture is mirrored, if they come of the
    /// tangent `dv2 e1 - dv1 e2`, which has that of det in it already, of `N x` that or of
    /// `du1 e2 - du2 e1`, and of `e1 x e2`.
    pub(super) fn turned(self) -> [bool; 3] {
        let t = self.mirror != Mirror::Printed;
        match (self.faceted, self.orthonormal) {
            (false, _) => [t, self.mirror == Mirror::Off, false],
            // N x T is dP/dv already, in the sign of the exact e1 x e2.
            (true, true) => [t, false, self.mirror == Mirror::Off],
            (true, false) => [t, true, self.mirror == Mirror::Off],
        }
    }
}

pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// The most lights.
pub(super) const MOST_LIGHTS: u8 = 8;

/// Names of the vectors that are mapped: the view vector, then each light.
pub(super) fn mapped(lights: usize) -> impl Iterator<Item = String> {
    std::iter::once("view".to_owned()).chain((0..lights).map(|light| format!("light{light}")))
}
