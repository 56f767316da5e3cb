//! Option values out of a fixed list: one table of an enum's names serves parsing, help, text and JSON.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, Error};
use serde::Serializer;
use std::ffi::OsStr;

/// One value of a list: its name on the command line and in reports, the value, and its help.
pub type Choice<T> = (&'static str, T, &'static str);

/// A type whose values are chosen by name.
pub trait Choose: Copy + PartialEq + Send + Sync + 'static {
    const CHOICES: &'static [Choice<Self>];

    /// The value's name.
    fn choice(self) -> &'static str {
        Self::CHOICES.iter().find(|choice| choice.1 == self).map_or("?", |choice| choice.0)
    }
}

/// Gives a type its table of names: `"name" => value: "help"`, with the name of a variant or a constant as the value.
macro_rules! choices {
    ($type:ident { $($name:literal => $value:ident $(($inner:expr))?: $help:expr,)+ }) => {
        impl $crate::cli::common::choice::Choose for $type {
            const CHOICES: &'static [$crate::cli::common::choice::Choice<Self>] =
                &[$(($name, $type::$value $(($inner))?, $help)),+];
        }
    };
}
pub(crate) use choices;

/// Serialises a value as its name.
pub fn as_name<T: Choose, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(value.choice())
}

/// A parser for the names of a type's values.
pub fn one_of<T: Choose>() -> Choices<T> {
    Choices(T::CHOICES)
}

/// See [`one_of`].
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
        Some(Box::new(self.0.iter().map(|&(name, _, help)| PossibleValue::new(name).help(help))))
    }
}
