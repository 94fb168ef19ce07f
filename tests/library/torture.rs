//! One difficulty per file: `fixtures/torture`, with the verdicts of the README there.

use std::collections::BTreeMap;

use objdict::diagnostic::Applicability;
use objdict::format::{self, Description, Format};
use objdict::model::{Access, Commissioning, Device, ObjectList, PdoKind, Value};
use objdict::profile::of_object;
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

/// Line, severity and rule of a finding.
type Verdict = (u32, &'static str, &'static str);

/// What is found in each file, all of it.
const VERDICTS: &[(&str, &[Verdict])] = &[
    ("01_ok", &[]),
    ("02_latin1", &[(135, "warning", "cia306/not-ascii")]),
    ("03_bom", &[(1, "warning", "cia306/byte-order-mark")]),
    ("04_compact_names_values", &[(148, "note", "cia306/configuration-in-eds")]),
    ("05_unknown_key", &[(137, "note", "cia306/unknown-key"), (141, "note", "cia306/unknown-key")]),
    ("06_unknown_section", &[(142, "note", "cia306/unknown-section")]),
    ("07_hex_neg_limit", &[(141, "note", "cia306/twos-complement")]),
    ("08_visible_string", &[]),
    ("09_rev_nodeid", &[(128, "warning", "cia306/node-id-last")]),
    ("10_lower_nodeid", &[(128, "note", "cia306/formula-spelling")]),
    ("11_lower_sections_keys", &[]),
    ("12_hash_semicolon_in_name", &[]),
    ("13_dup_section", &[(142, "error", "cia306/duplicate-section")]),
    ("14_dup_key", &[(140, "error", "cia306/duplicate-key")]),
    ("15_octal", &[(139, "warning", "cia306/octal-number")]),
    ("16_sub_without_parent", &[(133, "error", "cia306/sub-without-object")]),
    ("17_listed_missing", &[(132, "error", "cia306/listed-object-missing")]),
    ("18_unlisted", &[(133, "error", "cia306/object-not-listed")]),
    ("19_pdo_map_missing_obj", &[(195, "error", "cia301/mapped-object-missing")]),
    ("20_pdo_map_wrong_len", &[(195, "error", "cia301/wrong-mapping-length")]),
    ("21_pdo_map_unmappable", &[(195, "error", "cia301/mapped-object-not-mappable")]),
    ("22_default_overflow", &[(139, "error", "cia306/invalid-value")]),
    ("23_bad_accesstype", &[(138, "error", "cia306/invalid-value")]),
    ("24_bad_datatype", &[(137, "error", "cia306/undefined-data-type")]),
    ("25_low_gt_high", &[(141, "error", "cia306/low-limit-above-high")]),
    ("26_no_accesstype_var", &[(134, "error", "cia306/missing-key")]),
    ("27_baudrate100", &[(24, "note", "cia306/unknown-key")]),
    ("28_real32_dec", &[]),
    (
        "29_objectlinks_modules",
        &[(51, "warning", "cia301/missing-module-list"), (54, "warning", "cia306/module-without-objects")],
    ),
    ("30_comments_preserved", &[]),
    ("31_time_of_day", &[]),
    ("32_missing_1018", &[(51, "error", "cia301/missing-mandatory-object")]),
    ("33_compactpdo", &[]),
    ("34_crlf", &[]),
];

fn open(stem: &str) -> Description {
    let path = support::fixtures().join("torture").join(format!("{stem}.eds"));
    format::open(&path, &SourceOptions::default()).unwrap()
}

fn device(stem: &str) -> Device {
    open(stem).into_device()
}

#[test]
fn every_file_gets_its_verdict() {
    for (stem, expected) in VERDICTS {
        let description = open(stem);
        let findings = objdict::check(&description);
        let found: Vec<(u32, String, &str)> = findings
            .iter()
            .map(|finding| {
                let start = description.span_of(&finding.labels[0].at).start;
                let line = description.source().line_column(start).line;
                (line, finding.severity.to_string(), finding.rule.id)
            })
            .collect();
        let found: Vec<(u32, &str, &str)> =
            found.iter().map(|(line, severity, rule)| (*line, severity.as_str(), *rule)).collect();
        assert_eq!(found, *expected, "{stem}");
    }
}

#[test]
fn every_file_has_a_verdict() {
    let verdicts: BTreeMap<&str, _> = VERDICTS.iter().copied().collect();
    let files = support::files("torture", &["eds"]);
    assert_eq!(files.len(), verdicts.len());
    for file in files {
        let stem = file.file_stem().unwrap().to_str().unwrap();
        assert!(verdicts.contains_key(stem), "{stem}");
    }
}

#[test]
fn both_places_of_a_repetition_are_named() {
    for (stem, first) in [("13_dup_section", 130), ("14_dup_key", 139)] {
        let description = open(stem);
        let findings = objdict::check(&description);
        let finding = findings.iter().next().unwrap();
        let start = description.span_of(&finding.labels[1].at).start;
        assert_eq!(description.source().line_column(start).line, first, "{stem}");
    }
}

#[test]
fn the_right_access_type_is_suggested() {
    let findings = objdict::check(&open("23_bad_accesstype"));
    let help = findings.iter().next().unwrap().help.as_ref().unwrap().shown();
    assert!(help.contains("did you mean `rw`"), "{help}");
}

