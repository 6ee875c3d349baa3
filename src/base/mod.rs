//! The base of all other layers: casts, errors, files, documents, vector code, outside tools.

pub(crate) mod cast;
pub mod columns;
#[cfg(feature = "pictures")]
pub(crate) mod document;
pub mod error;
pub mod escape;
pub(crate) mod input;
pub mod json;
pub(crate) mod name;
pub mod output;
pub mod outside;
pub(crate) mod simd;
pub(crate) mod whole;
