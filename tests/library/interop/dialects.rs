//! Other tools read each dialect: every description is written for every reader, and types, access and values are compared.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::format::{self, Description, Dialect, Format, WriteOptions};
use objdict::model::{Access, Device, DeviceKind, Value};
use objdict::source::{SourceFile, SourceOptions};
use serde_json::{Value as Json, json};

use super::{environment, node_modules};
use crate::support;
use crate::support::skips::{sample, samples_all};

/// A sample of the healthy devices of the fixtures, and with `OBJDICT_CORPUS_DIR` the files below that folder.
pub(super) fn all_devices() -> Vec<(String, Device)> {
    let endings = ["eds", "dcf", "xdd", "xdc"];
    let of_xml = [support::files("xdd", &["xdd"]), support::files("xdc", &["xdc"])].concat();
    let mut paths = sample([support::good_devices(), of_xml].concat());
    let own = paths.len();
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        let mut files = support::files_below(Path::new(&folder), &endings);
        files.sort();
        paths.extend(files);
    }
    let open = |(number, path): (usize, &PathBuf)| {
        let device = format::open(path, &SourceOptions::default()).ok().map(Description::into_device)?;
        let stem = path.file_stem()?.to_string_lossy().into_owned();
        let kind = if number < own { "own" } else { "corpus" };
        Some((format!("{kind}-{number}-{stem}"), device))
    };
    let opened = paths.iter().enumerate().filter_map(open).filter(|(_, device)| !device.objects.is_empty());
    let minimal = fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let odd = minimal.replace("ProductNumber=", "ProductNumber=type ") + REFUSED;
    let odd = format::read(SourceFile::from_text("odd.eds", odd), Format::Eds).into_device();
    opened.chain([("own-odd".to_owned(), odd)]).collect()
}

/// What python-canopen refuses a file for: a VAR in compact storage, and texts where it reads numbers.
const REFUSED: &str = "\r\n[2F00]\r\nParameterName=Channels\r\nObjectType=7\r\nDataType=5\r\nAccessType=rw\r\nDefaultValue=1\r\n\
    CompactSubObj=2\r\n[2F01]\r\nParameterName=Limits\r\nObjectType=record\r\nSubNumber=2\r\n[2F01sub0]\r\nParameterName=n\r\n\
    DataType=5\r\nAccessType=ro\r\nDefaultValue=1\r\n[2F01sub1]\r\nParameterName=a\r\nDataType=7\r\nAccessType=rw\r\nDefaultValue=7\r\n";

/// Each entry with its type, access and value, as far as the description states them and CiA 301 knows the type.
fn entries(device: &Device, node_id: u8) -> Vec<Json> {
    let mut entries = Vec::new();
    for (&index, object) in device.objects.range(0x1000..).filter(|(_, object)| !object.orphan) {
        for (sub, entry) in object.entries().filter(|(sub, _)| *sub != 0xFF) {
            let data_type = entry.data_type.filter(|data_type| data_type.0 <= 0x1B);
            let value =
                entry.value().zip(data_type).and_then(|(value, data_type)| value.resolve(data_type, node_id));
            let value = match value {
                Some(Value::Boolean(flag)) => json!(flag),
                Some(Value::Signed(number)) => json!(number),
                Some(Value::Unsigned(number)) => json!(number),
                Some(Value::Real32(number)) if number.is_finite() => json!(number),
                Some(Value::Real64(number)) if number.is_finite() => json!(number),
                _ => Json::Null,
            };
            let is_formula = entry.value().is_some_and(|value| matches!(value, Value::NodeId(_)));
            let access = entry.access.map(Access::name);
            entries.push(json!([
                index,
                sub,
                data_type.map(|data_type| data_type.0),
                access,
                value,
                is_formula
            ]));
        }
    }
    entries
}

/// What a text states itself.
fn without_embedded(text: Vec<u8>, format: Format) -> Device {
    let text = String::from_utf8(text).unwrap();
    let lines: String = text.split_inclusive('\n').filter(|line| !line.starts_with(';')).collect();
    format::read(SourceFile::from_text("stated", lines), format).into_device()
}

/// Writes all devices in a dialect, with what is expected of a reader.
fn write(devices: &[(String, Device)], dialect: Dialect) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("interop-dialect-{}", dialect.name()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let mut options = WriteOptions::from(dialect);
    options.embed = true;
    let expected = devices.iter().map(|(name, device)| {
        let format = if device.kind == DeviceKind::Type { Format::Eds } else { Format::Dcf };
        let file = format!("{name}.{}", format.name().to_lowercase());
        let written = format::write(device, format, &options).unwrap().bytes;
        fs::write(folder.join(&file), &written).unwrap();
        let node_id = device.node_id().unwrap_or(5);
        let expected = match dialect {
            // it leaves out what one of the readers refuses
            Dialect::Portable => entries(&without_embedded(written, format), node_id),
            _ => entries(device, node_id),
        };
        json!({ "file": file, "node_id": node_id, "entries": expected })
    });
    let expected: Vec<Json> = expected.collect();
    fs::write(folder.join("expected.json"), serde_json::to_string(&expected).unwrap()).unwrap();
    folder
}

