//! A shading point as real numbers, and the value of each input port of a shading unit at that
//! point.
//!
//! Ports are identified by name, so a front end can feed any unit with some of these ports:
//!
//! - `phi_V`, `theta_V` and `V_x`, `V_y`, `V_z` for a vector V in polar or Cartesian form: `l`
//!   the light, `h` the halfway vector, `n` the normal, `t` the tangent, `b` the binormal N × T,
//!   all in the world; `lt`, `ht` the first two in the texture frame (T, B, N); `p` the perturbed
//!   normal in the texture frame;
//! - `psi`: the angle about N from the frame of N's own polar form (T along growing theta, B along
//!   growing phi) to the texture frame.
//!
//! Angles are in turns. At a pole phi is 0, and psi is measured accordingly.

use crate::base::simd::{Body, vectorised};
use crate::design::{Draw, HardCase, InputPorts, Sampler, Uniform, Values};
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::number::format::{Overflow, Round, quantize};
use crate::number::trig;
use glam::DVec3;

/// A shading point, with unit vectors.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Fragment {
    /// The surface normal in the world.
    pub normal: DVec3,
    /// The direction in which the texture's u grows, at a right angle to the normal.
    pub tangent: DVec3,
    /// The direction to the light in the world.
    pub light: DVec3,
    /// The direction halfway between light and eye in the world.
    pub half: DVec3,
    /// The perturbed normal in the frame (T, N × T, N).
    pub perturbed: DVec3,
}

/// Azimuth and polar angle in turns, 0 to 1 and 0 to ½.
#[inline(always)]
#[must_use]
pub fn polar(v: DVec3) -> (f64, f64) {
    let across = v.x * v.x + v.y * v.y;
    // On a pole phi is 0, even where atan2 would distinguish zeros by their sign.
    let phi = if across == 0.0 { 0.0 } else { trig::atan2_turns(v.y, v.x) };
    (if phi < 0.0 { phi + 1.0 } else { phi }, trig::atan2_turns(across.sqrt(), v.z))
}

/// The vectors of a fragment.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Vector {
    Light,
    Half,
    Normal,
    Tangent,
    Binormal,
    LightInFrame,
    HalfInFrame,
    Perturbed,
}

/// The value of a fragment that an input port of a shading unit receives.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Port(Kind);

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Kind {
    Psi,
    Phi(Vector),
    Theta(Vector),
    Component(Vector, usize),
}

impl Port {
    /// The port with this name; `None` if the name is unknown here.
    #[must_use]
    pub fn of(name: &str) -> Option<Self> {
        let vector = |name: &str| match name {
            "l" => Some(Vector::Light),
            "h" => Some(Vector::Half),
            "n" => Some(Vector::Normal),
            "t" => Some(Vector::Tangent),
            "b" => Some(Vector::Binormal),
            "lt" => Some(Vector::LightInFrame),
            "ht" => Some(Vector::HalfInFrame),
            "p" => Some(Vector::Perturbed),
            _ => None,
        };
        let kind = match name.rsplit_once('_') {
            None if name == "psi" => Some(Kind::Psi),
            Some(("phi", v)) => vector(v).map(Kind::Phi),
            Some(("theta", v)) => vector(v).map(Kind::Theta),
            Some((v, "x")) => vector(v).map(|v| Kind::Component(v, 0)),
            Some((v, "y")) => vector(v).map(|v| Kind::Component(v, 1)),
            Some((v, "z")) => vector(v).map(|v| Kind::Component(v, 2)),
            Some(_) | None => None,
        };
        kind.map(Self)
    }
}

impl Port {
    /// The port's values for many fragments; `to` is overwritten.
    pub fn column(self, fragments: &[Fragment], to: &mut Vec<f64>) {
        to.clear();
        let (Kind::Phi(vector) | Kind::Theta(vector)) = self.0 else {
            to.extend(fragments.iter().map(|fragment| fragment.value(self)));
            return;
        };
        to.resize(fragments.len(), 0.0);
        let is_phi = matches!(self.0, Kind::Phi(_));
        let mut vectors = [DVec3::ZERO; BLOCK];
        for (to, fragments) in to.chunks_mut(BLOCK).zip(fragments.chunks(BLOCK)) {
            for (v, fragment) in vectors.iter_mut().zip(fragments) {
                *v = fragment.vector(vector);
            }
            vectorised(Polar { vectors: &vectors[..to.len()], is_phi, to });
        }
    }
}

/// Number of fragments whose polar forms are computed at once.
const BLOCK: usize = 256;

/// Azimuths or polar angles of vectors.
struct Polar<'a> {
    vectors: &'a [DVec3],
    is_phi: bool,
    to: &'a mut [f64],
}

impl Body for Polar<'_> {
    #[inline(always)]
    fn run(self) {
        let pairs = self.to.iter_mut().zip(self.vectors);
        if self.is_phi {
            for (to, v) in pairs {
                *to = polar(*v).0;
            }
        } else {
            for (to, v) in pairs {
                *to = polar(*v).1;
            }
        }
    }
}

