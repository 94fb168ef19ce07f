//! `objdict dcf`: concise DCF made, taken apart, compared and proved.

mod diff;
mod pack;
mod unpack;
mod verify;

use std::io::Write;
use std::path::Path;

pub(super) use self::diff::differences;
pub(super) use self::pack::{PackedContent, content};
#[cfg(feature = "schema")]
pub(super) use self::verify::VerifyJson as VerifyDocument;
use super::annotation::DescribedStream;
use super::args::{DcfCommand, NamingArgs};
use super::ending::{Failure, Outcome};
use super::input::{ExpandArgs, Input, InputArgs, name_of, source_name};
use super::settings::ConfigFileArgs;
use super::stdout::Output;
use super::written_files::{is_stdout, save};
use objdict_format::ReadError;
use objdict_format::identify::{ContentKind, Identification, identify};
use objdict_format::input::{FileKind, Reading};
use objdict_model::diagnostic::plural;
use objdict_model::model::Device;
use objdict_node::concise;
use objdict_node::download::ConciseDcf;

pub(super) fn run(command: &DcfCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        DcfCommand::Pack(args) => pack::run(args, out),
        DcfCommand::Unpack(args) => unpack::run(args, out),
        DcfCommand::Diff(args) => diff::run(args, out),
        DcfCommand::Verify(args) => verify::run(args, out),
    }
}

/// A stream in any of its spellings.
fn stream(path: &Path, input: &InputArgs, node_id: Option<u8>) -> Result<ConciseDcf, Failure> {
    stream_of(&source_name(path), input.size.read(path)?, input, node_id)
}

/// The bytes of a file that has only hex digits, when its format is not given.
fn hex_of(bytes: &[u8], input: &InputArgs) -> Option<Vec<u8>> {
    std::str::from_utf8(bytes).ok().filter(|_| input.from.is_none()).and_then(concise::of_hex)
}

/// A stream in any of its spellings, from the bytes of a file.
fn stream_of(
    name: &str,
    bytes: Vec<u8>,
    input: &InputArgs,
    node_id: Option<u8>,
) -> Result<ConciseDcf, Failure> {
    if let Some(stream) = hex_of(&bytes, input) {
        return ConciseDcf::parse(&stream)
            .map_err(|error| Failure::new(format_args!("`{name}`, hex digits: {error}")));
    }
    let reading = Reading { node_id, is_node: true, ..input.reading() };
    let resembles = input.from.is_some() || resembles_stream(&bytes);
    let kind = match reading.recognised(name, bytes.clone()) {
        Ok((FileKind::Cdcf, _)) if !resembles => return Err(unknown(name, &identify(name, &bytes))),
        Ok((kind, _)) => kind,
        // the errors of a stream are worth a report
        Err(ReadError::Foreign { found, .. }) if found.kind == ContentKind::Unknown && resembles => {
            FileKind::Cdcf
        }
        Err(ReadError::Foreign { found, .. }) => return Err(unknown(name, &found)),
        Err(error) => return Err(error.into()),
    };
    match (Reading { from: Some(kind), ..reading }).read(name, bytes)? {
        (_, Input::Concise(configuration)) => Ok(configuration),
        (_, Input::Description(_) | Input::Device(_)) => {
            let message = format!("`{name}` is read as {} and is not a concise DCF", kind.name());
            let help = "creates one from it; `objdict diff` compares two descriptions";
            Err(Failure::new(message).help(format!("`objdict dcf pack {name}` {help}")))
        }
        (_, Input::NodeList(_)) => {
            Err(Failure::new(format_args!("`{name}` is read as {} and is not a concise DCF", kind.name())))
        }
    }
}

/// A file that is not a concise DCF in any spelling, with what it is.
fn unknown(name: &str, found: &Identification) -> Failure {
    let help = match found.kind {
        ContentKind::Unknown => Some("read it as a stream nevertheless with `--from cdcf`"),
        _ => found.advice(),
    };
    Failure::new(format_args!("`{name}` {}", found.verdict())).maybe_help(help)
}

/// Whether bytes begin as a stream does: with a count that a node can have, and the index of an object.
fn resembles_stream(bytes: &[u8]) -> bool {
    const MAX_COUNT: u32 = 1 << 20;
    let count = bytes.first_chunk().map(|count| u32::from_le_bytes(*count));
    let index = bytes.get(4..).and_then(|rest| rest.first_chunk()).map(|index| u16::from_le_bytes(*index));
    count.is_some_and(|count| count <= MAX_COUNT) && index.is_none_or(|index| index >= 0x1000)
}

/// The device of a description.
fn device(path: &Path, input: &InputArgs, expand: &ExpandArgs) -> Result<Device, Failure> {
    // `--from` is about the stream
    let patches = ConfigFileArgs::default().patches_of(path)?;
    let reading = Reading { from: None, is_node: true, ..input.reading_with(&patches) };
    let name = source_name(path);
    let device = match reading.read_one(&name, input.size.read(path)?)? {
        (_, Input::Description(description)) => description.device().clone(),
        (_, Input::Device(device)) => *device,
        (kind, _) => {
            return Err(Failure::new(format_args!(
                "`{name}` is a {}, which does not describe a device",
                kind.name()
            ))
            .help("name the node's EDS"));
        }
    };
    Ok(expand.device(&device).into_owned())
}

impl NamingArgs {
    fn device(&self) -> Result<Option<Device>, Failure> {
        self.eds.as_ref().map(|path| device(path, &self.input, &self.expand)).transpose()
    }

    fn described<'a>(&self, device: Option<&'a Device>) -> DescribedStream<'a> {
        let node_id = self.node_id.or_else(|| device?.node_id());
        DescribedStream { device, node_id }
    }
}

/// Writes to a file and says so, or to the standard output.
fn deliver(path: Option<&Path>, bytes: &[u8], what: &str, out: &mut Output) -> Result<(), Failure> {
    match path.filter(|path| !is_stdout(path)) {
        Some(path) => {
            save(path, bytes)?;
            out.summary(format_args!("{}: {what}", name_of(path)))?;
        }
        None => out.raw()?.write_all(bytes)?,
    }
    Ok(())
}

/// How many downloads there are.
fn count(configuration: &ConciseDcf) -> String {
    plural(configuration.0.len(), "download")
}
