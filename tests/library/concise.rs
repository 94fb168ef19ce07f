//! Concise DCF of the healthy configurations: planned, encoded, decoded.

use objdict::download::{ConciseDcf, DecodeErrorKind, NeededFile, PlanOptions, Scope, SkipReason};
use objdict::format::{self, Format, concise};
use objdict::generate::{Options, Target, generate};
use objdict::model::{Access, Device, Place, Value};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn device(name: &str) -> Device {
    let path = support::fixtures().join(name);
    format::open(&path, &SourceOptions::default()).unwrap().into_device()
}

fn read(file: &NeededFile) -> std::io::Result<Vec<u8>> {
    std::fs::read(support::fixtures().join("dcf").join(&*file.name))
}

fn configuration(device: &Device, options: &PlanOptions) -> ConciseDcf {
    ConciseDcf::plan(device, options).unwrap_or_else(|error| panic!("{error}")).into_concise(read).unwrap()
}

#[test]
fn every_configured_node_has_a_stream_that_reads_back() {
    for path in support::files("dcf", &["dcf"]) {
        let device = format::open(&path, &SourceOptions::default()).unwrap().into_device();
        let configuration = configuration(&device, &PlanOptions::default());
        let stream = configuration.write().unwrap();
        assert_eq!(ConciseDcf::parse(&stream).as_ref(), Ok(&configuration));
        let name = path.file_stem().unwrap().to_str().unwrap();
        insta::assert_snapshot!(name, concise::table(&configuration));
    }
}

#[test]
fn every_device_can_be_written_in_full() {
    let all = PlanOptions { node_id: Some(5), scope: Scope::All, commands: true, ..PlanOptions::default() };
    for path in support::good_devices() {
        let device = format::open(&path, &SourceOptions::default()).unwrap().into_device();
        let configuration = configuration(&device, &all);
        let stream = configuration.write().unwrap();
        assert_eq!(ConciseDcf::parse(&stream), Ok(configuration), "{}", path.display());
    }
}

/// The manager keeps the configuration of node 3 in 1F22h.
#[test]
fn the_stream_in_a_manager_is_read() {
    let manager = device("dcf/manager-302-node1.dcf");
    let entry = manager.entry(0x1F22, 3).unwrap();
    let Some(Value::Bytes(stream)) = entry.configured_value() else { panic!("{entry:?}") };
    let configuration = ConciseDcf::parse(stream).unwrap();
    insta::assert_snapshot!(concise::table(&configuration));
}

/// The mapping that a manager has for its own PDOs: compact storage, whose sub-index 0 cannot be written.
#[test]
fn a_fixed_mapping_is_left_out_once() {
    let text = "[DeviceComissioning]\nNodeID=1\n[1400]\nSubNumber=2\nParameterName=RPDO\nObjectType=0x09\n\
        [1400sub0]\nParameterName=highest\nDataType=0x0005\nAccessType=const\nDefaultValue=1\n\
        [1400sub1]\nParameterName=COB-ID\nDataType=0x0007\nAccessType=rw\nDefaultValue=0x182\nParameterValue=0x183\n\
        [1600]\nParameterName=mapping\nObjectType=0x09\nDataType=0x0007\nAccessType=rw\nCompactSubObj=2\n\
        [1600Value]\nNrOfEntries=2\n1=0x20000110\n2=0x20000220\n";
    let source = SourceFile::from_text("master.dcf", text.to_owned());
    let device = format::read(source, Format::Dcf).into_device();
    let plan = ConciseDcf::plan(&device, &PlanOptions::default()).unwrap();
    let skipped: Vec<(Place, SkipReason)> =
        plan.skipped.iter().map(|skipped| (skipped.place.clone(), skipped.reason)).collect();
    assert_eq!(skipped, [(Place::object(0x1600), SkipReason::FixedMapping)]);
    // a valid PDO whose COB-ID is constant cannot be disabled, so the complete configuration has nothing of it
    let mut constant = device.clone();
    constant.objects.get_mut(&0x1400).unwrap().subs.get_mut(1).unwrap().access = Some(Access::Const);
    let pdos = PlanOptions { scope: Scope::Pdos, ..PlanOptions::default() };
    assert_eq!(configuration(&constant, &pdos), ConciseDcf::default());
    let configuration = plan.into_concise(read).unwrap();
    assert!(configuration.0.iter().all(|download| download.index == 0x1400), "{configuration:?}");
    assert!(configuration.verify(&device, None).is_accepted());
}

#[test]
fn the_target_concise_writes_the_stream() {
    let device = device("dcf/manager-302-node1.dcf");
    let mut options = Options::default();
    options.file_stem = "manager".to_owned();
    let generated = generate(&device, Target::named("concise").unwrap(), &options).unwrap();
    assert_eq!(generated.files[0].path, "manager.cdcf");
    let stream = ConciseDcf::parse(&generated.files[0].contents).unwrap();
    let mut expected = configuration(&device, &PlanOptions::default());
    expected.0.retain(|download| download.index != 0x2101);
    assert_eq!(stream, expected);
    let notes: Vec<String> = generated.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        notes,
        ["0x2101sub0: not part of the stream: its data are in the file `manager-302-node1-routes.bin`"]
    );
}

#[test]
fn a_type_of_device_has_an_empty_stream() {
    let generated =
        generate(&device("eds/minimal.eds"), Target::named("concise").unwrap(), &Options::default()).unwrap();
    assert_eq!(generated.files[0].contents, [0; 4]);
    assert!(generated.notes[0].message.contains("the stream is empty"));
}

#[test]
fn what_a_stream_cannot_carry_is_named() {
    let mut device = device("dcf/io-401-node5.dcf");
    device.commissioning = None;
    let error = generate(&device, Target::named("concise").unwrap(), &Options::default()).unwrap_err();
    let expected = "0x1400sub1: `$NODEID+0x200` needs the node-ID";
    assert!(error.to_string().starts_with(expected), "{error}");
}

/// FFh extends the sign of a negative number only.
#[test]
fn a_byte_behind_a_positive_number_is_not_its_padding() {
    let stream = [1, 0, 0, 0, 0x00, 0x20, 0, 3, 0, 0, 0, 1, 2, 3, 0xFF];
    let error = ConciseDcf::parse(&stream).unwrap_err();
    assert_eq!(error.kind, DecodeErrorKind::TrailingBytes { count: 1, left: 1 });
}
