//! Constants of identity and services: exactly those that follow from the objects' values, compared bit by
//! bit.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

use objdict::generate::{CTable, Generated, Options, Target, generate};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

use crate::batch::{Part, TABLES};
use crate::compile::{c_compiler, cc};
use crate::processors::host;
use crate::{devices, for_all};

/// The node-IDs used to call functions.
const NODES: [u8; 3] = [1, 5, 127];

/// The expected constant.
#[derive(Debug, PartialEq)]
enum Expected {
    /// For each of the nodes.
    OfNode([u32; 3]),
    Flag(bool),
    Number(u32),
    Consumers(Vec<(u8, u16)>),
}

/// The constants of a device, by name.
struct Constants<'a> {
    device: &'a Device,
    /// The entries of the table.
    entries: BTreeSet<(u16, u8)>,
    expected: BTreeMap<String, Expected>,
}

impl Constants<'_> {
    fn of(device: &Device) -> BTreeMap<String, Expected> {
        let entries = crate::oracle::facts_of(device).map(|(address, _)| address).collect();
        let mut constants = Constants { device, entries, expected: BTreeMap::new() };
        constants.put("heartbeat_cob_id", Expected::OfNode(NODES.map(|node| 0x700 | u32::from(node))));
        for (sub, name) in (1..).zip(["vendor_id", "product_code", "revision_number", "serial_number"]) {
            constants.number(0x1018, sub, name, u32::MAX);
        }
        for (index, name, most) in [
            (0x1006, "communication_cycle_period", u32::MAX),
            (0x1007, "synchronous_window", u32::MAX),
            (0x1019, "sync_counter_overflow", 0xFF),
            (0x1015, "emcy_inhibit_time", 0xFFFF),
            (0x1017, "heartbeat_time", 0xFFFF),
        ] {
            constants.number(index, 0, name, most);
        }
        constants.cob_id(0x1005, 0, "sync", None, &[("is_produced", 30, true)]);
        constants.cob_id(0x1012, 0, "time", None, &[("is_consumed", 31, true), ("is_produced", 30, true)]);
        constants.cob_id(0x1014, 0, "emcy", None, &[("is_valid", 31, false)]);
        for (first, own, other) in [(0x1200, "server", "client"), (0x1280, "client", "server")] {
            for index in first..first + 0x80 {
                let name = |what: &str| format!("sdo_{own}{}_{what}", index - first + 1);
                let implied = |base: u32| (index == 0x1200).then_some(base);
                let valid = [("is_valid", 31, false)];
                constants.cob_id(index, 1, &name("request"), implied(0x600), &valid);
                constants.cob_id(index, 2, &name("response"), implied(0x580), &valid);
                constants.number(index, 3, &name(&format!("{other}_node_id")), 0xFF);
            }
        }
        constants.consumers();
        constants.expected
    }

    fn put(&mut self, name: &str, expected: Expected) {
        assert!(self.expected.insert(name.to_owned(), expected).is_none(), "{name}");
    }

    fn number(&mut self, index: u16, sub: u8, name: &str, most: u32) {
        let value = self.device.value(index, sub);
        let number = value.and_then(|value| u32::try_from(value.as_integer()?).ok());
        if let Some(number) = number.filter(|&number| number <= most && self.entries.contains(&(index, sub)))
        {
            self.put(name, Expected::Number(number));
        }
    }

    fn cob_id(&mut self, index: u16, sub: u8, name: &str, implied: Option<u32>, flags: &[(&str, u32, bool)]) {
        if !self.entries.contains(&(index, sub)) {
            return;
        }
        let on = |node: u8| match self.device.value(index, sub) {
            Some(value) => u32::try_from(value.integer_for(node)?).ok(),
            None => Some(implied? + u32::from(node)),
        };
        let Some(numbers) = NODES.iter().map(|&node| on(node)).collect::<Option<Vec<u32>>>() else { return };
        let [first, second, last] = numbers[..] else { unreachable!() };
        if first >> 29 != last >> 29 {
            return; // the flags depend on the node-ID
        }
        let bits = if first >> 29 & 1 == 1 { 29 } else { 11 };
        self.put(&format!("{name}_cob_id"), Expected::OfNode([first, second, last]));
        let can_ids = [first, second, last].map(|number| number & ((1 << bits) - 1));
        self.put(&format!("{name}_can_id"), Expected::OfNode(can_ids));
        self.put(&format!("{name}_is_extended"), Expected::Flag(bits == 29));
        for (flag, bit, when_set) in flags {
            self.put(&format!("{name}_{flag}"), Expected::Flag((first >> bit & 1 == 1) == *when_set));
        }
    }

    fn consumers(&mut self) {
        let mut consumers = Vec::new();
        for sub in 1..=127 {
            let value = self.device.value(0x1016, sub).and_then(|value| value.as_integer());
            let number = value.and_then(|number| u32::try_from(number).ok()).unwrap_or(0);
            let (node, time) = ((number >> 16) & 0xFF, (number & 0xFFFF) as u16);
            if (1..=127).contains(&node) && time != 0 && self.entries.contains(&(0x1016, sub)) {
                consumers.push((node as u8, time));
            }
        }
        if !consumers.is_empty() {
            self.put("heartbeat_consumers", Expected::Consumers(consumers));
        }
    }
}

