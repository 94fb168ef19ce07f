use crate::diagnostic::{Diagnostic, Findings, Fix, say, sub_index};
use crate::model::{DataType, Device, Field, ObjectType, TypeKind};
use crate::{EntryAt, rule};

rule! {
    "cia306/nested-structure", Warning, Entry(check), fix Mixed;
    summary: "an entry is a structure",
    checks: "Whether a sub-index or VAR has an object type with sub-indexes (ARRAY, RECORD, DEFSTRUCT), or a structured data type: 0020h to 0025h, or a DEFSTRUCT of the file.",
    why: "A sub-index cannot have sub-indexes, so the parts of the structure cannot be accessed.",
    example: "`ObjectType=0x8` in `[2000sub1]`",
    remedy: "Use a separate sub-index or object for each part.",
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
    let message = say!("{} is a structure ({}), but must be a single value", what, kind);
    let is_of_one_type = nested_type.is_some() && structure.is_none() && entry.data_type.is_some();
    let mut finding = Diagnostic::new(&RULE.info, at.field(field.clone()), message);
    if is_of_one_type {
        // the data type says that it is a single value
        let title = say!("write `{ObjectType=0x7}`");
        finding = finding.fix(Fix::risky(title.clone()).set(at.field(field), "0x7")).help(title);
    } else {
        finding = finding.help("use a separate sub-index or object for each part of the structure");
    }
    findings.push(finding);
}

/// Type definitions may refer to a structure, objects and sub-indexes may not. The type of sub-index 0 has
/// its own rule.
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
