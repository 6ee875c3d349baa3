//! Random and hard surface vertices for the ports of embossing units.

use crate::design::{Draw, HardCase, InputPorts, Uniform, Values};
use crate::netlist::{Netlist, NodeId};
use crate::number::format::{Overflow, Round, quantize};
use crate::number::trig::{rotation, sin_cos_turns};
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

/// A vertex as real numbers, for ports of any setting.
#[derive(Clone, Copy, Debug)]
struct Vertex {
    matrix: DMat3,
    tangent: DVec3,
    binormal: DVec3,
    light: DVec3,
    vertex: DVec3,
    coordinates: [f64; 4],
    constants: [f64; 2],
}

impl Vertex {
    /// All numbers, each at its [`Vertex::place`].
    fn numbers(&self) -> [f64; 27] {
        let [m0, m1, m2] = [0, 1, 2].map(|row| self.matrix.row(row));
        let vectors = [m0, m1, m2, self.tangent, self.binormal, self.light, self.vertex];
        let mut all = [0.0; 27];
        for (to, vector) in all.chunks_exact_mut(3).zip(vectors) {
            to.copy_from_slice(&vector.to_array());
        }
        all[21..25].copy_from_slice(&self.coordinates);
        all[25..].copy_from_slice(&self.constants);
        all
    }

    /// Index of an input port's number.
    fn place(port: &str) -> usize {
        let scalars = ["s0", "t0", "r0", "q0", "ks", "kt"];
        if let Some(at) = scalars.iter().position(|name| *name == port) {
            return 21 + at;
        }
        let (name, axis) = port.rsplit_once('_').expect("bug: a component");
        let axis = ["x", "y", "z"].iter().position(|known| *known == axis).expect("bug: an axis");
        let vector = match name {
            "m0" => 0,
            "m1" => 1,
            "m2" => 2,
            "tangent" | "ct" => 3,
            "binormal" | "normal" => 4,
            "light" => 5,
            "vertex" => 6,
            _ => panic!("bug: no port `{port}`"),
        };
        3 * vector + axis
    }

    /// A random vertex. The matrix is a rotation times ½ to 2, reflected for half of them. T and B
    /// are at right angles for half of them; for the others they aren't, and are ¾ to 5/4 long. The
    /// vertex is within 1000 of the eye in each axis, and the light 2^-6 to 2^10 from the vertex,
    /// uniform on a logarithmic scale.
    fn random(uniform: &mut Uniform) -> Self {
        let mut sphere = || {
            let (z, turns) = (1.0 - 2.0 * uniform.draw(), uniform.draw());
            let (sin, cos) = sin_cos_turns(turns);
            let across = (1.0 - z * z).sqrt();
            DVec3::new(across * cos, across * sin, z)
        };
        let (axis, tangent, other, direction) = (sphere(), sphere(), sphere(), sphere());
        let rotation = rotation(axis, uniform.draw());
        let scale = libm::exp2(2.0 * uniform.draw() - 1.0);
        let mirror = if uniform.draw() < 0.5 { DVec3::new(1.0, 1.0, -1.0) } else { DVec3::ONE };
        let right = tangent.cross(other).normalize_or(tangent.any_orthonormal_vector());
        let (mut tangent, mut binormal) = (tangent, right);
        if uniform.draw() < 0.5 {
            binormal = (right + tangent * (1.4 * uniform.draw() - 0.7)).normalize()
                * (0.75 + 0.5 * uniform.draw());
            tangent *= 0.75 + 0.5 * uniform.draw();
        }
        let vertex = DVec3::from_array([(); 3].map(|()| 2000.0 * uniform.draw() - 1000.0));
        let distance = libm::exp2(16.0 * uniform.draw() - 6.0);
        Self {
            matrix: DMat3::from_quat(rotation) * DMat3::from_diagonal(mirror) * scale,
            tangent,
            binormal,
            light: vertex + direction * distance,
            vertex,
            coordinates: [
                32.0 * uniform.draw() - 16.0,
                32.0 * uniform.draw() - 16.0,
                2.0 * uniform.draw() - 1.0,
                0.5 + 1.5 * uniform.draw(),
            ],
            constants: [2.0 * uniform.draw() - 1.0, 2.0 * uniform.draw() - 1.0],
        }
    }
}

/// Fills ports with random vertices.
pub(super) fn draw(_: &Values, ports: &InputPorts<'_>) -> Draw {
    let places: Vec<usize> = ports.names().map(Vertex::place).collect();
    Draw::new(move |_, uniform, columns, count| {
        columns.iter_mut().for_each(Vec::clear);
        for _ in 0..count {
            let numbers = Vertex::random(uniform).numbers();
            for (column, place) in columns.iter_mut().zip(&places) {
                column.push(numbers[*place]);
            }
        }
    })
}

