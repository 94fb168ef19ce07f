//! `[FileInfo]`: keys, dates and the EDS version.

use crate::diagnostic::{Findings, Fix, Severity, Text, listing_or, say, series};
use crate::model::{Device, DeviceKind, Field, FileInfo, Part, Place};
use crate::rule::rules;

rules! {
    source: "CiA 306-1 §4.4";

    "cia306/eds-version" = EDS_VERSION, Warning, Device(eds_version), fix Unsafe;
    summary: "`EDSVersion` is not a valid version",
    checks: "Whether `EDSVersion` has the form digit, dot, digit. A missing version means 3.0; a missing version and versions before 4.0 are notes.",
    why: "Tools use the version to decide which keys to expect: files of version 3.0 have no `ObjFlags`, no compact storage and no modules. `404` and `4.04` are numbers of other documents.",
    example: "`EDSVersion=404`",
    remedy: "Write `EDSVersion=4.0`.",

    "cia306/implausible-date" = IMPLAUSIBLE_DATE, Note, Device(implausible_date);
    summary: "the date is before the first EDS files",
    checks: "Whether `CreationDate` and `ModificationDate` are in 1995 or later. CANopen device descriptions exist since 1995.",
    why: "The computer's clock was not set, or month and day digits ended up in the year. Tools that look for the newer of two files choose the wrong one.",
    example: "`CreationDate=01-01-1980`",
    remedy: "Correct the date.",

    "cia306/missing-file-info-key" = MISSING_FILE_INFO_KEY, Warning,
        Device(missing_file_info_key), fix Unsafe;
    summary: "`[FileInfo]` lacks mandatory keys",
    checks: "Whether `FileName`, `FileVersion`, `FileRevision`, `Description`, `CreationTime`, `CreationDate` and `CreatedBy` are given. A missing `ModificationTime`, `ModificationDate` or `ModifiedBy` is a note: the file may be unmodified. `Description` may be empty.",
    why: "Configuration tools distinguish files of one device by version and date. A conformance test refuses the file.",
    example: "`[FileInfo]` without `FileRevision`",
    remedy: "Add the keys. Write `FileRevision=0` if revisions are not counted.",

    "cia306/missing-last-eds" = MISSING_LAST_EDS, Note, Device(missing_last_eds);
    summary: "a DCF does not name its EDS",
    checks: "Whether a DCF with more than a file name in `[FileInfo]` has `LastEDS`.",
    why: "Tools cannot check whether the configuration matches the device, or update it to a newer EDS.",
    example: "A DCF without `LastEDS`",
    remedy: "Write the file name of the EDS.",
    source: "CiA 306-1 §5.2",

    "cia306/modified-before-created" = MODIFIED_BEFORE_CREATED, Note, Device(modified_before_created);
    summary: "the modification date is before the creation date",
    checks: "Whether date and time of the last modification are not before the creation.",
    why: "One of the dates is wrong, perhaps with day and month swapped, so tools cannot decide which of two files is newer.",
    example: "`CreationDate=11-18-2024` and `ModificationDate=03-04-2024`",
    remedy: "Correct the date. The order is month, day, year.",
}

fn eds_version(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let place = Place::of(Part::FileInfo).field(Field::EdsVersion);
    let text = info.eds_version.as_deref().unwrap_or_default();
    let (severity, message) = match text.as_bytes() {
        [b'4'..=b'9', b'.', b'0'..=b'9'] => return,
        [] => (Severity::Note, say!("`{EDSVersion}` is missing, which means 3.0").to_owned()),
        [b'0'..=b'3', b'.', b'0'..=b'9'] => (Severity::Note, say!("EDS version {} is outdated", text)),
        _ => (Severity::Warning, say!("`{}` is not a valid EDS version, which has the form `4.0`", text)),
    };
    let fix = Fix::risky(say!("write `{EDSVersion=4.0}`")).set(place.clone(), "4.0");
    let finding = EDS_VERSION.at(place, message).severity(severity);
    findings.push(finding.help(say!("write `{EDSVersion=4.0}`")).fix(fix));
}

/// The year of the first descriptions.
const FIRST_YEAR: u16 = 1995;

