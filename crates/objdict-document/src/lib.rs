//! Documentation generated from a description: pages for reading, tables for programs, a DBC for tools of the bus.
//!
//! `objdict-network` is needed for the index of a site, `objdict-node` for the downloads of a node, and
//! `objdict-device` for the texts of abort codes.
//!
//! A page contains the text in reading order; a [`Form`] writes it. Neither reads files: the findings of
//! `check` and the file name are passed with the device ([`Subject`]).

mod anchor;
mod card;
mod changes;
mod connections;
mod context;
mod csv;
pub mod dbc;
pub mod describe;
mod details;
mod diagram;
mod entry;
mod escape;
mod finding;
mod groups;
mod html;
mod layout;
mod markdown;
mod network;
mod object;
mod page;
mod pdos;
mod sentence;
mod services;
mod site;
mod texts;
mod traffic;
mod write;

pub use self::changes::{ChangeEffect, ChangeRow, ChangedDevice, ChangesPage, TablePage};
pub use self::context::{CodeName, Form, Identifiers, Options, Subject};
pub use self::escape::field as csv_field;
pub use self::finding::Finding;
pub use self::network::SiteNetwork;
pub use self::site::{Site, SiteFile};
pub use self::traffic::{
    BandRun, Bands, Curve, CurveBucket, DENSITY_KINDS, Density, TrafficBus, TrafficCourse, TrafficEvent,
    TrafficEvents, TrafficLane, TrafficPage, TrafficPlot, TrafficTable,
};
pub use self::write::{card, write};
use objdict_model::{Language, diagnostic, model, source};
use objdict_profile as profile;

/// The version of the generator stated on pages.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");
