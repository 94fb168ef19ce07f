use crate::{demands, rule};

rule! {
    /// a channel or parameter of an I/O module has another access type
    ///
    /// ## What it checks
    /// The access types of 6000h to 6450h. Inputs are `ro`, outputs `rww`, or `rw` as before version 4 of CiA 301; parameters are `rw`.
    ///
    /// ## Why it matters
    /// An output that is `ro` cannot be set. An input that can be written is no input, and a tool offers it for RPDOs.
    ///
    /// ## Example
    /// `[6200sub1]` with `AccessType=ro`
    ///
    /// ## How to mend
    /// Use the access type of the profile, in the description and in the device.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/wrong-access", Error, Expected(demands::wrong_access), fix Unsafe
}
