//! So many files of `OBJDICT_CORPUS_DIR` other tools read at least, after safe fixes for no certain tool and in their dialects.

use std::fs;
use std::path::{Path, PathBuf};

use objdict::diagnostic::{Applicability, Tool};
use objdict::fix_for_readers;
use objdict::format::{self, Description, Dialect, WriteOptions};
use objdict::source::SourceOptions;

use super::{environment, readings};
use crate::support;
use crate::support::skips::skip;

/// What is made of each file, for whom, and the least share of files that it reads, in a thousand.
struct Goal {
    name: &'static str,
    make: fn(Description) -> Vec<u8>,
    tool: Tool,
    least: usize,
}

const PORTABLE: Goal = Goal {
    name: "portable",
    make: |description| in_dialect(&description, Dialect::Portable),
    tool: Tool::DcfTools,
    least: 890,
};

const GOALS: [Goal; 6] = [
    PORTABLE,
    Goal { tool: Tool::PythonCanopen, least: 1000, ..PORTABLE },
    Goal { tool: Tool::NodeCanopen, least: 1000, ..PORTABLE },
    Goal {
        name: "fixed",
        make: |description| fix_for_readers(description, Applicability::Safe, &Default::default()).bytes(),
        tool: Tool::PythonCanopen,
        least: 970,
    },
    Goal {
        name: "python-canopen",
        make: |description| in_dialect(&description, Dialect::PythonCanopen),
        tool: Tool::PythonCanopen,
        least: 1000,
    },
    // 215 of 255; the command also leaves out disabled objects, and comes to 217 of 256
    Goal {
        name: "lely",
        make: |description| in_dialect(&description, Dialect::Lely),
        tool: Tool::DcfTools,
        least: 843,
    },
];

fn in_dialect(description: &Description, dialect: Dialect) -> Vec<u8> {
    let mut options = WriteOptions::from(dialect);
    options.embed = true;
    format::write(description.device(), description.format(), &options).unwrap().bytes
}

#[test]
fn tools_read_their_share_of_the_corpus() {
    let Some(corpus) = std::env::var_os("OBJDICT_CORPUS_DIR") else {
        skip("`OBJDICT_CORPUS_DIR` names no folder");
        return;
    };
    let Some(programs) = environment() else { return };
    let files = support::files_below(Path::new(&corpus), &["eds", "dcf", "EDS", "DCF"]);
    for goal in &GOALS {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-goals").join(goal.name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let opened = files.iter().filter_map(|path| format::open(path, &SourceOptions::default()).ok());
        let paths: Vec<PathBuf> = opened
            .enumerate()
            .map(|(number, description)| {
                let ending = description.format().name().to_lowercase();
                let path = folder.join(format!("{number}.{ending}"));
                fs::write(&path, (goal.make)(description)).unwrap();
                path
            })
            .collect();
        let answers = readings(programs, &paths.iter().map(PathBuf::as_path).collect::<Vec<_>>());
        let read = answers.iter().filter(|answer| answer[goal.tool.name()].is_object()).count();
        println!("{}: {} reads {read} of {}", goal.name, goal.tool, paths.len());
        assert!(read * 1000 >= goal.least * paths.len(), "{}: {read} of {}", goal.name, paths.len());
    }
}
