//! `objdict network verify`.

use std::fs;
use std::io::Write;

use super::super::args::NetworkVerifyArgs;
use super::super::ending::{Failure, Outcome, note};
use super::super::input::name_of;
use super::super::stdout::Output;
pub(crate) use objdict_build::pipeline::{FileState, Manifest};
use objdict_model::diagnostic::plural;

pub(super) fn run(args: &NetworkVerifyArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let folder = name_of(&args.folder);
    let unusable = |error| Failure::new(format_args!("cannot read `{folder}/{}`: {error}", Manifest::NAME));
    let Some(manifest) = Manifest::open(&args.folder).map_err(unusable)? else {
        let failure = Failure::new(format_args!("`{folder}` has no `{}`", Manifest::NAME));
        return Err(failure.help("name a folder that `objdict network build` wrote"));
    };
    let (mut files, mut others, mut is_interrupted) = (0, 0, false);
    for (name, state) in manifest.verify(&args.folder) {
        let state = state.map_err(|error| Failure::new(format_args!("cannot read `{name}`: {error}")))?;
        files += 1;
        let problem = match state {
            FileState::Same => continue,
            FileState::Changed => "changed",
            FileState::Missing => "missing",
            FileState::Interrupted => {
                is_interrupted = true;
                continue;
            }
        };
        others += 1;
        writeln!(out, "{}: {problem}", name_of(&args.folder.join(name)))?;
    }
    for entry in fs::read_dir(&args.folder).into_iter().flatten().flatten() {
        let (name, path) = (entry.file_name(), entry.path());
        if path.is_file() && !manifest.lists(&name.to_string_lossy()) {
            note(&format!("note: `{}` is not in the list\n", name_of(&path)));
        }
    }
    if is_interrupted {
        writeln!(out, "{folder}: writing these files was interrupted; build them again")?;
        return Ok(Outcome::Findings);
    }
    let count = plural(files, "file");
    match others {
        0 => writeln!(out, "{folder}: {count} as written")?,
        _ => writeln!(out, "{folder}: {others} of {count} not as written")?,
    }
    Ok(if others == 0 { Outcome::Clean } else { Outcome::Findings })
}
