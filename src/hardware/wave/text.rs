//! Value changes of a VCD as bytes.
//!
//! The `vcd` crate writes the header and assigns the identifiers. Its writer of changes formats bit
//! by bit, which took nine tenths of a wave's time. So this module puts the millions of lines after
//! the header straight into one buffer, without allocation. Bits come eight at a time from a table,
//! and reals are the shortest text that reads back as the same `f64`.

use crate::base::cast;
use std::io::{self, Write};
use vcd::IdCode;

/// Bytes written at once: few calls, and the buffer stays in the second-level cache.
const BUFFER: usize = 1 << 17;

/// Room for a blank, an identifier and a newline; enough for more variables than fit into memory.
const END: usize = 8;

/// The longest line: a mark, 63 bits in whole bytes, and the end. Reals need at most 24 characters.
const LINE: usize = 1 + 64 + END;

/// The binary digits of each byte.
const DIGITS: [[u8; 8]; 256] = {
    let mut digits = [[b'0'; 8]; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut bit = 0;
        while bit < 8 {
            if byte >> (7 - bit) & 1 == 1 {
                digits[byte][bit] = b'1';
            }
            bit += 1;
        }
        byte += 1;
    }
    digits
};

/// The end of a variable's line: a blank, its identifier, a newline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Code {
    end: [u8; END],
    len: usize,
}

impl From<IdCode> for Code {
    fn from(code: IdCode) -> Self {
        let text = format!(" {code}\n");
        let mut end = [0; END];
        end[..text.len()].copy_from_slice(text.as_bytes());
        Self { end, len: text.len() }
    }
}

