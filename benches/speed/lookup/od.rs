// Made by objdict 0.1.0; do not edit.
//
// Object dictionary of (no name) by (no name).
//
// `Data` contains the variable values: `get` and `set` take the constants of this file, `read` and
// `write` index and sub-index, as an SDO does. The file depends on `objdict-device` and needs no standard
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
pub use table::{Abort, Change, Const, Elsewhere, Hooks, NodeConst, Ro, Rw, Time, Wo};

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

/// The default mapping of PDOs: one struct per PDO with its fields in frame order.
#[allow(dead_code, unreachable_pub, unused_imports)]
#[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)]
#[allow(clippy::derive_partial_eq_without_eq)]
pub mod pdo {
    use super::table::{first, pack, unpack};
    use super::Data;
}

/// All entries in ascending order of index and sub-index.
#[allow(dead_code, unreachable_pub, clippy::wildcard_imports)]
#[rustfmt::skip]
pub static ENTRIES: [Entry; 157] = {
    use table::*;
    [
        Entry::new(0x2000, 0x00, UNSIGNED32, READ | WRITE, 1, 1), // `Parameter 0`
        Entry::new(0x2007, 0x00, UNSIGNED32, READ | WRITE, 5, 189), // `Parameter 1`
        Entry::new(0x200E, 0x00, UNSIGNED32, READ | WRITE, 9, 185), // `Parameter 2`
        Entry::new(0x2015, 0x00, UNSIGNED32, READ | WRITE, 13, 181), // `Parameter 3`
        Entry::new(0x201C, 0x00, UNSIGNED32, READ | WRITE, 17, 177), // `Parameter 4`
        Entry::new(0x2023, 0x00, UNSIGNED32, READ | WRITE, 21, 173), // `Parameter 5`
        Entry::new(0x202A, 0x00, UNSIGNED32, READ | WRITE, 25, 169), // `Parameter 6`
        Entry::new(0x2031, 0x00, UNSIGNED32, READ | WRITE, 29, 165), // `Parameter 7`
        Entry::new(0x2038, 0x00, UNSIGNED32, READ | WRITE, 33, 161), // `Parameter 8`
        Entry::new(0x203F, 0x00, UNSIGNED32, READ | WRITE, 37, 157), // `Parameter 9`
        Entry::new(0x2046, 0x00, UNSIGNED32, READ | WRITE, 41, 153), // `Parameter 10`
        Entry::new(0x204D, 0x00, UNSIGNED32, READ | WRITE, 45, 149), // `Parameter 11`
        Entry::new(0x2054, 0x00, UNSIGNED32, READ | WRITE, 49, 145), // `Parameter 12`
        Entry::new(0x205B, 0x00, UNSIGNED32, READ | WRITE, 53, 141), // `Parameter 13`
        Entry::new(0x2062, 0x00, UNSIGNED32, READ | WRITE, 57, 137), // `Parameter 14`
        Entry::new(0x2069, 0x00, UNSIGNED32, READ | WRITE, 61, 133), // `Parameter 15`
        Entry::new(0x2070, 0x00, UNSIGNED32, READ | WRITE, 65, 129), // `Parameter 16`
        Entry::new(0x2077, 0x00, UNSIGNED32, READ | WRITE, 69, 125), // `Parameter 17`
        Entry::new(0x207E, 0x00, UNSIGNED32, READ | WRITE, 73, 121), // `Parameter 18`
        Entry::new(0x2085, 0x00, UNSIGNED32, READ | WRITE, 77, 117), // `Parameter 19`
        Entry::new(0x208C, 0x00, UNSIGNED32, READ | WRITE, 81, 113), // `Parameter 20`
        Entry::new(0x2093, 0x00, UNSIGNED32, READ | WRITE, 85, 109), // `Parameter 21`
        Entry::new(0x209A, 0x00, UNSIGNED32, READ | WRITE, 89, 105), // `Parameter 22`
        Entry::new(0x20A1, 0x00, UNSIGNED32, READ | WRITE, 93, 101), // `Parameter 23`
        Entry::new(0x20A8, 0x00, UNSIGNED32, READ | WRITE, 97, 97), // `Parameter 24`
        Entry::new(0x20AF, 0x00, UNSIGNED32, READ | WRITE, 101, 93), // `Parameter 25`
        Entry::new(0x20B6, 0x00, UNSIGNED32, READ | WRITE, 105, 89), // `Parameter 26`
        Entry::new(0x20BD, 0x00, UNSIGNED32, READ | WRITE, 109, 85), // `Parameter 27`
        Entry::new(0x20C4, 0x00, UNSIGNED32, READ | WRITE, 113, 81), // `Parameter 28`
        Entry::new(0x20CB, 0x00, UNSIGNED32, READ | WRITE, 117, 77), // `Parameter 29`
        Entry::new(0x20D2, 0x00, UNSIGNED32, READ | WRITE, 121, 73), // `Parameter 30`
        Entry::new(0x20D9, 0x00, UNSIGNED32, READ | WRITE, 125, 69), // `Parameter 31`
        Entry::new(0x20E0, 0x00, UNSIGNED32, READ | WRITE, 129, 65), // `Parameter 32`
        Entry::new(0x20E7, 0x00, UNSIGNED32, READ | WRITE, 133, 61), // `Parameter 33`
        Entry::new(0x20EE, 0x00, UNSIGNED32, READ | WRITE, 137, 57), // `Parameter 34`
        Entry::new(0x20F5, 0x00, UNSIGNED32, READ | WRITE, 141, 53), // `Parameter 35`
        Entry::new(0x20FC, 0x00, UNSIGNED32, READ | WRITE, 145, 49), // `Parameter 36`
        Entry::new(0x2103, 0x00, UNSIGNED32, READ | WRITE, 149, 45), // `Parameter 37`
        Entry::new(0x210A, 0x00, UNSIGNED32, READ | WRITE, 153, 41), // `Parameter 38`
        Entry::new(0x2111, 0x00, UNSIGNED32, READ | WRITE, 157, 37), // `Parameter 39`
        Entry::new(0x2118, 0x00, UNSIGNED32, READ | WRITE, 161, 33), // `Parameter 40`
        Entry::new(0x211F, 0x00, UNSIGNED32, READ | WRITE, 165, 29), // `Parameter 41`
        Entry::new(0x2126, 0x00, UNSIGNED32, READ | WRITE, 169, 25), // `Parameter 42`
        Entry::new(0x212D, 0x00, UNSIGNED32, READ | WRITE, 173, 21), // `Parameter 43`
        Entry::new(0x2134, 0x00, UNSIGNED32, READ | WRITE, 177, 17), // `Parameter 44`
        Entry::new(0x213B, 0x00, UNSIGNED32, READ | WRITE, 181, 13), // `Parameter 45`
        Entry::new(0x2142, 0x00, UNSIGNED32, READ | WRITE, 185, 9), // `Parameter 46`
        Entry::new(0x2149, 0x00, UNSIGNED32, READ | WRITE, 189, 5), // `Parameter 47`
        Entry::new(0x2150, 0x00, UNSIGNED32, READ | WRITE, 193, 0), // `Parameter 48`
        Entry::new(0x6000, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6000, 0x01, UNSIGNED32, READ | WRITE, 197, 189), // `Gain 1`
        Entry::new(0x6000, 0x02, UNSIGNED32, READ | WRITE, 201, 185), // `Gain 2`
        Entry::new(0x6000, 0x03, UNSIGNED32, READ | WRITE, 205, 181), // `Gain 3`
        Entry::new(0x6010, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6010, 0x01, UNSIGNED32, READ | WRITE, 209, 189), // `Gain 1`
        Entry::new(0x6010, 0x02, UNSIGNED32, READ | WRITE, 213, 185), // `Gain 2`
        Entry::new(0x6010, 0x03, UNSIGNED32, READ | WRITE, 217, 181), // `Gain 3`
        Entry::new(0x6020, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6020, 0x01, UNSIGNED32, READ | WRITE, 221, 189), // `Gain 1`
        Entry::new(0x6020, 0x02, UNSIGNED32, READ | WRITE, 225, 185), // `Gain 2`
        Entry::new(0x6020, 0x03, UNSIGNED32, READ | WRITE, 229, 181), // `Gain 3`
        Entry::new(0x6030, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6030, 0x01, UNSIGNED32, READ | WRITE, 233, 189), // `Gain 1`
        Entry::new(0x6030, 0x02, UNSIGNED32, READ | WRITE, 237, 185), // `Gain 2`
        Entry::new(0x6030, 0x03, UNSIGNED32, READ | WRITE, 241, 181), // `Gain 3`
        Entry::new(0x6040, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6040, 0x01, UNSIGNED32, READ | WRITE, 245, 189), // `Gain 1`
        Entry::new(0x6040, 0x02, UNSIGNED32, READ | WRITE, 249, 185), // `Gain 2`
        Entry::new(0x6040, 0x03, UNSIGNED32, READ | WRITE, 253, 181), // `Gain 3`
        Entry::new(0x6050, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6050, 0x01, UNSIGNED32, READ | WRITE, 257, 189), // `Gain 1`
        Entry::new(0x6050, 0x02, UNSIGNED32, READ | WRITE, 261, 185), // `Gain 2`
        Entry::new(0x6050, 0x03, UNSIGNED32, READ | WRITE, 265, 181), // `Gain 3`
        Entry::new(0x6060, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6060, 0x01, UNSIGNED32, READ | WRITE, 269, 189), // `Gain 1`
        Entry::new(0x6060, 0x02, UNSIGNED32, READ | WRITE, 273, 185), // `Gain 2`
        Entry::new(0x6060, 0x03, UNSIGNED32, READ | WRITE, 277, 181), // `Gain 3`
        Entry::new(0x6070, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6070, 0x01, UNSIGNED32, READ | WRITE, 281, 189), // `Gain 1`
        Entry::new(0x6070, 0x02, UNSIGNED32, READ | WRITE, 285, 185), // `Gain 2`
        Entry::new(0x6070, 0x03, UNSIGNED32, READ | WRITE, 289, 181), // `Gain 3`
        Entry::new(0x6080, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6080, 0x01, UNSIGNED32, READ | WRITE, 293, 189), // `Gain 1`
        Entry::new(0x6080, 0x02, UNSIGNED32, READ | WRITE, 297, 185), // `Gain 2`
        Entry::new(0x6080, 0x03, UNSIGNED32, READ | WRITE, 301, 181), // `Gain 3`
        Entry::new(0x6090, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6090, 0x01, UNSIGNED32, READ | WRITE, 305, 189), // `Gain 1`
        Entry::new(0x6090, 0x02, UNSIGNED32, READ | WRITE, 309, 185), // `Gain 2`
        Entry::new(0x6090, 0x03, UNSIGNED32, READ | WRITE, 313, 181), // `Gain 3`
        Entry::new(0x60A0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x60A0, 0x01, UNSIGNED32, READ | WRITE, 317, 189), // `Gain 1`
        Entry::new(0x60A0, 0x02, UNSIGNED32, READ | WRITE, 321, 185), // `Gain 2`
        Entry::new(0x60A0, 0x03, UNSIGNED32, READ | WRITE, 325, 181), // `Gain 3`
        Entry::new(0x60B0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x60B0, 0x01, UNSIGNED32, READ | WRITE, 329, 189), // `Gain 1`
        Entry::new(0x60B0, 0x02, UNSIGNED32, READ | WRITE, 333, 185), // `Gain 2`
        Entry::new(0x60B0, 0x03, UNSIGNED32, READ | WRITE, 337, 181), // `Gain 3`
        Entry::new(0x60C0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x60C0, 0x01, UNSIGNED32, READ | WRITE, 341, 189), // `Gain 1`
        Entry::new(0x60C0, 0x02, UNSIGNED32, READ | WRITE, 345, 185), // `Gain 2`
        Entry::new(0x60C0, 0x03, UNSIGNED32, READ | WRITE, 349, 181), // `Gain 3`
        Entry::new(0x60D0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x60D0, 0x01, UNSIGNED32, READ | WRITE, 353, 189), // `Gain 1`
        Entry::new(0x60D0, 0x02, UNSIGNED32, READ | WRITE, 357, 185), // `Gain 2`
        Entry::new(0x60D0, 0x03, UNSIGNED32, READ | WRITE, 361, 181), // `Gain 3`
        Entry::new(0x60E0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x60E0, 0x01, UNSIGNED32, READ | WRITE, 365, 189), // `Gain 1`
        Entry::new(0x60E0, 0x02, UNSIGNED32, READ | WRITE, 369, 185), // `Gain 2`
        Entry::new(0x60E0, 0x03, UNSIGNED32, READ | WRITE, 373, 181), // `Gain 3`
        Entry::new(0x60F0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x60F0, 0x01, UNSIGNED32, READ | WRITE, 377, 189), // `Gain 1`
        Entry::new(0x60F0, 0x02, UNSIGNED32, READ | WRITE, 381, 185), // `Gain 2`
        Entry::new(0x60F0, 0x03, UNSIGNED32, READ | WRITE, 385, 181), // `Gain 3`
        Entry::new(0x6100, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6100, 0x01, UNSIGNED32, READ | WRITE, 389, 189), // `Gain 1`
        Entry::new(0x6100, 0x02, UNSIGNED32, READ | WRITE, 393, 185), // `Gain 2`
        Entry::new(0x6100, 0x03, UNSIGNED32, READ | WRITE, 397, 181), // `Gain 3`
        Entry::new(0x6110, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6110, 0x01, UNSIGNED32, READ | WRITE, 401, 189), // `Gain 1`
        Entry::new(0x6110, 0x02, UNSIGNED32, READ | WRITE, 405, 185), // `Gain 2`
        Entry::new(0x6110, 0x03, UNSIGNED32, READ | WRITE, 409, 181), // `Gain 3`
        Entry::new(0x6120, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6120, 0x01, UNSIGNED32, READ | WRITE, 413, 189), // `Gain 1`
        Entry::new(0x6120, 0x02, UNSIGNED32, READ | WRITE, 417, 185), // `Gain 2`
        Entry::new(0x6120, 0x03, UNSIGNED32, READ | WRITE, 421, 181), // `Gain 3`
        Entry::new(0x6130, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6130, 0x01, UNSIGNED32, READ | WRITE, 425, 189), // `Gain 1`
        Entry::new(0x6130, 0x02, UNSIGNED32, READ | WRITE, 429, 185), // `Gain 2`
        Entry::new(0x6130, 0x03, UNSIGNED32, READ | WRITE, 433, 181), // `Gain 3`
        Entry::new(0x6140, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6140, 0x01, UNSIGNED32, READ | WRITE, 437, 189), // `Gain 1`
        Entry::new(0x6140, 0x02, UNSIGNED32, READ | WRITE, 441, 185), // `Gain 2`
        Entry::new(0x6140, 0x03, UNSIGNED32, READ | WRITE, 445, 181), // `Gain 3`
        Entry::new(0x6150, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6150, 0x01, UNSIGNED32, READ | WRITE, 449, 189), // `Gain 1`
        Entry::new(0x6150, 0x02, UNSIGNED32, READ | WRITE, 453, 185), // `Gain 2`
        Entry::new(0x6150, 0x03, UNSIGNED32, READ | WRITE, 457, 181), // `Gain 3`
        Entry::new(0x6160, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6160, 0x01, UNSIGNED32, READ | WRITE, 461, 189), // `Gain 1`
        Entry::new(0x6160, 0x02, UNSIGNED32, READ | WRITE, 465, 185), // `Gain 2`
        Entry::new(0x6160, 0x03, UNSIGNED32, READ | WRITE, 469, 181), // `Gain 3`
        Entry::new(0x6170, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6170, 0x01, UNSIGNED32, READ | WRITE, 473, 189), // `Gain 1`
        Entry::new(0x6170, 0x02, UNSIGNED32, READ | WRITE, 477, 185), // `Gain 2`
        Entry::new(0x6170, 0x03, UNSIGNED32, READ | WRITE, 481, 181), // `Gain 3`
        Entry::new(0x6180, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6180, 0x01, UNSIGNED32, READ | WRITE, 485, 189), // `Gain 1`
        Entry::new(0x6180, 0x02, UNSIGNED32, READ | WRITE, 489, 185), // `Gain 2`
        Entry::new(0x6180, 0x03, UNSIGNED32, READ | WRITE, 493, 181), // `Gain 3`
        Entry::new(0x6190, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x6190, 0x01, UNSIGNED32, READ | WRITE, 497, 189), // `Gain 1`
        Entry::new(0x6190, 0x02, UNSIGNED32, READ | WRITE, 501, 185), // `Gain 2`
        Entry::new(0x6190, 0x03, UNSIGNED32, READ | WRITE, 505, 181), // `Gain 3`
        Entry::new(0x61A0, 0x00, UNSIGNED8, READ, 0, 181), // `Highest sub-index supported`
        Entry::new(0x61A0, 0x01, UNSIGNED32, READ | WRITE, 509, 189), // `Gain 1`
        Entry::new(0x61A0, 0x02, UNSIGNED32, READ | WRITE, 513, 185), // `Gain 2`
        Entry::new(0x61A0, 0x03, UNSIGNED32, READ | WRITE, 517, 181), // `Gain 3`
    ]
};

