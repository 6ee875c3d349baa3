//! Rows of a CSV as they arrive: available rows are returned at once, and a row has a size limit.
//!
//! [`csv::Reader`] would wait for a full buffer, and accept a row of any length.

use std::io::{self, Read};

/// Longest row in bytes: thousands of columns.
pub(super) const ROW_BYTES: usize = 1 << 20;

/// Bytes per read: the more, the fewer blocks of rows.
const READ_BYTES: usize = 1 << 18;

/// Possible field separators, the likeliest first.
pub(super) const DELIMITERS: [u8; 3] = *b",;\t";

/// The outcome of asking for the next row.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Next {
    /// A whole row, whose fields can now be read.
    Row,
    /// No whole row, and getting more would block.
    Later,
    /// The end.
    End,
}

/// Why there is no next row.
#[derive(Debug)]
pub(super) enum Stop {
    /// The source can't be read.
    Io(io::Error),
    /// The row that begins in this line has more than [`ROW_BYTES`].
    TooLong(u64),
}

/// A source of CSV rows.
#[derive(Debug)]
pub(super) struct Records<R> {
    from: R,
    /// The bytes read; those before `start` are parsed.
    bytes: Vec<u8>,
    start: usize,
    parser: csv_core::Reader,
    /// Fields of the row, concatenated, and where each ends.
    fields: Vec<u8>,
    ends: Vec<usize>,
    /// How many fields' bytes and ends are filled.
    filled: (usize, usize),
    /// Lines begun so far, and the line in which the row began.
    line: u64,
    began: u64,
    after_return: bool,
    ended: bool,
    /// True if the current row is complete, so that the next call starts a new one.
    whole: bool,
}

impl<R: Read> Records<R> {
    /// Reads to the end of the first line that isn't blank, and picks the delimiter by it.
    pub(super) fn open(
        mut from: R,
        delimiter: impl FnOnce(&[u8]) -> u8,
    ) -> std::result::Result<Self, Stop> {
        let mut bytes = Vec::new();
        let is_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let line = loop {
            let first = bytes.iter().position(|byte| !is_end(byte)).unwrap_or(bytes.len());
            let end = bytes[first..].iter().position(is_end);
            if let Some(end) = end {
                break &bytes[first..first + end];
            }
            if bytes.len() > ROW_BYTES {
                return Err(Stop::TooLong(1));
            }
            if read_more(&mut from, &mut bytes).map_err(Stop::Io)? == 0 {
                break &bytes[first..];
            }
        };
        let parser = csv_core::ReaderBuilder::new().delimiter(delimiter(line)).build();
        Ok(Self {
            from,
            bytes,
            start: 0,
            parser,
            fields: vec![0; 1 << 10],
            ends: vec![0; 1 << 6],
            filled: (0, 0),
            line: 1,
            began: 1,
            after_return: false,
            ended: false,
            whole: true,
        })
    }

    /// Advances to the next row; reads from the source only if `wait` is set.
    pub(super) fn next(&mut self, wait: bool) -> std::result::Result<Next, Stop> {
        use csv_core::ReadRecordResult as Parsed;
        if std::mem::take(&mut self.whole) {
            self.filled = (0, 0);
            self.began = self.line;
        }
        loop {
            if self.start == self.bytes.len() && !self.ended {
                if !wait {
                    return Ok(Next::Later);
                }
                self.bytes.clear();
                self.start = 0;
                self.ended = read_more(&mut self.from, &mut self.bytes).map_err(Stop::Io)? == 0;
            }
            let (field, end) = self.filled;
            let from = &self.bytes[self.start..];
            let (parsed, taken, fields, ends) =
                self.parser.read_record(from, &mut self.fields[field..], &mut self.ends[end..]);
            for byte in &from[..taken] {
                // The end of a line is \n, \r or both.
                let ends = *byte == b'\r' || *byte == b'\n' && !self.after_return;
                self.line += u64::from(ends);
                self.after_return = *byte == b'\r';
            }
            self.start += taken;
            self.filled = (field + fields, end + ends);
            if self.filled.0 + self.filled.1 > ROW_BYTES {
                return Err(Stop::TooLong(self.began));
            }
            match parsed {
                Parsed::InputEmpty => {}
                Parsed::OutputFull => self.fields.resize(2 * self.fields.len(), 0),
                Parsed::OutputEndsFull => self.ends.resize(2 * self.ends.len(), 0),
                Parsed::Record => {
                    self.whole = true;
                    return Ok(Next::Row);
                }
                Parsed::End => return Ok(Next::End),
            }
        }
    }

    /// Number of fields of the row.
    pub(super) fn len(&self) -> usize {
        self.filled.1
    }

    /// A field of the row, without surrounding blanks.
    pub(super) fn field(&self, at: usize) -> &[u8] {
        let start = if at == 0 { 0 } else { self.ends[at - 1] };
        self.fields[start..self.ends[at]].trim_ascii()
    }

    /// The line in which the row ends, counted from 1.
    pub(super) fn line(&self) -> u64 {
        let ended = self.start > 0 && matches!(self.bytes[self.start - 1], b'\n' | b'\r');
        self.line - u64::from(ended)
    }
}

/// One read, appended to the bytes; returns the number of bytes read.
fn read_more(from: &mut impl Read, bytes: &mut Vec<u8>) -> io::Result<usize> {
    let there = bytes.len();
    bytes.resize(there + READ_BYTES, 0);
    let got = loop {
        match from.read(&mut bytes[there..]) {
            Err(why) if why.kind() == io::ErrorKind::Interrupted => {}
            got => break got,
        }
    };
    bytes.truncate(there + got.as_ref().copied().unwrap_or(0));
    got
}
