use crate::{demands, rule};

rule! {
    /// an object has a sub-index that CiA 302 does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of 1F00h to 1F91h is one that the document defines: 1 to 127 in lists of nodes, for that is how high node-IDs go, 128 in those that have an entry for all nodes.
    ///
    /// ## Why it matters
    /// There is no node 128. A tool that shows a list of nodes does not show the entry.
    ///
    /// ## Example
    /// `[1F81sub80]`
    ///
    /// ## How to mend
    /// Leave the entry out. What is your own belongs into 2000h to 5FFFh.
    ///
    /// ## Source
    /// CiA 302-2, the object descriptions
    "cia302/undefined-sub-index", Error, Against(demands::undefined_sub_index)
}
