//! `objdict diff`: changes that are made in valid devices (`fixtures/changes.txt`) are found with their verdicts and nothing else is,
//! and what only looks different is no change.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;

use objdict::format::{self, Format, WriteOptions, json};
use objdict::lint::changes::{Audience, ChangeVerdict, DeviceChange, compare, rules};
use objdict::model::{Compact, Date, Device, DeviceKind, Entry, Object, ObjectType, Value};
use objdict::source::{SourceFile, SourceOptions};

use crate::planted::plant;
use crate::support;

/// A change from one text to another.
struct Planted {
    file: String,
    what: String,
    /// The rules that report it, with their verdicts.
    expected: Vec<String>,
    old: Device,
    new: Device,
}

fn read(file: &str, text: &str) -> Device {
    let format = Format::from_name(file).unwrap_or(Format::Eds);
    format::read(SourceFile::from_text(file, text), format).into_device()
}

/// The rules about the revision number, the product code and the version and date of the file.
const VERSIONS: [&str; 5] = [
    "change/revision-not-raised",
    "change/revision-lowered",
    "change/file-version-not-raised",
    "change/modification-date-not-moved",
    "change/product-code-not-changed",
];

/// Raises the versions of a device, as its changes demand, but that which a rule is about.
fn raise(device: &mut Device, expected: &[String]) {
    let is_about = |rule: usize| expected.iter().any(|text| text.starts_with(VERSIONS[rule]));
    if let Some(info) = &mut device.file_info {
        if !is_about(2) {
            info.file_revision = Some(info.file_revision.unwrap_or(0) + 1);
        }
        let date = info.modification_date.filter(|_| !is_about(3));
        if let Some(date) = date {
            info.modification_date = Date::new(date.year + 1, date.month, date.day);
        }
    }
    let revision = device.objects.get_mut(&0x1018).and_then(|object| object.subs.get_mut(3));
    if let Some(entry) = revision.filter(|_| !is_about(0) && !is_about(1)) {
        let number = entry.default.as_ref().and_then(Value::as_integer).unwrap_or_default();
        entry.default = u64::try_from(number + 0x1_0000).ok().map(Value::Unsigned);
    }
}

fn planted() -> Vec<Planted> {
    let table = fs::read_to_string(support::fixtures().join("changes.txt")).unwrap();
    let (mut file, mut text, mut found) = (String::new(), String::new(), Vec::new());
    for line in table.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(name) = line.strip_prefix("== ") {
            file = name.to_owned();
            let bytes = fs::read(support::fixtures().join(name)).unwrap();
            let source = SourceFile::from_bytes(name, bytes, &SourceOptions::default()).unwrap();
            text = source.text().replace("\r\n", "\n");
            continue;
        }
        let (is_reversed, line) = line.strip_prefix("< ").map_or((false, line), |line| (true, line));
        let parts: Vec<String> = line.split(" | ").map(|part| part.replace("\\n", "\n")).collect();
        let edited = parts[2..].chunks(3).fold(text.clone(), |text, edit| {
            plant(&text, &parts[1], &edit[0], &edit[1], edit.get(2).map_or("", |new| new))
        });
        let expected =
            parts[0].split(", ").filter(|rule| *rule != "none").map(str::to_owned).collect::<Vec<_>>();
        let (old, new) = if is_reversed { (&edited, &text) } else { (&text, &edited) };
        let (old, mut new) = (read(&file, old), read(&file, new));
        if new.kind == DeviceKind::Type && !expected.is_empty() {
            raise(&mut new, &expected);
        }
        let what = parts[1].clone();
        found.push(Planted { file: file.clone(), what, expected, old, new });
    }
    found
}

fn shown(changes: &[DeviceChange]) -> String {
    changes.iter().fold(String::new(), |mut text, change| {
        writeln!(text, "  {} {} {}", change.rule.info.id, change.verdict(), change.message).unwrap();
        text
    })
}

