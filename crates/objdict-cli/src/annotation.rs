//! What is texts of a download beside its bytes.

use objdict_document::describe::Decoder;
use objdict_model::model::{DataType, Device, Value};
use objdict_node::concise::Annotation;
use objdict_node::download::{Download, transferred_type};

/// The description that a stream is for, and the node.
#[derive(Clone, Copy)]
pub(super) struct DescribedStream<'a> {
    pub device: Option<&'a Device>,
    pub node_id: Option<u8>,
}

impl DescribedStream<'_> {
    /// The data type, the name and the meaning of a download.
    pub(super) fn annotate(self, download: &Download) -> Annotation {
        let (index, sub) = download.entry();
        let Some(device) = self.device else {
            return Annotation { data_type: unsigned(download.data.len()), comment: String::new() };
        };
        let data_type = transferred_type(device, index, sub).or_else(|| unsigned(download.data.len()));
        let value = data_type.and_then(|data_type| Value::from_bytes(&download.data, data_type));
        let meaning = value.and_then(|value| Decoder::english(device, self.node_id).of(index, sub, &value));
        let texts = [self.name_of(index, sub), meaning.unwrap_or_default()];
        let texts: Vec<String> = texts.into_iter().filter(|text| !text.is_empty()).collect();
        Annotation { data_type, comment: texts.join(": ") }
    }

    /// The name of an entry with that of its object; empty where there is none.
    pub(super) fn name_of(self, index: u16, sub: u8) -> String {
        let Some(object) = self.device.and_then(|device| device.object(index)) else { return String::new() };
        match object.entry(sub).filter(|_| object.object_type().has_subs()) {
            Some(entry) => format!("{} / {}", object.name(), entry.name),
            None => object.name().to_owned(),
        }
    }
}

/// The type of a value of so many bytes, where it is most likely a number.
fn unsigned(length: usize) -> Option<DataType> {
    match length {
        1 => Some(DataType::UNSIGNED8),
        2 => Some(DataType::UNSIGNED16),
        4 => Some(DataType::UNSIGNED32),
        _ => None,
    }
}
