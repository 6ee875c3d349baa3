//! Number parsers for clap. Whole numbers may have every form of [`crate::base::whole`].

use crate::base::whole;
use std::ops::RangeInclusive;

/// A parser of whole numbers in a range; its error states the range and the forms.
pub(super) fn whole(legal: RangeInclusive<u64>) -> impl Fn(&str) -> Result<u64, String> + Clone {
    move |text| {
        whole::parse(text).filter(|number| legal.contains(number)).ok_or_else(|| told(&legal))
    }
}

fn told(legal: &RangeInclusive<u64>) -> String {
    let most = match *legal.end() {
        u64::MAX => "2^64-1".to_owned(),
        most => most.to_string(),
    };
    format!(
        "write a whole number from {} to {most}: in digits, or as 1_000, 1e3 or 2^10",
        legal.start()
    )
}

/// A parser of real numbers; its error states the form.
pub(super) fn real(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| "write a number, such as 60 or 12.5".to_owned())
}

/// Cycles as `FIRST..END`.
pub(super) fn window(text: &str) -> Result<std::ops::Range<u64>, String> {
    let range = text.split_once("..").and_then(|(a, b)| Some(whole::parse(a)?..whole::parse(b)?));
    range
        .filter(|range| range.start < range.end)
        .ok_or_else(|| "write FIRST..END with FIRST below END, such as 10..60".to_owned())
}
