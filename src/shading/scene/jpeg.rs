//! Checks whether a JPEG file is complete.
//!
//! Decoders are lenient: where data end early or are invalid they continue with grey, as viewers
//! want. The result is then silently a different picture. This check walks through the Huffman
//! codes of every scan (ITU-T T.81, annexes F and G). It keeps only which coefficients are nonzero,
//! and requires each scan to have exactly as many blocks as the header says.

/// The most scans of a file; encoders write about 10.
const MAX_SCANS: usize = 100;

/// A table of codes (annex C): the codes of each length are consecutive.
#[derive(Clone, Default)]
struct Huffman {
    /// Number of codes of 1 to 16 bits.
    counts: [u8; 16],
    /// The symbols that they stand for, by length.
    symbols: Vec<u8>,
}

/// A component of the frame.
struct Component {
    id: u8,
    /// Samples across and down in one unit of the frame.
    sampling: [usize; 2],
    /// Blocks across and down: of the component alone, and rounded up to whole units.
    alone: [usize; 2],
    padded: [usize; 2],
    /// Which coefficients of each block are nonzero; only for progressive frames.
    nonzero: Vec<u64>,
    /// True once a scan contained it.
    seen: bool,
}

struct Frame {
    progressive: bool,
    /// Units across and down.
    units: [usize; 2],
    components: Vec<Component>,
}

/// What a scan codes.
struct Scan {
    /// First and last coefficient.
    band: [usize; 2],
    /// True if it adds a bit to what earlier scans coded.
    refines: bool,
    /// Components by index, with their DC and AC tables.
    parts: Vec<(usize, Huffman, Huffman)>,
}

/// The state of the walk through a file.
struct Walk<'a> {
    bytes: &'a [u8],
    at: usize,
    dc: [Huffman; 4],
    ac: [Huffman; 4],
    /// Units between restarts; 0 for none.
    interval: usize,
    frame: Option<Frame>,
    scans: usize,
}

/// Checks the bytes of a file.
///
/// # Errors
/// If the data end too early or are invalid; the message names the byte and the problem.
pub(super) fn check(bytes: &[u8]) -> Result<(), String> {
    let (dc, ac) = Default::default();
    let mut walk = Walk { bytes, at: 0, dc, ac, interval: 0, frame: None, scans: 0 };
    walk.file().map_err(|problem| {
        format!(
            "is cut off or damaged at byte {} of {}: {problem}; copy or export it again",
            walk.at.min(bytes.len()),
            bytes.len()
        )
    })
}

impl<'a> Walk<'a> {
    fn file(&mut self) -> Result<(), String> {
        loop {
            match self.marker()? {
                // Start of image, restarts outside a scan, and TEM, which has no payload.
                0xd8 | 0xd0..=0xd7 | 0x01 => {}
                0xd9 => return self.end(),
                marker => {
                    let segment = self.segment()?;
                    match marker {
                        0xc4 => self.tables(segment)?,
                        0xc0..=0xc2 if self.frame.is_some() => {
                            return Err("a second frame".to_owned());
                        }
                        0xc0..=0xc2 => self.frame = Some(frame(segment, marker == 0xc2)?),
                        // Lossless and arithmetic coding: the decoder reports that it doesn't
                        // support them.
                        0xc3 | 0xc5..=0xc7 | 0xc9..=0xcb | 0xcd..=0xcf => return Ok(()),
                        0xdd => {
                            let interval = segment.first_chunk().ok_or("a short segment")?;
                            self.interval = usize::from(u16::from_be_bytes(*interval));
                        }
                        0xda => self.scan(segment)?,
                        _ => {}
                    }
                }
            }
        }
    }

    /// Checks that every component had a scan when the image ends.
    fn end(&self) -> Result<(), String> {
        let frame = self.frame.as_ref().ok_or("there is no frame")?;
        match frame.components.iter().find(|component| !component.seen) {
            Some(Component { id, .. }) => Err(format!("component {id} has no scan")),
            None => Ok(()),
        }
    }

