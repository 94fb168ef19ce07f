//! The sums of a bus beside what the descriptions say.

use serde::Serialize;

use super::{BusSums, LastFrame, MessageSums, NODES, SECOND, SYNCS, kept, lost, milliseconds};
use crate::incident::{Subject, numbered, with_consequences};
use crate::{Bus, DescribedNode, Incident, NodeEvent};
use objdict_document::describe::frames::{FrameKind, nmt_state, raw_bytes};
use objdict_lint::recorded::traffic as rules;
use objdict_model::model::{CobId, Pdo, PdoKind};
use objdict_network::Service;

/// The sums of a bus.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Bus"))]
pub struct BusReport {
    /// The name of the channel; absent if the log has none.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub channel: String,
    /// The time of the first frame, in seconds with the digits of the log.
    pub from: String,
    /// The time of the last frame.
    pub to: String,
    /// The number of frames.
    pub frames: u64,
    /// The number of error frames among them.
    pub error_frames: u64,
    /// Frames in a second.
    pub frames_per_second: f64,
    /// The load in percent; absent without a bit rate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load: Option<f64>,
    /// The load of the last half second, in percent.
    #[serde(skip)]
    pub present_load: f64,
    /// The number of frames of each kind.
    pub kinds: Vec<KindSums>,
    /// The nodes that sent frames, or that are described.
    pub nodes: Vec<NodeReport>,
    /// The CAN-IDs in ascending order.
    pub messages: Vec<MessageReport>,
    /// The first SDO transfers that ended with an abort code.
    pub aborted_transfers: Vec<NodeEvent>,
    /// The first emergencies.
    pub emergencies: Vec<NodeEvent>,
    /// The number of further events that are not listed.
    pub further_events: u64,
    /// The nodes that no description covers.
    pub undescribed: Vec<u8>,
    /// The values that were written to nodes, compared with their descriptions.
    pub configurations: Vec<ConfigurationReport>,
    /// What went wrong: [`incidents`](crate::incidents) takes it out and numbers it.
    #[serde(skip)]
    pub incidents: Vec<Incident>,
    /// The first events that are against rules.
    #[serde(skip)]
    pub findings: Vec<NodeEvent>,
    /// The first boot-up messages, which only a page lists.
    #[serde(skip)]
    pub starts: Vec<NodeEvent>,
    /// The first error frames, which only a page lists.
    #[serde(skip)]
    pub bus_errors: Vec<NodeEvent>,
}

/// The number of frames of a kind.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct KindSums {
    /// The kind.
    pub kind: &'static str,
    /// The number of frames.
    pub frames: u64,
}

/// What was seen of a node.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NodeReport {
    /// The node-ID; 0 for the frames of no node, such as SYNC, NMT and the requests of SDO clients.
    pub node: u8,
    /// The name; absent without a description.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The number of frames that it sent.
    pub frames: u64,
    /// The load of them in percent; absent without a bit rate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load: Option<f64>,
    /// Frames in a second.
    pub frames_per_second: f64,
    /// Its last NMT state; absent without a heartbeat or guarding.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub state: Option<String>,
    /// The number of boot-up messages.
    pub boot_ups: u64,
    /// The number of heartbeats that did not come in time.
    pub lost_heartbeats: u64,
    /// The number of emergencies.
    pub emergencies: u64,
    /// The number of SDO transfers with it that ended with an abort code.
    pub aborted_transfers: u64,
}

/// What was seen of a CAN-ID. Times are in milliseconds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MessageReport {
    /// The CAN-ID.
    pub can_id: u32,
    /// Whether it has 29 bits.
    pub extended: bool,
    /// The kind of its frames.
    pub kind: &'static str,
    /// The node; absent for frames of no node.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<u8>,
    /// What it is: `drive TPDO 1`.
    pub name: String,
    /// The number of frames.
    pub frames: u64,
    /// The distances between its frames; absent without two frames, and for frames without a cycle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<CycleReport>,
    /// The cycle that the descriptions state; absent if they state none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub described: Option<String>,
}

