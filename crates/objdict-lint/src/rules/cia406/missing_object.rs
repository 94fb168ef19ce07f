use crate::{demands, rule};

rule! {
    /// an object that CiA 406 demands of an encoder is missing
    ///
    /// ## What it checks
    /// Whether an encoder has what each class has: 6000h, 6500h and 6501h; 6004h, or 6020h for several sensors; 6502h when it turns; and its two TPDOs, 1800h and 1801h with their mappings (1802h in place of 1801h, as in editions before 3). What depends on the type of the encoder is not missed where 1000h does not state it.
    ///
    /// ## Why it matters
    /// The position is where a master looks for it, TPDO 1 sends it, and resolution and number of revolutions say what it means.
    ///
    /// ## Example
    /// no `[6502]` in an encoder with `[1000]` `DefaultValue=0x00020196`
    ///
    /// ## How to mend
    /// Describe the object, and build it into the device.
    ///
    /// ## Source
    /// CiA 406, class C1
    "cia406/missing-object", Error, Applied(demands::missing_object)
}
