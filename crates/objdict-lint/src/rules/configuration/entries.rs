//! The product, revision and entries of a configuration, compared with its EDS.

use std::cmp::Ordering;

use crate::configured::{ConfiguredDevice, EntryPair};
use crate::diagnostic::{At, Diagnostic, Findings, Severity, say, series, sub_index};
use crate::model::{Access, Device, DeviceInfo, Entry, Field, Part, Place, Value};
use crate::rule::rules;
use crate::stated;

rules! {
    source: "CiA 306-1 §4.6.3.2, §5.3";

    "configuration/different-access" = DIFFERENT_ACCESS, Warning, Configured(different_access);
    summary: "an entry of a configuration has a different access type than in its EDS",
    checks: "Each entry of a DCF must have the `AccessType` of its EDS, where both specify one. `ro` and `const` are treated as equal: neither is downloaded.",
    why: "A tool downloads values that the device rejects, or it omits values that it must write.",
    example: "`AccessType=rw` in the DCF, and `AccessType=ro` in the EDS",
    remedy: "Write the access type of the EDS, or check with the EDS of the device.",

    "configuration/different-default" = DIFFERENT_DEFAULT, Warning, Configured(different_default);
    summary: "an entry of a configuration has a different default than in its EDS",
    checks: "Each entry of a DCF must have the `DefaultValue` of its EDS, where both specify one. Formulas are evaluated for the node-ID of the DCF. Other rules check the identity (1018h). In the DCF of a coupler, values that its modules change are not checked.",
    why: "Tools download only values that differ from the default. If the DCF has a different default, they omit a value that the device does not have.",
    example: "`DefaultValue=100` in the DCF, and `DefaultValue=0` in the EDS",
    remedy: "Write the value as `ParameterValue`, and the default of the EDS as `DefaultValue`.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",

    "configuration/different-limits" = DIFFERENT_LIMITS, Warning, Configured(different_limits);
    summary: "an entry of a configuration has different limits than in its EDS",
    checks: "`LowLimit` and `HighLimit` of each entry of a DCF must equal the limits in its EDS, where both specify them.",
    why: "A tool that checks values with the DCF accepts values that the device rejects, or the reverse.",
    example: "`HighLimit=200` in the DCF, and `HighLimit=100` in the EDS",
    remedy: "Write the limit of the EDS, or check with the EDS of the device.",

    "configuration/different-type" = DIFFERENT_TYPE, Error, Configured(different_type);
    summary: "an entry of a configuration has a different data type than in its EDS",
    checks: "Each entry of a DCF must have the `DataType` of its EDS, where both specify one.",
    why: "A download has the length of the wrong type: the device rejects it with abort code 06070010h or uses the wrong bytes.",
    example: "`DataType=0x0005` in the DCF, and `DataType=0x0006` in the EDS",
    remedy: "Write the data type of the EDS, or check with the EDS of the device.",

    "configuration/other-device" = OTHER_DEVICE, Error, Configured(other_device);
    summary: "a configuration and its EDS are for different devices",
    checks: "`VendorNumber` and `ProductNumber` of a DCF must equal the numbers in its EDS, and so must vendor-ID and product code in 1018h. If they differ, no other difference is reported.",
    why: "The configuration belongs to a different product: its entries may not exist in the device or may have a different meaning.",
    example: "`ProductNumber=0x11` in the DCF, and `ProductNumber=0x10` in the EDS",
    remedy: "Specify the EDS of the device with `--eds` or in `LastEDS`, or create the DCF from scratch.",
    source: "CiA 306-1 §4.4, §5.3; CiA 301 §7.5.2.21",

    "configuration/other-revision" = OTHER_REVISION, Warning, Configured(other_revision);
    summary: "a configuration and its EDS are for different revisions",
    checks: "`RevisionNumber` of a DCF must equal the number in its EDS, and so must the revision number in 1018h.",
    why: "A manager that compares the revision does not boot the node, and objects of the other revision can differ.",
    example: "`RevisionNumber=0x00010000` in the DCF, and `RevisionNumber=0x00020000` in the EDS",
    remedy: "Create a new DCF from the EDS of the device, or specify the EDS that it was created from.",
    source: "CiA 306-1 §4.4, §5.3; CiA 301 §7.5.2.21",

    "configuration/unknown-entry" = UNKNOWN_ENTRY, Warning, Configured(unknown_entry);
    summary: "an object or sub-index of a configuration is not in its EDS",
    checks: "Each object and sub-index of a DCF must be in its EDS, or `CompactPDO` or `CompactSubObj` must imply it. With a configured value the finding is an error. A DCF of a coupler is not checked, because its modules add objects.",
    why: "The device rejects the download with abort code 06020000h or 06090011h, and the configuration stops there.",
    example: "`[2001]` with `ParameterValue=5`, and an EDS without `[2001]`",
    remedy: "Remove the entry, or check with the EDS of the device.",
    source: "CiA 306-1 §5.3; CiA 301 §7.2.4.3.17",

    "configuration/value-outside-limits" = VALUE_OUTSIDE_LIMITS, Error, Configured(value_outside_limits);
    summary: "a configured value is outside the limits of the EDS",
    checks: "Each `ParameterValue` of a DCF must be between `LowLimit` and `HighLimit` of its EDS. For a value outside the limits of the DCF itself, see `cia306/value-outside-limits`.",
    why: "The device rejects the download with abort code 06090031h or 06090032h.",
    example: "`ParameterValue=150` in the DCF, and `HighLimit=100` in the EDS",
    remedy: "Configure a value that the device accepts.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",
}

