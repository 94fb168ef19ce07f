use crate::diagnostic::{Diagnostic, Findings, listing, say};
use crate::model::{Device, Entry, Field, Object, ObjectType, Place};
use crate::{rule, stated};

rule! {
    "cia306/contradictory-sub-0", Warning, Object(check);
    summary: "the section of a VAR and that of its sub-index 0 disagree",
    checks: "Whether a VAR that also has a section for sub-index 0 has the same data type, access, mapping, default and limits in both. Keys that only one of them has are not compared.",
    why: "Both sections describe the same value. Some tools read the first one, others the second one.",
    example: "`DataType=0x0006` in `[6040]` and `DataType=0x0007` in `[6040sub0]`",
    remedy: "Remove the section of the sub-index.",
    source: "CiA 301 §7.4.3, CiA 306-1 §4.6.3.2",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(sub_0) = object.subs.get(0).filter(|_| object.subs.len() == 1) else { return };
    if stated::object_type(object).is_none_or(ObjectType::has_subs) {
        return;
    }
    let fields = different(&object.main, sub_0);
    let Some(first) = fields.first() else { return };
    let message = say!("sub-index 0 of {:04X}h has a different {} than the object", index, listing(&fields));
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, 0).field(first.clone()), message)
        .label(Place::object(index).field(first.clone()), "the object");
    findings.push(finding.help(say!("remove the {section} of the sub-index")));
}

/// The fields that both state differently.
fn different(object: &Entry, sub_0: &Entry) -> Vec<Field> {
    fn differ<T: PartialEq>(left: &Option<T>, right: &Option<T>) -> bool {
        matches!((left, right), (Some(left), Some(right)) if left != right)
    }
    let fields = [
        (Field::DataType, differ(&object.data_type, &sub_0.data_type)),
        (Field::AccessType, differ(&object.access, &sub_0.access)),
        (Field::DefaultValue, differ(&object.default, &sub_0.default)),
        (Field::PdoMapping, differ(&object.pdo_mapping, &sub_0.pdo_mapping)),
        (Field::LowLimit, differ(&object.low_limit, &sub_0.low_limit)),
        (Field::HighLimit, differ(&object.high_limit, &sub_0.high_limit)),
    ];
    fields.into_iter().filter(|(_, differ)| *differ).map(|(field, _)| field).collect()
}
