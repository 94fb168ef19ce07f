//! The target `canopennode-v1`.

use std::collections::HashSet;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Note, Options, StackLayout, Target, generate};
use objdict::model::{Device, Value};

use crate::compile::{c_compiler, cc, generate_with, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::processors::{build, host};
use crate::stacks::canfestival::address;
use crate::stacks::canopennode::{NODE_ID, predefined};
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, checkout, startup};

/// What the rows lack.
const LACKS: &[Lack] = &[
    Lack { what: "no data types", of: |_| true, instead: |row| Some(Row { data_type: None, ..row }) },
    Lack {
        what: "one length",
        of: |_| true,
        instead: |mut row| {
            if let (Some(default), Some(size)) = (&mut row.default, row.size) {
                default.resize(size, 0);
            }
            Some(row)
        },
    },
    Lack {
        what: "COB-IDs without a node-ID are those of the pre-defined connection set",
        of: |row| row.index != 0x1014 && predefined(row).is_some(),
        instead: |row| Some(Row { default: predefined(&row), ..row }),
    },
    Lack {
        what: "the stack counts errors itself",
        of: |row| (row.index, row.sub) == (0x1003, 0),
        instead: |_| None,
    },
];

/// The expected entries. The stack adds the node-ID to a fixed number in 1014h, too; that of this node is stored without it.
fn expected(device: &Device) -> Vec<Row> {
    let mut rows = without(LACKS, truth(device, NODE_ID));
    let lists: HashSet<u16> = rows.iter().filter(|row| row.sub > 0).map(|row| row.index).collect();
    for row in rows.iter_mut().filter(|row| row.sub == 0 && lists.contains(&row.index)) {
        (row.tpdo, row.rpdo) = (false, false); // of an array, it is mapped as its elements
    }
    let value = device.entry(0x1014, 0).and_then(|entry| entry.value().cloned());
    for row in rows.iter_mut().filter(|row| (row.index, row.sub, row.size) == (0x1014, 0, Some(4))) {
        let bytes = row.default.as_deref().and_then(|bytes| bytes.try_into().ok());
        let added = bytes.map(|bytes| u32::from_le_bytes(bytes).wrapping_add(u32::from(NODE_ID)));
        let is_of_node = added.is_some_and(|added| added & 0x7FF == 0x80 + 2 * u32::from(NODE_ID));
        if let (Some(added), false) = (added, is_of_node || matches!(value, Some(Value::NodeId(_)))) {
            row.default = Some(added.to_le_bytes().to_vec());
        }
    }
    rows
}

fn write(folder: &Path, device: &Device, options: &Options) -> Vec<Note> {
    generate_with(folder, device, "canopennode-v1", options).notes
}

/// The entries, with the number of errors.
pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device) -> Harness {
    let mut options = Options::default();
    options.node_id = Some(NODE_ID);
    let notes = write(folder, device, &options);
    let mut cc = cc(compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("canopennode_v1", "include").display()));
    cc.args(["-o", "harness", "CO_OD.c"]).arg(beside("canopennode_v1", "harness.c"));
    Harness { programs: build(&cc), arguments: vec![NODE_ID.to_string()], notes }
}

/// The entries without the number of errors.
pub(crate) fn without_count(dump: &str) -> String {
    let lines = dump.lines().filter(|line| !line.starts_with("1003 00 "));
    lines.map(|line| format!("{line}\n")).collect()
}

#[test]
fn the_tables_have_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let rows = expected(device);
        let harness = harness(&compiler, folder.path(), device);
        harness.check(&rows, |dump| compare(name, &rows, &without_count(dump))).map_err(fail)
    });
}

#[test]
fn the_files_of_a_small_device() {
    let device = crate::devices::device(&crate::support::fixtures().join("eds/minimal.eds"));
    for file in generate(&device, Target::CANOPENNODE_V1, &Options::default()).unwrap().files {
        let text = String::from_utf8(file.contents).unwrap().replace(env!("CARGO_PKG_VERSION"), "[version]");
        insta::assert_snapshot!(file.path, text);
    }
}

