use crate::{demands, rule};

rule! {
    /// an entry of an encoder has another access type
    ///
    /// ## What it checks
    /// The access types of 6000h to 6510h: what the encoder measures or states is `ro`, among it the operating status 6500h, and what configures it is `rw`. Some databases give 6020h and 6502h as `rw`, which is a mistake.
    ///
    /// ## Why it matters
    /// A position that can be written is no position; a preset that cannot be is none.
    ///
    /// ## Example
    /// `[6500]` with `AccessType=rw`
    ///
    /// ## How to mend
    /// Use the access type of the profile, in the description and in the device.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/wrong-access", Error, Expected(demands::wrong_access), fix Unsafe
}
