//! The bytes of a glTF file: container, buffers, and the numbers in them.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::shading::scene::limits::{MAX_TRIANGLES, too_many};
use crate::shading::scene::map;
use data_url::DataUrl;
use percent_encoding::percent_decode_str;
use serde::Deserialize;
use std::borrow::Cow;
use std::cell::Cell;
use std::collections::HashMap;
use std::path::Path;

/// The most numbers that a file's primitives read, counted each time that one reads them: many may
/// share an accessor.
const MAX_NUMBERS: usize = 1 << 25;

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    buffer_view: Option<usize>,
    #[serde(default)]
    byte_offset: usize,
    component_type: u32,
    #[serde(default)]
    normalized: bool,
    count: usize,
    #[serde(rename = "type")]
    kind: String,
    sparse: Option<Sparse>,
}

/// Elements that replace some of an accessor's.
#[derive(Deserialize)]
struct Sparse {
    count: usize,
    indices: SparseIndices,
    values: SparseValues,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct SparseIndices {
    buffer_view: usize,
    #[serde(default)]
    byte_offset: usize,
    component_type: u32,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct SparseValues {
    buffer_view: usize,
    #[serde(default)]
    byte_offset: usize,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct View {
    buffer: usize,
    #[serde(default)]
    byte_offset: usize,
    byte_length: usize,
    byte_stride: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    uri: Option<String>,
    byte_length: usize,
}

/// JSON and binary chunk of a `.glb` file. Bytes after its declared end aren't part of it.
pub(super) fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let word = |at: usize| -> Result<u32, String> {
        let word = bytes.get(at..at + 4).and_then(|word| word.try_into().ok());
        word.map(u32::from_le_bytes).ok_or_else(|| cut_off(bytes, at + 4))
    };
    if word(4)? != 2 {
        return Err(format!("is a .glb file of version {}: only version 2 is supported", word(4)?));
    }
    let end = cast::index_of_u32(word(8)?);
    if bytes.len() < end {
        return Err(cut_off(bytes, end));
    }
    let (mut json, mut binary) = (None, None);
    let mut at = 12;
    while at < end {
        let (len, kind) = (cast::index_of_u32(word(at)?), word(at + 4)?);
        let start = at + 8;
        at = start + len;
        if at > end {
            return Err(format!(
                "the chunk at byte {start} of its .glb container has {len} bytes and extends beyond the container's {end}: the file is damaged"
            ));
        }
        match kind {
            0x4e4f_534a => json = json.or(Some(&bytes[start..at])),
            0x004e_4942 => binary = binary.or(Some(&bytes[start..at])),
            _ => {}
        }
    }
    Ok((json.ok_or("has no JSON chunk in its .glb container")?, binary))
}

fn cut_off(bytes: &[u8], needed: usize) -> String {
    format!(
        "its .glb container has {} of {needed} bytes: the file is truncated; export or copy it again",
        bytes.len()
    )
}

/// The contents of buffers.
pub(super) struct Buffers<'a> {
    data: Vec<Cow<'a, [u8]>>,
    /// Index into `data` by buffer: buffers with the same URI share one entry, which is read once.
    places: Vec<usize>,
}

impl<'a> Buffers<'a> {
    /// Reads all buffers, limited to `max_bytes` together; `binary` is the chunk of a container.
    pub(super) fn read(
        buffers: &[Buffer],
        binary: Option<&'a [u8]>,
        path: &Path,
        max_bytes: u64,
    ) -> Result<Self> {
        let fail = |problem| Error::file(path, problem);
        let (mut data, mut places) = (Vec::new(), Vec::new());
        let mut known = HashMap::new();
        let mut left = max_bytes;
        for (i, buffer) in buffers.iter().enumerate() {
            let place = match buffer.uri.as_ref().and_then(|uri| known.get(uri)) {
                Some(place) => *place,
                None => {
                    let bytes = match (&buffer.uri, binary) {
                        (Some(uri), _) if is_data(uri) => {
                            let bytes = decoded(uri).ok_or_else(|| {
                                fail(format!(
                                    "buffer {i}: its data URI can't be decoded: legal are `data:;base64,` with base64, and `data:,` with bytes as %00 to %ff"
                                ))
                            })?;
                            Some(Cow::Owned(bytes))
                        }
                        (Some(uri), _) => {
                            let name = percent_decode_str(uri).decode_utf8_lossy();
                            let folder = path.parent().unwrap_or(Path::new(""));
                            map::read_up_to(&folder.join(&*name), left)?.map(Cow::Owned)
                        }
                        (None, Some(binary)) if i == 0 => Some(Cow::Borrowed(binary)),
                        (None, _) => {
                            let problem =
                                "has no data: export without compression, in one .glb file";
                            return Err(fail(format!("buffer {i} {problem}")));
                        }
                    };
                    let fits = |bytes: &Cow<[u8]>| cast::count_of(bytes.len()) <= left;
                    let bytes = bytes.filter(fits).ok_or_else(|| {
                        fail(format!(
                            "its buffers have more than {max_bytes} bytes together, the most that is supported: simplify it"
                        ))
                    })?;
                    left -= cast::count_of(bytes.len());
                    if let Some(uri) = &buffer.uri {
                        known.insert(uri, data.len());
                    }
                    data.push(bytes);
                    data.len() - 1
                }
            };
            let (has, needs) = (data[place].len(), buffer.byte_length);
            if has < needs {
                let problem =
                    format!("buffer {i} has {has} of {needs} bytes: the file is truncated");
                return Err(fail(problem));
            }
            places.push(place);
        }
        Ok(Self { data, places })
    }
}

/// True if a URI contains its data; the scheme is case-insensitive.
fn is_data(uri: &str) -> bool {
    uri.get(..5).is_some_and(|scheme| scheme.eq_ignore_ascii_case("data:"))
}

/// The bytes of a data URI, as text with %XX or as base64.
fn decoded(uri: &str) -> Option<Vec<u8>> {
    Some(DataUrl::process(uri).ok()?.decode_to_vec().ok()?.0)
}

/// An entry of one of the document's lists.
pub(super) fn get<'a, T>(list: &'a [T], what: &str, index: usize) -> Result<&'a T, String> {
    let len = list.len();
    list.get(index)
        .ok_or_else(|| format!("refers to {what} {index}, but there are {len} (they count from 0)"))
}

