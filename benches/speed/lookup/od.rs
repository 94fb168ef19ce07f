// Made by objdict 0.1.0; do not edit.
//
// Object dictionary of (no name) by (no name).
//
// `Data` contains the variable values, `Data::read` and `Data::write` implement SDO access, and each
// object has a module with the sub-indexes of its entries. The file has no dependencies and needs no
// standard library; use it as a module or with `include!`. Products rarely use all of it, so dead
// code is allowed; `unreachable_pub` depends on where it is included.

/// `0x2000`: `Parameter 0`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_0 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2000;
}

/// `0x2007`: `Parameter 1`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_1 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2007;
}

/// `0x200E`: `Parameter 2`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_2 {
    /// Index of the object.
    pub const INDEX: u16 = 0x200E;
}

/// `0x2015`: `Parameter 3`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_3 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2015;
}

/// `0x201C`: `Parameter 4`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_4 {
    /// Index of the object.
    pub const INDEX: u16 = 0x201C;
}

/// `0x2023`: `Parameter 5`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_5 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2023;
}

/// `0x202A`: `Parameter 6`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_6 {
    /// Index of the object.
    pub const INDEX: u16 = 0x202A;
}

/// `0x2031`: `Parameter 7`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_7 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2031;
}

/// `0x2038`: `Parameter 8`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_8 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2038;
}

/// `0x203F`: `Parameter 9`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_9 {
    /// Index of the object.
    pub const INDEX: u16 = 0x203F;
}

/// `0x2046`: `Parameter 10`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_10 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2046;
}

/// `0x204D`: `Parameter 11`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_11 {
    /// Index of the object.
    pub const INDEX: u16 = 0x204D;
}

/// `0x2054`: `Parameter 12`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_12 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2054;
}

/// `0x205B`: `Parameter 13`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_13 {
    /// Index of the object.
    pub const INDEX: u16 = 0x205B;
}

/// `0x2062`: `Parameter 14`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_14 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2062;
}

/// `0x2069`: `Parameter 15`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_15 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2069;
}

/// `0x2070`: `Parameter 16`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_16 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2070;
}

/// `0x2077`: `Parameter 17`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_17 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2077;
}

/// `0x207E`: `Parameter 18`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_18 {
    /// Index of the object.
    pub const INDEX: u16 = 0x207E;
}

/// `0x2085`: `Parameter 19`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_19 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2085;
}

/// `0x208C`: `Parameter 20`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_20 {
    /// Index of the object.
    pub const INDEX: u16 = 0x208C;
}

/// `0x2093`: `Parameter 21`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_21 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2093;
}

/// `0x209A`: `Parameter 22`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_22 {
    /// Index of the object.
    pub const INDEX: u16 = 0x209A;
}

/// `0x20A1`: `Parameter 23`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_23 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20A1;
}

/// `0x20A8`: `Parameter 24`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_24 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20A8;
}

/// `0x20AF`: `Parameter 25`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_25 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20AF;
}

/// `0x20B6`: `Parameter 26`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_26 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20B6;
}

/// `0x20BD`: `Parameter 27`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_27 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20BD;
}

/// `0x20C4`: `Parameter 28`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_28 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20C4;
}

/// `0x20CB`: `Parameter 29`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_29 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20CB;
}

/// `0x20D2`: `Parameter 30`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_30 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20D2;
}

/// `0x20D9`: `Parameter 31`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_31 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20D9;
}

/// `0x20E0`: `Parameter 32`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_32 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20E0;
}

/// `0x20E7`: `Parameter 33`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_33 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20E7;
}

/// `0x20EE`: `Parameter 34`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_34 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20EE;
}

/// `0x20F5`: `Parameter 35`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_35 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20F5;
}

/// `0x20FC`: `Parameter 36`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_36 {
    /// Index of the object.
    pub const INDEX: u16 = 0x20FC;
}

/// `0x2103`: `Parameter 37`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_37 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2103;
}

/// `0x210A`: `Parameter 38`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_38 {
    /// Index of the object.
    pub const INDEX: u16 = 0x210A;
}

/// `0x2111`: `Parameter 39`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_39 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2111;
}

/// `0x2118`: `Parameter 40`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_40 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2118;
}

/// `0x211F`: `Parameter 41`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_41 {
    /// Index of the object.
    pub const INDEX: u16 = 0x211F;
}

/// `0x2126`: `Parameter 42`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_42 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2126;
}

/// `0x212D`: `Parameter 43`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_43 {
    /// Index of the object.
    pub const INDEX: u16 = 0x212D;
}

/// `0x2134`: `Parameter 44`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_44 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2134;
}

/// `0x213B`: `Parameter 45`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_45 {
    /// Index of the object.
    pub const INDEX: u16 = 0x213B;
}

/// `0x2142`: `Parameter 46`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_46 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2142;
}

/// `0x2149`: `Parameter 47`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_47 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2149;
}

/// `0x2150`: `Parameter 48`.
#[allow(dead_code, unreachable_pub)]
pub mod parameter_48 {
    /// Index of the object.
    pub const INDEX: u16 = 0x2150;
}

