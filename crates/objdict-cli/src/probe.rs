//! `objdict probe`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::args::ProbeArgs;
use super::check::Reporter;
use super::ending::{Failure, Outcome, note};
use super::input::{Input, SizeArgs, name_of};
use super::new::date_and_time;
use super::settings::CommandSettings;
use super::stdout::Output;
use super::written_files::{SaveFolder, keep, save};
use objdict_document::TablePage;
use objdict_format as format;
use objdict_format::{Description, Format, WriteOptions};
use objdict_model::diagnostic::one_line;
use objdict_model::diagnostic::plural;
use objdict_model::model::Device;
use objdict_project::report::Subject;
use objdict_traffic::log::{LogOptions, LogReader};
use objdict_traffic::probe::learn;
use objdict_traffic::probe::{
    Conversation, Exchange, Judgement, ProbeOptions, ProbePlan, judge, read_answers,
};

/// The node-ID of a description that does not say one.
const NODE_ID: u8 = 1;

/// What a node sends from: 580h and its node-ID.
const SERVERS: std::ops::RangeInclusive<u32> = 0x581..=0x5FF;

pub(super) fn run(args: &ProbeArgs, out: &mut Output) -> Result<Outcome, Failure> {
    #[cfg(feature = "bus")]
    if let Some(file) = args.file.as_ref().filter(|_| args.is_on_bus()) {
        return asked(args, file, out);
    }
    match (&args.file, &args.answers) {
        (None, Some(answers)) => learned(args, answers, out),
        (Some(file), Some(answers)) => judged(args, file, answers, out),
        (Some(file), None) => planned(args, file, out),
        // the arguments require one of them
        (None, None) => Err(Failure::new("a description or answers are needed")),
    }
}

fn description(args: &ProbeArgs, path: &Path) -> Result<Description, Failure> {
    match args.input.read_node(path, args.settings.config_file())? {
        (_, Input::Description(description)) => Ok(*description),
        (kind, _) => {
            let message = format!(
                "expected an EDS, DCF, XDD or XDC, but `{}` is read as {}",
                name_of(path),
                kind.name()
            );
            Err(Failure::new(message))
        }
    }
}

fn planned(args: &ProbeArgs, file: &Path, out: &mut Output) -> Result<Outcome, Failure> {
    let description = description(args, file)?;
    let device = description.device();
    let node_id = args.settings.node_id().or_else(|| device.node_id()).unwrap_or(NODE_ID);
    let plan =
        ProbePlan::new(device, node_id, &ProbeOptions { write: args.write, also: args.write_object.clone() });
    if plan.is_empty() {
        return Err(Failure::new(format_args!("`{}` has no readable entry", name_of(file))));
    }
    let output = args.output.as_deref().unwrap_or(Path::new("."));
    let origin = format!("probe {}", one_line(&file.file_name().unwrap_or_default().to_string_lossy()));
    let folder = SaveFolder::open(output, &origin, &args.overwrite)?;
    let texts =
        [("probe.py", plan.script()), ("probe.log", plan.candump(args.gap)), ("probe.csv", plan.table())];
    let files = texts.each_ref().map(|(name, text)| (*name, text.as_bytes()));
    folder.replace(&files)?;
    let names = texts.each_ref().map(|(name, _)| *name).join(", ");
    out.summary(format_args!(
        "{}: {names}: {} for node {node_id}",
        name_of(output),
        plural(plan.len(), "question")
    ))?;
    Ok(Outcome::Clean)
}

/// The answers of a file, and the node that gave them, if the file says so.
pub(super) fn answers(
    size: &SizeArgs,
    path: &Path,
    node_id: Option<u8>,
    device: Option<&Device>,
) -> Result<(Vec<Exchange>, Option<u8>), Failure> {
    let bytes = size.read(path)?;
    let unreadable = |error: &dyn std::fmt::Display| {
        Failure::new(format_args!("cannot read `{}`: {error}", name_of(path)))
    };
    if is_table(&bytes) {
        let exchanges = read_answers(&String::from_utf8_lossy(&bytes)).map_err(|error| unreadable(&error))?;
        return Ok((exchanges, node_id));
    }
    let (mut log, mut frames) = (LogReader::new(bytes.as_slice(), LogOptions::default()), Vec::new());
    while let Some(frame) = log.next_frame()? {
        frames.push(frame);
    }
    if log.bad_count() > 0 {
        note(&format!(
            "note: `{}`: {} cannot be parsed\n",
            name_of(path),
            plural(log.bad_count() as usize, "line")
        ));
    }
    let base = frames.iter().filter(|frame| !frame.is_extended && !frame.is_error);
    let servers: BTreeSet<u32> = base.map(|frame| frame.can_id).filter(|id| SERVERS.contains(id)).collect();
    let node_id = match (node_id, servers.first(), servers.len()) {
        (Some(node_id), ..) => node_id,
        (None, Some(server), 1) => (server - 0x580) as u8,
        (None, Some(_), _) => {
            let message = format!("`{}` has SDO answers of {}", name_of(path), plural(servers.len(), "node"));
            return Err(Failure::new(message).help("name the node with `--node-id`"));
        }
        (None, None, _) => NODE_ID,
    };
    let mut buses: BTreeMap<u16, Conversation<'_>> = BTreeMap::new();
    for frame in &frames {
        let conversation = buses.entry(frame.channel).or_insert_with(|| match device {
            Some(device) => Conversation::with(device, node_id),
            None => Conversation::new(node_id),
        });
        conversation.take(frame);
    }
    Ok((buses.into_values().flat_map(Conversation::into_exchanges).collect(), Some(node_id)))
}

