//! Reads back every entry of the devices through its crate and compares it with the value expected from the
//! model. Each deviation must have a note, and each note a deviation.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod canopen_host;
mod canopen_rs;
#[path = "../../src/devices.rs"]
mod devices;
#[path = "../../../generate/oracle.rs"]
#[allow(dead_code, reason = "shared with the tests of the plain targets, which use more of it")]
mod oracle;
#[path = "../../../generate/stacks/truth.rs"]
#[allow(dead_code, reason = "shared with the tests of the stacks in C, which use more of it")]
mod truth;
mod zencan;

use std::collections::BTreeMap;

use devices::odd;

use objdict::generate::{Generated, Note, Options, Target, generate};
use objdict::model::{Device, Part};

/// Generates a target for a device.
fn generated(device: &Device, target: &str) -> Generated {
    generate(device, Target::named(target).unwrap(), &Options::default()).unwrap()
}

/// Number of entries per object in notes with a text; a note may apply to several entries.
fn noted(notes: &[Note], text: &str) -> BTreeMap<u16, usize> {
    let mut noted = BTreeMap::new();
    for note in notes.iter().filter(|note| note.message.contains(text)) {
        for place in std::iter::once(&note.place).chain(&note.also) {
            let (Part::Entry(index, _) | Part::Object(index)) = place.part else {
                panic!("{note}: not about an entry")
            };
            *noted.entry(index).or_default() += 1;
        }
    }
    noted
}

/// Number of entries per object.
fn counted(entries: &[(u16, u8)]) -> BTreeMap<u16, usize> {
    let mut counted = BTreeMap::new();
    entries.iter().for_each(|(index, _)| *counted.entry(*index).or_default() += 1);
    counted
}
