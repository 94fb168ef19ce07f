//! `objdict network diff` prints nothing if and only if everything that is built and shown of both networks is the same.
//!
//! The keys are those of the schemas, which are made of the tables that the files are read by.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use objdict::format::network::{BuiltFile, NetworkFile, PathOptions, schema};
use objdict::generate::{Options, Target, generate};
use objdict::network::{DcfgenMode, LelyOptions, Overview, Timing, TimingOptions};
use serde_json::{Value, json};

use crate::support::skips::{sample, samples_all, say};

/// A network with every key, without a description of its manager.
fn undescribed() -> Value {
    let pdo = json!({
        "enabled": true, "cob-id": 0x405, "transmission": "event", "inhibit": 10, "event-timer": 100,
        "deadline": 300, "sync-start": 0, "map": ["6041"],
    });
    let received = json!({
        "enabled": true, "cob-id": 0x305, "transmission": "event", "deadline": 300, "map": ["6040"],
        "inhibit": 10, "event-timer": 100, "sync-start": 0,
    });
    json!({
        "bus": {
            "name": "cell", "bit-rate": 250, "manager": "plc", "sync": 20000, "sync-window": 5000,
            "sync-overflow": 0, "identity": "serial", "unused-pdos": "off", "run-time-folder": "cfg",
        },
        "manager": {
            "id": 1, "vendor-id": 1, "product-code": 2, "revision-number": 3, "serial-number": 4,
            "heartbeat": 200, "watch": "3x", "watches-nodes": true, "time-cob-id": 0x4000_0100_u32,
            "emcy-inhibit": 10, "nmt-inhibit": 10, "error-behavior": { "1": 0 }, "start": true,
            "start-nodes": true, "start-all-nodes": false, "reset-all-nodes": false,
            "stop-all-nodes": false, "boot-time": 5000,
        },
        "type": { "fast": { "heartbeat": 100 }, "slow": { "heartbeat": 900 } },
        "node": {
            "drive": {
                "file": "servo.eds", "id": 5, "use": "fast", "heartbeat": 300, "watch": "2x",
                "watches-manager": true, "watches": { "counter": "1.5x" }, "guard-time": 0,
                "life-time-factor": 0, "time-cob-id": 0x8000_0100_u32, "error-behavior": { "1": 1 },
                "set": { "6081": 100 }, "rpdo": { "4": received }, "tpdo": { "4": pdo },
                "unused-pdos": "keep", "sdo": [{ "entry": "6081", "value": 7 }], "boot": true,
                "mandatory": true, "reset-communication": true, "retry-factor": 3,
                "software-file": "fw.bin", "software-version": 1, "restore": 1, "identity": "serial",
                "revision-number": 0x0001_0002, "serial-number": 9, "run-time-folder": "drives",
            },
            "counter": { "file": "counter.eds", "id": 6, "use": "fast" },
            "coupler": { "file": "coupler.eds", "id": 7, "modules": [1, 2], "unused-pdos": "off" },
        },
        "link": [
            {
                "from": "drive.6041", "to": "plc", "transmission": "sync/1", "inhibit": 10,
                "event-timer": 100, "deadline": 300, "can-id": 0x185,
            },
            { "from": "plc", "to": "drive.6040", "transmission": "event", "inhibit": 20, "event-timer": 90 },
        ],
    })
}

/// The same with one.
fn described_manager() -> Value {
    let mut described = undescribed();
    described["bus"]["manager"] = "controller".into();
    described["node"]["controller"] = json!({ "file": "plc.eds", "id": 1 });
    described["manager"].as_object_mut().unwrap().remove("id");
    described["link"][0]["to"] = "controller.5200:1-2".into();
    described["link"][0]["from"] = "drive.6041".into();
    described["link"].as_array_mut().unwrap().truncate(1);
    described
}

