//! A file as it was at a revision of its git repository.

use std::ffi::OsString;
use std::io::{self, ErrorKind, Read};
use std::path::Path;
use std::process::{Command, Stdio};

use super::ending::Failure;
use super::input::name_of;
use objdict_format::ReadError;
use objdict_model::source;

/// The bytes of a file at a revision, as git has stored them; `None` if it has no such file there.
pub(super) fn read(revision: &str, path: &Path, max_size: u64) -> Result<Option<Vec<u8>>, Failure> {
    let name = path.file_name().filter(|_| path != Path::new("-"));
    let name =
        name.ok_or_else(|| Failure::new(format!("`{}` is not a file in a git repository", name_of(path))))?;
    // git would take it as an option
    if revision.starts_with('-') {
        return Err(Failure::new(format!("`{revision}` is not a git revision")));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut object = OsString::from(format!("{revision}:./"));
    object.push(name);
    let mut command = Command::new("git");
    command.arg("-C").arg(folder).args(["show", "--no-textconv"]).arg(object).env("LC_ALL", "C");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut git = command.spawn().map_err(|error| not_started(&error))?;
    let stored =
        git.stdout.take().map(|stdout| source::read_stream(stdout, &name_of(path), max_size, Vec::new()));
    let mut complaint = String::new();
    if let Some(stderr) = git.stderr.take() {
        let _ = stderr.take(MAX_COMPLAINT).read_to_string(&mut complaint);
    }
    let is_done = git.wait().is_ok_and(|status| status.success());
    match stored {
        Some(Err(error)) => Err(ReadError::from(error).into()),
        Some(Ok(bytes)) if is_done => Ok(Some(bytes)),
        _ if MISSING.iter().any(|text| complaint.contains(text)) => Ok(None),
        _ => Err(refused(revision, path, &complaint)),
    }
}

/// Parts of the messages of git about a missing file.
const MISSING: [&str; 2] = ["does not exist", "but not in"];

/// So much of what git says is read.
const MAX_COMPLAINT: u64 = 4096;

fn not_started(error: &io::Error) -> Failure {
    match error.kind() {
        ErrorKind::NotFound => {
            Failure::new("cannot find git, which provides the former version of the file").help("install git")
        }
        _ => Failure::new(format!("cannot start git: {error}")),
    }
}

/// Why git does not have the file.
fn refused(revision: &str, path: &Path, complaint: &str) -> Failure {
    let name = name_of(path);
    let says = |text: &str| complaint.contains(text);
    if says("not a git repository") {
        return Failure::new(format!("`{name}` is not in a git repository"));
    }
    if says("invalid object name") || says("unknown revision") || says("bad revision") {
        let failure = Failure::new(format!("git has no revision `{revision}`"));
        return failure.help("fetch it first: `git fetch origin main` for `origin/main`");
    }
    let first = complaint.lines().next().unwrap_or_default();
    Failure::new(format!("git cannot read `{name}` at `{revision}`: {first}"))
}
