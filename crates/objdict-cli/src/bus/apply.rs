//! `objdict bus apply`.

use std::path::PathBuf;

use objdict_can::{ApplyOptions, ClientError, WriteResult, undo};
use objdict_format::input::{Input, Reading};
use objdict_model::diagnostic::plural;
use objdict_model::model::Device;
use objdict_model::source::{MAX_TOML_SIZE, read_text};
use objdict_node::concise;
use objdict_node::configure::{SettingProblem, SettingsFile, configuration};
use objdict_node::download::{ConciseDcf, Download, PlanOptions, Scope};

use super::change::{Change, require_parameters, tell_lost};
use super::question::agrees;
use super::session::BusSession;
use crate::annotation::DescribedStream;
use crate::args::BusApplyArgs;
use crate::convert::{refusal, tell_skipped};
use crate::ending::{Failure, Outcome, note, tell};
use crate::input::{name_of, source_name};
use crate::settings::reading;
use crate::stdout::Output;
use crate::written_files::{keep, require_other, save};

/// The NMT state operational, and the commands that leave and enter it.
const OPERATIONAL: u8 = 5;
const PRE_OPERATIONAL: u8 = 0x7F;
const ENTER_PRE_OPERATIONAL: u8 = 0x80;
const START: u8 = 1;

/// How long a node may take for another state, in milliseconds.
const STATE: u64 = 2000;

pub(super) fn run(args: &BusApplyArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let described = session.device(args.node);
    let (downloads, own) = downloads(args, described.as_ref())?;
    let device = described.or(own).unwrap_or_default();
    require_parameters(&device, &downloads, &args.change)?;
    session.listen(Some(args.node), &format!("reads the present values of node {}", args.node))?;
    session.require_safe(args.node, &device, true, &args.change)?;
    let present = session.client.present(args.node, &downloads)?;
    let change = Change { node_id: args.node, device: &device, downloads: &downloads, present: &present };
    change.show(args.connect.format, out)?;
    if !agrees(&args.change, &format!("write {} to node {}?", plural(downloads.len(), "value"), args.node))? {
        return Ok(change.leave(args.connect.format, out)?);
    }
    let undo_file = write_undo(args, &change)?;
    let skip = args.start.saturating_sub(1);
    let options = ApplyOptions { verify: args.verify, go_on: args.go_on, skip };
    let (results, error) =
        in_pre_operational(&mut session, args.node, |session| change.make(session, options))?;
    let outcome = change.report((&results, error.as_ref()), skip, args.connect.format, out)?;
    out.finish()?;
    tell(&format!("undo it with `objdict bus apply {} {}`\n", args.node, name_of(&undo_file)));
    if let Some(next) = results.iter().skip(skip).position(|result| *result == WriteResult::Unsent) {
        note(&format!("note: resume with `--start {}`\n", skip + next + 1));
    }
    if let Some(error) = error {
        return Err(error.into());
    }
    if outcome == Outcome::Clean {
        store(args, &mut session)?;
    }
    Ok(outcome)
}

/// The downloads of a file, and the device that it describes.
fn downloads(
    args: &BusApplyArgs,
    described: Option<&Device>,
) -> Result<(Vec<Download>, Option<Device>), Failure> {
    keep(&args.file);
    if args.file.extension().is_some_and(|ending| ending == "toml")
        && let Some(device) = described
    {
        return Ok((of_settings(args, device)?, None));
    }
    let reading = Reading { node_id: Some(args.node), is_node: true, ..reading() };
    let device = match reading.open(&args.file)? {
        (_, Input::Concise(concise)) => return Ok((concise.0, None)),
        (_, Input::Description(description)) => description.device().clone(),
        (_, Input::Device(device)) => *device,
        (kind, _) => {
            let failure = Failure::new(format_args!("`{}` is a {}", source_name(&args.file), kind.name()));
            return Err(failure.help("name a DCF, an XDC, a settings file or a concise DCF"));
        }
    };
    if let Some(other) = device.node_id().filter(|id| *id != args.node && !args.change.force) {
        let failure = Failure::new(format_args!("`{}` is for node {other}", name_of(&args.file)));
        let help = format!("`objdict configure --node-id {}` makes one for node {}", args.node, args.node);
        return Err(failure.help(help));
    }
    let downloads = planned(&device, args.node, args.all)?;
    Ok((downloads, Some(device)))
}

