//! Descriptions that are written beside what is generated.

use std::path::{Path, PathBuf};

use super::Error;
use objdict_format as format;
use objdict_format::input::FileKind;
use objdict_format::{Format, LossKind, WriteOptions};
use objdict_model::model::{Device, DeviceKind};

/// The description as a file of another format, before it is written.
#[derive(Debug)]
pub struct Conversion {
    pub path: PathBuf,
    pub bytes: Vec<u8>,
    /// What it does not have of the device, a line each.
    pub lost: Vec<String>,
}

impl Conversion {
    /// What `objdict convert` makes of the device for a file.
    pub(super) fn of(device: &Device, path: &Path) -> Result<Self, Error> {
        let format = format_of(device, path).ok_or_else(|| Error::NoFormat { path: path.to_owned() })?;
        let options = WriteOptions { embed: true, ..WriteOptions::default() };
        let written = format::convert(device.clone(), path, format, false, &options)
            .map_err(|error| Error::Conversion { path: path.to_owned(), error })?;
        let lost = written.losses.iter().filter(|loss| loss.kind == LossKind::Lost).map(ToString::to_string);
        Ok(Self { path: path.to_owned(), lost: lost.collect(), bytes: written.bytes })
    }
}

/// The format that the name of a file says, where a description of the device can have it.
fn format_of(device: &Device, path: &Path) -> Option<Format> {
    let kind = FileKind::of(path)?;
    let format = kind.format().filter(|format| FileKind::from(*format) == kind)?;
    (format.kind() == DeviceKind::Type || device.kind == DeviceKind::Node).then_some(format)
}
