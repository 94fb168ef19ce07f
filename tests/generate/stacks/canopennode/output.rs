//! The output files, and known mistakes of generators for the stack.

use objdict::diagnostic::Severity;
use objdict::generate::{Options, StackLayout, Target, generate};
use objdict::model::{Access, DataType, Device, ObjectType, Value};

use super::{generate_into, harness, with_declarations};
use crate::compile::c_compiler;
use crate::devices::device;
use crate::odd::{entry, of_type, var};
use crate::processors::build;
use crate::stacks::beside;
use crate::support::fixtures;

#[test]
fn the_files_of_a_small_device() {
    let sensors = device(&fixtures().join("eds/dspic-sensors.eds"));
    let generated = generate(&sensors, Target::named("canopennode").unwrap(), &Options::default()).unwrap();
    let version = concat!("objdict ", env!("CARGO_PKG_VERSION"));
    for file in &generated.files {
        let text = std::str::from_utf8(&file.contents).unwrap().replace(version, "objdict [version]");
        insta::assert_snapshot!(file.path.clone(), text);
    }
}

/// Texts with backslashes, a REAL as its bits, a negative 24-bit number, two record members with the same
/// name, and a COB-ID that the stack does not compute.
const TRAPS: &str = "\
[DeviceInfo]
VendorName=Traps
[MandatoryObjects]
SupportedObjects=0
[ManufacturerObjects]
SupportedObjects=5
1=0x2000
2=0x2001
3=0x2002
4=0x2003
5=0x2004
[2000]
ParameterName=Path
ObjectType=7
DataType=9
AccessType=const
DefaultValue=C:\\new\\
[2001]
ParameterName=Gain
ObjectType=7
DataType=8
AccessType=rw
DefaultValue=0x3FC00000
[2002]
ParameterName=Offset
ObjectType=7
DataType=0x10
AccessType=rw
DefaultValue=-3
[2003]
ParameterName=Axis
ObjectType=9
SubNumber=3
[2003sub0]
ParameterName=Highest sub-index supported
ObjectType=7
DataType=5
AccessType=const
DefaultValue=2
[2003sub1]
ParameterName=Mode
ObjectType=7
DataType=5
AccessType=rw
DefaultValue=1
[2003sub2]
ParameterName=Mode
ObjectType=7
DataType=5
AccessType=rw
DefaultValue=2
[2004]
ParameterName=Custom COB-ID
ObjectType=7
DataType=7
AccessType=rw
DefaultValue=$NODEID+0x680
";

fn described(text: &str) -> Device {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("device.eds");
    std::fs::write(&path, text.replace('\n', "\r\n")).unwrap();
    device(&path)
}

#[test]
fn nothing_falls_into_the_known_traps() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let output = harness(&compiler, folder.path(), &described(TRAPS), &Options::default()).dump().unwrap();
    let value = |address: &str| {
        let line = output.lines().find(|line| line.starts_with(address)).unwrap();
        line.rsplit(' ').next().unwrap().to_owned()
    };
    assert_eq!(value("2000 00"), "433A5C6E65775C"); // C:\new\ without anything after it
    assert_eq!(value("2001 00"), "0000C03F"); // 1.5, not 1069547520
    assert_eq!(value("2002 00"), "FDFFFF");
    assert_eq!((value("2003 01"), value("2003 02")), ("01".to_owned(), "02".to_owned()));
    assert_eq!(value("2004 00"), "85060000"); // for node 5
    let header = std::fs::read_to_string(folder.path().join("OD.h")).unwrap();
    assert!(header.contains("uint8_t mode;") && header.contains("uint8_t mode_02;"), "{header}");
    let source = std::fs::read_to_string(folder.path().join("OD.c")).unwrap();
    assert!(source.contains("1.5f"), "{source}");
    let apply = source.split("void OD_applyNodeId(uint8_t nodeId)\n").nth(1).unwrap();
    assert!(apply.split("\n}").next().unwrap().contains("x2004_customCOB_ID"), "{apply}");
}

/// What CANopenEditor gives no storage: entries without a default. An element with a default gives it to all.
const HALF_EMPTY: &str = "\
[DeviceInfo]
VendorName=Halves
[MandatoryObjects]
SupportedObjects=0
[ManufacturerObjects]
SupportedObjects=7
1=0x1017
2=0x2000
3=0x2001
4=0x2002
5=0x2003
6=0x2004
7=0x2005
[1017]
ParameterName=Producer heartbeat time
DataType=6
AccessType=rw
[2000]
ParameterName=Cell 1 Temp
DataType=6
AccessType=rw
DefaultValue=7
[2001]
ParameterName=Serial text
DataType=9
AccessType=rw
DefaultValue=abcd
[2002]
ParameterName=Levels
ObjectType=8
DataType=5
AccessType=rw
CompactSubObj=2
[2002Value]
NrOfEntries=1
2=9
[2003]
ParameterName=Axis
ObjectType=9
SubNumber=2
[2003sub0]
ParameterName=Highest sub-index supported
DataType=5
AccessType=const
DefaultValue=1
[2003sub1]
ParameterName=Mode
DataType=5
AccessType=rw
[2004]
ParameterName=Label
DataType=9
AccessType=rw
[2005]
ParameterName=Version
DataType=9
AccessType=ro
";

