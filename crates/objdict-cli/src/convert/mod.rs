//! `objdict convert`.

mod dbc;
mod device;
mod jobs;
mod losses;

use std::io::Write;

use self::device::{ConvertedFile, KeptData};
pub(super) use self::device::{read_data, refusal, tell_skipped};
use self::jobs::Job;
use self::losses::LossReport;
#[cfg(feature = "schema")]
pub(super) use self::losses::LossesJson as LossDocument;
pub(super) use self::losses::text as losses;
use super::annotation::DescribedStream;
use super::args::ConvertArgs;
use super::ending::{Failure, Outcome, note};
use super::input::{FileKind, Input, extensions, name_of, source_name};
use super::progress::{Progress, give_way};
use super::settings::{CommandSettings, SettingsArgs};
use super::stdout::Output;
use super::written_files::{SaveFolder, Saved, is_stdout, keep, require_other, save};
use objdict_format::input::Reading;
use objdict_format::{self as format, Description, Format, LossKind, ReadError, json};
use objdict_model::diagnostic::{Severity, plural};
use objdict_model::source::{SourceFile, SourceOptions};
use objdict_node::concise;
use objdict_node::download::ConciseDcf;

pub(super) fn run(args: &ConvertArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut jobs = jobs::plan(args)?;
    let settings = SettingsArgs::from(&args.config);
    let mut settings = CommandSettings::new(&settings)?;
    for job in &mut jobs {
        job.patches = settings.patches_of(&job.input)?;
    }
    // nothing is written over a file that is read later
    jobs.iter().for_each(|job| keep(&job.input));
    args.loss_report.iter().try_for_each(|path| require_other(path))?;
    let mut report = LossReport::default();
    let mut all_done = true;
    let mut place = OutputPlace::new(args, &jobs)?;
    let progress = Progress::new("converting", jobs.len());
    for jobs in jobs.chunk_by(|job, next| job.output == next.output) {
        let done = match jobs {
            [job] if job.to != FileKind::Dbc => convert_one(args, job, &mut place, &mut report, out),
            jobs => dbc::convert(args, jobs, &mut report, out),
        };
        if let Err(failure) = done {
            failure.print();
            all_done = false;
        }
        for _ in jobs {
            progress.step_with(out)?;
        }
    }
    drop(progress);
    place.finish()?;
    if let Some(path) = &args.loss_report {
        let document = report.to_json();
        match is_stdout(path) {
            true => out.raw()?.write_all(document.as_bytes())?,
            false => save(path, document.as_bytes()).map(|_| ())?,
        }
    }
    Ok(match () {
        () if !all_done => Outcome::Failed,
        () if args.deny_loss && report.has_lost() => Outcome::Findings,
        () => Outcome::Clean,
    })
}

/// Where files go.
enum OutputPlace {
    /// To the path that the arguments name.
    Named,
    /// Into a folder.
    Folder(SaveFolder),
}

impl OutputPlace {
    fn new(args: &ConvertArgs, jobs: &[Job]) -> Result<Self, Failure> {
        match args.output.first() {
            Some(folder) if jobs.iter().any(|job| job.is_named) => {
                Ok(Self::Folder(SaveFolder::open(folder, "convert", &args.overwrite)?))
            }
            _ => Ok(Self::Named),
        }
    }

    fn save(&mut self, job: &Job, bytes: &[u8]) -> Result<Saved, Failure> {
        match self {
            Self::Named => save(&job.output, bytes),
            Self::Folder(folder) => {
                folder.save(&job.output.file_name().unwrap_or_default().to_string_lossy(), bytes)
            }
        }
    }

    fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Named => Ok(()),
            Self::Folder(folder) => folder.finish(),
        }
    }
}

