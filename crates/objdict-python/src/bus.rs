//! A bus with devices, through an adapter of objdict or of python-can.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::time::Instant;

use objdict::bus::{BusFrame, LiveBus};
use objdict::can::{
    ApplyOptions, BusAddress, BusClient, ClientError, Danger, SimulatedBus, Transport, TransportError,
    WriteResult, has_srdos, open,
};
use objdict::download::{ConciseDcf, Download, PlanOptions, Scope};
use objdict::format::log::{LogTime, LoggedFrame};
use objdict::model::Device;
use objdict::parameter::{no_parameter, present_values};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::configure::with_present;
use super::dictionary::NativeDictionary;
use super::network::opened;
use super::value::NodeId;
use super::{BusError, raised};

/// How many microseconds a second has.
const SECOND: f64 = 1_000_000.0;

thread_local! {
    /// What interrupted a transfer: usually a `KeyboardInterrupt`.
    static INTERRUPTION: RefCell<Option<PyErr>> = const { RefCell::new(None) };
}

/// A client on a bus.
#[pyclass(unsendable, name = "Bus", module = "canopen_objdict._native")]
pub(crate) struct NativeBus(Option<BusClient>);

/// A node that was found: node-ID, NMT state, whether its SDO server answers, device type, and the four numbers of its identity.
type FoundRow = (u8, Option<u8>, bool, Option<u32>, [Option<u32>; 4]);

/// A download: index, sub-index, bytes, `written`, `differs`, `refused` or `unsent`, and the value read back or the abort code.
type WrittenRow<'py> = (u16, u8, Bound<'py, PyBytes>, &'static str, Option<Bound<'py, PyBytes>>, Option<u32>);

#[pymethods]
impl NativeBus {
    /// Opens an address of a bus, or takes the bus of python-can.
    #[new]
    fn new(bus: &Bound<'_, PyAny>, timeout: f64, is_shared: bool) -> PyResult<Self> {
        if !(timeout > 0.0 && timeout <= 3600.0) {
            return Err(PyValueError::new_err(
                "`timeout` is a number of seconds, more than 0 and at most 3600",
            ));
        }
        let transport = match bus.extract::<String>() {
            Ok(address) => adapter(&address)?,
            Err(_) => Box::new(PythonCan { bus: bus.clone().unbind(), opened: Instant::now() }),
        };
        let milliseconds = (timeout * 1000.0).ceil() as u32;
        let client = BusClient::new(transport).with_timeout(milliseconds).with_stop(is_interrupted);
        Ok(Self(Some(client.shared(is_shared))))
    }

    /// Closes the adapter.
    fn close(&mut self) {
        self.0 = None;
    }

    /// Listens for so many seconds.
    fn listen(&mut self, seconds: f64) -> PyResult<()> {
        self.client()?.listen(milliseconds(seconds)?).map_err(refused)
    }

    /// The NMT states of the nodes that were heard.
    fn states(&mut self) -> PyResult<BTreeMap<u8, Option<u8>>> {
        Ok(self.client()?.states().clone())
    }

    /// The nodes that answer or were heard.
    fn scan(&mut self, first: NodeId, last: NodeId, seconds: f64) -> PyResult<Vec<FoundRow>> {
        let found = self.client()?.scan(first.0..=last.0, milliseconds(seconds)?).map_err(refused)?;
        let row = |node: &objdict::can::ScannedNode| {
            (node.node_id, node.state, node.answers, node.device_type, node.identity)
        };
        Ok(found.iter().map(row).collect())
    }

    /// The bytes of an entry.
    fn upload<'py>(
        &mut self,
        py: Python<'py>,
        node: NodeId,
        index: u16,
        sub: u8,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.client()?.upload(node.0, index, sub).map_err(refused)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the bytes of an entry; a device with SRDOs is rejected.
    fn download(
        &mut self,
        node: NodeId,
        index: u16,
        sub: u8,
        data: Vec<u8>,
        device: Option<PyRef<'_, NativeDictionary>>,
    ) -> PyResult<()> {
        if device.is_some_and(|device| has_srdos(device.now().device())) {
            return Err(not_configured(node, Danger::Safety));
        }
        self.client()?.download(node.0, index, sub, &data).map_err(refused)
    }

