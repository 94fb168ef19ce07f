//! The target `canopen-stack`.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Generated, Options, StorageGroup};
use objdict::model::{Access, Device, Value};

use crate::compile::{c_compiler, cc, generate_with, succeed};
use crate::devices::{arbitrary_devices, device, devices, for_all};
use crate::processors::build;
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, checkout, startup};
use crate::support;

/// The folders with the sources of the stack.
const FOLDERS: [&str; 7] =
    ["config", "core", "hal", "object/basic", "object/cia301", "service/cia301", "service/cia305"];

/// Data missing in the rows of the stack.
const LACKS: [Lack; 5] = [
    Lack { what: "no data types", of: |_| true, instead: |row| Some(Row { data_type: None, ..row }) },
    Lack {
        what: "one flag for mapping in both directions",
        of: |row| row.tpdo || row.rpdo,
        instead: |row| Some(Row { tpdo: row.read, rpdo: row.write, ..row }),
    },
    Lack {
        what: "an error history that is empty at start",
        of: |row| row.index == 0x1003 && row.sub > 0 && row.data_type.is_none() && row.size == Some(4),
        instead: |row| Some(Row { default: None, ..row }),
    },
    Lack {
        what: "1011h reads as 1 or 0",
        of: |row| row.index == 0x1011 && row.sub > 0 && row.size == Some(4),
        instead: |row| {
            let any = row.default.as_ref().is_some_and(|bytes| bytes.iter().any(|&byte| byte != 0));
            Some(Row { default: Some(vec![u8::from(any), 0, 0, 0]), ..row })
        },
    },
    Lack {
        what: "heartbeat consumers of 24 bits",
        of: |row| row.index == 0x1016 && row.sub > 0 && row.size == Some(4),
        instead: |row| {
            let default = row.default.map(|bytes| [&bytes[..3], &[0]].concat());
            Some(Row { default, ..row })
        },
    },
];

pub(crate) fn options(node_id: u8, grouped: bool) -> Options {
    let mut options = Options::default();
    options.node_id = Some(node_id);
    options.file_stem = "device".to_owned();
    if grouped {
        let group = |text: &str| text.parse::<StorageGroup>().unwrap();
        options.groups = vec![group("1000-1FFF=COMM"), group("2000-9FFF=APP"), group("2100=ram")];
    }
    options
}

fn write(folder: &Path, device: &Device, options: &Options) -> Generated {
    generate_with(folder, device, "canopen-stack", options)
}

/// The expected rows of the stack; without 1200h, its default one.
fn expected(device: &Device, node_id: u8) -> Vec<Row> {
    let mut rows = without(&LACKS, truth(device, node_id));
    if !rows.iter().any(|row| row.index == 0x1200) {
        for (sub, base) in [(0, 2_u16), (1, 0x600), (2, 0x580)] {
            let size = if sub == 0 { 1 } else { 4 };
            let value = u32::from(base) + if sub == 0 { 0 } else { u32::from(node_id) };
            let default = Some(value.to_le_bytes()[..size].to_vec());
            let row =
                Row { index: 0x1200, sub, data_type: None, kind: None, size: Some(size), default, ..rows[0] };
            rows.push(Row { read: true, write: false, tpdo: false, rpdo: false, ..row });
        }
        rows.sort_by_key(|row| (row.index, row.sub));
    }
    rows
}

/// The entries found by the stack.
pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device, options: &Options) -> Harness {
    let notes = write(folder, device, options).notes;
    let mut cc = cc(compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("canopen_stack", "include").display()));
    cc.args(["-DDICTIONARY=\"device_od.h\"", "-o", "harness", "device_od.c", "device_od_spec.c"]);
    cc.args((!options.hooks.is_empty()).then(|| beside("canopen_stack", "hooks.c")));
    let programs = build(cc.arg(beside("canopen_stack", "harness.c")));
    Harness { programs, arguments: Vec::new(), notes }
}

#[test]
fn the_stack_reads_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    let devices = [devices(), arbitrary_devices(12)].concat();
    for_all(&devices, |(name, device)| {
        for (node_id, grouped) in [(5, false), (127, true)] {
            let fail = |error: String| format!("{name}, node {node_id}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let options = options(node_id, grouped);
            let rows = expected(device, node_id);
            let harness = harness(&compiler, folder.path(), device, &options);
            harness.check(&rows, |dump| compare(name, &rows, dump)).map_err(fail)?;
        }
        Ok(())
    });
}

