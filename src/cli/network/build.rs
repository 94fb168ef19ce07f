//! `objdict network build`.

use super::super::args::{NetworkBuildArgs, NetworkTarget};
use super::super::save::save;
use super::super::{Failure, Outcome, tell};
use super::open;
use crate::diagnostic::{Findings, Severity};
use crate::download::ConciseDcf;
use crate::network::{LelyOptions, Manner, Network, Slave, compile, configuration_file, lely_master};
use crate::report::{Tally, listed};

/// A file to write: its name and its bytes.
type File = (String, Vec<u8>);

pub(super) fn run(args: &NetworkBuildArgs) -> Result<Outcome, Failure> {
    let file = open(&args.file, &args.input)?;
    let findings = file.check();
    let mut tally = Tally::default();
    tally.add(&findings);
    if !findings.is_empty() {
        tell(&listed((&file.source).into(), &findings)?);
    }
    let Some(network) = &file.network else {
        return Err(Failure::new(format_args!("`{}` is no network", args.file.display())));
    };
    // what dcfgen has no word about, it builds
    let is_clear = findings.iter().all(|finding| finding.severity < Severity::Error || finding.is_understood);
    if tally.errors > 0 && !args.force && !(args.strict_dcfgen && is_clear) {
        let failure = Failure::new(format_args!("{tally}, so nothing is built"));
        failure.help("correct them; `--force` builds anyway").print();
        return Ok(Outcome::Findings);
    }
    let files = match args.target {
        NetworkTarget::Lely => lely(args, network)?,
        NetworkTarget::Concise => concise(network)?,
    };
    for (name, bytes) in files {
        save(&args.output.join(name), &bytes)?;
    }
    Ok(Outcome::Clean)
}

fn lely(args: &NetworkBuildArgs, network: &Network) -> Result<Vec<File>, Failure> {
    let manner = if args.strict_dcfgen { Manner::Strict } else { Manner::Repaired };
    let slaves = compile(network, manner, &mut Findings::new()).slaves;
    let options = LelyOptions { manner, remote_pdos: args.remote_pdo };
    let Some(master) = lely_master(network, &slaves, &options) else {
        return Err(Failure::new("a network without a manager has no files for Lely").help("add `master`"));
    };
    let mut files = vec![("master.dcf".to_owned(), master.dcf.into_bytes())];
    if !master.bin.0.is_empty() {
        files.push(("master.bin".to_owned(), written(&master.bin)?));
    }
    files.extend(streams(network, &slaves)?);
    Ok(files)
}

/// One stream a node, in an order that nodes accept.
fn concise(network: &Network) -> Result<Vec<File>, Failure> {
    let slaves = compile(network, Manner::Repaired, &mut Findings::new()).slaves;
    let stream = |slave: &Slave| {
        let node = &network.nodes[slave.node];
        let downloads = slave.arranged(node).map_err(|error| {
            Failure::new(format_args!("the configuration of `{}`: {error}", node.name.value))
        })?;
        Ok((format!("{}.cdcf", node.name.value), written(&downloads)?))
    };
    slaves.iter().map(stream).collect()
}

fn streams(network: &Network, slaves: &[Slave]) -> Result<Vec<File>, Failure> {
    let named = slaves.iter().filter_map(|slave| Some((configuration_file(network, slave)?, slave)));
    named.map(|(name, slave)| Ok((name, written(&slave.downloads)?))).collect()
}

fn written(downloads: &ConciseDcf) -> Result<Vec<u8>, Failure> {
    downloads.write().map_err(Failure::new)
}
