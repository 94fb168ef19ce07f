use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Access, Device, Field, Object, ObjectType, Place};
use crate::{rule, stated, with_others};

rule! {
    "cia306/array-of-mixed-access", Note, Device(check);
    summary: "the entries of an ARRAY have different access types",
    checks: "Whether sub-indexes 1 to FEh of each ARRAY can all be read, and all be written, or none. `const` counts as `ro`, `rwr` and `rww` as `rw`. The rule reports one finding for the device, with every such ARRAY. Objects below 2000h are not checked, because CiA 301 and CiA 302 define their access types.",
    why: "Code generators and configuration tools treat the elements of an ARRAY alike, and often use the access type of the first one for all.",
    example: "An ARRAY with `AccessType=rw` at sub-index 1 and `AccessType=ro` at sub-index 2",
    remedy: "Correct the access type, or write `ObjectType=0x9` (RECORD) where the device profile allows it.",
    source: "CiA 301 §7.4.3, table 42",
}

fn check(device: &Device, findings: &mut Findings) {
    let objects = device.objects.range(0x2000..);
    let mut mixed = objects.filter_map(|(&index, object)| Some((index, first_other(object)?)));
    let Some((index, (first, other))) = mixed.next() else { return };
    let place = |index, sub| Place::entry(index, sub).field(Field::AccessType);
    let message = say!(
        "sub-index {} of the ARRAY {:04X}h is `{}`, sub-index {} is `{}`",
        sub_index(other.0),
        index,
        other.1,
        sub_index(first.0),
        first.1
    );
    let finding = Diagnostic::new(&RULE.info, place(index, other.0), message)
        .label(place(index, first.0), say!("`{}` here", first.1))
        .help(say!(
            "correct the access type, or write `{ObjectType=0x9}` (RECORD) where the device profile allows it"
        ));
    let others = mixed.map(|(index, (_, (sub, access)))| (place(index, sub), say!("`{}` here", access)));
    findings.push(with_others(finding, others));
}

/// The first element of an ARRAY, and the first whose access type differs from it.
fn first_other(object: &Object) -> Option<((u8, Access), (u8, Access))> {
    let is_array =
        object.main.object_type == Some(ObjectType::Array) && stated::object_type(object).is_some();
    let elements = object.subs.iter().filter(|(sub, _)| is_array && (1..=0xFE).contains(sub));
    let mut stated = elements.filter_map(|(sub, entry)| Some((sub, entry.access?)));
    let kind = |access: Access| (access.is_readable(), access.is_writable());
    let first = stated.next()?;
    stated.find(|other| kind(other.1) != kind(first.1)).map(|other| (first, other))
}
