use super::{Abort, Data, Entry, Table};

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

    /// Called after such an entry was written; the entry has its new value.
    ///
    /// # Errors
    /// The code to abort the download with: the old value is restored; other changes of
    /// the hook remain.
    fn after_write(&mut self, data: &mut V, index: u16, sub: u8) -> Result<(), Abort> {
        let _ = (data, index, sub);
        Ok(())
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
        if !entry.is_hooked() {
            return self.write(index, sub, bytes);
        }
        let mut room = D::ROOM;
        let old = self.value(entry).and_then(|value| {
            let place = room.as_mut().get_mut(..value.len())?;
            place.copy_from_slice(value);
            Some(&*place)
        });
        self.write(index, sub, bytes)?;
        let answer = hooks.after_write(self, index, sub);
        if let (Err(_), Some(old)) = (answer, old) {
            self.keep(entry, old);
        }
        answer
    }
}
