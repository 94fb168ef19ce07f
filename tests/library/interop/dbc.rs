//! cantools and canmatrix decode frames to the values that packed them, for a sample of the fixtures and, with
//! `OBJDICT_CORPUS_DIR`, every description of a corpus.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::document::dbc::{self, BusNode, Dbc, DbcOptions};
use objdict::format::{self, json};
use objdict::model::{DataType, Device, Entry, MappedObject, Object, ObjectType, Part, PdoKind, Value};
use objdict::network::DcfgenMode;
use objdict::source::SourceOptions;
use serde_json::json;

use super::{environment, text_of};
use crate::network::open;
use crate::support;
use crate::support::skips::{sample, skip};

/// The files for the script, and what it is to do with them.
struct Cases {
    folder: PathBuf,
    cases: Vec<serde_json::Value>,
}

impl Cases {
    fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::remove_dir_all(&folder).ok();
        fs::create_dir_all(&folder).unwrap();
        Self { folder, cases: Vec::new() }
    }

    /// The DBC of devices on one bus.
    fn add(&mut self, devices: &[(Device, u8)], options: DbcOptions) {
        self.add_with(devices, options, None);
    }

    /// The DBC of a network.
    fn add_network(&mut self, name: &str, options: DbcOptions) {
        let nodes = open(name).build(DcfgenMode::Corrected).unwrap().configured_nodes().unwrap();
        let counterpart = nodes.iter().position(|node| node.is_made);
        let devices: Vec<_> = nodes.into_iter().map(|node| (node.device, node.node_id)).collect();
        self.add_with(&devices, options, counterpart);
    }

    /// The DBC of devices on one bus, and the one that has the other side of all PDOs.
    fn add_with(&mut self, devices: &[(Device, u8)], options: DbcOptions, counterpart: Option<usize>) {
        let node = |(position, (device, node_id))| {
            let is_counterpart = counterpart == Some(position);
            let (device, node_id): (&Device, &u8) = (device, node_id);
            BusNode { device, node_id: *node_id, name: None, is_counterpart }
        };
        let bus: Vec<_> =
            devices.iter().map(|(device, node_id)| (device, node_id)).enumerate().map(node).collect();
        let number = self.cases.len();
        let written = dbc::write(&bus, options);
        let nodes: Vec<serde_json::Value> = devices
            .iter()
            .enumerate()
            .map(|(position, (device, node_id))| {
                let file = format!("{number}-{position}.json");
                fs::write(self.folder.join(&file), json::write_device(device)).unwrap();
                let is_counterpart = counterpart == Some(position);
                let omitted = omitted(&written, position);
                json!({ "json": file, "node_id": node_id, "omitted": omitted, "counterpart": is_counterpart })
            })
            .collect();
        let file = format!("{number}.dbc");
        fs::write(self.folder.join(&file), &written.bytes).unwrap();
        self.cases.push(json!({ "dbc": file, "bits": options.bits, "sdo": options.sdo, "nodes": nodes }));
    }

    fn check(&self, programs: &Path) {
        fs::write(self.folder.join("cases.json"), serde_json::to_string(&self.cases).unwrap()).unwrap();
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/dbc.py");
        let output = Command::new(programs.join("python")).arg(script).arg(&self.folder).output().unwrap();
        assert!(output.status.success(), "{}", text_of(&output));
    }
}

/// The entries that a DBC says it does not have.
fn omitted(dbc: &Dbc, node: usize) -> Vec<(u16, u8)> {
    let omissions = dbc.omissions.iter().filter(|omission| omission.node == node);
    let places = omissions.filter_map(|omission| match omission.place.part {
        Part::Entry(index, sub) => Some((index, sub)),
        _ => None,
    });
    places.collect()
}

/// The device of a description and its node-ID; `None` if it is not one of CANopen.
fn read(path: &Path) -> Option<(Device, u8)> {
    let device = format::open(path, &SourceOptions::default()).ok()?.device().clone();
    let node_id = device.node_id().unwrap_or(5);
    Some((device, node_id))
}

/// The device with TPDOs for all entries that a frame can hold, behind each other from bit 3 on.
fn with_all_mapped(device: &Device) -> Device {
    let mut device = device.clone();
    device.objects.retain(|index, _| !(0x1400..0x1C00).contains(index));
    let mut mapped = Vec::new();
    for (&index, object) in device.objects.range(0x1000..) {
        for (sub, entry) in object.entries() {
            let bits = entry.data_type.and_then(DataType::bit_length);
            mapped.extend(bits.map(|bits| MappedObject { index, sub, bits }));
        }
    }
    let record = |values: &[u32]| {
        let entry = |&value: &u32| Entry { default: Some(Value::Unsigned(value.into())), ..Entry::default() };
        let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
        Object { main, subs: (0..).zip(values.iter().map(entry)).collect(), ..Object::default() }
    };
    let gap = MappedObject { index: 5, sub: 0, bits: 3 };
    for (number, object) in (0..PdoKind::MAX).zip(mapped) {
        let communication = 0x1800 + number;
        device.objects.insert(communication, record(&[2, 0x2001_0000 + u32::from(number), 255]));
        let slots = if object.bits > 61 { vec![object] } else { vec![gap, object] };
        let numbers = slots.iter().map(|slot| slot.to_number());
        let values: Vec<u32> = [slots.len() as u32].into_iter().chain(numbers).collect();
        device.objects.insert(communication + 0x200, record(&values));
    }
    device
}

/// All networks, and a sample of the devices: `dbc` and the tests of `objdict-document` compare the text of a DBC, and the fuzzer
/// that signals are inside their messages.
#[test]
fn frames_decode_to_the_values_that_packed_them() {
    let Some(programs) = environment() else { return };
    let mut cases = Cases::new("interop-dbc");
    let xml = [support::files("xdd", &["xdd"]), support::files("xdc", &["xdc"])].concat();
    let devices = sample([support::good_devices(), xml].concat());
    let devices: Vec<_> = devices.iter().map(|path| read(path).unwrap()).collect();
    for device in &devices {
        for (sdo, bits) in [(false, false), (false, true), (true, false)] {
            cases.add(std::slice::from_ref(device), DbcOptions { sdo, bits });
        }
    }
    for (device, node_id) in &devices {
        cases.add(&[(with_all_mapped(device), *node_id)], DbcOptions::default());
    }
    let network: Vec<_> = support::files("dcf", &["dcf"]).iter().map(|path| read(path).unwrap()).collect();
    cases.add(&network, DbcOptions::default());
    for name in ["worked.yml", "cell.yml", "chapter4.toml", "line.toml"] {
        for sdo in [false, true] {
            cases.add_network(name, DbcOptions { sdo, bits: false });
        }
    }
    for path in sample(support::files("torture", &["eds"])) {
        cases.add(&[read(&path).unwrap()], DbcOptions::default());
    }
    cases.check(programs);
}

#[test]
fn frames_of_a_corpus_decode_to_the_values_that_packed_them() {
    let Some(corpus) = std::env::var_os("OBJDICT_CORPUS_DIR") else {
        return skip("`OBJDICT_CORPUS_DIR` names no folder");
    };
    let Some(programs) = environment() else { return };
    let mut cases = Cases::new("interop-dbc-corpus");
    let mut paths = support::files_below(Path::new(&corpus), &["eds", "dcf", "xdd", "xdc", "xpd"]);
    paths.sort();
    for device in paths.iter().filter_map(|path| read(path)) {
        cases.add(&[device], DbcOptions::default());
    }
    assert!(!cases.cases.is_empty(), "no description below `{}`", corpus.display());
    cases.check(programs);
}
