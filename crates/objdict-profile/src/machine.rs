//! The state machine and error codes of a document.

use std::ops::RangeInclusive;

use super::{Profile, Values};

/// A state machine.
#[derive(Clone, Debug)]
pub struct StateMachine<'a> {
    /// The index of the object that has the state.
    pub status: u16,
    /// The index of the object that receives commands.
    pub command: u16,
    /// The states, as values of the state object.
    pub states: Vec<(Values, &'a str)>,
    /// The commands with their bits in the command object: `0xxx x110`, shutdown.
    pub commands: Vec<(&'a str, &'a str)>,
    /// The transitions between states.
    pub transitions: Vec<Transition<'a>>,
}

/// A transition of a state machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition<'a> {
    /// The number in the document.
    pub number: u8,
    /// The state before.
    pub from: &'a str,
    /// The state after it.
    pub to: &'a str,
    /// The commands or events that cause it.
    pub by: &'a str,
}

impl Profile {
    /// The state machine of its devices.
    pub fn state_machine(&self) -> Option<StateMachine<'_>> {
        let machine = self.tables.machine?;
        let text = |part: super::tables::SubList| part.of_text(&self.tables.texts);
        let status = self.object(machine.status).and_then(|facts| facts.entry(0));
        Some(StateMachine {
            status: machine.status,
            command: machine.command,
            states: status.and_then(|entry| Some(entry.bits().next()?.masked())).unwrap_or_default(),
            commands: self.tables.commands.iter().map(|row| (text(row.mask), text(row.name))).collect(),
            transitions: (self.tables.transitions.iter())
                .map(|row| Transition {
                    number: row.number,
                    from: text(row.from),
                    to: text(row.to),
                    by: text(row.by),
                })
                .collect(),
        })
    }

    /// The EMCY error codes that it defines beyond CiA 301, in ascending order.
    pub fn errors(&self) -> impl ExactSizeIterator<Item = (RangeInclusive<u64>, &str)> {
        let rows = self.tables.errors.of(&self.tables.meanings);
        rows.iter().map(|row| (row.first..=row.last, row.text.of_text(&self.tables.texts)))
    }

    /// The meaning of an EMCY error code.
    pub fn error(&self, code: u64) -> Option<&str> {
        self.errors().find(|(codes, _)| codes.contains(&code)).map(|(_, text)| text)
    }
}