/// The same for dcfgen.
fn bus() -> Value {
    let pdo = json!({
        "enabled": true, "cob_id": 0x405, "transmission": 1, "inhibit_time": 10, "event_timer": 100,
        "event_deadline": 300, "sync_start": 0, "mapping": [{ "index": 0x6041, "sub_index": 0, "bits": 16 }],
    });
    let mut received = pdo.clone();
    received["cob_id"] = 0x305.into();
    received["mapping"][0]["index"] = 0x6040.into();
    json!({
        "options": { "dcf_path": "cfg", "heartbeat_multiplier": 3.0, "retry_factor": 2 },
        "master": {
            "node_id": 1, "baudrate": 250, "vendor_id": 1, "product_code": 2, "revision_number": 3,
            "serial_number": 4, "sync_period": 20000, "sync_window": 5000, "sync_overflow": 0,
            "time_cob_id": 0x4000_0100_u32, "emcy_inhibit_time": 10, "nmt_inhibit_time": 10,
            "heartbeat_producer": 200, "heartbeat_multiplier": 3.0, "heartbeat_consumer": true,
            "error_behavior": { "1": 0 }, "start": true, "start_nodes": true, "start_all_nodes": false,
            "reset_all_nodes": false, "stop_all_nodes": false, "boot_time": 5000,
        },
        "drive": {
            "dcf": "servo.eds", "node_id": 5, "heartbeat_producer": 300, "heartbeat_consumer": true,
            "rpdo": { "1": received }, "tpdo": { "1": pdo }, "error_behavior": { "1": 1 },
            "sdo": [{ "index": 0x6081, "sub_index": 0, "value": 100 }],
        },
        "counter": { "dcf": "counter.eds", "node_id": 6 },
    })
}

/// A document as TOML or YAML, all of it in brackets.
fn text(value: &Value, sign: &str) -> String {
    match value {
        Value::Object(entries) => {
            let entries = entries.iter().map(|(key, value)| match key.parse::<u8>() {
                Ok(number) => format!("{number}{sign}{}", text(value, sign)),
                Err(_) => format!("\"{key}\"{sign}{}", text(value, sign)),
            });
            format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
        }
        Value::Array(items) => {
            format!("[{}]", items.iter().map(|item| text(item, sign)).collect::<Vec<_>>().join(", "))
        }
        value => value.to_string(),
    }
}

fn document(value: &Value, is_toml: bool) -> String {
    let sign = if is_toml { " = " } else { ": " };
    let lines = value.as_object().unwrap().iter();
    lines.fold(String::new(), |mut lines, (key, value)| {
        writeln!(lines, "{key}{sign}{}", text(value, sign)).unwrap();
        lines
    })
}

/// A value for a key of a schema, which names it.
fn candidates(key: &str, schema: &Value, present: Option<&Value>) -> Vec<Value> {
    let number = |schema: &Value| {
        let (low, high) = (schema["minimum"].as_i64()?, schema["maximum"].as_i64()?);
        let near = present.and_then(Value::as_i64).map(|number| number + 1);
        let all = [near, Some(low), Some(low + 1), Some(40)].into_iter().flatten();
        Some(all.filter(move |number| (low..=high).contains(number)).map(Value::from).collect::<Vec<_>>())
    };
    let text: &[&str] = match key {
        "manager" => &["drive"],
        "file" | "dcf" => &["copy.eds", "renamed.eds", "revised.eds", "counter.eds"],
        "use" => &["slow"],
        "watch" => &["4x"],
        "transmission" | "type" => &["sync/2", "event", "sync/0"],
        "entry" => &["6082", "6040"],
        "from" => &["drive.6061", "plc"],
        _ => &["other", "x.bin"],
    };
    match key {
        "watches" => vec![json!({ "counter": "2.5x" }), json!({})],
        "set" => vec![json!({ "6081": 101 }), json!({ "6082": 100 })],
        "to" => vec![json!("counter.6040"), json!(["counter.6040", "plc"])],
        "map" => vec![json!(["6061"]), json!(["6041", "6064"]), json!(["607A"])],
        "modules" => vec![json!([1]), json!([2, 1])],
        "value" => vec![json!(8), json!([8, 9])],
        _ if schema["enum"].is_array() => schema["enum"].as_array().unwrap().clone(),
        _ if schema["type"] == "boolean" => vec![json!(true), json!(false)],
        _ if schema["type"] == "integer" => number(schema).unwrap(),
        _ if schema["type"] == "number" => vec![json!(2.5), json!(4.0)],
        _ if schema["anyOf"].is_array() => number(&schema["anyOf"][0]).unwrap_or_default(),
        _ => text.iter().map(|text| json!(text)).collect(),
    }
}

