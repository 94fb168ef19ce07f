//! The questions of `objdict probe` and the checks of `objdict conformance`, to a device on a bus.

use std::cell::RefCell;
use std::rc::Rc;

use objdict_bus::{Conformance, RemoteGroups, conformance_on};
use objdict_can::{CheckedDevice, ClientError, Danger, SavedValues};
use objdict_model::diagnostic::plural;
use objdict_model::model::Device;
use objdict_traffic::Descriptions;
use objdict_traffic::probe::{Exchange, ProbePlan, SdoAnswer, SdoRequest};

use super::change::entries;
use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusChangeArgs, BusLinkArgs, NetworkInputArgs};
use crate::ending::{Failure, note, tell};

/// The NMT command that resets a node.
const RESET_NODE: u8 = 0x81;

/// Asks what a plan asks. A plan that writes is only carried out on a node that may be changed, after a question.
pub(crate) fn ask(
    args: &BusLinkArgs,
    yes: bool,
    node_id: u8,
    device: &Device,
    plan: &ProbePlan,
) -> Result<Vec<Exchange>, Failure> {
    let mut session = BusSession::link(args, &NetworkInputArgs::default(), Descriptions::default())?;
    let count = plural(plan.len(), "question");
    session.listen(Some(node_id), &format!("asks {count} of node {node_id}"))?;
    if plan.writes() {
        let what = format!("write values to node {node_id} and put them back?");
        require_consent(&mut session, node_id, device, yes, &what)?;
    }
    let mut failure = None;
    let exchanges = plan.run(|index, sub, request| {
        if failure.is_some() {
            return SdoAnswer::Silence;
        }
        let answer = match request {
            SdoRequest::Upload => session.client.upload(node_id, index, sub).map(SdoAnswer::Bytes),
            SdoRequest::Download(bytes) => {
                session.client.download(node_id, index, sub, bytes).map(|()| SdoAnswer::Done)
            }
        };
        answer.unwrap_or_else(|error| match error {
            ClientError::Refused { abort, .. } => SdoAnswer::Abort(abort),
            ClientError::Silent { .. } => SdoAnswer::Silence,
            error => {
                failure = Some(error);
                SdoAnswer::Silence
            }
        })
    });
    if let Some(error) = failure {
        if plan.writes() {
            note("note: what was written last may not be put back; compare with `objdict bus save`\n");
        }
        return Err(error.into());
    }
    if exchanges.iter().all(|exchange| exchange.answer == SdoAnswer::Silence) {
        let failure = Failure::new(format_args!("node {node_id} does not respond"));
        return Err(failure.help("name the node with `--node-id`; `objdict bus scan` lists the nodes"));
    }
    Ok(exchanges)
}

/// Checks a device for conformance with its description.
pub(crate) fn check(
    args: &BusLinkArgs,
    groups: RemoteGroups,
    yes: bool,
    node_id: u8,
    device: &Device,
) -> Result<Conformance, Failure> {
    let mut session = BusSession::link(args, &NetworkInputArgs::default(), Descriptions::default())?;
    session.listen(Some(node_id), &format!("checks the services and entries of node {node_id}"))?;
    // a node that does not answer would fail every check
    session.client.upload(node_id, 0x1000, 0)?;
    let mut before = SavedValues::default();
    if groups.writes {
        let commands = if groups.commands { ", start and stop it" } else { "" };
        let what = format!("reset node {node_id}, write values to it{commands}, and put the values back?");
        require_consent(&mut session, node_id, device, yes, &what)?;
        before = session.client.save(node_id, device)?;
    }
    let checked = Rc::new(RefCell::new(CheckedDevice { client: session.client, failure: None }));
    let results = conformance_on(device, node_id, checked.clone(), groups);
    let CheckedDevice { client, failure } = &mut *checked.borrow_mut();
    if let Some(error) = failure.take() {
        // the adapter may be gone, which is the error then
        if groups.writes && client.command(RESET_NODE, node_id).is_ok() {
            note(&format!("note: node {node_id} is reset, which discards the written values\n"));
        }
        return Err(error.into());
    }
    let (restored, lost) = client.put_back(node_id, &before)?;
    if !restored.is_empty() {
        note(&format!("note: set again, because the reset cleared them: {}\n", entries(&restored)));
    }
    if !lost.is_empty() {
        let lost = entries(&lost);
        tell(&format!("warning: node {node_id} has other values than before, and keeps them: {lost}\n"));
    }
    Ok(results)
}

/// Refuses a node that must not be written, and asks.
fn require_consent(
    session: &mut BusSession,
    node_id: u8,
    device: &Device,
    yes: bool,
    what: &str,
) -> Result<(), Failure> {
    if let Some(danger) = session.client.dangers(node_id, device)?.first() {
        let help = match danger {
            Danger::Safety => "leave out `--write`",
            _ => "stop the machine, or leave out `--write`",
        };
        return Err(Failure::new(format_args!("node {node_id} is not written: {danger}")).help(help));
    }
    let change = BusChangeArgs { dry_run: false, yes, force: false };
    match agrees(&change, what)? {
        true => Ok(()),
        false => Err(Failure::new("the device was not asked").help("leave out `--write` to read only")),
    }
}
