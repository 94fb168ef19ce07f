//! Values for interrupts and the main program.

use core::cell::RefCell;

use critical_section::Mutex;

/// A value that interrupts and the main program share in a `static`, such as the values of a device or a whole
/// [`Node`](crate::Node). Interrupts are disabled while it is in use, so uses should be short; for an RTOS or a second
/// core, provide a suitable `critical-section`.
#[derive(Debug)]
pub struct Shared<T>(Mutex<RefCell<T>>);

impl<T> Shared<T> {
    /// Shares a value.
    #[must_use]
    pub const fn new(value: T) -> Self {
        Self(Mutex::new(RefCell::new(value)))
    }

    /// Uses the value; `None` if the caller is already using it.
    pub fn with<R>(&self, then: impl FnOnce(&mut T) -> R) -> Option<R> {
        critical_section::with(|section| {
            let mut value = self.0.borrow(section).try_borrow_mut().ok()?;
            Some(then(&mut value))
        })
    }
}
