//! Fixes: what they leave alone, and that nothing new is wrong afterwards. Every file of the fixtures is fixed, the
//! malformed ones above all.

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

use objdict::diagnostic::{Applicability, Findings, Fix, Severity, Tool};
use objdict::format::{self, Description, Format};
use objdict::lint::Options;
use objdict::source::{Edits, SourceFile, SourceOptions};
use objdict::{AppliedFix, Fixed, check, check_with, fix, fix_for_readers, with_sound_fixes};
use serde_json::Value::Null;

use crate::support;
use crate::support::skips::sample;

pub(crate) fn folders(folder: &Path, files: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        if path.is_dir() {
            folders(&path, files);
        } else if ["eds", "dcf", "xdd", "xdc", "nxdd"].contains(&ending) {
            files.push(path);
        }
    }
}

/// The files with the descriptions of the fixtures.
fn files() -> Vec<PathBuf> {
    let mut files = Vec::new();
    folders(&support::fixtures(), &mut files);
    assert!(files.len() > 300);
    files
}

fn descriptions() -> Vec<Description> {
    read_all(&files())
}

fn read_all(files: &[PathBuf]) -> Vec<Description> {
    files.iter().filter_map(|path| format::open(path, &SourceOptions::default()).ok()).collect()
}

fn copy(description: &Description) -> Description {
    read(description, description.source().to_bytes())
}

fn read(like: &Description, bytes: Vec<u8>) -> Description {
    let mut options = SourceOptions::default();
    options.encoding = Some(like.source().encoding());
    format::read(SourceFile::from_bytes(like.source().name(), bytes, &options).unwrap(), like.format())
}

fn counts(findings: &Findings) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    findings.iter().for_each(|finding| *counts.entry(finding.rule.id).or_default() += 1);
    counts
}

/// What fixing a description did, held against what it promises.
fn assert_fixed(description: &Description, safety: Applicability, before: &BTreeMap<&str, usize>) -> Fixed {
    let fixed = fix(copy(description), safety, check);
    let name = description.source().name();
    let after = counts(&fixed.findings);
    for (rule, count) in &after {
        assert!(Some(count) <= before.get(rule), "{name}: {rule} {count} times, {before:?} before");
    }
    for rule in fixed.applied.iter().map(|repair| repair.rule).collect::<BTreeSet<_>>() {
        assert!(after.get(rule) < before.get(rule), "{name}: {rule} is still there");
    }
    let bytes = fixed.bytes();
    assert_eq!(fixed.applied.is_empty(), bytes == description.print(), "{name}");
    let again = read(&fixed.description, bytes);
    assert_eq!(again.device(), fixed.description.device(), "{name}: what is written is read the same");
    fixed
}

#[test]
fn findings_go_and_none_come() {
    for description in descriptions() {
        let findings = check(&description);
        let before = counts(&findings);
        for safety in [Applicability::Safe, Applicability::Unsafe] {
            let is_fixable = |fix: &Fix| fix.safety == safety && description.can_fix(fix);
            if !findings.iter().filter_map(|finding| finding.fix.as_ref()).any(is_fixable) {
                continue;
            }
            let fixed = assert_fixed(&description, safety, &before);
            let again = fix(copy(&fixed.description), safety, check);
            let name = description.source().name();
            assert!(again.applied.is_empty(), "{name}: fixed again: {:?}", again.applied);
        }
    }
}

#[test]
fn no_fix_makes_a_warning_an_error() {
    // a formula has no value without `[DeviceComissioning]`, whose absence is a warning as long as there is no formula
    let text = std::fs::read_to_string(support::fixtures().join("dcf/io-401-node5.dcf")).unwrap();
    let section = text.find("[DeviceComissioning]").unwrap();
    let after = section + 1 + text[section + 1..].find("\n[").unwrap();
    let text = format!("{}{}", &text[..section], &text[after + 1..]);
    let text = text.replacen("$NODEID+0x80", "$NODE_ID+0x80", 1).replace("$NODEID+", "");
    let source = SourceFile::from_bytes("a.dcf", text.into_bytes(), &SourceOptions::default()).unwrap();
    let description = format::read(source, Format::Dcf);
    let errors =
        |findings: &Findings| findings.iter().filter(|finding| finding.severity == Severity::Error).count();
    let severity = |findings: &Findings| {
        findings.iter().find(|f| f.rule.id == "cia306/missing-commissioning").unwrap().severity
    };
    assert_eq!(severity(&check(&description)), Severity::Warning);
    let before = errors(&check(&description));
    let fixed = fix(description, Applicability::Unsafe, check);
    assert_eq!(severity(&fixed.findings), Severity::Warning, "{:?}", fixed.applied);
    assert!(errors(&fixed.findings) <= before && !fixed.skipped.is_empty());
}

