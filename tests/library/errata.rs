//! Devices as they were printed, with their misprints: `fixtures/errata`, and what its README says must be found.

use std::collections::BTreeSet;

use objdict::diagnostic::At;
use objdict::format;
use objdict::source::SourceOptions;

use crate::support;

/// A device, the findings that name its misprints, and those that follow from them or are a matter of taste. A finding
/// is a rule and a place of the model; one that only the text shows has the text. Nothing else may be found.
struct Device {
    name: &'static str,
    main: &'static [&'static str],
    also: &'static [&'static str],
}

const DEVICES: &[Device] = &[
    Device {
        name: "a2-identity-subnumber",
        main: &["cia306/sub-number-mismatch 0x1018 / SubNumber"],
        also: &[],
    },
    Device {
        name: "a4-mapping-unsigned16",
        main: &[
            "cia401/wrong-data-type 0x6401sub1 / DataType",
            "cia401/wrong-data-type 0x6401sub2 / DataType",
        ],
        also: &[],
    },
    Device {
        name: "a7-mapping-from-sub0",
        main: &["cia301/mapping-of-count 0x1A02sub1 / DefaultValue"],
        also: &[],
    },
    Device {
        name: "a8-heartbeat-consumer",
        main: &[
            "cia301/invalid-consumer-heartbeat 0x1016sub1 / DefaultValue",
            "cia301/invalid-consumer-heartbeat 0x1016sub2 / DefaultValue",
        ],
        also: &[],
    },
    Device {
        name: "a8-analogue-output-unsigned16",
        main: &[
            "cia401/wrong-data-type 0x6411sub1 / DataType",
            "cia401/wrong-data-type 0x6411sub2 / DataType",
            "cia401/wrong-data-type 0x6411sub3 / DataType",
            "cia401/wrong-data-type 0x6411sub4 / DataType",
        ],
        // the exercise maps two of the four
        also: &["cia401/wrong-default-mapping 0x1601sub0 / DefaultValue"],
    },
    Device {
        name: "a9-encoder-406",
        main: &["cia301/synchronous-pdo-without-sync 0x1801sub2 / DefaultValue"],
        also: &[],
    },
    Device {
        name: "a10-io-401",
        main: &[
            "cia306/duplicate-section 1400sub2",
            "cia301/incomplete-pdo-parameter 0x1401",
            "cia301/cob-id-collision 0x1401sub1 / DefaultValue",
            "cia301/mapped-object-missing 0x1A01sub1 / DefaultValue",
            "cia301/wrong-mapping-count 0x1A01sub0 / DefaultValue",
            "cia401/device-type-without-channels 0x1000 / DefaultValue",
            // name and types are those of another object, which is one finding
            "cia401/wrong-data-type 0x6410sub1 / DataType",
            "naming/name-of-other-object 0x6410 / ParameterName",
        ],
        also: &["cia306/wrong-highest-sub-index 0x1401sub0 / DefaultValue"],
    },
    Device {
        name: "a10-mapping-from-sub0",
        main: &[
            "cia301/mapping-of-count 0x1601sub1 / DefaultValue",
            "cia301/mapping-of-count 0x1A01sub1 / DefaultValue",
        ],
        also: &[],
    },
    Device { name: "a14-bit-rate-25", main: &["cia306/unknown-key BaudRate_25"], also: &[] },
    Device {
        name: "a17-many-tpdos",
        main: &[
            "cia301/restricted-can-id 0x181Csub1 / DefaultValue",
            "cia301/restricted-can-id 0x181Dsub1 / DefaultValue",
            "cia301/restricted-can-id 0x181Esub1 / DefaultValue",
            "cia301/restricted-can-id 0x181Fsub1 / DefaultValue",
            "cia301/restricted-can-id 0x1820sub1 / DefaultValue",
            "cia301/restricted-can-id 0x1821sub1 / DefaultValue",
        ],
        also: &[
            "cia301/pdo-valid-by-default",
            // 520h to 560h plus the node-ID reach the default SDO on the higher nodes
            "cia301/restricted-can-id 0x1819sub1 / DefaultValue",
            "cia301/restricted-can-id 0x181Asub1 / DefaultValue",
            "cia301/restricted-can-id 0x181Bsub1 / DefaultValue",
        ],
    },
    Device {
        name: "a18-e6-encoder",
        main: &["cia406/missing-object 0x1000"],
        also: &["cia406/wrong-transmission-type 0x1801sub2 / DefaultValue"],
    },
    Device {
        name: "b1-b3-cs5525",
        main: &[
            "cia301/missing-mandatory-object MandatoryObjects",
            "cia301/no-error-control device",
            "cia306/missing-sub-0 0x1003",
            "cia301/obsolete-object 0x1004",
            "cia301/obsolete-object 0x100B",
            "cia301/obsolete-object 0x100F",
            "cia301/mapped-object-missing 0x1A01sub1 / DefaultValue",
            "cia301/mapped-object-not-mappable 0x1A01sub2 / DefaultValue",
            "cia401/missing-object 0x6404",
        ],
        also: &["cia301/emergency-without-cob-id 0x1003", "cia301/rtr-only-pdo 0x1801sub2 / DefaultValue"],
    },
    Device {
        name: "c2-c4-sensor-node",
        main: &[
            "cia301/cob-id-not-predefined 0x1800sub1 / DefaultValue",
            "cia401/wrong-data-type 0x6401sub1 / DataType",
            "cia401/wrong-data-type 0x6401sub2 / DataType",
        ],
        also: &[],
    },
    Device {
        name: "d-1014-emcy-invalid",
        main: &["cia301/emergency-disabled 0x1014 / DefaultValue"],
        also: &[],
    },
    Device {
        name: "d-1021-store-eds",
        main: &["cia301/wrong-access 0x1021 / AccessType", "cia301/wrong-access 0x1022 / AccessType"],
        also: &[],
    },
    Device {
        name: "d-1027-module-list",
        main: &["cia301/wrong-access 0x1027sub1 / AccessType", "cia301/wrong-access 0x1027sub2 / AccessType"],
        also: &[],
    },
    Device {
        name: "d-1800-timers",
        main: &["cia301/reserved-pdo-sub-index 0x1800sub4"],
        also: &[
            "cia301/timer-without-effect 0x1800sub3 / DefaultValue",
            "cia301/fixed-node-id 0x1800sub1 / DefaultValue",
        ],
    },
    Device { name: "d-1804-cob-id", main: &["cia301/invalid-cob-id 0x1804sub1 / DefaultValue"], also: &[] },
];

