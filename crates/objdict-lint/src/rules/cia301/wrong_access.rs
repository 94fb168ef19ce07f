use crate::{demands, rule};

rule! {
    /// a communication object has an access type that CiA 301 does not allow
    ///
    /// ## What it checks
    /// The access types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists, entry by entry. `ro` and `const` stand for each other, for the editions of CiA 301 exchanged them; `rwr` and `rww` count as `rw`; parameters that a profile may fix can be `const`.
    ///
    /// ## Why it matters
    /// A tool offers to write what the device refuses, or does not write what it must: a heartbeat time that is read-only cannot be set, a device type that can be written means nothing.
    ///
    /// ## Example
    /// `[1000]` with `AccessType=rw`
    ///
    /// ## How to mend
    /// Use an access type of the standard, in the description and in the device.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/wrong-access", Error, Expected(demands::wrong_access), fix Unsafe
}