/// An edit: where, and the new value; `None` removes the key.
#[derive(Clone, Debug)]
struct NetworkEdit {
    path: Vec<String>,
    value: Option<Value>,
}

impl NetworkEdit {
    fn applied(&self, document: &Value) -> Value {
        let mut edited = document.clone();
        let (last, parents) = self.path.split_last().unwrap();
        let parent = parents.iter().fold(&mut edited, |at, key| match at {
            Value::Array(items) => &mut items[key.parse::<usize>().unwrap()],
            at => &mut at[key.as_str()],
        });
        let parent = parent.as_object_mut().unwrap();
        match &self.value {
            Some(value) => parent.insert(last.clone(), value.clone()),
            None => parent.remove(last),
        };
        edited
    }
}

/// The edits of all keys that a schema lists below a value of the document.
fn edits(all: &Value, schema: &Value, value: &Value, path: &[String], found: &mut Vec<NetworkEdit>) {
    let schema = match schema["$ref"].as_str() {
        Some(name) => &all["$defs"][name.rsplit('/').next().unwrap()],
        None => schema,
    };
    let below = |key: &str| [path, &[key.to_owned()]].concat();
    if let Some(items) = schema["items"].as_object().filter(|items| items.contains_key("properties")) {
        for (at, item) in value.as_array().unwrap().iter().enumerate() {
            edits(all, &items.clone().into(), item, &below(&at.to_string()), found);
        }
        return;
    }
    let names = value.as_object().into_iter().flatten();
    if let Some(properties) = schema["properties"].as_object() {
        for (key, of_key) in properties {
            let present = value.get(key);
            let is_table = |of_key: &Value| {
                let tables = [&of_key["items"], &of_key["additionalProperties"], of_key];
                let numbered = of_key["patternProperties"].as_object().into_iter().flatten();
                let mut tables = tables.into_iter().chain(numbered.map(|(_, of_number)| of_number));
                tables.any(|table| table["properties"].is_object())
            };
            if is_table(of_key) || of_key["patternProperties"].is_object() {
                // a table that one instance has is edited there
                if let Some(present) = present {
                    edits(all, of_key, present, &below(key), found);
                }
                continue;
            }
            let values = candidates(key, of_key, present).into_iter().map(Some);
            let values = values.chain(present.map(|_| None));
            found.extend(values.map(|value| NetworkEdit { path: below(key), value }));
        }
    } else if schema["additionalProperties"].is_object() {
        for (name, value) in names {
            edits(all, &schema["additionalProperties"], value, &below(name), found);
        }
    } else if let Some(numbered) = schema["patternProperties"].as_object() {
        let of_number = numbered.values().next().unwrap();
        for (number, value) in names {
            match of_number["properties"].is_object() {
                true => edits(all, of_number, value, &below(number), found),
                false => found.push(NetworkEdit { path: below(number), value: Some(json!(2)) }),
            }
        }
    }
}

/// What is built or shown, by name.
type Outputs = Vec<(String, String)>;

/// How some outputs are made, but for names of files, comments and dates; `None` if they cannot be made.
type MakeOutputs = fn(&NetworkFile) -> Option<Outputs>;

/// The makers of all outputs. Those that take long come last: the first difference decides.
const MAKERS: [MakeOutputs; 3] = [shown, sent, described];

