//! Malformed and huge input: no panic, no quadratic time, and memory in proportion to the file.

use std::fmt::Write;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

/// How much memory the command may ask for: eight times the file, and what a process takes for nothing.
fn limit_kib(bytes: usize) -> usize {
    8 * bytes / 1024 + 16 * 1024
}

/// Checks a text with the command, with an upper limit on its memory. Exit code 101 is a panic; a process that runs
/// out of memory is aborted and has none.
#[cfg(target_os = "linux")]
fn check(name: &str, text: &[u8]) {
    let mut file = tempfile::Builder::new().suffix(".eds").tempfile().unwrap();
    file.write_all(text).unwrap();
    let script =
        format!("ulimit -d {} && exec \"$0\" check \"$1\" --from eds --format json", limit_kib(text.len()));
    let status = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_objdict")])
        .arg(file.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .unwrap();
    assert!(matches!(status.code(), Some(0 | 1)), "{name}: {status}");
}

#[cfg(not(target_os = "linux"))]
fn check(_: &str, _: &[u8]) {
    println!("skipped: there is no limit on memory to test with on this system");
}

/// Large enough to show what grows with the file; a debug build reads it in a second.
const SIZE: usize = 4 << 20;

fn repeated(line: impl Fn(usize) -> String, bytes: usize) -> Vec<u8> {
    let mut text = String::new();
    for number in 0.. {
        if text.len() >= bytes {
            break;
        }
        text.push_str(&line(number));
    }
    text.into_bytes()
}

#[test]
fn one_line_of_many_bytes() {
    check("a value", format!("[FileInfo]\nDescription={}\n", "x".repeat(SIZE)).as_bytes());
    check("a section name", format!("[{}]\n", "1".repeat(SIZE)).as_bytes());
    check("junk", "x".repeat(SIZE).as_bytes());
    check("a number", format!("[1000]\nDefaultValue={}\n", "9".repeat(SIZE)).as_bytes());
}

#[test]
fn many_empty_lines() {
    check("line feeds", &vec![b'\n'; SIZE]);
    check("zeros", &vec![0; SIZE]);
    check("brackets", &vec![b'['; SIZE]);
}

#[test]
fn many_sections() {
    check("unknown sections", &repeated(|number| format!("[section{number}]\nKey=value\n"), SIZE));
    check("one section again and again", &repeated(|_| "[2000]\nParameterName=x\n".to_owned(), SIZE));
    check("unclosed headers", &repeated(|number| format!("[Section{number:X}\n"), SIZE));
}

#[test]
fn many_keys() {
    check(
        "unknown keys",
        &repeated(
            |number| if number == 0 { "[2000]\n".to_owned() } else { format!("Key{number}=1\n") },
            SIZE,
        ),
    );
    check(
        "one key",
        &repeated(|number| if number == 0 { "[2000]\n" } else { "DataType=1\n" }.to_owned(), SIZE),
    );
    let list =
        |number| if number == 0 { "[OptionalObjects]\n".to_owned() } else { format!("{number}=0x1000\n") };
    check("a long list", &repeated(list, SIZE));
    let backwards = |number: usize| {
        if number == 0 {
            "[OptionalObjects]\n".to_owned()
        } else {
            format!("{}=0x1000\n", 9_999_999 - number)
        }
    };
    check("a list backwards", &repeated(backwards, SIZE));
}

#[test]
fn many_objects() {
    let entry = |number: usize| {
        let (index, sub) = (0x1000 + (number >> 8), number & 0xFF);
        let mut text = String::new();
        if sub == 0 {
            let _ =
                write!(text, "[{index:X}]\nParameterName=Record {index:X}\nObjectType=0x9\nSubNumber=256\n");
        }
        let _ = write!(
            text,
            "[{index:X}sub{sub:X}]\nParameterName=Parameter {sub}\nDataType=0x0007\nAccessType=rw\nLowLimit=1\nHighLimit=2\nDefaultValue=300\n"
        );
        text
    };
    check("objects", &repeated(entry, SIZE));
    let compact = |number: usize| {
        format!(
            "[{:X}]\nObjectType=8\nDataType=7\nAccessType=rw\nCompactSubObj=254\n",
            0x1000 + number % 0xF000
        )
    };
    check("compact objects", &repeated(compact, SIZE / 4));
}

#[test]
fn a_file_over_the_limit_is_refused() {
    let mut file = tempfile::Builder::new().suffix(".eds").tempfile().unwrap();
    file.write_all(b"[FileInfo]\n").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_objdict"))
        .args(["check", "--max-size", "5"])
        .arg(file.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("has 11 bytes") && message.contains("--max-size"), "{message}");
}

/// The exit code and the messages of a command that runs in `folder`, with a limit on its memory of so many KiB.
#[cfg(target_os = "linux")]
fn refusal(folder: &Path, kib: usize, line: &str) -> (Option<i32>, String) {
    let script = format!("ulimit -d {kib} && exec \"$0\" {line}");
    let program = env!("CARGO_BIN_EXE_objdict");
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
        assert!(message.contains("has 1016000 entries in compact storage, more than the limit of 250000"));
        assert!(message.contains("raise the limit with `--max-entries`"), "{line}: {message}");
    }
    fs::write(folder.path().join("few.eds"), compact(0)).unwrap();
    let convert = "convert few.eds -o few.json --max-entries";
    assert_eq!(refusal(folder.path(), 1 << 20, &format!("{convert} 253")).0, Some(2));
    assert_eq!(refusal(folder.path(), 1 << 20, &format!("{convert} 254")).0, Some(0));
}

