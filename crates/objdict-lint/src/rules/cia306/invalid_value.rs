use crate::diagnostic::{Argument, Diagnostic, Findings, Severity, Text, joined, say};
use crate::model::{Access, DataType, Device, Field, Misfit, Place, Reason};
use crate::{nearest_access, respell, rule};

rule! {
    "cia306/invalid-value", Error, Device(check), fix Unsafe;
    summary: "a text is no value of its key",
    checks: "Whether numbers are numbers and fit their type or key, whether defaults and limits are values of their data type, whether access types, object types, dates and times are those that the standard knows. A date or time that is none is a warning only. In real files these are half of the findings (`14:19PM`, `04-19-20`); the others are access types that no document has (`R`), numbers in another notation (`0000h`), words where a number belongs, and texts as the default of a DOMAIN: each of them is read in several ways by several tools.",
    why: "Each tool makes something else of it: refuses the file, leaves the value out, or cuts it to size, so that 300 in an UNSIGNED8 becomes 44.",
    example: "`DefaultValue=300` of an UNSIGNED8",
    remedy: "Write a value that fits, or choose the data type that you mean.",
    source: "CiA 306-1 §4.3, §4.6.3.2",
}

fn check(device: &Device, findings: &mut Findings) {
    for (part, misfits) in device.misfits() {
        for misfit in misfits.iter() {
            let data_type = device.data_type_of(&part, &misfit.field);
            let place = Place::of(part.clone()).field(misfit.field.clone());
            let fix = respell(misfit, data_type, place.clone());
            let finding = Diagnostic::new(&RULE.info, place, message(misfit, data_type));
            let is_date = matches!(misfit.reason, Reason::NotADate | Reason::NotAClockTime);
            // no tool needs the dates
            let severity = if is_date { Severity::Warning } else { Severity::Error };
            let finding = finding.severity(severity).help(help(misfit));
            findings.push(match fix {
                Some(fix) => finding.fix(fix),
                None => finding,
            });
        }
    }
}

fn message(misfit: &Misfit, data_type: Option<DataType>) -> Text {
    let Misfit { field, text, reason } = misfit;
    let what = match data_type {
        Some(data_type) => say!("`{}` of type {}", field, data_type),
        None => say!("`{}`", field),
    };
    match reason {
        Reason::OutOfRange { low, high } => {
            say!("`{}` does not fit {}, which takes {} to {}", text, what, low, high)
        }
        Reason::NotANumber => say!("`{}` is no number; {} takes one", text, what),
        Reason::NotOctal => {
            say!("`{}` is no number: a leading zero means octal, which has no digit 8 or 9", text)
        }
        Reason::NotReal => say!("`{}` is no number that fits {}", text, what),
        Reason::NotHexBytes => say!("`{}` is not made of pairs of hex digits, as {} takes them", text, what),
        Reason::NotATime => say!("`{}` is no time; {} takes one", text, what),
        Reason::NotAFormula => say!("`{}` is no formula of the form `$NODEID+number`", text),
        Reason::FormulaForType => say!("`{}` is a formula, and {} is no integer", text, what),
        Reason::UnknownWord => say!("`{}` is none of the words that {} takes", text, what),
        Reason::NotADate => say!("`{}` is no date of the form `mm-dd-yyyy`", text),
        Reason::NotAClockTime => say!("`{}` is no time of the form `hh:mmAM` or `hh:mmPM`", text),
        Reason::Malformed => say!("`{}` is not of the form that {} takes", text, what),
    }
}

fn help(misfit: &Misfit) -> Text {
    match (&misfit.field, &misfit.reason) {
        (Field::AccessType, _) => match nearest_access(&misfit.text) {
            Some(access) => say!("did you mean `{}`? the access types are {}", access, access_names()),
            None => say!("the access types are {}", access_names()),
        },
        (Field::ObjectType, _) => say!(
            "the object types are {ObjectType:0x0} NULL, {ObjectType:0x2} DOMAIN, {ObjectType:0x5} DEFTYPE, {ObjectType:0x6} DEFSTRUCT, {ObjectType:0x7} VAR, {ObjectType:0x8} ARRAY, {ObjectType:0x9} RECORD"
        ),
        (Field::Count, _) => "write the number of sub-indexes, or `0;` and a number of bits".into(),
        (_, Reason::NotADate) => {
            "write month, day and year with two, two and four digits: `01-31-2026`".into()
        }
        (_, Reason::NotAClockTime) => "write two digits for hour (01 to 12) and minute: `09:45AM`".into(),
        (_, Reason::NotAFormula) => {
            "write `$NODEID`, or `$NODEID+` and a number; there is no other operator".into()
        }
        (_, Reason::NotHexBytes) => "write two hex digits a byte and nothing else: `01A105`".into(),
        (_, Reason::NotATime) => "write the days and the milliseconds with a blank between them".into(),
        (_, Reason::NotOctal) => "remove the leading zeros".into(),
        (_, Reason::OutOfRange { .. }) => "write a value that fits, or choose a larger data type".into(),
        _ => say!("write a value of the right form, or remove the text to leave {the key} empty"),
    }
}

fn access_names() -> Argument {
    joined(Access::ALL.map(|access| say!("`{}`", access)), ", ")
}
