use crate::{demands, rule};

rule! {
    /// an object of a measuring device has more channels than CiA 404 knows
    ///
    /// ## What it checks
    /// Whether the objects that CiA 404 defines have channels 1 to 199 only.
    ///
    /// ## Why it matters
    /// Sub-indexes above C7h are no channels, so no tool looks for values there.
    ///
    /// ## Example
    /// `[7130subC8]`
    ///
    /// ## How to mend
    /// Put what is your own into an object from 2000h on.
    ///
    /// ## Source
    /// CiA 404-1, the object descriptions
    "cia404/undefined-sub-index", Warning, Against(demands::undefined_sub_index)
}
