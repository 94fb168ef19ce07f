//! DBC files of fixtures.

use objdict::document::dbc::{self, BusNode, DbcOptions};
use objdict::format;
use objdict::model::{Device, Value};
use objdict::source::SourceOptions;

use crate::support;

fn device(file: &str) -> Device {
    format::open(&support::fixtures().join(file), &SourceOptions::default()).unwrap().device().clone()
}

/// A DBC, and what it does not have.
fn shown(nodes: &[BusNode<'_>], options: DbcOptions) -> String {
    let written = dbc::write(nodes, options);
    let text: String = written.bytes.iter().map(|&byte| char::from(byte)).collect();
    let omissions = written.omissions.iter().map(|omission| {
        let fate = if omission.is_lost { "lost" } else { "left out" };
        format!("node {}: {fate}: {}: {}\n", omission.node, omission.place, omission.reason)
    });
    format!("{}\n{}", text.replace("\r\n", "\n"), omissions.collect::<String>())
}

#[test]
fn a_network() {
    let [io, drive] = ["dcf/io-401-node5.dcf", "dcf/drive-402-node8.dcf"].map(device);
    let nodes =
        [BusNode { device: &io, node_id: 5, name: None }, BusNode { device: &drive, node_id: 8, name: None }];
    insta::assert_snapshot!(shown(&nodes, DbcOptions::default()));
}

#[test]
fn bits_and_scales_of_an_xdd() {
    let mut press = device("xdd/press-402.xdd");
    // a PDO for what it measures: 2000h is scaled
    let mapping = press.objects.get_mut(&0x1A01).unwrap();
    mapping.subs.get_mut(2).unwrap().default = Some(Value::Unsigned(0x2000_0020));
    let node = BusNode { device: &press, node_id: 3, name: Some("press") };
    insta::assert_snapshot!(shown(&[node], DbcOptions { bits: true, sdo: false }));
}
