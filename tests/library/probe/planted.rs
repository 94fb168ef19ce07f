//! What a node does otherwise than its description, and what is found then.

use std::collections::{BTreeMap, BTreeSet};

use objdict::bus::{Abort, Dictionary, LiveDictionary};
use objdict_device::{Attributes, Scope};
use serde_json::{Value, json};

/// The description.
pub(super) const FIXTURE: &str = "eds/drive-402.eds";

/// A difference of an entry.
#[derive(Clone, Debug)]
pub(super) struct Difference {
    index: u16,
    sub: u8,
    kind: Kind,
    /// What is found.
    pub(super) rules: &'static [&'static str],
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// It is read as these bytes.
    Reads(&'static [u8]),
    /// Reading is aborted.
    ReadAborts(u32),
    /// Writing is aborted.
    WriteAborts(u32),
    /// Whatever is written is taken.
    Accepts,
    /// What is right is taken and forgotten.
    Ignores,
}
use Kind::*;

pub(super) fn all() -> Vec<Difference> {
    let rows: &[(u16, u8, Kind, &'static [&'static str])] = &[
        (0x1015, 0, ReadAborts(0x0602_0000), &["probe/absent"]),
        (0x1020, 2, ReadAborts(0x0609_0011), &["probe/absent"]),
        (0x2034, 0, ReadAborts(0x0602_0000), &["probe/absent"]),
        (0x2032, 0, ReadAborts(0x0602_0000), &["probe/absent"]),
        (0x2001, 7, ReadAborts(0x0609_0011), &["probe/absent"]),
        (0x606C, 0, WriteAborts(0x0602_0000), &["probe/absent"]),
        (0x1018, 5, Reads(&[1, 2, 3, 4]), &["probe/undescribed"]),
        (0x607D, 3, Reads(&[0]), &["probe/undescribed"]),
        (0xFFFF, 0, Reads(&[1]), &["probe/undescribed"]),
        (0x1017, 0, Reads(&[0xE8]), &["probe/wrong-size"]),
        (0x6041, 0, Reads(&[0; 4]), &["probe/wrong-size"]),
        (0x1002, 0, Reads(&[0; 2]), &["probe/wrong-size"]),
        (0x1018, 0, Reads(&[4, 0]), &["probe/wrong-size"]),
        (0x2003, 3, Reads(&[0; 4]), &["probe/wrong-size"]),
        (0x2021, 0, Reads(&[0; 8]), &["probe/wrong-size"]),
        (0x1000, 0, Reads(&[0x91, 1, 2, 0]), &["probe/other-value"]),
        (0x1008, 0, Reads(b"Servo drive SD401"), &["probe/other-value"]),
        (0x1009, 0, Reads(b"B3"), &["probe/other-value"]),
        (0x1018, 2, Reads(&[3, 4, 0, 0]), &["probe/other-value"]),
        (0x1018, 3, Reads(&[2, 0, 1, 0]), &["probe/other-value"]),
        (0x1016, 0, Reads(&[3]), &["probe/highest-sub-index"]),
        (0x2014, 0, Reads(&[9]), &["probe/highest-sub-index"]),
        (0x6099, 0, Reads(&[1]), &["probe/highest-sub-index"]),
        (0x1014, 0, Reads(&[0x86, 0, 0, 0]), &["probe/other-default"]),
        (0x1400, 1, Reads(&[5, 2, 0, 0x80]), &["probe/other-default"]),
        (0x2000, 0, Reads(b"axis 1"), &["probe/other-default"]),
        (0x2001, 1, Reads(&[0, 0, 0xA0, 0x40]), &["probe/other-default"]),
        (0x2002, 1, Reads(&[0xB1, 4]), &["probe/other-default", "probe/other-than-written"]),
        (0x2001, 5, Reads(&[0; 3]), &["probe/outside-limits"]),
        (0x605A, 0, Reads(&[16, 0]), &["probe/outside-limits"]),
        (0x2013, 0, Reads(&[0x7F]), &["probe/outside-limits"]),
        (0x2010, 0, Reads(&[2]), &["probe/invalid-value"]),
        (0x6404, 0, Reads(&[0xFF, 0xFE]), &["probe/invalid-value"]),
        (0x2002, 3, Reads(&[0, 0, 0xC0, 0x7F]), &["probe/invalid-value"]),
        (0x6502, 0, ReadAborts(0x0601_0001), &["probe/not-readable"]),
        (0x2011, 0, ReadAborts(0x0800_0000), &["probe/not-readable"]),
        (0x2020, 0, Reads(&[0; 4]), &["probe/readable"]),
        (0x6091, 3, ReadAborts(0x0602_0000), &["probe/wrong-abort"]),
        (0x608F, 3, ReadAborts(0x0800_0000), &["probe/wrong-abort"]),
        (0x6064, 0, WriteAborts(0x0800_0000), &["probe/wrong-abort"]),
        (0x60FD, 0, WriteAborts(0x0607_0010), &["probe/wrong-abort"]),
        (0x1018, 1, Accepts, &["probe/writable"]),
        (0x6061, 0, Accepts, &["probe/writable"]),
        (0x100A, 0, Accepts, &["probe/writable"]),
        (0x6065, 0, WriteAborts(0x0601_0002), &["probe/not-writable"]),
        (0x1019, 0, WriteAborts(0x0601_0000), &["probe/not-writable"]),
        (0x6066, 0, Accepts, &["probe/unchecked-size"]),
        (0x2015, 3, Accepts, &["probe/unchecked-size", "probe/unchecked-limit"]),
        (0x6067, 0, WriteAborts(0x0609_0031), &["probe/wrong-abort", "probe/refused-value"]),
        (0x6068, 0, WriteAborts(0x0800_0022), &["probe/wrong-abort", "probe/refused-value"]),
        (0x2002, 2, Ignores, &["probe/other-than-written"]),
        (0x2015, 5, Ignores, &["probe/other-than-written"]),
    ];
    rows.iter().map(|&(index, sub, kind, rules)| Difference { index, sub, kind, rules }).collect()
}

