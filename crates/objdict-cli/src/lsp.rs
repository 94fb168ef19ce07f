//! `objdict lsp`.

use lsp_server::Connection;

use super::ending::{Failure, Outcome};

/// Serves the editor at the other end of standard input and output.
pub(super) fn run() -> Result<Outcome, Failure> {
    let (connection, threads) = Connection::stdio();
    objdict_lsp::serve(&connection).map_err(Failure::new)?;
    // the thread that writes ends with the last sender
    drop(connection);
    threads.join()?;
    Ok(Outcome::Clean)
}
