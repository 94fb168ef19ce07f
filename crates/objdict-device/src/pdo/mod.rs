//! PDOs with parameters and mapping that can change at run time.

pub(crate) mod mapping;
mod receive;
pub(crate) mod transmission_type;
mod transmit;

use crate::clock::{earlier, milliseconds};
use crate::dictionary::word;
use crate::frame::{EXTENDED, NOT_VALID, can_id};
use crate::guard::Guarded;
use crate::services::Services;
use crate::{Abort, Dictionary, Frame, sync};

use mapping::ActiveMapping;
use receive::Rpdo;
use transmission_type::is_event_driven;
use transmit::Tpdo;

/// The offset from the index of the communication parameters to the index of the mapping.
const MAPPING: u16 = 0x200;

/// The PDOs of a device: `R` RPDOs and `T` TPDOs.
///
/// The dictionary contains their parameters. [`Pdos::load`] reads them; [`Pdos::guard`] checks writes and
/// keeps the PDOs up to date. Times are in microseconds.
#[derive(Clone, Debug)]
pub struct Pdos<const R: usize, const T: usize> {
    rpdos: [Rpdo; R],
    tpdos: [Tpdo; T],
    sync: u32,
    /// Whether SYNC has a counter.
    counts: bool,
    is_running: bool,
}

/// A PDO with the mapping of the description, as a struct of its values; implemented in the generated file.
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

/// The effect of a received frame. PDOs are identified by the index of their communication parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Reception {
    /// The frame is neither SYNC nor a valid RPDO, or the PDOs are stopped.
    Ignored,
    /// SYNC: waiting RPDOs are written, TPDOs become due.
    Sync,
    /// The values of the RPDO are written.
    Written(u16),
    /// The RPDO waits for the next SYNC.
    Held(u16),
    /// The RPDO has fewer bytes than its mapping and is ignored (emergency 8210h).
    TooShort(u16),
    /// The RPDO has more bytes than its mapping; the first ones are used (emergency 8220h).
    TooLong(u16),
    /// The dictionary rejected a value of the RPDO; the others are written.
    Refused(u16, Abort),
}

/// The communication parameters of a PDO, and its mapping.
#[derive(Clone, Copy, Debug)]
struct PdoParameters {
    /// The index, such as 1800h.
    index: u16,
    cob_id: u32,
    transmission_type: u8,
    /// In units of 100 µs.
    inhibit_time: u16,
    /// In milliseconds.
    event_timer: u16,
    sync_start: u8,
    mapping: ActiveMapping,
}

impl PdoParameters {
    const fn new(index: u16) -> Self {
        Self {
            index,
            cob_id: NOT_VALID,
            transmission_type: 255,
            inhibit_time: 0,
            event_timer: 0,
            sync_start: 0,
            mapping: ActiveMapping::new(),
        }
    }

    fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let mut number = |sub, default| word(dictionary, self.index, sub, default);
        self.cob_id = number(1, NOT_VALID);
        self.transmission_type = number(2, 255) as u8;
        self.inhibit_time = number(3, 0) as u16;
        self.event_timer = number(5, 0) as u16;
        self.sync_start = number(6, 0) as u8;
        self.mapping.load(dictionary, self.index | MAPPING);
    }

    fn pack<D: Dictionary + ?Sized>(&self, dictionary: &mut D) -> Result<(u64, u8), Abort> {
        self.mapping.pack(dictionary, self.index | MAPPING)
    }

    fn unpack<D: Dictionary + ?Sized>(&self, dictionary: &mut D, frame: u64) -> Result<(), Abort> {
        self.mapping.unpack(dictionary, self.index | MAPPING, frame)
    }

    /// Whether an object is the communication parameters or the mapping.
    const fn has_object(&self, index: u16) -> bool {
        index & !MAPPING == self.index
    }

    const fn is_valid(&self) -> bool {
        self.cob_id & (NOT_VALID | EXTENDED) == 0
    }

    const fn is_event_driven(&self) -> bool {
        is_event_driven(self.transmission_type)
    }

    /// The event timer in microseconds.
    fn period(&self) -> Option<u64> {
        (self.event_timer != 0).then(|| milliseconds(self.event_timer))
    }
}

impl<const R: usize, const T: usize> Pdos<R, T> {
    /// The PDOs with these communication parameters, such as 1400h and 1800h. None is valid before [`Pdos::load`].
    #[must_use]
    pub const fn new(rpdos: [u16; R], tpdos: [u16; T]) -> Self {
        let mut pdos = Self {
            rpdos: [Rpdo::new(0); R],
            tpdos: [Tpdo::new(0); T],
            sync: 0x80,
            counts: false,
            is_running: false,
        };
        let mut at = 0;
        while at < R {
            pdos.rpdos[at].parameters.index = rpdos[at];
            at += 1;
        }
        at = 0;
        while at < T {
            pdos.tpdos[at].parameters.index = tpdos[at];
            at += 1;
        }
        pdos
    }

