//! Hooks are called exactly for the requested entries, before reads and after writes, and their results are
//! returned.

use objdict::generate::{Options, PdoMappings, Target, generate};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

use crate::batch::Batch;
use crate::compile::{DRIVER, c_compiler, cc, driver, generate_with};
use crate::devices::{devices, for_all};
use crate::oracle::facts_of;
use crate::processors::host;
use crate::{compare, script, support};

fn entry(name: &str, data_type: DataType, access: Access, default: Option<Value>) -> Entry {
    Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(access),
        default,
        ..Entry::default()
    }
}

fn device() -> Device {
    let mut device = Device::default();
    let mut var = |index, main| device.objects.insert(index, Object { main, ..Object::default() });
    var(0x2000, entry("Counter", DataType::UNSIGNED16, Access::Rw, None));
    var(0x2002, entry("Label", DataType::VISIBLE_STRING, Access::Rw, Some(Value::Text("old".into()))));
    var(0x2003, entry("Fixed", DataType::UNSIGNED32, Access::Const, Some(Value::Unsigned(7))));
    var(0x2004, entry("State", DataType::UNSIGNED8, Access::Ro, None));
    var(0x2005, entry("Clock", DataType::TIME_OF_DAY, Access::Rw, None));
    var(0x2006, entry("Data", DataType::DOMAIN, Access::Rw, None));
    var(0x2007, entry("Plain", DataType::UNSIGNED16, Access::Rw, None));
    var(0x2008, entry("Key", DataType::INTEGER24, Access::Wo, None));
    let subs = (1..=3).map(|sub| (sub, entry("Speed", DataType::INTEGER32, Access::Rw, None)));
    let main = Entry { name: "Speeds".into(), object_type: Some(ObjectType::Array), ..Entry::default() };
    device.objects.insert(0x2001, Object { main, subs: subs.collect(), ..Object::default() });
    for index in [0x1600, 0x1A00] {
        let count = entry("Mapped", DataType::UNSIGNED8, Access::Rw, Some(Value::Unsigned(1)));
        let mapped = entry("First", DataType::UNSIGNED32, Access::Rw, Some(Value::Unsigned(0x2000_0010)));
        let main =
            Entry { name: "Mapping".into(), object_type: Some(ObjectType::Record), ..Entry::default() };
        let subs = [(0, count), (1, mapped)].into_iter().collect();
        device.objects.insert(index, Object { main, subs, ..Object::default() });
    }
    device
}

fn options(hooks: &[&str]) -> Options {
    let mut options = Options::default();
    options.hooks = hooks.iter().map(|at| at.parse().unwrap()).collect();
    options
}

const HOOKS: [&str; 9] = ["1A00", "2000", "0x2001:2", "2002", "2003", "2004", "2005", "2006", "2008"];

