//! Accessors to numbers. Every offset and count is checked against the bytes that are there.

use super::buffers::Buffers;
use super::fields::{only_compressed, out_of_range};
use super::json::Value;
use super::records::{Accessor, Component, Format, Records, Sparse};
use crate::io::{Note, Place, Problem, ReadError};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};

/// The bytes of an accessor's elements, in place.
#[derive(Clone, Copy, Debug)]
pub struct Elements<'a> {
    /// From the first byte of the first element to the last of the last; empty when there are no stored data.
    bytes: &'a [u8],
    /// From one element to the next; 0 when there are no stored data, which then are zeros.
    stride: usize,
    pub count: usize,
    pub format: Format,
    sparse: Option<Exceptions<'a>>,
}

#[derive(Clone, Copy, Debug)]
struct Exceptions<'a> {
    indices: &'a [u8],
    component: Component,
    values: &'a [u8],
}

pub struct Source<'a> {
    pub records: &'a Records,
    pub buffers: &'a Buffers,
    pub implied_limit: u64,
    /// Bytes of memory that decoding may still take; one file's bytes can be asked for any number of times.
    pub memory: Cell<u64>,
    pub notes: RefCell<Vec<Note>>,
}

impl<'a> Source<'a> {
    pub fn elements(&self, accessor: usize) -> Result<Elements<'a>, ReadError> {
        let record = &self.records.accessors[accessor];
        let fields = self.records.fields(record.object);
        let Some(format) = record.format else {
            return Err(out_of_range(fields.place(), "unknown type or component type"));
        };
        if record.count == 0 {
            return Err(out_of_range(fields.member("count"), "the accessor has no elements"));
        }
        let count = usize::try_from(record.count).unwrap_or(usize::MAX);
        let size = format.size() as u64;
        let (bytes, stride) = match record.view {
            None if record.count > self.implied_limit => {
                let limit = self.implied_limit;
                let found = format!("{count} elements without stored data (limit {limit})");
                let advice = "check where the file comes from";
                return Err(ReadError::new(Problem::Limit, fields.member("count"), found, advice));
            }
            None => (&[][..], 0),
            Some(view) => {
                let stride = self.records.views[view].stride.unwrap_or(size);
                let extent = Extent { offset: record.offset, count: record.count, size, stride };
                (self.slice(view, extent, record.object)?, stride as usize)
            }
        };
        let exceptions = |sparse| self.exceptions(record, sparse, size);
        let sparse = record.sparse.map(exceptions).transpose()?;
        Ok(Elements { bytes, stride, count, format, sparse })
    }

    fn exceptions(
        &self,
        accessor: &Accessor,
        sparse: Sparse,
        size: u64,
    ) -> Result<Exceptions<'a>, ReadError> {
        let (count, fields) = (accessor.count, self.records.fields(accessor.object));
        let refuse = |found: String| Err(out_of_range(fields.member("sparse"), found));
        if sparse.count == 0 || sparse.count > count {
            return refuse(format!("{} sparse values for {count} elements", sparse.count));
        }
        let component = sparse.component;
        let part = |(view, offset), size| {
            let extent = Extent { offset, count: sparse.count, size, stride: size };
            self.slice(view, extent, accessor.object)
        };
        let indices = part(sparse.indices, component.size() as u64)?;
        let values = part(sparse.values, size)?;
        let mut previous = None;
        for index in indices.chunks_exact(component.size()).map(|bytes| unsigned(bytes, component)) {
            if u64::from(index) >= count {
                return refuse(format!("sparse index {index} is out of range ({count} elements)"));
            }
            if previous.is_some_and(|previous| index <= previous) {
                return refuse(format!("sparse indices are not ascending (at {index})"));
            }
            previous = Some(index);
        }
        Ok(Exceptions { indices, component, values })
    }

    pub fn warn(&self, place: Place, text: impl Into<String>) {
        self.notes.borrow_mut().push(Note::warning(place, text));
    }

    /// Takes memory from the budget before something is decoded.
    pub fn spend(&self, bytes: u64, place: impl FnOnce() -> Place) -> Result<(), ReadError> {
        let Some(left) = self.memory.get().checked_sub(bytes) else {
            let found = "too much memory: many meshes share the same bytes";
            let advice = "check where the file comes from, or split it";
            return Err(ReadError::new(Problem::Limit, place(), found, advice));
        };
        self.memory.set(left);
        Ok(())
    }

    fn slice(&self, view: usize, extent: Extent, accessor: Value) -> Result<&'a [u8], ReadError> {
        let view = &self.records.views[view];
        let Extent { offset, count, size, stride } = extent;
        let place = || self.records.json.place(accessor);
        let Some(buffer) = self.buffers.bytes(view.buffer) else {
            let name = view.meshopt.unwrap_or("an extension");
            return Err(only_compressed(place(), format!("the data are stored only compressed by {name}")));
        };
        if stride < size {
            let found = format!("the stride is {stride}, less than the {size} bytes of an element");
            return Err(out_of_range(place(), found));
        }
        let needed = (count - 1).checked_mul(stride).and_then(|all| all.checked_add(size));
        let end = needed.and_then(|needed| needed.checked_add(offset));
        if end.is_none_or(|end| end > view.length) {
            let length = view.length;
            let found = format!(
                "{count} elements of {size} bytes from byte {offset} exceed the view of {length} bytes"
            );
            return Err(out_of_range(place(), found));
        }
        let whole = view.offset.checked_add(view.length).filter(|&end| end <= buffer.len() as u64);
        let (Some(needed), Some(_)) = (needed, whole) else {
            let (length, start, size) = (view.length, view.offset, buffer.len());
            let found =
                format!("a view of {length} bytes from byte {start} exceeds the buffer of {size} bytes");
            return Err(out_of_range(place(), found));
        };
        // Within the view, which is within the buffer.
        let start = view.offset + offset;
        Ok(&buffer[start as usize..(start + needed) as usize])
    }
}

