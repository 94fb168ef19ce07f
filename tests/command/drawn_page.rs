//! The page of `objdict decode --html`, read by Python's parser and held beside the bytes of the logs.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::support;

/// Reads a page and prints a line for each thing in it. An element that is not closed, or one that another closes, is an error.
const READER: &str = r#"
import sys
from html.parser import HTMLParser
EMPTY = {"meta", "link", "br", "input", "path", "rect"}
class Reader(HTMLParser):
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open, self.ids = [], set()
    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            assert values["id"] not in self.ids, values["id"]
            self.ids.add(values["id"])
        for key in ("data-points", "data-states"):
            if key in values:
                print(key, values["aria-label"], values[key], sep="|")
        if tag == "svg" and "aria-label" in values and not values.get("data-points") and not values.get("data-states"):
            print("lane", values["aria-label"], sep="|")
        if values.get("class", "").startswith("mark "):
            print("mark", values["class"][5:], values["data-time"], sep="|")
        if tag == "a":
            print("link", values["href"], sep="|")
        if tag not in EMPTY:
            self.open.append(tag)
    def handle_startendtag(self, tag, attributes):
        pass
    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (tag, self.open)
        self.open.pop()
reader = Reader()
reader.feed(open(sys.argv[1], encoding="utf-8").read())
assert not reader.open, reader.open
"#;

/// Prints the positions that TPDO 1 of node 5 has in an ASC log: seconds from the first frame on, and the number.
const POSITIONS: &str = r#"
import sys
first = None
for line in open(sys.argv[1]):
    parts = line.split()
    if len(parts) < 4 or parts[1] != "1" or parts[2] == "of":
        continue
    first = float(parts[0]) if first is None else first
    if parts[2] == "185":
        data = bytes(int(byte, 16) for byte in parts[6:])
        print(round(float(parts[0]) - first, 9), int.from_bytes(data[2:6], "little", signed=True))
"#;

/// Whether the tests are skipped.
fn is_without_python() -> bool {
    !support::skips::has("python3", "python3")
}

fn python(script: &str, path: &Path) -> String {
    let output = Command::new("python3").args(["-c", script]).arg(path).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn decode(arguments: &[&str], page: &Path) -> Output {
    let mut command = Command::new(crate::program());
    command.arg("decode").args(arguments).arg("--html").arg(page).output().unwrap()
}

/// What is in the page of logs.
fn read(arguments: &[&str]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.html");
    let output = decode(arguments, &page);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
    python(READER, &page).lines().map(str::to_owned).collect()
}

/// The same of a log with this text.
fn read_text(log: &str, arguments: &[&str]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.log");
    fs::write(&path, log).unwrap();
    read(&[&[path.to_str().unwrap()], arguments].concat())
}

fn of_kind<'l>(lines: &'l [String], kind: &str) -> Vec<Vec<&'l str>> {
    let parts = lines.iter().map(|line| line.split('|').collect::<Vec<_>>());
    parts.filter(|parts| parts[0] == kind).map(|parts| parts[1..].to_vec()).collect()
}

const DRIVE: [&str; 3] = ["fixtures/logs/drive.asc", "--with", "5=fixtures/eds/drive-402.eds"];

#[test]
fn a_plot_has_the_bytes_of_the_log() {
    if is_without_python() {
        return;
    }
    let lines = read(&[&DRIVE[..], &["--plot", "drive-402.6064"]].concat());
    let plots = of_kind(&lines, "data-points");
    assert_eq!(plots.len(), 1, "{lines:#?}");
    let drawn: Vec<&str> = plots[0][1].split(';').collect();
    let sent = python(POSITIONS, DRIVE[0].as_ref());
    assert_eq!(drawn, sent.lines().collect::<Vec<_>>());
    assert_eq!(
        plots[0][0],
        "drive-402: 6064:00 Position actual value: 5 values from 1450 to 2200, 1900 on average"
    );
}

#[test]
fn marks_are_where_it_happened_and_links_lead_to_them() {
    if is_without_python() {
        return;
    }
    let lines = read(&DRIVE);
    let marks = of_kind(&lines, "mark");
    let found: Vec<String> = marks.iter().map(|mark| mark.join(" ")).collect();
    for mark in ["boot-up 0", "abort 0.026", "emcy 0.055", "error 0.049", "deviation 0.056"] {
        assert!(found.iter().any(|found| found == mark), "{mark}: {found:?}");
    }
    assert_eq!(of_kind(&lines, "link").len(), marks.len(), "each mark has a line below");
    let lanes: Vec<&str> = of_kind(&lines, "lane").iter().map(|lane| lane[0]).collect();
    assert_eq!(
        lanes,
        [
            "no node: unknown 1, error 1",
            "5 drive-402: nmt 1, emcy 1, pdo 9, sdo 26, heartbeat 1, boot-up 1",
            "node 7: pdo 1, heartbeat 1",
        ]
    );
    let states = of_kind(&lines, "data-states");
    assert_eq!(
        states[1][0],
        "drive-402: 6041:00 Statusword: 3 changes between ready to switch on, switched on, operation enabled, fault reaction active"
    );
    let late = read(&["fixtures/logs/chapter4.log", "--with", "fixtures/network/chapter4.toml"]);
    assert!(of_kind(&late, "mark").iter().any(|mark| mark[0] == "deviation"));
}

