use crate::{demands, rule};

rule! {
    /// an entry of CiA 302 has another data type
    ///
    /// ## What it checks
    /// The data types of 1F00h to 1F91h. Where sources disagree, as on the priority level of a flying master, all of them are right. Two well-known databases make mistakes here, DOMAIN or INTEGER8 for 1F21h, which are not.
    ///
    /// ## Why it matters
    /// A manager writes a request with the length of the document, and a device that has another one refuses it. A widespread generator of manager descriptions has 1F25h as UNSIGNED8, though the request `conf` has four bytes; some drives have programs as OCTET_STRING, which does no harm. So it is a warning.
    ///
    /// ## Example
    /// `[1F50sub1]` with `DataType=0x0007`; it is a DOMAIN, `0x000F`
    ///
    /// ## How to mend
    /// Use the data type of the document, in the description and in the device.
    ///
    /// ## Source
    /// CiA 302-2 and 302-3, the object descriptions
    "cia302/wrong-data-type", Warning, Expected(demands::wrong_data_type), fix Unsafe
}
