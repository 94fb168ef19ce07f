//! The dictionary as tables.

use std::io::{self, Write};

use super::ShownDevice;
use crate::table::{TextTable, fit};
use objdict_document::describe::{Decoder, ValueReader};
use objdict_model::diagnostic::plural;
use objdict_model::model::{
    Device, DeviceKind, Entry, ExplicitDownload, Field, Moment, Object, ObjectType, PdoKind, PdoMapping,
};

/// The most characters that a cell of the large table shows; the page of one entry shows all.
const CELL: usize = 44;

/// The most characters of a text on the page of one entry.
const LINE: usize = 4000;

/// The columns that say which entry a row is.
const WHICH: [&str; 4] = ["Index", "Sub", "Name", "Object"];

/// What a cell says about an entry.
type CellOf = fn(ValueReader, &Entry) -> String;

/// The columns about an entry: the heading, and its cells.
const COLUMNS: [(&str, CellOf); 7] = [
    ("Type", |_, entry| entry.implied_type().map(|data_type| data_type.to_string()).unwrap_or_default()),
    ("Access", |_, entry| entry.implied_access().map(|access| access.to_string()).unwrap_or_default()),
    ("PDO", |_, entry| if entry.is_mappable() { pdo_mapping(entry).to_owned() } else { String::new() }),
    ("Default", |reader, entry| reader.field(entry, &Field::DefaultValue, entry.default.as_ref())),
    ("Value", |reader, entry| reader.field(entry, &Field::ParameterValue, entry.configured_value())),
    ("Low", |reader, entry| reader.field(entry, &Field::LowLimit, entry.low_limit.as_ref())),
    ("High", |reader, entry| reader.field(entry, &Field::HighLimit, entry.high_limit.as_ref())),
];

/// The table of entries.
type ShownTable = TextTable<{ WHICH.len() + COLUMNS.len() }>;

fn shown_table() -> ShownTable {
    let mut headings = WHICH.into_iter().chain(COLUMNS.map(|(heading, _)| heading));
    TextTable::new(std::array::from_fn(|_| headings.next().unwrap_or_default()), CELL)
}

/// All objects.
pub(super) fn device(view: &ShownDevice<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}\n", summary(view))?;
    let mut table = shown_table();
    for (&index, object) in &view.device.objects {
        object_rows(view, index, object, &mut table);
    }
    table.write(out)?;
    ordered(view, out)
}

/// The downloads that are made as stated, in their order.
fn ordered(view: &ShownDevice<'_>, out: &mut dyn Write) -> io::Result<()> {
    if view.device.downloads.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nOrdered downloads\n")?;
    let mut table = TextTable::new(["Index", "Sub", "Name", "Value", "When"], CELL);
    for ExplicitDownload { when, index, sub, value } in &view.device.downloads {
        let entry = view.device.entry(*index, *sub);
        let when = match when {
            Moment::Before => "before the values",
            Moment::After => "after the values",
        };
        table.row([
            format!("0x{index:04X}"),
            format!("{sub:X}"),
            entry.as_ref().map(|entry| entry.name.to_string()).unwrap_or_default(),
            view.reader(*index).short(Some(value), entry.and_then(|entry| entry.data_type)),
            when.to_owned(),
        ]);
    }
    table.write(out)
}

/// One object: its table, and what its values mean.
pub(super) fn object(
    view: &ShownDevice<'_>,
    index: u16,
    object: &Object,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut table = shown_table();
    object_rows(view, index, object, &mut table);
    table.write(out)?;
    let mut meanings = TextTable::new(["Sub", "Meaning"], LINE);
    let mut any = false;
    let decoder = Decoder::english(view.device, view.node_id);
    for (sub, entry) in object.entries() {
        if let Some(meaning) = entry.value().and_then(|value| {
            let value = view.reader(index).resolve(value, entry.data_type);
            decoder.of(index, sub, &value)
        }) {
            meanings.row([format!("{sub:X}"), meaning]);
            any = true;
        }
    }
    if any {
        writeln!(out)?;
        meanings.write(out)?;
    }
    if !object.links.is_empty() {
        let links: Vec<String> = object.links.iter().map(|index| format!("0x{index:04X}")).collect();
        writeln!(out, "\nlinks: {}", links.join(", "))?;
    }
    Ok(())
}

