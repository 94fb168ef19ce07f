//! `objdict open`: the workbench in a browser, with files of this computer.

#[cfg(feature = "open")]
mod files;
#[cfg(feature = "open")]
mod http;
#[cfg(feature = "open")]
mod server;

use super::args::OpenArgs;
use super::outcome::{Failure, Outcome};
use super::output::Output;

#[cfg(feature = "open")]
pub(super) fn run(args: &OpenArgs, out: &mut Output) -> Result<Outcome, Failure> {
    server::run(args, out)
}

#[cfg(not(feature = "open"))]
pub(super) fn run(_: &OpenArgs, _: &mut Output) -> Result<Outcome, Failure> {
    let help = "install a package, or build the page and then the command with `--features open` \
                (docs/workbench.md); `web/dist/objdict-workbench.html` opens files without the command";
    Err(Failure::new("this `objdict` was built without the workbench").help(help))
}