/// `0x6000`: `Axis 0`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_0 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6000;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6010`: `Axis 1`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_1 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6010;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6020`: `Axis 2`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_2 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6020;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6030`: `Axis 3`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_3 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6030;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6040`: `Axis 4`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_4 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6040;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6050`: `Axis 5`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_5 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6050;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6060`: `Axis 6`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_6 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6060;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6070`: `Axis 7`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_7 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6070;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6080`: `Axis 8`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_8 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6080;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6090`: `Axis 9`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_9 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6090;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x60A0`: `Axis 10`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_10 {
    /// Index of the object.
    pub const INDEX: u16 = 0x60A0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x60B0`: `Axis 11`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_11 {
    /// Index of the object.
    pub const INDEX: u16 = 0x60B0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x60C0`: `Axis 12`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_12 {
    /// Index of the object.
    pub const INDEX: u16 = 0x60C0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x60D0`: `Axis 13`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_13 {
    /// Index of the object.
    pub const INDEX: u16 = 0x60D0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x60E0`: `Axis 14`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_14 {
    /// Index of the object.
    pub const INDEX: u16 = 0x60E0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x60F0`: `Axis 15`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_15 {
    /// Index of the object.
    pub const INDEX: u16 = 0x60F0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6100`: `Axis 16`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_16 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6100;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6110`: `Axis 17`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_17 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6110;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6120`: `Axis 18`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_18 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6120;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6130`: `Axis 19`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_19 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6130;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6140`: `Axis 20`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_20 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6140;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6150`: `Axis 21`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_21 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6150;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6160`: `Axis 22`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_22 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6160;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6170`: `Axis 23`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_23 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6170;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6180`: `Axis 24`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_24 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6180;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x6190`: `Axis 25`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_25 {
    /// Index of the object.
    pub const INDEX: u16 = 0x6190;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// `0x61A0`: `Axis 26`.
#[allow(dead_code, unreachable_pub)]
pub mod axis_26 {
    /// Index of the object.
    pub const INDEX: u16 = 0x61A0;
    /// Sub-index `0x00`: `Highest sub-index supported`.
    pub const HIGHEST_SUB_INDEX_SUPPORTED: u8 = 0x00;
    /// Sub-index `0x01`: `Gain 1`.
    pub const GAIN_1: u8 = 0x01;
    /// Sub-index `0x02`: `Gain 2`.
    pub const GAIN_2: u8 = 0x02;
    /// Sub-index `0x03`: `Gain 3`.
    pub const GAIN_3: u8 = 0x03;
}

/// Default values of identity and services, decoded. COB-IDs are functions of the node-ID. `Data`
/// contains the present values.
#[allow(dead_code, unreachable_pub, clippy::cast_lossless)]
#[rustfmt::skip]
pub mod defaults {
    /// COB-ID of boot-up and heartbeat (`CiA` 301).
    #[must_use]
    pub const fn heartbeat_cob_id(node_id: u8) -> u32 {
        0x700 + node_id as u32
    }
}

/// The variable values; constants are in flash.
#[allow(dead_code, unreachable_pub, clippy::struct_excessive_bools)]
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    node_id: u8,
    /// `0x2000` sub-index `0x00`: `Parameter 0`, `rw`.
    pub parameter_0: u32,
    /// `0x2007` sub-index `0x00`: `Parameter 1`, `rw`.
    pub parameter_1: u32,
    /// `0x200E` sub-index `0x00`: `Parameter 2`, `rw`.
    pub parameter_2: u32,
    /// `0x2015` sub-index `0x00`: `Parameter 3`, `rw`.
    pub parameter_3: u32,
    /// `0x201C` sub-index `0x00`: `Parameter 4`, `rw`.
    pub parameter_4: u32,
    /// `0x2023` sub-index `0x00`: `Parameter 5`, `rw`.
    pub parameter_5: u32,
    /// `0x202A` sub-index `0x00`: `Parameter 6`, `rw`.
    pub parameter_6: u32,
    /// `0x2031` sub-index `0x00`: `Parameter 7`, `rw`.
    pub parameter_7: u32,
    /// `0x2038` sub-index `0x00`: `Parameter 8`, `rw`.
    pub parameter_8: u32,
    /// `0x203F` sub-index `0x00`: `Parameter 9`, `rw`.
    pub parameter_9: u32,
    /// `0x2046` sub-index `0x00`: `Parameter 10`, `rw`.
    pub parameter_10: u32,
    /// `0x204D` sub-index `0x00`: `Parameter 11`, `rw`.
    pub parameter_11: u32,
    /// `0x2054` sub-index `0x00`: `Parameter 12`, `rw`.
    pub parameter_12: u32,
    /// `0x205B` sub-index `0x00`: `Parameter 13`, `rw`.
    pub parameter_13: u32,
    /// `0x2062` sub-index `0x00`: `Parameter 14`, `rw`.
    pub parameter_14: u32,
    /// `0x2069` sub-index `0x00`: `Parameter 15`, `rw`.
    pub parameter_15: u32,
    /// `0x2070` sub-index `0x00`: `Parameter 16`, `rw`.
    pub parameter_16: u32,
    /// `0x2077` sub-index `0x00`: `Parameter 17`, `rw`.
    pub parameter_17: u32,
    /// `0x207E` sub-index `0x00`: `Parameter 18`, `rw`.
    pub parameter_18: u32,
    /// `0x2085` sub-index `0x00`: `Parameter 19`, `rw`.
    pub parameter_19: u32,
    /// `0x208C` sub-index `0x00`: `Parameter 20`, `rw`.
    pub parameter_20: u32,
    /// `0x2093` sub-index `0x00`: `Parameter 21`, `rw`.
    pub parameter_21: u32,
    /// `0x209A` sub-index `0x00`: `Parameter 22`, `rw`.
    pub parameter_22: u32,
    /// `0x20A1` sub-index `0x00`: `Parameter 23`, `rw`.
    pub parameter_23: u32,
    /// `0x20A8` sub-index `0x00`: `Parameter 24`, `rw`.
    pub parameter_24: u32,
    /// `0x20AF` sub-index `0x00`: `Parameter 25`, `rw`.
    pub parameter_25: u32,
    /// `0x20B6` sub-index `0x00`: `Parameter 26`, `rw`.
    pub parameter_26: u32,
    /// `0x20BD` sub-index `0x00`: `Parameter 27`, `rw`.
    pub parameter_27: u32,
    /// `0x20C4` sub-index `0x00`: `Parameter 28`, `rw`.
    pub parameter_28: u32,
    /// `0x20CB` sub-index `0x00`: `Parameter 29`, `rw`.
    pub parameter_29: u32,
    /// `0x20D2` sub-index `0x00`: `Parameter 30`, `rw`.
    pub parameter_30: u32,
    /// `0x20D9` sub-index `0x00`: `Parameter 31`, `rw`.
    pub parameter_31: u32,
    /// `0x20E0` sub-index `0x00`: `Parameter 32`, `rw`.
    pub parameter_32: u32,
    /// `0x20E7` sub-index `0x00`: `Parameter 33`, `rw`.
    pub parameter_33: u32,
    /// `0x20EE` sub-index `0x00`: `Parameter 34`, `rw`.
    pub parameter_34: u32,
    /// `0x20F5` sub-index `0x00`: `Parameter 35`, `rw`.
    pub parameter_35: u32,
    /// `0x20FC` sub-index `0x00`: `Parameter 36`, `rw`.
    pub parameter_36: u32,
    /// `0x2103` sub-index `0x00`: `Parameter 37`, `rw`.
    pub parameter_37: u32,
    /// `0x210A` sub-index `0x00`: `Parameter 38`, `rw`.
    pub parameter_38: u32,
    /// `0x2111` sub-index `0x00`: `Parameter 39`, `rw`.
    pub parameter_39: u32,
    /// `0x2118` sub-index `0x00`: `Parameter 40`, `rw`.
    pub parameter_40: u32,
    /// `0x211F` sub-index `0x00`: `Parameter 41`, `rw`.
    pub parameter_41: u32,
    /// `0x2126` sub-index `0x00`: `Parameter 42`, `rw`.
    pub parameter_42: u32,
    /// `0x212D` sub-index `0x00`: `Parameter 43`, `rw`.
    pub parameter_43: u32,
    /// `0x2134` sub-index `0x00`: `Parameter 44`, `rw`.
    pub parameter_44: u32,
    /// `0x213B` sub-index `0x00`: `Parameter 45`, `rw`.
    pub parameter_45: u32,
    /// `0x2142` sub-index `0x00`: `Parameter 46`, `rw`.
    pub parameter_46: u32,
    /// `0x2149` sub-index `0x00`: `Parameter 47`, `rw`.
    pub parameter_47: u32,
    /// `0x2150` sub-index `0x00`: `Parameter 48`, `rw`.
    pub parameter_48: u32,
    /// `0x6000` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_0_gain_1: u32,
    /// `0x6000` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_0_gain_2: u32,
    /// `0x6000` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_0_gain_3: u32,
    /// `0x6010` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_1_gain_1: u32,
    /// `0x6010` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_1_gain_2: u32,
    /// `0x6010` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_1_gain_3: u32,
    /// `0x6020` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_2_gain_1: u32,
    /// `0x6020` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_2_gain_2: u32,
    /// `0x6020` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_2_gain_3: u32,
    /// `0x6030` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_3_gain_1: u32,
    /// `0x6030` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_3_gain_2: u32,
    /// `0x6030` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_3_gain_3: u32,
    /// `0x6040` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_4_gain_1: u32,
    /// `0x6040` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_4_gain_2: u32,
    /// `0x6040` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_4_gain_3: u32,
    /// `0x6050` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_5_gain_1: u32,
    /// `0x6050` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_5_gain_2: u32,
    /// `0x6050` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_5_gain_3: u32,
    /// `0x6060` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_6_gain_1: u32,
    /// `0x6060` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_6_gain_2: u32,
    /// `0x6060` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_6_gain_3: u32,
    /// `0x6070` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_7_gain_1: u32,
    /// `0x6070` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_7_gain_2: u32,
    /// `0x6070` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_7_gain_3: u32,
    /// `0x6080` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_8_gain_1: u32,
    /// `0x6080` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_8_gain_2: u32,
    /// `0x6080` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_8_gain_3: u32,
    /// `0x6090` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_9_gain_1: u32,
    /// `0x6090` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_9_gain_2: u32,
    /// `0x6090` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_9_gain_3: u32,
    /// `0x60A0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_10_gain_1: u32,
    /// `0x60A0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_10_gain_2: u32,
    /// `0x60A0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_10_gain_3: u32,
    /// `0x60B0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_11_gain_1: u32,
    /// `0x60B0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_11_gain_2: u32,
    /// `0x60B0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_11_gain_3: u32,
    /// `0x60C0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_12_gain_1: u32,
    /// `0x60C0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_12_gain_2: u32,
    /// `0x60C0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_12_gain_3: u32,
    /// `0x60D0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_13_gain_1: u32,
    /// `0x60D0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_13_gain_2: u32,
    /// `0x60D0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_13_gain_3: u32,
    /// `0x60E0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_14_gain_1: u32,
    /// `0x60E0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_14_gain_2: u32,
    /// `0x60E0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_14_gain_3: u32,
    /// `0x60F0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_15_gain_1: u32,
    /// `0x60F0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_15_gain_2: u32,
    /// `0x60F0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_15_gain_3: u32,
    /// `0x6100` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_16_gain_1: u32,
    /// `0x6100` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_16_gain_2: u32,
    /// `0x6100` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_16_gain_3: u32,
    /// `0x6110` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_17_gain_1: u32,
    /// `0x6110` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_17_gain_2: u32,
    /// `0x6110` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_17_gain_3: u32,
    /// `0x6120` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_18_gain_1: u32,
    /// `0x6120` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_18_gain_2: u32,
    /// `0x6120` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_18_gain_3: u32,
    /// `0x6130` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_19_gain_1: u32,
    /// `0x6130` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_19_gain_2: u32,
    /// `0x6130` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_19_gain_3: u32,
    /// `0x6140` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_20_gain_1: u32,
    /// `0x6140` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_20_gain_2: u32,
    /// `0x6140` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_20_gain_3: u32,
    /// `0x6150` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_21_gain_1: u32,
    /// `0x6150` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_21_gain_2: u32,
    /// `0x6150` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_21_gain_3: u32,
    /// `0x6160` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_22_gain_1: u32,
    /// `0x6160` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_22_gain_2: u32,
    /// `0x6160` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_22_gain_3: u32,
    /// `0x6170` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_23_gain_1: u32,
    /// `0x6170` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_23_gain_2: u32,
    /// `0x6170` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_23_gain_3: u32,
    /// `0x6180` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_24_gain_1: u32,
    /// `0x6180` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_24_gain_2: u32,
    /// `0x6180` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_24_gain_3: u32,
    /// `0x6190` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_25_gain_1: u32,
    /// `0x6190` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_25_gain_2: u32,
    /// `0x6190` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_25_gain_3: u32,
    /// `0x61A0` sub-index `0x01`: `Gain 1`, `rw`.
    pub axis_26_gain_1: u32,
    /// `0x61A0` sub-index `0x02`: `Gain 2`, `rw`.
    pub axis_26_gain_2: u32,
    /// `0x61A0` sub-index `0x03`: `Gain 3`, `rw`.
    pub axis_26_gain_3: u32,
}

#[allow(dead_code, unreachable_pub)]
impl Data {
    /// The defaults for `node_id`, 1 to 127; only the lower seven bits are used.
    #[must_use]
    #[rustfmt::skip]
    #[allow(clippy::approx_constant, clippy::cast_lossless, clippy::too_many_lines)]
    pub const fn new(node_id: u8) -> Self {
        let node_id = node_id & 0x7F;
        Self {
            node_id,
            parameter_0: 0,
            parameter_1: 1,
            parameter_2: 2,
            parameter_3: 3,
            parameter_4: 4,
            parameter_5: 5,
            parameter_6: 6,
            parameter_7: 7,
            parameter_8: 8,
            parameter_9: 9,
            parameter_10: 10,
            parameter_11: 11,
            parameter_12: 12,
            parameter_13: 13,
            parameter_14: 14,
            parameter_15: 15,
            parameter_16: 16,
            parameter_17: 17,
            parameter_18: 18,
            parameter_19: 19,
            parameter_20: 20,
            parameter_21: 21,
            parameter_22: 22,
            parameter_23: 23,
            parameter_24: 24,
            parameter_25: 25,
            parameter_26: 26,
            parameter_27: 27,
            parameter_28: 28,
            parameter_29: 29,
            parameter_30: 30,
            parameter_31: 31,
            parameter_32: 32,
            parameter_33: 33,
            parameter_34: 34,
            parameter_35: 35,
            parameter_36: 36,
            parameter_37: 37,
            parameter_38: 38,
            parameter_39: 39,
            parameter_40: 40,
            parameter_41: 41,
            parameter_42: 42,
            parameter_43: 43,
            parameter_44: 44,
            parameter_45: 45,
            parameter_46: 46,
            parameter_47: 47,
            parameter_48: 48,
            axis_0_gain_1: 1,
            axis_0_gain_2: 2,
            axis_0_gain_3: 3,
            axis_1_gain_1: 1,
            axis_1_gain_2: 2,
            axis_1_gain_3: 3,
            axis_2_gain_1: 1,
            axis_2_gain_2: 2,
            axis_2_gain_3: 3,
            axis_3_gain_1: 1,
            axis_3_gain_2: 2,
            axis_3_gain_3: 3,
            axis_4_gain_1: 1,
            axis_4_gain_2: 2,
            axis_4_gain_3: 3,
            axis_5_gain_1: 1,
            axis_5_gain_2: 2,
            axis_5_gain_3: 3,
            axis_6_gain_1: 1,
            axis_6_gain_2: 2,
            axis_6_gain_3: 3,
            axis_7_gain_1: 1,
            axis_7_gain_2: 2,
            axis_7_gain_3: 3,
            axis_8_gain_1: 1,
            axis_8_gain_2: 2,
            axis_8_gain_3: 3,
            axis_9_gain_1: 1,
            axis_9_gain_2: 2,
            axis_9_gain_3: 3,
            axis_10_gain_1: 1,
            axis_10_gain_2: 2,
            axis_10_gain_3: 3,
            axis_11_gain_1: 1,
            axis_11_gain_2: 2,
            axis_11_gain_3: 3,
            axis_12_gain_1: 1,
            axis_12_gain_2: 2,
            axis_12_gain_3: 3,
            axis_13_gain_1: 1,
            axis_13_gain_2: 2,
            axis_13_gain_3: 3,
            axis_14_gain_1: 1,
            axis_14_gain_2: 2,
            axis_14_gain_3: 3,
            axis_15_gain_1: 1,
            axis_15_gain_2: 2,
            axis_15_gain_3: 3,
            axis_16_gain_1: 1,
            axis_16_gain_2: 2,
            axis_16_gain_3: 3,
            axis_17_gain_1: 1,
            axis_17_gain_2: 2,
            axis_17_gain_3: 3,
            axis_18_gain_1: 1,
            axis_18_gain_2: 2,
            axis_18_gain_3: 3,
            axis_19_gain_1: 1,
            axis_19_gain_2: 2,
            axis_19_gain_3: 3,
            axis_20_gain_1: 1,
            axis_20_gain_2: 2,
            axis_20_gain_3: 3,
            axis_21_gain_1: 1,
            axis_21_gain_2: 2,
            axis_21_gain_3: 3,
            axis_22_gain_1: 1,
            axis_22_gain_2: 2,
            axis_22_gain_3: 3,
            axis_23_gain_1: 1,
            axis_23_gain_2: 2,
            axis_23_gain_3: 3,
            axis_24_gain_1: 1,
            axis_24_gain_2: 2,
            axis_24_gain_3: 3,
            axis_25_gain_1: 1,
            axis_25_gain_2: 2,
            axis_25_gain_3: 3,
            axis_26_gain_1: 1,
            axis_26_gain_2: 2,
            axis_26_gain_3: 3,
        }
    }

    #[rustfmt::skip]
    #[allow(clippy::too_many_lines)]
    fn field(&self, ram: Offset) -> Option<&dyn Field> {
        let field: &dyn Field = match ram {
            1 => &self.parameter_0,
            2 => &self.parameter_1,
            3 => &self.parameter_2,
            4 => &self.parameter_3,
            5 => &self.parameter_4,
            6 => &self.parameter_5,
            7 => &self.parameter_6,
            8 => &self.parameter_7,
            9 => &self.parameter_8,
            10 => &self.parameter_9,
            11 => &self.parameter_10,
            12 => &self.parameter_11,
            13 => &self.parameter_12,
            14 => &self.parameter_13,
            15 => &self.parameter_14,
            16 => &self.parameter_15,
            17 => &self.parameter_16,
            18 => &self.parameter_17,
            19 => &self.parameter_18,
            20 => &self.parameter_19,
            21 => &self.parameter_20,
            22 => &self.parameter_21,
            23 => &self.parameter_22,
            24 => &self.parameter_23,
            25 => &self.parameter_24,
            26 => &self.parameter_25,
            27 => &self.parameter_26,
            28 => &self.parameter_27,
            29 => &self.parameter_28,
            30 => &self.parameter_29,
            31 => &self.parameter_30,
            32 => &self.parameter_31,
            33 => &self.parameter_32,
            34 => &self.parameter_33,
            35 => &self.parameter_34,
            36 => &self.parameter_35,
            37 => &self.parameter_36,
            38 => &self.parameter_37,
            39 => &self.parameter_38,
            40 => &self.parameter_39,
            41 => &self.parameter_40,
            42 => &self.parameter_41,
            43 => &self.parameter_42,
            44 => &self.parameter_43,
            45 => &self.parameter_44,
            46 => &self.parameter_45,
            47 => &self.parameter_46,
            48 => &self.parameter_47,
            49 => &self.parameter_48,
            50 => &self.axis_0_gain_1,
            51 => &self.axis_0_gain_2,
            52 => &self.axis_0_gain_3,
            53 => &self.axis_1_gain_1,
            54 => &self.axis_1_gain_2,
            55 => &self.axis_1_gain_3,
            56 => &self.axis_2_gain_1,
            57 => &self.axis_2_gain_2,
            58 => &self.axis_2_gain_3,
            59 => &self.axis_3_gain_1,
            60 => &self.axis_3_gain_2,
            61 => &self.axis_3_gain_3,
            62 => &self.axis_4_gain_1,
            63 => &self.axis_4_gain_2,
            64 => &self.axis_4_gain_3,
            65 => &self.axis_5_gain_1,
            66 => &self.axis_5_gain_2,
            67 => &self.axis_5_gain_3,
            68 => &self.axis_6_gain_1,
            69 => &self.axis_6_gain_2,
            70 => &self.axis_6_gain_3,
            71 => &self.axis_7_gain_1,
            72 => &self.axis_7_gain_2,
            73 => &self.axis_7_gain_3,
            74 => &self.axis_8_gain_1,
            75 => &self.axis_8_gain_2,
            76 => &self.axis_8_gain_3,
            77 => &self.axis_9_gain_1,
            78 => &self.axis_9_gain_2,
            79 => &self.axis_9_gain_3,
            80 => &self.axis_10_gain_1,
            81 => &self.axis_10_gain_2,
            82 => &self.axis_10_gain_3,
            83 => &self.axis_11_gain_1,
            84 => &self.axis_11_gain_2,
            85 => &self.axis_11_gain_3,
            86 => &self.axis_12_gain_1,
            87 => &self.axis_12_gain_2,
            88 => &self.axis_12_gain_3,
            89 => &self.axis_13_gain_1,
            90 => &self.axis_13_gain_2,
            91 => &self.axis_13_gain_3,
            92 => &self.axis_14_gain_1,
            93 => &self.axis_14_gain_2,
            94 => &self.axis_14_gain_3,
            95 => &self.axis_15_gain_1,
            96 => &self.axis_15_gain_2,
            97 => &self.axis_15_gain_3,
            98 => &self.axis_16_gain_1,
            99 => &self.axis_16_gain_2,
            100 => &self.axis_16_gain_3,
            101 => &self.axis_17_gain_1,
            102 => &self.axis_17_gain_2,
            103 => &self.axis_17_gain_3,
            104 => &self.axis_18_gain_1,
            105 => &self.axis_18_gain_2,
            106 => &self.axis_18_gain_3,
            107 => &self.axis_19_gain_1,
            108 => &self.axis_19_gain_2,
            109 => &self.axis_19_gain_3,
            110 => &self.axis_20_gain_1,
            111 => &self.axis_20_gain_2,
            112 => &self.axis_20_gain_3,
            113 => &self.axis_21_gain_1,
            114 => &self.axis_21_gain_2,
            115 => &self.axis_21_gain_3,
            116 => &self.axis_22_gain_1,
            117 => &self.axis_22_gain_2,
            118 => &self.axis_22_gain_3,
            119 => &self.axis_23_gain_1,
            120 => &self.axis_23_gain_2,
            121 => &self.axis_23_gain_3,
            122 => &self.axis_24_gain_1,
            123 => &self.axis_24_gain_2,
            124 => &self.axis_24_gain_3,
            125 => &self.axis_25_gain_1,
            126 => &self.axis_25_gain_2,
            127 => &self.axis_25_gain_3,
            128 => &self.axis_26_gain_1,
            129 => &self.axis_26_gain_2,
            130 => &self.axis_26_gain_3,
            _ => return None,
        };
        Some(field)
    }

    #[rustfmt::skip]
    #[allow(clippy::too_many_lines)]
    fn field_mut(&mut self, ram: Offset) -> Option<&mut dyn Field> {
        let field: &mut dyn Field = match ram {
            1 => &mut self.parameter_0,
            2 => &mut self.parameter_1,
            3 => &mut self.parameter_2,
            4 => &mut self.parameter_3,
            5 => &mut self.parameter_4,
            6 => &mut self.parameter_5,
            7 => &mut self.parameter_6,
            8 => &mut self.parameter_7,
            9 => &mut self.parameter_8,
            10 => &mut self.parameter_9,
            11 => &mut self.parameter_10,
            12 => &mut self.parameter_11,
            13 => &mut self.parameter_12,
            14 => &mut self.parameter_13,
            15 => &mut self.parameter_14,
            16 => &mut self.parameter_15,
            17 => &mut self.parameter_16,
            18 => &mut self.parameter_17,
            19 => &mut self.parameter_18,
            20 => &mut self.parameter_19,
            21 => &mut self.parameter_20,
            22 => &mut self.parameter_21,
            23 => &mut self.parameter_22,
            24 => &mut self.parameter_23,
            25 => &mut self.parameter_24,
            26 => &mut self.parameter_25,
            27 => &mut self.parameter_26,
            28 => &mut self.parameter_27,
            29 => &mut self.parameter_28,
            30 => &mut self.parameter_29,
            31 => &mut self.parameter_30,
            32 => &mut self.parameter_31,
            33 => &mut self.parameter_32,
            34 => &mut self.parameter_33,
            35 => &mut self.parameter_34,
            36 => &mut self.parameter_35,
            37 => &mut self.parameter_36,
            38 => &mut self.parameter_37,
            39 => &mut self.parameter_38,
            40 => &mut self.parameter_39,
            41 => &mut self.parameter_40,
            42 => &mut self.parameter_41,
            43 => &mut self.parameter_42,
            44 => &mut self.parameter_43,
            45 => &mut self.parameter_44,
            46 => &mut self.parameter_45,
            47 => &mut self.parameter_46,
            48 => &mut self.parameter_47,
            49 => &mut self.parameter_48,
            50 => &mut self.axis_0_gain_1,
            51 => &mut self.axis_0_gain_2,
            52 => &mut self.axis_0_gain_3,
            53 => &mut self.axis_1_gain_1,
            54 => &mut self.axis_1_gain_2,
            55 => &mut self.axis_1_gain_3,
            56 => &mut self.axis_2_gain_1,
            57 => &mut self.axis_2_gain_2,
            58 => &mut self.axis_2_gain_3,
            59 => &mut self.axis_3_gain_1,
            60 => &mut self.axis_3_gain_2,
            61 => &mut self.axis_3_gain_3,
            62 => &mut self.axis_4_gain_1,
            63 => &mut self.axis_4_gain_2,
            64 => &mut self.axis_4_gain_3,
            65 => &mut self.axis_5_gain_1,
            66 => &mut self.axis_5_gain_2,
            67 => &mut self.axis_5_gain_3,
            68 => &mut self.axis_6_gain_1,
            69 => &mut self.axis_6_gain_2,
            70 => &mut self.axis_6_gain_3,
            71 => &mut self.axis_7_gain_1,
            72 => &mut self.axis_7_gain_2,
            73 => &mut self.axis_7_gain_3,
            74 => &mut self.axis_8_gain_1,
            75 => &mut self.axis_8_gain_2,
            76 => &mut self.axis_8_gain_3,
            77 => &mut self.axis_9_gain_1,
            78 => &mut self.axis_9_gain_2,
            79 => &mut self.axis_9_gain_3,
            80 => &mut self.axis_10_gain_1,
            81 => &mut self.axis_10_gain_2,
            82 => &mut self.axis_10_gain_3,
            83 => &mut self.axis_11_gain_1,
            84 => &mut self.axis_11_gain_2,
            85 => &mut self.axis_11_gain_3,
            86 => &mut self.axis_12_gain_1,
            87 => &mut self.axis_12_gain_2,
            88 => &mut self.axis_12_gain_3,
            89 => &mut self.axis_13_gain_1,
            90 => &mut self.axis_13_gain_2,
            91 => &mut self.axis_13_gain_3,
            92 => &mut self.axis_14_gain_1,
            93 => &mut self.axis_14_gain_2,
            94 => &mut self.axis_14_gain_3,
            95 => &mut self.axis_15_gain_1,
            96 => &mut self.axis_15_gain_2,
            97 => &mut self.axis_15_gain_3,
            98 => &mut self.axis_16_gain_1,
            99 => &mut self.axis_16_gain_2,
            100 => &mut self.axis_16_gain_3,
            101 => &mut self.axis_17_gain_1,
            102 => &mut self.axis_17_gain_2,
            103 => &mut self.axis_17_gain_3,
            104 => &mut self.axis_18_gain_1,
            105 => &mut self.axis_18_gain_2,
            106 => &mut self.axis_18_gain_3,
            107 => &mut self.axis_19_gain_1,
            108 => &mut self.axis_19_gain_2,
            109 => &mut self.axis_19_gain_3,
            110 => &mut self.axis_20_gain_1,
            111 => &mut self.axis_20_gain_2,
            112 => &mut self.axis_20_gain_3,
            113 => &mut self.axis_21_gain_1,
            114 => &mut self.axis_21_gain_2,
            115 => &mut self.axis_21_gain_3,
            116 => &mut self.axis_22_gain_1,
            117 => &mut self.axis_22_gain_2,
            118 => &mut self.axis_22_gain_3,
            119 => &mut self.axis_23_gain_1,
            120 => &mut self.axis_23_gain_2,
            121 => &mut self.axis_23_gain_3,
            122 => &mut self.axis_24_gain_1,
            123 => &mut self.axis_24_gain_2,
            124 => &mut self.axis_24_gain_3,
            125 => &mut self.axis_25_gain_1,
            126 => &mut self.axis_25_gain_2,
            127 => &mut self.axis_25_gain_3,
            128 => &mut self.axis_26_gain_1,
            129 => &mut self.axis_26_gain_2,
            130 => &mut self.axis_26_gain_3,
            _ => return None,
        };
        Some(field)
    }

    /// The node-ID of the values.
    #[must_use]
    pub const fn node_id(&self) -> u8 {
        self.node_id
    }

    /// Reads a value into `buffer`, as transferred by an SDO upload; returns the number of bytes.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read(&self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let entry = find(index, sub)?;
        if !entry.is_readable() {
            return Err(Abort::WriteOnly);
        }
        let value = match self.field(entry.ram) {
            Some(field) => field.load(),
            None => entry.in_flash(self.node_id)?,
        };
        let bytes = match &value {
            Value::Number(number) => &number[..entry.size().min(8)],
            Value::Bytes(bytes) => bytes,
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
        let entry = find(index, sub)?;
        if !entry.is_writable() {
            return Err(Abort::ReadOnly);
        }
        let node_id = self.node_id;
        let field = self.field_mut(entry.ram).ok_or(Abort::CannotStore)?;
        entry.check_length(bytes.len())?;
        if entry.is_number() {
            let number = number(entry.data_type, bytes);
            entry.check_value(number, node_id)?;
            field.store(Value::Number(number.to_le_bytes()));
        } else {
            field.store(Value::Bytes(bytes));
        }
        Ok(())
    }
}

/// Why an SDO transfer is aborted (`CiA` 301).
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Abort {
    /// The buffer is shorter than the value.
    OutOfMemory = 0x0504_0005,
    /// Attempt to read a write-only entry.
    WriteOnly = 0x0601_0001,
    /// Attempt to write a read-only entry.
    ReadOnly = 0x0601_0002,
    /// There is no object with this index.
    NoObject = 0x0602_0000,
    /// The number of bytes does not match the data type.
    LengthMismatch = 0x0607_0010,
    /// More bytes than the data type or the capacity.
    TooLong = 0x0607_0012,
    /// Fewer bytes than the data type.
    TooShort = 0x0607_0013,
    /// The object has no such sub-index.
    NoSubIndex = 0x0609_0011,
    /// Not valid for the data type.
    InvalidValue = 0x0609_0030,
    /// Above the high limit.
    TooHigh = 0x0609_0031,
    /// Below the low limit.
    TooLow = 0x0609_0032,
    /// No capacity for the data; the application must store them.
    CannotStore = 0x0800_0020,
    /// No data in the table; the application must provide them.
    NoData = 0x0800_0024,
}

#[allow(dead_code, unreachable_pub)]
impl Abort {
    /// The abort code.
    #[must_use]
    pub const fn code(self) -> u32 {
        self as u32
    }
}

impl core::fmt::Display for Abort {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "SDO abort {:08X}h", self.code())
    }
}

