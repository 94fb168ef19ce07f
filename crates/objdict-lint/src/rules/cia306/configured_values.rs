//! The configured values of a DCF.

use std::cmp::Ordering;

use crate::diagnostic::{Argument, Findings, Fix, Severity, counted, say};
use crate::model::{
    Access, DataType, Device, DeviceKind, Entry, Field, Object, ObjectType, Part, Place, Value,
};
use crate::rule::rules;
use crate::{EntryAt, profile, stated};

rules! {
    source: "CiA 306-1 §5.3.1";

    "cia306/configuration-in-eds" = CONFIGURATION_IN_EDS, Note, Device(configuration_in_eds);
    summary: "an EDS contains DCF keys",
    checks: "Reports DCF keys in an EDS: `ParameterValue`, `Denotation`, `UploadFile`, `DownloadFile`, `ParamRefd`, `[xxxxValue]`, `[xxxxDenotation]`, `LastEDS` and `[ConnectedModules]`. Only the first one is shown.",
    why: "Tools that read the file as an EDS ignore them. The file may be a DCF without its `[DeviceComissioning]`.",
    example: "`ParameterValue=500` in an EDS",
    remedy: "Remove the keys, write the value as `DefaultValue`, or convert the file to a DCF.",
    source: "CiA 306-1 §5",

    "cia306/misplaced-file" = MISPLACED_FILE, Error, Entry(misplaced_file);
    summary: "a file is given for an entry without file transfer",
    checks: "`UploadFile` and `DownloadFile` must belong to a DOMAIN, and only one of them may be given. `UploadFile` requires a readable DOMAIN, `DownloadFile` a writable one.",
    why: "The file holds the data of a DOMAIN. For other entries, or in the wrong direction, tools do not transfer the file.",
    example: "`DownloadFile=program.bin` of an UNSIGNED32",
    remedy: "Remove the key, and write `ParameterValue` if it is missing and the entry is not read-only. Alternatively, correct the object type or access.",

    "cia306/read-only-value" = READ_ONLY_VALUE, Warning, EntryOf(read_only_value), fix Unsafe;
    summary: "a DCF configures an entry that is not writable",
    checks: "Each `ParameterValue` that differs from the default must belong to a writable entry. For `ro` entries the finding is a note: a tool may have stored a value read from the node, as in the example of the standard. Sub-index 0 and the identity object are not checked.",
    why: "Tools cannot download the value to the node, although the author expects it.",
    example: "`AccessType=const`, `DefaultValue=8` and `ParameterValue=9`",
    remedy: "Remove the `ParameterValue`, or correct `AccessType`; where CiA 301 requires `ro`, as for 1000h, correct the default.",

    "cia306/value-of-no-download" = VALUE_OF_NO_DOWNLOAD, Note, Entry(value_of_no_download), fix Unsafe;
    summary: "a DCF configures an entry that `ObjFlags` excludes from downloads",
    checks: "Reports a `ParameterValue` other than the default in a writable entry with bit 0 of `ObjFlags` (no download).",
    why: "Tools skip such entries in a download, so the value never reaches the node. A tool that does not know the flag stores, restores or erases something.",
    example: "`ObjFlags=0x1` and `ParameterValue=0x65766173` in `[1010sub1]`",
    remedy: "Remove the `ParameterValue`.",
    source: "CiA 306-1 §4.6.3.3",
}

fn configuration_in_eds(device: &Device, findings: &mut Findings) {
    if device.kind == DeviceKind::Node {
        return;
    }
    let mut places = Vec::new();
    if device
        .file_info
        .as_ref()
        .is_some_and(|info| info.last_eds.as_ref().is_some_and(|name| !name.is_empty()))
    {
        places.push(Place::of(Part::FileInfo).field(Field::LastEds));
    }
    if device.modules.as_ref().is_some_and(|modules| modules.connected.is_some()) {
        places.push(Place::of(Part::ConnectedModules));
    }
    let mut others = 0usize;
    for (&index, object) in &device.objects {
        for place in configured_places(index, object) {
            if places.is_empty() { places.push(place) } else { others += 1 }
        }
    }
    let Some(first) = places.first() else { return };
    let what = match &first.field {
        Some(field) => say!("`{}`", field),
        None => say!("`{}`", first.part),
    };
    let others = others + places.len() - 1;
    let message = match others {
        0 => say!("{} belongs in {a DCF}", what),
        _ => say!("{} and {} belong in {a DCF}", what, counted(others, "similar item", "similar items")),
    };
    let finding = CONFIGURATION_IN_EDS.at(first.clone(), message);
    findings.push(finding.help(say!(
        "write values as `{DefaultValue}`, or add `{[DeviceComissioning]}` and rename the file to {.dcf}"
    )));
}

/// The DCF keys of an object.
pub(super) fn configured_places(index: u16, object: &Object) -> impl Iterator<Item = Place> {
    let entries = object.described().filter_map(move |(sub, entry)| {
        let field = configured_field(entry)?;
        Some(Place::at(index, sub).field(field))
    });
    let compact = object.compact.as_ref();
    let values = compact.filter(|compact| !compact.values.is_empty()).map(|_| Part::CompactValues(index));
    let names =
        compact.filter(|compact| !compact.denotations.is_empty()).map(|_| Part::CompactDenotations(index));
    entries.chain(values.into_iter().chain(names).map(Place::of))
}

