//! LSS: node-ID and bit rate by the identity of a node (CiA 305).

use crate::Frame;

/// The CAN-ID of the master's requests.
const REQUEST: u16 = 0x7E5;
/// The CAN-ID of responses.
const ANSWER: u32 = 0x7E4;

/// The node-ID of a node without one.
const NO_NODE_ID: u8 = 0xFF;

/// The responses of identified slaves.
const SELECTED: u8 = 0x44;
const IDENTIFIED: u8 = 0x4F;
const NOT_CONFIGURED: u8 = 0x50;

/// The error code for an unsupported service, and for a value that is out of range or not supported.
const REFUSED: u8 = 1;

/// The LSS slave: state, identity and the settings of the master.
///
/// It is independent of drivers and clocks: [`LssSlave::receive`] processes a frame, and returns a response or the
/// action required of the application; [`LssSlave::poll`] processes the time. It works in every NMT state. A node
/// without node-ID has no other service: it sends no boot-up message before [`LssReceived::NodeId`].
#[derive(Clone, Debug)]
pub struct LssSlave {
    /// Vendor-ID, product code, revision and serial number (1018h).
    identity: [u32; 4],
    node_id: Option<u8>,
    /// The node-ID from the next reset on.
    next_node_id: Option<u8>,
    /// In kbit/s; 0 for automatic bit rate detection.
    bit_rates: &'static [u16],
    bit_rate: Option<u16>,
    stores: bool,
    is_in_configuration: bool,
    /// The command that continues a selection or an identification in which all numbers so far match.
    selection: u8,
    /// The part of the identity that is scanned.
    scanned: u8,
    switch: Option<Switch>,
}

/// A change of the bit rate. Before and after it the node is silent.
#[derive(Clone, Copy, Debug)]
struct Switch {
    /// The end of the current delay.
    at: u64,
    delay: u64,
    /// The bit rate to change to; `None` in the delay after the change.
    bit_rate: Option<u16>,
}

/// The effect of a frame that the LSS slave received.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LssReceived {
    /// The frame is not for this node, or needs no response.
    Ignored,
    /// The response.
    Answer(Frame),
    /// The node without node-ID has this one now: it starts as after a reset of the communication.
    NodeId(u8),
    /// Both must be stored for the next power-on; then send [`LssSlave::answer_store`].
    Store {
        /// `None` if the node-ID is removed.
        node_id: Option<u8>,
        /// In kbit/s, 0 for automatic; `None` if the master has not configured it.
        bit_rate: Option<u16>,
    },
}

/// The reason why the configuration is not stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LssStoreError {
    /// The memory cannot be written.
    NoAccess,
    /// A reason of the vendor.
    Vendor(u8),
}

impl LssSlave {
    /// A slave in the waiting state with vendor-ID, product code, revision and serial number as in 1018h. `node_id` is
    /// the node-ID at power-on; `None`, or a value outside 1 to 127, for a node without one.
    #[must_use]
    pub const fn new(identity: [u32; 4], node_id: Option<u8>) -> Self {
        let node_id = match node_id {
            Some(node_id @ 1..=127) => Some(node_id),
            _ => None,
        };
        Self {
            identity,
            node_id,
            next_node_id: node_id,
            bit_rates: &[],
            bit_rate: None,
            stores: false,
            is_in_configuration: false,
            selection: 0,
            scanned: 0,
            switch: None,
        }
    }

    /// The bit rates that the driver can change to, in kbit/s, 0 for automatic. Otherwise, the master cannot configure any.
    #[must_use]
    pub const fn with_bit_rates(mut self, bit_rates: &'static [u16]) -> Self {
        self.bit_rates = bit_rates;
        self
    }

    /// Lets the application store node-ID and bit rate ([`LssReceived::Store`]). Otherwise the slave responds
    /// that this is not supported.
    #[must_use]
    pub const fn with_storage(mut self) -> Self {
        self.stores = true;
        self
    }

    /// The node-ID in use.
    #[must_use]
    pub const fn node_id(&self) -> Option<u8> {
        self.node_id
    }