/// An XDD with a communication network profile around `objects`.
fn xdd(objects: &str, behind: &str) -> String {
    let schema = "http://www.w3.org/2001/XMLSchema-instance";
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<ISO15745ProfileContainer xmlns:xsi=\"{schema}\"><ISO15745Profile>\
         <ProfileBody xsi:type=\"ProfileBody_CommunicationNetwork_CANopen\"><ApplicationLayers><CANopenObjectList>{objects}\
         </CANopenObjectList></ApplicationLayers>{behind}</ProfileBody></ISO15745Profile></ISO15745ProfileContainer>\n"
    )
}

/// The promise of the README: 20 times the file and 50 MB. The limit of the system counts what is asked for, and is stricter than what is
/// in use at once.
#[cfg(target_os = "linux")]
#[test]
fn memory_is_in_proportion_to_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let lines = |line: &dyn Fn(usize) -> String, count: usize| (0..count).map(line).collect::<String>();
    let bombs = [
        ("brackets.eds", "[]\n".repeat(65_000)),
        ("many-brackets.eds", "[]\n".repeat(300_000)),
        ("sections.eds", lines(&|number| format!("[a{number}]\n"), 80_000)),
        ("long.eds", format!("[FileInfo]\nDescription={}\n", "x".repeat(1 << 20))),
        ("objects.xdd", xdd(&"<CANopenObject/>".repeat(100_000), "")),
        ("many-objects.xdd", xdd(&"<CANopenObject/>".repeat(300_000), "")),
        ("unknown.xdd", xdd("", &"<zz/>".repeat(70_000))),
        (
            "twice.xdd",
            xdd(&"<CANopenObject index=\"2000\" name=\"a\" objectType=\"7\"/>\n".repeat(40_000), ""),
        ),
        ("deep.xdd", xdd("", &"<a>".repeat(60_000))),
        ("lists.json", "[".repeat(1 << 20)),
    ];
    for (name, text) in &bombs {
        fs::write(folder.path().join(name), text).unwrap();
        let kib = (20 * text.len() + 50_000_000) / 1024;
        let other = if name.ends_with("xdd") { "eds" } else { "xdd" };
        for line in [
            format!("check {name}"),
            format!("convert {name} -o out.{other}"),
            format!("convert {name} -o out.json"),
        ] {
            let (code, message) = refusal(folder.path(), kib, &line);
            let is_refused =
                name.starts_with("many") && !(name.ends_with("eds") && line.starts_with("check"));
            assert!(matches!(code, Some(0..=2)), "{line}: {code:?} {message}");
            if is_refused {
                assert_eq!(code, Some(2), "{line}: {message}");
                assert!(
                    message.contains("more than the limit of") && message.contains("--max-entries"),
                    "{message}"
                );
            } else if *name != "lists.json" && *name != "deep.xdd" {
                assert_ne!(code, Some(2), "{line}: {message}");
            }
        }
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
        let mut command = Command::new(env!("CARGO_BIN_EXE_objdict"));
        command.args(arguments).current_dir(folder.path()).output().unwrap()
    };
    assert!(run(&["convert", "a.eds", "-o", "a.xdd"]).status.success());
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
