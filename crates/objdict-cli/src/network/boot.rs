//! `objdict network boot`.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::super::args::{NetworkBootArgs, ShowFormat};
use super::super::ending::{Failure, Outcome, note};
use super::super::input::name_of;
use super::super::stdout::Output;
use super::super::table::{TextTable, fit};
use super::super::written_files::keep;
use super::{open_to_use, source_names_of};
use objdict_bus::{BusFrame, Conditions, Cut, Event, EventKind, Milestone, NodeRun, Run, boot};
use objdict_document::describe::frames::{FrameReader, Talker, nmt_state};
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_model::source;
use objdict_model::source::DEFAULT_MAX_SIZE;
use objdict_network_file::{BuiltFile, InstallError, Installation, install};

/// The most characters of a cell.
const CELL: usize = 72;

/// The most characters of the words for a frame.
const WORDS: usize = 160;

/// The endings of the files that are read of a folder.
const ENDINGS: [&str; 6] = ["dcf", "xdc", "xdd", "eds", "bin", "json"];

/// The most files of a folder.
const FILES: usize = 1000;

pub(super) fn run(args: &NetworkBootArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut installation = installation(args)?;
    if let Some(bit_rate) = args.bit_rate {
        installation.plant.bit_rate = bit_rate;
    }
    let Installation { plant, mut notes } = installation;
    let conditions = Conditions {
        response: args.response_time,
        after: args.run_time,
        limit: args.time_limit,
        ..Conditions::default()
    };
    let run = boot(&plant, &conditions);
    notes.extend(run.not_simulated());
    let report = BootReport { run: &run, bit_rate: plant.bit_rate };
    match args.format {
        ShowFormat::Json => report.json(&source_names_of(&args.files), &notes, args.summary, out)?,
        ShowFormat::Table => {
            notes.iter().for_each(|text| note(&format!("note: {text}\n")));
            if !args.summary {
                report.trace(out)?;
            }
            report.summary(out)?;
        }
    }
    Ok(if run.is_booted() { Outcome::Clean } else { Outcome::Findings })
}

fn installation(args: &NetworkBootArgs) -> Result<Installation, Failure> {
    if let Some(path) = args.files.iter().find(|path| std::fs::metadata(path).is_err()) {
        let failure = Failure::new(format_args!("`{}` does not exist", name_of(path)));
        return Err(failure.help("`objdict network build -o FOLDER` writes a folder that boots"));
    }
    let (folders, files): (Vec<PathBuf>, Vec<PathBuf>) =
        args.files.iter().cloned().partition(|path| path.is_dir());
    let network = match (folders.is_empty(), files.is_empty()) {
        (false, true) => None,
        _ => Some(open_to_use(&files, &args.input)?),
    };
    let failed = |error: InstallError| match error.help() {
        Some(help) => Failure::new(&error).help(help),
        None => Failure::new(&error),
    };
    match (folders.as_slice(), network) {
        ([], Some(network)) => {
            let target = args.target.unwrap_or_else(|| network.boot_files());
            network.install(target).map_err(failed)
        }
        ([folder], network) => install(&read(folder)?, network.as_ref()).map_err(failed),
        _ => Err(Failure::new("several folders cannot be booted together").help("name one folder")),
    }
}

/// The files of a folder, in the order of their names.
fn read(folder: &Path) -> Result<Vec<BuiltFile>, Failure> {
    let failed = |error: io::Error| Failure::new(format_args!("cannot read `{}`: {error}", name_of(folder)));
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        if path.is_file() && ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str())) {
            paths.push(path);
        }
    }
    if paths.len() > FILES {
        let count = paths.len();
        return Err(Failure::new(format_args!("`{}` has {count} files, more than {FILES}", name_of(folder))));
    }
    paths.sort();
    let file = |path: PathBuf| {
        keep(&path);
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let bytes = source::read(&path, DEFAULT_MAX_SIZE).map_err(Failure::new)?;
        Ok(BuiltFile { name, bytes })
    };
    paths.into_iter().map(file).collect()
}

/// A run with what its frames say.
struct BootReport<'r> {
    run: &'r Run,
    bit_rate: u16,
}

/// A line of the trace.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Line"))]
struct TraceLine {
    /// When it happened, in microseconds.
    time: u64,
    #[serde(flatten)]
    frame: Option<FrameColumns>,
    /// The name of the node that sent the frame, or that the line is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    node: Option<String>,
    /// A sentence about the event.
    text: String,
}