#[test]
fn each_fix_alone_fixes_its_finding() {
    let mut failures = String::new();
    for description in descriptions() {
        let findings = check(&description);
        let before = counts(&findings);
        let mut seen = BTreeSet::new();
        for finding in &findings {
            let Some(fix) = &finding.fix else { continue };
            let is_declared = finding.rule.fix.is_some_and(|declared| declared.has(fix.safety));
            assert!(is_declared, "{} does not declare its {} fix", finding.rule.id, fix.safety);
            let Some(edits) = description.edits(fix).filter(|_| seen.insert(finding.rule.id)) else {
                continue;
            };
            assert!(edits.windows(2).all(|pair| pair[0].0.end <= pair[1].0.start), "the edits are in order");
            let mut text = Edits::new(description.source());
            edits.iter().for_each(|(span, new)| text.replace(*span, new.as_str()));
            let fixed = read(&description, text.to_bytes().unwrap());
            let after = counts(&check(&fixed));
            let name = description.source().name();
            if after.get(finding.rule.id) >= before.get(finding.rule.id) {
                writeln!(failures, "{name}: {}: {}", finding.rule.id, finding.message).unwrap();
            }
        }
    }
    assert!(failures.is_empty(), "{failures}");
}

/// The fixes that reports offer of a description, up to a safety, with the text that they make together.
fn offers(description: &Description, safety: Applicability) -> (Vec<AppliedFix>, Vec<u8>) {
    let findings = with_sound_fixes(description, check(description), check);
    let mut edits = Edits::new(description.source());
    let (mut encoding, mut offers) = (description.source().encoding(), Vec::new());
    for finding in &findings {
        let Some(fix) = finding.fix.as_ref().filter(|fix| fix.is_offered && fix.safety <= safety) else {
            continue;
        };
        let (message, title) = (finding.message.to_string(), fix.title.to_string());
        encoding = description.encoding_of(fix).unwrap_or(encoding);
        let changes = description.edits(fix).unwrap_or_default();
        changes.into_iter().for_each(|(span, text)| edits.replace(span, text));
        offers.push(AppliedFix { rule: finding.rule.id, message, title });
    }
    (offers, encoding.encode(&edits.text().expect("offers do not overlap")).unwrap())
}

/// In a sample; `findings_go_and_none_come` and `each_fix_alone_fixes_its_finding` make the fixes of every fixture.
#[test]
fn reports_offer_what_is_made() {
    let (mut offered, mut at_once) = (0, 0);
    let descriptions = read_all(&sample(files()));
    for description in &descriptions {
        for safety in [Applicability::Safe, Applicability::Unsafe] {
            let (offers, bytes) = offers(description, safety);
            let fixed = fix(copy(description), safety, check);
            let name = description.source().name();
            for offer in &offers {
                assert!(fixed.applied.contains(offer), "{name}: {offer:?} is not made");
            }
            assert_eq!(offers.is_empty(), fixed.applied.is_empty(), "{name}: {:?}", fixed.applied);
            offered += offers.len();
            at_once += usize::from(!offers.is_empty() && bytes == fixed.bytes());
            let rest = fix(read(description, bytes), safety, check);
            assert_eq!(rest.bytes(), fixed.bytes(), "{name}: the offers are what `--fix` begins with");
        }
    }
    // of the fixtures of rules, more than every fourth
    let least = descriptions.len() / 5;
    assert!(offered > least && at_once > least, "{offered} offers, {at_once} files need no second round");
}

