//! Random and hard triangles.

use crate::design::{Draw, HardCase, InputPorts, Sampler, Uniform, Values};
use crate::netlist::{Netlist, NodeId};
use crate::number::format::{Overflow, Round, quantize};
use crate::number::trig::sin_cos_turns;
use glam::{DVec2, DVec3};

/// A triangle and the vectors at its vertex, as real numbers.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    p: [DVec3; 3],
    uv: [DVec2; 3],
    normal: DVec3,
    view: DVec3,
    lights: [DVec3; 8],
}

impl Triangle {
    /// All numbers, each at its [`Triangle::place`].
    fn numbers(&self) -> [f64; 45] {
        let mut all = [0.0; 45];
        let vectors = self.p.iter().chain([&self.normal, &self.view]).chain(&self.lights);
        for (to, vector) in all.chunks_exact_mut(3).zip(vectors) {
            to.copy_from_slice(&vector.to_array());
        }
        for (to, uv) in all[39..].chunks_exact_mut(2).zip(&self.uv) {
            to.copy_from_slice(&uv.to_array());
        }
        all
    }

    /// Index of an input port's number.
    fn place(port: &str) -> usize {
        let (name, axis) = port.rsplit_once('_').expect("bug: a component");
        let axis = ["x", "y", "z", "u", "v"].iter().position(|known| *known == axis);
        let axis = axis.expect("bug: an axis");
        let number = |prefix: &str| -> Option<usize> { name.strip_prefix(prefix)?.parse().ok() };
        if let Some(k) = number("uv") {
            return 39 + 2 * k + axis - 3;
        }
        let vector = match (name, number("p"), number("light")) {
            ("normal", ..) => 3,
            ("view", ..) => 4,
            (_, Some(k), _) => k,
            (_, _, Some(k)) => 5 + k,
            _ => panic!("bug: no port `{port}`"),
        };
        3 * vector + axis
    }

    /// A random triangle. Positions and texture coordinates each span eight octaves of scale,
    /// anywhere in their range; half of the textures are mirrored. With `lit`, no angle is below
    /// 30°, in space and in the texture. The normal is at most 45° off the face's, and view and
    /// lights are on its side. Their lengths are ⅛ to 1 of the longest vector along an axis.
    /// Without `lit`, corners and normal are anywhere, and view and lights are any words. `limits`
    /// are those of positions, texture coordinates and vectors.
    fn random(limits: [f64; 3], lit: bool, uniform: &mut Uniform) -> Self {
        let mut sphere = || {
            let (z, turns) = (1.0 - 2.0 * uniform.draw(), uniform.draw());
            let (sin, cos) = sin_cos_turns(turns);
            let across = (1.0 - z * z).sqrt();
            DVec3::new(across * cos, across * sin, z)
        };
        let (axis, normal, aside) = (sphere(), sphere(), sphere());
        let (corners, directions) = ([(); 3].map(|()| sphere()), [(); 9].map(|()| sphere()));
        let mut within = |low: f64, high: f64| low + (high - low) * uniform.draw();
        // Corners on a circle, a third of a turn apart, give or take a twelfth: arcs are at least a
        // sixth.
        let mut circle = |sign: f64| {
            let first = within(0.0, 1.0);
            [0.0, 1.0, 2.0].map(|k| {
                let turns = sign * (first + k / 3.0 + within(-1.0, 1.0) / 12.0);
                let (sin, cos) = sin_cos_turns(turns);
                DVec2::new(cos, sin)
            })
        };
        let (flat, regular) = (circle(1.0), circle(1.0));
        let mirror = if uniform.draw() < 0.5 { -1.0 } else { 1.0 };
        let mut within = |low: f64, high: f64| low + (high - low) * uniform.draw();
        // Half the range is for the size, half for the place.
        let [size, uv_size] =
            [limits[0], limits[1]].map(|limit| 0.5 * limit * libm::exp2(within(-8.0, 0.0)));
        let mut place = |limit: f64| within(-0.5 * limit, 0.5 * limit);
        let center = DVec3::from_array([(); 3].map(|()| place(limits[0])));
        let uv_center = DVec2::from_array([(); 2].map(|()| place(limits[1])));
        let anywhere = [(); 3].map(|()| DVec2::new(place(2.0), place(2.0)));
        let (u, v) = axis.any_orthonormal_pair();
        let p = [0, 1, 2].map(|k| {
            let corner = if lit { u * flat[k].x + v * flat[k].y } else { corners[k] };
            center + corner * size
        });
        let uv = [0, 1, 2].map(|k| {
            let corner = if lit { regular[k] * DVec2::new(mirror, 1.0) } else { anywhere[k] };
            uv_center + corner * uv_size
        });
        let mut vectors = directions.map(|v| {
            // Without `lit`, up to the corners of the cube of all words: √3 of the longest vector
            // along an axis.
            let v = if lit { v } else { [(); 3].map(|()| within(-1.0, 1.0)).into() };
            v * limits[2] * libm::exp2(within(-3.0, 0.0))
        });
        let mut normal = normal;
        if lit {
            let face = (p[1] - p[0]).cross(p[2] - p[0]).normalize_or_zero();
            normal = (face + aside * within(0.0, 0.5f64.sqrt())).normalize_or(face);
            for v in &mut vectors {
                *v = if v.dot(normal) < 0.0 { -*v } else { *v };
            }
        }
        let [view, lights @ ..] = vectors;
        Self { p, uv, normal, view, lights }
    }
}