#[test]
fn the_layout_of_canopeneditor_has_no_storage_for_what_has_no_default() {
    let Some(compiler) = c_compiler() else { return };
    let device = described(HALF_EMPTY);
    let dump = |layout| {
        let folder = tempfile::tempdir().unwrap();
        let mut options = Options::default();
        options.layout = layout;
        let output = harness(&compiler, folder.path(), &device, &options).dump().unwrap();
        (output, std::fs::read_to_string(folder.path().join("OD.h")).unwrap())
    };
    let (output, header) = dump(StackLayout::CanOpenEditor);
    let lines = [
        "1017 00 - 2 rw-- -",
        "2000 00 - 2 rw-- 0700",
        "2001 00 - 4 rw-- 61626364",
        "2002 00 - 1 r--- 02",
        "2002 01 - 1 rw-- 00",
        "2002 02 - 1 rw-- 09",
        "2003 00 - 1 r--- 01",
        "2003 01 - 1 rw-- -",
        "2004 00 - 0 rw-- -",
        "2005 00 - 0 r--- -",
    ];
    assert_eq!(output.lines().collect::<Vec<_>>(), lines);
    assert!(header.contains("uint16_t x2000_cell1Temp;") && header.contains("char x2001_serialText[5];"));
    assert!(!header.contains("PERSIST_COMM") && !header.contains("uint16_t x1017"), "{header}");
    let (old, header) = dump(StackLayout::CanOpenEditor2020);
    assert_eq!(old, output);
    assert!(header.contains("uint16_t x2000_cell_1_Temp;"), "{header}");
    let (complete, _) = dump(StackLayout::Complete);
    assert!(
        complete.contains("1017 00 - 2 rw-- 0000\n") && complete.contains("2001 00 - 32 rw-- 61626364\n")
    );
}

/// Hooks that let the tables hold the value, except for one number.
const HOOKS: &str = r#"
#include "301/CO_ODinterface.h"
#include "OD.h"
#include <string.h>

ODR_t OD_read_H6040(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead)
{
    return OD_readOriginal(stream, buf, count, countRead);
}

ODR_t OD_write_H6040(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{
    uint16_t value;
    memcpy(&value, buf, sizeof value);
    return value == 0x80 && stream->object != NULL ? ODR_INVALID_VALUE : OD_writeLimited(stream, buf, count, countWritten);
}
"#;

#[test]
fn a_hook_answers_writes() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut options = Options::default();
    options.limits = true;
    options.hooks = ["6040", "1017", "7000"].map(|at| at.parse().unwrap()).into();
    let drive = device(&fixtures().join("eds/drive-402.eds"));
    let notes = generate_into(folder.path(), &drive, &options);
    let hooks: Vec<_> =
        notes.iter().filter(|note| note.message.contains("hook")).map(|note| &*note.message).collect();
    assert_eq!(
        hooks,
        ["the stack has its own extension of the object, so there is no hook", "no entry to call a hook for"]
    );
    std::fs::write(folder.path().join("hooks.c"), HOOKS).unwrap();
    let mut cc = with_declarations(&compiler, folder.path());
    cc.args(["-DWITH_LIMITS", "-DWITH_HOOKS", "-o", "harness", "OD.c", "hooks.c"])
        .arg(beside("canopennode", "harness.c"));
    let input = "6040 00 8000\n6040 00 0F00\n6060 00 80\n";
    let output = build(&cc).run(&["write", "5"], input).unwrap();
    assert_eq!(output.lines().take(2).collect::<Vec<_>>(), ["06090030", "00000000"]);
}

/// Problems that make the stack stop compilation or fail to start are warnings with a help text.
#[test]
fn what_the_stack_demands_is_a_warning() {
    let generated =
        generate(&described(TRAPS), Target::named("canopennode").unwrap(), &Options::default()).unwrap();
    let warnings: Vec<_> = generated
        .notes
        .iter()
        .filter(|note| note.severity == objdict::diagnostic::Severity::Warning)
        .collect();
    for index in ["1000h", "1001h", "1003h", "1014h", "1017h"] {
        let text = format!("{index} is missing");
        let warning = warnings.iter().find(|note| note.message.starts_with(&text));
        assert!(warning.is_some_and(|note| note.help.is_some()), "{index}: {warnings:?}");
    }
}

