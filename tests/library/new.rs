//! A new description has what its profile demands, and `check` finds nothing in it.

use std::fmt::Write;

use objdict::format::{self, Format, WriteOptions};
use objdict::model::{ClockTime, Date, Device, PdoKind};
use objdict::scaffold::{
    FEATURES, FeatureKind, FeatureValue, Features, PROFILES, Wanted, base, infer, scaffold,
};
use objdict::source::SourceFile;
use proptest::prelude::*;

fn wanted(profile: u16, features: &Features) -> Wanted {
    Wanted {
        profile,
        features: features.clone(),
        file_name: "new.eds".to_owned(),
        vendor_name: "Makers of things".to_owned(),
        vendor_id: 0x3F9,
        product_name: "Thing".to_owned(),
        product_code: 7,
        revision: 0x0001_0000,
        author: "tests".to_owned(),
        date: Date::new(2026, 11, 21).unwrap(),
        time: ClockTime::new(13, 12).unwrap(),
    }
}

/// What is found in the device, written as this format.
fn found(device: &Device, format: Format) -> String {
    let text = format::write(device, format, &WriteOptions::default()).unwrap().bytes;
    let name = if format == Format::Eds { "new.eds" } else { "new.xdd" };
    let source = SourceFile::from_bytes(name, text, &objdict::source::SourceOptions::default()).unwrap();
    let description = format::read(source, format);
    let mut report = String::new();
    for finding in objdict::check(&description).iter().take(5) {
        writeln!(report, "{} {}", finding.rule.id, finding.message).unwrap();
    }
    report
}

fn assert_clean(profile: u16, features: &Features) -> Device {
    let mut device = scaffold(&wanted(profile, features)).unwrap();
    assert_eq!(found(&device, Format::Eds), "", "{profile} {}", line(features));
    device.file_info.as_mut().unwrap().file_name = Some("new.xdd".to_owned());
    assert_eq!(found(&device, Format::Xdd), "", "{profile} {}", line(features));
    device
}

/// Features as a line of words: `rpdos=4 lss modes=homing,velocity`.
fn features(line: &str) -> Features {
    let mut features = Features::default();
    for word in line.split_whitespace() {
        let (word, text) = word.split_once('=').unwrap_or((word, "true"));
        let kind = FEATURES.iter().find(|feature| feature.word == word).unwrap().kind;
        let value = match kind {
            FeatureKind::Flag => FeatureValue::Flag(text == "true"),
            FeatureKind::Number { .. } => FeatureValue::Number(text.parse().unwrap()),
            FeatureKind::Bits { .. } => FeatureValue::Names(text.split(',').map(str::to_owned).collect()),
            _ => FeatureValue::Name(text.to_owned()),
        };
        features.set(word, &value).unwrap();
    }
    features
}

/// Features as such a line again.
fn line(features: &Features) -> String {
    let set = FEATURES.iter().filter_map(|feature| Some((feature.word, features.get(feature.word)?)));
    let words = set.map(|(word, value)| match value {
        FeatureValue::Flag(flag) => format!("{word}={flag}"),
        FeatureValue::Number(number) => format!("{word}={number}"),
        FeatureValue::Name(name) => format!("{word}={name}"),
        FeatureValue::Names(names) => format!("{word}={}", names.join(",")),
    });
    words.collect::<Vec<_>>().join(" ")
}

fn mapped(device: &Device, kind: PdoKind, number: u16) -> Vec<String> {
    device.pdo(kind, number).unwrap().mapped().map(|mapped| mapped.to_string()).collect()
}

#[test]
fn a_bare_device_is_clean() {
    let device = assert_clean(301, &Features::default());
    let indexes: Vec<u16> = device.objects.keys().copied().collect();
    assert_eq!(indexes, [0x1000, 0x1001, 0x1008, 0x1014, 0x1017, 0x1018]);
}

