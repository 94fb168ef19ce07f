use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, listing, say};
use crate::model::{DataType, Field, ObjectType};
use crate::profile;
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/missing-key", Error, Entry(check), fix Mixed, stops "*" at [DataType, AccessType];
    summary: "a key required by the object type is missing",
    checks: "Whether a VAR, DEFTYPE or sub-index, and an ARRAY or RECORD with `CompactSubObj`, has `DataType` and `AccessType`; whether any other ARRAY, RECORD or DEFSTRUCT has `SubNumber`; and whether an object with sub-indexes has `ObjectType` (a missing object type means VAR). A `DOMAIN` needs none of these keys.",
    why: "Without data type and access, the value cannot be read or written. Tools guess differently or refuse the file.",
    example: "A VAR without `AccessType`",
    remedy: "Add the key.",
    source: "CiA 306-1 §4.6.3.2, obligation table",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    match at.object_type() {
        Some(ObjectType::Var | ObjectType::DefType) => check_value(at, "VAR", findings),
        Some(ObjectType::Domain | ObjectType::Null) => {}
        Some(_) if at.sub.is_some() => {}
        Some(object_type) if at.object.compact.is_some() => check_value(at, object_type.name(), findings),
        Some(object_type) => check_sub_number(at, object_type, findings),
        None => check_object_type(at, findings),
    }
}

fn check_value(at: &EntryAt<'_>, kind: &str, findings: &mut Findings) {
    let entry = at.entry;
    // in an XDD, a parameter may define the access
    let has_access = entry.access.is_some()
        || entry.parameter.as_ref().is_some_and(|parameter| parameter.access.is_some());
    if entry.data_type.is_some() && has_access {
        return;
    }
    // sub-index 0 describes the value of such a VAR
    if at.sub.is_none() && at.object.compact.is_none() && at.object.subs.get(0).is_some() {
        return;
    }
    let stated = [(Field::DataType, entry.data_type.is_some()), (Field::AccessType, has_access)];
    let missing: Vec<Field> = stated
        .into_iter()
        .filter(|(field, stated)| !stated && !stated::is_invalid(entry, field))
        .map(|(field, _)| field)
        .collect();
    let Some(first) = missing.first() else { return };
    let kind = match (at.sub, entry.object_type) {
        (Some(_), _) => "a sub-index".into(),
        (None, Some(ObjectType::DefType)) => "a DEFTYPE".into(),
        (None, _) if at.object.compact.is_some() => say!("an object with `{CompactSubObj}`"),
        _ if kind == "VAR" => "a VAR".into(),
        _ => say!("{}", kind),
    };
    let message = say!("{} needs {}", kind, listing(&missing));
    let mut finding = Diagnostic::new(&RULE.info, at.field(first.clone()), message);
    let data_type = type_of_count(at).or_else(|| profile::data_type(at.device, at.index, at.sub));
    let access = profile::access(at.device, at.index, at.sub);
    if missing == [Field::DataType]
        && let Some(data_type) = data_type
    {
        let text = format!("0x{:04X}", data_type.0);
        let title = say!("write `{}`", Argument::setting(Field::DataType, &text));
        finding = finding.fix(Fix::safe(title).set(at.field(Field::DataType), text));
    }
    let is_known = |field: &Field| match field {
        Field::DataType => data_type.is_some(),
        _ => access.is_some(),
    };
    if missing.iter().all(is_known) {
        finding = finding.understood();
    }
    findings.push(finding.help(match missing.as_slice() {
        [Field::DataType] => say!("add `{DataType}` with the type of the value"),
        [Field::AccessType] => say!("add `{AccessType}`, such as `{AccessType=rw}`"),
        _ => {
            say!("add `{DataType}` with the type of the value, and `{AccessType}`, such as `{AccessType=rw}`")
        }
    }));
}

/// The type of sub-index 0 of a structure.
fn type_of_count(at: &EntryAt<'_>) -> Option<DataType> {
    let is_count = at.sub == Some(0) && stated::object_type(at.object).is_some_and(ObjectType::has_subs);
    DataType::of_sub_0(at.index).filter(|_| is_count)
}

fn check_sub_number(at: &EntryAt<'_>, object_type: ObjectType, findings: &mut Findings) {
    if at.object.sub_number.is_some() || stated::is_invalid(at.entry, &Field::SubNumber) {
        return;
    }
    let described = stated::described_subs(at.object);
    let article = if object_type == ObjectType::Array { "an" } else { "a" };
    let message = say!("{} {} needs `{SubNumber}`", article, object_type);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::SubNumber), message);
    findings.push(if described > 0 {
        let title = say!("add `{}`", Argument::setting(Field::SubNumber, described));
        let fix = Fix::safe(title.clone()).set(at.field(Field::SubNumber), described.to_string());
        finding.help(title).fix(fix)
    } else {
        finding.help(say!("describe the sub-indexes and write their number, or add `{CompactSubObj}`"))
    });
}

/// Reports a missing object type; another rule reports an invalid one.
fn check_object_type(at: &EntryAt<'_>, findings: &mut Findings) {
    let in_doubt = at.sub.is_none() && stated::is_structured(at.object);
    if !in_doubt || at.entry.object_type.is_some() || !at.entry.invalid_values.is_empty() {
        return;
    }
    let message =
        say!("an object with sub-indexes needs `{ObjectType}`; without `{ObjectType}` the object is a VAR");
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ObjectType), message);
    let fix = Fix::risky(say!("add `{ObjectType=0x9}`")).set(at.field(Field::ObjectType), "0x9");
    findings.push(
        finding.help(say!("add `{ObjectType=0x9}` for a RECORD, `{ObjectType=0x8}` for an ARRAY")).fix(fix),
    );
}