/// Distances between frames in milliseconds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CycleReport {
    /// The shortest.
    pub min: String,
    /// The mean.
    pub mean: String,
    /// The longest.
    pub max: String,
    /// The difference of both.
    pub jitter: String,
}

/// What was written to a node.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ConfigurationReport {
    /// The node-ID.
    pub node: u8,
    /// Its name.
    pub name: String,
    /// The number of entries that were written.
    pub written: usize,
    /// The number of written entries with the value in the description.
    pub as_described: usize,
    /// The entries with other values: the written value and the described one.
    pub others: Vec<String>,
    /// The configured entries of the description that were not written.
    pub not_written: Vec<String>,
    /// Whether more entries were written than are compared.
    pub is_cut: bool,
}

/// What went wrong on all buses, which is taken out of their reports.
pub fn incidents(reports: &mut [BusReport]) -> Vec<Incident> {
    numbered(reports.iter_mut().flat_map(|report| std::mem::take(&mut report.incidents)).collect())
}

impl BusReport {
    /// What is against the rules in a log.
    pub fn against_rules(&self, log: usize) -> impl Iterator<Item = &NodeEvent> {
        self.findings.iter().filter(move |event| event.moment.log == log)
    }
}

impl BusSums {
    /// The sums beside what the descriptions say.
    pub fn report(&mut self, bus: &Bus<'_>) -> BusReport {
        self.close(bus);
        let seconds = self.seconds();
        let kinds = FrameKind::ALL.iter().zip(self.kinds).filter(|(_, frames)| *frames > 0);
        let kinds = kinds.map(|(kind, frames)| KindSums { kind: kind.name(), frames });
        let listed = [&self.aborts, &self.emergencies];
        let further = listed.iter().map(|history| history.further()).sum();
        let nodes: Vec<NodeReport> =
            (0..NODES as u8).filter_map(|node| self.node(node, bus, seconds)).collect();
        let undescribed = nodes.iter().map(|node| node.node);
        let undescribed = undescribed.filter(|node| *node != 0 && !bus.reader.is_described(*node)).collect();
        let (from, to) = self.span.unwrap_or_default();
        let mut findings = self.book.findings.take();
        findings.sort_by_key(|event| event.moment.time);
        BusReport {
            channel: bus.channel.clone(),
            from: from.to_string(),
            to: to.to_string(),
            frames: self.frames,
            error_frames: self.error_frames,
            frames_per_second: rate(self.frames, seconds),
            load: self.load(self.bits, seconds),
            present_load: self.present_load,
            kinds: kinds.collect(),
            undescribed,
            nodes,
            messages: self.messages(bus),
            configurations: self.configurations(bus),
            aborted_transfers: self.aborts.take(),
            emergencies: self.emergencies.take(),
            incidents: with_consequences(&mut self.book, &bus.channel),
            findings,
            starts: self.starts.take(),
            bus_errors: self.bus_errors.take(),
            further_events: further,
        }
    }

    /// What is missing at the end of the log.
    fn close(&mut self, bus: &Bus<'_>) {
        let Some((_, end)) = self.span else { return };
        let end = end.nanoseconds();
        for node_id in 1..=127_u8 {
            let node = &mut self.nodes[usize::from(node_id)];
            let subject = Subject::new(&rules::LATE_HEARTBEAT, node_id, 1);
            let limit = node.heartbeat_limit();
            let Some((last, limit)) = node.last_heartbeat.clone().zip(limit) else {
                self.close_silent(node_id, end, bus);
                continue;
            };
            let gap = end.saturating_sub(last.time.nanoseconds());
            if gap > limit {
                node.lost += 1;
                let name = bus.reader.name(node_id);
                self.book.against(subject, last, || lost(&name, gap, limit) + ", until the end of the log");
            } else {
                self.close_pdos(node_id, end, bus);
            }
        }
        self.conduct.close(end, bus, &mut self.book);
        self.close_sync(end);
    }