fn different_access(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    for pair in configured.pairs() {
        let Some((is, original)) = pair.entry.access.zip(pair.original.access) else { continue };
        let is_written = |access| !matches!(access, Access::Ro | Access::Const);
        if is != original && (is_written(is) || is_written(original)) {
            let message = say!(
                "{} has access type `{}`, but `{}` in the {EDS}",
                pair.name(),
                is.name(),
                original.name()
            );
            let finding = configured.finding(&DIFFERENT_ACCESS.info, &pair, Field::AccessType, message);
            findings.push(finding.help(say!("write the access type of the {EDS}")));
        }
    }
}

fn different_default(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    // the modules of a coupler change the module list and the size of the arrays that they extend
    let is_of_modules = |pair: &EntryPair<'_>| {
        configured.origin.is_modular() && (pair.index == 0x1027 || pair.sub == Some(0))
    };
    for pair in configured.pairs().filter(|pair| pair.index != 0x1018 && !is_of_modules(pair)) {
        let Some((is, original)) = pair.entry.default.as_ref().zip(pair.original.default.as_ref()) else {
            continue;
        };
        if configured.differ(is, original) {
            let message = say!("the default of {} is {:h}, but {:h} in the {EDS}", pair.name(), is, original);
            let finding = configured.finding(&DIFFERENT_DEFAULT.info, &pair, Field::DefaultValue, message);
            findings.push(
                finding.help(say!("write the value as `{ParameterValue}`, and the default of the {EDS}")),
            );
        }
    }
}

type Limit = fn(&Entry) -> Option<&Value>;

fn different_limits(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    let limits: [(Field, Limit); 2] = [
        (Field::LowLimit, |entry| entry.low_limit.as_ref()),
        (Field::HighLimit, |entry| entry.high_limit.as_ref()),
    ];
    for pair in configured.pairs() {
        for (field, limit) in &limits {
            let Some((is, original)) = limit(pair.entry).zip(limit(&pair.original)) else { continue };
            if configured.differ(is, original) {
                let message =
                    say!("`{}` of {} is {:h}, but {:h} in the {EDS}", field, pair.name(), is, original);
                let finding = configured.finding(&DIFFERENT_LIMITS.info, &pair, field.clone(), message);
                findings.push(finding.help(say!("write the limit of the {EDS}")));
            }
        }
    }
}

fn different_type(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    for pair in configured.pairs() {
        let Some((is, original)) = pair.entry.data_type.zip(pair.original.data_type) else { continue };
        if is != original {
            let message = say!("{} has data type `{}`, but `{}` in the {EDS}", pair.name(), is, original);
            let finding = configured.finding(&DIFFERENT_TYPE.info, &pair, Field::DataType, message);
            findings.push(finding.help(say!("write the data type of the {EDS}")));
        }
    }
}

fn unknown_entry(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    if configured.origin.is_modular() {
        return;
    }
    for (&index, object) in &configured.device.objects {
        let Some(origin) = configured.origin.object(index) else {
            if !object.orphan {
                let is_configured = object.entries().any(|(_, entry)| entry.configured_value().is_some());
                let message = say!("the {EDS} has no object {:04X}h", index);
                push_by_use(UNKNOWN_ENTRY.at(Place::object(index), message), is_configured, findings);
            }
            continue;
        };
        let subs = object.described().filter_map(|(sub, entry)| Some((sub?, entry)));
        let missing: Vec<(u8, &Entry)> = subs.filter(|(sub, _)| !origin.has(*sub)).collect();
        let Some((first, _)) = missing.first() else { continue };
        let is_configured = missing.iter().any(|(_, entry)| entry.configured_value().is_some());
        let list = series(missing.iter().map(|(sub, _)| sub_index(*sub)));
        let message = say!("the {EDS} has no {} {} in {:04X}h", count_noun(missing.len()), list, index);
        let finding = UNKNOWN_ENTRY.at(Place::entry(index, *first), message);
        let finding = finding.label(At::Node(0, Place::object(index)), say!("in the {EDS}"));
        push_by_use(finding, is_configured, findings);
    }
}