/// A fix that does harm does not keep a large file from the others: they are tried without it.
#[test]
fn a_large_file_is_offered_the_fixes_that_do_no_harm() {
    let minimal = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let mut text = minimal.replace("FileName=minimal.eds", "FileName=other.eds");
    text.push_str(
        "\r\n[2000]\r\nParameterName=Axis\r\nObjectType=9\r\nSubNumber=1\r\n\
         \r\n[2000sub0]\r\nParameterName=Count\r\nObjectType=7\r\nDataType=4\r\n\
         AccessType=const\r\nDefaultValue=0\r\nPDOMapping=0\r\n",
    );
    text.push_str(&format!("; {}\r\n", "-".repeat(200)).repeat(6000));
    assert!(text.len() > 1 << 20);
    let description = format::read(SourceFile::from_text("minimal.eds", text), Format::Eds);
    let findings = check(&description);
    let wrong_name = findings.iter().find(|finding| finding.rule.id == "cia306/file-name").unwrap().clone();
    let checks = Cell::new(0);
    let check = |description: &Description| {
        checks.set(checks.get() + 1);
        let mut findings = check(description);
        if !description.source().text().contains("FileName=other.eds") {
            findings.push(wrong_name.clone());
        }
        findings
    };
    let findings = with_sound_fixes(&description, findings, check);
    let fixes = findings.iter().filter(|finding| finding.fix.as_ref().is_some_and(|fix| fix.is_offered));
    let offered: Vec<&str> = fixes.map(|finding| finding.rule.id).collect();
    assert!(offered.contains(&"cia306/sub-0-type") && !offered.contains(&"cia306/file-name"), "{offered:?}");
    assert!(checks.get() <= 3, "{} checks", checks.get());
}

/// A type that the limits do not fit is no fix: each offer is tried, and one that does harm costs the others a trial.
#[test]
fn no_type_is_written_that_the_numbers_of_an_entry_do_not_fit() {
    let minimal = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let sub = |count: &str, limit: &str| {
        format!(
            "\r\n[2000]\r\nParameterName=Axis\r\nObjectType=9\r\nSubNumber=1\r\n\
             \r\n[2000sub0]\r\nParameterName=Count\r\nObjectType=7\r\nDataType=3\r\nAccessType=ro\r\n\
             DefaultValue={count}\r\n{limit}PDOMapping=0\r\n"
        )
    };
    for (count, limit, fits) in [
        ("0", "", true),
        ("0", "HighLimit=255\r\n", true),
        ("0", "HighLimit=32767\r\n", false),
        ("0", "LowLimit=-1\r\n", false),
        ("300", "", false),
    ] {
        let text = format!("{minimal}{}", sub(count, limit));
        let description = format::read(SourceFile::from_text("minimal.eds", text), Format::Eds);
        let findings = check(&description);
        let found = findings.iter().find(|finding| finding.rule.id == "cia306/sub-0-type").unwrap();
        assert_eq!(found.fix.is_some(), fits, "{count} {limit}");
    }
}

/// What readers refuse although CiA 306 allows it is fixed without `--compat`, and unread lines become comments.
#[test]
fn readers_read_what_is_fixed_for_no_certain_tool() {
    let device = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let fixed = |text: &[u8]| {
        let source = SourceFile::from_bytes("minimal.eds", text.to_vec(), &SourceOptions::default()).unwrap();
        let description = format::read(source, Format::Eds);
        let fixed = fix_for_readers(description, Applicability::Safe, &Default::default());
        assert_eq!(
            fixed.bytes(),
            fix_for_readers(copy(&fixed.description), Applicability::Safe, &Default::default()).bytes()
        );
        String::from_utf8(fixed.bytes()).unwrap()
    };
    let vendor = device.split_once("VendorNumber=").unwrap().1.split_once("\r\n").unwrap().0;
    let cases = [
        (format!("VendorNumber={vendor}\r\n"), "VendorNumber=\r\n", ""),
        ("[1001]\r\n".into(), "[1001]\r\nparametername=Error register\r\n", "[1001]\r\nParameterName=Error"),
        ("[1001]\r\n".into(), "'.\r\n[1001]\r\n", "; '.\r\n[1001]\r\n"),
        (
            "[1001]\r\n".into(),
            "[1000]\r\nParameterName=Other\r\n[1001]\r\n",
            "; [1000]\r\n; ParameterName=Other\r\n",
        ),
        ("VendorName=".into(), "VendorName=First\r\nVendorName=", "VendorName=First\r\n; VendorName="),
    ];
    for (old, new, expected) in cases {
        let text = fixed(device.replacen(&old, new, 1).as_bytes());
        assert!(text.contains(expected) && !text.contains("VendorNumber=\r\n"), "{new}: {text}");
    }
    // code page 850 and Windows-1252
    for (letter, name) in [(0x94, "Sch\u{f6}naich"), (0xE9, "Sch\u{e9}naich")] {
        let (before, after) = device.split_once("VendorName=").unwrap();
        let text =
            [before.as_bytes(), b"VendorName=Sch", &[letter], b"naich\r\n;", after.as_bytes()].concat();
        assert!(fixed(&text).contains(&format!("VendorName={name}\r\n")));
    }
}