    /// Cyclic PDOs of a node that goes on end.
    fn close_pdos(&mut self, node_id: u8, end: i64, bus: &Bus<'_>) {
        let changed = self.nodes[usize::from(node_id)].stopped.max(self.conduct.changed(node_id));
        let own = self.messages.iter().filter(|message| message.node_id == Some(node_id));
        let silent = own.filter_map(|message| {
            let last = message.last.clone()?;
            let at = last.nanoseconds();
            let has_reason = changed.is_some_and(|changed| changed >= at.saturating_sub(SECOND))
                || self.is_without_sync(at, end);
            Some((message.silence(end, bus).filter(|_| !has_reason)?, last, message.can_id))
        });
        let silent: Vec<_> = silent.collect();
        for (text, last, about) in silent {
            let subject = Subject::new(&rules::SILENT_NODE, node_id, about);
            self.book.against(subject, last.seen(), || text + ", until the end of the log");
        }
    }

    /// A node without heartbeats whose regular PDOs end.
    fn close_silent(&mut self, node_id: u8, end: i64, bus: &Bus<'_>) {
        let node = &self.nodes[usize::from(node_id)];
        let Some(last) = &node.last else { return };
        // a command may come before the last frames that are to be sent
        let at = last.nanoseconds();
        let has_reason = node.stopped.is_some_and(|stopped| stopped >= at.saturating_sub(SECOND))
            || self.is_without_sync(at, end);
        let own = self.messages.iter().filter(|message| message.node_id == Some(node_id));
        let period = own
            .filter(|message| message.is_cyclic())
            .filter_map(|message| message.steady.regular(SYNCS))
            .max();
        let gap = end.saturating_sub(at);
        if let Some(period) =
            period.filter(|period| !has_reason && gap > SECOND.max(period.saturating_mul(10)))
        {
            let [gap, period] = [gap, period].map(milliseconds);
            let name = bus.reader.name(node_id);
            let text = || {
                format!(
                    "{name}: nothing for {gap} ms, its PDOs came every {period} ms, until the end of the log"
                )
            };
            self.book.against(Subject::new(&rules::SILENT_NODE, node_id, 1), last.seen(), text);
        }
    }

    /// Whether SYNC ended before a time, or about with it, and did not come again.
    fn is_without_sync(&self, at: i64, end: i64) -> bool {
        let last = self.last_sync.as_ref().map(LastFrame::nanoseconds);
        last.is_some_and(|last| end.saturating_sub(last) > SECOND && last <= at.saturating_add(SECOND))
    }

    fn close_sync(&mut self, end: i64) {
        let Some(last) = self.last_sync.as_ref().map(LastFrame::seen) else { return };
        let at = last.time.nanoseconds();
        let has_reason = self
            .nodes
            .iter()
            .any(|node| node.stopped.is_some_and(|stopped| stopped >= at.saturating_sub(SECOND)));
        let period = self.sync_period.or_else(|| self.syncs.regular(SYNCS)).filter(|_| !has_reason);
        let gap = end.saturating_sub(at);
        if let Some(period) = period.filter(|period| gap > SECOND.max(period.saturating_mul(10))) {
            let [gap, period] = [gap, period].map(milliseconds);
            let text =
                || format!("no SYNC for {gap} ms, its period is {period} ms, until the end of the log");
            self.book.against(Subject::new(&rules::SYNC_CYCLE, 0, 2), last, text);
        }
    }

    fn seconds(&self) -> f64 {
        let (from, to) = self.span.unwrap_or_default();
        to.nanoseconds().saturating_sub(from.nanoseconds()) as f64 / 1e9
    }

    fn load(&self, bits: u64, seconds: f64) -> Option<f64> {
        let bits_per_second = f64::from(self.bit_rate?) * 1000.0;
        Some(rounded(rate(bits, seconds) * 100.0 / bits_per_second))
    }

