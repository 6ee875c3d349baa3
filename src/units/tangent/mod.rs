//! The set-up of tangent-space bump mapping (US 7,843,463). From a triangle and one of its vertices
//! it computes the map from object space to texture space, and maps the view vector and the lights.
//!
//! With edges `e1 = p1 - p0`, `e2 = p2 - p0` and those of the texture `(du1, dv1)`, `(du2, dv2)`,
//! the position changes along the texture's axes by
//!
//! ```text
//! dP/du = (dv2 e1 - dv1 e2)/det    dP/dv = (du1 e2 - du2 e1)/det    det = du1 dv2 - du2 dv1
//! ```
//!
//! The tangent T is the direction of dP/du, and B = N x T with the vertex normal N. The rows of the
//! map are T, B, N: a vector in texture space is their dot products with the vector in object
//! space. With `frame=faceted` N isn't given. The second tangent is the direction of dP/dv, and N
//! is the direction of the cross product of both. Since `dP/du x dP/dv = (e1 x e2)/det`, the
//! hardware uses the exact `e1 x e2`. So slivers, whose tangents are nearly parallel, lose no
//! precision.
//!
//! Triangles are wound so that N is on the side of `e1 x e2`: counterclockwise as seen from
//! outside, `N·(e1 x e2) > 0`. With N on the other side, B points against dP/dv, and bumps along v
//! become dents.
//!
//! # What the patent prints, and what is wrong
//!
//! - **Mirrored textures.** (dP/du, dP/dv, N) is right-handed if det > 0 and left-handed if det
//!   < 0. If det < 0, N x T points along -dP/dv. The patent negates the tangent there
//!   (`mirror=printed`): then B points along dP/dv, and T along -dP/du. A map [T; N x T; N] is
//!   right-handed for any T, so no sign of T makes both right: it only moves the fault from one
//!   axis to the other. Bumps along u are then lit from the wrong side; with `mirror=off`, bumps
//!   along v are. `mirror=handed` has T = dP/du and B = sign(det) N x T: both are right.
//! - **Mirrored facets.** T x dP/dv points inward if det < 0: with `mirror=off` the facet is lit
//!   from behind. The patent's negated tangent corrects the normal, but bumps along u are wrong.
//!   `mirror=handed` takes N = sign(det) T x dP/dv: all three are right.
//! - **"Orthonormal".** The patent calls the map orthonormal. It isn't if T isn't at right angles
//!   to N, as with every vertex normal that isn't the face's: then B is shorter than 1 and light
//!   leaks from N to T. `basis=printed` is as printed: T unchanged, B = N x T without
//!   normalisation, and dP/dv unchanged for a facet. `basis=orthonormal` takes B = N x T over its
//!   length and T = B x N. That T has the direction of the part of T at right angles to N, and the
//!   length of N. For a facet, B = N x T, which is along the part of dP/dv at right angles to T.
//!
//! # Without a frame
//!
//! Differences and products are exact, so "zero" means exactly zero of the given words.
//! `degenerate` is the OR of three flags: `zero_uv` (det is 0), `zero_area` (`e1 x e2` is 0) and,
//! with vertex normals, `parallel` (`N x (dv2 e1 - dv1 e2)` is 0). In these cases nothing is
//! mirrored, and
//!
//! - a vertex has T along the x axis, or along the y axis if |N_x| > |N_y|, and B = N x T, made
//!   orthonormal as `basis` says. This frame depends on N alone. With N = 0, B is 0, and so is an
//!   orthonormal T.
//! - a facet without uv area has T along e1 (and, with `basis=printed`, e2 for dP/dv) and its own
//!   normal; a facet without area has T, B, N along x, y, z.
//!
//! Nothing special happens near zero: the bounds hold for the least det and for slivers of any
//! length, since vectors are block-normalised from exact words and N x T uses the exact T.

mod bounds;
mod datapath;
mod golden;
mod switches;
mod triangle;

