//! Steps that need every format: patches, baselines, and conversions of the description.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Conversion, DescribedDevice, Error, Generation, Request};
use objdict_format::input::{FileKind, Reading};
use objdict_format::patch::{Patch, Patched};
use objdict_format::{Description, Format, LossKind, ReadError, WriteOptions, convert};
use objdict_model::diagnostic::Findings;
use objdict_model::model::{Device, DeviceKind};
use objdict_model::source::read_text;
use objdict_project::baseline::{self, Baseline};
use objdict_project::config::Project;

impl Request {
    /// Options for reading the description, with the patches of arguments and configuration.
    pub(super) fn with_patches(
        &self,
        mut reading: Reading,
        project: Option<&Project>,
        files: &mut Vec<PathBuf>,
    ) -> Result<Reading, Error> {
        for path in &self.patches {
            files.push(path.clone());
            let patch = Patch::open(path).map_err(ReadError::from)?;
            reading.patches.push(Arc::new(patch));
        }
        if let Some(project) = project {
            reading.patches.extend(project.patches.iter().cloned());
        }
        Ok(reading)
    }

    /// The findings that are not in the baseline.
    pub(super) fn unknown(
        &self,
        description: &Description,
        mut findings: Findings,
        files: &mut Vec<PathBuf>,
    ) -> Result<Findings, Error> {
        if let Some(path) = &self.baseline {
            files.push(path.clone());
            let text = read_text(path, baseline::MAX_SIZE)?;
            let baseline =
                Baseline::read(&text).map_err(|error| Error::Baseline { path: path.clone(), error })?;
            baseline.suppress_beside(path, description, &mut findings);
        }
        Ok(findings)
    }

    /// The generated files, with the description in other formats.
    pub(super) fn with_conversions(
        &self,
        generation: Generation,
        device: &Device,
    ) -> Result<Generation, Error> {
        let conversions = self.conversions.iter().map(|path| conversion(device, path));
        Ok(Generation { conversions: conversions.collect::<Result<_, _>>()?, ..generation })
    }
}

impl DescribedDevice {
    /// The warnings about the configuration and about patches.
    pub(super) fn with_lines_of_patches(&self, mut lines: Vec<String>) -> Vec<String> {
        if let Self::Text(description) = self {
            lines.extend(description.patched().map(Patched::lines).unwrap_or_default());
        }
        lines
    }
}

/// The device converted as `objdict convert` does.
fn conversion(device: &Device, path: &Path) -> Result<Conversion, Error> {
    let format = format_of(device, path).ok_or_else(|| Error::NoFormat { path: path.to_owned() })?;
    let options = WriteOptions { embed: true, ..WriteOptions::default() };
    let written = convert(device.clone(), path, format, false, &options)
        .map_err(|error| Error::Conversion { path: path.to_owned(), error })?;
    let lost = written.losses.iter().filter(|loss| loss.kind == LossKind::Lost).map(ToString::to_string);
    Ok(Conversion { path: path.to_owned(), lost: lost.collect(), bytes: written.bytes })
}

/// The format for the extension of a file; `None` if it cannot describe the device.
fn format_of(device: &Device, path: &Path) -> Option<Format> {
    let kind = FileKind::of(path)?;
    let format = kind.format().filter(|format| FileKind::from(*format) == kind)?;
    (format.kind() == DeviceKind::Type || device.kind == DeviceKind::Node).then_some(format)
}
