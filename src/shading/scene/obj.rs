//! Meshes from Wavefront OBJ: points, texture coordinates, normals and polygons.
//!
//! This is a reader of our own. The crate `tobj` (like `obj-rs` and `wavefront_obj`) names no line
//! in its errors, cuts concave polygons as fans, silently skips statements, doesn't read continued
//! lines, and fails on a number that no face uses. The remaining work is a loop over words. This
//! reader also accepts what files contain beyond the specification: CR and CRLF line ends, a byte
//! order mark, colours after points, NaN and zero-length normals if no face uses them, and normal
//! indices in files without normals.

use super::assembly::{Mesh, MeshVertex, Tally};
use super::limits::{MAX_TRIANGLES, check_coordinates, checked_normal, too_many};
use super::polygon::Cutter;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::input::check_encoding;
use glam::{DVec2, DVec3};
use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;

/// Statements of names, groups, materials and appearance: they don't change shapes.
const SHAPELESS: &[&str] = &[
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
];
/// Those that hold names, which may end in a `\` of their own.
const NAMES: &[&str] = &["g", "o", "usemtl", "mtllib", "usemap", "maplib"];
/// Statements that define shapes.
const SHAPES: &[&str] = &["v", "vt", "vn", "f", "fo"];
/// Statements of free-form curves and surfaces, which aren't supported.
const FREE_FORM: &[&str] = &[
    "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
    "sp", "end", "con", "ctech", "stech", "bsp", "bzp", "cdc", "cdp", "res",
];

/// Reads an OBJ file from its bytes.
pub(super) fn read(bytes: &[u8], path: &Path) -> Result<Mesh> {
    let text = decoded(bytes).map_err(|problem| Error::file(path, problem))?;
    let mut reader = Reader::default();
    for (number, statement) in statements(&text) {
        reader.take(&statement, number).map_err(|why| Error::line(path, number, why))?;
    }
    Ok(reader.done())
}

/// The text, without a byte order mark.
fn decoded(bytes: &[u8]) -> Result<Cow<'_, str>, String> {
    check_encoding(bytes)?;
    if bytes.contains(&0) {
        return Err(
            "isn't text: it is binary, or UTF-16 without a byte order mark; save it as UTF-8"
                .to_owned(),
        );
    }
    // Names may have any encoding: nothing here depends on them.
    Ok(String::from_utf8_lossy(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)))
}

/// Statements without comments, each with the number of its first line. A `\` at the end of a line
/// continues it.
fn statements(text: &str) -> impl Iterator<Item = (u64, Cow<'_, str>)> {
    let mut lines = lines(text).map(without_comment).zip(1..).peekable();
    std::iter::from_fn(move || {
        let (line, number) = lines.next()?;
        let Some(mut begun) = continued(line) else { return Some((number, Cow::Borrowed(line))) };
        // The `\` ends a folder's name if a statement follows.
        let first = |line: &&str, of: &[&str]| {
            line.split_whitespace().next().is_some_and(|word| of.contains(&word))
        };
        if first(&line, NAMES) && lines.peek().is_some_and(|(next, _)| first(next, SHAPES)) {
            return Some((number, Cow::Borrowed(line)));
        }
        let mut statement = String::new();
        loop {
            statement.push_str(begun);
            statement.push(' ');
            let line = lines.next().map_or("", |(line, _)| line);
            let Some(more) = continued(line) else {
                statement.push_str(line);
                return Some((number, Cow::Owned(statement)));
            };
            begun = more;
        }
    })
}

/// The part before the `\` at the end of a line.
fn continued(line: &str) -> Option<&str> {
    line.trim_end().strip_suffix('\\')
}

/// Lines that end with LF, CR or CRLF.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let Some(end) = text.find(['\n', '\r']) else { return rest.take() };
        let len = if text[end..].starts_with("\r\n") { 2 } else { 1 };
        rest = Some(&text[end + len..]);
        Some(&text[..end])
    })
}

/// A line up to its comment. The `#` of a NaN as Microsoft's C library writes it (`-1.#IND`)
/// doesn't start a comment.
fn without_comment(line: &str) -> &str {
    let begins = |(at, _): &(usize, &str)| {
        let nan = ["INF", "IND", "QNAN", "SNAN"].iter().any(|n| line[at + 1..].starts_with(n));
        !(nan && line[..*at].ends_with("1."))
    };
    line.match_indices('#').find(begins).map_or(line, |(at, _)| &line[..at])
}