    fn byte(&mut self) -> Result<u8, String> {
        let byte = self.bytes.get(self.at).copied();
        self.at += 1;
        byte.ok_or_else(|| "the file ends within the picture".to_owned())
    }

    /// The next marker, which any number of 0xff may precede. Decoders ignore all other bytes
    /// between segments.
    fn marker(&mut self) -> Result<u8, String> {
        loop {
            while self.byte()? != 0xff {}
            let mut byte = 0xff;
            while byte == 0xff {
                byte = self.byte()?;
            }
            if byte != 0 {
                return Ok(byte);
            }
        }
    }

    /// The bytes of a segment. Its length precedes them and includes itself.
    fn segment(&mut self) -> Result<&'a [u8], String> {
        let len = usize::from(u16::from_be_bytes([self.byte()?, self.byte()?]));
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let segment = len.checked_sub(2).and_then(|len| rest.get(..len));
        let segment = segment.ok_or_else(|| format!("a segment of {len} bytes"))?;
        self.at += segment.len();
        Ok(segment)
    }

    /// Tables of codes (B.2.4.2).
    fn tables(&mut self, mut segment: &[u8]) -> Result<(), String> {
        let short = || "a table of codes is short".to_owned();
        while let Some((place, rest)) = segment.split_first() {
            let (counts, rest) = rest.split_first_chunk::<16>().ok_or_else(short)?;
            let len = counts.iter().map(|count| usize::from(*count)).sum();
            let (symbols, rest) = rest.split_at_checked(len).ok_or_else(short)?;
            let tables = if place >> 4 == 0 { &mut self.dc } else { &mut self.ac };
            let table = tables.get_mut(usize::from(place & 15));
            let table = table.ok_or_else(|| format!("there is no table {place:#04x}"))?;
            *table = Huffman { counts: *counts, symbols: symbols.to_vec() };
            segment = rest;
        }
        Ok(())
    }

    fn scan(&mut self, header: &[u8]) -> Result<(), String> {
        self.scans += 1;
        if self.scans > MAX_SCANS {
            return Err(format!("more than {MAX_SCANS} scans, the most that are read"));
        }
        let mut frame = self.frame.take().ok_or("a scan before the frame")?;
        let scan = self.scan_header(header, &frame)?;
        let number = self.scans;
        let mut units = Units { bits: Bits::new(self.bytes, self.at), end_run: 0 };
        let walked = units.walk(&scan, &mut frame, self.interval);
        self.at = units.bits.at;
        walked.map_err(|problem| format!("{problem} of scan {number}"))?;
        scan.parts.iter().for_each(|(part, ..)| frame.components[*part].seen = true);
        self.frame = Some(frame);
        Ok(())
    }

    fn scan_header(&self, header: &[u8], frame: &Frame) -> Result<Scan, String> {
        let wrong = || "the header of a scan makes no sense".to_owned();
        let (count, rest) = header.split_first().ok_or_else(wrong)?;
        let (parts, rest) = rest.split_at_checked(2 * usize::from(*count)).ok_or_else(wrong)?;
        let [first, last, bits] = *rest else { return Err(wrong()) };
        let (band, refines) = if frame.progressive {
            ([usize::from(first), usize::from(last)], bits >> 4 > 0)
        } else {
            ([0, 63], false)
        };
        // Beyond the first coefficient a progressive scan has a single component (G.1.1.1).
        let mixed = frame.progressive && (band[0] == 0) != (band[1] == 0);
        if band[0] > band[1] || band[1] > 63 || mixed || (band[0] > 0 && *count != 1) {
            return Err(wrong());
        }
        let part = |part: &[u8]| {
            let of = |tables: &[Huffman; 4], i: u8| tables.get(usize::from(i)).cloned();
            let component = frame.components.iter().position(|c| c.id == part[0]);
            Some((component?, of(&self.dc, part[1] >> 4)?, of(&self.ac, part[1] & 15)?))
        };
        let parts = parts.chunks_exact(2).map(part).collect::<Option<Vec<_>>>();
        let parts = parts.filter(|parts| !parts.is_empty()).ok_or_else(wrong)?;
        Ok(Scan { band, refines, parts })
    }
}

