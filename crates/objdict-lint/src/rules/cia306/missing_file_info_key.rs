use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, Text, listing_or, say, series};
use crate::model::{Device, Field, FileInfo, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-file-info-key", Warning, Device(check), fix Unsafe;
    summary: "`[FileInfo]` lacks mandatory keys",
    checks: "Whether `FileName`, `FileVersion`, `FileRevision`, `Description`, `CreationTime`, `CreationDate` and `CreatedBy` are given. A missing `ModificationTime`, `ModificationDate` or `ModifiedBy` is a note: the file may be unmodified. `Description` may be empty.",
    why: "Configuration tools distinguish files of one device by version and date. A conformance test refuses the file.",
    example: "`[FileInfo]` without `FileRevision`",
    remedy: "Add the keys. Write `FileRevision=0` if revisions are not counted.",
    source: "CiA 306-1 §4.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let missing = |fields: &[(Field, bool)]| -> Vec<Field> {
        let missing =
            fields.iter().filter(|(field, stated)| !stated && info.invalid_values.get(field).is_none());
        missing.map(|(field, _)| field.clone()).collect()
    };
    let creation = missing(&creation(info));
    let modification = missing(&modification(info));
    report(info, &creation, Severity::Warning, findings);
    if creation.is_empty() {
        report(info, &modification, Severity::Note, findings);
    }
}

/// The mandatory keys of every file and whether each has a value.
fn creation(info: &FileInfo) -> [(Field, bool); 7] {
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

fn modification(info: &FileInfo) -> [(Field, bool); 3] {
    [
        (Field::ModificationTime, info.modification_time.is_some()),
        (Field::ModificationDate, info.modification_date.is_some()),
        (Field::ModifiedBy, info.modified_by.is_some()),
    ]
}

fn is_text(text: Option<&str>) -> bool {
    text.is_some_and(|text| !text.is_empty())
}

fn report(info: &FileInfo, missing: &[Field], severity: Severity, findings: &mut Findings) {
    let Some(first) = missing.first() else { return };
    let message = say!("`{[FileInfo]}` has no {}", listing_or(missing));
    let place = Place::of(Part::FileInfo).field(first.clone());
    let finding = Diagnostic::new(&RULE.info, place, message).severity(severity);
    let finding = finding.help(say!("add {}", series(missing.iter().map(described))));
    findings.push(match filled(info, missing) {
        Some(fix) => finding.fix(fix),
        None => finding,
    });
}

/// The missing keys of an unmodified first version; `None` if author or date are unknown.
fn filled(info: &FileInfo, missing: &[Field]) -> Option<Fix> {
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
fn described(field: &Field) -> Text {
    match field {
        Field::CreationTime | Field::ModificationTime => say!("`{}` (hh:mm, with AM or PM)", field),
        Field::CreationDate | Field::ModificationDate => say!("`{}` (mm-dd-yyyy)", field),
        field => say!("`{}`", field),
    }
}
