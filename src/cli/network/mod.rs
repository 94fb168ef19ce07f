//! `objdict network`: several nodes and their manager.

mod build;
mod check;
mod diff;
mod graph;
mod show;

use std::io::Write;
use std::path::Path;

use super::args::{NetworkCommand, NetworkFormat, NetworkInputArgs, NetworkSchemaArgs};
use super::input::name_of;
use super::output::Output;
use super::save::keep;
use super::{Failure, Outcome, tell};
use crate::diagnostic::{Findings, Severity};
use crate::format::network::{NetworkFile, schema};
use crate::network::{Compiled, Manner, Network, compile};
use crate::report::plural;

pub(super) fn run(command: &NetworkCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        NetworkCommand::Check(args) => check::run(args, out),
        NetworkCommand::Build(args) => build::run(args, out),
        NetworkCommand::Show(args) => show::run(args, out),
        NetworkCommand::Graph(args) => graph::run(args, out),
        NetworkCommand::Diff(args) => diff::run(args, out),
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

/// Reads a network that is to be shown, with the configuration of its nodes. Its errors are left to `network check`.
fn compiled(path: &Path, input: &NetworkInputArgs) -> Result<(Network, Compiled), Failure> {
    let file = open(path, input)?;
    let errors = file.check().iter().filter(|finding| finding.severity == Severity::Error).count();
    let help = format!("`objdict network check {}` says which", name_of(path));
    let Some(network) = file.network else {
        return Err(Failure::new(format_args!("`{}` is no network", name_of(path))).help(help));
    };
    if errors > 0 {
        let warning = format!("the network has {}, so what it does may differ", plural(errors, "error"));
        tell(&format!("warning: {warning}\n  help: {help}\n"));
    }
    let compiled = compile(&network, Manner::Repaired, &mut Findings::new());
    Ok((network, compiled))
}

fn print_schema(args: &NetworkSchemaArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let schema = match args.format {
        NetworkFormat::Bus => schema::bus_yml(),
        NetworkFormat::Network => schema::network_toml(),
    };
    writeln!(out, "{schema:#}")?;
    Ok(Outcome::Clean)
}
