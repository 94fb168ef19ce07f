//! The SDO client of the manager: expedited and segmented transfers over the default channel of a node.

use objdict_device::{Abort, Frame};

/// Nanoseconds without an answer after which the client aborts a transfer.
const TIMEOUT: u64 = 500 * crate::node::MILLISECOND;

const SEGMENT: usize = 7;
const TOGGLE: u8 = 0x10;

/// A transfer between the manager and a node.
#[derive(Clone, Debug)]
pub(crate) struct Client {
    node_id: u8,
    transfer: Option<Transfer>,
}

#[derive(Clone, Debug)]
struct Transfer {
    index: u16,
    sub: u8,
    way: Way,
    /// The toggle bit of the next segment.
    toggle: u8,
    /// Whether the first answer came.
    is_started: bool,
    /// Until when an answer must come.
    until: u64,
}

#[derive(Clone, Debug)]
enum Way {
    /// The value, and how much of it is sent.
    Download(Vec<u8>, usize),
    /// What came of the value.
    Upload(Vec<u8>),
}

/// What an answer leads to.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Progress {
    /// The frame is not for this transfer.
    None,
    /// The next request.
    Send(Frame),
    /// The end: the value of an upload, nothing of a download.
    Done(Result<Vec<u8>, Abort>),
    /// The end, by an abort of the client, which has to be sent.
    Aborted(Frame, Abort),
}

impl Client {
    pub(crate) const fn new(node_id: u8) -> Self {
        Self { node_id, transfer: None }
    }

    /// Begins to write a value.
    pub(crate) fn download(&mut self, index: u16, sub: u8, data: Vec<u8>, now: u64) -> Frame {
        const EXPEDITED_WITH_SIZE: u8 = 0x23;
        const SEGMENTED_WITH_SIZE: u8 = 0x21;
        let size = u32::try_from(data.len()).unwrap_or(u32::MAX);
        let (command, bytes) = match size {
            1..=4 => {
                let mut bytes = [0; 4];
                bytes.iter_mut().zip(&data).for_each(|(to, from)| *to = *from);
                (EXPEDITED_WITH_SIZE | (4 - size as u8) << 2, bytes)
            }
            _ => (SEGMENTED_WITH_SIZE, size.to_le_bytes()),
        };
        self.start(index, sub, Way::Download(data, 0), now);
        self.initiate(command, bytes)
    }

    /// Begins to read a value.
    pub(crate) fn upload(&mut self, index: u16, sub: u8, now: u64) -> Frame {
        self.start(index, sub, Way::Upload(Vec::new()), now);
        self.initiate(0x40, [0; 4])
    }

    /// Takes an answer of the node.
    pub(crate) fn receive(&mut self, frame: &Frame, now: u64) -> Progress {
        let Some(transfer) = &mut self.transfer else { return Progress::None };
        let (true, Ok(bytes)) =
            (frame.id() == 0x580 + u16::from(self.node_id), <[u8; 8]>::try_from(frame.data()))
        else {
            return Progress::None;
        };
        transfer.until = now + TIMEOUT;
        let progress = transfer.receive(bytes);
        self.conclude(progress)
    }

    /// Aborts a transfer whose answer does not come.
    pub(crate) fn poll(&mut self, now: u64) -> Progress {
        match &self.transfer {
            Some(transfer) if transfer.until <= now => self.conclude(Err(Abort::Timeout)),
            _ => Progress::None,
        }
    }

    /// When [`Client::poll`] has to be called.
    pub(crate) fn next(&self) -> Option<u64> {
        self.transfer.as_ref().map(|transfer| transfer.until)
    }

    fn start(&mut self, index: u16, sub: u8, way: Way, now: u64) {
        let until = now + TIMEOUT;
        self.transfer = Some(Transfer { index, sub, way, toggle: 0, is_started: false, until });
    }