/// Buffered lines of a file.
pub(super) struct Lines<'a> {
    to: &'a mut dyn Write,
    bytes: Box<[u8]>,
    /// Bytes that aren't written yet.
    len: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(to: &'a mut dyn Write) -> Self {
        Self { to, bytes: vec![0; BUFFER].into_boxed_slice(), len: 0 }
    }

    /// Writes what is in the buffer.
    pub(super) fn flush(&mut self) -> io::Result<()> {
        self.empty()?;
        self.to.flush()
    }

    #[cold]
    fn empty(&mut self) -> io::Result<()> {
        let len = std::mem::take(&mut self.len);
        self.to.write_all(&self.bytes[..len])
    }

    /// Room for a line; bytes beyond `len` are overwritten later.
    #[inline(always)]
    fn line(&mut self) -> io::Result<&mut [u8; LINE]> {
        if BUFFER - self.len < LINE {
            self.empty()?;
        }
        Ok(self.bytes[self.len..].first_chunk_mut().expect("bug: there is room"))
    }

    /// Text of any length.
    pub(super) fn text(&mut self, text: &str) -> io::Result<()> {
        for piece in text.as_bytes().chunks(LINE) {
            self.line()?[..piece.len()].copy_from_slice(piece);
            self.len += piece.len();
        }
        Ok(())
    }

    /// The time of the lines that follow.
    pub(super) fn timestamp(&mut self, ps: u64) -> io::Result<()> {
        // At most 20 digits.
        let line = self.line()?;
        let (mut rest, mut at) = (ps, LINE);
        loop {
            at -= 1;
            line[at] = b'0' + u8::try_from(rest % 10).expect("bug: a digit");
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        let end = 1 + LINE - at;
        line.copy_within(at.., 1);
        line[0] = b'#';
        line[end] = b'\n';
        self.len += end + 1;
        Ok(())
    }

    /// A variable of one bit, given as its character.
    #[inline(always)]
    fn scalar(&mut self, value: u8, code: &Code) -> io::Result<()> {
        let line = self.line()?;
        line[..END].copy_from_slice(&code.end);
        // The value overwrites the blank.
        line[0] = value;
        self.len += code.len;
        Ok(())
    }

    /// A variable of one bit.
    pub(super) fn flag(&mut self, value: bool, code: &Code) -> io::Result<()> {
        self.scalar(b'0' + u8::from(value), code)
    }

    /// A variable of `bits` bits; `x` if its pattern is unknown.
    #[inline(always)]
    pub(super) fn word(&mut self, pattern: Option<u64>, bits: u32, code: &Code) -> io::Result<()> {
        if bits == 1 {
            return self.scalar(pattern.map_or(b'x', |p| b'0' + u8::from(p != 0)), code);
        }
        let line = self.line()?;
        line[0] = b'b';
        let end = if let Some(pattern) = pattern {
            // The first digit is the top bit of the first byte.
            let bytes = (pattern << (64 - bits)).to_be_bytes();
            let digits = line[1..].as_chunks_mut().0;
            for (to, byte) in digits.iter_mut().zip(bytes).take(cast::index_of_u32(bits + 7) / 8) {
                *to = DIGITS[usize::from(byte)];
            }
            1 + cast::index_of_u32(bits)
        } else {
            line[1] = b'x';
            2
        };
        line[end..end + END].copy_from_slice(&code.end);
        self.len += end + code.len;
        Ok(())
    }

    /// A real variable.
    pub(super) fn real(&mut self, value: f64, code: &Code) -> io::Result<()> {
        let line = self.line()?;
        line[0] = b'r';
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format(value).as_bytes();
        let end = 1 + text.len();
        line[1..end].copy_from_slice(text);
        line[end..end + END].copy_from_slice(&code.end);
        self.len += end + code.len;
        Ok(())
    }

    /// A string variable; the text must not contain blanks.
    pub(super) fn string(&mut self, value: &str, code: &Code) -> io::Result<()> {
        self.text("s")?;
        self.text(value)?;
        self.line()?[..END].copy_from_slice(&code.end);
        self.len += code.len;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The `vcd` crate's own writer defines what each line must be.
    #[test]
    fn lines_are_those_of_the_vcd_crate() {
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        let mut lines = Lines::new(&mut ours);
        let mut writer = vcd::Writer::new(&mut theirs);
        let mut state = 1u64;
        for round in 0..20_000u64 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let id = IdCode::from(state >> (28 + round % 36));
            let code = Code::from(id);
            let bits = u32::try_from(1 + round % 63).unwrap();
            let pattern = state.rotate_left(17) >> (64 - bits);
            let digit = |bit: u32| vcd::Value::from(pattern >> bit & 1 == 1);
            match (bits, round % 5) {
                (1, 0) => writer.change_scalar(id, vcd::Value::X),
                (1, _) => writer.change_scalar(id, digit(0)),
                (_, 0) => writer.change_vector(id, [vcd::Value::X]),
                (_, _) => writer.change_vector(id, (0..bits).rev().map(digit)),
            }
            .unwrap();
            lines.word((round % 5 > 0).then_some(pattern), bits, &code).unwrap();
            let time = state >> (round % 64);
            writer.timestamp(time).unwrap();
            lines.timestamp(time).unwrap();
            writer.change_scalar(id, round % 2 == 1).unwrap();
            lines.flag(round % 2 == 1, &code).unwrap();
            let text = "long".repeat(usize::try_from(round % 50).unwrap());
            writer.change_string(id, &text).unwrap();
            lines.string(&text, &code).unwrap();
        }
        for time in [0, 9, 10, u64::MAX] {
            writer.timestamp(time).unwrap();
            lines.timestamp(time).unwrap();
        }
        lines.flush().unwrap();
        assert!(ours == theirs, "{} and {} bytes", ours.len(), theirs.len());
    }

    #[test]
    fn reals_read_back_as_the_same_number() {
        let mut bytes = Vec::new();
        let mut lines = Lines::new(&mut bytes);
        let mut values = vec![
            0.0,
            -0.0,
            1e-300,
            f64::MIN_POSITIVE,
            f64::MIN,
            f64::NAN,
            f64::NEG_INFINITY,
            360.0,
        ];
        values.extend((1..2000).map(|i| f64::from(i) / 7.0 * 10f64.powi(i % 600 - 300)));
        let code = Code::from(IdCode::FIRST);
        values.iter().for_each(|value| lines.real(*value, &code).unwrap());
        lines.flush().unwrap();
        let read = String::from_utf8(bytes).unwrap();
        let read: Vec<u64> = read
            .lines()
            .map(|line| line.strip_prefix('r').unwrap().strip_suffix(" !").unwrap())
            .map(|text| text.parse::<f64>().unwrap().to_bits())
            .collect();
        let should: Vec<u64> = values.iter().map(|value| value.to_bits()).collect();
        assert_eq!(read, should);
    }
}
