//! `bus.yml` for dcfgen and ros2_canopen.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt::Write as _;
use std::path::Path;

use super::{Build, BuildError, BuiltFile, is_ini};
use objdict_format as format;
use objdict_format::{Dialect, Format, Syntax, WriteOptions};
use objdict_model::json::quoted;
use objdict_model::model::{Device, DeviceKind, PdoKind};
use objdict_network::{
    DownloadRequest, Heartbeat, Manager, Node, PdoRequest, RequestedCobId, RequestedValue, Said,
};
use objdict_node::configure::Setting;

impl Build<'_> {
    /// The network as a file for dcfgen, with the descriptions of the nodes: EDS and DCF files are copied,
    /// other formats are converted.
    ///
    /// # Errors
    /// If a description cannot be written.
    pub fn bus_yml(&self) -> Result<Vec<BuiltFile>, BuildError> {
        let mut files: Vec<BuiltFile> = Vec::new();
        let mut copied = BTreeMap::new();
        let mut text = String::new();
        if !self.network.run_time_folder.is_empty() {
            let _ = writeln!(text, "options:\n  dcf_path: {}\n", quoted(&self.network.run_time_folder));
        }
        if let Some(manager) = &self.network.manager {
            self.master(manager, &mut text);
        }
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            let (name, is_new) = self.copied(slave.node, &mut copied);
            let _ = writeln!(text, "\n{}:\n  dcf: {}", quoted(&node.name.value), quoted(&name));
            number(&mut text, "node_id", Some(slave.node_id));
            written(node, &mut text);
            if is_new {
                let bytes = match (self.foreign(slave.node), self.file.descriptions.get(&node.file.value)) {
                    (None, Some(description)) => description.source().to_bytes(),
                    (device, _) => as_ini(node, device.unwrap_or(&node.device), &name)?,
                };
                files.push(BuiltFile { name, bytes });
            }
        }
        files.insert(0, BuiltFile { name: "bus.yml".to_owned(), bytes: text.into_bytes() });
        Ok(files)
    }

    /// The device of a node whose description dcfgen cannot read because it is neither an EDS nor a DCF.
    fn foreign(&self, node: usize) -> Option<&Device> {
        let node = &self.network.nodes[node];
        match self.file.descriptions.get(&node.file.value) {
            Some(description) if is_ini(description) => None,
            Some(description) => Some(description.device()),
            None => Some(&node.device),
        }
    }

    /// The file name for a node's description, and whether it is new. Files with the same name in different folders are
    /// prefixed with the name of the node.
    fn copied<'a>(&'a self, node: usize, copied: &mut BTreeMap<String, &'a str>) -> (String, bool) {
        let file = self.network.nodes[node].file.value.as_str();
        let own = file.rsplit(['/', '\\']).next().unwrap_or_default();
        let name = match self.foreign(node) {
            None => own.to_owned(),
            Some(device) => {
                let ending = if device.kind == DeviceKind::Node { "dcf" } else { "eds" };
                Path::new(own).with_extension(ending).to_string_lossy().into_owned()
            }
        };
        for name in [name.clone(), format!("{}-{name}", self.stems[node])] {
            match copied.entry(name.to_lowercase()) {
                Entry::Vacant(entry) => {
                    entry.insert(file);
                    return (name, true);
                }
                Entry::Occupied(entry) if *entry.get() == file => return (name, false),
                Entry::Occupied(_) => {}
            }
        }
        (name, false)
    }

    fn master(&self, manager: &Manager, text: &mut String) {
        let present = |number: u32| Some(number).filter(|number| *number != 0);
        text.push_str("master:\n");
        number(text, "node_id", manager.node_id.map(|node_id| node_id.value));
        number(text, "baudrate", self.network.bit_rate.map(|rate| rate.value));
        for (key, value) in ["vendor_id", "product_code", "revision_number"].into_iter().zip(manager.identity)
        {
            number(text, key, present(value));
        }
        number(text, "serial_number", present(manager.serial_number));
        number(text, "sync_period", present(manager.sync_period.value));
        number(text, "sync_window", present(manager.sync_window.value));
        number(text, "sync_overflow", present(manager.sync_overflow.value.into()));
        number(text, "time_cob_id", value(manager.time_cob_id));
        number(text, "emcy_inhibit_time", present(manager.emcy_inhibit_time.into()));
        number(text, "nmt_inhibit_time", present(manager.nmt_inhibit_time.into()));
        heartbeat(text, &manager.heartbeat);
        errors(text, manager.error_behavior.iter().map(|(sub, value)| (*sub, *value)));
        let startup = manager.startup;
        for (key, is_set, default) in [
            ("start", startup.start, true),
            ("start_nodes", startup.start_nodes, true),
            ("start_all_nodes", startup.start_all_nodes, false),
            ("reset_all_nodes", startup.reset_all_nodes, false),
            ("stop_all_nodes", startup.stop_all_nodes, false),
        ] {
            flag(text, key, is_set, default);
        }
        number(text, "boot_time", present(manager.boot_time.value));
    }
}

/// The description of a node as an EDS, or as a DCF if it describes a node.
fn as_ini(node: &Node, device: &Device, file_name: &str) -> Result<Vec<u8>, BuildError> {
    let mut device = device.clone();
    device.file_info.get_or_insert_default().file_name = Some(file_name.to_owned());
    let options = WriteOptions { dialect: Dialect::Lely, embed: true, ..WriteOptions::default() };
    let written = format::write(&device, Format::of(Syntax::Ini, device.kind), &options);
    let failed = |error| BuildError::Edit { node: node.name.value.clone(), error };
    Ok(written.map_err(failed)?.bytes)
}

