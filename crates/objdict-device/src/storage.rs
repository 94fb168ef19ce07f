//! Values that are stored on command (1010h, 1011h).

use crate::dictionary::{Place, Scope, forward};
use crate::table::{AnyGroup, Data, Table};
use crate::{Abort, Attributes, Dictionary};

/// A table with storage groups. The generated file implements it.
pub trait Grouped: Table {
    /// The groups.
    const GROUPS: &'static [AnyGroup<Self>];
}

/// Memory that keeps the images of storage groups without power. Groups are numbered from 0 on in the order of [`Grouped::GROUPS`].
pub trait Storage {
    /// Keeps the image of a group in place of an older one.
    ///
    /// # Errors
    /// Why the image is not kept, such as [`Abort::Hardware`].
    fn save(&mut self, group: usize, image: &[u8]) -> Result<(), Abort>;

    /// Copies the image of a group; what was never kept may be any bytes.
    ///
    /// # Errors
    /// Why it cannot be read.
    fn load(&mut self, group: usize, image: &mut [u8]) -> Result<(), Abort>;

    /// Forgets the image of a group.
    ///
    /// # Errors
    /// Why it is still kept.
    fn erase(&mut self, group: usize) -> Result<(), Abort>;
}

/// The values of a device with storage: they begin with what was stored, 1010h stores them, and after 1011h they are the defaults from
/// the next reset on. `IMAGE` is the size of the largest image; the generated file has a type with it.
#[derive(Clone, Debug)]
pub struct Stored<V, S, const IMAGE: usize> {
    /// The values.
    pub data: V,
    /// The memory.
    pub storage: S,
}

impl<D: Grouped, S: Storage, const RAM: usize, const IMAGE: usize> Stored<Data<D, RAM>, S, IMAGE> {
    /// The values at power-on: those that were stored, else the defaults for a node-ID.
    pub fn new(node_id: u8, storage: S) -> Self {
        let mut stored = Self { data: Data::new(node_id), storage };
        stored.load(Scope::All);
        stored
    }

    fn load(&mut self, scope: Scope) {
        for (number, group) in D::GROUPS.iter().enumerate() {
            let mut image = [0; IMAGE];
            let Some(image) = image.get_mut(..group.image_size()) else { continue };
            if self.storage.load(number, image).is_ok() {
                // what was never stored, or by another version, has another layout: the defaults stay
                let _ = self.data.load_image(group, image, |index| scope.contains(index));
            }
        }
    }

    /// Does something with each group that a sub-index of 1010h and 1011h is about.
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
        self.each_group(sub, |stored, number, group| {
            let mut image = [0; IMAGE];
            let image = image.get_mut(..group.image_size()).ok_or(Abort::OutOfMemory)?;
            stored.data.save_image(group, image);
            stored.storage.save(number, image)
        })
    }

    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        self.each_group(sub, |stored, number, _| stored.storage.erase(number))
    }
}
