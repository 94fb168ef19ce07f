//! Storage and programs of `objdict-device` in a flash, by way of `embedded-storage`.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};
use objdict_device::{
    Abort, Attributes, Dictionary, FlashStorage, Frame, Node, Pdos, ProgramRequest, ProgramState,
};
use objdict_device::{LossReason, Received, Region, Scope, Storage, StorageLoss, WithProgram};

/// A flash in RAM: what is written must have been erased, in whole units.
#[derive(Clone)]
struct Ram {
    bytes: Vec<u8>,
    /// So many bytes are still changed before the power fails.
    power: usize,
}

impl Ram {
    fn new(size: usize) -> Self {
        Self { bytes: vec![0xAA; size], power: usize::MAX }
    }

    /// Changes bytes one after the other until the power fails, which leaves one that is neither.
    fn change(&mut self, offset: usize, bytes: impl Iterator<Item = u8>) -> Result<(), Misuse> {
        for (place, byte) in self.bytes[offset..].iter_mut().zip(bytes) {
            if self.power == 0 {
                *place ^= 0x5A;
                return Err(Misuse);
            }
            self.power -= 1;
            *place = byte;
        }
        Ok(())
    }
}

#[derive(Debug)]
struct Misuse;

impl NorFlashError for Misuse {
    fn kind(&self) -> NorFlashErrorKind {
        NorFlashErrorKind::Other
    }
}

impl ErrorType for Ram {
    type Error = Misuse;
}

impl ReadNorFlash for Ram {
    const READ_SIZE: usize = 4;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Misuse> {
        let offset = offset as usize;
        assert_eq!((offset % 4, bytes.len() % 4), (0, 0), "whole units");
        bytes.copy_from_slice(self.bytes.get(offset..offset + bytes.len()).ok_or(Misuse)?);
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.bytes.len()
    }
}

impl NorFlash for Ram {
    const WRITE_SIZE: usize = 8;
    const ERASE_SIZE: usize = 256;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), Misuse> {
        assert_eq!((from % 256, to % 256), (0, 0), "whole pages");
        self.change(from as usize, (from..to).map(|_| 0xFF))
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Misuse> {
        let offset = offset as usize;
        assert_eq!((offset % 8, bytes.len() % 8), (0, 0), "whole units");
        assert!(self.bytes[offset..offset + bytes.len()].iter().all(|&byte| byte == 0xFF), "erased");
        self.change(offset, bytes.iter().copied())
    }
}

#[test]
fn a_region_is_a_part_of_whole_pages() {
    let region = |start, end| Region::new(Ram::new(1024), start, end).is_some();
    assert!(region(0, 1024) && region(256, 512));
    assert!(!region(0, 1280) && !region(128, 512) && !region(0, 500) && !region(512, 256));
}

#[test]
fn groups_have_parts_of_their_own() {
    let region = Region::new(Ram::new(2048), 512, 2048).unwrap();
    assert!(FlashStorage::new(region.clone(), 0).is_none() && FlashStorage::new(region.clone(), 4).is_none());
    let mut storage = FlashStorage::new(region, 3).unwrap();
    let (one, other): (Vec<u8>, Vec<u8>) = ((0..101).collect(), (101..250).collect());
    storage.save(0, &[7; 3]).unwrap();
    storage.save(1, &other).unwrap();
    storage.save(0, &one).unwrap();
    let mut read = vec![0; 101];
    storage.load(0, &mut read).unwrap();
    assert_eq!(read, one);
    storage.erase(0).unwrap();
    let mut read = vec![0; 149];
    storage.load(1, &mut read).unwrap();
    assert_eq!(read, other);
    storage.load(0, &mut read).unwrap();
    assert_eq!(read, [0xFF; 149], "as if nothing was ever stored");
    assert_eq!(storage.load(2, &mut read), Err(Abort::NoData), "neither an image nor an erased flash");
    assert_eq!(storage.save(3, &one), Err(Abort::OutOfMemory));
    assert_eq!(storage.save(0, &[0; 193]), Err(Abort::OutOfMemory));
}

/// Numbers that repeat.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
}

