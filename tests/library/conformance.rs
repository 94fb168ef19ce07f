//! The node of a description does what CiA 301 says, and the checks notice when it does not.

use std::collections::BTreeSet;

use objdict::bus::{Abort, Conformance, Dictionary, LiveDictionary, Verdict, conformance, conformance_of};
use objdict::format::{self, Format};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};
use objdict::source::{SourceFile, SourceOptions};
use objdict_device::{Attributes, Scope};

/// The fixtures that pass every check that applies to them.
const FIXTURES: [&str; 5] =
    ["eds/drive-402.eds", "eds/io-401.eds", "eds/all-types.eds", "eds/encoder-406.eds", "xdd/press-402.xdd"];

fn fixture(name: &str) -> Device {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name);
    let format = if name.ends_with("xdd") { Format::Xdd } else { Format::Eds };
    let source =
        SourceFile::from_bytes(name, std::fs::read(path).unwrap(), &SourceOptions::default()).unwrap();
    format::read(source, format).device().clone()
}

/// A drive with all services: SYNC with a counter, a second SDO server, RPDOs for entries of their own, a program.
fn with_everything() -> Device {
    let mut device = fixture("eds/drive-402.eds");
    let mut add = |index: u16, sub: u8, data_type: DataType, value: u64| {
        let entry = Entry {
            data_type: Some(data_type),
            access: Some(Access::Rw),
            default: Some(Value::Unsigned(value)),
            ..Entry::default()
        };
        let object = device.objects.get_or_insert_with(index, Object::default);
        if matches!(index, 0x1006 | 0x1012 | 0x1019) {
            object.main = entry;
        } else {
            object.main.object_type = Some(ObjectType::Record);
            object.subs.insert(sub, entry);
        }
    };
    add(0x1006, 0, DataType::UNSIGNED32, 0);
    add(0x1012, 0, DataType::UNSIGNED32, 0x100);
    add(0x1029, 0, DataType::UNSIGNED8, 1);
    add(0x1029, 1, DataType::UNSIGNED8, 0);
    add(0x1019, 0, DataType::UNSIGNED8, 0);
    for (index, [client, server]) in [(0x1200, [0x605, 0x585]), (0x1201, [0x8000_0000; 2])] {
        add(index, 0, DataType::UNSIGNED8, 2);
        add(index, 1, DataType::UNSIGNED32, client);
        add(index, 2, DataType::UNSIGNED32, server);
    }
    for (pdo, mapped) in [(0_u16, 0x2100_0120_u64), (1, 0x2100_0220)] {
        add(0x1410 + pdo, 0, DataType::UNSIGNED8, 2);
        add(0x1410 + pdo, 1, DataType::UNSIGNED32, 0x8000_0000);
        add(0x1410 + pdo, 2, DataType::UNSIGNED8, 255);
        add(0x1610 + pdo, 0, DataType::UNSIGNED8, 1);
        add(0x1610 + pdo, 1, DataType::UNSIGNED32, mapped);
    }
    for (index, data_type) in [
        (0x1F50, DataType::DOMAIN),
        (0x1F51, DataType::UNSIGNED32), // as some devices have it, instead of a byte
        (0x1F56, DataType::UNSIGNED32),
        (0x1F57, DataType::UNSIGNED32),
    ] {
        add(index, 0, DataType::UNSIGNED8, 1);
        add(index, 1, data_type, 0);
    }
    for sub in 0..=2 {
        add(0x1020, sub, if sub == 0 { DataType::UNSIGNED8 } else { DataType::UNSIGNED32 }, 2 >> (8 * sub));
    }
    add(0x2100, 0, DataType::UNSIGNED8, 2);
    add(0x2100, 1, DataType::UNSIGNED32, 0);
    add(0x2100, 2, DataType::UNSIGNED32, 0);
    device
}

fn failures(results: &Conformance) -> Vec<String> {
    let failed = results.checks.iter().filter(|check| matches!(check.verdict, Verdict::Failed(_)));
    failed.map(|check| format!("{}: {}: {:?}", check.service, check.name, check.verdict)).collect()
}

#[test]
fn the_fixtures_pass_all_checks() {
    for name in FIXTURES {
        for node_id in [1, 5, 127] {
            let results = conformance(&fixture(name), node_id);
            assert_eq!(failures(&results), [""; 0], "{name}");
            assert!(results.passed().0 > 120, "{name}: {:?}", results.passed());
        }
    }
}