/// Junk before the header of a general section does not hide the section, and becomes a comment.
#[test]
fn a_section_behind_junk_is_read() {
    for junk in ["50", "]\u{E}"] {
        let text = format!("{junk}[FileInfo]\r\nFileName=a.eds\r\n[DeviceInfo]\r\nProductName=Lamp\r\n");
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let name = |description: &Description| description.device().file_info.clone()?.file_name;
        assert_eq!(name(&description).as_deref(), Some("a.eds"));
        let fixed = fix(description, Applicability::Safe, check).description;
        let text = fixed.source().text();
        assert!(text.starts_with("; ") && text.contains("\r\n[FileInfo]\r\n"), "{text}");
        assert_eq!(name(&fixed).as_deref(), Some("a.eds"));
    }
    let minimal = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let text = minimal.replace("[1000]", "50[1000]").replace("[1018sub1]", "0[1018sub1]");
    let description = format::read(SourceFile::from_text("minimal.eds", text), Format::Eds);
    assert_eq!(
        meaning(&description),
        meaning(&format::read(SourceFile::from_text("minimal.eds", minimal), Format::Eds))
    );
    let fixed = fix(description, Applicability::Safe, check).description;
    assert!(fixed.source().text().contains("; 50\r\n[1000]\r\n"), "{}", fixed.source().text());
}

/// What is plainly meant stops no table, and what may have been a key, a header or another value does. A safe fix of the first
/// leaves nothing to find.
#[test]
fn what_is_unambiguous_stops_no_table() {
    let eds = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let octets = |default: &str| {
        let object =
            "[2000]\r\nParameterName=Key\r\nObjectType=7\r\nDataType=10\r\nAccessType=rw\r\nDefaultValue=";
        format!("{eds}{object}{default}\r\n")
    };
    let xdd = std::fs::read_to_string(support::fixtures().join("xdd/io-401.xdd")).unwrap();
    let cases = [
        ("cia306/junk-line", true, eds.replace("[FileInfo]", "50[FileInfo]")),
        ("cia306/junk-line", true, eds.replace("[1018sub1]", "50[1018sub1]")),
        ("cia306/junk-line", true, format!("1\r\nA device of prose\r\n{eds}")),
        (
            "cia306/junk-line",
            true,
            eds.replace("[1000]\r\n", "[1000]\r\n; the type, as\r\nCiA has it\r\nin 301\r\n"),
        ),
        ("cia306/junk-line", true, eds.replace("[1000]\r\n", "[1000]\r\n'.\r\n")),
        ("cia306/junk-line", false, eds.replace("[1000]\r\n", "[1000]\r\nCiA has it\r\n")),
        ("cia306/junk-line", false, eds.replace("[1000]\r\n", "[1000]\r\n; the type\r\nDataType 7\r\n")),
        ("cia306/junk-line", false, eds.replace("[1000]\r\n", "[1000]\r\n;\r\n=======\r\n")),
        ("cia306/junk-line", false, format!("<<<<<<< HEAD\r\n{eds}")),
        ("cia306/invalid-value", true, octets("Motor 1")),
        ("cia306/invalid-value", true, octets("\"1 a\"")),
        ("cia306/invalid-value", false, octets("\"12\"")),
        ("cia306/invalid-value", false, octets("012")),
        ("cia311/invalid-hex", true, xdd.replace("subIndex=\"0", "subIndex=\"000")),
        ("cia311/invalid-hex", false, xdd.replacen("subIndex=\"01", "subIndex=\"0101", 1)),
    ];
    for (rule, is_clear, text) in cases {
        let format = if rule.starts_with("cia311") { Format::Xdd } else { Format::Eds };
        let description = format::read(SourceFile::from_text("device", text.clone()), format);
        let of_rule = |description: &Description| {
            check(description).iter().filter(|finding| finding.rule.id == rule).cloned().collect::<Vec<_>>()
        };
        let found = of_rule(&description);
        assert!(!found.is_empty(), "{rule}: {text}");
        assert_eq!(!found.iter().any(|finding| finding.stops("c")), is_clear, "{found:?}");
        if is_clear {
            let fixed = fix(description, Applicability::Safe, check).description;
            assert!(of_rule(&fixed).is_empty(), "{}", fixed.source().text());
        }
    }
}

