//! Indices into a netlist.

/// Index of a node in its netlist.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct NodeId(pub(super) u32);

/// Index of a table in its netlist.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct TableId(pub(super) u32);

/// Index of a scope in its netlist; scope 0 is the unit itself.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct ScopeId(pub(super) u32);

impl NodeId {
    /// Position in [`Netlist::nodes`](super::Netlist::nodes).
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}

impl TableId {
    /// The first table of a netlist.
    pub(super) const FIRST: Self = Self(0);

    /// Position in [`Netlist::tables`](super::Netlist::tables).
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}

impl ScopeId {
    /// The unit itself.
    pub const ROOT: Self = Self(0);

    /// Position in [`Netlist::scopes`](super::Netlist::scopes).
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}
