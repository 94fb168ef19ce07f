//! The exit code is the verdict: 0 where the answer is yes, 1 where it is no.

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

/// A command whose answer is yes, and one whose answer is no. No description is known of which `conformance` says no.
const VERDICTS: [(&str, &str); 21] = [
    ("check good.eds", "check bad.eds"),
    ("identify good.eds", "identify good.eds notes.txt"),
    ("fmt --check good.eds", "fmt --check untidy.eds"),
    ("fmt --diff good.eds", "fmt --diff untidy.eds"),
    ("generate good.eds --target c -o new", "generate bad.eds --target c -o new"),
    (
        "configure good.eds --node-id 5 --set 1017=100 -o new.dcf",
        "configure good.eds --node-id 5 --set 1017=70000 -o new.dcf",
    ),
    ("convert good.eds -o new.json --deny-loss", "convert good.toml -o new.eds --no-embed --deny-loss"),
    ("diff good.eds good.eds", "diff good.eds other.eds"),
    ("release good.eds good.eds", "release good.eds other.eds"),
    ("dcf diff one.cdcf.txt one.cdcf.txt", "dcf diff one.cdcf.txt two.cdcf.txt"),
    (
        "dcf verify one.cdcf.txt --eds good.eds --node-id 5",
        "dcf verify refused.cdcf.txt --eds good.eds --node-id 5",
    ),
    ("probe good.eds --answers right.log", "probe good.eds --answers wrong.log"),
    ("decode right.log --with 5=good.eds --check", "decode wrong.log --with 5=good.eds --check --deny note"),
    ("patch check good.eds -p fits.patch.toml", "patch check good.eds -p misfits.patch.toml"),
    ("network check net.toml", "network check twice.toml"),
    ("network build net.toml --target dcf -o new", "network build twice.toml --target dcf -o new"),
    ("network boot net.toml", "network boot other-type.toml"),
    ("network timing net.toml", "network timing unbounded.toml"),
    ("network timing unbounded.toml --allow-unbounded", "network timing late.toml --allow-unbounded"),
    ("network diff net.toml net.toml", "network diff net.toml unbounded.toml"),
    ("network verify built", "network verify changed"),
];

const NETWORK: &str = "[bus]\nbit-rate = 250\nmanager = \"plc\"\nunused-pdos = \"off\"\n\n[manager]\nid = 1\n\n\
    [node.a]\nfile = \"good.eds\"\nid = 5\n\n[[link]]\nfrom = \"a.6000:1-2\"\nto = \"plc\"\ntransmission = \"event\"\ninhibit = \"10ms\"\n";

fn run(folder: &Path, line: &str) -> (Option<i32>, String) {
    let output =
        Command::new(crate::program()).args(line.split_whitespace()).current_dir(folder).output().unwrap();
    (output.status.code(), String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned())
}

fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let eds = fs::read_to_string("fixtures/eds/io-401.eds").unwrap().replace("io-401.eds", "good.eds");
    let edited = |from: &str, to: &str| {
        assert!(eds.contains(from), "{from}");
        eds.replacen(from, to, 1)
    };
    write("good.eds", &eds);
    write(
        "bad.eds",
        &edited(
            "ParameterName=Device type\r\nObjectType=0x7\r\nDataType=0x0007",
            "ObjectType=0x7\r\nDataType=0x00FF",
        ),
    );
    write("untidy.eds", &edited("ObjectType=0x7", "ObjectType = 0x7"));
    write(
        "other.eds",
        &edited("time\r\nObjectType=0x7\r\nDataType=0x0006", "time\r\nObjectType=0x7\r\nDataType=0x0007"),
    );
    fs::copy("fixtures/toml/io.toml", folder.path().join("good.toml")).unwrap();
    let log = |value: &str| format!("(1.0) can0 605#4000100000000000\n(1.1) can0 585#43001000{value}\n");
    write("right.log", &log("91010F00"));
    write("wrong.log", &format!("{}(1.2) can0 185#01\n", log("92010F00")));
    write("one.cdcf.txt", "1017:00 UNSIGNED16 100\n");
    write("two.cdcf.txt", "1017:00 UNSIGNED16 200\n");
    write("refused.cdcf.txt", "1000:00 UNSIGNED32 1\n");
    let patch = |expected: u32| {
        format!(
            "format = \"objdict-patch/1\"\nvendor-id = 0x3F9\nproduct-code = 0x10\n\n[[change]]\nat = \"1017\"\n\
             expect = {{ default = {expected} }}\nset = {{ default = 7 }}\nreason = \"manual\"\n"
        )
    };
    write("fits.patch.toml", &patch(0));
    write("misfits.patch.toml", &patch(1));
    write("net.toml", NETWORK);
    let network = |from: &str, to: &str| {
        assert!(NETWORK.contains(from), "{from}");
        NETWORK.replacen(from, to, 1)
    };
    write("twice.toml", &network("id = 5", "id = 1"));
    write("unbounded.toml", &network("inhibit = \"10ms\"", "event-timer = \"5ms\""));
    write("late.toml", &network("10ms", "10ms\"\nevent-timer = \"20ms").replace("250", "10"));
    write("other-type.toml", &network("id = 5", "id = 5\nrevision-number = 9"));
    for built in ["built", "changed"] {
        let (code, told) = run(folder.path(), &format!("network build net.toml --target dcf -o {built}"));
        assert_eq!(code, Some(0), "{told}");
    }
    write("changed/a.dcf", "");
    write("notes.txt", "notes\n");
    folder
}

#[test]
fn the_exit_code_is_the_verdict() {
    let folder = folder();
    let mut wrong = Vec::new();
    for (yes, no) in VERDICTS {
        for (line, expected) in [(yes, 0), (no, 1)] {
            fs::remove_dir_all(folder.path().join("new")).ok();
            let (code, told) = run(folder.path(), line);
            if code != Some(expected) {
                wrong.push(format!("`{line}` exits with {code:?}, not {expected}: {told}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
