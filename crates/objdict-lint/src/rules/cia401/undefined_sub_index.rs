use crate::{demands, rule};

rule! {
    /// an object of an I/O module has a sub-index that CiA 401 does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of an object of 6000h to 6450h is one that the profile has: 1 to 254, 1 to 128 for single bits (6020h to 6027h and the like), 1 to 8 for 6422h.
    ///
    /// ## Why it matters
    /// Bit 129 has an index of its own, the next one, and that is where masters look for it.
    ///
    /// ## Example
    /// `[6020sub81]`; line 129 is 6021h sub-index 1
    ///
    /// ## How to mend
    /// Go on with the next index after 128 lines.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/undefined-sub-index", Error, Against(demands::undefined_sub_index)
}