#[test]
fn names_are_whole() {
    let name = |stem: &str| device(stem).object(0x2000).unwrap().name().to_owned();
    assert_eq!(name("02_latin1"), "Kühlwasser °C");
    assert_eq!(name("12_hash_semicolon_in_name"), "Valve #2; inlet side");
}

#[test]
fn values_are_what_the_text_means() {
    let entry = |stem: &str| device(stem).entry(0x2000, 0).unwrap().into_owned();
    let default = |stem: &str| entry(stem).default;
    assert_eq!(entry("07_hex_neg_limit").low_limit, Some(Value::Signed(-2_147_483_648)));
    for stem in ["09_rev_nodeid", "10_lower_nodeid"] {
        assert_eq!(device(stem).entry(0x1014, 0).unwrap().default, Some(Value::NodeId(0x80)), "{stem}");
    }
    assert_eq!(default("13_dup_section"), Some(Value::Unsigned(4)));
    assert_eq!(default("14_dup_key"), Some(Value::Unsigned(3)));
    assert_eq!(default("15_octal"), Some(Value::Unsigned(8)));
    assert_eq!(default("22_default_overflow"), None);
    assert_eq!(entry("23_bad_accesstype").access, None::<Access>);
    assert_eq!(default("28_real32_dec"), Some(Value::Real32(1.5)));
    assert_eq!(default("31_time_of_day"), None);
}

#[test]
fn a_compact_array_has_its_names_and_values() {
    let device = device("04_compact_names_values");
    let entries = device.object(0x2000).unwrap().entries();
    let members: Vec<(String, Option<i128>)> = entries
        .skip(1)
        .map(|(_, entry)| (entry.name.to_string(), entry.value().and_then(Value::as_integer)))
        .collect();
    let expected = [("Level of tank 1", 25), ("Level2", 75), ("Level3", 25), ("Level of the drain", 5)];
    assert_eq!(members, expected.map(|(name, value)| (name.to_owned(), Some(value))));
}

#[test]
fn what_the_standard_does_not_have_is_kept() {
    let unknown = device("05_unknown_key");
    let entry = &unknown.object(0x2000).unwrap().main;
    assert!(entry.extra.get("AcmeColour").is_some());
    let unit = entry.parameter.as_ref().and_then(|parameter| parameter.unit.as_ref());
    assert_eq!(unit.and_then(|unit| unit.labels.name_in("en")), Some("l/min"));
    assert!(device("06_unknown_section").extra.iter().any(|section| section.name() == "AcmePrivate"));
    let info = device("27_baudrate100").device_info.unwrap();
    assert_eq!(info.extra.get("BaudRate_100"), Some("1"));
}

#[test]
fn links_and_modules_reach_the_model() {
    let device = device("29_objectlinks_modules");
    assert!(!device.object(0x2000).unwrap().links.is_empty());
    assert_eq!(device.modules.unwrap().supported.len(), 1);
}

#[test]
fn a_byte_order_mark_hides_nothing() {
    let info = device("03_bom").file_info.unwrap();
    assert_eq!(info.file_name.as_deref(), Some("03_bom.eds"));
}

#[test]
fn a_formula_turned_around_is_fixed() {
    let fixed = objdict::fix(open("09_rev_nodeid"), Applicability::Safe, objdict::check);
    assert!(fixed.findings.is_empty());
    let text = fixed.description.source().text();
    assert!(text.contains("DefaultValue=$NODEID+0x80"), "{text}");
}

#[test]
fn comments_survive_an_edit() {
    let description = open("30_comments_preserved");
    let comments =
        |text: &str| text.lines().filter(|line| line.starts_with(';')).map(str::to_owned).collect::<Vec<_>>();
    let before = comments(description.source().text());
    assert!(!before.is_empty());
    let node = Commissioning { node_id: Some(5), ..Commissioning::default() };
    let dcf = String::from_utf8(description.to_node("node.dcf", &node).unwrap()).unwrap();
    assert!(dcf.contains("[DeviceComissioning]"));
    assert_eq!(comments(&dcf), before);
}

#[test]
fn pdos_that_no_section_describes_are_implied() {
    let implicit = device("33_compactpdo").implicit_pdos();
    assert_eq!(implicit, [(PdoKind::Tpdo, 1), (PdoKind::Tpdo, 2)]);
}

#[test]
fn line_ends_stay_as_they_are() {
    let bytes = open("34_crlf").print();
    assert!(bytes.windows(2).all(|pair| pair[1] != b'\n' || pair[0] == b'\r'));
}

/// A list whose section is there twice has the indexes of both.
#[test]
fn a_repeated_list_is_read_to_its_end() {
    let text = "[OptionalObjects]\nSupportedObjects=1\n1=0x1008\n\n[OptionalObjects]\nSupportedObjects=2\n1=0x1008\n2=0x100A\n";
    let device = format::read(SourceFile::from_text("twice.eds", text), Format::Eds).into_device();
    assert_eq!(device.lists.get(ObjectList::Optional), [0x1008, 0x100A]);
}

/// Only the profile of drives repeats its objects each 800h.
#[test]
fn other_profiles_describe_one_logical_device() {
    let text = |profile: u16| {
        format!("[1000]\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue={profile}\n")
    };
    let described = |profile, index| {
        let source = SourceFile::from_text("profile.eds", text(profile));
        let device = format::read(source, Format::Eds).into_device();
        of_object(&device, index).count()
    };
    assert!(described(402, 0x6840) == 1 && described(401, 0x6200) == 1);
    assert_eq!(described(401, 0x6A00), 0);
}
