use crate::{demands, rule};

rule! {
    /// an entry that a house profile lets no PDO carry is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at an entry that a loaded profile gives `mapping = "no"`.
    ///
    /// ## Why it matters
    /// A configuration tool offers it for a PDO, and the device refuses the mapping.
    ///
    /// ## Example
    /// `PDOMapping=1` where the profile says `mapping = "no"`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-mapping", Warning, Against(demands::wrong_mapping), fix Unsafe
}