/// Objects as the editors for the stack write them: a list whose number of elements is mappable, elements without a name, records of
/// one name, and members of one name.
const OF_EDITORS: &str = "\
[DeviceInfo]
VendorName=Editors
[MandatoryObjects]
SupportedObjects=0
[ManufacturerObjects]
SupportedObjects=4
1=0x2101
2=0x2102
3=0x2301
4=0x2302
[2101]
ParameterName=Power-on counter
ObjectType=7
;StorageLocation=EEPROM
DataType=7
AccessType=rw
[2102]
ParameterName=Outputs
ObjectType=8
SubNumber=3
[2102sub0]
ParameterName=max sub-index
DataType=5
AccessType=ro
DefaultValue=2
PDOMapping=1
[2102sub1]
ParameterName=
DataType=5
AccessType=rw
PDOMapping=1
[2102sub2]
ParameterName=Lamp
DataType=5
AccessType=rw
DefaultValue=9
PDOMapping=1
[2301]
ParameterName=Trace
ObjectType=9
SubNumber=3
[2301sub0]
ParameterName=max sub-index
DataType=5
AccessType=ro
DefaultValue=2
[2301sub1]
ParameterName=Mode
DataType=5
AccessType=rw
[2301sub2]
ParameterName=Mode
DataType=6
AccessType=rw
DefaultValue=3
";

/// An application with the names of the editors.
const APPLICATION: &str = r#"
#include "CO_driver.h"
#include "CO_OD.h"
#include "CO_SDO.h"

extern const CO_OD_entryRecord_t OD_record2302[];

static const unsigned numbers[] = {
    OD_2101_powerOnCounter, 0x2101, OD_powerOnCounter_idx, 0x2101, OD_2102_outputs, 0x2102, OD_2102_0_outputs_maxSubIndex, 0,
    OD_2102_1_outputs_, 1, OD_2102_2_outputs_lamp, 2, ODA_outputs_lamp, 1, ODL_outputs_arrayLength, 2, OD_2302_trace, 0x2302,
    OD_2302_2_trace_mode, 2, OD_trace_idx, 0x2301,
};

int main(void)
{
    unsigned at;
    OD_powerOnCounter++;
    OD_trace[0].maxSubIndex = 2;
    OD_trace[1].mode1 += 4;
    for (at = 0; at < sizeof numbers / sizeof numbers[0]; at += 2) {
        if (numbers[at] != numbers[at + 1]) {
            return 1;
        }
    }
    return CO_OD_EEPROM.powerOnCounter == 1 && OD_outputs[ODA_outputs_lamp] == 9 && CO_OD_RAM.trace[1].mode1 == 12
                   && OD_record2302[2].pData == &CO_OD_RAM.trace[1].mode1
               ? 0
               : 1;
}
"#;

/// An application that was written for the output of the editors compiles and finds its values.
#[test]
fn applications_find_the_names_of_the_editors() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let first = OF_EDITORS.split_once("[2301]").unwrap().1;
    let second = first.replace("2301", "2302").replace("DefaultValue=3", "DefaultValue=8");
    let text = format!("{OF_EDITORS}[2302]{second}");
    std::fs::write(folder.path().join("editors.eds"), text.replace('\n', "\r\n")).unwrap();
    let device = crate::devices::device(&folder.path().join("editors.eds"));
    write(folder.path(), &device, &Options::default());
    std::fs::write(folder.path().join("application.c"), APPLICATION).unwrap();
    let mut cc = cc(&compiler, folder.path());
    cc.arg("-I.").arg(format!("-I{}", beside("canopennode_v1", "include").display()));
    cc.args(["-o", "application", "CO_OD.c", "application.c"]);
    host(&cc).succeed().unwrap();
}

/// The sources of the stack without a bus.
const SOURCES: [&str; 14] = [
    "stack/drvTemplate/CO_driver.c",
    "stack/crc16-ccitt.c",
    "stack/CO_SDO.c",
    "stack/CO_Emergency.c",
    "stack/CO_NMT_Heartbeat.c",
    "stack/CO_SYNC.c",
    "stack/CO_TIME.c",
    "stack/CO_PDO.c",
    "stack/CO_HBconsumer.c",
    "stack/CO_SDOmaster.c",
    "stack/CO_LSSmaster.c",
    "stack/CO_LSSslave.c",
    "stack/CO_trace.c",
    "CANopen.c",
];

