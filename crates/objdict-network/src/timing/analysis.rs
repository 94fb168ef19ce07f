//! Worst-case response times on CAN, after Davis, Burns, Bril and Lukkien, "Controller Area Network (CAN) schedulability analysis: Refuted, revisited and
//! revised" (2007): blocking, busy periods, and every instance in them. Times are in nanoseconds.

/// The longest busy period that is examined. A message that waits longer is considered lost.
const LONGEST: u64 = 10_000_000_000;

/// The maximum number of examined instances of a message; more occur only close to full load.
const INSTANCES: u64 = 2000;

/// The maximum number of iterations until jitters that depend on responses are stable.
const ROUNDS: usize = 50;

/// Messages of one CAN-ID on the bus.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    /// The maximum time of a frame on the bus.
    pub(crate) cost: u64,
    pub(crate) arrival: Arrival,
    /// How late a message may be queued.
    pub(crate) jitter: u64,
    /// The position of the stream whose messages trigger these: its response plus `jitter` is the jitter.
    pub(crate) after: Option<usize>,
    /// Whether it is a part of the background.
    pub(crate) is_background: bool,
}

/// The arrival pattern of messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Arrival {
    /// With this minimum interval, apart from jitter.
    Every(u64),
    /// At any time.
    Unbounded,
    /// Too rarely to be included.
    Rare,
}

/// SDO transfers in the background: one at a time, of frames that are as long as they can be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Background {
    pub(crate) cost: u64,
    /// From a request to its response.
    pub(crate) response_time: u64,
    /// The position before which messages have a higher priority than all of its frames.
    pub(crate) first: usize,
    /// The position from which messages have a lower priority than all of its frames.
    pub(crate) end: usize,
}

/// All messages of a bus by priority.
#[derive(Clone, Debug)]
pub(crate) struct Streams {
    pub(crate) streams: Vec<Stream>,
    pub(crate) background: Option<Background>,
    pub(crate) bit_time: u64,
}

/// The longest time from the event that a message is about to its end on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ResponseTime {
    Within(u64),
    /// The message may wait indefinitely.
    Unbounded(WaitCause),
}

/// The reason why a message may wait indefinitely.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WaitCause {
    /// The message at this position may arrive at any time.
    Message(usize),
    /// The background may use all remaining time; without it, there is a bound.
    Background,
    /// The bus has too much to carry.
    Load,
}

/// The bus time that messages of higher priority need.
#[derive(Default)]
struct Demand(Vec<DemandedTime>);

struct DemandedTime {
    period: u64,
    jitter: u64,
    cost: u64,
}

impl Demand {
    /// Messages with one period and one jitter are one.
    fn add(&mut self, period: u64, jitter: u64, cost: u64) {
        match self.0.iter_mut().find(|same| (same.period, same.jitter) == (period, jitter)) {
            Some(same) => same.cost += cost,
            None => self.0.push(DemandedTime { period, jitter, cost }),
        }
    }

    fn before(&self, until: u64) -> u64 {
        self.0.iter().map(|one| (until + one.jitter).div_ceil(one.period) * one.cost).sum()
    }
}

/// Lower limits for messages of lower priority, with no less blocking.
struct Least {
    blocking: u64,
    /// The time until the first instance starts; `None` if unbounded.
    wait: Option<u64>,
    busy: u64,
}

impl Least {
    const fn of(blocking: u64) -> Self {
        Self { blocking, wait: Some(0), busy: 0 }
    }
}

impl Streams {
    /// The responses of all messages, in their order.
    pub(crate) fn responses(&self) -> Vec<ResponseTime> {
        let mut jitters: Vec<u64> = self.streams.iter().map(|stream| stream.jitter).collect();
        for _ in 0..ROUNDS {
            let responses = self.with(&mut jitters);
            let next: Option<Vec<u64>> = self.streams.iter().map(|stream| stream.late(&responses)).collect();
            match next {
                Some(next) if next != jitters => jitters = next,
                Some(_) => return responses,
                None => return self.cut(&responses),
            }
        }
        vec![ResponseTime::Unbounded(WaitCause::Load); self.streams.len()]
    }

    /// How late each message may be queued.
    pub(crate) fn jitters(&self, responses: &[ResponseTime]) -> Vec<u64> {
        self.streams.iter().map(|stream| stream.late(responses).unwrap_or(stream.jitter)).collect()
    }

    /// The responses when messages follow ones that may never arrive: all from the first of these on are
    /// unknown.
    fn cut(&self, responses: &[ResponseTime]) -> Vec<ResponseTime> {
        let first = self.streams.iter().position(|stream| stream.late(responses).is_none());
        let unknown = |at: usize| first.is_some_and(|first| at >= first);
        let cause = |at: usize| match responses[at] {
            ResponseTime::Unbounded(cause) => ResponseTime::Unbounded(cause),
            ResponseTime::Within(_) => ResponseTime::Unbounded(WaitCause::Load),
        };
        (0..responses.len()).map(|at| if unknown(at) { cause(at) } else { responses[at] }).collect()
    }

