//! Progress of long work, on the terminal.

use crate::base::escape;
use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// A bar on a terminal, nothing elsewhere.
pub(super) fn progress_bar(total: u64, what: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(
        "{prefix} [{bar:30}] {human_pos}/{human_len} {percent}% {per_sec}, {eta} left",
    );
    let bar = ProgressBar::new(total);
    bar.set_style(style.expect("bug: the template is right").progress_chars("=> "));
    bar.set_prefix(escape::short(what));
    bar
}

/// Animates a spinner if it is visible, since that needs a thread.
pub(super) fn tick(bar: &ProgressBar) {
    if !bar.is_hidden() {
        bar.enable_steady_tick(Duration::from_millis(200));
    }
}
