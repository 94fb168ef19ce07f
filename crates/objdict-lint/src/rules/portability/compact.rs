//! Compact objects, whose sections not all tools read.

use crate::diagnostic::{Findings, say};
use crate::model::{Compact, Device, Object, Part, Place};
use crate::rule::rules;

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

/// The places of the compact objects that a rule is about.
fn compact_objects(
    device: &Device,
    part: fn(u16) -> Part,
    is_meant: impl Fn(&Object, &Compact) -> bool,
) -> impl Iterator<Item = Place> {
    device.objects.iter().filter_map(move |(&index, object)| {
        let compact = object.compact.as_ref()?;
        is_meant(object, compact).then(|| Place::of(part(index)))
    })
}

fn compact_denotations(device: &Device, findings: &mut Findings) {
    let places =
        compact_objects(device, Part::CompactDenotations, |_, compact| !compact.denotations.is_empty());
    let texts = (
        "not all tools read the denotations of a compact object",
        say!("use `{[xxxxName]}`, or describe the sub-indexes individually"),
    );
    COMPACT_DENOTATIONS.report_all(places, "the same here", texts, findings);
}

fn compact_names(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::CompactNames, |_, compact| {
        !compact.names.is_empty() && !has_gap_in_names(compact)
    });
    let texts = ("not all tools read the names of a compact object", "describe the sub-indexes individually");
    COMPACT_NAMES.report_all(places, "the same here", texts, findings);
}

/// Whether a name between 1 and the number of names is missing, which another rule reports.
fn has_gap_in_names(compact: &Compact) -> bool {
    (1..=compact.names.len()).any(|sub| compact.names.iter().all(|(named, _)| usize::from(*named) != sub))
}

fn compact_parameter_value(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::Object, |object, compact| {
        compact.values.is_empty() && object.main.configured_value().is_some()
    });
    let texts = (
        say!("`{ParameterValue}` of a compact object configures all sub-indexes"),
        say!("write the values in `{[xxxxValue]}`"),
    );
    COMPACT_PARAMETER_VALUE.report_all(places, "the same here", texts, findings);
}

fn compact_storage(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::Object, |object, compact| {
        has_no_sections(compact) && object.main.configured_value().is_none()
    });
    let texts = (
        say!("not all tools support `{CompactSubObj}` as the standard defines it"),
        "describe the sub-indexes individually",
    );
    COMPACT_STORAGE.report_all(places, "the same here", texts, findings);
}

/// Whether the object has no sections for its sub-indexes.
fn has_no_sections(compact: &Compact) -> bool {
    compact.names.is_empty() && compact.values.is_empty() && compact.denotations.is_empty()
}

fn compact_values(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::CompactValues, |_, compact| !compact.values.is_empty());
    let texts =
        ("not all tools read the values of a compact object", "describe the sub-indexes individually");
    COMPACT_VALUES.report_all(places, "the same here", texts, findings);
}
