//! The reports that `check` writes.

use super::Failure;
use super::args::{CheckArgs, ReportFormat};
use super::output::Output;
use crate::report::{Concise, Json, Report, Text};

/// The report that was asked for.
pub(super) fn new<'a>(args: &CheckArgs, out: &'a mut Output) -> Result<Box<dyn Report + 'a>, Failure> {
    Ok(match args.format {
        ReportFormat::Text => {
            let colour = out.colour();
            Box::new(Text::new(out, colour))
        }
        ReportFormat::Concise => Box::new(Concise::new(out)),
        ReportFormat::Json => Box::new(Json::new(out)),
    })
}
