//! PDOs whose parameters and mapping change at run time.

mod mapping;
mod receive;
mod rules;
mod transmit;

use crate::{Abort, Attributes, Dictionary, Frame};

use receive::Rpdo;
use transmit::Tpdo;

/// The bit of a COB-ID that says that the PDO is not valid.
const NOT_VALID: u32 = 1 << 31;

/// The COB-ID of SYNC in a device without 1005h.
const SYNC: u32 = 0x80;

/// Whether a transmission type is event-driven; 0 to 240 are synchronous, those in between reserved or for remote frames.
const fn is_event_driven(transmission_type: u8) -> bool {
    transmission_type >= 254
}

/// The PDOs of a device: `R` RPDOs and `T` TPDOs.
///
/// The dictionary holds their parameters. [`Pdos::load`] reads those of communication, and writes go through [`Pdos::guard`],
/// which checks them and keeps them up to date; the mapping is read whenever a PDO is packed or unpacked. Times are in microseconds.
#[derive(Clone, Debug)]
pub struct Pdos<const R: usize, const T: usize> {
    rpdos: [Rpdo; R],
    tpdos: [Tpdo; T],
    sync: u32,
    /// Whether SYNC has a counter.
    counts: bool,
    is_running: bool,
}

/// A PDO with the mapping of the description, as a struct of its values. The generated file implements it.
pub trait Pdo: Sized {
    /// The values of the device.
    type Data;
    /// The index of its communication parameters, such as 1800h.
    const INDEX: u16;
    /// Length of a frame in bytes.
    const LENGTH: usize;

    /// Reads the present values.
    fn load(data: &Self::Data) -> Self;

    /// Writes the values without checking limits; constants are unchanged.
    fn store(&self, data: &mut Self::Data);

    /// The values as in a frame, with zeros beyond its length.
    fn to_bytes(&self) -> [u8; 8];

    /// The values of a frame.
    fn from_bytes(bytes: [u8; 8]) -> Self;
}

/// What became of a received frame. PDOs are named by the index of their communication parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reception {
    /// It is neither SYNC nor a valid RPDO, or the PDOs are stopped.
    Ignored,
    /// SYNC: RPDOs that waited for it are written, TPDOs are due.
    Sync,
    /// The values of the RPDO are written.
    Written(u16),
    /// The RPDO waits for the next SYNC.
    Held(u16),
    /// The RPDO has fewer bytes than its mapping, and is ignored (emergency 8210h).
    TooShort(u16),
    /// The dictionary refused a value of the RPDO; the others are written.
    Refused(u16, Abort),
}

/// The communication parameters of a PDO.
#[derive(Clone, Copy, Debug)]
struct Parameters {
    /// The index, such as 1800h.
    index: u16,
    cob_id: u32,
    transmission_type: u8,
    /// In units of 100 µs.
    inhibit_time: u16,
    /// In milliseconds.
    event_timer: u16,
    sync_start: u8,
}

impl Parameters {
    const fn new(index: u16) -> Self {
        Self {
            index,
            cob_id: NOT_VALID,
            transmission_type: 255,
            inhibit_time: 0,
            event_timer: 0,
            sync_start: 0,
        }
    }

    fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let mut number = |sub, default| dictionary.number(self.index, sub).unwrap_or(default);
        self.cob_id = number(1, u64::from(NOT_VALID)) as u32;
        self.transmission_type = number(2, 255) as u8;
        self.inhibit_time = number(3, 0) as u16;
        self.event_timer = number(5, 0) as u16;
        self.sync_start = number(6, 0) as u8;
    }

    const fn is_valid(&self) -> bool {
        self.cob_id & NOT_VALID == 0
    }

    const fn is_event_driven(&self) -> bool {
        is_event_driven(self.transmission_type)
    }

    /// The index of the mapping, such as 1A00h.
    const fn mapping(&self) -> u16 {
        self.index | 0x200
    }

    /// The event timer in microseconds.
    fn period(&self) -> Option<u64> {
        (self.event_timer != 0).then(|| u64::from(self.event_timer) * 1000)
    }
}

impl<const R: usize, const T: usize> Pdos<R, T> {
    /// The PDOs with these communication parameters, such as 1400h and 1800h. None is valid before [`Pdos::load`].
    #[must_use]
    pub const fn new(rpdos: [u16; R], tpdos: [u16; T]) -> Self {
        let mut pdos = Self {
            rpdos: [Rpdo::new(0); R],
            tpdos: [Tpdo::new(0); T],
            sync: SYNC,
            counts: false,
            is_running: false,
        };
        let mut at = 0;
        while at < R {
            pdos.rpdos[at] = Rpdo::new(rpdos[at]);
            at += 1;
        }
        at = 0;
        while at < T {
            pdos.tpdos[at] = Tpdo::new(tpdos[at]);
            at += 1;
        }
        pdos
    }

