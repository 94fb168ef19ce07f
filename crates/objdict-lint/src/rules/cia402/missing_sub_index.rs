use crate::{demands, rule};

rule! {
    /// a sub-index that an object of a drive has to have is missing
    ///
    /// ## What it checks
    /// Whether the records and arrays of a drive have the sub-indexes that CiA 402 makes mandatory: both limits of 607Bh and 607Dh, both speeds of 6099h, numerator and divisor of the factors, value and index of 60C2h.
    ///
    /// ## Why it matters
    /// A factor without its divisor, or a range with one end, means nothing.
    ///
    /// ## Example
    /// `[6099]` with `[6099sub0]` and `[6099sub1]` only
    ///
    /// ## How to mend
    /// Describe the missing sub-index.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/missing-sub-index", Error, Against(demands::missing_entry)
}
