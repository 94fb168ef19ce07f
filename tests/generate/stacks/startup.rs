//! What the notes of a stack predict, in the lines in which a node of the real stack prints what it found when it started.

use std::collections::BTreeSet;
use std::fmt::Write;

use objdict::generate::Note;
use objdict::model::{Device, Part};

/// `RPDO 2 disabled`, `consumer 3 rejected`, `server off`.
pub(crate) fn predicted(device: &Device, notes: &[Note]) -> BTreeSet<String> {
    notes.iter().flat_map(|note| [pdos(note), consumers(device, note), server(note)].concat()).collect()
}

fn pdos(note: &Note) -> Vec<String> {
    let Some((named, effect)) = note.message.split_once(" will ") else { return Vec::new() };
    let effects = [
        ("be disabled by the stack", "disabled"),
        ("be received without effect", "without effect"),
        ("not be transmitted by the stack, or empty", "without effect"),
        ("use the CAN-ID of NMT", "nmt"),
        ("be rejected by the stack", "rejected"),
        ("not be transmitted by the stack", "silent"),
    ];
    let effect = effects.iter().find(|(words, _)| effect.starts_with(words));
    let (Some((kind, numbers)), Some((_, effect))) = (named.split_once(' '), effect) else {
        return Vec::new();
    };
    let number = |text: &str| text.trim().parse::<u16>().unwrap();
    let ranges = numbers.split(',').map(|range| match range.split_once(" to ") {
        Some((first, last)) => number(first)..=number(last),
        None => number(range)..=number(range),
    });
    ranges.flatten().map(|number| format!("{kind} {number} {effect}")).collect()
}

fn consumers(device: &Device, note: &Note) -> Vec<String> {
    let Part::Entry(0x1016, sub) = note.place.part else { return Vec::new() };
    let is_used = |sub: &u8| {
        let value = device.object(0x1016).and_then(|object| object.value(*sub)?.as_integer()).unwrap_or(0);
        value & 0xFFFF != 0 && value >> 16 & 0xFF != 0
    };
    let above = |text: &str| text.split(',').next()?.parse::<u8>().ok();
    let subs = match note.message.split_once("of the entries above ") {
        Some((_, count)) => above(count).unwrap() + 1..=0x7F,
        None if note.message.contains("of all entries before") => 1..=sub,
        None if note.message.contains("rejects the heartbeat consumer") => sub..=sub,
        None => return Vec::new(),
    };
    subs.filter(is_used).map(|sub| format!("consumer {sub} rejected")).collect()
}

fn server(note: &Note) -> Vec<String> {
    let is_off = ["so the stack has no SDO server", "the stack does not respond to SDOs"];
    let is_off = is_off.iter().any(|text| note.message.contains(text));
    is_off.then(|| "server off".to_owned()).into_iter().collect()
}

/// A device with an UNSIGNED16 and an UNSIGNED8 for both directions, and PDOs: the index of the communication parameters, the
/// transmission type, the COB-ID without the node-ID, and the mapping.
pub(crate) fn device(pdos: &[(u16, u8, u32, &[u32])]) -> Device {
    let mut text = String::new();
    let mut value = |section: String, data_type: u8, default: String| {
        let _ = writeln!(text, "[{section}]\nParameterName=Value\nDataType={data_type}\nAccessType=rw");
        let _ = writeln!(text, "DefaultValue={default}\nPDOMapping={}", u8::from(section.starts_with('2')));
    };
    value("2000".to_owned(), 6, "0".to_owned());
    value("2001".to_owned(), 5, "0".to_owned());
    for &(index, kind, cob_id, mapping) in pdos {
        value(format!("{index:X}sub0"), 5, "2".to_owned());
        value(format!("{index:X}sub1"), 7, format!("$NODEID+{cob_id:#X}"));
        value(format!("{index:X}sub2"), 5, kind.to_string());
        let mapped = |sub| format!("{:X}sub{sub:X}", index + 0x200);
        value(mapped(0), 5, mapping.len().to_string());
        for (at, object) in mapping.iter().enumerate() {
            value(mapped(at + 1), 7, format!("{object:#X}"));
        }
    }
    for index in pdos.iter().flat_map(|pdo| [pdo.0, pdo.0 + 0x200]) {
        let _ = writeln!(text, "[{index:X}]\nParameterName=PDO\nObjectType=9\nSubNumber=1");
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pdos.eds");
    std::fs::write(&path, text).unwrap();
    crate::devices::device(&path)
}

/// Whether the stack does something that no test can expect.
pub(crate) fn is_undefined(notes: &[Note]) -> bool {
    let undefined =
        ["access memory beyond its mapping", "keep the stack from starting", "write to constants"];
    notes.iter().any(|note| undefined.iter().any(|text| note.message.contains(text)))
}

/// Compares them with what the node printed; returns their number.
pub(crate) fn compare(device: &Device, notes: &[Note], printed: &str) -> Result<usize, String> {
    let predicted = predicted(device, notes);
    let is_finding =
        |line: &&str| ["RPDO", "TPDO", "consumer", "server"].iter().any(|word| line.starts_with(word));
    let observed: BTreeSet<String> = printed.lines().filter(is_finding).map(str::to_owned).collect();
    if predicted == observed {
        return Ok(observed.len());
    }
    let missed: Vec<&String> = observed.difference(&predicted).collect();
    let wrong: Vec<&String> = predicted.difference(&observed).collect();
    Err(format!("not predicted: {missed:?}, not observed: {wrong:?}"))
}
