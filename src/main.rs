//! The command `objdict`.

use std::process::ExitCode;

fn main() -> ExitCode {
    objdict::cli::run()
}