#[test]
fn an_io_module_has_the_default_mapping() {
    let device = assert_clean(401, &features("digital-inputs=16 analog-outputs=2"));
    assert_eq!(device.object(0x6000).unwrap().highest_sub(), Some(2));
    assert_eq!(device.object(0x1005).and_then(|sync| sync.value(0)?.as_integer()), Some(0x80));
    assert_eq!(device.object(0x6411).unwrap().highest_sub(), Some(2));
    assert!(device.object(0x6200).is_none() && device.object(0x6401).is_none());
    assert_eq!(mapped(&device, PdoKind::Tpdo, 1), ["6000h:01, 8 bits", "6000h:02, 8 bits"]);
    assert_eq!(mapped(&device, PdoKind::Rpdo, 2), ["6411h:01, 16 bits", "6411h:02, 16 bits"]);
    assert_eq!(device.pdos().count(), 2);
}

/// What is read of a text as a `device.toml`, in which nothing may be found.
fn read_clean(text: &str) -> Device {
    let description = format::read(SourceFile::from_text("new.toml", text), Format::Toml);
    let found: Vec<String> = objdict::check(&description)
        .iter()
        .map(|found| format!("{}: {}", found.rule.id, found.message))
        .collect();
    assert!(found.is_empty(), "{found:#?}\n{text}");
    description.into_device()
}

/// The short source becomes the EDS that `new` makes, and so does the example in its comments become objects and a PDO.
#[test]
fn the_short_source_is_the_same_device() {
    for (profile, words, tpdo) in [
        (301, "", 1),
        (301, "rpdos=2 tpdos=2 store=1 lss heartbeat-consumers=2 device-name=false", 1),
        (301, "heartbeat=false guarding", 1),
        (401, "digital-inputs=16 analog-outputs=2", 2),
        (402, "modes=profile-position,homing", 4),
        (404, "analog-inputs=2 value-type=INTEGER16", 2),
        (406, "", 3),
    ] {
        let wanted = wanted(profile, &features(words));
        let text = format::new_device_toml(&wanted).unwrap();
        assert!(text.lines().count() <= 40, "{text}");
        let mut device = read_clean(&text);
        device.file_info.as_mut().unwrap().file_name = Some(wanted.file_name.clone());
        let eds = |device| format::write(device, Format::Eds, &WriteOptions::default()).unwrap().bytes;
        assert_eq!(eds(&device), eds(&scaffold(&wanted).unwrap()), "{profile} {words}");

        let (start, example) = text.split_once("#\n").unwrap();
        let lines = example.lines().map(|line| line.trim_start_matches("# ").trim_start_matches('#'));
        let example = read_clean(&format!("{start}{}", lines.collect::<Vec<_>>().join("\n")));
        assert!(example.object(0x2000).is_some() && example.object(0x2001).is_some());
        assert_eq!(mapped(&example, PdoKind::Tpdo, tpdo), ["2000h:00, 16 bits"], "{profile} {words}");
    }
}

#[test]
fn every_encoder_is_clean() {
    for encoder_type in 1..=10 {
        for class in ["c1", "c2"] {
            let features = features(&format!("encoder-class={class} encoder-type={encoder_type}"));
            let device = assert_clean(406, &features);
            assert_eq!(device.pdos().filter(|pdo| pdo.kind == PdoKind::Tpdo).count(), 2);
            assert!(device.object(0x1005).is_some(), "the second TPDO is synchronous");
        }
    }
}

#[test]
fn a_drive_has_what_its_modes_demand() {
    let modes = FEATURES.iter().find(|feature| feature.word == "modes").unwrap().kind;
    for mode in modes.names().into_iter().chain([modes.names().join(",")]) {
        assert_clean(402, &features(&format!("modes={mode}")));
    }
    let device = assert_clean(402, &features("modes=pp,hm"));
    assert_eq!(device.object(0x6502).unwrap().value(0).unwrap().as_integer(), Some(0x21));
    let has = |index| device.object(index).is_some();
    assert!(has(0x607A) && has(0x6098) && !has(0x60FF));
    assert_eq!(mapped(&device, PdoKind::Rpdo, 3), ["6040h:00, 16 bits", "607Ah:00, 32 bits"]);
    assert_eq!(mapped(&device, PdoKind::Tpdo, 3), ["6041h:00, 16 bits", "6064h:00, 32 bits"]);
    assert_eq!(device.pdos().count(), 6);
}

