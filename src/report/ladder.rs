//! A ladder of whole pipelines on a scene: its figures as JSON, CSV, Markdown and plots.
//!
//! `ladder.json` holds a `header`, `rungs` (each pipeline at each width) and `exponents` (the light
//! tables at each exponent of the highlight). Each rung and exponent is a point as in `sweep.json`;
//! its parameters are those of the design for the first material and light. `ladder.csv` has a row
//! for each rung, `exponents.csv` one for each exponent. Their columns are those that identify the
//! row, then the figures of [`FIGURES`], then `error`, the reason if there are none.

use super::chart::{Along, Chart, Front, Series, Style};
use super::markdown::short;
use super::pareto::pareto;
use super::record::{Measured, Point, SceneId};
use super::table::Table;
use crate::base::cast;
use crate::base::columns::{self, Field};
use crate::base::error::Result;
use crate::base::escape;
use crate::base::json;
use crate::base::output;
use crate::measure::Basis;
use crate::shading::picture::coverage;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::path::Path;

/// What was rendered.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Header {
    /// Version of this crate.
    pub crate_version: String,
    /// The scene.
    pub scene: SceneId,
    /// Pixels that see an object.
    pub covered_px: u64,
    /// The other pixels.
    pub background_px: u64,
    /// Number of lights of the scene: a pixel takes one sample per light.
    pub lights: usize,
    /// Pixels per degree of visual angle, for FLIP.
    pub pixels_per_degree: f64,
    /// Parameters of a rung, with the amount to subtract from its width.
    pub rung: Vec<(String, u32)>,
    /// Widths of the rungs.
    pub widths_bits: Vec<u32>,
    /// The pipeline in which the light tables were judged, if any.
    pub light_pipeline: Option<String>,
    /// Its parameters, unless others were set.
    pub light_parameters: Vec<String>,
}

/// A pipeline at a width.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Rung {
    /// The pipeline.
    pub pipeline: String,
    /// Its unit.
    pub unit: String,
    /// Width of the rung.
    pub width_bits: u32,
    /// Parameters and figures.
    #[serde(flatten)]
    pub point: Point,
}

/// Light tables at an exponent.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LightPoint {
    /// Exponent of the highlight.
    pub exponent: u32,
    /// Scheme of the light tables.
    pub scheme: String,
    /// Their address bits.
    pub addr_bits: u32,
    /// Parameters and figures.
    #[serde(flatten)]
    pub point: Point,
}

/// A ladder's result.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    /// What was rendered.
    pub header: Header,
    /// Each pipeline at each width.
    pub rungs: Vec<Rung>,
    /// The light tables at each exponent.
    pub exponents: Vec<LightPoint>,
}

/// A figure of a point.
type Pick = fn(&Header, &Measured) -> Field;

/// Figures in columns of the CSV files. Differences are in linear light, 0 to 1. Simulated pixels
/// per second and thread are those of the bit-true engine alone.
pub const FIGURES: [(&str, Pick); 20] = [
    ("picture_covered_px", |_, m| m.picture.map(|p| p.covered_px).into()),
    ("picture_background_px", |_, m| m.picture.map(|p| p.background_px).into()),
    ("picture_max_abs", |_, m| figure(m, "picture", true).into()),
    ("picture_mean_abs", |_, m| figure(m, "picture", false).into()),
    ("picture_psnr_db", |_, m| m.picture.map(|p| p.psnr_db.0).into()),
    ("picture_ssim", |_, m| m.picture.map(|p| p.ssim.0).into()),
    ("picture_flip", |_, m| m.picture.map(|p| p.flip.0).into()),
    ("picture_srgb8_differing", |_, m| m.picture.map(|p| p.srgb8_differing).into()),
    ("picture_srgb8_max_codes", |_, m| m.picture.map(|p| u32::from(p.srgb8_max_codes)).into()),
    ("lt_angle_max_rad", |_, m| figure(m, "lt_angle", true).into()),
    ("lt_angle_mean_rad", |_, m| figure(m, "lt_angle", false).into()),
    ("multipliers", |_, m| m.operators()[0].into()),
    ("adders", |_, m| m.operators()[1].into()),
    ("tables", |_, m| m.count("tables").into()),
    ("rom_bits", |_, m| m.count("rom_bits").into()),
    ("rom_bits_dual_port", |_, m| m.count("rom_bits_dual_port").into()),
    ("latency_cycles", |_, m| m.count("latency_cycles").into()),
    ("flip_flops", |_, m| m.count("flip_flops").into()),
    ("overflows", |_, m| m.overflows.iter().map(|o| o.count).sum::<u64>().into()),
    ("pixels_per_second_per_thread", |h, m| pixels_per_second(h, m).into()),
];