/// Those of the recorded island: a heartbeat and a transmission type are not configured.
pub(super) fn of_island() -> Vec<Difference> {
    let rows: [(u16, u8, &'static [u8]); 2] = [(0x1017, 0, &[0, 0]), (0x1800, 2, &[0xFF])];
    rows.map(|(index, sub, bytes)| Difference { index, sub, kind: Reads(bytes), rules: &[] }).into()
}

impl Difference {
    pub(super) fn expected(&self) -> BTreeSet<(&'static str, u16, u8)> {
        self.rules.iter().map(|rule| (*rule, self.index, self.sub)).collect()
    }

    /// As `local_node.py` reads it.
    pub(super) fn json(&self) -> Value {
        let hex = |bytes: &[u8]| bytes.iter().map(|byte| format!("{byte:02x}")).collect::<String>();
        let (kind, value) = match self.kind {
            Reads(bytes) => ("read", json!(hex(bytes))),
            ReadAborts(code) => ("read", json!(code)),
            WriteAborts(code) => ("write", json!(code)),
            Accepts => ("write", Value::Null),
            Ignores => ("write", json!("ignored")),
        };
        json!({ "index": self.index, "sub": self.sub, kind: value })
    }
}

/// A node with differences.
pub(super) struct Otherwise {
    node: LiveDictionary,
    kinds: BTreeMap<(u16, u8), Kind>,
    /// What was taken without a check.
    taken: BTreeMap<(u16, u8), Vec<u8>>,
}

impl Otherwise {
    pub(super) fn new(node: LiveDictionary, differences: &[Difference]) -> Self {
        let kinds = differences.iter().map(|one| ((one.index, one.sub), one.kind)).collect();
        Self { node, kinds, taken: BTreeMap::new() }
    }

    fn kind(&self, index: u16, sub: u8) -> Option<Kind> {
        self.kinds.get(&(index, sub)).copied()
    }
}

impl Dictionary for Otherwise {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        let own = self.node.attributes(index, sub);
        match self.kind(index, sub) {
            Some(Reads(bytes)) => {
                let unknown = Attributes {
                    size: bytes.len(),
                    data_type: 0,
                    readable: true,
                    writable: false,
                    fits_tpdo: false,
                    fits_rpdo: false,
                };
                Ok(Attributes { readable: true, ..own.unwrap_or(unknown) })
            }
            // as an octet string, whose length is not checked before it is written
            Some(Accepts | WriteAborts(_)) => {
                own.map(|own| Attributes { writable: true, data_type: 0x0A, size: 64, ..own })
            }
            _ => own,
        }
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let bytes = match self.kind(index, sub) {
            Some(Reads(bytes)) => bytes,
            Some(ReadAborts(code)) => return Err(code.into()),
            _ => match self.taken.get(&(index, sub)) {
                Some(bytes) => bytes,
                None => return self.node.read(index, sub, buffer),
            },
        };
        buffer[..bytes.len()].copy_from_slice(bytes);
        Ok(bytes.len())
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        match self.kind(index, sub) {
            Some(WriteAborts(code)) => Err(code.into()),
            Some(Accepts) => {
                self.taken.insert((index, sub), bytes.to_vec());
                Ok(())
            }
            Some(Ignores) => {
                let before = self.node.bytes(index, sub).unwrap().to_vec();
                self.node.write(index, sub, bytes)?;
                self.node.replace(index, sub, &before)
            }
            _ => self.node.write(index, sub, bytes),
        }
    }

    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.node.replace(index, sub, bytes)
    }

    fn restart(&mut self, scope: Scope, node_id: u8) {
        self.node.restart(scope, node_id);
    }
}
