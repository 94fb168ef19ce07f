//! `objdict network graph`.

use std::io::Write;

use super::super::args::{GraphFormat, NetworkGraphArgs};
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::overview;
use objdict_network::graph;

pub(super) fn run(args: &NetworkGraphArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let overview = overview(&args.files, &args.input)?;
    let text = match args.format {
        GraphFormat::Svg => graph::svg(&overview, |can_id| can_id.to_string()) + "\n",
        GraphFormat::Dot => graph::dot(&overview),
    };
    out.raw()?.write_all(text.as_bytes())?;
    Ok(Outcome::Clean)
}
