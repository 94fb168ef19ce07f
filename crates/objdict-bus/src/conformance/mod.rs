//! What CiA 301 says of a node, checked on `objdict-device` with the values of a description.
//!
//! A check sees of the node what a master sees: frames, and when they come. What it expects is in the description and in CiA 301.

mod bench;
mod described;
mod emergency;
mod error_control;
mod groups;
mod lss;
mod mapping;
mod nmt;
mod objects;
mod pdo;
mod program;
mod remote;
mod rpdo;
mod sdo;
mod storage;
mod sync;
mod sync_frame;
mod time;
mod transfers;
mod unserved;

pub use self::groups::RemoteGroups;
pub use self::remote::{RemoteDevice, conformance_on, conformance_plan};
use objdict_device::Dictionary;
use objdict_generate::StorageGroup;

use crate::dictionary::{LiveDictionary, PowerOn};
use crate::model::Device;
use crate::node::NodeServices;
use bench::Bench;
use described::DescribedEntries;
use transfers::{ClientExchange, RequestTarget};

/// The result of a check.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Verdict {
    /// The node does what CiA 301 says.
    Passed,
    /// It does something else.
    Failed(String),
    /// The node does not have the service, and its documentation says so.
    NotServed,
    /// The description does not have these objects.
    Absent(String),
    /// Why the description makes the check impossible.
    Impossible(String),
    /// The check is planned, and does this to a device.
    Planned(CheckEffect),
}

/// What a check does to a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CheckEffect {
    /// It reads, or sends requests that the device must refuse.
    Reads,
    /// It writes values after a reset; the next reset puts them back.
    Writes,
    /// It starts, stops and resets the device.
    Commands,
}

objdict_model::messages! { CheckEffect: {
    Self::Reads => "reads";
    Self::Writes => "writes; a reset puts back the values";
    Self::Commands => "starts, stops and resets the device";
} }

/// A check and its result.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ConformanceCheck {
    /// The service, such as `NMT`; several checks are about one.
    pub service: &'static str,
    /// What is checked.
    pub name: String,
    /// The section of CiA 301 (version 4.2.0), such as `7.2.8.3.1`, or another document of CiA.
    pub section: &'static str,
    /// The result.
    pub verdict: Verdict,
}

/// The results of all checks of a description.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Conformance {
    /// The checks, service by service.
    pub checks: Vec<ConformanceCheck>,
}

impl Conformance {
    /// How many checks the node passes, and how many there are for this description.
    pub fn passed(&self) -> (usize, usize) {
        let count = |is_meant: fn(&Verdict) -> bool| {
            self.checks.iter().filter(|check| is_meant(&check.verdict)).count()
        };
        let applies = |verdict: &Verdict| {
            !matches!(verdict, Verdict::Absent(_) | Verdict::Impossible(_) | Verdict::Planned(_))
        };
        (count(|verdict| *verdict == Verdict::Passed), count(applies))
    }

    /// Whether no check failed.
    pub fn is_clean(&self) -> bool {
        !self.checks.iter().any(|check| matches!(check.verdict, Verdict::Failed(_)))
    }
}

/// Why a check ends before its end.
type CheckStep<T = ()> = Result<T, Verdict>;

/// A check of a service: each begins with a node that has just been switched on.
struct ServiceCheck {
    service: &'static str,
    name: &'static str,
    section: &'static str,
    /// What the check needs on a real bus; empty if it cannot be made there.
    remote: &'static [CheckEffect],
    run: CheckRun,
}

/// How a check is made.
enum CheckRun {
    /// By requests to the SDO server about an entry.
    Frames(RequestTarget, &'static [ClientExchange]),
    Function(fn(&mut Bench<'_>) -> CheckStep),
}

impl ServiceCheck {
    fn run(&self, bench: &mut Bench<'_>) -> CheckStep {
        match self.run {
            CheckRun::Frames(target, exchanges) => transfers::run(bench, target, exchanges),
            CheckRun::Function(run) => run(bench),
        }
    }
}

/// The checks of a service: section, name, what it needs on a real bus if it can be made there, function.
macro_rules! checks {
    ($service:tt: $($section:literal $name:literal $(@$remote:ident)? $run:expr;)*) => {
        pub(super) const CHECKS: &[super::ServiceCheck] = &[$(super::ServiceCheck {
            service: $service,
            name: $name,
            section: $section,
            remote: &[$(super::CheckEffect::$remote)?],
            run: super::CheckRun::Function($run),
        }),*];
    };
}
use checks;

const SERVICES: [&[ServiceCheck]; 14] = [
    nmt::CHECKS,
    error_control::CHECKS,
    sdo::CHECKS,
    transfers::CHECKS,
    pdo::CHECKS,
    rpdo::CHECKS,
    mapping::CHECKS,
    sync::CHECKS,
    time::CHECKS,
    emergency::CHECKS,
    storage::CHECKS,
    program::CHECKS,
    lss::CHECKS,
    unserved::CHECKS,
];

/// Checks the node of a description, which has the defaults and the node-ID.
pub fn conformance(device: &Device, node_id: u8) -> Conformance {
    conformance_of(device, node_id, &[], |dictionary| dictionary)
}

/// Checks the node of a build with these storage groups and those of the description; without any, all values are stored. The
/// dictionary can be another one than that of the description.
pub fn conformance_of<D: Dictionary + Clone + 'static>(
    device: &Device,
    node_id: u8,
    groups: &[StorageGroup],
    dictionary: impl FnOnce(LiveDictionary) -> D,
) -> Conformance {
    let device = PowerOn::Defaults.values_of(device);
    let live = LiveDictionary::of_table(&device, node_id, groups);
    let (pdos, longest) = (live.pdos(), live.longest());
    let described = DescribedEntries::new(&device, node_id, &live);
    let mut node = node(&described, dictionary(live), &pdos, longest);
    let boot_up = node.boot(0);
    let bench = || Bench::new(&described, node.again(), boot_up);
    let of_groups = if groups.is_empty() { &[] } else { storage::OF_GROUPS };
    let of_services = SERVICES.into_iter().flatten().chain(of_groups).map(|check| ConformanceCheck {
        service: check.service,
        name: check.name.to_owned(),
        section: check.section,
        verdict: verdict(check.run(&mut bench())),
    });
    let mut checks: Vec<ConformanceCheck> = of_services.chain(unserved::of_objects(&described)).collect();
    checks.extend(objects::checks(&described, &mut bench()));
    Conformance { checks }
}

/// The node, with a memory for a program if the description has one.
fn node<D: Dictionary + Clone + 'static>(
    described: &DescribedEntries,
    dictionary: D,
    pdos: &[Vec<u16>; 2],
    longest: usize,
) -> Box<dyn NodeServices> {
    let node_id = described.node_id;
    if !program::is_described(described) {
        return crate::node::lone(node_id, dictionary, pdos, longest);
    }
    crate::node::lone(node_id, program::with_memory(dictionary), pdos, longest)
}

fn verdict(step: CheckStep) -> Verdict {
    step.err().unwrap_or(Verdict::Passed)
}

fn failed<T>(text: impl Into<String>) -> CheckStep<T> {
    Err(Verdict::Failed(text.into()))
}

fn impossible<T>(text: impl Into<String>) -> CheckStep<T> {
    Err(Verdict::Impossible(text.into()))
}

fn absent<T>(text: impl Into<String>) -> CheckStep<T> {
    Err(Verdict::Absent(text.into()))
}

/// Fails unless a condition holds.
fn ensure(holds: bool, text: impl FnOnce() -> String) -> CheckStep {
    if holds { Ok(()) } else { failed(text()) }
}
