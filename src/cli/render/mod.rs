//! `fixpath render`: a scene by pipelines, its golden, differences and figures.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::escape;
use crate::base::json;
use crate::base::output::{self, Set};
use crate::cli::progress::progress_bar;
use crate::cli::{ladder, number, text};
use crate::design::Design;
use crate::netlist::Counts;
use crate::report::record::RankBy;
use crate::shading::picture::{
    Amplify, Difference, PIXELS_PER_DEGREE, Panel, Picture, Srgb8, absolute_map,
    check_pixels_per_degree, coverage, sheet, signed_map,
};
use crate::shading::render::{
    EMBOSS_PIPELINES, Frames, Pipeline, Rendered, Shot, SpecialisedStage, check_view, mixed,
    render, specialise_to,
};
use crate::shading::scene::{Scene, Sharing};
use crate::sweep::View;
use clap::Args;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// The pipelines of a picture, if none are named.
const PIPELINES: [&str; 4] = ["printed", "corrected", "exact-polar", "exact-cartesian"];

/// Arguments of `fixpath render`.
#[derive(Args)]
pub(in crate::cli) struct RenderArgs {
    /// Scene file, or a built-in scene: plane, cube, sphere, lettering-raised, lettering-lowered, brick,
    /// light-orbit, mirrored.
    scene: PathBuf,
    /// Folder to write; pictures that an earlier run made there go.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Pipelines to compare; if not given emboss-gx,emboss-nv for a scene with an [emboss] section, else
    /// printed,corrected,exact-polar,exact-cartesian, and for a ladder all that shade bumps. Those that emboss have
    /// a golden of their own and go into a folder of their own. tangent-smooth and tangent-faceted set triangles up and
    /// light them in texture space; their difference is told in two parts.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pipelines: Vec<String>,
    /// Set a parameter of every pipeline that has it; those of the material come from the scene.
    #[arg(short = 'p', long = "param", value_name = "KEY=VALUE")]
    params: Vec<String>,
    /// Where texture frames come from: float, for each pixel; or setup, by the fixed-point unit tangent for each corner
    /// of planes, cubes and meshes, which -p then sets, too.
    #[arg(long, value_name = "SOURCE", default_value = "float", value_parser = ["float", "setup"])]
    frames: String,
    /// Pixels per degree of sight, for FLIP.
    #[arg(long, value_name = "X", default_value_t = PIXELS_PER_DEGREE, allow_negative_numbers = true, value_parser = number::real)]
    pixels_per_degree: f64,
    /// Cut each pipeline down to what the scene needs, hold it to the general one on every pixel, and
    /// tell what that saves.
    #[arg(long)]
    specialise: bool,
    /// In place of pictures, a report of error against cost and speed: every pipeline over a ladder of
    /// widths (8,10,12,14,16 bits if none are given), and the light tables over exponents.
    #[arg(long, value_name = "BITS,…", conflicts_with = "specialise", num_args = 0..=1, require_equals = true, default_missing_value = "")]
    ladder: Option<String>,
    /// Exponents of the highlight that the ladder's light tables are judged at; 1,8,32,128,255 if none
    /// are given.
    #[arg(long, value_name = "N,…", requires = "ladder")]
    exponents: Option<String>,
    /// As JSON.
    #[arg(long)]
    json: bool,
}

