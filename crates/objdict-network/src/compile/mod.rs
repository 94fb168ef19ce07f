//! The downloads of each node, in the order of dcfgen 2.4.2.
//!
//! It depends on its submodule `compiler`, which applies each download when it is created and returns the type
//! defined here.

mod compiler;
mod pdo;

use std::cell::OnceCell;
use std::collections::BTreeSet;

use objdict_model::diagnostic::Severity;

use self::compiler::{Compiler, FilePart};
use crate::compiled::{Compiled, DcfgenMode, Slave};
use crate::diagnostic::{At, Diagnostic, say};
use crate::download::ConciseDcf;
use crate::identity;
use crate::manager::complete;
use crate::model::{Address, Field, Part as DevicePart, Place};
use crate::network::{DownloadRequest, Manager, Network, Node, RequestedValue, Said};
use crate::rules::{
    HEARTBEAT_AND_GUARDING, INVALID_VALUE, MISSING_ENTRY, NO_HEARTBEAT_CONSUMER, SILENT_NODE, UNKNOWN_NODE_ID,
};
use crate::source::Span;

/// The first and the last CAN-ID for PDOs from number 5 on.
const POOL: std::ops::RangeInclusive<u32> = 0x680..=0x6DF;

/// Creates the downloads of all nodes.
pub fn compile(network: &Network, mode: DcfgenMode) -> Compiled {
    let locked: BTreeSet<u32> = network.lock.can_ids().collect();
    let mut pool = POOL.filter(|id| !locked.contains(id));
    let mut compiled = Compiled::default();
    for position in 0..network.nodes.len() {
        compile_node(network, position, mode, &mut pool, &mut compiled);
    }
    if mode == DcfgenMode::Corrected {
        complete(network, &mut compiled);
    }
    compiled
}

/// Adds the manager to a network that was compiled without its description.
pub(crate) fn compile_manager(network: &Network, compiled: &mut Compiled) {
    let Some(manager) = network.manager.as_ref() else { return };
    let Some(node) = manager.node else { return };
    compile_node(network, node, DcfgenMode::Corrected, &mut std::iter::empty(), compiled);
    complete(network, compiled);
}

fn compile_node(
    network: &Network,
    position: usize,
    mode: DcfgenMode,
    pool: &mut dyn Iterator<Item = u32>,
    compiled: &mut Compiled,
) {
    let node = &network.nodes[position];
    let Some(node_id) = node.node_id.filter(|node_id| (1..=127).contains(&node_id.value)) else {
        // the key of the manager that is missing was reported
        if network.is_made(position) {
            return;
        }
        let message = say!("the node-ID of `{}` is unknown", node.name.value);
        let place = Place::of(DevicePart::Commissioning).field(Field::NodeId);
        let finding = Diagnostic::new(&UNKNOWN_NODE_ID, node.name.at, message)
            .label(At::Node(position, place), "no node-ID");
        compiled.findings.push(finding.help("add the node-ID, or use the node's DCF"));
        return;
    };
    let mut compiler = Compiler::new((position, node), node_id.value, mode, &mut compiled.findings);
    let other = network.manager.as_ref().filter(|manager| manager.node != Some(position));
    let slave = slave(network, &mut compiler, other, pool);
    match other.is_none() && network.manager.is_some() {
        true => compiled.manager = Some(slave),
        false => compiled.slaves.push(slave),
    }
}

fn slave(
    network: &Network,
    compiler: &mut Compiler<'_, '_>,
    manager: Option<&Manager>,
    pool: &mut dyn Iterator<Item = u32>,
) -> Slave {
    let node = compiler.node;
    time(compiler);
    heartbeat(compiler);
    guarding(compiler);
    for &(sub, value) in &node.error_behavior {
        compiler.change(Address { index: 0x1029, sub: Some(sub) }, value.value.into(), value.at);
    }
    compiler.part = FilePart::Implied;
    node.implied.iter().for_each(|setting| compiler.set(setting));
    compiler.part = FilePart::Setting;
    node.settings.iter().for_each(|setting| compiler.set(setting));
    compiler.part = FilePart::Key;
    let mut pdos = pdo::states(compiler);
    for request in &node.pdos {
        pdo::configure(compiler, &mut pdos, request, &network.lock, pool);
    }
    let conditional = compiler.downloads.len();
    compiler.part = FilePart::Download;
    for request in &node.downloads {
        download(compiler, request);
    }
    compiler.part = FilePart::Key;
    if network.is_as_described {
        compiler.take_stored();
    }
    let own = compiler.downloads.len();
    if let Some(manager) = manager.filter(|_| !network.is_as_described) {
        consumers(network, compiler, manager);
    }
    compiler.contradictions();
    let heartbeat = compiler.heartbeat();
    if manager.is_some_and(Manager::monitors_nodes) {
        monitored(compiler, heartbeat);
    }
    let guard_time = guard_time(compiler, heartbeat);
    if compiler.mode == DcfgenMode::Corrected {
        pdos = pdo::effective(compiler, &pdos);
    }
    // monitoring of the manager comes first
    let consumers = compiler.downloads.split_off(own);
    let has_only_consumers = own == 0 && !consumers.is_empty();
    compiler.downloads.splice(0..0, consumers);
    Slave {
        node: compiler.position,
        node_id: compiler.node_id,
        downloads: ConciseDcf(std::mem::take(&mut compiler.downloads)),
        services: OnceCell::new(),
        arranged: OnceCell::new(),
        unconditional: own - conditional,
        has_only_consumers,
        pdos,
        heartbeat,
        emcy: compiler.emcy(),
        guard_time,
        identity: identity::expected(network, node, compiler.node_id, compiler.mode),
        origins: std::mem::take(&mut compiler.origins),
        former: std::mem::take(&mut compiler.former),
        device: std::mem::take(&mut compiler.device),
    }
}

