//! How an answer contradicts the description, if it does: one exchange beside the entry that it is about.

use std::cmp::Ordering;

use super::exchange::{SdoAnswer, SdoRequest};
use super::expectation::{Expectation, hex};
use super::plan::is_command;
use objdict_bus::Abort;
use objdict_lint::recorded::probe::*;
use objdict_model::diagnostic::{RuleInfo, Text, say};
use objdict_model::model::{Access, Field};

/// A contradiction between an answer and the description.
#[derive(Clone, Debug)]
pub(super) struct Contradiction {
    pub(super) rule: &'static RuleInfo,
    pub(super) message: Text,
    pub(super) at: Aspect,
}

/// What of the entry is contradicted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Aspect {
    Entry,
    /// The default, or the configured value.
    Value,
    Field(Field),
}

/// What is known of the value of an entry from what was written before.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) enum KnownValue {
    /// It was not written.
    #[default]
    Untouched,
    Written(Vec<u8>),
    /// It was written and saved before a reset (1010h): it is what was written, or what the device starts with.
    Saved,
    /// Something was accepted that should not have been.
    Unknown,
}

type ProbeVerdict = Option<Contradiction>;

fn contradiction(rule: &'static RuleInfo, at: Aspect, message: Text) -> ProbeVerdict {
    Some(Contradiction { rule, message, at })
}

/// An entry that is not described, at an index that is or is not.
pub(super) fn of_undescribed(
    place: &str,
    request: &SdoRequest,
    answer: &SdoAnswer,
    has_object: bool,
) -> ProbeVerdict {
    match answer {
        SdoAnswer::Silence => no_answer(place),
        SdoAnswer::Abort(Abort::NoObject) if !has_object => None,
        SdoAnswer::Abort(Abort::NoSubIndex) => None,
        SdoAnswer::Abort(abort) => {
            let right = if has_object { Abort::NoSubIndex } else { Abort::NoObject };
            wrong_abort(place, asked(request), *abort, right)
        }
        _ => contradiction(
            &UNDESCRIBED,
            Aspect::Entry,
            say!("the device has {}, which is not described", place),
        ),
    }
}

/// The answer to a request to read a described entry.
pub(super) fn of_upload(entry: &Expectation, answer: &SdoAnswer, memory: &KnownValue) -> ProbeVerdict {
    let place = &entry.place();
    match answer {
        SdoAnswer::Silence => no_answer(place),
        SdoAnswer::Abort(Abort::NoObject | Abort::NoSubIndex) if is_history(entry) => None,
        SdoAnswer::Abort(abort @ (Abort::NoObject | Abort::NoSubIndex)) => absent(place, *abort),
        SdoAnswer::Abort(Abort::WriteOnly) if !entry.is_readable() => None,
        SdoAnswer::Abort(abort) if !entry.is_readable() => {
            wrong_abort(place, "reading", *abort, Abort::WriteOnly)
        }
        // python-canopen answers with the second one
        SdoAnswer::Abort(Abort::NoData | Abort::NoSdoConnection)
            if entry.default.as_ref().is_none_or(Vec::is_empty) || is_history(entry) =>
        {
            None
        }
        SdoAnswer::Abort(abort) => {
            let message =
                say!("{} is {}, and reading it is aborted with {}", place, access(entry), words(*abort));
            contradiction(&NOT_READABLE, Aspect::Field(Field::AccessType), message)
        }
        _ if !entry.is_readable() => {
            let message = say!("{} is {}, and can be read", place, access(entry));
            contradiction(&READABLE, Aspect::Field(Field::AccessType), message)
        }
        SdoAnswer::Length(length) => of_size(entry, (*length)?),
        SdoAnswer::Done => None,
        answer => match answer.bytes(entry.data_type) {
            Some(bytes) => of_value(entry, &bytes, memory),
            None => {
                let SdoAnswer::Text(text) = answer else { return None };
                let message = say!("{} is `{}`, which is not a valid {}", place, text, type_name(entry));
                contradiction(&INVALID_VALUE, Aspect::Field(Field::DataType), message)
            }
        },
    }
}

