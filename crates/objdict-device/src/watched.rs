//! Values with the hooks of the application.

use crate::dictionary::{Place, Scope, entry_at, forward};
use crate::services::{RESTORE, STORE};
use crate::table::{Data, Entry, Handle, Hooked, Hooks, Typed, Variable};
use crate::{Abort, Attributes, Dictionary};

/// The values of a device with the hooks of its application, which are called for SDOs, RPDOs and [`Watched::set`] alike, and a flag
/// for each entry that was written. `FLAGS` is a byte for every eight entries; the generated file has a type with it.
#[derive(Clone, Debug)]
pub struct Watched<V, H, const FLAGS: usize> {
    /// The values. What is written to them directly calls no hook and raises no flag.
    pub data: V,
    /// The hooks.
    pub hooks: H,
    changed: [u8; FLAGS],
}

impl<V, H, const FLAGS: usize> Watched<V, H, FLAGS> {
    /// Values with hooks and no flag.
    #[must_use]
    pub const fn new(data: V, hooks: H) -> Self {
        Self { data, hooks, changed: [0; FLAGS] }
    }
}

impl<D: Hooked, H: Hooks<Data<D, RAM>>, const RAM: usize, const FLAGS: usize>
    Watched<Data<D, RAM>, H, FLAGS>
{
    /// Sets a value as an SDO does, hooks and limits included; access does not matter.
    ///
    /// # Errors
    /// Why the value is not valid, or what a hook answered; the value is unchanged.
    pub fn set<T: Typed + ?Sized, A: Variable>(
        &mut self,
        handle: Handle<D, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        self.data.set_with(&mut self.hooks, handle, value)?;
        self.raise(handle.entry());
        Ok(())
    }

    /// Whether the entry was written since the last call.
    pub fn take_changed(&mut self, entry: &Entry<D>) -> bool {
        let Some((byte, bit)) = self.flag(entry) else { return false };
        let was_changed = *byte & bit != 0;
        *byte &= !bit;
        was_changed
    }

    fn raise(&mut self, entry: &Entry<D>) {
        if let Some((byte, bit)) = self.flag(entry) {
            *byte |= bit;
        }
    }

    fn flag(&mut self, entry: &Entry<D>) -> Option<(&mut u8, u8)> {
        let row = entry.row()?;
        Some((self.changed.get_mut(row / 8)?, 1 << (row % 8)))
    }
}

impl<D: Hooked, H: Hooks<Data<D, RAM>>, const RAM: usize, const FLAGS: usize> Dictionary
    for Watched<Data<D, RAM>, H, FLAGS>
{
    forward! { data:
        fn attributes(self: &Self, index: u16, sub: u8) -> Result<Attributes, Abort>;
        fn replace(self: &mut Self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;
        fn restart(self: &mut Self, scope: Scope, node_id: u8);
        fn locate(self: &Self, index: u16, sub: u8) -> Result<Place, Abort>;
        fn attributes_at(self: &Self, place: Place) -> Result<Attributes, Abort>;
        fn begin_write(self: &mut Self, index: u16, sub: u8, length: Option<usize>) -> Result<bool, Abort>;
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        self.data.read_with(&mut self.hooks, index, sub, buffer)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.data.write_with(&mut self.hooks, index, sub, bytes)?;
        self.raise(Entry::find(index, sub)?);
        Ok(())
    }

    fn number_at(&mut self, place: Place) -> Result<u64, Abort> {
        let entry = entry_at::<D>(place)?;
        if entry.is_hooked() && entry.is_readable() {
            self.hooks.before_read(&mut self.data, entry.index(), entry.sub())?;
        }
        self.data.number_at(place)
    }

    fn write_at(&mut self, place: Place, bytes: &[u8]) -> Result<(), Abort> {
        let entry = entry_at::<D>(place)?;
        self.write(entry.index(), entry.sub(), bytes)
    }

    fn can_store(&self, sub: u8) -> bool {
        Entry::<D>::find(STORE, sub).is_ok_and(Entry::is_hooked)
    }

    fn store(&mut self, sub: u8) -> Result<(), Abort> {
        if self.can_store(sub) { self.write(STORE, sub, b"save") } else { Err(Abort::CannotStore) }
    }

    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        let is_hooked = Entry::<D>::find(RESTORE, sub).is_ok_and(Entry::is_hooked);
        if is_hooked { self.write(RESTORE, sub, b"load") } else { Err(Abort::CannotStore) }
    }
}
