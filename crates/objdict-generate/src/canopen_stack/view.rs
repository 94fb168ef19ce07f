//! Views of the canopen-stack templates.

use askama::Template;

use super::cell::{Cell, Planned, Type};
use super::layout::Layout;
use super::para::Parameters;
use crate::Options;
use crate::dictionary::Dictionary;
use crate::escape::filters;
use crate::model::PdoKind;

/// A row of the table.
pub(super) struct Row {
    pub(super) index: u16,
    sub: u8,
    flags: String,
    type_: Type,
    data: String,
    name: String,
}

impl Row {
    fn type_name(&self, prefix: &str) -> String {
        match self.type_ {
            Type::Stack(name) => name.to_owned(),
            Type::Block => format!("&{prefix}_block"),
            Type::Bytes => format!("&{prefix}_bytes"),
        }
    }
}

/// A minimum count in the configuration of the stack.
struct Count {
    /// The middle part of the macro name.
    name: &'static str,
    count: u16,
    what: &'static str,
    /// An additional condition.
    condition: &'static str,
}

/// Data common to all files.
pub(super) struct Head {
    lower: String,
    upper: String,
    stem: String,
    made_by: String,
    product: String,
    vendor: String,
    node_id: Option<u8>,
    length: usize,
    /// The numbers of objects for the stack's configuration.
    counts: [Count; 4],
}

/// The table and its values.
#[derive(Template)]
#[template(path = "canopen-stack/od.c", escape = "none")]
pub(super) struct Source<'a> {
    head: &'a Head,
    layout: &'a Layout,
    parameters: &'a Parameters,
    rows: &'a [Row],
    blocks: bool,
    bytes: bool,
}

/// The declarations.
#[derive(Template)]
#[template(path = "canopen-stack/od.h", escape = "none")]
pub(super) struct Header<'a> {
    head: &'a Head,
    layout: &'a Layout,
}

/// The node specification.
#[derive(Template)]
#[template(path = "canopen-stack/spec.c", escape = "none")]
pub(super) struct Specification<'a> {
    head: &'a Head,
    node_id: u8,
    baud_rate: u32,
    timers: u16,
    emcy: bool,
}

impl Head {
    pub(super) fn new(
        dictionary: &Dictionary<'_>,
        rows: &[Row],
        options: &Options,
        prefix: &str,
        stem: &str,
    ) -> Self {
        let info = dictionary.device.device_info.as_ref();
        let highest = |kind: PdoKind| {
            let numbers =
                dictionary.device.pdos().filter(|pdo| pdo.kind == kind && pdo.communication.is_some());
            numbers.map(|pdo| pdo.number).max().unwrap_or(1)
        };
        let up_to = |first: u16, last: u16| {
            let indexes = dictionary.objects.iter().map(|object| object.index);
            indexes
                .filter(|index| (first..=last).contains(index))
                .map(|index| index - first + 1)
                .max()
                .unwrap_or(1)
        };
        Self {
            lower: prefix.to_owned(),
            upper: prefix.to_ascii_uppercase(),
            stem: stem.to_owned(),
            made_by: options.made_by(),
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            node_id: dictionary.node_id,
            length: rows.len(),
            counts: [
                ("SSDO", up_to(0x1200, 0x127F), "SDO servers", ""),
                ("CSDO", up_to(0x1280, 0x12FF), "SDO clients", " && USE_CSDO"),
                ("RPDO", highest(PdoKind::Rpdo), "RPDOs", ""),
                ("TPDO", highest(PdoKind::Tpdo), "TPDOs", ""),
            ]
            .map(|(name, count, what, condition)| Count { name, count, what, condition }),
        }
    }
}

pub(super) fn has(planned: &[Vec<Planned>], type_: Type) -> bool {
    planned.iter().flatten().any(|row| row.type_ == type_)
}

impl<'a> Source<'a> {
    pub(super) fn new(
        head: &'a Head,
        planned: &[Vec<Planned>],
        layout: &'a Layout,
        parameters: &'a Parameters,
        rows: &'a [Row],
    ) -> Self {
        let (blocks, bytes) = (has(planned, Type::Block), has(planned, Type::Bytes));
        Self { head, layout, parameters, rows, blocks, bytes }
    }
}

impl<'a> Header<'a> {
    pub(super) fn new(head: &'a Head, layout: &'a Layout) -> Self {
        Self { head, layout }
    }
}

