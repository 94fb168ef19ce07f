//! `objdict network`: several nodes and their manager.

mod build;
mod check;

use std::io::Write;
use std::path::Path;

use super::args::{NetworkCommand, NetworkFormat, NetworkInputArgs, NetworkSchemaArgs};
use super::output::Output;
use super::save::keep;
use super::{Failure, Outcome};
use crate::format::network::{NetworkFile, schema};

pub(super) fn run(command: &NetworkCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        NetworkCommand::Check(args) => check::run(args, out),
        NetworkCommand::Build(args) => build::run(args, out),
        NetworkCommand::Schema(args) => print_schema(args, out),
    }
}

/// Reads a network; none of its files is written to.
fn open(path: &Path, input: &NetworkInputArgs) -> Result<NetworkFile, Failure> {
    let file = NetworkFile::open(path, &input.define.iter().cloned().collect()).map_err(Failure::new)?;
    keep(path);
    file.files.iter().for_each(|path| keep(path));
    Ok(file)
}

fn print_schema(args: &NetworkSchemaArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let schema = match args.format {
        NetworkFormat::Bus => schema::bus_yml(),
        NetworkFormat::Network => schema::network_toml(),
    };
    writeln!(out, "{schema:#}")?;
    Ok(Outcome::Clean)
}