/// 1012h. dcfgen compares with 100h and not with the value of the node.
fn time(compiler: &mut Compiler<'_, '_>) {
    let Some(request) = compiler.node.time_cob_id else { return };
    let at = Address { index: 0x1012, sub: None };
    match compiler.mode {
        DcfgenMode::Exact if request.value == 0x100 => {}
        DcfgenMode::Exact => compiler.write(at, request.value.into(), request.at, Severity::Warning),
        DcfgenMode::Corrected => compiler.change(at, request.value.into(), request.at),
    }
}

/// 1017h.
fn heartbeat(compiler: &mut Compiler<'_, '_>) {
    if let Some(request) = compiler.node.heartbeat.producer {
        compiler.change(Address { index: 0x1017, sub: None }, request.value.into(), request.at);
    }
}

/// Reports a consumer heartbeat time of the manager that does not fit into 1016h.
fn monitored(compiler: &mut Compiler<'_, '_>, heartbeat: u16) {
    let heartbeats = &compiler.node.heartbeat;
    if heartbeats.consumer_time(heartbeat).is_none() {
        let at = compiler.said(0x1017).unwrap_or(compiler.node.name.at);
        let finding = too_long(at, heartbeats.factor, heartbeat);
        compiler.findings.push(finding.label_each(compiler.origin(0x1017, 0), "the heartbeat time"));
    }
}

/// A consumer heartbeat time that does not fit into 1016h.
fn too_long(at: Span, factor: f64, producer: u16) -> Diagnostic {
    let message = say!("{} times {} ms is more than 65535 ms, the longest time in 1016h", factor, producer);
    let finding = Diagnostic::new(&NO_HEARTBEAT_CONSUMER, at, message).severity(Severity::Error);
    finding.help("lower the producer heartbeat time or the multiplier")
}

/// 100Ch and 100Dh.
fn guarding(compiler: &mut Compiler<'_, '_>) {
    let (time, factor) = compiler.node.guarding;
    let factor = factor.map(|factor| Said::new(u16::from(factor.value), factor.at));
    for (index, request) in [(0x100C, time), (0x100D, factor)] {
        if let Some(request) = request {
            compiler.change(Address { index, sub: None }, request.value.into(), request.at);
        }
    }
}

/// The final guard time for the manager: none if there is a heartbeat.
fn guard_time(compiler: &mut Compiler<'_, '_>, heartbeat: u16) -> u16 {
    // dcfgen has the manager guard a node without the objects
    let requested = |request: Option<u16>, index| match request.filter(|_| compiler.mode == DcfgenMode::Exact)
    {
        Some(request) => request.into(),
        None => compiler.present(index, 0),
    };
    let (time, factor) = compiler.node.guarding;
    let time = requested(time.map(|time| time.value), 0x100C);
    let factor = requested(factor.map(|factor| factor.value.into()), 0x100D);
    if time != 0 && factor != 0 && heartbeat != 0 {
        let at = compiler.said(0x100C).unwrap_or(compiler.node.name.at);
        let message = say!("`{}` has both a heartbeat and node guarding", compiler.node.name.value);
        let finding = Diagnostic::new(&HEARTBEAT_AND_GUARDING, at, message)
            .label_each(compiler.origin(0x1017, 0), "the heartbeat time")
            .label_each(compiler.origin(0x100C, 0), "the guard time")
            .label_each(compiler.origin(0x100D, 0), "the life time factor");
        compiler.findings.push(
            finding.help("remove the guard time and the life time factor; the manager uses the heartbeat"),
        );
        return 0;
    }
    u16::try_from(time).unwrap_or(0)
}

