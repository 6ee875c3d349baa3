//! The list of table schemes.

use super::cells::Definition;
use super::{bipartite, direct, linear};
use std::fmt;

/// Each scheme is a row here and a file.
macro_rules! schemes {
    ($($(#[$doc:meta])* $scheme:ident = $file:ident;)+) => {
        /// How a function is approximated from tables.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
        pub enum Scheme {
            $($(#[$doc])* $scheme,)+
        }

        impl Scheme {
            /// Every scheme.
            pub const ALL: &'static [Self] = &[$(Self::$scheme),+];

            pub(super) const fn definition(self) -> &'static Definition {
                match self {
                    $(Self::$scheme => &$file::DEFINITION,)+
                }
            }
        }
    };
}

schemes! {
    /// One word per cell.
    Direct = direct;
    /// Base plus slope times position in the cell: one multiplier.
    Linear = linear;
    /// Initial value plus offset: two tables, one adder.
    Bipartite = bipartite;
}

impl Scheme {
    /// Name on the command line and in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// For an index from -2^k to 2^k: the integer bits k at which a table with this many address
    /// bits has about the same error inside the range as a function that bends like atan has beyond
    /// its ends, 2^-k.
    #[must_use]
    pub fn balanced_int_bits(self, addr_bits: u32) -> u32 {
        (self.definition().balanced_int_bits)(addr_bits)
    }
}

impl fmt::Display for Scheme {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
