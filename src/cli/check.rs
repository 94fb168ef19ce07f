//! `objdict check`.

use super::args::{CheckArgs, ReportFormat};
use super::output::Output;
use super::{Failure, Outcome};
use crate::report::{Json, Report, Tally, Text};

pub(super) fn run(args: &CheckArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut report: Box<dyn Report> = match args.format {
        ReportFormat::Text => {
            let colour = out.colour();
            Box::new(Text::new(out, colour))
        }
        ReportFormat::Json => Box::new(Json::new(out)),
    };
    let mut tally = Tally::default();
    let mut all_read = true;
    for path in &args.files {
        match args.input.description(path) {
            Ok(description) => {
                let count = description.device_count();
                let mut next = Some(description);
                for number in 1..=count {
                    let Some(description) = next else { break };
                    let findings = crate::check(&description);
                    tally.add(&findings);
                    report.file(&description, &findings)?;
                    next = description.select(number);
                }
            }
            Err(failure) => {
                failure.print();
                all_read = false;
            }
        }
    }
    report.finish()?;
    Ok(match tally.at_least(args.deny.into()) {
        _ if !all_read => Outcome::Failed,
        0 => Outcome::Clean,
        _ => Outcome::Findings,
    })
}
