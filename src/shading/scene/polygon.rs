//! Polygons as triangles.
//!
//! A strictly convex polygon becomes a fan from its first corner. All others are cut by ear
//! clipping (crate `earcut`), after a projection along Newell's normal: the sum of the cross
//! products around the polygon, which is also defined for a polygon that isn't quite planar
//! (Sutherland, Sproull and Schumacker, "A characterization of ten hidden-surface algorithms",
//! 1974). A polygon that crosses itself, or goes around twice, has no inside and is an error. It
//! may touch itself, like one that leads to its hole and back. A polygon that crosses itself only
//! by rounding, or that goes out and back, has no area.

use super::assembly::{Topology, is_area};
use crate::base::cast;
use earcut::Earcut;
use glam::{DVec2, DVec3};

/// The most corners of a polygon that isn't convex: its edges are compared in pairs.
const MOST: usize = 4096;
/// The most pairs of edges of a file's nonconvex polygons: about ten seconds of work.
const MOST_PAIRS: u64 = 1 << 32;
/// How far corners may be across an edge, relative to the polygon's size: files have six or seven
/// digits.
const TOUCH: f64 = 1e-6;

/// Cuts the polygons of a file.
pub(super) struct Cutter {
    /// Number of edge pairs that may still be compared.
    left: u64,
}

impl Default for Cutter {
    fn default() -> Self {
        Self { left: MOST_PAIRS }
    }
}

impl Cutter {
    /// The triangles of a polygon as a list or a fan of its corners, with its winding; none if it
    /// has no area.
    ///
    /// # Errors
    /// If it crosses itself, or the limits for nonconvex polygons are exceeded.
    pub(super) fn triangles(&mut self, points: &[DVec3]) -> Result<(Topology, Vec<usize>), String> {
        let kept = if points.len() > 3 { around(points) } else { (0..points.len()).collect() };
        let of = |order: Vec<usize>| order.into_iter().map(|at| kept[at]).collect();
        if kept.len() < 3 {
            return Ok((Topology::List, Vec::new()));
        }
        let points: Vec<DVec3> = kept.iter().map(|at| points[*at]).collect();
        let plane = projected(&points);
        if kept.len() == 3 || plane.as_deref().is_some_and(is_convex) {
            return Ok((Topology::Fan, kept));
        }
        let cut = match plane {
            Some(plane) => {
                self.spend(plane.len())?;
                cut(&plane)
            }
            None => None,
        };
        match cut {
            Some(order) => Ok((Topology::List, of(order))),
            None if is_rounded_line(&points) => Ok((Topology::List, Vec::new())),
            None => Err(
                "the polygon crosses itself, so it has no inside: cut it into polygons that don't"
                    .to_owned(),
            ),
        }
    }

    /// Counts the pairs of `edges` edges against the limit.
    fn spend(&mut self, edges: usize) -> Result<(), String> {
        if edges > MOST {
            return Err(format!(
                "a polygon of {edges} corners that isn't convex: legal are up to {MOST} corners; export triangles"
            ));
        }
        self.left = self.left.checked_sub(cast::count_of(edges * edges)).ok_or_else(|| {
            format!(
                "the polygons that aren't convex have more than {MOST_PAIRS} pairs of edges up to here (counted within each polygon), the most that a file may have: export triangles"
            )
        })?;
        Ok(())
    }
}

/// The corners without repetitions of the previous one and without ways out and back.
fn around(points: &[DVec3]) -> Vec<usize> {
    let mut kept: Vec<usize> = Vec::with_capacity(points.len());
    for (corner, point) in points.iter().enumerate() {
        match *kept {
            [.., before] if points[before] == *point => {}
            [.., before, _] if points[before] == *point => {
                kept.pop();
            }
            _ => kept.push(corner),
        }
    }
    // The same across the end of the list.
    let (mut first, mut end) = (0, kept.len());
    while end - first > 2 {
        let at = |place: usize| points[kept[place]];
        if at(end - 1) == at(first) || at(end - 2) == at(first) {
            end -= 1;
        } else if at(end - 1) == at(first + 1) {
            first += 1;
        } else {
            break;
        }
    }
    kept[first..end].to_vec()
}

