//! The output of a build script, its lines for Cargo, and its errors.

use std::fs;
use std::path::Path;

use objdict::build_script::{Builder, Built, Error, Level, OutputError, Severity};
use objdict::format::input::FileKind;
use objdict::generate::{Names, Target};
use tempfile::TempDir;

fn fixture(path: &str) -> std::path::PathBuf {
    Path::new("fixtures").join(path)
}

/// The output and the lines for Cargo.
fn run(builder: Builder) -> (Result<Built, Error>, String) {
    let mut cargo = Vec::new();
    let built = builder.generate_to(&mut cargo);
    (built, String::from_utf8(cargo).unwrap())
}

/// The lines for Cargo of one kind.
fn told<'a>(cargo: &'a str, key: &str) -> Vec<&'a str> {
    let start = format!("cargo:{key}=");
    cargo.lines().filter_map(|line| line.strip_prefix(start.as_str())).collect()
}

fn names(built: &Built) -> Vec<String> {
    built.files.iter().map(|file| file.file_name().unwrap().to_string_lossy().into_owned()).collect()
}

#[test]
fn the_simple_case() {
    let out = TempDir::new().unwrap();
    let eds = fixture("eds/minimal.eds");
    let (built, cargo) = run(Builder::new(&eds).out_dir(out.path()));
    let built = built.unwrap();
    assert_eq!(names(&built), ["od.rs"]);
    assert_eq!((built.objects, built.entries), (5, 9));
    assert_eq!(cargo, format!("cargo:rerun-if-changed={}\n", eds.display()));
    let text = fs::read_to_string(out.path().join("od.rs")).unwrap();
    assert!(text.contains("pub mod identity_object"), "{text}");
}

/// The command and the builder write the same bytes.
#[test]
fn the_command_writes_the_same() {
    let (ours, theirs) = (TempDir::new().unwrap(), TempDir::new().unwrap());
    let file = fixture("dcf/io-401-node5.dcf");
    let builder = Builder::new(&file).out_dir(ours.path()).target(Target::RUST).target(Target::C);
    let builder = builder.target(Target::CONCISE).string_capacity(12).names(Names::Index).prefix("io");
    let built = run(builder).0.unwrap();
    let status = std::process::Command::new(crate::program())
        .arg("generate")
        .arg(&file)
        .args(["--target", "rust,c,concise", "--string-capacity", "12", "--names", "index", "--prefix", "io"])
        .arg("--output")
        .arg(theirs.path())
        .output()
        .unwrap();
    assert!(status.status.success(), "{}", String::from_utf8_lossy(&status.stderr));
    let files = names(&built);
    assert_eq!(fs::read_dir(theirs.path()).unwrap().count(), files.len() + 1, "and the list of files");
    for name in ["od.rs", "io.h", "io.c", "io-401-node5.cdcf"] {
        assert!(files.iter().any(|file| file == name), "{name} is not in {files:?}");
    }
    for name in files {
        assert_eq!(fs::read(ours.path().join(&name)).unwrap(), fs::read(theirs.path().join(&name)).unwrap());
    }
}

#[test]
fn every_format_is_read() {
    let out = TempDir::new().unwrap();
    for file in ["eds/drive-402.eds", "dcf/io-401-node5.dcf", "xdd/io-401.xdd", "toml/drive.toml"] {
        let built = run(Builder::new(fixture(file)).out_dir(out.path())).0;
        assert_eq!(names(&built.unwrap()), ["od.rs"], "{file}");
    }
    let device = objdict::format::open(&fixture("eds/minimal.eds"), &Default::default()).unwrap();
    let json = out.path().join("device.json");
    fs::write(&json, objdict::format::json::write_device(device.device())).unwrap();
    for builder in [Builder::new(&json), Builder::new(&json).from_kind(FileKind::Json)] {
        assert_eq!(names(&run(builder.out_dir(out.path())).0.unwrap()), ["od.rs"]);
    }
}

