//! `objdict bus write`.

use objdict_can::{ApplyOptions, WriteResult, undo};
use objdict_model::diagnostic::plural;
use objdict_model::literal::{self, Spelling};
use objdict_model::model::{Assignment, Device};
use objdict_node::configure::{SettingProblem, configure};
use objdict_node::download::{Download, bytes_of};

use super::change::{Change, require_parameters, tell_lost};
use super::question::agrees;
use super::session::BusSession;
use crate::args::BusWriteArgs;
use crate::ending::{Failure, Outcome, note};
use crate::stdout::Output;

pub(super) fn run(args: &BusWriteArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let device = session.require_device(args.node)?;
    let downloads = downloads(&device, args)?;
    require_parameters(&device, &downloads, &args.change)?;
    session.listen(Some(args.node), &format!("reads the present values of node {}", args.node))?;
    session.require_safe(args.node, &device, false, &args.change)?;
    let present = session.client.present(args.node, &downloads)?;
    let change = Change { node_id: args.node, device: &device, downloads: &downloads, present: &present };
    change.show(args.connect.format, out)?;
    if !agrees(&args.change, &format!("write {} to node {}?", plural(downloads.len(), "value"), args.node))? {
        return Ok(change.leave(args.connect.format, out)?);
    }
    let options = ApplyOptions { verify: true, ..ApplyOptions::default() };
    let (results, error) = change.make(&mut session, options);
    let outcome = change.report((&results, error.as_ref()), 0, args.connect.format, out)?;
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
    let download = |at: &Assignment| {
        let bytes = bytes_of(device, at.index, at.sub, &at.value, Some(args.node));
        let failed = |error| Failure::new(format_args!("{:04X}h sub-index {}: {error}", at.index, at.sub));
        bytes.map(|bytes| Download::new(at.index, at.sub, bytes)).map_err(failed)
    };
    assignments.iter().map(download).collect()
}

/// Reports the command that restores the previous values.
fn tell_undo(change: &Change<'_>, results: &[WriteResult], args: &BusWriteArgs) {
    let is_changed = |(download, result): &(&Download, &WriteResult)| {
        let is_written = matches!(result, WriteResult::Written | WriteResult::Differs(_));
        is_written && change.present.get(&download.entry()) != Some(&download.data)
    };
    let changed = change.downloads.iter().zip(results).filter(is_changed);
    let changed: Vec<Download> = changed.map(|(download, _)| download.clone()).collect();
    let mut undo = undo(&changed, change.present);
    let mut settings = String::new();
    for download in &undo.downloads.0 {
        match download.value(change.device) {
            Some(value) => {
                let value = literal::print(&value, Spelling::default());
                settings += " ";
                settings += &argument(format!("{:04X}:{:X}={value}", download.index, download.sub));
            }
            None => undo.lost.push(download.entry()),
        }
    }
    if !settings.is_empty() {
        note(&format!("note: undo it with `objdict bus write {}{settings}`\n", args.node));
    }
    tell_lost(&undo.lost);
}

/// An argument as shells take it.
fn argument(text: String) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "=:.+-_".contains(letter);
    if text.chars().all(is_plain) { text } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::argument;

    #[test]
    fn arguments_are_quoted_for_a_shell() {
        let quoted = ["1017:0=250", "2000:0=a b", "2000:0=it's"].map(|text| argument(text.to_owned()));
        assert_eq!(quoted, ["1017:0=250", "'2000:0=a b'", r"'2000:0=it'\''s'"]);
    }
}
