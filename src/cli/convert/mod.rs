//! `objdict convert`.

mod device;
mod jobs;
mod losses;

use std::fs;
use std::io::Write;
use std::path::Path;

use self::device::Converted;
use self::jobs::Job;
use self::losses::LossReport;
use super::args::ConvertArgs;
use super::input::{FileKind, Input, name_of};
use super::output::Output;
use super::save::{Saved, save};
use super::{Failure, Outcome};
use crate::format::{Fate, concise, json};

pub(super) fn run(args: &ConvertArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let jobs = jobs::plan(args)?;
    let mut report = LossReport::default();
    let mut all_done = true;
    for job in &jobs {
        if let Err(failure) = convert_one(args, job, &mut report, out) {
            failure.print();
            all_done = false;
        }
    }
    if let Some(path) = &args.loss_report {
        let document = report.to_json();
        match path == Path::new("-") {
            true => out.write_all(document.as_bytes())?,
            false => save(path, document.as_bytes()).map(|_| ())?,
        }
    }
    Ok(match () {
        () if !all_done => Outcome::Failed,
        () if args.deny_loss && report.has_lost() => Outcome::Findings,
        () => Outcome::Clean,
    })
}

/// Converts one file, and says so.
fn convert_one(
    args: &ConvertArgs,
    job: &Job,
    report: &mut LossReport,
    out: &mut Output,
) -> Result<(), Failure> {
    let is_stdout = job.output == Path::new("-");
    if !is_stdout && is_same_file(&job.input, &job.output) {
        let failure = Failure::new(format_args!("`{}` would overwrite itself", job.input.display()));
        return Err(failure.help("name another file for the output"));
    }
    let (from, Converted { bytes, losses }) = convert(args, job)?;
    let to = job.to;
    if is_stdout {
        out.write_all(&bytes)?;
        let shown: Vec<_> = losses.iter().filter(|loss| loss.fate != Fate::Carried).cloned().collect();
        super::tell(&losses::text(&shown));
    } else {
        let note = match save(&job.output, &bytes)? {
            Saved::Written => "",
            Saved::Unchanged => ", unchanged",
        };
        let (file, written, size) = (name_of(&job.input), job.output.display(), bytes.len());
        writeln!(out, "{file} ({}) to {written} ({}), {size} bytes{note}", from.name(), to.name())?;
        out.write_all(losses::text(&losses).as_bytes())?;
    }
    report.add(job, from, losses);
    Ok(())
}

fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

/// Reads a file and makes what was asked for of it.
fn convert(args: &ConvertArgs, job: &Job) -> Result<(FileKind, Converted), Failure> {
    let (from, input) = args.input.read(&job.input)?;
    let converted = match input {
        Input::Description(description) => device::of_description(args, job, &description, from)?,
        Input::Device(device) => device::of_device(args, job, &device, !args.no_carry)?,
        Input::Configuration(configuration) => match job.to {
            FileKind::Json => Converted::whole(json::write_configuration(&configuration).into_bytes()),
            FileKind::Cdcf => Converted::whole(concise::write(&configuration).map_err(Failure::new)?),
            to => {
                return Err(Failure::new(format_args!(
                    "a concise DCF holds values and no description, so no {} can be made of it",
                    to.name()
                ))
                .help("it can become `.json`"));
            }
        },
        Input::NodeList(_) => {
            return Err(Failure::new("a node list holds no device")
                .help(format!("`objdict show {}` names the files of its nodes", job.input.display())));
        }
    };
    Ok((from, converted))
}