/// Text or bytes of varying length, at most `N`.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Octets<const N: usize> {
    length: u16,
    bytes: [u8; N],
}

#[allow(dead_code, unreachable_pub)]
impl<const N: usize> Octets<N> {
    /// The first `N` of these bytes.
    #[must_use]
    pub const fn new(bytes: &[u8]) -> Self {
        let mut octets = Self {
            length: 0,
            bytes: [0; N],
        };
        while (octets.length as usize) < N && (octets.length as usize) < bytes.len() {
            octets.bytes[octets.length as usize] = bytes[octets.length as usize];
            octets.length += 1;
        }
        octets
    }

    /// The bytes.
    #[must_use]
    pub fn as_slice(&self) -> &[u8] {
        let length = usize::from(self.length);
        self.bytes.get(..length).unwrap_or(&self.bytes)
    }

    /// Replaces the bytes.
    ///
    /// # Errors
    /// [`Abort::TooLong`] for more than `N` bytes.
    pub fn set(&mut self, bytes: &[u8]) -> Result<(), Abort> {
        if bytes.len() > N {
            return Err(Abort::TooLong);
        }
        *self = Self::new(bytes);
        Ok(())
    }
}

/// A time of day since 1984-01-01, or a time difference.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Time {
    /// Milliseconds after midnight, 28 bits.
    pub milliseconds: u32,
    /// Days.
    pub days: u16,
}