/// Whenever the power fails, a group has what was stored last or what was being stored, and never its defaults.
#[test]
fn a_power_failure_loses_nothing_that_was_stored() {
    const LENGTH: usize = 120;
    let mut random = Random(59);
    let mut storage = FlashStorage::new(Region::new(Ram::new(1024), 0, 1024).unwrap(), 2).unwrap();
    let mut stored = vec![7; LENGTH];
    storage.save(1, &stored).unwrap();
    let mut flash = storage.into_region().flash;
    let (mut old, mut new) = (0, 0);
    for _ in 0..10_000 {
        let is_erased = random.below(8) == 0;
        let image: Vec<u8> =
            (0..LENGTH).map(|_| if is_erased { 0xFF } else { random.below(256) as u8 }).collect();
        // an image changes 256 bytes to erase and 136 to write
        flash.power = random.below(400);
        let mut storage = FlashStorage::new(Region::new(flash, 0, 1024).unwrap(), 2).unwrap();
        let result = if is_erased { storage.erase(1) } else { storage.save(1, &image) };
        // power-on
        let mut kept = vec![0; LENGTH];
        storage.load(1, &mut kept).unwrap();
        assert!(kept == stored || kept == image, "power failed after {result:?}");
        assert!(result.is_err() || kept == image, "what was answered ok is stored");
        *(if kept == image { &mut new } else { &mut old }) += 1;
        (flash, stored) = (storage.into_region().flash, kept);
    }
    assert!(old > 5000 && new > 100, "{old} old images and {new} new ones");
}

mod stored {
    use super::*;

    include!(concat!(env!("OUT_DIR"), "/io_401_runtime.rs"));

    fn write<D: Dictionary, const T: usize, const R: usize, const N: usize>(
        node: &mut objdict_device::Node<D, 64, 1, R, T, N>,
        index: u16,
        sub: u8,
        value: &[u8],
    ) -> Result<(), Abort> {
        node.guard().write(index, sub, value)
    }

    /// 1010h stores, a reset gives back what was stored, 1011h the defaults from the next reset on; "reset communication" leaves the
    /// values of the application.
    #[test]
    fn values_are_stored_and_restored() {
        let region = Region::new(Ram::new(2048), 0, 2048).unwrap();
        let values = Stored::new(5, FlashStorage::new(region, 2).unwrap());
        let mut node: Node<64, 1, Stored<FlashStorage<Ram>>> = Node::new(5, values, pdos());
        node.boot(0);
        let output =
            |node: &mut Node<64, 1, Stored<FlashStorage<Ram>>>| node.dictionary.number(0x6202, 1).unwrap();
        let heartbeat =
            |node: &mut Node<64, 1, Stored<FlashStorage<Ram>>>| node.dictionary.number(0x1017, 0).unwrap();
        let (of_application, of_heartbeat) = (output(&mut node), heartbeat(&mut node));
        write(&mut node, 0x1017, 0, &[0x34, 0x12]).unwrap();
        write(&mut node, 0x6202, 1, &[0x55]).unwrap();
        assert_eq!(write(&mut node, 0x1010, 1, b"load"), Err(Abort::CannotStore));
        assert_eq!(write(&mut node, 0x1010, 1, b"save"), Ok(()));
        write(&mut node, 0x1017, 0, &[1, 0]).unwrap();
        write(&mut node, 0x6202, 1, &[0x66]).unwrap();
        node.receive(&Frame::new(0, &[130, 5]).unwrap(), 0);
        node.boot(0);
        assert_eq!((heartbeat(&mut node), output(&mut node)), (0x1234, 0x66));
        node.receive(&Frame::new(0, &[129, 5]).unwrap(), 0);
        node.boot(0);
        assert_eq!((heartbeat(&mut node), output(&mut node)), (0x1234, 0x55));

        // power-on
        let storage = node.dictionary.storage.clone();
        let mut node: Node<64, 1, Stored<FlashStorage<Ram>>> = Node::new(5, Stored::new(5, storage), pdos());
        node.boot(0);
        assert_eq!((heartbeat(&mut node), output(&mut node)), (0x1234, 0x55));
        assert_eq!(write(&mut node, 0x1011, 1, b"load"), Ok(()));
        assert_eq!(heartbeat(&mut node), 0x1234);
        node.receive(&Frame::new(0, &[129, 5]).unwrap(), 0);
        node.boot(0);
        assert_eq!((heartbeat(&mut node), output(&mut node)), (of_heartbeat, of_application));
    }

    /// An output that may not exceed 50, and how often it was written.
    #[derive(Clone, Default)]
    struct Valve(u32);

    impl Hooks<Data> for Valve {
        fn after_write(&mut self, data: &mut Data, change: Change<'_>) -> Result<(), Abort> {
            assert_eq!((change.index(), change.sub()), (0x6202, 1));
            self.0 += 1;
            let mut value = [0];
            data.read(0x6202, 1, &mut value)?;
            if value[0] > 50 { Err(Abort::InvalidValue) } else { Ok(()) }
        }
    }

    type Hooked = WatchedStored<FlashStorage<Ram>, Valve>;

    fn powered(node_id: u8, storage: FlashStorage<Ram>) -> Node<64, 1, Hooked> {
        let values = WatchedStored::new(Stored::new(node_id, storage), Valve::default());
        let mut node: Node<64, 1, Hooked> = Node::new(node_id, values, pdos());
        node.boot(0);
        node
    }

