//! Values that not all tools read correctly.

use crate::diagnostic::{Findings, Fix, listing, listing_or, say};
use crate::model::{Access, DataType, Device, Entry, Field, ModulePart, ObjectType, Part, Place, Value};
use crate::rule::rules;
use crate::{EntryAt, EntryOwner, stated};

rules! {
    "portability/domain-without-type" = DOMAIN_WITHOUT_TYPE, Error, Entry(domain_without_type), fix Safe;
    summary: "a DOMAIN has no data type or access",
    checks: "Whether an object of type DOMAIN has `DataType` and `AccessType`. The standard does not require them: the data type is DOMAIN, the access `rw`.",
    why: "dcf-tools and python-canopen read both keys of each object with a value and fail if one is missing.",
    example: "`ObjectType=0x2` without `DataType`",
    remedy: "Write `DataType=0x000F` and `AccessType=rw` (the defaults).",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",

    "portability/empty-text" = EMPTY_TEXT, Error, Device(empty_text);
    summary: "a tool does not accept an empty text",
    checks: "Whether `VendorName`, `ProductName` and `OrderCode` of the device and of its modules have a text, if they are there.",
    why: "CANchkEDS reports mandatory keys without a value.",
    example: "`OrderCode=`",
    remedy: "Write the order code.",
    source: "CANchkEDS 4.0",

    "portability/file-reference" = FILE_REFERENCE, Note, Device(file_reference);
    summary: "a tool ignores the file of a DOMAIN",
    checks: "Whether an entry of a DCF has an `UploadFile` or a `DownloadFile`. The first one is shown with the others.",
    why: "python-canopen and CANopenEditor neither load the file nor write its name back.",
    example: "`DownloadFile=firmware.bin`",
    remedy: "Load the file in the application, or use a tool that supports it.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/long-value" = LONG_VALUE, Note, Device(long_value);
    summary: "a configured value has more than four bytes",
    checks: "Whether a writable entry with a default or configured value has a type of more than four bytes or of variable length. The first one is shown with the others.",
    why: "CODESYS configures entries of up to four bytes by SDO; the application must write longer ones.",
    example: "A writable UNSIGNED64 with a default",
    remedy: "Write the entry from the application, or split it into entries of four bytes.",
    source: "Manual of CODESYS, tab `SDOs` of a CANopen remote device",

    "portability/time-value" = TIME_VALUE, Warning, Device(time_value);
    summary: "a time of day or a duration has a value",
    checks: "Whether an entry of type TIME_OF_DAY or TIME_DIFFERENCE has a default or configured value. The first one is shown with the others.",
    why: "python-canopen does not know these types and reads an integer: the space between days and milliseconds is removed, and `1 2` becomes 12.",
    example: "`DefaultValue=1 0x36EE80` of a TIME_OF_DAY",
    remedy: "Remove the value if 0 is acceptable.",
    source: "python-canopen 2.4.1",
}

fn domain_without_type(at: &EntryAt<'_>, findings: &mut Findings) {
    if at.origin != EntryOwner::Device || at.object_type() != Some(ObjectType::Domain) {
        return;
    }
    let stated = [
        (Field::DataType, "0x000F", at.entry.data_type.is_some()),
        (Field::AccessType, "rw", at.entry.access.is_some()),
    ];
    let missing =
        stated.into_iter().filter(|(field, _, stated)| !stated && !stated::is_invalid(at.entry, field));
    let missing: Vec<(Field, &str)> = missing.map(|(field, value, _)| (field, value)).collect();
    if missing.is_empty() {
        return;
    }
    let lines: Vec<String> = missing.iter().map(|(field, value)| format!("{field}={value}")).collect();
    let message = say!("this DOMAIN has no {}", listing_or(missing.iter().map(|(field, _)| field)));
    let fix = Fix::safe(say!("add {}", listing(&lines)));
    let fix = missing.iter().fold(fix, |fix, (field, value)| fix.set(at.field(field.clone()), *value));
    findings.push(DOMAIN_WITHOUT_TYPE.at(at.place(), message).help(say!("add {}", listing(&lines))).fix(fix));
}

fn empty_text(device: &Device, findings: &mut Findings) {
    if let Some(info) = &device.device_info {
        report_empty_text(&Part::DeviceInfo, Field::VendorName, info.vendor_name.as_deref(), findings);
        report_empty_text(&Part::DeviceInfo, Field::ProductName, info.product_name.as_deref(), findings);
        report_empty_text(&Part::DeviceInfo, Field::OrderCode, info.order_code.as_deref(), findings);
    }
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let info = Part::Module(number, ModulePart::Info);
        report_empty_text(&info, Field::ProductName, module.product_name.as_deref(), findings);
        report_empty_text(&info, Field::OrderCode, module.order_code.as_deref(), findings);
    }
}

fn report_empty_text(part: &Part, field: Field, text: Option<&str>, findings: &mut Findings) {
    if text.is_some_and(|text| text.trim().is_empty()) {
        let message = say!("`{}` of `{}` is empty", field, part);
        findings.push(EMPTY_TEXT.at(Place::of(part.clone()).field(field), message).help("write the text"));
    }
}

fn file_reference(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device).filter_map(|(place, entry)| Some(place.field(file_field(entry)?)));
    let texts = ("not all tools load the file of this entry", "load the file in the application");
    FILE_REFERENCE.report_all(places, "another one", texts, findings);
}

fn file_field(entry: &Entry) -> Option<Field> {
    let configured = entry.configured.as_ref()?;
    let stated = [
        (Field::DownloadFile, configured.download_file.is_some()),
        (Field::UploadFile, configured.upload_file.is_some()),
    ];
    stated.into_iter().find(|(_, stated)| *stated).map(|(field, _)| field)
}

fn long_value(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device).filter(|(_, entry)| is_long_value(entry)).map(|(place, entry)| {
        let field =
            if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue };
        place.field(field)
    });
    let texts = ("the value has more than four bytes", "write the entry from the application");
    LONG_VALUE.report_all(places, "another one", texts, findings);
}

fn is_long_value(entry: &Entry) -> bool {
    let is_short = entry.data_type.and_then(DataType::byte_length).is_some_and(|bytes| bytes <= 4);
    entry.value().is_some() && entry.access.is_some_and(Access::is_writable) && !is_short
}

fn time_value(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device).filter_map(|(place, entry)| Some(place.field(time_field(entry)?)));
    let texts = ("not all tools read times", "remove the value if 0 is acceptable");
    TIME_VALUE.report_all(places, "another one", texts, findings);
}

fn time_field(entry: &Entry) -> Option<Field> {
    match (entry.configured_value(), &entry.default) {
        (Some(Value::Time(_)), _) => Some(Field::ParameterValue),
        (_, Some(Value::Time(_))) => Some(Field::DefaultValue),
        _ => None,
    }
}
