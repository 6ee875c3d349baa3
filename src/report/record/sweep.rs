//! The record of a sweep, and its files.

use super::csv::Columns;
use super::header::Header;
use super::measured::{Measured, Point, short};
use super::rank::{Lead, RankBy};
use crate::base::columns;
use crate::base::error::{Error, Result};
use crate::base::input;
use crate::base::json;
use crate::base::output;
use crate::measure::Basis;
use crate::shading::picture::coverage;
use serde::{Deserialize, Serialize};
use std::fs::OpenOptions;
use std::io;
use std::path::Path;

/// Largest `sweep.json` to read, in bytes: more than the largest sweep writes.
const MAX_BYTES: u64 = 1 << 32;

/// A sweep's result, from which the files and reports are made.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    /// What was swept.
    pub header: Header,
    /// Finished points in grid order.
    pub points: Vec<Point>,
}

impl Record {
    /// How many pixels the means of pictures are over, in words; `None` without a picture.
    #[must_use]
    pub fn coverage(&self) -> Option<String> {
        let picture = self.points.iter().find_map(|point| point.measured.as_ref()?.picture)?;
        Some(coverage(picture.covered_px, picture.background_px))
    }

    /// The leading quantity; angles are shown in degrees.
    #[must_use]
    pub fn lead(&self) -> Lead {
        if let Some(error) = self.image_error() {
            return error.lead();
        }
        let figures = self.points.iter().find_map(|p| p.measured.as_ref()?.figures.first());
        let (quantity, unit) = figures.map_or(("", ""), |f| (f.quantity.as_str(), f.unit.as_str()));
        let (scale, unit) = match unit {
            "rad" => (1f64.to_degrees(), "deg"),
            unit => (1.0, short(unit)),
        };
        let over = figures.and_then(|f| f.over.as_ref());
        let over = over.map(|over| format!(" relative to {over}")).unwrap_or_default();
        let what = format!("largest {quantity} error{over}");
        Lead { quantity: quantity.to_owned(), what, scale, unit }
    }

    /// The figure that ranks points over a scene; `None` without a scene.
    fn image_error(&self) -> Option<RankBy> {
        self.header.scene.as_ref().map(|_| self.header.error.unwrap_or_default())
    }

    /// The number that ranks a point on a basis, in the unit of [`lead`](Self::lead); NaN if there
    /// is none.
    #[must_use]
    pub fn error(&self, measured: &Measured, basis: Basis) -> f64 {
        let error = match self.image_error() {
            Some(error) => error.of(measured).unwrap_or(f64::NAN),
            None => measured.lead_max(basis),
        };
        error * self.lead().scale
    }

    /// The basis that ranks points: total, but end-to-end over a scene or if the points' input
    /// words differ. Against its own golden, a coarse input would look good.
    #[must_use]
    pub fn ranking(&self) -> Basis {
        if self.header.scene.is_some() {
            return Basis::EndToEnd;
        }
        let drawn = matches!(self.header.sampler.as_str(), "lit" | "sphere");
        if drawn && self.inputs_differ() { Basis::EndToEnd } else { Basis::Total }
    }

    /// True if points were measured over different input words.
    #[must_use]
    pub fn inputs_differ(&self) -> bool {
        let of =
            |measured: &'_ Measured| (measured.count("input_bits"), measured.input_formats.clone());
        let mut inputs = self.points.iter().filter_map(|p| p.measured.as_ref()).map(of);
        let first = inputs.next();
        inputs.any(|other| Some(&other) != first.as_ref())
    }

    /// Reads `sweep.json`; `None` if there is no such file.
    ///
    /// # Errors
    /// If the file can't be read or is not the result of a sweep.
    pub fn load(path: &Path) -> Result<Option<Self>> {
        let remedy = "choose another folder or pass --fresh";
        // Not by `input::open`: the sweep that reads the file rewrites it.
        let file = match input::open_with(OpenOptions::new().read(true), path) {
            Ok(file) => file,
            Err(why) if why.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(why) => return Err(Error::file(path, format!("can't read: {why}: {remedy}"))),
        };
        let bytes = input::read(file, path, MAX_BYTES)
            .map_err(|why| Error::usage(format!("{why}: {remedy}")))?;
        let malformed = |why: String| {
            Error::file(
                path,
                format!("is not a sweep result that this version reads ({why}): {remedy}"),
            )
        };
        let record: Self =
            serde_json::from_slice(&bytes).map_err(|why| malformed(why.to_string()))?;
        for (point, number) in record.points.iter().zip(1..) {
            let whole = match (&point.measured, &point.error) {
                (Some(measured), None) => {
                    let judged = match record.header.scene {
                        Some(_) => {
                            measured.picture.is_some() && measured.lead(Basis::EndToEnd).is_some()
                        }
                        None => measured.lead(Basis::Total).is_some(),
                    };
                    judged && measured.count("rom_bits_dual_port").is_some()
                }
                (None, error) => error.is_some(),
                (Some(_), Some(_)) => false,
            };
            if !whole {
                return Err(malformed(format!("point {number} is incomplete")));
            }
        }
        Ok(Some(record))
    }

    /// Writes `sweep.json`, one line per point.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn write_json<'a>(
        path: &Path,
        header: &Header,
        points: impl Iterator<Item = &'a Point>,
    ) -> Result<()> {
        output::write_file(path, |to| {
            let fail = output::at(path);
            let json = |why: serde_json::Error| fail(why.into());
            to.write_all(b"{").map_err(&fail)?;
            for (name, value) in json::head("sweep") {
                write!(to, "\"{name}\": {value}, ").map_err(&fail)?;
            }
            write!(to, "\"header\": ").map_err(&fail)?;
            serde_json::to_writer_pretty(&mut *to, header).map_err(json)?;
            write!(to, ",\n\"points\": [").map_err(&fail)?;
            for (index, point) in points.enumerate() {
                to.write_all(if index == 0 { b"\n" } else { b",\n" }).map_err(&fail)?;
                serde_json::to_writer(&mut *to, point).map_err(json)?;
            }
            to.write_all(b"\n]}\n").map_err(&fail)
        })
    }

    /// Writes `sweep.csv`; the module's documentation describes the columns.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn write_csv<'a>(
        path: &Path,
        header: &Header,
        points: impl Iterator<Item = &'a Point> + Clone,
    ) -> Result<()> {
        let columns = Columns::new(header, points.clone());
        let rows = points.map(|point| columns.row(point));
        output::write_file(path, |to| columns::write(to, path, &columns.names(), rows))
    }
}
