//! Values of arguments.

use objdict_model::literal::written_number;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A value of a few, each with its word and what it is.
pub(super) fn one_of<T: Clone + Send + Sync>(
    all: &'static [(T, &'static str, &'static str)],
) -> impl TypedValueParser<Value = T> {
    let words = all.iter().map(|(_, word, about)| {
        PossibleValue::new(*word).help(Some(*about).filter(|about| !about.is_empty()))
    });
    PossibleValuesParser::new(words).try_map(|given| {
        let found = all.iter().find(|(_, word, _)| *word == given);
        found.map(|(value, ..)| value.clone()).ok_or("there is no such value")
    })
}

/// A text of one line.
pub(super) fn node_name(text: &str) -> Result<String, String> {
    if text.chars().any(char::is_control) {
        Err("a name is one line".to_owned())
    } else {
        Ok(text.to_owned())
    }
}

/// 1 to 127, in decimal or as `0x7F`.
pub(super) fn node_id(text: &str) -> Result<u8, String> {
    let number = number(text).and_then(|number| u8::try_from(number).ok());
    number.filter(|id| (1..=127).contains(id)).ok_or_else(|| "a node-ID is a number from 1 to 127".to_owned())
}

/// 32 bits, in decimal or as `0x1234`.
pub(super) fn serial_number(text: &str) -> Result<u32, String> {
    number(text).ok_or_else(|| "a serial number is a number of 32 bits".to_owned())
}

/// A number in decimal or as `0x7F`.
pub(super) fn number(text: &str) -> Option<u32> {
    written_number(text, u32::MAX.into()).and_then(|number| u32::try_from(number).ok())
}