/// Each check applies to some device, and passes there.
#[test]
fn every_check_is_made() {
    let mut passed = BTreeSet::new();
    let mut all = BTreeSet::new();
    for device in [with_everything(), fixture("eds/all-types.eds"), fixture("eds/io-401.eds")] {
        let results = conformance(&device, 5);
        assert_eq!(failures(&results), [""; 0]);
        for check in results.checks.into_iter().filter(|check| !check.service.starts_with("objects")) {
            if check.verdict == Verdict::Passed {
                passed.insert((check.service, check.name.clone()));
            }
            all.insert((check.service, check.name));
        }
    }
    let never: Vec<_> = all.difference(&passed).filter(|(service, _)| *service != "not served").collect();
    assert!(never.is_empty(), "{never:#?}");
    assert!(passed.len() > 170, "{}", passed.len());
}

/// What is not served is said and fails nothing.
#[test]
fn services_that_the_node_does_not_have_are_named() {
    let results = conformance(&fixture("eds/manager-302.eds"), 5);
    let unserved: Vec<&str> = results
        .checks
        .iter()
        .filter(|check| check.verdict == Verdict::NotServed)
        .map(|check| check.name.as_str())
        .collect();
    assert_eq!(unserved, ["SYNC window", "emergency consumer", "SDO client", "NMT master"]);
    assert!(results.is_clean());
    let (passed, count) = results.passed();
    assert_eq!(passed + 4, count);
}

/// What a wrong node does otherwise.
#[derive(Clone, Copy, Debug)]
enum Mistake {
    /// An object is read as another value.
    Reads(u16, fn(&mut [u8])),
    /// Writes are answered with this instead.
    Answers(Result<(), Abort>, Option<Abort>),
    /// An abort code instead of another one.
    Says(Abort, Abort),
    /// Everything is writable, or mappable.
    Attributes(fn(&mut Attributes)),
    /// A reset gives nothing back.
    Keeps,
    /// Reset communication gives back all values.
    Forgets,
    /// Nothing is stored, nothing is restored.
    StoresNothing,
    RestoresNothing,
}

#[derive(Clone)]
struct Wrong(LiveDictionary, Mistake);

impl Wrong {
    fn said<T>(&self, result: Result<T, Abort>) -> Result<T, Abort> {
        match self.1 {
            Mistake::Says(right, wrong) => result.map_err(|abort| if abort == right { wrong } else { abort }),
            _ => result,
        }
    }
}

impl Dictionary for Wrong {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        let mut attributes = self.said(self.0.attributes(index, sub))?;
        if let Mistake::Attributes(change) = self.1 {
            change(&mut attributes);
        }
        Ok(attributes)
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let read = self.0.read(index, sub, buffer);
        let length = self.said(read)?;
        match self.1 {
            Mistake::Reads(object, change) if object == index => change(&mut buffer[..length]),
            _ => {}
        }
        Ok(length)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        match self.1 {
            // as if it were written
            Mistake::Answers(answer, None) => answer,
            Mistake::Answers(answer, Some(right)) => self
                .0
                .write(index, sub, bytes)
                .or_else(|abort| if abort == right { answer } else { Err(abort) }),
            _ => {
                let written = self.0.write(index, sub, bytes);
                self.said(written)
            }
        }
    }

    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.0.replace(index, sub, bytes)
    }

    fn restart(&mut self, scope: Scope, node_id: u8) {
        match self.1 {
            Mistake::Keeps => {}
            Mistake::Forgets => self.0.restart(Scope::All, node_id),
            _ => self.0.restart(scope, node_id),
        }
    }

    fn can_store(&self, sub: u8) -> bool {
        self.0.can_store(sub)
    }

    fn store(&mut self, sub: u8) -> Result<(), Abort> {
        if matches!(self.1, Mistake::StoresNothing) { Ok(()) } else { self.0.store(sub) }
    }

    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        if matches!(self.1, Mistake::RestoresNothing) { Ok(()) } else { self.0.restore(sub) }
    }
}

fn flip(bytes: &mut [u8]) {
    bytes.iter_mut().take(1).for_each(|byte| *byte ^= 1);
}

