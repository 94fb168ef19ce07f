use crate::diagnostic::{Diagnostic, Findings, counted, say};
use crate::model::{Device, DeviceKind, Entry, Field, Object, Part, Place};
use crate::rule;

rule! {
    "cia306/configuration-in-eds", Note, Device(check);
    summary: "an EDS has keys of a DCF",
    checks: "Whether an EDS uses keys of a DCF: `ParameterValue`, `Denotation`, `UploadFile`, `DownloadFile`, `ParamRefd`, `[xxxxValue]`, `[xxxxDenotation]`, `LastEDS` and `[ConnectedModules]`. Only the first one is shown.",
    why: "Tools that read the file as an EDS ignore them. The file may be a DCF without its `[DeviceComissioning]`.",
    example: "`ParameterValue=500` in an EDS",
    remedy: "Remove the keys, write the value as `DefaultValue`, or convert the file to a DCF.",
    source: "CiA 306-1 §5",
}

fn check(device: &Device, findings: &mut Findings) {
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
        for place in of_object(index, object) {
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
    let finding = Diagnostic::new(&RULE.info, first.clone(), message);
    findings.push(finding.help(say!(
        "write values as `{DefaultValue}`, or add `{[DeviceComissioning]}` and rename the file to {.dcf}"
    )));
}

fn of_object(index: u16, object: &Object) -> impl Iterator<Item = Place> {
    let entries = object.described().filter_map(move |(sub, entry)| {
        let field = configured_field(entry)?;
        Some(sub.map_or(Place::object(index), |sub| Place::entry(index, sub)).field(field))
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