impl Fragment {
    /// Value of an input port.
    #[must_use]
    pub fn value(&self, port: Port) -> f64 {
        match port.0 {
            Kind::Psi => self.psi(),
            Kind::Phi(v) => polar(self.vector(v)).0,
            Kind::Theta(v) => polar(self.vector(v)).1,
            Kind::Component(v, axis) => self.vector(v)[axis],
        }
    }

    fn vector(&self, vector: Vector) -> DVec3 {
        let binormal = || self.normal.cross(self.tangent);
        let in_frame =
            |v: DVec3| DVec3::new(v.dot(self.tangent), v.dot(binormal()), v.dot(self.normal));
        match vector {
            Vector::Light => self.light,
            Vector::Half => self.half,
            Vector::Normal => self.normal,
            Vector::Tangent => self.tangent,
            Vector::Binormal => binormal(),
            Vector::LightInFrame => in_frame(self.light),
            Vector::HalfInFrame => in_frame(self.half),
            Vector::Perturbed => self.perturbed,
        }
    }

    fn psi(&self) -> f64 {
        let n = self.normal;
        let across = (n.x * n.x + n.y * n.y).sqrt();
        let (cos, sin) = if across == 0.0 { (1.0, 0.0) } else { (n.x / across, n.y / across) };
        let along_theta = DVec3::new(n.z * cos, n.z * sin, -across);
        let along_phi = DVec3::new(-sin, cos, 0.0);
        let turns = trig::atan2_turns(self.tangent.dot(along_phi), self.tangent.dot(along_theta));
        if turns < 0.0 { turns + 1.0 } else { turns }
    }

    /// A random fragment. N, T and the vector to the eye are uniform, with the eye in front of the
    /// surface. With `lit` the light is in front of it too. Slopes of the perturbed normal are
    /// uniform in ±1.
    fn random(lit: bool, uniform: &mut Uniform) -> Self {
        let mut sphere = || {
            let (z, turns) = (1.0 - 2.0 * uniform.draw(), uniform.draw());
            let (sin, cos) = trig::sin_cos_turns(turns);
            let across = (1.0 - z * z).sqrt();
            DVec3::new(across * cos, across * sin, z)
        };
        let before = |v: DVec3, n: DVec3| if v.dot(n) < 0.0 { -v } else { v };
        let (normal, other, light, eye) = (sphere(), sphere(), sphere(), sphere());
        let light = if lit { before(light, normal) } else { light };
        let eye = before(eye, normal);
        // Parallel or opposite vectors are as improbable as two equal floats.
        let tangent = normal.cross(other).normalize_or(normal.any_orthonormal_vector());
        let slopes = [2.0 * uniform.draw() - 1.0, 2.0 * uniform.draw() - 1.0];
        Self {
            normal,
            tangent,
            light,
            half: (light + eye).normalize_or(normal),
            perturbed: DVec3::new(slopes[0], slopes[1], 1.0).normalize(),
        }
    }
}

/// Fills the input ports of a shading unit with random shading points.
///
/// # Panics
/// If a port's name is unknown here, which is a bug.
pub(crate) fn draw(_: &Values, ports: &InputPorts<'_>) -> Draw {
    let port = |name| Port::of(name).expect("bug: ports of shading units are those of fragments");
    let ports: Vec<Port> = ports.names().map(port).collect();
    Draw::new(move |sampler, uniform, columns, count| {
        let lit = sampler == Sampler::Lit;
        let fragments: Vec<Fragment> = (0..count).map(|_| Fragment::random(lit, uniform)).collect();
        for (port, column) in ports.iter().zip(columns) {
            port.column(&fragments, column);
        }
    })
}

