//! `objdict bus write`.

use objdict_can::{ApplyOptions, WriteResult};
use objdict_model::diagnostic::plural;
use objdict_model::model::Device;
use objdict_node::configure::{SettingProblem, configure};
use objdict_node::download::{Download, bytes_of, transferred_type};

use super::change::{Change, require_parameters};
use super::question::agrees;
use super::session::BusSession;
use crate::args::BusWriteArgs;
use crate::ending::{Failure, Outcome, note};
use crate::stdout::Output;
use objdict_model::model::Value;

pub(super) fn run(args: &BusWriteArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let device = session.device(args.node)?;
    let downloads = downloads(&device, args)?;
    require_parameters(&device, &downloads, &args.change)?;
    session.listen(Some(args.node), &format!("reads the present values of node {}", args.node))?;
    session.require_safe(args.node, &device, false, &args.change)?;
    let present = session.client.present(args.node, &downloads)?;
    let change = Change { node_id: args.node, device: &device, downloads: &downloads, present: &present };
    change.show(args.format, out)?;
    if !agrees(&args.change, &format!("write {} to node {}?", plural(downloads.len(), "value"), args.node))? {
        return Ok(change.leave(args.format, out)?);
    }
    let options = ApplyOptions { verify: true, ..ApplyOptions::default() };
    let (results, error) = change.make(&mut session, options);
    let outcome = change.report((&results, error.as_ref()), 0, args.format, out)?;
    out.finish()?;
    tell_undo(&change, &results, args);
    error.map_or(Ok(outcome), |error| Err(error.into()))
}

/// The downloads that values of arguments are.
fn downloads(device: &Device, args: &BusWriteArgs) -> Result<Vec<Download>, Failure> {
    let assignments = configure(device, args.node, &args.values).map_err(|problems| {
        let lines: Vec<String> = problems.iter().map(SettingProblem::to_string).collect();
        let help = problems.iter().find_map(|problem| problem.help.clone());
        Failure::of_lines(lines).maybe_help(help)
    })?;
    let download = |at: &objdict_model::model::Assignment| {
        let bytes = bytes_of(device, at.index, at.sub, &at.value, Some(args.node));
        let failed = |error| Failure::new(format_args!("{:04X}h sub-index {}: {error}", at.index, at.sub));
        bytes.map(|bytes| Download::new(at.index, at.sub, bytes)).map_err(failed)
    };
    assignments.iter().map(download).collect()
}

/// The command that writes the values before.
fn tell_undo(change: &Change<'_>, results: &[WriteResult], args: &BusWriteArgs) {
    let mut settings = String::new();
    for (download, result) in change.downloads.iter().zip(results) {
        let (index, sub) = (download.index, download.sub);
        let is_written = matches!(result, WriteResult::Written | WriteResult::Differs(_));
        let before = change.present.get(&(index, sub)).filter(|bytes| is_written && **bytes != download.data);
        let value =
            before.and_then(|bytes| Value::from_bytes(bytes, transferred_type(change.device, index, sub)?));
        if let Some(number) = value.and_then(|value| value.as_integer()) {
            settings += &format!(" {index:04X}:{sub:X}={number}");
        }
    }
    if !settings.is_empty() {
        note(&format!("note: undo it with `objdict bus write {}{settings}`\n", args.node));
    }
}