/// Triangles of the corners; `None` if the polygon crosses itself.
fn cut(plane: &[DVec2]) -> Option<Vec<usize>> {
    if cross(plane) {
        return None;
    }
    let mut corners: Vec<usize> = Vec::new();
    Earcut::new().earcut(plane.iter().map(|at| at.to_array()), &[], &mut corners);
    let rounding = TOUCH * size(plane).powi(2);
    let (mut whole, mut once) = (0.0, true);
    for corners in corners.chunks_exact_mut(3) {
        let [a, b, c] = [corners[0], corners[1], corners[2]].map(|corner| plane[corner]);
        let area = turn(a, b, c);
        whole += area.abs();
        once &= area.abs() <= rounding || times_around(plane, (a + b + c) / 3.0) == 1;
        if area < 0.0 {
            corners.swap(1, 2);
        }
    }
    // A polygon that reverses where it touches itself, or goes around twice, isn't covered exactly
    // once.
    let area: f64 = edges(plane).map(|(_, [a, b])| a.perp_dot(b)).sum();
    (once && (whole - area).abs() <= rounding).then_some(corners)
}

/// How often the polygon goes around a point counter-clockwise: counts the edges that cross the ray
/// to the point's right.
fn times_around(plane: &[DVec2], at: DVec2) -> i32 {
    let crosses = |(_, [a, b]): (usize, [DVec2; 2])| {
        let left = turn(a, b, at) > 0.0;
        match (a.y <= at.y, b.y <= at.y) {
            (true, false) if left => 1,
            (false, true) if !left => -1,
            _ => 0,
        }
    };
    edges(plane).map(crosses).sum()
}

/// The corners projected along the normal, seen from the side on which they run counter-clockwise,
/// relative to the first corner. `None` if there is no such side.
fn projected(points: &[DVec3]) -> Option<Vec<DVec2>> {
    let from_first: Vec<DVec3> = points.iter().map(|point| point - points[0]).collect();
    let next = from_first.iter().cycle().skip(1);
    let normal: DVec3 = from_first.iter().zip(next).map(|(a, b)| a.cross(*b)).sum();
    let size = from_first.iter().map(|point| point.length_squared()).fold(0.0, f64::max);
    if !is_area(normal.length(), size) {
        return None;
    }
    let (x, y) = normal.normalize().any_orthonormal_pair();
    Some(from_first.iter().map(|point| DVec2::new(point.dot(x), point.dot(y))).collect())
}

/// True if all points are on one line, up to the digits that a file stores for such coordinates.
fn is_rounded_line(points: &[DVec3]) -> bool {
    let to = |point: &DVec3| point - points[0];
    let far =
        points.iter().map(to).max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let far = far.expect("bug: a polygon has corners");
    let largest = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    points.iter().all(|point| to(point).cross(far).length() <= TOUCH * largest * far.length())
}

/// The largest distance of a corner from the first.
fn size(plane: &[DVec2]) -> f64 {
    plane.iter().map(|at| at.length()).fold(0.0, f64::max)
}

/// Positive if c is to the left of the line from a to b.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The edges, with the number of their first corner.
fn edges(plane: &[DVec2]) -> impl Iterator<Item = (usize, [DVec2; 2])> + '_ {
    let next = plane.iter().cycle().skip(1);
    plane.iter().zip(next).map(|(a, b)| [*a, *b]).enumerate()
}

/// True if every corner turns left and the polygon goes around once.
fn is_convex(plane: &[DVec2]) -> bool {
    let ahead = |(i, [a, b]): (usize, [DVec2; 2])| {
        let c = plane[(i + 2) % plane.len()];
        let longest = a.distance_squared(b).max(b.distance_squared(c));
        turn(a, b, c) > TOUCH * longest
    };
    // In one turn, x rises in one run and falls in another.
    let grows: Vec<bool> = edges(plane).map(|(_, [a, b])| b.x > a.x).collect();
    let turns = (0..grows.len()).filter(|i| grows[*i] != grows[(i + 1) % grows.len()]).count();
    edges(plane).all(ahead) && turns == 2
}

