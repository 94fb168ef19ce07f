use crate::{demands, rule};

rule! {
    /// a communication object that no PDO may carry is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at a communication object of CiA 301 other than 1001h, 1002h, 1013h, 1026h and the COB-IDs of SDOs, which CiA 301 calls mappable although nobody maps them.
    ///
    /// ## Why it matters
    /// A configuration tool offers the object for a PDO; the device refuses the mapping, or a received PDO changes the communication of the node.
    ///
    /// ## Example
    /// `[1017]` with `PDOMapping=1`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/mapped-communication-object", Warning, Against(demands::wrong_mapping), fix Unsafe
}