/// One source makes the tables and the EDS and XDD that go with the firmware, as `objdict convert` writes them.
#[test]
fn descriptions_are_written_beside_the_tables() {
    let out = TempDir::new().unwrap();
    let source = fixture("toml/drive.toml");
    let (eds, xdd) = (out.path().join("shipped/drive.eds"), out.path().join("shipped/drive.xdd"));
    let builder = || Builder::new(&source).out_dir(out.path().join("od")).convert_to(&eds).convert_to(&xdd);
    let (built, cargo) = run(builder());
    assert_eq!(names(&built.unwrap()), ["od.rs", "drive.eds", "drive.xdd"]);
    assert_eq!(told(&cargo, "rerun-if-changed"), [source.display().to_string()]);
    assert!(!cargo.contains("lost: "), "{cargo}");
    for file in [&eds, &xdd] {
        let converted = out.path().join(file.file_name().unwrap());
        let status = std::process::Command::new(crate::program())
            .arg("convert")
            .arg(&source)
            .arg("-o")
            .arg(&converted)
            .output()
            .unwrap();
        assert!(status.status.success(), "{}", String::from_utf8_lossy(&status.stderr));
        assert_eq!(fs::read_to_string(file).unwrap(), fs::read_to_string(&converted).unwrap());
    }
    let modified = || fs::metadata(&eds).unwrap().modified().unwrap();
    let before = modified();
    run(builder()).0.unwrap();
    assert_eq!(modified(), before, "what is the same is not written");
}

/// A description is neither written over the one that it is made of nor in a format that cannot describe it, and then there are
/// no tables either.
#[test]
fn descriptions_that_cannot_be_written() {
    let out = TempDir::new().unwrap();
    let source = out.path().join("drive.eds");
    fs::copy(fixture("eds/drive-402.eds"), &source).unwrap();
    let to = |name: &str| {
        let od = out.path().join("od");
        let builder = Builder::new(&source).out_dir(&od).convert_to(out.path().join(name));
        let error = run(builder).0.unwrap_err();
        assert!(!od.join("od.rs").exists(), "{name}");
        error
    };
    assert!(matches!(to("drive.eds"), Error::Output(OutputError::InUse { .. })));
    for name in ["drive.pdf", "drive.dbc", "drive.od", "drive.dcf"] {
        let shown = format!("{:?}", to(name));
        assert!(shown.starts_with("the description cannot be written as `"), "{shown}");
        assert!(shown.ends_with("  help: name a file that ends in .eds or .xdd"), "{shown}");
    }
    assert_eq!(fs::read(&source).unwrap(), fs::read(fixture("eds/drive-402.eds")).unwrap());
}

/// What an EDS has no place for, even in comments, is a warning.
#[test]
fn losses_of_a_written_description_are_warnings() {
    let out = TempDir::new().unwrap();
    let source = fixture("xdd/press-402.xdd");
    let (built, cargo) = run(Builder::new(&source).out_dir(out.path()).convert_to(out.path().join("a.eds")));
    built.unwrap();
    assert!(told(&cargo, "warning").iter().any(|line| line.contains("a.eds: lost: ")), "{cargo}");
}

#[test]
fn what_is_the_same_is_not_written() {
    let out = TempDir::new().unwrap();
    let make = || run(Builder::new(fixture("eds/minimal.eds")).out_dir(out.path())).0.unwrap();
    let time = |built: &Built| fs::metadata(&built.files[0]).unwrap().modified().unwrap();
    let first = make();
    let written = time(&first);
    let second = make();
    assert_eq!(second, first);
    assert_eq!(time(&second), written);
}

/// What `main` returns is what the user of a build script sees.
#[test]
fn an_error_in_the_description_fails_the_build() {
    let out = TempDir::new().unwrap();
    let eds = fixture("torture/22_default_overflow.eds");
    let (built, cargo) = run(Builder::new(&eds).out_dir(out.path()));
    let error = built.unwrap_err();
    assert_eq!(told(&cargo, "rerun-if-changed"), [eds.display().to_string()]);
    assert!(matches!(&error, Error::Findings { findings, .. } if findings.len() == 1));
    assert_eq!(error.to_string(), format!("`{}` has 1 error, so nothing was generated", eds.display()));
    let shown = format!("Error: {error:?}\n");
    insta::assert_snapshot!("error", shown);
    assert_eq!(fs::read_dir(out.path()).unwrap().count(), 0, "nothing is written");
}

#[test]
fn an_error_can_be_made_milder_or_passed_over() {
    let out = TempDir::new().unwrap();
    let eds = fixture("torture/22_default_overflow.eds");
    let builder = || Builder::new(&eds).out_dir(out.path());
    for builder in [
        builder().force(true),
        builder().severity("cia306/invalid-value", Level::At(Severity::Warning)),
        builder().severity("cia306", Level::At(Severity::Warning)),
    ] {
        let (built, cargo) = run(builder);
        assert_eq!(names(&built.unwrap()), ["od.rs"]);
        let warnings = told(&cargo, "warning");
        assert!(
            warnings.iter().any(|line| line.contains(":139:14: ") && line.contains("is out of range")),
            "{cargo}"
        );
    }
    let (built, cargo) = run(builder().severity("cia306/invalid-value", Level::Off));
    assert!(built.is_ok());
    assert!(!cargo.contains("invalid-value"), "{cargo}");
    let error = run(builder().severity("cia306/invalid-valu", Level::Off)).0.unwrap_err();
    assert_eq!(
        format!("{error:?}"),
        "unknown rule or group `cia306/invalid-valu`\n  help: did you mean `cia306/invalid-value`?"
    );
}