fn shown(file: &NetworkFile) -> Option<Outputs> {
    let (network, compiled) = (file.network()?, file.compiled()?);
    let rate = network.bit_rate.map_or(1000, |rate| rate.value);
    let options = TimingOptions { bit_rate: Some(rate), ..TimingOptions::default() };
    Some(vec![
        ("show".to_owned(), serde_json::to_string(&Overview::new(network, compiled)).unwrap()),
        ("timing".to_owned(), format!("{:?}", Timing::new(network, compiled, &options))),
    ])
}

fn sent(file: &NetworkFile) -> Option<Outputs> {
    let build = file.build(DcfgenMode::Corrected).ok()?;
    let mut files = build.concise().ok()?;
    files.extend(build.lely(&LelyOptions { remote_pdos: true, ..LelyOptions::default() }).ok()?);
    files.extend(build.bus_yml().ok()?.into_iter().take(1));
    Some(nameless(&files))
}

/// The DCFs of all nodes, and the tables of the manager.
fn described(file: &NetworkFile) -> Option<Outputs> {
    let build = file.build(DcfgenMode::Corrected).ok()?;
    let mut found = nameless(&build.node_list().ok()?);
    for target in [Target::C, Target::RUST] {
        let tables = generate(&build.manager_device().ok()?, target, &Options::default()).ok()?;
        let text = tables.files.iter().map(|file| String::from_utf8_lossy(&file.contents).into_owned());
        found.push((format!("{target:?}"), text.collect()));
    }
    Some(found)
}

/// Files without the lines that name others.
fn nameless(files: &[BuiltFile]) -> Outputs {
    let is_name = |line: &&str| {
        let key = line.split(['=', ':']).next().unwrap_or_default().trim();
        ["FileName", "LastEDS", "dcf"].contains(&key)
    };
    let without_names = |file: &BuiltFile| {
        let text = str::from_utf8(&file.bytes);
        let text = text.map(|text| text.lines().filter(|line| !is_name(line)).collect::<Vec<_>>().join("\n"));
        (file.name.clone(), text.unwrap_or_else(|_| format!("{:?}", file.bytes)))
    };
    files.iter().map(without_names).collect()
}

/// The first outputs that differ; `None` if there are some that cannot be made.
fn differing(before: &[Outputs], file: &NetworkFile) -> Option<Vec<String>> {
    for (make, before) in MAKERS.iter().zip(before) {
        let after = make(file)?;
        let [removed, added] = [(before, &after), (&after, before)]
            .map(|(these, others)| these.iter().filter(|output| !others.contains(output)));
        let names: BTreeSet<_> = removed.chain(added).map(|(name, _)| name.clone()).collect();
        if !names.is_empty() {
            return Some(names.into_iter().collect());
        }
    }
    Some(Vec::new())
}

/// What the command prints, and its exit code.
fn diff(folder: &Path, other: &str, first: &str) -> (String, i32) {
    let mut command = Command::new(crate::program());
    let output = command.current_dir(folder).args(["network", "diff", first, other]).output().unwrap();
    (crate::printed(&output.stdout), output.status.code().unwrap())
}

fn read(folder: &Path, name: &str) -> NetworkFile {
    NetworkFile::open(&folder.join(name), &PathOptions::default()).unwrap()
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let fixture = |name: &str| fs::read_to_string(Path::new("fixtures").join(name)).unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    for name in ["servo.eds", "counter.eds", "plc.eds"] {
        write(name, &fixture(&format!("network/{name}")));
    }
    write("coupler.eds", &fixture("eds/coupler-modular.eds"));
    let servo = fixture("network/servo.eds");
    write("copy.eds", &servo);
    write("revised.eds", &servo.replacen("FileRevision=0", "FileRevision=2", 1));
    write("renamed.eds", &servo.replacen("ParameterName=Device type", "ParameterName=Kind of device", 1));
    folder
}