    /// Whether the node is in the configuration state, rather than waiting.
    #[must_use]
    pub const fn is_in_configuration(&self) -> bool {
        self.is_in_configuration
    }

    /// Whether no service may send because the bit rate of the network is about to change.
    #[must_use]
    pub const fn is_silent(&self) -> bool {
        self.switch.is_some()
    }

    /// Resets the slave, and returns the node-ID after a reset of the node or its communication, as
    /// configured by the master.
    pub const fn reset(&mut self) -> Option<u8> {
        self.node_id = self.next_node_id;
        self.is_in_configuration = false;
        self.node_id
    }

    /// Processes a frame received at `now`, in microseconds.
    pub fn receive(&mut self, frame: &Frame, now: u64) -> LssReceived {
        if frame.id() != REQUEST || frame.data().len() != 8 || self.is_silent() {
            return LssReceived::Ignored;
        }
        let [command, a, b, c, d, rest @ ..] = frame.bytes();
        let number = u32::from_le_bytes([a, b, c, d]);
        let answer = match command {
            0x04 => return self.switch_state(a),
            0x40..=0x43 if !self.is_in_configuration => self.select(command, number),
            0x46..=0x4B => self.identify(command, number),
            0x4C => self.has_no_node_id().then_some([NOT_CONFIGURED, 0, 0, 0, 0]),
            0x51 if !self.is_in_configuration => self.scan(number, rest),
            0x15 if self.is_in_configuration => {
                self.start_switch(u16::from_le_bytes([a, b]), now);
                None
            }
            0x17 if self.is_in_configuration && self.stores => {
                return LssReceived::Store { node_id: self.next_node_id, bit_rate: self.bit_rate };
            }
            0x11..=0x17 | 0x5A..=0x5E if self.is_in_configuration => self.configure(command, [a, b]),
            _ => None,
        };
        answer.map_or(LssReceived::Ignored, |bytes| LssReceived::Answer(full(bytes)))
    }

    /// The response to [`LssReceived::Store`], for success or failure.
    #[must_use]
    pub const fn answer_store(result: Result<(), LssStoreError>) -> Frame {
        let (error, reason) = match result {
            Ok(()) => (0, 0),
            Err(LssStoreError::NoAccess) => (2, 0),
            Err(LssStoreError::Vendor(reason)) => (0xFF, reason),
        };
        full([0x17, error, reason, 0, 0])
    }

    /// The bit rate in kbit/s, 0 for automatic, to which the driver must change now.
    pub const fn poll(&mut self, now: u64) -> Option<u16> {
        let Some(Switch { at, delay, bit_rate }) = self.switch else { return None };
        if now < at {
            return None;
        }
        self.switch = match bit_rate {
            Some(_) => Some(Switch { at: at.saturating_add(delay), delay, bit_rate: None }),
            None => None,
        };
        bit_rate
    }

    /// The time at which [`LssSlave::poll`] must be called.
    #[must_use]
    pub const fn next(&self) -> Option<u64> {
        match self.switch {
            Some(switch) => Some(switch.at),
            None => None,
        }
    }

    const fn has_no_node_id(&self) -> bool {
        self.node_id.is_none() && self.next_node_id.is_none()
    }

    fn switch_state(&mut self, state: u8) -> LssReceived {
        match state {
            0 => self.is_in_configuration = false,
            1 => self.is_in_configuration = true,
            _ => {}
        }
        match (self.node_id, self.next_node_id) {
            (None, Some(node_id)) if !self.is_in_configuration => {
                self.node_id = Some(node_id);
                LssReceived::NodeId(node_id)
            }
            _ => LssReceived::Ignored,
        }
    }