/// The type of one component of an element.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(code: u32) -> Result<Self, String> {
        Ok(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            other => return Err(format!("unknown component type {other}")),
        })
    }

    /// The type of an index: a number of a vertex, joint or element.
    fn of_indices(code: u32) -> Result<Self, String> {
        let component = Self::of(code)?;
        match component {
            Self::U8 | Self::U16 | Self::U32 => Ok(component),
            Self::I8 | Self::I16 | Self::F32 => Err(format!(
                "indices have component type {code}: legal are 5121, 5123 and 5125, unsigned integers"
            )),
        }
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// Decodes a component of [`Self::size`] bytes.
    fn decode(self, bytes: &[u8]) -> f64 {
        let two = || [bytes[0], bytes[1]];
        let four = || [bytes[0], bytes[1], bytes[2], bytes[3]];
        match self {
            Self::I8 => f64::from(i8::from_le_bytes([bytes[0]])),
            Self::U8 => f64::from(bytes[0]),
            Self::I16 => f64::from(i16::from_le_bytes(two())),
            Self::U16 => f64::from(u16::from_le_bytes(two())),
            Self::U32 => f64::from(u32::from_le_bytes(four())),
            Self::F32 => f64::from(f32::from_le_bytes(four())),
        }
    }

    /// The real that a normalized number stands for (3.11 of the specification).
    fn unit(self, value: f64) -> f64 {
        match self {
            Self::I8 => (value / 127.0).max(-1.0),
            Self::U8 => value / 255.0,
            Self::I16 => (value / 32767.0).max(-1.0),
            Self::U16 => value / 65535.0,
            Self::U32 | Self::F32 => value,
        }
    }
}

/// Numbers by accessor.
pub(super) struct Data<'a> {
    accessors: &'a [Accessor],
    views: &'a [View],
    buffers: Buffers<'a>,
    /// How many numbers may still be read.
    left: Cell<usize>,
}

impl<'a> Data<'a> {
    pub(super) fn new(accessors: &'a [Accessor], views: &'a [View], buffers: Buffers<'a>) -> Self {
        Self { accessors, views, buffers, left: Cell::new(MAX_NUMBERS) }
    }

    /// Counts numbers against the limit.
    pub(super) fn spend(&self, numbers: usize) -> Result<(), String> {
        let left = self.left.get().checked_sub(numbers).ok_or_else(|| {
            format!(
                "its primitives read more than {MAX_NUMBERS} numbers together (those of a shared accessor count each time), the most that is supported: simplify it"
            )
        })?;
        self.left.set(left);
        Ok(())
    }

    /// True if an accessor has its own data, and doesn't default to zeros.
    pub(super) fn has_view(&self, index: usize) -> bool {
        self.accessors.get(index).is_some_and(|accessor| accessor.buffer_view.is_some())
    }

    /// Every component of an accessor, in order, as reals.
    pub(super) fn reals(&self, index: usize, components: usize) -> Result<Vec<f64>, String> {
        let accessor = get(self.accessors, "accessor", index)?;
        self.read(accessor, components).map_err(|why| format!("accessor {index}: {why}"))
    }

    /// The same for an accessor of vertex or joint numbers.
    pub(super) fn wholes(&self, index: usize, components: usize) -> Result<Vec<usize>, String> {
        let accessor = get(self.accessors, "accessor", index)?;
        if accessor.normalized {
            let problem = "holds indices, which can't be normalized";
            return Err(format!("accessor {index}: {problem}"));
        }
        Component::of_indices(accessor.component_type)
            .map_err(|why| format!("accessor {index}: {why}"))?;
        Ok(self.reals(index, components)?.into_iter().map(cast::usize_of).collect())
    }

