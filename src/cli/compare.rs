//! `fixpath compare`: Table 1 of Lee et al., rebuilt.

use super::{number, text};
use crate::base::cast;
use crate::base::columns::{self, Field};
use crate::base::error::{Error, Result};
use crate::base::escape;
use crate::base::json;
use crate::base::output;
use crate::design::Sampler;
use crate::measure::Inputs;
use crate::report::Table;
use crate::shading::picture::coverage;
use crate::shading::render::check_view;
use crate::sweep::compare::{
    self, COUNTS, Comparison, Hardware, Row, SceneRendered, Spread, Stage, saved_percent,
};
use clap::Args;
use std::fmt::Write as _;
use std::io::Write;
use std::iter;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub(super) struct CompareArgs {
    /// Set a parameter of every architecture that has it.
    #[arg(short = 'p', long = "param", value_name = "KEY=VALUE")]
    params: Vec<String>,
    /// Number of random fragments.
    #[arg(long, value_name = "N", default_value_t = 100_000, allow_negative_numbers = true, value_parser = number::whole(1..=u64::MAX))]
    samples: u64,
    /// Seed of the random fragments.
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = number::whole(0..=u64::MAX))]
    seed: u64,
    /// Scenes to render for the image error: built-in names or files; `none` skips it.
    #[arg(
        long,
        value_name = "SCENE,…",
        value_delimiter = ',',
        default_value = "plane,cube,sphere"
    )]
    scenes: Vec<String>,
    /// As JSON.
    #[arg(long)]
    json: bool,
    /// Also write the tables to a file, as Markdown or CSV by its extension.
    #[arg(long, value_name = "FILE.md|FILE.csv")]
    out: Option<PathBuf>,
}

/// Counts and measures; returns the text to print.
pub(super) fn run(args: &CompareArgs) -> Result<String> {
    let ending = args.out.as_ref().map(|path| path.extension().and_then(|e| e.to_str()));
    if let (Some(path), Some(ending)) = (&args.out, ending)
        && !matches!(ending, Some("md" | "csv"))
    {
        let problem = "give a file that ends in .md or .csv".to_owned();
        return Err(Error::file(path, problem));
    }
    let inputs = Inputs { sampler: Sampler::Lit, samples: args.samples, seed: args.seed };
    let bar = super::progress::progress_bar(inputs.samples, "fragments");
    let progress = |name: &str, done| {
        bar.set_prefix(escape::short(name));
        bar.set_position(done);
    };
    let scenes = match &args.scenes[..] {
        [none] if none == "none" => Vec::new(),
        names => names
            .iter()
            .map(|name| Ok((name.as_str(), super::render::still_scene_of(Path::new(name))?)))
            .collect::<Result<_>>()?,
    };
    args.out.as_deref().map_or(Ok(()), output::check)?;
    for (_, scene) in &scenes {
        check_view(scene)?;
    }
    let mut comparison = compare::compare(&args.params, &inputs, &progress)?;
    bar.finish_and_clear();
    for (name, scene) in &scenes {
        let bar = super::progress::progress_bar(u64::from(scene.image.height), name);
        let name = Path::new(name).file_stem().and_then(|stem| stem.to_str()).unwrap_or(name);
        comparison.add_scene(&escape::short(name), scene, &|rows| bar.set_position(rows))?;
        bar.finish_and_clear();
    }
    if let Some(path) = &args.out {
        let markdown = ending.flatten() == Some("md");
        if markdown {
            output::write_text(path, &markdown_of(&comparison))?;
        } else {
            output::write_file(path, |to| write_csv(&comparison, to, path))?;
        }
    }
    if args.json {
        return Ok(json::text(&json::document("compare", &comparison)));
    }
    let mut told = String::new();
    for section in
        sections(&comparison).into_iter().filter(|section| !section.table.rows.is_empty())
    {
        let _ = writeln!(told, "{}", section.title);
        told.push_str(&section.table.text());
        for note in section.notes {
            let _ = writeln!(told, "  {note}");
        }
        told.push('\n');
    }
    Ok(told)
}

/// A table with a title.
struct Section {
    title: String,
    table: Table,
    notes: Vec<String>,
}

/// `ours / paper`, or one of them alone.
fn beside(ours: Option<u64>, paper: Option<u64>) -> String {
    let text = |count: Option<u64>| count.map_or("-".to_owned(), |count| count.to_string());
    match (ours, paper) {
        (None | Some(0), None | Some(0)) => "-".to_owned(),
        _ => format!("{} / {}", text(ours), text(paper)),
    }
}