impl RenderArgs {
    /// A built-in scene by some pipelines, or, if none are named, the usual ones.
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

/// Renders and writes; returns a row of the demo's table for each pipeline, and false if a bound is broken.
pub(in crate::cli) fn demo_rows(args: &RenderArgs) -> Result<(Vec<String>, bool)> {
    let made = render_and_write(args, scene_of(&args.scene)?)?;
    let value =
        figures(&made.scene, &made.rendered, &made.differences, &parts(&made.rendered, args)?);
    output::write_text(&made.set.path().join("figures.json"), &json::text(&value))?;
    made.set.commit()?;
    let row = |(shot, d): (&Shot, &Difference)| {
        format!(
            "{} | {} | {} | {:.1} % | {} of {}",
            shot.pipeline.name,
            text::number(d.max.difference * 255.0),
            text::number(d.mean * 255.0),
            d.srgb8_differing * 100.0,
            d.covered_px,
            d.covered_px + d.background_px
        )
    };
    let rows = made.rendered.shots.iter().zip(&made.differences).map(row).collect();
    Ok((rows, bounds_hold(&made.rendered, &made.differences)))
}

/// The most pipelines beside each other on a sheet.
const SHEET_PIPELINES: usize = 4;
/// The most frames beside each other on a sheet.
const SHEET_FRAMES: usize = 12;

/// The scene of a name or a file; what isn't as its files have it goes to standard error.
pub(in crate::cli) fn scene_of(path: &Path) -> Result<Scene> {
    Ok(noted(named_scene(path)?))
}

/// The same for what takes one picture: a light that moves stands still.
pub(in crate::cli) fn still_scene_of(path: &Path) -> Result<Scene> {
    Ok(noted(named_scene(path)?.at_start()))
}

fn noted(scene: Scene) -> Scene {
    // A lost note changes nothing.
    let _ = write!(io::stderr(), "{}", notes(&scene));
    scene
}

/// A line for each of a scene's notes.
fn notes(scene: &Scene) -> String {
    let told = |note: &String| format!("note: {}\n", escape::message(note));
    scene.notes().iter().map(told).collect()
}

fn named_scene(path: &Path) -> Result<Scene> {
    // A bare word that is no file is meant as a name, though there may be no such scene. A folder of
    // that name may be what an earlier run wrote.
    match path.to_str().filter(|name| !name.contains(['.', '/', '\\'])) {
        Some(name) if !path.exists() || path.is_dir() => Scene::builtin(name),
        Some(_) | None => Scene::open(path),
    }
}

/// The scene of a name or a file, to sweep over.
pub(in crate::cli) fn view_of(path: &Path, error: RankBy) -> Result<View> {
    Ok(View { scene: still_scene_of(path)?, name: name_of(path), error })
}

/// The name of a scene in reports.
fn name_of(path: &Path) -> String {
    // A file's name can be anything; in reports it stays on its line.
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    escape::short(&name)
}

/// A scene, how it was rendered, and how far each pipeline is from the golden.
struct Made {
    scene: Scene,
    pipelines: Vec<Pipeline>,
    rendered: Rendered,
    differences: Vec<Difference>,
    /// The pictures, for which figures are missing.
    set: Set,
}

/// Files of pictures.
const SET: &str = "render";

/// Files of figures.
const FIGURES: [&str; 2] = ["figures.json", "figures.txt"];

/// What the pictures of a pipeline are named after it.
fn pictures_of(pipeline: &Pipeline) -> Vec<&'static str> {
    let mut ends = vec!["", "_difference", "_signed"];
    if pipeline.is_emboss() {
        ends.push("_golden");
    }
    if pipeline.is_tangent() {
        ends.extend(["_flow", "_arithmetic", "_algorithm"]);
    }
    ends
}

/// Files of a scene with one picture.
fn files_of(pipelines: &[Pipeline]) -> Vec<String> {
    let of = |pipeline: &Pipeline| -> Vec<String> {
        let name = |end: &&str| format!("{}{end}.png", pipeline.name);
        pictures_of(pipeline).iter().map(name).collect()
    };
    let others = ["golden.png", "sheet.png"].into_iter().chain(FIGURES).map(str::to_owned);
    others.chain(pipelines.iter().flat_map(of)).collect()
}

/// Files of a scene whose light moves.
fn files_of_frames(pipelines: &[Pipeline], frames: u32) -> Vec<String> {
    let mut folders = vec!["golden".to_owned()];
    for pipeline in pipelines {
        folders.push(pipeline.name.clone());
        folders.extend(pipeline.is_emboss().then(|| format!("{}_golden", pipeline.name)));
    }
    let of = |folder: &String| -> Vec<String> {
        (0..frames).map(|number| format!("{folder}/{}", frame_file(number))).collect()
    };
    let others = ["sheet.png"].into_iter().chain(FIGURES).map(str::to_owned);
    others.chain(folders.iter().flat_map(of)).collect()
}