/// Converts one file: the device in it, or into a folder all of them.
fn convert_one(
    args: &ConvertArgs,
    job: &Job,
    place: &mut OutputPlace,
    report: &mut LossReport,
    out: &mut Output,
) -> Result<(), Failure> {
    let is_node = matches!(job.to, FileKind::Dcf | FileKind::Xdc | FileKind::Cdcf | FileKind::CdcfText);
    let reading = Reading { keep_disabled: true, is_node, ..args.input.reading_with(&job.patches) };
    let (from, input) = reading.read(&source_name(&job.input), args.input.size.read(&job.input)?)?;
    match input {
        Input::Description(description) if description.device_count() == 0 => {
            let name = name_of(&job.input);
            Err(ReadError::NoDevice { name, kind: from }.into())
        }
        Input::Description(description) if job.is_named && args.input.device.is_none() => {
            let count = description.device_count();
            if count == 1 {
                let converted = device::of_description(args, job, written(*description)?, from)?;
                return finish(job, from, converted, place, report, out);
            }
            for own in (0..count).map_while(|number| description.sibling(number)) {
                let job = job.of_device(own.number());
                let converted = device::of_description(args, &job, written(own)?, from)?;
                finish(&job, from, converted, place, report, out)?;
            }
            Ok(())
        }
        Input::Description(description) => {
            let description = args.input.selected(&job.input, *description)?;
            let description = written(description)?;
            finish(job, from, device::of_description(args, job, description, from)?, place, report, out)
        }
        Input::Device(device) => {
            let max_losses = args.input.max_losses(0);
            let kept = KeptData { embed: !args.no_embed, meanings: false };
            let converted = device::of_device(args, job, *device, kept, max_losses)?;
            finish(job, from, converted, place, report, out)
        }
        Input::Concise(configuration) => {
            finish(job, from, of_configuration(job, &configuration)?, place, report, out)
        }
        Input::NodeList(_) => {
            let failure = Failure::new("a node list does not describe a device");
            let file = name_of(&job.input);
            Err(failure.help(format!("`objdict show {file}` lists the files of its nodes")))
        }
    }
}

/// The description with the text that its patches make of it.
fn written(description: Description) -> Result<Description, Failure> {
    Ok(description.realised()?.unwrap_or(description))
}

/// Writes what a file became, and says so.
fn finish(
    job: &Job,
    from: FileKind,
    converted: ConvertedFile,
    place: &mut OutputPlace,
    report: &mut LossReport,
    out: &mut Output,
) -> Result<(), Failure> {
    let ConvertedFile { bytes, losses } = converted;
    if bytes.is_empty() {
        let failure = Failure::new(format_args!("`{}` does not describe a device", name_of(&job.input)));
        return Err(failure.help("run `objdict check` to see what is missing"));
    }
    let to = job.to;
    give_way();
    if is_stdout(&job.output) {
        out.raw()?.write_all(&bytes)?;
        let shown: Vec<_> = losses.iter().filter(|loss| loss.kind != LossKind::Embedded).cloned().collect();
        note(&losses::text(&shown));
    } else {
        let unchanged = match place.save(job, &bytes)? {
            Saved::Written => "",
            Saved::Unchanged => ", unchanged",
        };
        let (file, written, size) = (name_of(&job.input), name_of(&job.output), bytes.len());
        let losses = losses::text(&losses);
        let line = format!(
            "{file} ({}) to {written} ({}), {size} bytes{unchanged}\n{losses}",
            from.name(),
            to.name()
        );
        out.summary(line.trim_end_matches('\n'))?;
    }
    if job.to == FileKind::Toml {
        note_errors(job, bytes);
    }
    report.add(job, from, losses);
    Ok(())
}

/// Reports errors that a source has from its description, because commands refuse such a source.
fn note_errors(job: &Job, bytes: Vec<u8>) {
    let name = name_of(&job.output);
    let Ok(source) = SourceFile::from_bytes(&name, bytes, &SourceOptions::default()) else { return };
    let findings = objdict_project::check(&format::read(source, Format::Toml));
    let errors = findings.iter().filter(|finding| finding.severity == Severity::Error).count();
    if errors > 0 {
        let errors = plural(errors, "error");
        note(&format!(
            "note: `{name}` has {errors} from the description; correct them before you convert it (`objdict check {name}` lists them)\n"
        ));
    }
}

/// What is made of a concise DCF.
fn of_configuration(job: &Job, configuration: &ConciseDcf) -> Result<ConvertedFile, Failure> {
    match job.to {
        FileKind::Json => Ok(ConvertedFile::whole(json::write_configuration(configuration).into_bytes())),
        FileKind::CdcfText => {
            let described = DescribedStream { device: None, node_id: None };
            let text = concise::print(configuration, |download| described.annotate(download));
            Ok(ConvertedFile::whole(text.into_bytes()))
        }
        FileKind::Cdcf => configuration.write().map(ConvertedFile::whole).map_err(Failure::new),
        to => {
            let name = to.name();
            let message =
                format!("a concise DCF contains values but no description, so it cannot become {name}");
            let kinds = [FileKind::Json, FileKind::Cdcf, FileKind::CdcfText];
            Err(Failure::new(message).help(format!("it can become {}", extensions(kinds))))
        }
    }
}
