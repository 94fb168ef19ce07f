//! The simulated node answers as the generated tables do.

use objdict::bus::{Dictionary, LiveDictionary, PowerOn};
use objdict::generate::Options;
use objdict::model::Device;

use crate::devices::{arbitrary_devices, devices, for_all};
use crate::oracle::hex;
use crate::script;

/// The answers to the operations of a script.
fn answers(device: &Device, input: &str) -> Vec<String> {
    let mut dictionary = LiveDictionary::new(device, 1, PowerOn::Configured);
    let number = |text: &str| usize::from_str_radix(text, 16).unwrap();
    let mut answers = Vec::new();
    for line in input.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let at = |words: &[&str]| (number(words[1]) as u16, number(words[2]) as u8);
        let answer = match words[0] {
            "i" => {
                let (node_id, options) = (number(words[1]) as u8, Options::default());
                dictionary = LiveDictionary::with_options(device, node_id, PowerOn::Configured, &options);
                continue;
            }
            "r" => {
                let (index, sub) = at(&words);
                let mut buffer = vec![0; number(words[3])];
                dictionary.read(index, sub, &mut buffer).map(|length| buffer[..length].to_vec())
            }
            "w" => {
                let (index, sub) = at(&words);
                let digits = words[3].trim_matches('-').as_bytes();
                let pair = |pair: &[u8]| number(std::str::from_utf8(pair).unwrap()) as u8;
                let bytes: Vec<u8> = digits.chunks(2).map(pair).collect();
                dictionary.write(index, sub, &bytes).map(|()| Vec::new())
            }
            _ => continue,
        };
        answers.push(match answer {
            Ok(bytes) => format!("ok {}", hex(&bytes)),
            Err(abort) => format!("abort {:08X}", abort.code()),
        });
    }
    answers
}

#[test]
fn a_simulated_node_answers_as_a_generated_table() {
    for_all(&[devices(), arbitrary_devices(20)].concat(), |(name, device)| {
        let mut device = device.with_implicit_pdos().into_owned();
        // it serves these itself: a table leaves them to the application
        for index in [0x1010, 0x1011, 0x1020] {
            device.objects.remove(&index);
        }
        let script = script::with_hooks(&device);
        let is_answer = |line: &&String| line.starts_with("ok ") || line.starts_with("abort ");
        let expected = script.expected.iter().filter(is_answer);
        let answers = answers(&device, &script.input);
        let operations = script.input.lines().filter(|line| line.starts_with(['r', 'w']));
        for ((expected, answer), operation) in expected.zip(&answers).zip(operations) {
            if expected != answer {
                return Err(format!("{name}: {operation:.80}: `{answer}` where `{expected}` was expected"));
            }
        }
        if answers.is_empty() { Err(format!("{name}: no operation")) } else { Ok(()) }
    });
}
