//! Files without the text of a description: JSON, concise DCF, node lists.

use super::{FileKind, Input, ReadError, Reading};
use crate::json::{self, DocumentKind};
use objdict_model::source::SourceFile;
use objdict_node::concise;
use objdict_node::download::ConciseDcf;

/// The JSON of a device may contain one value per this number of bytes, and one for each allowed entry.
const BYTES_PER_VALUE: usize = 16;

impl Reading {
    /// The content of a source that is not a description.
    pub(super) fn content(&self, kind: FileKind, source: &SourceFile) -> Result<Input, ReadError> {
        let damaged = |error: Box<dyn std::error::Error + Send + Sync>| ReadError::Content {
            name: source.name().to_owned(),
            error,
        };
        match kind {
            FileKind::Json => {
                self.limited_values(source)?;
                match json::kind(source.text()).map_err(|error| damaged(error.into()))? {
                    DocumentKind::Device => {
                        json::read_device(source.text()).map(|device| Input::Device(Box::new(device)))
                    }
                    DocumentKind::ConciseDcf => json::read_configuration(source.text()).map(Input::Concise),
                }
                .map_err(|error| damaged(error.into()))
            }
            FileKind::CanopenEditorJson => {
                self.limited_values(source)?;
                let device = crate::canopeneditor::read(source.text());
                device.map(|device| Input::Device(Box::new(device))).map_err(|error| damaged(error.into()))
            }
            FileKind::Cdcf => {
                let configuration = ConciseDcf::parse(&source.to_bytes());
                configuration.map(Input::Concise).map_err(|error| damaged(error.into()))
            }
            FileKind::CdcfText => {
                let configuration = concise::parse(source.text(), self.node_id);
                configuration.map(Input::Concise).map_err(|error| damaged(error.into()))
            }
            #[cfg(feature = "node-list")]
            FileKind::Cpj => {
                crate::nodelist::read(source).map(Input::NodeList).map_err(|error| damaged(error.into()))
            }
            kind => Err(ReadError::NotBuilt { name: source.name().to_owned(), kind }),
        }
    }

    /// Rejects a document of many short values: each needs more memory than its text.
    fn limited_values(&self, source: &SourceFile) -> Result<(), ReadError> {
        let count = memchr::memchr3_iter(b',', b'[', b'{', source.text().as_bytes()).count();
        let limit = self.max_values() + source.text().len() / BYTES_PER_VALUE;
        let name = source.name().to_owned();
        if count > limit {
            Err(ReadError::TooManyParts { name, what: "values", count, limit })
        } else {
            Ok(())
        }
    }
}
