//! `objdict dcf diff`.

use std::io::Write;

use super::super::annotation::DescribedStream;
use super::super::args::DcfDiffArgs;
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::stream;
use objdict_node::concise;
use objdict_node::download::{ConciseDcf, Difference, Differences, Download};

pub(super) fn run(args: &DcfDiffArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let names = &args.names;
    let device = names.device()?;
    let described = names.described(device.as_ref());
    let first = stream(&args.first, &names.input, described.node_id)?;
    let second = stream(&args.second, &names.input, described.node_id)?;
    let found = first.differences(&second);
    differences(&found, described, out)?;
    Ok(if found.is_empty() { Outcome::Clean } else { Outcome::Findings })
}

/// Prints what two streams write differently.
pub(crate) fn differences(
    differences: &Differences,
    described: DescribedStream<'_>,
    out: &mut Output,
) -> Result<(), Failure> {
    for difference in &differences.entries {
        for (sign, side) in [('-', &difference.first), ('+', &difference.second)] {
            let text = concise::print(&downloads(difference, side), |download| described.annotate(download));
            for line in text.lines() {
                writeln!(out, "{sign} {line}")?;
            }
        }
    }
    if differences.is_reordered {
        writeln!(out, "downloads in both files are in a different order")?;
    }
    Ok(())
}

/// What one side writes to the entry.
fn downloads(difference: &Difference, side: &[Vec<u8>]) -> ConciseDcf {
    let download = |data: &Vec<u8>| Download::new(difference.index, difference.sub, data.clone());
    ConciseDcf(side.iter().map(download).collect())
}
