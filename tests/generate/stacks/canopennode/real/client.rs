//! `SdoClient` of `objdict-device` against the SDO server of the stack, which has block transfers with CRC here.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use objdict::generate::{Options, StackLayout};
use objdict::model::{Access, DataType, Value};
use objdict_device::{Abort, Frame, SdoClient, SdoStep};

use super::{NODE_ID, beside, checkout, generate_into, sources, with_port};
use crate::compile::{c_compiler, succeed};
use crate::oracle::hex;
use crate::{device, odd, support};

const TEXT: u16 = 0x2ABC;
const LONGEST: usize = 1000;
const FLAGS: [&str; 3] = [
    "-DCO_CONFIG_SDO_SRV=(CO_CONFIG_SDO_SRV_SEGMENTED|CO_CONFIG_SDO_SRV_BLOCK)",
    "-DCO_CONFIG_SDO_SRV_BUFFER_SIZE=1000",
    "-DCO_CONFIG_CRC16=CO_CONFIG_CRC16_ENABLE",
];

/// The program of the stack.
struct Server {
    child: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Server {
    fn start(program: &Path) -> Self {
        let mut command = Command::new(program);
        command.args([&NODE_ID.to_string(), "frames"]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let (requests, answers) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        Self { child, requests, answers: BufReader::new(answers) }
    }

    /// Sends a line; returns the answers.
    fn say(&mut self, line: &str) -> Vec<Frame> {
        writeln!(self.requests, "{line}").unwrap();
        let lines = (&mut self.answers).lines().map(Result::unwrap).take_while(|line| line != ".");
        lines.map(|line| answer(&line)).collect()
    }

    /// Runs a transfer to its end.
    fn run(&mut self, client: &mut SdoClient, value: &mut [u8], mut step: SdoStep) -> Result<usize, Abort> {
        let (mut now, mut answers) = (0, VecDeque::new());
        loop {
            if let Some(frame) = step.frame {
                answers.extend(self.say(&hex(frame.data())));
            }
            if let Some(end) = step.end {
                return end;
            }
            step = match answers.pop_front() {
                Some(answer) => client.receive(value, &answer, now),
                None => client.poll(value, now),
            };
            if step == SdoStep::default() && answers.is_empty() {
                answers.extend(self.say("."));
                now += 1000;
            }
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.child.kill().and_then(|()| self.child.wait()).unwrap();
    }
}

fn answer(line: &str) -> Frame {
    let byte = |at: usize| u8::from_str_radix(&line[2 * at..2 * at + 2], 16).unwrap();
    let bytes: [u8; 8] = std::array::from_fn(byte);
    Frame::new(0x580 + u16::from(NODE_ID), &bytes).unwrap()
}

/// The stack with the tables of a device that has a text with this default, and with a file of the application.
fn with_text(default: Option<Value>, options: &Options, application: Option<&str>) -> Option<Server> {
    let (stack, compiler) = (checkout("OBJDICT_CANOPENNODE_DIR")?, c_compiler()?);
    let folder = tempfile::tempdir().unwrap();
    let mut device = device(&support::fixtures().join("eds/io-401.eds"));
    let text = odd::entry("Text", DataType::VISIBLE_STRING, Access::Rw, default);
    device.objects.insert(TEXT, odd::var(text));
    generate_into(folder.path(), &device, options);
    let mut cc = with_port(&compiler, folder.path(), &stack);
    cc.args(FLAGS).args(["-o", "node", "OD.c"]).arg(beside("canopennode", "real/node.c"));
    if let Some(source) = application {
        std::fs::write(folder.path().join("application.c"), source).unwrap();
        cc.args(["-DWITH_HOOKS", "application.c"]);
    }
    cc.arg(stack.join("CANopen.c")).arg(stack.join("301/crc16-ccitt.c")).args(sources(&stack));
    succeed(&mut cc, "").unwrap();
    Some(Server::start(&folder.path().join("node")))
}

/// A text of every length is written and read by each protocol.
#[test]
fn a_client_writes_and_reads_an_entry_of_the_real_stack() {
    let text = Value::Text("x".repeat(LONGEST).into());
    let Some(mut server) = with_text(Some(text), &Options::default(), None) else { return };
    for length in 1..=LONGEST {
        let value: Vec<u8> = (0..length).map(|at| (at * 37 + length) as u8 | 1).collect();
        for is_block in [false, true] {
            let mut client = SdoClient::new(NODE_ID).with_block_size([1, 5, 127][length % 3]);
            let mut sent = value.clone();
            let step = match is_block {
                true => client.download_block(TEXT, 0, length, 0),
                false => client.download(&mut sent[..], TEXT, 0, length, 0),
            };
            assert_eq!(server.run(&mut client, &mut sent, step), Ok(length));
            let mut read = vec![0; LONGEST];
            let step = if is_block { client.upload_block(TEXT, 0, 0) } else { client.upload(TEXT, 0, 0) };
            assert_eq!(server.run(&mut client, &mut read, step), Ok(length), "{length} bytes, {is_block}");
            assert_eq!(read[..length], value);
        }
    }
    let mut client = SdoClient::new(NODE_ID);
    let step = client.upload_block(0x3000, 0, 0);
    assert_eq!(server.run(&mut client, &mut [], step), Err(Abort::NoObject));
}

/// A text of the application, as in the examples of the stack.
const APPLICATION: &str = r#"
#include "301/CO_ODinterface.h"
#include "OD.h"
#include <string.h>

static char text[32];

ODR_t OD_read_H2ABC(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead)
{
    *countRead = (OD_size_t)strlen(text);
    if (*countRead > count) {
        return ODR_DEV_INCOMPAT;
    }
    memcpy(buf, text, *countRead);
    stream->dataLength = *countRead;
    return ODR_OK;
}

ODR_t OD_write_H2ABC(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{
    (void)stream;
    if (count >= sizeof text) {
        return ODR_DATA_LONG;
    }
    memset(text, 0, sizeof text);
    memcpy(text, buf, count);
    *countWritten = count;
    return ODR_OK;
}
"#;

/// In the layout of `CANopenEditor` a text without default has no variable and no length, so any length reaches the application.
#[test]
fn a_text_without_a_variable_is_written_to_the_application() {
    let mut options = Options::default();
    options.layout = StackLayout::CanOpenEditor;
    let Some(mut server) = with_text(None, &options, None) else { return };
    let transfer = |server: &mut Server, sent: &[u8]| {
        let mut client = SdoClient::new(NODE_ID);
        let mut value = sent.to_vec();
        let step = client.download(&mut value[..], TEXT, 0, sent.len(), 0);
        let written = server.run(&mut client, &mut value, step);
        let mut read = [0; 32];
        let step = client.upload(TEXT, 0, 0);
        (written, server.run(&mut client, &mut read, step).map(|length| read[..length].to_vec()))
    };
    // without the application there is nothing
    let missing = Abort::NoSubIndex;
    assert_eq!(transfer(&mut server, b"drive"), (Err(missing), Err(missing)));

    options.hooks = [format!("{TEXT:X}").parse().unwrap()].into();
    let Some(mut server) = with_text(None, &options, Some(APPLICATION)) else { return };
    for text in ["d", "five!", "fifteen letters"] {
        let bytes = text.as_bytes().to_vec();
        assert_eq!(transfer(&mut server, &bytes), (Ok(bytes.len()), Ok(bytes)), "{text}");
    }
    assert_eq!(transfer(&mut server, &[b'x'; 40]).0, Err(Abort::TooLong));
}
