//! Other tools read what we write: python-canopen 2.4.1 uploads every entry, dcf-tools 2.4.2 accepts what is within its
//! range, cantools 45.1.0 and canmatrix 1.3.3 decode the frames of a DBC, and safe fixes make no fixture worse for the first two
//! and canopen 6.2.1 of npm (`fixes`).
//!
//! The test makes a Python environment below `target` and installs the packages. Without Python or network it says so
//! and passes, except when `CI=true`.

#![allow(clippy::print_stdout, reason = "prints what a tool read")]

mod dialects;
mod editor;
mod fixes;
mod goals;

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use objdict::compat::{Effect, REACTIONS};
use objdict::diagnostic::{Findings, Tool};
use objdict::format::{self, Description, Format, WriteOptions};
use objdict::lint::Options;
use objdict::model::{Access, Commissioning, DataType, Device, TypeKind, Value};
use objdict::source::{SourceFile, SourceOptions};
use objdict_model::literal::RealSpelling;
use serde_json::json;

use crate::support;

#[cfg(all(feature = "bus", unix))]
mod bus;
#[cfg(feature = "full")]
mod canopeneditor;
#[cfg(feature = "full")]
mod dbc;
mod edited;
#[cfg(feature = "full")]
mod logs;
mod networks;
#[cfg(feature = "cli")]
mod schemas;

const PACKAGES: [&str; 6] = [
    "canopen==2.4.1",
    "dcf-tools==2.4.2",
    "cantools==45.1.0",
    "canmatrix==1.3.3",
    "jsonschema-rs==0.61.0",
    "protobuf==6.33.0",
];

/// The folder with the programs of the environment, made once; `None`, and the test is skipped, when it cannot be made here.
pub(crate) fn environment() -> Option<&'static Path> {
    static ENVIRONMENT: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    let made = ENVIRONMENT.get_or_init(|| support::python("interop-venv", &PACKAGES));
    support::unless_offline(made.as_deref().map_err(Clone::clone))
}

/// The package of npm, installed once.
fn node_modules() -> Option<&'static Path> {
    static MODULES: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    support::unless_offline(MODULES.get_or_init(install_node_modules).as_deref().map_err(Clone::clone))
}

fn install_node_modules() -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-npm");
    let modules = folder.join("node_modules");
    if modules.join("canopen").is_dir() {
        return Ok(modules);
    }
    fs::create_dir_all(&folder).unwrap();
    let mut npm = Command::new("npm");
    npm.args(["install", "--silent", "--no-save", "--prefix"]).arg(&folder).arg("canopen@6.2.1");
    support::run(&mut npm).map_err(|error| format!("npm: {error}"))?;
    Ok(modules)
}

fn text_of(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

/// A healthy fixture, read.
fn devices() -> Vec<(String, Description)> {
    let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
    let open = |path: &PathBuf| format::open(path, &SourceOptions::default()).unwrap();
    support::good_devices().iter().map(|path| (name(path), open(path))).collect()
}

/// Writes the canonical text of every healthy device into a new folder.
fn write_all(devices: &[(String, Description)], folder: &str, options: &WriteOptions) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    fs::create_dir_all(&folder).unwrap();
    for (name, description) in devices {
        let written = format::write(description.device(), description.format(), options).unwrap();
        fs::write(folder.join(name), written.bytes).unwrap();
    }
    folder
}

/// The expected upload of each entry, without what python-canopen cannot serve: entries that are write-only or
/// have no value, definitions of types and entries of such a type, the TIME types, which it does not know, and strings
/// with ` ;`, which it cuts there.
fn expected_entries(device: &Device, node_id: u8) -> Vec<serde_json::Value> {
    let mut entries = Vec::new();
    for (&index, object) in &device.objects {
        for (sub, entry) in object.entries() {
            let data_type = entry.data_type.unwrap_or(DataType::DOMAIN);
            let is_unknown = matches!(
                data_type.kind(),
                TypeKind::TimeOfDay | TypeKind::TimeDifference | TypeKind::Defined
            ) || index < 0x1000
                || matches!(entry.value(), Some(Value::Text(text)) if text.contains(" ;"));
            let value = entry.value().and_then(|value| value.resolve(data_type, node_id));
            let bytes = value.and_then(|value| value.to_bytes(data_type));
            if let Some(bytes) =
                bytes.filter(|_| !is_unknown && entry.access.is_some_and(Access::is_readable))
            {
                let hex: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
                entries.push(json!({ "index": index, "sub": sub, "bytes": hex }));
            }
        }
    }
    entries
}

