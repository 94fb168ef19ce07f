//! Message frequency and bus load.

use crate::Language;
use crate::compiled::{Compiled, PdoState, Slave};
use crate::messages::{MessageId, Messages, Service};
use crate::network::{Network, Said};
use crate::source::Span;

/// The maximum number of bits of a data frame with this many bytes, with stuff bits and the interframe space.
pub(crate) const fn frame_bits(bytes: u64, is_extended: bool) -> u64 {
    if is_extended { 80 + 10 * bytes } else { 55 + 10 * bytes }
}

/// The sender and parameters of SYNC.
pub(crate) struct Sync {
    pub(crate) can_id: MessageId,
    /// The communication cycle period in microseconds.
    pub(crate) period: u64,
    /// The synchronous window length in microseconds; 0: none.
    pub(crate) window: Said<u64>,
    /// The synchronous counter overflow value.
    pub(crate) overflow: u8,
    pub(crate) bytes: u64,
    pub(crate) at: Span,
    pub(crate) node: usize,
}

/// Aperiodic messages, which the bus load does not include.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Uncounted {
    /// The CAN-IDs of PDOs that an event or a request triggers and that have neither inhibit time nor event timer.
    pub pdos: Vec<MessageId>,
    /// Other services: `NMT`, `TIME`, `EMCY`, `SDO`.
    pub services: Vec<&'static str>,
}

impl Uncounted {
    /// The maximum number of listed CAN-IDs.
    const MAX_LISTED: usize = 8;

    /// `NMT, EMCY, SDO, 2 PDOs without inhibit time and event timer (18Dh, 20Bh)`, with CAN-IDs as the document has them. Empty if all is
    /// counted.
    pub fn words(&self, language: Language, spelled: impl Fn(MessageId) -> String) -> String {
        let mut words: Vec<String> = self.services.iter().map(ToString::to_string).collect();
        let shown = self.pdos.iter().take(Self::MAX_LISTED).map(|id| spelled(*id)).collect::<Vec<_>>();
        let rest = if self.pdos.len() > shown.len() { ", …" } else { "" };
        let s = if self.pdos.len() == 1 { "" } else { "s" };
        let without =
            language.pick("without inhibit time and event timer", "ohne Inhibit-Time und Event-Timer");
        if !self.pdos.is_empty() {
            words.push(format!("{} PDO{s} {without} ({}{rest})", self.pdos.len(), shown.join(", ")));
        }
        words.join(", ")
    }
}

/// The messages of a network in time.
#[derive(Clone, Copy)]
pub(crate) struct Traffic<'n> {
    pub(crate) network: &'n Network,
    pub(crate) compiled: &'n Compiled,
    pub(crate) messages: &'n Messages,
}

impl<'n> Traffic<'n> {
    /// The SYNC that is sent.
    pub(crate) fn sync(self) -> Option<Sync> {
        let mut messages = self.messages.0.iter();
        let (can_id, party) = messages.find_map(|(can_id, message)| {
            let party = message.senders.iter().find(|party| party.service == Service::Sync)?;
            Some((*can_id, party))
        })?;
        let slave = self.compiled.node(party.node)?;
        let services = slave.services();
        let overflow = services.sync_counter_overflow.unwrap_or(0);
        let at = slave.said(0x1007, 0).unwrap_or(party.at);
        Some(Sync {
            can_id,
            period: services.communication_cycle_period?.into(),
            window: Said::new(services.synchronous_window.unwrap_or(0).into(), at),
            overflow,
            bytes: u64::from(overflow > 1),
            at: party.at,
            node: party.node,
        })
    }

    /// All PDOs that are on, of senders and of receivers.
    pub(crate) fn sent(self) -> Vec<(&'n Slave, &'n PdoState)> {
        let pdos = |slave: &'n Slave| slave.pdos.iter().map(move |state| (slave, state));
        self.compiled.nodes().flat_map(pdos).filter(|(_, state)| state.is_active()).collect()
    }

    /// The PDOs that a node sends, by CAN-ID, with the parameters of the sender, otherwise of a receiver.
    fn pdos(self) -> impl Iterator<Item = &'n PdoState> {
        let sent = self.messages.0.values().filter(|message| !message.senders.is_empty());
        sent.filter_map(move |message| {
            let mut parties = message.senders.iter().chain(&message.receivers);
            parties.find_map(|party| self.compiled.pdo(party))
        })
    }

    /// The messages that [`load`](Self::load) does not include.
    pub(crate) fn uncounted(self) -> Uncounted {
        let sync = self.sync();
        // without SYNC, a synchronous PDO is not sent
        let is_uncounted =
            |state: &&PdoState| state.period(sync.as_ref()).is_none() && state.transmission > 240;
        let pdos = self.pdos().filter(is_uncounted).map(PdoState::can_id).collect();
        let parties = || self.messages.0.values().flat_map(|message| &message.senders);
        let is_sent = |services: &[Service]| parties().any(|party| services.contains(&party.service));
        let services = [
            ("NMT", self.network.manager.is_some()),
            ("TIME", is_sent(&[Service::Time])),
            ("EMCY", is_sent(&[Service::Emcy])),
            ("SDO", is_sent(&[Service::SdoRequest, Service::SdoResponse])),
        ];
        let services = services.into_iter().filter(|(_, is_sent)| *is_sent).map(|(name, _)| name).collect();
        Uncounted { pdos, services }
    }
}
