//! LDR-FLIP: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A
//! Difference Evaluator for Alternating Images", 2020.
//!
//! Two differences are computed and combined: of colour, after a filter that removes what the eye
//! can't resolve, and of features, which are edges and points found in the luminance. A picture is
//! extended beyond its borders with its border pixels.

use super::filter::{Plane, sum_over_bands, taps};
use super::pixels::{Srgb8, linear};
use crate::base::cast;
use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::ops::Range;

/// Contrast sensitivity to luminance, red against green, and blue against yellow: sums of
/// `a * sqrt(pi / b) * exp(-pi² d² / b)`, where `d` is the distance in degrees (Table 1).
const SENSITIVITY: [&[(f64, f64)]; 3] =
    [&[(1.0, 0.0047)], &[(1.0, 0.0053)], &[(34.1, 0.04), (13.5, 0.025)]];
/// Width of the feature detectors, in degrees.
const FEATURE_DEG: f64 = 0.082;
/// Exponents of colour and feature differences.
const COLOUR_EXPONENT: f64 = 0.7;
const FEATURE_EXPONENT: f64 = 0.5;
/// Differences up to this fraction of the largest are spread over the second fraction of the scale.
const SMALL_PART: f64 = 0.4;
const SMALL_SPREAD: f64 = 0.95;

/// CIE XYZ of linear red, green and blue with sRGB's primaries.
const XYZ_OF_RGB: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];
/// Its inverse.
const RGB_OF_XYZ: [[f64; 3]; 3] = [
    [3.241_003_232_976_358, -1.537_398_969_488_785, -0.498_615_881_996_363],
    [-0.969_224_252_202_516, 1.875_929_983_695_176, 0.041_554_226_340_085],
    [0.055_639_419_851_975, -0.204_011_206_123_91, 1.057_148_977_187_533],
];

type Colour = [f64; 3];

fn times(matrix: &[[f64; 3]; 3], colour: Colour) -> Colour {
    matrix.map(|row| row[0] * colour[0] + row[1] * colour[1] + row[2] * colour[2])
}

/// XYZ of white.
fn white() -> Colour {
    times(&XYZ_OF_RGB, [1.0; 3])
}

/// XYZ relative to white: 0..=1 for colours within sRGB.
fn relative_xyz(rgb: Colour) -> Colour {
    let (xyz, white) = (times(&XYZ_OF_RGB, rgb), white());
    [xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]]
}

/// Linear light of the opponent colour YyCxCz, clamped to 0..=1.
fn rgb_of_opponent([y, cx, cz]: Colour) -> Colour {
    let (y, white) = ((y + 16.0) / 116.0, white());
    let xyz = [(y + cx / 500.0) * white[0], y * white[1], (y - cz / 200.0) * white[2]];
    times(&RGB_OF_XYZ, xyz).map(|light| light.clamp(0.0, 1.0))
}

