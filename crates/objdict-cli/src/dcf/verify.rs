//! `objdict dcf verify`.

use std::io::{self, Write};

use serde::Serialize;

use super::super::annotation::DescribedStream;
use super::super::args::{PlainFormat, VerifyArgs};
use super::super::ending::{Failure, Outcome};
use super::super::input::{name_of, source_name};
use super::super::stdout::Output;
use super::{count, device, stream};
use objdict_model::json::Version;
use objdict_model::model::HexText;
use objdict_node::download::{Objection, Verification};

pub(super) fn run(args: &VerifyArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let device = device(&args.eds, &args.input, &args.expand)?;
    let node_id = args.node_id.or_else(|| device.node_id());
    let configuration = stream(&args.blob, &args.input, node_id)?;
    let verification = configuration.verify(&device, node_id);
    match args.format {
        PlainFormat::Text => {
            let refused = verification.refusals().count();
            let verdict = if refused == 0 { "none refused".to_owned() } else { format!("{refused} refused") };
            let described = DescribedStream { device: Some(&device), node_id };
            writeln!(out, "{}: {}, {verdict}", name_of(&args.blob), count(&configuration))?;
            out.write_all(text(&verification, described).as_bytes())?;
        }
        PlainFormat::Json => write_json(&source_name(&args.blob), &verification, out)?,
    }
    Ok(if verification.is_accepted() { Outcome::Clean } else { Outcome::Findings })
}

/// What is said of the downloads, the first one that is refused first; what is said of several of them once.
pub(super) fn text(verification: &Verification, described: DescribedStream<'_>) -> String {
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
            "note: without the node-ID the present value of {entries} is unknown: {}\n  help: pass `--node-id`\n",
            places.join(", ")
        ));
    }
    text
}

/// What is said of the first download of a group and also of the others.
fn one(group: &[&Objection], described: DescribedStream<'_>) -> String {
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
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct VerifyJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The file with the downloads, as it was given.
    file: &'a str,
    /// Whether the node accepts all downloads.
    accepted: bool,
    /// The downloads that the node refuses, or that are hardly intended.
    objections: Vec<VerifyRow>,
    /// The entries whose present value depends on a missing node-ID.
    unknown: Vec<String>,
}

/// What is said of a download.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Objection"))]
struct VerifyRow {
    /// The offset of the download in the stream.
    offset: usize,
    /// Its number, counted from 1.
    download: usize,
    /// The index of the object.
    index: HexText<u16>,
    /// The sub-index of the entry.
    sub: HexText<u8>,
    /// Whether the node refuses it; `false` when nodes, or most of them, accept a write that is hardly intended.
    refused: bool,
    /// The abort code of CiA 301 that the node sends; absent for a write that only tools must not make.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(regex(pattern = "^0x[0-9A-F]{8}$")))]
    abort: Option<String>,
    /// The problem.
    message: String,
    /// The advice.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<String>,
}

fn write_json(file: &str, verification: &Verification, out: &mut Output) -> io::Result<()> {
    let row = |objection: &Objection| VerifyRow {
        offset: objection.offset,
        download: objection.number,
        index: HexText(objection.index),
        sub: HexText(objection.sub),
        refused: objection.kind.is_refusal(),
        abort: objection.kind.abort().map(|abort| format!("0x{:08X}", abort.0)),
        message: objection.kind.to_string(),
        help: objection.kind.help(),
    };
    let document = VerifyJson {
        version: Version,
        file,
        accepted: verification.is_accepted(),
        objections: verification.objections.iter().map(row).collect(),
        unknown: verification.unknown.iter().map(ToString::to_string).collect(),
    };
    out.pretty_json(&document)
}
