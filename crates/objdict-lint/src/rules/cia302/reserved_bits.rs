use crate::{demands, rule};

rule! {
    /// a reserved bit of 1F80h or 1F81h is set
    ///
    /// ## What it checks
    /// Whether only bits are set in 1F80h (0 to 6), in entries of 1F81h (all but 1) and in 1F57h that the document defines.
    ///
    /// ## Why it matters
    /// A device answers with abort code 0609 0030h when a bit is written that it does not support; a later edition may give the bit a meaning.
    ///
    /// ## Example
    /// `[1F80]` with `DefaultValue=0x00000080`
    ///
    /// ## How to mend
    /// Clear the bit.
    ///
    /// ## Source
    /// CiA 302-2 (1F80h, 1F81h); CiA 302-3 (1F57h)
    "cia302/reserved-bits", Warning, Expected(demands::reserved_bits), fix Unsafe
}
