use crate::{demands, rule};

rule! {
    /// an object of an encoder has not as many elements as there are sensors or channels
    ///
    /// ## What it checks
    /// Whether 6010h and 650Ch have as many elements as 6020h, 6301h and 6302h as many as 6300h, 6401h and 6402h as many as 6400h.
    ///
    /// ## Why it matters
    /// A sensor without an element has no preset, a work area without a limit no end.
    ///
    /// ## Example
    /// `[6020sub0]` with `DefaultValue=2`, `[6010sub0]` with `DefaultValue=1`
    ///
    /// ## How to mend
    /// Describe an element for each sensor or channel.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/different-channel-count", Warning, Against(demands::different_channel_count)
}
