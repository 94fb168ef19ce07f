use crate::{demands, rule};

rule! {
    /// a channel of a measuring device has another data type than CiA 404 gives it
    ///
    /// ## What it checks
    /// The data types of the objects that CiA 404 defines. Field values and process values are REAL32 from 6000h on, INTEGER16 from 7000h, INTEGER24 from 8000h and INTEGER32 from 9000h. Objects for which our sources do not agree are not looked at.
    ///
    /// ## Why it matters
    /// The index says the type: a master that reads 7130h takes two bytes for an INTEGER16.
    ///
    /// ## Example
    /// `DataType=0x0008` in `[7130sub1]`, which is REAL32 in the range of INTEGER16
    ///
    /// ## How to mend
    /// Move the object to the range of its type, such as 6130h for REAL32, or correct the type.
    ///
    /// ## Source
    /// CiA 404-1, the object descriptions
    "cia404/wrong-data-type", Error, Expected(demands::wrong_data_type), fix Unsafe
}
