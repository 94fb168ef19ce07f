use crate::diagnostic::{Diagnostic, Findings, counted, say};
use crate::model::{Access, Device, Field, Part, Place};
use crate::rule;

rule! {
    "portability/unclear-direction", Warning, Device(check);
    summary: "a mappable entry is readable and writable",
    checks: "Whether entries with `PDOMapping=1` have an access type with a direction: `ro`, `const` and `rwr` for TPDOs, `wo` and `rww` for RPDOs. Only the first one is shown.",
    why: "CANchkEDS cannot decide whether an entry with `rw` belongs to a TPDO or to an RPDO.",
    example: "`AccessType=rw` and `PDOMapping=1`",
    remedy: "Write `rwr` for an entry that TPDOs send, `rww` for one that RPDOs receive.",
    source: "CANchkEDS 4.0; CiA 306-1 §4.6.3.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut unclear = device.objects.iter().flat_map(|(&index, object)| {
        let entries = object.described();
        let unclear = entries.filter(|(_, entry)| entry.access == Some(Access::Rw) && entry.is_mappable());
        unclear.map(move |(sub, _)| sub.map_or(Part::Object(index), |sub| Part::Entry(index, sub)))
    });
    let Some(first) = unclear.next() else { return };
    let entries = counted(unclear.count() + 1, "entry is", "entries are");
    let message = say!("{} mappable with `{AccessType=rw}`, which names no direction", entries);
    let finding = Diagnostic::new(&RULE.info, Place::of(first).field(Field::AccessType), message);
    findings.push(finding.help(say!("write `{AccessType=rwr}` for TPDOs, `{AccessType=rww}` for RPDOs")));
}
