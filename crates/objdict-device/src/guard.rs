//! The dictionary as SDO servers have it.
//!
//! A filter for SDO writes. It asks `rules` to reject values that no service supports, and passes the others on
//! to the services.

use crate::dictionary::{Dictionary, Scope, forward, number};
use crate::services::{RESTORE, STORE, Services};
use crate::{Abort, Attributes, ObjectSet, errors, rules};

/// A dictionary that rejects invalid values of communication objects, and whose services apply each write; see
/// [`Pdos::guard`](crate::Pdos::guard) and [`Node::guard`](crate::Node::guard).
#[derive(Debug)]
pub struct Guarded<'a, D: ?Sized, S> {
    pub(crate) dictionary: &'a mut D,
    pub(crate) services: S,
}

/// Date and time of the configuration in sub-indexes 1 and 2, with which a manager recognises it.
const CONFIGURATION: u16 = 0x1020;

impl<D: Dictionary + ?Sized, S: Services> Guarded<'_, D, S> {
    /// Whether an entry of 1010h or 1011h executes a command when a signature is written; if so, it has no
    /// stored value.
    fn is_command(&self, index: u16, sub: u8) -> bool {
        let objects = self.dictionary.objects();
        (objects.has(STORE) || objects.has(RESTORE)) && matches!(index, STORE | RESTORE) && sub > 0
    }

    /// Clears the date of the configuration, which has changed (CiA 301 §7.5.2.23).
    fn forget_configuration(&mut self, index: u16) {
        if self.dictionary.objects().has(CONFIGURATION) && index != CONFIGURATION {
            for sub in 1..=2 {
                // a device without 1020h has nothing to clear
                let _ = self.dictionary.replace(CONFIGURATION, sub, &[0; 4]);
            }
        }
    }
}

impl<D: Dictionary + ?Sized, S: Services> Dictionary for Guarded<'_, D, S> {
    forward! { dictionary:
        fn attributes(self: &Self, index: u16, sub: u8) -> Result<Attributes, Abort>;
        fn own_node_id(self: &Self) -> Option<u8>;
        fn objects(self: &Self) -> ObjectSet;
        fn replace(self: &mut Self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;
        fn restart(self: &mut Self, scope: Scope, node_id: u8);
        fn begin_read(self: &mut Self, index: u16, sub: u8) -> Result<Option<usize>, Abort>;
        fn read_piece(self: &mut Self, index: u16, sub: u8, offset: usize, piece: &mut [u8]) -> Result<(), Abort>;
        fn write_piece(self: &mut Self, index: u16, sub: u8, offset: usize, piece: &[u8]) -> Result<(), Abort>;
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        // reading returns the capabilities of the device
        if self.is_command(index, sub)
            && self.attributes(index, sub)?.readable
            && !self.dictionary.can_store(sub)
        {
            let Some(room) = buffer.first_chunk_mut::<4>() else { return Err(Abort::OutOfMemory) };
            *room = [0; 4];
            return Ok(4);
        }
        let is_empty = |count| count < u64::from(sub);
        let has_history = self.dictionary.objects().has(errors::HISTORY);
        if has_history
            && index == errors::HISTORY
            && sub > 0
            && self.dictionary.number(index, 0).is_ok_and(is_empty)
        {
            self.attributes(index, sub)?;
            return Err(Abort::NoData);
        }
        self.dictionary.read(index, sub, buffer)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let entry = self.dictionary.attributes(index, sub)?;
        let has_date = self.dictionary.objects().has(CONFIGURATION);
        let mut stays = false;
        // the dictionary itself reports why it rejects other values
        if entry.writable && bytes.len() == entry.size && bytes.len() <= 8 {
            let number = number(bytes);
            rules::check::<_, S>(self.dictionary, index, sub, number)?;
            if self.is_command(index, sub) {
                return if index == STORE {
                    self.dictionary.store(sub)
                } else {
                    self.dictionary.restore(sub)
                };
            }
            stays = has_date && self.dictionary.number(index, sub) == Ok(number);
        }
        self.dictionary.write(index, sub, bytes)?;
        if !stays {
            self.forget_configuration(index);
        }
        self.services.follow(self.dictionary, index, sub);
        Ok(())
    }

    fn begin_write(&mut self, index: u16, sub: u8, length: Option<usize>) -> Result<bool, Abort> {
        // signatures are not stored
        if self.is_command(index, sub) { Ok(false) } else { self.dictionary.begin_write(index, sub, length) }
    }

    fn end_write(&mut self, index: u16, sub: u8, length: usize) -> Result<(), Abort> {
        self.dictionary.end_write(index, sub, length)?;
        self.forget_configuration(index);
        self.services.follow(self.dictionary, index, sub);
        Ok(())
    }
}
