//! A bus that is open, and what describes its nodes.

use std::fs::File;
use std::io::{LineWriter, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use objdict_bus::LiveBus;
use objdict_can::{BusAddress, BusClient, ClientError, SimulatedBus, Transport, TransportError, open};
use objdict_model::model::Device;
use objdict_traffic::log::LoggedFrame;
use objdict_traffic::{DescribedNode, Descriptions};

use crate::args::{BusConnectArgs, BusLinkArgs, NamedBus, NetworkInputArgs, named_bus};
use crate::decode::descriptions;
use crate::ending::{Failure, note, tell};
use crate::input::name_of;
use crate::network;
use crate::written_files::{end_orderly, keep, require_other};

/// Where the address of a bus is looked for when no argument names it.
const VARIABLE: &str = "OBJDICT_BUS";

static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// A bus that a command works on.
pub(crate) struct BusSession {
    pub(crate) client: BusClient,
    /// The address as it was given.
    pub(super) name: String,
    pub(super) descriptions: Descriptions,
    listen: u64,
    is_simulated: bool,
    /// Whether the command needs no PDOs once it knows who is on the bus.
    drops_pdos: bool,
}

/// The time of a simulation that no argument limits, in seconds.
const SIMULATION: u32 = 10;

impl From<ClientError> for Failure {
    fn from(error: ClientError) -> Self {
        Self::new(&error).help(error.help())
    }
}

impl From<TransportError> for Failure {
    fn from(error: TransportError) -> Self {
        ClientError::from(error).into()
    }
}

impl BusSession {
    /// Opens the bus; nothing is sent.
    pub(crate) fn open(args: &BusConnectArgs) -> Result<Self, Failure> {
        let descriptions = descriptions(args.with.iter(), &args.input)?;
        let session = Self::link(&args.link, &args.input, descriptions)?;
        Ok(Self { drops_pdos: args.link.log.is_none(), ..session })
    }

    /// The same with descriptions that are read already.
    pub(crate) fn link(
        args: &BusLinkArgs,
        input: &NetworkInputArgs,
        descriptions: Descriptions,
    ) -> Result<Self, Failure> {
        let NamedBus { address, name } = address(args)?;
        end_orderly(&IS_INTERRUPTED);
        let client = BusClient::new(transport(&address, input)?);
        let mut client = client
            .with_timeout(args.timeout)
            .with_stop(|| IS_INTERRUPTED.load(Ordering::Relaxed))
            .shared(args.shared);
        if let Some(path) = &args.log {
            require_other(path)?;
            let failed = |error| Failure::new(format_args!("cannot write `{}`: {error}", name_of(path)));
            let mut file = Some(LineWriter::new(File::create(path).map_err(failed)?));
            let name = name_of(path);
            client = client.with_observer(Box::new(move |frame| {
                // the frame is on the bus whether it can be logged or not
                let written = file.as_mut().map_or(Ok(()), |file| writeln!(file, "{}", line(frame)));
                if let Err(error) = written {
                    tell(&format!("warning: `{name}` is incomplete: {error}\n"));
                    file = None;
                }
            }));
        }
        let is_simulated = matches!(address, BusAddress::Simulated { .. });
        Ok(Self { client, name, descriptions, listen: args.listen.into(), is_simulated, drops_pdos: false })
    }

    /// Says what is sent, listens before it, and refuses a node that another client is at work on.
    pub(crate) fn listen(&mut self, node_id: Option<u8>, then: &str) -> Result<(), Failure> {
        if !self.client.is_replay() {
            note(&format!("note: listens for {} ms, then {then}\n", self.listen));
        }
        self.client.listen(self.listen)?;
        if self.drops_pdos {
            self.client.drop_pdos()?;
        }
        if let Some(node_id) = node_id {
            self.client.require_own(node_id)?;
        }
        Ok(())
    }

    /// When a command ends that goes on for some seconds, or until it is interrupted, in microseconds. A simulation always ends.
    pub(super) fn end(&self, seconds: Option<u32>) -> Option<u64> {
        let seconds = seconds.or(self.is_simulated.then_some(SIMULATION))?;
        Some(self.client.now().saturating_add(u64::from(seconds) * 1_000_000))
    }

    /// Lets frames pass until a time.
    pub(super) fn wait(&mut self, until: u64) -> Result<(), ClientError> {
        while self.client.next_frame(until)?.is_some() {}
        Ok(())
    }

    /// Refuses a broadcast on a bus with other nodes than this one.
    pub(super) fn require_alone(&self, is_alone: bool, but: &[u8]) -> Result<(), Failure> {
        if is_alone { Ok(()) } else { Ok(self.client.require_alone(but)?) }
    }

    /// The description of a node: the one for its node-ID, else the only one without a node-ID.
    pub(crate) fn described(&self, node_id: u8) -> Option<&DescribedNode> {
        let nodes = &self.descriptions.nodes;
        let stated = nodes.iter().find(|node| node.node_id == Some(node_id));
        stated.or_else(|| {
            let mut open = nodes.iter().filter(|node| node.node_id.is_none());
            open.next().filter(|_| open.next().is_none())
        })
    }

    /// The described device of a node.
    pub(super) fn device(&self, node_id: u8) -> Option<Device> {
        self.described(node_id).map(|node| node.device.clone())
    }

    /// The same for what cannot be done without.
    pub(super) fn require_device(&self, node_id: u8) -> Result<Device, Failure> {
        self.device(node_id).ok_or_else(|| {
            let failure = Failure::new(format_args!("no description of node {node_id} is named"));
            failure.help(format!("name it, as in `--with {node_id}=drive.eds`"))
        })
    }
}

fn address(args: &BusLinkArgs) -> Result<NamedBus, Failure> {
    match (&args.bus, std::env::var(VARIABLE)) {
        (Some(bus), _) => Ok(bus.clone()),
        (None, Ok(text)) if !text.is_empty() => {
            named_bus(&text).map_err(|error| Failure::new(format_args!("{VARIABLE}: {error}")))
        }
        _ => {
            let help = "pass `--bus socketcan:can0`, `--bus slcan:/dev/ttyACM0@500` or `--bus sim:network.toml`, or set OBJDICT_BUS";
            Err(Failure::new("no bus is named").help(help))
        }
    }
}

fn transport(address: &BusAddress, input: &NetworkInputArgs) -> Result<Box<dyn Transport>, Failure> {
    let BusAddress::Simulated { network, memory, new } = address else { return Ok(open(address)?) };
    let file = network::open_to_use(std::slice::from_ref(network), input)?;
    let bus = SimulatedBus::new(LiveBus::new(file.plant_nodes(), file.bit_rate(), new));
    match memory {
        Some(path) => {
            keep(path);
            Ok(Box::new(bus.with_memory(path)?))
        }
        None => Ok(Box::new(bus)),
    }
}

/// As `candump -L` writes a frame.
pub(super) fn line(frame: &LoggedFrame) -> String {
    let direction = if frame.is_sent == Some(true) { "T" } else { "R" };
    let time = frame.time.nanoseconds();
    format!("({}.{:06}) bus {frame} {direction}", time / 1_000_000_000, time % 1_000_000_000 / 1000)
}