/// The named hard cases of a unit whose ports are those of fragments.
///
/// # Panics
/// If a port's name is unknown here, which is a bug.
pub(crate) fn hard_cases(netlist: &Netlist) -> Vec<HardCase> {
    let words = |fragment: &Fragment| -> Vec<i64> {
        let word = |(port, id): (usize, &NodeId)| {
            let node = netlist.node(*id);
            let port = Port::of(netlist.input_name(port)).expect("bug: a fragment's port");
            let value = fragment.value(port);
            let overflow = match node.quantity {
                Quantity::Turns => Overflow::Wrap,
                Quantity::Number | Quantity::Float20 => Overflow::Saturate,
            };
            let word = quantize(value, node.format, Round::HalfEven, overflow);
            word.expect("bug: fragments are finite").0
        };
        netlist.inputs().iter().enumerate().map(word).collect()
    };
    let cases = |name, list: Vec<Fragment>| HardCase::new(name, list.iter().map(words).collect());
    let unit = |x: f64, y: f64, z: f64| DVec3::new(x, y, z).normalize();
    let tiny = 2f64.powi(-10);
    let poles = [DVec3::Z, DVec3::NEG_Z, unit(tiny, 0.0, 1.0), unit(tiny, -tiny, -1.0)];
    let normals = [DVec3::X, DVec3::NEG_Y, unit(1.0, 2.0, 2.0), unit(-1.0, 1e-3, -1.0)];
    let bumps = [DVec3::Z, unit(0.3, -0.2, 1.0), unit(-1.0, 1.0, 1.0), unit(1.0, tiny, tiny)];
    let (mut at_poles, mut seam, mut facing, mut opposite, mut grazing, mut edge, mut short) =
        (vec![], vec![], vec![], vec![], vec![], vec![], vec![]);
    for normal in poles.into_iter().chain(normals) {
        for around in [DVec3::new(0.6, 0.8, 0.1), DVec3::new(-0.8, 0.1, 0.6)] {
            let tangent = normal.cross(around).normalize();
            let binormal = normal.cross(tangent);
            for perturbed in bumps {
                let lit = |light: DVec3, half: DVec3| Fragment {
                    normal,
                    tangent,
                    light: light.normalize(),
                    half: half.normalize(),
                    perturbed,
                };
                let bump = tangent * perturbed.x + binormal * perturbed.y + normal * perturbed.z;
                let across = bump.any_orthonormal_vector();
                let off = |v: DVec3, by: DVec3| [v, v + by * tiny, v - by * tiny];
                at_poles.extend(poles.map(|pole| lit(pole, normal)));
                seam.push(lit(unit(1.0, tiny / 64.0, 1.0), unit(1.0, -tiny / 64.0, 1.0)));
                seam.push(lit(unit(-1.0, -tiny / 64.0, 0.5), unit(-1.0, tiny / 64.0, 0.5)));
                facing.extend(off(bump, across).map(|v| lit(v, v)));
                facing.extend(off(normal, tangent).map(|v| lit(v, v)));
                opposite.extend(off(-bump, across).map(|v| lit(v, v)));
                opposite.extend(off(-normal, binormal).map(|v| lit(v, v)));
                grazing.extend(off(tangent, normal).map(|v| lit(v, v)));
                grazing.extend(off(binormal, normal).map(|v| lit(v, v)));
                edge.extend(off(across, bump).map(|v| lit(v, v)));
                // Vectors as shortened by interpolation between vertices.
                let full = lit(bump + across, bump);
                short.push(Fragment { light: full.light * 0.75, half: full.half * 0.6, ..full });
                short.push(Fragment { perturbed: perturbed * 0.6, ..full });
            }
        }
    }
    vec![
        cases("poles: N or L along z, and one word off", at_poles),
        cases("phi wrap: L and H on both sides of the seam", seam),
        cases("A parallel to N' or N: dot product at 1, and just off", facing),
        cases("A opposite to N' or N: dot product at -1, and just off", opposite),
        cases("grazing light: N·A at 0, just below and just above", grazing),
        cases("dot product N'·A at 0, just below and just above", edge),
        cases("vectors shorter than 1, as after interpolation", short),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn random(count: usize) -> Vec<Fragment> {
        let mut uniform = Uniform::new(1);
        (0..count).map(|_| Fragment::random(true, &mut uniform)).collect()
    }

    /// Rotating by -phi_n about z, -theta_n about y and -psi about z maps T, B, N to x, y, z.
    #[test]
    fn psi_completes_the_polar_rotation_to_the_texture_frame() {
        let mut all = random(200);
        let poles = [(-0.0, 0.0, 1.0), (-0.0, -0.0, 1.0), (0.0, -0.0, -1.0), (-0.0, 0.0, -1.0)];
        let poles = poles.map(DVec3::from);
        for normal in [DVec3::Z, DVec3::NEG_Z, DVec3::X].into_iter().chain(poles) {
            for tangent in [DVec3::Y, DVec3::new(0.0, -0.6, 0.8), DVec3::new(0.8, 0.6, 0.0)] {
                let tangent = (tangent - normal * tangent.dot(normal)).normalize();
                all.push(Fragment { normal, tangent, ..all[0] });
            }
        }
        for fragment in all {
            let port = |name| fragment.value(Port::of(name).unwrap()) * TAU;
            let turn = glam::DMat3::from_rotation_z(-port("psi"))
                * glam::DMat3::from_rotation_y(-port("theta_n"))
                * glam::DMat3::from_rotation_z(-port("phi_n"));
            let binormal = fragment.normal.cross(fragment.tangent);
            for (v, axis) in
                [(fragment.tangent, DVec3::X), (binormal, DVec3::Y), (fragment.normal, DVec3::Z)]
            {
                assert!((turn * v - axis).length() < 1e-12, "{fragment:?}: {}", turn * v);
            }
            let lt = ["lt_x", "lt_y", "lt_z"].map(|name| fragment.value(Port::of(name).unwrap()));
            assert!((turn * fragment.light - DVec3::from(lt)).length() < 1e-12);
        }
    }

    #[test]
    fn names_that_mean_nothing() {
        for name in ["", "x", "l", "l_w", "phi", "phi_q", "q_x", "psi_n"] {
            assert_eq!(Port::of(name), None, "{name}");
        }
    }
}
