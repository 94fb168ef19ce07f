use crate::{demands, rule};

rule! {
    /// a parameter of an I/O module has a value that means nothing
    ///
    /// ## What it checks
    /// Whether the trigger selection of an analogue input, 6421h, is 0 to 31, the error mode of an analogue output, 6443h, 0 or 1, and an error reaction of 1029h 0 to 2 or one of the manufacturer (128 to 255).
    ///
    /// ## Why it matters
    /// The device refuses the value, or does what nobody knows.
    ///
    /// ## Example
    /// `[6421sub1]` with `DefaultValue=0x20`
    ///
    /// ## How to mend
    /// Write a value that the profile defines.
    ///
    /// ## Source
    /// CiA 401 (6421h, 6443h, 1029h)
    "cia401/wrong-value", Error, Expected(demands::wrong_value)
}