/// The columns of a frame.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FrameColumns {
    /// The CAN-ID in hex, without a prefix.
    can_id: String,
    /// The bytes in hex, or `remote`.
    data: String,
    /// Whether it is a remote frame.
    is_remote: bool,
    /// The service; absent if no node uses the CAN-ID.
    #[serde(skip_serializing_if = "Option::is_none")]
    service: Option<String>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct BootJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The files as they were given, separated by spaces.
    file: &'a str,
    /// What was assumed, and which nodes are left out.
    notes: &'a [String],
    /// The bit rate in kbit/s.
    bit_rate: u16,
    /// Whether the exit code is 0.
    is_booted: bool,
    /// Whether the application starts the nodes (1F80h).
    waits_for_application: bool,
    /// When the last node became operational that had to, in microseconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    operational: Option<u64>,
    /// When the simulation ended, in microseconds.
    end: u64,
    /// How long the bus was in use, in microseconds.
    busy: u64,
    /// The number of frames.
    frames: usize,
    /// Why the network is not booted.
    problems: Vec<String>,
    /// The manager, then the nodes by node-ID.
    nodes: Vec<NodeJson<'a>>,
    /// What happened; absent with `--summary`.
    #[serde(skip_serializing_if = "Option::is_none")]
    trace: Option<Vec<TraceLine>>,
}

/// A node.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Node"))]
struct NodeJson<'a> {
    /// The node-ID.
    node_id: u8,
    /// The name in the network.
    name: &'a str,
    /// Whether it is the manager.
    is_manager: bool,
    /// Whether the network is not booted without it.
    must_boot: bool,
    /// Its NMT state at the end; absent for a missing node.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<String>,
    /// Why it is not booted: the letter of CiA 302-2.
    #[serde(skip_serializing_if = "Option::is_none")]
    error_status: Option<char>,
    /// When it was booted, in microseconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    booted: Option<u64>,
    /// When it became operational, in microseconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    operational: Option<u64>,
    /// The number of downloads that it accepted.
    downloads: usize,
    /// The number of its emergencies.
    emergencies: usize,
}