/// The state of reading a mesh.
#[derive(Default)]
struct Reader {
    points: Vec<DVec3>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
    mesh: Mesh,
    /// The vertex of each combination of point, texture coordinate and normal.
    known: HashMap<[Option<usize>; 3], u32>,
    /// Corners that refer to a texture coordinate, or a normal, before the file has any.
    early: [Tally; 2],
    cutter: Cutter,
    met: Met,
}

/// Statements that form no triangles.
#[derive(Default)]
struct Met {
    small: Tally,
    lines: Tally,
    points: Tally,
    free_form: Tally,
    unknown: Tally,
    /// Name of the first unknown one.
    name: String,
}

impl Reader {
    fn take(&mut self, statement: &str, line: u64) -> Result<(), String> {
        // Concatenated files have a byte order mark where each one began.
        let mut words = statement.trim_start_matches('\u{feff}').split_whitespace();
        let met = &mut self.met;
        match words.next() {
            // Values are checked where they are used: many files have invalid ones that no face
            // uses.
            Some("v") => self.points.push(DVec3::from_array(numbers("the point", words, 3)?)),
            Some("vt") => {
                self.early[0].follows("vt")?;
                let [u, v, _] = numbers("the texture coordinate", words, 1)?;
                self.uvs.push(DVec2::new(u, v));
            }
            Some("vn") => {
                self.early[1].follows("vn")?;
                self.normals.push(DVec3::from_array(numbers("the normal", words, 3)?));
            }
            // `fo` is the old name of `f`.
            Some("f" | "fo") => self.face(words, line)?,
            Some("l") => met.lines.add(Some(line)),
            Some("p") => met.points.add(Some(line)),
            Some(name) if FREE_FORM.contains(&name) => met.free_form.add(Some(line)),
            Some(name) if !SHAPELESS.contains(&name) => {
                if met.unknown.count == 0 {
                    met.name = shown(name);
                }
                met.unknown.add(Some(line));
            }
            Some(_) | None => {}
        }
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>, line: u64) -> Result<(), String> {
        let corners: Vec<u32> =
            words.map(|word| self.corner(word, line)).collect::<Result<_, _>>()?;
        if corners.len() < 3 {
            self.met.small.add(Some(line));
            return Ok(());
        }
        if corners.len() - 2 > MAX_TRIANGLES {
            return Err(too_many());
        }
        let point = |corner: &u32| self.mesh.vertices[cast::index_of_u32(*corner)].position;
        let points: Vec<DVec3> = corners.iter().map(point).collect();
        let (topology, order) = self.cutter.triangles(&points)?;
        for _ in topology.triangles(order.len())?..corners.len() - 2 {
            self.mesh.flat.add(Some(line));
        }
        let order: Vec<u32> = order.into_iter().map(|at| corners[at]).collect();
        self.mesh.indices += cast::count_of(order.len());
        self.mesh.assemble(topology, &order, Some(line))
    }

    /// The vertex of a corner: a point, and its texture coordinate and normal if it names them.
    fn corner(&mut self, word: &str, line: u64) -> Result<u32, String> {
        let mut indices = word.split('/');
        let [point, uv, normal] =
            [(); 3].map(|()| indices.next().filter(|index| !index.is_empty()));
        if indices.next().is_some() {
            return Err(format!("corner `{}` has more than three indices (v/vt/vn)", shown(word)));
        }
        let Some(point) = pick(self.points.len(), "point", word, point)? else {
            return Err(format!("corner `{}` names no point", shown(word)));
        };
        let mut other = |len: usize, what, index: Option<&str>, early: usize| {
            let names_one = |index: &str| index.parse().is_ok_and(|index: i64| index != 0);
            if len == 0 && index.is_some_and(names_one) {
                // Treated as missing, provided that the file has none at all.
                self.early[early].add(Some(line));
                return Ok(None);
            }
            pick(len, what, word, index)
        };
        let uv = other(self.uvs.len(), "texture coordinate", uv, 0)?;
        let normal = other(self.normals.len(), "normal", normal, 1)?;
        let names = [Some(point), uv, normal];
        if let Some(vertex) = self.known.get(&names) {
            return Ok(*vertex);
        }
        let position = self.points[point];
        check_coordinates(&format!("point {}", point + 1), &position.to_array())?;
        let normal = match normal {
            Some(i) => checked_normal(&format!("normal {}", i + 1), self.normals[i])?,
            None => None,
        };
        let uv = uv.map(|i| (i, self.uvs[i]));
        if let Some((i, uv)) = uv {
            check_coordinates(&format!("texture coordinate {}", i + 1), &uv.to_array())?;
        }
        let vertices = &mut self.mesh.vertices;
        vertices.push(MeshVertex { position, normal, uv: uv.map(|(_, uv)| uv) });
        let vertex = cast::id_of(vertices.len() - 1);
        self.known.insert(names, vertex);
        Ok(vertex)
    }