/// Operations and the expected output: the hook calls, then the answer.
const SESSION: &[(&str, &[&str])] = &[
    // before_read() counts, and the count is read
    ("r 2000 00", &["before 2000 00", "ok 0100"]),
    ("r 2000 00", &["before 2000 00", "ok 0200"]),
    // after_write() sees the new value
    ("w 2000 00 0A00", &["after 2000 00 10", "ok -"]),
    ("r 2000 00", &["before 2000 00", "ok 0B00"]),
    // rejected: the old value is restored
    ("w 2000 00 0D00", &["after 2000 00 13", "abort 06040043"]),
    ("r 2000 00", &["before 2000 00", "ok 0C00"]),
    // writes that the dictionary rejects do not call hooks
    ("w 2000 00 0A", &["abort 06070013"]),
    ("r 2009 00", &["abort 06020000"]),
    ("w 2003 00 01000000", &["abort 06010002"]),
    ("r 2008 00", &["abort 06010001"]),
    // only one entry of an object has a hook
    ("w 2001 01 05000000", &["ok -"]),
    ("w 2001 02 05000000", &["after 2001 02 12", "ok -"]),
    ("r 2001 01", &["ok 05000000"]),
    ("r 2001 02", &["before 2001 02", "ok 05000000"]),
    ("r 2001 03", &["ok 00000000"]),
    ("w 2007 00 0D00", &["ok -"]),
    // values other than numbers are restored completely
    ("w 2002 00 6E6577", &["after 2002 00 12", "ok -"]),
    ("w 2002 00 626164206F6E6573", &["after 2002 00 12", "abort 08000022"]),
    ("r 2002 00", &["before 2002 00", "ok 6E6577"]),
    ("w 2005 00 010203040506", &["after 2005 00 12", "ok -"]),
    ("w 2005 00 FFFFFFFFFFFF", &["after 2005 00 12", "abort 08000021"]),
    ("r 2005 00", &["before 2005 00", "ok 010203040506"]),
    ("w 2008 00 FFFFFF", &["after 2008 00 12", "ok -"]),
    // an aborted upload
    ("r 2004 00", &["before 2004 00", "abort 06060000"]),
    ("r 2003 00", &["before 2003 00", "ok 07000000"]),
    // no capacity: the application provides the value
    ("r 2006 00", &["abort 08000024"]),
    ("w 2006 00 01", &["abort 08000020"]),
    // the structs of PDOs follow no other mapping, but a hook may
    ("w 1600 00 00", &["abort 06010002"]),
    ("w 1600 01 10000020", &["abort 06010002"]),
    ("r 1600 01", &["ok 10000020"]),
    ("w 1A00 00 00", &["after 1A00 00 12", "ok -"]),
    ("r 1A00 00", &["before 1A00 00", "ok 00"]),
];

const RUST: &str = r#"
mod od {
    include!("od.rs");
}

struct Application;

impl od::Hooks<od::Data> for Application {
    fn before_read(&mut self, data: &mut od::Data, index: u16, sub: u8) -> Result<(), od::Abort> {
        println!("before {index:04X} {sub:02X}");
        data.put(od::COUNTER, data.get(od::COUNTER) + u16::from(index == 0x2000));
        if index == 0x2004 { Err(od::Abort::Hardware) } else { Ok(()) }
    }

    fn after_write(&mut self, data: &mut od::Data, change: od::Change<'_>) -> Result<(), od::Abort> {
        println!("after {:04X} {:02X} {}", change.index(), change.sub(), data.get(od::COUNTER));
        if change.old(od::COUNTER).is_some() && data.get(od::COUNTER) == 13 {
            Err(od::Abort::Incompatible)
        } else if data.get(od::LABEL) == b"bad ones" {
            Err(od::Abort::DeviceState)
        } else if data.get(od::CLOCK).days == 0xFFFF {
            Err(od::Abort::LocalControl)
        } else {
            Ok(())
        }
    }
}

/// Hooks without requested entries.
struct Silent;

impl od::Hooks<od::Data> for Silent {}

fn main() {
    let mut data = od::Data::new(1);
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        let words: Vec<&str> = line.split(' ').collect();
        let number = |word: usize| u16::from_str_radix(words[word], 16).unwrap();
        let (index, sub) = (number(1), number(2) as u8);
        let answer = if words[0] == "r" {
            let mut buffer = [0; 100];
            let length = data.read_with(&mut Application, index, sub, &mut buffer);
            length.map(|length| buffer[..length].iter().map(|byte| format!("{byte:02X}")).collect())
        } else {
            let bytes: Vec<u8> = (0..words[3].len() / 2)
                .map(|at| u8::from_str_radix(&words[3][2 * at..2 * at + 2], 16).unwrap())
                .collect();
            let hooks: &mut dyn od::Hooks<od::Data> = &mut Application;
            data.write_with(hooks, index, sub, &bytes).map(|()| String::from("-"))
        };
        match answer {
            Ok(bytes) => println!("ok {bytes}"),
            Err(abort) => println!("abort {:08X}", abort.code()),
        }
    }
    assert_eq!(data.read_with(&mut Silent, 0x2000, 0, &mut [0; 2]), Ok(2));
    assert_eq!(data.write_with(&mut Silent, 0x2000, 0, &[13, 0]), Ok(()));
    assert!(od::find(0x2000, 0).unwrap().is_hooked() && !od::find(0x2007, 0).unwrap().is_hooked());
}
"#;

