use crate::{demands, rule};

rule! {
    /// an entry of CiA 302 has an access type that the document does not allow
    ///
    /// ## What it checks
    /// The access types of 1F00h to 1F91h. `ro` and `const` stand for each other; `rwr` and `rww` count as `rw`; a startup value or a flying master that cannot be configured may be constant.
    ///
    /// ## Why it matters
    /// A tool that finds 1F22h read-only does not store the configuration of the nodes there, and a request that is read-only cannot be made.
    ///
    /// ## Example
    /// `[1F25sub1]` with `AccessType=ro`; the request to configure a node is written
    ///
    /// ## How to mend
    /// Use the access type of the document, in the description and in the device.
    ///
    /// ## Source
    /// CiA 302-2 and 302-3, the object descriptions
    "cia302/wrong-access", Error, Expected(demands::wrong_access), fix Unsafe
}