/// True if two edges cross between their ends.
fn cross(plane: &[DVec2]) -> bool {
    let size = size(plane);
    let mut sorted: Vec<[DVec2; 2]> = edges(plane).map(|(_, edge)| edge).collect();
    sorted.sort_unstable_by(|[a, b], [c, d]| a.x.min(b.x).total_cmp(&c.x.min(d.x)));
    // The ends of one edge are on opposite sides of the other's line, by signed distance.
    let parted = |[a, b]: [DVec2; 2], [c, d]: [DVec2; 2]| {
        let length = a.distance(b);
        let [c, d] = [c, d].map(|end| turn(a, b, end));
        c.min(d) < -TOUCH * size * length && c.max(d) > TOUCH * size * length
    };
    sorted.iter().enumerate().any(|(i, edge)| {
        let end = edge[0].x.max(edge[1].x);
        let beside = sorted[i + 1..].iter().take_while(|other| other[0].x.min(other[1].x) <= end);
        beside.into_iter().any(|other| parted(*edge, *other) && parted(*other, *edge))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_core::{RngCore, SeedableRng};

    fn flat(points: &[[f64; 2]]) -> Vec<DVec3> {
        points.iter().map(|[x, y]| DVec3::new(*x, *y, 0.0)).collect()
    }

    fn triangles(points: &[DVec3]) -> Result<(Topology, Vec<usize>), String> {
        Cutter::default().triangles(points)
    }

    /// Twice the area that the corners go around.
    fn area(points: &[DVec3]) -> f64 {
        points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.cross(*b).z).sum()
    }

    fn cut(points: &[DVec3]) -> Vec<[usize; 3]> {
        let (topology, order) = triangles(points).unwrap();
        let count = topology.triangles(order.len()).unwrap();
        (0..count).map(|i| topology.corners(i).map(|at| order[at])).collect()
    }

    fn areas(points: &[DVec3]) -> Vec<f64> {
        let area =
            |[a, b, c]: &[usize; 3]| (points[*b] - points[*a]).cross(points[*c] - points[*a]).z;
        cut(points).iter().map(area).collect()
    }

    /// Stars of random radii about the origin. Triangles of a polygon's corners that all turn left
    /// cover each point as often as the polygon goes around it: here, once.
    #[test]
    fn triangles_cover_the_polygon_once_from_any_corner() {
        let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(12);
        let mut real = || f64::from(random.next_u32()) / f64::from(u32::MAX);
        for corners in [4, 5, 6, 9, 20, 150] {
            let star: Vec<DVec3> = (0..corners)
                .map(|i| {
                    let angle = f64::from(i) / f64::from(corners) * std::f64::consts::TAU;
                    DVec3::new(angle.cos(), angle.sin(), 0.0) * (0.2 + real())
                })
                .collect();
            for first in 0..star.len() {
                let mut turned = star.clone();
                turned.rotate_left(first);
                let areas = areas(&turned);
                assert_eq!(areas.len(), star.len() - 2);
                assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
                assert!((areas.iter().sum::<f64>() - area(&star)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_polygon_in_space_turns_as_it_did() {
        // An arrow whose notch is its first corner, in several orientations.
        let arrow = flat(&[[0.0, 0.25], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]);
        for axes in [
            [DVec3::X, DVec3::Y],
            [DVec3::Y, DVec3::Z],
            [DVec3::Z, DVec3::X],
            [DVec3::X, DVec3::NEG_Y],
            [DVec3::new(1.0, 2.0, 3.0), DVec3::new(-3.0, 1.0, 2.0)],
        ] {
            let stood: Vec<DVec3> =
                arrow.iter().map(|at| at.x * axes[0] + at.y * axes[1] + DVec3::ONE).collect();
            let normal = axes[0].cross(axes[1]);
            let triangles = cut(&stood);
            assert_eq!(triangles.len(), 2);
            for [a, b, c] in triangles {
                let own = (stood[b] - stood[a]).cross(stood[c] - stood[a]);
                assert!(own.dot(normal) > 0.0, "{a} {b} {c}");
                assert!([a, b, c].contains(&0), "both have the notch");
            }
        }
    }

    #[test]
    fn corners_on_edges_stay_corners() {
        // A square with a corner in the middle of each side, starting at each corner in turn.
        let mut square = flat(&[
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [2.0, 1.0],
            [2.0, 2.0],
            [1.0, 2.0],
            [0.0, 2.0],
            [0.0, 1.0],
        ]);
        for _ in 0..8 {
            square.rotate_left(1);
            let areas = areas(&square);
            assert!(areas.len() == 6 && areas.iter().all(|area| *area > 0.0), "{areas:?}");
            assert_eq!(areas.iter().sum::<f64>(), 8.0);
        }
    }

    #[test]
    fn touching_is_legal_and_crossing_is_not() {
        // To a square hole and back by the same path.
        let keyhole = flat(&[
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 3.0],
            [0.0, 3.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
        ]);
        assert!((areas(&keyhole).iter().sum::<f64>() - 16.0).abs() < 1e-12);
        let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 1.0]];
        let even_bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        let pentagram: Vec<[f64; 2]> = (0..5)
            .map(|i| f64::from(i) * 0.8 * std::f64::consts::PI)
            .map(|angle| [angle.cos(), angle.sin()])
            .collect();
        let twice = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        // One half of it is reversed; both halves touch in one corner.
        let over = [[0.0, 0.0], [-2.0, 1.0], [-2.0, -1.0], [0.0, 0.0], [1.0, 1.0], [1.0, -1.0]];
        for crossing in [&bow[..], &even_bow, &pentagram, &twice, &over] {
            let why = triangles(&flat(crossing)).unwrap_err();
            assert!(why.starts_with("the polygon crosses itself"), "{crossing:?}: {why}");
        }
    }

    #[test]
    fn lines_have_no_triangles_and_large_polygons_a_limit() {
        let none = Ok((Topology::List, Vec::new()));
        assert_eq!(triangles(&[DVec3::ONE; 5]), none);
        let line: Vec<DVec3> = (0..6).map(|i| f64::from(i % 4) * DVec3::ONE).collect();
        assert_eq!(triangles(&line), none);
        // Out and back, also across the first corner.
        let back = flat(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.0]]);
        for first in 0..4 {
            let mut turned = back.clone();
            turned.rotate_left(first);
            assert_eq!(triangles(&turned), none, "{first}");
        }
        // Thinner than the seventh digit, to which its corners are rounded across each other. Moved
        // to the origin, where that rounding counts as real, it crosses itself.
        let sliver = [
            [122.9991, 45.00191],
            [122.9903, 45.02151],
            [122.9871, 45.02877],
            [122.9953, 45.0103],
            [122.9972, 45.00608],
            [122.9989, 45.00245],
        ];
        assert_eq!(triangles(&flat(&sliver)), none);
        let moved = sliver.map(|[x, y]| [x - 122.99, y - 45.01]);
        assert!(triangles(&flat(&moved)).is_err());
        let gear = |teeth: i32| -> Vec<DVec3> {
            let tooth = |i: i32| {
                let angle = f64::from(i) / f64::from(teeth) * std::f64::consts::PI;
                DVec3::new(angle.cos(), angle.sin(), 0.0) * f64::from(2 + i % 2)
            };
            (0..2 * teeth).map(tooth).collect()
        };
        assert_eq!(cut(&gear(2048)).len(), 4094);
        let why = triangles(&gear(2049)).unwrap_err();
        assert!(why.starts_with("a polygon of 4098 corners"), "{why}");
        // Repeated corners don't count.
        let many = [vec![gear(2)[0]; 5000], gear(2)].concat();
        assert_eq!(cut(&many).len(), 2);
        let mut cutter = Cutter { left: 20 * 20 + 19 * 19 };
        assert!(cutter.triangles(&gear(10)).is_ok());
        let why = cutter.triangles(&gear(10)).unwrap_err();
        assert!(why.contains("more than 4294967296 pairs of edges"), "{why}");
    }
}