#[test]
fn python_canopen_uploads_what_we_wrote() {
    let Some(programs) = environment() else { return };
    let devices = devices();
    let folder = write_all(&devices, "interop-python-canopen", &WriteOptions::default());
    let expected: Vec<_> = devices
        .iter()
        .map(|(name, description)| {
            let node_id = description.device().node_id().unwrap_or(5);
            let entries = expected_entries(description.device(), node_id);
            json!({ "file": name, "node_id": node_id, "entries": entries })
        })
        .collect();
    upload(programs, &folder, &expected);
}

/// Uploads the expected entries of descriptions in a folder.
fn upload(programs: &Path, folder: &Path, expected: &[serde_json::Value]) {
    fs::write(folder.join("expected.json"), serde_json::to_string(expected).unwrap()).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/read_back.py");
    let output = Command::new(programs.join("python")).arg(script).arg(folder).output().unwrap();
    assert!(output.status.success(), "{}", text_of(&output));
}

/// Prints node-ID and bit rate of each description whose path is on the standard input.
const NODE_AND_BIT_RATE: &str = "
import sys, canopen
for path in sys.stdin.read().splitlines():
    try:
        dictionary = canopen.import_od(path)
        print(dictionary.node_id, dictionary.bitrate)
    except Exception as error:
        print('refused', repr(error))
";

/// Spellings of a section with the node.
const SPELLINGS: [&str; 6] = [
    "[DeviceCommissioning]\r\nNodeID=3\r\nBaudRate=250\r\n",
    "[devicecomissioning]\r\nNodeId=$NODEID\r\nBAUDRATE=250 ; kbit/s\r\n",
    "[ DeviceComissioning ]\r\nNodeID=0x7D\r\nBaudrate=0x7D\r\n",
    "[DeviceComissioning]\r\nNodeID=010\r\nBaudrate=0125 ; kbit/s\r\n",
    "[DeviceComissioning]\r\nNodeid=5\r\nNodeID=9\r\nBaudRate=125\r\nBaudrate=250\r\n",
    "[DeviceComissioning]\r\nNodeName=pump\r\n",
];

/// A description becomes a DCF with the node-ID 5 and 125 kbit/s, also where it spells section, keys or numbers in other ways.
#[test]
fn python_canopen_finds_the_node_of_what_we_configured() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-node");
    fs::create_dir_all(&folder).unwrap();
    let node = Commissioning { node_id: Some(5), baud_rate: Some(125), ..Commissioning::default() };
    let mut paths = String::new();
    let mut written = |name: &str, eds: &Description| {
        let path = folder.join(name).with_extension("dcf");
        fs::write(&path, eds.to_node(name, &node).unwrap()).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(
            text.contains("LSS_SerialNumber"),
            eds.source().text().contains("LSS_SerialNumber"),
            "{name}"
        );
        paths += &format!("{}\n", path.display());
    };
    for (name, description) in devices() {
        if description.format().syntax() == format::Syntax::Ini {
            written(&name, &description);
        }
    }
    let eds = fs::read_to_string(support::fixtures().join("eds/io-401.eds")).unwrap();
    for (number, spelling) in SPELLINGS.iter().enumerate() {
        let source = SourceFile::from_text("node.dcf", format!("{spelling}\r\n{eds}"));
        written(&format!("node{number}.dcf"), &format::read(source, Format::Dcf));
    }
    let Some(programs) = environment() else { return };
    let mut python = Command::new(programs.join("python"));
    python
        .args(["-c", NODE_AND_BIT_RATE])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut python = python.spawn().unwrap();
    python.stdin.take().unwrap().write_all(paths.as_bytes()).unwrap();
    let output = python.wait_with_output().unwrap();
    let found = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", text_of(&output));
    assert_eq!(paths.lines().count(), found.lines().count());
    let mut read = 0;
    for (path, found) in paths.lines().zip(found.lines()) {
        // it refuses some fixtures as they are
        let may_be_refused = !path.contains("interop-node/node");
        if !found.starts_with("refused") || !may_be_refused {
            assert_eq!(found, "5 125000", "{path}");
            read += 1;
        }
    }
    assert!(read > SPELLINGS.len() + 5, "{found}");
}

/// What dcf-tools does not know, by file: the words that it refuses the file with.
const BEYOND_DCF_TOOLS: [(&str, &str); 5] = [
    ("all-types.eds", "unknown section in DCF: 40"),
    ("coupler-modular.eds", "unknown section in DCF: SupportedModules"),
    ("coupler-modular-node10.dcf", "unknown section in DCF: SupportedModules"),
    ("manager-302.eds", "unknown section in DCF: DynamicChannels"),
    ("manager-302-node1.dcf", "unknown section in DCF: DynamicChannels"),
];