/// What the stack answers otherwise than its tables say: states, entries that it does not know, empty values and long ones.
fn is_answered_by_the_stack(row: &Row) -> bool {
    let is_long = row.size.is_none_or(|size| size == 0 || size > 889);
    !row.read
        || is_long
        || matches!(row.index, 0x1001 | 0x1003 | 0x2100)
        || is_pdo_id(row.index, row.sub) && row.size != Some(4) // its fourth byte has the state
        || row.index == 0x1200 && row.sub > 2 // the node-ID is added there, too
        || (0x1800..=0x19FF).contains(&row.index) && row.sub == 4
        || matches!(row.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) && row.sub == 0 // 0 without a mapping that is valid
        || (0x1280..=0x12FF).contains(&row.index) && row.sub > 0 // an SDO client begins without a server
}

/// Whether an entry has the COB-ID of a PDO.
fn is_pdo_id(index: u16, sub: u8) -> bool {
    sub == 1 && matches!(index, 0x1400..=0x15FF | 0x1800..=0x19FF)
}

/// The COB-ID of a PDO without the bit that the stack sets when it cannot use the PDO.
fn without_state(mut row: Row) -> Row {
    let is_id = is_pdo_id(row.index, row.sub);
    if let (true, Some([.., high])) = (is_id, row.default.as_deref_mut()) {
        *high |= 0x80;
    }
    row
}

/// The entries as the SDO server of the stack reads them with the files and hooks of a folder.
fn of_real_stack(compiler: &str, folder: &Path, stack: &Path) -> Result<String, String> {
    let cc = || {
        let mut command = std::process::Command::new(compiler);
        command.current_dir(folder).args(["-std=gnu99", "-I.", "-DCO_SDO_BUFFER_SIZE=889"]);
        for include in ["stack/drvTemplate", "stack", ""] {
            command.arg("-isystem").arg(stack.join(include));
        }
        command
    };
    succeed(cc().args(["-Wall", "-Wextra", "-Werror", "-c", "CO_OD.c"]), "")?;
    let mut build = cc();
    build.args(["-w", "-o", "node", "CO_OD.o"]).args(SOURCES.map(|source| stack.join(source)));
    build.args(folder.join("hooks.c").is_file().then_some("hooks.c"));
    succeed(build.arg(beside("canopennode_v1", "node.c")), "")?;
    succeed(std::process::Command::new(folder.join("node")).arg(NODE_ID.to_string()), "")
}

/// Hooks that show the argument of the application in what is read.
const HOOKS: &str = r#"
#include "CO_driver.h"
#include "CO_OD.h"
#include "CO_SDO.h"

CO_SDO_abortCode_t CO_OD_hook2101(CO_ODF_arg_t *ODF_arg)
{
    if (ODF_arg->reading) {
        ODF_arg->data[0] = *(uint8_t *)ODF_arg->object;
    }
    return (CO_SDO_abortCode_t)0;
}

CO_SDO_abortCode_t CO_OD_hook2102(CO_ODF_arg_t *ODF_arg)
{
    return CO_OD_hook2101(ODF_arg);
}
"#;

/// What the stack does with the functions.
const REGISTERED: &str = r#"
void CO_OD_configure(CO_SDO_t *SDO, uint16_t index, CO_SDO_abortCode_t (*pODFunc)(CO_ODF_arg_t *ODF_arg), void *object,
                     uint8_t *flags, uint8_t flagsSize)
{
    SDO->function[index - 0x2101] = flags == 0 && flagsSize == 0 ? pODFunc : 0;
    SDO->object = object;
}

int main(void)
{
    uint8_t mark = 7, value = 0;
    CO_SDO_t server;
    CO_ODF_arg_t argument = {&mark, &value, 1, 1};
    CO_OD_initHooks(&server, &mark);
    return server.object == &mark && server.function[0](&argument) == 0 && server.function[1] == CO_OD_hook2102 && value == 7 ? 0 : 1;
}
"#;