    /// Sends an NMT command, to all nodes without one.
    fn command(&mut self, command: u8, node: Option<NodeId>) -> PyResult<()> {
        self.client()?.command(command, node.map_or(0, |node| node.0)).map_err(refused)
    }

    /// Waits for a state of a node; whether it came.
    fn wait_for(&mut self, node: NodeId, state: u8, seconds: f64) -> PyResult<bool> {
        self.client()?.wait_for(node.0, state, milliseconds(seconds)?).map_err(refused)
    }

    /// Gives a device the present values of its parameters; returns the entries that the node does not let read, with abort codes.
    fn save(&mut self, node: NodeId, device: &NativeDictionary) -> PyResult<Vec<(u16, u8, u32)>> {
        let shared = device.now();
        let saved = self.client()?.save(node.0, shared.device()).map_err(refused)?;
        let (assignments, _) = present_values(shared.device(), node.0, saved.values);
        device.0.set(with_present(&shared, node.0, &assignments)?);
        Ok(saved.refused.iter().map(|((index, sub), abort)| (*index, *sub, abort.code())).collect())
    }

    /// Writes what a device is configured to be, in an order that nodes accept.
    fn apply<'py>(
        &mut self,
        py: Python<'py>,
        node: NodeId,
        device: &NativeDictionary,
        verify: bool,
        go_on: bool,
        is_forced: bool,
    ) -> PyResult<Vec<WrittenRow<'py>>> {
        let shared = device.now();
        self.require_safe(node, shared.device(), is_forced)?;
        let (downloads, files) = planned(&shared, node.0)?;
        let is_moving =
            |download: &&Download| no_parameter(shared.device(), download.index, download.sub).is_some();
        if let Some(Download { index, sub, .. }) = downloads.iter().find(is_moving).filter(|_| !is_forced) {
            return Err(raised(format_args!(
                "{index:04X}h sub-index {sub} is no parameter: writing it can move something; `force=True` writes it"
            )));
        }
        let options = ApplyOptions { verify, go_on, skip: 0 };
        let (results, error) = self.client()?.apply(node.0, &downloads, options);
        match error {
            Some(error) => Err(refused(error)),
            None => Ok(downloads
                .iter()
                .zip(&results)
                .chain(files.iter().map(|file| (file, &WriteResult::Unsent)))
                .map(|(download, result)| row(py, download, result))
                .collect()),
        }
    }
}

impl NativeBus {
    /// Rejects a different device, and a node that must not be configured now.
    fn require_safe(&mut self, node: NodeId, device: &Device, is_forced: bool) -> PyResult<()> {
        let client = self.client()?;
        let other = client.other_identity(node.0, device).map_err(refused)?;
        if let Some(other) = other.filter(|_| !is_forced) {
            return Err(raised(format_args!("node {} is not the described device: {other}", node.0)));
        }
        let dangers = client.dangers(node.0, device).map_err(refused)?;
        match dangers.into_iter().find(|danger| !is_forced || !danger.can_be_forced()) {
            Some(danger) => Err(not_configured(node, danger)),
            None => Ok(()),
        }
    }

    fn client(&mut self) -> PyResult<&mut BusClient> {
        self.0.as_mut().ok_or_else(|| raised("the bus is closed"))
    }
}

fn not_configured(node: NodeId, danger: Danger) -> PyErr {
    raised(format_args!("node {} is not configured: {danger}", node.0))
}

fn row<'py>(py: Python<'py>, download: &Download, result: &WriteResult) -> WrittenRow<'py> {
    let (word, found, abort) = match result {
        WriteResult::Written => ("written", None, None),
        WriteResult::Differs(found) => ("differs", Some(PyBytes::new(py, found)), None),
        WriteResult::Refused(abort) => ("refused", None, Some(abort.code())),
        _ => ("unsent", None, None),
    };
    (download.index, download.sub, PyBytes::new(py, &download.data), word, found, abort)
}

/// What is written to a node, and the entries whose data are in files, which are not written.
fn planned(
    shared: &super::shared::SharedDescription,
    node_id: u8,
) -> PyResult<(Vec<Download>, Vec<Download>)> {
    let mut options = PlanOptions::default();
    (options.node_id, options.scope) = (Some(node_id), Scope::Changed);
    let plan = ConciseDcf::plan(shared.device(), &options).map_err(raised)?;
    let files = plan.files().map(|file| Download::new(file.index, file.sub, [])).collect();
    Ok((plan.without_files().0, files))
}

