//! A device as a file of another format, as `objdict convert` and build scripts write it.

use std::mem;
use std::path::Path;

use super::description::stated_name;
use super::{EditError, Format, Loss, LossKind, Syntax, WriteOptions, Written, write};
use objdict_model::model::{Device, Objects, Place};

/// The text of a device for a file, whose name it states. An EDS or DCF does not have the objects that are
/// disabled, unless they are kept.
///
/// # Errors
/// As [`write()`](super::write()).
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

/// Removes the objects that the device does not have: an EDS cannot say so, and every other tool would take them for
/// objects of the device.
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
    let losses: Vec<Loss> = disabled.into_iter().map(loss).collect();
    let lists = &mut device.lists;
    for list in [&mut lists.mandatory, &mut lists.optional, &mut lists.manufacturer].into_iter().flatten() {
        list.retain(|index| device.objects.contains_key(index));
    }
    losses
}