/// The header of a frame (B.2.2).
fn frame(segment: &[u8], progressive: bool) -> Result<Frame, String> {
    let wrong = || "the header of the frame makes no sense".to_owned();
    let (head, rest) = segment.split_first_chunk::<6>().ok_or_else(wrong)?;
    let side = |i: usize| usize::from(u16::from_be_bytes([head[i], head[i + 1]]));
    let size = [side(3), side(1)];
    let given = rest.get(..3 * usize::from(head[5])).filter(|given| given.len() <= 12);
    let given = given.ok_or_else(wrong)?;
    let sampling = |part: &[u8]| [usize::from(part[1] >> 4), usize::from(part[1] & 15)];
    let samplings: Vec<[usize; 2]> = given.chunks_exact(3).map(sampling).collect();
    if samplings.as_flattened().iter().any(|n| !(1..=4).contains(n)) || size.contains(&0) {
        return Err(wrong());
    }
    let most = [0, 1].map(|axis| samplings.iter().map(|s| s[axis]).max().unwrap_or(1));
    let units = [0, 1].map(|axis| size[axis].div_ceil(8 * most[axis]));
    let component = |(part, sampling): (&[u8], &[usize; 2])| {
        let padded = [0, 1].map(|axis| units[axis] * sampling[axis]);
        Component {
            id: part[0],
            sampling: *sampling,
            alone: [0, 1]
                .map(|axis| (size[axis] * sampling[axis]).div_ceil(most[axis]).div_ceil(8)),
            padded,
            nonzero: vec![0; if progressive { padded[0] * padded[1] } else { 0 }],
            seen: false,
        }
    };
    let components = given.chunks_exact(3).zip(&samplings).map(component).collect();
    Ok(Frame { progressive, units, components })
}

/// The units of a scan, in order.
struct Units<'a> {
    bits: Bits<'a>,
    /// Blocks that follow without further coefficients (G.1.2.2).
    end_run: usize,
}