const C: &str = r#"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "od.h"

uint32_t od_before_read(od_data_t *data, uint16_t index, uint8_t sub)
{
    printf("before %04X %02X\n", (unsigned)index, (unsigned)sub);
    if (index == OD_COUNTER) {
        data->counter++;
    }
    return index == OD_STATE ? OD_ABORT_HARDWARE : OD_OK;
}

uint32_t od_after_write(od_data_t *data, uint16_t index, uint8_t sub)
{
    printf("after %04X %02X %u\n", (unsigned)index, (unsigned)sub, (unsigned)data->counter);
    if (index == OD_COUNTER && data->counter == 13u) {
        return OD_ABORT_INCOMPATIBLE;
    }
    if (data->label.length == 8u && memcmp(data->label.bytes, "bad ones", 8u) == 0) {
        return OD_ABORT_DEVICE_STATE;
    }
    return data->clock.days == 0xFFFFu ? OD_ABORT_LOCAL_CONTROL : OD_OK;
}

int main(void)
{
    static od_data_t data;
    static char line[1000];
    od_init(&data, 1);
    while (fgets(line, sizeof line, stdin) != NULL) {
        const uint16_t index = (uint16_t)strtoul(line + 2, NULL, 16);
        const uint8_t sub = (uint8_t)strtoul(line + 7, NULL, 16);
        uint8_t buffer[100];
        size_t length = 0;
        uint32_t answer;
        size_t at;
        if (line[0] == 'r') {
            answer = od_read(&data, index, sub, buffer, sizeof buffer, &length);
        } else {
            for (at = 10; line[at] != '\n'; at += 2) {
                char pair[3] = {line[at], line[at + 1], '\0'};
                buffer[length++] = (uint8_t)strtoul(pair, NULL, 16);
            }
            answer = od_write(&data, index, sub, buffer, length);
            length = 0;
        }
        if (answer != OD_OK) {
            printf("abort %08lX\n", (unsigned long)answer);
            continue;
        }
        printf("ok ");
        for (at = 0; at < length; at++) {
            printf("%02X", (unsigned)buffer[at]);
        }
        printf(line[0] == 'r' ? "\n" : "-\n");
    }
    return 0;
}
"#;

#[test]
fn hooks_are_called_for_what_they_are_asked_for() {
    let (device, options) = (device(), options(&HOOKS));
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let input: String = SESSION.iter().map(|(line, _)| format!("{line}\n")).collect();
    let expected: Vec<&str> = SESSION.iter().flat_map(|(_, lines)| *lines).copied().collect();

    let compare = |language: &str, output: &str| match output.lines().eq(expected.iter().copied()) {
        true => Ok(()),
        false => Err(format!("{language}: {output}\nwhere {expected:?} was expected")),
    };
    let mut batch = Batch::new(&[]);
    batch.add("hooks", &generate(&device, Target::RUST, &options).unwrap(), RUST, &(&input, &expected));
    batch.build();
    batch.check("hooks", &input, |output| compare("Rust", output)).unwrap();

    let Some(compiler) = c_compiler() else { return };
    generate_with(folder, &device, "c", &options);
    std::fs::write(folder.join("driver.c"), C).unwrap();
    for level in ["-O0", "-O2"] {
        let mut cc = cc(&compiler, folder);
        let programs = host(cc.args([level, "-I.", "-o", "in-c", "od.c", "driver.c"]));
        programs.check(&[], &input, &expected, |output| compare(level, output)).unwrap();
    }
}