    fn node(&self, node_id: u8, bus: &Bus<'_>, seconds: f64) -> Option<NodeReport> {
        let node = &self.nodes[usize::from(node_id)];
        let is_described = bus.reader.is_described(node_id);
        (node.frames + node.aborts > 0 || is_described).then(|| NodeReport {
            node: node_id,
            name: is_described.then(|| bus.reader.name(node_id)),
            frames: node.frames,
            load: self.load(node.bits, seconds),
            frames_per_second: rate(node.frames, seconds),
            state: node.state.map(nmt_state),
            boot_ups: node.boot_ups,
            lost_heartbeats: node.lost,
            emergencies: node.emergencies,
            aborted_transfers: node.aborts,
        })
    }

    fn messages(&self, bus: &Bus<'_>) -> Vec<MessageReport> {
        let mut messages: Vec<&MessageSums> = self.messages.iter().collect();
        messages.sort_by_key(|message| (message.is_extended, message.can_id));
        let sync = sync_period(bus);
        messages.into_iter().map(|message| message.report(bus, sync)).collect()
    }

    /// What was written to the nodes with a description.
    fn configurations(&self, bus: &Bus<'_>) -> Vec<ConfigurationReport> {
        let mut reports: Vec<ConfigurationReport> = Vec::new();
        for (&(node_id, index, sub), bytes) in &self.written {
            let Some(described) = bus.description(node_id) else { continue };
            if reports.last().is_none_or(|report| report.node != node_id) {
                reports.push(ConfigurationReport {
                    node: node_id,
                    name: bus.reader.name(node_id),
                    written: 0,
                    as_described: 0,
                    others: Vec::new(),
                    not_written: self.not_written(node_id, described, bus),
                    is_cut: self.is_written_cut,
                });
            }
            let Some(report) = reports.last_mut() else { continue };
            report.written += 1;
            let stated = stated(described, node_id, index, sub);
            if stated.as_deref().map(kept) == Some(bytes) {
                report.as_described += 1;
            } else if report.others.len() < MAX_LISTED && is_setting(described, index, sub) {
                let said = stated.map_or_else(|| "no value".to_owned(), |bytes| raw_bytes(&bytes));
                let entry = bus.reader.entry_name(node_id, (index, sub));
                report.others.push(format!("{entry}: wrote {}, expected {said}", raw_bytes(bytes)));
            }
        }
        reports
    }

    /// The entries that a DCF configures and that were not written.
    fn not_written(&self, node_id: u8, described: &DescribedNode, bus: &Bus<'_>) -> Vec<String> {
        let entries = described.device.objects.iter().filter(|_| described.is_configured).flat_map(
            |(&index, object)| {
                let changed = object.entries().filter(|(_, entry)| entry.is_changed(Some(node_id)));
                changed.map(move |(sub, _)| (index, sub)).collect::<Vec<_>>()
            },
        );
        let missing = entries.filter(|(index, sub)| !self.written.contains_key(&(node_id, *index, *sub)));
        missing.take(MAX_LISTED).map(|entry| bus.reader.entry_name(node_id, entry)).collect()
    }
}

/// The most entries of a list.
const MAX_LISTED: usize = 100;

impl MessageSums {
    fn report(&self, bus: &Bus<'_>, sync: Option<u32>) -> MessageReport {
        let has_cycle =
            matches!(self.kind, FrameKind::Sync | FrameKind::Time | FrameKind::Pdo | FrameKind::Heartbeat);
        let mean = self.cycle.mean().filter(|_| has_cycle || self.kind == FrameKind::Unknown);
        let cycle = mean.map(|mean| CycleReport {
            min: milliseconds(self.cycle.shortest),
            mean: milliseconds(mean),
            max: milliseconds(self.cycle.longest),
            jitter: milliseconds(self.cycle.longest - self.cycle.shortest),
        });
        let service = match self.kind {
            FrameKind::Unknown | FrameKind::Lss => String::new(),
            FrameKind::Guarding => "guarding".to_owned(),
            _ => self.service.map_or_else(String::new, |service| service.to_string()),
        };
        let name = match self.node_id {
            Some(node_id) if self.kind != FrameKind::Nmt => format!("{} {service}", bus.reader.name(node_id)),
            _ => service,
        };
        MessageReport {
            can_id: self.can_id,
            extended: self.is_extended,
            kind: self.kind.name(),
            node: self.node_id,
            name: name.trim_end().to_owned(),
            frames: self.cycle.frames,
            cycle,
            described: self.described(bus, sync),
        }
    }