    /// Reads the communication parameters of all PDOs, after a reset or when the application changed them.
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.rpdos.iter_mut().for_each(|rpdo| rpdo.load(dictionary));
        self.tpdos.iter_mut().for_each(|tpdo| tpdo.load(dictionary));
        self.load_sync(dictionary);
    }

    fn load_sync<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.sync = dictionary.number(0x1005, 0).map_or(SYNC, |cob_id| cob_id as u32);
        self.counts = dictionary.number(0x1019, 0).is_ok_and(|overflow| overflow != 0);
    }

    /// Starts the PDOs when the node becomes operational. Each event-driven TPDO is sent once.
    pub fn start(&mut self) {
        self.is_running = true;
        self.rpdos.iter_mut().for_each(Rpdo::restart);
        self.tpdos.iter_mut().for_each(Tpdo::restart);
    }

    /// Stops the PDOs when the node is not operational any more.
    pub const fn stop(&mut self) {
        self.is_running = false;
    }

    /// The dictionary for SDO servers: it refuses what parameters of PDOs cannot be, and the PDOs follow what is written.
    pub const fn guard<'a, D: Dictionary + ?Sized>(
        &'a mut self,
        dictionary: &'a mut D,
    ) -> Guarded<'a, D, R, T> {
        Guarded { dictionary, pdos: self }
    }

    /// Takes a frame: SYNC or an RPDO.
    pub fn receive<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        frame: &Frame,
        now: u64,
    ) -> Reception {
        if !self.is_running {
            return Reception::Ignored;
        }
        if let Some(rpdo) = self.rpdos.iter_mut().find(|rpdo| rpdo.has_id(frame.id())) {
            return rpdo.receive(dictionary, frame, now);
        }
        if frame.id() != crate::frame::can_id(self.sync) {
            return Reception::Ignored;
        }
        let counter = frame.data().first().copied().filter(|_| self.counts);
        self.rpdos.iter_mut().for_each(|rpdo| rpdo.sync(dictionary));
        self.tpdos.iter_mut().for_each(|tpdo| tpdo.sync(counter));
        Reception::Sync
    }

    /// The next TPDO that is due. Call it until it returns `None`.
    pub fn poll<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) -> Option<Frame> {
        let due = self.tpdos.iter_mut().filter(|tpdo| tpdo.is_due(now));
        if self.is_running { due.into_iter().find_map(|tpdo| tpdo.send(dictionary, now)) } else { None }
    }

    /// An RPDO that did not come for as long as its event timer says; each is reported once until it comes again.
    pub fn overdue(&mut self, now: u64) -> Option<u16> {
        let rpdos = self.rpdos.iter_mut().filter(|_| self.is_running);
        rpdos.into_iter().find_map(|rpdo| rpdo.overdue(now))
    }

    /// Requests a TPDO of type 0, 254 or 255 by the index of its communication parameters: it is sent as soon as SYNC or its inhibit
    /// time permits.
    pub fn request(&mut self, index: u16) {
        let tpdos = self.tpdos.iter_mut().filter(|tpdo| tpdo.index() == index);
        tpdos.for_each(Tpdo::request);
    }

    /// Requests the TPDOs of type 0, 254 and 255 whose values differ from those that were sent last.
    pub fn request_changed<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let tpdos = self.tpdos.iter_mut();
        tpdos.for_each(|tpdo| tpdo.request_if_changed(dictionary));
    }

    /// Follows a write to the dictionary.
    fn follow<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16) {
        if matches!(index, 0x1005 | 0x1019) {
            self.load_sync(dictionary);
        }
        if let Some(rpdo) = self.rpdos.iter_mut().find(|rpdo| rpdo.index() == index) {
            rpdo.load(dictionary);
        }
        if let Some(tpdo) = self.tpdos.iter_mut().find(|tpdo| tpdo.index() == index) {
            tpdo.load(dictionary);
        }
    }
}

/// A dictionary whose PDOs follow what is written to it; see [`Pdos::guard`].
#[derive(Debug)]
pub struct Guarded<'a, D: ?Sized, const R: usize, const T: usize> {
    dictionary: &'a mut D,
    pdos: &'a mut Pdos<R, T>,
}

impl<D: Dictionary + ?Sized, const R: usize, const T: usize> Dictionary for Guarded<'_, D, R, T> {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        self.dictionary.attributes(index, sub)
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        self.dictionary.read(index, sub, buffer)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let entry = self.dictionary.attributes(index, sub)?;
        // the dictionary itself knows why it refuses others
        if entry.writable && bytes.len() == entry.size && bytes.len() <= 8 {
            let number = bytes.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte));
            rules::check(self.dictionary, index, sub, number)?;
        }
        self.dictionary.write(index, sub, bytes)?;
        self.pdos.follow(self.dictionary, index);
        Ok(())
    }
}
