//! Messages on a simulated bus: whenever it is free, the message with the highest priority of those that wait is sent.

/// A message that waits for the bus. Times are in nanoseconds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Queued {
    pub(super) at: u64,
    /// How long it takes on the bus.
    pub(super) duration: u64,
}

/// A message that was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sent {
    /// Which stream it is of; the first has the highest priority.
    pub(super) stream: usize,
    /// Which message of the stream it is.
    pub(super) number: u64,
    pub(super) queued: u64,
    pub(super) start: u64,
    pub(super) end: u64,
}

/// Sends messages until a time, or until so many are sent. `next` has the message of a stream with a number, which is queued no earlier than the one before;
/// it is given when that one was sent.
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
