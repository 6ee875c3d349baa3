//! Generated surfaces: each computes colour and height from one function, so that the bumps match
//! the colours.
//!
//! Everything is computed in f64 from an integer hash, so a pattern is the same on every run.

use crate::base::cast;
use crate::shading::srgb::from_srgb;
use glam::DVec3;
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

/// A generated surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Pattern {
    /// A wall of wooden boards; repeats.
    Wood,
    /// A brick wall; repeats.
    Brick,
    /// A planet with oceans, land and ice; u is longitude and v latitude, without a seam.
    Earth,
    /// A stone plate, twice as wide as high, with a word in raised letters; repeats.
    Lettering,
}

/// A surface at one point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// Linear RGB, 0 to 1.
    pub(super) color: [f64; 3],
    /// 0 to 1.
    pub(super) height: f64,
}

/// A surface at the middle of each texel of a map, row by row.
#[derive(Clone, Debug)]
pub(super) struct Samples {
    pub(super) pattern: Pattern,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) texels: Vec<Sample>,
}

impl Pattern {
    /// Columns and rows if the scene gives none.
    pub(super) const fn default_size(self) -> (u32, u32) {
        match self {
            Self::Wood | Self::Brick => (512, 512),
            Self::Earth | Self::Lettering => (512, 256),
        }
    }

    /// The surface over a map of this size.
    pub(super) fn over(self, width: u32, height: u32) -> Samples {
        let middle = |i: u32, side: u32| (f64::from(i) + 0.5) / f64::from(side);
        let texels = (0..width * height).into_par_iter().map(|texel| {
            let (x, y) = (texel % width, texel / width);
            self.sample(middle(x, width), 1.0 - middle(y, height))
        });
        Samples { pattern: self, width, height, texels: texels.collect() }
    }

    /// The surface at (u, v), both 0 to 1.
    fn sample(self, u: f64, v: f64) -> Sample {
        let (color, height) = match self {
            Self::Wood => wood(u, v),
            Self::Brick => brick(u, v),
            Self::Earth => earth(u, v),
            Self::Lettering => lettering(u, v),
        };
        Sample {
            color: color.to_array().map(|c| c.clamp(0.0, 1.0)),
            height: height.clamp(0.0, 1.0),
        }
    }
}

/// Boards side by side, each cut from its own log, with ends at different places.
fn wood(u: f64, v: f64) -> (DVec3, f64) {
    const BOARDS: f64 = 5.0;
    let board = (u * BOARDS).floor();
    let across = u * BOARDS - board; // 0 to 1 over the board
    let log = |what| hash01([cast::i64_of(board), what, 0], 11);
    // At the joint between two boards' ends, discontinuities are allowed.
    let along = (v + log(0)).rem_euclid(1.0);

    // Rings about an axis slightly skewed to the board give long arches.
    let wobble = fbm(DVec3::new(2.0 * across, 3.0 * along, 7.0 * board), FREE, 3, 12);
    let from_axis = DVec3::new(
        across - 0.2 - 0.6 * log(1) + 0.12 * wobble,
        0.0,
        0.10 + 0.5 * (along - 0.5) * (0.4 + log(2)),
    );
    let rings = 9.0 * from_axis.length() + 0.25 * wobble;
    let ring = rings.rem_euclid(1.0);
    // Early wood darkens slowly; late wood ends abruptly.
    let late = smooth(0.25, 0.85, ring) * (1.0 - smooth(0.92, 1.0, ring));
    let fibre = fbm(DVec3::new(45.0 * across, 4.0 * along, 3.0 * board), FREE, 3, 13);
    let pores = smooth(0.25, 0.5, noise(DVec3::new(70.0 * across, 9.0 * along, board), FREE, 14));

    let pale = mix(srgb(0xd3_a5_6b), srgb(0xb9_83_4c), log(3));
    let dark = mix(srgb(0x8f_5a_2e), srgb(0x74_45_22), log(4));
    let mut color = mix(pale, dark, (0.75 * late + 0.22 * fibre + 0.1).clamp(0.0, 1.0));
    color *= 1.0 - 0.25 * pores;

    // Board edges are rounded off; between boards there is a gap.
    let edge = across.min(1.0 - across);
    let end = 6.0 * along.min(1.0 - along);
    let gap = edge.min(end);
    let body = smooth(0.012, 0.075, gap);
    color = mix(srgb(0x22_16_0d), color, smooth(0.0, 0.045, gap));
    let grain = 0.10 * late + 0.035 * fibre - 0.05 * pores;
    (color, body * (0.78 + grain + 0.06 * (log(5) - 0.5)))
}