/// Errors that concern no entry become warnings of the build, before those of the check.
#[test]
fn an_error_that_concerns_no_table_is_shown() {
    let out = TempDir::new().unwrap();
    let eds = out.path().join("octal.eds");
    fs::copy(fixture("broken/octal.eds"), &eds).unwrap();
    let builder = || Builder::new(&eds).out_dir(out.path()).no_config().max_warnings(0);
    let (built, cargo) = run(builder());
    assert_eq!(names(&built.unwrap()), ["od.rs"]);
    let shown = told(&cargo, "warning");
    assert!(shown[0].contains(" error cia306/invalid-value: "), "{cargo}");
    let error = run(builder().deny(Severity::Error)).0.unwrap_err();
    assert!(
        matches!(&error, Error::Findings { findings, .. } if findings.iter().all(|finding| finding.rule.id == "cia306/invalid-value"))
    );
    let known = out.path().join("known.json");
    let description = objdict::format::open(&eds, &Default::default()).unwrap();
    let mut baseline = objdict::baseline::Baseline::default();
    baseline.add("octal.eds", &description, &objdict::check(&description));
    fs::write(&known, baseline.write()).unwrap();
    let (built, cargo) = run(builder().deny(Severity::Error).baseline(&known));
    built.unwrap();
    assert!(!cargo.contains("invalid-value"), "{cargo}");
    assert!(told(&cargo, "rerun-if-changed").contains(&known.to_str().unwrap()), "{cargo}");
}

/// A warning is a line, whatever it quotes, and there is an end to them.
#[test]
fn warnings_are_lines() {
    let folder = TempDir::new().unwrap();
    let eds = folder.path().join("many.eds");
    let mut text = fs::read_to_string(fixture("eds/minimal.eds")).unwrap();
    for number in 0..50 {
        text.push_str(&format!("[junk{number}]\nKey{number}=a\u{85}cargo:rustc-cfg=x\u{1B}[31m\n"));
    }
    fs::write(&eds, text).unwrap();
    let builder = || Builder::new(&eds).out_dir(folder.path().join("out")).no_config();
    let builder = || builder().severity("cia306", Level::At(Severity::Warning));
    let (built, cargo) = run(builder().max_warnings(3));
    built.unwrap();
    let warnings = told(&cargo, "warning");
    assert_eq!(warnings.len(), 4, "{cargo}");
    assert!(warnings[3].contains(" more warnings; run `objdict check`"), "{cargo}");
    assert!(warnings[0].contains("many.eds:"), "{cargo}");
    let (_, all) = run(builder().max_warnings(10_000));
    assert!(told(&all, "warning").len() > 4, "{all}");
    for line in all.lines() {
        assert!(line.starts_with("cargo:warning=") || line.starts_with("cargo:rerun-if-changed="), "{line}");
        assert!(!line.contains(char::is_control), "{line}");
    }
}

#[test]
fn notes_of_the_target_are_reported() {
    let out = TempDir::new().unwrap();
    let (built, cargo) =
        run(Builder::new(fixture("eds/io-401.eds")).out_dir(out.path()).target(Target::CONCISE).prefix("io"));
    built.unwrap();
    let notes = told(&cargo, "warning");
    assert_eq!(notes.len(), 2, "{cargo}");
    assert!(
        notes[0].ends_with("io-401.eds: note: concise: the option `prefix` has no effect on this target"),
        "{cargo}"
    );
    assert!(notes[1].ends_with("(set values in a DCF (`ParameterValue`))"), "{cargo}");
}

