use crate::{demands, rule};

rule! {
    /// a list of nodes has not the size that CiA 302 gives it
    ///
    /// ## What it checks
    /// Whether sub-index 0 of a list of nodes is 127, or 128 where there is an entry for all nodes (1F25h, 1F82h, 1F83h), and whether that of other objects lies in its range. It is silent where another rule has it: sub-indexes that are missing or too many, or a highest one that is not described.
    ///
    /// ## Why it matters
    /// A manager that is told of fewer nodes does not look for the others; a configuration tool offers no entry for them.
    ///
    /// ## Example
    /// `[1F81sub0]` with `DefaultValue=32`, and sub-indexes up to 32
    ///
    /// ## How to mend
    /// Describe all 127 entries; `CompactSubObj=127` does it in one line. A device with room for fewer nodes refuses to write the others.
    ///
    /// ## Source
    /// CiA 302-2, the object descriptions
    "cia302/sub-0-out-of-range", Warning, Against(demands::sub_0_out_of_range)
}