/// Undefined hooks and storage groups do not change any answers.
#[test]
fn answers_are_the_same_with_hooks_and_groups() {
    let chosen = ["odd", "constant", "all-types.eds"];
    let mut devices: Vec<_> =
        devices().into_iter().filter(|(name, _)| chosen.contains(&name.as_str())).collect();
    assert_eq!(devices.len(), chosen.len());
    let path = support::fixtures().join("xdd/io-401.xdd");
    devices.push(("io-401.xdd".to_owned(), crate::devices::device(&path)));
    let options = |device: &Device| {
        let mut options = Options::default();
        options.hooks = device.objects.keys().map(|index| format!("{index:X}").parse().unwrap()).collect();
        options.groups = ["1000-31FF=COMM", "3300-34FF=OTHER"].map(|group| group.parse().unwrap()).to_vec();
        options
    };
    let mut batch = Batch::new(&[]);
    for (name, device) in &devices {
        let script = script::with_hooks(device);
        let generated = generate(device, Target::RUST, &options(device)).unwrap();
        batch.add(name, &generated, DRIVER, &(&script.input, &script.expected));
    }
    batch.build();
    for_all(&devices, |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let script = script::with_hooks(device);
        batch.check(name, &script.input, |answers| compare(name, "Rust", &script, answers)).map_err(fail)?;
        let Some(compiler) = c_compiler() else { return Ok(()) };
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        generate_with(folder, device, "c", &options(device));
        let mut cc = cc(&compiler, folder);
        let programs = host(cc.args(["-O1", "-I.", "-o", "in-c", "od.c"]).arg(driver("driver.c")));
        let compare = |answers: &str| compare(name, "C", &script, answers);
        programs.check(&[], &script.input, &script.expected, compare).map_err(fail)
    });
}

#[test]
fn sdos_write_mappings_that_are_dynamic() {
    let Some(compiler) = c_compiler() else { return };
    let mut devices = devices();
    let is_mapped = |row: &(u16, u8)| matches!(row.0, 0x1600..=0x17FF | 0x1A00..=0x1BFF);
    devices.retain(|(_, device)| {
        facts_of(device).any(|(at, facts)| is_mapped(&at) && facts.access.is_writable())
    });
    assert!(devices.len() > 5, "only {} devices have mappings that can be written", devices.len());
    for_all(&devices, |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let mut options = Options::default();
        options.pdo_mappings = PdoMappings::Dynamic;
        let generated = generate_with(folder, device, "c", &options);
        let sources = generated.files.iter().map(|file| &file.path).filter(|path| path.ends_with(".c"));
        let mut cc = cc(&compiler, folder);
        let programs = host(cc.args(["-O1", "-I.", "-o", "in-c"]).args(sources).arg(driver("driver.c")));
        let script = script::with_hooks(device);
        let compare = |answers: &str| compare(name, "C", &script, answers);
        programs.check(&[], &script.input, &script.expected, compare).map_err(fail)
    });
}

#[test]
fn hooks_that_can_do_little_are_reported() {
    let told = |hooks: &[&str]| {
        let generated = generate(&device(), Target::named("rust").unwrap(), &options(hooks)).unwrap();
        let notes: Vec<String> = generated.notes.iter().map(ToString::to_string).collect();
        notes.into_iter().filter(|note| note.contains("hook") && !note.contains("--hook")).collect::<Vec<_>>()
    };
    assert_eq!(told(&["2000", "2001", "2001:1", "2004"]), [""; 0]);
    assert_eq!(
        told(&["2003", "2006", "2009", "2001:4"]),
        [
            "0x2003: the value is in flash: the hook is called before a read, but cannot change it",
            "0x2006: the table has nothing here that a hook could be called for",
            "0x2009: no entry to call a hook for",
            "0x2001sub4: no entry to call a hook for",
        ]
    );
}
