//! The target `lely`.

#[cfg(feature = "full")]
mod boot;
mod hooks;
#[cfg(feature = "full")]
mod network;
mod real;

use std::path::Path;

use objdict::generate::{Note, Options, Target, generate};
use objdict::model::{DataType, Device, DeviceKind, TypeKind, Value};

use crate::compile::{c_compiler, cc, generate_with};
use crate::devices::{arbitrary_devices, device, devices, for_all};
use crate::oracle::facts_of;
use crate::processors::build;
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, for_node};

/// What the rows lack.
const LACKS: [Lack; 4] = [
    Lack {
        what: "arrays of any length",
        of: |row| is_array(row),
        instead: |row| Some(Row { size: None, ..row }),
    },
    Lack {
        what: "types of the device",
        of: |row| row.kind.is_none(),
        instead: |row| {
            let (data_type, size) = of_length(row.size.unwrap());
            Some(Row { data_type: Some(data_type.0), size, ..row })
        },
    },
    Lack { what: "256 entries", of: |row| row.sub == 0xFF && row.index == 0x3304, instead: |_| None },
    Lack {
        what: "UNICODE_STRINGs with a zero",
        of: |row| row.kind == Some(TypeKind::UnicodeString),
        instead: |row| {
            let characters = row.default.as_deref().unwrap_or_default().chunks(2);
            let default =
                characters.take_while(|character| character != b"\0\0").flatten().copied().collect();
            Some(Row { default: Some(default), ..row })
        },
    },
];

fn is_array(row: &Row) -> bool {
    use TypeKind::{Domain, OctetString, UnicodeString, VisibleString};
    matches!(row.kind, Some(VisibleString | OctetString | UnicodeString | Domain))
}

/// The type of the library with this length, and its size.
fn of_length(length: usize) -> (DataType, Option<usize>) {
    let numbers = DataType::STATIC
        .iter()
        .copied()
        .filter(|data_type| matches!(data_type.kind(), TypeKind::Unsigned(_)));
    let mut numbers = numbers.filter(|data_type| data_type.byte_length().map(usize::from) == Some(length));
    numbers.next().map_or((DataType::OCTET_STRING, None), |data_type| (data_type, Some(length)))
}

/// An EDS may have configured values too: they are values, not defaults.
#[test]
fn configured_values_are_no_defaults() {
    let mut device = device(&crate::support::fixtures().join("dcf/io-401-node5.dcf"));
    let mut of = |kind| {
        device.kind = kind;
        let generated = generate(&device, Target::named("lely").unwrap(), &for_node(5)).unwrap();
        String::from_utf8(generated.files[0].contents.clone()).unwrap()
    };
    let [node, of_type] = [DeviceKind::Node, DeviceKind::Type].map(&mut of);
    let defaults = |text: &str| {
        text.lines().filter(|line| line.contains("_DEFAULT(")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(defaults(&of_type), defaults(&node));
    assert!(of_type.contains("CO_OBJ_FLAGS_PARAMETER_VALUE"), "{of_type}");
}

/// A device without the files that the library transfers in place of values.
fn without_files(device: &Device) -> Device {
    let mut device = device.clone();
    for object in device.objects.values_mut() {
        let entries = object.subs.iter_mut().map(|(_, entry)| entry).chain([&mut object.main]);
        for configured in entries.filter_map(|entry| entry.configured.as_mut()) {
            (configured.upload_file, configured.download_file) = (None, None);
        }
    }
    device
}

fn write(folder: &Path, device: &Device, options: &Options) -> Vec<Note> {
    generate_with(folder, device, "lely", options).notes
}

/// The rows, with the flags of a configuration; with the argument `all`, details too.
fn with_flags(compiler: &str, folder: &Path, (device, node_id): (&Device, u8), flags: &[&str]) -> Harness {
    let notes = write(folder, device, &for_node(node_id));
    let mut cc = cc(compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("lely", "include").display())).args(flags);
    cc.args(["-DSDEV=od_sdev", "-o", "harness", "device_sdev.c"]);
    Harness { programs: build(cc.arg(beside("lely", "harness.c"))), arguments: Vec::new(), notes }
}

pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device, node_id: u8) -> Harness {
    with_flags(compiler, folder, (device, node_id), &[])
}