pub(super) fn draw(values: &Values, ports: &InputPorts<'_>) -> Draw {
    let range = |name: &str| libm::exp2(values.bits(name).into());
    let limits = ["position_int_bits", "uv_int_bits", "vector_int_bits"].map(range);
    let places: Vec<usize> = ports.names().map(Triangle::place).collect();
    Draw::new(move |sampler, uniform, columns, count| {
        columns.iter_mut().for_each(Vec::clear);
        for _ in 0..count {
            let lit = sampler == Sampler::Lit;
            let numbers = Triangle::random(limits, lit, uniform).numbers();
            for (column, place) in columns.iter_mut().zip(&places) {
                column.push(numbers[*place]);
            }
        }
    })
}

pub(super) fn hard_cases(netlist: &Netlist) -> Vec<HardCase> {
    let words = |triangle: &Triangle| -> Vec<i64> {
        let numbers = triangle.numbers();
        let word = |(port, id): (usize, &NodeId)| {
            let value = numbers[Triangle::place(netlist.input_name(port))];
            let format = netlist.node(*id).format;
            let word = quantize(value, format, Round::HalfEven, Overflow::Saturate);
            word.expect("bug: triangles are finite").0
        };
        netlist.inputs().iter().enumerate().map(word).collect()
    };
    let found = |name: &str| {
        let port = (0..netlist.inputs().len()).find(|port| netlist.input_name(*port) == name)?;
        Some(netlist.node(netlist.inputs()[port]).format)
    };
    let format = |name: &str| found(name).expect("bug: a port");
    let (position, uv) = (format("p0_x"), format("uv0_u"));
    let (lsb, uv_lsb) = (position.ulp(), uv.ulp());
    let (span, uv_span) = (-position.value(position.min_raw()), -uv.value(uv.min_raw()));
    let cases = |name, list: Vec<Triangle>| HardCase::new(name, list.iter().map(words).collect());
    let two = |u: f64, v: f64| DVec2::new(u, v);
    let corners = |e1: DVec3, e2: DVec3| {
        let p0 = DVec3::new(-0.25, 0.125, 0.0625) * span;
        [p0, p0 + e1, p0 + e2]
    };
    let unit = 0.25 * span; // a typical edge
    let (e1, e2) = (DVec3::new(0.96, 0.28, 0.0) * unit, DVec3::new(-0.28, 0.768, 0.576) * unit);
    let normal = e1.cross(e2).normalize();
    let usual = Triangle {
        p: corners(e1, e2),
        uv: [two(0.125, 0.25), two(0.625, 0.25), two(0.125, 0.75)].map(|at| at * uv_span),
        normal: (normal + DVec3::new(0.125, -0.25, 0.0625)).normalize(),
        view: DVec3::new(0.48, -0.36, 0.8),
        lights: [DVec3::new(0.6, 0.64, 0.48); 8],
    };
    let textures =
        |list: Vec<[DVec2; 3]>| list.into_iter().map(|uv| Triangle { uv, ..usual }).collect();
    let shapes = |list: Vec<(DVec3, DVec3)>| {
        list.into_iter().map(|(e1, e2)| Triangle { p: corners(e1, e2), ..usual }).collect()
    };
    let [uv0, uv1, uv2] = usual.uv;
    let mirror = |uv: [DVec2; 3], u: f64, v: f64| uv.map(|at| at * two(u, v));
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let normals = |list: Vec<DVec3>| -> Vec<Triangle> {
        list.into_iter().map(|normal| Triangle { normal, ..usual }).collect()
    };
    // dP/du is along e1, which is exact in words if the edge is along an axis.
    let along = |axis: usize| Triangle {
        p: corners(axes[axis] * unit, axes[(axis + 1) % 3] * unit),
        normal: axes[(axis + 2) % 3],
        ..usual
    };
    let seam = |u: [f64; 3]| [two(u[0], 0.2), two(u[1], 0.2), two(u[2], 0.4)];
    let mut list = vec![
        cases("mirrored texture, along u, v, both, and turned", {
            let turned = usual.uv.map(|at| two(at.y, at.x));
            let list = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
            let mut list: Vec<[DVec2; 3]> = list.map(|(u, v)| mirror(usual.uv, u, v)).to_vec();
            list.extend([turned, [uv0, uv2, uv1], [uv1, uv0, uv2]]);
            textures(list)
        }),
        cases("determinant of the texture one LSB from 0, either side, and 0 there", {
            // (k, 1) and (k + 1, 1): -1; 1 with the edges exchanged.
            let near = |k: f64| {
                let edges = [two(k, 1.0), two(k + 1.0, 1.0)].map(|edge| uv0 + edge * uv_lsb);
                [[uv0, edges[0], edges[1]], [uv0, edges[1], edges[0]], [uv0, edges[0], edges[0]]]
            };
            // (k, k - 1) and (k + 1, k): 1, both long.
            let long = |k: f64| {
                let edges = [two(k, k - 1.0), two(k + 1.0, k)].map(|edge| uv0 + edge * uv_lsb);
                [[uv0, edges[0], edges[1]], [uv0, edges[1], edges[0]]]
            };
            let most = (0.5 * uv_span / uv_lsb).floor();
            let mut list: Vec<[DVec2; 3]> =
                [0.0, 1.0, 100.0, most].into_iter().flat_map(near).collect();
            list.extend([2.0, 100.0, most].into_iter().flat_map(long));
            textures(list)
        }),
        cases("zero area of the texture", {
            textures(vec![
                [uv0; 3],
                [uv0, uv1, uv1],
                [uv0, uv0, uv1],
                [uv0, uv1, uv0],
                [uv0, uv1, uv0 * 2.0 - uv1],
                [two(0.0, 0.0), two(1.0, 1.0) * 0.25 * uv_span, two(1.0, 1.0) * 0.5 * uv_span],
            ])
        }),
        cases("a seam of the texture", {
            textures(vec![
                seam([0.99, 0.01, 0.99]),
                seam([0.01, 0.99, 0.01]),
                seam([0.99, 0.01, 0.01]),
                seam([0.99, 1.01, 0.99]),
            ])
        }),
        cases("slivers of aspect 1:10^4", {
            let thin = 1e-4 * 2.0;
            shapes(vec![
                (e1 * 2.0, e2 * thin),
                (e1 * thin, e2 * 2.0),
                (e1 * 2.0, e1 * 2.0 + e2 * thin),
                (e1 * 2.0, e1 * -1.0 + e2 * thin),
                (e1 * 2.0, DVec3::Z * lsb),
                (DVec3::X * span, DVec3::X * (span - lsb) + DVec3::Y * lsb),
            ])
        }),
        cases("repeated vertices and triangles without area", {
            shapes(vec![
                (DVec3::ZERO, DVec3::ZERO),
                (e1, e1),
                (DVec3::ZERO, e2),
                (e1, DVec3::ZERO),
                (DVec3::X * unit, DVec3::X * unit * -0.5),
                (DVec3::ONE * 4.0 * lsb, DVec3::ONE * 8.0 * lsb),
            ])
        }),
        cases("both without area", {
            vec![
                Triangle { p: corners(e1, e1), uv: [uv0, uv1, uv1], ..usual },
                Triangle { p: corners(DVec3::ZERO, DVec3::ZERO), uv: [uv0; 3], ..usual },
            ]
        }),
        cases("triangles of one LSB", {
            let p = usual.p[0];
            let small = axes.iter().flat_map(|e1| axes.iter().map(move |e2| (*e1, *e2)));
            small
                .flat_map(|(e1, e2)| {
                    let small = [uv0, uv0 + two(uv_lsb, 0.0), uv0 + two(0.0, uv_lsb)];
                    let p = [p, p + e1 * lsb, p + e2 * lsb];
                    [Triangle { p, ..usual }, Triangle { p, uv: small, ..usual }]
                })
                .collect()
        }),
        cases("the longest edges", {
            let far = 1e9; // past every position
            let ends = |bits: usize| {
                DVec3::from_array([0, 1, 2].map(|i| if bits >> i & 1 == 0 { -far } else { far }))
            };
            let uv_ends = |bits: usize| {
                two(if bits & 1 == 0 { -far } else { far }, if bits & 2 == 0 { -far } else { far })
            };
            [[0, 7, 1], [7, 0, 4], [0, 3, 5], [1, 6, 2], [5, 2, 0], [0, 1, 2]]
                .into_iter()
                .flat_map(|of| {
                    let p = of.map(ends);
                    [[0, 1, 2], [3, 0, 1], [0, 3, 2]].map(|uv| Triangle {
                        p,
                        uv: uv.map(uv_ends),
                        normal: DVec3::Z,
                        ..usual
                    })
                })
                .collect()
        }),
        cases("positions and textures over eight octaves of scale", {
            (0..=8)
                .flat_map(|octave| {
                    let scale = libm::exp2((-octave).into());
                    let uv = [uv0, uv0 + (uv1 - uv0) * scale, uv0 + (uv2 - uv0) * scale];
                    let p = corners(e1 * scale, e2 * scale);
                    [Triangle { p, ..usual }, Triangle { uv, ..usual }, Triangle { p, uv, ..usual }]
                })
                .collect()
        }),
        cases("view and light 0, of one LSB, and longest", {
            let lsb = format("view_x").ulp();
            let list = [DVec3::ZERO, DVec3::X * lsb, DVec3::ONE * 1e9, DVec3::ONE * -1e9];
            let list = list.into_iter().chain(axes.map(|axis| axis * -1e9));
            list.map(|v| Triangle { view: v, lights: [-v; 8], ..usual }).collect()
        }),
        cases("the longest view and light along T, B or N, and 0.47 of both others", {
            let corner = DVec3::ONE;
            (0..3)
                .flat_map(|row| [(row, 0.0), (row, 0.47f64)])
                .flat_map(|(row, aside)| {
                    // Mirrors the corner to its image in texture space.
                    let mut mapped = DVec3::splat(aside);
                    mapped[row] = (3.0 - 2.0 * aside * aside).sqrt();
                    let across = (corner - mapped).normalize();
                    let [t, normal] = [DVec3::X, DVec3::Z].map(|v| v.reflect(across));
                    [1e9, -1e9].map(|far| Triangle {
                        p: corners(t * unit, normal.cross(t) * unit),
                        normal,
                        view: corner * far,
                        lights: [corner * -far; 8],
                        ..usual
                    })
                })
                .collect()
        }),
    ];
    let Some(normal_format) = found("normal_x") else { return list };
    let normal_lsb = normal_format.ulp();
    list.extend([
        cases("T parallel to N", {
            (0..3)
                .flat_map(|axis| {
                    [1.0, -1.0].map(|sign| Triangle { normal: axes[axis] * sign, ..along(axis) })
                })
                .collect()
        }),
        cases("T parallel to N but for one LSB", {
            (0..3)
                .flat_map(|axis| {
                    [1, 2].into_iter().flat_map(move |aside| {
                        [1.0, -1.0].map(|sign| Triangle {
                            normal: axes[axis] + axes[(axis + aside) % 3] * sign * normal_lsb,
                            ..along(axis)
                        })
                    })
                })
                .collect()
        }),
        cases("T parallel to N but for one LSB of an edge", {
            (0..3)
                .map(|axis| {
                    let aside = axes[(axis + 1) % 3] * lsb;
                    let p = corners(axes[axis] * unit + aside, axes[(axis + 2) % 3] * unit);
                    Triangle { p, normal: axes[axis], ..along(axis) }
                })
                .collect()
        }),
        cases("N 0, along axes, longest, inward, or at right angles to the face", {
            let mut list =
                normals(vec![DVec3::ZERO, DVec3::splat(1e9), DVec3::splat(-1e9), -normal]);
            list.extend(normals(axes.into_iter().flat_map(|axis| [axis, -axis]).collect()));
            list.extend(normals(vec![e1.normalize(), e2.normalize()]));
            list
        }),
        cases("N 0 or along axes without a frame", {
            let uv = [uv0; 3];
            let list =
                [DVec3::ZERO, DVec3::ONE, DVec3::new(1.0, -1.0, 0.0), DVec3::new(-1.0, 0.5, 0.0)];
            let list = list.into_iter().chain(axes.into_iter().flat_map(|axis| [axis, -axis]));
            list.map(|normal| Triangle { normal, uv, ..usual }).collect()
        }),
    ]);
    list
}
