//! A bus while it runs: `candump -L can0 | objdict decode - --summary` on a terminal.

use std::process::Command;

use crate::support::skips;

/// Runs the command on a terminal of its own and prints what comes; frames come for a second and a half, from two nodes at first.
const SCRIPT: &str = r"
import os, pty, subprocess, sys, threading, time
main, side = pty.openpty()
command = subprocess.Popen(
    [sys.argv[1], 'decode', '-', '--summary'], stdin=subprocess.PIPE, stdout=side, env={**os.environ, 'TERM': 'xterm'})
os.close(side)
shown = []
def read():
    try:
        while data := os.read(main, 65536):
            shown.append(data)
    except OSError:
        pass  # the terminal is closed
reader = threading.Thread(target=read)
reader.start()
for at in range(15):
    nodes = (5, 6) if at < 5 else (5,)
    for node in nodes:
        command.stdin.write(b'(%d.%d) can0 70%d#05\n' % (10 + at // 10, at % 10, node))
    command.stdin.flush()
    time.sleep(0.1)
command.stdin.close()
command.wait()
reader.join()
sys.stdout.buffer.write(b''.join(shown))
";

#[test]
fn a_summary_of_a_pipe_is_a_screen() {
    if !skips::has("python3", "python3") {
        return;
    }
    let output = Command::new("python3").args(["-c", SCRIPT, crate::program()]).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let screens: Vec<&str> = text.split("\x1B[H").collect();
    let (last, summary) = screens.last().unwrap().split_once("\x1B[J").unwrap();
    assert!(screens.len() > 2, "it is drawn again and again: {text}");
    assert!(last.starts_with("Needs attention: 1 unresolved\x1B[K\r\n\x1B[K\r\ncan0: "), "{text}");
    assert!(last.contains("\r\nNode  State        Lost\x1B[K\r\n5     operational\x1B[K\r\n"), "{text}");
    assert!(last.contains("limit 300.000 ms, until"), "{text}");
    // the summary follows as plain text
    assert!(summary.starts_with("Needs attention: 1 unresolved\r\n\r\nUnresolved:"), "{text}");
    assert!(summary.contains("until the end of the log"), "{text}");
}