fn frame_file(number: u32) -> String {
    format!("frame_{number:03}.png")
}

/// The pipelines asked for, with their parameters.
fn pipelines_of(args: &RenderArgs, scene: &Scene) -> Result<Vec<Pipeline>> {
    let mut pipelines = Vec::new();
    let names: Vec<&str> = match (&args.pipelines[..], &args.ladder) {
        ([], _) if scene.emboss.asked && args.specialise => {
            let text = format!(
                "--specialise is for pipelines that shade bumps, and the scene has an [emboss] section: name some that shade bumps, as --pipelines {}",
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
    // Before the work, not after it.
    check_view(scene)?;
    check_pixels_per_degree(args.pixels_per_degree)?;
    if args.out.exists() && !args.out.is_dir() {
        return Err(Error::file(&args.out, "is no folder, and pictures go into one".to_owned()));
    }
    Ok(pipelines)
}

/// Renders, and writes pictures and figures.
fn render_and_write(args: &RenderArgs, scene: Scene) -> Result<Made> {
    let pipelines = pipelines_of(args, &scene)?;
    let mut set = Set::open(&args.out, SET)?;
    set.expect(files_of(&pipelines))?;
    let bar = progress_bar(u64::from(scene.image.height), "rows");
    let (rendered, differences) =
        rendered(&scene, &pipelines, args, &|done| bar.set_position(done))?;
    bar.finish_and_clear();
    write_pictures(&set.path(), &rendered)?;
    Ok(Made { scene, pipelines, rendered, differences, set })
}

/// A picture by each pipeline, and how far each is from the golden.
fn rendered(
    scene: &Scene,
    pipelines: &[Pipeline],
    args: &RenderArgs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<(Rendered, Vec<Difference>)> {
    let rendered = render(scene, pipelines, true, progress)?;
    let differences = rendered
        .shots
        .iter()
        .map(|shot| {
            let golden = rendered.golden_of(shot);
            rendered.difference(&shot.picture, golden, args.pixels_per_degree)
        })
        .collect::<Result<Vec<_>>>()?;
    Ok((rendered, differences))
}

/// Renders every frame of a scene whose light moves, and writes `frame_000.png` and so on into a folder
/// for the golden and for each pipeline, a sheet of all, and figures of every frame; returns what to
/// tell, and false if a bound is broken.
fn run_frames(args: &RenderArgs, scene: &Scene) -> Result<(String, bool)> {
    if args.specialise {
        let text = "--specialise takes a scene with one picture: leave [orbit] out";
        return Err(Error::usage(text.to_owned()));
    }
    let pipelines = pipelines_of(args, scene)?;
    let names: Vec<&str> =
        ["golden"].into_iter().chain(pipelines.iter().map(|p| p.name.as_str())).collect();
    let mut set = Set::open(&args.out, SET)?;
    set.expect(files_of_frames(&pipelines, scene.frames()))?;
    let out = set.path();
    for name in &names {
        output::make_folder(&out.join(name))?;
    }
    let height = u64::from(scene.image.height);
    let bar = progress_bar(u64::from(scene.frames()) * height, "rows");
    // A row of the sheet for each picture, and below it one of differences.
    let mut rows: Vec<Vec<Srgb8>> = vec![Vec::new(); 2 * names.len() - 1];
    let (mut values, mut told, mut held) = (Vec::new(), Vec::new(), true);
    let mut view = String::new();
    for number in 0..scene.frames() {
        let before = u64::from(number) * height;
        let (rendered, differences) = rendered(&scene.frame(number), &pipelines, args, &|done| {
            bar.set_position(before + done)
        })?;
        let file = frame_file(number);
        let golden = rendered.golden.to_srgb8();
        golden.save_png(&out.join("golden").join(&file))?;
        rows[0].push(golden);
        for (i, shot) in rendered.shots.iter().enumerate() {
            let picture = shot.picture.to_srgb8();
            picture.save_png(&out.join(&shot.pipeline.name).join(&file))?;
            if let Some(golden) = &shot.golden {
                let folder = out.join(format!("{}_golden", shot.pipeline.name));
                output::make_folder(&folder)?;
                golden.to_srgb8().save_png(&folder.join(&file))?;
            }
            rows[1 + 2 * i].push(picture);
            rows[2 + 2 * i].push(absolute_map(
                &shot.picture,
                rendered.golden_of(shot),
                Amplify::Fit,
            )?);
        }
        // The camera stands still: each frame sees the same pixels.
        view = covered(&rendered);
        held &= bounds_hold(&rendered, &differences);
        values.push(figures(scene, &rendered, &differences, &parts(&rendered, args)?));
        for (shot, difference) in rendered.shots.iter().zip(&differences) {
            told.push(vec![
                number.to_string(),
                shot.pipeline.name.clone(),
                text::number(difference.max.difference * 255.0),
                bound_of(shot).map(|bound| text::number(bound * 255.0)).unwrap_or_default(),
                text::number(difference.mean * 255.0),
                format!("{:.4}", difference.ssim),
                format!("{:.4}", difference.flip),
            ]);
        }
    }
    bar.finish_and_clear();
    // As many frames as fit a sheet well.
    let step = rows[0].len().div_ceil(SHEET_FRAMES);
    let mut panels = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let caption = if i > 0 && i % 2 == 0 { "difference" } else { names[i.div_ceil(2)] };
        panels.extend(row.iter().step_by(step).map(|picture| Panel { caption, picture }));
    }
    let columns = rows[0].len().div_ceil(step);
    sheet(&panels, columns)?.save_png(&out.join("sheet.png"))?;
    let value = json::document("render-frames", json!({ "frames": values }));
    let headings = [">frame", "pipeline", ">max/255", ">bound/255", ">mean/255", ">SSIM", ">FLIP"];
    let mut told = format!("{view}\n{}", text::table(&headings, &told));
    if !held {
        told.push_str(text::BROKEN);
    }
    write_figures(set, &value, &(told.clone() + &notes(scene)))?;
    Ok((if args.json { json::text(&value) } else { told }, held))
}

/// How much of the pictures means are over, in words.
fn covered(rendered: &Rendered) -> String {
    coverage(rendered.covered, rendered.background())
}

/// Writes the figures of pictures that are complete, and puts all into their places.
fn write_figures(set: Set, value: &Value, told: &str) -> Result<()> {
    for (name, text) in FIGURES.into_iter().zip([&*json::text(value), told]) {
        output::write_text(&set.path().join(name), text)?;
    }
    set.commit()
}

/// What its largest difference can't be above, in linear light.
fn bound_of(shot: &Shot) -> Option<f64> {
    shot.emboss.and_then(|known| known.bound)
}

/// False if a picture is farther from the golden than it can be.
fn bounds_hold(rendered: &Rendered, differences: &[Difference]) -> bool {
    let holds = |(shot, difference): (&Shot, &Difference)| {
        bound_of(shot).is_none_or(|bound| difference.max.difference <= bound) // false for NaN
    };
    rendered.shots.iter().zip(differences).all(holds)
}

/// Renders and writes; returns what to tell, and false if a specialised pipeline differs.
pub(in crate::cli) fn run(args: &RenderArgs) -> Result<(String, bool)> {
    let scene = match &args.ladder {
        Some(_) => still_scene_of(&args.scene)?,
        None => scene_of(&args.scene)?,
    };
    if let Some(widths) = &args.ladder {
        if args.frames == "setup" {
            let text = "--ladder takes frames in floating point: leave --frames out";
            return Err(Error::usage(text.to_owned()));
        }
        let exponents = args.exponents.as_deref();
        let pipelines = pipelines_of(args, &scene)?;
        if pipelines.iter().all(Pipeline::is_emboss) {
            if exponents.is_some() {
                let text = "an emboss has no highlight and no --exponents: leave them out";
                return Err(Error::usage(text.to_owned()));
            }
            return ladder::run_emboss(
                &pipelines,
                widths,
                args.pixels_per_degree,
                (&scene, &name_of(&args.scene)),
                (&args.out, args.json),
            );
        }
        if pipelines.iter().any(Pipeline::is_emboss) {
            return Err(mixed());
        }
        if pipelines.iter().any(Pipeline::is_tangent) {
            let text = "--ladder is for pipelines that shade bumps or emboss: leave tangent pipelines out, and set their widths by -p";
            return Err(Error::usage(text.to_owned()));
        }
        let ladder = ladder::ladder(pipelines, widths, exponents, args.pixels_per_degree)?;
        let told = ladder::run(&ladder, &scene, &name_of(&args.scene), &args.out, args.json)?;
        return Ok((told, true));
    }
    if args.specialise {
        let pipelines = pipelines_of(args, &scene)?;
        if args.frames == "setup" {
            let text = "--specialise takes frames in floating point: leave --frames out";
            return Err(Error::usage(text.to_owned()));
        }
        if pipelines.iter().any(|pipeline| pipeline.is_emboss() || pipeline.is_tangent()) {
            let text = "--specialise is for pipelines that shade bumps: leave it out for an emboss or a tangent-space set-up";
            return Err(Error::usage(text.to_owned()));
        }
    }
    if scene.orbit.is_some() {
        return run_frames(args, &scene);
    }
    let Made { scene, pipelines, rendered, differences, set } = render_and_write(args, scene)?;
    let parts = parts(&rendered, args)?;
    let mut value = figures(&scene, &rendered, &differences, &parts);
    let mut told = table(&rendered, &differences);
    told.push_str(&setups(&rendered, &differences, &parts));
    told.push_str(&frames(&rendered));
    let mut same = bounds_hold(&rendered, &differences);
    if !same {
        told.push_str(text::BROKEN);
    }
    if args.specialise {
        let reduced = pipelines
            .iter()
            .map(|pipeline| Ok((pipeline.name.as_str(), specialise_to(&scene, pipeline)?)))
            .collect::<Result<Vec<_>>>()?;
        same &= reduced.iter().flat_map(|(_, stages)| stages).all(|stage| stage.mismatches == 0);
        let fields = value.as_object_mut().expect("bug: an object");
        let stages = |(name, stages): &(&str, Vec<SpecialisedStage>)| json!({ "pipeline": name, "designs": stages });
        fields.insert("specialised".to_owned(), reduced.iter().map(stages).collect());
        told.push('\n');
        told.push_str(&savings(&reduced));
    }
    write_figures(set, &value, &(told.clone() + &notes(&scene)))?;
    Ok((if args.json { json::text(&value) } else { told }, same))
}

/// What specialised pipelines save, a row for each design.
fn savings(reduced: &[(&str, Vec<SpecialisedStage>)]) -> String {
    let mut rows = Vec::new();
    for (name, stages) in reduced {
        for stage in stages {
            let report = &stage.report;
            let face = report.face.as_ref().map(|face| &face.counts);
            let multipliers = |counts: &Counts| {
                counts.datapath.multipliers + counts.schemes.multipliers + counts.parts.multipliers
            };
            let adders = |c: &Counts| c.datapath.adders + c.schemes.adders + c.parts.adders;
            let change = |count: &dyn Fn(&Counts) -> u64| {
                let (before, pixel) = (count(&report.before), count(&report.pixel.counts));
                let face = face.map(|face| format!(" + {}", count(face))).unwrap_or_default();
                format!("{before} to {pixel}{face}")
            };
            let per = |seconds: f64| seconds / cast::f64_of_count(stage.samples.max(1)) * 1e9;
            let inputs = |rate: &str| stage.inputs.iter().filter(|port| port.rate == rate).count();
            rows.push(vec![
                (*name).to_owned(),
                format!("{}, {}", stage.material, stage.light),
                format!("{} {} {}", inputs("scene"), inputs("face"), inputs("pixel")),
                change(&|counts| counts.tables),
                change(&|counts| counts.rom_bits),
                change(&|counts| counts.rom_bits_dual_port),
                change(&multipliers),
                change(&adders),
                if face.is_some() { stage.faces.to_string() } else { "-".to_owned() },
                format!(
                    "{:.1} to {:.1}",
                    per(stage.general_seconds),
                    per(stage.specialised_seconds)
                ),
                if stage.mismatches == 0 {
                    format!("all {} words", stage.samples)
                } else {
                    format!("{} DIFFER", stage.mismatches)
                },
            ]);
        }
    }
    let mut told = String::from(
        "only what the scene needs: before, after for every pixel + after once for every flat face;\n\
         each design is held to the general one on every pixel\n",
    );
    told.push_str(&text::table(
        &[
            "pipeline",
            "material, light",
            "ports constant on scene, face; changing",
            "tables",
            "ROM bits",
            "with copies",
            "multipliers",
            "adders",
            "faces",
            "ns a sample",
            "equal",
        ],
        &rows,
    ));
    told
}

fn write_pictures(out: &Path, rendered: &Rendered) -> Result<()> {
    let golden = rendered.golden.to_srgb8();
    golden.save_png(&out.join("golden.png"))?;
    let mut pictures = Vec::new();
    for shot in &rendered.shots {
        let name = &shot.pipeline.name;
        let picture = shot.picture.to_srgb8();
        picture.save_png(&out.join(format!("{name}.png")))?;
        if let Some(golden) = &shot.golden {
            golden.to_srgb8().save_png(&out.join(format!("{name}_golden.png")))?;
        }
        let difference = absolute_map(&shot.picture, rendered.golden_of(shot), Amplify::Fit)?;
        difference.save_png(&out.join(format!("{name}_difference.png")))?;
        signed_map(&shot.picture, rendered.golden_of(shot), Amplify::Fit)?
            .save_png(&out.join(format!("{name}_signed.png")))?;
        if let Some(setup) = &shot.setup {
            setup.flow.to_srgb8().save_png(&out.join(format!("{name}_flow.png")))?;
            absolute_map(&shot.picture, &setup.flow, Amplify::Fit)?
                .save_png(&out.join(format!("{name}_arithmetic.png")))?;
            absolute_map(&setup.flow, &rendered.golden, Amplify::Fit)?
                .save_png(&out.join(format!("{name}_algorithm.png")))?;
        }
        pictures.push((name.as_str(), picture, difference));
    }
    // Rows of pictures, the golden first, with their differences below.
    let nothing = Srgb8::new(1, 1, vec![[255; 3]])?;
    let blank = Panel { caption: "", picture: &nothing };
    let mut panels = Vec::new();
    let columns = pictures.len().min(SHEET_PIPELINES);
    for (row, some) in pictures.chunks(SHEET_PIPELINES).enumerate() {
        let first = Panel { caption: "golden", picture: &golden };
        panels.push(if row == 0 { first } else { blank });
        panels.extend(some.iter().map(|(name, picture, _)| Panel { caption: name, picture }));
        panels.resize((2 * row + 1) * (columns + 1), blank);
        panels.push(blank);
        let caption = "difference";
        panels.extend(some.iter().map(|(_, _, difference)| Panel { caption, picture: difference }));
        panels.resize((2 * row + 2) * (columns + 1), blank);
    }
    sheet(&panels, columns + 1)?.save_png(&out.join("sheet.png"))
}

/// What a set-up's difference to the golden is made of: arithmetic (to its own flow with the golden of the
/// set-up) and algorithm (of that flow to the golden).
type Parts = Option<[Difference; 2]>;

fn parts(rendered: &Rendered, args: &RenderArgs) -> Result<Vec<Parts>> {
    let between = |a: &Picture, b: &Picture| rendered.difference(a, b, args.pixels_per_degree);
    let of = |shot: &Shot| match &shot.setup {
        None => Ok(None),
        Some(setup) => Ok(Some([
            between(&shot.picture, &setup.flow)?,
            between(&setup.flow, &rendered.golden)?,
        ])),
    };
    rendered.shots.iter().map(of).collect()
}

/// What is known of frames that are set up, once where pipelines say the same.
fn frames(rendered: &Rendered) -> String {
    let mut lines: Vec<String> = Vec::new();
    for known in rendered.shots.iter().filter_map(|shot| shot.frames.as_ref()) {
        let overflows: u64 = known.overflows.iter().map(|overflow| overflow.count).sum();
        let line = format!(
            "frames by the set-up: {} of {} faces mirrored, {} of {} corners without a frame of their own, {overflows} overflows; the coarsest step of positions is {} and of texture coordinates {}\n",
            known.mirrored,
            known.faces,
            known.degenerate,
            3 * known.faces,
            text::number(known.position_step),
            text::number(known.uv_step)
        );
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines.concat()
}

/// What set-ups take and save, and what their differences are made of.
fn setups(rendered: &Rendered, differences: &[Difference], parts: &[Parts]) -> String {
    let mut told = String::new();
    let shots = rendered.shots.iter().zip(differences).zip(parts);
    let mut rows = Vec::new();
    let mut work = Vec::new();
    let mut sharing = None;
    for ((shot, total), parts) in shots {
        let (Some(setup), Some([arithmetic, algorithm])) = (&shot.setup, parts) else { continue };
        let of = |what: &str, d: &Difference| {
            vec![
                shot.pipeline.name.clone(),
                what.to_owned(),
                text::number(d.max.difference * 255.0),
                text::number(d.mean * 255.0),
                format!("{:.1}", d.psnr_db),
                format!("{:.4}", d.ssim),
                format!("{:.4}", d.flip),
                format!("{:.2} %", d.srgb8_differing * 100.0),
            ]
        };
        rows.extend([of("arithmetic", arithmetic), of("algorithm", algorithm), of("total", total)]);
        let operations = |counts: &Counts| {
            let all = [&counts.datapath, &counts.schemes, &counts.parts];
            [
                all.iter().map(|operators| operators.multipliers).sum::<u64>(),
                all.iter().map(|operators| operators.adders).sum::<u64>(),
                counts.reads,
            ]
        };
        let primitive = setup.per_primitive.as_ref().map_or([0; 3], operations);
        let vertex = operations(&setup.per_vertex);
        let [triangles, corners] = [setup.sharing.primitives, setup.sharing.replicated_operations];
        for (rate, operations, times) in
            [("per triangle", primitive, triangles), ("per vertex of a triangle", vertex, corners)]
        {
            let mut row = vec![shot.pipeline.name.clone(), rate.to_owned(), times.to_string()];
            row.extend(operations.map(|count| count.to_string()));
            work.push(row);
        }
        let _ = writeln!(
            told,
            "{}: {} of {triangles} triangles mirrored, {} of {corners} corners without a frame of their own; the coarsest step of positions is {} and of texture coordinates {}",
            shot.pipeline.name,
            setup.mirrored,
            setup.degenerate,
            text::number(setup.position_step),
            text::number(setup.uv_step)
        );
        sharing = Some(setup.sharing);
    }
    let Some(sharing) = sharing else { return told };
    let Sharing {
        vertices,
        primitives,
        indices,
        stitches,
        vertex_operations,
        replicated_operations,
        bytes,
        replicated_bytes,
    } = sharing;
    let saved = |less: u64, more: u64| {
        format!("{:.2} x", cast::f64_of_count(more) / cast::f64_of_count(less.max(1)))
    };
    format!(
        "\nset-up per triangle: arithmetic is to the same flow with the set-up in floating point, algorithm of that to the golden\n{}{told}\
         {vertices} vertices, {primitives} triangles of {indices} indices, {stitches} more that only stitch; shared, the vertex stage works on {vertex_operations} vertices, and on \
         {replicated_operations} if each triangle has its own ({}); buffers have {bytes} bytes, and would have {replicated_bytes} ({})\n{}",
        text::table(
            &[
                "pipeline",
                "difference",
                ">max/255",
                ">mean/255",
                ">PSNR dB",
                ">SSIM",
                ">FLIP",
                ">8-bit differing"
            ],
            &rows
        ),
        saved(vertex_operations, replicated_operations),
        saved(bytes, replicated_bytes),
        text::table(
            &["pipeline", "set-up", ">times", ">multipliers", ">adders", ">table reads"],
            &work
        )
    )
}

fn figures(
    scene: &Scene,
    rendered: &Rendered,
    differences: &[Difference],
    parts: &[Parts],
) -> Value {
    let parameters = |design: &Design| text::parameters(&design.values);
    let shot = |((shot, difference), parts): ((&Shot, &Difference), &Parts)| {
        json!({
            "pipeline": shot.pipeline.name,
            "unit": shot.pipeline.unit.name,
            "parameters": parameters(&shot.design),
            "behind": shot.behind.iter().map(|design| json!({
                "unit": design.values.unit().name,
                "parameters": parameters(design),
            })).collect::<Vec<_>>(),
            "difference": difference,
            "emboss": shot.emboss,
            "setup": shot.setup,
            "frames": shot.frames,
            "arithmetic": parts.as_ref().map(|[arithmetic, _]| arithmetic),
            "algorithm": parts.as_ref().map(|[_, algorithm]| algorithm),
            "vectors": shot.vectors,
            "overflows": shot.overflowed(),
            "samples": shot.samples,
            "engine_samples_per_second_per_thread": shot.samples_per_second,
        })
    };
    json::document(
        "render",
        json!({
            "width_px": rendered.golden.width_px(),
            "height_px": rendered.golden.height_px(),
            "covered_px": rendered.covered,
            "background_px": rendered.background(),
            "notes": scene.notes(),
            "blinn_max": rendered.blinn,
            "pixels_per_second":
                cast::f64_of_len(rendered.golden.pixels().len()) / rendered.elapsed.as_secs_f64(),
            "pipelines": rendered.shots.iter().zip(differences).zip(parts).map(shot).collect::<Vec<_>>(),
        }),
    )
}

fn table(rendered: &Rendered, differences: &[Difference]) -> String {
    let rows: Vec<Vec<String>> = rendered
        .shots
        .iter()
        .zip(differences)
        .map(|(shot, d)| {
            let angle = |rad: f64| format!("{}°", text::number(rad.to_degrees()));
            vec![
                shot.pipeline.name.clone(),
                text::number(d.max.difference * 255.0),
                text::number(d.mean * 255.0),
                format!("{:.1}", d.psnr_db),
                format!("{:.4}", d.ssim),
                format!("{:.4}", d.flip),
                format!("{:.2} %", d.srgb8_differing * 100.0),
                d.srgb8_max_codes.to_string(),
                shot.vectors.map(|v| angle(v.max_rad)).unwrap_or_default(),
                shot.vectors.map(|v| angle(v.mean_rad)).unwrap_or_default(),
                bound_of(shot).map(|bound| text::number(bound * 255.0)).unwrap_or_default(),
                format!("{:.1}", shot.samples_per_second / 1e6),
            ]
        })
        .collect();
    let mut told = format!(
        "{} x {} pixels: {}; differences to the golden, in linear light\n",
        rendered.golden.width_px(),
        rendered.golden.height_px(),
        covered(rendered)
    );
    let headings = [
        "pipeline",
        ">max/255",
        ">mean/255",
        ">PSNR dB",
        ">SSIM",
        ">FLIP",
        ">8-bit differing",
        ">codes",
        ">L' angle max",
        ">mean",
        ">bound/255",
        ">M samples/s a thread",
    ];
    // Columns that say something.
    let kept: Vec<usize> =
        (0..headings.len()).filter(|i| rows.iter().any(|row| !row[*i].is_empty())).collect();
    let headings: Vec<&str> = kept.iter().map(|i| headings[*i]).collect();
    let keep = |row: &Vec<String>| kept.iter().map(|i| row[*i].clone()).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(keep).collect();
    told.push_str(&text::table(&headings, &rows));
    let pixels = cast::f64_of_len(rendered.golden.pixels().len());
    let _ = writeln!(
        told,
        "  {:.2} M pixels/s for rays, golden and all pipelines together{}",
        pixels / rendered.elapsed.as_secs_f64() / 1e6,
        rendered.blinn.map_or(String::new(), |blinn| format!(
            "; Blinn's equation differs from the golden by {} at most",
            text::number(blinn)
        ))
    );
    told
}
