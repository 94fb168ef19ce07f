//! `objdict open`: the workbench in a browser, with files of this computer.

mod files;
mod http;
mod server;

pub(super) use self::server::run;
