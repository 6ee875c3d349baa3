//! The quantities whose errors are measured.

use super::stream::{Angles, Differences, Lengths};
use crate::base::simd::vectorised;
use crate::design::{Design, Shape};

/// How an error is computed from golden columns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    /// Angle between the directions of three columns.
    Angle,
    /// Length of the difference of three columns.
    Dot,
    /// Difference of one column.
    Number,
    /// Difference modulo a turn, of angles in turns.
    Turns,
    /// Difference of one column, divided by the golden's scale in this column.
    Relative(usize),
    /// Difference of one column in texels of a texture of that size.
    Texels(u32),
}

/// A quantity whose error is measured.
#[derive(Clone, Debug)]
pub(super) struct Measurand {
    pub(super) name: String,
    kind: Kind,
    /// Its first golden column.
    pub(super) column: usize,
    /// Ulp of the node, if the column is a node.
    pub(super) ulp: Option<f64>,
}

impl Measurand {
    pub(super) fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Angle => "rad",
            Kind::Dot | Kind::Number => "1",
            Kind::Turns => "turn",
            Kind::Relative(_) => "rel",
            Kind::Texels(_) => "texel",
        }
    }

    /// True if it represents its group when no bound is stated: the angle of a direction, or a
    /// number itself.
    pub(super) fn counts_unbounded(&self, design: &Design) -> bool {
        let direction = design.groups.iter().any(|group| group.shape.is_direction());
        if direction {
            self.kind == Kind::Angle
        } else {
            matches!(self.kind, Kind::Number | Kind::Turns)
        }
    }

    /// All measurands of a design, in reporting order, which is the same for all designs of a unit.
    pub(super) fn all(design: &Design) -> Vec<Self> {
        let mut all = Vec::new();
        let mut column = 0;
        let mut scale: usize = design.groups.iter().map(|group| group.shape.columns().len()).sum();
        for group in &design.groups {
            let mut names = group.quantities().into_iter();
            let mut add = |kind, column, ulp| {
                let name = names.next().expect("bug: each quantity has a name");
                all.push(Self { name, kind, column, ulp });
            };
            if group.shape.is_direction() {
                add(Kind::Angle, column, None);
                add(Kind::Dot, column, None);
            }
            if let Shape::Scaled { scales, texels } = &group.shape {
                if let Some(texels) = texels {
                    add(Kind::Texels(*texels), column, None);
                }
                for _ in scales {
                    add(Kind::Relative(scale), column, None);
                    scale += 1;
                }
            }
            for i in 0..group.shape.columns().len() {
                let ulp = |i: usize| design.netlist.node(group.nodes[i]).format.ulp();
                let ulp = (group.shape != Shape::Polar).then(|| ulp(i));
                let kind = if group.shape == Shape::Turns { Kind::Turns } else { Kind::Number };
                add(kind, column + i, ulp);
            }
            column += group.shape.columns().len();
        }
        all
    }

    /// Errors of samples; `golden` has the scales.
    pub(super) fn errors(
        &self,
        is: &[Vec<f64>],
        should: &[Vec<f64>],
        golden: &[Vec<f64>],
        errors: &mut Vec<f64>,
    ) {
        errors.resize(is[self.column].len(), 0.0);
        match self.kind {
            Kind::Angle => {
                let (u, v) = (self.three(is), self.three(should));
                vectorised(Angles { u, v, angles: errors });
            }
            Kind::Dot => {
                let (u, v) = (self.three(is), self.three(should));
                vectorised(Lengths { u, v, lengths: errors });
            }
            Kind::Number | Kind::Turns | Kind::Texels(_) | Kind::Relative(_) => {
                let factor =
                    if let Kind::Texels(texels) = self.kind { f64::from(texels) } else { 1.0 };
                let (is, should) = (&is[self.column], &should[self.column]);
                vectorised(Differences { is, should, factor, errors });
            }
        }
        if self.kind == Kind::Turns {
            errors.iter_mut().for_each(|error| *error -= error.round());
        }
        if let Kind::Relative(scale) = self.kind {
            for (error, scale) in errors.iter_mut().zip(&golden[scale]) {
                // 0/0 counts as no error.
                *error = if *error == 0.0 { 0.0 } else { *error / scale };
            }
        }
    }

    /// The three columns of a vector.
    fn three<'a>(&self, columns: &'a [Vec<f64>]) -> [&'a [f64]; 3] {
        [0, 1, 2].map(|axis| columns[self.column + axis].as_slice())
    }
}

/// Names of the angles whose errors are measured, one for each direction.
pub(crate) fn angle_quantities(design: &Design) -> Vec<String> {
    angles(design).map(|measurand| measurand.name).collect()
}

/// The errors of those angles in rad, one column each, from golden columns of samples.
pub(crate) fn angle_errors(design: &Design, is: &[Vec<f64>], should: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let errors = |measurand: Measurand| {
        let mut errors = Vec::new();
        measurand.errors(is, should, should, &mut errors);
        errors
    };
    angles(design).map(errors).collect()
}

fn angles(design: &Design) -> impl Iterator<Item = Measurand> {
    Measurand::all(design).into_iter().filter(|measurand| measurand.kind == Kind::Angle)
}
