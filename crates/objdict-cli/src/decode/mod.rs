//! `objdict decode`: the traffic of a bus in words.

mod check;
mod csv;
mod html;
mod incidents;
pub(super) mod screen;
mod summary;
mod text;

use std::fs::File;
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

use self::csv::{LongCsv, WideCsv};
use self::screen::Screen;
#[cfg(feature = "schema")]
pub(super) use self::summary::TrafficSummaryJson as SummaryDocument;
use self::text::{JsonLines, TextLines};
#[cfg(feature = "bus")]
use super::args::{BusWatchArgs, ShowFormat};
use super::args::{DecodeArgs, DecodeFormat, FrameFilterArgs, NetworkInputArgs, WithFile};
use super::baseline::KnownFindings;
use super::ending::{Failure, Outcome, note, tell};
use super::input::{Input, name_of, source_name};
use super::network;
use super::settings::reading;
use super::stdout::Output;
use super::written_files::{keep, require_other};
use objdict_document::describe::frames::{DecodedFrame, FrameKind};
use objdict_format::input::Reading;
use objdict_network_file::NetworkFile;
use objdict_traffic::log::{LogOptions, LoggedFrame};
use objdict_traffic::{Bus, Buses, Descriptions, MergedLogs, NamedLog, Origin, Recording, digits, raw};

/// How much of a log is read at once.
const BUFFER: usize = 1 << 16;

type Logs = MergedLogs<Box<dyn BufRead>>;

pub(super) fn run(args: &DecodeArgs, out: &mut Output) -> Result<Outcome, Failure> {
    require_format(args)?;
    let (input, profile) = (args.input(), args.settings.device_profile()?);
    let described = |files: &mut dyn Iterator<Item = &WithFile>| {
        Ok::<_, Failure>(Descriptions { profile, ..descriptions(files, &input)? })
    };
    let others = described(&mut args.with.iter())?;
    let mut by_channel: Vec<(String, Descriptions)> = Vec::new();
    for channel in args.channel.iter().map(|given| &given.channel) {
        if by_channel.iter().all(|(known, _)| known != channel) {
            let mut files =
                args.channel.iter().filter(|given| given.channel == *channel).map(|given| &given.file);
            by_channel.push((channel.clone(), described(&mut files)?));
        }
    }
    let mut buses = Buses::new(&by_channel, &others);
    let is_live = !args.logs.iter().all(|path| is_file(path));
    if buses.is_open() && !is_live {
        let notes = buses.find(&mut open(args)?).map_err(|error| unreadable(&error))?;
        notes.iter().for_each(|text| note(&format!("note: {text}\n")));
    }
    let mut logs = open(args)?;
    if args.check || args.is_summary() || args.html.is_some() {
        let outcome = sums(args, &mut buses, &mut logs, out)?;
        return Ok(outcome.max(report_bad_lines(&logs)?));
    }
    let mut printer: Box<dyn FramePrinter> = match (args.format, args.wide) {
        (DecodeFormat::Json, _) => Box::new(JsonLines),
        (DecodeFormat::Csv, false) => Box::new(LongCsv::default()),
        (DecodeFormat::Csv, true) => Box::new(WideCsv::new(args.max_rows)),
        _ => Box::new(TextLines),
    };
    each_frame(&args.filter, &mut buses, &mut logs, |shown| {
        printer.frame(&shown, out)?;
        // a line of a live bus is there at once
        if is_live { out.flush() } else { Ok(()) }
    })?;
    printer.end(out)?;
    report_bad_lines(&logs)
}

/// The frames of a bus while they arrive, and their sums at the end.
#[cfg(feature = "bus")]
pub(super) fn watch(
    args: &BusWatchArgs,
    descriptions: &Descriptions,
    log: NamedLog<Box<dyn BufRead>>,
    out: &mut Output,
) -> Result<Outcome, Failure> {
    let (mut buses, mut logs) = (Buses::new(&[], descriptions), MergedLogs(vec![log]));
    let filter = FrameFilterArgs::default();
    if args.frames {
        each_frame(&filter, &mut buses, &mut logs, |shown| {
            match args.connect.format {
                ShowFormat::Table => TextLines.frame(&shown, out)?,
                ShowFormat::Json => JsonLines.frame(&shown, out)?,
            }
            out.flush()
        })?;
        return Ok(Outcome::Clean);
    }
    let is_text = args.connect.format == ShowFormat::Table;
    let mut screen = if is_text { Screen::of_terminal() } else { None };
    let document = summary::gather(&filter, None, &mut buses, &mut logs, None, |at, sums, bus| {
        Screen::update(&mut screen, at, sums, bus);
    })?;
    drop(screen);
    document.write(if is_text { DecodeFormat::Text } else { DecodeFormat::Json }, out)?;
    Ok(if args.check { document.outcome() } else { Outcome::Clean })
}

