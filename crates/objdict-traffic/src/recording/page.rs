//! The page of a recording and of the sums that go with it.

use super::{Course, Plot, Recording};
use crate::{BusReport, Buses, Incident, NodeEvent};
use objdict_document::{
    TrafficBus, TrafficCourse, TrafficEvent, TrafficEvents, TrafficLane, TrafficPage, TrafficPlot,
    TrafficTable,
};
use objdict_model::diagnostic::plural;

/// The most events of a kind on a page.
const MAX_EVENTS: usize = 1000;

/// What is said on a page in words and in tables.
pub struct PageTexts {
    /// The names of the logs.
    pub title: String,
    /// What all logs have.
    pub summary: String,
    /// The title, the tables and the remarks of each bus.
    pub buses: Vec<(String, Vec<TrafficTable>, Vec<String>)>,
}

impl Recording {
    /// The signals that are drawn.
    pub fn plots(&self, buses: &Buses<'_>) -> Vec<TrafficPlot<'_>> {
        self.plots.iter().map(|plot| plot.drawn(buses)).collect()
    }

    /// The page of what was recorded.
    pub fn html(
        &self,
        texts: PageTexts,
        reports: &[BusReport],
        incidents: &[Incident],
        buses: &Buses<'_>,
    ) -> String {
        let drawn = texts.buses.into_iter().zip(reports).enumerate().map(
            |(at, ((title, tables, remarks), report))| {
                let (node_ids, lanes) = self.lanes_of(at, buses);
                let mut events = events(report, &node_ids);
                events.insert(0, listed(incidents, &report.channel, &node_ids));
                TrafficBus { title, lanes, events, tables, remarks }
            },
        );
        TrafficPage {
            title: texts.title,
            summary: texts.summary,
            density: &self.density,
            buses: drawn.collect(),
            plots: self.plots(buses),
            left_out: self.left_out(),
        }
        .html()
    }

    /// The node-IDs of a bus and their lanes.
    fn lanes_of(&self, at: usize, buses: &Buses<'_>) -> (Vec<u8>, Vec<TrafficLane<'_>>) {
        let own = self.lanes.iter().filter(|((of, _), _)| *of == at);
        let lane = |(&(_, node_id), &lane): (&(usize, u8), &usize)| {
            let name = match buses.all.get(at).filter(|_| node_id != 0) {
                Some(bus) if bus.reader.is_described(node_id) => {
                    format!("{node_id} {}", bus.reader.name(node_id))
                }
                Some(bus) => bus.reader.name(node_id),
                None => "no node".to_owned(),
            };
            (node_id, TrafficLane { name, lane, states: self.states.get(&(at, node_id)) })
        };
        own.map(lane).unzip()
    }

    /// Which signals are not drawn.
    fn left_out(&self) -> String {
        let mut sentences = Vec::new();
        let (names, count) = &self.left_out;
        if *count > 0 {
            let more = if names.len() < *count { ", …" } else { "" };
            sentences.push(format!(
                "{} of {} are drawn, not {}{more}. `--plot` chooses others.",
                self.plots.len(),
                plural(self.plots.len() + count, "signal"),
                names.join(", ")
            ));
        }
        let unused: Vec<String> = self.unused().map(|text| format!("`{text}`")).collect();
        if !unused.is_empty() {
            sentences.push(format!("The log has no value of {}.", unused.join(", ")));
        }
        if self.plots.is_empty() && self.choices.is_empty() {
            sentences.push("No signal of a PDO changes. `--plot` draws others.".to_owned());
        }
        if self.density.left_out() > 0 {
            sentences.push(format!(
                "{} frames of further nodes are not in the time line.",
                self.density.left_out()
            ));
        }
        sentences.join(" ")
    }
}

impl Plot {
    fn drawn(&self, buses: &Buses<'_>) -> TrafficPlot<'_> {
        let (at, node_id, ..) = self.key;
        let bus = buses.all.get(at);
        let channel =
            bus.filter(|_| buses.all.len() > 1).map_or(String::new(), |bus| format!("{} ", bus.channel));
        let node = bus.map_or_else(String::new, |bus| bus.reader.name(node_id));
        TrafficPlot {
            name: format!("{channel}{node}: {}", self.name),
            unit: self.unit.clone(),
            course: match &self.course {
                Course::Numbers(curve) => TrafficCourse::Numbers(curve),
                Course::States(bands) => TrafficCourse::States(bands),
            },
        }
    }
}

/// The events of a report with their marks.
fn events(report: &BusReport, node_ids: &[u8]) -> Vec<TrafficEvents> {
    let lists = [
        ("Aborted transfers", "abort", &report.aborted_transfers),
        ("Emergencies", "emcy", &report.emergencies),
        ("Boot-ups", "boot-up", &report.starts),
        ("Error frames", "error", &report.bus_errors),
    ];
    let list = |(title, class, events): (_, _, &Vec<NodeEvent>)| TrafficEvents {
        title,
        class,
        events: events.iter().take(MAX_EVENTS).map(|event| shown(event, node_ids)).collect(),
        further: events.len().saturating_sub(MAX_EVENTS) as u64,
    };
    lists.map(list).into()
}

/// The incidents of a bus with their numbers.
fn listed(incidents: &[Incident], channel: &str, node_ids: &[u8]) -> TrafficEvents {
    let own = incidents.iter().filter(|incident| incident.channel == channel);
    let shown = own.map(|incident| TrafficEvent {
        time: incident.start.nanoseconds(),
        shown_time: incident.start.to_string(),
        lane: node_ids.iter().position(|node_id| Some(node_id) == incident.nodes.first()),
        text: format!("{} {}: {}", incident.number, incident.state.name(), incident.text),
        rule: incident.kind.rule.id,
    });
    let events: Vec<TrafficEvent> = shown.take(MAX_EVENTS).collect();
    TrafficEvents { title: "Incidents", class: "deviation", events, further: 0 }
}

fn shown(event: &NodeEvent, node_ids: &[u8]) -> TrafficEvent {
    TrafficEvent {
        time: event.moment.time.nanoseconds(),
        shown_time: event.moment.time.to_string(),
        lane: node_ids.iter().position(|node_id| *node_id == event.node),
        text: event.text.clone(),
        rule: event.rule.map_or("", |rule| rule.id),
    }
}
