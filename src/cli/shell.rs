//! Commands to copy into a shell.

use std::path::Path;

/// A path as one word of a command.
pub(super) fn word(path: &Path) -> String {
    let bytes = path.as_os_str().as_encoded_bytes();
    let is_plain = |b: &u8| b.is_ascii_alphanumeric() || b"/._-+,:@%=".contains(b) || *b >= 0x80;
    // Otherwise programs would read it as an option.
    let before = if bytes.first() == Some(&b'-') { "./" } else { "" };
    match path.to_str() {
        Some(text) if !text.is_empty() && bytes.iter().all(is_plain) => format!("{before}{text}"),
        Some(text) if !text.chars().any(char::is_control) => {
            format!("'{before}{}'", text.replace('\'', r"'\''"))
        }
        // Bytes that a terminal would interpret, or that aren't text.
        Some(_) | None => {
            let escape = |b: &u8| match b {
                b'\'' | b'\\' => format!("\\{}", char::from(*b)),
                b' '..=b'~' => char::from(*b).to_string(),
                _ => format!("\\x{b:02x}"),
            };
            format!("$'{before}{}'", bytes.iter().map(escape).collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(unix)]
    fn bash_reads_a_word_as_the_path() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::{OsStrExt, OsStringExt};
        let names: [&[u8]; 9] = [
            b"a/b-c_1.vcd",
            b"two words.vcd",
            b"it's $(touch x) `y` \"z\" \\ !",
            "h\u{f6}he \u{2192}.vcd".as_bytes(),
            b"\x1b[31mred\nline\t'\\1f",
            b"\xff\xfe0 no text",
            b"~/home",
            b"",
            b"*",
        ];
        for name in names {
            let path = Path::new(OsStr::from_bytes(name));
            let script = format!("printf %s {}", word(path));
            let output = std::process::Command::new("bash").args(["-c", &script]).output().unwrap();
            let read = std::ffi::OsString::from_vec(output.stdout);
            assert_eq!(read.as_bytes(), name, "{script}");
        }
        assert_eq!(word(Path::new("a/b-c_1.vcd")), "a/b-c_1.vcd");
        assert_eq!(word(Path::new("-x.vcd")), "./-x.vcd");
        assert_eq!(word(Path::new("-x y")), "'./-x y'");
    }
}
