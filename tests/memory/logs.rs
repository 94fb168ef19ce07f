//! The sums and incidents of a log: of a long log they take as much as of a short one.

use std::io::{self, BufReader, Read};

use objdict::format::log::LogOptions;
use objdict::traffic::{BusSums, Buses, Descriptions, MergedLogs, NamedLog, incidents};

use super::skips::samples_all;
use super::{ALLOCATOR, usage};

/// What the process with so many frames is called.
pub(crate) const TASK: &str = "log";

#[test]
fn the_sums_of_a_log_take_the_same_however_long_it_is() {
    let frames = if samples_all() { 250_000 } else { 25_000 };
    let [short, long] = [frames, 4 * frames].map(|frames| usage(TASK, frames));
    println!("{short:?} {long:?}");
    assert!(long.peak < short.peak + 100_000 && long.text > 3 * short.text, "{short:?}, {long:?}");
}

/// A log that is made while it is read: nodes that fall silent and start again, report errors, reject what is written, and send PDOs.
struct Made {
    frames: usize,
    next: usize,
    line: Vec<u8>,
    bytes: usize,
}

impl Read for Made {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.line.is_empty() && self.next < self.frames {
            let (at, node) = (self.next, self.next / 5 % 25 + 1);
            let frame = match at % 5 {
                0 => format!("{:03X}#00", 0x700 + node),
                1 => format!("{:03X}#1081{:02X}0000000000", 0x80 + node, at / 5 % 7),
                2 => format!("{:03X}#2B00200{}00000000", 0x600 + node, at / 125 % 10),
                3 => format!("{:03X}#8000200{}31000906", 0x580 + node, at / 125 % 10),
                _ if at % 25 == 4 => format!("{:03X}#{at:08X}", 0x180 + node),
                _ => format!("{:08X}#{at:08X}", 0x1800_0000 + at % 5000),
            };
            self.line = format!("({}.{:06}) can0 {frame}\n", at / 1000, at % 1000 * 1000).into_bytes();
            self.bytes += self.line.len();
            self.next += 1;
        }
        let count = self.line.len().min(buffer.len());
        buffer[..count].copy_from_slice(&self.line[..count]);
        self.line.drain(..count);
        Ok(count)
    }
}

/// What the process does.
pub(crate) fn run(frames: usize) {
    let before = (ALLOCATOR.allocated(), ALLOCATOR.total_allocated());
    let descriptions = Descriptions::default();
    let mut buses = Buses::new(&[], &descriptions);
    let mut made = Made { frames, next: 0, line: Vec::new(), bytes: 0 };
    let mut sums = BusSums::new(Some(500));
    let named = NamedLog::new("log".to_owned(), BufReader::new(&mut made), LogOptions::default());
    let mut logs = MergedLogs(vec![named]);
    while let Some((log, frame)) = logs.next_frame().unwrap() {
        let at = buses.of(log, &frame, &logs);
        let decoded = buses.all[at].decode(&frame);
        sums.add(&decoded, &frame, logs.origin(log), &buses.all[at]);
    }
    let mut reports = [sums.report(&buses.all[0])];
    let incidents = incidents(&mut reports);
    assert!(reports[0].frames == frames as u64 && incidents.len() > 50, "{}", incidents.len());
    drop(logs);
    let (peak, total) = (ALLOCATOR.max_allocated() - before.0, ALLOCATOR.total_allocated() - before.1);
    println!("usage: {} {peak} {total}", made.bytes);
}