fn counts_row(
    name: &str,
    stage: &str,
    ours: Option<Hardware>,
    paper: Option<Hardware>,
) -> Vec<String> {
    let mut row = vec![name.to_owned(), stage.to_owned()];
    row.extend(
        (0..COUNTS.len()).map(|i| {
            beside(ours.map(|ours| ours.counts()[i]), paper.map(|paper| paper.counts()[i]))
        }),
    );
    row
}

fn sections(comparison: &Comparison) -> Vec<Section> {
    let strings = |texts: &[&str]| -> Vec<String> { texts.iter().map(|&t| t.to_owned()).collect() };
    let mut headings = strings(&["architecture", "stage"]);
    headings.extend(COUNTS.iter().map(|count| format!(">{count}")));
    let mut counts = Vec::new();
    for row in &comparison.rows {
        for (name, stage) in [(row.name, Stage::SetUp), ("", Stage::Illumination)] {
            let (ours, paper) = row.stage(stage);
            counts.push(counts_row(name, stage.name(), ours, paper));
        }
        counts.push(counts_row("", "whole", Some(row.whole), compare::whole(row.paper)));
    }
    let cost = |row: &Row| {
        let cells = [row.tables, row.rom_bits, row.latency_cycles.into()];
        let mut row = vec![row.name.to_owned()];
        row.extend(cells.map(|count| count.to_string()));
        row
    };
    let claims = comparison.claims.iter().map(|claim| {
        let share =
            |pair: [u64; 2]| format!("1 - {}/{} = {:.1} %", pair[0], pair[1], saved_percent(pair));
        vec![
            claim.name.to_owned(),
            claim.against.to_owned(),
            share(claim.multipliers),
            share(claim.paper),
        ]
    });
    let spread = |spread: Option<Spread>, scale: f64, unit: &str| -> [String; 3] {
        spread.map_or_else(
            || std::array::from_fn(|_| "-".to_owned()),
            |s| [s.mean, s.p99, s.max].map(|x| format!("{}{unit}", text::number(x * scale))),
        )
    };
    let error = |row: &Row| {
        let mut cells = vec![row.name.to_owned()];
        cells.extend(spread(row.angle, 1f64.to_degrees(), "°"));
        cells.extend(spread(row.dot, 1.0, ""));
        cells.extend(spread(row.intensity, 1.0, ""));
        cells
    };
    let differences = comparison.rows.iter().flat_map(|row| {
        row.differences.iter().map(|d| {
            let pair = format!("{} / {}", d.ours, d.paper);
            vec![
                row.name.to_owned(),
                d.stage.name().to_owned(),
                d.count.to_owned(),
                pair,
                d.why.to_owned(),
            ]
        })
    });
    let samples = cast::f64_of_count(comparison.samples);
    vec![
        Section {
            title: format!("operators, ours / the paper's: {}", comparison.source),
            table: Table { headings, rows: counts },
            notes: strings(&[
                "counted from the netlists, by scope; in whole, operators that both stages share count once",
                "not counted, as in the paper: operators inside dividers, roots and tables; rounding, negation, multiplexers",
            ]),
        },
        Section {
            title: "storage and latency".to_owned(),
            table: Table::new(
                &["architecture", ">distinct tables", ">ROM bits", ">latency in cycles"],
                comparison.rows.iter().map(cost).collect(),
            ),
            notes: Vec::new(),
        },
        Section {
            title: "\"up to 78 % fewer multiplications\", in both readings".to_owned(),
            table: Table::new(
                &["pipeline", "reading", "by these netlists", "by the paper"],
                claims.collect(),
            ),
            notes: Vec::new(),
        },
        Section {
            title: format!(
                "error over {samples} lit fragments, seed {}, end to end",
                comparison.seed
            ),
            table: Table::new(
                &[
                    "architecture",
                    ">vector: mean",
                    ">p99",
                    ">max",
                    ">dot: mean",
                    ">p99",
                    ">max",
                    ">intensity: mean",
                    ">p99",
                    ">max",
                ],
                comparison.rows.iter().map(error).collect(),
            ),
            notes: strings(&[
                "vector: angle between the computed and the golden L' (kugler: N' as its light sees it); dot: N'·L'",
                "end to end: against the golden model of the inputs before quantisation; `fixpath sim` splits each error",
            ]),
        },
        images(comparison),
        Section {
            title: "why counts differ from the paper's".to_owned(),
            table: Table::new(
                &["architecture", "stage", "count", ">ours / paper", "because"],
                differences.collect(),
            ),
            notes: Vec::new(),
        },
    ]
}