/// What is known at the end of the logs: sums, findings and a page.
fn sums(
    args: &DecodeArgs,
    buses: &mut Buses<'_>,
    logs: &mut Logs,
    out: &mut Output,
) -> Result<Outcome, Failure> {
    // what cannot be written should not be read for
    args.html.as_deref().map_or(Ok(()), require_other)?;
    let mut recording = args.html.as_ref().map(|_| Recording::new(&args.plot, args.points));
    let mut known = KnownFindings::new(&args.baseline)?;
    let is_live =
        args.summary && args.format == DecodeFormat::Text && !args.logs.iter().all(|path| is_file(path));
    let mut screen = if is_live { Screen::of_terminal() } else { None };
    let mut document =
        summary::gather(&args.filter, args.bit_rate, buses, logs, recording.as_mut(), |at, sums, bus| {
            Screen::update(&mut screen, at, sums, bus);
        })?;
    drop(screen);
    document.sift(&mut known);
    let is_written = known.is_written();
    known.finish()?;
    if let Some((path, recording)) = args.html.as_deref().zip(recording) {
        html::write(path, &recording, &document, buses)?;
    }
    match args.incident {
        Some(number) if args.format == DecodeFormat::Json => {
            document.only(number)?.write(args.format, out)?;
        }
        Some(number) => incidents::write_one(number, document.incidents(), out)?,
        None if args.summary && is_written => {}
        None if args.summary => document.write(args.format, out)?,
        None if args.check => return check::run(args, document.buses(), out),
        None => {}
    }
    Ok(if args.check { document.outcome() } else { Outcome::Clean })
}

/// A frame that is shown.
struct ShownFrame<'s, 'd> {
    frame: &'s LoggedFrame,
    decoded: DecodedFrame,
    bus: &'s Bus<'d>,
    /// The position of the bus.
    at: usize,
    origin: Origin<'s>,
}

/// Fails for a format that has no place for what is shown.
fn require_format(args: &DecodeArgs) -> Result<(), Failure> {
    let (problem, help) = match args.format {
        format if format.is_of_findings() && args.is_summary() => {
            ("this is a format of findings", "leave out `--summary` and `--incident`")
        }
        DecodeFormat::Csv if args.check => ("findings have no CSV", "use `--format text` or `--format json`"),
        DecodeFormat::Csv if args.html.is_some() => ("a page has no CSV", "leave out `--format csv`"),
        DecodeFormat::Csv if args.is_summary() => {
            ("`--summary` has no CSV", "use `--format text` or `--format json`")
        }
        format if format.is_of_findings() && !args.check => ("this is a format of findings", "add `--check`"),
        DecodeFormat::Csv => return Ok(()),
        _ if args.wide => ("`--wide` is a form of CSV", "add `--format csv`"),
        _ => return Ok(()),
    };
    Err(Failure::new(problem).help(help))
}

/// What writes frames.
trait FramePrinter {
    fn frame(&mut self, shown: &ShownFrame<'_, '_>, out: &mut Output) -> io::Result<()>;

    fn end(&mut self, _out: &mut Output) -> io::Result<()> {
        Ok(())
    }
}

/// Gives each frame that passes the filters to `show`.
fn each_frame<'d>(
    filter: &FrameFilterArgs,
    buses: &mut Buses<'d>,
    logs: &mut Logs,
    mut show: impl FnMut(ShownFrame<'_, 'd>) -> io::Result<()>,
) -> Result<(), Failure> {
    let has_filter = filter.is_set();
    while let Some((log, frame)) = logs.next_frame().map_err(|error| unreadable(&error))? {
        let at = buses.of(log, &frame, logs);
        let bus = &mut buses.all[at];
        let decoded = bus.decode(&frame);
        for text in bus.assign(false) {
            note(&format!("note: {text}\n"));
        }
        let bus = &buses.all[at];
        if !has_filter || filter.passes(&decoded, &frame, bus) {
            show(ShownFrame { frame: &frame, decoded, bus, at, origin: logs.origin(log) })?;
        }
    }
    Ok(())
}

impl FrameFilterArgs {
    fn is_set(&self) -> bool {
        let Self { only_node, object, kind, from, to } = self;
        !only_node.is_empty() || !object.is_empty() || !kind.is_empty() || from.is_some() || to.is_some()
    }