#[test]
fn hooks_answer_uploads() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("editors.eds"), OF_EDITORS.replace('\n', "\r\n")).unwrap();
    let device = crate::devices::device(&folder.join("editors.eds"));
    let mut options = Options::default();
    options.hooks = ["2101", "2102:1", "2102:2", "7000"].map(|at| at.parse().unwrap()).into();
    let notes = write(folder, &device, &options);
    let of_hooks = notes.iter().filter(|note| note.message.contains("hook")).map(|note| &*note.message);
    let for_all =
        "the stack calls the hook for all entries of the object; also for 1 more entry of the object";
    assert_eq!(of_hooks.collect::<Vec<_>>(), ["no entry to call a hook for", for_all]);
    std::fs::write(folder.join("registered.c"), format!("{HOOKS}{REGISTERED}")).unwrap();
    let mut cc = cc(&compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("canopennode_v1", "include").display()));
    cc.args(["-Wno-missing-prototypes", "-o", "registered", "CO_OD.c", "registered.c"]);
    host(&cc).succeed().unwrap();
    if let Some(stack) = checkout("OBJDICT_CANOPENNODE_V1_DIR") {
        std::fs::write(folder.join("hooks.c"), HOOKS).unwrap();
        let printed = of_real_stack(&compiler, folder, &stack).unwrap();
        let lines: Vec<&str> = printed.lines().filter(|line| line.starts_with("210")).collect();
        let expected = [
            "2101 00 - 4 rw-- 5A000000",
            "2102 00 - 1 r--- 5A",
            "2102 01 - 1 rwtp 5A",
            "2102 02 - 1 rwtp 5A",
        ];
        assert_eq!(lines, expected);
    }
}

/// `OBJDICT_CANOPENNODE_V1_DIR` names a checkout of the stack 1.3: it compiles and starts with the tables, and its SDO server
/// reads them.
#[test]
fn the_sdo_server_of_the_real_stack_reads_the_tables() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPENNODE_V1_DIR"), c_compiler()) else {
        return;
    };
    let found = AtomicUsize::new(0);
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let mut options = Options::default();
        options.node_id = Some(NODE_ID);
        let notes = write(folder.path(), device, &options);
        if startup::is_undefined(&notes) {
            return Ok(());
        }
        let printed = of_real_stack(&compiler, folder.path(), &stack).map_err(fail)?;
        found.fetch_add(startup::compare(device, &notes, &printed).map_err(fail)?, Ordering::Relaxed);
        let rows = expected(device).into_iter().filter(|row| !is_answered_by_the_stack(row));
        let rows: Vec<Row> = rows.map(without_state).collect();
        let known: HashSet<(u16, u8)> = rows.iter().map(|row| (row.index, row.sub)).collect();
        let lines = printed.lines().filter(|line| address(line).is_some_and(|at| known.contains(&at)));
        let lines: String = lines.map(|line| format!("{}\n", line_without_state(line))).collect();
        compare(name, &rows, &lines).map_err(fail)
    });
    eprintln!("CANopenNode 1.3: {found:?} predictions");
}

/// The same for a line.
fn line_without_state(line: &str) -> String {
    let is_id = address(line).is_some_and(|(index, sub)| is_pdo_id(index, sub));
    let (start, high) = line.split_at(line.len().saturating_sub(2));
    match u8::from_str_radix(high, 16) {
        Ok(high) if is_id => format!("{start}{:02X}", high | 0x80),
        _ => line.to_owned(),
    }
}

/// libEDSsharp wrote the hex digits of indexes in lower case until November 2019.
#[test]
fn macros_of_older_editors_have_lower_case_digits() {
    let module = crate::devices::device(&crate::support::fixtures().join("eds/io-401.eds"));
    let text = |layout| {
        let options = Options { layout, ..Options::default() };
        let files = generate(&module, Target::CANOPENNODE_V1, &options).unwrap().files;
        files.into_iter().map(|file| String::from_utf8(file.contents).unwrap()).collect::<String>()
    };
    let (new, old) = (text(StackLayout::CanOpenEditor), text(StackLayout::CanOpenEditor2020));
    for (upper, lower) in [
        ("#define OD_1A00_TPDOMappingParameter 0x1A00\n", "#define OD_1a00_TPDOMappingParameter 0x1a00\n"),
        ("#define OD_100A_manufacturerSoftwareVersion ", "#define OD_100a_manufacturerSoftwareVersion "),
        ("OD_record1A00[5]", "OD_record1a00[5]"),
        ("(void *)&OD_record1A00}", "(void *)&OD_record1a00}"),
    ] {
        assert!(new.contains(upper) && !new.contains(lower), "{upper}");
        assert!(old.contains(lower) && !old.contains(upper), "{lower}");
    }
    assert_eq!(new, text(StackLayout::Complete));
}