/// All inputs are registered with Cargo: the configuration, the files that it names, and those of options.
#[test]
fn every_file_that_is_read_is_watched() {
    let folder = TempDir::new().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::copy(fixture("eds/drive-402.eds"), path("drive.eds")).unwrap();
    fs::copy(fixture("profiles/project-drives.toml"), path("custom.toml")).unwrap();
    fs::write(path("objdict.toml"), "profiles = [\"custom.toml\", \"401\"]\nnonsense = 1\n[rules]\ncustom = \"note\"\ncia401 = \"off\"\n\"cia306/file-name\" = \"off\"\n").unwrap();
    fs::write(path("names.toml"), "1018 = \"who am i\"\n").unwrap();
    let builder = || Builder::new(path("drive.eds")).out_dir(path("out")).rename(path("names.toml"));
    let (built, cargo) = run(builder());
    let text = fs::read_to_string(&built.unwrap().files[0]).unwrap();
    assert!(text.contains("pub mod who_am_i"), "{text}");
    let watched = ["drive.eds", "objdict.toml", "custom.toml", "names.toml"]
        .map(|name| path(name).display().to_string());
    assert_eq!(told(&cargo, "rerun-if-changed"), watched);
    assert!(
        told(&cargo, "warning")[0].contains("objdict.toml:2:1: warning objdict/unknown-setting: "),
        "{cargo}"
    );

    // another configuration, or none
    let (_, cargo) = run(builder().no_config());
    assert!(!cargo.contains("objdict.toml"), "{cargo}");
    fs::write(path("other.toml"), "node-id = 200\n").unwrap();
    let (built, cargo) = run(builder().config(path("other.toml")));
    assert!(cargo.contains("other.toml"), "{cargo}");
    let error = built.unwrap_err();
    assert!(format!("{error:?}").contains("`node-id` is a number from 1 to 127"), "{error:?}");

    // what is broken in a profile is shown
    fs::write(path("custom.toml"), "document = 7\n").unwrap();
    let error = run(builder()).0.unwrap_err();
    assert!(matches!(error, Error::Profile(_)));
    assert!(format!("{error:?}").contains("custom.toml:1:12"), "{error:?}");
}

#[test]
fn failures_say_what_to_do() {
    let out = TempDir::new().unwrap();
    let minimal = || Builder::new(fixture("eds/minimal.eds")).out_dir(out.path());
    let names = out.path().join("names.toml");
    fs::write(&names, "\nspeed = \"x\"\n").unwrap();
    let file = out.path().join("file");
    fs::write(&file, "").unwrap();
    let shown = |builder: Builder| format!("{:?}", run(builder).0.unwrap_err());
    let failures = [
        (shown(Builder::new("none.eds")), "cannot read `none.eds`: "),
        (shown(Builder::new("fixtures")), "`fixtures` is a directory\n  help: name files"),
        (
            shown(Builder::new(fixture("foreign/ethernet-ip.eds"))),
            "for EtherNet/IP, not for CANopen\n  help: ",
        ),
        (shown(minimal().node_id(0)), "target `rust`: `0` is not a valid node-ID (1 to 127)"),
        (shown(minimal().prefix("a b").target(Target::C)), "target `c`: `a b` is not an identifier"),
        (shown(minimal().rename(&names)), "names.toml:2: `speed` is not an object"),
        (shown(minimal().rename("none.toml")), "cannot read `none.toml`: "),
        (
            shown(minimal().max_ram(8)),
            "target `rust`: the tables use 24 bytes of RAM, more than the limit of 8\n  help: ",
        ),
        (shown(minimal().max_flash(8)), "bytes of flash, more than the limit of 8"),
        (shown(minimal().group(0x2000..=0x2001, "a b")), "`a b` is not"),
        (shown(minimal().profile("999")), "unknown profile `999`\n  help: write one of 301, "),
        (shown(minimal().out_dir(&file)), "cannot write `"),
        (
            shown(Builder::new(fixture("nxdd/line.nxdd")).out_dir(out.path())),
            "help: choose one with `device`",
        ),
    ];
    for (shown, expected) in failures {
        assert!(shown.contains(expected), "{shown}\nhas not: {expected}");
    }
}

#[test]
fn a_missing_folder_for_the_files_is_reported() {
    // Cargo sets the variable for build scripts only
    if std::env::var_os("OUT_DIR").is_none() {
        let error = run(Builder::new(fixture("eds/minimal.eds"))).0.unwrap_err();
        assert!(matches!(error, Error::NoOutDir));
    }
}

