//! `objdict bus replace`.

use std::collections::BTreeMap;
use std::io::Write;

use objdict_can::{ApplyOptions, LssIdentity};
use objdict_model::diagnostic::plural;
use objdict_network::Slave;

use super::change::Change;
use super::lss::{await_boot_up, configure, in_lss, selected, spelled};
use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusReplaceArgs, ShowFormat};
use crate::ending::{Failure, Outcome, note};
use crate::input::name_of;
use crate::network::open_to_use;
use crate::stdout::Output;

pub(super) fn run(args: &BusReplaceArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let file = open_to_use(std::slice::from_ref(&args.network), &args.connect.input)?;
    let slave =
        file.compiled().and_then(|compiled| compiled.slaves.iter().find(|slave| slave.node_id == args.node));
    let slave = slave.ok_or_else(|| {
        Failure::new(format_args!("`{}` has no node {}", name_of(&args.network), args.node))
            .help("`objdict network show` lists its nodes")
    })?;
    session.listen(
        None,
        &format!("asks whether node {} is missing, and looks for a new device by LSS", args.node),
    )?;
    if !session.client.scan(args.node..=args.node, args.connect.link.timeout.into())?.is_empty() {
        let failure = Failure::new(format_args!("node {} is there, so nothing is replaced", args.node));
        return Err(failure.help("disconnect it; `objdict bus apply` configures a node that is there"));
    }
    session.require_alone(args.alone, &[])?;
    let is_done = in_lss(&mut session, |session| {
        let identity = selected(session, None)?;
        if args.connect.format == ShowFormat::Table {
            writeln!(out, "new device: {}", spelled(identity))?;
            out.finish()?;
        }
        require_same_type(slave, identity)?;
        let count = plural(slave.downloads.0.len(), "value");
        if !agrees(&args.change, &format!("make it node {} and write {count}?", args.node))? {
            return Ok(false);
        }
        configure(session, args.node, None)?;
        Ok(true)
    })?;
    let change = Change {
        node_id: args.node,
        device: &slave.device,
        downloads: &slave.downloads.0,
        present: &BTreeMap::new(),
    };
    if !is_done {
        return Ok(change.leave(args.connect.format, out)?);
    }
    await_boot_up(&mut session, args.node)?;
    let (results, error) =
        change.make(&mut session, ApplyOptions { verify: true, ..ApplyOptions::default() });
    let outcome = change.report((&results, error.as_ref()), 0, args.connect.format, out)?;
    if let Some(error) = error {
        return Err(error.into());
    }
    if args.store && outcome == Outcome::Clean {
        session.store(args.node)?;
    }
    Ok(outcome)
}

/// Refuses a device of another type. Another revision is noted.
fn require_same_type(slave: &Slave, identity: LssIdentity) -> Result<(), Failure> {
    let [_, vendor, product, revision, _] = slave.identity;
    for (expected, found, what) in
        [(vendor, identity[0], "vendor-ID"), (product, identity[1], "product code")]
    {
        if expected != 0 && expected != found {
            let message = format!("the new device differs: its {what} is {found:X}h, expected {expected:X}h");
            return Err(Failure::new(message).help("connect a device of the same type"));
        }
    }
    if revision != 0 && revision != identity[2] {
        note(&format!("note: the revision number is {:X}h, expected {revision:X}h\n", identity[2]));
    }
    Ok(())
}