    fn read(&self, accessor: &Accessor, components: usize) -> Result<Vec<f64>, String> {
        let kind = match components {
            1 => "SCALAR",
            2 => "VEC2",
            3 => "VEC3",
            4 => "VEC4",
            _ => "MAT4",
        };
        if accessor.kind != kind {
            return Err(format!("is {} where {kind} is needed", accessor.kind));
        }
        let component = Component::of(accessor.component_type)?;
        if accessor.count > 3 * MAX_TRIANGLES {
            return Err(too_many());
        }
        self.spend(accessor.count * components)?;
        let place = |view, byte_offset| Place { view, byte_offset, component, components };
        let mut values = match accessor.buffer_view {
            Some(view) => self.block(place(view, accessor.byte_offset), accessor.count)?,
            None => vec![0.0; accessor.count * components],
        };
        if let Some(Sparse { count, indices, values: by }) = &accessor.sparse {
            if *count > accessor.count {
                return Err(format!(
                    "has {count} sparse elements, more than its {} elements",
                    accessor.count
                ));
            }
            self.spend(count * (components + 1))?;
            let indices = Place {
                view: indices.buffer_view,
                byte_offset: indices.byte_offset,
                component: Component::of_indices(indices.component_type)?,
                components: 1,
            };
            let indices = self.block(indices, *count)?;
            let by = self.block(place(by.buffer_view, by.byte_offset), *count)?;
            for (index, element) in indices.into_iter().zip(by.chunks_exact(components)) {
                let start = components * cast::usize_of(index);
                let to = values.get_mut(start..start + components).ok_or_else(|| {
                    format!(
                        "refers to sparse element {index}, but there are {} (they count from 0)",
                        accessor.count
                    )
                })?;
                to.copy_from_slice(element);
            }
        }
        if accessor.normalized {
            values.iter_mut().for_each(|value| *value = component.unit(*value));
        }
        Ok(values)
    }

    /// The first `count` elements of a place in a buffer view.
    fn block(&self, place: Place, count: usize) -> Result<Vec<f64>, String> {
        let view = get(self.views, "buffer view", place.view)?;
        let buffer = get(&self.buffers.places, "buffer", view.buffer)?;
        let buffer = &self.buffers.data[*buffer];
        let beyond = || "extends beyond its buffer".to_owned();
        let bytes = view.byte_offset.checked_add(view.byte_length);
        let bytes = bytes.and_then(|end| buffer.get(view.byte_offset..end)).ok_or_else(beyond)?;
        let size = place.component.size();
        let element = size * place.components;
        let stride = view.byte_stride.unwrap_or(element);
        if stride < element {
            return Err(format!(
                "buffer view {} has `byteStride` {stride}, less than the {element} bytes of its elements",
                place.view
            ));
        }
        // Keeps the allocation below within the number of bytes in the file.
        if count > bytes.len() {
            return Err(beyond());
        }
        let mut values = Vec::with_capacity(count * place.components);
        for i in 0..count {
            let start = i.checked_mul(stride).and_then(|at| at.checked_add(place.byte_offset));
            let bytes = start.and_then(|start| bytes.get(start..start.checked_add(element)?));
            let bytes = bytes.ok_or_else(beyond)?;
            values.extend(bytes.chunks_exact(size).map(|bytes| place.component.decode(bytes)));
        }
        Ok(values)
    }
}

/// Where elements start, and their type.
struct Place {
    view: usize,
    byte_offset: usize,
    component: Component,
    components: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_uris() {
        let of = |text: &str| decoded(&format!("data:application/octet-stream;base64,{text}"));
        assert_eq!(of("").unwrap(), b"");
        assert_eq!(of("TQ==").unwrap(), b"M");
        assert_eq!(of("TWE").unwrap(), b"Ma");
        assert_eq!(of("TWFuAP/+").unwrap(), b"Man\x00\xff\xfe");
        assert_eq!(of("TWFuAP%2F%2B").unwrap(), b"Man\x00\xff\xfe");
        assert!(of("TW!u").is_none() && of("T").is_none());
        assert_eq!(decoded("data:,a%00%fF+%").unwrap(), b"a\x00\xff+%");
        assert_eq!(decoded("data:").map(|_| ()), None);
    }

    #[test]
    fn normalized_numbers_end_at_one() {
        for (component, least, most) in [
            (Component::I8, -128.0, 127.0),
            (Component::U8, 0.0, 255.0),
            (Component::I16, -32768.0, 32767.0),
            (Component::U16, 0.0, 65535.0),
        ] {
            assert_eq!(component.unit(most), 1.0);
            assert_eq!(component.unit(least), if least < 0.0 { -1.0 } else { 0.0 });
        }
        assert_eq!(Component::I8.decode(&[0x80]), -128.0);
        assert_eq!(Component::I16.decode(&[0xff, 0x7f]), 32767.0);
        assert_eq!(Component::U32.decode(&[255; 4]), 4_294_967_295.0);
    }
}
