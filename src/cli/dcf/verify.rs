//! `objdict dcf verify`.

use std::io::{self, Write};

use serde::Serialize;

use super::super::annotation::Described;
use super::super::args::{VerdictFormat, VerifyArgs};
use super::super::input::{name_of, source_name};
use super::super::output::Output;
use super::super::{Failure, Outcome};
use super::{count, device, stream};
use crate::download::{Objection, Verification};
use crate::json;

/// The version of the JSON document, see docs/json.md.
const VERSION: u32 = 1;

pub(super) fn run(args: &VerifyArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let device = device(&args.eds, &args.input, &args.expand)?;
    let node_id = args.node_id.or_else(|| device.node_id());
    let configuration = stream(&args.blob, &args.input, node_id)?;
    let verification = configuration.verify(&device, node_id);
    match args.format {
        VerdictFormat::Text => {
            let refused = verification.refusals().count();
            let verdict = if refused == 0 { "none refused".to_owned() } else { format!("{refused} refused") };
            let described = Described { device: Some(&device), node_id };
            writeln!(out, "{}: {}, {verdict}", name_of(&args.blob), count(&configuration))?;
            out.write_all(text(&verification, described).as_bytes())?;
        }
        VerdictFormat::Json => write_json(&source_name(&args.blob), &verification, out)?,
    }
    Ok(if verification.is_accepted() { Outcome::Clean } else { Outcome::Findings })
}

/// What is said of the downloads, the first one that is refused first; what is said of several of them once.
pub(super) fn text(verification: &Verification, described: Described<'_>) -> String {
    let mut text = String::new();
    let first = verification.refusals().next();
    let others = verification.objections.iter().filter(|&objection| Some(objection) != first);
    let mut groups: Vec<(String, Vec<&Objection>)> = Vec::new();
    for objection in first.into_iter().chain(others) {
        let message = objection.kind.to_string();
        match groups.iter_mut().find(|(other, _)| *other == message) {
            Some((_, group)) => group.push(objection),
            None => groups.push((message, vec![objection])),
        }
    }
    for (_, group) in &groups {
        text.push_str(&one(group, described));
    }
    if !verification.unknown.is_empty() {
        let places: Vec<String> = verification.unknown.iter().map(|place| format!("`{place}`")).collect();
        let entries = if places.len() == 1 { "an entry" } else { "entries" };
        text.push_str(&format!(
            "note: without the node-ID the present value of {entries} is not known: {}\n  help: say it with `--node-id`\n",
            places.join(", ")
        ));
    }
    text
}

/// What is said of the first download of a group and also of the others.
fn one(group: &[&Objection], described: Described<'_>) -> String {
    let Some((objection, others)) = group.split_first() else { return String::new() };
    let kind = &objection.kind;
    let severity = if kind.is_refusal() { "error" } else { "warning" };
    let mut text = format!(
        "{severity}: at byte {}, download {}, `{}`: {kind}\n",
        objection.offset, objection.number, objection.place
    );
    let name = described.name_of(objection.index, objection.sub);
    if !name.is_empty() {
        text.push_str(&format!("  entry: {name}\n"));
    }
    if !others.is_empty() {
        let places: Vec<String> =
            others.iter().map(|other| format!("{} (`{}`)", other.number, other.place)).collect();
        let downloads = if places.len() == 1 { "download" } else { "downloads" };
        text.push_str(&format!("  also: {downloads} {}\n", places.join(", ")));
    }
    if let Some(abort) = kind.abort() {
        text.push_str(&format!("  abort: {abort}, {}\n", abort.text()));
    }
    if let Some(help) = kind.help() {
        text.push_str(&format!("  help: {help}\n"));
    }
    text
}

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    file: &'a str,
    accepted: bool,
    objections: Vec<Row>,
    unknown: Vec<String>,
}

#[derive(Serialize)]
struct Row {
    offset: usize,
    download: usize,
    index: String,
    sub: String,
    refused: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    abort: Option<String>,
    message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<String>,
}

fn write_json(file: &str, verification: &Verification, out: &mut Output) -> io::Result<()> {
    let row = |objection: &Objection| Row {
        offset: objection.offset,
        download: objection.number,
        index: format!("0x{:04X}", objection.index),
        sub: format!("0x{:02X}", objection.sub),
        refused: objection.kind.is_refusal(),
        abort: objection.kind.abort().map(|abort| format!("0x{:08X}", abort.0)),
        message: objection.kind.to_string(),
        help: objection.kind.help(),
    };
    let document = Document {
        version: VERSION,
        file,
        accepted: verification.is_accepted(),
        objections: verification.objections.iter().map(row).collect(),
        unknown: verification.unknown.iter().map(ToString::to_string).collect(),
    };
    json::write_pretty(&mut out.raw()?, &document)?;
    writeln!(out)
}
