use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

/// The year of the first descriptions.
const FIRST: u16 = 1995;

rule! {
    "cia306/implausible-date", Note, Device(check);
    summary: "the date is before the first EDS files",
    checks: "Whether `CreationDate` and `ModificationDate` are in 1995 or later. CANopen device descriptions exist since 1995.",
    why: "The computer's clock was not set, or month and day digits ended up in the year. Tools that look for the newer of two files choose the wrong one.",
    example: "`CreationDate=01-01-1980`",
    remedy: "Correct the date.",
    source: "CiA 306-1 §4.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let dates =
        [(Field::CreationDate, info.creation_date), (Field::ModificationDate, info.modification_date)];
    let early =
        dates.into_iter().find_map(|(field, date)| Some((field, date.filter(|date| date.year < FIRST)?)));
    let Some((field, date)) = early else { return };
    let message = say!("EDS files did not exist in the year {:04}", date.year);
    let finding = Diagnostic::new(&RULE.info, Place::of(Part::FileInfo).field(field), message);
    findings.push(finding.help("correct the date"));
}
