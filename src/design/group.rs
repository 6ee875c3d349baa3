//! Nodes with one meaning, which the golden model has too.

use crate::netlist::{Netlist, NodeId};
use std::f64::consts::TAU;

/// What some nodes are together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// A direction in three components; the golden gives x, y, z.
    Cartesian,
    /// A direction as azimuth and polar angle in turns; the golden gives x, y, z.
    Polar,
    /// A number; the golden gives it.
    Scalar,
    /// A number whose error counts beside scales of its own: absolute and, as `NAME_SCALE`, over
    /// each of them. The golden gives it, and its scales in
    /// columns of their own after those of all groups.
    Scaled {
        /// The scales.
        scales: &'static [Scale],
        /// Texels of a texture whose coordinate it moves: the error is also told in them.
        texels: Option<u32>,
    },
}

/// What an error is told over.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Scale {
    /// Name after the quantity's.
    pub name: &'static str,
    /// What it is, in words: errors are told over that.
    pub what: &'static str,
}

impl Shape {
    /// Its scales.
    #[must_use]
    pub fn scales(self) -> &'static [Scale] {
        match self {
            Self::Scaled { scales, .. } => scales,
            Self::Cartesian | Self::Polar | Self::Scalar => &[],
        }
    }

    /// How many nodes it takes.
    #[must_use]
    pub fn nodes(self) -> usize {
        match self {
            Self::Cartesian => 3,
            Self::Polar => 2,
            Self::Scalar | Self::Scaled { .. } => 1,
        }
    }

    /// True if it is a direction.
    #[must_use]
    pub fn is_direction(self) -> bool {
        matches!(self, Self::Cartesian | Self::Polar)
    }

    /// Names of the golden's columns.
    #[must_use]
    pub fn columns(self) -> &'static [&'static str] {
        match self {
            Self::Cartesian | Self::Polar => &["x", "y", "z"],
            Self::Scalar | Self::Scaled { .. } => &[""],
        }
    }

    /// Values that golden columns mean for the nodes; angles in turns, 0 to 1.
    #[must_use]
    pub fn of_golden(self, golden: &[f64]) -> Vec<f64> {
        match (self, golden) {
            (Self::Polar, [x, y, z]) => {
                let phi = (libm::atan2(*y, *x) / TAU).rem_euclid(1.0) + 0.0; // -0 becomes 0
                vec![phi, libm::atan2(libm::hypot(*x, *y), *z) / TAU]
            }
            (Self::Cartesian | Self::Scalar | Self::Scaled { .. } | Self::Polar, _) => {
                golden.to_vec()
            }
        }
    }
}

/// Nodes with one meaning, which the golden model has too.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Group {
    /// Name in front of its quantities; nothing for the only one.
    pub name: &'static str,
    /// What the nodes are together.
    pub shape: Shape,
    /// The nodes.
    pub nodes: Vec<NodeId>,
}

impl Group {
    /// Names of the golden's columns.
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        self.shape.columns().iter().map(|column| prefixed(self.name, column)).collect()
    }

    /// One number for each output port of a netlist, named as the port.
    ///
    /// # Panics
    /// If a name is no output port.
    #[must_use]
    pub fn ports(netlist: &Netlist, names: &[&'static str]) -> Vec<Self> {
        let group = |name: &&'static str| {
            let output = netlist.outputs().iter().find(|output| output.name == *name);
            let node = output.expect("bug: a port of this name").node;
            Self { name, shape: Shape::Scalar, nodes: vec![node] }
        };
        names.iter().map(group).collect()
    }
}

impl Group {
    /// Nodes inside, by their labels.
    ///
    /// # Panics
    /// If there is no node of a label, or not as many as the shape takes: that is wrong code.
    pub(crate) fn inside(
        netlist: &Netlist,
        name: &'static str,
        shape: Shape,
        labels: &[&str],
    ) -> Self {
        let find = |label: &&str| netlist.ids().find(|id| netlist.label(*id) == **label);
        let found = labels.iter().map(|label| find(label).expect("bug: a node of this label"));
        let nodes: Vec<NodeId> = found.collect();
        assert_eq!(nodes.len(), shape.nodes(), "bug: nodes of `{name}`");
        Self { name, shape, nodes }
    }
}

/// `group_part`, or the one that isn't empty.
pub(super) fn prefixed(group: &str, part: &str) -> String {
    match (group, part) {
        ("", name) | (name, "") => name.to_owned(),
        (group, part) => format!("{group}_{part}"),
    }
}
