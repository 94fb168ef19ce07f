//! Values with the hooks of the application.

use crate::dictionary::{Place, Scope, entry_at, forward};
use crate::services::{RESTORE, STORE};
use crate::table::{Data, Entry, Handle, Hooked, Hooks, Typed, Variable};
use crate::{Abort, Attributes, Dictionary, Grouped, ObjectSet, Storage, Stored};

/// Values that can call hooks: [`Data`], with or without storage.
pub trait Watchable<H>: Dictionary {
    /// The table of the values.
    type Table: Hooked;

    /// Calls the hook before an entry is read, if there is one.
    ///
    /// # Errors
    /// The error that the hook returned.
    fn before_read(&mut self, hooks: &mut H, entry: &Entry<Self::Table>) -> Result<(), Abort>;

    /// Like [`Dictionary::write`], with hooks.
    ///
    /// # Errors
    /// The reason why the value is not valid, or the error of the hook; the value is unchanged.
    fn write_with(&mut self, hooks: &mut H, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;

    /// Sets a value as an SDO does; access does not matter.
    ///
    /// # Errors
    /// Like [`Watchable::write_with`].
    fn set_with<T: Typed + ?Sized, A: Variable>(
        &mut self,
        hooks: &mut H,
        handle: Handle<Self::Table, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort>;
}

impl<D: Hooked, H: Hooks<Self>, const RAM: usize> Watchable<H> for Data<D, RAM> {
    type Table = D;

    fn before_read(&mut self, hooks: &mut H, entry: &Entry<D>) -> Result<(), Abort> {
        let calls = entry.is_hooked() && entry.is_readable();
        if calls { hooks.before_read(self, entry.index(), entry.sub()) } else { Ok(()) }
    }

    fn write_with(&mut self, hooks: &mut H, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.write_with(hooks, index, sub, bytes)
    }

    fn set_with<T: Typed + ?Sized, A: Variable>(
        &mut self,
        hooks: &mut H,
        handle: Handle<D, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        self.set_with(hooks, handle, value)
    }
}

impl<D: Hooked + Grouped, S: Storage, H: Hooks<Data<D, RAM>>, const RAM: usize, const IMAGE: usize>
    Watchable<H> for Stored<Data<D, RAM>, S, IMAGE>
{
    type Table = D;

    fn before_read(&mut self, hooks: &mut H, entry: &Entry<D>) -> Result<(), Abort> {
        self.data.before_read(hooks, entry)
    }

    fn write_with(&mut self, hooks: &mut H, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.data.write_with(hooks, index, sub, bytes)
    }

    fn set_with<T: Typed + ?Sized, A: Variable>(
        &mut self,
        hooks: &mut H,
        handle: Handle<D, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        self.data.set_with(hooks, handle, value)
    }
}

/// The values of a device with the hooks of its application, which are called for SDOs, RPDOs and [`Watched::set`], and
/// a flag for each entry that was written. `FLAGS` is one byte per eight entries; the generated file contains a type
/// with it.
#[derive(Clone, Debug)]
pub struct Watched<V, H, const FLAGS: usize> {
    /// The values. Direct writes to them call no hook and set no flag.
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

impl<V: Watchable<H>, H, const FLAGS: usize> Watched<V, H, FLAGS> {
    /// Sets a value as an SDO does, hooks and limits included; access does not matter.
    ///
    /// # Errors
    /// The reason why the value is not valid, or the error of a hook; the value is unchanged.
    pub fn set<T: Typed + ?Sized, A: Variable>(
        &mut self,
        handle: Handle<V::Table, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        self.data.set_with(&mut self.hooks, handle, value)?;
        self.raise(handle.entry());
        Ok(())
    }

    /// Whether the entry was written since the last call.
    pub fn take_changed(&mut self, entry: &Entry<V::Table>) -> bool {
        let Some((byte, bit)) = self.flag(entry) else { return false };
        let was_changed = *byte & bit != 0;
        *byte &= !bit;
        was_changed
    }

    fn raise(&mut self, entry: &Entry<V::Table>) {
        if let Some((byte, bit)) = self.flag(entry) {
            *byte |= bit;
        }
    }

    fn flag(&mut self, entry: &Entry<V::Table>) -> Option<(&mut u8, u8)> {
        let row = entry.row()?;
        Some((self.changed.get_mut(row / 8)?, 1 << (row % 8)))
    }

    /// Whether a hook executes the command in an entry of 1010h or 1011h.
    fn is_command_hooked(index: u16, sub: u8) -> bool {
        Entry::<V::Table>::find(index, sub).is_ok_and(Entry::is_hooked)
    }
}

/// Implements storage with the underlying dictionary; without storage, a hook of 1010h or 1011h does it, and
/// is called with the signature as the value.
impl<V: Watchable<H>, H, const FLAGS: usize> Dictionary for Watched<V, H, FLAGS> {
    forward! { data:
        fn attributes(self: &Self, index: u16, sub: u8) -> Result<Attributes, Abort>;
        fn serves_more(self: &Self) -> bool;
        fn own_node_id(self: &Self) -> Option<u8>;
        fn objects(self: &Self) -> ObjectSet;
        fn replace(self: &mut Self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;
        fn restart(self: &mut Self, scope: Scope, node_id: u8);
        fn locate(self: &Self, index: u16, sub: u8) -> Result<Place, Abort>;
        fn attributes_at(self: &Self, place: Place) -> Result<Attributes, Abort>;
        fn begin_write(self: &mut Self, index: u16, sub: u8, length: Option<usize>) -> Result<bool, Abort>;
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        self.data.before_read(&mut self.hooks, Entry::find(index, sub)?)?;
        self.data.read(index, sub, buffer)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.data.write_with(&mut self.hooks, index, sub, bytes)?;
        self.raise(Entry::find(index, sub)?);
        Ok(())
    }

    fn number_at(&mut self, place: Place) -> Result<u64, Abort> {
        self.data.before_read(&mut self.hooks, entry_at(place)?)?;
        self.data.number_at(place)
    }

    fn write_at(&mut self, place: Place, bytes: &[u8]) -> Result<(), Abort> {
        let entry = entry_at::<V::Table>(place)?;
        self.write(entry.index(), entry.sub(), bytes)
    }

    fn can_store(&self, sub: u8) -> bool {
        self.data.can_store(sub) || Self::is_command_hooked(STORE, sub)
    }

    fn store(&mut self, sub: u8) -> Result<(), Abort> {
        if !self.data.can_store(sub) && Self::is_command_hooked(STORE, sub) {
            return self.write(STORE, sub, b"save");
        }
        self.data.store(sub)
    }

    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        if !self.data.can_store(sub) && Self::is_command_hooked(RESTORE, sub) {
            return self.write(RESTORE, sub, b"load");
        }
        self.data.restore(sub)
    }
}
