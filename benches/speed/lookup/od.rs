// Made by objdict 0.1.0; do not edit.
//
// Object dictionary of (no name) by (no name).
//
// `Data` contains the variable values: `get` and `set` take the constants of this file, `read` and
// `write` index and sub-index, as an SDO does. The file has no dependencies and needs no standard
// library; use it as a module or with `include!`. Products rarely use all of it, so dead code is
// allowed; `unreachable_pub` depends on where it is included.

/// Size of the longest value in bytes.
#[allow(dead_code, unreachable_pub)]
pub const MAX_SIZE: usize = 4;

/// The dictionary of this device, as a type.
#[allow(unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Od;

/// The variable values; constants are in flash.
#[allow(dead_code, unreachable_pub)]
pub type Data = table::Data<Od, 521>;

/// An entry of the dictionary.
#[allow(dead_code, unreachable_pub)]
pub type Entry = table::Entry<Od>;

/// An entry with its type and access.
#[allow(dead_code, unreachable_pub)]
pub type Handle<T, A> = table::Handle<Od, T, A>;

/// The elements of an array.
#[allow(dead_code, unreachable_pub)]
pub type Array<T, A> = table::Array<Od, T, A>;

#[allow(unused_imports, unreachable_pub)]
pub use table::{Abort, Const, Elsewhere, NodeConst, Ro, Rw, Time, Wo};

/// Finds the entry with an index and a sub-index by binary search.
///
/// # Errors
/// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
#[allow(dead_code, unreachable_pub)]
pub const fn find(index: u16, sub: u8) -> Result<&'static Entry, Abort> {
    Entry::find(index, sub)
}

#[allow(unused_imports, unreachable_pub)]
pub use self::manufacturer::*;

/// Objects of the manufacturer: `0x2000` to `0x5FFF`.
#[allow(dead_code, unreachable_pub, unused_imports, clippy::wildcard_imports)]
#[rustfmt::skip]
pub mod manufacturer {
    use super::*;

    /// `0x2000`: `Parameter 0`, `rw`, default `0`.
    pub const PARAMETER_0: Handle<u32, Rw> = Handle::of(0x2000, 0x00);

    /// `0x2007`: `Parameter 1`, `rw`, default `1`.
    pub const PARAMETER_1: Handle<u32, Rw> = Handle::of(0x2007, 0x00);

    /// `0x200E`: `Parameter 2`, `rw`, default `2`.
    pub const PARAMETER_2: Handle<u32, Rw> = Handle::of(0x200E, 0x00);

    /// `0x2015`: `Parameter 3`, `rw`, default `3`.
    pub const PARAMETER_3: Handle<u32, Rw> = Handle::of(0x2015, 0x00);

    /// `0x201C`: `Parameter 4`, `rw`, default `4`.
    pub const PARAMETER_4: Handle<u32, Rw> = Handle::of(0x201C, 0x00);

    /// `0x2023`: `Parameter 5`, `rw`, default `5`.
    pub const PARAMETER_5: Handle<u32, Rw> = Handle::of(0x2023, 0x00);

    /// `0x202A`: `Parameter 6`, `rw`, default `6`.
    pub const PARAMETER_6: Handle<u32, Rw> = Handle::of(0x202A, 0x00);

    /// `0x2031`: `Parameter 7`, `rw`, default `7`.
    pub const PARAMETER_7: Handle<u32, Rw> = Handle::of(0x2031, 0x00);

    /// `0x2038`: `Parameter 8`, `rw`, default `8`.
    pub const PARAMETER_8: Handle<u32, Rw> = Handle::of(0x2038, 0x00);

    /// `0x203F`: `Parameter 9`, `rw`, default `9`.
    pub const PARAMETER_9: Handle<u32, Rw> = Handle::of(0x203F, 0x00);

    /// `0x2046`: `Parameter 10`, `rw`, default `10`.
    pub const PARAMETER_10: Handle<u32, Rw> = Handle::of(0x2046, 0x00);

    /// `0x204D`: `Parameter 11`, `rw`, default `11`.
    pub const PARAMETER_11: Handle<u32, Rw> = Handle::of(0x204D, 0x00);

    /// `0x2054`: `Parameter 12`, `rw`, default `12`.
    pub const PARAMETER_12: Handle<u32, Rw> = Handle::of(0x2054, 0x00);

    /// `0x205B`: `Parameter 13`, `rw`, default `13`.
    pub const PARAMETER_13: Handle<u32, Rw> = Handle::of(0x205B, 0x00);

    /// `0x2062`: `Parameter 14`, `rw`, default `14`.
    pub const PARAMETER_14: Handle<u32, Rw> = Handle::of(0x2062, 0x00);

    /// `0x2069`: `Parameter 15`, `rw`, default `15`.
    pub const PARAMETER_15: Handle<u32, Rw> = Handle::of(0x2069, 0x00);

    /// `0x2070`: `Parameter 16`, `rw`, default `16`.
    pub const PARAMETER_16: Handle<u32, Rw> = Handle::of(0x2070, 0x00);

    /// `0x2077`: `Parameter 17`, `rw`, default `17`.
    pub const PARAMETER_17: Handle<u32, Rw> = Handle::of(0x2077, 0x00);

    /// `0x207E`: `Parameter 18`, `rw`, default `18`.
    pub const PARAMETER_18: Handle<u32, Rw> = Handle::of(0x207E, 0x00);

    /// `0x2085`: `Parameter 19`, `rw`, default `19`.
    pub const PARAMETER_19: Handle<u32, Rw> = Handle::of(0x2085, 0x00);

    /// `0x208C`: `Parameter 20`, `rw`, default `20`.
    pub const PARAMETER_20: Handle<u32, Rw> = Handle::of(0x208C, 0x00);

    /// `0x2093`: `Parameter 21`, `rw`, default `21`.
    pub const PARAMETER_21: Handle<u32, Rw> = Handle::of(0x2093, 0x00);

    /// `0x209A`: `Parameter 22`, `rw`, default `22`.
    pub const PARAMETER_22: Handle<u32, Rw> = Handle::of(0x209A, 0x00);

    /// `0x20A1`: `Parameter 23`, `rw`, default `23`.
    pub const PARAMETER_23: Handle<u32, Rw> = Handle::of(0x20A1, 0x00);

    /// `0x20A8`: `Parameter 24`, `rw`, default `24`.
    pub const PARAMETER_24: Handle<u32, Rw> = Handle::of(0x20A8, 0x00);

    /// `0x20AF`: `Parameter 25`, `rw`, default `25`.
    pub const PARAMETER_25: Handle<u32, Rw> = Handle::of(0x20AF, 0x00);

    /// `0x20B6`: `Parameter 26`, `rw`, default `26`.
    pub const PARAMETER_26: Handle<u32, Rw> = Handle::of(0x20B6, 0x00);

    /// `0x20BD`: `Parameter 27`, `rw`, default `27`.
    pub const PARAMETER_27: Handle<u32, Rw> = Handle::of(0x20BD, 0x00);

    /// `0x20C4`: `Parameter 28`, `rw`, default `28`.
    pub const PARAMETER_28: Handle<u32, Rw> = Handle::of(0x20C4, 0x00);

    /// `0x20CB`: `Parameter 29`, `rw`, default `29`.
    pub const PARAMETER_29: Handle<u32, Rw> = Handle::of(0x20CB, 0x00);

    /// `0x20D2`: `Parameter 30`, `rw`, default `30`.
    pub const PARAMETER_30: Handle<u32, Rw> = Handle::of(0x20D2, 0x00);

    /// `0x20D9`: `Parameter 31`, `rw`, default `31`.
    pub const PARAMETER_31: Handle<u32, Rw> = Handle::of(0x20D9, 0x00);

    /// `0x20E0`: `Parameter 32`, `rw`, default `32`.
    pub const PARAMETER_32: Handle<u32, Rw> = Handle::of(0x20E0, 0x00);

    /// `0x20E7`: `Parameter 33`, `rw`, default `33`.
    pub const PARAMETER_33: Handle<u32, Rw> = Handle::of(0x20E7, 0x00);

    /// `0x20EE`: `Parameter 34`, `rw`, default `34`.
    pub const PARAMETER_34: Handle<u32, Rw> = Handle::of(0x20EE, 0x00);

    /// `0x20F5`: `Parameter 35`, `rw`, default `35`.
    pub const PARAMETER_35: Handle<u32, Rw> = Handle::of(0x20F5, 0x00);

    /// `0x20FC`: `Parameter 36`, `rw`, default `36`.
    pub const PARAMETER_36: Handle<u32, Rw> = Handle::of(0x20FC, 0x00);

    /// `0x2103`: `Parameter 37`, `rw`, default `37`.
    pub const PARAMETER_37: Handle<u32, Rw> = Handle::of(0x2103, 0x00);

    /// `0x210A`: `Parameter 38`, `rw`, default `38`.
    pub const PARAMETER_38: Handle<u32, Rw> = Handle::of(0x210A, 0x00);

