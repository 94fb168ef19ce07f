//! The tags of an XML text, counted before it is read.

/// How many tags start an element.
pub(super) fn start_tags(text: &str) -> usize {
    let bytes = text.as_bytes();
    let starts = |&at: &usize| bytes.get(at + 1).is_some_and(|next| !matches!(next, b'/' | b'!' | b'?'));
    memchr::memchr_iter(b'<', bytes).filter(starts).count()
}

/// How many tags start the description of a device.
pub(super) fn containers(text: &str) -> usize {
    const NAME: &str = "ISO15745ProfileContainer";
    const MAX_PREFIX: usize = 64;
    let starts = |&at: &usize| {
        let before = &text.as_bytes()[at.saturating_sub(MAX_PREFIX)..at];
        let tag = before.iter().rposition(|byte| matches!(byte, b'<' | b'/' | b'>' | b' ' | b'\n'));
        tag.is_some_and(|tag| before[tag] == b'<')
    };
    memchr::memmem::find_iter(text.as_bytes(), NAME).filter(starts).count()
}