impl Time {
    /// The used bits of the first four bytes.
    const USED: u32 = 0x0FFF_FFFF;
}

/// A value transferred by an SDO.
#[allow(dead_code)]
enum Value<'a> {
    /// Little-endian.
    Number([u8; 8]),
    Bytes(&'a [u8]),
}

/// Common operations of the fields of `Data`.
#[allow(dead_code)]
trait Field {
    fn load(&self) -> Value<'_>;
    fn store(&mut self, value: Value<'_>);
}

macro_rules! number_fields {
    ($($number:ty)*) => {
        $(impl Field for $number {
            fn load(&self) -> Value<'_> {
                let bytes = self.to_le_bytes();
                let mut number = [0; 8];
                number[..bytes.len()].copy_from_slice(&bytes);
                Value::Number(number)
            }

            fn store(&mut self, value: Value<'_>) {
                let mut bytes = self.to_le_bytes();
                if let Value::Number(number) = value {
                    bytes.copy_from_slice(&number[..core::mem::size_of::<Self>()]);
                }
                *self = Self::from_le_bytes(bytes);
            }
        })*
    };
}

number_fields!(i8 i16 i32 i64 u8 u16 u32 u64 f32 f64);

impl Field for bool {
    fn load(&self) -> Value<'_> {
        Value::Number([u8::from(*self), 0, 0, 0, 0, 0, 0, 0])
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Number([byte, ..]) = value {
            *self = byte != 0;
        }
    }
}

