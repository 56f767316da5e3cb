//! Accessors to numbers. Every offset and count is checked against the bytes that are there.

use crate::io::gltf::container::buffers::Buffers;
use crate::io::gltf::document::records::{Component, Format, Records, View};
use crate::io::gltf::json::fields::At;
use crate::io::text::counted;
use crate::io::{Place, Problem, ReadError};
use std::borrow::Cow;
use std::cell::Cell;

/// The bytes of an accessor's elements, in place.
#[derive(Clone, Copy, Debug)]
pub struct Elements<'a> {
    /// From the first byte of the first element to the last of the last; empty when there are no stored data.
    bytes: &'a [u8],
    /// From one element to the next; 0 when there are no stored data, which then are zeros.
    stride: usize,
    pub count: usize,
    pub format: Format,
    /// The exceptions, ascending.
    sparse: Option<Exceptions<'a>>,
}

#[derive(Clone, Copy, Debug)]
struct Exceptions<'a> {
    indices: &'a [u8],
    component: Component,
    values: &'a [u8],
}

/// Reads the accessors of a document.
pub struct Source<'a> {
    pub records: &'a Records,
    pub buffers: &'a Buffers,
    /// Elements that accessors without stored data may still stand for.
    pub implied_limit: u64,
    /// Bytes of memory that decoding may still take; one file's bytes can be asked for any number of times.
    pub memory: Cell<u64>,
}

impl<'a> Source<'a> {
    /// Finds the elements of an accessor.
    pub fn elements(&self, accessor: usize) -> Result<Elements<'a>, ReadError> {
        let at = At::new("accessors", accessor);
        let record = &self.records.accessors[accessor];
        let Some(format) = record.format else {
            let found = "an accessor whose type or component type glTF 2.0 does not have";
            return Err(ReadError::new(Problem::Range, at.place(), found, "export the file again"));
        };
        let count = usize::try_from(record.count).unwrap_or(usize::MAX);
        if record.count == 0 {
            let found = "an accessor without elements";
            return Err(ReadError::new(Problem::Range, at.member("count"), found, "export the file again"));
        }
        let size = format.size();
        let (bytes, stride) = match record.view {
            None if record.count > self.implied_limit => {
                let found = format!("{count} elements of zeros, for which the file stores no data");
                let advice = format!("the limit is {}; check where the file comes from", self.implied_limit);
                return Err(ReadError::new(Problem::Limit, at.member("count"), found, advice));
            }
            None => (&[][..], 0),
            Some(view) => {
                let view = &self.records.views[view];
                let stride = view.stride.unwrap_or(size as u64);
                let range = Extent { offset: record.offset, count: record.count, size: size as u64, stride };
                (self.slice(view, range, at)?, stride as usize)
            }
        };
        let sparse = record.sparse.map(|sparse| {
            let place = at.member("sparse");
            if sparse.count == 0 || sparse.count > record.count {
                let found = format!("{} exceptions for {count} elements", sparse.count);
                return Err(ReadError::new(Problem::Range, place, found, "export the file again"));
            }
            let part = |view: usize, offset: u64, size: usize| {
                let extent = Extent { offset, count: sparse.count, size: size as u64, stride: size as u64 };
                self.slice(&self.records.views[view], extent, at)
            };
            let component = sparse.index_component;
            let indices = part(sparse.index_view, sparse.index_offset, component.size())?;
            let values = part(sparse.value_view, sparse.value_offset, size)?;
            check_exceptions(indices, component, count, place)?;
            Ok(Exceptions { indices, component, values })
        });
        Ok(Elements { bytes, stride, count, format, sparse: sparse.transpose()? })
    }

    /// Takes memory from the budget before something is decoded.
    pub fn spend(&self, bytes: u64, at: At) -> Result<(), ReadError> {
        match self.memory.get().checked_sub(bytes) {
            Some(left) => {
                self.memory.set(left);
                Ok(())
            }
            None => {
                let found = "the file uses the same bytes so often that its meshes would not fit into memory";
                let advice = "check where it comes from; splitting it into several files helps";
                Err(ReadError::new(Problem::Limit, at.place(), found, advice))
            }
        }
    }

    fn slice(&self, view: &View, extent: Extent, at: At) -> Result<&'a [u8], ReadError> {
        let range = |found: String| {
            Err(ReadError::new(
                Problem::Range,
                at.place(),
                found,
                "the file is broken or cut off; export it again",
            ))
        };
        let Some(buffer) = self.buffers.bytes(view.buffer) else {
            let name = view.meshopt.unwrap_or("an extension");
            let found = format!("data that are only there compressed by {name}");
            let advice = "decompress the file first, for example with `gltf-transform copy`";
            return Err(ReadError::new(Problem::Unsupported, at.place(), found, advice));
        };
        if extent.stride < extent.size {
            let found =
                format!("elements of {} only {} apart", bytes_of(extent.size), bytes_of(extent.stride));
            return range(found);
        }
        let needed =
            (extent.count - 1).checked_mul(extent.stride).and_then(|all| all.checked_add(extent.size));
        let end = needed.and_then(|needed| needed.checked_add(extent.offset));
        if end.is_none_or(|end| end > view.length) {
            let Extent { offset, count, size, .. } = extent;
            let elements = counted(count, "element", "elements");
            let view = bytes_of(view.length);
            return range(format!("{elements} of {} from byte {offset} of a view of {view}", bytes_of(size)));
        }
        let start = view.offset.checked_add(extent.offset);
        let whole = view.offset.checked_add(view.length).filter(|&end| end <= buffer.len() as u64);
        match (start, needed, whole) {
            (Some(start), Some(needed), Some(_)) => Ok(&buffer[start as usize..(start + needed) as usize]),
            _ => {
                let (length, size) = (bytes_of(view.length), bytes_of(buffer.len() as u64));
                range(format!("a view of {length} from byte {} of a buffer of {size}", view.offset))
            }
        }
    }
}

