//! The result of a sweep as data: `sweep.json` and `sweep.csv`.
//!
//! `sweep.json` holds a `header` (what was swept, over which inputs) and `points` in grid order,
//! one line each. A point has its `parameters` (numbers, or names as text) and either `error`, the
//! reason why there are no figures, or `measured`. Numbers that JSON can't represent are the texts
//! `NaN`, `inf` and `-inf`.
//!
//! Over a scene, the quantities are `picture`, the difference from the golden picture in linear
//! light, and `lt_angle`, both end to end. Material parameters that come from the scene are the
//! text `scene`. `measured` also has `picture`, with the figures that only pictures have.
//!
//! `sweep.csv` has one row per point. Its columns, in this order:
//!
//! - one per swept parameter, then one per other parameter, each under the parameter's name;
//! - `datapath_multipliers`, `datapath_adders` … operators of the datapath itself, and
//!   `scheme_multipliers`, `scheme_adders` … those inside table schemes; `tables`, `reads`,
//!   `ports`, `input_bits`, `latency_cycles`, `flip_flops`, `model_period_ps`, `rom_bits` (one copy
//!   of each table) and `rom_bits_dual_port` (one copy per two read ports); if a parameter has the
//!   same name, the column is `counted_<name>`;
//! - `samples`;
//! - `<quantity>_<basis>_<figure>_<unit>`, for instance `angle_total_max_rad`: the quantity is
//!   `angle`, `dot`, `x`, `y` or `z` of a direction (prefixed with the name of the direction if a
//!   unit has several) or the name of a number; the basis is `total`, `arithmetic`, `algorithm` or
//!   `end_to_end`; the figure is `max`, `mean`, `bias`, `rms`, `p50`, `p99` or `p999`; the unit is
//!   `rad`, `texel`, `rel` for an error relative to its scale, or `abs` for the absolute error of a
//!   number without a unit. Numbers and components also have `<quantity>_<basis>_max_ulp`, which is
//!   empty if no node holds the component;
//! - `<quantity>_total_witness` of the leading quantity, which is the first: the input words of its
//!   largest total error, as `phi_a=123;theta_a=…`. Over a scene, `picture_witness` instead: the
//!   pixel and channel of the largest difference. It follows `picture_psnr_db`, `picture_ssim`,
//!   `picture_flip`, `picture_covered_px` (pixels that see an object), `picture_background_px` (the
//!   others, which no mean includes), `picture_srgb8_differing` (share of the covered pixels, 0 to
//!   1) and `picture_srgb8_max_codes`;
//! - `overflows`: how often any `narrow` overflowed;
//! - `samples_per_second`, `threads` and `engine_samples_per_second_per_thread`;
//! - `error`: why a point has no figures; empty otherwise.
//!
//! [`crate::base::columns`] describes how fields are written, [`crate::base::json`] what documents
//! have in common.

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