    /// `0x2111`: `Parameter 39`, `rw`, default `39`.
    pub const PARAMETER_39: Handle<u32, Rw> = Handle::of(0x2111, 0x00);

    /// `0x2118`: `Parameter 40`, `rw`, default `40`.
    pub const PARAMETER_40: Handle<u32, Rw> = Handle::of(0x2118, 0x00);

    /// `0x211F`: `Parameter 41`, `rw`, default `41`.
    pub const PARAMETER_41: Handle<u32, Rw> = Handle::of(0x211F, 0x00);

    /// `0x2126`: `Parameter 42`, `rw`, default `42`.
    pub const PARAMETER_42: Handle<u32, Rw> = Handle::of(0x2126, 0x00);

    /// `0x212D`: `Parameter 43`, `rw`, default `43`.
    pub const PARAMETER_43: Handle<u32, Rw> = Handle::of(0x212D, 0x00);

    /// `0x2134`: `Parameter 44`, `rw`, default `44`.
    pub const PARAMETER_44: Handle<u32, Rw> = Handle::of(0x2134, 0x00);

    /// `0x213B`: `Parameter 45`, `rw`, default `45`.
    pub const PARAMETER_45: Handle<u32, Rw> = Handle::of(0x213B, 0x00);

    /// `0x2142`: `Parameter 46`, `rw`, default `46`.
    pub const PARAMETER_46: Handle<u32, Rw> = Handle::of(0x2142, 0x00);

    /// `0x2149`: `Parameter 47`, `rw`, default `47`.
    pub const PARAMETER_47: Handle<u32, Rw> = Handle::of(0x2149, 0x00);

    /// `0x2150`: `Parameter 48`, `rw`, default `48`.
    pub const PARAMETER_48: Handle<u32, Rw> = Handle::of(0x2150, 0x00);
}

#[allow(unused_imports, unreachable_pub)]
pub use self::profile::*;

/// Objects of the device profile: `0x6000` to `0x9FFF`.
#[allow(dead_code, unreachable_pub, unused_imports, clippy::wildcard_imports)]
#[rustfmt::skip]
pub mod profile {
    use super::*;

