//! Messages on a simulated bus: whenever it is free, the waiting message with the highest priority is sent.

/// A message that waits for the bus. Times are in nanoseconds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Queued {
    pub(super) at: u64,
    /// Its duration on the bus.
    pub(super) duration: u64,
}

/// A message that was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sent {
    /// Its stream; the first one has the highest priority.
    pub(super) stream: usize,
    /// Its number in the stream.
    pub(super) number: u64,
    pub(super) queued: u64,
    pub(super) start: u64,
    pub(super) end: u64,
}

/// Sends messages until a time, or until this many are sent. `next` returns the message of a stream with a number,
/// which is queued no earlier than the previous one; it is called when that one has been sent.
pub(super) fn send(
    streams: usize,
    until: u64,
    most: usize,
    mut next: impl FnMut(usize, u64, u64) -> Option<Queued>,
) -> Vec<Sent> {
    let mut heads: Vec<(u64, Option<Queued>)> = (0..streams).map(|stream| (0, next(stream, 0, 0))).collect();
    let mut sent = Vec::new();
    let mut free = 0;
    while sent.len() < most {
        let Some(first) = heads.iter().filter_map(|(_, head)| head.map(|head| head.at)).min() else { break };
        let start = free.max(first);
        let winner = heads.iter().position(|(_, head)| head.is_some_and(|head| head.at <= start));
        let Some((stream, (number, Some(head)))) = winner.map(|stream| (stream, heads[stream])) else {
            break;
        };
        if start >= until {
            break;
        }
        free = start + head.duration;
        sent.push(Sent { stream, number, queued: head.at, start, end: free });
        heads[stream] = (number + 1, next(stream, number + 1, free));
    }
    sent
}
