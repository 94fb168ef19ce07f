//! Texts in front of the disk: what an editor has in its buffers, or a browser in place of files.
//!
//! Everything that readers open goes through `read`, so no reader needs a parameter for buffers. The language
//! server also records which files a result depends on, and drops the result when one of them changes.

use std::cell::RefCell;
use std::path::Path;
use std::rc::Rc;

use super::path::absolute;

/// Texts that count more than the files of their paths.
pub trait Buffers {
    /// The bytes at an absolute path without `.` and `..`; `None` leaves it to the disk.
    fn bytes(&self, path: &Path) -> Option<Vec<u8>>;
}

thread_local! {
    static BUFFERS: RefCell<Option<Rc<dyn Buffers>>> = const { RefCell::new(None) };
}

/// Puts back what was in front of the disk before, even after a panic.
struct Restored(Option<Rc<dyn Buffers>>);

impl Drop for Restored {
    fn drop(&mut self) {
        BUFFERS.replace(self.0.take());
    }
}

/// Runs a function; what it opens on this thread is read from the buffers where they have it.
pub fn with_buffers<T>(buffers: Rc<dyn Buffers>, run: impl FnOnce() -> T) -> T {
    let _restored = Restored(BUFFERS.replace(Some(buffers)));
    run()
}

/// The bytes that count more than a file.
pub(super) fn buffered(path: &Path) -> Option<Vec<u8>> {
    let buffers = BUFFERS.with_borrow(Clone::clone)?;
    buffers.bytes(&absolute(path))
}

/// Whether there is a file or a buffer of this path.
pub fn is_file(path: &Path) -> bool {
    path.is_file() || buffered(path).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Folder, read};

    struct One(&'static str);

    impl Buffers for One {
        fn bytes(&self, path: &Path) -> Option<Vec<u8>> {
            path.ends_with(self.0).then(|| b"buffer".to_vec())
        }
    }

    #[test]
    fn a_buffer_counts_more_than_the_disk_for_a_time() {
        let path = std::env::temp_dir().join("objdict-no-such-folder").join("a.eds");
        let text = with_buffers(Rc::new(One("a.eds")), || {
            assert!(is_file(&path));
            assert_eq!(Folder::of(&path).resolve("a.eds").unwrap(), path);
            assert!(matches!(read(&path, 3), Err(crate::source::SourceError::TooLarge { .. })));
            read(&path, 100).unwrap()
        });
        assert_eq!(text, b"buffer");
        assert!(read(&path, 100).is_err() && !is_file(&path));
    }
}
