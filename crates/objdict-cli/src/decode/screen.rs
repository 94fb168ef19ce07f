//! What a bus does now, on a terminal: nodes, states, load and open incidents.

use std::io::{self, IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::super::table::{TextTable, fit};
use super::incidents;
use super::summary::{node_rows, title};
use objdict_traffic as traffic;
use objdict_traffic::{Bus, BusReport, BusSums};

/// The screen changes no more often.
const PACE: Duration = Duration::from_millis(500);

/// A bus without a frame for so long is said to be silent.
const SILENCE: Duration = Duration::from_secs(2);

/// The size of a terminal that does not say it.
const SIZE: (usize, usize) = (80, 24);

/// The headings of the nodes, which are some of those of the summary.
const NODES: [&str; 8] = ["Node", "Name", "State", "Load", "Boot-ups", "Lost", "EMCY", "Aborts"];

/// The lines of a screen with so many columns and rows: the verdict, then each bus with its nodes, then the incidents, the open ones first. The
/// reports keep their incidents.
pub(crate) fn lines(reports: &mut [BusReport], (columns, rows): (usize, usize)) -> Vec<String> {
    let incidents = traffic::incidents(reports);
    let mut text = Vec::new();
    // writing to memory cannot fail
    let _ = incidents::write(&traffic::verdict(&incidents), &incidents, &mut text);
    let of_incidents = String::from_utf8_lossy(&text).replace(", until the end of the log", ", until now");
    let mut of_incidents = of_incidents.lines().map(str::to_owned);
    let mut lines: Vec<String> = of_incidents.next().into_iter().collect();
    for incident in incidents {
        if let Some(report) = reports.iter_mut().find(|report| report.channel == incident.channel) {
            report.incidents.push(incident);
        }
    }
    for report in reports {
        let mut table = TextTable::new(NODES, columns);
        for [node, name, _, _, load, state, boot_ups, lost, emergencies, aborts] in node_rows(report) {
            table.row([node, name, state, load, boot_ups, lost, emergencies, aborts]);
        }
        let mut text = Vec::new();
        let _ = table.write(&mut text);
        let present = report.load.map_or_else(String::new, |_| format!(", now {:.1} %", report.present_load));
        lines.extend([String::new(), title(report) + &present]);
        lines.extend(String::from_utf8_lossy(&text).lines().map(str::to_owned));
    }
    lines.extend(of_incidents);
    if lines.len() > rows {
        lines.truncate(rows.saturating_sub(1));
        lines.push("…".to_owned());
    }
    lines.iter().map(|line| fit(line, columns)).collect()
}

/// A terminal that shows a bus. A thread reports when no more frames arrive.
pub(crate) struct Screen {
    state: Arc<Mutex<State>>,
    ticker: Option<(Sender<()>, JoinHandle<()>)>,
    /// The last report of each bus, and when it is due again by its position.
    reports: Vec<BusReport>,
    due: Vec<Instant>,
}

struct State {
    lines: Vec<String>,
    frame: Instant,
}

impl Screen {
    /// The screen of the standard output; `None` if that is no terminal.
    pub(crate) fn of_terminal() -> Option<Self> {
        let is_dumb = std::env::var_os("TERM").is_none_or(|term| term == "dumb");
        if is_dumb || !io::stdout().is_terminal() {
            return None;
        }
        let now = Instant::now();
        let state = Arc::new(Mutex::new(State { lines: Vec::new(), frame: now }));
        let (sender, end) = channel();
        let own = state.clone();
        let ticker = thread::spawn(move || {
            while end.recv_timeout(PACE) == Err(RecvTimeoutError::Timeout) {
                let state = own.lock().unwrap_or_else(PoisonError::into_inner);
                if state.frame.elapsed() > SILENCE && !state.lines.is_empty() {
                    state.draw(&mut io::stdout());
                }
            }
        });
        Some(Self { state, ticker: Some((sender, ticker)), reports: Vec::new(), due: Vec::new() })
    }

    /// A frame of the bus at a position has come: shows it if it is time to do so.
    pub(super) fn update(screen: &mut Option<Self>, at: usize, sums: &BusSums, bus: &Bus<'_>) {
        let Some(screen) = screen else { return };
        let now = Instant::now();
        while screen.due.len() <= at {
            screen.due.push(now + PACE);
        }
        if now >= screen.due[at] {
            screen.due[at] = now + PACE;
            screen.show(sums.clone().report(bus));
        }
    }

    /// Shows a bus below the others.
    fn show(&mut self, report: BusReport) {
        match self.reports.iter_mut().find(|known| known.channel == report.channel) {
            Some(known) => *known = report,
            None => self.reports.push(report),
        }
        let size = terminal_size::terminal_size_of(io::stdout());
        let size = size.map_or(SIZE, |(columns, rows)| (columns.0.into(), rows.0.into()));
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let lines = lines(&mut self.reports, (size.0, size.1.saturating_sub(1)));
        *state = State { lines, frame: Instant::now() };
        state.draw(&mut io::stdout());
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.ticker.take() {
            drop(sender);
            let _ = thread.join(); // it fails only by a panic, and then there is no line
        }
    }
}

impl State {
    /// Writes the lines over those before. Nothing has to be restored when the program ends.
    fn draw(&self, out: &mut dyn Write) {
        let silent = self.frame.elapsed();
        let mut text = String::from("\x1B[H");
        for (at, line) in self.lines.iter().enumerate() {
            text.push_str(line);
            if at == 0 && silent > SILENCE {
                text.push_str(&format!(" (no frame for {} s)", silent.as_secs()));
            }
            text.push_str("\x1B[K\n");
        }
        // there is no other place to report an error of this
        let _ = out.write_all((text + "\x1B[J").as_bytes()).and_then(|()| out.flush());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_traffic::log::LogOptions;
    use objdict_traffic::{Buses, Descriptions, MergedLogs, NamedLog};

    fn shown(log: &str, size: (usize, usize)) -> Vec<String> {
        let descriptions = Descriptions::default();
        let mut buses = Buses::new(&[], &descriptions);
        let mut logs =
            MergedLogs(vec![NamedLog::new("log".to_owned(), log.as_bytes(), LogOptions::default())]);
        let mut sums: Vec<BusSums> = Vec::new();
        while let Some((log, frame)) = logs.next_frame().unwrap() {
            let at = buses.of(log, &frame, &logs);
            let decoded = buses.all[at].decode(&frame);
            sums.resize_with(sums.len().max(at + 1), || BusSums::new(Some(125)));
            sums[at].add(&decoded, &frame, logs.origin(log), &buses.all[at]);
        }
        // the sums go on after a report of a copy
        let reports = sums.iter().zip(&buses.all).map(|(sums, bus)| sums.clone().report(bus));
        let mut reports: Vec<BusReport> = reports.collect();
        let first = lines(&mut reports, size);
        assert_eq!(lines(&mut reports, size), first, "the reports keep their incidents");
        first
    }

    #[test]
    fn a_screen_has_the_verdict_the_nodes_and_the_incidents() {
        let beats = (10..20).map(|at| format!("({}.{}) can0 705#05\n", at / 10, at % 10)).collect::<String>();
        let log = beats + "(2.5) can1 706#7F\n(3.0) can0 707#05\n(3.1) can0 707#05\n";
        let expected = [
            "Needs attention: 1 unresolved",
            "",
            "can0: 12 frames from 1.0 to 3.1, 5.7 frames/s, 0.27 % load, now 0.1 %",
            "Node  State        Load    Lost",
            "5     operational  0.23 %  1",
            "7     operational  0.04 %",
            "",
            "can1: 1 frame from 2.5 to 2.5, 0.0 frames/s, 0.00 % load, now 0.0 %",
            "Node  State            Load",
            "6     pre-operational  0.00 %",
            "",
            "Unresolved:",
            "   1  1.9  can0: node 5: no heartbeat for 1200.000 ms, limit 300.000 ms, until …",
        ];
        assert_eq!(shown(&log, (80, 40)), expected);
        let small = shown(&log, (40, 4));
        assert_eq!(small, [expected[0], expected[1], "can0: 12 frames from 1.0 to 3.1, 5.7 fr…", "…"]);
    }

    #[test]
    fn a_bus_that_is_silent_is_said_to_be() {
        let frame = Instant::now().checked_sub(Duration::from_secs(5)).unwrap();
        let state = |frame| State { lines: vec!["No incidents".to_owned(), "can0".to_owned()], frame };
        let drawn = |state: State| {
            let mut out = Vec::new();
            state.draw(&mut out);
            String::from_utf8(out).unwrap()
        };
        let text = "\x1B[HNo incidents (no frame for 5 s)\x1B[K\ncan0\x1B[K\n\x1B[J";
        assert_eq!(drawn(state(frame)), text);
        assert_eq!(drawn(state(Instant::now())), text.replace(" (no frame for 5 s)", ""));
    }
}
