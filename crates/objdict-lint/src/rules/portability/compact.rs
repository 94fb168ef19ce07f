//! Compact objects, whose sections not all tools read.

use crate::diagnostic::{Findings, say};
use crate::model::{Compact, Device, Part, Place};
use crate::rule::rules;
use crate::with_others;

rules! {
    "portability/compact-denotations" = COMPACT_DENOTATIONS, Error, Device(compact_denotations);
    summary: "a tool does not know the denotations of a compact object",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxDenotation]`. The first one is shown with the others.",
    why: "dcf-tools knows `[xxxxName]` and `[xxxxValue]`, but not this section, and refuses the file.",
    example: "`[2000Denotation]`",
    remedy: "Use `[xxxxName]`, or describe the sub-indexes individually.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/compact-names" = COMPACT_NAMES, Warning, Device(compact_names);
    summary: "a tool ignores the names of a compact object",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxName]` without a gap. The first one is shown with the others.",
    why: "CANopenEditor does not read the section and names the sub-indexes after the object, with a hex number appended.",
    example: "`[2000Name]`",
    remedy: "Describe the sub-indexes individually if their names matter.",
    source: "CANopenEditor of 2026",

    "portability/compact-parameter-value" = COMPACT_PARAMETER_VALUE, Error, Device(compact_parameter_value);
    summary: "a compact object has one configured value for all sub-indexes",
    checks: "Whether an object with `CompactSubObj` has a `ParameterValue`, but no section `[xxxxValue]`. The first one is shown with the others.",
    why: "dcf-tools does not read the value of the key correctly and crashes.",
    example: "`CompactSubObj=8` and `ParameterValue=1`",
    remedy: "Write the value of each sub-index in `[xxxxValue]`.",
    source: "dcf-tools 2.4.2",

    "portability/compact-storage" = COMPACT_STORAGE, Warning, Device(compact_storage);
    summary: "a tool does not support `CompactSubObj` correctly",
    checks: "Whether an object has `CompactSubObj` without a section of names, values or denotations, which have their own rules. The first one is shown with the others.",
    why: "CANopenEditor creates the sub-indexes, but drops their default and mapping and uses the low limit as the high limit. python-canopen creates the sub-indexes of an ARRAY on access, without a value in sub-index 0, and none for a RECORD.",
    example: "`CompactSubObj=8`",
    remedy: "Describe the sub-indexes individually.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/compact-values" = COMPACT_VALUES, Warning, Device(compact_values);
    summary: "a tool ignores the values of a compact object",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxValue]`. The first one is shown with the others.",
    why: "python-canopen and CANopenEditor do not read the section: they use the default instead of the configured values.",
    example: "`[2000Value]`",
    remedy: "Describe the sub-indexes individually, each with its `ParameterValue`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn compact_denotations(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| !compact.denotations.is_empty());
        is_meant.then(|| Place::of(Part::CompactDenotations(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = COMPACT_DENOTATIONS
        .at(first, "not all tools read the denotations of a compact object")
        .help(say!("use `{[xxxxName]}`, or describe the sub-indexes individually"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

fn compact_names(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object
            .compact
            .as_ref()
            .is_some_and(|compact| !compact.names.is_empty() && !has_gap_in_names(compact));
        is_meant.then(|| Place::of(Part::CompactNames(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = COMPACT_NAMES
        .at(first, "not all tools read the names of a compact object")
        .help("describe the sub-indexes individually");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

/// Whether a name between 1 and the number of names is missing, which another rule reports.
fn has_gap_in_names(compact: &Compact) -> bool {
    (1..=compact.names.len()).any(|sub| compact.names.iter().all(|(named, _)| usize::from(*named) != sub))
}

fn compact_parameter_value(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| compact.values.is_empty())
            && object.main.configured_value().is_some();
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = COMPACT_PARAMETER_VALUE
        .at(first, say!("`{ParameterValue}` of a compact object configures all sub-indexes"))
        .help(say!("write the values in `{[xxxxValue]}`"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

fn compact_storage(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| has_no_sections(compact))
            && object.main.configured_value().is_none();
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = COMPACT_STORAGE
        .at(first, say!("not all tools support `{CompactSubObj}` as the standard defines it"))
        .help("describe the sub-indexes individually");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

/// Whether the object has no sections for its sub-indexes.
fn has_no_sections(compact: &Compact) -> bool {
    compact.names.is_empty() && compact.values.is_empty() && compact.denotations.is_empty()
}

fn compact_values(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| !compact.values.is_empty());
        is_meant.then(|| Place::of(Part::CompactValues(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = COMPACT_VALUES
        .at(first, "not all tools read the values of a compact object")
        .help("describe the sub-indexes individually");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
