//! `objdict bus lss`.

use std::fmt;
use std::io::Write;

use objdict_can::{LssIdentity, lss_rate};
use objdict_model::json::Version;
use objdict_network::Slave;
use serde::Serialize;

use super::command::BusCommandJson;
use super::question::agrees;
use super::session::BusSession;
use crate::args::{BusLssAssignArgs, BusLssCommand, BusLssPlanArgs, BusLssScanArgs, ShowFormat};
use crate::ending::{Failure, Outcome, note};
use crate::network::open_to_use;
use crate::stdout::Output;

/// How long a device may take for its boot-up message with a new node-ID, in milliseconds.
const BOOT_UP: u64 = 3000;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LssJson {
    /// The version of the document.
    version: Version<1>,
    /// Vendor-ID, product code, revision number and serial number of a device without a node-ID; absent if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    identity: Option<LssIdentity>,
}

/// The steps that assign the node-IDs and the bit rate of a network.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LssPlanJson {
    /// The version of the document.
    version: Version<1>,
    /// The steps in order, each for `objdict bus lss assign`.
    steps: Vec<LssStep>,
}

/// A device to be assigned.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LssStep {
    /// The node-ID to assign.
    node_id: u8,
    /// Vendor-ID, product code, revision number and serial number, which select the device; absent for a new device without a
    /// node-ID.
    #[serde(skip_serializing_if = "Option::is_none")]
    identity: Option<LssIdentity>,
    /// The bit rate to assign, in kbit/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    bit_rate: Option<u16>,
    /// Whether no other device may be connected.
    is_alone: bool,
}

pub(super) fn run(command: &BusLssCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        BusLssCommand::Scan(args) => scan(args, out),
        BusLssCommand::Assign(args) => assign(args, out),
        BusLssCommand::Plan(args) => plan(args, out),
    }
}

fn scan(args: &BusLssScanArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    session.listen(None, "looks for a device without a node-ID (LSS fastscan)")?;
    session.require_alone(args.alone, &[])?;
    let identity = in_lss(&mut session, |session| Ok(session.client.fastscan()?))?;
    match (args.connect.format, identity) {
        (ShowFormat::Json, identity) => out.json(&LssJson { version: Version, identity })?,
        (ShowFormat::Table, Some(identity)) => writeln!(out, "{}", spelled(identity))?,
        (ShowFormat::Table, None) => writeln!(out, "no device without a node-ID responds")?,
    }
    Ok(Outcome::Clean)
}

fn assign(args: &BusLssAssignArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    session.listen(None, &format!("assigns node-ID {} by LSS", args.node))?;
    // the device itself may have the node-ID already
    let own: &[u8] = if args.identity.is_some() { &[args.node] } else { &[] };
    session.require_alone(args.alone, own)?;
    if session.client.states().contains_key(&args.node) && !has_node_id(&mut session, args)? {
        return Err(
            Failure::new(format_args!("node-ID {} is in use", args.node)).help("assign a different one")
        );
    }
    let mut document = BusCommandJson::new("lss assign", false);
    in_lss(&mut session, |session| {
        let identity = selected(session, args.identity)?;
        document.identity = Some(identity);
        if args.connect.format == ShowFormat::Table {
            writeln!(out, "{}", spelled(identity))?;
            out.finish()?;
        }
        if let Some(rate) = args.bit_rate {
            rescue(session, rate);
        }
        document.is_sent = agrees(&args.change, &format!("assign node-ID {} to this device?", args.node))?;
        if document.is_sent {
            let is_tested = configure(session, args.node, args.bit_rate)?;
            document.is_tested = args.bit_rate.map(|_| is_tested);
        }
        Ok(())
    })?;
    if document.is_sent {
        let has_booted = await_boot_up(&mut session, args.node)?;
        document.node(args.node, has_booted.then_some(0x7F));
        match (args.bit_rate, document.is_tested) {
            (Some(rate), Some(true)) => {
                note(&format!("note: the device responds at {rate} kbit/s, and works at it from now on\n"));
            }
            (Some(rate), _) if session.client.has_bit_rates() => {
                note(&format!(
                    "note: the device changes to {rate} kbit/s at its next power-on only, so it is not tested\n"
                ));
            }
            _ => {}
        }
    }
    match args.connect.format {
        ShowFormat::Json => out.json(&document)?,
        ShowFormat::Table if document.is_sent => {
            out.summary(format_args!("node-ID {} is assigned and stored", args.node))?;
        }
        ShowFormat::Table => {}
    }
    Ok(Outcome::Clean)
}

/// Whether the device that is selected by its identity has the node-ID already.
fn has_node_id(session: &mut BusSession, args: &BusLssAssignArgs) -> Result<bool, Failure> {
    let Some(identity) = args.identity else { return Ok(false) };
    let found = session.client.scan(args.node..=args.node, args.connect.link.timeout.into())?;
    Ok(found.iter().any(|node| node.identity == identity.map(Some)))
}