/// One entry, field by field.
pub(super) fn entry(
    view: &ShownDevice<'_>,
    (index, sub): (u16, u8),
    object: &Object,
    entry: &Entry,
    out: &mut dyn Write,
) -> io::Result<()> {
    let reader = view.reader(index);
    writeln!(out, "0x{index:04X}sub{sub:X}  {}\n", fit(&entry.name, LINE))?;
    let mut lines = TextTable::new(["", ""], LINE);
    let mut line = |name: &str, text: String| lines.row([format!("  {name}"), text]);
    if object.object_type().has_subs() {
        line("object", format!("{} ({})", object.name(), object.object_type()));
    }
    line("object type", entry.object_type.unwrap_or(ObjectType::Var).to_string());
    if let Some(data_type) = entry.implied_type() {
        let bits = data_type.bit_length().map(|bits| format!(", {bits} bits")).unwrap_or_default();
        line("data type", format!("{data_type}{bits}"));
    }
    if let Some(access) = entry.implied_access() {
        line("access", access.to_string());
    }
    line("PDO mapping", pdo_mapping(entry).to_owned());
    for (name, value) in [
        ("default", &entry.default),
        ("value", &entry.configured_value().cloned()),
        ("low limit", &entry.low_limit),
        ("high limit", &entry.high_limit),
    ] {
        if let Some(value) = value {
            line(name, reader.long(value, entry.data_type));
        }
    }
    if let Some(value) = entry.value() {
        if let Some(bytes) = reader.bytes(value, entry.data_type, " ") {
            line("bytes", bytes);
        }
        let resolved = reader.resolve(value, entry.data_type);
        if let Some(meaning) = Decoder::english(view.device, view.node_id).of(index, sub, &resolved) {
            line("meaning", meaning);
        }
    }
    for (name, text) in remarks(entry) {
        line(name, text);
    }
    lines.write(out)
}

/// What only some entries have.
fn remarks(entry: &Entry) -> Vec<(&'static str, String)> {
    let mut remarks = Vec::new();
    if entry.flags().refuses_write() {
        remarks.push(("flags", "not written when a configuration is downloaded".to_owned()));
    }
    if entry.flags().refuses_read() {
        remarks.push(("flags", "not read when a device is scanned".to_owned()));
    }
    if let Some(configured) = &entry.configured {
        let texts = [
            ("denotation", &configured.denotation),
            ("upload file", &configured.upload_file),
            ("download file", &configured.download_file),
            ("reference", &configured.reference_designator),
        ];
        remarks
            .extend(texts.into_iter().filter_map(|(name, text)| Some((name, text.as_deref()?.to_owned()))));
    }
    if let Some(safety) = &entry.safety {
        if safety.srdo_mapping == Some(true) {
            remarks.push(("SRDO mapping", "yes".to_owned()));
        }
        if let Some(inverted) = safety.inverted_srad {
            remarks.push(("inverted", format!("0x{:04X}sub{:X}", inverted >> 16, inverted & 0xFF)));
        }
    }
    let invalid = |invalid: &objdict_model::model::InvalidValue| {
        ("unreadable", format!("{}={}", invalid.field, invalid.text))
    };
    remarks.extend(entry.invalid_values.iter().map(invalid));
    remarks.extend(entry.extra.iter().map(|(key, value)| ("extra", format!("{key}={value}"))));
    remarks
}