fn value<T>(said: Option<Said<T>>) -> Option<T> {
    said.map(|said| said.value)
}

fn number<T: std::fmt::Display>(text: &mut String, key: &str, value: Option<T>) {
    if let Some(value) = value {
        // writing to a string does not fail
        let _ = writeln!(text, "  {key}: {value}");
    }
}

fn flag(text: &mut String, key: &str, is_set: bool, default: bool) {
    number(text, key, (is_set != default).then_some(is_set));
}

fn heartbeat(text: &mut String, heartbeat: &Heartbeat) {
    number(text, "heartbeat_producer", value(heartbeat.producer));
    let is_other = (heartbeat.factor - Heartbeat::DEFAULT_FACTOR).abs() > f64::EPSILON;
    number(text, "heartbeat_multiplier", is_other.then(|| format!("{:?}", heartbeat.factor)));
    number(text, "heartbeat_consumer", value(heartbeat.consumer));
}

fn errors(text: &mut String, values: impl Iterator<Item = (u8, u8)>) {
    let values: Vec<String> = values.map(|(sub, value)| format!("{sub}: {value}")).collect();
    number(text, "error_behavior", (!values.is_empty()).then(|| format!("{{{}}}", values.join(", "))));
}

/// The configuration of a node.
fn written(node: &Node, text: &mut String) {
    number(text, "dcf_path", node.run_time_folder.as_ref().map(|folder| quoted(folder)));
    // dcfgen does not interpret FFFFFFFFh as an unset number
    let stated = |number: Option<Said<u32>>| value(number).filter(|number| *number != u32::MAX);
    number(text, "revision_number", stated(node.revision_number));
    number(text, "serial_number", stated(node.serial_number));
    number(text, "time_cob_id", value(node.time_cob_id));
    heartbeat(text, &node.heartbeat);
    number(text, "guard_time", value(node.guarding.0));
    number(text, "life_time_factor", value(node.guarding.1));
    errors(text, node.error_behavior.iter().map(|(sub, value)| (*sub, value.value)));
    let boot = &node.boot;
    number(text, "retry_factor", Some(boot.retry_factor.value).filter(|factor| *factor != 3));
    flag(text, "boot", boot.boot, true);
    flag(text, "mandatory", boot.mandatory, false);
    flag(text, "reset_communication", boot.reset_communication, true);
    number(text, "software_file", boot.software_file.as_ref().map(|file| quoted(file)));
    number(text, "software_version", Some(boot.software_version.value).filter(|version| *version != 0));
    number(text, "restore_configuration", Some(boot.restore_configuration.value).filter(|sub| *sub != 0));
    for kind in PdoKind::ALL {
        let pdos: Vec<&PdoRequest> = node.pdos.iter().filter(|request| request.pdo.kind == kind).collect();
        if !pdos.is_empty() {
            let _ = writeln!(text, "  {}:", kind.name().to_ascii_lowercase());
            pdos.into_iter().for_each(|request| pdo(text, request));
        }
    }
    let settings = node.settings.iter().filter_map(|setting| download_of(&setting.value));
    let downloads: Vec<String> =
        settings.chain(node.downloads.iter().map(|request| download(&request.value))).collect();
    if !downloads.is_empty() {
        let _ = writeln!(text, "  sdo:\n    - {}", downloads.join("\n    - "));
    }
}

fn pdo(text: &mut String, request: &PdoRequest) {
    let mut keys = Vec::new();
    if !request.enabled {
        keys.push("enabled: false".to_owned());
    }
    keys.extend(request.cob_id.map(|cob_id| match cob_id.value {
        RequestedCobId::Auto => "cob_id: auto".to_owned(),
        RequestedCobId::Number(number) => format!("cob_id: 0x{number:X}"),
    }));
    let narrow = |key: &str, said: Option<Said<u8>>| said.map(|said| format!("{key}: {}", said.value));
    let wide = |key: &str, said: Option<Said<u16>>| said.map(|said| format!("{key}: {}", said.value));
    keys.extend(narrow("transmission", request.transmission));
    keys.extend(wide("inhibit_time", request.inhibit_time));
    keys.extend(wide("event_timer", request.event_timer));
    keys.extend(wide("event_deadline", request.deadline));
    keys.extend(narrow("sync_start", request.sync_start));
    if let Some(mapping) = &request.mapping {
        let entries = mapping.iter().map(|entry| {
            let (index, sub) = (entry.value.index, entry.value.sub.unwrap_or(0));
            format!("{{index: 0x{index:04X}, sub_index: {sub}}}")
        });
        keys.push(format!("mapping: [{}]", entries.collect::<Vec<_>>().join(", ")));
    }
    let _ = writeln!(text, "    {}: {{{}}}", request.pdo.number, keys.join(", "));
}

fn download(request: &DownloadRequest) -> String {
    let value = match &request.value {
        RequestedValue::Integer(number) => number.to_string(),
        RequestedValue::Real(number) => format!("{number:?}"),
        RequestedValue::Text(text) => quoted(text),
    };
    format!("{{index: 0x{:04X}, sub_index: {}, value: {value}}}", request.index, request.sub)
}

/// A setting by index with a number; dcfgen has no others.
fn download_of(setting: &Setting) -> Option<String> {
    let Setting::Value { at: objdict_node::ObjectName::Address(at), text } = setting else { return None };
    let (index, sub) = (at.index, at.sub.unwrap_or(0));
    Some(format!("{{index: 0x{index:04X}, sub_index: {sub}, value: {text}}}"))
}