impl<'a> Specification<'a> {
    pub(super) fn new(head: &'a Head, dictionary: &Dictionary<'_>) -> Self {
        let device = dictionary.device;
        let chosen = device.commissioning.as_ref().and_then(|commissioning| commissioning.baud_rate);
        let fastest = || device.device_info.as_ref()?.baud_rates.supported().max();
        let consumers = dictionary.objects.iter().find(|object| object.index == 0x1016);
        let consumers = consumers.map_or(0, |object| object.entries.len().saturating_sub(1));
        let pdos = device.pdo_count(PdoKind::Tpdo);
        // heartbeat, SYNC and LSS; a timer per consumer; an event timer and an inhibit time per TPDO
        let timers = u16::try_from(3 + consumers + 2 * pdos).unwrap_or(u16::MAX);
        Self {
            head,
            node_id: head.node_id.unwrap_or(1),
            baud_rate: u32::from(chosen.or_else(fastest).unwrap_or(125)) * 1000,
            timers,
            emcy: device.object(0x1014).is_some(),
        }
    }
}

/// The rows, by key.
pub(super) fn rows(dictionary: &Dictionary<'_>, planned: &[Vec<Planned>], layout: &Layout) -> Vec<Row> {
    let mut rows = Vec::new();
    for (number, object) in dictionary.objects.iter().enumerate() {
        for (at, entry) in object.entries.iter().enumerate() {
            let planned = &planned[number][at];
            let resolved = &entry.resolved;
            let stack = object.object.main.stack.as_ref().or(entry.entry.stack.as_ref());
            let detects_change = stack.is_some_and(|stack| stack.detects_change == Some(true));
            let mappable = resolved.tpdo || resolved.rpdo;
            let flags = Flags {
                direct: matches!(planned.cell, Cell::Direct(_)),
                node_id: planned.node_id,
                triggers: detects_change && resolved.tpdo,
                mappable,
                read: resolved.access.is_readable(),
                write: resolved.access.is_writable(),
            };
            rows.push(Row {
                index: object.index,
                sub: entry.sub,
                flags: flags.name(),
                type_: planned.type_,
                data: layout.data[number][at].clone(),
                name: entry.entry.name.to_string(),
            });
        }
    }
    if dictionary.objects.iter().all(|object| object.index != 0x1200) {
        rows.extend(default_sdo_server());
        rows.sort_by_key(|row| (row.index, row.sub));
    }
    rows
}

/// 1200h with the COB-IDs of CiA 301.
fn default_sdo_server() -> impl Iterator<Item = Row> {
    let row = |sub: u8, type_: &'static str, data: &str, name: &str| {
        let (flags, type_) = (if sub == 0 { "CO_OBJ_D___R_" } else { "CO_OBJ_DN__R_" }, Type::Stack(type_));
        let name = format!("{name} (not in the description)");
        Row { index: 0x1200, sub, flags: flags.to_owned(), type_, data: data.to_owned(), name }
    };
    [
        row(0, "CO_TUNSIGNED8", "2u", "Highest sub-index"),
        row(1, "CO_TUNSIGNED32", "1536u", "COB-ID client to server"),
        row(2, "CO_TUNSIGNED32", "1408u", "COB-ID server to client"),
    ]
    .into_iter()
}

/// The flags of a row.
#[derive(Clone, Copy)]
struct Flags {
    direct: bool,
    node_id: bool,
    triggers: bool,
    mappable: bool,
    read: bool,
    write: bool,
}

impl Flags {
    /// The macro of the stack, or several if none covers all of them.
    fn name(self) -> String {
        let lone = |letter: char, set: bool| if set { letter } else { '_' };
        let mut missing = Vec::new();
        let mut named = self;
        if named.triggers && (named.direct || named.node_id || !named.mappable) {
            missing.push("CO_OBJ___A___");
            named.triggers = false;
        }
        if named.mappable && named.direct {
            missing.push("CO_OBJ____P__");
            named.mappable = false;
        }
        let name: String = [
            lone('D', named.direct),
            lone('N', named.node_id),
            lone('A', named.triggers),
            lone('P', named.mappable),
            lone('R', named.read),
            lone('W', named.write),
        ]
        .into_iter()
        .collect();
        let mut names = vec![format!("CO_OBJ_{name}")];
        names.extend(missing.into_iter().map(str::to_owned));
        names.join(" | ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_have_the_names_of_the_stack() {
        let none = Flags {
            direct: false,
            node_id: false,
            triggers: false,
            mappable: false,
            read: true,
            write: false,
        };
        assert_eq!(none.name(), "CO_OBJ_____R_");
        assert_eq!(Flags { write: true, mappable: true, triggers: true, ..none }.name(), "CO_OBJ___APRW");
        assert_eq!(Flags { direct: true, node_id: true, ..none }.name(), "CO_OBJ_DN__R_");
        assert_eq!(Flags { direct: true, mappable: true, ..none }.name(), "CO_OBJ_D___R_ | CO_OBJ____P__");
        let all = Flags { node_id: true, mappable: true, triggers: true, ..none };
        assert_eq!(all.name(), "CO_OBJ__N_PR_ | CO_OBJ___A___");
    }
}
