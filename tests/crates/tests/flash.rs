//! Storage and programs of `objdict-device` in a flash, by way of `embedded-storage`.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};
use objdict_device::{
    Abort, Attributes, Dictionary, FlashStorage, Frame, Node, Pdos, ProgramRequest, ProgramState,
};
use objdict_device::{Received, Region, Scope, Storage, WithProgram};

/// A flash in RAM: what is written must have been erased, in whole units.
#[derive(Clone)]
struct Ram {
    bytes: Vec<u8>,
}

impl Ram {
    fn new(size: usize) -> Self {
        Self { bytes: vec![0xAA; size] }
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
        self.bytes[from as usize..to as usize].fill(0xFF);
        Ok(())
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Misuse> {
        let offset = offset as usize;
        assert_eq!((offset % 8, bytes.len() % 8), (0, 0), "whole units");
        let place = &mut self.bytes[offset..offset + bytes.len()];
        assert!(place.iter().all(|&byte| byte == 0xFF), "erased");
        place.copy_from_slice(bytes);
        Ok(())
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
    assert!(FlashStorage::new(region.clone(), 0).is_none() && FlashStorage::new(region.clone(), 7).is_none());
    let mut storage = FlashStorage::new(region, 2).unwrap();
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
    assert_eq!(storage.save(2, &one), Err(Abort::OutOfMemory));
    assert_eq!(storage.save(0, &[0; 769]), Err(Abort::OutOfMemory));
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