fn implausible_date(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let dates =
        [(Field::CreationDate, info.creation_date), (Field::ModificationDate, info.modification_date)];
    let early = dates
        .into_iter()
        .find_map(|(field, date)| Some((field, date.filter(|date| date.year < FIRST_YEAR)?)));
    let Some((field, date)) = early else { return };
    let message = say!("EDS files did not exist in the year {:04}", date.year);
    let finding = IMPLAUSIBLE_DATE.at(Place::of(Part::FileInfo).field(field), message);
    findings.push(finding.help("correct the date"));
}

fn missing_file_info_key(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let missing = |fields: &[(Field, bool)]| -> Vec<Field> {
        let missing =
            fields.iter().filter(|(field, stated)| !stated && info.invalid_values.get(field).is_none());
        missing.map(|(field, _)| field.clone()).collect()
    };
    let creation = missing(&creation_keys(info));
    let modification = missing(&modification_keys(info));
    report_missing_keys(info, &creation, Severity::Warning, findings);
    if creation.is_empty() {
        report_missing_keys(info, &modification, Severity::Note, findings);
    }
}

/// The mandatory keys of every file and whether each has a value.
fn creation_keys(info: &FileInfo) -> [(Field, bool); 7] {
    [
        (Field::FileName, is_text(info.file_name.as_deref())),
        (Field::FileVersion, info.file_version.is_some()),
        (Field::FileRevision, info.file_revision.is_some()),
        (Field::Description, info.description.is_some()),
        (Field::CreationTime, info.creation_time.is_some()),
        (Field::CreationDate, info.creation_date.is_some()),
        (Field::CreatedBy, info.created_by.is_some()),
    ]
}

fn modification_keys(info: &FileInfo) -> [(Field, bool); 3] {
    [
        (Field::ModificationTime, info.modification_time.is_some()),
        (Field::ModificationDate, info.modification_date.is_some()),
        (Field::ModifiedBy, info.modified_by.is_some()),
    ]
}

fn is_text(text: Option<&str>) -> bool {
    text.is_some_and(|text| !text.is_empty())
}

fn report_missing_keys(info: &FileInfo, missing: &[Field], severity: Severity, findings: &mut Findings) {
    let Some(first) = missing.first() else { return };
    let message = say!("`{[FileInfo]}` has no {}", listing_or(missing));
    let place = Place::of(Part::FileInfo).field(first.clone());
    let finding = MISSING_FILE_INFO_KEY.at(place, message).severity(severity);
    let finding = finding.help(say!("add {}", series(missing.iter().map(key_with_form))));
    findings.push(match fill_missing_keys(info, missing) {
        Some(fix) => finding.fix(fix),
        None => finding,
    });
}

/// The missing keys of an unmodified first version; `None` if author or date are unknown.
fn fill_missing_keys(info: &FileInfo, missing: &[Field]) -> Option<Fix> {
    missing.iter().try_fold(Fix::risky(say!("add {the keys}")), |fix, field| {
        let value = match field {
            Field::FileVersion => "1".to_owned(),
            Field::FileRevision => "0".to_owned(),
            Field::Description => String::new(),
            Field::ModificationTime => info.creation_time?.to_string(),
            Field::ModificationDate => info.creation_date?.to_string(),
            Field::ModifiedBy => info.created_by.clone()?,
            _ => return None,
        };
        Some(fix.set(Place::of(Part::FileInfo).field(field.clone()), value))
    })
}

/// A key for the help; with the form of its value where that is not plain.
fn key_with_form(field: &Field) -> Text {
    match field {
        Field::CreationTime | Field::ModificationTime => say!("`{}` (hh:mm, with AM or PM)", field),
        Field::CreationDate | Field::ModificationDate => say!("`{}` (mm-dd-yyyy)", field),
        field => say!("`{}`", field),
    }
}

fn missing_last_eds(device: &Device, findings: &mut Findings) {
    let Some(info) = device.file_info.as_ref().filter(|_| device.kind == DeviceKind::Node) else { return };
    let is_named = info.last_eds.as_ref().is_some_and(|name| !name.is_empty());
    if is_named || info.eds_version.is_none() {
        return;
    }
    let place = Place::of(Part::FileInfo).field(Field::LastEds);
    let finding = MISSING_LAST_EDS.at(place, "the file does not name its EDS");
    findings.push(finding.help(say!("write the file name of the EDS as `{LastEDS}`")));
}

fn modified_before_created(device: &Device, findings: &mut Findings) {
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
    let finding = MODIFIED_BEFORE_CREATED.at(place(wrong), message).label(place(right), "created here");
    findings.push(finding.help("correct the date; the order is month, day, year: `01-31-2026`"));
}