    fn done(self) -> Mesh {
        let Self { mut mesh, met, early: [uvs, normals], .. } = self;
        let unknown = format!("unknown statements ignored, such as `{}`", met.name);
        let told = [
            met.small.told("faces of fewer than 3 corners left out"),
            met.lines.told("lines (`l`) ignored"),
            met.points.told("points (`p`) ignored"),
            met.free_form.told("statements of free-form curves and surfaces ignored"),
            met.unknown.told(&unknown),
            uvs.told("corners that refer to a texture coordinate, but the file has none"),
            normals.told("corners that refer to a normal, but the file has none"),
        ];
        mesh.notes.extend(told.into_iter().flatten());
        mesh
    }
}

/// The first three numbers of a line. At least `least` of them are required; the others default to
/// 0.
fn numbers<'a>(
    what: &str,
    words: impl Iterator<Item = &'a str>,
    least: usize,
) -> Result<[f64; 3], String> {
    let mut values = [0.0; 3];
    let mut count = 0;
    for word in words {
        let value = match word.trim_start_matches('-').strip_prefix("1.#") {
            Some(_) => f64::NAN,
            None => word
                .parse()
                .map_err(|_| format!("{what} has `{}`, which isn't a number", shown(word)))?,
        };
        // A weight or a colour may follow.
        if let Some(to) = values.get_mut(count) {
            *to = value;
        }
        count += 1;
    }
    if count < least {
        return Err(format!("{what} has {count} numbers: it needs at least {least}"));
    }
    Ok(values)
}

/// The position in a list of `len` entries that a corner's index refers to: from 1 up, or from -1
/// backwards.
fn pick(
    len: usize,
    what: &str,
    corner: &str,
    index: Option<&str>,
) -> Result<Option<usize>, String> {
    let Some(index) = index else { return Ok(None) };
    let parsed: Option<i64> = index.parse().ok();
    let position = parsed.and_then(|index| match index {
        1.. => usize::try_from(index - 1).ok(),
        0 => None,
        _ => usize::try_from(index.unsigned_abs()).ok().and_then(|back| len.checked_sub(back)),
    });
    let position = position.filter(|position| *position < len).ok_or_else(|| {
        format!(
            "corner `{}` refers to {what} {}, but up to here there are {len} (they count from 1)",
            shown(corner),
            shown(index)
        )
    })?;
    Ok(Some(position))
}

/// Formats a word for a message: shortened, and without control characters for a terminal.
fn shown(word: &str) -> String {
    crate::base::escape::short(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways_and_go_on() {
        let text = "a # \\\r\nb \\\rc\\ \n d # e\n\n\rf -1.#IND 1.#QNAN#g\\";
        let seen: Vec<(u64, String)> = statements(text)
            .map(|(line, statement)| {
                (line, statement.split_whitespace().collect::<Vec<_>>().join(" "))
            })
            .collect();
        let expected = [(1, "a"), (2, "b c d"), (5, ""), (6, ""), (7, "f -1.#IND 1.#QNAN")];
        assert_eq!(seen, expected.map(|(line, text)| (line, text.to_owned())));
        assert_eq!(statements("\\").count(), 1);
        assert_eq!(statements("f \\\n\\\n").count(), 1);
        // Names that end in `\`, and one that continues.
        assert_eq!(statements("g C:\\dir\\\nv 1 2 3\no a\\\nvn 0 0 1").count(), 4);
        assert_eq!(statements("g a \\\n b\nf 1 \\\n2 3").count(), 2);
    }
}
