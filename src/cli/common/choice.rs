//! Option values out of a fixed list: one table of an enum's names serves parsing, help, text and JSON.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, Error};
use crease::io::Format;
use crease::text::{Catalogue, Language};
use serde::Serializer;
use std::ffi::OsStr;

/// One value of a list: its name on the command line and in reports, and the value.
pub type Choice<T> = (&'static str, T);

/// The help of each value, by the type in small letters and the value's name.
static HELP: Catalogue = english(include_str!("values.en.ftl"));

/// A type whose values are chosen by name.
pub trait Choose: Copy + PartialEq + Send + Sync + 'static {
    const TYPE: &'static str;
    const CHOICES: &'static [Choice<Self>];

    fn choice(self) -> &'static str {
        Self::CHOICES.iter().find(|choice| choice.1 == self).map_or("?", |choice| choice.0)
    }
}

/// Gives a type its table of names: `"name" => value`, with the name of a variant or a constant as the value.
macro_rules! choices {
    ($type:ident: $($name:literal => $value:ident $(($inner:expr))?),+ $(,)?) => {
        impl $crate::cli::common::choice::Choose for $type {
            const TYPE: &'static str = stringify!($type);
            const CHOICES: &'static [$crate::cli::common::choice::Choice<Self>] =
                &[$(($name, $type::$value $(($inner))?)),+];
        }
    };
}
pub(crate) use choices;

/// Texts in English alone.
pub const fn english(source: &'static str) -> Catalogue {
    Catalogue::new(source, source)
}

/// Serialises a value as its name.
pub fn as_name<T: Choose, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(value.choice())
}

/// A parser for the names of a type's values.
pub fn one_of<T: Choose>() -> Choices<T> {
    Choices(T::CHOICES)
}

/// The same for the formats that are written: all but the last.
pub fn written_formats() -> Choices<Format> {
    Choices(&Format::CHOICES[..Format::WRITTEN.len()])
}

#[derive(Clone)]
pub struct Choices<T: 'static>(&'static [Choice<T>]);

impl<T: Choose> TypedValueParser for Choices<T> {
    type Value = T;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<T, Error> {
        let known = PossibleValuesParser::new(self.0.iter().map(|choice| choice.0));
        let name = known.parse_ref(command, arg, value)?;
        let chosen = self.0.iter().find(|choice| choice.0 == name);
        Ok(chosen.expect("clap has checked the name").1)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(|&(name, _)| {
            let help = HELP.get(&format!("{}-{name}", T::TYPE.to_ascii_lowercase()));
            PossibleValue::new(name).help(help.get(Language::English).to_owned())
        })))
    }
}
