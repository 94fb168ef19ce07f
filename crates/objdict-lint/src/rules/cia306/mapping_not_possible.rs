use crate::diagnostic::{Diagnostic, Findings, Fix, Text, say};
use crate::model::{Access, Field, MappedObject, ObjectType};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/mapping-not-possible", Warning, Entry(check), fix Unsafe;
    summary: "an entry is marked mappable, but cannot be mapped",
    checks: "Whether entries with `PDOMapping=1` have a data type of fixed length, at most 64 bits, and are not `const`.",
    why: "Tools offer the entry for mapping, but the device refuses the mapping.",
    example: "`PDOMapping=1` of a VISIBLE_STRING",
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
    let unmappable = entry.data_type.filter(|data_type| stated::is_unmappable(data_type.kind()));
    let (message, field, label) = match (unmappable, entry.access) {
        (Some(data_type), _) => {
            (say!("{} cannot be mapped to a PDO", data_type), Field::DataType, "the data type")
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
    let fix = if unmappable.is_some() { Fix::safe(title.clone()) } else { Fix::risky(title.clone()) };
    findings.push(finding.help(title).fix(fix.set(at.field(Field::PdoMapping), "0")));
}
