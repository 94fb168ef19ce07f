//! Nodes and their manager on a simulated bus. Part of `objdict`; depend on that crate instead.
//!
//! The crate knows networks only as a `Plant`; `objdict-document` describes its frames.
//!
//! A [`Plant`] is a network of descriptions and of the objects of its manager. [`boot`] lets the manager boot it (CiA 302-2): real
//! frames, arbitrated by CAN-ID and as long as the bit rate makes them, between an NMT master and nodes that are
//! `objdict-device` over a [`LiveDictionary`]. What happens is a [`Run`], the same in every run.

mod client;
mod conformance;
mod dictionary;
mod frame;
mod live;
mod manager;
mod node;
mod run;
mod simulation;

pub use conformance::{
    CheckEffect, Conformance, ConformanceCheck, RemoteDevice, RemoteGroups, Verdict, conformance,
    conformance_of, conformance_on, conformance_plan,
};
pub use dictionary::{LiveDictionary, PowerOn};
pub use frame::{BusFrame, classical_bits};
pub use live::LiveBus;
pub use manager::{BootFailure, Configurations, Milestone};
pub use objdict_device::{Abort, Dictionary, Frame, NmtState, SdoClient, SdoData, SdoStep, crc};
pub use run::{Cut, Event, EventKind, NodeRun, Run};
pub use simulation::{Conditions, Plant, PlantNode, boot};

use objdict_model::{diagnostic, model};
use objdict_node::download;
