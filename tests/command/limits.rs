//! Huge input is refused by a message that names the limit; tests/memory has what is below it.

use std::fmt::Write;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

/// How much memory the command may ask for: eight times the file, and what a process takes for nothing.
#[cfg(target_os = "linux")]
fn limit_kib(bytes: usize) -> usize {
    8 * bytes / 1024 + 16 * 1024
}

#[test]
fn a_file_over_the_limit_is_refused() {
    let mut file = tempfile::Builder::new().suffix(".eds").tempfile().unwrap();
    file.write_all(b"[FileInfo]\n").unwrap();
    let output =
        Command::new(crate::program()).args(["check", "--max-size", "5"]).arg(file.path()).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("has 11 bytes") && message.contains("--max-size"), "{message}");
}

/// The exit code and the messages of a command that runs in `folder`, with a limit on its memory of so many KiB.
#[cfg(target_os = "linux")]
fn refusal(folder: &Path, kib: usize, line: &str) -> (Option<i32>, String) {
    let script = format!("ulimit -d {kib} && exec \"$0\" {line}");
    let program = crate::program();
    let output = Command::new("sh").args(["-c", &script, program]).current_dir(folder).output().unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[cfg(target_os = "linux")]
#[test]
fn compact_storage_does_not_explode() {
    let folder = tempfile::tempdir().unwrap();
    let compact = |number| {
        format!("[{:X}]\nObjectType=8\nDataType=7\nAccessType=rw\nCompactSubObj=254\n", 0x2000 + number)
    };
    // what is compared and what is carried is not in memory at once for all entries
    fs::write(folder.path().join("some.eds"), (0..40).map(compact).collect::<String>()).unwrap();
    assert_eq!(refusal(folder.path(), 36 * 1024, "convert some.eds -o some.xdd").0, Some(0));
    // a conversion and a simulated node of these took 250 MB
    fs::write(folder.path().join("more.eds"), (0..980).map(compact).collect::<String>()).unwrap();
    for line in ["convert more.eds -o more.xdd", "conformance more.eds"] {
        assert_eq!(refusal(folder.path(), 18 * 1024, line).0, Some(2), "{line}");
    }
    let many: String = (0..4000).map(compact).collect();
    fs::write(folder.path().join("many.eds"), &many).unwrap();
    for line in [
        "convert many.eds -o many.xdd",
        "convert many.eds -o many.json",
        "generate many.eds --target c -o out",
        "docs many.eds -o many.html",
        "show many.eds",
        "dcf pack many.eds --all --node-id 1 -o many.cdcf",
        "configure many.eds --node-id 1 -o many.dcf",
    ] {
        let (code, message) = refusal(folder.path(), limit_kib(many.len()), line);
        assert_eq!(code, Some(2), "{line}: {message}");
        let limit = 25_000 + many.len() / 64;
        let expected = format!("has 1016000 entries in compact storage, more than the limit of {limit}");
        assert!(message.contains(&expected), "{line}: {message}");
        assert!(message.contains("increase the limit with `--max-entries`"), "{line}: {message}");
    }
    fs::write(folder.path().join("few.eds"), compact(0)).unwrap();
    let convert = "convert few.eds -o few.json --max-entries";
    assert_eq!(refusal(folder.path(), 1 << 20, &format!("{convert} 253")).0, Some(2));
    assert_eq!(refusal(folder.path(), 1 << 20, &format!("{convert} 254")).0, Some(0));
}

/// What a text may become is limited by its size, and the message says how much of what there is.
#[test]
fn small_parts_are_limited() {
    let folder = tempfile::tempdir().unwrap();
    let lines = |line: &dyn Fn(usize) -> String, count: usize| (0..count).map(line).collect::<String>();
    let network = fs::read_to_string("fixtures/nxdd/line.nxdd").unwrap();
    let end = network.find("<ISO15745ProfileContainer").unwrap();
    let containers = "<ISO15745ProfileContainer/>".repeat(200);
    let device = fs::read_to_string("fixtures/eds/minimal.eds").unwrap();
    let module = |number| format!("[M{number}Fixed2000]\nParameterName=a\n");
    let files = [
        ("eds", "xdd", "[]\n".repeat(100_000), "99999 sections", true),
        ("eds", "xdd", lines(&|number| format!("[{:X}]\n", 0x2000 + number), 10_000), "10000 objects", true),
        ("eds", "xdd", device + &lines(&module, 20_000), "values of the description", true),
        ("xdd", "eds", "<a>".repeat(100_000), "100000 elements", true),
        ("json", "eds", "[".repeat(1 << 20), "1048576 values", true),
        ("xdd", "eds", network[..end].to_owned() + &containers + &network[end..], "devices", false),
    ];
    for (from, to, text, what, is_raised) in files {
        let name = format!("a.{from}");
        fs::write(folder.path().join(&name), text).unwrap();
        let line = ["convert", &name, "--from", from, "--to", to, "-o", "out"];
        let output = Command::new(crate::program()).args(line).current_dir(&folder).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(message.contains(what), "{name}: {message}");
        assert_eq!(
            message.contains("increase the limit with `--max-entries`"),
            is_raised,
            "{name}: {message}"
        );
    }
}

/// The items of a list are found in a table: a finding does not walk through all objects of an XDD.
#[test]
fn items_of_lists_in_an_xdd_are_located_in_linear_time() {
    let folder = tempfile::tempdir().unwrap();
    let (first, count) = (0x2000, 20_000);
    let mut eds = format!("[ManufacturerObjects]\nSupportedObjects={count}\n");
    for number in 0..count {
        let _ = writeln!(eds, "{}=0x{:04X}", number + 1, first + number);
    }
    for index in first..first + count {
        let _ = write!(eds, "[{index:04X}]\nParameterName=A\nObjectType=7\nDataType=5\nAccessType=rw\n");
    }
    fs::write(folder.path().join("a.eds"), eds).unwrap();
    let run = |arguments: &[&str]| {
        let mut command = Command::new(crate::program());
        command.args(arguments).current_dir(folder.path()).output().unwrap()
    };
    assert!(run(&["convert", "a.eds", "-o", "a.xdd", "--max-entries", "80000"]).status.success());
    let start = std::time::Instant::now();
    let output = run(&["check", "a.xdd"]);
    assert!(String::from_utf8_lossy(&output.stdout).contains("cia306/wrong-object-list"));
    assert!(start.elapsed() < std::time::Duration::from_secs(10), "{:?}", start.elapsed());
}

#[cfg(target_os = "linux")]
#[test]
fn large_toml_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let tables = (0..200_000).map(|number| format!("[a{number}]\n")).collect::<String>();
    for name in ["objdict.toml", "large.toml"] {
        fs::write(folder.path().join(name), &tables).unwrap();
    }
    fs::copy("fixtures/eds/minimal.eds", folder.path().join("a.eds")).unwrap();
    for line in [
        "check a.eds",
        "check a.eds --no-config --profile large.toml",
        "configure a.eds --no-config --node-id 1 --settings large.toml",
        "generate a.eds --no-config --target c --rename large.toml -o out",
    ] {
        let (code, message) = refusal(folder.path(), 32 * 1024, line);
        assert_eq!(code, Some(2), "{line}: {message}");
        assert!(message.contains("has 1888890 bytes, more than the limit of 1048576"), "{line}: {message}");
    }
}