    fn storage() -> FlashStorage<Ram> {
        let mut flash = Ram::new(2048);
        flash.erase(0, 2048).unwrap();
        FlashStorage::new(Region::new(flash, 0, 2048).unwrap(), 2).unwrap()
    }

    /// Hooks are called, and what was stored survives resets and power-on.
    #[test]
    fn stored_values_have_hooks() {
        let mut first = powered(5, storage());
        assert_eq!(write(&mut first, 0x6202, 1, &[51]), Err(Abort::InvalidValue));
        assert_eq!(write(&mut first, 0x6202, 1, &[49]), Ok(()));
        assert_eq!(first.dictionary.hooks.0, 2);
        assert_eq!(write(&mut first, 0x1010, 1, b"save"), Ok(()));
        assert_eq!(write(&mut first, 0x6202, 1, &[7]), Ok(()));
        first.receive(&Frame::new(0, &[129, 5]).unwrap(), 0);
        first.boot(0);
        assert_eq!(first.dictionary.number(0x6202, 1), Ok(49), "after a reset");
        let mut second = powered(5, first.dictionary.data.storage.clone());
        assert_eq!(second.dictionary.number(0x6202, 1), Ok(49), "after power-on");
        assert_eq!((write(&mut second, 0x1011, 1, b"load"), second.dictionary.data.lost()), (Ok(()), None));
        second.receive(&Frame::new(0, &[129, 5]).unwrap(), 0);
        second.boot(0);
        assert_eq!(second.dictionary.number(0x6202, 1), Ok(0), "restored");
    }

    /// What was stored with its default follows the node-ID; what was stored with another value does not.
    #[test]
    fn stored_formulas_follow_the_node_id() {
        let mut stored = powered(5, storage());
        let cob_id = |node: &mut Node<64, 1, Hooked>, index| node.dictionary.number(index, 1).unwrap();
        write(&mut stored, 0x1801, 1, &0x8000_0285_u32.to_le_bytes()).unwrap();
        write(&mut stored, 0x1801, 1, &0x0000_0185_u32.to_le_bytes()).unwrap();
        write(&mut stored, 0x1010, 1, b"save").unwrap();
        let mut moved = powered(9, stored.dictionary.data.storage.clone());
        assert_eq!((cob_id(&mut moved, 0x1800), cob_id(&mut moved, 0x1801)), (0x189, 0x185));
        assert_eq!(moved.dictionary.number(0x1014, 0), Ok(0x89));
        // an LSS master gives another one
        moved.set_node_id(10);
        moved.boot(0);
        assert_eq!((cob_id(&mut moved, 0x1800), cob_id(&mut moved, 0x1801)), (0x18A, 0x185));
    }

    /// A damaged image is told, and the defaults are used.
    #[test]
    fn losses_are_told() {
        let mut stored = powered(5, storage());
        write(&mut stored, 0x6202, 1, &[49]).unwrap();
        write(&mut stored, 0x1010, 1, b"save").unwrap();
        let mut flash = stored.dictionary.data.storage.into_region().flash;
        flash.bytes[1024 + 64 + 7] ^= 1;
        let storage = FlashStorage::new(Region::new(flash, 0, 2048).unwrap(), 2).unwrap();
        let mut damaged = powered(5, storage);
        let loss = StorageLoss { group: 1, reason: LossReason::Memory(Abort::NoData) };
        assert_eq!(damaged.dictionary.data.lost(), Some(loss));
        assert_eq!(damaged.dictionary.number(0x6202, 1), Ok(0));
        assert_eq!(powered(5, self::storage()).dictionary.data.lost(), None, "nothing was ever stored");
    }
}

/// 1F50h to 1F57h of a device.
struct Objects;

impl Dictionary for Objects {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        let (size, data_type) = match (index, sub) {
            (0x1F50, 1) => (0, 0x0F),
            (0x1F51, 1) => (1, 5),
            (0x1F56 | 0x1F57, 1) => (4, 7),
            _ => return Err(Abort::NoObject),
        };
        let writable = index < 0x1F56;
        Ok(Attributes { size, data_type, readable: true, writable, fits_tpdo: false, fits_rpdo: false })
    }

    fn read(&mut self, _: u16, _: u8, _: &mut [u8]) -> Result<usize, Abort> {
        Err(Abort::NoObject)
    }

    fn write(&mut self, _: u16, _: u8, _: &[u8]) -> Result<(), Abort> {
        Err(Abort::ReadOnly)
    }

    fn replace(&mut self, _: u16, _: u8, _: &[u8]) -> Result<(), Abort> {
        Err(Abort::NoObject)
    }

    fn restart(&mut self, _: Scope, _: u8) {}
}

