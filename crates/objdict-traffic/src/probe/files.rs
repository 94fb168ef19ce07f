//! A plan as files: the script, the table and the log.

use std::fmt::Write;

use super::expectation::{Expectation, hex};
use super::plan::{Attempt, ProbePlan, Question};
use objdict_document::csv_field;

/// The script without its data.
const SCRIPT: &str = include_str!("probe.py");

/// The lines of the script that are replaced.
const NODE_ID: &str = "NODE_ID = 1\n";
const QUESTIONS: &str = "QUESTIONS = []\n";

/// A client gives up a transfer of segments after the beginning: it timed out (CiA 301 §7.2.4.3.17).
const TIMED_OUT: u32 = 0x0504_0000;

impl ProbePlan {
    /// The script for python-canopen.
    pub fn script(&self) -> String {
        let mut questions = "QUESTIONS = [\n".to_owned();
        for step in &self.steps {
            let Question { index, sub, .. } = step;
            let _ = writeln!(questions, "    (0x{index:04X}, 0x{sub:02X}, {}),", step.attempt.python());
        }
        questions.push_str("]\n");
        SCRIPT.replace(NODE_ID, &format!("NODE_ID = {}\n", self.node_id)).replace(QUESTIONS, &questions)
    }

    /// What is asked and expected, as CSV.
    pub fn table(&self) -> String {
        let mut table = "index,sub,name,data_type,access,action,sent,expected\n".to_owned();
        for step in &self.steps {
            let cells = [
                format!("0x{:04X}", step.index),
                format!("0x{:02X}", step.sub),
                step.entry.as_ref().map(|entry| entry.name.clone()).unwrap_or_default(),
                step.data_type(),
                step.access().to_owned(),
                if step.attempt == Attempt::Read { "read" } else { "write" }.to_owned(),
                step.attempt.sent(),
                step.expected(),
            ];
            let cells: Vec<String> = cells.iter().map(|cell| csv_field(cell).into_owned()).collect();
            let _ = writeln!(table, "{}", cells.join(","));
        }
        table
    }

    /// The reads as a log of `candump -L`, so many milliseconds apart, because `canplayer` waits for no answer. A value of more than
    /// four bytes is only begun, and given up before the next one.
    pub fn candump(&self, gap: u32) -> String {
        let (mut log, mut milliseconds) = (String::new(), 0_u64);
        let can_id = 0x600 + u16::from(self.node_id);
        let mut frame = |bytes: [u8; 8]| {
            let data: String = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
            let (seconds, rest) = (milliseconds / 1000, milliseconds % 1000);
            let _ = writeln!(log, "({seconds:010}.{rest:03}000) can0 {can_id:03X}#{data}");
            milliseconds += u64::from(gap);
        };
        for step in self.steps.iter().filter(|step| step.attempt == Attempt::Read) {
            let [low, high] = step.index.to_le_bytes();
            frame([0x40, low, high, step.sub, 0, 0, 0, 0]);
            let is_short =
                step.entry.as_ref().and_then(Expectation::length).is_some_and(|length| length <= 4);
            if !is_short {
                let [a, b, c, d] = TIMED_OUT.to_le_bytes();
                frame([0x80, low, high, step.sub, a, b, c, d]);
            }
        }
        log
    }
}

impl Question {
    fn data_type(&self) -> String {
        let data_type = self.entry.as_ref().and_then(|entry| entry.data_type);
        data_type.map(|data_type| data_type.to_string()).unwrap_or_default()
    }

    fn access(&self) -> &'static str {
        self.entry.as_ref().and_then(|entry| entry.access).map_or("", |access| access.name())
    }

    /// The value as bytes, the abort code, or nothing if any value is right.
    fn expected(&self) -> String {
        match (&self.refusal, &self.attempt, &self.entry) {
            (Some(abort), ..) => format!("abort 0x{:08X}", abort.code()),
            (None, Attempt::Read, Some(entry)) => entry.default.as_deref().map(hex).unwrap_or_default(),
            _ => "accepted".to_owned(),
        }
    }
}

impl Attempt {
    /// The tuple of the script: what is sent, as a word or as hex digits.
    fn python(&self) -> String {
        let bytes = |bytes: &[u8]| format!("\"{}\"", hex(bytes));
        match self {
            Self::Read => "READ".to_owned(),
            Self::Own => "OWN".to_owned(),
            Self::Longer => "LONGER".to_owned(),
            Self::Shorter => "SHORTER".to_owned(),
            Self::Beyond(value) => bytes(value),
            Self::Other(values) => {
                let values: Vec<String> = values.iter().map(|value| bytes(value)).collect();
                format!("({})", values.join(", "))
            }
        }
    }

    fn sent(&self) -> String {
        match self {
            Self::Read => String::new(),
            Self::Own => "the value that was read".to_owned(),
            Self::Longer => "the value and a zero byte".to_owned(),
            Self::Shorter => "the value without its last byte".to_owned(),
            Self::Beyond(value) => hex(value),
            Self::Other(values) => values.iter().map(|value| hex(value)).collect::<Vec<_>>().join(" or "),
        }
    }
}