/// What a settings file changes of a description.
fn of_settings(args: &BusApplyArgs, device: &Device) -> Result<Vec<Download>, Failure> {
    let text = read_text(&args.file, MAX_TOML_SIZE).map_err(Failure::new)?;
    let file = SettingsFile::parse(&text)
        .map_err(|error| Failure::new(format_args!("`{}`: {error}", name_of(&args.file))))?;
    let configuration = configuration(device, args.node, &file.settings)
        .map_err(|problems| Failure::of_lines(problems.iter().map(SettingProblem::to_string)))?;
    let mut device = device.clone();
    device.assign(&configuration.values);
    device.downloads = configuration.downloads;
    planned(&device, args.node, args.all)
}

/// The downloads of a device in an order that nodes accept.
fn planned(device: &Device, node_id: u8, is_all: bool) -> Result<Vec<Download>, Failure> {
    let scope = if is_all { Scope::All } else { Scope::Changed };
    let options = PlanOptions { node_id: Some(node_id), scope, ..PlanOptions::default() };
    let plan = ConciseDcf::plan(device, &options).map_err(|error| refusal(&error))?;
    tell_skipped(&plan);
    for file in plan.files() {
        let (index, sub, name) = (file.index, file.sub, &file.name);
        note(&format!(
            "note: {index:04X}h sub-index {sub} is not written: its data are in the file `{name}`\n"
        ));
    }
    Ok(plan.without_files().0)
}

/// Writes the downloads that undo a change to a new file.
fn write_undo(args: &BusApplyArgs, change: &Change<'_>) -> Result<PathBuf, Failure> {
    let numbered = |number: u32| match number {
        1 => PathBuf::from(format!("node-{}-undo.cdcf.txt", args.node)),
        _ => PathBuf::from(format!("node-{}-undo-{number}.cdcf.txt", args.node)),
    };
    let path = match &args.undo {
        Some(path) => path.clone(),
        None => (1..1000).map(numbered).find(|path| !path.exists()).unwrap_or_else(|| numbered(1)),
    };
    if path.exists() {
        let failure =
            Failure::new(format_args!("`{}` exists, and may undo an earlier change", name_of(&path)));
        return Err(failure.help("move it, or name a different file with `--undo`"));
    }
    require_other(&path)?;
    let undo = undo(change.downloads, change.present);
    let stream = DescribedStream { device: Some(change.device), node_id: Some(args.node) };
    save(&path, concise::print(&undo.downloads, |download| stream.annotate(download)).as_bytes())?;
    tell_lost(&undo.lost);
    Ok(path)
}

/// What a change comes to.
type Changed = (Vec<WriteResult>, Option<ClientError>);

/// Changes a node that is operational in state pre-operational, and starts it again.
pub(super) fn in_pre_operational(
    session: &mut BusSession,
    node_id: u8,
    change: impl FnOnce(&mut BusSession) -> Changed,
) -> Result<Changed, Failure> {
    let state = session.client.states().get(&node_id).copied().flatten();
    let is_left = state.is_some_and(|state| state != PRE_OPERATIONAL);
    if state.is_none() {
        note(&format!(
            "note: node {node_id} sends no heartbeat, so its state is not known and not changed\n"
        ));
    }
    if is_left {
        session.client.command(ENTER_PRE_OPERATIONAL, node_id)?;
        session.client.wait_for(node_id, PRE_OPERATIONAL, STATE)?;
    }
    let changed = change(session);
    if state == Some(OPERATIONAL) {
        let is_done =
            changed.1.is_none() && !changed.0.iter().any(|result| matches!(result, WriteResult::Refused(_)));
        // half a configuration is not started
        let is_started = is_done
            && session.client.command(START, node_id).is_ok()
            && session.client.wait_for(node_id, OPERATIONAL, STATE).unwrap_or(false);
        if !is_started {
            note(&format!(
                "note: node {node_id} stays pre-operational; `objdict bus nmt start {node_id}` starts it\n"
            ));
        }
    }
    Ok(changed)
}

/// Writes 1020h, then lets the node store everything: a later download would clear 1020h.
fn store(args: &BusApplyArgs, session: &mut BusSession) -> Result<(), Failure> {
    if let Some(time) = args.stamp {
        for (sub, number) in [(1, time.days), (2, time.milliseconds)] {
            session.client.download(args.node, 0x1020, sub, &number.to_le_bytes())?;
        }
        note("note: 1020h has the date and time\n");
    }
    if args.store { session.store(args.node) } else { Ok(()) }
}
