//! `objdict network timing`.

mod document;

use std::io::{self, Write};

pub(crate) use self::document::TimingJson;
use super::super::args::{NetworkTimingArgs, ShowFormat};
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::super::table::{TextTable, fit};
use super::super::written_files::save;
use super::{resolved, source_names_of};
use objdict_model::diagnostic::plural;
use objdict_network::{
    DeadlineKind, Load, Remedy, TimedMessage, Timing, TimingOptions, TrafficKind, timeline,
};

/// The most characters of a cell.
const CELL: usize = 72;

pub(super) fn run(args: &NetworkTimingArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let resolved = resolved(&args.files, &args.input)?;
    let options = TimingOptions {
        bit_rate: args.bit_rate,
        response_time: args.response_time,
        node_delay: args.node_delay,
        event_distance: args.inhibit_time,
        sdo: !args.no_sdo,
        emergencies: args.emergencies,
        allow_unbounded: args.allow_unbounded,
    };
    let timing = Timing::new(resolved.network(), resolved.compiled(), &options);
    let none = || Failure::new("the network has no bit rate").help("name one: `--bit-rate 250`");
    let timing = timing.ok_or_else(none)?;
    if let Some(path) = &args.svg {
        save(path, (timeline::svg(&timing, |can_id| can_id.to_string()) + "\n").as_bytes())?;
    }
    match args.format {
        ShowFormat::Json => {
            let names = source_names_of(&args.files);
            let document = TimingJson::new(&names, &timing, &options);
            out.json(&document)?;
        }
        ShowFormat::Table => TimingReport { timing: &timing, options: &options }.write(out)?,
    }
    Ok(if timing.is_met(&options) { Outcome::Clean } else { Outcome::Findings })
}

struct TimingReport<'t> {
    timing: &'t Timing,
    options: &'t TimingOptions,
}

