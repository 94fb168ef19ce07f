use super::{Abort, Data, Entry, Handle, Table, Typed, Variable, copy};

/// Hooks of the application for the entries selected with `--hook`; `V` is [`Data`].
pub trait Hooks<V> {
    /// Called before such an entry is read; may change its value.
    ///
    /// # Errors
    /// The code to abort the upload with.
    fn before_read(&mut self, data: &mut V, index: u16, sub: u8) -> Result<(), Abort> {
        let _ = (data, index, sub);
        Ok(())
    }

    /// Called after such an entry was written; `data` has its new value.
    ///
    /// # Errors
    /// The code to abort the download with: the old value is restored; other changes of
    /// the hook remain.
    fn after_write(&mut self, data: &mut V, change: Change<'_>) -> Result<(), Abort> {
        let _ = (data, change);
        Ok(())
    }
}

/// A write, for [`Hooks::after_write`].
#[derive(Clone, Copy, Debug)]
pub struct Change<'a> {
    index: u16,
    sub: u8,
    old: &'a [u8],
}

impl<'a> Change<'a> {
    /// The index of the entry.
    #[must_use]
    pub const fn index(self) -> u16 {
        self.index
    }

    /// The sub-index of the entry.
    #[must_use]
    pub const fn sub(self) -> u8 {
        self.sub
    }

    /// The value before, if this is the entry that was written.
    #[must_use]
    pub fn old<D: Table, T: Typed + ?Sized, A>(self, handle: Handle<D, T, A>) -> Option<T::Value<'a>> {
        let is_this = self.index == handle.index() && self.sub == handle.sub();
        is_this.then(|| T::load(self.old))
    }
}

/// A table with hooks.
pub trait Hooked: Table {
    /// Room for the longest value that [`Hooks::after_write`] may reject.
    type Room: AsMut<[u8]>;
    /// The room without a value.
    const ROOM: Self::Room;
}

impl<D: Hooked, const RAM: usize> Data<D, RAM> {
    /// Like [`Data::read`], with hooks.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read_with(
        &mut self,
        hooks: &mut (impl Hooks<Self> + ?Sized),
        index: u16,
        sub: u8,
        buffer: &mut [u8],
    ) -> Result<usize, Abort> {
        let entry = Entry::<D>::find(index, sub)?;
        if entry.is_hooked() && entry.is_readable() {
            hooks.before_read(self, index, sub)?;
        }
        self.read(index, sub, buffer)
    }

    /// Like [`Data::write`], with hooks.
    ///
    /// # Errors
    /// The code to abort the download with; the value is unchanged.
    pub fn write_with(
        &mut self,
        hooks: &mut (impl Hooks<Self> + ?Sized),
        index: u16,
        sub: u8,
        bytes: &[u8],
    ) -> Result<(), Abort> {
        let entry = Entry::find(index, sub)?;
        if entry.is_writable() { self.write_entry_with(hooks, entry, bytes) } else { Err(Abort::ReadOnly) }
    }

    /// Like [`Data::set`], with hooks.
    ///
    /// # Errors
    /// The reason why the value is not valid, or the error of the hook; the value is unchanged.
    pub fn set_with<T: Typed + ?Sized, A: Variable>(
        &mut self,
        hooks: &mut (impl Hooks<Self> + ?Sized),
        handle: Handle<D, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        if !T::fits(value, handle.size()) {
            return Err(Abort::InvalidValue);
        }
        T::with_bytes(value, handle.size(), |bytes| self.write_entry_with(hooks, handle.entry(), bytes))
    }

    fn write_entry_with(
        &mut self,
        hooks: &mut (impl Hooks<Self> + ?Sized),
        entry: &Entry<D>,
        bytes: &[u8],
    ) -> Result<(), Abort> {
        if !entry.is_hooked() {
            return self.write_entry(entry, bytes);
        }
        let mut room = D::ROOM;
        let old = self.value(entry).and_then(|value| {
            let place = room.as_mut().get_mut(..value.len())?;
            copy(place, value);
            Some(&*place)
        });
        self.write_entry(entry, bytes)?;
        let change = Change { index: entry.index(), sub: entry.sub(), old: old.unwrap_or(&[]) };
        let answer = hooks.after_write(self, change);
        if let (Err(_), Some(old)) = (answer, old) {
            self.keep(entry, old);
        }
        answer
    }
}
