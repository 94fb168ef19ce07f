use crate::{demands, rule};

rule! {
    /// an entry of a drive that no PDO should carry is marked as mappable
    ///
    /// ## What it checks
    /// Whether objects that CiA 402 keeps out of PDOs are marked as mappable: option codes, the motor and the drive by name and date, the device types of axes. Parameters that the document keeps out but many drives let in are not looked at.
    ///
    /// ## Why it matters
    /// Tools offer the entry for mapping, and the drive is asked to do with every SYNC what is meant to be done once.
    ///
    /// ## Example
    /// `PDOMapping=1` in `[605A]`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`, unless the drive really can do it.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/wrong-mapping", Note, Against(demands::wrong_mapping), fix Unsafe
}
