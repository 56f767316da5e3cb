//! Typed access to the members of JSON objects, with errors that name the position.

use super::json::{Json, Kind, Value};
use crate::io::{Place, Problem, ReadError};
use std::borrow::Cow;

/// An object whose members are read by name and type.
#[derive(Clone, Copy)]
pub struct Fields<'a> {
    pub json: &'a Json,
    pub object: Value,
}

impl<'a> Fields<'a> {
    pub fn new(json: &'a Json, object: Value) -> Result<Self, ReadError> {
        let is_object = json.kind(object) == Kind::Object;
        if is_object { Ok(Self { json, object }) } else { Err(mismatch(json, object, "an object")) }
    }

    pub fn root(json: &'a Json) -> Self {
        Self { json, object: json.root() }
    }

    pub fn place(&self) -> Place {
        self.json.place(self.object)
    }

    /// The position of a member, present or not.
    pub fn member(&self, name: &str) -> Place {
        Place::Json(format!("{}/{name}", self.json.pointer(self.object)))
    }

    pub fn child(&self, name: &str) -> Result<Option<Self>, ReadError> {
        let object =
            |value| (self.json.kind(value) == Kind::Object).then_some(Self { object: value, ..*self });
        self.typed(name, "an object", object)
    }

    pub fn required_child(&self, name: &str) -> Result<Self, ReadError> {
        self.child(name)?.ok_or_else(|| self.missing(name))
    }

    pub fn integer(&self, name: &str) -> Result<Option<u64>, ReadError> {
        self.typed(name, "a non-negative integer", |value| self.json.integer(value))
    }

    pub fn required(&self, name: &str) -> Result<u64, ReadError> {
        self.integer(name)?.ok_or_else(|| self.missing(name))
    }

    /// The number of one of `count` elements of another list, which are called `what`.
    pub fn reference(&self, name: &str, what: &str, count: usize) -> Result<Option<usize>, ReadError> {
        let index = self.integer(name)?;
        index.map(|index| checked_index(index, count, what, || self.member(name))).transpose()
    }

    pub fn required_reference(&self, name: &str, what: &str, count: usize) -> Result<usize, ReadError> {
        self.reference(name, what, count)?.ok_or_else(|| self.missing(name))
    }

    /// The numbers of elements of another list, as [`reference`](Self::reference); empty if there is no list.
    pub fn references(&self, name: &str, what: &str, count: usize) -> Result<Vec<usize>, ReadError> {
        let reference = |value| {
            let index = self.json.integer(value);
            let index = index.ok_or_else(|| mismatch(self.json, value, "a non-negative integer"))?;
            checked_index(index, count, what, || self.member(name))
        };
        self.items(name)?.map(reference).collect()
    }

    pub fn boolean(&self, name: &str) -> Result<Option<bool>, ReadError> {
        self.typed(name, "true or false", |value| self.json.boolean(value))
    }

    pub fn string(&self, name: &str) -> Result<Option<Cow<'a, str>>, ReadError> {
        let json = self.json;
        self.typed(name, "a string", |value| json.string(value))
    }

    pub fn required_string(&self, name: &str) -> Result<Cow<'a, str>, ReadError> {
        self.string(name)?.ok_or_else(|| self.missing(name))
    }

    pub fn name(&self) -> Result<String, ReadError> {
        Ok(self.string("name")?.unwrap_or_default().into_owned())
    }

    pub fn number(&self, name: &str) -> Result<Option<f64>, ReadError> {
        self.typed(name, "a finite number", |value| self.json.number(value).filter(|n| n.is_finite()))
    }

    pub fn numbers<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, ReadError> {
        self.typed(name, &format!("a list of {N} finite numbers"), |value| {
            let mut numbers = [0.0; N];
            let mut elements = self.json.elements(value);
            for number in &mut numbers {
                *number = self.json.number(elements.next()?).filter(|n| n.is_finite())?;
            }
            elements.next().is_none().then_some(numbers)
        })
    }

    pub fn items(&self, name: &str) -> Result<impl Iterator<Item = Value> + use<'a>, ReadError> {
        let json = self.json;
        let array = self.typed(name, "a list", |value| (json.kind(value) == Kind::Array).then_some(value))?;
        Ok(array.into_iter().flat_map(|array| json.elements(array)))
    }

    /// The elements of a list, which must be objects; empty if there is no list.
    pub fn list(&self, name: &str) -> Result<Vec<Value>, ReadError> {
        self.items(name)?.map(|value| Ok(Fields::new(self.json, value)?.object)).collect()
    }

    pub fn extension(&self, name: &str) -> Option<Value> {
        self.json.member(self.json.member(self.object, "extensions")?, name)
    }

    pub fn missing(&self, name: &str) -> ReadError {
        let found = format!("the required member `{name}` is missing");
        ReadError::new(Problem::Syntax, self.place(), found, "export the file again")
    }

    fn typed<T>(
        &self,
        name: &str,
        wanted: &str,
        get: impl Fn(Value) -> Option<T>,
    ) -> Result<Option<T>, ReadError> {
        let Some(value) = self.json.member(self.object, name) else { return Ok(None) };
        get(value).map(Some).ok_or_else(|| mismatch(self.json, value, wanted))
    }
}

fn mismatch(json: &Json, value: Value, wanted: &str) -> ReadError {
    let raw = json.raw(value);
    let short: String = raw.chars().take(40).collect();
    let dots = if short.len() < raw.len() { "..." } else { "" };
    let found = format!("{short}{dots} is not {wanted}");
    ReadError::new(Problem::Syntax, json.place(value), found, "export the file again")
}

pub fn numbered(list: &str, number: usize) -> Place {
    Place::Json(format!("/{list}/{number}"))
}

/// An index if it is that of one of `count` elements, which are called `what`.
pub fn checked_index(
    index: u64,
    count: usize,
    what: &str,
    place: impl FnOnce() -> Place,
) -> Result<usize, ReadError> {
    let checked = usize::try_from(index).ok().filter(|&index| index < count);
    checked.ok_or_else(|| {
        out_of_range(place(), format!("{what} {index} is out of range (the file has {count})"))
    })
}

/// An error about a file that contradicts itself.
pub fn out_of_range(place: Place, found: impl Into<String>) -> ReadError {
    ReadError::new(Problem::Range, place, found, "the file is damaged; export it again")
}

/// An error about data that only an extension can decompress.
pub fn only_compressed(place: Place, found: impl Into<String>) -> ReadError {
    let advice = "decompress the file first, for example with `gltf-transform copy`";
    ReadError::new(Problem::Unsupported, place, found, advice)
}
