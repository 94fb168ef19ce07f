//! Concise DCF of the healthy configurations: planned, encoded, decoded.

mod support;

use objdict::download::{Configuration, NeededFile, PlanOptions, Scope, plan};
use objdict::format::{self, concise};
use objdict::model::{Device, Value};
use objdict::source::SourceOptions;

fn device(name: &str) -> Device {
    let path = support::fixtures().join(name);
    format::open(&path, &SourceOptions::default()).unwrap().into_device()
}

fn read(file: &NeededFile) -> std::io::Result<Vec<u8>> {
    std::fs::read(support::fixtures().join("dcf").join(&*file.name))
}

fn configuration(device: &Device, options: &PlanOptions) -> Configuration {
    plan(device, options).unwrap_or_else(|error| panic!("{error}")).into_configuration(read).unwrap()
}

#[test]
fn every_configured_node_has_a_stream_that_reads_back() {
    for path in support::files("dcf", &["dcf"]) {
        let device = format::open(&path, &SourceOptions::default()).unwrap().into_device();
        let configuration = configuration(&device, &PlanOptions::default());
        let stream = concise::write(&configuration).unwrap();
        assert_eq!(concise::read(&stream).as_ref(), Ok(&configuration));
        let name = path.file_stem().unwrap().to_str().unwrap();
        insta::assert_snapshot!(name, concise::table(&configuration));
    }
}

#[test]
fn every_device_can_be_written_in_full() {
    let all = PlanOptions { node_id: Some(5), scope: Scope::All, commands: true };
    for path in support::good_devices() {
        let device = format::open(&path, &SourceOptions::default()).unwrap().into_device();
        let configuration = configuration(&device, &all);
        let stream = concise::write(&configuration).unwrap();
        assert_eq!(concise::read(&stream), Ok(configuration), "{}", path.display());
    }
}

/// The manager keeps the configuration of node 3 in 1F22h.
#[test]
fn the_stream_in_a_manager_is_read() {
    let manager = device("dcf/manager-302-node1.dcf");
    let entry = manager.entry(0x1F22, 3).unwrap();
    let Some(Value::Bytes(stream)) = entry.configured_value() else { panic!("{entry:?}") };
    let configuration = concise::read(stream).unwrap();
    insta::assert_snapshot!(concise::table(&configuration));
}
