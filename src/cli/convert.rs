//! `objdict convert`.

use std::fs;
use std::io::Write;
use std::path::Path;

use super::args::ConvertArgs;
use super::input::{FileKind, Input, name_of};
use super::output::Output;
use super::save::{Saved, save};
use super::{Failure, Outcome, tell};
use crate::download::{Configuration, NeededFile, Plan, PlanError, PlanOptions, Scope, plan};
use crate::format::{self, Description, Format, concise, json};
use crate::model::{Commissioning, Device, DeviceKind};

pub(super) fn run(args: &ConvertArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let to = target(args)?;
    let is_stdout = args.out == Path::new("-");
    if !is_stdout && is_same_file(&args.file, &args.out) {
        let failure = Failure::new(format_args!("`{}` would overwrite itself", args.file.display()));
        return Err(failure.help("name another file for the output"));
    }
    let (from, input) = args.input.read(&args.file)?;
    let bytes = convert(args, from, input, to)?;
    if is_stdout {
        out.write_all(&bytes)?;
        return Ok(Outcome::Clean);
    }
    let note = match save(&args.out, &bytes)? {
        Saved::Written => "",
        Saved::Unchanged => ", unchanged",
    };
    let (file, written, size) = (name_of(&args.file), args.out.display(), bytes.len());
    writeln!(out, "{file} ({}) to {written} ({}), {size} bytes{note}", from.name(), to.name())?;
    Ok(Outcome::Clean)
}

/// What the output shall be: what the user says, else what its name says.
fn target(args: &ConvertArgs) -> Result<FileKind, Failure> {
    let to = args.to.map(FileKind::from).or_else(|| FileKind::of(&args.out));
    let known = "`.eds`, `.dcf`, `.json` and `.cdcf` (concise DCF) are known";
    match to {
        Some(FileKind::Cpj) => Err(Failure::new("node lists are not written").help(known)),
        Some(to) => Ok(to),
        None => {
            let message = format!("the name `{}` does not say which format to write", args.out.display());
            Err(Failure::new(message).help(format!("{known}; or say it with `--to`")))
        }
    }
}

fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

fn convert(args: &ConvertArgs, from: FileKind, input: Input, to: FileKind) -> Result<Vec<u8>, Failure> {
    match input {
        Input::Description(description) => convert_description(args, &description, from, to),
        Input::Device(device) => convert_device(args, &device, to),
        Input::Configuration(configuration) => match to {
            FileKind::Json => Ok(json::write_configuration(&configuration).into_bytes()),
            FileKind::Cdcf => concise::write(&configuration).map_err(Failure::new),
            _ => Err(Failure::new(format_args!(
                "a concise DCF holds values and no description, so no {} can be made of it",
                to.name()
            ))
            .help("it can become `.json`")),
        },
        Input::NodeList(_) => Err(Failure::new("a node list holds no device")
            .help(format!("`objdict show {}` names the files of its nodes", args.file.display()))),
    }
}

fn convert_description(
    args: &ConvertArgs,
    description: &Description,
    from: FileKind,
    to: FileKind,
) -> Result<Vec<u8>, Failure> {
    if args.canonical.is_asked() || args.expand.implicit_pdos {
        return convert_device(args, description.device(), to);
    }
    let file_name = base_name(&args.out);
    match (from, to) {
        (FileKind::Eds, FileKind::Eds) => Ok(description.source().to_bytes()),
        (FileKind::Dcf, FileKind::Dcf) if !args.changes_node() => Ok(description.source().to_bytes()),
        (_, FileKind::Dcf) => {
            let node = node(args, description.device())?;
            description.to_node(&file_name, &node).map_err(Failure::new)
        }
        (_, FileKind::Eds) => description.to_type(&file_name).map_err(Failure::new),
        _ => convert_device(args, description.device(), to),
    }
}