/// The folders with the sources of a checkout.
fn folders(stack: &Path) -> Vec<PathBuf> {
    FOLDERS.iter().map(|folder| stack.join("src").join(folder)).collect()
}

/// `OBJDICT_CANOPEN_STACK_DIR` names a checkout of the stack.
#[test]
fn the_headers_of_the_real_stack_take_the_files() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPEN_STACK_DIR"), c_compiler()) else { return };
    let folders = folders(&stack);
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        write(folder.path(), device, &options(5, true));
        let mut cc = cc(&compiler, folder.path());
        for folder in &folders {
            cc.arg("-isystem").arg(folder);
        }
        cc.args(["-DCO_RPDO_N=512", "-DCO_TPDO_N=512", "-DCO_SSDO_N=128", "-DCO_CSDO_N=128"]);
        cc.args(["-fsyntax-only", "device_od.c", "device_od_spec.c"]);
        succeed(&mut cc, "").map_err(|error| format!("{name}: {error}")).map(drop)
    });
}

/// The same checkout: what the stack does not serve when it starts is what the notes predict.
#[test]
fn the_real_stack_starts_as_the_notes_predict() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPEN_STACK_DIR"), c_compiler()) else { return };
    let folders = folders(&stack);
    let sources = |folder: &PathBuf| folder.read_dir().unwrap().map(|entry| entry.unwrap().path());
    let is_source = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "c");
    let sources: Vec<PathBuf> = folders.iter().flat_map(sources).filter(is_source).collect();
    let real = |folder: &Path| {
        let mut cc = Command::new(&compiler);
        cc.current_dir(folder).args(["-std=gnu99", "-w", "-I."]);
        cc.args(folders.iter().map(|folder| format!("-I{}", folder.display())));
        cc.args(["-DCO_RPDO_N=255", "-DCO_TPDO_N=255", "-DCO_SSDO_N=128", "-DCO_CSDO_N=128"]);
        cc
    };
    let objects = tempfile::tempdir().unwrap();
    succeed(real(objects.path()).arg("-c").args(&sources), "").unwrap();
    let objects: Vec<PathBuf> =
        objects.path().read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    let (started, found) = (AtomicUsize::new(0), AtomicUsize::new(0));
    for_all(&devices(), |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let notes = write(folder.path(), device, &options(5, false)).notes;
        if startup::is_undefined(&notes) {
            return Ok(());
        }
        let mut cc = real(folder.path());
        cc.args(["-DDICTIONARY=\"device_od.h\"", "-o", "node", "device_od.c", "device_od_spec.c"]);
        succeed(cc.arg(beside("canopen_stack", "node.c")).args(&objects), "").map_err(fail)?;
        let printed = succeed(&mut Command::new(folder.path().join("node")), "").map_err(fail)?;
        found.fetch_add(startup::compare(device, &notes, &printed).map_err(fail)?, Ordering::Relaxed);
        started.fetch_add(1, Ordering::Relaxed);
        Ok(())
    });
    eprintln!("canopen-stack: {started:?} nodes started, {found:?} predictions");
}

/// A number, numbers, a text and a heartbeat.
const HOOKED: &str = "
[MandatoryObjects]
SupportedObjects=3
1=0x1000
2=0x1001
3=0x1018
[OptionalObjects]
SupportedObjects=2
1=0x1014
2=0x1017
[ManufacturerObjects]
SupportedObjects=3
1=0x2101
2=0x2102
3=0x2103
[1000]
ParameterName=Device type
DataType=0x0007
AccessType=ro
[1001]
ParameterName=Error register
DataType=0x0005
AccessType=ro
[1014]
ParameterName=COB-ID EMCY
DataType=0x0007
AccessType=ro
DefaultValue=$NODEID+0x80
[1017]
ParameterName=Producer heartbeat time
DataType=0x0006
AccessType=rw
[1018]
ParameterName=Identity object
ObjectType=0x9
DataType=0x0007
AccessType=ro
CompactSubObj=4
[2101]
ParameterName=Speed
DataType=0x0003
AccessType=rw
DefaultValue=0x100
[2102]
ParameterName=Levels
ObjectType=0x8
DataType=0x0003
AccessType=rw
DefaultValue=0x200
CompactSubObj=2
[2103]
ParameterName=Label
DataType=0x0009
AccessType=rw
DefaultValue=abc
";

