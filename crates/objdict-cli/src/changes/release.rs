//! `objdict release`: whether the versions of a new description moved as its changes demand, and the edits that move them.

use std::path::Path;

use super::side::{ComparedSide, sides};
use crate::args::ReleaseArgs;
use crate::ending::{Failure, Outcome};
use crate::fix::{Fixing, amend};
use crate::input::Input;
use crate::new::date_and_time;
use crate::report;
use crate::stdout::Output;
use objdict_format::Description;
use objdict_lint::changes::{ReleaseFacts, release};
use objdict_model::diagnostic::{Applicability, Findings, Severity};
use objdict_model::model::{Device, DeviceKind};
use objdict_model::source::shown;
use objdict_project::report::Subject;

pub(crate) fn run(args: &ReleaseArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let (date, time) = date_and_time(args.date)?;
    let facts = ReleaseFacts { date, time, product_code: args.product_code };
    let [old, new] = sides(&args.sides, &args.input, &args.config)?;
    for side in [&old, &new] {
        require_type(side)?;
    }
    let path = args.sides.newer();
    if args.fix && !args.diff && path == Path::new("-") {
        let failure = Failure::new("the standard input cannot be changed in place");
        return Err(failure.help("use `--diff` to print the changes"));
    }
    let old = old.device()?;
    let mut description = described(new)?;
    let check = |description: &Description| release(old, description.device(), &facts);
    let mut fixing = Fixing::default();
    if args.fix || args.diff {
        let number = description.number();
        let fix = |description| objdict_project::fix(description, Applicability::Safe, check);
        let amended = amend(path, description, number..number + 1, fix);
        let (after, amended) =
            amended.ok_or_else(|| Failure::new(format!("cannot change `{}`", shown(path))))?;
        description = after;
        match amended {
            Some(amended) if args.diff => fixing.show(&amended, out)?,
            Some(amended) => {
                amended.write()?;
                fixing.count(&amended);
            }
            None => {}
        }
    }
    let findings = check(&description);
    let is_clean = findings.is_empty() && !(args.diff && fixing.is_needed());
    let outcome = if is_clean { Outcome::Clean } else { Outcome::Findings };
    if !args.diff {
        write_report(args, &description, &findings, outcome, out)?;
    }
    if args.fix || args.diff {
        fixing.finish(args.diff);
    }
    Ok(outcome)
}

fn write_report(
    args: &ReleaseArgs,
    description: &Description,
    findings: &Findings,
    outcome: Outcome,
    out: &mut Output,
) -> Result<(), Failure> {
    let mut report = report::new(&args.report, out)?;
    report.deny_from(Severity::Note);
    report.file(Subject::Description(description), findings)?;
    report.exit_code(outcome.code());
    Ok(report.finish()?)
}

/// Refuses the description of a node.
fn require_type(side: &ComparedSide) -> Result<(), Failure> {
    let device: &Device = side.device()?;
    if device.kind == DeviceKind::Type {
        return Ok(());
    }
    let failure =
        Failure::new(format!("`{}` describes a node, which has the versions of its device", side.name()));
    Err(failure.help("name the EDS or XDD that the node was created from"))
}

/// The new description with its text.
fn described(side: ComparedSide) -> Result<Description, Failure> {
    let message = format!("`{}` is read as {}, not as an EDS or XDD", side.name(), side.format);
    match side.input {
        Input::Description(description) => Ok(*description),
        _ => Err(Failure::new(message).help("convert it to an EDS or XDD with `objdict convert`")),
    }
}