impl Field for Time {
    fn load(&self) -> Value<'_> {
        let mut number = [0; 8];
        number[..4].copy_from_slice(&(self.milliseconds & Self::USED).to_le_bytes());
        number[4..6].copy_from_slice(&self.days.to_le_bytes());
        Value::Number(number)
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Number([low, second, third, high, days @ .., _, _]) = value {
            self.milliseconds = u32::from_le_bytes([low, second, third, high]) & Self::USED;
            self.days = u16::from_le_bytes(days);
        }
    }
}

impl<const N: usize> Field for Octets<N> {
    fn load(&self) -> Value<'_> {
        Value::Bytes(self.as_slice())
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Bytes(bytes) = value {
            *self = Self::new(bytes);
        }
    }
}

impl<const N: usize> Field for [u8; N] {
    fn load(&self) -> Value<'_> {
        Value::Bytes(self)
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Bytes(bytes) = value {
            *self = Octets::new(bytes).bytes;
        }
    }
}

/// A location in RAM (0: none, the value is in flash) or in [`ROM`].
type Offset = u16;

/// An entry of the dictionary.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    index: u16,
    sub: u8,
    data_type: u8,
    flags: u16,
    ram: Offset,
    rom: Offset,
}

#[allow(dead_code, unreachable_pub)]
impl Entry {
    const fn row(address: (u16, u8), data_type: u8, flags: u16, ram: Offset, rom: Offset) -> Self {
        let (index, sub) = address;
        Self {
            index,
            sub,
            data_type,
            flags,
            ram,
            rom,
        }
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

    /// Whether the default is an offset to the node-ID.
    #[must_use]
    pub const fn adds_node_id(&self) -> bool {
        self.flags & NODE_ID_DEFAULT != 0
    }

    /// Maximum size of a value in an SDO transfer, in bytes.
    #[must_use]
    pub fn size(&self) -> usize {
        match number_size(self.data_type) {
            0 => self.head(0),
            size => size,
        }
    }

    /// The bytes of the default; for a formula, of the offset to the node-ID.
    #[must_use]
    pub fn default_bytes(&self) -> &'static [u8] {
        match number_size(self.data_type) {
            0 => self.bytes(4, self.head(2)),
            size => self.bytes(0, size),
        }
    }