    fn passes(&self, decoded: &DecodedFrame, frame: &LoggedFrame, bus: &Bus<'_>) -> bool {
        let for_all = decoded.kind == FrameKind::Nmt && decoded.node_id.is_none();
        let is_of_node =
            || for_all || decoded.node_id.is_some_and(|node_id| self.only_node.contains(&node_id));
        self.from.is_none_or(|from| frame.time >= from)
            && self.to.is_none_or(|to| frame.time <= to)
            && (self.kind.is_empty() || self.kind.contains(&decoded.kind))
            && (self.only_node.is_empty() || is_of_node())
            && (self.object.is_empty() || self.has_object(decoded, frame, bus))
    }

    fn has_object(&self, decoded: &DecodedFrame, frame: &LoggedFrame, bus: &Bus<'_>) -> bool {
        let is_wanted = |(index, sub): (u16, u8)| {
            self.object
                .iter()
                .any(|(wanted, wanted_sub)| *wanted == index && wanted_sub.is_none_or(|wanted| wanted == sub))
        };
        match (decoded.kind, decoded.sdo) {
            (FrameKind::Sdo, Some(sdo)) => sdo.entry.is_some_and(is_wanted),
            (FrameKind::Pdo, _) => bus
                .reader
                .signals(decoded, &raw(frame))
                .iter()
                .any(|signal| is_wanted((signal.index, signal.sub))),
            _ => false,
        }
    }
}

fn is_file(path: &Path) -> bool {
    path.metadata().is_ok_and(|found| found.is_file())
}

/// Opens the logs; nothing is written to them.
fn open(args: &DecodeArgs) -> Result<Logs, Failure> {
    let options = LogOptions { has_distances: args.distances.then_some(true) };
    let open = |path: &PathBuf| {
        let source: Box<dyn BufRead> = if path == Path::new("-") {
            keep(Path::new("/dev/stdin"));
            Box::new(BufReader::with_capacity(BUFFER, io::stdin()))
        } else {
            keep(path);
            let failed = |error| Failure::new(format_args!("cannot read `{}`: {error}", name_of(path)));
            Box::new(BufReader::with_capacity(BUFFER, File::open(path).map_err(failed)?))
        };
        Ok(NamedLog::new(name_of(path), source, options))
    };
    Ok(MergedLogs(args.logs.iter().map(open).collect::<Result<_, Failure>>()?))
}

fn unreadable(error: &io::Error) -> Failure {
    Failure::new(format_args!("cannot read the log: {error}"))
}

/// The nodes that files describe.
pub(super) fn descriptions<'a>(
    files: impl Iterator<Item = &'a WithFile>,
    input: &NetworkInputArgs,
) -> Result<Descriptions, Failure> {
    let mut found = Descriptions::default();
    for WithFile { node_id, path } in files {
        keep(path);
        let is_network = node_id.is_none() && NetworkFile::is_network(path).map_err(Failure::new)?;
        if is_network {
            found.add_network(&network::open_to_use(std::slice::from_ref(path), input)?);
            continue;
        }
        let mut patches = input.patch.patches.clone();
        patches.extend(input.config.patches_of(path)?);
        let reading = Reading { patches, ..reading() };
        let device = match reading.open(path)? {
            (_, Input::Description(description)) => description.device().clone(),
            (_, Input::Device(device)) => *device,
            (kind, _) => {
                let message = format!("`{}` is a {}, not a description", name_of(path), kind.name());
                return Err(Failure::new(message).help("name an EDS, DCF, XDD or XDC, or a network"));
            }
        };
        found.add_device(device, *node_id, path, source_name(path));
    }
    Ok(found)
}

/// Reports lines that are not understood. A log without a frame is not one.
fn report_bad_lines(logs: &Logs) -> Result<Outcome, Failure> {
    let mut outcome = Outcome::Clean;
    for log in &logs.0 {
        if let Some(problem) = log.problem() {
            tell(&format!("error: {problem}\n"));
            outcome = Outcome::Failed;
            continue;
        }
        if log.reader.frame_count() == 0 {
            note(&format!("note: `{}` has no frame\n", log.name));
        }
        log.warnings().for_each(|text| tell(&format!("warning: {text}\n")));
    }
    Ok(outcome)
}

/// The CAN-ID in hex: 3 digits for 11 bits, 8 for 29.
fn id_of(frame: &LoggedFrame) -> String {
    if frame.is_extended { format!("{:08X}", frame.can_id) } else { format!("{:03X}", frame.can_id) }
}

/// Writes a line of data.
fn write_raw(out: &mut Output, line: &str) -> io::Result<()> {
    out.raw()?.write_all(line.as_bytes())
}