/// Entries that the stack reads when it starts: index, sub-index, another type, and whether it does not start then.
const SHAPES: &[(u16, u8, DataType, bool)] = &[
    (0x1001, 0, DataType::UNSIGNED16, true),
    (0x1003, 1, DataType::UNSIGNED16, false),
    (0x1005, 0, DataType::UNSIGNED16, true),
    (0x1006, 0, DataType::UNSIGNED16, true),
    (0x1007, 0, DataType::VISIBLE_STRING, true),
    (0x1010, 1, DataType::UNSIGNED8, false),
    (0x1012, 0, DataType::UNSIGNED16, true),
    (0x1014, 0, DataType::VISIBLE_STRING, true),
    (0x1015, 0, DataType::UNSIGNED32, false),
    (0x1016, 1, DataType::UNSIGNED16, true),
    (0x1017, 0, DataType::UNSIGNED32, true),
    (0x1019, 0, DataType::UNSIGNED32, true),
    (0x1200, 1, DataType::UNSIGNED16, false),
    (0x1201, 1, DataType::VISIBLE_STRING, true),
    (0x1201, 2, DataType::DOMAIN, true),
    (0x1280, 1, DataType::UNSIGNED16, false),
    (0x1400, 1, DataType::UNSIGNED16, true),
    (0x1400, 2, DataType::UNSIGNED16, true),
    (0x1600, 0, DataType::UNSIGNED16, true),
    (0x1600, 1, DataType::UNSIGNED16, true),
    (0x1800, 1, DataType::OCTET_STRING, true),
    (0x1800, 2, DataType::UNSIGNED16, true),
    (0x1800, 3, DataType::UNSIGNED32, false),
    (0x1800, 5, DataType::UNSIGNED32, false),
    (0x1A00, 0, DataType::UNSIGNED16, true),
    (0x1A00, 1, DataType::UNSIGNED16, true),
];

/// Devices for the stack, each with an entry of another type, and whether it does not start then; first one with the right types, and
/// two whose sub-indexes are others.
pub(super) fn shapes() -> Vec<(String, Device, bool)> {
    let mut right = device(&fixtures().join("eds/io-401.eds"));
    let mut value = |index, data_type| {
        right.objects.insert(index, var(entry("Value", data_type, Access::Rw, Some(Value::Unsigned(0)))));
    };
    let (byte, long) = (DataType::UNSIGNED8, DataType::UNSIGNED32);
    [0x1005, 0x1006, 0x1007, 0x1012].into_iter().for_each(|index| value(index, long));
    value(0x1019, byte);
    for (index, highest) in [(0x1201, 2), (0x1280, 3)] {
        let types = [byte, long, long, byte].into_iter().zip(0..=highest);
        let default = |sub| Value::Unsigned(if sub == 0 { u64::from(highest) } else { 0 });
        let subs =
            types.map(|(data_type, sub)| (sub, entry("Value", data_type, Access::Rw, Some(default(sub)))));
        right.objects.insert(index, of_type(ObjectType::Record, "SDO", subs));
    }
    let mut all = vec![("right".to_owned(), right.clone(), false)];
    for &(index, sub, data_type, stops) in SHAPES {
        let mut other = right.clone();
        let object = other.objects.get_mut(&index).unwrap();
        let wrong = object.subs.iter_mut().find(|(at, _)| *at == sub).map(|(_, entry)| entry);
        let wrong = wrong.unwrap_or(&mut object.main);
        (wrong.data_type, wrong.default) = (Some(data_type), None);
        (wrong.low_limit, wrong.high_limit) = (None, None);
        all.push((format!("{index:04X}h:{sub:02X}"), other, stops));
    }
    let mut gap = right.clone();
    let consumers = gap.objects.get_mut(&0x1016).unwrap();
    let second = consumers.subs.remove(2).unwrap();
    consumers.subs.insert(3, second);
    all.push(("1016h with a gap".to_owned(), gap, true));
    let mut highest = right;
    let server = highest.objects.get_mut(&0x1201).unwrap();
    server.subs.iter_mut().next().unwrap().1.default = Some(Value::Unsigned(4));
    all.push(("1201h with 4".to_owned(), highest, true));
    all
}

#[test]
fn shapes_that_stop_the_start_are_errors() {
    for (name, device, stops) in shapes() {
        let notes = generate(&device, Target::CANOPENNODE, &Options::default()).unwrap().notes;
        let errors: Vec<_> = notes.iter().filter(|note| note.severity == Severity::Error).collect();
        assert_eq!(errors.len(), usize::from(stops), "{name}: {errors:#?}");
        assert!(errors.iter().all(|error| error.help.is_some() && error.message.contains("does not start")));
    }
    // with the layout of the editor, an entry without a default has no memory
    let mut device = device(&fixtures().join("eds/io-401.eds"));
    device.objects.get_mut(&0x1017).unwrap().main.default = None;
    let options = Options { layout: StackLayout::CanOpenEditor, ..Options::default() };
    let notes = generate(&device, Target::CANOPENNODE, &options).unwrap().notes;
    let errors: Vec<String> =
        notes.iter().filter(|note| note.severity == Severity::Error).map(ToString::to_string).collect();
    assert!(errors.iter().any(|error| error.starts_with("0x1017")), "{errors:?}");
}
