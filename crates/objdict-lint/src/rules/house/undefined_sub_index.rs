use crate::{demands, rule};

rule! {
    /// an object has a sub-index that a house profile does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of an object is one that the loaded profile lists. A profile that lists none leaves them free.
    ///
    /// ## Why it matters
    /// Tools of the house do not show it, and a later edition of the profile may give it another meaning.
    ///
    /// ## Example
    /// `[2000sub3]` where the profile ends with sub-index 2
    ///
    /// ## How to mend
    /// Put it into an object of its own, or into the profile.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/undefined-sub-index", Error, Against(demands::undefined_sub_index)
}
