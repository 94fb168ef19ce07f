//! Storage groups of any size, for a storage that has several.

use core::ops::Range;

use super::stored::{Group, ImageError, check, members, save};
use super::{Data, Table, part};

/// A storage group whose size is not part of its type.
#[derive(Clone, Copy, Debug)]
pub struct AnyGroup<D> {
    first: usize,
    image_size: usize,
    layout: u32,
    store_sub_index: Option<u8>,
    table: core::marker::PhantomData<fn() -> D>,
}

impl<D: Table> AnyGroup<D> {
    /// Size of an image in bytes.
    #[must_use]
    pub const fn image_size(&self) -> usize {
        self.image_size
    }

    /// Whether a sub-index of 1010h and 1011h is about the group: 1 is about all.
    #[must_use]
    pub fn is_of(&self, sub: u8) -> bool {
        sub == 1 || self.store_sub_index == Some(sub)
    }

    const fn places(&self) -> Range<usize> {
        self.first..self.first + self.image_size - 6
    }
}

impl<D: Table, const IMAGE: usize> Group<D, IMAGE> {
    /// The group without the size in its type.
    #[must_use]
    pub const fn any(self) -> AnyGroup<D> {
        AnyGroup {
            first: self.first as usize,
            image_size: IMAGE,
            layout: self.layout,
            store_sub_index: self.store_sub_index(),
            table: core::marker::PhantomData,
        }
    }
}

impl<D: Table, const RAM: usize> Data<D, RAM> {
    /// Writes the values of a group to an image, which has the size of the group.
    pub fn save_image(&self, group: &AnyGroup<D>, image: &mut [u8]) {
        save(self.bytes.get(group.places()).unwrap_or_default(), group.layout, image);
    }

    /// Reads the values of some objects of a group from an image without checking limits. A value that was the default for the
    /// node-ID `saved_by` is the default for the present node-ID afterwards.
    ///
    /// # Errors
    /// The reason why the image is not valid; no value changes.
    pub fn load_image(
        &mut self,
        group: &AnyGroup<D>,
        image: &[u8],
        saved_by: Option<u8>,
        is_loaded: impl Fn(u16) -> bool,
    ) -> Result<(), ImageError> {
        self.take(group.places(), check(image, group.image_size, group.layout)?, &is_loaded)?;
        let Some(saved_by) = saved_by.filter(|&node_id| node_id != self.node_id()) else { return Ok(()) };
        for entry in members::<D>(group.places()).filter(|entry| entry.adds_node_id()) {
            let default = entry.default_number(saved_by).to_le_bytes();
            if is_loaded(entry.index()) && self.value(entry) == Some(part(&default, 0, entry.size())) {
                self.set_default(entry);
            }
        }
        Ok(())
    }
}