    /// The low limit for a node as `u64` with the bits of the value.
    #[must_use]
    pub fn low_limit(&self, node_id: u8) -> Option<u64> {
        (self.flags & LOW != 0).then(|| self.number(1, LOW_NODE_ID, node_id))
    }

    /// The high limit for a node as `u64` with the bits of the value.
    #[must_use]
    pub fn high_limit(&self, node_id: u8) -> Option<u64> {
        let block = 1 + usize::from(self.flags & LOW != 0);
        (self.flags & HIGH != 0).then(|| self.number(block, HIGH_NODE_ID, node_id))
    }

    const fn key(&self) -> u32 {
        key(self.index, self.sub)
    }

    const fn is_number(&self) -> bool {
        number_size(self.data_type) != 0
    }

    /// The data of this entry in flash.
    fn bytes(&self, skip: usize, length: usize) -> &'static [u8] {
        let start = self.rom as usize + skip;
        ROM.get(start..start + length).unwrap_or(&[])
    }

    /// One of the two lengths before a non-numeric default.
    fn head(&self, skip: usize) -> usize {
        match self.bytes(skip, 2) {
            [low, high] => usize::from(*low) | (usize::from(*high) << 8),
            _ => 0,
        }
    }

    /// Reads a number from flash and adds the node-ID if the flag is set.
    fn number(&self, block: usize, flag: u16, node_id: u8) -> u64 {
        let size = self.size();
        let number = number(self.data_type, self.bytes(block * size, size));
        if self.flags & flag == 0 {
            return number;
        }
        number.wrapping_add(u64::from(node_id & 0x7F))
    }

    /// The value of an entry without a field.
    fn in_flash(&self, node_id: u8) -> Result<Value<'static>, Abort> {
        if self.is_number() {
            let number = self.number(0, NODE_ID_DEFAULT, node_id);
            return Ok(Value::Number(number.to_le_bytes()));
        }
        if self.data_type == DOMAIN && self.size() == 0 {
            return Err(Abort::NoData);
        }
        Ok(Value::Bytes(self.default_bytes()))
    }

    fn check_length(&self, length: usize) -> Result<(), Abort> {
        let exact = self.is_number() || self.data_type == BLOCK;
        if length > self.size() {
            Err(Abort::TooLong)
        } else if exact && length < self.size() {
            Err(Abort::TooShort)
        } else if self.data_type == UNICODE_STRING && length & 1 != 0 {
            Err(Abort::LengthMismatch)
        } else {
            Ok(())
        }
    }

    fn check_value(&self, number: u64, node_id: u8) -> Result<(), Abort> {
        if self.data_type == BOOLEAN && number > 1 {
            return Err(Abort::InvalidValue);
        }
        self.check_limits(number, node_id)
    }

    fn check_limits(&self, number: u64, node_id: u8) -> Result<(), Abort> {
        if self.flags & (LOW | HIGH) == 0 {
            return Ok(());
        }
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

/// Finds the entry with an index and a sub-index by binary search.
///
/// # Errors
/// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
#[allow(dead_code, unreachable_pub)]
pub fn find(index: u16, sub: u8) -> Result<&'static Entry, Abort> {
    match ENTRIES.binary_search_by_key(&key(index, sub), Entry::key) {
        Ok(row) => ENTRIES.get(row).ok_or(Abort::NoObject),
        Err(row) => {
            let mut neighbours = ENTRIES.iter().skip(row.saturating_sub(1)).take(2);
            if neighbours.any(|entry| entry.index == index) {
                Err(Abort::NoSubIndex)
            } else {
                Err(Abort::NoObject)
            }
        }
    }
}

