//! What is asked before a device is changed.

use std::io::{self, BufRead, IsTerminal};

use crate::args::BusChangeArgs;
use crate::ending::{Failure, tell};

/// Asks whether something is to be done; `Ok(false)` means that the user declines, or that nothing is to be sent (`--dry-run`).
pub(super) fn agrees(args: &BusChangeArgs, what: &str) -> Result<bool, Failure> {
    if args.dry_run {
        tell("dry run: nothing is written\n");
        return Ok(false);
    }
    if args.yes {
        return Ok(true);
    }
    if !io::stdin().is_terminal() {
        let failure = Failure::new("nothing is written without a confirmation");
        return Err(failure.help("check the list, then pass `--yes`"));
    }
    tell(&format!("{what} [y/N] "));
    let mut answer = String::new();
    io::stdin().lock().read_line(&mut answer)?;
    let agrees = matches!(answer.trim(), "y" | "Y" | "yes");
    if !agrees {
        tell("nothing is written\n");
    }
    Ok(agrees)
}