/// The names that the module or the header defines, in lower case.
fn names(text: &str, marks: &[&str]) -> Vec<String> {
    let mut names: Vec<String> = text
        .lines()
        .filter_map(|line| marks.iter().find_map(|mark| line.strip_prefix(mark)))
        .map(|rest| rest.split([' ', '(', ':']).next().unwrap_or_default().to_lowercase())
        .collect();
    names.sort();
    names
}

/// A program that compares the constants; fails if the set of constants differs from the expected one.
fn in_rust(text: &str, expected: &BTreeMap<String, Expected>) -> Result<String, String> {
    let (_, rest) = text.split_once("pub mod defaults {\n").ok_or("no module")?;
    let module = rest.split_once("\n}\n").ok_or("no end")?.0;
    let found = names(module, &["    pub const fn ", "    pub const "]);
    let found: Vec<_> = found.iter().filter(|name| *name != "fn").collect();
    if found != expected.keys().collect::<Vec<_>>() {
        return Err(format!("{found:?} in Rust where {:?} were expected", expected.keys()));
    }
    let mut program = String::from("mod od { include!(\"od.rs\"); }\nuse od::defaults;\nfn main() {\n");
    for (name, value) in expected {
        let upper = name.to_uppercase();
        match value {
            Expected::OfNode(numbers) => {
                for (node, number) in NODES.iter().zip(numbers) {
                    let _ = writeln!(program, "assert_eq!(defaults::{name}({node}), {number});");
                }
            }
            Expected::Flag(flag) => {
                let _ = writeln!(program, "assert!(defaults::{upper} == {flag});");
            }
            Expected::Number(number) => {
                let _ = writeln!(program, "assert_eq!(u64::from(defaults::{upper}), {number});");
            }
            Expected::Consumers(consumers) => {
                let _ = writeln!(program, "assert_eq!(defaults::{upper}[..], {consumers:?});");
            }
        }
    }
    program.push_str("}\n");
    Ok(program)
}

fn check_c(
    folder: &Path,
    text: &str,
    compiler: &str,
    expected: &BTreeMap<String, Expected>,
) -> Result<(), String> {
    let (_, text) = text.split_once("/* Default values of identity and services").ok_or("no constants")?;
    let defined = names(text, &["#define OD_DEFAULT_"]);
    let mut wanted: Vec<String> = expected.keys().cloned().collect();
    if expected.contains_key("heartbeat_consumers") {
        wanted.push("heartbeat_consumers_count".to_owned());
    }
    wanted.sort();
    if defined != wanted {
        return Err(format!("{defined:?} in C where {wanted:?} were expected"));
    }
    let mut program =
        String::from("#undef NDEBUG\n#include <assert.h>\n#include \"od.h\"\nint main(void)\n{\n");
    for (name, value) in expected {
        let name = format!("OD_DEFAULT_{}", name.to_uppercase());
        match value {
            Expected::OfNode(numbers) => {
                for (node, number) in NODES.iter().zip(numbers) {
                    let _ = writeln!(program, "assert({name}({node}) == {number}u);");
                }
            }
            Expected::Flag(flag) => {
                let _ = writeln!(program, "assert({name} == {});", u8::from(*flag));
            }
            Expected::Number(number) => {
                let _ = writeln!(program, "assert({name} == {number}u);");
            }
            Expected::Consumers(consumers) => {
                let _ = writeln!(
                    program,
                    "{{ static const struct {{ uint8_t node_id; uint16_t time; }} got[{name}_COUNT] = {name};"
                );
                let _ = writeln!(program, "assert(sizeof got == {} * sizeof got[0]);", consumers.len());
                for (at, (node, time)) in consumers.iter().enumerate() {
                    let _ = writeln!(
                        program,
                        "assert(got[{at}].node_id == {node} && got[{at}].time == {time}u);"
                    );
                }
                program.push_str("}\n");
            }
        }
    }
    program.push_str("    return 0;\n}\n");
    std::fs::write(folder.join("defaults.c"), program).map_err(|error| error.to_string())?;
    host(cc(compiler, folder).args(["-I.", "-o", "in-c", "defaults.c"])).succeed()
}