/// Hex digits of all bits are no limit, and only for a tool that refuses them the number is written.
#[test]
fn a_lone_high_limit_of_all_bits_limits_nothing() {
    let minimal = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let object = "\r\n[2000]\r\nParameterName=Position\r\nObjectType=7\r\nDataType=4\r\nAccessType=rw\r\nHighLimit=0xFFFFFFFF\r\n";
    let read =
        || format::read(SourceFile::from_text("minimal.eds", format!("{minimal}{object}")), Format::Eds);
    let limit =
        |device: &objdict::model::Device| device.object(0x2000)?.main.high_limit.as_ref()?.as_integer();
    assert_eq!(limit(read().device()), Some(i32::MAX.into()));
    let plain = fix_for_readers(read(), Applicability::Safe, &Default::default()).description;
    assert!(plain.source().text().contains("HighLimit=0xFFFFFFFF"));
    let options = Options { tools: vec![Tool::DcfTools], ..Options::default() };
    let fixed = fix(read(), Applicability::Safe, |description| check_with(description, &options)).description;
    assert!(fixed.source().text().contains("HighLimit=2147483647"), "{}", fixed.source().text());
}

/// The JSON of a device without what is kept of invalid and unknown texts, and with the type and access that a DOMAIN implies.
fn meaning(description: &Description) -> serde_json::Value {
    fn strip(value: &mut serde_json::Value) {
        if let Some(fields) = value.as_object_mut() {
            fields.retain(|name, _| !["invalid_values", "extra"].contains(&name.as_str()));
            fields.values_mut().for_each(strip);
        }
    }
    let mut device = description.device().clone();
    for object in device.objects.values_mut() {
        for entry in std::iter::once(&mut object.main).chain(object.subs.iter_mut().map(|(_, entry)| entry)) {
            (entry.data_type, entry.access) = (entry.implied_type(), entry.implied_access());
        }
    }
    let mut json = serde_json::to_value(&device).unwrap();
    strip(&mut json);
    json
}

/// Data that repeat others of the file: counts and lists of what is described, and missing parts that mean what is added.
const REDUNDANT: [&str; 9] = [
    "/lists",
    "/comments",
    "/dummy_usage",
    "/declared",
    "/extension_list",
    "/sub_number",
    "/rpdo_count",
    "/tpdo_count",
    "/compact_pdo",
];

/// What differs between two JSON values, as paths: not what is redundant, not a data type that was missing and that the standard fixes or
/// the value that was text without it, and not of a part with an invalid text.
fn differences(path: &str, old: &serde_json::Value, new: &serde_json::Value, found: &mut Vec<String>) {
    let is_missing = path.ends_with("/data_type") && old.is_null() || old.get("raw").is_some();
    if is_missing || REDUNDANT.iter().any(|part| path.ends_with(part)) || old.get("misfits").is_some() {
        return;
    }
    match (old.as_object(), new.as_object()) {
        (Some(left), Some(right)) => {
            for name in left.keys().chain(right.keys()).collect::<BTreeSet<_>>() {
                let (old, new) = (left.get(name).unwrap_or(&Null), right.get(name).unwrap_or(&Null));
                differences(&format!("{path}/{name}"), old, new, found);
            }
        }
        _ if old != new => found.push(format!("{path}: {old} became {new}")),
        _ => {}
    }
}