/// What is found in a device: the rule, and its place or, where only the text has it, the text there.
fn found(name: &str) -> BTreeSet<String> {
    let path = support::fixtures().join("errata").join(format!("{name}.eds"));
    let description = format::open(&path, &SourceOptions::default()).unwrap();
    let findings = objdict::check(&description);
    let found = findings.iter().map(|finding| {
        let place = match &finding.labels[0].at {
            At::Place(place) => place.to_string(),
            At::Span(span) => span.of(description.source().text()).to_owned(),
            At::Patch(..) => panic!("no patch is made"),
            At::Node(node, place) => panic!("a device has no node {node} with {place}"),
        };
        format!("{} {place}", finding.rule.id)
    });
    found.collect()
}

#[test]
fn every_misprint_is_found_and_nothing_else() {
    for Device { name, main, also } in DEVICES {
        let found = found(name);
        let main: BTreeSet<String> = main.iter().map(|&finding| finding.to_owned()).collect();
        // at one place, or a rule at any
        let is_accepted = |finding: &str| {
            also.iter().any(|also| *also == finding || finding.split(' ').next() == Some(*also))
        };
        let missed: Vec<_> = main.difference(&found).collect();
        assert!(missed.is_empty(), "{name}: not found: {missed:#?}");
        let more: Vec<_> =
            found.iter().filter(|finding| !main.contains(*finding) && !is_accepted(finding)).collect();
        assert!(more.is_empty(), "{name}: found, but nothing is wrong there: {more:#?}");
    }
}

#[test]
fn every_device_is_in_the_table() {
    let names: BTreeSet<&str> = DEVICES.iter().map(|device| device.name).collect();
    for file in support::files("errata", &["eds"]) {
        let stem = file.file_stem().unwrap().to_str().unwrap();
        assert!(names.contains(stem), "{stem}");
    }
}
