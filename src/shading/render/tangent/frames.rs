//! Frames from the setup, for bump-mapping pipelines.

use super::known::FramesKnown;
use super::setup::{Corner, Outputs, Setup, flagged};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::Design;
use crate::shading::render::block::{BlockShot, overflows};
use crate::shading::render::named::Stage;
use crate::shading::render::pipeline::{Pipeline, knows};
use crate::shading::scene::{CURVED, Fragments, Scene, SharedVertex};
use crate::units::built_in;
use crate::units::fragment::Fragment;
use glam::DVec3;
use std::sync::Arc;

/// Frames at the corners of a scene's faces, computed by the unit.
pub(in crate::shading::render) struct FaceFrames {
    design: Arc<Design>,
    /// Components of T, B and N of each corner of each face, by column.
    rows: Vec<Vec<f64>>,
    known: FramesKnown,
}

impl FaceFrames {
    /// The pipeline parameters that the frames depend on.
    pub(in crate::shading::render) fn parameters(pipeline: &Pipeline) -> Vec<&String> {
        pipeline.assignments.iter().filter(|set| knows(built_in("tangent"), set)).collect()
    }

    pub(in crate::shading::render) fn new(scene: &Scene, pipeline: &Pipeline) -> Result<Self> {
        scene.demand_uv("the setup of frames")?;
        let of_face =
            |(object, face): (u32, [SharedVertex; 3])| face.map(|corner| (object, corner));
        let corners: Vec<(u32, SharedVertex)> = scene.faces().flat_map(of_face).collect();
        let setup = Setup::new(pipeline, 1, corners.iter().copied())?;
        let corner = |at: usize| {
            let face = &corners[at / 3 * 3..][..3];
            let of = [0, 1, 2].map(|i| face[i].1);
            Corner {
                object: corners[at].0,
                positions: of.map(|vertex| vertex.position),
                uvs: of.map(|vertex| vertex.uv),
                normal: corners[at].1.normal,
                view: DVec3::ZERO,
                lights: [DVec3::ZERO; 8],
            }
        };
        let mut names: Vec<String> = ["t", "b", "n"]
            .iter()
            .flat_map(|row| ["x", "y", "z"].map(|axis| format!("{row}_{axis}")))
            .collect();
        names.extend(["mirrored", "degenerate"].map(str::to_owned));
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut shot = BlockShot::of([&setup.stage.program].into_iter());
        let count = corners.len();
        let Outputs { fixed: mut rows, .. } = setup.run(count, corner, &names, false, &mut shot)?;
        let mut flag = || rows.pop().expect("bug: a flag");
        let (degenerate, mirrored) = (flag(), flag());
        let steps = setup.steps();
        let Stage { design, program } = setup.stage;
        let known = FramesKnown {
            faces: cast::count_of(count / 3),
            mirrored: flagged(mirrored.iter().step_by(3)),
            degenerate: flagged(degenerate.iter()),
            position_step: steps[0],
            uv_step: steps[1],
            overflows: overflows([(&design, &program)].into_iter(), &shot.overflows)?,
        };
        Ok(Self { design, rows, known })
    }

    pub(in crate::shading::render) fn design(&self) -> &Arc<Design> {
        &self.design
    }

    pub(in crate::shading::render) fn known(&self) -> &FramesKnown {
        &self.known
    }

    /// A shading point with the frame of the setup; `None` on a sphere.
    pub(in crate::shading::render) fn frame(
        &self,
        scene: &Scene,
        fragments: &Fragments,
        i: usize,
        point: &Fragment,
    ) -> Option<Fragment> {
        if fragments.primitive[i] == CURVED {
            return None;
        }
        let first = 3 * cast::index_of_u32(fragments.primitive[i]);
        let [s, r] = [0, 1].map(|axis| fragments.weights[axis][i]);
        let weights = [1.0 - s - r, s, r];
        let row = |row: usize| {
            let at = |axis: usize| -> f64 {
                let column = &self.rows[3 * row + axis];
                (0..3).map(|corner| weights[corner] * column[first + corner]).sum()
            };
            DVec3::new(at(0), at(1), at(2))
        };
        let normal = row(2).normalize_or(point.normal);
        let across = row(0) - normal * normal.dot(row(0));
        let tangent = across.normalize_or(normal.any_orthonormal_vector());
        let side = if row(1).dot(normal.cross(tangent)) < 0.0 { -1.0 } else { 1.0 };
        let bump = scene.bumps.vector(fragments.bump[i]);
        let perturbed = DVec3::new(bump.x, bump.y * side, bump.z);
        Some(Fragment { normal, tangent, perturbed, ..*point })
    }
}