    /// Whether the numbers of a selection or an identification match this node up to this command.
    fn fits(&mut self, command: u8, number: u32) -> bool {
        let [vendor, product, revision, serial] = self.identity;
        let fits = match command {
            0x40 | 0x46 => number == vendor,
            0x41 | 0x47 => number == product,
            0x42 => number == revision,
            0x43 => number == serial,
            0x48 => number <= revision,
            0x49 => number >= revision,
            0x4A => number <= serial,
            _ => number >= serial,
        };
        let is_first = matches!(command, 0x40 | 0x46);
        let fits = fits && (is_first || command == self.selection);
        self.selection = if fits { command + 1 } else { 0 };
        fits
    }

    fn select(&mut self, command: u8, number: u32) -> Option<[u8; 5]> {
        if !self.fits(command, number) || command != 0x43 {
            return None;
        }
        self.is_in_configuration = true;
        Some([SELECTED, 0, 0, 0, 0])
    }

    fn identify(&mut self, command: u8, number: u32) -> Option<[u8; 5]> {
        let fits = self.fits(command, number);
        (fits && command == 0x4B).then_some([IDENTIFIED, 0, 0, 0, 0])
    }

    /// A step of fastscan: whether a part of the identity matches the number from bit `bit` on. All nodes without
    /// node-ID send the same response at the same time.
    fn scan(&mut self, number: u32, [bit, part, next]: [u8; 3]) -> Option<[u8; 5]> {
        const START: u8 = 0x80;
        if !self.has_no_node_id() || next > 3 {
            return None;
        }
        if bit == START {
            self.scanned = 0;
            return Some([IDENTIFIED, 0, 0, 0, 0]);
        }
        let differences = (self.identity.get(usize::from(part))? ^ number).checked_shr(bit.into())?;
        if part != self.scanned || differences != 0 {
            return None;
        }
        self.scanned = next;
        self.is_in_configuration = bit == 0 && next < part;
        Some([IDENTIFIED, 0, 0, 0, 0])
    }

    /// The services of the configuration state except those with an event.
    fn configure(&mut self, command: u8, [a, b]: [u8; 2]) -> Option<[u8; 5]> {
        let inquired = |number: u32| {
            let [a, b, c, d] = number.to_le_bytes();
            [command, a, b, c, d]
        };
        let [vendor, product, revision, serial] = self.identity;
        Some(match command {
            0x11 => [command, self.configure_node_id(a), 0, 0, 0],
            0x13 => [command, self.configure_bit_rate(a, b), 0, 0, 0],
            // with storage, this is an event
            0x17 => [command, REFUSED, 0, 0, 0],
            0x5A => inquired(vendor),
            0x5B => inquired(product),
            0x5C => inquired(revision),
            0x5D => inquired(serial),
            // before the node has a node-ID, its next one
            0x5E => [command, self.node_id.or(self.next_node_id).unwrap_or(NO_NODE_ID), 0, 0, 0],
            _ => return None,
        })
    }

    const fn configure_node_id(&mut self, node_id: u8) -> u8 {
        self.next_node_id = match node_id {
            1..=127 => Some(node_id),
            NO_NODE_ID => None,
            _ => return REFUSED,
        };
        0
    }

    /// CiA 305 defines table 0; vendors may define others.
    fn configure_bit_rate(&mut self, table: u8, row: u8) -> u8 {
        let bit_rate = match row {
            0 => 1000,
            1 => 800,
            2 => 500,
            3 => 250,
            4 => 125,
            6 => 50,
            7 => 20,
            8 => 10,
            9 => 0,
            _ => return REFUSED,
        };
        if table != 0 || !self.bit_rates.contains(&bit_rate) {
            return REFUSED;
        }
        self.bit_rate = Some(bit_rate);
        0
    }

    /// Begins the first delay, in milliseconds. Does nothing without a configured bit rate.
    fn start_switch(&mut self, delay: u16, now: u64) {
        let delay = u64::from(delay) * 1000;
        let at = now.saturating_add(delay);
        self.switch = self.bit_rate.map(|bit_rate| Switch { at, delay, bit_rate: Some(bit_rate) });
    }
}

const fn full([a, b, c, d, e]: [u8; 5]) -> Frame {
    Frame::full(ANSWER, [a, b, c, d, e, 0, 0, 0])
}