/// The named hard cases of a unit with the ports of vertices.
pub(super) fn hard_cases(netlist: &Netlist) -> Vec<HardCase> {
    let words = |vertex: &Vertex| -> Vec<i64> {
        let numbers = vertex.numbers();
        let word = |(port, id): (usize, &NodeId)| {
            let value = numbers[Vertex::place(netlist.input_name(port))];
            let format = netlist.node(*id).format;
            let word = quantize(value, format, Round::HalfEven, Overflow::Saturate);
            word.expect("bug: vertices are finite").0
        };
        netlist.inputs().iter().enumerate().map(word).collect()
    };
    let cases = |name, list: Vec<Vertex>| HardCase::new(name, list.iter().map(words).collect());
    let ulp = |name: &str| {
        let port = (0..netlist.inputs().len()).find(|port| netlist.input_name(*port) == name);
        port.map(|port| netlist.node(netlist.inputs()[port]).format.ulp())
    };
    let far = 1e9; // past every position
    let turn = DMat3::from_quat(rotation(DVec3::new(0.6, 0.0, 0.8), 1.0 / TAU));
    let vertex = Vertex {
        matrix: turn,
        tangent: DVec3::new(0.48, 0.6, 0.64),
        binormal: DVec3::new(0.8, 0.0, -0.6),
        light: DVec3::new(3.0, -2.0, 5.0),
        vertex: DVec3::new(-1.0, 4.0, 0.5),
        coordinates: [0.25, 0.75, 0.0, 1.0],
        constants: [1.0 / 256.0, 1.0 / 128.0],
    };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut list = Vec::new();
    if let Some(lsb) = ulp("light_x") {
        let places = [DVec3::ZERO, vertex.vertex, DVec3::splat(far), DVec3::splat(-far)];
        let at = |light: DVec3, place: DVec3| Vertex { light, vertex: place, ..vertex };
        list.push(cases("L = 0", places.map(|place| at(place, place)).to_vec()));
        let short = axes.iter().flat_map(|axis| [*axis * lsb, -*axis * lsb]);
        list.push(cases(
            "L one LSB long",
            short.map(|l| at(vertex.vertex + l, vertex.vertex)).collect(),
        ));
        let corners = (0..8).map(|bits| {
            DVec3::from_array([0, 1, 2].map(|axis| if bits >> axis & 1 == 0 { far } else { -far }))
        });
        list.push(cases("the longest L", corners.map(|corner| at(corner, -corner)).collect()));
        let uneven = axes.iter().flat_map(|axis| {
            let tiny = (DVec3::ONE - *axis) * lsb;
            [at(*axis * far + tiny, DVec3::ZERO), at(-*axis * far - tiny, DVec3::ZERO)]
        });
        list.push(cases("L with one huge and two tiny components", uneven.collect()));
        let distances = (-6..=10).map(|k| libm::exp2(k.into()));
        let direction = DVec3::new(0.48, -0.6, 0.64);
        list.push(cases(
            "lights from 2^-6 to 2^10 away",
            distances.map(|d| at(vertex.vertex + direction * d, vertex.vertex)).collect(),
        ));
        let mirror = DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0));
        let matrices = [0.0, 0.5, 1.0, 2.0].map(|scale| turn * scale);
        let matrices = matrices.into_iter().chain([
            turn * mirror,
            mirror * 2.0,
            DMat3::from_diagonal(DVec3::new(0.5, 2.0, 1.0)),
        ]);
        list.push(cases(
            "matrix scaled by 0, ½, 1, 2, unevenly, and reflected",
            matrices.map(|matrix| Vertex { matrix, ..vertex }).collect(),
        ));
        let ends = [(far, far), (-far, far), (far, -far), (-far, -far)];
        let at_end = |(s, t): (f64, f64)| {
            [vertex.light, -vertex.light].map(|light| Vertex {
                coordinates: [s, t, s, t],
                light,
                ..vertex
            })
        };
        list.push(cases(
            "S0, T0 and q at the ends of their range",
            ends.into_iter().flat_map(at_end).collect(),
        ));
    }
    let lsb = ulp("tangent_x").or_else(|| ulp("ct_x")).expect("bug: one of T and CT is there");
    let parallel = |binormal: DVec3| Vertex { binormal, ..vertex };
    let t = vertex.tangent;
    list.push(cases(
        "T parallel to B, or N to CT",
        [t, -t, t * 2.0, t * 0.5].map(parallel).to_vec(),
    ));
    list.push(cases(
        "T parallel to B, or N to CT, but for one LSB",
        axes.iter().flat_map(|axis| [t + *axis * lsb, t - *axis * lsb]).map(parallel).collect(),
    ));
    list.push(cases(
        "T or B, N or CT 0, along axes, or of one LSB",
        [DVec3::ZERO, DVec3::X, DVec3::NEG_Z, DVec3::Y * lsb, DVec3::ONE * lsb]
            .into_iter()
            .flat_map(|v| [Vertex { tangent: v, ..vertex }, Vertex { binormal: v, ..vertex }])
            .collect(),
    ));
    list.push(cases(
        "T, B exchanged",
        vec![vertex, Vertex { tangent: vertex.binormal, binormal: vertex.tangent, ..vertex }],
    ));
    list
}
