use crate::diagnostic::{Argument, Diagnostic, Findings, Text, counted, say};
use crate::model::{DataType, Device, Object, Place};
use crate::rule;

rule! {
    "cia306/described-standard-type", Note, Device(check);
    summary: "the file describes a data type of CiA 301",
    checks: "Whether the file describes objects 0001h to 0025h, the data types and structures that CiA 301 defines.",
    why: "Every tool knows these types. Some refuse a file with objects below 1000h, and the others learn nothing new. Only the first one is shown.",
    example: "`[0005]`",
    remedy: "Remove the sections and their lines in the lists. Custom types start at 0040h.",
    source: "CiA 301 §7.4.7, table 44; CiA 306-1 §4.6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    // links alone describe no object
    let is_described = |(_, object): &(&u16, &Object)| !object.orphan || !object.subs.is_empty();
    let mut types = device.objects.range(0x0001..=0x0025).filter(is_described);
    let Some((&index, _)) = types.next() else { return };
    let name = DataType(index).name().unwrap_or("reserved");
    let others = types.count();
    let more = match others {
        0 => Text::default(),
        _ => say!(", and {} more", counted(others, "type", "types")),
    };
    let message = say!("{:04X}h ({}) is a type that CiA 301 defines{}", index, name, more);
    let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
    findings.push(
        finding
            .help(say!("remove the {sections}{}", Argument::OfLists(" and their lines in the lists".into()))),
    );
}
