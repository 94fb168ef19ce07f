//! A new description has what its profile demands, and `check` finds nothing in it.

use std::fmt::Write;

use objdict::format::{self, Format, WriteOptions};
use objdict::model::{ClockTime, Date, Device, PdoKind};
use objdict::scaffold::{
    ChannelCounts, Encoder, EncoderClass, Functions, MAX_ANALOG, MAX_DIGITAL, Wanted, scaffold,
};
use objdict::source::SourceFile;
use proptest::prelude::*;

fn wanted(functions: Functions) -> Wanted {
    Wanted {
        functions,
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

fn assert_clean(functions: Functions) -> Device {
    let mut device = scaffold(&wanted(functions));
    assert_eq!(found(&device, Format::Eds), "", "{functions:?}");
    device.file_info.as_mut().unwrap().file_name = Some("new.xdd".to_owned());
    assert_eq!(found(&device, Format::Xdd), "", "{functions:?}");
    device
}

#[test]
fn a_bare_device_is_clean() {
    let device = assert_clean(Functions::Bare);
    let indexes: Vec<u16> = device.objects.keys().copied().collect();
    assert_eq!(indexes, [0x1000, 0x1001, 0x1008, 0x1014, 0x1017, 0x1018]);
}

#[test]
fn an_io_module_has_the_default_mapping() {
    let channels = ChannelCounts { digital_inputs: 16, analog_outputs: 2, ..ChannelCounts::default() };
    let device = assert_clean(Functions::InputsOutputs(channels));
    assert_eq!(device.object(0x6000).unwrap().highest_sub(), Some(2));
    assert_eq!(device.object(0x1005).and_then(|sync| sync.value(0)?.as_integer()), Some(0x80));
    assert_eq!(device.object(0x6411).unwrap().highest_sub(), Some(2));
    assert!(device.object(0x6200).is_none() && device.object(0x6401).is_none());
    let mapped = |kind, number| -> Vec<String> {
        device.pdo(kind, number).unwrap().mapped().map(|mapped| mapped.to_string()).collect()
    };
    assert_eq!(mapped(PdoKind::Tpdo, 1), ["6000h:01, 8 bits", "6000h:02, 8 bits"]);
    assert_eq!(mapped(PdoKind::Rpdo, 2), ["6411h:01, 16 bits", "6411h:02, 16 bits"]);
    assert_eq!(device.pdos().count(), 2);
}

#[test]
fn every_encoder_is_clean() {
    for encoder_type in 1..=10 {
        for class in [EncoderClass::C1, EncoderClass::C2] {
            let device = assert_clean(Functions::Encoder(Encoder { class, encoder_type }));
            assert_eq!(device.pdos().filter(|pdo| pdo.kind == PdoKind::Tpdo).count(), 2);
            assert!(device.object(0x1005).is_some(), "the second TPDO is synchronous");
        }
    }
}

#[test]
fn the_largest_module_is_clean() {
    let (digital, analog) = (MAX_DIGITAL, MAX_ANALOG);
    let device = assert_clean(Functions::InputsOutputs(ChannelCounts {
        digital_inputs: digital,
        digital_outputs: digital,
        analog_inputs: analog,
        analog_outputs: analog,
    }));
    assert_eq!(device.object(0x6401).unwrap().highest_sub(), Some(254));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
    #[test]
    fn every_io_module_is_clean(
        digital_inputs in prop_oneof![Just(0), 1u16..200],
        digital_outputs in prop_oneof![Just(0), 1u16..200],
        analog_inputs in prop_oneof![Just(0), 1u8..40],
        analog_outputs in prop_oneof![Just(0), 1u8..40],
    ) {
        let channels = ChannelCounts { digital_inputs, digital_outputs, analog_inputs, analog_outputs };
        prop_assume!(channels != ChannelCounts::default());
        assert_clean(Functions::InputsOutputs(channels));
    }
}
