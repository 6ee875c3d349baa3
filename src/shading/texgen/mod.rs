//! Texture coordinate generation as two graphics interfaces define it: API calls in, a
//! configuration of the emboss unit out.
//!
//! [`gx`] implements the rules of `GXSetTexCoordGen` (US 6,980,218 and 7,307,640), [`nv`] those of
//! `GL_NV_texgen_emboss`. [`Calls`] is a list of calls from a TOML file:
//!
//! ```
//! use fixpath::texgen::Calls;
//! let calls = Calls::parse(
//!     r#"
//!     [[gx]]
//!     call = "SetTexCoordGen"
//!     dst_coord = "TEXCOORD0"
//!     func = "MTX2x4"
//!     src_param = "TEX0"
//!     mat_idx = "TEXMTX3"
//!
//!     [[gx]]
//!     call = "SetTexCoordGen"
//!     dst_coord = "TEXCOORD1"
//!     func = "BUMP0"
//!     src_param = "TEXCOORD0"
//!     mat_idx = "IDENTITY"
//!     "#,
//!     "calls.toml".as_ref(),
//! )?;
//! let outcome = calls.run();
//! assert_eq!(outcome.problems(), 0);
//! assert_eq!(outcome.emboss[0].to_string(), "setting=gx light=0 source=0 destination=1 ks=1 kt=1");
//! # Ok::<(), fixpath::error::Error>(())
//! ```

mod calls;
pub mod gx;
pub mod nv;
mod opengl;
mod setting;

pub use calls::{Calls, Event, Outcome, Refusal};
pub use setting::{Emboss, Setting};
