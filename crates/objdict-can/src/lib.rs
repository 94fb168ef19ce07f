//! Devices on a CAN bus. Part of `objdict`; depend on that crate instead.
//!
//! A [`Transport`] is an adapter, a log or a simulated network. A [`BusClient`] is the one SDO client, NMT master and LSS master that a
//! command is. What it does has no words and reads no files, so all of it is tested on simulated nodes.

mod address;
mod apply;
mod candump;
mod checked;
mod client;
mod compare;
mod lss;
mod safety;
mod save;
mod scan;
mod sim;
mod slcan;
#[cfg(target_os = "linux")]
mod socketcan;
mod transport;

pub use address::{BusAddress, NoBusAddress};
pub use apply::{ApplyOptions, Undo, WriteResult, undo};
pub use candump::ReplayedLog;
pub use checked::CheckedDevice;
pub use client::{BusClient, ClientError, FrameObserver};
pub use compare::{ExpectedNode, NodeDifference, is_heartbeat_due};
pub use lss::{LssIdentity, LssPlace, lss_rate};
pub use safety::{Danger, OtherIdentity, has_srdos};
pub use save::SavedValues;
pub use scan::ScannedNode;
pub use sim::SimulatedBus;
pub use slcan::SlcanAdapter;
pub use transport::{Transport, TransportError};

/// Opens an adapter or a log.
///
/// # Errors
/// When it cannot be opened. A simulated network is made of descriptions, so it is opened by [`SimulatedBus::new`].
pub fn open(address: &BusAddress) -> Result<Box<dyn Transport>, TransportError> {
    match address {
        BusAddress::Slcan { port, bit_rate } => Ok(Box::new(SlcanAdapter::open(port, *bit_rate)?)),
        BusAddress::Candump(path) => Ok(Box::new(ReplayedLog::open(path)?)),
        #[cfg(target_os = "linux")]
        BusAddress::SocketCan(name) => Ok(Box::new(socketcan::SocketCanInterface::open(name)?)),
        #[cfg(not(target_os = "linux"))]
        BusAddress::SocketCan(name) => {
            const HELP: &str = "use `slcan:PORT@RATE` with a serial adapter, or Python with python-can";
            Err(TransportError::closed(name, "only Linux has SocketCAN", HELP))
        }
        BusAddress::Simulated { network, .. } => Err(TransportError::closed(
            &network.to_string_lossy(),
            "it needs descriptions",
            "use `SimulatedBus`",
        )),
    }
}

#[cfg(test)]
mod tests;
