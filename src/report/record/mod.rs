//! The result of a sweep as data: `sweep.json` and `sweep.csv`.
//!
//! `sweep.json` holds a `header` (what was swept, over which inputs) and `points` in grid order,
//! one line each: its `parameters` (numbers, or names as text), and either `error`, the reason
//! why there are no figures, or `measured`. Numbers that JSON can't write are the texts `NaN`,
//! `inf` and `-inf`.
//!
//! Over a scene the quantities are `picture`, the difference to the golden picture in linear light,
//! and `lt_angle`, both end to end; parameters of the material that come from the scene are the
//! text `scene`; and `measured` also has `picture`, which no other quantity can tell.
//!
//! `sweep.csv` has one row per point. Its columns, in this order:
//!
//! - one per swept parameter, then one per other parameter, each under the parameter's name;
//! - `datapath_multipliers`, `datapath_adders` … operators of the datapath itself, and
//!   `scheme_multipliers`, `scheme_adders` … those inside table schemes; `tables`, `reads`,
//!   `ports`, `input_bits`, `latency_cycles`, `flip_flops`, `model_period_ps`,
//!   `rom_bits` (one copy of each table) and `rom_bits_dual_port` (as many copies as two
//!   ports per copy ask for); one that a parameter has the name of is `counted_<name>`;
//! - `samples`;
//! - `<quantity>_<basis>_<figure>_<unit>`, for instance `angle_total_max_rad`: the quantity is
//!   `angle`, `dot`, `x`, `y` or `z` of a direction (after the name of the direction, where a
//!   unit has several) or the name of a number, the basis `total`, `arithmetic`, `algorithm` or
//!   `end_to_end`, the figure `max`, `mean`, `bias`, `rms`, `p50`, `p99` or `p999`, the unit
//!   `rad`, `texel`, `rel` for an error over its scale, or `abs` for the absolute one of a number
//!   without a unit; numbers and components
//!   also have `<quantity>_<basis>_max_ulp`, which is empty where no node holds the component;
//! - `<quantity>_total_witness` of the leading quantity, which is the first: the input words that
//!   gave its largest total error, as `phi_a=123;theta_a=…`;
//!   over a scene `picture_witness` in its place, the pixel and channel of the largest difference,
//!   and before it `picture_psnr_db`, `picture_ssim`, `picture_flip`, `picture_covered_px` (pixels that see
//!   an object: the others, `picture_background_px`, count in no mean), `picture_srgb8_differing` (part
//!   of the covered pixels, 0 to 1) and `picture_srgb8_max_codes`;
//! - `overflows`: how often any `narrow` overflowed;
//! - `samples_per_second`, `threads` and `engine_samples_per_second_per_thread`;
//! - `error`: why a point has no figures; empty otherwise.
//!
//! [`crate::base::columns`] tells how fields are written, [`crate::base::json`] what documents have in common.

mod csv;
mod header;
mod measured;
mod parameters;
mod rank;
mod sweep;

pub use header::{Axis, FORMAT_VERSION, Header, SceneId};
pub use measured::{Figures, Measured, Overflows, PictureFigures, Point, Real};
pub use parameters::{Parameters, assigned, json_of, parameters_of, plain};
pub use rank::{Lead, RankBy};
pub use sweep::Record;