fn convert_device(args: &ConvertArgs, device: &Device, to: FileKind) -> Result<Vec<u8>, Failure> {
    let device = args.expand.device(device);
    match to {
        FileKind::Json => Ok(json::write_device(&device).into_bytes()),
        FileKind::Cdcf => {
            let configuration = configuration(args, &device)?;
            concise::write(&configuration).map_err(Failure::new)
        }
        FileKind::Eds => Ok(canonical(args, device.into_owned(), Format::Eds)),
        FileKind::Dcf => {
            let mut node_device = device.into_owned();
            node_device.commissioning = Some(node(args, &node_device)?);
            node_device.kind = DeviceKind::Node;
            Ok(canonical(args, node_device, Format::Dcf))
        }
        FileKind::Cpj => Err(Failure::new("node lists are not written")),
    }
}

/// A new text, written from the model alone.
fn canonical(args: &ConvertArgs, mut device: Device, format: Format) -> Vec<u8> {
    if let Some(info) = &mut device.file_info {
        info.file_name = Some(base_name(&args.out));
    }
    let written = format::write(&device, format, &args.canonical.options(args.input.encoding));
    for loss in &written.losses {
        print_note(&loss.to_string());
    }
    written.bytes
}

fn base_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The node of the output: that of the device, with what the arguments change.
fn node(args: &ConvertArgs, device: &Device) -> Result<Commissioning, Failure> {
    let mut node = device.commissioning.clone().unwrap_or_default();
    node.node_id = args.node_id.or(node.node_id);
    node.baud_rate = args.bit_rate.or(node.baud_rate);
    if let Some(name) = &args.node_name {
        node.node_name = Some(name.clone());
    }
    if node.node_id.is_none() {
        return Err(Failure::new("a DCF is for one node, and nothing says which one")
            .help("say its node-ID with `--node-id`"));
    }
    if node.baud_rate.is_none() {
        let rate = usual_bit_rate(device);
        node.baud_rate = Some(rate);
        print_note(&format!("the DCF states {rate} kbit/s; say another bit rate with `--bit-rate`"));
    }
    Ok(node)
}

/// A bit rate that the device has, the most usual one first.
fn usual_bit_rate(device: &Device) -> u16 {
    let rates = device.device_info.as_ref().map(|info| info.baud_rates).unwrap_or_default();
    let usual = [250, 125, 500, 1000, 50, 20, 800, 10];
    usual.into_iter().find(|&rate| rates.get(rate) == Some(true)).unwrap_or(250)
}

/// What a node must be told so that it is configured as the device says.
fn configuration(args: &ConvertArgs, device: &Device) -> Result<Configuration, Failure> {
    let scope = if args.all { Scope::All } else { Scope::Changed };
    let options = PlanOptions { node_id: args.node_id, scope, ..PlanOptions::default() };
    let plan = plan(device, &options).map_err(|error| refusal(&error))?;
    print_skipped(&plan);
    let folder = args.file.parent().unwrap_or(Path::new(""));
    plan.into_configuration(|file| read_data(folder, file))
}

fn refusal(error: &PlanError) -> Failure {
    let failure = Failure::new(error);
    match error.help() {
        Some(help) => failure.help(help),
        None => failure,
    }
}

/// The data of a DOMAIN, from the file that the description names; seen from the folder of the description.
fn read_data(folder: &Path, file: &NeededFile) -> Result<Vec<u8>, Failure> {
    let path = folder.join(file.name.as_ref());
    fs::read(&path).map_err(|error| {
        let entry = format!("0x{:04X}sub{:X}", file.index, file.sub);
        Failure::new(format_args!("cannot read `{}`, the data of {entry}: {error}", path.display()))
    })
}

fn print_skipped(plan: &Plan) {
    for skipped in &plan.skipped {
        print_note(&format!("{}: not part of the stream: {}", skipped.place, skipped.reason));
    }
    if plan.steps.is_empty() {
        print_note(
            "nothing is configured to another value than its default: the stream is empty; write all values with `--all`",
        );
    }
}

fn print_note(text: &str) {
    tell(&format!("note: {text}\n"));
}
