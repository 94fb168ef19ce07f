//! What is found in the devices with misprints (`fixtures/errata`) and in those with one difficulty each
//! (`fixtures/torture`): each row names all that is found, no more and no less, with its place.

use std::fs;
use std::path::{Path, PathBuf};

use objdict::diagnostic::{At, Severity};
use objdict::format;
use objdict::source::SourceOptions;

/// A file, and every finding in it as rule and place, in the order of the file.
type Row = (&'static str, &'static [(&'static str, &'static str)]);

/// The misprints. What README.md there calls `also` and the linter finds too stands below the others.
const ERRATA: &[Row] = &[
    ("a2-identity-subnumber.eds", &[("cia306/sub-number-mismatch", "0x1018 / SubNumber")]),
    // for the rules about CiA 401
    ("a4-mapping-unsigned16.eds", &[]),
    ("a7-mapping-from-sub0.eds", &[("cia301/mapping-of-count", "0x1A02sub1 / DefaultValue")]),
    ("a8-analogue-output-unsigned16.eds", &[]),
    (
        "a8-heartbeat-consumer.eds",
        &[
            ("cia301/invalid-consumer-heartbeat", "0x1016sub1 / DefaultValue"),
            ("cia301/invalid-consumer-heartbeat", "0x1016sub2 / DefaultValue"),
        ],
    ),
    ("a9-encoder-406.eds", &[("cia301/synchronous-pdo-without-sync", "0x1801sub2 / DefaultValue")]),
    (
        "a10-io-401.eds",
        &[
            ("cia306/duplicate-section", "1400sub2"),
            ("cia301/incomplete-pdo-parameter", "0x1401"),
            ("cia306/wrong-highest-sub-index", "0x1401sub0 / DefaultValue"),
            ("cia301/cob-id-collision", "0x1401sub1 / DefaultValue"),
            ("cia301/cob-id-not-predefined", "0x1401sub1 / DefaultValue"),
            ("cia301/wrong-mapping-count", "0x1A01sub0 / DefaultValue"),
            ("cia301/mapped-object-missing", "0x1A01sub1 / DefaultValue"),
        ],
    ),
    (
        "a10-mapping-from-sub0.eds",
        &[
            ("cia301/mapping-of-count", "0x1601sub1 / DefaultValue"),
            ("cia301/mapping-of-count", "0x1A01sub1 / DefaultValue"),
        ],
    ),
    ("a14-bit-rate-25.eds", &[("cia306/unknown-key", "BaudRate_25")]),
    (
        "a17-many-tpdos.eds",
        &[
            ("cia301/pdo-valid-by-default", "0x1804sub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x1819sub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x181Asub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x181Bsub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x181Csub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x181Dsub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x181Esub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x181Fsub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x1820sub1 / DefaultValue"),
            ("cia301/restricted-can-id", "0x1821sub1 / DefaultValue"),
        ],
    ),
    // for the rules about CiA 406
    ("a18-e6-encoder.eds", &[]),
    (
        "b1-b3-cs5525.eds",
        &[
            ("cia301/no-error-control", "device"),
            ("cia301/missing-mandatory-object", "MandatoryObjects"),
            ("cia301/emergency-without-cob-id", "0x1003"),
            ("cia306/missing-sub-0", "0x1003"),
            ("cia301/obsolete-object", "0x1004"),
            ("cia301/obsolete-object", "0x100B"),
            ("cia301/obsolete-object", "0x100F"),
            ("cia301/mapped-object-missing", "0x1A01sub1 / DefaultValue"),
            ("cia301/mapped-object-not-mappable", "0x1A01sub2 / DefaultValue"),
        ],
    ),
    ("c2-c4-sensor-node.eds", &[("cia301/cob-id-not-predefined", "0x1800sub1 / DefaultValue")]),
    ("d-1014-emcy-invalid.eds", &[("cia301/emergency-disabled", "0x1014 / DefaultValue")]),
    (
        "d-1021-store-eds.eds",
        &[("cia301/wrong-access", "0x1021 / AccessType"), ("cia301/wrong-access", "0x1022 / AccessType")],
    ),
    (
        "d-1027-module-list.eds",
        &[
            ("cia301/wrong-access", "0x1027sub1 / AccessType"),
            ("cia301/wrong-access", "0x1027sub2 / AccessType"),
        ],
    ),
    (
        "d-1800-timers.eds",
        &[
            ("cia301/fixed-node-id", "0x1800sub1 / DefaultValue"),
            ("cia301/reserved-pdo-sub-index", "0x1800sub4"),
        ],
    ),
    ("d-1804-cob-id.eds", &[("cia301/invalid-cob-id", "0x1804sub1 / DefaultValue")]),
];

