use crate::{demands, rule};

rule! {
    /// a channel of a measuring device has another access type than CiA 404 gives it
    ///
    /// ## What it checks
    /// The access types of the objects that CiA 404 defines, where two sources agree. `rwr` and `rww` count as `rw`.
    ///
    /// ## Why it matters
    /// A measured value that can be written is no measured value, and a limit that cannot be written is set by nobody.
    ///
    /// ## Example
    /// `AccessType=rw` in `[7130sub1]`
    ///
    /// ## How to mend
    /// Correct the access type.
    ///
    /// ## Source
    /// CiA 404-1, the object descriptions
    "cia404/wrong-access", Warning, Expected(demands::wrong_access), fix Unsafe
}