/// Changes each key, and compares the verdict of `diff` with what is built.
fn compare_edits(name: &str, base: &Value, all: &[NetworkEdit]) {
    let is_toml = name.ends_with("toml");
    let folder = folder();
    let folder = folder.path();
    fs::write(folder.join(name), document(base, is_toml)).unwrap();
    let file = read(folder, name);
    let errors: Vec<_> = file.text_errors().map(|error| error.message.to_string()).collect();
    assert_eq!(errors, Vec::<String>::new(), "{}", document(base, is_toml));
    let before: Vec<Outputs> = MAKERS.iter().map(|make| make(&file).unwrap()).collect();
    let other = format!("other-{name}");
    let (mut accepted, mut wrong, mut compared) = (BTreeSet::new(), 0, 0);
    for (number, edit) in sample(sample(all)).into_iter().enumerate() {
        if number > 0 && number % 100 == 0 {
            say(format!("{number} edits of {}", all.len()));
        }
        fs::write(folder.join(&other), document(&edit.applied(base), is_toml)).unwrap();
        let file = read(folder, &other);
        if file.text_errors().next().is_some() {
            continue;
        }
        let Some(differing) = differing(&before, &file) else { continue };
        accepted.insert(edit.path.last().unwrap());
        compared += 1;
        let (said, code) = diff(folder, &other, name);
        if said.is_empty() != differing.is_empty() || code != i32::from(!differing.is_empty()) {
            wrong += 1;
            say(format!("{edit:?}: exit {code}, differing: {differing:?}\n{said}"));
        }
    }
    assert_eq!(wrong, 0, "of {compared} edits, which are above, in {}", document(base, is_toml));
    if samples_all() {
        say(format!("{compared} edits of {} are accepted", all.len()));
        let keys: BTreeSet<_> = all.iter().map(|edit| edit.path.last().unwrap()).collect();
        let refused: Vec<_> = keys.difference(&accepted).collect();
        assert!(refused.is_empty(), "no change is accepted of {refused:?}");
    }
}

/// What cannot be built is compared too, and names that no system allows for files are replaced in the same way everywhere.
#[test]
fn a_network_has_no_difference_from_itself() {
    let folder = folder();
    let folder = folder.path();
    let servo = fs::read_to_string(folder.join("servo.eds")).unwrap().replace("\r\n", "\n");
    let faulty = servo.replacen("[1017]\n", "[1017]\nParameterValue=abc\n", 1);
    fs::write(folder.join("faulty.eds"), &faulty).unwrap();
    assert_ne!(servo, faulty);
    let network = "[bus]\nbit-rate = 250\nmanager = \"m\"\n[manager]\nid = 1\n".to_owned();
    let node = |name: &str, id: u8| format!("[node.{name:?}]\nfile = \"servo.eds\"\nid = {id}\n");
    let network = network + &node("CON", 5) + &node("a:b", 6) + &node("a/b", 7);
    fs::write(folder.join("n.toml"), &network).unwrap();
    fs::write(folder.join("faulty.toml"), network.replacen("servo.eds", "faulty.eds", 1)).unwrap();
    for name in ["n.toml", "faulty.toml"] {
        assert_eq!(diff(folder, name, name), (String::new(), 0), "{name}");
    }
    assert_eq!(diff(folder, "n.toml", "faulty.toml").1, 1);
    fs::write(folder.join("revised.toml"), network.replacen("servo.eds", "revised.eds", 1)).unwrap();
    let said = "description of CON:\n- FileRevision=0\n+ FileRevision=2\n";
    assert_eq!(diff(folder, "revised.toml", "n.toml"), (said.to_owned(), 1));
    let file = read(folder, "n.toml");
    assert!(!file.check().has_errors());
    let built: BTreeSet<String> = file
        .build(DcfgenMode::Corrected)
        .unwrap()
        .dcfs()
        .unwrap()
        .into_iter()
        .map(|file| file.name)
        .collect();
    assert_eq!(built, ["_CON.dcf", "a_b-7.dcf", "a_b.dcf", "m.dcf"].map(str::to_owned).into());
    let mut docs = Command::new(crate::program());
    assert!(docs.current_dir(folder).args(["docs", "n.toml", "-o", "docs"]).status().unwrap().success());
    let pages: BTreeSet<String> = built.iter().map(|name| name.replace(".dcf", ".html")).collect();
    assert!(pages.iter().all(|page| folder.join("docs").join(page).is_file()));
}