    fn initiate(&self, command: u8, [a, b, c, d]: [u8; 4]) -> Frame {
        let (index, sub) = self.transfer.as_ref().map_or((0, 0), |transfer| (transfer.index, transfer.sub));
        let [low, high] = index.to_le_bytes();
        self.request([command, low, high, sub, a, b, c, d])
    }

    fn request(&self, bytes: [u8; 8]) -> Frame {
        request(self.node_id, bytes)
    }

    fn conclude(&mut self, progress: Result<Next, Abort>) -> Progress {
        match progress {
            Ok(Next::Nothing) => Progress::None,
            Ok(Next::Request(bytes)) => Progress::Send(self.request(bytes)),
            Ok(Next::End(result)) => {
                self.transfer = None;
                Progress::Done(result)
            }
            Err(abort) => {
                let frame = self.initiate(0x80, abort.code().to_le_bytes());
                self.transfer = None;
                Progress::Aborted(frame, abort)
            }
        }
    }
}

/// What follows an answer.
enum Next {
    Nothing,
    Request([u8; 8]),
    End(Result<Vec<u8>, Abort>),
}

impl Transfer {
    fn receive(&mut self, bytes: [u8; 8]) -> Result<Next, Abort> {
        let [command, low, high, sub, data @ ..] = bytes;
        let is_same = (u16::from_le_bytes([low, high]), sub) == (self.index, self.sub);
        match (command >> 5, &mut self.way, self.is_started) {
            (4, ..) if is_same => Ok(Next::End(Err(Abort::from(u32::from_le_bytes(data))))),
            // the answer to an earlier transfer that was aborted
            (2..=4, ..) if !is_same => Ok(Next::Nothing),
            (3, Way::Download(value, _), false) => {
                self.is_started = true;
                if matches!(value.len(), 1..=4) {
                    return Ok(Next::End(Ok(Vec::new())));
                }
                Ok(self.next_segment())
            }
            (1, Way::Download(value, sent), true) => {
                if command & TOGGLE == self.toggle {
                    return Err(Abort::ToggleBit);
                }
                if *sent >= value.len() { Ok(Next::End(Ok(Vec::new()))) } else { Ok(self.next_segment()) }
            }
            (2, Way::Upload(_), false) if command & 2 != 0 => {
                let length = if command & 1 == 0 { 4 } else { 4 - usize::from(command >> 2 & 3) };
                Ok(Next::End(Ok(data[..length].to_vec())))
            }
            (2, Way::Upload(_), false) => {
                self.is_started = true;
                Ok(self.ask())
            }
            (0, Way::Upload(value), true) => {
                if command & TOGGLE == self.toggle {
                    return Err(Abort::ToggleBit);
                }
                let used = SEGMENT - usize::from(command >> 1 & 7);
                value.extend(&bytes[1..=used]);
                let value = std::mem::take(value);
                if command & 1 == 1 {
                    return Ok(Next::End(Ok(value)));
                }
                self.way = Way::Upload(value);
                Ok(self.ask())
            }
            _ => Err(Abort::UnknownCommand),
        }
    }

    /// The next segment of a download. Its answer has the same toggle bit, which is no more that of [`Transfer::toggle`].
    fn next_segment(&mut self) -> Next {
        let Way::Download(value, sent) = &mut self.way else { return Next::Nothing };
        let rest = &value[*sent..];
        let used = rest.len().min(SEGMENT);
        let mut bytes = [0; 8];
        bytes[1..=used].copy_from_slice(&rest[..used]);
        bytes[0] = self.toggle | ((SEGMENT - used) as u8) << 1 | u8::from(rest.len() <= SEGMENT);
        *sent += used;
        self.toggle ^= TOGGLE;
        Next::Request(bytes)
    }

    /// The request of the next segment of an upload.
    fn ask(&mut self) -> Next {
        let command = 0x60 | self.toggle;
        self.toggle ^= TOGGLE;
        Next::Request([command, 0, 0, 0, 0, 0, 0, 0])
    }
}

