use crate::{demands, rule};

rule! {
    /// an encoder that turns has an object of linear ones, or the other way round
    ///
    /// ## What it checks
    /// Whether 6001h (measuring units per revolution) and 6502h (number of revolutions) are there for encoders that turn only, and 6005h (measuring steps) for linear ones only, as the type in 1000h says.
    ///
    /// ## Why it matters
    /// The object means nothing in this device, or the type is wrong, and with it the meaning of all values.
    ///
    /// ## Example
    /// `[6005]` in an encoder with `[1000]` `DefaultValue=0x00020196`
    ///
    /// ## How to mend
    /// Leave the object out, or correct the type.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/misplaced-object", Warning, Against(demands::misplaced_object)
}