#[test]
fn dcf_tools_accepts_what_we_wrote() {
    let Some(programs) = environment() else { return };
    let devices = devices();
    let mut options = WriteOptions::default();
    options.eds.real = RealSpelling::Hex;
    let folder = write_all(&devices, "interop-dcf-tools", &options);
    for (name, description) in &devices {
        let node_id = description.device().node_id().unwrap_or(5).to_string();
        let output = Command::new(programs.join("dcfchk"))
            .args(["-n", &node_id])
            .arg(folder.join(name))
            .output()
            .unwrap();
        let text = text_of(&output);
        match BEYOND_DCF_TOOLS.iter().find(|(file, _)| file == name) {
            None => assert!(output.status.success() && text.is_empty(), "{name}: {text}"),
            Some((_, words)) => assert!(text.contains(words), "{name}: not refused for `{words}`: {text}"),
        }
    }
}

/// The tools that a finding says refuse the file.
fn claims(findings: &Findings, tool: Tool) -> bool {
    let says_so = |text: &str| {
        text.split("; ").any(|part| {
            part.split_once(": the file is rejected")
                .is_some_and(|(tools, _)| tools.split(", ").any(|named| named == tool.name()))
        })
    };
    findings.iter().any(|finding| {
        says_so(&finding.message.shown()) || finding.help.as_ref().is_some_and(|help| says_so(&help.shown()))
    })
}

/// The bad fixtures of the rules whose findings say what other tools do, with all findings.
fn bad_fixtures() -> Vec<(PathBuf, Findings)> {
    let rules = support::fixtures().join("rules");
    let causes: BTreeSet<&str> = REACTIONS.iter().map(|reaction| reaction.rule).collect();
    let files = causes.iter().flat_map(|rule| fs::read_dir(rules.join(rule)).unwrap());
    let files = files.map(|file| file.unwrap().path());
    let is_bad = |path: &PathBuf| {
        path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("bad"))
            && path.extension().is_some_and(|ending| ending == "eds" || ending == "dcf")
    };
    let mut options = Options::default();
    options.tools.extend(Tool::ALL);
    let mut fixtures: Vec<_> = files
        .filter(is_bad)
        .map(|path| {
            let description = format::open(&path, &SourceOptions::default()).unwrap();
            let findings = objdict::check_with(&description, &options);
            (path, findings)
        })
        .collect();
    fixtures.sort_by(|(left, _), (right, _)| left.cmp(right));
    fixtures
}

/// What the tools read in files, an object for each: by the name of the tool its entries, or why it refuses the file. Without
/// npm, node-canopen is not among them.
fn readings(programs: &Path, paths: &[&Path]) -> Vec<serde_json::Value> {
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop");
    let mut python = Command::new(programs.join("python"));
    let mut answers = answers(python.arg(scripts.join("readings.py")), paths);
    if let Some(modules) = node_modules() {
        let mut node = Command::new("node");
        let more = self::answers(node.env("NODE_PATH", modules).arg(scripts.join("readings.js")), paths);
        for (answer, more) in answers.iter_mut().zip(more) {
            answer["node-canopen"] = more["node-canopen"].clone();
        }
    }
    answers
}

/// The lines of JSON that a script writes, one for each path.
fn answers(command: &mut Command, paths: &[&Path]) -> Vec<serde_json::Value> {
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let paths: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    child.stdin.take().unwrap().write_all(paths.join("\n").as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    let lines = String::from_utf8(output.stdout).unwrap();
    let answers: Vec<serde_json::Value> =
        lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(answers.len(), paths.len());
    answers
}

#[test]
fn tools_refuse_what_findings_say_they_refuse() {
    let Some(programs) = environment() else { return };
    let fixtures = bad_fixtures();
    let paths: Vec<&Path> = fixtures.iter().map(|(path, _)| path.as_path()).collect();
    let answers = readings(programs, &paths);
    let rules = support::fixtures().join("rules");
    let mut wrong = Vec::new();
    for ((path, findings), answer) in fixtures.iter().zip(&answers) {
        for tool in [Tool::DcfTools, Tool::PythonCanopen, Tool::NodeCanopen] {
            if answer[tool.name()].is_null() {
                continue;
            }
            let claimed = claims(findings, tool);
            let refusal = answer[tool.name()].as_str();
            let rule =
                path.parent().unwrap().strip_prefix(&rules).unwrap().to_string_lossy().replace('\\', "/");
            let may_refuse = REACTIONS.iter().any(|reaction| {
                reaction.rule == rule && reaction.effect == Effect::Refused && reaction.tools.contains(&tool)
            });
            // further consequences of a defect are not listed
            let is_surprise = rule.starts_with("portability/") && !may_refuse;
            if claimed && refusal.is_none() || is_surprise && refusal.is_some() {
                wrong.push(format!("{}: {tool}: claimed {claimed}, is {refusal:?}", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
