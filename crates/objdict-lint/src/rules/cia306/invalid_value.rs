use crate::diagnostic::{Diagnostic, Findings, Severity};
use crate::model::{Access, DataType, Device, Field, Misfit, Place, Reason};
use crate::{nearest_access, respell, rule};

rule! {
    /// a text is no value of its key
    ///
    /// ## What it checks
    /// Whether numbers are numbers and fit their type or key, whether defaults and limits are values of their data type, whether access types, object types, dates and times are those that the standard knows. A date or time that is none is a warning only. In real files these are half of the findings (`14:19PM`, `04-19-20`); the others are access types that no document has (`R`), numbers in another notation (`0000h`), words where a number belongs, and texts as the default of a DOMAIN: each of them is read in several ways by several tools.
    ///
    /// ## Why it matters
    /// Each tool makes something else of it: refuses the file, leaves the value out, or cuts it to size, so that 300 in an UNSIGNED8 becomes 44.
    ///
    /// ## Example
    /// `DefaultValue=300` of an UNSIGNED8
    ///
    /// ## How to mend
    /// Write a value that fits, or choose the data type that you mean.
    ///
    /// ## Source
    /// CiA 306-1 §4.3, §4.6.3.2
    "cia306/invalid-value", Error, Device(check), fix Unsafe
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

fn message(misfit: &Misfit, data_type: Option<DataType>) -> String {
    let Misfit { field, text, reason } = misfit;
    let what = match data_type {
        Some(data_type) => format!("`{field}` of type {data_type}"),
        None => format!("`{field}`"),
    };
    match reason {
        Reason::OutOfRange { low, high } => {
            format!("`{text}` does not fit {what}, which takes {low} to {high}")
        }
        Reason::NotANumber => format!("`{text}` is no number; {what} takes one"),
        Reason::NotOctal => {
            format!("`{text}` is no number: a leading zero means octal, which has no digit 8 or 9")
        }
        Reason::NotReal => format!("`{text}` is no number that fits {what}"),
        Reason::NotHexBytes => format!("`{text}` is not made of pairs of hex digits, as {what} takes them"),
        Reason::NotATime => format!("`{text}` is no time; {what} takes one"),
        Reason::NotAFormula => format!("`{text}` is no formula of the form `$NODEID+number`"),
        Reason::FormulaForType => format!("`{text}` is a formula, and {what} is no integer"),
        Reason::UnknownWord => format!("`{text}` is none of the words that {what} takes"),
        Reason::NotADate => format!("`{text}` is no date of the form `mm-dd-yyyy`"),
        Reason::NotAClockTime => format!("`{text}` is no time of the form `hh:mmAM` or `hh:mmPM`"),
        Reason::Malformed => format!("`{text}` is not of the form that {what} takes"),
    }
}

fn help(misfit: &Misfit) -> String {
    match (&misfit.field, &misfit.reason) {
        (Field::AccessType, _) => match nearest_access(&misfit.text) {
            Some(access) => format!("did you mean `{access}`? the access types are {}", access_names()),
            None => format!("the access types are {}", access_names()),
        },
        (Field::ObjectType, _) => "the object types are 0x0 NULL, 0x2 DOMAIN, 0x5 DEFTYPE, 0x6 DEFSTRUCT, 0x7 VAR, 0x8 ARRAY, 0x9 RECORD".to_owned(),
        (Field::Count, _) => "write the number of sub-indexes, or `0;` and a number of bits".to_owned(),
        (_, Reason::NotADate) => "write month, day and year with two, two and four digits: `01-31-2026`".to_owned(),
        (_, Reason::NotAClockTime) => "write two digits for hour (01 to 12) and minute: `09:45AM`".to_owned(),
        (_, Reason::NotAFormula) => "write `$NODEID`, or `$NODEID+` and a number; there is no other operator".to_owned(),
        (_, Reason::NotHexBytes) => "write two hex digits a byte and nothing else: `01A105`".to_owned(),
        (_, Reason::NotATime) => "write the days and the milliseconds with a blank between them".to_owned(),
        (_, Reason::NotOctal) => "remove the leading zeros".to_owned(),
        (_, Reason::OutOfRange { .. }) => "write a value that fits, or choose a larger data type".to_owned(),
        _ => "write a value of the right form, or remove the text to leave the key empty".to_owned(),
    }
}

fn access_names() -> String {
    let names: Vec<String> = Access::ALL.iter().map(|access| format!("`{access}`")).collect();
    names.join(", ")
}
