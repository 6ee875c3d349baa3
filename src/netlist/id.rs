//! Indices into a netlist.

use std::sync::atomic::{AtomicU32, Ordering};

/// The owner of an index: one builder, or finished netlists, which all share one owner.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) struct Owner(u32);

impl Owner {
    /// The owner of all finished netlists, so that a unit built twice has the same ids.
    pub(super) const FINISHED: Self = Self(0);

    /// A new builder's owner, with a unique number.
    pub(super) fn builder() -> Self {
        static LAST: AtomicU32 = AtomicU32::new(0);
        Self(LAST.fetch_add(1, Ordering::Relaxed).wrapping_add(1))
    }
}

/// Index of a node in its netlist. During construction it also identifies its builder.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct NodeId {
    pub(super) owner: Owner,
    pub(super) number: u32,
}

/// Index of a table in its netlist. During construction it also identifies its builder.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct TableId {
    pub(super) owner: Owner,
    pub(super) number: u32,
}

/// Index of a scope in its netlist; scope 0 is the unit itself.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct ScopeId(pub(super) u32);

impl NodeId {
    pub(super) fn finished(number: u32) -> Self {
        Self { owner: Owner::FINISHED, number }
    }

    /// True for ids of a finished netlist, false for ids of a builder.
    pub(crate) fn is_finished(self) -> bool {
        self.owner == Owner::FINISHED
    }

    /// Position in [`Netlist::nodes`](super::Netlist::nodes).
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.number).expect("bug: 32 bits fit")
    }
}

impl TableId {
    /// The first table of a finished netlist.
    pub(super) const FIRST: Self = Self::finished(0);

    pub(super) const fn finished(number: u32) -> Self {
        Self { owner: Owner::FINISHED, number }
    }

    /// Position in [`Netlist::tables`](super::Netlist::tables).
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.number).expect("bug: 32 bits fit")
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
