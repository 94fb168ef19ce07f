//! The target `canopen-stack`: the `CO_OBJ` table of embedded-office's canopen-stack 4.4 and its values.
//!
//! One row per sub-index. Constants of up to 16 bits are stored in the row, longer ones in flash; values that
//! can change are separate variables or members of their storage group. The files define additional types
//! where the types of the stack do not follow the description: writable texts, numbers of 24 and of 40 to 64
//! bits, and blocks of up to 4 bytes, which the stack reads only once.

mod cell;
mod checks;
mod hooks;
mod layout;
mod para;
mod rows;
mod sizes;
mod special;

use super::c_code::file_name;
use super::dictionary::TableDictionary;
use super::head::Head;
use super::notes::{in_order, once_per_object};
use super::{BackendOutput, GenerateError, Options, render};
use crate::model::{Device, PdoKind};
use cell::{PlannedRow, Planner, RowType};
use hooks::TypeHook;
use layout::RowLayout;
use para::ParameterArrays;
use rows::StackRow;

/// What the files have.
struct CanOpenStackView<'a> {
    head: Head,
    dictionary: &'a TableDictionary<'a>,
    planned: Vec<Vec<PlannedRow>>,
    layout: RowLayout,
    parameters: ParameterArrays,
    rows: Vec<StackRow>,
    hooks: Vec<TypeHook>,
}

include!("../../expanded/canopen-stack/od.c.rs");
include!("../../expanded/canopen-stack/od.h.rs");
include!("../../expanded/canopen-stack/spec.c.rs");

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let mut dictionary = TableDictionary::new(device, options)?;
    let prefix = options.prefix_or("od")?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let planned = Planner { node_id: dictionary.node_id, notes: &mut notes }.plan(&dictionary);
    let mut layout = RowLayout::new(&dictionary, &planned, options, &prefix, &mut notes);
    let parameters = ParameterArrays::new(&dictionary, &planned, &mut layout, &prefix, &mut notes);
    let mut rows = rows::rows(&dictionary, &planned, &layout);
    let hooks = hooks::mark(&mut rows, options, &prefix, &mut notes);
    checks::check(&dictionary, rows.len(), &mut notes);
    let head = Head::new(device, options, &prefix, &file_name(options, "od"));
    let tables = CanOpenStackView { head, dictionary: &dictionary, planned, layout, parameters, rows, hooks };
    let stem = &tables.head.stem;
    let files = vec![
        render(format!("{stem}.c"), tables.source()),
        render(format!("{stem}.h"), tables.header()),
        render(format!("{stem}_spec.c"), tables.specification()),
    ];
    Ok(BackendOutput { files, notes: once_per_object(in_order(notes)), size: sizes::report(&tables) })
}

impl CanOpenStackView<'_> {
    /// Whether a row has a type.
    fn has(&self, type_: RowType) -> bool {
        self.planned.iter().flatten().any(|row| row.type_ == type_)
    }

    /// Whether a type of this target is replaced by one of the application, which then can call its functions.
    fn shares(&self, type_: RowType) -> bool {
        self.rows.iter().any(|row| row.hooked && row.type_ == type_)
    }

    /// Minimum counts in the configuration of the stack: the middle part of the macro name, the count, of what, and an
    /// additional condition.
    fn counts(&self) -> [(&'static str, u16, &'static str, &'static str); 4] {
        let TableDictionary { device, objects, .. } = self.dictionary;
        let highest = |kind: PdoKind| {
            let pdos = device.pdos().filter(|pdo| pdo.kind == kind && pdo.communication.is_some());
            pdos.map(|pdo| pdo.number).max().unwrap_or(1)
        };
        let up_to = |first: u16, last: u16| {
            let indexes = objects.iter().map(|object| object.index);
            indexes.filter(|index| (first..=last).contains(index)).max().map_or(1, |index| index - first + 1)
        };
        [
            ("SSDO", up_to(0x1200, 0x127F), "SDO servers", ""),
            ("CSDO", up_to(0x1280, 0x12FF), "SDO clients", " && USE_CSDO"),
            ("RPDO", highest(PdoKind::Rpdo), "RPDOs", ""),
            ("TPDO", highest(PdoKind::Tpdo), "TPDOs", ""),
        ]
    }

    /// In bit/s.
    fn baud_rate(&self) -> u32 {
        let device = self.dictionary.device;
        let chosen = device.commissioning.as_ref().and_then(|commissioning| commissioning.baud_rate);
        let fastest = || device.device_info.as_ref()?.baud_rates.supported().max();
        u32::from(chosen.or_else(fastest).unwrap_or(125)) * 1000
    }

    /// Heartbeat, SYNC and LSS; a timer per consumer; an event timer and an inhibit time per TPDO.
    fn timers(&self) -> u16 {
        let consumers = self.dictionary.object(0x1016);
        let consumers = consumers.map_or(0, |object| object.entries.len().saturating_sub(1));
        let pdos = self.dictionary.device.pdo_count(PdoKind::Tpdo);
        u16::try_from(3 + consumers + 2 * pdos).unwrap_or(u16::MAX)
    }

    fn has_emcy(&self) -> bool {
        self.dictionary.device.object(0x1014).is_some()
    }
}
