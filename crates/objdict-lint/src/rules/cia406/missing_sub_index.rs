use crate::{demands, rule};

rule! {
    /// an object of an encoder has no sub-index that CiA 406 demands
    ///
    /// ## What it checks
    /// Whether each array of 6005h to 650Ch has its first element, and 6005h and 650Ah what they always have.
    ///
    /// ## Why it matters
    /// An array without elements describes what is not there.
    ///
    /// ## Example
    /// `[6030]` with `[6030sub0]` only
    ///
    /// ## How to mend
    /// Describe the sub-index, or leave the object out.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/missing-sub-index", Error, Against(demands::missing_entry)
}
