//! The emboss unit: displaced texture coordinates of a vertex, as in two published designs.
//!
//! - `setting=gx`, US 6,980,218 and 7,307,640: a 3×3 matrix transforms T and B of the model, L
//!   points from the vertex to the light, and `(S1, T1) = (S0, T0) + (T·L, B·L)/|L|`. This sign of
//!   L departs from the patents. Their table prints L = V - L_p, from the light to the vertex
//!   (`l_sign=vertex-light`). That displaces away from the light, so the displaced height less the
//!   undisplaced one is bright toward the light. The default here displaces toward the light, and
//!   the difference has the opposite sign. The matrix may scale, which sets the strength, so T and
//!   B are not normalised. The normal isn't used. Here T displaces s and B displaces t. In that
//!   console's own API the vector of s is the *second* of a vertex's N, B, T, and it belongs at
//!   port `tangent`.
//! - `setting=nv`, `GL_NV_texgen_emboss`: T and BN of [`super::basis`],
//!   `Es = PCTs + Ks (L·BN)/|L| PCTq, Et = PCTt - Kt (L·T)/|L| PCTq`; r and q pass through. L
//!   points to the light, and CT along growing t. BN = N × CT then points against growing s, and
//!   both displacements lead away from the light.
//!
//! The parameters `light`, `source` and `destination` name the light and the coordinates that the
//! ports stand for, for the report of `fixpath texgen`. No word depends on them.
//!
//! Each difference between the two designs is a switch: the setting gives its default, and a user
//! may override it.
//!
//! L is an exact difference of positions, which is then block-normalised: all components are
//! shifted up by the same number of places, until the largest fills its word. The shift is never
//! undone, since the result doesn't depend on it. So the direction of a light 2^-6 away keeps as
//! many bits as that of one 2^10 away. If L is 0, nothing is displaced. A vector of length 0 that
//! is to be normalised displaces nothing either. Either case sets `degenerate`.

mod bounds;
mod datapath;
mod formats;
mod golden;
mod printed;
mod switches;

use crate::design::{Param, Role, Unit};
use crate::units::basis::{component_bits, dot_frac_bits, guard_bits};
use crate::units::dot::ending_overflow;
use crate::units::normalise::norm_bits;
use crate::units::rsqrt::{root_addr_bits, root_frac_bits, root_scheme};
use datapath::design;
use formats::{MAX_CONSTANT, MAX_CONSTANT_INT_BITS};

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("emboss", "texture coordinates displaced by the direction of a light, for embossing")
        .source("US 6,980,218; US 7,307,640; GL_NV_texgen_emboss")
        .formula(
            "with v for s and w for t, k the constants (1 in gx), q = 1 without scale_q, l = L/|L|, L = light - vertex (l_sign=vertex-light: its negative):\n\
         ds = ks q (v.l), dt = kt q (w.l) (setting=nv: dt = -kt q (w.l)); s1 = s0 + ds, t1 = t0 + dt\n\
         setting=gx: v = M tangent, w = M binormal; setting=nv: v = BN, w = T of the unit basis",
        )
        .params([
            Param::choice("setting", ["gx", "nv"])
                .role(Role::Pipeline)
                .help("design that sets every switch left at auto"),
            Param::choice("frame", ["auto", "matrix", "normal", "given"])
                .help("T and B transformed by the matrix (gx), computed from N and CT (nv), or taken as given"),
            Param::choice("normalise_basis", ["auto", "off", "on"])
                .help("normalise T and B (with frame=normal: B only) (gx: off; nv: on)"),
            Param::choice("s_vector", ["auto", "tangent", "binormal"])
                .help("the vector that displaces s (gx: tangent; nv: binormal); the other one displaces t"),
            Param::choice("l_sign", ["light-vertex", "vertex-light"])
                .help("L = light - vertex, or as the patents print it (from the light to the vertex), from which the default departs; vertex-light swaps raised and sunken"),
            Param::choice("t_sign", ["auto", "plus", "minus"])
                .help("sign of the displacement of t (gx: plus; nv: minus)"),
            Param::choice("scale_q", ["auto", "off", "on"])
                .help("multiply displacements by q (gx: off; nv: on)"),
            Param::choice("constants", ["auto", "off", "parameters", "ports"])
                .help("multiply displacements by Ks and Kt (gx: off; nv: parameters)"),
            Param::real("ks", -MAX_CONSTANT..=MAX_CONSTANT)
                .default(1)
                .help("Ks, any number within its format (constants=parameters)"),
            Param::real("kt", -MAX_CONSTANT..=MAX_CONSTANT)
                .default(1)
                .help("Kt, any number within its format (constants=parameters)"),
            Param::flag("input20")
                .help("light and matrix arrive as 20-bit floats: 12 significant bits, rounded toward zero"),
            component_bits(),
            Param::bits("matrix_bits", 2..=24)
                .default(16)
                .help("bits of the matrix, signed (frame=matrix)"),
            Param::bits("matrix_int_bits", 0..=6)
                .default(2)
                .help("matrix elements are from -2^matrix_int_bits to 2^matrix_int_bits (frame=matrix)"),
            Param::bits("position_bits", 2..=30).default(28).help("bits of positions, signed"),
            Param::bits("position_frac_bits", 0..=28)
                .default(15)
                .help("fraction bits of positions"),
            guard_bits(),
            norm_bits(),
            dot_frac_bits(),
            root_scheme(),
            root_addr_bits(),
            root_frac_bits(),
            Param::bits("constant_int_bits", 0..=MAX_CONSTANT_INT_BITS)
                .auto("as many as ks and kt each need, at least 1")
                .help("Ks and Kt are from -2^constant_int_bits to 2^constant_int_bits"),
            Param::bits("constant_frac_bits", 2..=24)
                .auto("20; with more than 6 integer bits, 26 less those")
                .help("fraction bits of Ks and Kt, and of their products with q"),
            Param::bits("texture_int_bits", 0..=8)
                .default(6)
                .help("texture coordinates are from -2^texture_int_bits to 2^texture_int_bits"),
            Param::bits("texture_frac_bits", 2..=24)
                .default(18)
                .help("fraction bits of texture coordinates and displacements"),
            ending_overflow().help("overflow of s1 and t1; with overflow=saturate or symmetric, the golden is clamped to the same range"),
            Param::rounding("rounding"),
            Param::int("texture_size", 1..=65_536)
                .role(Role::MapSize)
                .default(256)
                .help("texels along the texture; only used for errors in texels"),
            Param::int("light", 0..=31)
                .role(Role::Label)
                .help("number of the light whose position is at port `light`; only reported"),
            Param::int("source", 0..=31)
                .role(Role::Label)
                .help("coordinate (gx) or texture unit (nv) of s0 and t0; only reported"),
            Param::int("destination", 0..=31)
                .role(Role::Label)
                .default(1)
                .help("coordinate (gx) or texture unit (nv) of s1 and t1; only reported"),
        ])
        .inputs("light_x … light_z, vertex_x … vertex_z: light and vertex in eye space; s0, t0: texture coordinates; \
             with frame=matrix m0_x … m2_z: rows of the model-view matrix, tangent_x … binormal_z: T and B of the model; \
             with frame=normal normal_x … ct_z: N and CT in eye space; with frame=given tangent_x … binormal_z in eye space; \
             with scale_q=on q0, r0; with constants=ports ks, kt")
        .outputs("ds, dt: displacements; s1, t1: displaced coordinates; degenerate: 1 if L (or a vector that is normalised) \
              is 0, which displaces nothing; with scale_q=on q1, r1, passed through")
        .design(design)
}
