//! Groups of nodes that the golden model computes, too.

use crate::base::error::{Error, Result};
use crate::netlist::{Netlist, NodeId};
use std::f64::consts::TAU;

/// What the nodes of a group represent.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Shape {
    /// A direction in three components; the golden gives x, y, z.
    Cartesian,
    /// A direction as azimuth and polar angle in turns; the golden gives x, y, z.
    Polar,
    /// A number; the golden gives it.
    Scalar,
    /// An angle in turns, whose errors are modulo a turn; the golden gives it.
    Turns,
    /// A number with one or more scales: its error is reported absolutely and, as `NAME_SCALE`,
    /// relative to each scale. The golden computes it, and its scales in separate columns after
    /// those of all groups.
    Scaled {
        /// The scales.
        scales: Vec<Scale>,
        /// Size in texels of a texture whose coordinate the number shifts: the error is also
        /// reported in texels.
        texels: Option<u32>,
    },
}

/// A scale that errors are divided by.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Scale {
    /// Suffix after the quantity's name.
    pub name: String,
    /// Description of the scale, in words.
    pub what: String,
}

impl Scale {
    /// A scale.
    #[must_use]
    pub fn new(name: impl Into<String>, what: impl Into<String>) -> Self {
        Self { name: name.into(), what: what.into() }
    }
}

impl Shape {
    /// Its scales.
    #[must_use]
    pub fn scales(&self) -> &[Scale] {
        match self {
            Self::Scaled { scales, .. } => scales,
            Self::Cartesian | Self::Polar | Self::Scalar | Self::Turns => &[],
        }
    }

    /// Number of nodes in the group.
    #[must_use]
    pub fn nodes(&self) -> usize {
        match self {
            Self::Cartesian => 3,
            Self::Polar => 2,
            Self::Scalar | Self::Turns | Self::Scaled { .. } => 1,
        }
    }

    /// True for a direction.
    #[must_use]
    pub fn is_direction(&self) -> bool {
        matches!(self, Self::Cartesian | Self::Polar)
    }

    /// Names of the golden's columns.
    #[must_use]
    pub fn columns(&self) -> &'static [&'static str] {
        match self {
            Self::Cartesian | Self::Polar => &["x", "y", "z"],
            Self::Scalar | Self::Turns | Self::Scaled { .. } => &[""],
        }
    }

    /// Converts golden columns to values of the nodes; angles in turns, 0 to 1.
    #[must_use]
    pub fn of_golden(&self, golden: &[f64]) -> Vec<f64> {
        match (self, golden) {
            (Self::Polar, [x, y, z]) => {
                let phi = (libm::atan2(*y, *x) / TAU).rem_euclid(1.0) + 0.0; // -0 becomes 0
                vec![phi, libm::atan2(libm::hypot(*x, *y), *z) / TAU]
            }
            (
                Self::Cartesian | Self::Scalar | Self::Turns | Self::Scaled { .. } | Self::Polar,
                _,
            ) => golden.to_vec(),
        }
    }
}

/// Nodes that together represent a quantity of the golden model.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Group {
    /// Prefix of its quantities; empty for the only group.
    pub name: String,
    /// What the nodes represent.
    pub shape: Shape,
    /// The nodes.
    pub nodes: Vec<NodeId>,
}

impl Group {
    /// A group.
    #[must_use]
    pub fn new(name: impl Into<String>, shape: Shape, nodes: Vec<NodeId>) -> Self {
        Self { name: name.into(), shape, nodes }
    }

    /// Names of the golden's columns.
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        self.shape.columns().iter().map(|column| prefixed(&self.name, column)).collect()
    }

    /// Names of the quantities whose errors are measured, in the order of reports.
    #[must_use]
    pub fn quantities(&self) -> Vec<String> {
        let mut parts: Vec<&str> = Vec::new();
        if self.shape.is_direction() {
            parts.extend(["angle", "dot"]);
        }
        if let Shape::Scaled { scales, texels } = &self.shape {
            parts.extend(texels.map(|_| "texels"));
            parts.extend(scales.iter().map(|scale| scale.name.as_str()));
        }
        let parts = parts.into_iter().map(|part| prefixed(&self.name, part));
        parts.chain(self.columns()).collect()
    }

    /// One scalar group per named output port of a netlist, with the port's name.
    ///
    /// # Errors
    /// If a name is not an output port.
    pub fn ports<N: AsRef<str>>(
        netlist: &Netlist,
        names: impl IntoIterator<Item = N>,
    ) -> Result<Vec<Self>> {
        let group = |name: N| {
            let name = name.as_ref();
            let port = netlist.outputs().iter().find(|output| output.name == name);
            let port = port.ok_or_else(|| none(netlist, "output", name))?;
            Ok(Self::new(name, Shape::Scalar, vec![port.node]))
        };
        names.into_iter().map(group).collect()
    }

    /// A group of nodes inside the netlist, given by their labels.
    ///
    /// # Errors
    /// If no node has one of the labels.
    pub fn inside<N: AsRef<str>>(
        netlist: &Netlist,
        name: impl Into<String>,
        shape: Shape,
        labels: impl IntoIterator<Item = N>,
    ) -> Result<Self> {
        let find = |label: N| {
            let found = netlist.ids().find(|id| netlist.label(*id) == label.as_ref());
            found.ok_or_else(|| none(netlist, "node", label.as_ref()))
        };
        Ok(Self::new(name, shape, labels.into_iter().map(find).collect::<Result<_>>()?))
    }
}

fn none(netlist: &Netlist, what: &str, name: &str) -> Error {
    Error::usage(format!(
        "a group of `{}` names the {what} `{name}`, which doesn't exist",
        netlist.name()
    ))
}

/// `group_part`; if one is empty, the other alone.
pub(super) fn prefixed(group: &str, part: &str) -> String {
    match (group, part) {
        ("", name) | (name, "") => name.to_owned(),
        (group, part) => format!("{group}_{part}"),
    }
}
