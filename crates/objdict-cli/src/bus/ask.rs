//! The questions of `objdict probe` to a device on a bus.

use objdict_can::{ClientError, Danger};
use objdict_model::diagnostic::plural;
use objdict_model::model::Device;
use objdict_traffic::Descriptions;
use objdict_traffic::probe::{Exchange, ProbePlan, SdoAnswer, SdoRequest};

use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusChangeArgs, BusLinkArgs, NetworkInputArgs};
use crate::ending::{Failure, note};

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
        if let Some(danger) = session.client.dangers(node_id, device)?.first() {
            let help = match danger {
                Danger::Safety => "leave out `--write`",
                _ => "stop the machine, or leave out `--write`",
            };
            return Err(Failure::new(format_args!("node {node_id} is not written: {danger}")).help(help));
        }
        let change = BusChangeArgs { dry_run: false, yes, force: false };
        if !agrees(&change, &format!("write values to node {node_id} and put them back?"))? {
            return Ok(Vec::new());
        }
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
        let failure = Failure::new(format_args!("node {node_id} does not answer"));
        return Err(failure.help("name the node with `--node-id`; `objdict bus scan` lists the nodes"));
    }
    Ok(exchanges)
}