/// A device with services that no fixture has, and names similar to those of the constants.
pub(crate) fn odd() -> Device {
    let mut device = Device::default();
    let entry = |name: &str, data_type, default| Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(Access::Rw),
        default,
        ..Entry::default()
    };
    let number = |number: u32| Some(Value::Unsigned(number.into()));
    let long = |name: &str, default| entry(name, DataType::UNSIGNED32, default);
    let record = |name: &str, subs: Vec<(u8, Entry)>| Object {
        main: Entry { name: name.into(), object_type: Some(ObjectType::Record), ..Entry::default() },
        subs: subs.into_iter().collect(),
        ..Object::default()
    };
    let mut put =
        |index: u16, main: Entry| device.objects.insert(index, Object { main, ..Object::default() });
    put(0x1005, long("default sync cob id", number(0x6000_0080)));
    put(0x1006, long("defaults", number(u32::MAX)));
    put(0x1007, long("Window", None));
    put(0x1012, long("default time can id", Some(Value::NodeId(0xA000_0000))));
    put(0x1014, long("Flags of one node", Some(Value::NodeId(0x1FFF_FFF0))));
    put(0x1015, entry("default emcy inhibit time", DataType::UNSIGNED16, Some(Value::NodeId(3))));
    put(0x1017, entry("Heartbeat", DataType::UNSIGNED16, number(0xFFFF)));
    put(0x1019, entry("Overflow", DataType::UNSIGNED8, number(240)));
    put(0x2000, entry("default heartbeat cob id", DataType::UNSIGNED8, None));
    put(0x2001, entry("default heartbeat consumers count", DataType::UNSIGNED8, None));
    let consumers = [0x0003_01F4, 0, 0x007F_FFFF, 0x0080_0001, 0x0005_0000, 0x0001_0001];
    let consumers = (1..).zip(consumers).map(|(sub, consumer)| (sub, long("Consumer", number(consumer))));
    let formula = (7, long("Formula", Some(Value::NodeId(1))));
    let consumers = consumers.chain([formula]).collect();
    device.objects.insert(0x1016, record("Consumers", consumers));
    let channel = |request: Option<Value>, response: Option<Value>| {
        let node = entry("Node", DataType::UNSIGNED8, number(7));
        record("SDO", vec![(1, long("Request", request)), (2, long("Response", response)), (3, node)])
    };
    device.objects.insert(0x1200, channel(None, None));
    device.objects.insert(0x127F, channel(number(0x8000_0000), Some(Value::NodeId(0x2000_0000))));
    device.objects.insert(0x1280, channel(None, number(0x581)));
    device.objects.insert(0x12FF, channel(Some(Value::NodeId(0)), number(u32::MAX)));
    device
}

fn text(generated: &Generated) -> String {
    String::from_utf8_lossy(&generated.files[0].contents).into_owned()
}

/// The program of the test below.
pub(crate) fn part(name: &str, device: &Device, generated: &Generated) -> Part {
    let program = in_rust(&text(generated), &Constants::of(device));
    Part::new(&format!("defaults {name}"), &program.unwrap_or_else(|error| panic!("{name}: {error}")), &())
}

#[test]
fn constants_are_what_the_objects_say() {
    let compiler = c_compiler();
    let devices: Vec<(String, Device)> =
        devices().into_iter().chain([("services".to_owned(), odd())]).collect();
    for_all(&devices, |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        TABLES.check(&format!("defaults {name}"), "", |_| Ok(())).map_err(fail)?;
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let expected = Constants::of(device);
        let Some(compiler) = &compiler else { return Ok(()) };
        for table in [CTable::Compact, CTable::Structs] {
            let mut options = Options::default();
            options.table = table;
            let generated = generate(device, Target::C, &options).map_err(|error| error.to_string())?;
            std::fs::write(folder.join("od.h"), &generated.files[0].contents)
                .map_err(|error| error.to_string())?;
            check_c(folder, &text(&generated), compiler, &expected).map_err(fail)?;
        }
        Ok(())
    });
}

#[test]
fn what_makes_no_constant_is_noted() {
    let generated = generate(&odd(), Target::RUST, &Options::default()).unwrap();
    let of_constants = generated.notes.iter().filter(|note| note.message.starts_with("no constant"));
    let notes: Vec<String> = of_constants.map(ToString::to_string).collect();
    let none =
        |value: &str| format!("no constant for `{value}`, which is not valid for this object on every node");
    assert_eq!(
        notes,
        [
            format!("0x1014sub0: {}", none("$NODEID+0x1FFFFFF0")),
            format!("0x1015sub0: {}", none("$NODEID+0x3")),
            format!("0x1016sub7: {}", none("$NODEID+0x1")),
        ]
    );
}
