//! Sections and keys that not all tools support, and services that CANopenNode and other stacks do not support.

use crate::diagnostic::{Findings, say};
use crate::model::{Device, Entry, Field, Part, Place};
use crate::rule::rules;
use crate::{stack, stated};
use objdict_model::canopennode::Cause;

rules! {
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026";

    "portability/auto-baud-rate" = AUTO_BAUD_RATE, Error, Device(auto_baud_rate);
    summary: "a tool does not support `BaudRate_auto`",
    checks: "Reports the key `BaudRate_auto` in `[DeviceInfo]`.",
    why: "dcf-tools supports only the keys of the first edition of CiA 306 and rejects a file with other keys.",
    example: "`BaudRate_auto=0`",
    remedy: "Remove the key if it is 0; otherwise use a copy without the key for the tool.",
    source: "dcf-tools 2.4.2",

    "portability/denotation" = DENOTATION, Note, Device(denotation);
    summary: "a tool drops a denotation",
    checks: "Reports entries of a DCF with a `Denotation`. The finding is at the first one and lists the others.",
    why: "python-canopen does not read the denotation and writes files without it: the application's name of the entry is lost.",
    example: "`Denotation=Pump 3`",
    remedy: "Repeat important denotations in `ParameterName`.",
    source: "python-canopen 2.4.1",

    "portability/dynamic-channels" = DYNAMIC_CHANNELS, Error, Device(dynamic_channels);
    summary: "a tool does not support `[DynamicChannels]`",
    checks: "Reports a section `[DynamicChannels]` in the file.",
    why: "dcf-tools rejects a file with unknown sections; python-canopen and CANopenEditor write files without the section.",
    example: "`[DynamicChannels]`",
    remedy: "Use a copy without the section for the tool; network variables then have no segments.",

    "portability/mapped-bits" = MAPPED_BITS, Warning, Device(mapped_bits);
    summary: "a PDO maps single bits",
    checks: "Reports entries of the default mapping whose length is not a multiple of eight bits.",
    why: "CANopenNode maps whole bytes unless configured for bits (`CO_CONFIG_PDO_BITWISE_MAPPING`); otherwise the PDO is not valid.",
    example: "`0x20000001` in 1A00h",
    remedy: "Map entries of whole bytes, or configure the stack for bits.",
    source: "PDOconfigMap of CANopenNode 4",

    "portability/modules" = MODULES, Error, Device(modules);
    summary: "a tool does not support modules",
    checks: "Reports modules that the file describes: `[SupportedModules]` and the sections `[Mx…]`.",
    why: "dcf-tools rejects a file with such sections. python-canopen reads only the device without the objects of the modules.",
    example: "`[SupportedModules]`",
    remedy: "Use a file of the device with its connected modules for the tool.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",

    "portability/no-error-history" = NO_ERROR_HISTORY, Error, Device(no_error_history);
    summary: "a stack needs 1003h (error history)",
    checks: "The device must have 1003h.",
    why: "CANopenNode keeps an error history unless configured otherwise (`CO_CONFIG_EM` without `CO_CONFIG_EM_HISTORY`). Without 1003h its start fails, without error information.",
    example: "no `[1003]`",
    remedy: "Describe 1003h as an ARRAY with at least one element, or configure the stack without the history.",
    source: "CO_EM_init of CANopenNode 4",

    "portability/object-flags" = OBJECT_FLAGS, Note, Device(object_flags);
    summary: "a tool ignores `ObjFlags`",
    checks: "Reports entries with an `ObjFlags` other than 0. The finding is at the first one and lists the others.",
    why: "dcf-tools accepts the key and writes the excluded entries. python-canopen does not support the key and writes files without it.",
    example: "`ObjFlags=1`, which forbids the download of the entry",
    remedy: "Check the values that the tool writes to these entries, or remove the values.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",

    "portability/object-links" = OBJECT_LINKS, Error, Device(object_links);
    summary: "a tool does not support object links",
    checks: "Reports objects with a section `[xxxxObjectLinks]`. The finding is at the first one and lists the others.",
    why: "dcf-tools rejects a file with unknown sections; python-canopen and CANopenEditor write files without the section.",
    example: "`[2000ObjectLinks]`",
    remedy: "Use a copy without the section for the tool: the section only groups objects.",

    "portability/parameter-reference" = PARAMETER_REFERENCE, Note, Device(parameter_reference);
    summary: "a tool drops a reference designator",
    checks: "Reports entries of a DCF with a `ParamRefd`. The finding is at the first one and lists the others.",
    why: "python-canopen and CANopenEditor write files without the key.",
    example: "`ParamRefd=-A1.X3`",
    remedy: "Keep the original file and do not edit it with the tool.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/safety-key" = SAFETY_KEY, Error, Device(safety_key);
    summary: "a tool does not support the keys of CANopen Safety",
    checks: "Reports entries with `SRDOMapping` or `InvertedSRAD`, and `CANopenSafetySupported` in `[DeviceInfo]`. The finding is at the first one and lists the others.",
    why: "dcf-tools rejects a file with unknown keys; python-canopen and CANopenEditor write files without them.",
    example: "`SRDOMapping=1`",
    remedy: "Use a copy of the file without these keys for the tool.",

    "portability/service-count" = SERVICE_COUNT, Error, Device(service_count);
    summary: "a stack does not support this number of objects",
    checks: "The number of objects per service must be within the limits of CANopenNode, which counts objects by index or count label (`CO_countLabel`). The limits are one for most services, 64 SRDOs, 128 SDO servers and 128 SDO clients, 255 RPDOs and 255 TPDOs. 1016h must have 1 to 127 elements.",
    why: "CANopenNode does not compile; PDOs above 255 are ignored because the count is a byte.",
    example: "1016h with 128 elements",
    remedy: "Describe fewer objects, or use the count label for one object only.",
    source: "CANopen.c of CANopenNode 4",

    "portability/service-gap" = SERVICE_GAP, Warning, Device(service_gap);
    summary: "the objects of a service are not consecutive",
    checks: "SDO servers and clients, RPDOs and TPDOs must be numbered from the first one without a gap, and each PDO must have its mapping.",
    why: "CANopenNode uses consecutive entries of its object list, starting at the first. After a gap it uses the wrong objects. Without the first one it does not compile.",
    example: "1800h and 1802h without 1801h",
    remedy: "Number the PDOs without a gap. Set bit 31 of the COB-ID of unused PDOs (not valid).",
    source: "CANopen.c of CANopenNode 4",

    "portability/service-object-missing" = SERVICE_OBJECT_MISSING, Error, Device(service_object_missing);
    summary: "an object required by a stack is missing",
    checks: "The device must have 1000h, 1001h, 1014h and 1017h, and also 1006h if it has 1005h. The rule also counts objects by the count labels of the description (`CO_countLabel`).",
    why: "CANopenNode is compiled with the objects of its services and does not compile if one of them is missing, although most of them are optional in CiA 301.",
    example: "no `[1017]`",
    remedy: "Describe the object. A producer heartbeat time of 0 and an EMCY COB-ID with bit 31 set (not valid) disable the services.",
    source: "CANopen.c of CANopenNode 4",

    "portability/sub-index-255" = SUB_INDEX_255, Error, Device(sub_index_255);
    summary: "an object has sub-index FFh",
    checks: "Reports objects with sub-index FFh, the structure of the object in CiA 301.",
    why: "The highest sub-index that dcf-tools allows is 254, so it rejects the file.",
    example: "`[2000subFF]`",
    remedy: "Remove the sub-index if the device does not need it; otherwise use a copy without it for the tool.",
    source: "dcf-tools 2.4.2",

    "portability/tool-list" = TOOL_LIST, Error, Device(tool_list);
    summary: "a tool does not support `[Tools]`",
    checks: "Reports a section `[Tools]` in the file.",
    why: "dcf-tools rejects a file with unknown sections; python-canopen and CANopenEditor write files without the sections.",
    example: "`[Tools]` and `[Tool1]`",
    remedy: "Use a copy without the sections for the tool. No device needs them.",

    "portability/type-definition" = TYPE_DEFINITION, Error, Device(type_definition);
    summary: "the file defines data types",
    checks: "Reports objects below 1000h, which define types. The finding is at the first one and lists the others.",
    why: "dcf-tools does not support such sections and rejects the file. python-canopen skips them and treats entries of these types as DOMAIN.",
    example: "`[40]` with `ObjectType=0x5`",
    remedy: "Use standard types and remove the definitions.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn auto_baud_rate(device: &Device, findings: &mut Findings) {
    let Some(auto) = device.device_info.as_ref().and_then(|info| info.baud_rates.auto) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::BaudRateAuto);
    let finding = AUTO_BAUD_RATE.at(place, say!("`{BaudRate_auto}` is {a key} of later editions of CiA 306"));
    findings.push(finding.help(if auto {
        say!("use a copy without {the key} for the tool")
    } else {
        say!("remove {the key}: 0 is the default")
    }));
}

