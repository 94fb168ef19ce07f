//! Which entries are parameters: their values are saved, restored and compared.

use crate::download::{bytes_of, transferred_type};
use crate::model::{Access, Assignment, DataType, Device, Entry, PdoKind, Value};

/// Why an entry is no parameter: it is neither saved nor restored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum NoParameter {
    /// Writing it starts an action.
    Command,
    /// It moves something: a setpoint, an output, or an entry that is mapped into an RPDO.
    ProcessData,
    /// A program or a file.
    Domain,
}

objdict_model::messages! { NoParameter: {
    Self::Command => "command";
    Self::ProcessData => "process data";
    Self::Domain => "domain";
} }

/// Objects whose values are commands (CiA 301, CiA 302): error history, store and restore, operating system, programs, slaves.
const COMMANDS: [(u16, u16); 9] = [
    (0x1003, 0x1003),
    (0x1010, 0x1011),
    (0x1020, 0x1020), // when the configuration was made, which every write clears
    (0x1023, 0x1026),
    (0x1F25, 0x1F25),
    (0x1F50, 0x1F51),
    (0x1F57, 0x1F57),
    (0x1F82, 0x1F83),
    (0x1F8A, 0x1F8A),
];

/// Setpoints and modes of drives (CiA 402), for the first axis.
const OF_DRIVES: [u16; 12] =
    [0x6040, 0x6042, 0x6060, 0x6071, 0x607A, 0x60B0, 0x60B1, 0x60B2, 0x60C1, 0x60C2, 0x60FE, 0x60FF];

/// Outputs of I/O modules (CiA 401).
const OF_OUTPUTS: [(u16, u16); 5] =
    [(0x6200, 0x6200), (0x6220, 0x6227), (0x6300, 0x6300), (0x6320, 0x6320), (0x6410, 0x6414)];

/// Whether an entry is something else than a parameter, and what.
pub fn no_parameter(device: &Device, index: u16, sub: u8) -> Option<NoParameter> {
    let is_in = |ranges: &[(u16, u16)], index: u16| {
        ranges.iter().any(|(first, last)| (*first..=*last).contains(&index))
    };
    let of_axis = 0x6000 + index.wrapping_sub(0x6000) % 0x800;
    let is_of_profile = (0x6000..0xA000).contains(&index);
    let is_output = is_of_profile
        && (OF_DRIVES.contains(&of_axis) && device.profile() != Some(401)
            || is_in(&OF_OUTPUTS, of_axis) && device.profile() == Some(401));
    let is_mapped = || {
        let mut slots = device.pdos().filter(|pdo| pdo.kind == PdoKind::Rpdo);
        slots.any(|pdo| pdo.mapped().any(|object| (object.index, object.sub) == (index, sub)))
    };
    if is_in(&COMMANDS, index) {
        Some(NoParameter::Command)
    } else if index >= 0x2000 && (is_output || is_mapped()) {
        Some(NoParameter::ProcessData)
    } else if transferred_type(device, index, sub) == Some(DataType::DOMAIN) {
        Some(NoParameter::Domain)
    } else {
        None
    }
}

/// Whether a description lets an entry be read and written, so that its value can be saved.
pub fn is_saved(entry: &Entry) -> bool {
    entry.implied_access().is_some_and(|access| Access::is_readable(access) && Access::is_writable(access))
}

/// Entries that are no parameters, each with its reason.
pub type LeftOutEntries = Vec<((u16, u8), NoParameter)>;

/// The values of entries as assignments: bytes as they were transferred, of parameters that can be written and whose described value is
/// another one. The other entries are left out, each with its reason if it is no parameter.
pub fn present_values(
    device: &Device,
    node_id: u8,
    values: impl IntoIterator<Item = ((u16, u8), Vec<u8>)>,
) -> (Vec<Assignment>, LeftOutEntries) {
    let (mut assignments, mut left_out) = (Vec::new(), Vec::new());
    for ((index, sub), bytes) in values {
        let Some(entry) = device.entry(index, sub).filter(|entry| is_saved(entry)) else { continue };
        if let Some(reason) = no_parameter(device, index, sub) {
            left_out.push(((index, sub), reason));
            continue;
        }
        let described =
            entry.value().and_then(|value| bytes_of(device, index, sub, value, Some(node_id)).ok());
        let value =
            transferred_type(device, index, sub).and_then(|data_type| Value::from_bytes(&bytes, data_type));
        if let Some(value) = value.filter(|_| described.as_ref() != Some(&bytes)) {
            assignments.push(Assignment { index, sub, value });
        }
    }
    (assignments, left_out)
}
