//! Typed access to the members of JSON objects, with errors that say where.

use crate::io::gltf::json::tree::{Json, Kind, Value};
use crate::io::{Place, Problem, ReadError};
use std::borrow::Cow;

/// The place of an object in a document: up to two numbered steps, such as `/meshes/3/primitives/1`, and perhaps one more
/// by name.
#[derive(Clone, Copy, Debug, Default)]
pub struct At {
    steps: [Option<(&'static str, usize)>; 2],
    last: Option<&'static str>,
}

impl At {
    pub fn new(list: &'static str, number: usize) -> At {
        At { steps: [Some((list, number)), None], last: None }
    }

    pub fn then(self, list: &'static str, number: usize) -> At {
        At { steps: [self.steps[0], Some((list, number))], last: None }
    }

    /// The place of a member that is an object itself.
    pub fn member_at(self, name: &'static str) -> At {
        At { last: Some(name), ..self }
    }

    pub fn place(self) -> Place {
        Place::Json(self.pointer())
    }

    pub fn member(self, name: &str) -> Place {
        Place::Json(format!("{}/{name}", self.pointer()))
    }

    /// The numbers of the two steps; 0 for one that is not there.
    pub fn numbers(self) -> (usize, usize) {
        let [first, second] = self.steps.map(|step| step.map_or(0, |(_, number)| number));
        (first, second)
    }

    fn pointer(self) -> String {
        let steps = self.steps.iter().flatten().map(|(list, number)| format!("/{list}/{number}"));
        steps.chain(self.last.map(|name| format!("/{name}"))).collect()
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
    /// The fields of a value, which must be an object.
    pub fn new(json: &'a Json, object: Value, at: At) -> Result<Self, ReadError> {
        if json.kind(object) == Kind::Object {
            Ok(Self { json, object, at })
        } else {
            Err(mismatch(json, object, at.place(), "an object"))
        }
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

    /// A list of element numbers; empty if there is none.
    pub fn indices(&self, name: &str) -> Result<Vec<usize>, ReadError> {
        let Some(array) = self.array(name)? else { return Ok(Vec::new()) };
        let index = |value| {
            let index = self.json.integer(value).and_then(|index| usize::try_from(index).ok());
            index.ok_or_else(|| mismatch(self.json, value, self.at.member(name), "a non-negative integer"))
        };
        self.json.elements(array).map(index).collect()
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

/// An error about an element number that is too large.
pub fn dangling(place: Place, what: &str, index: usize, count: usize) -> ReadError {
    let found = format!("{what} {index} is asked for, counted from 0, where the file has {count}");
    ReadError::new(Problem::Range, place, found, "the file is broken; export it again")
}