/// Bricks in running bond.
fn brick(u: f64, v: f64) -> (DVec3, f64) {
    const COLUMNS: i64 = 4;
    const ROWS: i64 = 10;
    // Width of a brick in units of its height, so that joints are equally wide in both directions.
    let shape = cast::f64_of(ROWS) / cast::f64_of(COLUMNS);
    let everywhere = |per_side: i64, octaves, seed| {
        let side = cast::f64_of(per_side);
        fbm(DVec3::new(u * side, v * side, 0.5), [per_side, per_side, 0], octaves, seed)
    };
    let y = v * cast::f64_of(ROWS) + 0.05 * everywhere(9, 2, 21);
    let row = y.floor();
    let odd = row.rem_euclid(2.0);
    let x = u * cast::f64_of(COLUMNS) + 0.5 * odd + 0.02 * everywhere(9, 2, 22);
    let column = x.floor();
    let place = [cast::i64_of(column).rem_euclid(COLUMNS), cast::i64_of(row).rem_euclid(ROWS)];
    let own = |what| hash01([place[0], place[1], what], 23);
    let (x, y) = (x - column, y - row);
    let side = (x.min(1.0 - x) * shape).min(y.min(1.0 - y));
    // Corners are rounded: the distance to a joint falls off in both directions.
    let corner =
        DVec3::new((0.22 - x.min(1.0 - x) * shape).max(0.0), (0.22 - y.min(1.0 - y)).max(0.0), 0.0);
    let inside = side.min(0.22 - corner.length());

    let rough = everywhere(24, 4, 24);
    let sand = everywhere(90, 2, 25);
    let is_brick = smooth(0.055, 0.085, inside + 0.02 * rough);
    let tint = mix(srgb(0x9c_46_33), srgb(0x6f_2d_25), own(0));
    let tint = mix(tint, srgb(0xb8_6a_48), 0.55 * own(1) * own(1));
    let burnt = smooth(0.1, 0.5, everywhere(7, 3, 26) + 0.5 * (own(2) - 0.6));
    let fired = mix(tint, srgb(0x3e_22_20), 0.55 * burnt) * (1.0 + 0.3 * rough + 0.12 * sand);
    let mortar = srgb(0xa9_a2_96) * (0.85 + 0.2 * sand + 0.15 * rough);
    let body = 0.74 + 0.10 * rough + 0.03 * sand + 0.10 * (own(3) - 0.5);
    let joint = 0.22 + 0.06 * sand + 0.03 * rough;
    let dome = smooth(0.05, 0.16, inside + 0.012 * rough);
    (mix(mortar, fired, is_brick), joint + (body - joint) * dome)
}

/// A planet from noise on the sphere.
fn earth(u: f64, v: f64) -> (DVec3, f64) {
    let (sin_az, cos_az) = libm::sincos(TAU * u);
    let (sin_theta, cos_theta) = libm::sincos(PI * (1.0 - v));
    let p = DVec3::new(sin_theta * cos_az, sin_theta * sin_az, cos_theta);
    // Coasts are ragged because noise displaces the point at which land is looked up.
    let moved = |seed| fbm(2.1 * p + DVec3::splat(3.7), FREE, 4, seed);
    let q = p + 0.32 * DVec3::new(moved(31), moved(32), moved(33));
    let continents = fbm(1.25 * q + DVec3::new(5.2, 1.3, 9.1), FREE, 7, 34);
    let land = continents + 0.035; // above 0 it is dry
    let coast = smooth(0.0, 0.02, land);

    let ridges = 1.0 - fbm(3.4 * q, FREE, 6, 35).abs() * 2.6;
    let belts = smooth(-0.05, 0.3, fbm(1.6 * p, FREE, 3, 36) + 0.08);
    let mountains = belts * ridges.max(0.0).powi(3) * smooth(0.0, 0.16, land);
    let rolling = 0.5 + 0.5 * fbm(9.0 * p, FREE, 5, 37);
    let relief = smooth(0.0, 0.35, land) * (0.22 + 0.3 * rolling) + 0.62 * mountains;

    let latitude = (v - 0.5).abs() * 2.0; // 0 at the equator, 1 at a pole
    let fray = fbm(6.0 * p, FREE, 5, 38);
    let wet = fbm(2.4 * p + DVec3::splat(8.3), FREE, 4, 39);
    // Wet at the equator, dry at about 25 degrees, then wet again, finally cold.
    let desert = smooth(0.0, 0.22, 0.16 - (latitude - 0.28).abs() - 0.35 * wet + 0.1 * fray + 0.06);
    let cold = smooth(0.58, 0.80, latitude + 0.12 * fray + 0.25 * relief);
    let ice = smooth(0.80, 0.86, latitude + 0.09 * fray + 0.05 * coast + 0.1 * relief);

    let green = mix(srgb(0x2f_5a_24), srgb(0x6b_7f_38), (rolling + 0.7 * fray).clamp(0.0, 1.0));
    let green = mix(green, srgb(0x1d_48_1c), smooth(0.30, 0.05, latitude) * smooth(-0.1, 0.2, wet));
    let sand = mix(srgb(0xd2_b2_7a), srgb(0xb0_82_50), rolling);
    let tundra = mix(srgb(0x7d_76_5a), srgb(0x9a_94_84), rolling);
    let mut ground = mix(mix(green, sand, desert), tundra, cold);
    ground = mix(ground, srgb(0x70_5c_4a), smooth(0.25, 0.6, mountains));
    ground = mix(ground, srgb(0xee_f0_f2), smooth(0.52, 0.78, mountains + 0.4 * cold * mountains));
    let deep = mix(srgb(0x0a_24_55), srgb(0x12_38_70), 0.5 + 0.8 * fray);
    let sea = mix(deep, srgb(0x2f_7d_9c), smooth(-0.10, -0.005, land));
    let color = mix(mix(sea, ground, coast), srgb(0xf2_f5_f8), ice);
    let surface = mix1(0.10, 0.16 + 0.8 * relief, coast);
    (color, mix1(surface, 0.24 + 0.1 * rolling + 0.5 * relief * coast, ice))
}

