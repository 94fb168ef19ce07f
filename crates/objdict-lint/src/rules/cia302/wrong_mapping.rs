use crate::{demands, rule};

rule! {
    /// an object of CiA 302 is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at an entry of 1F00h to 1F91h. All of them are for configuration, and no PDO carries them.
    ///
    /// ## Why it matters
    /// A configuration tool offers it for a PDO, and the device refuses the mapping.
    ///
    /// ## Example
    /// `[1F80]` with `PDOMapping=1`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`.
    ///
    /// ## Source
    /// CiA 302-2, the object descriptions
    "cia302/wrong-mapping", Warning, Against(demands::wrong_mapping), fix Unsafe
}
