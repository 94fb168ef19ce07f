//! Chores: `cargo xtask corpus FOLDER [--generate] [--shares FILE]`, `cargo xtask mutants FOLDER COUNT`,
//! `cargo xtask docs [--check]`.

#![allow(clippy::print_stdout, reason = "the table is the result of the chore")]

mod changes;
mod corpus;
mod docs;
mod generated;
mod mutants;
mod mutate;
mod round_trip;
mod shares;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
usage:
  cargo xtask corpus FOLDER [--generate] [--shares FILE]
      read, print, check and convert there and back every description below FOLDER, and print a table; with --generate also
      compile what is generated from each, with --shares write how many files each rule fires on (docs/rules-shares.tsv)
  cargo xtask mutants FOLDER COUNT
      damage the descriptions below FOLDER so often, and read, check, mend and arrange them; nothing may panic
  cargo xtask docs [--check]
      write docs/rules.md (with docs/rules-shares.tsv) and docs/portability.md; with --check only compare";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match arguments[..] {
        ["corpus", folder] => corpus::run(Path::new(folder), false, None),
        ["corpus", folder, "--generate"] => corpus::run(Path::new(folder), true, None),
        ["corpus", folder, "--shares", file] => corpus::run(Path::new(folder), false, Some(Path::new(file))),
        ["corpus", folder, "--generate", "--shares", file] => {
            corpus::run(Path::new(folder), true, Some(Path::new(file)))
        }
        ["mutants", folder, count] => match count.parse() {
            Ok(count) => mutants::run(Path::new(folder), count),
            Err(_) => Err(USAGE.to_owned()),
        },
        ["docs"] => docs::run(false),
        ["docs", "--check"] => docs::run(true),
        _ => Err(USAGE.to_owned()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
