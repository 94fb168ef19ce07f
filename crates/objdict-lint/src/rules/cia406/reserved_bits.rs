use crate::{demands, rule};

rule! {
    /// a reserved bit of an encoder parameter is set
    ///
    /// ## What it checks
    /// Whether only bits are set that the profile defines: 0 to 3 and 12 to 15 of 6000h and 6500h, 0, 1 and 12 to 15 of alarms (6503h, 6504h), 0 to 5 and 12 to 15 of warnings (6505h, 6506h).
    ///
    /// ## Why it matters
    /// A later edition may give the bit a meaning. What is your own belongs into bits 12 to 15. Bit 0 of 6000h, the code sequence, is a trap of its own: with encoders of most manufacturers 0 means that the position rises clockwise, some texts have it the other way round, so state it in the manual.
    ///
    /// ## Example
    /// `[6000]` with `DefaultValue=0x0010`
    ///
    /// ## How to mend
    /// Clear the bit.
    ///
    /// ## Source
    /// CiA 406 (6000h, 6500h, 6503h to 6506h)
    "cia406/reserved-bits", Warning, Expected(demands::reserved_bits), fix Unsafe
}