#[test]
fn a_measuring_device_has_values_of_one_type() {
    for value_type in ["REAL32", "INTEGER16", "INTEGER24", "INTEGER32"] {
        let channels = "digital-inputs=9 digital-outputs=1 analog-inputs=3 analog-outputs=5";
        assert_clean(404, &features(&format!("{channels} value-type={value_type}")));
    }
    let device = assert_clean(404, &features("analog-inputs=3 value-type=INTEGER16"));
    assert_eq!(mapped(&device, PdoKind::Tpdo, 1).len(), 3);
    assert_eq!(device.object(0x7130).unwrap().highest_sub(), Some(3));
    assert_eq!(device.object(0x1000).unwrap().value(0).unwrap().as_integer(), Some(0x2_0194));
}

#[test]
fn every_feature_is_clean() {
    for feature in FEATURES {
        let text = match feature.kind {
            FeatureKind::Flag => vec!["true".to_owned()],
            FeatureKind::Number { lowest, highest } => vec![lowest.max(1).to_string(), highest.to_string()],
            kind => kind.names(),
        };
        let profile = feature.profiles.first().copied().unwrap_or(301);
        for text in text {
            // what only restores, and a drive without a mode, are findings
            let other = match feature.word {
                "restore" => " store=1",
                "drive-types" => ",servo-drive modes=velocity",
                _ => "",
            };
            let device = assert_clean(profile, &features(&format!("{}={text}{other}", feature.word)));
            assert!(device.lists.mandatory.is_some());
        }
    }
    let all = "rpdos=6 tpdos=6 sdo-servers=3 sdo-clients=2 heartbeat-consumers=5 emcy-consumers=3 error-history=8 \
               error-behavior=1 sync-producer sync-window sync-counter time-producer store=4 emcy-inhibit-time lss \
               rpdo-parameters=5 tpdo-parameters=6 mapping-entries=8 verify-configuration status-register \
               hardware-version software-version";
    let device = assert_clean(401, &features(&format!("{all} digital-inputs=8")));
    assert_eq!(device.object(0x1A00).unwrap().highest_sub(), Some(8));
    assert_eq!(mapped(&device, PdoKind::Tpdo, 1), ["6000h:01, 8 bits"]);
    let cob_id = |index| device.object(index).unwrap().value(1).unwrap().integer_for(5);
    assert_eq!(
        (cob_id(0x1800), cob_id(0x1801), cob_id(0x1804)),
        (Some(0x185), Some(0x8000_0285), Some(0x8000_0000))
    );
}

#[test]
fn features_are_found_in_the_device_that_they_made() {
    for (profile, words) in [
        (301, ""),
        (301, "heartbeat=false guarding=true emcy=false"),
        (
            301,
            "rpdos=2 tpdos=6 rpdo-parameters=5 sdo-servers=2 heartbeat-consumers=4 error-history=8 sync-producer=true store=2",
        ),
        (301, "sync=true time-producer=true restore=1 identity-entries=1 device-name=false lss=true"),
        (401, "digital-inputs=16 analog-outputs=9"),
        (401, "tpdos=3 mapping-entries=8 sync=false digital-inputs=16"),
        (402, "drive-types=frequency-converter modes=velocity"),
        (402, "modes=profile-position,homing,cyclic-synchronous-position"),
        (404, "analog-inputs=2 value-type=INTEGER24"),
        (406, "encoder-class=c2 encoder-type=8"),
    ] {
        let wanted = features(words);
        let device = base(profile, 1, &wanted).unwrap();
        let (found, features) = infer(&device);
        assert_eq!((found, line(&features).as_str()), (profile, words));
        assert_eq!(base(found, 1, &features).unwrap(), device, "{words}");
    }
}

