use crate::{demands, rule};

rule! {
    /// an entry has a value that a house profile does not allow
    ///
    /// ## What it checks
    /// Whether the value of an entry, configured or default, is one of those that a loaded profile allows.
    ///
    /// ## Why it matters
    /// The device refuses the value, or does what nobody expects.
    ///
    /// ## Example
    /// `DefaultValue=300` where the profile says `values = [[0, 200]]`
    ///
    /// ## How to mend
    /// Use a value of the profile.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-value", Error, Expected(demands::wrong_value)
}
