//! The LSS master: node-ID and bit rate by the identity of a device (CiA 305).

use objdict_bus::Frame;

use crate::client::{BusClient, ClientError};

/// The CAN-IDs of requests and of answers.
const REQUEST: u16 = 0x7E5;
const ANSWER: u32 = 0x7E4;

/// How long a slave may take for an answer, in microseconds; for storing as long as an SDO.
const PATIENCE: u64 = 50_000;
const STORING: u64 = 2_000_000;

/// How long a device waits before it changes its bit rate, and then before it sends, in milliseconds; and how often it is asked then.
const SWITCH_DELAY: u16 = 500;
const ATTEMPTS: usize = 3;

/// Vendor-ID, product code, revision number and serial number.
pub type LssIdentity = [u32; 4];

/// The services that a slave may refuse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LssPlace {
    /// No device with this identity answers.
    Selection,
    /// The node-ID.
    NodeId,
    /// The bit rate.
    BitRate,
    /// An answer at the new bit rate.
    Test,
    /// Storing both.
    Store,
}

objdict_model::messages! { LssPlace: {
    Self::Selection => "no device with this identity answers";
    Self::NodeId => "the device refuses the node-ID";
    Self::BitRate => "the device refuses the bit rate";
    Self::Test => "the device does not respond at the new bit rate, so nothing is stored";
    Self::Store => "the device does not store node-ID and bit rate";
} }

/// The row of a bit rate in kbit/s in the table of CiA 305.
pub fn lss_rate(bit_rate: u16) -> Option<u8> {
    let row = [1000, 800, 500, 250, 125, 100, 50, 20, 10].iter().position(|rate| *rate == bit_rate)?;
    u8::try_from(row).ok()
}

impl BusClient {
    /// Finds a device without a node-ID: of several the one whose identity has the lowest numbers. It is in the configuration state then.
    ///
    /// # Errors
    /// When the adapter is lost or the user interrupts.
    pub fn fastscan(&mut self) -> Result<Option<LssIdentity>, ClientError> {
        self.lss_waiting()?;
        if self.ask(scan(0, 0x80, 0, 0), 0x4F, PATIENCE)?.is_none() {
            return Ok(None);
        }
        let mut identity = [0_u32; 4];
        for part in 0..4_u8 {
            let mut number = 0_u32;
            for bit in (0..32).rev() {
                if self.ask(scan(number, bit, part, part), 0x4F, PATIENCE)?.is_none() {
                    number |= 1 << bit;
                }
            }
            let next = if part == 3 { 0 } else { part + 1 };
            if self.ask(scan(number, 0, part, next), 0x4F, PATIENCE)?.is_none() {
                return Ok(None);
            }
            identity[usize::from(part)] = number;
        }
        Ok(Some(identity))
    }

    /// Puts the device with an identity into the configuration state; whether it is there.
    ///
    /// # Errors
    /// As [`fastscan`](Self::fastscan).
    pub fn lss_select(&mut self, identity: LssIdentity) -> Result<bool, ClientError> {
        self.lss_waiting()?;
        let mut answer = None;
        for (command, number) in (0x40..).zip(identity) {
            let wait = if command == 0x43 { PATIENCE } else { 0 };
            answer = self.ask(with_number(command, number), 0x44, wait)?;
        }
        Ok(answer.is_some())
    }

    /// Gives the selected device a node-ID and, if it is to have another one, a bit rate in kbit/s, and stores both. The bit rate is tested
    /// first if the adapter and the device can change to it; no other device may be on the bus then. Returns whether it was tested: if so,
    /// device and adapter work at it, else the device does from its next power-on.
    ///
    /// # Errors
    /// As [`fastscan`](Self::fastscan); what the device refuses is the result.
    pub fn lss_configure(
        &mut self,
        node_id: u8,
        bit_rate: Option<u16>,
    ) -> Result<Result<bool, LssPlace>, ClientError> {
        let mut is_tested = false;
        let is_accepted = |answer: Option<[u8; 8]>| answer.is_some_and(|answer| answer[1] == 0);
        if !is_accepted(self.ask([0x11, node_id, 0, 0, 0, 0, 0, 0], 0x11, PATIENCE)?) {
            return Ok(Err(LssPlace::NodeId));
        }
        if let Some(row) = bit_rate.map(lss_rate) {
            let row = row.unwrap_or(u8::MAX);
            if !is_accepted(self.ask([0x13, 0, row, 0, 0, 0, 0, 0], 0x13, PATIENCE)?) {
                return Ok(Err(LssPlace::BitRate));
            }
        }
        if let Some(bit_rate) = bit_rate.filter(|_| self.has_bit_rates()) {
            match self.lss_test(bit_rate)? {
                Some(false) => return Ok(Err(LssPlace::Test)),
                tested => is_tested = tested.is_some(),
            }
        }
        let is_stored = is_accepted(self.ask([0x17, 0, 0, 0, 0, 0, 0, 0], 0x17, STORING)?);
        Ok(if is_stored { Ok(is_tested) } else { Err(LssPlace::Store) })
    }

    /// Lets the selected device change its bit rate, and asks it there. If it does not answer, the adapter gets its own one back; `None`
    /// if the device answers there, because it cannot change without a power-on.
    fn lss_test(&mut self, bit_rate: u16) -> Result<Option<bool>, ClientError> {
        let (before, [low, high]) = (self.bit_rate(), SWITCH_DELAY.to_le_bytes());
        self.request([0x15, low, high, 0, 0, 0, 0, 0])?;
        // the request must leave the adapter, and the device waits twice
        self.listen(u64::from(SWITCH_DELAY) / 2)?;
        self.set_bit_rate(bit_rate)?;
        self.listen(2 * u64::from(SWITCH_DELAY))?;
        if self.is_configured()? {
            return Ok(Some(true));
        }
        if let Some(before) = before {
            self.set_bit_rate(before)?;
        }
        Ok(if self.is_configured()? { None } else { Some(false) })
    }

    /// Whether a device in the configuration state answers.
    fn is_configured(&mut self) -> Result<bool, ClientError> {
        for _ in 0..ATTEMPTS {
            if self.ask([0x5E, 0, 0, 0, 0, 0, 0, 0], 0x5E, PATIENCE)?.is_some() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Ends the configuration state of all devices. A device with a new node-ID starts with it.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn lss_waiting(&mut self) -> Result<(), ClientError> {
        self.request([0x04, 0, 0, 0, 0, 0, 0, 0])
    }

    fn request(&mut self, bytes: [u8; 8]) -> Result<(), ClientError> {
        Frame::new(REQUEST, &bytes).map_or(Ok(()), |frame| self.send(&frame.into()))
    }

    /// Sends a request; returns the answer with a command, or `None` if it does not come in time.
    fn ask(&mut self, request: [u8; 8], command: u8, wait: u64) -> Result<Option<[u8; 8]>, ClientError> {
        self.request(request)?;
        let until = self.now().saturating_add(wait);
        while let Some(frame) = self.next_frame(until)? {
            let answer = frame.data().first_chunk().copied().filter(|answer: &[u8; 8]| answer[0] == command);
            if frame.can_id == ANSWER && !frame.is_extended && answer.is_some() {
                return Ok(answer);
            }
        }
        Ok(None)
    }
}

fn with_number(command: u8, number: u32) -> [u8; 8] {
    let [a, b, c, d] = number.to_le_bytes();
    [command, a, b, c, d, 0, 0, 0]
}

const fn scan(number: u32, bit: u8, part: u8, next: u8) -> [u8; 8] {
    let [a, b, c, d] = number.to_le_bytes();
    [0x51, a, b, c, d, bit, part, next]
}