/// The word on the plate.
const WORD: &str = "fixpath";
/// Dot rows of a letter, and of the whole plate.
const LETTER_DOTS: usize = 16;
const PLATE_DOTS: f64 = 28.0;

/// Ink of the word's dots, 0 to 1, row by row from the top, and the number of dots in a row.
static INK: LazyLock<(Vec<f64>, usize)> = LazyLock::new(|| {
    let (weight, size) = (FontWeight::Regular, RasterHeight::Size16);
    let width = get_raster_width(weight, size);
    let columns = WORD.chars().count() * width;
    let mut ink = vec![0.0; columns * LETTER_DOTS];
    for (i, letter) in WORD.chars().enumerate() {
        let raster = get_raster(letter, weight, size).expect("bug: the font has plain letters");
        for (x, y) in (0..LETTER_DOTS).flat_map(|y| (0..width).map(move |x| (x, y))) {
            ink[y * columns + i * width + x] = f64::from(raster.pixel(x, y).unwrap_or(0)) / 255.0;
        }
    }
    (ink, columns)
});

/// A sandstone plate with a word.
fn lettering(u: f64, v: f64) -> (DVec3, f64) {
    let (ink, columns) = &*INK;
    let at = |x: i64, y: i64| {
        let inside = |at: i64, count: usize| usize::try_from(at).ok().filter(|at| *at < count);
        inside(x, *columns).zip(inside(y, LETTER_DOTS)).map_or(0.0, |(x, y)| ink[y * columns + x])
    };
    // Dot coordinates from the word's upper left, centres at whole numbers; the word is centred.
    let x = 2.0 * PLATE_DOTS * (u - 0.5) + 0.5 * cast::f64_of_len(*columns) - 0.5;
    let y = PLATE_DOTS * (0.5 - v) + 0.5 * cast::f64_of_len(LETTER_DOTS) - 0.5;
    // A cubic B-spline over the dots: dots merge into strokes without steps, with sloped edges.
    let weights = |f: f64| {
        let g = 1.0 - f;
        let near = |f: f64| 2.0 / 3.0 - 0.5 * f * f * (2.0 - f);
        [g * g * g / 6.0, near(f), near(g), f * f * f / 6.0]
    };
    let (left, top) = (x.floor(), y.floor());
    let (across, down) = (weights(x - left), weights(y - top));
    let mut cover = 0.0;
    for (j, wy) in (-1..).zip(down) {
        for (i, wx) in (-1..).zip(across) {
            cover += wx * wy * at(cast::i64_of(left) + i, cast::i64_of(top) + j);
        }
    }
    let raised = smooth(0.12, 0.55, cover);
    let everywhere = |per_side: i64, octaves, seed| {
        let (along, up) = (cast::f64_of(2 * per_side), cast::f64_of(per_side));
        let period = [2 * per_side, per_side, 0];
        fbm(DVec3::new(u * along, v * up, 0.5), period, octaves, seed)
    };
    let grain = everywhere(60, 3, 41);
    let cloud = everywhere(3, 3, 42);
    let stone = mix(srgb(0xa8_9f_8e), srgb(0xb9_ad_96), (0.5 + cloud).clamp(0.0, 1.0));
    (stone * (1.0 + 0.10 * grain), 0.1 + 0.03 * grain + 0.8 * raised)
}

/// The period of noise that doesn't repeat.
const FREE: [i64; 3] = [0; 3];

