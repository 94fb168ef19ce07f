//! `objdict bus nmt`.

use std::io::Write;

use super::command::BusCommandJson;
use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusNmtArgs, NmtService, ShowFormat};
use crate::ending::{Failure, Outcome};
use crate::stdout::Output;
use objdict_document::describe::frames::nmt_state;

/// How long a node may take to show its new state, in milliseconds.
const STATE: u64 = 3000;

pub(super) fn run(args: &BusNmtArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let (what, word, state) = match args.command {
        NmtService::Start => ("start", "start", 5),
        NmtService::Stop => ("stop", "stop", 4),
        NmtService::PreOperational => ("set to pre-operational", "pre-operational", 0x7F),
        NmtService::Reset => ("reset", "reset", 0x7F),
        NmtService::ResetCommunication => ("reset the communication of", "reset-communication", 0x7F),
    };
    let whom = if args.node == 0 { "all nodes".to_owned() } else { format!("node {}", args.node) };
    session.listen(None, &format!("sends the NMT command {:02X}h to {whom}", args.command as u8))?;
    if args.node == 0 {
        session.require_alone(args.alone, &[])?;
    }
    let is_sent = agrees(&args.change, &format!("{what} {whom}?"))?;
    let mut document = BusCommandJson::new(word, is_sent);
    let mut outcome = Outcome::Clean;
    if is_sent {
        let nodes: Vec<u8> = match args.node {
            0 => session.client.states().keys().copied().collect(),
            node_id => vec![node_id],
        };
        session.client.command(args.command as u8, args.node)?;
        for node_id in nodes {
            let is_shown = session.client.wait_for(node_id, state, STATE)?;
            document.node(node_id, is_shown.then_some(state));
            let verb = if is_shown { "is" } else { "does not show that it is" };
            if args.connect.format == ShowFormat::Table {
                writeln!(out, "node {node_id} {verb} {}", nmt_state(state))?;
            }
            if !is_shown {
                outcome = Outcome::Findings;
            }
        }
    }
    if args.connect.format == ShowFormat::Json {
        out.json(&document)?;
    }
    Ok(outcome)
}
