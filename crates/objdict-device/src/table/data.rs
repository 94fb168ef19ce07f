use super::{Abort, Entry, Handle, Table, Time, Typed, Variable, part};

/// The values that can change; constants are in flash.
///
/// They are in one byte array in SDO encoding; a string follows its length. The first byte is the node-ID.
#[derive(Clone, Debug, PartialEq)]
pub struct Data<D, const RAM: usize> {
    pub(super) bytes: [u8; RAM],
    table: core::marker::PhantomData<fn() -> D>,
}

impl<D: Table, const RAM: usize> Data<D, RAM> {
    /// The defaults for `node_id`, 1 to 127; only the lower seven bits are used.
    #[must_use]
    pub const fn new(node_id: u8) -> Self {
        let mut data = Self { bytes: [0; RAM], table: core::marker::PhantomData };
        copy(&mut data.bytes, &[node_id & 0x7F]);
        let mut entries = D::ENTRIES;
        while let [entry, rest @ ..] = entries {
            data.set_default(entry);
            entries = rest;
        }
        data
    }

    /// Sets the values of objects to the defaults for `node_id`.
    pub fn set_defaults(&mut self, node_id: u8, is_restored: impl Fn(u16) -> bool) {
        copy(&mut self.bytes, &[node_id & 0x7F]);
        for entry in D::ENTRIES.iter().filter(|entry| is_restored(entry.index())) {
            self.set_default(entry);
        }
    }

    /// The node-ID of the values.
    #[must_use]
    pub const fn node_id(&self) -> u8 {
        let bytes: &[u8] = &self.bytes;
        if let [node_id, ..] = bytes { *node_id } else { 0 }
    }

