use crate::{demands, rule};

rule! {
    /// the device type names an encoder that CiA 406 does not know
    ///
    /// ## What it checks
    /// Whether the high word of 1000h is one of the types 1 to 10. In a module of several logical devices that of 67FFh and each 800h behind it.
    ///
    /// ## Why it matters
    /// The type says whether the encoder turns or is linear, and with it which objects it has and what their values mean.
    ///
    /// ## Example
    /// `[1000]` with `DefaultValue=0x00000196`
    ///
    /// ## How to mend
    /// Write the type: 1 single-turn, 2 multi-turn, 8 absolute linear, and so on.
    ///
    /// ## Source
    /// CiA 406 (1000h)
    "cia406/unknown-encoder-type", Error, Expected(demands::undefined_field_value)
}