fn milliseconds(seconds: f64) -> PyResult<u64> {
    if (0.0..=86_400.0).contains(&seconds) {
        return Ok((seconds * 1000.0) as u64);
    }
    Err(PyValueError::new_err(format!("`{seconds}` is not a number of seconds from 0 to 86400")))
}

/// An adapter of objdict.
fn adapter(address: &str) -> PyResult<Box<dyn Transport>> {
    let address: BusAddress = address.parse().map_err(raised)?;
    let BusAddress::Simulated { network, memory, new } = &address else {
        return open(&address).map_err(|error| refused(error.into()));
    };
    let file = opened(network)?;
    let bus = SimulatedBus::new(LiveBus::new(file.plant_nodes(), file.bit_rate(), new));
    Ok(match memory {
        Some(path) => Box::new(bus.with_memory(path).map_err(|error| refused(error.into()))?),
        None => Box::new(bus),
    })
}

/// An error of a bus as an exception.
fn refused(error: ClientError) -> PyErr {
    if let Some(interruption) = INTERRUPTION.take() {
        return interruption;
    }
    let exception = BusError::new_err(format!("{error} ({})", error.help()));
    let abort = error.abort().map(|abort| abort.code());
    Python::attach(|py| match exception.value(py).setattr("abort", abort) {
        Ok(()) => exception,
        Err(error) => error,
    })
}

/// Whether Python has a signal for the program, such as Ctrl-C.
fn is_interrupted() -> bool {
    let signal = Python::attach(|py| py.check_signals());
    signal.map_err(|error| INTERRUPTION.set(Some(error))).is_err()
}

/// The bus of python-can, with whatever adapter it has.
struct PythonCan {
    bus: Py<PyAny>,
    opened: Instant,
}

impl PythonCan {
    fn sent(&self, py: Python<'_>, frame: &BusFrame) -> PyResult<()> {
        let options = pyo3::types::PyDict::new(py);
        options.set_item("arbitration_id", frame.id())?;
        options.set_item("is_extended_id", false)?;
        options.set_item("is_remote_frame", frame.is_remote())?;
        options.set_item("data", frame.data())?;
        let message = py.import("can")?.getattr("Message")?.call((), Some(&options))?;
        self.bus.call_method1(py, "send", (message,)).map(drop)
    }

    fn received(&self, py: Python<'_>, until: u64) -> PyResult<Option<LoggedFrame>> {
        let left = until.saturating_sub(self.now()) as f64 / SECOND;
        let message = self.bus.bind(py).call_method1("recv", (left,))?;
        if message.is_none() {
            return Ok(None);
        }
        let is = |name: &str| message.getattr(name)?.is_truthy();
        let id: u32 = message.getattr("arbitration_id")?.extract()?;
        let data: Vec<u8> = message.getattr("data")?.extract()?;
        let time = LogTime::new(i64::try_from(self.now().saturating_mul(1000)).unwrap_or(i64::MAX), 6);
        let mut frame = LoggedFrame::new(time, 0, id, is("is_extended_id")?).with_data(&data);
        (frame.is_remote, frame.is_error) = (is("is_remote_frame")?, is("is_error_frame")?);
        Ok(Some(frame))
    }
}

impl Transport for PythonCan {
    fn send(&mut self, frame: &BusFrame) -> Result<(), TransportError> {
        Python::attach(|py| self.sent(py, frame)).map_err(lost)
    }

    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError> {
        Python::attach(|py| self.received(py, until)).map_err(lost)
    }

    fn now(&self) -> u64 {
        u64::try_from(self.opened.elapsed().as_micros()).unwrap_or(u64::MAX)
    }
}

/// An exception of python-can; Ctrl-C stays what it is.
fn lost(error: PyErr) -> TransportError {
    let text = error.to_string();
    if Python::attach(|py| error.is_instance_of::<pyo3::exceptions::PyKeyboardInterrupt>(py)) {
        INTERRUPTION.set(Some(error));
    }
    TransportError::Lost(text)
}
