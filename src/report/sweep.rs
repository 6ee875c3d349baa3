//! Writes the report of a sweep to files.

use super::markdown;
use super::plot;
use super::record::Record;
use crate::base::error::Result;
use crate::base::output;
use std::path::Path;

/// Every file that [`write()`] may write.
pub const FILES: [&str; 5] = [
    "report.md",
    "error_vs_table.svg",
    "error_vs_axis.svg",
    "error_vs_rom.svg",
    "error_vs_speed.svg",
];

/// Writes `report.md` and the plots that it links to into a folder.
///
/// # Errors
/// If a file can't be written.
pub fn write(folder: &Path, record: &Record) -> Result<()> {
    let plots = plot::plots(record);
    let text = |name: &str, text: &str| {
        let path = folder.join(name);
        output::write_file(&path, |to| to.write_all(text.as_bytes()).map_err(output::at(&path)))
    };
    for plot in &plots {
        text(plot.file, &plot.svg)?;
    }
    text("report.md", &markdown::sweep(record, &plots))
}