    /// Reads the parameters of all PDOs, after a reset or when the application changed them.
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.rpdos.iter_mut().for_each(|rpdo| rpdo.load(dictionary));
        self.tpdos.iter_mut().for_each(|tpdo| tpdo.load(dictionary));
        self.load_sync(dictionary);
    }

    fn load_sync<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.sync = sync::cob_id(dictionary);
        self.counts = word(dictionary, sync::OVERFLOW, 0, 0) != 0;
    }

    /// Starts the PDOs when the node becomes operational. Each event-driven TPDO is sent once.
    pub fn start(&mut self) {
        self.is_running = true;
        self.rpdos.iter_mut().for_each(Rpdo::restart);
        self.tpdos.iter_mut().for_each(Tpdo::restart);
    }

    /// Stops the PDOs when the node is no longer operational.
    pub const fn stop(&mut self) {
        self.is_running = false;
    }

    /// The dictionary for SDO servers: it rejects invalid values of communication objects, and the PDOs apply
    /// each write.
    pub const fn guard<'a, D: Dictionary + ?Sized>(
        &'a mut self,
        dictionary: &'a mut D,
    ) -> Guarded<'a, D, &'a mut Self> {
        Guarded { dictionary, services: self }
    }

    /// Processes a frame: SYNC, or the RPDOs with this CAN-ID. If there are several, the last one is
    /// returned.
    pub fn receive<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        frame: &Frame,
        now: u64,
    ) -> Reception {
        let mut last = Reception::Ignored;
        self.receive_each(dictionary, frame, now, |_, reception| last = reception);
        last
    }

    /// Processes a frame, and calls a function for SYNC and for each RPDO with this CAN-ID.
    pub(crate) fn receive_each<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        frame: &Frame,
        now: u64,
        mut each: impl FnMut(&mut D, Reception),
    ) {
        if !self.is_running {
            return;
        }
        for rpdo in self.rpdos.iter_mut().filter(|rpdo| rpdo.has_id(frame.id())) {
            let reception = rpdo.receive(dictionary, frame, now);
            each(dictionary, reception);
        }
        if self.sync & EXTENDED == 0 && frame.id() == can_id(self.sync) {
            let counter = frame.data().first().copied().filter(|_| self.counts);
            self.rpdos.iter_mut().for_each(|rpdo| rpdo.sync(dictionary));
            self.tpdos.iter_mut().for_each(|tpdo| tpdo.sync(counter));
            each(dictionary, Reception::Sync);
        }
    }

    /// The length of SYNC in bytes: 1 with a counter.
    pub(crate) const fn sync_length(&self) -> usize {
        self.counts as usize
    }

    /// The next TPDO that is due. Call it until it returns `None`.
    pub fn poll<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) -> Option<Frame> {
        let due = self.tpdos.iter_mut().filter(|tpdo| tpdo.is_due(now));
        if self.is_running { due.into_iter().find_map(|tpdo| tpdo.send(dictionary, now)) } else { None }
    }

    /// An RPDO that did not arrive within its event timer; each is reported once until it arrives again.
    pub fn overdue(&mut self, now: u64) -> Option<u16> {
        let rpdos = self.rpdos.iter_mut().filter(|_| self.is_running);
        rpdos.into_iter().find_map(|rpdo| rpdo.overdue(now))
    }

    /// The time at which a TPDO is due or an RPDO is overdue; `None` if that depends on a frame or a request.
    #[must_use]
    pub fn next(&self, now: u64) -> Option<u64> {
        if !self.is_running {
            return None;
        }
        let next = self.tpdos.iter().fold(None, |next, tpdo| earlier(next, tpdo.next(now)));
        self.rpdos.iter().fold(next, |next, rpdo| earlier(next, rpdo.deadline()))
    }

    /// Requests a TPDO of type 0, 254 or 255 by the index of its communication parameters. It is sent as soon as SYNC
    /// or its inhibit time permits.
    pub fn request(&mut self, index: u16) {
        let tpdos = self.tpdos.iter_mut().filter(|tpdo| tpdo.parameters.index == index);
        tpdos.for_each(Tpdo::request);
    }

    /// Requests the TPDOs of type 0, 254 and 255 whose values differ from the last transmission.
    pub fn request_changed<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let tpdos = self.tpdos.iter_mut();
        tpdos.for_each(|tpdo| tpdo.request_if_changed(dictionary));
    }

    /// Applies a write to the dictionary.
    pub(crate) fn follow<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16) {
        let objects = dictionary.objects();
        if (objects.writes(sync::COB_ID) || objects.writes(sync::OVERFLOW))
            && matches!(index, sync::COB_ID | sync::OVERFLOW)
        {
            self.load_sync(dictionary);
        }
        if !objects.writes(0x1400) && !objects.writes(0x1600) {
            return;
        }
        if let Some(rpdo) = self.rpdos.iter_mut().find(|rpdo| rpdo.parameters.has_object(index)) {
            rpdo.load(dictionary);
        }
        if let Some(tpdo) = self.tpdos.iter_mut().find(|tpdo| tpdo.parameters.has_object(index)) {
            tpdo.load(dictionary);
        }
    }
}

impl<const R: usize, const T: usize> Services for &mut Pdos<R, T> {
    fn follow<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16, _: u8) {
        Pdos::follow(self, dictionary, index);
    }
}
