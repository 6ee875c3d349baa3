//! Text from files, command lines and outside tools, made safe for display: no terminal control
//! characters, one line, bounded length, and the same text when shown as Markdown.

use std::borrow::Cow;

/// Maximum characters of a word or a name in a message.
const SHORT: usize = 60;
/// Maximum characters kept of a long message: of its start, and of its end, which holds the remedy.
const MESSAGE: [usize; 2] = [800, 400];

/// True if a terminal acts on a character, displays nothing for it, or changes text direction.
pub(crate) fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}'
            | '\u{180b}'..='\u{180f}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{3164}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{ffa0}'
            | '\u{fff0}'..='\u{fffb}' | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}')
        // Noncharacters, which XML refuses.
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
            // `\n`, `\u{1b}`: Rust's escapes.
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

/// Escapes a text for one line of a terminal, in full.
#[must_use]
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, |_| false)
}

/// Escapes several lines for a terminal, in full.
#[must_use]
pub fn lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| matches!(c, '\n' | '\t'))
}

/// A word or a name from outside for a message, cut at 60 characters.
#[must_use]
pub fn short(text: &str) -> String {
    let start: String = text.chars().take(SHORT).collect();
    let end = if start.len() < text.len() { "…" } else { "" };
    line(&start).into_owned() + end
}

/// A message for one line of a terminal; a long one loses its middle.
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

/// Escapes a text for a line or a table cell of Markdown, so that it shows unchanged.
///
/// Markup characters get a backslash; `<` and `&` become entities, which every renderer knows. An
/// underscore inside a word is not markup.
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
        // Default-ignorable characters of Unicode that aren't above, a noncharacter of each kind,
        // and blanks that count as letters.
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
        // Escapes make it longer, but it stays bounded.
        assert!(message(&"\u{1b}".repeat(5000)).len() < 10_000);
    }

    #[test]
    fn markdown_marks_nothing() {
        assert_eq!(markdown("angle_bits=8 a|b"), "angle_bits=8 a\\|b");
        assert_eq!(markdown("_a_ *b* `c`\n"), "\\_a\\_ \\*b\\* \\`c\\`\\\\n");
        assert_eq!(markdown("<script>&[x](y)"), "&lt;script&gt;&amp;\\[x\\](y)");
    }
}