impl Units<'_> {
    fn walk(&mut self, scan: &Scan, frame: &mut Frame, interval: usize) -> Result<(), String> {
        let alone = match *scan.parts.as_slice() {
            [(part, ..)] => Some(frame.components[part].alone),
            _ => None,
        };
        let [columns, rows] = alone.unwrap_or(frame.units);
        let count = columns * rows;
        for unit in 0..count {
            if interval > 0 && unit > 0 && unit % interval == 0 {
                self.bits.restart((unit / interval - 1) % 8)?;
                self.end_run = 0;
            }
            let (x, y) = (unit % columns, unit / columns);
            for (part, dc, ac) in &scan.parts {
                let component = &mut frame.components[*part];
                let [across, down] = if alone.is_some() { [1, 1] } else { component.sampling };
                for block in 0..across * down {
                    let column = x * across + block % across;
                    let row = y * down + block / across;
                    let mut unkept = 0;
                    let place = row * component.padded[0] + column;
                    let nonzero = component.nonzero.get_mut(place).unwrap_or(&mut unkept);
                    let walked = if frame.progressive {
                        self.progressive(scan, [dc, ac], nonzero)
                    } else {
                        self.sequential([dc, ac])
                    };
                    walked.map_err(|problem| format!("{problem}, in unit {unit} of {count}"))?;
                }
            }
        }
        self.bits.finish().map_err(|problem| format!("{problem} after {count} units"))
    }

    /// Skips the difference of a block's first coefficient to the previous block (F.1.2.1).
    fn constant(&mut self, dc: &Huffman) -> Result<(), String> {
        let size = self.bits.code(dc)?;
        if size > 15 {
            return Err(format!("code {size:#04x} is invalid"));
        }
        self.bits.take(size).map(|_| ())
    }

    /// A block of a sequential frame (F.1.2).
    fn sequential(&mut self, [dc, ac]: [&Huffman; 2]) -> Result<(), String> {
        self.constant(dc)?;
        let mut k = 1;
        while k <= 63 {
            let symbol = self.bits.code(ac)?;
            let (run, size) = (usize::from(symbol >> 4), symbol & 15);
            match (run, size) {
                (0, 0) => break,
                (15, 0) => k += 16,
                (_, 0) => return Err(format!("code {symbol:#04x} is invalid")),
                _ => {
                    k += run;
                    if k > 63 {
                        return Err("more than 64 coefficients".to_owned());
                    }
                    self.bits.take(size)?;
                    k += 1;
                }
            }
        }
        Ok(())
    }

    /// A block of a progressive frame (G.1.2).
    fn progressive(
        &mut self,
        scan: &Scan,
        [dc, ac]: [&Huffman; 2],
        nonzero: &mut u64,
    ) -> Result<(), String> {
        let [first, last] = scan.band;
        if first == 0 {
            return if scan.refines { self.bits.take(1).map(|_| ()) } else { self.constant(dc) };
        }
        let mut k = first;
        while k <= last && self.end_run == 0 {
            let symbol = self.bits.code(ac)?;
            let (mut run, size) = (usize::from(symbol >> 4), symbol & 15);
            if size == 0 && run < 15 {
                self.end_run = (1 << run) + self.bits.take(symbol >> 4)?;
                break;
            }
            self.bits.take(size)?;
            // Skip as many zeros as `run` says; where the scan refines, each nonzero coefficient
            // passed has a bit.
            while k <= last {
                if scan.refines && *nonzero >> k & 1 == 1 {
                    self.bits.take(1)?;
                } else if run == 0 {
                    break;
                } else {
                    run -= 1;
                }
                k += 1;
            }
            if size > 0 {
                if k > last {
                    return Err(format!("coefficients beyond {last}"));
                }
                *nonzero |= 1 << k;
            }
            k += 1;
        }
        if self.end_run > 0 {
            self.end_run -= 1;
            if scan.refines {
                let rest = (k..=last).filter(|k| *nonzero >> k & 1 == 1).count();
                for _ in 0..rest {
                    self.bits.take(1)?;
                }
            }
        }
        Ok(())
    }
}

/// The bits of a scan's data, up to the next marker.
struct Bits<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The current byte, and how many of its bits are left.
    byte: u8,
    left: u32,
}

