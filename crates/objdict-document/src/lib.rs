//! Documentation generated from a description: pages for reading, tables for programs, a DBC for tools of the bus.
//!
//! `objdict-network` is needed for the index of a site, `objdict-node` for the downloads of a node, and
//! `objdict-device` for the texts of abort codes.
//!
//! A page contains the words in reading order; a [`Form`] writes it. Neither reads files: the findings of
//! `check` and the file name are passed with the device ([`Subject`]).

mod anchor;
mod card;
mod changes;
mod communication;
mod connections;
mod context;
mod csv;
pub mod dbc;
pub mod describe;
mod details;
mod diagram;
mod downloads;
mod entry;
mod escape;
mod finding;
mod form;
mod groups;
mod html;
mod layout;
mod markdown;
mod network;
mod object;
mod options;
mod page;
mod pdos;
mod policy;
mod probed;
mod sentence;
mod services;
mod site;
mod states;
mod subject;
mod text_width;
mod texts;
mod traffic;
mod variants;
mod write;

pub use self::changes::{ChangeEffect, ChangeRow, ChangedDevice, ChangesPage};
pub use self::escape::field as csv_field;
pub use self::finding::Finding;
pub use self::form::Form;
pub use self::network::SiteNetwork;
pub use self::options::Options;
pub use self::probed::ProbePage;
pub use self::site::{Site, SiteFile};
pub use self::subject::{CodeName, Identifiers, Subject};
pub use self::traffic::{
    BandRun, Bands, Curve, CurveBucket, DENSITY_KINDS, Density, TrafficBus, TrafficCourse, TrafficEvent,
    TrafficEvents, TrafficLane, TrafficPage, TrafficPlot, TrafficTable,
};
pub use self::variants::VariantsPage;
pub use self::write::{card, write};
use objdict_model::{Language, diagnostic, model, source};
use objdict_profile as profile;