fn denotation(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device)
        .filter(|(_, entry)| {
            entry.configured.as_ref().is_some_and(|configured| configured.denotation.is_some())
        })
        .map(|(place, _)| place.field(Field::Denotation));
    let texts = (
        say!("not all tools read `{Denotation}`"),
        say!("repeat important denotations in `{ParameterName}`"),
    );
    DENOTATION.report_each(places, texts, findings);
}

fn dynamic_channels(device: &Device, findings: &mut Findings) {
    if device.dynamic_channels.is_some() {
        let finding = DYNAMIC_CHANNELS
            .at(Place::of(Part::DynamicChannels), say!("`{[DynamicChannels]}` is {a section} of CiA 302"));
        findings.push(finding.help(say!("use a copy without the {section} for the tool")));
    }
}

fn modules(device: &Device, findings: &mut Findings) {
    if device.modules.is_some() {
        let finding = MODULES.at(Place::of(Part::SupportedModules), "the file describes modules");
        findings.push(
            finding.help("for the tool, use a file that describes the device with its connected modules"),
        );
    }
}

fn object_flags(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device)
        .filter(|(_, entry)| entry.flags().0 != 0)
        .map(|(place, _)| place.field(Field::ObjFlags));
    let texts = (
        say!("not all configuration tools observe `{ObjFlags}`"),
        "check the values that the tool writes to these entries",
    );
    OBJECT_FLAGS.report_each(places, texts, findings);
}

