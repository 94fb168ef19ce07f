use crate::{demands, rule};

rule! {
    /// an object of an encoder has a sub-index that CiA 406 does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of 6005h to 650Ch is one that the profile has.
    ///
    /// ## Why it matters
    /// A later edition may give it another meaning, and tools that know the profile do not show it.
    ///
    /// ## Example
    /// `[650Asub4]`
    ///
    /// ## How to mend
    /// Put what is your own into 2000h to 5FFFh.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/undefined-sub-index", Error, Against(demands::undefined_sub_index)
}
