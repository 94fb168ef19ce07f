use crate::diagnostic::{Diagnostic, Findings, Fix, Text, say, sub_index};
use crate::model::{Device, Entry, Field, Place, Value};
use crate::rule;

rule! {
    "cia301/storage-signature-as-default", Warning, Device(check), fix Unsafe;
    summary: "a default of 1010h or 1011h is not a value that the device returns",
    checks: "Whether the defaults of 1010h are 0 to 3 and those of 1011h 0 or 1: the values that the device returns when the entry is read. Bit 0 means that it stores or restores on command, bit 1 of 1010h that it stores autonomously.",
    why: "The signatures `save` and `load` are written to the entries, not read from them. A tool that compares the device with its description finds a difference, and one that writes the defaults stores or restores by accident.",
    example: "`[1010sub1]` with `DefaultValue=0x65766173`",
    remedy: "Write 1, or the value that the device returns.",
    source: "CiA 301 §7.5.2.13, §7.5.2.14",
}

fn check(device: &Device, findings: &mut Findings) {
    for (index, known, signature) in [(0x1010, 3, 0x6576_6173), (0x1011, 1, 0x6461_6F6C)] {
        let Some(object) = device.object(index) else { continue };
        let shared = object.compact.as_ref().map(|_| (None, &object.main));
        let described = object.subs.iter().filter(|&(sub, _)| (1..=0x7F).contains(&sub));
        let mut wrong = shared
            .into_iter()
            .chain(described.map(|(sub, entry)| (Some(sub), entry)))
            .filter_map(|(sub, entry)| Some((sub, number(entry).filter(|number| number & !known != 0)?)));
        let Some((sub, value)) = wrong.next() else { continue };
        let place =
            sub.map_or(Place::object(index), |sub| Place::entry(index, sub)).field(Field::DefaultValue);
        let which = sub.map_or_else(Text::default, |sub| say!(" sub-index {}", sub_index(sub)));
        let finding = if value == signature {
            let message = say!(
                "`0x{:08X}` is the signature that is written to {:04X}h{}, not the value that is read",
                value,
                index,
                which
            );
            Diagnostic::new(&RULE.info, place.clone(), message)
        } else {
            let message = say!("`0x{:08X}` of {:04X}h{} has reserved bits set", value, index, which);
            Diagnostic::new(&RULE.info, place.clone(), message)
        };
        let fix = Fix::risky("write `1`, the value for storing or restoring on command").set(place, "1");
        findings.push(
            finding
                .help("write the value that the device returns: 1 if it stores or restores on command")
                .fix(fix),
        );
    }
}

fn number(entry: &Entry) -> Option<i128> {
    entry.default.as_ref().and_then(Value::as_integer)
}