/// A value that was read.
fn of_value(entry: &Expectation, bytes: &[u8], memory: &KnownValue) -> ProbeVerdict {
    if *memory == KnownValue::Unknown {
        return None;
    }
    of_size(entry, bytes.len())
        .or_else(|| {
            let defect = entry.defect(bytes)?;
            let message = say!(
                "{} is `{}`: {}, so it is not a valid {}",
                entry.place(),
                hex(bytes),
                defect,
                type_name(entry)
            );
            contradiction(&INVALID_VALUE, Aspect::Field(Field::DataType), message)
        })
        .or_else(|| {
            let (limit, side) = entry.exceeded(bytes)?;
            let field = limit_field(side);
            let message = say!("{} is {}, and `{}` is {}", entry.place(), entry.shown(bytes), field, limit);
            contradiction(&OUTSIDE_LIMITS, Aspect::Field(field), message)
        })
        .or_else(|| of_content(entry, bytes, memory))
}

fn of_size(entry: &Expectation, length: usize) -> ProbeVerdict {
    let expected = entry.length().filter(|expected| *expected != length)?;
    let message = say!("{} has {} bytes, and {} has {}", entry.place(), length, type_name(entry), expected);
    contradiction(&WRONG_SIZE, Aspect::Field(Field::DataType), message)
}

/// A value beside the one that is described, or that was written.
fn of_content(entry: &Expectation, bytes: &[u8], memory: &KnownValue) -> ProbeVerdict {
    let place = entry.place();
    if let KnownValue::Written(written) = memory {
        let is_own = bytes == written || entry.is_mappable || is_service(entry.index);
        let message =
            || say!("{} is {}, and {} was written", place, entry.shown(bytes), entry.shown(written));
        return if is_own { None } else { contradiction(&OTHER_THAN_WRITTEN, Aspect::Entry, message()) };
    }
    let described = entry.default.as_ref().filter(|_| !is_volatile(entry) && *memory != KnownValue::Saved)?;
    if is_same(entry, bytes, described) {
        return None;
    }
    let message = say!("{} is {}, and {} is described", place, entry.shown(bytes), entry.shown(described));
    let rule = match entry {
        entry if entry.is_highest_sub && !entry.is_writable() => &HIGHEST_SUB_INDEX,
        entry if entry.access == Some(Access::Const) || is_identity(entry) => &OTHER_VALUE,
        // process data
        entry if entry.is_mappable => return None,
        _ => &OTHER_DEFAULT,
    };
    contradiction(rule, Aspect::Value, message)
}

/// Whether two values are the same; zeros may follow a text.
fn is_same(entry: &Expectation, bytes: &[u8], described: &[u8]) -> bool {
    let text = |bytes: &[u8]| bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    match entry.length() {
        Some(_) => bytes == described,
        None => bytes[..text(bytes)] == described[..text(described)],
    }
}

/// The answer to a request to write a described entry.
pub(super) fn of_download(entry: &Expectation, bytes: &[u8], answer: &SdoAnswer) -> ProbeVerdict {
    let place = &entry.place();
    let abort = match answer {
        SdoAnswer::Silence => return no_answer(place),
        SdoAnswer::Abort(abort @ (Abort::NoObject | Abort::NoSubIndex)) => return absent(place, *abort),
        SdoAnswer::Abort(abort) => Some(*abort),
        _ => None,
    };
    if !entry.is_writable() {
        return match abort {
            Some(Abort::ReadOnly) => None,
            Some(abort) => wrong_abort(place, "writing", abort, Abort::ReadOnly),
            None => {
                let message = say!("{} is {}, and can be written", place, access(entry));
                contradiction(&WRITABLE, Aspect::Field(Field::AccessType), message)
            }
        };
    }
    if let Some(abort @ (Abort::ReadOnly | Abort::UnsupportedAccess)) = abort {
        let message = say!("{} is {}, and writing it is aborted with {}", place, access(entry), words(abort));
        return contradiction(&NOT_WRITABLE, Aspect::Field(Field::AccessType), message);
    }
    if !entry.fits(bytes) {
        return of_wrong_size(entry, bytes, abort);
    }
    match entry.exceeded(bytes) {
        Some((limit, side)) => {
            let field = limit_field(side);
            let right = if side == Ordering::Less { Abort::TooLow } else { Abort::TooHigh };
            match abort {
                Some(Abort::InvalidValue) => None,
                Some(abort) if abort == right => None,
                Some(abort) => wrong_abort(place, "writing a value outside the limits of", abort, right),
                None => {
                    let message =
                        say!("{} takes {}, and `{}` is {}", place, entry.shown(bytes), field, limit);
                    contradiction(&UNCHECKED_LIMIT, Aspect::Field(field), message)
                }
            }
        }
        None => {
            let abort = abort.filter(|_| !is_service(entry.index))?;
            let message = say!("{} rejects {} with {}", place, entry.shown(bytes), words(abort));
            contradiction(&REFUSED_VALUE, Aspect::Entry, message)
        }
    }
}

