//! EDS to DCF and back are edits of the text.

use std::path::Path;

use objdict::format::{self, Description, Format};
use objdict::model::{Commissioning, Device, DeviceKind};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn open(path: &Path) -> Description {
    format::open(path, &SourceOptions::default()).unwrap()
}

fn read(bytes: Vec<u8>, name: &str) -> Description {
    let source = SourceFile::from_bytes(name, bytes, &SourceOptions::default()).unwrap();
    format::read(source, Format::from_name(name).unwrap())
}

fn node() -> Commissioning {
    let name = Some("Pump; left #1".to_owned());
    Commissioning {
        node_id: Some(5),
        baud_rate: Some(250),
        node_name: name,
        manager: Some(false),
        ..Commissioning::default()
    }
}

/// The node that a DCF of [`node`] reads back as: keys that readers ask for are always there.
fn complete(node: &Commissioning) -> Commissioning {
    Commissioning {
        net_number: Some(node.net_number.unwrap_or(0)),
        network_name: Some(node.network_name.clone().unwrap_or_default()),
        ..node.clone()
    }
}

/// The device without what a DCF changes.
fn without_node(device: &Device) -> Device {
    let mut device = device.clone();
    device.kind = DeviceKind::Type;
    device.commissioning = None;
    if let Some(info) = &mut device.file_info {
        info.file_name = None;
        info.last_eds = None;
    }
    device
}

#[test]
fn a_dcf_of_every_eds_says_the_same_of_the_device_and_is_clean() {
    for path in support::files("eds", &["eds"]) {
        let eds = open(&path);
        let dcf = read(eds.to_node("pump.dcf", &node()).unwrap(), "pump.dcf");
        assert_eq!(without_node(dcf.device()), without_node(eds.device()), "{}", path.display());
        assert_eq!(dcf.device().commissioning, Some(complete(&node())));
        let info = dcf.device().file_info.clone().unwrap();
        assert_eq!(info.file_name.as_deref(), Some("pump.dcf"));
        assert_eq!(info.last_eds.as_deref(), path.file_name().and_then(|name| name.to_str()));
        // the names of one fixture are hostile on purpose
        let is_of_content = |finding: &&objdict::diagnostic::Diagnostic| finding.rule.group() != "naming";
        let findings = objdict::check(&dcf);
        let findings: Vec<_> = findings.iter().filter(is_of_content).collect();
        assert!(findings.is_empty(), "{}: {findings:#?}", path.display());
    }
}

#[test]
fn every_line_of_the_eds_but_the_file_name_is_in_the_dcf() {
    for path in support::files("broken", &["eds"]) {
        let eds = open(&path);
        if eds.source().is_read_only() {
            assert!(eds.to_node("pump.dcf", &node()).is_err());
            continue;
        }
        let dcf = read(eds.to_node("pump.dcf", &node()).unwrap(), "pump.dcf");
        assert_eq!(dcf.source().encoding(), eds.source().encoding(), "{}", path.display());
        let mut rest = dcf.source().text();
        for line in eds
            .source()
            .text()
            .split(['\r', '\n'])
            .filter(|line| !line.to_ascii_lowercase().contains("filename"))
        {
            let at = rest.find(line).unwrap_or_else(|| panic!("{}: `{line}` is gone", path.display()));
            rest = &rest[at + line.len()..];
        }
    }
}

#[test]
fn a_dcf_made_from_an_eds_gives_the_eds_back() {
    for path in support::files("eds", &["eds"]) {
        let eds = open(&path);
        let dcf = read(eds.to_node("pump.dcf", &node()).unwrap(), "pump.dcf");
        let name = path.file_name().unwrap().to_str().unwrap();
        let again = dcf.to_type(name).unwrap();
        assert!(again == eds.print(), "{}", path.display());
    }
}

#[test]
fn an_eds_of_every_dcf_has_no_configuration() {
    for path in support::files("dcf", &["dcf"]) {
        let eds = read(open(&path).to_type("type.eds").unwrap(), "type.eds");
        let device = eds.device();
        assert_eq!(device.kind, DeviceKind::Type, "{}", path.display());
        for object in device.objects.values() {
            assert!(object.described().all(|(_, entry)| entry.configured.is_none()));
        }
    }
}