#[derive(Clone, Copy)]
struct Extent {
    offset: u64,
    /// Not 0.
    count: u64,
    size: u64,
    stride: u64,
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

    /// All elements as `f32` vectors, missing components filled up with `fill`.
    pub fn floats<const N: usize>(&self, fill: f32) -> impl ExactSizeIterator<Item = [f32; N]> + use<'a, N> {
        let (raw, format) = (self.raw(), self.format);
        let (whole, size, width) = (format.size(), format.component.size(), format.width.min(N));
        (0..self.count).map(move |element| {
            let mut vector = [fill; N];
            let bytes = raw[element * whole..(element + 1) * whole].chunks_exact(size);
            for (number, bytes) in vector[..width].iter_mut().zip(bytes) {
                *number = float(bytes, format.component, format.normalized);
            }
            vector
        })
    }

    pub fn integers(&self) -> Vec<u32> {
        let component = self.format.component;
        self.raw().chunks_exact(self.format.size()).map(|bytes| unsigned(bytes, component)).collect()
    }
}

/// A number as the standard reads it: normalised integers are divided by their largest value.
pub fn float(bytes: &[u8], component: Component, normalized: bool) -> f32 {
    let most = match component {
        Component::F32 => return f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
        Component::I8 if normalized => 127.0,
        Component::U8 if normalized => 255.0,
        Component::I16 if normalized => 32767.0,
        Component::U16 if normalized => 65535.0,
        _ => return number(bytes, component) as f32,
    };
    (number(bytes, component) as f32 / most).max(-1.0)
}

/// A number in the units of its storage.
pub fn number(bytes: &[u8], component: Component) -> f64 {
    match component {
        Component::I8 => f64::from(bytes[0] as i8),
        Component::U8 => f64::from(bytes[0]),
        Component::I16 => f64::from(i16::from_le_bytes([bytes[0], bytes[1]])),
        Component::U16 => f64::from(u16::from_le_bytes([bytes[0], bytes[1]])),
        Component::U32 => f64::from(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        Component::F32 => f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
    }
}

fn unsigned(bytes: &[u8], component: Component) -> u32 {
    match component.size() {
        1 => u32::from(bytes[0]),
        2 => u32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
        _ => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
    }
}