impl TimingReport<'_> {
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        self.summary(out)?;
        writeln!(out)?;
        self.messages(out)?;
        self.sync(out)?;
        self.remedies(out)?;
        self.loads(out)?;
        self.rates(out)?;
        self.boot(out)
    }

    fn summary(&self, out: &mut dyn Write) -> io::Result<()> {
        let Timing { load, bit_rate, name, .. } = self.timing;
        let name = fit(name.as_deref().unwrap_or("network without a name"), CELL);
        let [average, worst] = percents(load, *bit_rate);
        writeln!(out, "{name} at {bit_rate} kbit/s: load {average} on average, {worst} in the worst case")?;
        let sdo = match self.options.sdo {
            true => format!(
                "one SDO transfer at a time, with responses after {}",
                milliseconds(self.options.response_time)
            ),
            false => "no SDO transfers".to_owned(),
        };
        let rest = if self.options.emergencies { "" } else { " EMCY," };
        writeln!(out, "Assumed: {sdo}. Not counted:{rest} NMT, TIME, boot-up")?;
        self.unbounded(out)
    }

    /// PDOs without inhibit time.
    fn unbounded(&self, out: &mut dyn Write) -> io::Result<()> {
        let names = |message: &TimedMessage| message.can_id.to_string();
        let pdos: Vec<String> = self.timing.unbounded().map(names).collect();
        if pdos.is_empty() {
            return Ok(());
        }
        let (has, they) = if pdos.len() == 1 { ("has", "it") } else { ("have", "they") };
        let names = fit(&pdos.join(", "), CELL);
        writeln!(out, "Unbounded: {names} {has} no inhibit time, so {they} may fill the bus")?;
        match self.timing.inhibit_time {
            Some(tenths) => {
                let time = milliseconds(u64::from(tenths) * 100_000);
                writeln!(
                    out,
                    "  help: with an inhibit time of {time} or more, all messages meet their deadlines"
                )
            }
            None => writeln!(out, "  help: no inhibit time is enough at this bit rate"),
        }
    }

    fn messages(&self, out: &mut dyn Write) -> io::Result<()> {
        let headings = [
            "CAN-ID", "Message", "From", "To", "Bytes", "Bits", "Period", "Jitter", "Response", "Deadline",
            "Slack",
        ];
        let mut table = TextTable::new(headings, CELL);
        for message in &self.timing.messages {
            let time = |time: Option<u64>| time.map(milliseconds).unwrap_or_default();
            let [least, most] = message.bits;
            table.row([
                message.can_id.to_string(),
                message.name.clone(),
                message.sender.node.clone(),
                receivers(message),
                message.bytes.to_string(),
                format!("{least}-{most}"),
                period(message),
                time(Some(message.jitter).filter(|jitter| *jitter != 0)),
                response(message),
                message.deadline.map(deadline).unwrap_or_default(),
                slack(message),
            ]);
        }
        table.write(out)
    }

    fn sync(&self, out: &mut dyn Write) -> io::Result<()> {
        let Some(sync) = &self.timing.sync else { return Ok(()) };
        let (limit, what) = (milliseconds(sync.limit()), if sync.window == 0 { "period" } else { "window" });
        writeln!(out)?;
        match sync.needed {
            None => {
                writeln!(out, "SYNC: its PDOs may exceed the {what} of {limit} without limit")
            }
            Some(needed) => {
                let fits = if sync.fits() == Some(true) { "within" } else { "more than" };
                let needed = milliseconds(needed);
                writeln!(
                    out,
                    "SYNC: all its PDOs are on the bus after {needed}, {fits} the {what} of {limit}"
                )
            }
        }
    }

    fn remedies(&self, out: &mut dyn Write) -> io::Result<()> {
        let late = self.timing.messages.iter().filter(|message| message.is_missed()).count();
        if late == 0 {
            return Ok(());
        }
        writeln!(out, "\n{} may be late\n", plural(late, "message"))?;
        for remedy in &self.timing.remedies {
            let message = &self.timing.messages[remedy.message];
            writeln!(
                out,
                "{} ({}): {}",
                message.can_id,
                fit(&format!("{} of {}", message.name, message.sender.node), CELL),
                help(remedy, message.deadline)
            )?;
        }
        Ok(())
    }

    fn loads(&self, out: &mut dyn Write) -> io::Result<()> {
        let bit_rate = self.timing.bit_rate;
        let row = |name: &str, load: &Load| {
            let [average, worst] = percents(load, bit_rate);
            [name.to_owned(), average, bits(load.average), worst, bits(load.worst)]
        };
        let headings = |of| [of, "Average", "", "Worst case", ""];
        let mut nodes = TextTable::new(headings("Load of"), CELL);
        self.timing.nodes.iter().for_each(|share| nodes.row(row(&share.of.node, &share.load)));
        let mut kinds = TextTable::new(headings("Load by"), CELL);
        self.timing.kinds.iter().for_each(|share| kinds.row(row(kind(share.of), &share.load)));
        kinds.row(row("all messages", &self.timing.load));
        writeln!(out)?;
        nodes.write(out)?;
        writeln!(out)?;
        kinds.write(out)
    }

    fn rates(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "\nBit rates\n")?;
        let mut table = TextTable::new(["kbit/s", "Average", "Worst case", ""], CELL);
        for row in &self.timing.rates {
            let [average, worst] = percents(&row.load, row.bit_rate);
            let verdict = match row.missed {
                _ if row.fits() => "fits".to_owned(),
                0 => "overload".to_owned(),
                late => format!("{} late", plural(late, "message")),
            };
            table.row([row.bit_rate.to_string(), average, worst, verdict]);
        }
        table.write(out)?;
        let without = match self.timing.unbounded().next() {
            Some(_) => ", without the PDOs that have no inhibit time",
            None => "",
        };
        match self.timing.fits_from() {
            Some(rate) => writeln!(out, "\nThe network fits from {rate} kbit/s on{without}"),
            None => writeln!(out, "\nThe network fits at no bit rate{without}"),
        }
    }

    fn boot(&self, out: &mut dyn Write) -> io::Result<()> {
        let Some(boot) = self.timing.boot.as_ref().filter(|boot| !boot.nodes.is_empty()) else {
            return Ok(());
        };
        writeln!(out, "\nConfiguration at boot\n")?;
        let mut table =
            TextTable::new(["Node", "Name", "", "Downloads", "Frames", "With responses", "Limit", ""], CELL);
        for node in &boot.nodes {
            let is_limited = node.is_mandatory && boot.limit != 0;
            table.row([
                node.node_id.to_string(),
                node.name.clone(),
                if node.is_mandatory { "mandatory" } else { "" }.to_owned(),
                node.downloads.to_string(),
                milliseconds(node.bus),
                milliseconds(node.total),
                if is_limited { milliseconds(boot.limit) } else { String::new() },
                if boot.is_late(node) { "late" } else { "" }.to_owned(),
            ]);
        }
        table.write(out)?;
        let bus = milliseconds(boot.bus());
        writeln!(
            out,
            "\nThe frames of all configurations take {bus}; `objdict network boot` simulates the boot"
        )
    }
}