fn figure(measured: &Measured, quantity: &str, max: bool) -> Option<f64> {
    let figures = measured.figures(quantity, Basis::EndToEnd)?;
    Some(if max { figures.max.0 } else { figures.mean.0 })
}

/// A count for a chart; NaN if unknown.
fn count(measured: &Measured, name: &str) -> f64 {
    measured.count(name).map_or(f64::NAN, cast::f64_of_count)
}

fn pixels_per_second(header: &Header, measured: &Measured) -> f64 {
    measured.speed.engine_samples_per_second_per_thread / cast::f64_of_len(header.lights.max(1))
}

/// The largest difference of a picture in 1/255; NaN if there is no picture.
fn error(point: &Point) -> f64 {
    let max = point.measured.as_ref().and_then(|m| figure(m, "picture", true));
    max.unwrap_or(f64::NAN) * 255.0
}

/// Names of all files that [`Record::write`] may write.
pub const FILES: [&str; 7] = [
    "ladder.json",
    "ladder.csv",
    "ladder.md",
    "exponents.csv",
    "ladder_error_vs_rom.svg",
    "ladder_error_vs_speed.svg",
    "exponents.svg",
];

impl Record {
    /// As JSON.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        json::document("ladder", self)
    }

    /// Writes `ladder.json`, `ladder.csv`, `ladder.md`, `exponents.csv` and the plots into a
    /// folder.
    ///
    /// # Errors
    /// If a file can't be written.
    pub fn write(&self, folder: &Path) -> Result<()> {
        output::make_folder(folder)?;
        let json = folder.join("ladder.json");
        output::write_text(&json, &json::text(&self.json()))?;
        let rungs = self.rungs.iter().map(|rung| {
            let told: [Field; 3] =
                [rung.pipeline.as_str().into(), rung.unit.as_str().into(), rung.width_bits.into()];
            let own = self.header.rung.iter().map(|(key, _)| rung.point.field(key));
            (told.into_iter().chain(own).collect(), &rung.point)
        });
        let mut names = vec!["pipeline", "unit", "width_bits"];
        names.extend(self.header.rung.iter().map(|(key, _)| key.as_str()));
        self.write_csv(&folder.join("ladder.csv"), &names, rungs)?;
        let names = ["exponent", "light_scheme", "light_addr_bits"];
        let lights = self.exponents.iter().map(|light| {
            let told: [Field; 3] =
                [light.exponent.into(), light.scheme.as_str().into(), light.addr_bits.into()];
            (told.to_vec(), &light.point)
        });
        self.write_csv(&folder.join("exponents.csv"), &names, lights)?;
        for (file, chart) in self.charts() {
            output::write_text(&folder.join(file), &chart.svg())?;
        }
        output::write_text(&folder.join("ladder.md"), &self.markdown())
    }

    fn write_csv<'a>(
        &self,
        path: &Path,
        names: &[&str],
        points: impl Iterator<Item = (Vec<Field>, &'a Point)>,
    ) -> Result<()> {
        let figures = FIGURES.map(|(name, _)| name);
        let heading = names.iter().copied().chain(figures).chain(["error"]);
        let heading: Vec<String> = heading.map(str::to_owned).collect();
        let rows = points.map(|(mut row, point)| {
            row.extend(FIGURES.map(|(_, get)| match &point.measured {
                Some(measured) => get(&self.header, measured),
                None => Field::Missing,
            }));
            row.push(point.error.clone().into());
            row
        });
        output::write_file(path, |to| columns::write(to, path, &heading, rows))
    }

    /// The pipelines at every width.
    #[must_use]
    pub fn pipelines_table(&self) -> Table {
        let mut headings = vec![
            "pipeline",
            ">bits",
            ">max/255",
            ">mean/255",
            ">PSNR dB",
            ">FLIP",
            ">L' angle max °",
            ">mean °",
            ">mul",
            ">add",
            ">ROM bits",
            ">with copies",
            ">cycles",
            ">Mpixels/s a thread",
        ];
        let row = |rung: &Rung| {
            let mut row = vec![rung.pipeline.clone(), rung.width_bits.to_string()];
            let Some(m) = &rung.point.measured else { return row };
            let shown = |number: Option<f64>, scale: f64| {
                number.map_or_else(|| "-".to_owned(), |number| short(number * scale))
            };
            let count = |name| m.count(name).unwrap_or(0).to_string();
            row.extend([
                shown(figure(m, "picture", true), 255.0),
                shown(figure(m, "picture", false), 255.0),
                m.picture.map(|p| format!("{:.1}", p.psnr_db.0)).unwrap_or_default(),
                m.picture.map(|p| format!("{:.4}", p.flip.0)).unwrap_or_default(),
                shown(figure(m, "lt_angle", true), 1f64.to_degrees()),
                shown(figure(m, "lt_angle", false), 1f64.to_degrees()),
            ]);
            row.extend(m.operators().map(|count| count.to_string()));
            row.extend(["rom_bits", "rom_bits_dual_port", "latency_cycles"].map(count));
            row.push(format!("{:.1}", pixels_per_second(&self.header, m) / 1e6));
            row
        };
        let mut rows: Vec<Vec<String>> = self.rungs.iter().map(row).collect();
        refusals(&mut headings, &mut rows, self.rungs.iter().map(|r| r.point.error.as_deref()));
        Table::new(&headings, rows)
    }

    /// Light tables with their points, in order of exponent.
    fn light_tables(&self) -> Vec<((&str, u32), Vec<&LightPoint>)> {
        let mut tables: Vec<((&str, u32), Vec<&LightPoint>)> = Vec::new();
        for light in &self.exponents {
            let key = (light.scheme.as_str(), light.addr_bits);
            match tables.iter_mut().find(|(known, _)| *known == key) {
                Some((_, points)) => points.push(light),
                None => tables.push((key, vec![light])),
            }
        }
        tables
    }

    /// The largest difference by light table and exponent; `None` if light tables weren't judged.
    #[must_use]
    pub fn exponents_table(&self) -> Option<Table> {
        let tables = self.light_tables();
        let (_, first) = tables.first()?;
        let mut headings = ["light tables", ">ROM bits", ">mul"].map(str::to_owned).to_vec();
        headings.extend(first.iter().map(|light| format!(">n = {}", light.exponent)));
        let row = |((scheme, addr_bits), lights): &((&str, u32), Vec<&LightPoint>)| {
            let mut row = vec![format!("{scheme}, 2^{addr_bits}")];
            // Tables grow a little with the exponent because slopes need more bits.
            let measured = lights.iter().filter_map(|light| light.point.measured.as_ref());
            let most = |get: fn(&Measured) -> u64| {
                let most = measured.clone().map(get).max();
                most.map_or_else(|| "-".to_owned(), |most| most.to_string())
            };
            row.push(most(|m| m.count("rom_bits").unwrap_or(0)));
            row.push(most(|m| m.operators()[0]));
            row.extend(lights.iter().map(|light| match light.point.measured {
                Some(_) => short(error(&light.point)),
                None => "refused".to_owned(),
            }));
            row
        };
        let rows = tables.iter().map(row).collect();
        Some(Table { headings, rows })
    }

    /// Why light tables were refused, one line per reason.
    #[must_use]
    pub fn refused_tables(&self) -> Vec<String> {
        let mut reasons: Vec<(&str, Vec<String>)> = Vec::new();
        for light in &self.exponents {
            let Some(why) = &light.point.error else { continue };
            let LightPoint { exponent, scheme, addr_bits, .. } = light;
            let name = format!("{scheme} 2^{addr_bits} at n = {exponent}");
            match reasons.iter_mut().find(|(known, _)| known == why) {
                Some((_, names)) => names.push(name),
                None => reasons.push((why, vec![name])),
            }
        }
        let line = |(why, names): (&str, Vec<String>)| {
            format!("refused: {}, because {why}", names.join(", "))
        };
        reasons.into_iter().map(line).collect()
    }

    /// What the light tables achieve, in words; `None` if they weren't judged, or one of those
    /// named was refused.
    #[must_use]
    pub fn remedy(&self) -> Option<String> {
        let sharpest = self.exponents.iter().map(|light| light.exponent).max()?;
        let at = |scheme: &str, addr_bits| {
            self.exponents.iter().find(|light| {
                light.exponent == sharpest && light.scheme == scheme && light.addr_bits == addr_bits
            })
        };
        let sizes = self.exponents.iter().map(|light| light.addr_bits);
        let (least, most) = (sizes.clone().min()?, sizes.max()?);
        let shown = |scheme, addr_bits| {
            let point = &at(scheme, addr_bits)?.point;
            point.measured.is_some().then(|| short(error(point)))
        };
        Some(format!(
            "At exponent {sharpest}, the picture is off by up to {}/255 with direct tables of 2^{most} entries, {}/255 with linear ones (`light_scheme=linear`) of 2^{least} entries, {}/255 with linear ones of 2^{most} entries, and {}/255 with bipartite ones of 2^{most} entries.",
            shown("direct", most)?,
            shown("linear", least)?,
            shown("linear", most)?,
            shown("bipartite", most)?,
        ))
    }

    fn caption(&self) -> Vec<String> {
        vec![format!(
            "Scene {}; largest difference of any channel from the golden picture, in linear light.",
            self.header.scene.name
        )]
    }

    /// The plots and their files.
    fn charts(&self) -> Vec<(&'static str, Chart)> {
        let mut charts = vec![
            ("ladder_error_vs_rom.svg", self.error_vs_rom()),
            ("ladder_error_vs_speed.svg", self.error_vs_speed()),
        ];
        if !self.exponents.is_empty() {
            charts.push(("exponents.svg", self.error_vs_exponent()));
        }
        charts
    }

    /// One line per pipeline, from rung to rung.
    fn by_pipeline(&self, x: impl Fn(&Measured) -> f64) -> Vec<Series> {
        let mut all: Vec<Series> = Vec::new();
        for rung in &self.rungs {
            let Some(measured) = &rung.point.measured else { continue };
            let place = (x(measured), error(&rung.point));
            match all.iter_mut().find(|series| series.label == rung.pipeline) {
                Some(series) => series.points.push(place),
                None => all.push(Series {
                    label: rung.pipeline.clone(),
                    colour: all.len(),
                    mark: all.len(),
                    style: Style::Joined,
                    points: vec![place],
                }),
            }
        }
        all
    }

    fn widths(&self) -> String {
        let widths: Vec<String> = self.header.widths_bits.iter().map(u32::to_string).collect();
        format!("Marks along a line are rungs of {} bits.", widths.join(", "))
    }

    fn error_vs_rom(&self) -> Chart {
        let rom = |measured: &Measured| count(measured, "rom_bits_dual_port");
        let costs: Vec<(f64, f64)> = self
            .rungs
            .iter()
            .map(|rung| (rung.point.measured.as_ref().map_or(f64::NAN, rom), error(&rung.point)))
            .collect();
        let label = |rung: &Rung| format!("{}, {}", rung.pipeline, rung.width_bits);
        let best = pareto(&costs).into_iter();
        let points = best.map(|i| (costs[i].0, costs[i].1, label(&self.rungs[i]))).collect();
        let mut caption = self.caption();
        caption.push(self.widths());
        Chart {
            title: format!("{}: picture error against ROM bits", self.header.scene.name),
            caption,
            x: ("ROM bits, one copy per two read ports".to_owned(), Along::Log10),
            y: ("largest difference (1/255)".to_owned(), Along::Log10),
            series: self.by_pipeline(rom),
            front: Some(Front { label: "Pareto-optimal".to_owned(), points }),
        }
    }

    fn error_vs_speed(&self) -> Chart {
        let mut caption = self.caption();
        caption.push(format!(
            "{} Wall-clock time: affected by other load on the machine.",
            self.widths()
        ));
        Chart {
            title: format!("{}: picture error against simulation speed", self.header.scene.name),
            caption,
            x: ("bit-true engine alone (pixels per second and thread)".to_owned(), Along::Log10),
            y: ("largest difference (1/255)".to_owned(), Along::Log10),
            series: self.by_pipeline(|measured| pixels_per_second(&self.header, measured)),
            front: None,
        }
    }

    fn error_vs_exponent(&self) -> Chart {
        let mut schemes: Vec<&str> = Vec::new();
        let mut sizes: Vec<u32> = Vec::new();
        let mut series = Vec::new();
        for ((scheme, addr_bits), lights) in self.light_tables() {
            if !schemes.contains(&scheme) {
                schemes.push(scheme);
            }
            if !sizes.contains(&addr_bits) {
                sizes.push(addr_bits);
            }
            let mut points: Vec<(f64, f64)> =
                lights.iter().map(|l| (f64::from(l.exponent), error(&l.point))).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            series.push(Series {
                label: format!("{scheme}, 2^{addr_bits}"),
                colour: schemes.iter().position(|known| *known == scheme).unwrap_or(0),
                mark: sizes.iter().position(|known| *known == addr_bits).unwrap_or(0),
                style: Style::Joined,
                points,
            });
        }
        let mut caption = self.caption();
        caption.push("Colours show the scheme of the light tables, marks their size.".to_owned());
        Chart {
            title: format!("{}: picture error against the exponent", self.header.scene.name),
            caption,
            x: ("exponent of the highlight".to_owned(), Along::Log2),
            y: ("largest difference (1/255)".to_owned(), Along::Log10),
            series,
            front: None,
        }
    }

    fn markdown(&self) -> String {
        let mut text = String::new();
        // Writing to a string can't fail.
        let _ = self.report(&mut text);
        text
    }

    fn report(&self, text: &mut String) -> std::fmt::Result {
        let header = &self.header;
        writeln!(
            text,
            "# Ladder on {}\n\nfixpath {}.\n",
            escape::markdown(&header.scene.name),
            header.crate_version
        )?;
        writeln!(
            text,
            "- Scene {}, lights: {}; {}.",
            escape::markdown(&header.scene.to_string()),
            header.lights,
            coverage(header.covered_px, header.background_px)
        )?;
        let rung = |(key, less): &(String, u32)| match less {
            0 => format!("`{key}=w`"),
            less => format!("`{key}=w-{less}`"),
        };
        let parts: Vec<String> = header.rung.iter().map(rung).collect();
        writeln!(
            text,
            "- A rung of w bits sets {}. A pipeline skips parameters that its unit lacks, and keeps those that were set explicitly (`ladder.csv` lists them).",
            parts.join(", ")
        )?;
        for note in &header.scene.notes {
            writeln!(text, "- Note: {}.", escape::markdown(note))?;
        }
        writeln!(
            text,
            "- Differences are those from the golden picture (tangent-space bump mapping in `f64`), over every channel of the covered pixels, in linear light, here in 1/255. FLIP compares the 8-bit sRGB pictures. L' angle is the angle between the rotated light vector and that of the inputs before quantisation."
        )?;
        writeln!(
            text,
            "- Multipliers, adders, tables and cycles are those of one pass: a pixel under one light. \"With copies\" stores each table once per two read ports. Pixels per second are those of the bit-true engine alone, per thread; other load on the machine affects them.\n"
        )?;
        writeln!(text, "## Pipelines\n")?;
        text.push_str(&self.pipelines_table().markdown());
        let plot = |text: &mut String, file: &str| {
            let charts = self.charts();
            let found = charts.iter().find(|(known, _)| *known == file);
            found.map_or(Ok(()), |(_, chart)| {
                write!(text, "\n![{}]({file})\n", escape::markdown(&chart.title))
            })
        };
        plot(text, "ladder_error_vs_rom.svg")?;
        plot(text, "ladder_error_vs_speed.svg")?;
        let (Some(lights), Some(pipeline)) = (self.exponents_table(), &header.light_pipeline)
        else {
            return Ok(());
        };
        let parameters: Vec<String> =
            header.light_parameters.iter().map(|set| format!("`{set}`")).collect();
        writeln!(
            text,
            "\n## Light tables over exponents\n\nThe largest difference in 1/255 of pipeline {pipeline}. Its other parameters are so fine that the light tables dominate: {}, unless others were set. The exponent replaces the scene's, in the golden too. The diffuse and the specular table have the same size. ROM bits and multipliers are those of the whole pipeline.\n",
            parameters.join(", ")
        )?;
        text.push_str(&lights.markdown());
        for refused in self.refused_tables() {
            write!(text, "\n{}\n", escape::markdown(&refused))?;
        }
        if let Some(remedy) = self.remedy() {
            writeln!(text, "\n{remedy}")?;
        }
        plot(text, "exponents.svg")
    }
}

/// Fills rows that have no figures; if there are any, adds a column with the reasons.
pub fn refusals<'a>(
    headings: &mut Vec<&str>,
    rows: &mut [Vec<String>],
    why: impl Iterator<Item = Option<&'a str>>,
) {
    let why: Vec<Option<&str>> = why.collect();
    if why.iter().all(Option::is_none) {
        return;
    }
    for (row, why) in rows.iter_mut().zip(why) {
        row.resize(headings.len(), "-".to_owned());
        row.push(why.unwrap_or_default().to_owned());
    }
    headings.push("refused because");
}
