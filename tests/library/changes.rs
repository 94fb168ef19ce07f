//! `objdict diff`: changes that are made in valid devices (`fixtures/changes.txt`) are found with their verdicts and nothing else is,
//! and what only looks different is no change.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;

use objdict::diagnostic::Applicability;
use objdict::format::{self, Description, Format, WriteOptions, json};
use objdict::lint::changes::{Audience, ChangeVerdict, DeviceChange, ReleaseFacts, compare, release, rules};
use objdict::model::{
    Access, ClockTime, Compact, Date, Device, DeviceKind, Entry, Object, ObjectType, Value,
};
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

/// The same as texts.
struct Texts {
    file: String,
    what: String,
    expected: Vec<String>,
    /// Before and after.
    texts: [String; 2],
}

fn read(file: &str, text: &str) -> Description {
    let format = Format::from_name(file).unwrap_or(Format::Eds);
    format::read(SourceFile::from_text(file, text), format)
}

/// The rules about the revision number, the product code and the version and date of the file.
const VERSIONS: [&str; 5] = [
    "change/revision-not-raised",
    "change/revision-lowered",
    "change/file-version-not-raised",
    "change/modification-date-not-moved",
    "change/product-code-not-changed",
];

/// The revision number of nearly every new device is raised.
const RAISED: &str = "change/revision-raised";

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
    let is_raised = is_about(0) || is_about(1) || expected.iter().any(|text| text.starts_with(RAISED));
    if let Some(entry) = revision.filter(|_| !is_raised) {
        let number = entry.default.as_ref().and_then(Value::as_integer).unwrap_or_default();
        entry.default = u64::try_from(number + 0x1_0000).ok().map(Value::Unsigned);
    }
}

fn texts() -> Vec<Texts> {
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
        let texts = if is_reversed { [edited, text.clone()] } else { [text.clone(), edited] };
        found.push(Texts { file: file.clone(), what: parts[1].clone(), expected, texts });
    }
    found
}

fn planted() -> Vec<Planted> {
    let with_devices = |Texts { file, what, expected, texts: [old, new] }| {
        let (old, mut new) = (read(&file, &old).into_device(), read(&file, &new).into_device());
        if new.kind == DeviceKind::Type && !expected.is_empty() {
            raise(&mut new, &expected);
        }
        Planted { file, what, expected, old, new }
    };
    texts().into_iter().map(with_devices).collect()
}

