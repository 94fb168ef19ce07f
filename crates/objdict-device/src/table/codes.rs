/// Flag of a row: readable by SDO.
pub const READ: u16 = 0x001;
/// Flag of a row: writable by SDO.
pub const WRITE: u16 = 0x002;
/// Flag of a row: mappable to TPDOs.
pub const TPDO: u16 = 0x004;
/// Flag of a row: mappable to RPDOs.
pub const RPDO: u16 = 0x008;
/// Flag of a row: it has a low limit.
pub const LOW: u16 = 0x010;
/// Flag of a row: it has a high limit.
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
