//! The output files, and known mistakes of generators for the stack.

use objdict::generate::{Options, Target, generate};
use objdict::model::Device;

use super::dump;
use crate::compile::c_compiler;
use crate::devices::device;
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

fn traps() -> Device {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("traps.eds");
    std::fs::write(&path, TRAPS.replace('\n', "\r\n")).unwrap();
    device(&path)
}

#[test]
fn nothing_falls_into_the_known_traps() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let (output, _) = dump(&compiler, folder.path(), &traps()).unwrap();
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

/// Problems that make the stack stop compilation or fail to start are warnings with a help text.
#[test]
fn what_the_stack_demands_is_a_warning() {
    let generated = generate(&traps(), Target::named("canopennode").unwrap(), &Options::default()).unwrap();
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
