use super::{Entry, Table, Time};

/// Access: read-only for SDOs; the application sets the value.
#[derive(Clone, Copy, Debug)]
pub enum Ro {}
/// Access: write-only for SDOs.
#[derive(Clone, Copy, Debug)]
pub enum Wo {}
/// Access: readable and writable.
#[derive(Clone, Copy, Debug)]
pub enum Rw {}
/// Access: a constant in flash.
#[derive(Clone, Copy, Debug)]
pub enum Const {}
/// Access: a constant in flash to which the node-ID is added.
#[derive(Clone, Copy, Debug)]
pub enum NodeConst {}
/// Access: the application transfers the data, for which the table has no capacity.
#[derive(Clone, Copy, Debug)]
pub enum Elsewhere {}

/// Access of entries with a value in RAM, which an application can set.
#[diagnostic::on_unimplemented(
    message = "the application cannot set an entry whose access is `{Self}`",
    label = "this constant of the dictionary has no value in RAM",
    note = "a constant is in flash: read it with `value()` or `get`, or describe the entry with a different access type"
)]
pub trait Variable {}

impl Variable for Ro {}
impl Variable for Wo {}
impl Variable for Rw {}

/// An entry with its type and access: `data.get(od::SPEED)`.
pub struct Handle<D: 'static, T: ?Sized, A> {
    entry: &'static Entry<D>,
    // copied from the entry, so that the address of a value is a constant
    ram: u32,
    size: u16,
    kind: core::marker::PhantomData<fn(A) -> *const T>,
}

impl<D: Table, T: ?Sized, A> Handle<D, T, A> {
    /// The handle of an entry.
    ///
    /// # Panics
    /// If there is no such entry; in a constant this is a compile-time error.
    #[must_use]
    pub const fn of(index: u16, sub: u8) -> Self {
        match Entry::find(index, sub) {
            Ok(entry) => Self::new(entry),
            Err(_) => panic!("no such entry"),
        }
    }

    const fn new(entry: &'static Entry<D>) -> Self {
        let (ram, size) = (entry.ram() as u32, entry.size() as u16);
        Self { entry, ram, size, kind: core::marker::PhantomData }
    }

    /// The row in the table, with access, PDO mapping and data type.
    #[must_use]
    pub const fn entry(self) -> &'static Entry<D> {
        self.entry
    }

    /// The index.
    #[must_use]
    pub const fn index(self) -> u16 {
        self.entry.index()
    }

    /// The sub-index.
    #[must_use]
    pub const fn sub(self) -> u8 {
        self.entry.sub()
    }

    /// Maximum size of a value in an SDO transfer, in bytes.
    #[must_use]
    pub const fn size(self) -> usize {
        self.size as usize
    }

    /// The offset of the value; 0 for a value in flash.
    pub(super) const fn ram(self) -> usize {
        self.ram as usize
    }
}

impl<D, T: ?Sized, A> Clone for Handle<D, T, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, T: ?Sized, A> Copy for Handle<D, T, A> {}

impl<D: Table, T: ?Sized, A> core::fmt::Debug for Handle<D, T, A> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Handle({:04X}h:{:02X})", self.index(), self.sub())
    }
}

macro_rules! defaults {
    ($($number:ty, $bits:ident => $value:expr;)*) => {
        $(impl<D: Table, A> Handle<D, $number, A> {
            /// The default for a node.
            #[must_use]
            pub const fn default(self, node_id: u8) -> $number {
                let $bits = self.entry.default_number(node_id);
                $value
            }
        }

        impl<D: Table> Handle<D, $number, Const> {
            /// The value.
            #[must_use]
            pub const fn value(self) -> $number {
                self.default(0)
            }
        })*
    };
}

macro_rules! limits {
    ($($number:ty, $bits:ident => $value:expr;)*) => {
        $(impl<D: Table, A> Handle<D, $number, A> {
            /// The low limit for a node.
            #[must_use]
            pub const fn low(self, node_id: u8) -> Option<$number> {
                match self.entry.low_limit(node_id) {
                    Some($bits) => Some($value),
                    None => None,
                }
            }

            /// The high limit for a node.
            #[must_use]
            pub const fn high(self, node_id: u8) -> Option<$number> {
                match self.entry.high_limit(node_id) {
                    Some($bits) => Some($value),
                    None => None,
                }
            }
        })*
    };
}

macro_rules! numbers {
    ($($number:ty, $bits:ident => $value:expr;)*) => {
        defaults! { $($number, $bits => $value;)* }
        limits! { $($number, $bits => $value;)* }
    };
}

numbers! {
    i8, bits => bits as i8;
    i16, bits => bits as i16;
    i32, bits => bits as i32;
    i64, bits => bits as i64;
    u8, bits => bits as u8;
    u16, bits => bits as u16;
    u32, bits => bits as u32;
    u64, bits => bits;
    f32, bits => f32::from_bits(bits as u32);
    f64, bits => f64::from_bits(bits);
}

defaults! {
    bool, bits => bits != 0;
    Time, bits => Time::from_number(bits);
}

impl<D: Table, A> Handle<D, [u8], A> {
    /// The default.
    #[must_use]
    pub const fn default(self) -> &'static [u8] {
        self.entry.default_bytes()
    }
}

impl<D: Table> Handle<D, [u8], Const> {
    /// The value.
    #[must_use]
    pub const fn value(self) -> &'static [u8] {
        self.default()
    }
}

/// The elements of an ARRAY: sub-index 1 and up, all alike.
pub struct Array<D: 'static, T: ?Sized, A> {
    elements: &'static [Entry<D>],
    kind: core::marker::PhantomData<fn(A) -> *const T>,
}

impl<D: Table, T: ?Sized, A> Array<D, T, A> {
    /// The handle of an array with this number of elements.
    ///
    /// # Panics
    /// If there is no such array; in a constant this is a compile-time error.
    #[must_use]
    pub const fn of(index: u16, length: u8) -> Self {
        let mut entries = D::ENTRIES;
        while let [entry, rest @ ..] = entries {
            if entry.index() == index && entry.sub() == 1 {
                break;
            }
            entries = rest;
        }
        let elements = entries.split_at(length as usize).0;
        Self { elements, kind: core::marker::PhantomData }
    }

    /// The number of elements, which is the highest sub-index.
    #[must_use]
    pub const fn len(self) -> usize {
        self.elements.len()
    }

    /// Whether there are no elements, which the generator excludes.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.elements.is_empty()
    }

    /// The element with this sub-index, counted from 1.
    ///
    /// # Panics
    /// If there is none; see [`Self::get`].
    #[must_use]
    #[track_caller]
    pub const fn at(self, sub: u8) -> Handle<D, T, A> {
        match self.get(sub) {
            Some(element) => element,
            None => panic!("no such sub-index"),
        }
    }

    /// The element with this sub-index, starting at 1; `None` if there is none.
    #[must_use]
    pub const fn get(self, sub: u8) -> Option<Handle<D, T, A>> {
        let Some(number) = (sub as usize).checked_sub(1) else { return None };
        match self.elements.split_at_checked(number) {
            Some((_, [entry, ..])) => Some(Handle::new(entry)),
            _ => None,
        }
    }

    /// All elements.
    pub fn iter(self) -> impl Iterator<Item = Handle<D, T, A>> {
        self.elements.iter().map(Handle::new)
    }
}

impl<D, T: ?Sized, A> Clone for Array<D, T, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, T: ?Sized, A> Copy for Array<D, T, A> {}

impl<D: Table, T: ?Sized, A> core::fmt::Debug for Array<D, T, A> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