/// Whether a file is JSON, or CSV with a column `index`.
fn is_table(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let text = text.trim_start_matches('\u{FEFF}').trim_start();
    let headings = text.lines().find(|line| !line.starts_with('#')).unwrap_or_default().to_ascii_lowercase();
    text.starts_with(['[', '{']) || headings.contains("index")
}

fn judged(args: &ProbeArgs, file: &Path, path: &Path, out: &mut Output) -> Result<Outcome, Failure> {
    let description = description(args, file)?;
    let node_id = args.settings.node_id().or_else(|| description.device().node_id());
    let (exchanges, node_id) = answers(&args.input.size, path, node_id, Some(description.device()))?;
    let node_id = node_id.unwrap_or(NODE_ID);
    if exchanges.is_empty() {
        let failure = Failure::new(format_args!("`{}` has no SDO transfer of node {node_id}", name_of(path)));
        return Err(failure.help("name the node with `--node-id`"));
    }
    report(args, file, &description, node_id, &exchanges, out)
}

/// Asks a device on a bus, and judges what it answers.
#[cfg(feature = "bus")]
fn asked(args: &ProbeArgs, file: &Path, out: &mut Output) -> Result<Outcome, Failure> {
    let description = description(args, file)?;
    let device = description.device();
    let node_id = args.settings.node_id().or_else(|| device.node_id()).unwrap_or(NODE_ID);
    let options = ProbeOptions { write: args.write, also: args.write_object.clone() };
    let plan = ProbePlan::new(device, node_id, &options);
    let exchanges = super::bus::ask(&args.bus, args.yes, node_id, device, &plan)?;
    report(args, file, &description, node_id, &exchanges, out)
}

fn report(
    args: &ProbeArgs,
    file: &Path,
    description: &Description,
    node_id: u8,
    exchanges: &[Exchange],
    out: &mut Output,
) -> Result<Outcome, Failure> {
    let judgement = judge(description.device(), node_id, exchanges);
    let mut settings = CommandSettings::new(&args.settings)?;
    let project = settings.project_of(file)?;
    let findings = settings.options(file, project.as_deref()).severities.apply(judgement.findings.clone());
    let mut reporter = Reporter::new(&args.report, &args.baseline, out)?;
    reporter.report_on(Subject::from(description), findings, settings.deny(project.as_deref()))?;
    for project in settings.projects() {
        reporter.take_project(project, &settings)?;
    }
    let outcome = reporter.finish(None)?;
    note(&format!("{}\n", summary(&judgement, node_id)));
    if let Some(html) = &args.html {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        save(html, page(&name, &judgement, node_id).html().as_bytes())?;
    }
    Ok(outcome)
}

/// Such as: node 5: 210 of 214 answers as described; 3 entries were not read
fn summary(judgement: &Judgement, node_id: u8) -> String {
    let (passed, count) = (judgement.passed(), judgement.rows.len());
    let unasked = match judgement.unasked.len() {
        0 => String::new(),
        1 => "; 1 entry was not read".to_owned(),
        count => format!("; {count} entries were not read"),
    };
    format!("node {node_id}: {passed} of {} as described{unasked}", plural(count, "answer"))
}

fn page<'a>(file: &'a str, judgement: &'a Judgement, node_id: u8) -> TablePage<'a> {
    let rows = judgement.rows.iter().map(|row| {
        let address = format!("{:04X}:{:02X}", row.index, row.sub);
        let verdict = match &row.problem {
            Some((rule, problem)) => format!("{}: {problem}", rule.id),
            None => "as described".to_owned(),
        };
        (
            vec![address, row.name.clone(), row.asked.clone(), row.answer.clone(), verdict],
            row.problem.is_some(),
        )
    });
    let (summary, rows) = (summary(judgement, node_id), rows.collect());
    let headings = &["Entry", "Name", "Asked", "Answer", "Verdict"];
    TablePage { file, heading: file, summary, headings, rows }
}

fn learned(args: &ProbeArgs, path: &Path, out: &mut Output) -> Result<Outcome, Failure> {
    let output = args.output.as_deref().unwrap_or(Path::new("learned.eds"));
    keep(path);
    let (exchanges, node_id) = answers(&args.input.size, path, args.settings.node_id(), None)?;
    let (date, time) = date_and_time(None)?;
    let name = output.file_name().unwrap_or_default().to_string_lossy();
    let device = learn(&exchanges, node_id, &name, date, time);
    let Some(device) = device else {
        return Err(Failure::new(format_args!("`{}` has no response for any entry", name_of(path))));
    };
    let bytes = format::write(&device, Format::Eds, &WriteOptions::default())?.bytes;
    save(output, &bytes)?;
    out.summary(format_args!("{}: {}", name_of(output), plural(device.objects.len(), "object")))?;
    Ok(Outcome::Clean)
}
