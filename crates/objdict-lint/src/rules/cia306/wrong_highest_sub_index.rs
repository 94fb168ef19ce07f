use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Access, Device, Entry, Field, Object, ObjectType, Place};
use crate::{rule, stated};

rule! {
    "cia306/wrong-highest-sub-index", Error, Object(check), fix Unsafe;
    summary: "sub-index 0 is not the highest sub-index",
    checks: "Whether the value of sub-index 0 is the highest described sub-index, excluding FFh. A lower value is an error; a higher or missing value is a warning. Not checked: objects with a writable sub-index 0, or whose sub-index 0 counts used entries (error history, PDO and SRDO mappings, lists for multiplexed PDOs).",
    why: "Managers read as many entries as sub-index 0 indicates. They never see entries above it, and get an abort for missing ones.",
    example: "`[1018sub0]` with `DefaultValue=3`, and `[1018sub4]`",
    remedy: "Write the highest sub-index, or describe the missing entries.",
    source: "CiA 301 §7.4.7.2, CiA 306-1 §4.6.3.2",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(sub_0) = object.subs.get(0) else { return };
    let counts = stated::counts_otherwise(index) || sub_0.access.is_some_and(Access::is_writable);
    if counts || object.compact.is_some() || !stated::object_type(object).is_some_and(ObjectType::has_subs) {
        return;
    }
    let highest = object.highest_sub().unwrap_or_default();
    let (field, value) = match (sub_0.configured_value(), &sub_0.default) {
        (Some(value), _) => (Field::ParameterValue, value.as_integer()),
        (None, Some(value)) => (Field::DefaultValue, value.as_integer()),
        (None, None) => return missing_value(index, sub_0, highest, findings),
    };
    let Some(value) = value.filter(|&value| value != i128::from(highest)) else { return };
    let place = Place::entry(index, 0).field(field.clone());
    let title = say!("write `{}`", Argument::setting(&field, highest));
    let fix = Fix::risky(title).set(place.clone(), highest.to_string());
    let finding = if value < i128::from(highest) {
        let message =
            say!("sub-index 0 of {:04X}h is {}, but sub-index {} is described", index, value, highest);
        Diagnostic::new(&RULE.info, place, message)
            .label(Place::entry(index, highest), "the highest sub-index")
            .help(say!("write `{}`", Argument::setting(&field, highest)))
    } else {
        let message = say!(
            "sub-index 0 of {:04X}h is {}, but the highest described sub-index is {}",
            index,
            value,
            highest
        );
        Diagnostic::new(&RULE.info, place, message)
            .severity(Severity::Warning)
            .help(say!("describe the missing sub-indexes, or write `{}`", Argument::setting(&field, highest)))
    };
    findings.push(finding.fix(fix));
}

fn missing_value(index: u16, sub_0: &Entry, highest: u8, findings: &mut Findings) {
    if !sub_0.invalid_values.is_empty() || sub_0.data_type.is_none() {
        return;
    }
    let message = say!("sub-index 0 of {:04X}h has no value", index);
    let place = Place::entry(index, 0).field(Field::DefaultValue);
    let fix = Fix::risky(say!("write `{}`", Argument::setting(Field::DefaultValue, highest)))
        .set(place.clone(), highest.to_string());
    let finding = Diagnostic::new(&RULE.info, place, message).severity(Severity::Warning).fix(fix);
    findings.push(
        finding
            .help(say!("write `{}`, the highest sub-index", Argument::setting(Field::DefaultValue, highest))),
    );
}
