use crate::{demands, rule};

rule! {
    /// a parameter of an I/O module is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at a parameter: polarity, filters, masks, error modes and values, limits, scaling. Only channels are process data.
    ///
    /// ## Why it matters
    /// A configuration tool offers it for a PDO, and the device refuses the mapping.
    ///
    /// ## Example
    /// `[6202sub1]` with `PDOMapping=1`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`, unless the device does let PDOs carry it.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/wrong-mapping", Warning, Against(demands::wrong_mapping), fix Unsafe
}