impl<'r> BootReport<'r> {
    /// The lines of all events.
    fn lines(&self) -> impl Iterator<Item = TraceLine> + '_ {
        let talkers = self.run.nodes.iter().filter_map(|node| {
            let (name, node_id) = (node.name.as_str(), node.node_id);
            Some(Talker { name, node_id, device: node.device.as_ref()?, is_counterpart: false })
        });
        let mut reader = FrameReader::new(talkers.collect());
        self.run.events.iter().map(move |event| self.line(event, &mut reader))
    }

    fn line(&self, event: &Event, reader: &mut FrameReader<'_>) -> TraceLine {
        let time = event.time / 1000;
        let name = |at: usize| self.run.nodes[at].name.clone();
        let (node, text) = match &event.kind {
            EventKind::Frame { sender, frame } => return frame_line(time, name(*sender), frame, reader),
            EventKind::State { node, state } => {
                (*node, format!("{} is {}", name(*node), nmt_state(state.code())))
            }
            EventKind::Milestone { node, milestone } => (*node, self.milestone(*node, milestone)),
            EventKind::TwoSenders { id, senders: [first, second] } => {
                (*second, format!("{id:03X}h is sent by {} and by {}", name(*first), name(*second)))
            }
            _ => (0, String::new()),
        };
        TraceLine { time, frame: None, node: Some(name(node)), text }
    }

    fn milestone(&self, node: usize, milestone: &Milestone) -> String {
        let NodeRun { name, downloads, .. } = &self.run.nodes[node];
        match milestone {
            Milestone::Booted if *downloads == 0 => format!("{name} is booted"),
            Milestone::Booted => format!("{name} is booted, after {}", plural(*downloads, "download")),
            Milestone::Running => format!("{name} is already operational and remains unchanged"),
            Milestone::Failed(failure) => {
                format!("{name} is not booted (error {}): it {failure}", failure.status())
            }
            Milestone::Lost => format!("{name} is lost: its heartbeat or guarding response is missing"),
            _ => String::new(),
        }
    }

    fn trace(&self, out: &mut dyn Write) -> io::Result<()> {
        for TraceLine { time, frame, text, .. } in self.lines() {
            let (can_id, data) = frame.map_or_else(Default::default, |frame| (frame.can_id, frame.data));
            let line = format!("{:>11} ms  {can_id:3}  {data:<23}  {text}", milliseconds(time));
            writeln!(out, "{}", fit(line.trim_end(), WORDS))?;
        }
        writeln!(out)
    }

    fn summary(&self, out: &mut dyn Write) -> io::Result<()> {
        let headings = ["Node", "Name", "", "State", "Booted", "Operational", "Downloads", "EMCY"];
        let mut table = TextTable::new(headings, CELL);
        let time = |time: Option<u64>| {
            time.map_or_else(String::new, |time| format!("{} ms", milliseconds(time / 1000)))
        };
        for node in &self.run.nodes {
            table.row([
                node.node_id.to_string(),
                node.name.clone(),
                if node.is_manager { "manager" } else { "" }.to_owned(),
                node.state.map_or_else(|| "missing".to_owned(), |state| nmt_state(state.code())),
                time(node.booted),
                time(node.operational),
                if node.is_manager { String::new() } else { node.downloads.to_string() },
                if node.emergencies == 0 { String::new() } else { node.emergencies.to_string() },
            ]);
        }
        table.write(out)?;
        writeln!(out)?;
        for problem in self.problems() {
            writeln!(out, "{}", fit(&problem, CELL * 3))?;
        }
        writeln!(out, "{}", self.verdict())
    }

    /// Why the network is not booted.
    fn problems(&self) -> Vec<String> {
        let waits = self.run.waits_for_application;
        let manager = &self.run.nodes[0].name;
        let is_late = |node: &&NodeRun| {
            node.must_boot && (node.operational.is_none() || !node.is_manager && node.booted.is_none())
        };
        let late = self.run.nodes.iter().filter(is_late);
        let late = late.filter(|node| !waits || node.booted.is_none());
        let of_node = late.map(|node| {
            let name = &node.name;
            match (&node.milestone, node.assignment) {
                (Some(Milestone::Failed(failure)), _) => {
                    format!("{name} is not booted (error {}): it {failure}", failure.status())
                }
                (Some(Milestone::Lost), _) => format!("{name} is lost"),
                _ if node.is_manager => format!("{name} waits for mandatory nodes"),
                (_, None) => format!("{name} is not in the network list (1F81h) of {manager}"),
                (_, Some(assignment)) if assignment & 5 != 5 => {
                    format!("{name} must be booted, but its 1F81h in {manager} is {assignment:08X}h")
                }
                _ if node.state.is_none() => format!("{name} is missing"),
                _ if node.operational.is_some() => format!("{name} is not booted"),
                _ => format!("{name} is not operational"),
            }
        });
        let errors = self.run.nodes.iter().filter(|node| node.errors != 0);
        let errors = errors.map(|node| {
            format!("{} sends {} while it is operational", node.name, plural(node.errors, "EMCY"))
        });
        let conflicts = self.run.events.iter().filter_map(|event| match event.kind {
            EventKind::TwoSenders { id, senders } => {
                let [first, second] = senders.map(|at| self.run.nodes[at].name.as_str());
                Some(format!("{id:03X}h is sent by {first} and by {second}"))
            }
            _ => None,
        });
        let overload = self
            .run
            .is_overloaded()
            .then(|| "the bus is overloaded: frames of low priority are not sent".to_owned());
        of_node.chain(errors).chain(conflicts).chain(overload).collect()
    }

    fn verdict(&self) -> String {
        let Run { operational, end, cut, .. } = self.run;
        let frames = plural(self.run.frames().count(), "frame");
        let load = self.run.busy * 100 / self.run.end.max(1);
        let rate = format!("at {} kbit/s, {load} % load", self.bit_rate);
        match (operational, cut) {
            _ if !self.run.is_booted() => {
                let why = match cut {
                    Some(Cut::Time) => ", the time limit",
                    Some(Cut::Frames) => ", too many frames",
                    Some(Cut::Overload) | None => "",
                };
                format!("not booted: ended after {} ms{why}, {rate}, {frames}", milliseconds(end / 1000))
            }
            (Some(time), _) => format!("operational after {} ms {rate}, {frames}", milliseconds(time / 1000)),
            (None, _) => {
                let booted = self.run.nodes.iter().filter_map(|node| node.booted).max().unwrap_or(0);
                format!(
                    "booted after {} ms {rate}, {frames}; the application starts the nodes (1F80h)",
                    milliseconds(booted / 1000)
                )
            }
        }
    }

    fn json(&self, file: &str, notes: &[String], is_short: bool, out: &mut Output) -> io::Result<()> {
        let micro = |time: Option<u64>| time.map(|time| time / 1000);
        let row = |node: &'r NodeRun| NodeJson {
            node_id: node.node_id,
            name: &node.name,
            is_manager: node.is_manager,
            must_boot: node.must_boot,
            state: node.state.map(|state| nmt_state(state.code())),
            error_status: match &node.milestone {
                Some(Milestone::Failed(failure)) => Some(failure.status()),
                _ => None,
            },
            booted: micro(node.booted),
            operational: micro(node.operational),
            downloads: node.downloads,
            emergencies: node.emergencies,
        };
        let document = BootJson {
            version: Version,
            file,
            notes,
            bit_rate: self.bit_rate,
            is_booted: self.run.is_booted(),
            waits_for_application: self.run.waits_for_application,
            operational: micro(self.run.operational),
            end: self.run.end / 1000,
            busy: self.run.busy / 1000,
            frames: self.run.frames().count(),
            problems: self.problems(),
            nodes: self.run.nodes.iter().map(row).collect(),
            trace: (!is_short).then(|| self.lines().collect()),
        };
        out.json(&document)
    }
}

fn frame_line(time: u64, sender: String, frame: &BusFrame, reader: &mut FrameReader<'_>) -> TraceLine {
    let words = reader.read(frame.id(), frame.data(), frame.is_remote());
    let bytes: Vec<String> = frame.data().iter().map(|byte| format!("{byte:02X}")).collect();
    let data = if frame.is_remote() { "remote".to_owned() } else { bytes.join(" ") };
    let frame = FrameColumns {
        can_id: format!("{:03X}", frame.id()),
        data,
        is_remote: frame.is_remote(),
        service: words.service.map(|service| service.to_string()),
    };
    TraceLine { time, frame: Some(frame), node: Some(sender), text: words.text }
}

/// Microseconds as milliseconds.
fn milliseconds(time: u64) -> String {
    format!("{}.{:03}", time / 1000, time % 1000)
}
