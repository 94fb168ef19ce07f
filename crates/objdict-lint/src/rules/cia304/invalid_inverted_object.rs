use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::model::{DataType, Device, Field, Place};
use crate::rule;

rule! {
    "cia304/invalid-inverted-object", Error, Device(check);
    summary: "the inverted entry of a safety entry is missing or not suitable",
    checks: "Whether `InvertedSRAD` refers to a described entry, other than itself, of the same data type.",
    why: "A tool that creates an SRDO maps the entry together with its `InvertedSRAD`. With a wrong one, the receiver compares unrelated values.",
    example: "`InvertedSRAD=0x610101` without `[6101sub1]`",
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
            let message = say!("`0x{:06X}` is not a valid inverted entry: {}", srad, what);
            let finding = Diagnostic::new(&RULE.info, part.field(Field::InvertedSrad), message);
            findings.push(finding.help("write index and sub-index of the inverted entry as six hex digits"));
        }
    }
}

fn problem(device: &Device, own: (u16, u8), srad: u32, data_type: Option<DataType>) -> Option<Text> {
    let [sub, low, high, above] = srad.to_le_bytes();
    let named = (u16::from_le_bytes([low, high]), sub);
    if above != 0 {
        return Some("the address has more than six digits".into());
    }
    if named == own {
        return Some("the address is that of the entry itself".into());
    }
    let Some(inverted) = device.entry(named.0, named.1) else {
        return (!device.is_modular()).then(|| "there is no such entry".into());
    };
    match (data_type, inverted.data_type) {
        (Some(plain), Some(other)) if plain != other => {
            Some(say!("its data type is {}, that of the entry is {}", other, plain))
        }
        _ => None,
    }
}
