use crate::{demands, rule};

rule! {
    /// a parameter has not as many elements as there are channels
    ///
    /// ## What it checks
    /// Whether the parameters of channels (polarity, filter, interrupt masks, error mode and value, limits, scaling) have as many elements as the channels. It is silent when any of the forms of the channels has that number.
    ///
    /// ## Why it matters
    /// The channels without an element cannot be configured, and a tool that goes through them together is answered with an abort.
    ///
    /// ## Example
    /// `[6000sub0]` with `DefaultValue=2`, `[6002sub0]` with `DefaultValue=1`
    ///
    /// ## How to mend
    /// Describe an element for each channel.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/different-channel-count", Warning, Against(demands::different_channel_count)
}
