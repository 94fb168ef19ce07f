//! Values that are stored on command (1010h, 1011h).

use crate::dictionary::{Place, Scope, forward};
use crate::table::{AnyGroup, Data, ImageError, Table};
use crate::{Abort, Attributes, Dictionary, ObjectSet};

/// A table with storage groups. The generated file implements it.
pub trait Grouped: Table {
    /// The groups.
    const GROUPS: &'static [AnyGroup<Self>];
}

/// Non-volatile memory for the images of storage groups. Groups are numbered from 0 in the order of
/// [`Grouped::GROUPS`].
pub trait Storage {
    /// Stores the image of a group, replacing the previous one.
    ///
    /// # Errors
    /// The reason why the image is not stored, such as [`Abort::Hardware`].
    fn save(&mut self, group: usize, image: &[u8]) -> Result<(), Abort>;

    /// Copies the image of a group. If none was ever stored, or it was erased, all bytes are equal, such as
    /// FFh.
    ///
    /// # Errors
    /// Why it cannot be read: [`Stored::lost`] has it.
    fn load(&mut self, group: usize, image: &mut [u8]) -> Result<(), Abort>;

    /// Forgets the image of a group.
    ///
    /// # Errors
    /// Why it is still kept.
    fn erase(&mut self, group: usize) -> Result<(), Abort>;
}

/// Stored values that could not be read, so that the defaults are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StorageLoss {
    /// The number of the storage group.
    pub group: usize,
    /// Why.
    pub reason: LossReason,
}

/// Why stored values could not be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LossReason {
    /// The memory cannot be read, or contains no valid image, possibly because it was never completely
    /// written.
    Memory(Abort),
    /// The image is corrupted, or belongs to a different table.
    Image(ImageError),
}

/// The bytes after an image: the node-ID for which its values were stored, and its complement. Images of
/// version 0.1 have neither.
const TRAILER: usize = 2;

/// The values of a device with storage: they start with the stored values, 1010h stores them, and 1011h restores the
/// defaults at the next reset. A value with `$NODEID` that was stored with its default follows the node-ID. `IMAGE` is
/// the size of the largest image plus two bytes for the node-ID; the generated file contains a type with it.
#[derive(Clone, Debug)]
pub struct Stored<V, S, const IMAGE: usize> {
    /// The values.
    pub data: V,
    /// The memory.
    pub storage: S,
    lost: Option<StorageLoss>,
}

impl<V, S, const IMAGE: usize> Stored<V, S, IMAGE> {
    /// The first group whose stored values could not be read, at power-on and at later resets; an application reports
    /// it as the error [`DATA_SET`](crate::error_code::DATA_SET).
    #[must_use]
    pub const fn lost(&self) -> Option<StorageLoss> {
        self.lost
    }
}

impl<D: Grouped, S: Storage, const RAM: usize, const IMAGE: usize> Stored<Data<D, RAM>, S, IMAGE> {
    /// The values at power-on: the stored ones, otherwise the defaults for a node-ID.
    pub fn new(node_id: u8, storage: S) -> Self {
        let mut stored = Self { data: Data::new(node_id), storage, lost: None };
        stored.load(Scope::All);
        stored
    }

    fn load(&mut self, scope: Scope) {
        for (number, group) in D::GROUPS.iter().enumerate() {
            if let Err(reason) = self.load_group(number, group, scope) {
                self.lost.get_or_insert(StorageLoss { group: number, reason });
            }
        }
    }

    fn load_group(&mut self, number: usize, group: &AnyGroup<D>, scope: Scope) -> Result<(), LossReason> {
        let mut kept = [0; IMAGE];
        let kept = kept.get_mut(..group.image_size() + TRAILER).unwrap_or_default();
        self.storage.load(number, kept).map_err(LossReason::Memory)?;
        if kept.iter().all(|byte| kept.first() == Some(byte)) {
            return Ok(());
        }
        let Some((image, &mut [node_id, complement])) = kept.split_last_chunk_mut() else { return Ok(()) };
        let saved_by = (complement == !node_id).then_some(node_id);
        let loaded = self.data.load_image(group, image, saved_by, |index| scope.contains(index));
        loaded.map_err(LossReason::Image)
    }

    fn save_group(&mut self, number: usize, group: &AnyGroup<D>) -> Result<(), Abort> {
        let mut kept = [0; IMAGE];
        let kept = kept.get_mut(..group.image_size() + TRAILER).ok_or(Abort::OutOfMemory)?;
        if let Some((image, trailer)) = kept.split_last_chunk_mut() {
            self.data.save_image(group, image);
            let node_id = self.data.node_id();
            *trailer = [node_id, !node_id];
        }
        self.storage.save(number, kept)
    }

    /// Calls a function for each group that a sub-index of 1010h or 1011h selects.
    fn each_group(
        &mut self,
        sub: u8,
        mut each: impl FnMut(&mut Self, usize, &AnyGroup<D>) -> Result<(), Abort>,
    ) -> Result<(), Abort> {
        let mut answer = Err(Abort::CannotStore);
        for (number, group) in D::GROUPS.iter().enumerate().filter(|(_, group)| group.is_of(sub)) {
            answer = each(self, number, group);
            answer?;
        }
        answer
    }
}

impl<D: Grouped, S: Storage, const RAM: usize, const IMAGE: usize> Dictionary
    for Stored<Data<D, RAM>, S, IMAGE>
{
    forward! { data:
        fn attributes(self: &Self, index: u16, sub: u8) -> Result<Attributes, Abort>;
        fn read(self: &mut Self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort>;
        fn write(self: &mut Self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;
        fn serves_more(self: &Self) -> bool;
        fn own_node_id(self: &Self) -> Option<u8>;
        fn objects(self: &Self) -> ObjectSet;
        fn replace(self: &mut Self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;
        fn locate(self: &Self, index: u16, sub: u8) -> Result<Place, Abort>;
        fn attributes_at(self: &Self, place: Place) -> Result<Attributes, Abort>;
        fn number_at(self: &mut Self, place: Place) -> Result<u64, Abort>;
        fn write_at(self: &mut Self, place: Place, bytes: &[u8]) -> Result<(), Abort>;
        fn begin_read(self: &mut Self, index: u16, sub: u8) -> Result<Option<usize>, Abort>;
        fn read_piece(self: &mut Self, index: u16, sub: u8, offset: usize, piece: &mut [u8]) -> Result<(), Abort>;
        fn begin_write(self: &mut Self, index: u16, sub: u8, length: Option<usize>) -> Result<bool, Abort>;
        fn write_piece(self: &mut Self, index: u16, sub: u8, offset: usize, piece: &[u8]) -> Result<(), Abort>;
        fn end_write(self: &mut Self, index: u16, sub: u8, length: usize) -> Result<(), Abort>;
    }

    fn restart(&mut self, scope: Scope, node_id: u8) {
        self.data.restart(scope, node_id);
        self.load(scope);
    }

    fn can_store(&self, sub: u8) -> bool {
        D::GROUPS.iter().any(|group| group.is_of(sub))
    }

    fn store(&mut self, sub: u8) -> Result<(), Abort> {
        self.each_group(sub, Self::save_group)
    }

    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        self.each_group(sub, |stored, number, _| stored.storage.erase(number))
    }
}
