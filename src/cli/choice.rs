//! Option values out of a fixed list, given straight as the library's types.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, Error};
use std::ffi::OsStr;

/// One value of a list: its name on the command line, what it stands for, and its help.
pub type Choice<T> = (&'static str, T, &'static str);

/// The name of a value of a list.
pub fn name_of<T: PartialEq>(choices: &[Choice<T>], value: &T) -> &'static str {
    choices.iter().find(|choice| choice.1 == *value).map_or("?", |choice| choice.0)
}

/// A parser for the names of a list.
#[derive(Clone)]
pub struct Choices<T: 'static>(pub &'static [Choice<T>]);

impl<T: Copy + Send + Sync + 'static> TypedValueParser for Choices<T> {
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
