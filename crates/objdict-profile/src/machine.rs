//! The state machine that a document defines, and its error codes.

use std::ops::RangeInclusive;

use super::{Profile, Values};

/// A state machine.
#[derive(Clone, Debug)]
pub struct StateMachine<'a> {
    /// The index of the object that has the state.
    pub status: u16,
    /// The index of the object that takes the commands.
    pub command: u16,
    /// The states, as values of the state object.
    pub states: Vec<(Values, &'a str)>,
    /// The commands with their bits in the command object: `0xxx x110`, shutdown.
    pub commands: Vec<(&'a str, &'a str)>,
    /// What leads from state to state.
    pub transitions: Vec<Transition<'a>>,
}

/// A transition of a state machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition<'a> {
    /// The number in the document.
    pub number: u8,
    /// The state before.
    pub from: &'a str,
    /// The state behind it.
    pub to: &'a str,
    /// The commands or events that cause it.
    pub by: &'a str,
}

impl Profile {
    /// The state machine of its devices.
    pub fn state_machine(&self) -> Option<StateMachine<'_>> {
        let machine = self.tables.machine?;
        let text = |part: super::tables::Part| part.of_text(&self.tables.texts);
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

    /// The error codes of EMCY that it defines beyond those of CiA 301, in ascending order.
    pub fn errors(&self) -> impl ExactSizeIterator<Item = (RangeInclusive<u64>, &str)> {
        let rows = self.tables.errors.of(&self.tables.meanings);
        rows.iter().map(|row| (row.first..=row.last, row.text.of_text(&self.tables.texts)))
    }

    /// What an error code of EMCY means.
    pub fn error(&self, code: u64) -> Option<&str> {
        self.errors().find(|(codes, _)| codes.contains(&code)).map(|(_, text)| text)
    }
}

#[cfg(test)]
mod tests {
    use crate::named;

    #[test]
    fn transitions_lead_from_state_to_state() {
        let machine = named("402").unwrap().state_machine().unwrap();
        let is_state = |name: &str| machine.states.iter().any(|(_, state)| *state == name);
        assert_eq!((machine.states.len(), machine.transitions.len()), (8, 17));
        for (number, transition) in (0..).zip(&machine.transitions) {
            assert_eq!(transition.number, number);
            assert!(is_state(transition.to), "{transition:?}");
            assert!(is_state(transition.from) || matches!(number, 0 | 13), "{transition:?}");
        }
        let is_used =
            |name: &str| machine.transitions.iter().any(|of| of.by.split(", ").any(|by| by == name));
        assert!(machine.commands.iter().all(|(_, name)| is_used(name)), "{:?}", machine.commands);
        assert!(machine.commands.iter().all(|(mask, _)| mask.len() == 9), "{:?}", machine.commands);
    }

    #[test]
    fn errors_of_a_drive_have_names() {
        let drive = named("402").unwrap();
        assert_eq!(drive.error(0x8611), Some("following error"));
        assert_eq!(drive.error(0x8612), Some("reference limit"));
        assert_eq!(drive.error(0x5115), Some("low voltage of a supply of the manufacturer"));
        assert_eq!(drive.error(0xFF00), None);
        let codes: Vec<u64> = drive.errors().flat_map(|(codes, _)| codes).collect();
        assert!(codes.is_sorted(), "{codes:X?}");
        assert_eq!(named("401").unwrap().errors().len(), 0);
    }
}
