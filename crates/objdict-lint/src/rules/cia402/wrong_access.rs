use crate::{demands, rule};

rule! {
    /// an entry of a drive has another access type than CiA 402 gives it
    ///
    /// ## What it checks
    /// The access types of the objects that CiA 402 defines. `rwr` and `rww` count as `rw`. 6060h may be `wo`, as version 2 had it; ratings, resolutions and factors that a drive cannot change may be `ro`.
    ///
    /// ## Why it matters
    /// A master that writes what is read-only, or reads back what is write-only, is refused.
    ///
    /// ## Example
    /// `AccessType=wo` in `[6040]`
    ///
    /// ## How to mend
    /// Correct the access type. Option codes that are `ro` because the drive knows one reaction only are against the document, but harmless where nobody writes them; hence a warning.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/wrong-access", Warning, Expected(demands::wrong_access), fix Unsafe
}
