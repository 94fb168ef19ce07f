//! The page of `objdict probe --html`: every question, its answer and its verdict.

use std::process::Command;

use crate::page::Page;
use crate::support::fixtures;

#[test]
fn each_answer_has_a_verdict() {
    let made = Page::made(|path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_objdict"));
        command.arg("probe").arg(fixtures().join("eds/drive-402.eds")).args(["--node-id", "5", "--answers"]);
        command.arg(fixtures().join("probe/drive-402.csv")).arg("--html").arg(path);
        command
    });
    let Some(page) = made else { return };
    assert_eq!(
        page.text("document.querySelector('header p').textContent"),
        "node 5: 262 of 267 answers as described"
    );
    assert_eq!(page.number("document.querySelectorAll('tbody tr').length"), 267.0);
    let verdicts = page.texts(
        "[...document.querySelectorAll('tbody tr')].filter(row => row.querySelector('strong')).map(row =>
            row.cells[0].textContent + ' ' + row.querySelector('strong').textContent.split(':')[0])",
    );
    assert_eq!(
        verdicts,
        [
            "1017:00 probe/other-default",
            "1018:03 probe/other-value",
            "2003:02 probe/outside-limits",
            "6041:00 probe/wrong-size",
            "6071:00 probe/absent",
        ]
    );
    let value = "[...document.querySelectorAll('tbody tr')].find(row => row.cells[0].textContent === '1017:00').innerText";
    assert_eq!(
        page.text(value),
        "1017:00\tProducer heartbeat time\tread\t1000 (0x3E8)\tprobe/other-default: 1017h is 1000 (0x3E8), and 500 (0x1F4) is described"
    );
}
