//! Which files become which.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::super::args::ConvertArgs;
use super::super::ending::Failure;
use super::super::input::{FileKind, extensions, name_of};
use super::super::written_files::{is_folder, is_stdout};
use objdict_format::patch::Patch;

/// A file to convert.
#[derive(Clone)]
pub(super) struct Job {
    pub input: PathBuf,
    pub output: PathBuf,
    pub to: FileKind,
    /// Whether its name in a folder was made from that of the input.
    pub is_named: bool,
    /// The patches of its configuration.
    pub patches: Vec<Arc<Patch>>,
}

impl Job {
    /// The same for one of several devices in the input, counted from 0: `line-2.eds`.
    pub(super) fn of_device(&self, number: usize) -> Self {
        let stem = self.output.file_stem().unwrap_or_default().to_string_lossy();
        let name = format!("{stem}-{}.{}", number + 1, self.to.ending());
        Self { output: self.output.with_file_name(name), ..self.clone() }
    }
}

/// The endings of the formats that are written, for the help of an error.
fn known_endings() -> String {
    format!("use {}", extensions(FileKind::written()))
}

/// What the arguments ask for: one file or several of one file, a folder for all files, or one DBC of all of them.
pub(super) fn plan(args: &ConvertArgs) -> Result<Vec<Job>, Failure> {
    let inputs = args.files.as_slice();
    match (args.output.as_slice(), args.to) {
        ([], Some(_)) => plan_output(inputs, Path::new("-"), args.to),
        ([], None) => Err(no_output(inputs)),
        ([output], to) => plan_output(inputs, output, to),
        (outputs, to) => {
            if inputs.len() > 1 || outputs.iter().any(|output| is_folder(output)) {
                let failure = Failure::new("several outputs require a single input and must not be folders");
                return Err(failure.help("name one folder for several files, with `--to`"));
            }
            for (number, output) in outputs.iter().enumerate() {
                if outputs[..number].contains(output) {
                    let message = format!("the output `{}` is named twice", name_of(output));
                    return Err(Failure::new(message).help("name each output once"));
                }
            }
            let plans = outputs.iter().map(|output| plan_output(inputs, output, to));
            Ok(plans.collect::<Result<Vec<_>, _>>()?.concat())
        }
    }
}

/// What one output asks for.
fn plan_output(inputs: &[PathBuf], output: &Path, stated: Option<FileKind>) -> Result<Vec<Job>, Failure> {
    let named = FileKind::of(output);
    let job = |input: &PathBuf, to| Job {
        input: input.clone(),
        output: output.to_owned(),
        to,
        is_named: false,
        patches: Vec::new(),
    };
    match inputs {
        inputs if !is_folder(output) && stated.or(named) == Some(FileKind::Dbc) => {
            Ok(inputs.iter().map(|input| job(input, FileKind::Dbc)).collect())
        }
        [input] if !is_folder(output) => {
            let to = stated.or(named).ok_or_else(|| {
                let message = format!("`{}` has no extension of a known format", name_of(output));
                Failure::new(message).help(format!("{}, or name the format with `--to`", known_endings()))
            })?;
            if FileKind::written().all(|kind| kind != to) {
                return Err(Failure::new(format_args!("cannot write {}", to.name())).help(known_endings()));
            }
            Ok(vec![job(input, to)])
        }
        inputs if is_stdout(output) => {
            let message = format!("{} files cannot go to the standard output", inputs.len());
            Err(Failure::new(message).help("name a folder with `--output`"))
        }
        inputs => {
            let Some(to) = stated else {
                let message = format!("missing format for the folder `{}`", name_of(output));
                return Err(Failure::new(message).help("name it with `--to`"));
            };
            into_folder(inputs, output, to)
        }
    }
}

fn no_output(inputs: &[PathBuf]) -> Failure {
    let failure = Failure::new("missing output");
    match inputs {
        [_] => failure.help("name the file to write with `--output`"),
        // as `cp` and former versions of objdict take them
        _ => failure.help("all of these files are inputs; name the file or folder to write with `--output`"),
    }
}

fn into_folder(inputs: &[PathBuf], folder: &Path, to: FileKind) -> Result<Vec<Job>, Failure> {
    // `A.eds` and `a.eds` are one file on many systems
    let mut made: BTreeMap<String, &Path> = BTreeMap::new();
    let mut jobs = Vec::new();
    for input in inputs {
        if input == Path::new("-") {
            return Err(Failure::new("the standard input has no file name to use in a folder")
                .help("name the file to write"));
        }
        let name = format!("{}.{}", stem(input), to.ending());
        let output = folder.join(&name);
        if let Some(other) = made.insert(name.to_lowercase(), input) {
            let message = format!(
                "`{}` and `{}` would both become `{}`",
                name_of(other),
                name_of(input),
                name_of(&output)
            );
            return Err(Failure::new(message).help("convert them into different folders"));
        }
        jobs.push(Job { input: input.clone(), output, to, is_named: true, patches: Vec::new() });
    }
    Ok(jobs)
}

/// The name of a file without its known endings: `drive` of `drive.eds.txt`.
fn stem(path: &Path) -> String {
    let mut stem = PathBuf::from(path.file_stem().unwrap_or_default());
    while stem.extension().is_some() && FileKind::of(&stem).is_some() {
        stem = PathBuf::from(stem.file_stem().unwrap_or_default());
    }
    stem.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lose_their_known_endings() {
        for (name, expected) in
            [("a/drive.eds", "drive"), ("drive.eds.txt", "drive"), ("v1.2.xdd", "v1.2"), ("drive", "drive")]
        {
            assert_eq!(stem(Path::new(name)), expected);
        }
    }

    #[test]
    fn two_files_of_one_name_are_an_error() {
        let inputs = [PathBuf::from("a/drive.eds"), PathBuf::from("b/drive.dcf")];
        let failure = into_folder(&inputs, Path::new("out"), FileKind::Json).err().unwrap();
        assert!(failure.message.contains("would both become"), "{}", failure.message);
        let inputs = [PathBuf::from("PLC.eds"), PathBuf::from("plc.dcf")];
        assert!(into_folder(&inputs, Path::new("out"), FileKind::Json).is_err(), "one file on Windows");
    }
}
