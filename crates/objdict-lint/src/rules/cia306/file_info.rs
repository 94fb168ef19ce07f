//! `[FileInfo]`: keys, dates and the EDS version; `[DeviceComissioning]` of a DCF.

use super::configured_values::configured_places;
use crate::diagnostic::{Findings, Fix, Severity, Text, listing_or, say, series};
use crate::model::{BaudRates, Commissioning, Device, DeviceKind, Field, FileInfo, Part, Place};
use crate::rule::rules;
use crate::stated;

rules! {
    source: "CiA 306-1 §4.4";

    "cia306/eds-version" = EDS_VERSION, Warning, Device(eds_version), fix Unsafe;
    summary: "`EDSVersion` is not a valid version",
    checks: "`EDSVersion` must have the format digit, dot, digit. A missing version means 3.0. A missing version and versions before 4.0 are notes.",
    why: "Tools use the version to decide which keys to expect: files of version 3.0 have no `ObjFlags`, no compact storage and no modules. `404` and `4.04` are numbers of other documents.",
    example: "`EDSVersion=404`",
    remedy: "Write `EDSVersion=4.0`.",

    "cia306/implausible-date" = IMPLAUSIBLE_DATE, Note, Device(implausible_date);
    summary: "the date is before the first EDS files",
    checks: "`CreationDate` and `ModificationDate` must be in 1995 or later. CANopen device descriptions have existed since 1995.",
    why: "The computer's clock was not set, or month and day digits ended up in the year. Tools that look for the newer of two files choose the wrong one.",
    example: "`CreationDate=01-01-1980`",
    remedy: "Correct the date.",

    "cia306/invalid-baud-rate" = INVALID_BAUD_RATE, Error, Device(invalid_baud_rate);
    summary: "the bit rate of a DCF is not valid",
    checks: "`Baudrate` must be a CiA 301 bit rate (10, 20, 50, 125, 250, 500, 800, 1000 kbit/s) that the device supports according to `BaudRate_x`. 0, which tools write when no bit rate is selected, is a warning.",
    why: "A node with a wrong bit rate disturbs the network or cannot communicate.",
    example: "`Baudrate=500000`",
    remedy: "Write the bit rate in kbit/s.",
    source: "CiA 306-1 §5.4, CiA 301 §6.2",

    "cia306/invalid-node-id" = INVALID_NODE_ID, Error, Device(invalid_node_id);
    summary: "the node-ID of a DCF is not valid",
    checks: "`NodeID` must be 1 to 127, or 255 for a node that gets its node-ID by LSS. With 255, formulas with `$NODEID` are not allowed. An XDD without configured values describes no node, so 0 is a note.",
    why: "Other nodes cannot address the node, and its COB-IDs are unknown.",
    example: "`NodeID=0`",
    remedy: "Write the node-ID of the node.",
    source: "CiA 306-1 §5.4, CiA 301 §7.2.5.2",

    "cia306/missing-commissioning" = MISSING_COMMISSIONING, Error, Device(missing_commissioning);
    summary: "a DCF has no node-ID and bit rate",
    checks: "A DCF must have a section `[DeviceComissioning]` (the standard spells the name with one m). The finding is a warning if no value is a formula with `$NODEID`: some masters get their node-ID from the application program.",
    why: "Without node-ID and bit rate, the node cannot be addressed, and formulas with `$NODEID` have no value.",
    example: "An EDS that was renamed to .dcf",
    remedy: "Add the section with `NodeID` and `Baudrate`.",
    source: "CiA 306-1 §5.4",

    "cia306/missing-file-info-key" = MISSING_FILE_INFO_KEY, Warning,
        Device(missing_file_info_key), fix Unsafe;
    summary: "`[FileInfo]` lacks mandatory keys",
    checks: "`FileName`, `FileVersion`, `FileRevision`, `Description`, `CreationTime`, `CreationDate` and `CreatedBy` must be given. A missing `ModificationTime`, `ModificationDate` or `ModifiedBy` is a note: the file may be unmodified. `Description` may be empty.",
    why: "Configuration tools distinguish files of one device by version and date. A conformance test rejects the file.",
    example: "`[FileInfo]` without `FileRevision`",
    remedy: "Add the keys. Write `FileRevision=0` if revisions are not counted.",

    "cia306/missing-last-eds" = MISSING_LAST_EDS, Note, Device(missing_last_eds);
    summary: "a DCF does not name its EDS",
    checks: "A DCF with more than a file name in `[FileInfo]` must have `LastEDS`.",
    why: "Tools cannot check whether the configuration matches the device, or update it to a newer EDS.",
    example: "A DCF without `LastEDS`",
    remedy: "Write the file name of the EDS.",
    source: "CiA 306-1 §5.2",

    "cia306/missing-node-name" = MISSING_NODE_NAME, Note, Device(missing_node_name), fix Unsafe;
    summary: "a configured node has no name",
    checks: "`[DeviceComissioning]` must have `NodeName`.",
    why: "Network tools show nodes by their names. A tool that expects the key may reject the file.",
    example: "`[DeviceComissioning]` without `NodeName`",
    remedy: "Add `NodeName`.",
    source: "CiA 306-1 §5.4",

    "cia306/modified-before-created" = MODIFIED_BEFORE_CREATED, Note, Device(modified_before_created);
    summary: "the modification date is before the creation date",
    checks: "Date and time of the last modification must not be before the creation.",
    why: "One of the dates is wrong, perhaps with day and month swapped. Tools cannot decide which of two files is newer.",
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

/// A key for the help, with the format of its value unless that is obvious.
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
    if is_named || info.eds_version.is_none() || is_renamed_eds(device) {
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

fn invalid_baud_rate(device: &Device, findings: &mut Findings) {
    let Some(rate) = device.commissioning.as_ref().and_then(|node| node.baud_rate) else { return };
    let place = Place::of(Part::Commissioning).field(Field::Baudrate);
    let info = device.device_info.as_ref();
    let supported: Vec<u16> = info.iter().flat_map(|info| info.baud_rates.supported()).collect();
    if !BaudRates::DEFINED.contains(&rate) {
        let message = match rate {
            0 => say!("`{Baudrate}` is 0: no bit rate is selected").to_owned(),
            _ => say!("`{Baudrate}` is {}, but CANopen does not define this bit rate", rate),
        };
        let finding = INVALID_BAUD_RATE.at(place, message).severity(if rate == 0 {
            Severity::Warning
        } else {
            Severity::Error
        });
        findings.push(finding.help(match supported.is_empty() {
            true => say!("write one of the bit rates in kbit/s: {}", series(BaudRates::DEFINED)),
            false => say!("write a bit rate that the device supports: {} kbit/s", series(supported)),
        }));
        return;
    }
    let Some(info) = info else { return };
    // another rule reports a device without bit rates
    if supported.is_empty() || supported.contains(&rate) {
        return;
    }
    let field = info.baud_rates.iter().find(|(other, ..)| *other == rate).map(|(_, field, _)| field);
    if field.as_ref().is_some_and(|field| info.invalid_values.get(field).is_some()) {
        return;
    }
    let message = say!("`{Baudrate}` is {}, which the device does not support", rate);
    let label = Place { field, ..Place::of(Part::DeviceInfo) };
    let finding = INVALID_BAUD_RATE.at(place, message).label(label, "not supported");
    findings
        .push(finding.help(say!("write a bit rate that the device supports: {} kbit/s", series(supported))));
}

fn invalid_node_id(device: &Device, findings: &mut Findings) {
    let Some(node) = &device.commissioning else { return };
    let place = Place::of(Part::Commissioning).field(Field::NodeId);
    let is_note = node.node_id == Some(0) && is_type_description(device);
    let message = match node.node_id {
        Some(1..=127) => return,
        Some(255) => match stated::first_formula(device) {
            Some(formula) => return report_unknown_node_id(place, formula, findings),
            None => return,
        },
        Some(number) => say!("`{NodeID}` is {}, but node-IDs are 1 to 127", number),
        None if has_invalid_node_id(node) => return,
        None => say!("`{NodeID}` is missing").to_owned(),
    };
    let finding =
        INVALID_NODE_ID.at(place, message).help(say!("write `{NodeID=}` and a number from 1 to 127"));
    findings.push(if is_note { finding.severity(Severity::Note) } else { finding });
}

/// Whether an XML file describes a device type, not a node: it has no configured values.
fn is_type_description(device: &Device) -> bool {
    let mut entries = device.objects.values().flat_map(crate::model::Object::described);
    device.headers.network.is_some() && !entries.any(|(_, entry)| entry.configured_value().is_some())
}

fn has_invalid_node_id(node: &Commissioning) -> bool {
    node.invalid_values.get(&Field::NodeId).is_some()
}

fn report_unknown_node_id(place: Place, formula: Place, findings: &mut Findings) {
    let message = say!("`{NodeID}` is 255, so formulas with `$NODEID` have no value");
    let finding = INVALID_NODE_ID.at(place, message).label(formula, "a formula");
    findings.push(finding.help("write the node's future node-ID"));
}

fn missing_commissioning(device: &Device, findings: &mut Findings) {
    let says_something = !device.objects.is_empty() || device.device_info.is_some();
    if device.kind == DeviceKind::Node && device.commissioning.is_none() && says_something {
        let message = say!("{section} `{[DeviceComissioning]}` is missing");
        let finding = MISSING_COMMISSIONING.at(Place::device(), message);
        let finding = match stated::first_formula(device) {
            Some(formula) => finding.label(formula, "a formula without a value"),
            None => finding.severity(Severity::Warning),
        };
        findings.push(finding.help(match is_renamed_eds(device) {
            true => "rename the file to `.eds`: it configures nothing".into(),
            false => say!("add the {section} with `{NodeID}` and `{Baudrate}`"),
        }));
    }
}

/// Whether a file without a node is an EDS that was named as a DCF: it contains the name of an EDS and has no DCF keys.
fn is_renamed_eds(device: &Device) -> bool {
    let name = device.file_info.as_ref().and_then(|info| info.file_name.as_deref()).unwrap_or_default();
    let is_eds = name.to_ascii_lowercase().ends_with(".eds") && device.commissioning.is_none();
    is_eds && device.objects.iter().all(|(&index, object)| configured_places(index, object).next().is_none())
}

fn missing_node_name(device: &Device, findings: &mut Findings) {
    if device.commissioning.as_ref().is_none_or(|node| node.node_name.is_some()) {
        return;
    }
    let place = Place::of(Part::Commissioning).field(Field::NodeName);
    let message = say!("`{[DeviceComissioning]}` has no `{NodeName}`");
    let finding = MISSING_NODE_NAME.at(place.clone(), message).help(say!("add `{NodeName}`"));
    let name = device.device_info.as_ref().and_then(|info| info.product_name.clone());
    findings.push(match name.filter(|name| !name.is_empty()) {
        Some(name) => finding.fix(Fix::risky(say!("use the name of the product")).set(place, name)),
        None => finding,
    });
}
