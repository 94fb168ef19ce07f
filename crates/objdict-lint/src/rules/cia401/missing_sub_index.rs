use crate::{demands, rule};

rule! {
    /// an array of an I/O module has no element
    ///
    /// ## What it checks
    /// Whether each array of 6000h to 6450h has its first element.
    ///
    /// ## Why it matters
    /// An array without elements describes channels that are not there.
    ///
    /// ## Example
    /// `[6200]` with `[6200sub0]` only
    ///
    /// ## How to mend
    /// Describe the elements, or leave the object out.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/missing-sub-index", Error, Against(demands::missing_entry)
}
