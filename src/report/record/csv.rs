//! Points as columns of `sweep.csv`.

use super::header::Header;
use super::measured::{Figures, PictureFigures, Point, Real, short};
use crate::base::cast;
use crate::base::columns::Field;
use crate::measure::Basis;
use std::collections::BTreeSet;

/// Columns of the CSV: everything that any of the points has.
pub(super) struct Columns {
    parameters: Vec<String>,
    counts: Vec<String>,
    /// Each quantity with its unit in column names.
    quantities: Vec<(String, &'static str)>,
    /// Quantities that have figures in ulp.
    with_ulp: BTreeSet<String>,
    bases: Vec<Basis>,
    /// Whether the points are pictures of a scene.
    pictures: bool,
}

/// Picks one of a picture's figures.
type PickOfPicture = fn(&PictureFigures) -> Field;

/// Figures of pictures in columns.
const PICTURE_FIGURES: [(&str, PickOfPicture); 7] = [
    ("picture_psnr_db", |p| p.psnr_db.0.into()),
    ("picture_ssim", |p| p.ssim.0.into()),
    ("picture_flip", |p| p.flip.0.into()),
    ("picture_covered_px", |p| p.covered_px.into()),
    ("picture_background_px", |p| p.background_px.into()),
    ("picture_srgb8_differing", |p| p.srgb8_differing.into()),
    ("picture_srgb8_max_codes", |p| u32::from(p.srgb8_max_codes).into()),
];

/// Picks one of the figures.
type Pick = fn(&Figures) -> Real;

/// Figures in columns.
const FIGURES: [(&str, Pick); 7] = [
    ("max", |f| f.max),
    ("mean", |f| f.mean),
    ("bias", |f| f.bias),
    ("rms", |f| f.rms),
    ("p50", |f| f.p50),
    ("p99", |f| f.p99),
    ("p999", |f| f.p999),
];

impl Columns {
    pub(super) fn new<'a>(header: &Header, points: impl Iterator<Item = &'a Point>) -> Self {
        let axes = header.axes.iter().map(|axis| &axis.key);
        let parameters = axes.chain(header.base.keys()).cloned().collect();
        let mut columns = Self {
            parameters,
            counts: Vec::new(),
            quantities: Vec::new(),
            with_ulp: BTreeSet::new(),
            bases: Vec::new(),
            pictures: header.scene.is_some(),
        };
        for measured in points.filter_map(|point| point.measured.as_ref()) {
            for name in measured.counts.keys() {
                if !columns.counts.contains(name) {
                    columns.counts.push(name.clone());
                }
            }
            for figures in &measured.figures {
                if columns.quantities.iter().all(|(name, _)| *name != figures.quantity) {
                    columns.quantities.push((figures.quantity.clone(), short(&figures.unit)));
                }
                if !columns.pictures && figures.unit == "1" && !figures.quantity.ends_with("dot") {
                    columns.with_ulp.insert(figures.quantity.clone());
                }
                if !columns.bases.contains(&figures.basis) {
                    columns.bases.push(figures.basis);
                }
            }
        }
        columns
    }

    pub(super) fn names(&self) -> Vec<String> {
        let mut names = self.parameters.clone();
        // Some units have a parameter of that name, and many readers reject two columns with the
        // same name.
        names.extend(self.counts.iter().map(|name| match self.parameters.contains(name) {
            true => format!("counted_{name}"),
            false => name.clone(),
        }));
        names.push("samples".to_owned());
        for (quantity, unit) in &self.quantities {
            for basis in &self.bases {
                let basis = basis.name().replace('-', "_");
                for (figure, _) in FIGURES {
                    names.push(format!("{quantity}_{basis}_{figure}_{unit}"));
                }
                if self.with_ulp.contains(quantity) {
                    names.push(format!("{quantity}_{basis}_max_ulp"));
                }
            }
        }
        let lead = self.quantities.first().map_or("lead", |(quantity, _)| quantity.as_str());
        if self.pictures {
            names.extend(PICTURE_FIGURES.map(|(name, _)| name.to_owned()));
            names.push("picture_witness".to_owned());
        } else {
            names.push(format!("{lead}_total_witness"));
        }
        names.extend(
            [
                "overflows",
                "samples_per_second",
                "threads",
                "engine_samples_per_second_per_thread",
                "error",
            ]
            .map(str::to_owned),
        );
        names
    }

    pub(super) fn row(&self, point: &Point) -> Vec<Field> {
        let mut row: Vec<Field> = self.parameters.iter().map(|key| point.field(key)).collect();
        let measured = point.measured.as_ref();
        row.extend(
            self.counts.iter().map(|name| Field::from(measured.and_then(|m| m.count(name)))),
        );
        row.push(measured.map(|m| m.samples).into());
        for (quantity, _) in &self.quantities {
            for basis in &self.bases {
                let figures = measured.and_then(|m| m.figures(quantity, *basis));
                row.extend(FIGURES.map(|(_, get)| Field::from(figures.map(|f| get(f).0))));
                if self.with_ulp.contains(quantity) {
                    row.push(figures.and_then(|f| Some(f.max_ulp?.0)).into());
                }
            }
        }
        if self.pictures {
            let picture = measured.and_then(|measured| measured.picture.as_ref());
            row.extend(PICTURE_FIGURES.map(|(_, get)| picture.map_or(Field::Missing, get)));
        }
        match measured {
            Some(measured) => {
                let speed = &measured.speed;
                row.extend([
                    measured.witness().into(),
                    measured.overflows.iter().map(|o| o.count).sum::<u64>().into(),
                    speed.samples_per_second.into(),
                    cast::count_of(speed.threads).into(),
                    speed.engine_samples_per_second_per_thread.into(),
                ]);
            }
            None => row.extend([const { Field::Missing }; 5]),
        }
        row.push(point.error.clone().into());
        row
    }
}