fn compare_edits_of_toml(base: &Value) {
    let schema = schema::network_toml();
    let mut found = Vec::new();
    edits(&schema, &schema, base, &[], &mut found);
    compare_edits("network.toml", base, &found);
}

#[test]
fn no_difference_of_a_network_means_the_same_outputs() {
    compare_edits_of_toml(&undescribed());
}

#[test]
fn no_difference_of_a_network_with_a_described_manager_means_the_same_outputs() {
    compare_edits_of_toml(&described_manager());
}

#[test]
fn no_difference_of_a_bus_means_the_same_outputs() {
    let bus = bus();
    let schema = schema::bus_yml();
    let mut found = Vec::new();
    for (name, value) in bus.as_object().unwrap() {
        let of_name = schema["properties"].get(name).unwrap_or(&schema["$defs"]["node"]);
        edits(&schema, of_name, value, std::slice::from_ref(name), &mut found);
    }
    compare_edits("bus.yml", &bus, &found);
}

/// Every command that needs a network names the option that allows the folder of its descriptions.
#[test]
fn descriptions_outside_the_project_have_their_remedy() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("own")).unwrap();
    fs::copy("fixtures/eds/drive-402.eds", folder.path().join("drive.eds")).unwrap();
    let text = "[bus]\nbit-rate = 500\n\n[node.a]\nfile = \"../drive.eds\"\nid = 5\n\n\
        [node.b]\nfile = \"../drive.eds\"\nid = 6\n";
    fs::write(folder.path().join("own/net.toml"), text).unwrap();
    for line in ["network boot net.toml", "bus scan --nodes 5-6 --bus sim:net.toml", "bus lss plan net.toml"]
    {
        let run = |more: &[&str]| {
            let mut command = Command::new(crate::program());
            command.args(line.split(' ')).args(more).current_dir(folder.path().join("own"));
            let output = command.output().unwrap();
            (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
        };
        let (code, errors) = run(&[]);
        assert_eq!(code, Some(2), "{line}");
        assert!(errors.contains("is outside the project") && errors.contains("`--allow-path`"), "{errors}");
        assert!(!run(&["--allow-path", ".."]).1.contains("outside the project"), "{line}");
    }
}

/// Devices with a serial number get their node-IDs on one bus; a bit rate is tested with each alone, at last.
#[test]
fn a_plan_changes_the_bit_rates_last() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("fixtures/eds/drive-402.eds", folder.path().join("drive.eds")).unwrap();
    let node =
        |name: &str, id: u8, more: &str| format!("[node.{name}]\nfile = \"drive.eds\"\nid = {id}\n{more}\n");
    let nodes = [node("a", 5, "serial-number = 7"), node("b", 6, ""), node("c", 7, "serial-number = 8")];
    fs::write(folder.path().join("net.toml"), format!("[bus]\nbit-rate = 250\n\n{}", nodes.concat()))
        .unwrap();
    let mut command = Command::new(crate::program());
    let output =
        command.args(["bus", "lss", "plan", "net.toml"]).current_dir(folder.path()).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<(u8, bool)> = text
        .lines()
        .map(|line| {
            assert!(line.contains("--identity") || line.contains("new device"), "{line}");
            (
                line.split(' ').nth(4).unwrap().parse().unwrap(),
                line.contains("--bit-rate 250    # connect only"),
            )
        })
        .collect();
    assert_eq!(lines, [(5, false), (7, false), (6, true), (5, true), (7, true)], "{text}");
}
