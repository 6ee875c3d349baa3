//! `fixpath render --ladder`: whole pipelines over widths, and light tables over exponents.

use super::progress::progress_bar;
use super::text;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::base::output::Set;
use crate::base::whole;
use crate::report::ladder::Record;
use crate::shading::picture::coverage;
use crate::shading::render::Pipeline;
use crate::shading::scene::Scene;
use crate::sweep::ladder::{self, EXPONENTS, LEGAL_EXPONENTS, LEGAL_WIDTHS, Ladder, WIDTHS};
use std::fmt::Write as _;
use std::ops::RangeInclusive;
use std::path::Path;

/// Name of the output set of a ladder, whatever its pipelines.
const SET: &str = "ladder";

/// Parses a list of whole numbers, all legal and none repeated.
fn numbers(what: &str, list: &str, legal: &RangeInclusive<u32>) -> Result<Vec<u32>> {
    let mut numbers = Vec::new();
    for item in list.split(',').map(str::trim) {
        let number = whole::parse(item).and_then(|number| number.try_into().ok());
        let number = number.filter(|number| legal.contains(number));
        let number = number.ok_or_else(|| {
            let (least, most) = (legal.start(), legal.end());
            Error::usage(format!("{what} `{item}`: legal are whole numbers from {least} to {most}"))
        })?;
        if numbers.contains(&number) {
            return Err(Error::usage(format!("{what} {number} is given twice")));
        }
        numbers.push(number);
    }
    Ok(numbers)
}

/// The ladder asked for on the command line. An empty list of widths, or no list of exponents,
/// selects the defaults.
pub(super) fn ladder(
    pipelines: Vec<Pipeline>,
    widths: &str,
    exponents: Option<&str>,
    pixels_per_degree: f64,
) -> Result<Ladder> {
    Ok(Ladder {
        pipelines,
        widths: match widths {
            "" => WIDTHS.to_vec(),
            list => numbers("width", list, &LEGAL_WIDTHS)?,
        },
        exponents: match exponents {
            None => EXPONENTS.to_vec(),
            Some(list) => numbers("exponent", list, &LEGAL_EXPONENTS)?,
        },
        pixels_per_degree,
    })
}

/// Runs the ladder and writes its files; returns the text to print.
pub(super) fn run(
    ladder: &Ladder,
    scene: &Scene,
    name: &str,
    out: &Path,
    as_json: bool,
) -> Result<String> {
    let mut set = Set::open(out, SET)?;
    set.expect(crate::report::ladder::FILES)?;
    let bar = progress_bar(cast::count_of(ladder.pictures(scene)), "pictures");
    let record = ladder.climb(scene, name, &|done| bar.set_position(cast::count_of(done)))?;
    bar.finish_and_clear();
    record.write(&set.path())?;
    set.commit()?;
    if as_json {
        return Ok(json::text(&record.json()));
    }
    Ok(told(&record, out))
}

/// Runs a ladder of emboss pipelines and writes its files; returns the text to print, and false if
/// a bound is broken.
pub(super) fn run_emboss(
    pipelines: &[Pipeline],
    widths: &str,
    pixels_per_degree: f64,
    (scene, name): (&Scene, &str),
    (out, as_json): (&Path, bool),
) -> Result<(String, bool)> {
    use ladder::emboss::{self, LEGAL_WIDTHS, WIDTHS};
    let widths = match widths {
        "" => WIDTHS.to_vec(),
        list => numbers("width", list, &LEGAL_WIDTHS)?,
    };
    let mut set = Set::open(out, SET)?;
    set.expect(emboss::FILES)?;
    let bar = progress_bar(cast::count_of(emboss::pictures(pipelines, &widths)), "pictures");
    let done = |done| bar.set_position(cast::count_of(done));
    let record = emboss::climb(scene, name, pipelines, &widths, pixels_per_degree, &done)?;
    bar.finish_and_clear();
    record.write(&set.path())?;
    set.commit()?;
    let held = record.bounds_hold();
    if as_json {
        return Ok((json::text(&record.json()), held));
    }
    let mut told = format!(
        "scene {}: {}; differences from the golden, in linear light\n{}",
        record.scene,
        coverage(record.covered_px, record.background_px),
        record.table().text()
    );
    let _ = writeln!(told, "see {}", out.join("ladder.md").display());
    if !held {
        told.push_str(text::BROKEN);
    }
    Ok((told, held))
}

fn told(record: &Record, out: &Path) -> String {
    let header = &record.header;
    let mut told = format!(
        "scene {}: {}; differences from the golden, in linear light\n",
        header.scene,
        coverage(header.covered_px, header.background_px)
    );
    told.push_str(&record.pipelines_table().text());
    if let (Some(table), Some(pipeline)) = (record.exponents_table(), &header.light_pipeline) {
        let _ = writeln!(
            told,
            "\nmax/255 by exponent n of the highlight and light tables, pipeline {pipeline}, all else fine"
        );
        told.push_str(&table.text());
        for refused in record.refused_tables() {
            let _ = writeln!(told, "{refused}");
        }
    }
    if let Some(remedy) = record.remedy() {
        let _ = writeln!(told, "{remedy}");
    }
    let _ = writeln!(told, "see {}", out.join("ladder.md").display());
    told
}
