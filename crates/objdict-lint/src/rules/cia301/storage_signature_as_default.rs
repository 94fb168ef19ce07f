use crate::diagnostic::{Diagnostic, Findings, Fix, Text, say, sub_index};
use crate::model::{Device, Entry, Field, Place, Value};
use crate::rule;

rule! {
    "cia301/storage-signature-as-default", Warning, Device(check), fix Unsafe;
    summary: "a default of 1010h or 1011h is no answer of the device",
    checks: "Whether the defaults of 1010h are 0 to 3 and those of 1011h 0 or 1: what the device answers when the entry is read. Bit 0 says that it stores or restores on command, bit 1 of 1010h that it stores by itself.",
    why: "What is written there, the signatures `save` and `load`, is not what is read. A tool that compares the device with its description finds a difference, and one that writes defaults back stores or restores by accident.",
    example: "`[1010sub1]` with `DefaultValue=0x65766173`",
    remedy: "Write 1, or what the device answers.",
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
            let message =
                say!("`0x{:08X}` is what is written to {:04X}h{}, not what is read", value, index, which);
            Diagnostic::new(&RULE.info, place.clone(), message)
        } else {
            let message = say!("`0x{:08X}` of {:04X}h{} has bits that mean nothing", value, index, which);
            Diagnostic::new(&RULE.info, place.clone(), message)
        };
        let fix = Fix::risky("write what a device that does it on command answers").set(place, "1");
        findings.push(finding.help("write what the device answers: 1 if it does it on command").fix(fix));
    }
}

fn number(entry: &Entry) -> Option<i128> {
    entry.default.as_ref().and_then(Value::as_integer)
}
