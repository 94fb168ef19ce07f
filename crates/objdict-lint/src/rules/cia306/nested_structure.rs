use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{DataType, Device, Field, ObjectType, TypeKind};
use crate::{EntryAt, rule};

rule! {
    "cia306/nested-structure", Warning, Entry(check);
    summary: "an entry is a structure",
    checks: "Whether a sub-index or VAR has an object type with sub-indexes of its own (ARRAY, RECORD, DEFSTRUCT), or the data type of a structure: 0020h to 0025h, or a DEFSTRUCT of the file.",
    why: "There are no sub-indexes below a sub-index, so nobody can reach the parts of the structure.",
    example: "`ObjectType=0x8` in `[2000sub1]`",
    remedy: "Give each part a sub-index or an object of its own.",
    source: "CiA 301 §7.4.4",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let nested_type = at.sub.and(entry.object_type).filter(|object_type| object_type.has_subs());
    let structure = entry.data_type.filter(|&data_type| is_structure(at.device, data_type));
    let (field, kind) = match (nested_type, structure) {
        (Some(object_type), _) => (Field::ObjectType, object_type.to_string()),
        (None, Some(data_type)) if holds_one_value(at) => (Field::DataType, data_type.to_string()),
        _ => return,
    };
    let what = match at.sub {
        Some(sub) => say!("sub-index {} of {:04X}h", sub_index(sub), at.index),
        None => say!("{:04X}h", at.index),
    };
    let message = say!("{} is a structure ({}), but can only hold a single value", what, kind);
    let finding = Diagnostic::new(&RULE.info, at.field(field), message);
    findings.push(finding.help("give each part of the structure a sub-index or an object of its own"));
}

/// The definition of a type may name a structure; an object or sub-index may not. The type of sub-index 0 has a rule of its
/// own.
fn holds_one_value(at: &EntryAt<'_>) -> bool {
    let is_definition = matches!(at.object.object_type(), ObjectType::DefType | ObjectType::DefStruct);
    at.holds_value() && !is_definition && at.sub != Some(0)
}

fn is_structure(device: &Device, data_type: DataType) -> bool {
    match data_type.kind() {
        TypeKind::Structure => true,
        TypeKind::Defined => device
            .object(data_type.0)
            .is_some_and(|object| object.main.object_type == Some(ObjectType::DefStruct)),
        _ => false,
    }
}
