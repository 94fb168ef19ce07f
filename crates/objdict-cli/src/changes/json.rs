//! Changes as one JSON document; docs/reference/json.md describes it.

use std::collections::BTreeMap;
use std::io;

use serde::Serialize;

use super::{ComparedDescriptions, ComparedSide};
use crate::stdout::Output;
use objdict_lint::changes::{ChangeImpact, ChangeVerdict, DeviceChange};
use objdict_model::json::Version;
use objdict_model::model::{Device, HexText, Place};

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct ChangesJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The old description.
    old: DescriptionFacts<'a>,
    /// The new description.
    new: DescriptionFacts<'a>,
    /// The worst verdict; absent without changes.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "Option<VerdictName>"))]
    verdict: Option<&'static str>,
    /// The changes in dictionary order; changes of the device as a whole come last.
    changes: Vec<ChangeJson<'a>>,
    /// The number of changes.
    summary: ChangeCounts,
}

/// A description, and the versions that it states.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct DescriptionFacts<'a> {
    /// The file as it was given; `<stdin>` for the standard input.
    file: &'a str,
    /// The format that it was read as.
    format: &'static str,
    /// 1018h sub-index 3.
    #[serde(skip_serializing_if = "Option::is_none")]
    revision_number: Option<u32>,
    /// `FileVersion`.
    #[serde(skip_serializing_if = "Option::is_none")]
    file_version: Option<u8>,
    /// `FileRevision`.
    #[serde(skip_serializing_if = "Option::is_none")]
    file_revision: Option<u8>,
}

/// A change.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Change"))]
struct ChangeJson<'a> {
    /// The id of the rule; `objdict explain` prints its page.
    rule: &'static str,
    /// The worst of its verdicts.
    #[cfg_attr(feature = "schema", schemars(with = "VerdictName"))]
    verdict: &'static str,
    /// The index of the object, in the old description if it has it; absent for the device as a whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    index: Option<HexText<u16>>,
    /// The sub-index of the entry; absent for an object or PDO as a whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    sub: Option<HexText<u8>>,
    /// What was, in short; absent for nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    old: Option<&'a str>,
    /// What is, in short; absent for nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    new: Option<&'a str>,
    /// The change as a sentence; quoted values are cut to 80 characters and `…`.
    message: String,
    /// What it means for each audience that it affects: `configurations`, `pdo-consumers`, `sdo-clients`, `firmware`, `stored-values`.
    verdicts: BTreeMap<&'static str, EffectRow>,
    /// Where it is in the old description; absent for what is not in a text.
    #[serde(skip_serializing_if = "Option::is_none")]
    old_place: Option<ChangePlace<'a>>,
    /// Where it is in the new description; absent for what is not in a text.
    #[serde(skip_serializing_if = "Option::is_none")]
    new_place: Option<ChangePlace<'a>>,
}

/// What a change means for an audience.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Effect"))]
struct EffectRow {
    /// The verdict.
    #[cfg_attr(feature = "schema", schemars(with = "VerdictName"))]
    verdict: &'static str,
    /// Why.
    reason: &'static str,
    /// The documents that it follows from.
    source: &'static str,
}

/// A place in a file.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct ChangePlace<'a> {
    /// The file as it was given.
    file: &'a str,
    /// The line, counted from 1.
    line: u32,
    /// The column, counted from 1 in Unicode scalar values.
    column: u32,
    /// The address in the object dictionary, such as `0x1018sub1 / DefaultValue`.
    place: String,
}

/// The number of changes by verdict.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "ChangeCounts"))]
struct ChangeCounts {
    /// The number of breaking changes.
    breaking: usize,
    /// The number of risky changes.
    risky: usize,
    /// The number of compatible changes.
    compatible: usize,
}

/// A verdict, in the schema.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[schemars(rename = "Verdict", rename_all = "lowercase")]
#[allow(dead_code, reason = "its schema is all that is made of it")]
enum VerdictName {
    /// What worked still works.
    Compatible,
    /// Something may work differently and must be looked at.
    Risky,
    /// Something that worked does not work any more.
    Breaking,
}

pub(super) fn write(comparison: &ComparedDescriptions, out: &mut Output) -> io::Result<()> {
    let document = ChangesJson {
        version: Version,
        old: facts(&comparison.old),
        new: facts(&comparison.new),
        verdict: comparison.verdict().map(ChangeVerdict::name),
        changes: comparison.changes.iter().map(|change| row(comparison, change)).collect(),
        summary: ChangeCounts {
            breaking: comparison.count(ChangeVerdict::Breaking),
            risky: comparison.count(ChangeVerdict::Risky),
            compatible: comparison.count(ChangeVerdict::Compatible),
        },
    };
    out.pretty_json(&document)
}

fn facts(side: &ComparedSide) -> DescriptionFacts<'_> {
    let device = side.device().ok();
    let info = device.and_then(|device| device.file_info.as_ref());
    DescriptionFacts {
        file: &side.file,
        format: side.format,
        revision_number: device.map(Device::identity).and_then(|identity| identity.revision_number),
        file_version: info.and_then(|info| info.file_version),
        file_revision: info.and_then(|info| info.file_revision),
    }
}

fn row<'a>(comparison: &'a ComparedDescriptions, change: &'a DeviceChange) -> ChangeJson<'a> {
    let source = change.rule.info.source;
    let effect = |effect: &ChangeImpact| {
        let ChangeImpact { audience, verdict, reason } = *effect;
        (audience.name(), EffectRow { verdict: verdict.name(), reason, source })
    };
    ChangeJson {
        rule: change.rule.info.id,
        verdict: change.verdict().name(),
        index: change.index.map(HexText),
        sub: change.sub.map(HexText),
        old: change.old.as_deref(),
        new: change.new.as_deref(),
        message: change.message.to_string(),
        verdicts: change.effects().map(effect).collect(),
        old_place: change.old_place.as_ref().and_then(|place| at(&comparison.old, place)),
        new_place: change.new_place.as_ref().and_then(|place| at(&comparison.new, place)),
    }
}

fn at<'a>(side: &'a ComparedSide, place: &Place) -> Option<ChangePlace<'a>> {
    let at = side.locate(place)?;
    Some(ChangePlace { file: &side.file, line: at.line, column: at.column, place: place.to_string() })
}
