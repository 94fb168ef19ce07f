//! Converts a device to a file of a different format, for `objdict convert` and build scripts.

use std::mem;
use std::path::Path;

use objdict_eds::eds;
use objdict_model::diagnostic::Diagnostic;
use objdict_model::source::Span;
#[cfg(feature = "xdd")]
use objdict_xdd::xml;

use super::description::stated_name;
use super::{Description, EditError, Format, Loss, LossKind, Syntax, WriteOptions, Written, write};
use objdict_model::model::{Device, Objects, Place};

/// Writes a device as the text of a file with this name. An EDS or DCF omits disabled objects, unless they
/// are kept.
///
/// # Errors
/// See [`write()`](super::write()).
pub fn convert(
    mut device: Device,
    file: &Path,
    format: Format,
    keep_disabled: bool,
    options: &WriteOptions,
) -> Result<Written, EditError> {
    // a source keeps the name of the description that it is for
    if let Some(info) = device.file_info.as_mut().filter(|_| format != Format::Toml) {
        let name = file.file_name().unwrap_or_default();
        info.file_name = Some(stated_name(&name.to_string_lossy()));
    }
    let mut losses = Vec::new();
    if format.syntax() == Syntax::Ini && !keep_disabled {
        losses = remove_disabled(&mut device);
    }
    let mut written = write(&device, format, options)?;
    losses.append(&mut written.losses);
    Ok(Written { losses, ..written })
}

/// The text of a description that its device does not contain, and which a new text therefore lacks: comments, repeated
/// sections and keys, and invalid lines. Repetitions with the same value are excluded.
pub fn unread(description: &Description) -> Vec<Loss> {
    let is_unread = |finding: &&Diagnostic| match finding.rule.id {
        "cia306/duplicate-section" => finding.fix.is_some() && !finding.is_understood,
        "cia306/duplicate-key" => !finding.is_understood,
        "cia306/junk-line" => true,
        _ => false,
    };
    let source = description.source();
    let loss = |kind, span: Span, reason| Loss {
        place: Place::device(),
        path: String::new(),
        kind,
        value: serde_json::Value::from(span.of(source.text())).into(),
        becomes: None,
        reason: Some(reason),
    };
    let of_finding = |finding: &Diagnostic| {
        let span = finding.labels.first().map(|label| description.span_of(&label.at)).unwrap_or_default();
        let line = source.line_column(span.start).line;
        loss(LossKind::Lost, span, format!("line {line}: {}", finding.message))
    };
    let of_comment = |span| loss(LossKind::LeftOut, span, "comments are not part of the device".to_owned());
    match description.document() {
        Some(document) => {
            let of_lines = description.text_findings();
            let unread = of_lines.iter().chain(description.findings()).filter(is_unread).map(of_finding);
            unread.chain(eds::comments(document).map(of_comment)).collect()
        }
        #[cfg(feature = "xdd")]
        None if description.tree().is_some() => xml::comments(source.text()).map(of_comment).collect(),
        None => Vec::new(),
    }
}

/// Whether an EDS or DCF states units, factors or descriptions of values in the keys of python-canopen.
pub fn has_meaning_keys(description: &Description) -> bool {
    let text = description.source().text();
    let is_meaning_key = |finding: &Diagnostic| {
        let name = finding.labels.first().map(|label| description.span_of(&label.at).of(text));
        finding.rule.id == "cia306/unknown-key" && name.is_some_and(eds::is_meaning_key)
    };
    description.document().is_some() && description.findings().iter().any(is_meaning_key)
}

/// Removes disabled objects: an EDS cannot express that, and other tools would treat them as objects of the device.
fn remove_disabled(device: &mut Device) -> Vec<Loss> {
    let (disabled, objects): (Objects, Objects) =
        mem::take(&mut device.objects).into_iter().partition(|(_, object)| object.is_disabled());
    device.objects = objects;
    let loss = |(index, object)| Loss {
        place: Place::object(index),
        path: format!("/objects/0x{index:04X}"),
        kind: LossKind::Lost,
        value: serde_json::to_value(object).unwrap_or_default().into(),
        becomes: None,
        reason: Some("the object is disabled; `--keep-disabled` keeps it".to_owned()),
    };
    let lists = &mut device.lists;
    for list in [&mut lists.mandatory, &mut lists.optional, &mut lists.manufacturer].into_iter().flatten() {
        list.retain(|index| !disabled.contains_key(index));
    }
    disabled.into_iter().map(loss).collect()
}