/// The difficulties. The rows without findings are devices that are healthy.
const TORTURE: &[Row] = &[
    ("01_ok.eds", &[]),
    ("02_latin1.eds", &[("cia306/not-ascii", "ü")]),
    ("03_bom.eds", &[("cia306/byte-order-mark", "")]),
    ("04_compact_names_values.eds", &[("cia306/configuration-in-eds", "0x2000Value")]),
    ("05_unknown_key.eds", &[("cia306/unknown-key", "Unit"), ("cia306/unknown-key", "AcmeColour")]),
    ("06_unknown_section.eds", &[("cia306/unknown-section", "AcmePrivate")]),
    ("07_hex_neg_limit.eds", &[("cia306/twos-complement", "0x80000000")]),
    ("08_visible_string.eds", &[]),
    ("09_rev_nodeid.eds", &[("cia306/node-id-last", "0x80+$NODEID")]),
    ("10_lower_nodeid.eds", &[("cia306/formula-spelling", "$nodeid+0x80")]),
    ("11_lower_sections_keys.eds", &[]),
    ("12_hash_semicolon_in_name.eds", &[]),
    ("13_dup_section.eds", &[("cia306/duplicate-section", "2000")]),
    ("14_dup_key.eds", &[("cia306/duplicate-key", "DefaultValue")]),
    ("15_octal.eds", &[("cia306/octal-number", "010")]),
    ("16_sub_without_parent.eds", &[("cia306/sub-without-object", "0x2001sub1")]),
    ("17_listed_missing.eds", &[("cia306/listed-object-missing", "ManufacturerObjects / 1")]),
    ("18_unlisted.eds", &[("cia306/object-not-listed", "0x2000")]),
    ("19_pdo_map_missing_obj.eds", &[("cia301/mapped-object-missing", "0x1A00sub1 / DefaultValue")]),
    ("20_pdo_map_wrong_len.eds", &[("cia301/wrong-mapping-length", "0x1A00sub1 / DefaultValue")]),
    ("21_pdo_map_unmappable.eds", &[("cia301/mapped-object-not-mappable", "0x1A00sub1 / DefaultValue")]),
    ("22_default_overflow.eds", &[("cia306/invalid-value", "0x2000 / DefaultValue")]),
    ("23_bad_accesstype.eds", &[("cia306/invalid-value", "0x2000 / AccessType")]),
    ("24_bad_datatype.eds", &[("cia306/undefined-data-type", "0x2000 / DataType")]),
    ("25_low_gt_high.eds", &[("cia306/low-limit-above-high", "0x2000 / LowLimit")]),
    ("26_no_accesstype_var.eds", &[("cia306/missing-key", "0x2000 / AccessType")]),
    ("27_baudrate100.eds", &[("cia306/unknown-key", "BaudRate_100")]),
    ("28_real32_dec.eds", &[]),
    ("29_objectlinks_modules.eds", &[]),
    ("30_comments_preserved.eds", &[]),
    ("31_time_of_day.eds", &[]),
    ("32_missing_1018.eds", &[("cia301/missing-mandatory-object", "MandatoryObjects")]),
    ("33_compactpdo.eds", &[]),
    ("34_crlf.eds", &[]),
];

fn fixtures(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(folder)
}

fn check(path: &Path) -> Vec<(&'static str, Severity, String)> {
    let description = match format::open(path, &SourceOptions::default()) {
        Ok(description) => description,
        Err(error) => panic!("{}: {error}", path.display()),
    };
    let findings = objdict::check(&description);
    let place = |at: &At| match at {
        At::Place(place) => place.to_string(),
        At::Span(span) => span.of(description.source().text()).trim().to_owned(),
    };
    findings.iter().map(|finding| (finding.rule.id, finding.severity, place(&finding.labels[0].at))).collect()
}

fn assert_rows(folder: &str, rows: &[Row]) {
    let mut wrong = Vec::new();
    for &(file, expected) in rows {
        let found = check(&fixtures(folder).join(file));
        let found: Vec<(&str, &str)> = found.iter().map(|(rule, _, place)| (*rule, place.as_str())).collect();
        if found != expected {
            wrong.push(format!("{folder}/{file}: found {found:#?}, expected {expected:#?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let mut files: Vec<String> = fs::read_dir(fixtures(folder))
        .into_iter()
        .flatten()
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.ends_with(".eds"))
        .collect();
    files.sort();
    let mut named: Vec<&str> = rows.iter().map(|(file, _)| *file).collect();
    named.sort_unstable();
    assert_eq!(files, named, "every file of {folder} has a row");
}

#[test]
fn every_misprint_is_found() {
    assert_rows("errata", ERRATA);
}

#[test]
fn every_difficulty_gets_its_verdict() {
    assert_rows("torture", TORTURE);
}

#[test]
fn what_readers_must_bear_is_no_error() {
    for number in ["01", "04", "05", "06", "07", "08", "10", "11", "12", "27", "28", "30", "31", "33", "34"] {
        let row = TORTURE.iter().find(|(file, _)| file.starts_with(number));
        let (file, _) = row.unwrap_or_else(|| panic!("no row {number}"));
        for (rule, severity, place) in check(&fixtures("torture").join(file)) {
            assert_eq!(severity, Severity::Note, "{file}: {rule} at {place}");
        }
    }
}

#[test]
fn what_no_tool_can_know_is_an_error() {
    for number in ["13", "14", "16", "17", "18", "19", "20", "21", "22", "23", "24", "25", "26", "32"] {
        let row = TORTURE.iter().find(|(file, _)| file.starts_with(number));
        let (file, _) = row.unwrap_or_else(|| panic!("no row {number}"));
        let found = check(&fixtures("torture").join(file));
        assert!(found.iter().any(|(_, severity, _)| *severity == Severity::Error), "{file}: {found:?}");
    }
}