fn plan(args: &BusLssPlanArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let file = open_to_use(std::slice::from_ref(&args.network), &args.input)?;
    let slaves = file.compiled().into_iter().flat_map(|compiled| &compiled.slaves);
    let (by_serial, new): (Vec<_>, Vec<_>) = slaves.partition(|slave| slave.identity[4] != 0);
    let rate = Some(file.bit_rate()).filter(|rate| lss_rate(*rate).is_some());
    let step = |slave: &Slave, bit_rate| {
        let [_, identity @ ..] = slave.identity;
        let identity = Some(identity).filter(|[.., serial]| *serial != 0);
        LssStep {
            node_id: slave.node_id,
            identity,
            bit_rate,
            is_alone: bit_rate.is_some() || identity.is_none(),
        }
    };
    let mut steps: Vec<_> = by_serial.iter().map(|slave| step(slave, None)).collect();
    steps.extend(new.iter().map(|slave| step(slave, rate)));
    // a device that changes its bit rate would disturb the others
    steps.extend(by_serial.iter().filter(|_| rate.is_some()).map(|slave| step(slave, rate)));
    match args.format {
        ShowFormat::Json => out.json(&LssPlanJson { version: Version, steps })?,
        ShowFormat::Table => steps.iter().try_for_each(|step| writeln!(out, "{step}"))?,
    }
    note(
        "note: if a device is lost, connect it alone, try each bit rate of the adapter with `objdict bus lss scan`, and assign it again\n",
    );
    Ok(Outcome::Clean)
}

/// The command of a step.
impl fmt::Display for LssStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "objdict bus lss assign {}", self.node_id)?;
        if let Some(identity) = self.identity {
            write!(f, " --identity {}", spelled(identity))?;
        }
        if let Some(rate) = self.bit_rate {
            write!(f, " --bit-rate {rate}")?;
        }
        match (self.is_alone, self.identity) {
            (false, _) => Ok(()),
            (true, None) => f.write_str("    # connect only this new device"),
            (true, Some(_)) => f.write_str("    # connect only this device"),
        }
    }
}

/// Does something with LSS, and leaves the configuration state in any case.
pub(super) fn in_lss<T>(
    session: &mut BusSession,
    act: impl FnOnce(&mut BusSession) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let result = act(session);
    let waiting = session.client.lss_waiting();
    let result = result?;
    waiting?;
    Ok(result)
}

/// Selects the device with an identity, or the one without a node-ID.
pub(super) fn selected(
    session: &mut BusSession,
    identity: Option<LssIdentity>,
) -> Result<LssIdentity, Failure> {
    match identity {
        Some(identity) if session.client.lss_select(identity)? => Ok(identity),
        Some(identity) => {
            let failure =
                Failure::new(format_args!("no device with the identity {} responds", spelled(identity)));
            Err(failure.help("read 1018h of the device, or leave out `--identity`"))
        }
        None => session.client.fastscan()?.ok_or_else(|| {
            let failure = Failure::new("no device without a node-ID responds");
            failure.help("switch it on alone; a device that has a node-ID needs `--identity`")
        }),
    }
}

/// Gives the selected device a node-ID and a bit rate; whether the bit rate was tested.
pub(super) fn configure(
    session: &mut BusSession,
    node_id: u8,
    bit_rate: Option<u16>,
) -> Result<bool, Failure> {
    let result = session.client.lss_configure(node_id, bit_rate)?;
    result.map_err(|place| {
        Failure::new(place).help("switch the device off and on: it keeps what it had; see its manual for LSS")
    })
}

/// Waits for the boot-up message of a device with a new node-ID; whether it came.
pub(super) fn await_boot_up(session: &mut BusSession, node_id: u8) -> Result<bool, Failure> {
    // it may have come with the answers before
    let has_booted = session.client.states().get(&node_id) == Some(&Some(0x7F))
        || session.client.wait_for(node_id, 0x7F, BOOT_UP)?;
    if !has_booted {
        note(&format!(
            "note: node {node_id} sends no boot-up message; a device that had a node-ID needs a reset\n"
        ));
    }
    Ok(has_booted)
}

/// What to do if the device is no longer found.
fn rescue(session: &BusSession, rate: u16) {
    let now = session
        .client
        .bit_rate()
        .map_or_else(|| "the present rate".to_owned(), |rate| format!("{rate} kbit/s"));
    let plan = if session.client.has_bit_rates() {
        format!(
            "note: tests {rate} kbit/s before it is stored, so no other device may be connected; if the device is lost, switch it off and on, connect it alone, and look for it at {now} and at {rate} kbit/s with `objdict bus lss scan`\n"
        )
    } else {
        format!(
            "note: this adapter cannot test {rate} kbit/s; until its next power-on the device works at {now}, then at {rate} kbit/s; if it is lost, connect it alone, set the adapter to {rate} kbit/s, and assign the bit rate again\n"
        )
    };
    note(&plan);
}

/// `0x3F9:0x402:0x10001:7`, as `--identity` takes it.
pub(super) fn spelled(identity: LssIdentity) -> String {
    identity.map(|number| format!("0x{number:X}")).join(":")
}
