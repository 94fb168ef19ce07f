//! The state machine of a profile in TOML.

use serde::Deserialize;

use super::pack::Packer;
use crate::tables::{CommandRow, MachineRow, TransitionRow};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MachineTable {
    status: u16,
    command: u16,
    commands: Vec<CommandTable>,
    transitions: Vec<TransitionTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CommandTable {
    name: String,
    mask: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TransitionTable {
    number: u8,
    from: String,
    to: String,
    by: String,
}

impl MachineTable {
    pub(super) fn rows(
        &self,
        packer: &mut Packer,
    ) -> (Option<MachineRow>, Vec<CommandRow>, Vec<TransitionRow>) {
        let command =
            |row: &CommandTable| CommandRow { name: packer.text(&row.name), mask: packer.text(&row.mask) };
        let commands = self.commands.iter().map(command).collect();
        let transition = |row: &TransitionTable| TransitionRow {
            number: row.number,
            from: packer.text(&row.from),
            to: packer.text(&row.to),
            by: packer.text(&row.by),
        };
        let transitions = self.transitions.iter().map(transition).collect();
        (Some(MachineRow { status: self.status, command: self.command }), commands, transitions)
    }
}
