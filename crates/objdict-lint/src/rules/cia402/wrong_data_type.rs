use crate::{demands, rule};

rule! {
    /// an entry of a drive has another data type than CiA 402 gives it
    ///
    /// ## What it checks
    /// The data types of the objects that CiA 402 defines; sub-index 0 is the matter of `cia306/sub-0-type`.
    ///
    /// ## Why it matters
    /// A master reads and writes the value with the type of the profile: with another length the transfer is aborted and the mapping is refused; with another sign a speed backwards becomes the largest speed forwards. Of the real drives that were looked at every third has such an entry, mostly 608Fh and 6090h as INTEGER32 or 60FFh as UNSIGNED32, and each of them was against the document.
    ///
    /// ## Example
    /// `DataType=0x0007` in `[60FF]`, which is UNSIGNED32 in the place of INTEGER32
    ///
    /// ## How to mend
    /// Correct the data type, in the device too; or move an object of your own out of the range of the profile.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/wrong-data-type", Error, Expected(demands::wrong_data_type), fix Unsafe
}
