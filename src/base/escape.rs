//! Text from files, command lines and outside tools, made fit for where it is shown: it acts on no
//! terminal, stays on its line, ends in time, and says the same in Markdown as it is.

use std::borrow::Cow;

/// The most characters of a word or a name in a message.
const SHORT: usize = 60;
/// The most characters of a message: what comes first, and the remedy, which comes last.
const MESSAGE: [usize; 2] = [800, 400];

/// True if a terminal acts on a character, shows nothing for it, or turns the text around it.
pub(crate) fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}'
            | '\u{180b}'..='\u{180f}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{3164}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{ffa0}'
            | '\u{fff0}'..='\u{fffb}' | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}')
        // No character at all, which XML refuses.
        || matches!(c, '\u{fdd0}'..='\u{fdef}')
        || u32::from(c) & 0xfffe == 0xfffe
}

fn escaped(text: &str, stays: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(|c| is_hidden(c) && !stays(c)) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_hidden(c) && !stays(c) {
            // `\n`, `\u{1b}`: as Rust writes it.
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

/// A text for one line of a terminal, whole.
#[must_use]
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, |_| false)
}

/// Lines for a terminal, whole.
#[must_use]
pub fn lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| matches!(c, '\n' | '\t'))
}

/// A word or a name from outside for a message: its start, where it is long.
#[must_use]
pub fn short(text: &str) -> String {
    let start: String = text.chars().take(SHORT).collect();
    let end = if start.len() < text.len() { "…" } else { "" };
    line(&start).into_owned() + end
}

/// A message for one line of a terminal: where it is long, without its middle.
#[must_use]
pub fn message(text: &str) -> String {
    let [first, last] = MESSAGE;
    let place = |mut places: Box<dyn Iterator<Item = (usize, char)> + '_>, n: usize| {
        places.nth(n).map(|(place, _)| place)
    };
    let start = place(Box::new(text.char_indices()), first);
    let end = place(Box::new(text.char_indices().rev()), last - 1);
    match (start, end) {
        (Some(start), Some(end)) if start < end => {
            format!("{} … {}", line(&text[..start]), line(&text[end..]))
        }
        _ => line(text).into_owned(),
    }
}

/// A text inside a line or a table's cell of Markdown, where it shows as it is.
///
/// Marks get a backslash, `<` and `&` their entities, which every renderer knows; an underscore
/// inside a word marks nothing.
#[must_use]
pub fn markdown(text: &str) -> String {
    let text = line(text);
    let mut shown = String::with_capacity(text.len() + 16);
    let mut before = ' ';
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        let inside = |c: char| c.is_alphanumeric() || c == '_';
        match c {
            '<' => shown.push_str("&lt;"),
            '>' => shown.push_str("&gt;"),
            '&' => shown.push_str("&amp;"),
            '_' if inside(before) && chars.peek().is_some_and(|after| inside(*after)) => {
                shown.push(c);
            }
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '~' => shown.extend(['\\', c]),
            _ => shown.push(c),
        }
        before = c;
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_hidden_is_left() {
        let text = "a\u{1b}[31mb\nc\u{9b}1md\u{202e}e\u{7f}\u{200b}\u{feff}ü √";
        let shown = "a\\u{1b}[31mb\\nc\\u{9b}1md\\u{202e}e\\u{7f}\\u{200b}\\u{feff}ü √";
        assert_eq!(line(text), shown);
        assert_eq!(lines("a\tb\n\u{1b}c\r\n"), "a\tb\n\\u{1b}c\\r\n");
        // Unicode's default ignorables that aren't above, a noncharacter of each kind, blanks that
        // are letters.
        for c in [
            '\u{34f}',
            '\u{3164}',
            '\u{115f}',
            '\u{fe0f}',
            '\u{e0100}',
            '\u{ffff}',
            '\u{2fffe}',
            '\u{fdd0}',
        ] {
            assert_eq!(line(&c.to_string()), c.escape_default().to_string());
        }
        for code in 0..=0x0011_0000 {
            let Some(c) = char::from_u32(code) else { continue };
            assert!(!line(&c.to_string()).contains(is_hidden), "{code:x}");
            assert!(!markdown(&c.to_string()).contains(is_hidden), "{code:x}");
        }
    }

    #[test]
    fn long_texts_end() {
        assert_eq!(short(&"ä".repeat(60)), "ä".repeat(60));
        assert_eq!(short(&"ä".repeat(61)), "ä".repeat(60) + "…");
        assert_eq!(message(&"ä".repeat(1200)), "ä".repeat(1200));
        let told = message(&format!("{}: do that", "ä".repeat(50_000_000)));
        assert!(told.chars().count() < 1300, "{}", told.len());
        assert!(told.starts_with("ää") && told.ends_with("ä: do that"), "{told}");
        // Escapes make it longer, but not without end.
        assert!(message(&"\u{1b}".repeat(5000)).len() < 10_000);
    }

    #[test]
    fn markdown_marks_nothing() {
        assert_eq!(markdown("angle_bits=8 a|b"), "angle_bits=8 a\\|b");
        assert_eq!(markdown("_a_ *b* `c`\n"), "\\_a\\_ \\*b\\* \\`c\\`\\\\n");
        assert_eq!(markdown("<script>&[x](y)"), "&lt;script&gt;&amp;\\[x\\](y)");
    }
}
