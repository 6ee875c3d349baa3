//! Golden columns, computed from inputs or from judged nodes.

use crate::design::{Design, Group, Shape};
use crate::number::trig::Real;

/// Converts columns of judged nodes to the golden's columns: directions become x, y, z. It swaps
/// columns of `nodes` for others.
pub(crate) fn as_golden(groups: &[Group], nodes: &mut [Vec<f64>], to: &mut Vec<Vec<f64>>) {
    let columns = groups.iter().map(|group| group.shape.columns().len()).sum();
    to.resize(columns, Vec::new());
    let (mut node, mut column) = (0, 0);
    for group in groups {
        let from = &mut nodes[node..node + group.shape.nodes()];
        let to = &mut to[column..column + group.shape.columns().len()];
        node += from.len();
        column += to.len();
        match group.shape {
            Shape::Cartesian | Shape::Scalar | Shape::Turns | Shape::Scaled { .. } => {
                for (to, from) in to.iter_mut().zip(from) {
                    std::mem::swap(to, from);
                }
            }
            Shape::Polar => {
                let [x, y, z] = to else { panic!("bug: x, y, z") };
                let len = from[0].len();
                [&mut *x, &mut *y, &mut *z].into_iter().for_each(|to| to.resize(len, 0.0));
                f64::sin_cos_turns(&from[0], y, x);
                let mut sin_theta = vec![0.0; len];
                f64::sin_cos_turns(&from[1], &mut sin_theta, z);
                for ((x, y), sin_theta) in x.iter_mut().zip(y).zip(&sin_theta) {
                    *x *= sin_theta;
                    *y *= sin_theta;
                }
            }
        }
    }
}

/// Computes the golden columns of input columns.
pub(crate) fn run_golden(design: &Design, inputs: &[Vec<f64>], to: &mut Vec<Vec<f64>>) {
    let len = inputs.first().map_or(0, Vec::len);
    to.resize(design.golden_columns(), Vec::new());
    for column in to.iter_mut() {
        column.resize(len, 0.0);
    }
    let columns: Vec<&[f64]> = inputs.iter().map(Vec::as_slice).collect();
    design.golden.run(&columns, to);
}