/// Image errors, three columns for each scene.
fn images(comparison: &Comparison) -> Section {
    let scenes: Vec<&str> = comparison.scenes.iter().map(|scene| scene.scene.as_str()).collect();
    let mut headings = vec!["architecture".to_owned()];
    for scene in &scenes {
        headings.extend([format!(">{scene}: max/255"), ">mean/255".to_owned(), ">FLIP".to_owned()]);
    }
    let row = |row: &Row| {
        let mut cells = vec![row.name.to_owned()];
        for image in &row.images {
            cells.extend([image.max, image.mean].map(|x| text::number(x * 255.0)));
            cells.push(format!("{:.4}", image.flip));
        }
        cells.resize(1 + 3 * scenes.len(), "-".to_owned());
        cells
    };
    Section {
        title: "difference of each picture from the golden, in linear light".to_owned(),
        table: Table {
            headings,
            rows: if scenes.is_empty() {
                Vec::new()
            } else {
                comparison.rows.iter().map(row).collect()
            },
        },
        notes: comparison
            .scenes
            .iter()
            .map(|of| format!("{}: {}", of.scene, coverage(of.covered_px, of.background_px)))
            .chain(
                comparison
                    .scenes
                    .iter()
                    .flat_map(|of| of.notes.iter().map(|note| format!("{}: {note}", of.scene))),
            )
            .chain(["peercy has no illumination; `fixpath render` shows the pictures".to_owned()])
            .collect(),
    }
}

fn markdown_of(comparison: &Comparison) -> String {
    let mut text = "# Table 1 rebuilt\n".to_owned();
    for section in sections(comparison).into_iter().filter(|section| !section.table.rows.is_empty())
    {
        let _ = writeln!(text, "\n## {}\n", escape::markdown(&section.title));
        text.push_str(&section.table.markdown());
        for note in &section.notes {
            let _ = writeln!(text, "\n{}.", escape::markdown(note));
        }
    }
    text
}

/// One line per architecture and stage.
fn write_csv(comparison: &Comparison, to: &mut dyn Write, path: &Path) -> Result<()> {
    let mut heading = ["architecture", "stage"].map(str::to_owned).to_vec();
    for count in COUNTS {
        let name = count.replace([' ', '-'], "_");
        heading.extend([name.clone(), format!("{name}_paper")]);
    }
    heading.extend(["tables", "rom_bits", "latency_cycles"].map(str::to_owned));
    for quantity in ["angle_rad", "dot", "intensity"] {
        heading.extend(["mean", "p99", "max"].map(|figure| format!("{quantity}_{figure}")));
    }
    for SceneRendered { scene, .. } in &comparison.scenes {
        for figure in ["max", "mean", "flip"] {
            // A number keeps headings unique if scenes share a name, or one has the name of a
            // quantity.
            let name = format!("{scene}_{figure}");
            let numbered = (2..).map(|number| format!("{name}_{number}"));
            let mut free = iter::once(name.clone()).chain(numbered);
            heading.extend(free.find(|name| !heading.contains(name)));
        }
    }
    let row = |row: &Row, stage: &str, ours: Option<Hardware>, paper: Option<Hardware>| {
        let mut fields = [row.name, stage].map(Field::from).to_vec();
        for i in 0..COUNTS.len() {
            fields.extend([ours, paper].map(|counts| Field::from(counts.map(|c| c.counts()[i]))));
        }
        if stage == "whole" {
            fields.extend([row.tables.into(), row.rom_bits.into(), row.latency_cycles.into()]);
            for spread in [row.angle, row.dot, row.intensity] {
                fields.extend([
                    spread.map(|s| s.mean).into(),
                    spread.map(|s| s.p99).into(),
                    spread.map(|s| s.max).into(),
                ]);
            }
            let images = row.images.iter().flat_map(|image| [image.max, image.mean, image.flip]);
            fields.extend(images.map(Field::Real));
        }
        fields.resize(heading.len(), Field::Missing);
        fields
    };
    let rows = comparison.rows.iter().flat_map(|of| {
        let (set_up, illumination) = (of.stage(Stage::SetUp), of.stage(Stage::Illumination));
        let whole = (Some(of.whole), compare::whole(of.paper));
        [("set-up", set_up), ("illumination", illumination), ("whole", whole)]
            .map(|(stage, (ours, paper))| row(of, stage, ours, paper))
    });
    columns::write(to, path, &heading, rows)
}
