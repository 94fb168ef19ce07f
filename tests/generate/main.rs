//! Generated code compiles without warnings and answers as described: for every valid fixture, the answers of
//! the Rust and the C table are compared with those expected from the model, and thus with each other.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod batch;
mod bench_table;
mod compile;
mod crates;
mod defaults;
mod devices;
mod gates;
mod handles;
mod hooks;
#[cfg(feature = "full")]
mod live;
mod meanings;
mod misra;
mod node_size;
mod notes;
mod odd;
mod oracle;
mod output;
mod pdo;
mod processors;
mod script;
mod size;
mod stacks;
mod stored;
#[path = "../support/mod.rs"]
mod support;
#[cfg(feature = "template")]
mod template;
mod thumb;
mod verdicts;
mod words;

use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Options, Target, generate};
use objdict::model::Device;

use batch::{Part, TABLES};
use compile::{DRIVER, c_compiler, cc, driver, generate_into, rustc, succeed};
use devices::{arbitrary_devices, device, devices, for_all};
use processors::build;
use script::Script;
use verdicts::Key;

/// The first answers that differ from the expected ones.
fn compare(name: &str, language: &str, script: &Script, output: &str) -> Result<(), String> {
    let answers: Vec<&str> = output.lines().collect();
    let pairs = script.expected.iter().map(String::as_str).zip(answers.iter().copied());
    let mut differences: Vec<String> = pairs
        .enumerate()
        .filter(|(_, (expected, answer))| expected != answer)
        .map(|(line, (expected, answer))| {
            format!("answer {line}: `{answer}` where `{expected}` was expected")
        })
        .take(5)
        .collect();
    if answers.len() != script.expected.len() {
        differences.push(format!("{} answers where {} were expected", answers.len(), script.expected.len()));
    }
    if differences.is_empty() {
        return Ok(());
    }
    Err(format!("{name}, {language}:\n{}", differences.join("\n")))
}

/// The program of the test below.
fn answers(name: &str, device: &Device) -> Part {
    let script = script::without_hooks(device);
    Part::new(&format!("answers {name}"), DRIVER, &(script.input, script.expected))
}

#[test]
fn rust_and_c_answer_as_the_description_says() {
    let compiler = c_compiler();
    let answers = AtomicUsize::new(0);
    for_all(&[devices(), arbitrary_devices(8)].concat(), |(name, device)| {
        let script = script::without_hooks(device);
        answers.fetch_add(script.expected.len(), Ordering::Relaxed);
        let fail = |error: String| format!("{name}: {error}");
        let in_rust = |answers: &str| compare(name, "Rust", &script, answers);
        TABLES.check(&format!("answers {name}"), &script.input, in_rust).map_err(fail)?;

        let Some(compiler) = &compiler else { return Ok(()) };
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        generate_into(folder, device, "c");
        let mut cc = cc(compiler, folder);
        cc.args(["-I.", "-o", "in-c", "od.c"]).arg(driver("driver.c"));
        let compare = |answers: &str| compare(name, "C", &script, answers);
        build(&cc).check(&[], &script.input, &script.expected, compare).map_err(fail)
    });
    let answers = answers.into_inner();
    assert!(answers > 150_000, "only {answers} answers were compared");
}

/// Code generated from malformed files and arbitrary devices compiles too, unless generation fails with an
/// error.
#[test]
fn what_damaged_and_arbitrary_descriptions_give_compiles() {
    let folder = tempfile::tempdir().unwrap();
    let mut paths = support::files("broken", &["eds", "dcf"]);
    paths.extend(support::files("torture", &["eds"]));
    paths.extend(support::files("errata", &["eds"]));
    let damaged = paths.into_iter().map(|path| (path.display().to_string(), device(&path)));
    let devices: Vec<(String, Device)> = damaged.chain(arbitrary_devices(60)).collect();
    let (mut modules, mut sources, mut keys) = (String::from("#![no_std]\n"), Vec::new(), Vec::new());
    let mut count = 0;
    let mut rustc = rustc(folder.path());
    rustc.args(["--crate-type=lib", "--emit=metadata", "all.rs"]);
    let mut cc = c_compiler().map(|compiler| cc(&compiler, folder.path()));
    if let Some(cc) = &mut cc {
        cc.arg("-fsyntax-only");
    }
    for (number, (name, device)) in devices.iter().enumerate() {
        // the name is in the path of compiler errors
        let stem = name.rsplit('/').next().unwrap().replace(|c: char| !c.is_ascii_alphanumeric(), "_");
        let module = format!("{number}-{stem}");
        let folder = folder.path().join(&module);
        std::fs::create_dir(&folder).unwrap();
        let is_refused = [Target::RUST, Target::C].into_iter().any(|target| {
            let error = generate(device, target, &Options::default()).err();
            error.is_some_and(|error| !error.to_string().is_empty())
        });
        if is_refused {
            continue;
        }
        generate_into(&folder, device, "rust");
        generate_into(&folder, device, "c");
        count += 1;
        let mut key = Key::new();
        [Some(&rustc), cc.as_ref()].into_iter().flatten().for_each(|compiler| key.tool(compiler));
        key.folder(&folder);
        if !key.is_kept() {
            modules.push_str(&format!("pub mod od{number} {{ include!(\"{module}/od.rs\"); }}\n"));
            sources.push(folder.join("od.c"));
            keys.push(key);
        }
    }
    assert!(count > devices.len() / 2, "hardly anything was generated");
    if keys.is_empty() {
        return;
    }
    std::fs::write(folder.path().join("all.rs"), modules).unwrap();
    succeed(&mut rustc, "").unwrap();
    if let Some(cc) = &mut cc {
        succeed(cc.args(sources), "").unwrap();
    }
    keys.iter().for_each(Key::keep);
}