#[test]
fn filters_count_for_what_is_drawn() {
    if is_without_python() {
        return;
    }
    let lines = read(&[&DRIVE[..], &["--only-node", "7"]].concat());
    assert_eq!(of_kind(&lines, "lane"), [["node 7: pdo 1, heartbeat 1"]]);
    let lines = read(&[&DRIVE[..], &["--from", "0.055", "--object", "6064", "--plot", "6064"]].concat());
    assert_eq!(of_kind(&lines, "data-points")[0][1], "0 1950;0.005 2200;0.013 2200");
    let lines = read(&[&DRIVE[..], &["--kind", "sdo", "--plot", "6081"]].concat());
    // of two writes the node aborts the second
    let points = of_kind(&lines, "data-points");
    assert_eq!((points.len(), points[0][1]), (1, "0.0229 50000"));
}

#[test]
fn values_of_sdos_and_states_of_nodes_are_plots_too() {
    if is_without_python() {
        return;
    }
    let network = ["fixtures/logs/chapter4.log", "--with", "fixtures/network/chapter4.toml"];
    let plots = ["--plot", "11.1017", "--plot", "left.NMT state", "--plot", "analogue inputs1"];
    let lines = read(&[&network[..], &plots].concat());
    let points = of_kind(&lines, "data-points");
    assert_eq!(points[0][0].split(": ").nth(1), Some("1017:00 Producer heartbeat time"), "{points:?}");
    assert!(points[0][1].ends_with(" 300"), "{points:?}");
    assert_eq!(points.len(), 3, "the inputs are those of two nodes");
    let states = of_kind(&lines, "data-states");
    assert!(states[0][0].starts_with("left: NMT state: ") && states[0][0].contains("pre-operational"));
}

#[test]
fn memory_and_page_are_bounded_and_extremes_are_kept() {
    if is_without_python() {
        return;
    }
    // node 5 says what TPDO 1 has: 32 bits of 2000h
    let mut log: String = ["2300180185010000", "2F001A0000000000", "23001A0120000020", "2F001A0001000000"]
        .map(|request| format!("(0.0) can0 605#{request}\n(0.0) can0 585#60{}00000000\n", &request[2..8]))
        .concat();
    for number in 0..30_000_u32 {
        let value = if number == 12_345 { 0x12_3456 } else { number % 50 };
        let bytes = value.swap_bytes();
        log.push_str(&format!("({}.{:03}) can0 185#{bytes:08X}\n", number / 1000, number % 1000));
    }
    let lines = read_text(&log, &["--points", "100"]);
    let plots = of_kind(&lines, "data-points");
    let rows: Vec<Vec<&str>> = plots[0][1].split(';').map(|row| row.split(' ').collect()).collect();
    assert!((50..=100).contains(&rows.len()), "{}", rows.len());
    assert!(plots[0][0].starts_with("node 5: 2000:00: 30000 values from 0 to 1193046, "), "{}", plots[0][0]);
    let highest: Vec<_> = rows.iter().filter(|row| row[3] == "1193046").collect();
    let from: f64 = highest[0][0].parse().unwrap();
    assert!(highest.len() == 1 && (11.7..=12.345).contains(&from), "{highest:?}");
}

#[test]
fn logs_of_any_form_have_a_page() {
    if is_without_python() {
        return;
    }
    for (log, lanes) in [
        ("", 0),
        ("(7.5) can0 705#00\n", 1),
        ("(9.0) can0 185#01\n(1.0) can0 185#02\n(5.0) can0 186#02\n", 2),
        ("(1.0) can0 185#01\n(2.0) can1 185#01\n(3.0) can1 186#01\n", 3),
        ("(9223372036.0) can0 185#01\n(0.0) can0 185#02\n", 1),
    ] {
        let lines = read_text(log, &[]);
        assert_eq!(of_kind(&lines, "lane").len(), lanes, "{log}");
    }
}

#[test]
fn what_is_not_in_the_log_is_said() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.html");
    let output = decode(&[&DRIVE[..], &["--plot", "2040", "--summary"]].concat(), &page);
    let (shown, said) =
        (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert!(shown.starts_with("Needs attention: 3 unresolved, 2 warnings\n"), "{shown}");
    assert!(said.contains("no value of `2040` is in the frames that are shown"), "{said}");
    let text = fs::read_to_string(&page).unwrap();
    assert!(text.contains("The log has no value of `2040`."));
    assert!(text.contains("1: 43 frames from 0.015991 to 0.077991"), "the page has the same sums");
    let output = decode(&[&DRIVE[..], &["--check"]].concat(), &page);
    assert_eq!(output.status.code(), Some(1), "with --check its findings count");
}