#[test]
fn planted_changes_have_their_verdict_and_no_other() {
    let all = planted();
    assert!(all.len() >= 60, "{} changes", all.len());
    let mut wrong = String::new();
    for Planted { file, what, expected, old, new } in &all {
        let changes = compare(old, new);
        let found: Vec<String> =
            changes.iter().map(|change| format!("{} {}", change.rule.info.id, change.verdict())).collect();
        if found != *expected {
            writeln!(wrong, "{file}: {what}: expected {expected:?}\n{}", shown(&changes)).unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn every_kind_of_change_is_planted() {
    let planted: BTreeSet<String> = planted()
        .iter()
        .flat_map(|planted| planted.expected.iter().map(|rule| rule.split(' ').next().unwrap().to_owned()))
        .collect();
    let without: Vec<_> = rules().map(|rule| rule.info.id).filter(|id| !planted.contains(*id)).collect();
    // the command adds these, and the sessions of docs/diff.md and `identifiers` have them
    assert_eq!(without, ["change/identifier-changed", "change/configuration-refused"]);
}

#[test]
fn changes_say_what_changes() {
    let text = planted().iter().fold(String::new(), |mut text, planted| {
        let changes = compare(&planted.old, &planted.new);
        writeln!(text, "{}: {}\n{}", planted.file, planted.what, shown(&changes)).unwrap();
        text
    });
    insta::with_settings!({ snapshot_path => "snapshots", prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("changes", text);
    });
}

#[test]
fn a_rule_has_one_verdict_for_each_audience_in_the_order_of_the_table() {
    for rule in rules() {
        let audiences: Vec<Audience> = rule.effects.iter().map(|effect| effect.audience).collect();
        assert!(
            audiences.is_sorted() && audiences.windows(2).all(|pair| pair[0] != pair[1]),
            "{}",
            rule.info.id
        );
        for effect in rule.effects {
            assert!(
                !effect.reason.ends_with('.') && effect.reason.trim() == effect.reason,
                "{}",
                effect.reason
            );
        }
    }
}

/// Nothing is stored of an object without a group, no configuration writes what is read-only, and no PDO carries what is not mappable.
#[test]
fn only_who_uses_an_entry_is_affected() {
    let all = planted();
    let audiences = |what: &str| {
        let planted = all.iter().find(|planted| planted.what == what).unwrap();
        compare(&planted.old, &planted.new)[0]
            .effects()
            .map(|effect| effect.audience.name())
            .collect::<Vec<_>>()
    };
    assert_eq!(audiences("an object is gone"), ["configurations", "sdo-clients", "firmware"]);
    assert_eq!(
        audiences("a stored object is gone, and comes back where none moves to"),
        ["configurations", "sdo-clients", "firmware", "stored-values"]
    );
    assert_eq!(audiences("an entry is not mappable any more"), ["pdo-consumers", "firmware"]);
}

fn devices() -> Vec<std::path::PathBuf> {
    let folders = ["eds", "dcf", "xdd", "xdc", "bases", "objdictgen", "cnxml"].into_iter();
    folders.flat_map(|folder| support::files(folder, &["eds", "dcf", "xdd", "xdc", "od", "xml"])).collect()
}

#[test]
fn other_forms_of_a_device_are_no_change() {
    let mut wrong = String::new();
    let mut compared = 0;
    for path in devices() {
        let description = format::open(&path, &SourceOptions::default()).unwrap();
        let device = description.device();
        let target = match device.kind {
            DeviceKind::Type => Format::Xdd,
            DeviceKind::Node => Format::Xdc,
        };
        let mut options = WriteOptions::default();
        options.embed = true;
        let written = format::write(device, target, &options).unwrap();
        let source = SourceFile::from_bytes("other.xdd", written.bytes, &SourceOptions::default()).unwrap();
        let text = description.source().text();
        let ending =
            if text.contains("\r\n") { text.replace("\r\n", "\n") } else { text.replace('\n', "\r\n") };
        let others = [
            ("itself", device.clone()),
            ("XML", format::read(source, target).into_device()),
            ("JSON", json::read_device(&json::write_device(device)).unwrap()),
            (
                "other line ends",
                format::read(SourceFile::from_text("other", ending), description.format()).into_device(),
            ),
        ];
        for (form, other) in others {
            let changes = compare(device, &other);
            if !changes.is_empty() {
                writeln!(wrong, "{} as {form}:\n{}", path.display(), shown(&changes)).unwrap();
            }
            compared += 1;
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(compared > 100, "{compared}");
}

/// Each entry of a compact object, described on its own.
#[test]
fn a_compact_object_is_its_entries() {
    let main = Entry {
        name: "Channel".into(),
        object_type: Some(ObjectType::Array),
        data_type: Some(objdict::model::DataType::UNSIGNED16),
        default: Some(Value::Unsigned(7)),
        ..Entry::default()
    };
    let compact = Compact { count: 3, values: vec![(2, Value::Unsigned(9))], ..Compact::default() };
    let object = Object { main, compact: Some(Box::new(compact)), ..Object::default() };
    let mut described = Object {
        subs: object.entries().map(|(sub, entry)| (sub, entry.into_owned())).collect(),
        compact: None,
        ..object.clone()
    };
    described.main = Entry { data_type: None, default: None, ..described.main };
    let device = |object: Object| {
        let mut device = Device::default();
        device.objects.insert(0x2000, object);
        device
    };
    let changes = compare(&device(object), &device(described));
    assert!(changes.is_empty(), "{}", shown(&changes));
}

#[test]
fn verdicts_are_ordered() {
    assert!(
        ChangeVerdict::Compatible < ChangeVerdict::Risky && ChangeVerdict::Risky < ChangeVerdict::Breaking
    );
}
