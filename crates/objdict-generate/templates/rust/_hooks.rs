/// Hooks of the application for the entries selected with `--hook`.
#[allow(dead_code, unreachable_pub)]
pub trait Hooks {
    /// Called before such an entry is read; may change its value.
    ///
    /// # Errors
    /// The code to abort the upload with.
    fn before_read(&mut self, data: &mut Data, index: u16, sub: u8) -> Result<(), Abort> {
        let _ = (data, index, sub);
        Ok(())
    }

    /// Called after such an entry was written; the entry has its new value.
    ///
    /// # Errors
    /// The code to abort the download with: the old value is restored; other changes of
    /// the hook remain.
    fn after_write(&mut self, data: &mut Data, index: u16, sub: u8) -> Result<(), Abort> {
        let _ = (data, index, sub);
        Ok(())
    }
}

/// Size of the longest value that [`Hooks::after_write`] may reject.
const HOOK_ROOM: usize = {{ hook_room }};

#[allow(dead_code, unreachable_pub)]
impl Data {
    /// Like [`Data::read`], with hooks.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read_with(
        &mut self,
        hooks: &mut (impl Hooks + ?Sized),
        index: u16,
        sub: u8,
        buffer: &mut [u8],
    ) -> Result<usize, Abort> {
        let entry = find(index, sub)?;
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
        hooks: &mut (impl Hooks + ?Sized),
        index: u16,
        sub: u8,
        bytes: &[u8],
    ) -> Result<(), Abort> {
        let entry = find(index, sub)?;
        if !entry.is_hooked() {
            return self.write(index, sub, bytes);
        }
        let mut old = [0; HOOK_ROOM];
        let length = match self.field(entry.ram).map(Field::load) {
            Some(Value::Number(number)) => keep(&mut old, &number),
            Some(Value::Bytes(bytes)) => keep(&mut old, bytes),
            None => 0,
        };
        self.write(index, sub, bytes)?;
        let answer = hooks.after_write(self, index, sub);
        if let (Err(_), Some(field)) = (answer, self.field_mut(entry.ram)) {
            let mut number = [0; 8];
            number.copy_from_slice(&old[..8]);
            field.store(if entry.is_number() {
                Value::Number(number)
            } else {
                Value::Bytes(old.get(..length).unwrap_or(&[]))
            });
        }
        answer
    }
}

/// Copies what fits; returns the number of bytes.
#[allow(dead_code)]
fn keep(room: &mut [u8], bytes: &[u8]) -> usize {
    let length = bytes.len().min(room.len());
    room[..length].copy_from_slice(&bytes[..length]);
    length
}