fn count_noun(count: usize) -> &'static str {
    if count == 1 { "sub-index" } else { "sub-indexes" }
}

fn push_by_use(finding: Diagnostic, is_configured: bool, findings: &mut Findings) {
    let finding = finding.help(say!("remove it, or check with the device's {EDS}"));
    findings.push(if is_configured { finding.severity(Severity::Error) } else { finding });
}

fn value_outside_limits(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    let node_id = configured.node_id();
    for pair in configured.pairs() {
        let Some(value) = pair.entry.configured_value() else { continue };
        let beyond = |limit: Option<&Value>, order| {
            limit.is_some_and(|limit| stated::compare(value, limit, node_id) == Some(order))
        };
        let original = &pair.original;
        let sides = [
            (Field::LowLimit, &pair.entry.low_limit, &original.low_limit, Ordering::Less),
            (Field::HighLimit, &pair.entry.high_limit, &original.high_limit, Ordering::Greater),
        ];
        let exceeded = sides
            .into_iter()
            .find(|(_, own, limit, order)| beyond(limit.as_ref(), *order) && !beyond(own.as_ref(), *order));
        // the limits apply to the signature, not to the value returned by reading
        let Some((field, _, Some(limit), _)) = exceeded.filter(|_| !matches!(pair.index, 0x1010 | 0x1011))
        else {
            continue;
        };
        let message =
            say!("{} is configured as {:h}, but `{}` is {:h} in the {EDS}", pair.name(), value, field, limit);
        let place = configured.device.value_place(pair.index, pair.sub.unwrap_or_default());
        let finding = VALUE_OUTSIDE_LIMITS.at(place, message);
        let sub = Place::at(pair.index, pair.sub);
        let finding = finding.label(At::Node(0, sub.field(field)), say!("in the {EDS}"));
        findings.push(finding.help("configure a value that the device accepts"));
    }
}

fn other_device(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    let (device, origin) = (configured.device, configured.written);
    for (field, name, number, sub) in IDENTITY {
        let Some((place, is, other, wanted)) = difference(device, origin, &field, number, sub) else {
            continue;
        };
        let message = say!("the {} is `0x{:08X}`, but `0x{:08X}` in the {EDS}", name, is, wanted);
        let finding = OTHER_DEVICE.at(place, message);
        findings.push(
            finding
                .label(At::Node(0, other), say!("in the {EDS}"))
                .help(say!("check with the device's {EDS}")),
        );
    }
}

type NumberField = fn(&DeviceInfo) -> Option<u32>;

const IDENTITY: [(Field, &str, NumberField, u8); 2] = [
    (Field::VendorNumber, "vendor-ID", |info| info.vendor_number, 1),
    (Field::ProductNumber, "product code", |info| info.product_number, 2),
];

/// Whether both are descriptions of the same product.
pub(crate) fn is_same(device: &Device, origin: &Device) -> bool {
    IDENTITY.iter().all(|(field, _, number, sub)| difference(device, origin, field, *number, *sub).is_none())
}

/// Different numbers of two devices, in the device information or in a sub-index of 1018h: the place and the number of
/// each.
fn difference(
    device: &Device,
    origin: &Device,
    field: &Field,
    number: NumberField,
    sub: u8,
) -> Option<(Place, u32, Place, u32)> {
    let of_info = |device: &Device| device.device_info.as_ref().and_then(number);
    let of_object = |device: &Device| u32::try_from(device.value(0x1018, sub)?.as_integer()?).ok();
    let info = || Place::of(Part::DeviceInfo).field(field.clone());
    let differing =
        |left: Option<u32>, right: Option<u32>| left.zip(right).filter(|(left, right)| left != right);
    differing(of_info(device), of_info(origin)).map(|(is, wanted)| (info(), is, info(), wanted)).or_else(
        || {
            let (is, wanted) = differing(of_object(device), of_object(origin))?;
            Some((device.value_place(0x1018, sub), is, origin.value_place(0x1018, sub), wanted))
        },
    )
}

fn other_revision(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    let (device, origin) = (configured.device, configured.written);
    let found = difference(device, origin, &Field::RevisionNumber, |info| info.revision_number, 3);
    let Some((place, is, other, wanted)) = found else { return };
    let message = say!("the revision number is `0x{:08X}`, but `0x{:08X}` in the {EDS}", is, wanted);
    let finding = OTHER_REVISION.at(place, message).label(At::Node(0, other), say!("in the {EDS}"));
    findings.push(finding.help(say!("recreate the configuration from this {EDS}")));
}
