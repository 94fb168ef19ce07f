use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, listing_or, say};
use crate::model::{Field, ObjectType};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/unsupported-key", Warning, Entry(check), fix Mixed;
    summary: "the object type does not support a key",
    checks: "Whether an ARRAY, RECORD or DEFSTRUCT without `CompactSubObj` has keys of a value (`DataType`, `AccessType`, `DefaultValue`, `PDOMapping=1`, limits), a DOMAIN has limits or `PDOMapping=1`, or a VAR, DEFTYPE or DOMAIN has `SubNumber`. `SubNumber=0` and `PDOMapping=0` are accepted. `CompactSubObj` of a VAR or DOMAIN is an error.",
    why: "The key describes a value that does not exist. The object type may be wrong, or the key is in the wrong section.",
    example: "`[1018]` with `ObjectType=0x9` and `DataType=0x0023`",
    remedy: "Remove the key, move it to the sub-indexes, or correct `ObjectType`.",
    source: "CiA 306-1 §4.6.3.2, obligation table",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(object_type) = at.object_type() else { return };
    let keys = match object_type {
        ObjectType::Var | ObjectType::DefType if at.sub.is_some() => return,
        ObjectType::Var | ObjectType::DefType => keys_of_structure(at),
        ObjectType::Domain => keys_of_structure(at).into_iter().chain(keys_of_number(at)).collect(),
        ObjectType::Null => return,
        _ if at.sub.is_some() || at.object.compact.is_some() => return,
        _ => keys_of_value(at),
    };
    let Some(first) = keys.first() else { return };
    let article = if object_type == ObjectType::Array { "an" } else { "a" };
    let message = say!("{} {} does not support {}", article, object_type, listing_or(&keys));
    let title = if keys.len() == 1 { say!("remove {the key}") } else { say!("remove {the keys}") };
    // what describes a value may be intended
    let fix = if keys == [Field::SubNumber] { Fix::safe(title) } else { Fix::risky(title) };
    let fix = keys.iter().fold(fix, |fix, field| fix.remove(at.field(field.clone())));
    let compact = keys.contains(&Field::CompactSubObj);
    let finding = Diagnostic::new(&RULE.info, at.field(first.clone()), message).severity(if compact {
        Severity::Error
    } else {
        Severity::Warning
    });
    let finding = finding.fix(fix);
    findings.push(if object_type.has_subs() {
        finding.help(match keys.len() {
            1 => say!("remove {the key}, or move it to the sub-indexes"),
            _ => say!("remove {the keys}, or move them to the sub-indexes"),
        })
    } else {
        finding.help(say!("remove {the key}, or correct `{ObjectType}`"))
    });
}

/// The keys that count sub-indexes. Another rule reports described sub-indexes.
fn keys_of_structure(at: &EntryAt<'_>) -> Vec<Field> {
    let object = at.object;
    let mut keys = Vec::new();
    if at.sub.is_some() || stated::described_subs(object) > usize::from(object.subs.get(0).is_some()) {
        return keys;
    }
    if object.sub_number.is_some_and(|number| number > 0) {
        keys.push(Field::SubNumber);
    }
    if object.compact.is_some() {
        keys.push(Field::CompactSubObj);
    }
    keys
}

fn keys_of_number(at: &EntryAt<'_>) -> Vec<Field> {
    let entry = at.entry;
    let stated = [
        (Field::PdoMapping, entry.is_mappable()),
        (Field::LowLimit, entry.low_limit.is_some()),
        (Field::HighLimit, entry.high_limit.is_some()),
    ];
    stated.into_iter().filter(|(_, stated)| *stated).map(|(field, _)| field).collect()
}

fn keys_of_value(at: &EntryAt<'_>) -> Vec<Field> {
    let entry = at.entry;
    let stated = [
        (Field::DataType, entry.data_type.is_some()),
        (Field::AccessType, entry.access.is_some()),
        (Field::DefaultValue, entry.default.is_some()),
        (Field::ParameterValue, entry.configured_value().is_some()),
    ];
    let mut keys: Vec<Field> =
        stated.into_iter().filter(|(_, stated)| *stated).map(|(field, _)| field).collect();
    keys.extend(keys_of_number(at));
    keys
}