fn of_wrong_size(entry: &Expectation, bytes: &[u8], abort: Option<Abort>) -> ProbeVerdict {
    let is_long = entry.length().is_some_and(|length| length < bytes.len());
    let right = if is_long { Abort::TooLong } else { Abort::TooShort };
    match abort {
        Some(Abort::LengthMismatch) => None,
        Some(abort) if abort == right => None,
        Some(abort) => wrong_abort(&entry.place(), "writing a wrong number of bytes to", abort, right),
        None => {
            let message = say!("{} takes {} bytes, and is {}", entry.place(), bytes.len(), type_name(entry));
            contradiction(&UNCHECKED_SIZE, Aspect::Field(Field::DataType), message)
        }
    }
}

fn no_answer(place: &str) -> ProbeVerdict {
    contradiction(&NO_ANSWER, Aspect::Entry, say!("no response to a request for {}", place))
}

fn absent(place: &str, abort: Abort) -> ProbeVerdict {
    contradiction(
        &ABSENT,
        Aspect::Entry,
        say!("the device lacks {}: it responds with {}", place, words(abort)),
    )
}

fn wrong_abort(place: &str, what: &str, abort: Abort, right: Abort) -> ProbeVerdict {
    let message = say!("{} {} is aborted with `{}` instead of `{}`", what, place, words(abort), words(right));
    contradiction(&WRONG_ABORT, Aspect::Entry, message)
}

/// An abort code with its meaning.
pub(super) fn words(abort: Abort) -> String {
    abort.to_string().trim_start_matches("SDO abort ").to_owned()
}

const fn asked(request: &SdoRequest) -> &'static str {
    match request {
        SdoRequest::Upload => "reading",
        SdoRequest::Download(_) => "writing",
    }
}

const fn limit_field(side: Ordering) -> Field {
    match side {
        Ordering::Less => Field::LowLimit,
        _ => Field::HighLimit,
    }
}

fn access(entry: &Expectation) -> &'static str {
    entry.access.map_or("not stated", Access::name)
}

fn type_name(entry: &Expectation) -> String {
    entry.data_type.map(|data_type| data_type.to_string()).unwrap_or_default()
}

/// Errors that there may not have been.
const fn is_history(entry: &Expectation) -> bool {
    entry.index == 0x1003 && entry.sub > 0
}

/// Whether the value is not the described one as a matter of course: errors, commands, the serial number.
fn is_volatile(entry: &Expectation) -> bool {
    let is_unnumbered = entry.default.as_ref().is_some_and(|bytes| bytes.iter().all(|byte| *byte == 0));
    matches!(entry.index, 0x1001..=0x1003 | 0x1010 | 0x1011 | 0x1F50..=0x1F5F)
        || ((entry.index, entry.sub) == (0x1018, 4) && is_unnumbered)
}

const fn is_identity(entry: &Expectation) -> bool {
    matches!((entry.index, entry.sub), (0x1000, 0) | (0x1018, 1..=3))
}

/// Whether what is written has conditions that the description does not state.
fn is_service(index: u16) -> bool {
    matches!(index, 0x1000..0x2000) || is_command(index)
}