/// Sums octaves of noise, each twice as fine and half as strong; about -0.7 to 0.7.
fn fbm(p: DVec3, period: [i64; 3], octaves: u32, seed: u64) -> f64 {
    let (mut sum, mut weight, mut scale) = (0.0, 0.5, 1);
    for octave in 0..octaves {
        let shift = 17.31 * f64::from(octave);
        // A shift is harmless along a repeating axis; along a free one it decouples octaves.
        let q = p * cast::f64_of(scale) + DVec3::splat(shift);
        sum += weight * noise(q, period.map(|side| side * scale), seed + u64::from(octave) * 101);
        weight *= 0.5;
        scale *= 2;
    }
    sum
}

/// Gradient noise, about -1 to 1; the lattice repeats after `period` along axes where that isn't 0.
fn noise(p: DVec3, period: [i64; 3], seed: u64) -> f64 {
    let cell = p.floor();
    let f = p - cell;
    let lattice = [cell.x, cell.y, cell.z].map(cast::i64_of);
    let ends = |axis: usize, offset: i64| {
        let at = lattice[axis] + offset;
        if period[axis] == 0 { at } else { at.rem_euclid(period[axis]) }
    };
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let weight = [fade(f.x), fade(f.y), fade(f.z)];
    // From plane to line to corner, so that each level hashes only its own coordinate.
    let corner = |state: u64, x: f64, y: f64, k: i64| {
        let bits = stir(state, ends(2, k));
        let part = |shift: u32| cast::f64_of_count(bits >> shift & 0xffff) / 32768.0 - 1.0;
        part(0) * x + part(16) * y + part(32) * (f.z - cast::f64_of(k))
    };
    let line = |state: u64, x: f64, j: i64| {
        let (state, y) = (stir(state, ends(1, j)), f.y - cast::f64_of(j));
        mix1(corner(state, x, y, 0), corner(state, x, y, 1), weight[2])
    };
    let plane = |i: i64| {
        let (state, x) = (stir(seed, ends(0, i)), f.x - cast::f64_of(i));
        mix1(line(state, x, 0), line(state, x, 1), weight[1])
    };
    1.2 * mix1(plane(0), plane(1), weight[0])
}

/// Mixes an integer into a state (splitmix64).
fn stir(state: u64, x: i64) -> u64 {
    let mut z = (state ^ cast::bits_of(x)).wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A hash of three integers, in [0, 1).
fn hash01(at: [i64; 3], seed: u64) -> f64 {
    let bits = at.iter().fold(seed, |state, x| stir(state, *x));
    cast::f64_of_count(bits >> 11) / 9_007_199_254_740_992.0 // 2^53
}

/// 0 before `from`, 1 after `to`, smooth in between; either order.
fn smooth(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

fn mix(a: DVec3, b: DVec3, t: f64) -> DVec3 {
    a + (b - a) * t
}

fn mix1(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// Linear colour of an sRGB code `rrggbb`.
fn srgb(code: u32) -> DVec3 {
    let part = |shift: u32| from_srgb(f64::from(code >> shift & 0xff) / 255.0);
    DVec3::new(part(16), part(8), part(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jump(pattern: Pattern, a: (f64, f64), b: (f64, f64)) -> f64 {
        let (a, b) = (pattern.sample(a.0, a.1), pattern.sample(b.0, b.1));
        let colors = a.color.iter().zip(b.color).map(|(x, y)| (x - y).abs());
        colors.fold((a.height - b.height).abs(), f64::max)
    }

    #[test]
    fn patterns_repeat_without_a_seam() {
        for i in 0..400 {
            let t = (f64::from(i) + 0.5) / 400.0;
            for pattern in [Pattern::Wood, Pattern::Brick, Pattern::Earth, Pattern::Lettering] {
                let across = jump(pattern, (1e-7, t), (1.0 - 1e-7, t));
                assert!(across < 1e-3, "{pattern:?} {t} {across}");
            }
            for pattern in [Pattern::Wood, Pattern::Brick, Pattern::Lettering] {
                let up = jump(pattern, (t, 1e-7), (t, 1.0 - 1e-7));
                assert!(up < 1e-3, "{pattern:?} {t} {up}");
            }
            // A pole is one point.
            assert!(jump(Pattern::Earth, (0.0, 1.0), (t, 1.0)) < 1e-9);
        }
    }

    #[test]
    fn heights_use_their_range_and_fit_the_colours() {
        for pattern in [Pattern::Wood, Pattern::Brick, Pattern::Earth, Pattern::Lettering] {
            let samples: Vec<Sample> = (0..10_000u32)
                .map(|i| pattern.sample(f64::from(i % 100) / 100.0, f64::from(i / 100) / 100.0))
                .collect();
            let least = samples.iter().map(|s| s.height).fold(1.0, f64::min);
            let most = samples.iter().map(|s| s.height).fold(0.0, f64::max);
            assert!(most - least > 0.5, "{pattern:?} {least} {most}");
            for s in samples {
                assert!(
                    (0.0..=1.0).contains(&s.height)
                        && s.color.iter().all(|c| (0.0..=1.0).contains(c))
                );
            }
        }
    }
}