/// What the build script writes replaces what it wrote, and no input.
#[test]
fn files_of_others_stay() {
    let out = TempDir::new().unwrap();
    let eds = out.path().join("od.rs");
    fs::copy(fixture("eds/minimal.eds"), &eds).unwrap();
    let error = run(Builder::new(&eds).out_dir(out.path()).overwrite(true).no_config()).0.unwrap_err();
    assert!(matches!(error, Error::Output(OutputError::InUse { .. })), "{error:?}");
    assert_eq!(fs::read(&eds).unwrap(), fs::read(fixture("eds/minimal.eds")).unwrap());
    fs::remove_file(&eds).unwrap();

    let builder = || {
        let builder = Builder::new(fixture("dcf/io-401-node5.dcf")).out_dir(out.path());
        builder.target(Target::RUST).target(Target::CONCISE)
    };
    let path = out.path().join("io-401-node5.cdcf");
    fs::write(&path, "by hand").unwrap();
    let error = run(builder()).0.unwrap_err();
    assert!(matches!(error, Error::Output(OutputError::Foreign { .. })), "{error:?}");
    assert!(
        format!("{error:?}")
            .ends_with("\n  help: choose a different folder, or replace the file with `overwrite`")
    );
    assert_eq!(fs::read(&path).unwrap(), b"by hand");
    assert!(!out.path().join("od.rs").exists(), "nothing is written");
    run(builder().overwrite(true)).0.unwrap();
    run(builder()).0.unwrap();
    run(builder().node_id(7)).0.unwrap();
    fs::write(&path, "changed").unwrap();
    let error = run(builder()).0.unwrap_err();
    assert!(matches!(error, Error::Output(OutputError::Changed { .. })), "{error:?}");
}

/// The forms of an address.
#[test]
fn hooks_and_names_take_numbers() {
    let out = TempDir::new().unwrap();
    let text = |builder: Builder| {
        let built = run(builder.out_dir(out.path())).0.unwrap();
        fs::read_to_string(&built.files[0]).unwrap()
    };
    let new = || Builder::new(fixture("eds/io-401.eds"));
    let address = |text: &str| text.parse::<objdict::model::Address>().unwrap();
    let old = new().hook(address("1017")).hook(address("6200:1")).name_of(address("1017"), "beat");
    assert_eq!(text(new().hook(0x1017).hook((0x6200, 1)).name_of(0x1017, "beat")), text(old));
    assert_ne!(text(new().hook(0x1017)), text(new()));
}

/// What is accepted is not reported, and what accepts nothing is.
#[test]
fn notes_and_warnings_are_accepted() {
    let out = TempDir::new().unwrap();
    let told_of = |what: &[&str]| {
        let builder =
            Builder::new(fixture("eds/drive-402.eds")).out_dir(out.path()).target(Target::CANOPENNODE);
        let builder = what.iter().fold(builder.max_warnings(1000), |builder, what| builder.accept(*what));
        let (built, cargo) = run(builder);
        built.unwrap();
        told(&cargo, "warning").into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let all = told_of(&[]);
    assert!(all.iter().any(|line| line.contains("1005h is described without 1006h")), "{all:#?}");
    let left = told_of(&["1005h is described without 1006h"]);
    assert_eq!(all.len(), left.len() + 1, "{left:#?}");
    let left = told_of(&["canopennode: ", "cia306/no-such-rule"]);
    let last = format!(
        "{}: `accept` matches no `cia306/no-such-rule`: remove it",
        fixture("eds/drive-402.eds").display()
    );
    assert_eq!(left, [last]);
}

/// The order of targets changes no path, for each pair of targets and for all.
#[test]
fn the_order_of_targets_changes_no_path() {
    let out = TempDir::new().unwrap();
    let template = out.path().join("list.txt.j2");
    fs::write(&template, "{{ device }}").unwrap();
    let paths = |targets: &[Target]| {
        let folder = TempDir::new().unwrap();
        let builder =
            Builder::new(fixture("dcf/io-401-node5.dcf")).template(&template).out_dir(folder.path());
        let (built, _) = run(targets.iter().fold(builder, |builder, target| builder.target(*target)));
        let files = built.unwrap().files;
        let mut paths: Vec<_> =
            files.iter().map(|file| file.strip_prefix(folder.path()).unwrap().to_owned()).collect();
        paths.sort();
        let one_case: std::collections::BTreeSet<String> =
            paths.iter().map(|path| path.to_str().unwrap().to_ascii_lowercase()).collect();
        assert_eq!(one_case.len(), paths.len(), "{paths:?}");
        paths
    };
    let all: Vec<Target> = Target::all().collect();
    for (at, &one) in all.iter().enumerate() {
        for &other in &all[at + 1..] {
            assert_eq!(paths(&[one, other]), paths(&[other, one]), "{one:?} {other:?}");
        }
    }
    let reversed: Vec<Target> = all.iter().rev().copied().collect();
    assert_eq!(paths(&all), paths(&reversed));
}