fn configured_field(entry: &Entry) -> Option<Field> {
    let configured = entry.configured.as_ref()?;
    let stated = [
        (Field::ParameterValue, configured.value.is_some()),
        (Field::Denotation, configured.denotation.is_some()),
        (Field::UploadFile, configured.upload_file.is_some()),
        (Field::DownloadFile, configured.download_file.is_some()),
        (Field::ParamRefd, configured.reference_designator.is_some()),
    ];
    stated.into_iter().find(|(_, stated)| *stated).map(|(field, _)| field)
}

fn misplaced_file(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(configured) = &at.entry.configured else { return };
    let field = match (&configured.upload_file, &configured.download_file) {
        (None, None) => return,
        (Some(_), None) => Field::UploadFile,
        (_, Some(_)) => Field::DownloadFile,
    };
    let entry = at.entry;
    let is_domain =
        entry.object_type == Some(ObjectType::Domain) || entry.data_type == Some(DataType::DOMAIN);
    let access = entry.access;
    let (message, help) = if !is_domain {
        let what = entry.data_type.map_or("not a DOMAIN".into(), |data_type| say!("{}", data_type));
        (
            say!("`{}` is for a DOMAIN, but the entry is {}", field, what),
            match access.is_some_and(Access::is_writable) && configured.value.is_none() {
                true => say!("remove {the key} and write `{ParameterValue}`"),
                false => say!("remove {the key}"),
            },
        )
    } else if configured.upload_file.is_some() && configured.download_file.is_some() {
        (say!("the entry has both `{UploadFile}` and `{DownloadFile}`"), "remove one of the two".into())
    } else if field == Field::UploadFile && access == Some(Access::Wo) {
        (
            say!("`{UploadFile}` is for readable data, but the entry is `wo`"),
            say!("remove {the key}, or correct `{AccessType}`"),
        )
    } else if field == Field::DownloadFile && access.is_some_and(|access| !access.is_writable()) {
        (
            say!("`{DownloadFile}` is for writable data, but the entry is not writable"),
            say!("remove {the key}, or correct `{AccessType}`"),
        )
    } else {
        return;
    };
    findings.push(MISPLACED_FILE.at(at.field(field), message).help(help));
}

fn read_only_value(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(value) = at.entry.configured_value() else { return };
    let severity = match at.entry.access {
        Some(Access::Const) => Severity::Warning,
        Some(Access::Ro) => Severity::Note,
        _ => return,
    };
    let Some(default) = at.entry.default.as_ref().filter(|default| *default != value) else { return };
    let [node_id, _] = stated::node_ids(device);
    let same = stated::compare(value, default, node_id) == Some(Ordering::Equal);
    if same || at.index == 0x1018 || at.sub == Some(0) || !at.holds_value() || device.kind != DeviceKind::Node
    {
        return;
    }
    let access = at.entry.access.unwrap_or(Access::Ro);
    let message = say!(
        "`{ParameterValue}` is {:h}, but the entry is `{}` and its default is {:h}",
        value,
        access,
        default
    );
    let finding = READ_ONLY_VALUE
        .at(at.field(Field::ParameterValue), message)
        .severity(severity)
        .label(at.field(Field::AccessType), "not writable");
    let fix = Fix::risky(say!("remove `{ParameterValue}`")).remove(at.field(Field::ParameterValue));
    // the access type that the standard defines is right, so the default may be wrong
    let is_fixed = profile::access(device, at.index, at.sub).is_some_and(|access| !access.is_writable());
    findings.push(finding.fix(fix).help(match value {
        Value::Unsigned(number) if is_fixed => {
            let digits =
                at.entry.data_type.and_then(DataType::bit_length).map_or(0, |bits| usize::from(bits) / 4);
            let value = format!("0x{number:0digits$X}");
            let setting = Argument::setting(Field::DefaultValue, value);
            say!("remove `{ParameterValue}`, or write `{}` if the device returns it", setting)
        }
        _ if is_fixed => say!("remove `{ParameterValue}`, or correct `{DefaultValue}`"),
        _ => say!("remove `{ParameterValue}`, or correct `{AccessType}`"),
    }));
}

fn value_of_no_download(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(value) = at.entry.configured_value() else { return };
    if at.entry.default.as_ref() == Some(value) || !at.entry.access.is_some_and(Access::is_writable) {
        return;
    }
    let own = at.entry.flags().refuses_write();
    if own || at.sub.is_some_and(|sub| sub > 0) && at.object.main.flags().refuses_write() {
        let message = say!("`{ParameterValue}` is never written: `{ObjFlags}` bit 0 forbids the download");
        let flags = if own { at.place() } else { at.object_place() };
        let finding = VALUE_OF_NO_DOWNLOAD
            .at(at.field(Field::ParameterValue), message)
            .label(flags.field(Field::ObjFlags), "forbids the download");
        let fix = Fix::risky(say!("remove `{ParameterValue}`")).remove(at.field(Field::ParameterValue));
        findings.push(finding.help(say!("remove `{ParameterValue}`")).fix(fix));
    }
}
