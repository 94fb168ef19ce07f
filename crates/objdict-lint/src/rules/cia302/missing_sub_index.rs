use crate::{demands, rule};

rule! {
    /// a sub-index that CiA 302 demands is missing
    ///
    /// ## What it checks
    /// Whether lists of nodes and of programs have an entry, and whether 1F70h, 1F90h and 1F91h are complete.
    ///
    /// ## Why it matters
    /// The manager reads an entry for each node that it finds. One that is missing answers with an abort, and the boot procedure stops.
    ///
    /// ## Example
    /// `[1F90]` without `[1F90sub3]`, the priority of the master
    ///
    /// ## How to mend
    /// Describe the sub-index. `CompactSubObj=127` describes a list of nodes in one line.
    ///
    /// ## Source
    /// CiA 302-2, the object descriptions
    "cia302/missing-sub-index", Error, Against(demands::missing_entry)
}
