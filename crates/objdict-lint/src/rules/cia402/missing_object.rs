use crate::{demands, rule};

rule! {
    /// an object that a drive has to have is missing
    ///
    /// ## What it checks
    /// Whether a drive has the controlword 6040h and the statusword 6041h, and, for each mode that 6502h (supported drive modes) says it has, the objects that the mode cannot do without: 6042h to 6044h, 6046h and 6048h for velocity; 607Ah, 6081h, 6083h and 6064h for profile position; 60FFh, 606Ch and 6083h for profile velocity; 6071h, 6077h and 6087h for torque; 6098h and 6099h for homing; the targets, 6064h and 60C2h for the cyclic modes. Further axes, 800h indexes apart, are looked at like the first. What a module may bring is not missed.
    ///
    /// ## Why it matters
    /// A master walks the drive through its states with 6040h and 6041h, and writes the objects of the mode; where one is missing, the SDO transfer is aborted and the axis stays where it is.
    ///
    /// ## Example
    /// `DefaultValue=0x00000005` in `[6502]`, which is profile position and profile velocity, and no `[60FF]`
    ///
    /// ## How to mend
    /// Describe the object, or take the bit of the mode out of 6502h. Of the real drives that were looked at none lacks an object of its modes; those that lack the words are examples of stacks.
    ///
    /// ## Source
    /// CiA 402-2, the object descriptions of the modes; IEC 61800-7-201
    "cia402/missing-object", Error, Applied(demands::missing_object)
}