impl<'a> Bits<'a> {
    fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, byte: 0, left: 0 }
    }

    fn bit(&mut self) -> Result<u8, String> {
        if self.left == 0 {
            // A byte of 0xff is followed by a 0, which says that it isn't a marker.
            self.byte = match self.bytes.get(self.at..) {
                Some([0xff, 0, ..]) => {
                    self.at += 2;
                    0xff
                }
                None | Some([] | [0xff, ..]) => return Err("the data end too early".to_owned()),
                Some([byte, ..]) => {
                    self.at += 1;
                    *byte
                }
            };
            self.left = 8;
        }
        self.left -= 1;
        Ok(self.byte >> self.left & 1)
    }

    /// Reads `count` bits, 16 at most.
    fn take(&mut self, count: u8) -> Result<usize, String> {
        (0..count).try_fold(0, |bits, _| Ok(bits << 1 | usize::from(self.bit()?)))
    }

    /// The symbol of the next code (F.2.2.3).
    fn code(&mut self, table: &Huffman) -> Result<u8, String> {
        let (mut code, mut first, mut index) = (0, 0, 0);
        for count in table.counts.map(usize::from) {
            code |= usize::from(self.bit()?);
            if code < first + count {
                return Ok(table.symbols[index + code - first]);
            }
            index += count;
            first = (first + count) << 1;
            code <<= 1;
        }
        Err("no code fits".to_owned())
    }

    /// Continues behind the marker of restart number `expected`.
    fn restart(&mut self, expected: usize) -> Result<(), String> {
        self.finish()?;
        while let Some([0xff, 0xff, ..]) = self.bytes.get(self.at..) {
            self.at += 1;
        }
        match self.bytes.get(self.at..) {
            Some([0xff, marker, ..]) if usize::from(*marker) == 0xd0 + expected => {
                self.at += 2;
                Ok(())
            }
            _ => Err(format!("restart {expected} is missing")),
        }
    }

    /// Drops the padding bits of the last byte, and the zero bytes with which some files are
    /// padded; a marker must follow. Decoders skip any bytes, but bytes that code something more
    /// are a sign of damage.
    fn finish(&mut self) -> Result<(), String> {
        self.left = 0;
        while self.bytes.get(self.at) == Some(&0) {
            self.at += 1;
        }
        match self.bytes.get(self.at..) {
            Some([0xff, marker, ..]) if *marker != 0 => Ok(()),
            None | Some([] | [0xff]) => Err("the file ends within the picture".to_owned()),
            Some(_) => Err("data are left over".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::codecs::jpeg::JpegEncoder;
    use image::{ExtendedColorType, RgbImage};

    /// 40 x 24 pixels from another encoder: progressive, with subsampled components and restarts.
    const PROGRESSIVE: &str = "\
        ffd8ffe000104a46494600010100000100010000ffdb004300140e0f120f0d14121012171514181e32211e1c1c1e3d2c2e24\
        3249404c4b47404645505a736250556d5645466488656d777b8182814e608d978c7d96737e817cffdb0043011517171e1a1e\
        3b21213b7c5346537c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c7c\
        7c7c7c7c7c7c7c7cffc20011080018002803012200021101031101ffc4001900010003010100000000000000000000000001\
        03040502ffc40017010101010100000000000000000000000003020104ffdd00040002ffda000c03010002100310000001e5\
        e8ab6364e88b398fffd097a5572f61b5ffd15e1454157fffc4001b1000030002030000000000000000000000000102031104\
        2331ffda000801010001050248527fffd050283fffd1e4475c9fffd2946d23ffd35b6674947fffd483c5ffd58911ffd6cfa5\
        1fffc4001b11000202030100000000000000000000000001021103122131ffda0008010301013f01d6c9462b87ffd0c296a7\
        90b3ffd197292317948fffc400191101010003010000000000000000000000020003111201ffda0008010201013f0160c879\
        7fffd0c60f33d6efffd1563d737fffc4001a100002020300000000000000000000000000100171112151ffda000801010006\
        3f025fffd05fffd18b5fffd25fffd3233d3fffd45fffd5347fffd68b3fffc4001d1000030002020300000000000000000000\
        00011110214161315171ffda0008010100013f21c77fffd0c5ff00ffd18d3587ffd225a32b3fffd37e8f86b20fffd442ca79\
        7d1fffd540d75aaf70ffd65e59f087ffda000c03010002000300000010075fffd007dfffd1043fffc4001b11010002020300\
        000000000000000000000100112131415171ffda0008010301013f101cb1c99fffd0da81eb0541b9ffd134c0b8d1e0a5ea7f\
        ffc4001e1100010304030000000000000000000000010011b141a1d1e12181f0ffda0008010201013f100297d22796be97ff\
        d0a61f748098d395ffd1617244e50b0489caffc4001e100100030100030003000000000000000001001121413151618191c1\
        ffda0008010100013f106791de4fffd066b23bc9ffd11454575ce300d613ffd206b088147a4e4fffd3a3d07ac7f665e59cef\
        867fffd436b4fd4340788f4fb3ffd5a16a01da8eec3f20cfffd61a6a9e3e19ffd9";

    fn bytes_of(hex: &str) -> Vec<u8> {
        let byte = |pair: &[u8]| {
            let pair = std::str::from_utf8(pair).unwrap();
            u8::from_str_radix(pair, 16).unwrap()
        };
        hex.as_bytes().chunks(2).map(byte).collect()
    }

    fn pictures() -> Vec<Vec<u8>> {
        let picture = RgbImage::from_fn(40, 24, |x, y| {
            image::Rgb([x * y, 7 * x, 5 * y * y].map(|value| value.to_le_bytes()[0]))
        });
        let grey = image::DynamicImage::ImageRgb8(picture.clone()).into_luma8();
        let encoded = |bytes: &[u8], color| {
            let mut file = Vec::new();
            JpegEncoder::new_with_quality(&mut file, 80).encode(bytes, 40, 24, color).unwrap();
            file
        };
        vec![
            encoded(picture.as_raw(), ExtendedColorType::Rgb8),
            encoded(grey.as_raw(), ExtendedColorType::L8),
            bytes_of(PROGRESSIVE),
        ]
    }

    #[test]
    fn no_cut_passes() {
        for (picture, progressive) in pictures().into_iter().zip([false, false, true]) {
            assert_eq!(check(&picture), Ok(()));
            assert_eq!(check(&[&picture[..], b"what follows"].concat()), Ok(()));
            for len in 0..picture.len() {
                let why = check(&picture[..len]).unwrap_err();
                assert!(why.starts_with("is cut off or damaged at byte "), "{why}");
            }
            // Like tools that repair a file by only appending an end marker: a picture with fewer
            // scans is complete, but no part of a scan is.
            let repaired = |len: &usize| check(&[&picture[..*len], b"\xff\xd9"].concat()).is_ok();
            let whole: Vec<usize> = (0..picture.len() - 2).filter(repaired).collect();
            assert_eq!(whole.is_empty(), !progressive);
            // Right before the next segment, or in its leading 0xff bytes.
            let segment =
                |at: usize| [[0xff, 0xc4], [0xff, 0xda]].contains(&[picture[at], picture[at + 1]]);
            for len in whole {
                assert!(segment(len) || segment(len - 1), "{len}");
            }
        }
    }

    /// Bytes that no decoder reads don't change the picture.
    #[test]
    fn what_is_between_segments_may_be() {
        for picture in pictures() {
            let end = picture.len() - 2;
            let filled = [&picture[..end], &[0, 0], &picture[end..]].concat();
            assert_eq!(check(&filled), Ok(()));
            let more = [&picture[..end], &[0, 1], &picture[end..]].concat();
            assert!(check(&more).unwrap_err().contains("data are left over"));
            let tables = picture.windows(2).position(|pair| pair == [0xff, 0xc4]).unwrap();
            let between = [&picture[..tables], b"\x12\xff\0", &picture[tables..]].concat();
            assert_eq!(check(&between), Ok(()));
        }
    }

    /// Damage that changes the number of blocks or yields an invalid code is found; nothing panics.
    #[test]
    fn damage_inside_is_found() {
        for picture in pictures() {
            let start = picture.windows(2).position(|pair| pair == [0xff, 0xda]).unwrap();
            let mut found = 0;
            let all = 8 * (picture.len() - start);
            for bit in 0..8 * picture.len() {
                let mut damaged = picture.clone();
                damaged[bit / 8] ^= 1 << (bit % 8);
                found += usize::from(check(&damaged).is_err() && bit >= 8 * start);
            }
            // Many codes turn into others of the same length, and many bits are values.
            assert!(4 * found > all, "{found} of {all}");
            for (from, len) in [(start + 20, 40), ((start + picture.len()) / 2, 20)] {
                let cut = [&picture[..from], &picture[from + len..]].concat();
                assert!(check(&cut).is_err(), "{len} bytes less at {from}");
            }
        }
    }
}
