//! CANopenEditor opens what is written for it: its readers are compiled of a checkout that `OBJDICT_CANOPENEDITOR_DIR` names.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use objdict::format::{self, Dialect, Format, WriteOptions, XddVersion};
use objdict::model::DeviceKind;

use super::dialects::all_devices;
use crate::support;
use crate::support::skips::{has, skip};

/// The readers of EDS, DCF, XDD and XDC.
const SOURCES: [&str; 10] = [
    "CanOpenEDS",
    "CanOpenXDD",
    "CanOpenXSD_1_0",
    "CanOpenXSD_1_1",
    "Filetypes",
    "IFileExporter",
    "StringUnescape",
    "Warnings",
    "eds",
    "extensions",
];

/// What only the project format of the editor needs, and what that needs of packages.
const OF_PROTOBUF: [&str; 6] =
    ["OdSubObject", "OdObject", "CanOpenDevice", "LibCanOpen", "Timestamp", "Protobuf"];

/// The reader of XDD 1.1 without the members about protobuf.
fn without_protobuf(source: &str) -> String {
    let lines: Vec<&str> = source.trim_start_matches('\u{FEFF}').lines().collect();
    let mut text = String::new();
    let mut at = 0;
    while let Some(line) = lines.get(at) {
        let is_member = ["        private ", "        public "].iter().any(|start| line.starts_with(start))
            && line.contains('(')
            && !line.trim_end().ends_with(';');
        let length = match is_member {
            true => lines[at..].iter().position(|line| *line == "        }").map_or(1, |end| end + 1),
            false => 1,
        };
        let block = lines[at..at + length].join("\n");
        let is_import = line.starts_with("using LibCanOpen") || line.starts_with("using Google");
        if block.contains("GetExporters") {
            text += "public ExporterDescriptor[] GetExporters() { return new ExporterDescriptor[0]; }\n";
        } else if !(is_import || is_member && OF_PROTOBUF.iter().any(|word| block.contains(word))) {
            text += &format!("{block}\n");
        }
        at += length;
    }
    text
}

/// The program that opens files, compiled; `None` without a checkout or a compiler.
fn editor() -> Option<PathBuf> {
    let Some(checkout) = std::env::var_os("OBJDICT_CANOPENEDITOR_DIR").map(PathBuf::from) else {
        skip("`OBJDICT_CANOPENEDITOR_DIR` names no checkout");
        return None;
    };
    if !has("mcs", "mono-mcs") || !has("mono", "mono-runtime") {
        return None;
    }
    let library = checkout.join("libEDSsharp");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-editor");
    fs::create_dir_all(&folder).unwrap();
    let xdd = fs::read_to_string(library.join("CanOpenXDD_1_1.cs")).unwrap();
    fs::write(folder.join("CanOpenXDD_1_1.cs"), without_protobuf(&xdd)).unwrap();
    let program = folder.join("editor.exe");
    let mut compiler = Command::new("mcs");
    compiler
        .args(["-langversion:latest", "-warn:0", "-r:System.Xml,System.Core,System.Web"])
        .arg(format!("-out:{}", program.display()))
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/editor.cs"))
        .arg(folder.join("CanOpenXDD_1_1.cs"))
        .args(SOURCES.iter().chain(&["PDOHelper"]).map(|name| library.join(name).with_extension("cs")));
    support::run(&mut compiler).unwrap_or_else(|error| panic!("{error}"));
    Some(program)
}

/// Writes all devices as the editor is to read them, and gives the paths.
fn written() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-editor-files");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let dialects = [Dialect::CanOpenEditor, Dialect::Portable];
    let dialects =
        dialects.map(|dialect| (WriteOptions::from(dialect), [Format::Eds, Format::Dcf], dialect.name()));
    let of_xdd = [XddVersion::V1_0, XddVersion::V1_1].map(|version| {
        let mut options = WriteOptions::default();
        options.xdd_version = version;
        (options, [Format::Xdd, Format::Xdc], version.name())
    });
    let mut paths = Vec::new();
    for (name, device) in all_devices() {
        for (options, [of_type, of_node], version) in of_xdd.iter().chain(&dialects) {
            let mut options = options.clone();
            options.embed = true;
            let format = if device.kind == DeviceKind::Type { *of_type } else { *of_node };
            let path = folder.join(format!("{name}-{version}.{}", format.name().to_lowercase()));
            fs::write(&path, format::write(&device, format, &options).unwrap().bytes).unwrap();
            paths.push(path);
        }
    }
    paths
}

#[test]
fn canopeneditor_opens_its_dialects_and_xdd() {
    let Some(program) = editor() else { return };
    let paths = written();
    let mut mono = Command::new("mono");
    let mut mono = mono.arg(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let list: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let mut input = mono.stdin.take().unwrap();
    let writer = std::thread::spawn(move || input.write_all((list.join("\n") + "\n").as_bytes()));
    let output = mono.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    let answers = String::from_utf8_lossy(&output.stdout).into_owned();
    let refused: Vec<&str> = answers.lines().filter(|line| !line.ends_with("\topened")).collect();
    assert!(refused.is_empty(), "{}", refused.join("\n"));
    assert_eq!(answers.lines().count(), paths.len());
    println!("CANopenEditor opened {} files", paths.len());
}