/// Nanoseconds as milliseconds, without zeros at the end.
pub(super) fn milliseconds(time: u64) -> String {
    let (whole, rest) = (time / 1_000_000, time % 1_000_000);
    match rest {
        0 => format!("{whole} ms"),
        rest => format!("{whole}.{} ms", format!("{rest:06}").trim_end_matches('0')),
    }
}

fn period(message: &TimedMessage) -> String {
    match (message.period, message.is_cyclic) {
        (Some(period), true) => milliseconds(period),
        (Some(distance), false) => format!("≥ {}", milliseconds(distance)),
        (None, _) if message.is_unbounded => "any time".to_owned(),
        (None, _) => String::new(),
    }
}

fn response(message: &TimedMessage) -> String {
    match (message.response, message.unbounded_by) {
        (Some(response), _) => milliseconds(response),
        (None, Some(cause)) if cause != message.can_id => format!("unbounded ({cause})"),
        (None, _) if message.waits_for_sdo => "unbounded (SDO)".to_owned(),
        (None, _) => "unbounded".to_owned(),
    }
}

/// The nodes that receive a message: the name of one, else their number.
fn receivers(message: &TimedMessage) -> String {
    match message.receivers.as_slice() {
        [] => String::new(),
        [first, rest @ ..] if rest.iter().all(|end| end.position == first.position) => first.node.clone(),
        all => plural(all.len(), "node"),
    }
}

fn deadline((time, kind): (u64, DeadlineKind)) -> String {
    let why = match kind {
        DeadlineKind::Period => "period",
        DeadlineKind::EventTimer => "event timer",
        DeadlineKind::SyncWindow => "window",
        DeadlineKind::Receiver => "receiver",
    };
    format!("{} ({why})", milliseconds(time))
}

fn slack(message: &TimedMessage) -> String {
    match (message.response, message.deadline) {
        (Some(response), Some((deadline, _))) if response > deadline => {
            format!("{} late", milliseconds(response - deadline))
        }
        (Some(response), Some((deadline, _))) => milliseconds(deadline - response),
        _ => String::new(),
    }
}

fn help(remedy: &Remedy, deadline: Option<(u64, DeadlineKind)>) -> String {
    if deadline == Some((0, DeadlineKind::Receiver)) {
        return "increase the receiver's timeout (1016h, or the event timer of its RPDO) above the period"
            .to_owned();
    }
    let rate = remedy.bit_rate.map(|rate| format!("{rate} kbit/s"));
    let before = remedy.before.map(|before| format!("a CAN-ID below {before}"));
    let helps: Vec<String> = rate.into_iter().chain(before).collect();
    match helps.is_empty() {
        true => "lengthen its period, or the periods of the messages before it".to_owned(),
        false => format!("{} would be enough", helps.join(", or ")),
    }
}

const fn kind(kind: TrafficKind) -> &'static str {
    match kind {
        TrafficKind::Nmt => "NMT",
        TrafficKind::Sync => "SYNC",
        TrafficKind::Time => "TIME",
        TrafficKind::Emcy => "EMCY",
        TrafficKind::SynchronousPdo => "synchronous PDOs",
        TrafficKind::EventPdo => "event-driven PDOs",
        TrafficKind::Sdo => "SDO",
        TrafficKind::Heartbeat => "heartbeats",
        TrafficKind::Guarding => "guarding",
    }
}

/// Average and worst case.
fn percents(load: &Load, bit_rate: u16) -> [String; 2] {
    let percent = |percent: u64| format!("{}.{:03} %", percent / 1000, percent % 1000);
    [percent(load.average_percent(bit_rate)), percent(load.worst_percent(bit_rate))]
}

/// Thousandths of a bit each second.
fn bits(load: u64) -> String {
    let tenths = (load + 50) / 100;
    format!("{}.{} bit/s", tenths / 10, tenths % 10)
}
