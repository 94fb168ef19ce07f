use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::model::{DataType, Device, Field, Place};
use crate::rule;

rule! {
    "cia304/invalid-inverted-object", Error, Device(check);
    summary: "the inverted value of a safety entry is not there",
    checks: "Whether `InvertedSRAD` names an entry that is described, another one, and one of the same data type.",
    why: "The tool that builds an SRDO maps the entry together with the one that `InvertedSRAD` names. With a wrong one, the receiver compares values that have nothing to do with each other.",
    example: "`InvertedSRAD=0x610101`, and no `[6101sub1]`",
    remedy: "Write index and sub-index of the inverted entry as six hex digits.",
    source: "CiA 306-1 annex A",
}

fn check(device: &Device, findings: &mut Findings) {
    for (&index, object) in &device.objects {
        for (sub, entry) in object.described().filter(|(_, entry)| entry.safety.is_some()) {
            let Some(srad) = entry.safety.as_ref().and_then(|safety| safety.inverted_srad) else { continue };
            let part = sub.map_or(Place::object(index), |sub| Place::entry(index, sub));
            let Some(what) = problem(device, (index, sub.unwrap_or(0)), srad, entry.data_type) else {
                continue;
            };
            let message = say!("`0x{:06X}` as entry with the inverted value: {}", srad, what);
            let finding = Diagnostic::new(&RULE.info, part.field(Field::InvertedSrad), message);
            findings.push(finding.help("write index and sub-index of the inverted entry as six hex digits"));
        }
    }
}

fn problem(device: &Device, own: (u16, u8), srad: u32, data_type: Option<DataType>) -> Option<Text> {
    let [sub, low, high, above] = srad.to_le_bytes();
    let named = (u16::from_le_bytes([low, high]), sub);
    if above != 0 {
        return Some("it has more than six digits".into());
    }
    if named == own {
        return Some("it is the entry itself".into());
    }
    let Some(inverted) = device.entry(named.0, named.1) else {
        return (!device.is_modular()).then(|| "there is no such entry".into());
    };
    match (data_type, inverted.data_type) {
        (Some(plain), Some(other)) if plain != other => {
            Some(say!("it is {}, and the entry is {}", other, plain))
        }
        _ => None,
    }
}
