//! The SDO client of the manager: expedited and segmented transfers over the default channel of a node.

use objdict_device::{Abort, Frame, SdoClient, SdoData, SdoStep};

/// Nanoseconds without an answer after which the client aborts a transfer.
const TIMEOUT: u64 = 500 * crate::node::MILLISECOND;

/// A transfer between the manager and a node, with its value.
#[derive(Clone, Debug)]
pub(crate) struct Client {
    client: SdoClient,
    value: Bytes,
}

/// The value of a download, or what came of that of an upload.
#[derive(Clone, Debug, Default)]
struct Bytes(Vec<u8>);

impl SdoData for Bytes {
    fn read(&mut self, offset: usize, buffer: &mut [u8]) -> Result<(), Abort> {
        self.0.as_slice().read(offset, buffer)
    }

    fn write(&mut self, _: usize, bytes: &[u8]) -> Result<(), Abort> {
        self.0.extend(bytes);
        Ok(())
    }
}

/// What follows: a frame to send, and the end with the value.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct ClientProgress {
    pub(crate) frame: Option<Frame>,
    pub(crate) end: Option<Result<Vec<u8>, Abort>>,
}

impl Client {
    pub(crate) const fn new(node_id: u8) -> Self {
        let node_id = node_id as u16;
        Self::with_can_ids([0x600 + node_id, 0x580 + node_id])
    }

    /// The client of another channel: the CAN-IDs of its requests and of its responses.
    pub(crate) const fn with_can_ids([request, response]: [u16; 2]) -> Self {
        let client = SdoClient::with_can_ids(request, response).with_timeout(TIMEOUT);
        Self { client, value: Bytes(Vec::new()) }
    }

    /// Begins to write a value.
    pub(crate) fn download(&mut self, index: u16, sub: u8, data: Vec<u8>, now: u64) -> ClientProgress {
        let length = data.len();
        self.value = Bytes(data);
        let step = self.client.download(&mut self.value, index, sub, length, now);
        self.progress(step)
    }

    /// Begins to read a value.
    pub(crate) fn upload(&mut self, index: u16, sub: u8, now: u64) -> ClientProgress {
        self.value.0.clear();
        let step = self.client.upload(index, sub, now);
        self.progress(step)
    }

    /// Begins to write a value by a block transfer.
    pub(crate) fn download_block(&mut self, index: u16, sub: u8, data: Vec<u8>, now: u64) -> ClientProgress {
        let length = data.len();
        self.value = Bytes(data);
        let step = self.client.download_block(index, sub, length, now);
        self.progress(step)
    }

    /// Begins to read a value by a block transfer.
    pub(crate) fn upload_block(&mut self, index: u16, sub: u8, now: u64) -> ClientProgress {
        self.value.0.clear();
        let step = self.client.upload_block(index, sub, now);
        self.progress(step)
    }

    /// Takes an answer of the node.
    pub(crate) fn receive(&mut self, frame: &Frame, now: u64) -> ClientProgress {
        let step = self.client.receive(&mut self.value, frame, now);
        self.progress(step)
    }

    /// Aborts a transfer whose answer does not come.
    pub(crate) fn poll(&mut self, now: u64) -> ClientProgress {
        let step = self.client.poll(&mut self.value, now);
        self.progress(step)
    }

    /// When [`Client::poll`] has to be called.
    pub(crate) const fn next(&self) -> Option<u64> {
        self.client.next()
    }

    fn progress(&mut self, step: SdoStep) -> ClientProgress {
        let value = |_| std::mem::take(&mut self.value.0);
        ClientProgress { frame: step.frame, end: step.end.map(|end| end.map(value)) }
    }
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

    /// Runs a transfer to its end.
    fn run(
        client: &mut Client,
        dictionary: &mut LiveDictionary,
        mut progress: ClientProgress,
    ) -> Result<Vec<u8>, Abort> {
        let mut server = SdoServer::<1000>::new(0, 5);
        loop {
            let request = progress.frame.expect("a request");
            let answer = server.receive(dictionary, &request, 0).expect("a server answers");
            progress = client.receive(&answer, 0);
            if let Some(end) = progress.end {
                return end;
            }
        }
    }

    #[test]
    fn values_of_all_lengths_are_written_and_read() {
        let (mut dictionary, mut client) = (dictionary(), Client::new(5));
        for (index, data) in
            [(0x2000, &b"\x12\x34"[..]), (0x2001, b"12345678"), (0x1008, b""), (0x1008, b"1234567")]
        {
            let progress = client.download(index, 0, data.to_vec(), 0);
            assert!(run(&mut client, &mut dictionary, progress).is_ok(), "{index:04X}h");
            let progress = client.upload(index, 0, 0);
            assert_eq!(run(&mut client, &mut dictionary, progress).as_deref(), Ok(data), "{index:04X}h");
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
            let progress = client.download(index, 0, data, 0);
            assert_eq!(run(&mut client, &mut dictionary, progress), Err(abort));
        }
    }

    #[test]
    fn a_transfer_without_an_answer_ends() {
        let mut client = Client::new(5);
        assert_eq!(client.upload(0x1000, 0, 7).end, None);
        assert_eq!(client.next(), Some(7 + TIMEOUT));
        assert_eq!(client.poll(6 + TIMEOUT), ClientProgress::default());
        let abort = Frame::new(0x605, &[0x80, 0x00, 0x10, 0x00, 0x00, 0x00, 0x04, 0x05]);
        assert_eq!(client.poll(7 + TIMEOUT), ClientProgress { frame: abort, end: Some(Err(Abort::Timeout)) });
        assert_eq!(client.next(), None);
    }
}