/// A download that is sent also of a value that the node already has.
fn download(compiler: &mut Compiler<'_, '_>, request: &Said<DownloadRequest>) {
    let DownloadRequest { index, sub, value } = &request.value;
    let at = Address { index: *index, sub: Some(*sub) };
    match value {
        RequestedValue::Integer(number) => compiler.write(at, *number, request.at, Severity::Error),
        RequestedValue::Real(number) => compiler.write_real(at, *number, request.at),
        RequestedValue::Text(text) => compiler.write_text(at, text, request.at),
    }
}

/// The producer heartbeat time of the manager: from the network file, otherwise from its description.
fn heartbeat_of(network: &Network, manager: &Manager) -> u16 {
    let described = || {
        let node = &network.nodes[manager.node?];
        let number = identity::number(&node.device, 0x1017, 0, manager.node_id?.value)?;
        u16::try_from(number).ok()
    };
    manager.heartbeat.producer.map(|time| time.value).or_else(described).unwrap_or(0)
}

/// 1016h: the node monitors the manager, or no longer does.
fn consumers(network: &Network, compiler: &mut Compiler<'_, '_>, manager: &Manager) {
    const CONSUMERS: u16 = 0x1016;
    let Some(manager_id) = manager.node_id.map(|node_id| node_id.value) else { return };
    let producer = heartbeat_of(network, manager);
    let time = if producer == 0 { Some(0) } else { manager.heartbeat.consumer_time(producer) };
    let subs: Vec<(u8, u32)> = (1..=254)
        .filter(|&sub| compiler.has(Address { index: CONSUMERS, sub: Some(sub) }))
        .map(|sub| (sub, u32::try_from(compiler.present(CONSUMERS, sub)).unwrap_or(0)))
        .collect();
    let node_of = |consumer: u32| (consumer >> 16) as u8;
    let request = compiler.node.heartbeat.consumer.filter(|request| request.value);
    let said = request.map_or(compiler.node.name.at, |request| request.at);
    let put = |compiler: &mut Compiler<'_, '_>, sub, value: u32| {
        let at = Address { index: CONSUMERS, sub: Some(sub) };
        compiler.write(at, value.into(), said, Severity::Error);
    };
    let is_silent = time == Some(0);
    if let Some(request) = request.filter(|_| is_silent) {
        let message = say!(
            "`{}` is configured to monitor `{}`, which sends no heartbeat",
            compiler.node.name.value,
            manager.name.value
        );
        let finding = Diagnostic::new(&SILENT_NODE, request.at, message);
        compiler.findings.push(finding.help("set the manager's producer heartbeat time").understood());
    }
    let Some(request) = request.filter(|_| !is_silent) else {
        // entries that the network file writes itself are kept
        let is_stale = |&(sub, consumer): &(u8, u32)| {
            let is_of_manager = consumer & 0xFFFF != 0 && node_of(consumer) == manager_id;
            is_of_manager && !compiler.origins.contains_key(&(CONSUMERS, sub))
        };
        let stale: Vec<u8> = subs.iter().filter(|sub| is_stale(sub)).map(|(sub, _)| *sub).collect();
        // dcfgen inserts each one before the previous ones
        stale.into_iter().rev().for_each(|sub| put(compiler, sub, u32::from(manager_id) << 16));
        return;
    };
    let unused = |consumer: u32| consumer & 0xFFFF == 0 || !(1..=127).contains(&node_of(consumer));
    let own = subs.iter().find(|&&(_, consumer)| node_of(consumer) == manager_id);
    let place = own.or_else(|| subs.iter().find(|&&(_, consumer)| unused(consumer))).map(|&(sub, _)| sub);
    let finding = |message| Diagnostic::new(&NO_HEARTBEAT_CONSUMER, request.at, message);
    let name = &compiler.node.name.value;
    match (place, time) {
        (Some(sub), Some(time)) => put(compiler, sub, u32::from(manager_id) << 16 | u32::from(time)),
        (Some(_), None) => compiler.findings.push(too_long(request.at, manager.heartbeat.factor, producer)),
        (None, _) if subs.is_empty() => compiler.findings.push(
            finding(say!("`{}` has no 1016h, so it cannot monitor the manager", name))
                .help("do not let it monitor the manager"),
        ),
        (None, _) => compiler.findings.push(
            finding(say!("all entries of 1016h of `{}` monitor other nodes", name))
                .label(compiler.place(Place::object(CONSUMERS)), "no entry is free")
                .help("free one with a download of 0, or do not let it monitor the manager"),
        ),
    }
}

/// A finding about an entry that the node does not have.
fn missing(node: &Node, at: Address) -> crate::diagnostic::Text {
    let name = &node.name.value;
    match (node.device.object(at.index), at.sub) {
        (Some(_), Some(sub)) => say!("`{}` has no {:04X}h:{:02X}", name, at.index, sub),
        _ => say!("`{}` has no {:04X}h", name, at.index),
    }
}
