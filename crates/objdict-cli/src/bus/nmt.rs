//! `objdict bus nmt`.

use std::io::Write;

use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusNmtArgs, NmtService};
use crate::ending::{Failure, Outcome};
use crate::stdout::Output;
use objdict_document::describe::frames::nmt_state;

/// How long a node may take to show its new state, in milliseconds.
const STATE: u64 = 3000;

pub(super) fn run(args: &BusNmtArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let (what, state) = match args.command {
        NmtService::Start => ("start", 5),
        NmtService::Stop => ("stop", 4),
        NmtService::PreOperational => ("set to pre-operational", 0x7F),
        NmtService::Reset => ("reset", 0x7F),
        NmtService::ResetCommunication => ("reset the communication of", 0x7F),
    };
    let whom = if args.node == 0 { "all nodes".to_owned() } else { format!("node {}", args.node) };
    session.listen(None, &format!("sends the NMT command {:02X}h to {whom}", args.command as u8))?;
    if args.node == 0 {
        session.require_alone(args.alone, &[])?;
    }
    if !agrees(&args.change, &format!("{what} {whom}?"))? {
        return Ok(Outcome::Clean);
    }
    let nodes: Vec<u8> = match args.node {
        0 => session.client.states().keys().copied().collect(),
        node_id => vec![node_id],
    };
    session.client.command(args.command as u8, args.node)?;
    let mut outcome = Outcome::Clean;
    for node_id in nodes {
        if session.client.wait_for(node_id, state, STATE)? {
            writeln!(out, "node {node_id} is {}", nmt_state(state))?;
        } else {
            writeln!(out, "node {node_id} does not show that it is {}", nmt_state(state))?;
            outcome = Outcome::Findings;
        }
    }
    Ok(outcome)
}