fn bytes_of(count: u64) -> String {
    counted(count, "byte", "bytes")
}

#[derive(Clone, Copy)]
struct Extent {
    offset: u64,
    /// Not 0.
    count: u64,
    size: u64,
    stride: u64,
}

fn check_exceptions(
    indices: &[u8],
    component: Component,
    count: usize,
    place: Place,
) -> Result<(), ReadError> {
    let mut previous = None;
    for index in indices.chunks_exact(component.size()).map(|bytes| unsigned(bytes, component)) {
        let found = if index as usize >= count {
            format!("an exception for element {index} of {count}")
        } else if previous.is_some_and(|previous| index <= previous) {
            format!("exceptions that do not ascend (at element {index})")
        } else {
            previous = Some(index);
            continue;
        };
        return Err(ReadError::new(Problem::Range, place, found, "the file is broken; export it again"));
    }
    Ok(())
}

impl<'a> Elements<'a> {
    /// All elements as raw bytes without gaps.
    pub fn raw(&self) -> Cow<'a, [u8]> {
        let size = self.format.size();
        if self.sparse.is_none() && self.stride == size {
            return Cow::Borrowed(self.bytes);
        }
        let mut raw = vec![0; size * self.count];
        if self.stride > 0 {
            // The last element may end before a whole stride does.
            for (to, from) in raw.chunks_exact_mut(size).zip(self.bytes.chunks(self.stride)) {
                to.copy_from_slice(&from[..size]);
            }
        }
        if let Some(sparse) = &self.sparse {
            let indices = sparse.indices.chunks_exact(sparse.component.size());
            for (index, value) in indices.zip(sparse.values.chunks_exact(size)) {
                let start = unsigned(index, sparse.component) as usize * size;
                raw[start..start + size].copy_from_slice(value);
            }
        }
        Cow::Owned(raw)
    }

    /// All elements as `f32` vectors; normalised integers divided by their largest value, as the standard says.
    /// Elements of fewer components are filled up with `fill`, those of more cut.
    pub fn floats<const N: usize>(&self, fill: f32) -> Vec<[f32; N]> {
        let raw = self.raw();
        let (component, normalized) = (self.format.component, self.format.normalized);
        let size = component.size();
        let width = self.format.width.min(N);
        let elements = raw.chunks_exact(self.format.size());
        elements
            .map(|element| {
                let mut vector = [fill; N];
                for (number, bytes) in vector[..width].iter_mut().zip(element.chunks_exact(size)) {
                    *number = float(bytes, component, normalized);
                }
                vector
            })
            .collect()
    }

    /// All elements as unsigned integers, first component only.
    pub fn integers(&self) -> Vec<u32> {
        let component = self.format.component;
        self.raw().chunks_exact(self.format.size()).map(|bytes| unsigned(bytes, component)).collect()
    }
}

fn float(bytes: &[u8], component: Component, normalized: bool) -> f32 {
    match component {
        Component::F32 => f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
        Component::I8 if normalized => (f32::from(bytes[0] as i8) / 127.0).max(-1.0),
        Component::I8 => f32::from(bytes[0] as i8),
        Component::U8 if normalized => f32::from(bytes[0]) / 255.0,
        Component::U8 => f32::from(bytes[0]),
        Component::I16 | Component::U16 => {
            let pair = [bytes[0], bytes[1]];
            match (component, normalized) {
                (Component::I16, true) => (f32::from(i16::from_le_bytes(pair)) / 32767.0).max(-1.0),
                (Component::I16, false) => f32::from(i16::from_le_bytes(pair)),
                (_, true) => f32::from(u16::from_le_bytes(pair)) / 65535.0,
                (_, false) => f32::from(u16::from_le_bytes(pair)),
            }
        }
        Component::U32 => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as f32,
    }
}

fn unsigned(bytes: &[u8], component: Component) -> u32 {
    match component.size() {
        1 => u32::from(bytes[0]),
        2 => u32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
        _ => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
    }
}
