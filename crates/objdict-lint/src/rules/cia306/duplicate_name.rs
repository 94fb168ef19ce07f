use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Device, Entry, Field, Object, Place};
use crate::rule;

rule! {
    "cia306/duplicate-name", Note, Object(check);
    summary: "two sub-indexes of an object have the same name",
    checks: "Whether the names of an object's sub-indexes differ. Objects below 2000h are not checked because CiA 301 itself repeats names there. Only the first repetition in an object is shown.",
    why: "Users cannot distinguish the entries, libraries that look up entries by name return the first one, and code generators have to add numbers.",
    example: "`ParameterName=Gain` in `[2000sub1]` and in `[2000sub2]`",
    remedy: "Add a number or a word to the names.",
    source: "Not in a standard; python-canopen, for example, looks up entries by name",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some((first, second)) = Some(object).filter(|_| index >= 0x2000).and_then(repetition) else { return };
    let name = object.subs.get(second).map_or("", |entry| &entry.name);
    let message =
        say!("sub-indexes {} and {} are both called `{}`", sub_index(first), sub_index(second), name);
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = Diagnostic::new(&RULE.info, place(second), message).label(place(first), "first here");
    findings.push(finding.help("add a number or a word to the names"));
}

/// The first two sub-indexes with the same non-empty name.
fn repetition(object: &Object) -> Option<(u8, u8)> {
    /// Up to this many names, comparing pairs is faster than hashing.
    const FEW: usize = 10;
    let subs = &object.subs;
    if subs.len() <= FEW {
        return subs.iter().enumerate().find_map(|(at, (second, entry))| {
            let same = |other: &(u8, &Entry)| other.1.name == entry.name && !entry.name.is_empty();
            subs.iter().take(at).find(same).map(|(first, _)| (first, second))
        });
    }
    let mut seen: HashMap<&str, u8> = HashMap::with_capacity(subs.len());
    subs.iter().filter(|(_, entry)| !entry.name.is_empty()).find_map(|(second, entry)| {
        let first = *seen.entry(&entry.name).or_insert(second);
        (first != second).then_some((first, second))
    })
}