#[test]
fn hooks_answer_uploads_and_refuse_downloads() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("hooked.eds"), HOOKED).unwrap();
    let device = device(&folder.join("hooked.eds"));
    let mut options = options(5, false);
    options.hooks = ["1017", "2101", "2102:1", "2103", "7000"].map(|at| at.parse().unwrap()).into();
    let harness = harness(&compiler, folder, &device, &options);
    let (dump, notes) = (harness.dump().unwrap(), &harness.notes);
    let hooks = notes.iter().filter(|note| note.message.contains("hook")).map(|note| &*note.message);
    let of_stack = "the stack has its own type for the entry, so there is no hook";
    assert_eq!(hooks.collect::<Vec<_>>(), ["no entry to call a hook for", of_stack]);
    let lines: Vec<&str> = dump.lines().filter(|line| line.starts_with("210")).collect();
    let expected = [
        "2101 00 - 2 rw-- 5A01",
        "2102 00 - 1 r--- 02",
        "2102 01 - 2 rw-- 5A02",
        "2102 02 - 2 rw-- 0002",
        "2103 00 - 32 rw-- 5A6263",
    ];
    assert_eq!(lines, expected);
    let Some(stack) = checkout("OBJDICT_CANOPEN_STACK_DIR") else { return };
    let mut cc = std::process::Command::new(&compiler);
    cc.current_dir(folder).args(["-std=gnu99", "-w", "-I.", "-DDICTIONARY=\"device_od.h\"", "-o", "node"]);
    for folder in folders(&stack) {
        let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
        cc.arg("-I")
            .arg(folder)
            .args(files.filter(|path| path.extension().is_some_and(|extension| extension == "c")));
    }
    cc.args(["device_od.c", "device_od_spec.c"])
        .args(["asked.c", "hooks.c"].map(|name| beside("canopen_stack", name)));
    succeed(&mut cc, "").unwrap();
    let requests =
        ["4001210000000000", "2B012100FF000000", "2B01210001020000", "4001210000000000", "4003210000000000"];
    let responses = succeed(std::process::Command::new(folder.join("node")).args(requests), "").unwrap();
    let expected =
        ["4B0121005A010000", "8001210030000906", "6001210000000000", "4B0121005A020000", "470321005A626300"];
    assert_eq!(responses.lines().collect::<Vec<_>>(), expected);
}

#[test]
fn a_server_without_a_valid_cob_id_is_a_warning() {
    let text = std::fs::read_to_string(support::fixtures().join("eds/io-401.eds")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let warnings = |text: &str| {
        let path = folder.path().join("device.eds");
        std::fs::write(&path, text).unwrap();
        let notes = write(folder.path(), &device(&path), &Options::default()).notes;
        notes.iter().filter(|note| note.message.contains("so the stack has no SDO server")).count()
    };
    assert!(text.contains("DefaultValue=$NODEID+0x600"));
    assert_eq!(warnings(&text), 0);
    let off = text.replace("$NODEID+0x600", "0x80000000").replace("$NODEID+0x580", "0x80000000");
    assert_eq!(warnings(&off), 1, "one note for both COB-IDs");
}

/// The stack takes a `Data` field of 0 for a missing address.
#[test]
fn a_constant_heartbeat_time_of_0_has_an_address() {
    let mut device = device(&support::fixtures().join("eds/io-401.eds"));
    let heartbeat = &mut device.objects.get_mut(&0x1017).unwrap().main;
    (heartbeat.access, heartbeat.default) = (Some(Access::Const), Some(Value::Unsigned(0)));
    let folder = tempfile::tempdir().unwrap();
    let files = write(folder.path(), &device, &Options::default()).files;
    let texts = files.iter().map(|file| String::from_utf8_lossy(&file.contents));
    let lines: Vec<String> = texts
        .flat_map(|text| {
            text.lines().filter(|line| line.contains("CO_THB_PROD")).map(str::to_owned).collect::<Vec<_>>()
        })
        .collect();
    assert!(lines.len() == 1 && lines[0].contains('&'), "{lines:#?}");
}
