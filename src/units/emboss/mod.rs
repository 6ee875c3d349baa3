//! The emboss unit: displaced texture coordinates of a vertex, as two published designs have them.
//!
//! - `setting=gx`, US 6,980,218 and 7,307,640: T and B of the model by a 3×3
//!   matrix, L from the vertex to the light, `(S1, T1) = (S0, T0) + (T·L, B·L)/|L|`. This sign of L departs from the
//!   patents: their table prints L = V - L_p, from the light to the vertex (`l_sign=vertex-light`), which displaces
//!   away from the light, so that the displaced height less the undisplaced one is bright toward the light. Here the
//!   default displaces toward it, and the difference is the other way round. The matrix may
//!   scale, which sets the strength, so T and B are not normalised. The normal isn't used. Here s goes
//!   with T and t with B; in that console's own API the vector of s is the *second* of a vertex's
//!   N, B, T, so that one is what port `tangent` takes.
//! - `setting=nv`, `GL_NV_texgen_emboss`: T and BN of [`super::basis`],
//!   `Es = PCTs + Ks (L·BN)/|L| PCTq, Et = PCTt - Kt (L·T)/|L| PCTq`; r and q pass. L points to the light, and CT
//!   along growing t; then BN = N × CT points against growing s, and both displacements lead away from the light.
//!
//! Parameters `light`, `source` and `destination` say which light and which coordinates the ports stand for, as
//! `fixpath texgen` tells a configuration; no word depends on them.
//!
//! Every difference between them is a switch that a setting sets and a user may set otherwise.
//!
//! L is a difference of positions, exact, and then block-normalised: its largest component is shifted
//! up to the top of its word, the others with it, and the shift is never undone, as the result
//! doesn't depend on it. So the direction of a light 2^-6 away keeps as many bits as one 2^10 away.
//! Where L is 0, nothing is displaced; a vector of length 0 that is normalised displaces nothing. Either sets
//! `degenerate`.

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
                .help("what every switch that is auto stands at"),
            Param::choice("frame", ["auto", "matrix", "normal", "given"])
                .help("T and B by the matrix (gx), from N and CT (nv), or as they are"),
            Param::choice("normalise_basis", ["auto", "off", "on"])
                .help("T and B (of N x CT: B) over their lengths (gx: off; nv: on)"),
            Param::choice("s_vector", ["auto", "tangent", "binormal"])
                .help("the vector that displaces s (gx: tangent; nv: binormal); the other one displaces t"),
            Param::choice("l_sign", ["light-vertex", "vertex-light"])
                .help("L = light - vertex, or as the patents print it (from the light to the vertex), from which the default departs; turns what looks raised"),
            Param::choice("t_sign", ["auto", "plus", "minus"])
                .help("sign of the displacement of t (gx: plus; nv: minus)"),
            Param::choice("scale_q", ["auto", "off", "on"])
                .help("displacements times q (gx: off; nv: on)"),
            Param::choice("constants", ["auto", "off", "parameters", "ports"])
                .help("displacements times Ks and Kt (gx: off; nv: parameters)"),
            Param::real("ks", -MAX_CONSTANT..=MAX_CONSTANT)
                .default(1)
                .help("Ks, any number that its format holds (constants=parameters)"),
            Param::real("kt", -MAX_CONSTANT..=MAX_CONSTANT)
                .default(1)
                .help("Kt, any number that its format holds (constants=parameters)"),
            Param::flag("input20")
                .help("light and matrix come as floats of 20 bits: 12 significant bits, toward zero"),
            component_bits(),
            Param::bits("matrix_bits", 2..=24)
                .default(16)
                .help("bits of the matrix, signed (frame=matrix)"),
            Param::bits("matrix_int_bits", 0..=6)
                .default(2)
                .help("it is from -2^matrix_int_bits to 2^matrix_int_bits (frame=matrix)"),
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
                .auto("as many as ks and kt ask for, each of them, 1 at least")
                .help("Ks and Kt are from -2^constant_int_bits to 2^constant_int_bits"),
            Param::bits("constant_frac_bits", 2..=24)
                .auto("20, and fewer with more than 6 whole bits, 26 of both")
                .help("fraction bits of Ks and Kt, and of their products with q"),
            Param::bits("texture_int_bits", 0..=8)
                .default(6)
                .help("texture coordinates are from -2^texture_int_bits to 2^texture_int_bits"),
            Param::bits("texture_frac_bits", 2..=24)
                .default(18)
                .help("fraction bits of texture coordinates and displacements"),
            ending_overflow().help("overflow of s1 and t1; with the first two the golden ends where they do"),
            Param::rounding("rounding"),
            Param::int("texture_size", 1..=65_536)
                .role(Role::MapSize)
                .default(256)
                .help("texels along the texture: only for errors in texels"),
            Param::int("light", 0..=31)
                .role(Role::Label)
                .help("the light that port `light` is the place of: only told"),
            Param::int("source", 0..=31)
                .role(Role::Label)
                .help("the coordinate (gx) or texture unit (nv) that s0 and t0 are of: only told"),
            Param::int("destination", 0..=31)
                .role(Role::Label)
                .default(1)
                .help("the coordinate (gx) or texture unit (nv) that s1 and t1 are of: only told"),
        ])
        .inputs("light_x … light_z, vertex_x … vertex_z: light and vertex in eye space; s0, t0: texture coordinates; \
             with frame=matrix m0_x … m2_z: rows of the model-view matrix, tangent_x … binormal_z: T and B of the model; \
             with frame=normal normal_x … ct_z: N and CT in eye space; with frame=given tangent_x … binormal_z there; \
             with scale_q=on q0, r0; with constants=ports ks, kt")
        .outputs("ds, dt: displacements; s1, t1: displaced coordinates; degenerate: 1 where L (or a vector that is normalised) \
              is 0, which displaces nothing; with scale_q=on q1, r1, passed")
        .design(design)
}