fn object_rows(view: &ShownDevice<'_>, index: u16, object: &Object, table: &mut ShownTable) {
    let reader = view.reader(index);
    let shown_index = format!("0x{index:04X}");
    let object_type = object.object_type();
    let is_single = !object_type.has_subs() && object.subs.is_empty() && object.compact.is_none();
    if is_single {
        if !view.shows(&object.main) {
            return;
        }
        let which = [shown_index, String::new(), object.name().to_owned(), object_type.to_string()];
        add_row(table, which, Some((reader, &object.main)));
        return;
    }
    if view.changed && !object.entries().any(|(_, entry)| view.shows(&entry)) {
        return;
    }
    let (name, object_type) = match object.orphan {
        true => ("(not described)", String::new()),
        false => (object.name(), object_type.to_string()),
    };
    add_row(table, [shown_index, String::new(), name.to_owned(), object_type], None);
    for (sub, entry) in object.entries().filter(|(_, entry)| view.shows(entry)) {
        let object_type = entry.object_type.filter(|&of| of != ObjectType::Var);
        let object_type = object_type.map(|of| of.to_string()).unwrap_or_default();
        let which = [String::new(), format!("{sub:X}"), entry.name.to_string(), object_type];
        add_row(table, which, Some((reader, &entry)));
    }
}

/// Adds a row; that of an object which has entries says nothing else.
fn add_row(table: &mut ShownTable, which: [String; 4], entry: Option<(ValueReader, &Entry)>) {
    let about =
        |(_, cell): (&str, CellOf)| entry.map(|(reader, entry)| cell(reader, entry)).unwrap_or_default();
    let mut cells = which.into_iter().chain(COLUMNS.map(about));
    table.row(std::array::from_fn(|_| cells.next().unwrap_or_default()));
}

fn pdo_mapping(entry: &Entry) -> &'static str {
    match entry.pdo_mapping.unwrap_or_default() {
        PdoMapping::Optional => "yes",
        mapping => mapping.name(),
    }
}

/// Two lines: what the device is, and how much there is of it.
fn summary(view: &ShownDevice<'_>) -> String {
    let device = view.device;
    let info = device.device_info.as_ref();
    let product = info.and_then(|info| info.product_name.as_deref()).filter(|name| !name.is_empty());
    let product = product.unwrap_or("device without a name");
    let vendor = info.and_then(|info| info.vendor_name.as_deref()).filter(|name| !name.is_empty());
    let vendor = vendor.map(|vendor| format!(" ({vendor})")).unwrap_or_default();
    let mut facts = vec![view.format.to_owned()];
    facts.extend(device.is_ethercat().then(|| "from EtherCAT".to_owned()));
    if device.kind == DeviceKind::Node {
        facts.push(node(device));
    } else if let Some(node_id) = view.node_id {
        facts.push(format!("as node {node_id}"));
    }
    facts.extend(Decoder::english(device, view.node_id).device_profile());
    let entries: usize = device.objects.values().map(|object| object.entries().count()).sum();
    facts.push(plural(device.pdo_count(PdoKind::Rpdo), "RPDO"));
    facts.push(plural(device.pdo_count(PdoKind::Tpdo), "TPDO"));
    facts.push(plural(device.objects.len(), "object"));
    facts.push(if entries == 1 { "1 entry".to_owned() } else { format!("{entries} entries") });
    if let Some(modules) = device.modules.as_ref().filter(|modules| !modules.supported.is_empty()) {
        facts.push(format!("{} to plug in", plural(modules.supported.len(), "module")));
    }
    if !device.downloads.is_empty() {
        facts.push(plural(device.downloads.len(), "ordered download"));
    }
    fit(&format!("{product}{vendor}"), LINE) + "\n" + &fit(&facts.join(", "), LINE)
}

fn node(device: &Device) -> String {
    let node = device.commissioning.as_ref();
    let id = match node.and_then(|node| node.node_id) {
        Some(id) => format!("node {id}"),
        None => "a node".to_owned(),
    };
    let name = node.and_then(|node| node.node_name.as_deref()).filter(|name| !name.is_empty());
    let name = name.map(|name| format!(" \"{name}\"")).unwrap_or_default();
    let rate =
        node.and_then(|node| node.baud_rate).map(|rate| format!(", {rate} kbit/s")).unwrap_or_default();
    format!("{id}{name}{rate}")
}