impl table::Table for Od {
    const ENTRIES: &'static [Entry] = &ENTRIES;

    #[rustfmt::skip]
    const ROM: &'static [u8] = {
        static ROM: [u8; 193] = [
            0x30, 0x00, 0x00, 0x00, 0x00, 0x2F, 0x00, 0x00, 0x00, 0x2E, 0x00, 0x00, 0x00, 0x2D, 0x00, 0x00,
            0x00, 0x2C, 0x00, 0x00, 0x00, 0x2B, 0x00, 0x00, 0x00, 0x2A, 0x00, 0x00, 0x00, 0x29, 0x00, 0x00,
            0x00, 0x28, 0x00, 0x00, 0x00, 0x27, 0x00, 0x00, 0x00, 0x26, 0x00, 0x00, 0x00, 0x25, 0x00, 0x00,
            0x00, 0x24, 0x00, 0x00, 0x00, 0x23, 0x00, 0x00, 0x00, 0x22, 0x00, 0x00, 0x00, 0x21, 0x00, 0x00,
            0x00, 0x20, 0x00, 0x00, 0x00, 0x1F, 0x00, 0x00, 0x00, 0x1E, 0x00, 0x00, 0x00, 0x1D, 0x00, 0x00,
            0x00, 0x1C, 0x00, 0x00, 0x00, 0x1B, 0x00, 0x00, 0x00, 0x1A, 0x00, 0x00, 0x00, 0x19, 0x00, 0x00,
            0x00, 0x18, 0x00, 0x00, 0x00, 0x17, 0x00, 0x00, 0x00, 0x16, 0x00, 0x00, 0x00, 0x15, 0x00, 0x00,
            0x00, 0x14, 0x00, 0x00, 0x00, 0x13, 0x00, 0x00, 0x00, 0x12, 0x00, 0x00, 0x00, 0x11, 0x00, 0x00,
            0x00, 0x10, 0x00, 0x00, 0x00, 0x0F, 0x00, 0x00, 0x00, 0x0E, 0x00, 0x00, 0x00, 0x0D, 0x00, 0x00,
            0x00, 0x0C, 0x00, 0x00, 0x00, 0x0B, 0x00, 0x00, 0x00, 0x0A, 0x00, 0x00, 0x00, 0x09, 0x00, 0x00,
            0x00, 0x08, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00, 0x06, 0x00, 0x00, 0x00, 0x05, 0x00, 0x00,
            0x00, 0x04, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00,
            0x00,
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

impl table::Hooked for Od {
    type Room = [u8; 8];
    const ROOM: [u8; 8] = [0; 8];
}

/// The values with the hooks of the application.
#[allow(dead_code, unreachable_pub)]
pub type Watched<H> = objdict_device::Watched<Data, H, 20>;

/// A node with `CHANNELS` SDO servers for values of at most `BUFFER` bytes, and with the PDOs of this device.
#[allow(dead_code, unreachable_pub)]
pub type Node<const BUFFER: usize, const CHANNELS: usize, D = Data> =
    objdict_device::Node<D, BUFFER, CHANNELS, 0, 0, 0>;

/// The PDOs, for `Node::new`.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub const fn pdos() -> objdict_device::Pdos<0, 0> {
    objdict_device::Pdos::new([], [])
}

/// A node with the defaults, before its boot-up.
#[allow(dead_code, unreachable_pub)]
pub const fn node<const BUFFER: usize, const CHANNELS: usize>(node_id: u8) -> Node<BUFFER, CHANNELS> {
    Node::new(node_id, Data::new(node_id), pdos())
}

#[allow(unreachable_pub)]
pub use objdict_device::table;