/// A request to the default SDO server of a node.
fn request(node_id: u8, bytes: [u8; 8]) -> Frame {
    let id = 0x600 + u16::from(node_id & 0x7F);
    // eight bytes and eleven bits are always a frame
    Frame::new(id, &bytes).unwrap_or_else(|| unreachable!("{id:03X}h is a CAN-ID"))
}

#[cfg(test)]
mod tests {
    use objdict_device::{Dictionary, SdoServer};

    use super::*;
    use crate::dictionary::{LiveDictionary, PowerOn};
    use crate::model::{Access, DataType, Device, Entry, Object, Value};

    fn dictionary() -> LiveDictionary {
        let mut device = Device::default();
        let entries = [
            (0x1000, DataType::UNSIGNED32, Access::Ro, Some(Value::Unsigned(0x191))),
            (
                0x1008,
                DataType::VISIBLE_STRING,
                Access::Rw,
                Some(Value::Text("a longer name than a frame".into())),
            ),
            (0x2000, DataType::UNSIGNED16, Access::Rw, None),
            (0x2001, DataType::UNSIGNED64, Access::Rw, None),
        ];
        for (index, data_type, access, default) in entries {
            let main =
                Entry { data_type: Some(data_type), access: Some(access), default, ..Entry::default() };
            device.objects.insert(index, Object { main, ..Object::default() });
        }
        LiveDictionary::new(&device, 5, PowerOn::Defaults)
    }

    /// Runs a transfer to its end; counts the requests.
    fn run(
        client: &mut Client,
        dictionary: &mut LiveDictionary,
        first: Frame,
    ) -> (Result<Vec<u8>, Abort>, u32) {
        let mut server = SdoServer::<1000>::new(0, 5);
        let (mut request, mut count) = (first, 1);
        loop {
            let answer = server.receive(dictionary, &request, 0).expect("a server answers");
            match client.receive(&answer, 0) {
                Progress::Send(next) => (request, count) = (next, count + 1),
                Progress::Done(result) => return (result, count),
                progress => panic!("{progress:?}"),
            }
        }
    }

    #[test]
    fn values_of_all_lengths_are_written_and_read() {
        let (mut dictionary, mut client) = (dictionary(), Client::new(5));
        for (index, data, requests) in [
            (0x2000, &b"\x12\x34"[..], 1),
            (0x2001, b"12345678", 3),
            (0x1008, b"", 2),
            (0x1008, b"1234567", 2),
        ] {
            let request = client.download(index, 0, data.to_vec(), 0);
            assert_eq!(
                run(&mut client, &mut dictionary, request),
                (Ok(Vec::new()), requests),
                "{index:04X}h"
            );
            let request = client.upload(index, 0, 0);
            assert_eq!(run(&mut client, &mut dictionary, request).0.as_deref(), Ok(data), "{index:04X}h");
        }
        assert_eq!(dictionary.number(0x2000, 0), Ok(0x3412));
    }

    #[test]
    fn the_reason_of_an_abort_is_known() {
        let (mut dictionary, mut client) = (dictionary(), Client::new(5));
        for (index, data, abort) in [
            (0x1000, vec![0; 4], Abort::ReadOnly),
            (0x3000, vec![0; 20], Abort::NoObject),
            (0x2000, vec![0; 3], Abort::TooLong),
        ] {
            let request = client.download(index, 0, data, 0);
            assert_eq!(run(&mut client, &mut dictionary, request).0, Err(abort));
        }
    }

    #[test]
    fn a_transfer_without_an_answer_ends() {
        let mut client = Client::new(5);
        client.upload(0x1000, 0, 7);
        assert_eq!(client.next(), Some(7 + TIMEOUT));
        assert_eq!(client.poll(6 + TIMEOUT), Progress::None);
        let Progress::Aborted(frame, Abort::Timeout) = client.poll(7 + TIMEOUT) else { panic!("no abort") };
        assert_eq!(frame.data(), [0x80, 0x00, 0x10, 0x00, 0x00, 0x00, 0x04, 0x05]);
        assert_eq!(client.next(), None);
    }
}
