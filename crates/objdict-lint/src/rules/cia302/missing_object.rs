use crate::{demands, rule};

rule! {
    /// an object that CiA 302 demands beside another one is missing
    ///
    /// ## What it checks
    /// Whether what belongs together is there: 1F20h with 1F21h, 1F23h with 1F24h, 1F26h with 1F27h, 1F51h with 1F50h, and 1F90h when bit 5 of 1F80h makes the device a flying master. What a module may bring is not missed.
    ///
    /// ## Why it matters
    /// A stored DCF without its format cannot be read, an expected date without a time is compared with half of what the node has, and a program that nobody can start stays where it is.
    ///
    /// ## Example
    /// `[1F20]` and no `[1F21]`
    ///
    /// ## How to mend
    /// Describe the other object too, and build it into the device.
    ///
    /// ## Source
    /// CiA 302-2 (1F20h to 1F27h, 1F80h, 1F90h); CiA 302-3 (1F50h, 1F51h)
    "cia302/missing-object", Error, Applied(demands::missing_object)
}