use crate::design::{Param, Role, Unit};
use crate::units::basis::{component_bits, dot_frac_bits, guard_bits};
use crate::units::normalise::norm_bits;
use crate::units::rsqrt::{root_addr_bits, root_frac_bits, root_scheme};
use datapath::{MOST_INT_BITS, design};
use switches::MOST_LIGHTS;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("tangent", "tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space")
        .source("US 7,843,463, with its mirroring rule and facets as printed and corrected")
        .formula(
            "e1 = p1 - p0, e2 = p2 - p0, (du1, dv1) = uv1 - uv0, (du2, dv2) = uv2 - uv0\n\
         det = du1 dv2 - du2 dv1, dP/du = (dv2 e1 - dv1 e2)/det, dP/dv = (du1 e2 - du2 e1)/det\n\
         frame=smooth: T along dP/du, B = N x T; basis=orthonormal: B normalised, then T = B x N\n\
         frame=faceted: T, B along dP/du, dP/dv, N along T x B; basis=orthonormal: then B = N x T\n\
         then, if det < 0: mirror=handed negates B (faceted: N), printed T and B (T and N)\n\
         a vector v in texture space is (T.v, B.v, N.v)",
        )
        .params([
            Param::choice("frame", ["smooth", "faceted"])
                .role(Role::Pipeline)
                .help("a map per vertex with its normal, or one for the triangle with a second tangent"),
            Param::choice("mirror", ["handed", "printed", "off"])
                .help("in mirrored textures: negate B (of a facet N), negate T as the patent does, or neither; \
               errors are against a golden with the same rule"),
            Param::choice("basis", ["orthonormal", "printed"])
                .help("T, B, N made orthonormal, or T and N x T (of a facet dP/dv) unchanged; \
               errors are against a golden with the same rule"),
            Param::int("lights", 1..=MOST_LIGHTS.into()).role(Role::Count).help("number of lights"),
            Param::bits("position_int_bits", 0..=MOST_INT_BITS)
                .default(4)
                .help("positions are from -2^position_int_bits to 2^position_int_bits"),
            Param::bits("position_frac_bits", 0..=23)
                .default(11)
                .help("fraction bits of positions; 2 to 24 bits with sign and integer bits"),
            Param::bits("uv_int_bits", 0..=MOST_INT_BITS)
                .default(2)
                .help("texture coordinates are from -2^uv_int_bits to 2^uv_int_bits"),
            Param::bits("uv_frac_bits", 0..=23)
                .default(13)
                .help("fraction bits of texture coordinates; 2 to 24 bits with sign and integer bits"),
            component_bits(),
            guard_bits().default(2),
            Param::bits("vector_int_bits", 0..=20)
                .default(1)
                .help("view vector and lights are from -2^vector_int_bits to 2^vector_int_bits"),
            Param::bits("vector_bits", 2..=24).default(16).help("bits of the components of view vector and lights, signed"),
            Param::bits("out_frac_bits", 0..=30)
                .default(14)
                .help("fraction bits of view vector and lights in texture space"),
            norm_bits(),
            dot_frac_bits(),
            root_scheme(),
            root_addr_bits().default(8),
            root_frac_bits(),
            Param::rounding("rounding"),
        ])
        .inputs("p0_x … p2_z: positions of the triangle's vertices in object space, counterclockwise as seen from the side that N points to: \
             N·(e1 x e2) > 0, otherwise B points against dP/dv and bumps along v become dents; \
             uv0_u … uv2_v: their texture coordinates; with frame=smooth normal_x … normal_z: unit normal of the vertex, from -2 to 2; \
             view_x … view_z, light0_x … : vectors from the vertex to the eye and each of `lights` lights in object space, of any length. \
             Sampler lit: no angle below 30°, N at most 45° off the face normal; sampler sphere: any triangle")
        .outputs("t_x … t_z, b_x … b_z, n_x … n_z: rows of the map; ts_view_x …, ts_light0_x … : view vector and lights in texture space, \
              along T, B and N, not normalised; mirrored: 1 if the texture's determinant is negative (also with degenerate 1, \
              where it negates nothing); degenerate: 1 if a fixed frame is used; the reasons: zero_uv, zero_area and, with frame=smooth, parallel")
        .design(design)
}
