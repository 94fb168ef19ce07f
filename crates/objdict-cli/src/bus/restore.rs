//! `objdict bus restore`.

use super::command::BusCommandJson;
use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusRestoreArgs, ShowFormat};
use crate::ending::{Failure, Outcome, note};
use crate::stdout::Output;

pub(super) fn run(args: &BusRestoreArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let device = session.device(args.node).unwrap_or_default();
    session.listen(
        Some(args.node),
        &format!("writes \"load\" to 1011h sub-index {} of node {}", args.sub, args.node),
    )?;
    session.require_safe(args.node, &device, true, &args.change)?;
    let is_sent = agrees(&args.change, &format!("restore the defaults of node {}?", args.node))?;
    let mut document = BusCommandJson::new("restore", is_sent);
    if is_sent {
        session.client.download(args.node, 0x1011, args.sub, b"load")?;
        document.node(args.node, None);
    }
    if args.connect.format == ShowFormat::Json {
        out.json(&document)?;
    } else if is_sent {
        out.summary(format_args!("node {}: the defaults are valid after its next reset", args.node))?;
    }
    if !is_sent {
        return Ok(Outcome::Clean);
    }
    note(&format!(
        "note: switch it off and on, or reset it: `objdict bus nmt reset {}`; its node-ID and bit rate may change too\n",
        args.node
    ));
    Ok(Outcome::Clean)
}
