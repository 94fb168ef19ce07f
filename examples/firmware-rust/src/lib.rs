//! The node: an SDO server for expedited transfers and a TPDO, both of the generated dictionary.
//!
//! There is no driver here: frames come as bytes and go as bytes, so that a test can be the bus.

#![no_std]
#![forbid(unsafe_code)]

/// The object dictionary, made of `climate-sensor.eds` by the build script.
pub mod od {
    include!(concat!(env!("OUT_DIR"), "/od.rs"));
}

use od::Abort;

/// The data of an SDO frame.
pub type Sdo = [u8; 8];

/// A frame that the node sends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The CAN-ID, 11 bits.
    pub id: u16,
    /// The data of the TPDO.
    pub data: [u8; od::pdo::Tpdo1::LENGTH],
}

/// The sensor as a CANopen node.
pub struct Node {
    /// The dictionary. The application reads and writes its values.
    pub data: od::Data,
}

/// The COB-ID is not in use.
const INVALID: u32 = 1 << 31;

impl Node {
    /// A node after reset.
    pub const fn new(node_id: u8) -> Self {
        Self { data: od::Data::new(node_id) }
    }

    /// Takes a measurement: tenths of a degree Celsius and tenths of a percent.
    pub fn measure(&mut self, temperature: i16, humidity: u16) {
        let data = &mut self.data;
        data.put(od::climate::TEMPERATURE, temperature);
        data.put(od::climate::HUMIDITY, humidity);
        let is_cold = temperature < data.get(od::alarm_limits::LOWEST_TEMPERATURE);
        let is_hot = temperature > data.get(od::alarm_limits::HIGHEST_TEMPERATURE);
        data.put(od::contacts::HEATER, is_cold);
        data.put(od::contacts::ALARM, is_cold || is_hot);
    }

    /// The TPDO as it would go out now; `None` while its COB-ID says that it does not exist.
    pub fn tpdo1(&self) -> Option<Frame> {
        let cob_id = self.data.get(od::tpdo_1::COB_ID);
        if cob_id & INVALID != 0 {
            return None;
        }
        let data = od::pdo::Tpdo1::load(&self.data).pack();
        Some(Frame { id: (cob_id & 0x7FF) as u16, data })
    }

    /// The answer to the request of an SDO client; none to an abort.
    pub fn answer(&mut self, request: Sdo) -> Option<Sdo> {
        let [command, low, high, sub, data @ ..] = request;
        let index = u16::from_le_bytes([low, high]);
        let answered = match command >> 5 {
            1 => self.download(index, sub, command, data),
            2 => self.upload(index, sub),
            4 => return None,
            _ => Err(Abort::UnknownCommand),
        };
        let (command, data) = answered.unwrap_or_else(|abort| (0x80, abort.code().to_le_bytes()));
        let [a, b, c, d] = data;
        Some([command, low, high, sub, a, b, c, d])
    }

    /// The client writes: bit 1 says that the data are in the frame, bit 0 that the frame says how many they are.
    fn download(&mut self, index: u16, sub: u8, command: u8, data: [u8; 4]) -> Result<(u8, [u8; 4]), Abort> {
        let length = match command & 3 {
            3 => 4 - usize::from(command >> 2 & 3),
            2 => od::find(index, sub)?.size().min(4),
            _ => return Err(Abort::UnknownCommand),
        };
        self.data.write(index, sub, &data[..length])?;
        Ok((0x60, [0; 4]))
    }

    /// The client reads. A value of more than four bytes needs a server for segments.
    fn upload(&self, index: u16, sub: u8) -> Result<(u8, [u8; 4]), Abort> {
        let mut data = [0; 4];
        let length = self.data.read(index, sub, &mut data)?;
        let unused = 4 - length as u8;
        Ok((0x43 | unused << 2, data))
    }
}
