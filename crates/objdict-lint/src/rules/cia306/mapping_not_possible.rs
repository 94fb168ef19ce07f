use crate::diagnostic::{Diagnostic, Findings, Fix, Text, say};
use crate::model::{Access, DataType, Entry, Field, MappedObject, ObjectType, TypeKind, Value};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/mapping-not-possible", Warning, Entry(check), fix Unsafe;
    summary: "an entry is marked mappable, but cannot be mapped",
    checks: "Whether entries with `PDOMapping=1` are at most 64 bits long and are not `const`. A text or OCTET_STRING can be mapped if its value has at most 8 bytes; without a value its length is open, and it is reported.",
    why: "Tools offer the entry for mapping, but the device refuses the mapping.",
    example: "`PDOMapping=1` of a VISIBLE_STRING with 12 characters",
    remedy: "Write `PDOMapping=0`, or correct `DataType` or `AccessType`.",
    source: "CiA 301 §7.5.2.36",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if !entry.is_mappable() || !at.holds_value() || at.object_type() == Some(ObjectType::Domain) {
        return;
    }
    // another rule reports a PDO that maps an entry without a fixed length
    let is_mapped = |at: &EntryAt<'_>| {
        let this = |mapped: MappedObject| (mapped.index, mapped.sub) == (at.index, at.sub.unwrap_or(0));
        at.device.pdos().any(|pdo| pdo.mapped().any(this))
    };
    let unmappable =
        entry.data_type.filter(|data_type| stated::is_unmappable(data_type.kind()) && !is_short(entry));
    let (message, field, label) = match (unmappable, entry.access) {
        (Some(data_type), _) => {
            let message = match data_type.kind() {
                TypeKind::Domain | TypeKind::Structure => say!("{} cannot be mapped to a PDO", data_type),
                _ => say!("a PDO has 8 bytes, and this {} may be longer", data_type),
            };
            (message, Field::DataType, "the data type")
        }
        (None, Some(Access::Const)) => {
            (Text::from("a constant never changes"), Field::AccessType, "a constant")
        }
        _ => return,
    };
    if unmappable.is_some() && is_mapped(at) {
        return;
    }
    let message = say!("`{PDOMapping}` is {}, but {}", entry.pdo_mapping.unwrap_or_default(), message);
    let finding =
        Diagnostic::new(&RULE.info, at.field(Field::PdoMapping), message).label(at.field(field), label);
    let title = say!("write `{PDOMapping=0}`");
    let fix = Fix::risky(title.clone()).set(at.field(Field::PdoMapping), "0");
    findings.push(finding.help(title).fix(fix));
}

/// Whether the value of a string has 1 to 8 bytes, which a PDO can carry.
fn is_short(entry: &Entry) -> bool {
    let length = match (entry.data_type, entry.value()) {
        (Some(DataType::VISIBLE_STRING), Some(Value::Text(text))) => text.len(),
        (Some(DataType::UNICODE_STRING), Some(Value::Text(text))) => text.encode_utf16().count() * 2,
        (Some(DataType::OCTET_STRING), Some(Value::Bytes(bytes))) => bytes.len(),
        _ => 0,
    };
    (1..=8).contains(&length)
}
