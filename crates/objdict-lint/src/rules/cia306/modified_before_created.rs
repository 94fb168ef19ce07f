use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/modified-before-created", Note, Device(check);
    summary: "the modification date is before the creation date",
    checks: "Whether date and time of the last modification are not before the creation.",
    why: "One of the dates is wrong, perhaps with day and month swapped, so tools cannot decide which of two files is newer.",
    example: "`CreationDate=11-18-2024` and `ModificationDate=03-04-2024`",
    remedy: "Correct the date. The order is month, day, year.",
    source: "CiA 306-1 §4.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let (Some(created), Some(modified)) = (info.creation_date, info.modification_date) else { return };
    let times = info.creation_time.zip(info.modification_time);
    let earlier = modified < created || modified == created && times.is_some_and(|(from, to)| to < from);
    if !earlier {
        return;
    }
    let (wrong, right) = if modified == created {
        (Field::ModificationTime, Field::CreationTime)
    } else {
        (Field::ModificationDate, Field::CreationDate)
    };
    let message = match times.filter(|_| modified == created) {
        Some((from, to)) => say!("modified at {}, but created at {} on the same day", to, from),
        None => say!("modified on {}, but created on {}", modified, created),
    };
    let place = |field| Place::of(Part::FileInfo).field(field);
    let finding = Diagnostic::new(&RULE.info, place(wrong), message).label(place(right), "created here");
    findings.push(finding.help("correct the date; the order is month, day, year: `01-31-2026`"));
}
