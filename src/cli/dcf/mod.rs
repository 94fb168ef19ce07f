//! `objdict dcf`: concise DCF made, taken apart, compared and proved.

mod diff;
mod pack;
mod unpack;
mod verify;

use std::io::Write;
use std::path::Path;

pub(super) use self::diff::differences;
use super::annotation::Described;
use super::args::{DcfCommand, ExpandArgs, NamingArgs};
use super::input::{Input, InputArgs, name_of};
use super::output::Output;
use super::save::{is_stdout, save};
use super::{Failure, Outcome};
use crate::download::ConciseDcf;
use crate::format::concise;
use crate::format::input::{FileKind, Reading};
use crate::model::Device;
use crate::report::plural;

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
    stream_of(&name_of(path), input.size.read(path)?, input, node_id)
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
    // what is not recognised as something else is a stream, and its errors are worth a report
    let reading = Reading { node_id, ..input.reading() };
    let kind = match reading.recognised(name, bytes.clone()) {
        Ok((kind @ (FileKind::CdcfText | FileKind::Json | FileKind::Cdcf), _)) => kind,
        _ => FileKind::Cdcf,
    };
    match (Reading { from: Some(kind), ..reading }).read(name, bytes)? {
        (_, Input::Concise(configuration)) => Ok(configuration),
        _ => Err(Failure::new(format_args!("`{name}` is no concise DCF"))),
    }
}

/// The device of a description.
fn device(path: &Path, input: &InputArgs, expand: &ExpandArgs) -> Result<Device, Failure> {
    // `--from` is about the stream
    let reading = Reading { from: None, ..input.reading() };
    let name = name_of(path);
    let device = match reading.read_one(&name, input.size.read(path)?)? {
        (_, Input::Description(description)) => description.device().clone(),
        (_, Input::Device(device)) => *device,
        (kind, _) => {
            return Err(Failure::new(format_args!(
                "`{name}` is a {}, which describes no device",
                kind.name()
            ))
            .help("name the EDS of the node"));
        }
    };
    Ok(expand.device(&device).into_owned())
}

impl NamingArgs {
    fn device(&self) -> Result<Option<Device>, Failure> {
        self.eds.as_ref().map(|path| device(path, &self.input, &self.expand)).transpose()
    }

    fn described<'a>(&self, device: Option<&'a Device>) -> Described<'a> {
        let node_id = self.node_id.or_else(|| device?.node_id());
        Described { device, node_id }
    }
}

/// Writes to a file and says so, or to the standard output.
fn deliver(path: Option<&Path>, bytes: &[u8], what: &str, out: &mut Output) -> Result<(), Failure> {
    match path.filter(|path| !is_stdout(path)) {
        Some(path) => {
            save(path, bytes)?;
            writeln!(out, "{}: {what}", path.display())?;
        }
        None => out.write_all(bytes)?,
    }
    Ok(())
}

/// How many downloads there are.
fn count(configuration: &ConciseDcf) -> String {
    plural(configuration.0.len(), "download")
}