fn double(bytes: &mut [u8]) {
    let number = bytes.iter().rev().fold(0, |number: u64, &byte| number << 8 | u64::from(byte));
    let length = bytes.len();
    bytes.copy_from_slice(&(number * 2).to_le_bytes()[..length]);
}

#[test]
fn a_wrong_node_fails() {
    use Mistake::*;
    let mistakes: [(Mistake, &[&str]); 19] = [
        (Reads(0x1018, flip), &["1018h"]),
        (Reads(0x607A, flip), &["607Ah"]),
        (Reads(0x1017, double), &["the period of 1017h", "a late heartbeat does not delay the next one"]),
        (Reads(0x1006, double), &["bit 30 of 1005h: the period of 1006h"]),
        (Reads(0x1015, double), &["the inhibit time of 1015h"]),
        (Reads(0x1016, double), &["a missing heartbeat: emergency 8130h"]),
        (Reads(0x1A00, flip), &["each event-driven TPDO once when operational, with its values"]),
        (Answers(Ok(()), None), &["6081h", "expedited download", "type 255: written at once"]),
        (Answers(Ok(()), Some(Abort::TooHigh)), &["6060h"]),
        (
            Answers(Ok(()), Some(Abort::TooShort)),
            &["6081h", "0607 0013h: a download of one byte to a longer entry"],
        ),
        (Says(Abort::NoObject, Abort::General), &["0602 0000h: upload without an object"]),
        (Says(Abort::NoSubIndex, Abort::NoObject), &["0609 0011h: download without a sub-index"]),
        (
            Attributes(|attributes| (attributes.writable, attributes.readable) = (true, true)),
            &["0601 0002h: block download to what is read-only"],
        ),
        (
            Attributes(|attributes| (attributes.fits_tpdo, attributes.fits_rpdo) = (true, true)),
            &[
                "TPDO: an entry that is not mappable is rejected",
                "RPDO: an entry that is not mappable is rejected",
            ],
        ),
        (Attributes(|attributes| attributes.size += 1), &["1014h"]),
        (Keeps, &["reset node restores the values of 2000h to 9FFFh"]),
        (Forgets, &["reset communication keeps the values of 2000h to 9FFFh"]),
        (StoresNothing, &["1010h: stored values survive a reset"]),
        (RestoresNothing, &["1011h: the defaults apply after a reset"]),
    ];
    let device = with_everything();
    for (mistake, expected) in mistakes {
        let results = conformance_of(&device, 5, &[], |dictionary| Wrong(dictionary, mistake));
        let failed = failures(&results);
        for name in expected {
            let is_noticed = failed.iter().any(|failure| failure.contains(&format!(": {name}: ")));
            assert!(is_noticed, "{mistake:?}: `{name}` does not fail: {failed:#?}");
        }
        assert!(!results.is_clean());
    }
}

/// With groups, 1010h stores their values and no others, and the checks are about these.
#[test]
fn the_groups_of_a_build_are_tested() {
    let of = |groups: &[&str]| {
        let groups: Vec<_> = groups.iter().map(|group| group.parse().unwrap()).collect();
        conformance_of(&fixture("eds/io-401.eds"), 5, &groups, |dictionary| dictionary)
    };
    let verdict = |results: &Conformance, name: &str| {
        let found = results.checks.iter().find(|check| check.name == name);
        found.map(|check| check.verdict.clone())
    };
    let (stored, outside) =
        ("1010h: stored values survive a reset", "1010h: values outside the groups are not stored");
    assert_eq!(verdict(&of(&[]), outside), None);
    for groups in [&["1000-1FFF=COMM"][..], &["6000-9FFF=APPLICATION"]] {
        let results = of(groups);
        assert_eq!(failures(&results), [""; 0]);
        assert_eq!(verdict(&results, stored), Some(Verdict::Passed), "{groups:?}");
        assert_eq!(verdict(&results, outside), Some(Verdict::Passed), "{groups:?}");
    }
    // no value is in the group, or all are
    assert!(matches!(verdict(&of(&["3000=NONE"]), stored), Some(Verdict::Absent(_))));
    let all = of(&["1000-1FFF=COMM", "2000-9FFF=APPLICATION"]);
    assert!(matches!(verdict(&all, outside), Some(Verdict::Absent(_))));
}
