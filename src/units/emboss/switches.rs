//! The switches of the unit, resolved by its setting.

use crate::design::Values;

/// Where T and B come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Frame {
    Matrix,
    Normal,
    Given,
}

/// Where Ks and Kt come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Constants {
    Off,
    Parameters,
    Ports,
}

/// The switches; those that are `auto` have the value of the setting.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switches {
    pub(super) frame: Frame,
    pub(super) normalise: bool,
    pub(super) s_is_binormal: bool,
    pub(super) vertex_light: bool,
    pub(super) minus_t: bool,
    pub(super) q: bool,
    pub(super) constants: Constants,
}

impl Switches {
    pub(super) fn new(values: &Values) -> Self {
        let nv = values.choice("setting") == "nv";
        let of = |name, gx, of_nv| match values.choice(name) {
            "auto" if nv => of_nv,
            "auto" => gx,
            given => given,
        };
        Self {
            frame: match of("frame", "matrix", "normal") {
                "matrix" => Frame::Matrix,
                "normal" => Frame::Normal,
                _ => Frame::Given,
            },
            normalise: of("normalise_basis", "off", "on") == "on",
            s_is_binormal: of("s_vector", "tangent", "binormal") == "binormal",
            vertex_light: values.choice("l_sign") == "vertex-light",
            minus_t: of("t_sign", "plus", "minus") == "minus",
            q: of("scale_q", "off", "on") == "on",
            constants: match of("constants", "off", "parameters") {
                "off" => Constants::Off,
                "parameters" => Constants::Parameters,
                _ => Constants::Ports,
            },
        }
    }

    /// True if the datapath is that of US 6,980,218, which prints a schedule for it.
    pub(super) fn is_printed(self) -> bool {
        let as_printed = self.frame == Frame::Matrix && !self.normalise && !self.s_is_binormal;
        as_printed && !self.minus_t && !self.has_factor()
    }

    /// True if displacements have a factor.
    pub(super) fn has_factor(self) -> bool {
        self.q || self.constants != Constants::Off
    }

    /// Names of the input ports in order; a vector's ports are given by their common prefix.
    pub(super) fn ports(self) -> Vec<&'static str> {
        let mut names = match self.frame {
            Frame::Matrix => vec!["m0", "m1", "m2", "tangent", "binormal"],
            Frame::Normal => vec!["normal", "ct"],
            Frame::Given => vec!["tangent", "binormal"],
        };
        names.extend(["light", "vertex", "s0", "t0"]);
        if self.q {
            names.extend(["q0", "r0"]);
        }
        if self.constants == Constants::Ports {
            names.extend(["ks", "kt"]);
        }
        names
    }
}

/// True if the port of this name is a vector.
pub(super) fn is_vector(name: &str) -> bool {
    !["s0", "t0", "q0", "r0", "ks", "kt"].contains(&name)
}