impl Planted {
    /// The changes, but for the revision number that is raised for them.
    fn changes(&self) -> Vec<DeviceChange> {
        let is_planted = self.expected.iter().any(|text| text.starts_with(RAISED));
        let changes = compare(&self.old, &self.new).into_iter();
        changes.filter(|change| is_planted || change.rule.info.id != RAISED).collect()
    }
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
    for planted in &all {
        let Planted { file, what, expected, .. } = planted;
        let changes = planted.changes();
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
    // the command adds these, and the sessions of docs/guides/diff.md and `identifiers` have them
    assert_eq!(without, ["change/identifier-changed", "change/configuration-refused"]);
}

#[test]
fn changes_say_what_changes() {
    let text = planted().iter().fold(String::new(), |mut text, planted| {
        let changes = planted.changes();
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
    let changes = compare(&device(object.clone()), &device(described.clone()));
    assert!(changes.is_empty(), "{}", shown(&changes));
    // what no entry takes from the object
    let both = Object { subs: described.subs, ..object };
    let edited = |edit: fn(&mut Object)| {
        let mut other = both.clone();
        edit(&mut other);
        compare(&device(both.clone()), &device(other))
    };
    assert_eq!(edited(|_| ()).len(), 0);
    let edits: [fn(&mut Object); 4] = [
        |object| object.main.access = Some(Access::Ro),
        |object| object.main.default = None,
        |object| object.compact.as_mut().unwrap().values.clear(),
        |object| _ = object.subs.remove(2),
    ];
    for (number, edit) in edits.into_iter().enumerate() {
        assert!(!edited(edit).is_empty(), "{number}");
    }
}

/// Two devices that imply the same PDO: one lists its objects, as its DCF does.
#[test]
fn the_lists_of_implied_pdos_count() {
    let lines = "[DeviceInfo]\nNrOfRXPDO=1\nCompactPDO=3\n[OptionalObjects]\n";
    let device = |members: &str| read("implied.eds", &format!("{lines}{members}\n")).device().clone();
    let [unlisted, listed] = ["SupportedObjects=0", "SupportedObjects=2\n1=0x1400\n2=0x1600"].map(device);
    assert_eq!(compare(&unlisted, &unlisted).len(), 0);
    assert!(!compare(&unlisted, &listed).is_empty());
    // described PDOs are another form of implied ones
    let described = unlisted.with_implicit_pdos().into_owned();
    for implied in [&unlisted, &listed] {
        let changes = [compare(implied, &described), compare(&described, implied)].concat();
        assert!(changes.is_empty(), "{}", shown(&changes));
    }
}

#[test]
fn verdicts_are_ordered() {
    assert!(
        ChangeVerdict::Compatible < ChangeVerdict::Risky && ChangeVerdict::Risky < ChangeVerdict::Breaking
    );
}

/// In every text with a planted change, what a release needs is raised, and no other line changes.
#[test]
fn a_release_raises_what_its_changes_demand() {
    let when = (Date::new(2030, 1, 31).unwrap(), ClockTime::new(8, 30).unwrap());
    let facts = ReleaseFacts { date: when.0, time: when.1, product_code: Some(0x1234) };
    let mut raised = BTreeSet::new();
    for Texts { file, what, texts: [old, new], .. } in texts() {
        let old = read(&file, &old).into_device();
        let description = read(&file, &new);
        let check = |description: &Description| release(&old, description.device(), &facts);
        let fixed = objdict::fix(description, Applicability::Safe, check);
        assert!(
            fixed.findings.is_empty() && fixed.skipped.is_empty(),
            "{file}: {what}: {:?}",
            fixed.findings
        );
        raised.extend(fixed.applied.iter().map(|fix| fix.rule));
        let after = fixed.description.source().text();
        let pairs: Vec<(&str, &str)> =
            new.lines().zip(after.lines()).filter(|(new, after)| new != after).collect();
        assert_eq!(new.lines().count(), after.lines().count(), "{file}: {what}");
        assert!(pairs.len() <= 7, "{file}: {what}: {pairs:?}");
        if old.kind == DeviceKind::Type && !fixed.applied.is_empty() {
            let date = if file.ends_with("eds") { "Date=01-31-2030" } else { "Date=\"2030-01-31\"" };
            assert!(after.contains(date), "{file}: {what}");
        }
    }
    assert_eq!(raised, BTreeSet::from(VERSIONS));
}

/// The revision becomes a new major one, or what it was before; a file without a revision left gets the next version.
#[test]
fn the_next_versions() {
    let old = fs::read_to_string(support::fixtures().join("bases/drive.eds")).unwrap().replace("\r\n", "\n");
    let new = fs::read_to_string(support::fixtures().join("diff/drive-2.eds")).unwrap().replace("\r\n", "\n");
    let facts = ReleaseFacts {
        date: Date::new(2030, 1, 31).unwrap(),
        time: ClockTime::new(8, 30).unwrap(),
        product_code: None,
    };
    let titles = |old: &str, new: &str| -> Vec<String> {
        let findings = release(&read("a.eds", old).into_device(), &read("b.eds", new).into_device(), &facts);
        findings
            .iter()
            .map(|finding| finding.fix.as_ref().map_or("none".into(), |fix| fix.title.to_string()))
            .collect()
    };
    let full = |text: &str| text.replace("FileRevision=0", "FileRevision=255");
    assert_eq!(
        titles(&full(&old), &full(&new)),
        ["bump the revision number to 2.0", "bump the file version to 2.0", "write the date 2030-01-31"]
    );
    // the behaviour is that of before
    let lower = old.replace("0x00010001", "0x00010000");
    assert_eq!(
        titles(&old, &lower),
        ["bump the revision number to 1.1", "bump the file version to 1.1", "write the date 2030-01-31"]
    );
    // no other number is left
    let last = |text: &str| text.replace("0x00010001", "0xFFFF0000");
    assert_eq!(titles(&last(&old), &last(&new))[0], "none");
    // a date that moved before moves with the versions
    let moved = new.replace("ModificationDate=11-18-2024", "ModificationDate=11-18-2025");
    assert_eq!(titles(&old, &moved)[2], "write the date 2030-01-31");
    let raised = moved.replace("FileRevision=0", "FileRevision=1").replace("0x00010001", "0x00020000");
    assert!(titles(&old, &raised).is_empty(), "{:?}", titles(&old, &raised));
}
