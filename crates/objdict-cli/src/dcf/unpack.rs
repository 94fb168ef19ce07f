//! `objdict dcf unpack`.

use super::super::args::UnpackArgs;
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::{count, deliver, stream};
use objdict_node::concise;

pub(super) fn run(args: &UnpackArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let names = &args.names;
    let device = names.device()?;
    let described = names.described(device.as_ref());
    let configuration = stream(&args.blob, &names.input, described.node_id)?;
    let text = concise::print(&configuration, |download| described.annotate(download));
    deliver(args.output.as_deref(), text.as_bytes(), &count(&configuration), out)?;
    Ok(Outcome::Clean)
}
