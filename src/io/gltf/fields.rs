//! Typed access to the members of JSON objects, with errors that name the place.

use super::json::{Json, Kind, Value};
use crate::io::{Place, Problem, ReadError};
use std::borrow::Cow;

/// The place of an object in a document: up to two numbered steps, such as `/meshes/3/primitives/1`, and up to two more by
/// name.
#[derive(Clone, Copy, Debug, Default)]
pub struct At {
    steps: [Option<(&'static str, usize)>; 2],
    names: [Option<&'static str>; 2],
}

impl At {
    pub fn new(list: &'static str, number: usize) -> At {
        At { steps: [Some((list, number)), None], names: [None; 2] }
    }

    pub fn then(self, list: &'static str, number: usize) -> At {
        At { steps: [self.steps[0], Some((list, number))], names: [None; 2] }
    }

    /// The place of a member that is an object itself.
    pub fn member_at(self, name: &'static str) -> At {
        let [first, _] = self.names;
        At { names: first.map_or([Some(name), None], |first| [Some(first), Some(name)]), ..self }
    }

    pub fn place(self) -> Place {
        Place::Json(self.pointer())
    }

    pub fn member(self, name: &str) -> Place {
        Place::Json(format!("{}/{name}", self.pointer()))
    }

    fn pointer(self) -> String {
        let steps = self.steps.iter().flatten().map(|(list, number)| format!("/{list}/{number}"));
        steps.chain(self.names.iter().flatten().map(|name| format!("/{name}"))).collect()
    }
}

/// An object whose members are read by name and type.
#[derive(Clone, Copy)]
pub struct Fields<'a> {
    pub json: &'a Json,
    pub object: Value,
    pub at: At,
}

impl<'a> Fields<'a> {
    /// The fields of a whole document, which is known to be an object.
    pub fn root(json: &'a Json) -> Self {
        Self { json, object: json.root(), at: At::default() }
    }

    /// The fields of a value, which must be an object.
    pub fn new(json: &'a Json, object: Value, at: At) -> Result<Self, ReadError> {
        if json.kind(object) == Kind::Object {
            Ok(Self { json, object, at })
        } else {
            Err(mismatch(json, object, at.place(), "an object"))
        }
    }

    /// The fields of a member, which must be an object.
    pub fn child(&self, name: &'static str) -> Result<Option<Self>, ReadError> {
        Ok(self.object(name)?.map(|object| Self { object, at: self.at.member_at(name), ..*self }))
    }

    /// The fields of a member that has to be there.
    pub fn required_child(&self, name: &'static str) -> Result<Self, ReadError> {
        self.child(name)?.ok_or_else(|| self.missing(name))
    }

    /// A non-negative integer.
    pub fn integer(&self, name: &str) -> Result<Option<u64>, ReadError> {
        self.typed(name, "a non-negative integer", |value| self.json.integer(value))
    }

    /// The number of an element in another list.
    pub fn index(&self, name: &str) -> Result<Option<usize>, ReadError> {
        let index = self.integer(name)?;
        Ok(index.map(|index| usize::try_from(index).unwrap_or(usize::MAX)))
    }

    /// The number of one of `count` elements of another list, which are called `what`.
    pub fn reference(&self, name: &str, what: &str, count: usize) -> Result<Option<usize>, ReadError> {
        let index = self.index(name)?;
        index.map(|index| checked_index(index, count, what, || self.at.member(name))).transpose()
    }

    /// A non-negative integer that has to be there.
    pub fn required(&self, name: &str) -> Result<u64, ReadError> {
        self.integer(name)?.ok_or_else(|| self.missing(name))
    }

    pub fn boolean(&self, name: &str) -> Result<Option<bool>, ReadError> {
        self.typed(name, "true or false", |value| self.json.boolean(value))
    }

    pub fn string(&self, name: &str) -> Result<Option<Cow<'a, str>>, ReadError> {
        let json = self.json;
        self.typed(name, "a string", |value| json.string(value))
    }

    /// A finite number.
    pub fn number(&self, name: &str) -> Result<Option<f64>, ReadError> {
        self.typed(name, "a finite number", |value| self.json.number(value).filter(|n| n.is_finite()))
    }

    /// A list of exactly `N` numbers, all finite.
    pub fn numbers<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, ReadError> {
        self.typed(name, "a list of finite numbers of the right length", |value| {
            let mut numbers = [0.0; N];
            let mut elements = self.json.elements(value);
            for number in &mut numbers {
                *number = self.json.number(elements.next()?).filter(|n| n.is_finite())?;
            }
            elements.next().is_none().then_some(numbers)
        })
    }

    pub fn object(&self, name: &str) -> Result<Option<Value>, ReadError> {
        self.typed(name, "an object", |value| (self.json.kind(value) == Kind::Object).then_some(value))
    }

    pub fn array(&self, name: &str) -> Result<Option<Value>, ReadError> {
        self.typed(name, "a list", |value| (self.json.kind(value) == Kind::Array).then_some(value))
    }

    /// The elements of a list; none if there is none.
    pub fn items(&self, name: &str) -> Result<impl Iterator<Item = Value> + use<'a>, ReadError> {
        let json = self.json;
        Ok(self.array(name)?.into_iter().flat_map(|array| json.elements(array)))
    }

