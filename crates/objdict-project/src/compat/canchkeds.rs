//! The reports of CANchkEDS of Vector according to its public help: errors (E) and warnings (W) with their numbers. It
//! checks only EDS files. Its database of objects is not public; the numbers E30, E38 and E39 represent the content of
//! CiA documents.

use super::reactions::{is_at_header, section_of, shown};
use super::{Effect, Reaction, When};
use objdict_format::Description;
use objdict_model::diagnostic::{At, Change, Diagnostic, Severity, Tool};
use objdict_model::model::{Part, Place};

const CANCHKEDS: &[Tool] = &[Tool::CanChkEds];

const fn error(rule: &'static str, what: &'static str) -> Reaction {
    Reaction { rule, tools: CANCHKEDS, effect: Effect::Failed, what, when: None }
}

const fn warning(rule: &'static str, what: &'static str) -> Reaction {
    Reaction { rule, tools: CANCHKEDS, effect: Effect::Warned, what, when: None }
}

impl Reaction {
    const fn only(self, text: &'static str, holds: fn(&Description, &Diagnostic) -> bool) -> Self {
        Self { when: Some(When { text, holds }), ..self }
    }
}

/// The messages, in the order of the rules.
pub static MESSAGES: &[Reaction] = &[
    warning("cia301/cob-id-not-predefined", "warning W30"),
    warning("cia301/default-error-register", "warning W30"),
    warning("cia301/default-sdo-cob-id", "warning W30"),
    warning("cia301/fixed-node-id", "warning W30"),
    error("cia301/gap-in-mapping", "error E11"),
    error("cia301/granularity-against-access", "error E69 or E70"),
    error("cia301/incomplete-pdo-parameter", "error E39"),
    error("cia301/incomplete-sdo-parameter", "error E39"),
    error("cia301/invalid-dummy-mapping", "error E74"),
    error("cia301/mappable-without-pdo", "error E61"),
    error("cia301/mapped-object-missing", "error E63"),
    error("cia301/mapped-object-not-mappable", "error E35"),
    error("cia301/mapping-granularity", "error E75"),
    error("cia301/mapping-of-variable-length", "error E66"),
    warning("cia301/mapping-without-valid-bit", "warning W26"),
    error("cia301/missing-mandatory-object", "error E9"),
    error("cia301/missing-module-list", "error E54"),
    error("cia301/mixed-mapping-access", "error E67 or E68"),
    error("cia301/module-list-without-modules", "error E55"),
    error("cia301/obsolete-object", "error E71 or E72").only("1004h with wrong numbers", is_warning),
    error("cia301/pdo-length-exceeded", "error E64"),
    warning("cia301/service-cob-id-not-predefined", "warning W30"),
    error("cia301/undefined-sub-index", "error E38"),
    error("cia301/wrong-access", "error E30"),
    error("cia301/wrong-data-type", "error E30"),
    warning("cia301/wrong-mapping-count", "warning W51"),
    error("cia301/wrong-mapping-direction", "error E8"),
    error("cia301/wrong-mapping-length", "error E65"),
    error("cia301/wrong-object-type", "error E30"),
    error("cia306/array-of-mixed-types", "error E42"),
    error("cia306/blanks-in-section-name", "error E12"),
    error("cia306/compact-and-sub-number", "error E27"),
    error("cia306/date-spelling", "error E29"),
    error("cia306/described-standard-type", "error E31"),
    error("cia306/dummy-below-granularity", "error E76"),
    error("cia306/duplicate-key", "error E25"),
    error("cia306/duplicate-section", "error E4"),
    warning("cia306/dynamic-channels-flag", "warning W6"),
    error("cia306/eds-version", "error E41"),
    error("cia306/group-messaging-flag", "error E73").only("a multiplexed PDO", is_warning),
    error("cia306/identity-mismatch", "error E130"),
    error("cia306/indented-section", "error E3"),
    error("cia306/invalid-list-entry", "error E29"),
    error("cia306/invalid-object-flags", "error E22"),
    error("cia306/invalid-value", "error E21, E22 or E29"),
    error("cia306/line-too-long", "error E23"),
    error("cia306/link-to-missing-object", "error E7 or E13"),
    warning("cia306/list-numbering", "warning W3"),
    error("cia306/listed-object-missing", "error E1"),
    error("cia306/mapping-not-possible", "error E30"),
    error("cia306/missing-device-info-key", "error E26"),
    error("cia306/missing-file-info-key", "error E26 or E29").only("a key of the creation", is_warning),
    error("cia306/missing-key", "error E26, E33 or E34"),
    error("cia306/missing-module-info", "error E26"),
    error("cia306/missing-name", "error E26"),
    error("cia306/missing-section", "error E1"),
    error("cia306/missing-sub-0", "error E14"),
    error("cia306/misspelt-key", "error E24 or E26"),
    error("cia306/misspelt-section", "error E1"),
    error("cia306/module-conflict", "error E53"),
    error("cia306/module-list-mismatch", "error E1"),
    error("cia306/module-overlap", "error E10 or E51"),
    error("cia306/module-without-objects", "error E52"),
    error("cia306/number-suffix", "error E21"),
    error("cia306/object-listed-twice", "error E37"),
    warning("cia306/object-not-listed", "warning W1"),
    error("cia306/reserved-index", "error E32").only("below 1000h", |_, finding| {
        let at = finding.labels.first().map(|label| &label.at);
        matches!(at, Some(At::Place(Place { part: Part::Object(..0x1000), .. })))
    }),
    warning("cia306/reserved-key", "warning W22"),
    error("cia306/section-spelling", "error E12"),
    error("cia306/stray-compact-section", "error E40"),
    error("cia306/sub-number-mismatch", "error E6").only("fewer sub-indexes", has_fewer),
    warning("cia306/sub-number-mismatch", "warning W2")
        .only("more sub-indexes", |description, finding| !has_fewer(description, finding)),
    error("cia306/trailing-comment", "error E21"),
    error("cia306/unclosed-section", "error E2"),
    error("cia306/unknown-key", "error E24").only("in an information section", is_of_information),
    warning("cia306/unknown-key", "warning W21")
        .only("elsewhere", |description, finding| !is_of_information(description, finding)),
    warning("cia306/unknown-section", "warning W1"),
    error("cia306/unsupported-key", "error E27"),
    warning("cia306/wrong-compact-pdo", "warning W50").only("no PDO", |description, _| {
        let info = description.device().device_info.as_ref();
        info.is_some_and(|info| info.rpdo_count == Some(0) && info.tpdo_count == Some(0))
    }),
    error("cia306/wrong-count", "error E5").only("fewer entries", has_fewer),
    warning("cia306/wrong-count", "warning W21")
        .only("more entries", |description, finding| !has_fewer(description, finding)),
    error("cia306/wrong-highest-sub-index", "error E36").only("with a value", has_value),
    warning("cia306/wrong-highest-sub-index", "warning W24")
        .only("without a value", |description, finding| !has_value(description, finding)),
    error("cia306/wrong-object-list", "error E28"),
    error("cia306/wrong-pdo-count", "error E62"),
    error("portability/empty-text", "error E21"),
    warning("portability/tool-list", "warning W21"),
    warning("portability/type-definition", "warning W23"),
    warning("portability/unclear-direction", "warning W4 or W5"),
    warning("portability/unused-mapping-slot", "warning W25"),
];

fn is_warning(_: &Description, finding: &Diagnostic) -> bool {
    finding.severity > Severity::Note
}

fn is_of_information(description: &Description, finding: &Diagnostic) -> bool {
    section_of(description, finding).to_ascii_lowercase().ends_with("info")
}

/// Whether the place of a finding is a number. If there is none, it is the header or the key.
fn has_value(description: &Description, finding: &Diagnostic) -> bool {
    let is_number = shown(description, finding).starts_with(|first: char| first.is_ascii_digit());
    is_number && !is_at_header(description, finding)
}

/// Whether a count exceeds the one that the fix writes. Missing and non-numeric counts do not.
fn has_fewer(description: &Description, finding: &Diagnostic) -> bool {
    let stated: Option<u64> = shown(description, finding).parse().ok();
    let written = finding.fix.iter().flat_map(|fix| &fix.changes).find_map(|change| match change {
        Change::Replace(_, text) | Change::Set(_, text) => text.parse().ok(),
        _ => None,
    });
    // without a fix, sections are lost
    stated.is_some_and(|stated| written.is_none_or(|written| stated > written))
}