/// What a tool did with the files of a folder.
#[derive(Default)]
struct Verdict {
    read: usize,
    same: usize,
    /// The first words of each refusal, and the first difference of a file.
    reasons: BTreeMap<String, String>,
}

fn read_with(command: &mut Command) -> Verdict {
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", super::text_of(&output));
    let mut verdict = Verdict::default();
    for line in String::from_utf8(output.stdout).unwrap().lines() {
        let answer: Json = serde_json::from_str(line).unwrap();
        let file = answer["file"].as_str().unwrap().to_owned();
        match (answer["refused"].as_str(), answer["differences"].as_array()) {
            (None, Some(differences)) => {
                verdict.read += 1;
                match differences.first() {
                    None => verdict.same += 1,
                    Some(first) => {
                        _ = verdict.reasons.insert(file, format!("{first} ({})", differences.len()));
                    }
                }
            }
            (refused, _) => {
                _ = verdict.reasons.insert(file, format!("refused: {}", refused.unwrap_or_default()));
            }
        }
    }
    verdict
}

/// Only the tool of a dialect must read it. What the others do with it is printed with `OBJDICT_SAMPLE=all`.
///
/// For every device, `python_canopen_uploads_what_we_wrote` reads the canonical text, and the tests of `write` and of the command's
/// `dialects` compare what each dialect changes.
#[test]
fn tools_read_their_dialects() {
    let Some(programs) = environment() else { return };
    let devices = all_devices();
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop");
    let modules = node_modules();
    let mut failures = Vec::new();
    for dialect in Dialect::ALL.into_iter().filter(|dialect| *dialect != Dialect::Codesys) {
        let folder = write(&devices, dialect);
        for tool in ["dcf-tools", "python-canopen", "node-canopen"] {
            let is_for_it = dialect.tools().iter().any(|of_dialect| of_dialect.name() == tool);
            if !is_for_it && !samples_all() {
                continue;
            }
            let mut command = match (tool, modules) {
                ("node-canopen", None) => continue,
                ("node-canopen", Some(modules)) => {
                    let mut node = Command::new("node");
                    node.env("NODE_PATH", modules).arg(scripts.join("read_all.js"));
                    node
                }
                _ => {
                    let mut python = Command::new(programs.join("python"));
                    python.arg(scripts.join("read_all.py")).arg(tool);
                    python
                }
            };
            let Verdict { read, same, reasons } = read_with(command.arg(&folder));
            println!("{}\t{tool}\t{} files\t{read} read\t{same} alike", dialect.name(), devices.len());
            // it reads some values otherwise, however they are written (docs/reference/portability.md)
            let counts = |why: &str| is_for_it && (tool != "node-canopen" || why.starts_with("refused"));
            let reasons = reasons.iter().filter(|(_, why)| counts(why));
            failures.extend(reasons.map(|(file, why)| format!("{tool}: {file}: {why}")));
        }
    }
    println!("{}", failures.join("\n"));
    failures.retain(|failure| failure.contains(": own-"));
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Of a `device.toml`, and of the EDS and XDD that are written of it; an element has what its array states.
#[test]
fn units_factors_and_descriptions_reach_python_canopen() {
    let Some(environment) = environment() else { return };
    let source = "format = 'objdict-device/1'\nprofile = '301@1'\n[object]\n\
        2000 = { name = 'Supply', type = 'u16', unit = 'V', factor = 0.01, description = 'at 50 % of the load' }\n\
        2001 = { name = 'Temperatures', type = '[i16; 2]', unit = 'K', factor = 0.5 }\n\
        2002 = { name = 'Offset', type = 'i16', unit = 'mm', factor = 2, offset = 7 }\n";
    let read = |text: &str, format| format::read(SourceFile::from_text("units", text), format).into_device();
    let write = |device: &Device, format| {
        let mut options = WriteOptions::from(Dialect::PythonCanopen);
        options.embed = true;
        format::write(device, format, &options).unwrap().bytes
    };
    let device = read(source, Format::Toml);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-units");
    fs::create_dir_all(&folder).unwrap();
    for format in [Format::Toml, Format::Eds, Format::Xdd] {
        let text = String::from_utf8(write(&device, format)).unwrap();
        let file = folder.join(format!("{}.eds", format.name()));
        fs::write(&file, write(&read(&text, format), Format::Eds)).unwrap();
        let mut python = Command::new(environment.join("python"));
        python.args(["-c", READ_UNITS]).arg(&file);
        let output = python.output().unwrap();
        assert!(output.status.success(), "{}", super::text_of(&output));
        let expected = "V 0.01 at 50 % of the load\nK 0.5 \nK 0.5 \nmm 1 \n"; // python-canopen knows no offset, so no factor
        assert_eq!(String::from_utf8_lossy(&output.stdout).replace("\r\n", "\n"), expected, "{format:?}");
    }
}

const READ_UNITS: &str = "
import canopen, sys
od = canopen.import_od(sys.argv[1])
for entry in [od[0x2000], od[0x2001][1], od[0x2001][2], od[0x2002]]:
    print(entry.unit, entry.factor, entry.description)
";