/// Opponent coordinates of three relative values: YyCxCz for XYZ itself, L*a*b* for its roots.
fn opponent([x, y, z]: Colour) -> Colour {
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// L*a*b* with chroma scaled by lightness, as perceived (Hunt effect).
fn hunt_lab(rgb: Colour) -> Colour {
    const DELTA: f64 = 6.0 / 29.0;
    let root = |t: f64| {
        if t > DELTA * DELTA * DELTA {
            libm::cbrt(t)
        } else {
            t / (3.0 * DELTA * DELTA) + 4.0 / 29.0
        }
    };
    let [l, a, b] = opponent(relative_xyz(rgb).map(root));
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// HyAB distance: absolute difference in lightness plus Euclidean distance in chroma.
fn hyab(p: Colour, q: Colour) -> f64 {
    (p[0] - q[0]).abs() + ((p[1] - q[1]).powi(2) + (p[2] - q[2]).powi(2)).sqrt()
}

/// All filters, with a common radius.
struct Filters {
    radius: usize,
    /// For each sensitivity, the Gaussians whose products along x and y add up to it.
    sensitivity: [Vec<Vec<f64>>; 3],
    /// A Gaussian and its first two derivatives, the negative and the positive part of each scaled
    /// to sum to 1.
    smooth: Vec<f64>,
    edge: Vec<f64>,
    point: Vec<f64>,
    /// The largest colour difference: of green and blue, which are farthest apart.
    largest: f64,
}

/// Three standard deviations, in whole px.
fn reach(deviation_px: f64) -> f64 {
    (3.0 * deviation_px).ceil()
}

impl Filters {
    fn new(pixels_per_degree: f64) -> Self {
        let gaussians = SENSITIVITY.iter().flat_map(|gaussians| gaussians.iter());
        let widest = gaussians.map(|(_, b)| *b).fold(0.0, f64::max);
        let colour_reach = reach((widest / (2.0 * PI * PI)).sqrt() * pixels_per_degree);
        let deviation = 0.5 * FEATURE_DEG * pixels_per_degree;
        let feature_reach = reach(deviation);
        let radius = cast::usize_of(colour_reach.max(feature_reach));
        // Shorter filters are padded with zeros.
        let within = |reach: f64, value: &dyn Fn(f64) -> f64| {
            taps(radius, |x| if x.abs() <= reach { value(x) } else { 0.0 })
        };

        let sensitivity = SENSITIVITY.map(|gaussians| {
            let parts: Vec<(f64, Vec<f64>)> = gaussians
                .iter()
                .map(|(a, b)| {
                    let bell = |x: f64| libm::exp(-PI * PI * (x / pixels_per_degree).powi(2) / b);
                    (a * (PI / b).sqrt(), within(colour_reach, &bell))
                })
                .collect();
            let weight = |(a, bell): &(f64, Vec<f64>)| a * bell.iter().sum::<f64>().powi(2);
            let total: f64 = parts.iter().map(weight).sum();
            // A part's factor is divided equally between x and y.
            let scaled = |(a, bell): &(f64, Vec<f64>)| {
                bell.iter().map(|value| value * (a / total).sqrt()).collect()
            };
            parts.iter().map(scaled).collect()
        });

        let bell = |x: f64| libm::exp(-0.5 * (x / deviation).powi(2));
        let scaled = |kernel: Vec<f64>| -> Vec<f64> {
            let sum = |sign: f64| kernel.iter().map(|value| (sign * value).max(0.0)).sum::<f64>();
            let (above, below) = (sum(1.0), sum(-1.0));
            let scale = |value: &f64| value / if *value < 0.0 { below } else { above };
            kernel.iter().map(scale).collect()
        };
        Self {
            radius,
            sensitivity,
            smooth: scaled(within(feature_reach, &bell)),
            edge: scaled(within(feature_reach, &|x| -x * bell(x))),
            point: scaled(within(feature_reach, &|x| ((x / deviation).powi(2) - 1.0) * bell(x))),
            largest: libm::pow(
                hyab(hunt_lab([0.0, 1.0, 0.0]), hunt_lab([0.0, 0.0, 1.0])),
                COLOUR_EXPONENT,
            ),
        }
    }
}

/// The compared quantities of a picture, over some rows.
struct Seen {
    colours: Vec<Colour>,
    edges: Vec<f64>,
    points: Vec<f64>,
}

impl Seen {
    fn new(picture: &Srgb8, rows: Range<usize>, filters: &Filters) -> Self {
        let planes = opponent_planes(picture, rows, filters.radius);
        let filtered = |channel: usize| -> Vec<f64> {
            let gaussians = filters.sensitivity[channel].iter();
            let parts = gaussians.map(|g| planes[channel].along_x(g).along_y(g).values);
            let add = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(b).map(|(a, b)| a + b).collect();
            parts.reduce(add).expect("bug: a sensitivity without Gaussians")
        };
        let (y, cx, cz) = (filtered(0), filtered(1), filtered(2));
        let colour = |i: usize| hunt_lab(rgb_of_opponent([y[i], cx[i], cz[i]]));
        let colours = (0..y.len()).map(colour).collect();

        // The detectors use the luminance as 0..=1; they don't respond to the offset.
        let smooth = planes[0].along_x(&filters.smooth);
        let strength = |kernel: &[f64]| -> Vec<f64> {
            let x = planes[0].along_x(kernel).along_y(&filters.smooth);
            let y = smooth.along_y(kernel);
            x.values.iter().zip(y.values).map(|(x, y)| (x * x + y * y).sqrt() / 116.0).collect()
        };
        Self { colours, edges: strength(&filters.edge), points: strength(&filters.point) }
    }
}

/// YyCxCz of rows, padded by the radius on all sides.
fn opponent_planes(picture: &Srgb8, rows: Range<usize>, radius: usize) -> [Plane; 3] {
    let (width, height) = (picture.width_px(), picture.height_px());
    let wide = width + 2 * radius;
    let inside = |i: usize, len: usize| i.saturating_sub(radius).min(len - 1);
    let mut planes =
        [(); 3].map(|()| Plane { width: wide, values: Vec::with_capacity(wide * rows.len()) });
    for y in rows.start..rows.end + 2 * radius {
        let row = &picture.codes[inside(y, height) * width..][..width];
        let row: Vec<Colour> =
            row.iter().map(|codes| opponent(relative_xyz(codes.map(linear)))).collect();
        for (channel, plane) in planes.iter_mut().enumerate() {
            plane.values.extend((0..wide).map(|x| row[inside(x, width)][channel]));
        }
    }
    planes
}

/// Mean FLIP, 0..=1, of two pictures of equal size, viewed at `pixels_per_degree` of the visual
/// field. 0 if they are equal.
pub(super) fn flip(a: &Srgb8, b: &Srgb8, pixels_per_degree: f64) -> f64 {
    let filters = Filters::new(pixels_per_degree);
    let sum = sum_over_bands(a.height_px(), |rows| {
        let a = Seen::new(a, rows.clone(), &filters);
        let b = Seen::new(b, rows, &filters);
        (0..a.colours.len())
            .map(|i| {
                let colour = libm::pow(hyab(a.colours[i], b.colours[i]), COLOUR_EXPONENT);
                let edge = (a.edges[i] - b.edges[i]).abs();
                let point = (a.points[i] - b.points[i]).abs();
                let feature = libm::pow(FRAC_1_SQRT_2 * edge.max(point), FEATURE_EXPONENT).min(1.0);
                libm::pow(spread(colour, filters.largest), 1.0 - feature)
            })
            .sum()
    });
    sum / cast::f64_of_len(a.codes.len())
}

/// A colour difference as a fraction of the largest, with small ones spread out.
fn spread(difference: f64, largest: f64) -> f64 {
    let small = SMALL_PART * largest;
    if difference < small {
        difference / small * SMALL_SPREAD
    } else {
        SMALL_SPREAD + (difference - small) / (largest - small) * (1.0 - SMALL_SPREAD)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrices_are_each_other_s_inverse() {
        for (i, unit) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate()
        {
            let back = times(&RGB_OF_XYZ, times(&XYZ_OF_RGB, unit));
            for (k, value) in back.into_iter().enumerate() {
                let expected = f64::from(u8::from(i == k));
                assert!((value - expected).abs() < 1e-12, "{i} {k} {value}");
            }
        }
    }

    #[test]
    fn filters_keep_what_is_even_and_detectors_don_t_see_it() {
        for ppd in [1.0, 20.0, 67.0, 1000.0] {
            let filters = Filters::new(ppd);
            for gaussians in &filters.sensitivity {
                let sum: f64 = gaussians.iter().map(|g| g.iter().sum::<f64>().powi(2)).sum();
                assert!((sum - 1.0).abs() < 1e-12, "{ppd} {sum}");
            }
            let sum = |kernel: &[f64]| kernel.iter().sum::<f64>();
            assert!((sum(&filters.smooth) - 1.0).abs() < 1e-12, "{ppd}");
            assert!(sum(&filters.edge).abs() < 1e-12, "{ppd}");
            assert!(sum(&filters.point).abs() < 1e-12, "{ppd}");
        }
    }
}
