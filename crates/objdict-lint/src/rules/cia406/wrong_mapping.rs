use crate::{demands, rule};

rule! {
    /// a parameter of an encoder is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at a parameter or a constant: 6000h to 6003h, 6200h, 6500h to 6502h and the like. Positions, speeds, alarms, warnings and CAM states are what PDOs carry.
    ///
    /// ## Why it matters
    /// A configuration tool offers it for a PDO, and the device refuses the mapping.
    ///
    /// ## Example
    /// `[6502]` with `PDOMapping=1`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`, unless the device does let PDOs carry it.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/wrong-mapping", Warning, Against(demands::wrong_mapping), fix Unsafe
}