type Loader = Node<WithProgram<Objects, Ram>, 8, 1, 0, 0, 0>;

fn ask(node: &mut Loader, bytes: [u8; 8]) -> [u8; 8] {
    match node.receive(&Frame::new(0x605, &bytes).unwrap(), 0) {
        Received::Answer(answer) => answer.data().try_into().unwrap(),
        other => panic!("{other:?}"),
    }
}

/// Downloads a program in segments without a stated length, and returns the abort code.
fn download(node: &mut Loader, program: &[u8]) -> Option<u32> {
    let abort =
        |answer: [u8; 8]| (answer[0] == 0x80).then(|| u32::from_le_bytes(answer[4..].try_into().unwrap()));
    if let Some(code) = abort(ask(node, [0x20, 0x50, 0x1F, 1, 0, 0, 0, 0])) {
        return Some(code);
    }
    program.chunks(7).enumerate().find_map(|(number, part)| {
        let is_last = (number + 1) * 7 >= program.len();
        let mut bytes = [0; 8];
        bytes[0] = (number as u8 & 1) << 4 | (7 - part.len() as u8) << 1 | u8::from(is_last);
        bytes[1..=part.len()].copy_from_slice(part);
        abort(ask(node, bytes))
    })
}

/// A program of 2000 bytes is loaded by a node whose SDO buffer has eight.
#[test]
fn a_program_is_stopped_cleared_downloaded_and_started() {
    let region = Region::new(Ram::new(4096), 1024, 4096).unwrap();
    let mut node = Loader::new(5, WithProgram::new(Objects, region, 100), Pdos::new([], []));
    node.boot(0);
    let program: Vec<u8> = (0..2000).map(|at| (at % 253) as u8).collect();
    let control = |node: &mut Loader, command| node.guard().write(0x1F51, 1, &[command]);
    let number = |node: &mut Loader, index| node.dictionary.number(index, 1).unwrap();

    assert_eq!(number(&mut node, 0x1F51), 1);
    assert_eq!(control(&mut node, 3), Err(Abort::DeviceState), "it runs");
    assert_eq!(download(&mut node, &program), Some(0x0800_0022));
    assert_eq!(number(&mut node, 0x1F57), 4 << 1, "not cleared");
    assert_eq!(control(&mut node, 0), Ok(()));
    assert_eq!(node.dictionary.take_request(), Some(ProgramRequest::Stop));
    assert_eq!(control(&mut node, 3), Ok(()));
    assert_eq!(control(&mut node, 1), Err(Abort::DeviceState), "there is none");
    assert_eq!(number(&mut node, 0x1F57), 1 << 1, "no program");
    assert_eq!(download(&mut node, &program), None);
    assert_eq!(node.dictionary.state(), ProgramState::Stopped);
    assert_eq!(number(&mut node, 0x1F57), 0);
    assert_eq!(control(&mut node, 1), Ok(()));
    assert_eq!(node.dictionary.take_request(), Some(ProgramRequest::Start));
    assert_eq!(control(&mut node, 9), Err(Abort::InvalidValue));

    // it is found again at the next start, and has the same identification
    let mut kept = vec![0; 2000];
    node.dictionary.read_piece(0x1F50, 1, 0, &mut kept).unwrap();
    assert_eq!(kept, program);
    let identification = number(&mut node, 0x1F56);
    let region = node.dictionary.region().clone();
    let mut next = Loader::new(5, WithProgram::new(Objects, region, 2000), Pdos::new([], []));
    assert_eq!(number(&mut next, 0x1F56), identification);
    assert_ne!(identification, 0);
}

#[test]
fn a_program_that_does_not_fit_is_refused() {
    let region = Region::new(Ram::new(512), 0, 512).unwrap();
    let mut node = Loader::new(5, WithProgram::new(Objects, region, 0), Pdos::new([], []));
    node.boot(0);
    node.guard().write(0x1F51, 1, &[3]).unwrap();
    // stated: at its beginning
    let answer = ask(&mut node, [0x21, 0x50, 0x1F, 1, 0x01, 0x02, 0, 0]);
    assert_eq!(answer, [0x80, 0x50, 0x1F, 1, 0x05, 0, 0x04, 0x05]);
    assert_eq!(download(&mut node, &[0; 513]), Some(0x0504_0005));
    assert_eq!(node.dictionary.state(), ProgramState::Partial);
    assert_eq!(download(&mut node, &[0; 512]), Some(0x0800_0022), "it has to be cleared");
    node.guard().write(0x1F51, 1, &[3]).unwrap();
    assert_eq!(download(&mut node, &[0; 512]), None);
}