#[test]
fn what_is_not_known_is_an_error() {
    let error = |profile, version, words| -> String {
        let error = base(profile, version, &features(words)).unwrap_err();
        format!("{error}; {}", error.help())
    };
    assert_eq!(error(405, 1, ""), "CiA 405 is not supported; these are supported: 301, 401, 402, 404, 406");
    assert_eq!(error(402, 2, ""), "CiA 402 has no version 2; these are known: 402@1");
    assert_eq!(error(402, 0, ""), "CiA 402 has no version 0; these are known: 402@1");
    assert_eq!(
        error(402, 1, "digital-inputs=1"),
        "CiA 402 has no `digital-inputs`; only CiA 401, 404 has it"
    );
    assert_eq!(
        error(404, 1, "analog-inputs=200"),
        "CiA 404 has at most 199 `analog-inputs`; write a number up to 199"
    );
    let mut features = Features::default();
    let mut set = |word, value| features.set(word, &value).unwrap_err().to_string();
    assert_eq!(set("rdpos", FeatureValue::Number(1)), "`rdpos` is not a feature");
    assert_eq!(set("rpdos", FeatureValue::Number(-1)), "`rpdos` must be a number from 0 to 512");
    assert_eq!(set("lss", FeatureValue::Number(1)), "`lss` must be true or false");
    assert_eq!(
        set("encoder-class", FeatureValue::Name("c3".to_owned())),
        "`encoder-class` must be one of c1, c2"
    );
    let error = set("drive-types", FeatureValue::Names(vec!["pump".to_owned()]));
    assert!(
        error.starts_with("`drive-types` must be a list of these: frequency-converter, servo-drive, "),
        "{error}"
    );
}

#[test]
fn the_largest_module_is_clean() {
    let device = assert_clean(
        401,
        &features("digital-inputs=2032 digital-outputs=2032 analog-inputs=254 analog-outputs=254"),
    );
    assert_eq!(device.object(0x6401).unwrap().highest_sub(), Some(254));
}

/// A version of a profile never changes: what it made once, it makes for ever.
#[test]
fn versions_make_what_they_always_made() {
    let mut report = String::new();
    for (profile, newest) in PROFILES {
        for words in [
            "",
            "rpdos=5 tpdos=5 sdo-servers=2 sdo-clients=1 heartbeat-consumers=2 guarding emcy-inhibit-time emcy-consumers=1 \
             error-history=2 error-behavior=2 status-register sync-producer sync-window sync-counter time store=3 \
             verify-configuration hardware-version software-version lss",
            "digital-inputs=9 digital-outputs=9 analog-inputs=5 analog-outputs=5",
            "analog-inputs=5 analog-outputs=5 value-type=INTEGER24",
            "modes=pp,vl,pv,tq,hm,ip,csp,csv,cst,cstca",
            "encoder-class=c2 encoder-type=10",
        ] {
            for version in 1..=*newest {
                let Ok(device) = base(*profile, version, &features(words)) else { continue };
                let text = objdict::format::json::write_device(&device);
                let digest = objdict::source::hash(text.as_bytes());
                let words = words.split(' ').next().unwrap_or_default();
                writeln!(
                    report,
                    "{profile}@{version} {words}: {} objects, {digest:016x}",
                    device.objects.len()
                )
                .unwrap();
            }
        }
    }
    insta::assert_snapshot!(report);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
    #[test]
    fn every_io_module_is_clean(
        digital_inputs in prop_oneof![Just(0), 1u16..200],
        digital_outputs in prop_oneof![Just(0), 1u16..200],
        analog_inputs in prop_oneof![Just(0), 1u16..40],
        analog_outputs in prop_oneof![Just(0), 1u16..40],
    ) {
        let mut channels = Features::default();
        channels.digital_inputs = Some(digital_inputs);
        channels.digital_outputs = Some(digital_outputs);
        channels.analog_inputs = Some(analog_inputs);
        channels.analog_outputs = Some(analog_outputs);
        prop_assume!(digital_inputs + digital_outputs + analog_inputs + analog_outputs > 0);
        assert_clean(401, &channels);
    }
}
