//! Tables, for terminals and as Markdown.

use crate::base::escape;

/// Rows under headings.
pub struct Table {
    /// Headings; those of right-aligned columns start with `>`.
    pub headings: Vec<String>,
    /// Rows.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Rows under headings; those of right-aligned columns start with `>`.
    #[must_use]
    pub fn new(headings: &[impl AsRef<str>], rows: Vec<Vec<String>>) -> Self {
        Self {
            headings: headings.iter().map(|heading| heading.as_ref().to_owned()).collect(),
            rows,
        }
    }

    /// The shown headings, and whether their columns are right-aligned.
    fn columns(&self) -> impl Iterator<Item = (&str, bool)> {
        let right = |heading: &String| heading.starts_with('>');
        self.headings.iter().map(move |heading| (heading.trim_start_matches('>'), right(heading)))
    }

    /// Columns padded to their widest cell. Every cell stays on one line.
    #[must_use]
    pub fn text(&self) -> String {
        let cells = |row: &Vec<String>| row.iter().map(|cell| escape::message(cell)).collect();
        let headings = self.columns().map(|(heading, _)| heading.to_owned()).collect();
        let lines: Vec<Vec<String>> =
            std::iter::once(headings).chain(self.rows.iter().map(cells)).collect();
        let width = |(column, (_, right)): (usize, (&str, bool))| {
            let cells = lines.iter().map(|row| row[column].chars().count());
            (cells.max().unwrap_or(0), right)
        };
        let widths: Vec<(usize, bool)> = self.columns().enumerate().map(width).collect();
        let mut text = String::new();
        for row in &lines {
            let padded = row.iter().zip(&widths).map(|(cell, &(width, right))| {
                if right { format!(" {cell:>width$}") } else { format!(" {cell:<width$}") }
            });
            let line: String = std::iter::once(" ".to_owned()).chain(padded).collect();
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }

    /// As Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        let rule = |right: bool| if right { "---:" } else { "---" }.to_owned();
        let mut text = row(self.columns().map(|(heading, _)| escape::markdown(heading)).collect());
        text.push_str(&row(self.columns().map(|(_, right)| rule(right)).collect()));
        for cells in &self.rows {
            text.push_str(&row(cells.iter().map(|cell| escape::markdown(cell)).collect()));
        }
        text
    }
}
