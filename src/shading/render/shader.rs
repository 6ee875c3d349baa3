//! A pipeline prepared for the pixels of a scene.

use super::pipeline::{Frames, Pipeline};
use super::tangent::frames::FaceFrames;
use crate::base::error::{Error, Result};
use crate::design::{Design, Reflection, Value};
use crate::netlist::NodeId;
use crate::number::format::Format;
use crate::shading::scene::Scene;
use crate::sim::batch::Program;
use crate::units::fragment::Port;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// A design prepared for shading pixels.
pub(super) struct Stage {
    pub(super) design: Arc<Design>,
    pub(super) program: Program,
    pub(super) ports: Vec<Port>,
    /// The nodes of the rotated light vector among the program's outputs, if it is measured.
    pub(super) vector: Option<Range<usize>>,
    pub(super) has_specular: bool,
    pub(super) light_format: Format,
}

impl Stage {
    fn new(design: Design, vectors: bool) -> Result<Self> {
        let netlist = &design.netlist;
        let mut ports = Vec::new();
        for at in 0..netlist.inputs().len() {
            let name = netlist.input_name(at);
            let none = || Error::usage(format!("a scene has no value for the port `{name}`"));
            ports.push(Port::of(name).ok_or_else(none)?);
        }
        let output = |name: &str| {
            netlist.outputs().iter().find(|output| output.name == name).map(|output| output.node)
        };
        let diffuse = output("diffuse").ok_or_else(|| {
            Error::usage(format!("unit `{}` has no output `diffuse`", design.values.unit().name))
        })?;
        let mut nodes: Vec<NodeId> = vec![diffuse];
        let specular = output("specular");
        nodes.extend(specular);
        let group = design.groups.iter().find(|group| vectors && group.name == "lt");
        let vector = group.map(|group| nodes.len()..nodes.len() + group.nodes.len());
        nodes.extend(group.iter().flat_map(|group| group.nodes.iter().copied()));
        let program = Program::compile(netlist, &nodes);
        let light_format = netlist.node(diffuse).format;
        let (design, has_specular) = (Arc::new(design), specular.is_some());
        Ok(Self { program, ports, vector, has_specular, light_format, design })
    }

    /// True unless its specular light is 0 everywhere.
    pub(super) fn needs_specular(&self) -> bool {
        let specular = self.design.values.reflection(Reflection::Specular);
        let dark = matches!(specular, Some(Value::Real(number)) if number.get() <= 0.0);
        self.has_specular && !dark
    }
}

/// A pipeline prepared for shading the pixels of a scene: all its designs.
pub struct Shader {
    pub(super) pipeline: Pipeline,
    pub(super) stages: Vec<Stage>,
    /// Stage by material and light.
    pub(super) of: Vec<Vec<usize>>,
    /// Its own texture frames, if they are set up by the unit.
    pub(super) frames: Option<Arc<FaceFrames>>,
}

impl Shader {
    /// The pipeline on a scene; `vectors` also measures the rotated light vectors.
    ///
    /// # Errors
    /// If the pipeline can't be built with its parameters, or lacks a port.
    pub fn new(scene: &Scene, pipeline: &Pipeline, vectors: bool) -> Result<Self> {
        Self::with_stages(scene, pipeline, vectors, true, true)
    }

    /// As [`Shader::new`]. Unless `shared`, each material has its own stage under each light, even
    /// if two have equal designs. Unless `framed`, the caller sets the frames.
    pub(super) fn with_stages(
        scene: &Scene,
        pipeline: &Pipeline,
        vectors: bool,
        shared: bool,
        framed: bool,
    ) -> Result<Self> {
        let mut known: BTreeMap<Vec<Value>, usize> = BTreeMap::new();
        let mut stages = Vec::new();
        let mut of = Vec::new();
        for material in &scene.materials {
            let mut row = Vec::new();
            for (number, light) in scene.lights.iter().enumerate() {
                let ambient = if number == 0 { scene.ambient * material.ambient } else { 0.0 };
                let design = pipeline.design(ambient, light, material)?;
                let key: Vec<Value> =
                    design.values.iter().map(|(_, value)| value.clone()).collect();
                let index = match known.get(&key) {
                    Some(index) if shared => *index,
                    Some(_) | None => {
                        stages.push(Stage::new(design, vectors)?);
                        known.insert(key, stages.len() - 1);
                        stages.len() - 1
                    }
                };
                row.push(index);
            }
            of.push(row);
        }
        let frames = match pipeline.frames {
            Frames::Setup if framed => Some(Arc::new(FaceFrames::new(scene, pipeline)?)),
            Frames::Float | Frames::Setup => None,
        };
        Ok(Self { pipeline: pipeline.clone(), stages, of, frames })
    }

    /// One of its designs: that of the first material under the first light. The others differ in
    /// the contents of the light tables.
    #[must_use]
    pub fn design(&self) -> &Arc<Design> {
        &self.stages[0].design
    }

    /// The first material and light that use a stage.
    pub(super) fn first_use(&self, stage: usize) -> (usize, usize) {
        let uses = self.of.iter().enumerate().flat_map(|(material, row)| {
            row.iter().enumerate().map(move |(light, index)| (material, light, *index))
        });
        let first = uses.into_iter().find(|(_, _, index)| *index == stage);
        first.map(|(material, light, _)| (material, light)).expect("bug: every stage is used")
    }
}