    /// All values of a top-level list, which must be objects, by number; empty if there is no list.
    pub fn list(&self, name: &'static str) -> Result<Vec<Value>, ReadError> {
        let values: Vec<Value> = self.items(name)?.collect();
        for (number, &value) in values.iter().enumerate() {
            Fields::new(self.json, value, At::new(name, number))?;
        }
        Ok(values)
    }

    /// A list of element numbers; empty if there is none.
    pub fn indices(&self, name: &str) -> Result<Vec<usize>, ReadError> {
        let index = |value| {
            let index = self.json.integer(value).and_then(|index| usize::try_from(index).ok());
            index.ok_or_else(|| mismatch(self.json, value, self.at.member(name), "a non-negative integer"))
        };
        self.items(name)?.map(index).collect()
    }

    /// An extension object by name, if there.
    pub fn extension(&self, name: &str) -> Option<Value> {
        let extensions = self.json.member(self.object, "extensions")?;
        self.json.member(extensions, name)
    }

    pub fn missing(&self, name: &str) -> ReadError {
        let found = format!("no `{name}`, which glTF requires");
        ReadError::new(Problem::Syntax, self.at.place(), found, "export the file again")
    }

    fn typed<T>(
        &self,
        name: &str,
        wanted: &str,
        get: impl Fn(Value) -> Option<T>,
    ) -> Result<Option<T>, ReadError> {
        let Some(value) = self.json.member(self.object, name) else { return Ok(None) };
        match get(value) {
            Some(typed) => Ok(Some(typed)),
            None => Err(mismatch(self.json, value, self.at.member(name), wanted)),
        }
    }
}

fn mismatch(json: &Json, value: Value, place: Place, wanted: &str) -> ReadError {
    let raw = json.raw(value);
    let short: String = raw.chars().take(40).collect();
    let dots = if short.len() < raw.len() { "..." } else { "" };
    let found = format!("{short}{dots} where {wanted} should be");
    ReadError::new(Problem::Syntax, place, found, "export the file again")
}

/// An index if it is that of one of `count` elements, which are called `what`.
pub fn checked_index(
    index: usize,
    count: usize,
    what: &str,
    place: impl FnOnce() -> Place,
) -> Result<usize, ReadError> {
    if index < count {
        return Ok(index);
    }
    let found = format!("{what} {index} is asked for, counted from 0, where the file has {count}");
    Err(out_of_range(place(), found))
}

/// An error about a file that contradicts itself.
pub fn out_of_range(place: Place, found: impl Into<String>) -> ReadError {
    ReadError::new(Problem::Range, place, found, "the file is broken; export it again")
}

/// An error about data that only an extension can decompress.
pub fn only_compressed(place: Place, found: impl Into<String>) -> ReadError {
    let advice = "decompress the file first, for example with `gltf-transform copy`";
    ReadError::new(Problem::Unsupported, place, found, advice)
}