    /// `0x6000`: `Axis 0`.
    pub mod axis_0 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6000;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6010`: `Axis 1`.
    pub mod axis_1 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6010;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6020`: `Axis 2`.
    pub mod axis_2 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6020;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6030`: `Axis 3`.
    pub mod axis_3 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6030;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6040`: `Axis 4`.
    pub mod axis_4 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6040;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6050`: `Axis 5`.
    pub mod axis_5 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6050;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6060`: `Axis 6`.
    pub mod axis_6 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6060;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6070`: `Axis 7`.
    pub mod axis_7 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6070;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6080`: `Axis 8`.
    pub mod axis_8 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6080;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6090`: `Axis 9`.
    pub mod axis_9 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6090;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x60A0`: `Axis 10`.
    pub mod axis_10 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x60A0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x60B0`: `Axis 11`.
    pub mod axis_11 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x60B0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x60C0`: `Axis 12`.
    pub mod axis_12 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x60C0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x60D0`: `Axis 13`.
    pub mod axis_13 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x60D0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x60E0`: `Axis 14`.
    pub mod axis_14 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x60E0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x60F0`: `Axis 15`.
    pub mod axis_15 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x60F0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6100`: `Axis 16`.
    pub mod axis_16 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6100;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6110`: `Axis 17`.
    pub mod axis_17 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6110;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6120`: `Axis 18`.
    pub mod axis_18 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6120;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6130`: `Axis 19`.
    pub mod axis_19 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6130;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6140`: `Axis 20`.
    pub mod axis_20 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6140;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6150`: `Axis 21`.
    pub mod axis_21 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6150;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6160`: `Axis 22`.
    pub mod axis_22 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6160;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6170`: `Axis 23`.
    pub mod axis_23 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6170;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6180`: `Axis 24`.
    pub mod axis_24 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6180;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x6190`: `Axis 25`.
    pub mod axis_25 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x6190;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }

    /// `0x61A0`: `Axis 26`.
    pub mod axis_26 {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x61A0;
        /// Sub-index `0x00`: `Highest sub-index supported`, `const`, default `3`.
        pub const HIGHEST_SUB_INDEX_SUPPORTED: Handle<u8, Const> = Handle::of(INDEX, 0x00);
        /// Sub-index `0x01`: `Gain 1`, `rw`, default `1`.
        pub const GAIN_1: Handle<u32, Rw> = Handle::of(INDEX, 0x01);
        /// Sub-index `0x02`: `Gain 2`, `rw`, default `2`.
        pub const GAIN_2: Handle<u32, Rw> = Handle::of(INDEX, 0x02);
        /// Sub-index `0x03`: `Gain 3`, `rw`, default `3`.
        pub const GAIN_3: Handle<u32, Rw> = Handle::of(INDEX, 0x03);
    }
}

/// Default values of identity and services, decoded. COB-IDs are functions of the node-ID. `Data`
/// contains the present values.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::arithmetic_side_effects, clippy::cast_lossless)]
#[rustfmt::skip]
pub mod defaults {
    /// COB-ID of boot-up and heartbeat (`CiA` 301).
    #[must_use]
    pub const fn heartbeat_cob_id(node_id: u8) -> u32 {
        0x700 + node_id as u32
    }
}

/// All entries in ascending order of index and sub-index.
#[allow(dead_code, unreachable_pub, clippy::wildcard_imports)]
#[rustfmt::skip]
pub static ENTRIES: [Entry; 157] = {
    use table::*;
    [
        Entry::new(0x2000, 0x00, UNSIGNED32, READ | WRITE, 1, 0), // `Parameter 0`
        Entry::new(0x2007, 0x00, UNSIGNED32, READ | WRITE, 5, 4), // `Parameter 1`
        Entry::new(0x200E, 0x00, UNSIGNED32, READ | WRITE, 9, 8), // `Parameter 2`
        Entry::new(0x2015, 0x00, UNSIGNED32, READ | WRITE, 13, 12), // `Parameter 3`
        Entry::new(0x201C, 0x00, UNSIGNED32, READ | WRITE, 17, 16), // `Parameter 4`
        Entry::new(0x2023, 0x00, UNSIGNED32, READ | WRITE, 21, 20), // `Parameter 5`
        Entry::new(0x202A, 0x00, UNSIGNED32, READ | WRITE, 25, 24), // `Parameter 6`
        Entry::new(0x2031, 0x00, UNSIGNED32, READ | WRITE, 29, 28), // `Parameter 7`
        Entry::new(0x2038, 0x00, UNSIGNED32, READ | WRITE, 33, 32), // `Parameter 8`
        Entry::new(0x203F, 0x00, UNSIGNED32, READ | WRITE, 37, 36), // `Parameter 9`
        Entry::new(0x2046, 0x00, UNSIGNED32, READ | WRITE, 41, 40), // `Parameter 10`
        Entry::new(0x204D, 0x00, UNSIGNED32, READ | WRITE, 45, 44), // `Parameter 11`
        Entry::new(0x2054, 0x00, UNSIGNED32, READ | WRITE, 49, 48), // `Parameter 12`
        Entry::new(0x205B, 0x00, UNSIGNED32, READ | WRITE, 53, 52), // `Parameter 13`
        Entry::new(0x2062, 0x00, UNSIGNED32, READ | WRITE, 57, 56), // `Parameter 14`
        Entry::new(0x2069, 0x00, UNSIGNED32, READ | WRITE, 61, 60), // `Parameter 15`
        Entry::new(0x2070, 0x00, UNSIGNED32, READ | WRITE, 65, 64), // `Parameter 16`
        Entry::new(0x2077, 0x00, UNSIGNED32, READ | WRITE, 69, 68), // `Parameter 17`
        Entry::new(0x207E, 0x00, UNSIGNED32, READ | WRITE, 73, 72), // `Parameter 18`
        Entry::new(0x2085, 0x00, UNSIGNED32, READ | WRITE, 77, 76), // `Parameter 19`
        Entry::new(0x208C, 0x00, UNSIGNED32, READ | WRITE, 81, 80), // `Parameter 20`
        Entry::new(0x2093, 0x00, UNSIGNED32, READ | WRITE, 85, 84), // `Parameter 21`
        Entry::new(0x209A, 0x00, UNSIGNED32, READ | WRITE, 89, 88), // `Parameter 22`
        Entry::new(0x20A1, 0x00, UNSIGNED32, READ | WRITE, 93, 92), // `Parameter 23`
        Entry::new(0x20A8, 0x00, UNSIGNED32, READ | WRITE, 97, 96), // `Parameter 24`
        Entry::new(0x20AF, 0x00, UNSIGNED32, READ | WRITE, 101, 100), // `Parameter 25`
        Entry::new(0x20B6, 0x00, UNSIGNED32, READ | WRITE, 105, 104), // `Parameter 26`
        Entry::new(0x20BD, 0x00, UNSIGNED32, READ | WRITE, 109, 108), // `Parameter 27`
        Entry::new(0x20C4, 0x00, UNSIGNED32, READ | WRITE, 113, 112), // `Parameter 28`
        Entry::new(0x20CB, 0x00, UNSIGNED32, READ | WRITE, 117, 116), // `Parameter 29`
        Entry::new(0x20D2, 0x00, UNSIGNED32, READ | WRITE, 121, 120), // `Parameter 30`
        Entry::new(0x20D9, 0x00, UNSIGNED32, READ | WRITE, 125, 124), // `Parameter 31`
        Entry::new(0x20E0, 0x00, UNSIGNED32, READ | WRITE, 129, 128), // `Parameter 32`
        Entry::new(0x20E7, 0x00, UNSIGNED32, READ | WRITE, 133, 132), // `Parameter 33`
        Entry::new(0x20EE, 0x00, UNSIGNED32, READ | WRITE, 137, 136), // `Parameter 34`
        Entry::new(0x20F5, 0x00, UNSIGNED32, READ | WRITE, 141, 140), // `Parameter 35`
        Entry::new(0x20FC, 0x00, UNSIGNED32, READ | WRITE, 145, 144), // `Parameter 36`
        Entry::new(0x2103, 0x00, UNSIGNED32, READ | WRITE, 149, 148), // `Parameter 37`
        Entry::new(0x210A, 0x00, UNSIGNED32, READ | WRITE, 153, 152), // `Parameter 38`
        Entry::new(0x2111, 0x00, UNSIGNED32, READ | WRITE, 157, 156), // `Parameter 39`
        Entry::new(0x2118, 0x00, UNSIGNED32, READ | WRITE, 161, 160), // `Parameter 40`
        Entry::new(0x211F, 0x00, UNSIGNED32, READ | WRITE, 165, 164), // `Parameter 41`
        Entry::new(0x2126, 0x00, UNSIGNED32, READ | WRITE, 169, 168), // `Parameter 42`
        Entry::new(0x212D, 0x00, UNSIGNED32, READ | WRITE, 173, 172), // `Parameter 43`
        Entry::new(0x2134, 0x00, UNSIGNED32, READ | WRITE, 177, 176), // `Parameter 44`
        Entry::new(0x213B, 0x00, UNSIGNED32, READ | WRITE, 181, 180), // `Parameter 45`
        Entry::new(0x2142, 0x00, UNSIGNED32, READ | WRITE, 185, 184), // `Parameter 46`
        Entry::new(0x2149, 0x00, UNSIGNED32, READ | WRITE, 189, 188), // `Parameter 47`
        Entry::new(0x2150, 0x00, UNSIGNED32, READ | WRITE, 193, 192), // `Parameter 48`
        Entry::new(0x6000, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6000, 0x01, UNSIGNED32, READ | WRITE, 197, 4), // `Gain 1`
        Entry::new(0x6000, 0x02, UNSIGNED32, READ | WRITE, 201, 8), // `Gain 2`
        Entry::new(0x6000, 0x03, UNSIGNED32, READ | WRITE, 205, 12), // `Gain 3`
        Entry::new(0x6010, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6010, 0x01, UNSIGNED32, READ | WRITE, 209, 4), // `Gain 1`
        Entry::new(0x6010, 0x02, UNSIGNED32, READ | WRITE, 213, 8), // `Gain 2`
        Entry::new(0x6010, 0x03, UNSIGNED32, READ | WRITE, 217, 12), // `Gain 3`
        Entry::new(0x6020, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6020, 0x01, UNSIGNED32, READ | WRITE, 221, 4), // `Gain 1`
        Entry::new(0x6020, 0x02, UNSIGNED32, READ | WRITE, 225, 8), // `Gain 2`
        Entry::new(0x6020, 0x03, UNSIGNED32, READ | WRITE, 229, 12), // `Gain 3`
        Entry::new(0x6030, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6030, 0x01, UNSIGNED32, READ | WRITE, 233, 4), // `Gain 1`
        Entry::new(0x6030, 0x02, UNSIGNED32, READ | WRITE, 237, 8), // `Gain 2`
        Entry::new(0x6030, 0x03, UNSIGNED32, READ | WRITE, 241, 12), // `Gain 3`
        Entry::new(0x6040, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6040, 0x01, UNSIGNED32, READ | WRITE, 245, 4), // `Gain 1`
        Entry::new(0x6040, 0x02, UNSIGNED32, READ | WRITE, 249, 8), // `Gain 2`
        Entry::new(0x6040, 0x03, UNSIGNED32, READ | WRITE, 253, 12), // `Gain 3`
        Entry::new(0x6050, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6050, 0x01, UNSIGNED32, READ | WRITE, 257, 4), // `Gain 1`
        Entry::new(0x6050, 0x02, UNSIGNED32, READ | WRITE, 261, 8), // `Gain 2`
        Entry::new(0x6050, 0x03, UNSIGNED32, READ | WRITE, 265, 12), // `Gain 3`
        Entry::new(0x6060, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6060, 0x01, UNSIGNED32, READ | WRITE, 269, 4), // `Gain 1`
        Entry::new(0x6060, 0x02, UNSIGNED32, READ | WRITE, 273, 8), // `Gain 2`
        Entry::new(0x6060, 0x03, UNSIGNED32, READ | WRITE, 277, 12), // `Gain 3`
        Entry::new(0x6070, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6070, 0x01, UNSIGNED32, READ | WRITE, 281, 4), // `Gain 1`
        Entry::new(0x6070, 0x02, UNSIGNED32, READ | WRITE, 285, 8), // `Gain 2`
        Entry::new(0x6070, 0x03, UNSIGNED32, READ | WRITE, 289, 12), // `Gain 3`
        Entry::new(0x6080, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6080, 0x01, UNSIGNED32, READ | WRITE, 293, 4), // `Gain 1`
        Entry::new(0x6080, 0x02, UNSIGNED32, READ | WRITE, 297, 8), // `Gain 2`
        Entry::new(0x6080, 0x03, UNSIGNED32, READ | WRITE, 301, 12), // `Gain 3`
        Entry::new(0x6090, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6090, 0x01, UNSIGNED32, READ | WRITE, 305, 4), // `Gain 1`
        Entry::new(0x6090, 0x02, UNSIGNED32, READ | WRITE, 309, 8), // `Gain 2`
        Entry::new(0x6090, 0x03, UNSIGNED32, READ | WRITE, 313, 12), // `Gain 3`
        Entry::new(0x60A0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x60A0, 0x01, UNSIGNED32, READ | WRITE, 317, 4), // `Gain 1`
        Entry::new(0x60A0, 0x02, UNSIGNED32, READ | WRITE, 321, 8), // `Gain 2`
        Entry::new(0x60A0, 0x03, UNSIGNED32, READ | WRITE, 325, 12), // `Gain 3`
        Entry::new(0x60B0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x60B0, 0x01, UNSIGNED32, READ | WRITE, 329, 4), // `Gain 1`
        Entry::new(0x60B0, 0x02, UNSIGNED32, READ | WRITE, 333, 8), // `Gain 2`
        Entry::new(0x60B0, 0x03, UNSIGNED32, READ | WRITE, 337, 12), // `Gain 3`
        Entry::new(0x60C0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x60C0, 0x01, UNSIGNED32, READ | WRITE, 341, 4), // `Gain 1`
        Entry::new(0x60C0, 0x02, UNSIGNED32, READ | WRITE, 345, 8), // `Gain 2`
        Entry::new(0x60C0, 0x03, UNSIGNED32, READ | WRITE, 349, 12), // `Gain 3`
        Entry::new(0x60D0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x60D0, 0x01, UNSIGNED32, READ | WRITE, 353, 4), // `Gain 1`
        Entry::new(0x60D0, 0x02, UNSIGNED32, READ | WRITE, 357, 8), // `Gain 2`
        Entry::new(0x60D0, 0x03, UNSIGNED32, READ | WRITE, 361, 12), // `Gain 3`
        Entry::new(0x60E0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x60E0, 0x01, UNSIGNED32, READ | WRITE, 365, 4), // `Gain 1`
        Entry::new(0x60E0, 0x02, UNSIGNED32, READ | WRITE, 369, 8), // `Gain 2`
        Entry::new(0x60E0, 0x03, UNSIGNED32, READ | WRITE, 373, 12), // `Gain 3`
        Entry::new(0x60F0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x60F0, 0x01, UNSIGNED32, READ | WRITE, 377, 4), // `Gain 1`
        Entry::new(0x60F0, 0x02, UNSIGNED32, READ | WRITE, 381, 8), // `Gain 2`
        Entry::new(0x60F0, 0x03, UNSIGNED32, READ | WRITE, 385, 12), // `Gain 3`
        Entry::new(0x6100, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6100, 0x01, UNSIGNED32, READ | WRITE, 389, 4), // `Gain 1`
        Entry::new(0x6100, 0x02, UNSIGNED32, READ | WRITE, 393, 8), // `Gain 2`
        Entry::new(0x6100, 0x03, UNSIGNED32, READ | WRITE, 397, 12), // `Gain 3`
        Entry::new(0x6110, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6110, 0x01, UNSIGNED32, READ | WRITE, 401, 4), // `Gain 1`
        Entry::new(0x6110, 0x02, UNSIGNED32, READ | WRITE, 405, 8), // `Gain 2`
        Entry::new(0x6110, 0x03, UNSIGNED32, READ | WRITE, 409, 12), // `Gain 3`
        Entry::new(0x6120, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6120, 0x01, UNSIGNED32, READ | WRITE, 413, 4), // `Gain 1`
        Entry::new(0x6120, 0x02, UNSIGNED32, READ | WRITE, 417, 8), // `Gain 2`
        Entry::new(0x6120, 0x03, UNSIGNED32, READ | WRITE, 421, 12), // `Gain 3`
        Entry::new(0x6130, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6130, 0x01, UNSIGNED32, READ | WRITE, 425, 4), // `Gain 1`
        Entry::new(0x6130, 0x02, UNSIGNED32, READ | WRITE, 429, 8), // `Gain 2`
        Entry::new(0x6130, 0x03, UNSIGNED32, READ | WRITE, 433, 12), // `Gain 3`
        Entry::new(0x6140, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6140, 0x01, UNSIGNED32, READ | WRITE, 437, 4), // `Gain 1`
        Entry::new(0x6140, 0x02, UNSIGNED32, READ | WRITE, 441, 8), // `Gain 2`
        Entry::new(0x6140, 0x03, UNSIGNED32, READ | WRITE, 445, 12), // `Gain 3`
        Entry::new(0x6150, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6150, 0x01, UNSIGNED32, READ | WRITE, 449, 4), // `Gain 1`
        Entry::new(0x6150, 0x02, UNSIGNED32, READ | WRITE, 453, 8), // `Gain 2`
        Entry::new(0x6150, 0x03, UNSIGNED32, READ | WRITE, 457, 12), // `Gain 3`
        Entry::new(0x6160, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6160, 0x01, UNSIGNED32, READ | WRITE, 461, 4), // `Gain 1`
        Entry::new(0x6160, 0x02, UNSIGNED32, READ | WRITE, 465, 8), // `Gain 2`
        Entry::new(0x6160, 0x03, UNSIGNED32, READ | WRITE, 469, 12), // `Gain 3`
        Entry::new(0x6170, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6170, 0x01, UNSIGNED32, READ | WRITE, 473, 4), // `Gain 1`
        Entry::new(0x6170, 0x02, UNSIGNED32, READ | WRITE, 477, 8), // `Gain 2`
        Entry::new(0x6170, 0x03, UNSIGNED32, READ | WRITE, 481, 12), // `Gain 3`
        Entry::new(0x6180, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6180, 0x01, UNSIGNED32, READ | WRITE, 485, 4), // `Gain 1`
        Entry::new(0x6180, 0x02, UNSIGNED32, READ | WRITE, 489, 8), // `Gain 2`
        Entry::new(0x6180, 0x03, UNSIGNED32, READ | WRITE, 493, 12), // `Gain 3`
        Entry::new(0x6190, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x6190, 0x01, UNSIGNED32, READ | WRITE, 497, 4), // `Gain 1`
        Entry::new(0x6190, 0x02, UNSIGNED32, READ | WRITE, 501, 8), // `Gain 2`
        Entry::new(0x6190, 0x03, UNSIGNED32, READ | WRITE, 505, 12), // `Gain 3`
        Entry::new(0x61A0, 0x00, UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
        Entry::new(0x61A0, 0x01, UNSIGNED32, READ | WRITE, 509, 4), // `Gain 1`
        Entry::new(0x61A0, 0x02, UNSIGNED32, READ | WRITE, 513, 8), // `Gain 2`
        Entry::new(0x61A0, 0x03, UNSIGNED32, READ | WRITE, 517, 12), // `Gain 3`
    ]
};

impl table::Table for Od {
    const ENTRIES: &'static [Entry] = &ENTRIES;

    #[rustfmt::skip]
    const ROM: &'static [u8] = {
        static ROM: [u8; 196] = [
            0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00,
            0x04, 0x00, 0x00, 0x00, 0x05, 0x00, 0x00, 0x00, 0x06, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00,
            0x08, 0x00, 0x00, 0x00, 0x09, 0x00, 0x00, 0x00, 0x0A, 0x00, 0x00, 0x00, 0x0B, 0x00, 0x00, 0x00,
            0x0C, 0x00, 0x00, 0x00, 0x0D, 0x00, 0x00, 0x00, 0x0E, 0x00, 0x00, 0x00, 0x0F, 0x00, 0x00, 0x00,
            0x10, 0x00, 0x00, 0x00, 0x11, 0x00, 0x00, 0x00, 0x12, 0x00, 0x00, 0x00, 0x13, 0x00, 0x00, 0x00,
            0x14, 0x00, 0x00, 0x00, 0x15, 0x00, 0x00, 0x00, 0x16, 0x00, 0x00, 0x00, 0x17, 0x00, 0x00, 0x00,
            0x18, 0x00, 0x00, 0x00, 0x19, 0x00, 0x00, 0x00, 0x1A, 0x00, 0x00, 0x00, 0x1B, 0x00, 0x00, 0x00,
            0x1C, 0x00, 0x00, 0x00, 0x1D, 0x00, 0x00, 0x00, 0x1E, 0x00, 0x00, 0x00, 0x1F, 0x00, 0x00, 0x00,
            0x20, 0x00, 0x00, 0x00, 0x21, 0x00, 0x00, 0x00, 0x22, 0x00, 0x00, 0x00, 0x23, 0x00, 0x00, 0x00,
            0x24, 0x00, 0x00, 0x00, 0x25, 0x00, 0x00, 0x00, 0x26, 0x00, 0x00, 0x00, 0x27, 0x00, 0x00, 0x00,
            0x28, 0x00, 0x00, 0x00, 0x29, 0x00, 0x00, 0x00, 0x2A, 0x00, 0x00, 0x00, 0x2B, 0x00, 0x00, 0x00,
            0x2C, 0x00, 0x00, 0x00, 0x2D, 0x00, 0x00, 0x00, 0x2E, 0x00, 0x00, 0x00, 0x2F, 0x00, 0x00, 0x00,
            0x30, 0x00, 0x00, 0x00,
        ];
        &ROM
    };

    // not part of the program unless used
    #[rustfmt::skip]
    const NAMES: &'static [&'static str] = {
        static NAMES: [&str; 157] = [
            "Parameter 0",
            "Parameter 1",
            "Parameter 2",
            "Parameter 3",
            "Parameter 4",
            "Parameter 5",
            "Parameter 6",
            "Parameter 7",
            "Parameter 8",
            "Parameter 9",
            "Parameter 10",
            "Parameter 11",
            "Parameter 12",
            "Parameter 13",
            "Parameter 14",
            "Parameter 15",
            "Parameter 16",
            "Parameter 17",
            "Parameter 18",
            "Parameter 19",
            "Parameter 20",
            "Parameter 21",
            "Parameter 22",
            "Parameter 23",
            "Parameter 24",
            "Parameter 25",
            "Parameter 26",
            "Parameter 27",
            "Parameter 28",
            "Parameter 29",
            "Parameter 30",
            "Parameter 31",
            "Parameter 32",
            "Parameter 33",
            "Parameter 34",
            "Parameter 35",
            "Parameter 36",
            "Parameter 37",
            "Parameter 38",
            "Parameter 39",
            "Parameter 40",
            "Parameter 41",
            "Parameter 42",
            "Parameter 43",
            "Parameter 44",
            "Parameter 45",
            "Parameter 46",
            "Parameter 47",
            "Parameter 48",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
            "Highest sub-index supported",
            "Gain 1",
            "Gain 2",
            "Gain 3",
        ];
        &NAMES
    };
}

/// The code that serves the table, which is the same for every device.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::arithmetic_side_effects, clippy::nursery, clippy::pedantic)]
#[rustfmt::skip]
pub mod table {
macro_rules! aborts {
    ($($name:ident = $code:literal, $text:literal;)*) => {
        /// Why an SDO transfer is aborted (`CiA` 301, 7.2.4.3.17).
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Abort {
            $(#[doc = concat!($text, ".")] $name,)*
            /// A code without a meaning in `CiA` 301.
            Other(u32),
        }

        impl Abort {
            /// The abort code.
            #[must_use]
            pub const fn code(self) -> u32 {
                match self {
                    $(Self::$name => $code,)*
                    Self::Other(code) => code,
                }
            }

            const fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                    Self::Other(_) => "unknown abort code",
                }
            }
        }

        impl From<u32> for Abort {
            fn from(code: u32) -> Self {
                match code {
                    $($code => Self::$name,)*
                    _ => Self::Other(code),
                }
            }
        }
    };
}

aborts! {
    ToggleBit = 0x0503_0000, "the toggle bit does not alternate";
    Timeout = 0x0504_0000, "the transfer timed out";
    UnknownCommand = 0x0504_0001, "unknown command specifier";
    BlockSize = 0x0504_0002, "invalid block size";
    SequenceNumber = 0x0504_0003, "invalid sequence number";
    Crc = 0x0504_0004, "the CRC does not match";
    OutOfMemory = 0x0504_0005, "the buffer is shorter than the value";
    UnsupportedAccess = 0x0601_0000, "unsupported access";
    WriteOnly = 0x0601_0001, "attempt to read a write-only entry";
    ReadOnly = 0x0601_0002, "attempt to write a read-only entry";
    NoObject = 0x0602_0000, "there is no object with this index";
    NotMappable = 0x0604_0041, "the entry cannot be mapped to the PDO";
    PdoTooLong = 0x0604_0042, "the mapped entries are longer than the PDO";
    Incompatible = 0x0604_0043, "the value contradicts others";
    InternalIncompatible = 0x0604_0047, "the device contradicts itself";
    Hardware = 0x0606_0000, "the hardware failed";
    LengthMismatch = 0x0607_0010, "the number of bytes does not match the data type";
    TooLong = 0x0607_0012, "more bytes than the data type or the capacity";
    TooShort = 0x0607_0013, "fewer bytes than the data type";
    NoSubIndex = 0x0609_0011, "the object has no such sub-index";
    InvalidValue = 0x0609_0030, "not valid for the data type";
    TooHigh = 0x0609_0031, "above the high limit";
    TooLow = 0x0609_0032, "below the low limit";
    MaximumBelowMinimum = 0x0609_0036, "the maximum is below the minimum";
    NoSdoConnection = 0x060A_0023, "no SDO connection is available";
    General = 0x0800_0000, "general error";
    CannotStore = 0x0800_0020, "the application cannot take the data";
    LocalControl = 0x0800_0021, "the device is controlled locally";
    DeviceState = 0x0800_0022, "not in this state of the device";
    NoDictionary = 0x0800_0023, "there is no object dictionary";
    NoData = 0x0800_0024, "no data is available";
}

impl From<Abort> for u32 {
    fn from(abort: Abort) -> Self {
        abort.code()
    }
}

impl core::fmt::Display for Abort {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "SDO abort {:08X}h: {}", self.code(), self.meaning())
    }
}

impl core::error::Error for Abort {}

/// Flag of a row: readable by SDO.
pub const READ: u16 = 0x001;
/// Flag of a row: writable by SDO.
pub const WRITE: u16 = 0x002;
/// Flag of a row: mappable to TPDOs.
pub const TPDO: u16 = 0x004;
/// Flag of a row: mappable to RPDOs.
pub const RPDO: u16 = 0x008;
/// Flag of a row: there is a low limit.
pub const LOW: u16 = 0x010;
/// Flag of a row: there is a high limit.
pub const HIGH: u16 = 0x020;
/// Flag of a row: the default is an offset to the node-ID.
pub const NODE_ID_DEFAULT: u16 = 0x040;
/// Flag of a row: the low limit is an offset to the node-ID.
pub const LOW_NODE_ID: u16 = 0x080;
/// Flag of a row: the high limit is an offset to the node-ID.
pub const HIGH_NODE_ID: u16 = 0x100;
/// Flag of a row: hooks are called.
pub const HOOK: u16 = 0x200;

/// Data type of a row: one of the device, with a fixed number of bytes.
pub const BLOCK: u8 = 0x00;
/// Data type of a row: BOOLEAN.
pub const BOOLEAN: u8 = 0x01;
/// Data type of a row: INTEGER8.
pub const INTEGER8: u8 = 0x02;
/// Data type of a row: INTEGER16.
pub const INTEGER16: u8 = 0x03;
/// Data type of a row: INTEGER32.
pub const INTEGER32: u8 = 0x04;
/// Data type of a row: UNSIGNED8.
pub const UNSIGNED8: u8 = 0x05;
/// Data type of a row: UNSIGNED16.
pub const UNSIGNED16: u8 = 0x06;
/// Data type of a row: UNSIGNED32.
pub const UNSIGNED32: u8 = 0x07;
/// Data type of a row: REAL32.
pub const REAL32: u8 = 0x08;
/// Data type of a row: `VISIBLE_STRING`.
pub const VISIBLE_STRING: u8 = 0x09;
/// Data type of a row: `OCTET_STRING`.
pub const OCTET_STRING: u8 = 0x0A;
/// Data type of a row: `UNICODE_STRING`.
pub const UNICODE_STRING: u8 = 0x0B;
/// Data type of a row: `TIME_OF_DAY`.
pub const TIME_OF_DAY: u8 = 0x0C;
/// Data type of a row: `TIME_DIFFERENCE`.
pub const TIME_DIFFERENCE: u8 = 0x0D;
/// Data type of a row: DOMAIN.
pub const DOMAIN: u8 = 0x0F;
/// Data type of a row: INTEGER24.
pub const INTEGER24: u8 = 0x10;
/// Data type of a row: REAL64.
pub const REAL64: u8 = 0x11;
/// Data type of a row: INTEGER40.
pub const INTEGER40: u8 = 0x12;
/// Data type of a row: INTEGER48.
pub const INTEGER48: u8 = 0x13;
/// Data type of a row: INTEGER56.
pub const INTEGER56: u8 = 0x14;
/// Data type of a row: INTEGER64.
pub const INTEGER64: u8 = 0x15;
/// Data type of a row: UNSIGNED24.
pub const UNSIGNED24: u8 = 0x16;
/// Data type of a row: UNSIGNED40.
pub const UNSIGNED40: u8 = 0x18;
/// Data type of a row: UNSIGNED48.
pub const UNSIGNED48: u8 = 0x19;
/// Data type of a row: UNSIGNED56.
pub const UNSIGNED56: u8 = 0x1A;
/// Data type of a row: UNSIGNED64.
pub const UNSIGNED64: u8 = 0x1B;

/// The table of a device: a type without values that the generated file implements this for.
pub trait Table: Copy + core::fmt::Debug + PartialEq + 'static {
    /// All entries in ascending order of index and sub-index.
    const ENTRIES: &'static [Entry<Self>];
    /// Defaults and limits. For a type of at most eight bytes: the default, then the low limit and the high limit
    /// if flagged, each with the size of the type. For any other type: the capacity and the length of the default as
    /// two 16-bit numbers, then the default. All numbers are little-endian.
    const ROM: &'static [u8];
    /// The name of each entry in the description, or none at all.
    const NAMES: &'static [&'static str] = &[];
    /// Whether writes are checked against limits.
    const CHECKS_LIMITS: bool = true;
}

/// An entry of the dictionary: a row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Entry<D> {
    index: u16,
    sub: u8,
    data_type: u8,
    /// The flags; in the highest six bits those of the offsets beyond 16 bits.
    flags: u16,
    ram: u16,
    rom: u16,
    table: core::marker::PhantomData<fn() -> D>,
}

impl<D: Table> Entry<D> {
    /// A row: `ram` is the offset of its value in `Data`, 0 for a value in flash, `rom` that of
    /// its data in flash. Both have at most 19 bits.
    #[must_use]
    pub const fn new(index: u16, sub: u8, data_type: u8, flags: u16, ram: u32, rom: u32) -> Self {
        let flags = flags | ((ram >> 16) << 10 | (rom >> 16) << 13) as u16;
        let (ram, rom) = (ram as u16, rom as u16);
        Self { index, sub, data_type, flags, ram, rom, table: core::marker::PhantomData }
    }

    /// Finds the entry with an index and a sub-index by binary search.
    ///
    /// # Errors
    /// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
    pub const fn find(index: u16, sub: u8) -> Result<&'static Self, Abort> {
        let key = (index as u32) << 8 | sub as u32;
        let mut entries = D::ENTRIES;
        let mut is_object = false;
        while let Some((below, [entry, above @ ..])) = entries.split_at_checked(entries.len() / 2) {
            let found = entry.key();
            if found == key {
                return Ok(entry);
            }
            // the neighbours of the missing key are both compared with it
            is_object |= entry.index == index;
            entries = if found < key { above } else { below };
        }
        Err(if is_object { Abort::NoSubIndex } else { Abort::NoObject })
    }

    /// The index.
    #[must_use]
    pub const fn index(&self) -> u16 {
        self.index
    }

    /// The sub-index.
    #[must_use]
    pub const fn sub(&self) -> u8 {
        self.sub
    }

    /// The index of the data type, such as 07h for UNSIGNED32; 0 for a device-specific type.
    #[must_use]
    pub const fn data_type(&self) -> u8 {
        self.data_type
    }

    /// Whether it is readable by SDO.
    #[must_use]
    pub const fn is_readable(&self) -> bool {
        self.flags & READ != 0
    }

    /// Whether it is writable by SDO.
    #[must_use]
    pub const fn is_writable(&self) -> bool {
        self.flags & WRITE != 0
    }

    /// Whether it is mappable to TPDOs.
    #[must_use]
    pub const fn fits_tpdo(&self) -> bool {
        self.flags & TPDO != 0
    }

    /// Whether it is mappable to RPDOs.
    #[must_use]
    pub const fn fits_rpdo(&self) -> bool {
        self.flags & RPDO != 0
    }

    /// Whether hooks are called.
    #[must_use]
    pub const fn is_hooked(&self) -> bool {
        self.flags & HOOK != 0
    }

    /// Whether the default is an offset to the node-ID.
    #[must_use]
    pub const fn adds_node_id(&self) -> bool {
        self.flags & NODE_ID_DEFAULT != 0
    }

    /// The name in the description; empty if the table has none.
    #[must_use]
    pub fn name(&self) -> &'static str {
        let row = D::ENTRIES.binary_search_by_key(&self.key(), Self::key);
        row.ok().and_then(|row| D::NAMES.get(row)).copied().unwrap_or("")
    }

    /// Maximum size of a value in an SDO transfer, in bytes.
    #[must_use]
    pub const fn size(&self) -> usize {
        match number_size(self.data_type) {
            0 => self.head(0),
            size => size,
        }
    }

    /// The bytes of the default; for a formula, of the offset to the node-ID.
    #[must_use]
    pub const fn default_bytes(&self) -> &'static [u8] {
        match number_size(self.data_type) {
            0 => self.stored(4, self.head(2)),
            size => self.stored(0, size),
        }
    }

    /// The default for a node with the bits of the value; 0 if it is not a number.
    #[must_use]
    pub const fn default_number(&self, node_id: u8) -> u64 {
        self.number(0, NODE_ID_DEFAULT, node_id)
    }

    /// The low limit for a node with the bits of the value; `None` without limit, or where limits are left out.
    #[must_use]
    pub const fn low_limit(&self, node_id: u8) -> Option<u64> {
        if !D::CHECKS_LIMITS || self.flags & LOW == 0 {
            return None;
        }
        Some(self.number(1, LOW_NODE_ID, node_id))
    }

    /// The high limit for a node, as [`Self::low_limit`].
    #[must_use]
    pub const fn high_limit(&self, node_id: u8) -> Option<u64> {
        if !D::CHECKS_LIMITS || self.flags & HIGH == 0 {
            return None;
        }
        let block = if self.flags & LOW != 0 { 2 } else { 1 };
        Some(self.number(block, HIGH_NODE_ID, node_id))
    }

    const fn key(&self) -> u32 {
        (self.index as u32) << 8 | self.sub as u32
    }

    pub(super) const fn is_number(&self) -> bool {
        number_size(self.data_type) != 0
    }

    pub(super) const fn is_block(&self) -> bool {
        self.data_type == BLOCK
    }

    /// Whether its value has a current length, which is in front of its bytes.
    pub(super) const fn has_length(&self) -> bool {
        !self.is_number() && !self.is_block()
    }

    pub(super) const fn is_time(&self) -> bool {
        matches!(self.data_type, TIME_OF_DAY | TIME_DIFFERENCE)
    }

    /// Whether the application must transfer its data: a DOMAIN without capacity.
    pub(super) const fn is_elsewhere(&self) -> bool {
        self.data_type == DOMAIN && self.size() == 0
    }

    /// The offset of its value; 0 for a value in flash.
    pub(super) const fn ram(&self) -> usize {
        self.ram as usize | (self.flags as usize >> 10 & 7) << 16
    }

    /// Size of its value in RAM, in bytes.
    pub(super) const fn ram_size(&self) -> usize {
        self.size() + if self.has_length() { 2 } else { 0 }
    }

    /// A part of its data in flash.
    const fn stored(&self, skip: usize, length: usize) -> &'static [u8] {
        let rom = self.rom as usize | (self.flags as usize >> 13) << 16;
        part(D::ROM, rom + skip, length)
    }

    /// The default as it is in RAM: of a text with its length. A formula needs the node-ID.
    pub(super) const fn initial_bytes(&self) -> &'static [u8] {
        if self.has_length() { self.stored(2, 2 + self.head(2)) } else { self.default_bytes() }
    }

    /// One of the two lengths before a non-numeric default.
    const fn head(&self, skip: usize) -> usize {
        match self.stored(skip, 2) {
            [low, high] => *low as usize | (*high as usize) << 8,
            _ => 0,
        }
    }

    /// A number in flash, plus the node-ID if the flag is set.
    const fn number(&self, block: usize, flag: u16, node_id: u8) -> u64 {
        let size = number_size(self.data_type);
        let number = number(self.data_type, self.stored(block * size, size));
        if self.flags & flag == 0 { number } else { number.wrapping_add((node_id & 0x7F) as u64) }
    }

    /// Whether a value may be written.
    pub(super) fn check(&self, bytes: &[u8], node_id: u8) -> Result<(), Abort> {
        let (length, size) = (bytes.len(), self.size());
        if length > size {
            Err(Abort::TooLong)
        } else if length < size && !self.has_length() {
            Err(Abort::TooShort)
        } else if self.data_type == UNICODE_STRING && length & 1 != 0 {
            Err(Abort::LengthMismatch)
        } else if self.data_type == BOOLEAN && bytes != [0] && bytes != [1] {
            Err(Abort::InvalidValue)
        } else if D::CHECKS_LIMITS && self.flags & (LOW | HIGH) != 0 {
            self.check_limits(number(self.data_type, bytes), node_id)
        } else {
            Ok(())
        }
    }

    fn check_limits(&self, number: u64, node_id: u8) -> Result<(), Abort> {
        let order = |number| order(self.data_type, number);
        let value = order(number).ok_or(Abort::InvalidValue)?;
        let low = self.low_limit(node_id).and_then(order);
        let high = self.high_limit(node_id).and_then(order);
        if low.is_some_and(|low| value < low) {
            Err(Abort::TooLow)
        } else if high.is_some_and(|high| value > high) {
            Err(Abort::TooHigh)
        } else {
            Ok(())
        }
    }
}

/// A part of these bytes; empty beyond their end.
pub(super) const fn part(bytes: &[u8], start: usize, length: usize) -> &[u8] {
    let Some((_, rest)) = bytes.split_at_checked(start) else { return &[] };
    match rest.split_at_checked(length) {
        Some((part, _)) => part,
        None => &[],
    }
}

/// Size of a number of this data type, in bytes; 0 for other types.
const fn number_size(data_type: u8) -> usize {
    match data_type {
        BOOLEAN | INTEGER8 | UNSIGNED8 => 1,
        INTEGER16 | UNSIGNED16 => 2,
        INTEGER24 | UNSIGNED24 => 3,
        INTEGER32 | UNSIGNED32 | REAL32 => 4,
        INTEGER40 | UNSIGNED40 => 5,
        INTEGER48 | UNSIGNED48 | TIME_OF_DAY | TIME_DIFFERENCE => 6,
        INTEGER56 | UNSIGNED56 => 7,
        INTEGER64 | UNSIGNED64 | REAL64 => 8,
        _ => 0,
    }
}

const fn is_signed(data_type: u8) -> bool {
    matches!(data_type, INTEGER8..=INTEGER32 | INTEGER24 | INTEGER40..=INTEGER64)
}

/// Converts at most eight bytes to a number, with sign extension.
pub(super) const fn number(data_type: u8, mut bytes: &[u8]) -> u64 {
    let mut number = match bytes {
        [.., last] if *last >= 0x80 && is_signed(data_type) => u64::MAX,
        _ => 0,
    };
    while let [rest @ .., last] = bytes {
        number = number << 8 | *last as u64;
        bytes = rest;
    }
    number
}

/// Converts a value to a number with the same order; `None` for NaN.
fn order(data_type: u8, number: u64) -> Option<u64> {
    const SIGN: u64 = 1 << 63;
    let (real, infinity) = match data_type {
        REAL32 => (number << 32, 0x7F80_0000 << 32),
        REAL64 => (number, 0x7FF0_0000_0000_0000),
        _ if is_signed(data_type) => return Some(number ^ SIGN),
        _ => return Some(number),
    };
    let magnitude = real & !SIGN;
    if magnitude > infinity {
        return None;
    }
    Some(if real & SIGN == 0 { SIGN + magnitude } else { SIGN - magnitude })
}

/// Access: read-only for SDOs; the application sets the value.
#[derive(Clone, Copy, Debug)]
pub enum Ro {}
/// Access: write-only for SDOs.
#[derive(Clone, Copy, Debug)]
pub enum Wo {}
/// Access: readable and writable.
#[derive(Clone, Copy, Debug)]
pub enum Rw {}
/// Access: a constant in flash.
#[derive(Clone, Copy, Debug)]
pub enum Const {}
/// Access: a constant in flash to which the node-ID is added.
#[derive(Clone, Copy, Debug)]
pub enum NodeConst {}
/// Access: the application transfers the data, for which the table has no room.
#[derive(Clone, Copy, Debug)]
pub enum Elsewhere {}

/// Access of entries with a value in RAM: those that an application can set.
pub trait Variable {}

impl Variable for Ro {}
impl Variable for Wo {}
impl Variable for Rw {}

/// An entry with its type and access: `data.get(od::SPEED)`.
pub struct Handle<D: 'static, T: ?Sized, A> {
    entry: &'static Entry<D>,
    // of the entry, so that the address of a value is a constant
    ram: u32,
    size: u16,
    kind: core::marker::PhantomData<fn(A) -> *const T>,
}

impl<D: Table, T: ?Sized, A> Handle<D, T, A> {
    /// The handle of an entry.
    ///
    /// # Panics
    /// If there is no such entry; in a constant this is an error of the compiler.
    #[must_use]
    pub const fn of(index: u16, sub: u8) -> Self {
        match Entry::find(index, sub) {
            Ok(entry) => Self::new(entry),
            Err(_) => panic!("no such entry"),
        }
    }

    const fn new(entry: &'static Entry<D>) -> Self {
        let (ram, size) = (entry.ram() as u32, entry.size() as u16);
        Self { entry, ram, size, kind: core::marker::PhantomData }
    }

    /// The row in the table, with access, PDO mapping and data type.
    #[must_use]
    pub const fn entry(self) -> &'static Entry<D> {
        self.entry
    }

    /// The index.
    #[must_use]
    pub const fn index(self) -> u16 {
        self.entry.index()
    }

    /// The sub-index.
    #[must_use]
    pub const fn sub(self) -> u8 {
        self.entry.sub()
    }

    /// Maximum size of a value in an SDO transfer, in bytes.
    #[must_use]
    pub const fn size(self) -> usize {
        self.size as usize
    }

    /// The offset of the value; 0 for a value in flash.
    pub(super) const fn ram(self) -> usize {
        self.ram as usize
    }
}

impl<D, T: ?Sized, A> Clone for Handle<D, T, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, T: ?Sized, A> Copy for Handle<D, T, A> {}

impl<D: Table, T: ?Sized, A> core::fmt::Debug for Handle<D, T, A> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Handle({:04X}h:{:02X})", self.index(), self.sub())
    }
}

macro_rules! defaults {
    ($($number:ty, $bits:ident => $value:expr;)*) => {
        $(impl<D: Table, A> Handle<D, $number, A> {
            /// The default for a node.
            #[must_use]
            pub const fn default(self, node_id: u8) -> $number {
                let $bits = self.entry.default_number(node_id);
                $value
            }
        }

        impl<D: Table> Handle<D, $number, Const> {
            /// The value.
            #[must_use]
            pub const fn value(self) -> $number {
                self.default(0)
            }
        })*
    };
}

defaults! {
    bool, bits => bits != 0;
    i8, bits => bits as i8;
    i16, bits => bits as i16;
    i32, bits => bits as i32;
    i64, bits => bits as i64;
    u8, bits => bits as u8;
    u16, bits => bits as u16;
    u32, bits => bits as u32;
    u64, bits => bits;
    f32, bits => f32::from_bits(bits as u32);
    f64, bits => f64::from_bits(bits);
    Time, bits => Time::from_number(bits);
}

macro_rules! limits {
    ($($number:ty, $bits:ident => $value:expr;)*) => {
        $(impl<D: Table, A> Handle<D, $number, A> {
            /// The low limit for a node.
            #[must_use]
            pub const fn low(self, node_id: u8) -> Option<$number> {
                match self.entry.low_limit(node_id) {
                    Some($bits) => Some($value),
                    None => None,
                }
            }

            /// The high limit for a node.
            #[must_use]
            pub const fn high(self, node_id: u8) -> Option<$number> {
                match self.entry.high_limit(node_id) {
                    Some($bits) => Some($value),
                    None => None,
                }
            }
        })*
    };
}

limits! {
    i8, bits => bits as i8;
    i16, bits => bits as i16;
    i32, bits => bits as i32;
    i64, bits => bits as i64;
    u8, bits => bits as u8;
    u16, bits => bits as u16;
    u32, bits => bits as u32;
    u64, bits => bits;
    f32, bits => f32::from_bits(bits as u32);
    f64, bits => f64::from_bits(bits);
}

impl<D: Table, A> Handle<D, [u8], A> {
    /// The default.
    #[must_use]
    pub const fn default(self) -> &'static [u8] {
        self.entry.default_bytes()
    }
}

impl<D: Table> Handle<D, [u8], Const> {
    /// The value.
    #[must_use]
    pub const fn value(self) -> &'static [u8] {
        self.default()
    }
}

/// The elements of an ARRAY: sub-index 1 and up, all alike.
pub struct Array<D: 'static, T: ?Sized, A> {
    elements: &'static [Entry<D>],
    kind: core::marker::PhantomData<fn(A) -> *const T>,
}

impl<D: Table, T: ?Sized, A> Array<D, T, A> {
    /// The handle of an array with this number of elements.
    ///
    /// # Panics
    /// If there is no such array; in a constant this is an error of the compiler.
    #[must_use]
    pub const fn of(index: u16, length: u8) -> Self {
        let mut entries = D::ENTRIES;
        while let [entry, rest @ ..] = entries {
            if entry.index() == index && entry.sub() == 1 {
                break;
            }
            entries = rest;
        }
        let elements = entries.split_at(length as usize).0;
        Self { elements, kind: core::marker::PhantomData }
    }

    /// The number of elements, which is the highest sub-index.
    #[must_use]
    pub const fn len(self) -> usize {
        self.elements.len()
    }

    /// Whether there are none, which the generator excludes.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.elements.is_empty()
    }

    /// The element with this sub-index, counted from 1.
    ///
    /// # Panics
    /// If there is none, see [`Self::get`].
    #[must_use]
    #[track_caller]
    pub const fn at(self, sub: u8) -> Handle<D, T, A> {
        match self.get(sub) {
            Some(element) => element,
            None => panic!("no such sub-index"),
        }
    }

    /// The element with this sub-index, counted from 1; `None` if there is none.
    #[must_use]
    pub const fn get(self, sub: u8) -> Option<Handle<D, T, A>> {
        let Some(number) = (sub as usize).checked_sub(1) else { return None };
        match self.elements.split_at_checked(number) {
            Some((_, [entry, ..])) => Some(Handle::new(entry)),
            _ => None,
        }
    }

    /// All elements.
    pub fn iter(self) -> impl Iterator<Item = Handle<D, T, A>> {
        self.elements.iter().map(Handle::new)
    }
}

impl<D, T: ?Sized, A> Clone for Array<D, T, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, T: ?Sized, A> Copy for Array<D, T, A> {}

impl<D: Table, T: ?Sized, A> core::fmt::Debug for Array<D, T, A> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// The type of an entry in the program: `u16`, `bool`, [`Time`], `[u8]` for a text, octet string or DOMAIN, `[u8; N]`
/// for a type that the device defines.
pub trait Typed {
    /// A value.
    type Value<'a>: Copy;

    /// Whether the current length of a value is in front of it.
    const HAS_LENGTH: bool = false;

    /// The value of these bytes, as transferred by an SDO. Numbers take the lowest bytes and extend what is shorter.
    fn load(bytes: &[u8]) -> Self::Value<'_>;

    /// The value of an entry in flash.
    fn load_constant<'a, D: Table>(entry: &'a Entry<D>, node_id: u8) -> Self::Value<'a>;

    /// Passes on the bytes of a value, of a number the lowest `size`.
    fn with_bytes<R>(value: Self::Value<'_>, size: usize, then: impl FnOnce(&[u8]) -> R) -> R;

    /// Whether the lowest `size` bytes hold the value: an UNSIGNED24 is shorter than its `u32`.
    #[must_use]
    fn fits(value: Self::Value<'_>, size: usize) -> bool {
        let _ = (value, size);
        true
    }
}

macro_rules! numbers {
    ($($longest:ident: $($number:ty)*;)*) => {
        $($(impl Typed for $number {
            type Value<'a> = Self;

            fn load(bytes: &[u8]) -> Self {
                let extended = || number($longest, bytes) as Self;
                bytes.first_chunk().map_or_else(extended, |bytes| Self::from_le_bytes(*bytes))
            }

            fn load_constant<D: Table>(entry: &Entry<D>, node_id: u8) -> Self {
                Self::load(&entry.default_number(node_id).to_le_bytes())
            }

            fn with_bytes<R>(value: Self, size: usize, then: impl FnOnce(&[u8]) -> R) -> R {
                let bytes = value.to_le_bytes();
                then(bytes.get(..size).unwrap_or(&bytes))
            }

            fn fits(value: Self, size: usize) -> bool {
                Self::with_bytes(value, size, |bytes| Self::load(bytes).to_le_bytes() == value.to_le_bytes())
            }
        })*)*
    };
}

numbers! {
    INTEGER64: i8 i16 i32 i64;
    UNSIGNED64: u8 u16 u32 u64 f32 f64;
}

impl Typed for bool {
    type Value<'a> = Self;

    fn load(bytes: &[u8]) -> Self {
        bytes.first().is_some_and(|&byte| byte != 0)
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> Self {
        Self::load(entry.default_bytes())
    }

    fn with_bytes<R>(value: Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        then(&[u8::from(value)])
    }
}

/// A time of day since 1984-01-01, or a time difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Time {
    /// Milliseconds after midnight, 28 bits.
    pub milliseconds: u32,
    /// Days.
    pub days: u16,
}

impl Time {
    /// The used bits of the byte with the highest bits of the milliseconds.
    pub(super) const USED: u8 = 0x0F;

    /// The time of six bytes.
    pub(super) const fn from_number(number: u64) -> Self {
        Self { milliseconds: number as u32 & 0x0FFF_FFFF, days: (number >> 32) as u16 }
    }
}

impl Typed for Time {
    type Value<'a> = Self;

    fn load(bytes: &[u8]) -> Self {
        Self::from_number(number(UNSIGNED64, bytes))
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> Self {
        Self::load(entry.default_bytes())
    }

    fn with_bytes<R>(value: Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        let [a, b, c, d] = value.milliseconds.to_le_bytes();
        let [e, f] = value.days.to_le_bytes();
        then(&[a, b, c, d & Self::USED, e, f])
    }
}

impl Typed for [u8] {
    type Value<'a> = &'a Self;

    const HAS_LENGTH: bool = true;

    fn load(bytes: &[u8]) -> &[u8] {
        bytes
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> &Self {
        entry.default_bytes()
    }

    fn with_bytes<R>(value: &Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        then(value)
    }
}

impl<const N: usize> Typed for [u8; N] {
    type Value<'a> = Self;

    fn load(bytes: &[u8]) -> Self {
        bytes.first_chunk().copied().unwrap_or([0; N])
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> Self {
        Self::load(entry.default_bytes())
    }

    fn with_bytes<R>(value: Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        then(&value)
    }
}

/// The values that can change; constants are in flash.
///
/// They are in one array of bytes as an SDO transfers them, a text behind its length. The first byte is the node-ID.
#[derive(Clone, Debug, PartialEq)]
pub struct Data<D, const RAM: usize> {
    pub(super) bytes: [u8; RAM],
    table: core::marker::PhantomData<fn() -> D>,
}

impl<D: Table, const RAM: usize> Data<D, RAM> {
    /// The defaults for `node_id`, 1 to 127; only the lower seven bits are used.
    #[must_use]
    pub const fn new(node_id: u8) -> Self {
        let mut data = Self { bytes: [0; RAM], table: core::marker::PhantomData };
        copy(&mut data.bytes, &[node_id & 0x7F]);
        let mut entries = D::ENTRIES;
        while let [entry, rest @ ..] = entries {
            data.set_default(entry);
            entries = rest;
        }
        data
    }

    /// The node-ID of the values.
    #[must_use]
    pub const fn node_id(&self) -> u8 {
        let bytes: &[u8] = &self.bytes;
        if let [node_id, ..] = bytes { *node_id } else { 0 }
    }

    /// The value of an entry.
    #[must_use]
    #[inline]
    pub fn get<T: Typed + ?Sized, A>(&self, handle: Handle<D, T, A>) -> T::Value<'_> {
        match self.value_at(handle.ram(), handle.size(), T::HAS_LENGTH) {
            Some(bytes) => T::load(bytes),
            None => T::load_constant(handle.entry(), self.node_id()),
        }
    }

    /// Sets a value that the limits allow, as an SDO would; access does not matter.
    ///
    /// # Errors
    /// Why the value is not valid; it is unchanged.
    #[inline]
    pub fn set<T: Typed + ?Sized, A: Variable>(
        &mut self,
        handle: Handle<D, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        if !T::fits(value, handle.size()) {
            return Err(Abort::InvalidValue);
        }
        T::with_bytes(value, handle.size(), |bytes| self.write_entry(handle.entry(), bytes))
    }

    /// Sets a value without a look at its limits. Of a longer text the end is cut off.
    #[inline]
    pub fn put<T: Typed + ?Sized, A: Variable>(&mut self, handle: Handle<D, T, A>, value: T::Value<'_>) {
        T::with_bytes(value, handle.size(), |bytes| {
            self.keep_at(handle.ram(), handle.size(), T::HAS_LENGTH, bytes);
        });
    }

    /// Reads a value into `buffer`, as transferred by an SDO upload; returns the number of bytes.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read(&self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let entry = Entry::find(index, sub)?;
        if entry.is_readable() { self.read_entry(entry, buffer) } else { Err(Abort::WriteOnly) }
    }

    /// The same for an entry that is at hand, without a look at its access.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read_entry(&self, entry: &Entry<D>, buffer: &mut [u8]) -> Result<usize, Abort> {
        let number;
        let bytes = match self.value(entry) {
            Some(bytes) => bytes,
            None if entry.adds_node_id() => {
                number = entry.default_number(self.node_id()).to_le_bytes();
                part(&number, 0, entry.size())
            }
            None if entry.is_elsewhere() => return Err(Abort::NoData),
            None => entry.default_bytes(),
        };
        let room = buffer.get_mut(..bytes.len()).ok_or(Abort::OutOfMemory)?;
        room.copy_from_slice(bytes);
        Ok(bytes.len())
    }

    /// Writes a value transferred by an SDO download if the dictionary allows it.
    ///
    /// # Errors
    /// The code to abort the download with; the value is unchanged.
    pub fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let entry = Entry::find(index, sub)?;
        if entry.is_writable() { self.write_entry(entry, bytes) } else { Err(Abort::ReadOnly) }
    }

    /// The same for an entry that is at hand, without a look at its access.
    ///
    /// # Errors
    /// The code to abort the download with; the value is unchanged.
    pub fn write_entry(&mut self, entry: &Entry<D>, bytes: &[u8]) -> Result<(), Abort> {
        if entry.ram() == 0 {
            return Err(Abort::CannotStore);
        }
        entry.check(bytes, self.node_id())?;
        self.keep(entry, bytes);
        Ok(())
    }

    /// The bytes of a value in RAM; `None` for a value in flash.
    pub(super) fn value(&self, entry: &Entry<D>) -> Option<&[u8]> {
        self.value_at(entry.ram(), entry.size(), entry.has_length())
    }

    #[inline]
    fn value_at(&self, ram: usize, size: usize, has_length: bool) -> Option<&[u8]> {
        if ram == 0 {
            return None;
        }
        let place = self.bytes.get(ram..)?;
        if has_length {
            let (length, text) = place.split_first_chunk()?;
            text.get(..usize::from(u16::from_le_bytes(*length)))
        } else {
            place.get(..size)
        }
    }

    /// Stores a value that has been checked.
    pub(super) fn keep(&mut self, entry: &Entry<D>, bytes: &[u8]) {
        self.keep_at(entry.ram(), entry.size(), entry.has_length(), bytes);
        self.clear_void_bits(entry);
    }

    pub(super) fn clear_void_bits(&mut self, entry: &Entry<D>) {
        if let Some(byte) = self.bytes.get_mut(entry.ram() + 3).filter(|_| entry.is_time()) {
            *byte &= Time::USED;
        }
    }

    /// Stores what has room; what is left of the room of a text is cleared.
    #[inline]
    fn keep_at(&mut self, ram: usize, size: usize, has_length: bool, bytes: &[u8]) {
        let Some(place) = self.bytes.get_mut(ram..).filter(|_| ram > 0) else { return };
        if !has_length {
            if let (Some(place), Some(bytes)) = (place.get_mut(..size), bytes.get(..size)) {
                place.copy_from_slice(bytes);
            }
            return;
        }
        let kept = bytes.get(..size).unwrap_or(bytes);
        let Some((length, text)) = place.split_first_chunk_mut() else { return };
        *length = (kept.len() as u16).to_le_bytes();
        if let Some(text) = text.get_mut(..size) {
            text.fill(0);
            copy(text, kept);
        }
    }

    /// Sets an entry in RAM to its default.
    pub(super) const fn set_default(&mut self, entry: &Entry<D>) {
        let node_id = self.node_id();
        let bytes: &mut [u8] = &mut self.bytes;
        let place = match bytes.split_at_mut_checked(entry.ram()) {
            Some((before, place)) if !before.is_empty() => place,
            _ => return,
        };
        if entry.adds_node_id() {
            let number = entry.default_number(node_id).to_le_bytes();
            copy(place, part(&number, 0, entry.size()));
        } else {
            copy(place, entry.initial_bytes());
        }
    }
}

/// The node-ID that the table is generated for.
pub trait Configured: Table {
    /// The node-ID.
    const NODE_ID: u8;
}

impl<D: Configured, const RAM: usize> Default for Data<D, RAM> {
    /// The defaults for the configured node-ID.
    fn default() -> Self {
        Self::new(D::NODE_ID)
    }
}

/// Copies as many bytes as both have.
const fn copy(mut to: &mut [u8], mut from: &[u8]) {
    while let ([place, room @ ..], [byte, rest @ ..]) = (to, from) {
        *place = *byte;
        to = room;
        from = rest;
    }
}

}