    /// The value of an entry.
    #[must_use]
    #[inline]
    pub fn get<T: Typed + ?Sized, A>(&self, handle: Handle<D, T, A>) -> T::Value<'_> {
        match self.value_at(handle.ram(), handle.size(), T::HAS_LENGTH) {
            Some(bytes) => T::load(bytes),
            None => T::load_constant(handle.entry(), self.node_id()),
        }
    }

    /// Sets a value that the limits allow, as an SDO would; access does not matter.
    ///
    /// # Errors
    /// The reason why the value is not valid; it is unchanged.
    #[inline]
    pub fn set<T: Typed + ?Sized, A: Variable>(
        &mut self,
        handle: Handle<D, T, A>,
        value: T::Value<'_>,
    ) -> Result<(), Abort> {
        if !T::fits(value, handle.size()) {
            return Err(Abort::InvalidValue);
        }
        T::with_bytes(value, handle.size(), |bytes| self.write_entry(handle.entry(), bytes))
    }

    /// Sets a value without checking its limits. Strings are truncated to the capacity.
    #[inline]
    pub fn put<T: Typed + ?Sized, A: Variable>(&mut self, handle: Handle<D, T, A>, value: T::Value<'_>) {
        T::with_bytes(value, handle.size(), |bytes| {
            self.keep_at(handle.ram(), handle.size(), T::HAS_LENGTH, bytes);
        });
    }

    /// Reads a value into `buffer`, as transferred by an SDO upload; returns the number of bytes.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read(&self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let entry = Entry::find(index, sub)?;
        if entry.is_readable() { self.read_entry(entry, buffer) } else { Err(Abort::WriteOnly) }
    }

    /// Like [`Self::read`], for a known entry, without checking its access.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read_entry(&self, entry: &Entry<D>, buffer: &mut [u8]) -> Result<usize, Abort> {
        let number;
        let bytes = match self.value(entry) {
            Some(bytes) => bytes,
            None if entry.adds_node_id() => {
                number = entry.default_number(self.node_id()).to_le_bytes();
                part(&number, 0, entry.size())
            }
            None if entry.is_elsewhere() => return Err(Abort::NoData),
            None => entry.default_bytes(),
        };
        let room = buffer.get_mut(..bytes.len()).ok_or(Abort::OutOfMemory)?;
        copy(room, bytes);
        Ok(bytes.len())
    }

    /// Writes a value transferred by an SDO download if the dictionary allows it.
    ///
    /// # Errors
    /// The code to abort the download with; the value is unchanged.
    pub fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let entry = Entry::find(index, sub)?;
        if entry.is_writable() { self.write_entry(entry, bytes) } else { Err(Abort::ReadOnly) }
    }

    /// Like [`Self::write`], for a known entry, without checking its access.
    ///
    /// # Errors
    /// The code to abort the download with; the value is unchanged.
    pub fn write_entry(&mut self, entry: &Entry<D>, bytes: &[u8]) -> Result<(), Abort> {
        if entry.ram() == 0 {
            return Err(Abort::CannotStore);
        }
        entry.check(bytes, self.node_id())?;
        self.keep(entry, bytes);
        Ok(())
    }

    /// The bytes of a value in RAM; `None` for a value in flash.
    pub(super) fn value(&self, entry: &Entry<D>) -> Option<&[u8]> {
        self.value_at(entry.ram(), entry.size(), entry.has_length())
    }

    #[inline]
    fn value_at(&self, ram: usize, size: usize, has_length: bool) -> Option<&[u8]> {
        if ram == 0 {
            return None;
        }
        let place = self.bytes.get(ram..)?;
        if has_length {
            let (length, text) = place.split_first_chunk()?;
            text.get(..usize::from(u16::from_le_bytes(*length)))
        } else {
            place.get(..size)
        }
    }

    /// Stores a value that has been checked.
    pub(super) fn keep(&mut self, entry: &Entry<D>, bytes: &[u8]) {
        self.keep_at(entry.ram(), entry.size(), entry.has_length(), bytes);
        self.clear_void_bits(entry);
    }

    pub(super) fn clear_void_bits(&mut self, entry: &Entry<D>) {
        if let Some(byte) = self.bytes.get_mut(entry.ram() + 3).filter(|_| entry.is_time()) {
            *byte &= Time::USED;
        }
    }

    /// Stores as much as fits; the rest of a string's capacity is cleared.
    #[inline]
    fn keep_at(&mut self, ram: usize, size: usize, has_length: bool, bytes: &[u8]) {
        let Some(place) = self.bytes.get_mut(ram..).filter(|_| ram > 0) else { return };
        if !has_length {
            if let (Some(place), Some(bytes)) = (place.get_mut(..size), bytes.get(..size)) {
                copy(place, bytes);
            }
            return;
        }
        let kept = bytes.get(..size).unwrap_or(bytes);
        let Some((length, text)) = place.split_first_chunk_mut() else { return };
        *length = (kept.len() as u16).to_le_bytes();
        if let Some(text) = text.get_mut(..size) {
            text.fill(0);
            copy(text, kept);
        }
    }

    /// Sets an entry in RAM to its default.
    pub(super) const fn set_default(&mut self, entry: &Entry<D>) {
        let node_id = self.node_id();
        let bytes: &mut [u8] = &mut self.bytes;
        let place = match bytes.split_at_mut_checked(entry.ram()) {
            Some((before, place)) if !before.is_empty() => place,
            _ => return,
        };
        if entry.adds_node_id() {
            let number = entry.default_number(node_id).to_le_bytes();
            copy(place, part(&number, 0, entry.size()));
        } else {
            copy(place, entry.initial_bytes());
        }
    }
}

/// The node-ID that the table is generated for.
pub trait Configured: Table {
    /// The node-ID.
    const NODE_ID: u8;
}

impl<D: Configured, const RAM: usize> Default for Data<D, RAM> {
    /// The defaults for the configured node-ID.
    fn default() -> Self {
        Self::new(D::NODE_ID)
    }
}

/// Copies the bytes that both slices have: `copy_from_slice` would leave a panic if the compiler cannot prove
/// equal lengths.
pub(super) const fn copy(mut to: &mut [u8], mut from: &[u8]) {
    while let ([place, room @ ..], [byte, rest @ ..]) = (to, from) {
        *place = *byte;
        to = room;
        from = rest;
    }
}