/// The limits of all integers, as the harness prints them: those of the description, else those of the type.
fn limits(device: &Device, node_id: u8) -> Vec<((u16, u8), String)> {
    let facts = facts_of(device).filter(|(at, facts)| facts.kind.is_some() && *at != (0x3304, 0xFF));
    let limits = facts.filter_map(|(at, facts)| {
        let range = facts.data_type.integer_range()?;
        let bytes = |limit: &Option<Value>, of_type: i128| {
            let value = limit.as_ref().and_then(|limit| limit.resolve(facts.data_type, node_id));
            let value = value.or_else(|| Value::from_integer(of_type, facts.data_type)).unwrap();
            crate::oracle::hex(&value.to_bytes(facts.data_type).unwrap())
        };
        let (low, high) = (bytes(&facts.low, range.0), bytes(&facts.high, range.1));
        Some((at, format!(" min={low} max={high} ")))
    });
    limits.collect()
}

#[test]
fn the_library_reads_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        for (node_id, flags) in [(5, [].as_slice()), (127, &WITHOUT)] {
            let fail = |error: String| format!("{name}, node {node_id}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let device = &without_files(device);
            let rows = without(&LACKS, truth(device, node_id));
            let harness = with_flags(&compiler, folder.path(), (device, node_id), flags);
            harness.check(&rows, |dump| compare(name, &rows, dump)).map_err(fail)?;
        }
        Ok(())
    });
}

/// A configuration of the library without the members that it can lack.
const WITHOUT: [&str; 3] =
    ["-DLELY_NO_CO_OBJ_NAME=1", "-DLELY_NO_CO_OBJ_LIMITS=1", "-DLELY_NO_CO_OBJ_DEFAULT=1"];

#[test]
fn every_integer_has_limits() {
    let Some(compiler) = c_compiler() else { return };
    let devices: Vec<_> = devices().into_iter().filter(|(name, _)| name != "words").collect();
    for_all(&devices, |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let limits = limits(device, 5);
        let compare = |dump: &str| {
            let mut lines = dump.lines();
            for ((index, sub), limits) in &limits {
                let start = format!("{index:04X} {sub:02X} ");
                let line = lines.find(|line| line.starts_with(&start)).unwrap_or("");
                if !line.contains(limits) {
                    return Err(format!("{name}: `{line}` has not{limits}"));
                }
            }
            Ok(())
        };
        harness(&compiler, folder.path(), device, 5).programs.check(&["all"], "", &limits, compare)
    });
}

/// A node with what only its configuration states.
const NODE: &str = "
[DeviceInfo]
VendorName=Example
VendorNumber=0x3F9
ProductName=Lamp \"one\"
BaudRate_10=1
BaudRate_1000=1
LSS_Supported=1
[DummyUsage]
Dummy0005=1
[DeviceComissioning]
NodeID=5
NodeName=Entrance
Baudrate=10
[ManufacturerObjects]
SupportedObjects=4
1=0x2000
2=0x2001
3=0x2002
4=0x2003
[2000]
ParameterName=COB-ID
Denotation=Lamp COB-ID
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x180
ParameterValue=0x181
HighLimit=$NODEID+0x200
ObjFlags=1
[2001]
ParameterName=Program
ObjectType=0x2
DataType=0x000F
AccessType=rw
UploadFile=lamp.bin
[2002]
ParameterName=Key
DataType=0x000A
AccessType=ro
DefaultValue=DEAD00EF
[2003]
ParameterName=Brightness
DataType=0x0008
AccessType=rw
PDOMapping=1
DefaultValue=1.5
";

#[test]
fn a_table_and_its_details() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("lamp.dcf"), NODE).unwrap();
    let device = device(&folder.path().join("lamp.dcf"));
    let notes =
        write(folder.path(), &device, &Options { file_stem: "lamp".to_owned(), ..Options::default() });
    assert_eq!(
        notes[0].to_string(),
        "0x2001sub0: the library transfers the file `lamp.bin` in place of a value"
    );
    assert_eq!(notes.len(), 1);
    let file = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    insta::assert_snapshot!(
        "lamp_sdev.c",
        file("lamp_sdev.c").replace(env!("CARGO_PKG_VERSION"), "[version]")
    );
    let Some(compiler) = c_compiler() else { return };
    let harness = harness(&compiler, folder.path(), &device, 5);
    insta::assert_snapshot!("lamp", harness.programs.run(&["all"], "").unwrap());
}

/// The library reads texts up to their zero.
#[test]
fn a_text_beyond_a_literal_has_room_for_its_zero() {
    let mut device = device(&crate::support::fixtures().join("eds/io-401.eds"));
    let text = "a".repeat(5000);
    device.objects.get_mut(&0x1008).unwrap().main.default = Some(Value::Text(text.into()));
    let files = generate(&device, Target::named("lely").unwrap(), &for_node(5)).unwrap().files;
    let room = "CO_DOMAIN_NC(co_unsigned8_t, 5001, ";
    assert!(files.iter().any(|file| String::from_utf8_lossy(&file.contents).contains(room)));
}
