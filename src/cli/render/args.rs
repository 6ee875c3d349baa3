//! Arguments: a scene, pipelines, a folder.

use crate::base::error::{Error, Result};
use crate::cli::number;
use crate::shading::picture::{PIXELS_PER_DEGREE, check_pixels_per_degree};
use crate::shading::render::{EMBOSS_PIPELINES, Frames, Pipeline, check_view};
use crate::shading::scene::Scene;
use clap::Args;
use std::path::{Path, PathBuf};

/// The default pipelines of a picture.
const PIPELINES: [&str; 4] = ["printed", "corrected", "exact-polar", "exact-cartesian"];

/// Arguments of `fixpath render`.
#[derive(Args)]
pub(in crate::cli) struct RenderArgs {
    /// Scene file, or a built-in scene: plane, cube, sphere, lettering-raised, lettering-lowered,
    /// brick, light-orbit, mirrored.
    pub(super) scene: PathBuf,
    /// Folder to write; pictures that an earlier run wrote there are removed.
    #[arg(long, value_name = "DIR")]
    pub(super) out: PathBuf,
    /// Pipelines to compare. Those that shade bumps: printed, corrected, exact-polar,
    /// exact-cartesian (settings of the unit bump), ernst, kim, kugler. Those that emboss:
    /// emboss-gx, emboss-nv; they have their own golden and need a folder of their own. Those that
    /// set up triangles and light them in texture space: tangent-smooth, tangent-faceted; their
    /// difference is reported in two parts. Default: those that emboss for a scene with an
    /// [emboss] section; for a ladder, all that shade bumps; otherwise the first four.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub(super) pipelines: Vec<String>,
    /// Set a parameter of every pipeline that has it. Material parameters come from the scene.
    #[arg(short = 'p', long = "param", value_name = "KEY=VALUE")]
    params: Vec<String>,
    /// Source of texture frames. float: computed for each pixel. setup: by the fixed-point unit
    /// tangent, for each corner of planes, cubes and meshes; -p then also sets its parameters.
    #[arg(long, value_name = "SOURCE", default_value = "float", value_parser = ["float", "setup"])]
    pub(super) frames: String,
    /// Pixels per degree of visual angle, for FLIP.
    #[arg(long, value_name = "X", default_value_t = PIXELS_PER_DEGREE, allow_negative_numbers = true, value_parser = number::real)]
    pub(super) pixels_per_degree: f64,
    /// Specialise each pipeline to what the scene needs, compare it with the general one on every
    /// pixel, and report what that saves.
    #[arg(long)]
    pub(super) specialise: bool,
    /// Instead of pictures, write a report of error against cost and speed: the pipelines that
    /// shade bumps over a ladder of widths w, with direct tables of 2^(w-2) entries, and their
    /// light tables over exponents; or the pipelines that emboss, one parameter at a time. Widths
    /// are 4 to 22 bits (24 to emboss), written with =, as in --ladder=8,12; default 8,10,12,14,16.
    #[arg(long, value_name = "BITS,…", conflicts_with = "specialise", num_args = 0..=1, require_equals = true, default_missing_value = "")]
    pub(super) ladder: Option<String>,
    /// Highlight exponents at which the ladder judges the light tables; default 1,8,32,128,255.
    #[arg(long, value_name = "N,…", requires = "ladder")]
    pub(super) exponents: Option<String>,
    /// As JSON.
    #[arg(long)]
    pub(super) json: bool,
}

impl RenderArgs {
    /// A built-in scene with the given pipelines, or the default ones if none are named.
    pub(in crate::cli) fn of_builtin(name: &str, pipelines: &[&str], out: &Path) -> Self {
        Self {
            scene: name.into(),
            out: out.to_owned(),
            pipelines: pipelines.iter().map(|&name| name.to_owned()).collect(),
            params: Vec::new(),
            frames: "float".to_owned(),
            pixels_per_degree: PIXELS_PER_DEGREE,
            specialise: false,
            ladder: None,
            exponents: None,
            json: false,
        }
    }
}

/// The requested pipelines, with their parameters.
pub(super) fn pipelines_of(args: &RenderArgs, scene: &Scene) -> Result<Vec<Pipeline>> {
    let mut pipelines = Vec::new();
    let names: Vec<&str> = match (&args.pipelines[..], &args.ladder) {
        ([], _) if scene.emboss.asked && args.specialise => {
            let text = format!(
                "--specialise is for pipelines that shade bumps, and the scene has an [emboss] section: name some that shade bumps, such as --pipelines {}",
                PIPELINES.join(",")
            );
            return Err(Error::usage(text));
        }
        ([], _) if scene.emboss.asked => EMBOSS_PIPELINES.to_vec(),
        ([], None) => PIPELINES.to_vec(),
        ([], Some(_)) => Pipeline::names(),
        (names, _) => names.iter().map(String::as_str).collect(),
    };
    for name in names {
        if pipelines.iter().any(|known: &Pipeline| known.name == name) {
            return Err(Error::usage(format!("pipeline `{name}` is named twice")));
        }
        pipelines.push(Pipeline::named(name)?);
    }
    if args.frames == "setup" {
        if let Some(other) = pipelines.iter().find(|p| p.is_emboss() || p.is_tangent()) {
            let text = format!(
                "--frames=setup is for pipelines that shade bumps: `{}` has frames of its own; leave one of them out",
                other.name
            );
            return Err(Error::usage(text));
        }
        pipelines.iter_mut().for_each(|pipeline| pipeline.frames = Frames::Setup);
    }
    Pipeline::set(&mut pipelines, &args.params)?;
    // Check before the work starts.
    check_view(scene)?;
    check_pixels_per_degree(args.pixels_per_degree)?;
    if args.out.exists() && !args.out.is_dir() {
        return Err(Error::file(&args.out, "is not a folder, and pictures go into one".to_owned()));
    }
    Ok(pipelines)
}
