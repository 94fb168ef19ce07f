//! How a device communicates: its services and PDOs in words, and its CAN-IDs.

use super::connections::{self, Connection};
use super::diagram::Grid;
use super::pdos::{self, PdoView};
use super::services::{self, Service};
use crate::decoded::Decoder;
use crate::model::Entry;

/// What a page says of communication.
#[derive(Clone, Debug)]
pub(crate) struct Communication {
    pub(crate) services: Vec<Service>,
    pub(crate) pdos: Vec<PdoView>,
    pub(crate) connections: Vec<Connection>,
}

impl Communication {
    /// That of a device, with the PDOs that `CompactPDO` implies where it is one that has them as objects
    /// ([`Device::with_implicit_pdos`](crate::model::Device::with_implicit_pdos)). `name` says what entries are called.
    pub(crate) fn new(decoder: &Decoder<'_>, name: &dyn Fn(&Entry) -> String) -> Self {
        Self {
            services: services::services(decoder, name),
            pdos: pdos::pdos(decoder, name),
            connections: connections::connections(decoder),
        }
    }

    /// What all drawings of PDOs share.
    pub(crate) fn grid(&self) -> Grid {
        Grid::new()
    }
}

#[cfg(test)]
mod preview {
    use super::super::texts::Texts;
    use super::*;
    use crate::Language;
    use askama::Template;

    #[derive(Template)]
    #[template(
        source = r#"<!doctype html><meta charset=utf-8><meta name=viewport content="width=device-width"><style>{% include "html/_style.css" %}{% include "html/_communication.css" %}</style><main>{% include "html/_services.html" %}{% include "html/_pdos.html" %}{% include "html/_connections.html" %}</main>"#,
        ext = "html"
    )]
    struct Preview<'a> {
        communication: &'a Communication,
        t: &'static Texts,
    }

    #[test]
    fn preview() {
        let Ok(files) = std::env::var("PREVIEW") else { return };
        for file in files.split_whitespace() {
            let path = std::path::Path::new(file);
            let Ok(read) = crate::format::open(path, &Default::default()) else {
                eprintln!("{file}?");
                continue;
            };
            let device = read.device().with_implicit_pdos();
            for language in Language::ALL {
                let node_id = device.node_id().or(if language == Language::English { Some(5) } else { None });
                let decoder = Decoder { device: &device, node_id, language };
                let communication = Communication::new(&decoder, &|entry| entry.name.to_string());
                let text =
                    Preview { communication: &communication, t: Texts::of(language) }.render().unwrap();
                let name = path.file_stem().unwrap().to_string_lossy();
                std::fs::write(format!("/tmp/preview/{name}-{language}.html"), text).unwrap();
            }
        }
    }
}