    /// The responses with these jitters; sets the jitters of messages that follow one of higher priority.
    fn with(&self, jitters: &mut [u64]) -> Vec<ResponseTime> {
        let blocking = self.blocking();
        let mut higher = Demand::default();
        let mut unbounded = None;
        let mut least = Least::of(0);
        let mut responses = Vec::with_capacity(self.streams.len());
        for (at, stream) in self.streams.iter().enumerate() {
            if stream.after.is_some_and(|after| after < at) {
                jitters[at] = stream.late(&responses).unwrap_or(jitters[at]);
            }
            if stream.arrival == Arrival::Unbounded {
                unbounded = unbounded.or(Some(at));
            }
            responses.push(match unbounded {
                Some(cause) => ResponseTime::Unbounded(WaitCause::Message(cause)),
                None => {
                    let background =
                        self.background.filter(|background| at >= background.first && !stream.is_background);
                    let level = PriorityLevel {
                        blocking: blocking[at],
                        higher: &higher,
                        background,
                        bit_time: self.bit_time,
                    };
                    if blocking[at] != least.blocking {
                        least = Least::of(blocking[at]);
                    }
                    let response = level.response(stream, jitters[at], &mut least);
                    response.map_or_else(|| level.unbounded(stream, jitters[at]), ResponseTime::Within)
                }
            });
            if let Arrival::Every(period) = stream.arrival {
                higher.add(period, jitters[at], stream.cost);
            }
        }
        responses
    }

    /// The longest frame of lower priority that each message may have to wait for.
    fn blocking(&self) -> Vec<u64> {
        let mut longest = 0;
        let mut blocking = vec![0; self.streams.len()];
        for (at, stream) in self.streams.iter().enumerate().rev() {
            let background =
                self.background.filter(|background| at < background.end && !stream.is_background);
            blocking[at] = longest.max(background.map_or(0, |background| background.cost));
            if stream.arrival != Arrival::Rare {
                longest = longest.max(stream.cost);
            }
        }
        blocking
    }

    /// The maximum time from the end of the message at `trigger` until the messages that it triggers simultaneously
    /// have been sent; `None` if unbounded.
    pub(crate) fn burst(&self, trigger: usize, triggered: &[usize], jitters: &[u64]) -> Option<u64> {
        let last = *triggered.iter().max()?;
        let mut higher = Demand::default();
        for (at, stream) in self.streams.iter().enumerate().take(last) {
            match stream.arrival {
                _ if at == trigger || triggered.contains(&at) => {}
                Arrival::Every(period) => higher.add(period, jitters[at], stream.cost),
                Arrival::Unbounded => return None,
                Arrival::Rare => {}
            }
        }
        let background = self.background.filter(|background| last >= background.first);
        let level = PriorityLevel {
            blocking: self.blocking()[last],
            higher: &higher,
            background,
            bit_time: self.bit_time,
        };
        level.settle(triggered.iter().map(|at| self.streams[*at].cost).sum(), 0)
    }
}

impl Stream {
    /// The maximum queuing delay of a message; `None` if it follows one that may never arrive.
    fn late(&self, responses: &[ResponseTime]) -> Option<u64> {
        match self.after.map(|at| responses[at]) {
            None => Some(self.jitter),
            Some(ResponseTime::Within(response)) => Some(response + self.jitter),
            Some(ResponseTime::Unbounded(_)) => None,
        }
    }
}

/// Everything that a message must wait for.
struct PriorityLevel<'s> {
    blocking: u64,
    higher: &'s Demand,
    background: Option<Background>,
    bit_time: u64,
}

impl PriorityLevel<'_> {
    /// The response time of a message; `None` if unbounded.
    fn response(&self, stream: &Stream, jitter: u64, least: &mut Least) -> Option<u64> {
        // SDO frames do not wait for each other
        let mut apart = Least::of(least.blocking);
        let least = if stream.is_background { &mut apart } else { least };
        least.wait = self.settle(0, least.wait?);
        let mut wait = least.wait?;
        let Arrival::Every(period) = stream.arrival else { return Some(jitter + wait + stream.cost) };
        least.busy = self.busy(stream.cost.max(least.busy), stream.cost, period, jitter)?;
        let busy = least.busy;
        let instances = (busy + jitter).div_ceil(period).max(1);
        let mut longest = 0;
        for instance in 0..instances {
            wait = self.settle(instance * stream.cost, wait)?;
            longest = longest.max(jitter + wait + stream.cost - (instance * period).min(jitter + wait));
        }
        Some(longest)
    }

    /// The reason why there is no response time.
    fn unbounded(&self, stream: &Stream, jitter: u64) -> ResponseTime {
        let alone = PriorityLevel { background: None, ..*self };
        let is_bound = || alone.response(stream, jitter, &mut Least::of(self.blocking)).is_some();
        let is_background = self.background.is_some() && is_bound();
        ResponseTime::Unbounded(if is_background { WaitCause::Background } else { WaitCause::Load })
    }

    /// The time until a message may start; `start` is a lower limit.
    fn settle(&self, own: u64, start: u64) -> Option<u64> {
        let mut wait = start.max(self.blocking + own);
        loop {
            let next = self.work(self.blocking + own, wait + self.bit_time)?;
            if next <= wait {
                return Some(wait);
            }
            wait = next;
        }
    }

    /// The time for which the bus is busy with messages of this priority and higher ones; `start` is a lower
    /// limit.
    fn busy(&self, start: u64, cost: u64, period: u64, jitter: u64) -> Option<u64> {
        let mut busy = start;
        loop {
            let instances = (busy + jitter).div_ceil(period).max(1);
            if instances > INSTANCES {
                return None;
            }
            let next = self.work(self.blocking + instances * cost, busy)?;
            if next <= busy {
                return Some(busy);
            }
            busy = next;
        }
    }

    /// The bus time required before `until`, plus `work`; `None` if that exceeds the limit.
    fn work(&self, work: u64, until: u64) -> Option<u64> {
        let work = work + self.higher.before(until);
        let work = match self.background {
            None => work,
            // a response and the next request, and both again if the bus was busy with others for the
            // response time
            Some(Background { cost, response_time, .. }) => {
                work + 2 * cost * (1 + work.checked_div(response_time)?)
            }
        };
        (work <= LONGEST).then_some(work)
    }
}