/// Over the fixtures and, with `OBJDICT_CORPUS_DIR`, the files below that folder.
#[test]
fn safe_fixes_leave_the_device_as_it_is() {
    let mut changed = String::new();
    let mut others = Vec::new();
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        folders(Path::new(&folder), &mut others);
    }
    for description in descriptions().into_iter().chain(read_all(&others)) {
        let before = meaning(&description);
        let name = description.source().name().to_owned();
        let fixed = fix_for_readers(description, Applicability::Safe, &Default::default());
        let mut found = Vec::new();
        differences("", &before, &meaning(&fixed.description), &mut found);
        let rules: BTreeSet<&str> = fixed.applied.iter().map(|applied| applied.rule).collect();
        if !found.is_empty() {
            writeln!(changed, "{name} {rules:?}: {}", found.join("; ")).unwrap();
        }
    }
    assert!(changed.is_empty(), "{changed}");
}

/// A rule that is not selected is not fixed, and neither are the spellings that readers refuse.
/// Both versions of a merge conflict are in the file: what repeats or miscounts in it is what the other version needs.
#[test]
fn a_file_with_conflict_markers_is_not_fixed() {
    let tools = || Options { tools: Tool::ALL.to_vec(), ..Options::default() };
    let formats = [Format::Eds, Format::Dcf, Format::Xdd, Format::Xdc];
    let names = ["eds/io-401.eds", "dcf/io-401-node5.dcf", "xdd/io-401.xdd", "xdc/io-401-node5.xdc"];
    for (name, format) in names.into_iter().zip(formats) {
        let text = std::fs::read_to_string(support::fixtures().join(name)).unwrap().replace("\r\n", "\n");
        let is_xml = text.starts_with('<');
        // an octal number and a wrong date, which are fixed without the markers
        let text = match is_xml {
            false => text.replacen("FileRevision=", "FileRevision=010\nCreationDate=2024-03-04\n;", 1),
            true => text.replacen("index=\"1017\"", "index=\"1017\" highLimit=\"010\"", 1),
        };
        let (start, end) =
            if is_xml { ("<CANopenObject index=\"1017\"", "/>\n") } else { ("[1017]", "\n\n") };
        let start = text.find(start).unwrap();
        let end = start + text[start..].find(end).unwrap() + end.len();
        let object = &text[start..end];
        let with = |marks: [&str; 3]| {
            let [first, middle, last] = marks;
            format!("{}{first}{object}{middle}{object}{last}{}", &text[..start], &text[end..])
        };
        let described = |text: String| {
            format::read(SourceFile::from_text(name.rsplit('/').next().unwrap(), text), format)
        };
        let twice = described(with([""; 3]));
        assert!(!fix(twice, Applicability::Unsafe, check).applied.is_empty(), "{name} can be fixed");
        let conflict = with(["\n<<<<<<< HEAD\n", "\n=======\n", "\n>>>>>>> other\n"]);
        for options in [Options::default(), tools()] {
            let findings = check_with(&described(conflict.clone()), &options);
            let rules: BTreeSet<&str> = findings.iter().map(|finding| finding.rule.id).collect();
            let only = if is_xml { "xml/lone-less-than" } else { "cia306/junk-line" };
            assert_eq!(rules, BTreeSet::from([only]), "{name}");
            assert!(findings.iter().all(|finding| finding.fix.is_none() && finding.help.is_some()));
            let fixed = fix_for_readers(described(conflict.clone()), Applicability::Unsafe, &options);
            assert!(fixed.applied.is_empty() && fixed.bytes() == conflict.as_bytes(), "{name}");
        }
    }
}

#[test]
fn only_selected_rules_are_fixed() {
    let text = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let text = text.replace("[1001]\r\nParameterName", "[1001]\r\nparametername");
    let fixed = |rule: Option<&str>| {
        let mut options = Options::default();
        if let Some(rule) = rule {
            options.severities.select(objdict::registry::select(rule).unwrap());
        }
        let description = format::read(SourceFile::from_text("minimal.eds", &text), Format::Eds);
        String::from_utf8(fix_for_readers(description, Applicability::Safe, &options).bytes()).unwrap()
    };
    assert!(fixed(None).contains("[1001]\r\nParameterName"));
    assert_eq!(fixed(Some("cia306/file-name")), text);
}