const fn key(index: u16, sub: u8) -> u32 {
    ((index as u32) << 8) | sub as u32
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
fn number(data_type: u8, bytes: &[u8]) -> u64 {
    let negative = is_signed(data_type) && bytes.last().is_some_and(|&last| last >= 0x80);
    let start = if negative { u64::MAX } else { 0 };
    let shift = |number: u64, &byte: &u8| (number << 8) | u64::from(byte);
    bytes.iter().rev().fold(start, shift)
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
    if real & SIGN == 0 {
        Some(SIGN + magnitude)
    } else {
        Some(SIGN - magnitude)
    }
}

const READ: u16 = 0x001;
const WRITE: u16 = 0x002;
const TPDO: u16 = 0x004;
const RPDO: u16 = 0x008;
const LOW: u16 = 0x010;
const HIGH: u16 = 0x020;
const NODE_ID_DEFAULT: u16 = 0x040;
const LOW_NODE_ID: u16 = 0x080;
const HIGH_NODE_ID: u16 = 0x100;

const BLOCK: u8 = 0x00;
const BOOLEAN: u8 = 0x01;
const INTEGER8: u8 = 0x02;
const INTEGER16: u8 = 0x03;
const INTEGER32: u8 = 0x04;
const UNSIGNED8: u8 = 0x05;
const UNSIGNED16: u8 = 0x06;
const UNSIGNED32: u8 = 0x07;
const REAL32: u8 = 0x08;
#[allow(dead_code)]
const VISIBLE_STRING: u8 = 0x09;
#[allow(dead_code)]
const OCTET_STRING: u8 = 0x0A;
const UNICODE_STRING: u8 = 0x0B;
const TIME_OF_DAY: u8 = 0x0C;
const TIME_DIFFERENCE: u8 = 0x0D;
const DOMAIN: u8 = 0x0F;
const INTEGER24: u8 = 0x10;
const REAL64: u8 = 0x11;
const INTEGER40: u8 = 0x12;
const INTEGER48: u8 = 0x13;
const INTEGER56: u8 = 0x14;
const INTEGER64: u8 = 0x15;
const UNSIGNED24: u8 = 0x16;
const UNSIGNED40: u8 = 0x18;
const UNSIGNED48: u8 = 0x19;
const UNSIGNED56: u8 = 0x1A;
const UNSIGNED64: u8 = 0x1B;

/// All entries in ascending order of index and sub-index.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub static ENTRIES: [Entry; 157] = [
    Entry::row((0x2000, 0x00), UNSIGNED32, READ | WRITE, 1, 0), // `Parameter 0`
    Entry::row((0x2007, 0x00), UNSIGNED32, READ | WRITE, 2, 4), // `Parameter 1`
    Entry::row((0x200E, 0x00), UNSIGNED32, READ | WRITE, 3, 8), // `Parameter 2`
    Entry::row((0x2015, 0x00), UNSIGNED32, READ | WRITE, 4, 12), // `Parameter 3`
    Entry::row((0x201C, 0x00), UNSIGNED32, READ | WRITE, 5, 16), // `Parameter 4`
    Entry::row((0x2023, 0x00), UNSIGNED32, READ | WRITE, 6, 20), // `Parameter 5`
    Entry::row((0x202A, 0x00), UNSIGNED32, READ | WRITE, 7, 24), // `Parameter 6`
    Entry::row((0x2031, 0x00), UNSIGNED32, READ | WRITE, 8, 28), // `Parameter 7`
    Entry::row((0x2038, 0x00), UNSIGNED32, READ | WRITE, 9, 32), // `Parameter 8`
    Entry::row((0x203F, 0x00), UNSIGNED32, READ | WRITE, 10, 36), // `Parameter 9`
    Entry::row((0x2046, 0x00), UNSIGNED32, READ | WRITE, 11, 40), // `Parameter 10`
    Entry::row((0x204D, 0x00), UNSIGNED32, READ | WRITE, 12, 44), // `Parameter 11`
    Entry::row((0x2054, 0x00), UNSIGNED32, READ | WRITE, 13, 48), // `Parameter 12`
    Entry::row((0x205B, 0x00), UNSIGNED32, READ | WRITE, 14, 52), // `Parameter 13`
    Entry::row((0x2062, 0x00), UNSIGNED32, READ | WRITE, 15, 56), // `Parameter 14`
    Entry::row((0x2069, 0x00), UNSIGNED32, READ | WRITE, 16, 60), // `Parameter 15`
    Entry::row((0x2070, 0x00), UNSIGNED32, READ | WRITE, 17, 64), // `Parameter 16`
    Entry::row((0x2077, 0x00), UNSIGNED32, READ | WRITE, 18, 68), // `Parameter 17`
    Entry::row((0x207E, 0x00), UNSIGNED32, READ | WRITE, 19, 72), // `Parameter 18`
    Entry::row((0x2085, 0x00), UNSIGNED32, READ | WRITE, 20, 76), // `Parameter 19`
    Entry::row((0x208C, 0x00), UNSIGNED32, READ | WRITE, 21, 80), // `Parameter 20`
    Entry::row((0x2093, 0x00), UNSIGNED32, READ | WRITE, 22, 84), // `Parameter 21`
    Entry::row((0x209A, 0x00), UNSIGNED32, READ | WRITE, 23, 88), // `Parameter 22`
    Entry::row((0x20A1, 0x00), UNSIGNED32, READ | WRITE, 24, 92), // `Parameter 23`
    Entry::row((0x20A8, 0x00), UNSIGNED32, READ | WRITE, 25, 96), // `Parameter 24`
    Entry::row((0x20AF, 0x00), UNSIGNED32, READ | WRITE, 26, 100), // `Parameter 25`
    Entry::row((0x20B6, 0x00), UNSIGNED32, READ | WRITE, 27, 104), // `Parameter 26`
    Entry::row((0x20BD, 0x00), UNSIGNED32, READ | WRITE, 28, 108), // `Parameter 27`
    Entry::row((0x20C4, 0x00), UNSIGNED32, READ | WRITE, 29, 112), // `Parameter 28`
    Entry::row((0x20CB, 0x00), UNSIGNED32, READ | WRITE, 30, 116), // `Parameter 29`
    Entry::row((0x20D2, 0x00), UNSIGNED32, READ | WRITE, 31, 120), // `Parameter 30`
    Entry::row((0x20D9, 0x00), UNSIGNED32, READ | WRITE, 32, 124), // `Parameter 31`
    Entry::row((0x20E0, 0x00), UNSIGNED32, READ | WRITE, 33, 128), // `Parameter 32`
    Entry::row((0x20E7, 0x00), UNSIGNED32, READ | WRITE, 34, 132), // `Parameter 33`
    Entry::row((0x20EE, 0x00), UNSIGNED32, READ | WRITE, 35, 136), // `Parameter 34`
    Entry::row((0x20F5, 0x00), UNSIGNED32, READ | WRITE, 36, 140), // `Parameter 35`
    Entry::row((0x20FC, 0x00), UNSIGNED32, READ | WRITE, 37, 144), // `Parameter 36`
    Entry::row((0x2103, 0x00), UNSIGNED32, READ | WRITE, 38, 148), // `Parameter 37`
    Entry::row((0x210A, 0x00), UNSIGNED32, READ | WRITE, 39, 152), // `Parameter 38`
    Entry::row((0x2111, 0x00), UNSIGNED32, READ | WRITE, 40, 156), // `Parameter 39`
    Entry::row((0x2118, 0x00), UNSIGNED32, READ | WRITE, 41, 160), // `Parameter 40`
    Entry::row((0x211F, 0x00), UNSIGNED32, READ | WRITE, 42, 164), // `Parameter 41`
    Entry::row((0x2126, 0x00), UNSIGNED32, READ | WRITE, 43, 168), // `Parameter 42`
    Entry::row((0x212D, 0x00), UNSIGNED32, READ | WRITE, 44, 172), // `Parameter 43`
    Entry::row((0x2134, 0x00), UNSIGNED32, READ | WRITE, 45, 176), // `Parameter 44`
    Entry::row((0x213B, 0x00), UNSIGNED32, READ | WRITE, 46, 180), // `Parameter 45`
    Entry::row((0x2142, 0x00), UNSIGNED32, READ | WRITE, 47, 184), // `Parameter 46`
    Entry::row((0x2149, 0x00), UNSIGNED32, READ | WRITE, 48, 188), // `Parameter 47`
    Entry::row((0x2150, 0x00), UNSIGNED32, READ | WRITE, 49, 192), // `Parameter 48`
    Entry::row((0x6000, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6000, 0x01), UNSIGNED32, READ | WRITE, 50, 4), // `Gain 1`
    Entry::row((0x6000, 0x02), UNSIGNED32, READ | WRITE, 51, 8), // `Gain 2`
    Entry::row((0x6000, 0x03), UNSIGNED32, READ | WRITE, 52, 12), // `Gain 3`
    Entry::row((0x6010, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6010, 0x01), UNSIGNED32, READ | WRITE, 53, 4), // `Gain 1`
    Entry::row((0x6010, 0x02), UNSIGNED32, READ | WRITE, 54, 8), // `Gain 2`
    Entry::row((0x6010, 0x03), UNSIGNED32, READ | WRITE, 55, 12), // `Gain 3`
    Entry::row((0x6020, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6020, 0x01), UNSIGNED32, READ | WRITE, 56, 4), // `Gain 1`
    Entry::row((0x6020, 0x02), UNSIGNED32, READ | WRITE, 57, 8), // `Gain 2`
    Entry::row((0x6020, 0x03), UNSIGNED32, READ | WRITE, 58, 12), // `Gain 3`
    Entry::row((0x6030, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6030, 0x01), UNSIGNED32, READ | WRITE, 59, 4), // `Gain 1`
    Entry::row((0x6030, 0x02), UNSIGNED32, READ | WRITE, 60, 8), // `Gain 2`
    Entry::row((0x6030, 0x03), UNSIGNED32, READ | WRITE, 61, 12), // `Gain 3`
    Entry::row((0x6040, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6040, 0x01), UNSIGNED32, READ | WRITE, 62, 4), // `Gain 1`
    Entry::row((0x6040, 0x02), UNSIGNED32, READ | WRITE, 63, 8), // `Gain 2`
    Entry::row((0x6040, 0x03), UNSIGNED32, READ | WRITE, 64, 12), // `Gain 3`
    Entry::row((0x6050, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6050, 0x01), UNSIGNED32, READ | WRITE, 65, 4), // `Gain 1`
    Entry::row((0x6050, 0x02), UNSIGNED32, READ | WRITE, 66, 8), // `Gain 2`
    Entry::row((0x6050, 0x03), UNSIGNED32, READ | WRITE, 67, 12), // `Gain 3`
    Entry::row((0x6060, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6060, 0x01), UNSIGNED32, READ | WRITE, 68, 4), // `Gain 1`
    Entry::row((0x6060, 0x02), UNSIGNED32, READ | WRITE, 69, 8), // `Gain 2`
    Entry::row((0x6060, 0x03), UNSIGNED32, READ | WRITE, 70, 12), // `Gain 3`
    Entry::row((0x6070, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6070, 0x01), UNSIGNED32, READ | WRITE, 71, 4), // `Gain 1`
    Entry::row((0x6070, 0x02), UNSIGNED32, READ | WRITE, 72, 8), // `Gain 2`
    Entry::row((0x6070, 0x03), UNSIGNED32, READ | WRITE, 73, 12), // `Gain 3`
    Entry::row((0x6080, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6080, 0x01), UNSIGNED32, READ | WRITE, 74, 4), // `Gain 1`
    Entry::row((0x6080, 0x02), UNSIGNED32, READ | WRITE, 75, 8), // `Gain 2`
    Entry::row((0x6080, 0x03), UNSIGNED32, READ | WRITE, 76, 12), // `Gain 3`
    Entry::row((0x6090, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6090, 0x01), UNSIGNED32, READ | WRITE, 77, 4), // `Gain 1`
    Entry::row((0x6090, 0x02), UNSIGNED32, READ | WRITE, 78, 8), // `Gain 2`
    Entry::row((0x6090, 0x03), UNSIGNED32, READ | WRITE, 79, 12), // `Gain 3`
    Entry::row((0x60A0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x60A0, 0x01), UNSIGNED32, READ | WRITE, 80, 4), // `Gain 1`
    Entry::row((0x60A0, 0x02), UNSIGNED32, READ | WRITE, 81, 8), // `Gain 2`
    Entry::row((0x60A0, 0x03), UNSIGNED32, READ | WRITE, 82, 12), // `Gain 3`
    Entry::row((0x60B0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x60B0, 0x01), UNSIGNED32, READ | WRITE, 83, 4), // `Gain 1`
    Entry::row((0x60B0, 0x02), UNSIGNED32, READ | WRITE, 84, 8), // `Gain 2`
    Entry::row((0x60B0, 0x03), UNSIGNED32, READ | WRITE, 85, 12), // `Gain 3`
    Entry::row((0x60C0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x60C0, 0x01), UNSIGNED32, READ | WRITE, 86, 4), // `Gain 1`
    Entry::row((0x60C0, 0x02), UNSIGNED32, READ | WRITE, 87, 8), // `Gain 2`
    Entry::row((0x60C0, 0x03), UNSIGNED32, READ | WRITE, 88, 12), // `Gain 3`
    Entry::row((0x60D0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x60D0, 0x01), UNSIGNED32, READ | WRITE, 89, 4), // `Gain 1`
    Entry::row((0x60D0, 0x02), UNSIGNED32, READ | WRITE, 90, 8), // `Gain 2`
    Entry::row((0x60D0, 0x03), UNSIGNED32, READ | WRITE, 91, 12), // `Gain 3`
    Entry::row((0x60E0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x60E0, 0x01), UNSIGNED32, READ | WRITE, 92, 4), // `Gain 1`
    Entry::row((0x60E0, 0x02), UNSIGNED32, READ | WRITE, 93, 8), // `Gain 2`
    Entry::row((0x60E0, 0x03), UNSIGNED32, READ | WRITE, 94, 12), // `Gain 3`
    Entry::row((0x60F0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x60F0, 0x01), UNSIGNED32, READ | WRITE, 95, 4), // `Gain 1`
    Entry::row((0x60F0, 0x02), UNSIGNED32, READ | WRITE, 96, 8), // `Gain 2`
    Entry::row((0x60F0, 0x03), UNSIGNED32, READ | WRITE, 97, 12), // `Gain 3`
    Entry::row((0x6100, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6100, 0x01), UNSIGNED32, READ | WRITE, 98, 4), // `Gain 1`
    Entry::row((0x6100, 0x02), UNSIGNED32, READ | WRITE, 99, 8), // `Gain 2`
    Entry::row((0x6100, 0x03), UNSIGNED32, READ | WRITE, 100, 12), // `Gain 3`
    Entry::row((0x6110, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6110, 0x01), UNSIGNED32, READ | WRITE, 101, 4), // `Gain 1`
    Entry::row((0x6110, 0x02), UNSIGNED32, READ | WRITE, 102, 8), // `Gain 2`
    Entry::row((0x6110, 0x03), UNSIGNED32, READ | WRITE, 103, 12), // `Gain 3`
    Entry::row((0x6120, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6120, 0x01), UNSIGNED32, READ | WRITE, 104, 4), // `Gain 1`
    Entry::row((0x6120, 0x02), UNSIGNED32, READ | WRITE, 105, 8), // `Gain 2`
    Entry::row((0x6120, 0x03), UNSIGNED32, READ | WRITE, 106, 12), // `Gain 3`
    Entry::row((0x6130, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6130, 0x01), UNSIGNED32, READ | WRITE, 107, 4), // `Gain 1`
    Entry::row((0x6130, 0x02), UNSIGNED32, READ | WRITE, 108, 8), // `Gain 2`
    Entry::row((0x6130, 0x03), UNSIGNED32, READ | WRITE, 109, 12), // `Gain 3`
    Entry::row((0x6140, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6140, 0x01), UNSIGNED32, READ | WRITE, 110, 4), // `Gain 1`
    Entry::row((0x6140, 0x02), UNSIGNED32, READ | WRITE, 111, 8), // `Gain 2`
    Entry::row((0x6140, 0x03), UNSIGNED32, READ | WRITE, 112, 12), // `Gain 3`
    Entry::row((0x6150, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6150, 0x01), UNSIGNED32, READ | WRITE, 113, 4), // `Gain 1`
    Entry::row((0x6150, 0x02), UNSIGNED32, READ | WRITE, 114, 8), // `Gain 2`
    Entry::row((0x6150, 0x03), UNSIGNED32, READ | WRITE, 115, 12), // `Gain 3`
    Entry::row((0x6160, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6160, 0x01), UNSIGNED32, READ | WRITE, 116, 4), // `Gain 1`
    Entry::row((0x6160, 0x02), UNSIGNED32, READ | WRITE, 117, 8), // `Gain 2`
    Entry::row((0x6160, 0x03), UNSIGNED32, READ | WRITE, 118, 12), // `Gain 3`
    Entry::row((0x6170, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6170, 0x01), UNSIGNED32, READ | WRITE, 119, 4), // `Gain 1`
    Entry::row((0x6170, 0x02), UNSIGNED32, READ | WRITE, 120, 8), // `Gain 2`
    Entry::row((0x6170, 0x03), UNSIGNED32, READ | WRITE, 121, 12), // `Gain 3`
    Entry::row((0x6180, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6180, 0x01), UNSIGNED32, READ | WRITE, 122, 4), // `Gain 1`
    Entry::row((0x6180, 0x02), UNSIGNED32, READ | WRITE, 123, 8), // `Gain 2`
    Entry::row((0x6180, 0x03), UNSIGNED32, READ | WRITE, 124, 12), // `Gain 3`
    Entry::row((0x6190, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x6190, 0x01), UNSIGNED32, READ | WRITE, 125, 4), // `Gain 1`
    Entry::row((0x6190, 0x02), UNSIGNED32, READ | WRITE, 126, 8), // `Gain 2`
    Entry::row((0x6190, 0x03), UNSIGNED32, READ | WRITE, 127, 12), // `Gain 3`
    Entry::row((0x61A0, 0x00), UNSIGNED8, READ, 0, 12), // `Highest sub-index supported`
    Entry::row((0x61A0, 0x01), UNSIGNED32, READ | WRITE, 128, 4), // `Gain 1`
    Entry::row((0x61A0, 0x02), UNSIGNED32, READ | WRITE, 129, 8), // `Gain 2`
    Entry::row((0x61A0, 0x03), UNSIGNED32, READ | WRITE, 130, 12), // `Gain 3`
];

/// Defaults and limits.
#[rustfmt::skip]
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

/// The name of each entry in the description; not part of the program unless used.
#[allow(dead_code)]
#[rustfmt::skip]
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

#[allow(dead_code, unreachable_pub)]
impl Entry {
    /// The name in the description.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match ENTRIES.binary_search_by_key(&self.key(), Self::key) {
            Ok(row) => NAMES.get(row).copied().unwrap_or(""),
            Err(_) => "",
        }
    }
}