    /// The cycle that the descriptions state.
    fn described(&self, bus: &Bus<'_>, sync: Option<u32>) -> Option<String> {
        let device = || bus.reader.device(self.node_id?);
        match (self.kind, self.service) {
            (FrameKind::Sync, _) => sync.map(|period| milliseconds(i64::from(period) * 1000) + " ms"),
            (FrameKind::Heartbeat, _) => {
                let time = device()?.services().heartbeat_time.filter(|time| *time != 0)?;
                Some(format!("{time} ms"))
            }
            (FrameKind::Pdo, Some(Service::Pdo(pdo))) if self.is_described => {
                described_cycle(&device()?.pdo(pdo.kind, pdo.number)?, sync)
            }
            _ => None,
        }
    }
}

/// When a PDO is sent.
fn described_cycle(pdo: &Pdo<'_>, sync: Option<u32>) -> Option<String> {
    if pdo.kind == PdoKind::Rpdo {
        return None;
    }
    let cycle = |count: u8| {
        let period =
            sync.map(|period| format!(" ({} ms)", milliseconds(i64::from(period) * 1000 * i64::from(count))));
        period.unwrap_or_default()
    };
    match pdo.transmission_type? {
        0 => Some("after SYNC, on events".to_owned()),
        1 => Some(format!("each SYNC{}", cycle(1))),
        count @ 2..=240 => Some(format!("each {count} SYNCs{}", cycle(count))),
        252 | 253 => Some("on request".to_owned()),
        254 | 255 => {
            let inhibit = pdo.inhibit_time.filter(|time| *time != 0);
            let timer = pdo.event_timer.filter(|time| *time != 0);
            let parts = [
                inhibit.map(|time| format!("at least {} ms", f64::from(time) / 10.0)),
                timer.map(|time| format!("at most {time} ms")),
            ];
            let parts: Vec<String> = parts.into_iter().flatten().collect();
            Some(if parts.is_empty() { "on events".to_owned() } else { parts.join(", ") })
        }
        _ => None,
    }
}

/// The period of SYNC in microseconds: that of the node that produces it.
pub(super) fn sync_period(bus: &Bus<'_>) -> Option<u32> {
    let services = bus.reader.node_ids().filter_map(|node_id| Some(bus.reader.device(node_id)?.services()));
    let periods = services.filter_map(|services| {
        let is_producer = services.sync.is_some_and(CobId::bit_30);
        Some((is_producer, services.communication_cycle_period.filter(|period| *period != 0)?))
    });
    periods.max_by_key(|(is_producer, _)| *is_producer).map(|(_, period)| period)
}

/// Whether a value of an entry is a setting: commands and process values are not compared.
fn is_setting(described: &DescribedNode, index: u16, sub: u8) -> bool {
    let is_configured = || {
        let entry = described.device.entry(index, sub);
        entry.is_some_and(|entry| entry.configured_value().is_some())
    };
    (0x1000..0x2000).contains(&index) && !matches!(index, 0x1003 | 0x1010 | 0x1011 | 0x1F50..=0x1F57)
        || is_configured()
}

/// The bytes of a value that a description states.
fn stated(described: &DescribedNode, node_id: u8, index: u16, sub: u8) -> Option<Vec<u8>> {
    let object = described.device.object(index)?;
    let value = object.value(sub)?;
    let data_type = object.entry(sub)?.implied_type()?;
    value.resolve(data_type, node_id).unwrap_or_else(|| value.clone().into_owned()).to_bytes(data_type)
}

fn rate(count: u64, seconds: f64) -> f64 {
    if seconds > 0.0 { rounded(count as f64 / seconds) } else { 0.0 }
}

/// A number with three digits behind the point.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}
