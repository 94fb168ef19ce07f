//! The two descriptions that are compared: files, or a file and what it was at a revision.

use std::path::Path;

use crate::args::SidesArgs;
use crate::ending::Failure;
use crate::git;
use crate::input::{FileKind, Input, InputArgs, name_of, source_name};
use crate::settings::ConfigFileArgs;
use objdict_format::Description;
use objdict_model::model::{Device, Place};
use objdict_model::source::LineColumn;

/// One of the descriptions.
pub(super) struct ComparedSide {
    /// The file as it was given; behind a revision, as git has it.
    pub(super) file: String,
    /// What it was read as.
    pub(super) format: &'static str,
    pub(super) input: Input,
}

/// The old and the new description.
pub(super) fn sides(
    args: &SidesArgs,
    input: &InputArgs,
    config: &ConfigFileArgs,
) -> Result<[ComparedSide; 2], Failure> {
    let new = args.newer();
    let read = |path: &Path| ComparedSide::new(source_name(path), input.read_one(path, config)?);
    let old = match &args.git {
        None => read(&args.old)?,
        Some(revision) => {
            let file = format!("{revision}:{}", source_name(new));
            let bytes = git::read(revision, new, input.size.max_size)?.ok_or_else(|| {
                let message = format!("git has no file `{}` at `{revision}`", name_of(new));
                let help = "name the file of that revision with OLD and NEW: `git show REV:PATH` prints it";
                Failure::new(message).help(help)
            })?;
            let read = input.reading_with(&config.patches_of(new)?).read_one(&file, bytes)?;
            ComparedSide::new(file, read)?
        }
    };
    Ok([old, read(new)?])
}

impl ComparedSide {
    fn new(file: String, (kind, input): (FileKind, Input)) -> Result<Self, Failure> {
        let side = Self { file, format: kind.name(), input };
        side.device()?;
        Ok(side)
    }

    pub(super) fn device(&self) -> Result<&Device, Failure> {
        match &self.input {
            Input::Description(description) => Ok(description.device()),
            Input::Device(device) => Ok(device),
            Input::Concise(_) | Input::NodeList(_) => {
                let message =
                    format!("`{}` is read as {} and does not describe a device", self.name(), self.format);
                let help = "`objdict dcf diff` compares concise DCF, `objdict network diff` networks";
                Err(Failure::new(message).help(help))
            }
        }
    }

    /// The file as it is printed.
    pub(super) fn name(&self) -> String {
        name_of(Path::new(&self.file))
    }

    pub(super) fn description(&self) -> Option<&Description> {
        match &self.input {
            Input::Description(description) => Some(description),
            _ => None,
        }
    }

    /// Line and column of a place: of its field, or if the text does not state that, of its part.
    pub(super) fn locate(&self, place: &Place) -> Option<LineColumn> {
        let description = self.description()?;
        let part = || description.locate(&Place::of(place.part.clone()));
        let span = description.locate(place).or_else(part)?;
        Some(description.source().line_column(span.start))
    }
}
