use crate::{demands, rule};

rule! {
    /// an entry of CiA 302 has a value that means nothing
    ///
    /// ## What it checks
    /// Whether the priority level of a flying master, 1F90h sub-index 3, is 0, 1 or 2.
    ///
    /// ## Why it matters
    /// The master sends its priority in the negotiation, and the others do not understand it.
    ///
    /// ## Example
    /// `[1F90sub3]` with `DefaultValue=3`
    ///
    /// ## How to mend
    /// Write 0 for a high, 1 for a medium or 2 for a low priority.
    ///
    /// ## Source
    /// CiA 302-2 (1F90h)
    "cia302/wrong-value", Error, Expected(demands::wrong_value)
}
