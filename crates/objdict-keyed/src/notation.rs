//! The notations of strings in files, as ECMA-262 patterns for their JSON Schemas. The readers parse the same strings;
//! patterns cannot compare numbers, so the readers check the order of range limits and the range of times.

use super::section::{Notation, Shape};

/// The meaning of placeholders in patterns; a placeholder may contain those after it. `{words}` are the names
/// of data types.
pub const PARTS: [(&str, &str); 9] = [
    ("{address}", r"\s*{hex}\s*(([sS][uU][bB]|[:./])\s*0{0,2}(0[xX])?{sub}[hH]?\s*)?"),
    ("{subs}", r"(:\s*(0x)?{sub}\s*-\s*(0x)?{sub}\s*)?"),
    ("{hex}", "(0[xX][0-9A-Fa-f]{1,4}|[0-9A-Fa-f]{1,4}[hH]?)"),
    ("{sub}", "[0-9A-Fa-f]{1,2}"),
    ("{time}", r"[0-9]+(\.[0-9]{1,9})?\s*(m|[uµμ])?s"),
    ("{factor}", r"(?=[^eEx]*[1-9])\+?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?\s*x"),
    ("{number}", r"\+?(0[xX]0*[0-9A-Fa-f]{1,8}|0*[0-7]|[1-9][0-9]{0,9})"),
    ("{type}", "({words}|0x0*[0-9A-Fa-f]{1,4})"),
    ("{range}", "[0-9A-Fa-f]{4}(-[0-9A-Fa-f]{4})?"),
];

/// A time with its unit: `33ms`.
pub const TIME: Notation = r"^\s*{time}\s*$";
/// A factor: `1.5x`.
pub const FACTOR: Notation = r"^\s*{factor}\s*$";
/// A factor or a time.
pub const FACTOR_OR_TIME: Notation = r"^\s*({factor}|{time})\s*$";
/// The address of an object or entry: `6041`, `1018:1`.
pub const ADDRESS: Notation = "^{address}$";
/// An address, or a part of a description that has no address.
pub const PART: Notation = "^(file|device|commissioning|{address})$";
/// The addresses of entries: `6000:1-5`.
pub const ADDRESSES: Notation = "^{address}{subs}$";
/// A node with its entries, given by address or name.
pub const LINK_END: Notation = r"^\s*[^.\s][^.]*(\.({address}|\s*(?![0-9][0-9A-Fa-fxX:]*\s*$)(?=[^:]*[^\x00-)+-/:->@\[-`{-\x7F]).*){subs})?$";
/// A transmission type: `sync/1`, `event`, `254`.
pub const TRANSMISSION_TYPE: Shape = Shape::IntegerOrText(
    0,
    255,
    r"^\s*([sS][yY][nN][cC](/0*(1?[0-9]{1,2}|2[0-3][0-9]|240))?|[rR][tT][rR](-[sS][yY][nN][cC])?|[eE][vV][eE][nN][tT](-([vV][eE][nN][dD][oO][rR]|[pP][rR][oO][fF][iI][lL][eE]))?|0[xX]0*[0-9A-Fa-f]{1,2}|0*[0-7]|[89]|[1-9][0-9]|1[0-9]{2}|2[0-4][0-9]|25[0-5])\s*$",
);
/// What other strings are not, and the correct notation.
pub const NO_TRANSMISSION: [&str; 2] = [
    "a transmission type",
    "write `sync/1` to `sync/240`, `event`, `event-vendor`, `rtr`, `rtr-sync` or a number up to 255",
];
/// A COB-ID: `0x181`, `$NODEID+0x180`, `off`.
pub const COB_ID: Notation =
    r"^(off|{number}|\s*({number}\s*\+\s*)*\$[nN][oO][dD][eE][iI][dD]\s*(\+\s*{number}\s*)*)$";
/// A data type of an entry or object.
pub const DATA_TYPE: Notation = r"^({type}|record|array|\[\s*{type}\s*(;\s*0*([1-9][0-9]?|1[0-9]{2}|2[0-4][0-9]|25[0-4])\s*)?\]|string\(\s*[0-9]{1,10}\s*\))$";
/// The data type of an object as a whole.
pub const BASE_TYPE: Notation = "^{type}$";
/// Data types that fill gaps in RPDOs.
pub const DUMMIES: Notation = r"^(only(?= |$))?\s*(!?{type}(\s+!?{type})*)?\s*$";
/// Indexes of four digits, and ranges of them.
pub const INDEXES: Notation = r"^\s*({range}(\s+{range})*)?\s*$";
/// An entry of a device with a number of bits.
pub const MAPPED: Notation = "^[0-9A-Fa-f]{4}(:{sub})?(/[0-9]{1,3})?$";
/// Bits and bit ranges, as names in a table.
pub const BITS: Notation = r"^\s*0*([0-9]|[1-5][0-9]|6[0-3])\s*(-\s*0*([0-9]|[1-5][0-9]|6[0-3])\s*)?$";
/// Numbers of values, as names in a table.
pub const NUMBERS: Notation = "^([+-]?[0-9]+|[+]?(0[xX]0*[0-9A-Fa-f]{1,16}|0|[1-9][0-9]*)[uUlL]*)$";
/// A date of ISO 8601.
pub const DATE: Notation = "^[0-9]{4}-(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])$";
/// An ISO 8601 time of day.
pub const TIME_OF_DAY: Notation =
    r"^([01][0-9]|2[0-3]):[0-5][0-9](:[0-5][0-9](\.[0-9]+)?)?(Z|[+-](0[0-9]|1[0-3]):[0-5][0-9]|[+-]14:00)?$";
/// A hash of 64 digits.
pub const SHA256: Notation = "^[0-9A-Fa-f]{64}$";
