//! The spelling of values in description files: CiA 306-1 §4.3 and the practice of real files.
//!
//! Readers accept the spellings of real files (octal, `n+$NODEID`, comments after numbers, C suffixes) and report
//! each as a `Quirk`. The model stores only the value; `spelling` turns quirks into findings.

mod calendar;
mod intended;
mod parse;
mod print;
mod respell;
mod spelling;
mod written;

pub use calendar::{clock_time, date};
pub use intended::Intended;
pub use parse::{
    Quirk, Quirks, high_limit, integer, integer_in_line, plain_value, small_number, strip_comment, value,
    value_in_line,
};
pub use print::{RealSpelling, Spelling, nanoseconds, print};
pub use respell::{respell, trailing_comment};
pub use spelling::{QUOTED, RULES, spelling, spelling_in_line};
pub use written::{NoValue, iec_number, written, written_number};
