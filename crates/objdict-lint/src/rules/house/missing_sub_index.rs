use crate::{demands, rule};

rule! {
    /// a sub-index that a house profile demands is missing
    ///
    /// ## What it checks
    /// Whether the objects of the device have the sub-indexes that a loaded profile makes mandatory, always or under a condition that holds for the device.
    ///
    /// ## Why it matters
    /// The software of the house counts on the sub-index.
    ///
    /// ## Example
    /// `{ sub = 3, need = "mandatory" }` in the profile, and no `[2000sub3]`
    ///
    /// ## How to mend
    /// Describe the sub-index, and build it into the device.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/missing-sub-index", Error, Against(demands::missing_entry)
}
