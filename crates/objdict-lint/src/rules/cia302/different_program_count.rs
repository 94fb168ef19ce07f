use crate::{demands, rule};

rule! {
    /// 1F51h does not control as many programs as 1F50h has
    ///
    /// ## What it checks
    /// Whether program control (1F51h) has as many sub-indexes as program data (1F50h).
    ///
    /// ## Why it matters
    /// A program that was downloaded cannot be started, or what is started is not there.
    ///
    /// ## Example
    /// `[1F50sub0]` with `DefaultValue=2`, `[1F51sub0]` with `DefaultValue=1`
    ///
    /// ## How to mend
    /// Describe an entry of 1F51h for each program of 1F50h.
    ///
    /// ## Source
    /// CiA 302-3 (1F50h, 1F51h)
    "cia302/different-program-count", Error, Against(demands::different_channel_count)
}