fn object_links(device: &Device, findings: &mut Findings) {
    let places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = !object.links.is_empty();
        is_meant.then(|| Place::of(Part::Links(index)))
    });
    let texts =
        ("some tools do not know object links", say!("use a copy without the {section} for the tool"));
    OBJECT_LINKS.report_each(places, texts, findings);
}

fn parameter_reference(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device)
        .filter(|(_, entry)| {
            entry.configured.as_ref().is_some_and(|configured| configured.reference_designator.is_some())
        })
        .map(|(place, _)| place.field(Field::ParamRefd));
    let texts = (say!("not all tools read `{ParamRefd}`"), "keep the original file");
    PARAMETER_REFERENCE.report_each(places, texts, findings);
}

fn safety_key(device: &Device, findings: &mut Findings) {
    let info = device.device_info.as_ref().filter(|info| info.safety_supported.is_some());
    let supported = info.map(|_| Place::of(Part::DeviceInfo).field(Field::CanOpenSafetySupported));
    let entries =
        stated::entries(device).filter_map(|(place, entry)| Some(place.field(safety_field(entry)?)));
    let places = supported.into_iter().chain(entries);
    let texts =
        (say!("{the key} belongs to CANopen Safety"), say!("use a copy without {the key} for the tool"));
    SAFETY_KEY.report_each(places, texts, findings);
}

fn safety_field(entry: &Entry) -> Option<Field> {
    let safety = entry.safety.as_ref()?;
    let stated = [
        (Field::SrdoMapping, safety.srdo_mapping.is_some()),
        (Field::InvertedSrad, safety.inverted_srad.is_some()),
    ];
    stated.into_iter().find(|(_, stated)| *stated).map(|(field, _)| field)
}

fn sub_index_255(device: &Device, findings: &mut Findings) {
    for (&index, object) in &device.objects {
        if object.subs.get(0xFF).is_some() && !object.orphan {
            let message = say!("{:04X}h has sub-index FFh", index);
            let finding = SUB_INDEX_255.at(Place::entry(index, 0xFF), message);
            findings.push(finding.help("use a copy without this sub-index for the tool"));
        }
    }
}

fn tool_list(device: &Device, findings: &mut Findings) {
    if !device.tools.is_empty() {
        let finding = TOOL_LIST.at(Place::of(Part::Tools), say!("some tools do not know `{[Tools]}`"));
        findings.push(finding.help(say!("use a copy without the {sections} for the tool")));
    }
}

fn type_definition(device: &Device, findings: &mut Findings) {
    let places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = index < 0x1000 && !object.orphan;
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let texts = (
        "some tools do not know data types defined in the file",
        "use standard types, and remove the definition",
    );
    TYPE_DEFINITION.report_each(places, texts, findings);
}

fn mapped_bits(device: &Device, findings: &mut Findings) {
    stack::unmet(&MAPPED_BITS.info, Cause::Bits, device, findings);
}

fn no_error_history(device: &Device, findings: &mut Findings) {
    stack::unmet(&NO_ERROR_HISTORY.info, Cause::NoHistory, device, findings);
}

fn service_count(device: &Device, findings: &mut Findings) {
    stack::unmet(&SERVICE_COUNT.info, Cause::Count, device, findings);
}

fn service_gap(device: &Device, findings: &mut Findings) {
    stack::unmet(&SERVICE_GAP.info, Cause::Gap, device, findings);
}

fn service_object_missing(device: &Device, findings: &mut Findings) {
    stack::unmet(&SERVICE_OBJECT_MISSING.info, Cause::Missing, device, findings);
}
