//! The PDOs of a node.

use super::POOL;
use super::compiler::Compiler;
use crate::compiled::{DcfgenMode, PdoState, indexes};
use crate::configure::PdoName;
use crate::diagnostic::{At, Diagnostic, Severity, say};
use crate::download::transferred_type;
use crate::lock::NetworkLock;
use crate::model::{Address, CobId, DataType, Field, MappedObject, Part, PdoKind, Place};
use crate::network::{PdoRequest, RequestedCobId, Said};
use crate::origin::{because, refusing_field};
use crate::rules::{IDLE_PDO, MISSING_ENTRY, NO_FREE_CAN_ID, PDO_TOO_LONG, UNMAPPABLE_ENTRY};

/// The PDOs after the downloads so far.
pub(super) fn states(compiler: &Compiler<'_, '_>) -> Vec<PdoState> {
    let indexes = compiler.device.objects.range(0x1400..0x1A00);
    let pdos = indexes.filter_map(|(index, _)| PdoKind::of_communication(*index));
    pdos.map(|(kind, number)| state(compiler, PdoName { kind, number })).collect()
}

fn state(compiler: &Compiler<'_, '_>, pdo: PdoName) -> PdoState {
    let (communication, mapping) = indexes(pdo);
    let [parameters, slots] = [communication, mapping].map(|index| compiler.object(index));
    let count = compiler.number(parameters, 0);
    let number = |sub: u8| if i128::from(sub) <= count { compiler.number(parameters, sub) } else { 0 };
    let is_tpdo = pdo.kind == PdoKind::Tpdo;
    let timer = u16::try_from(number(5)).unwrap_or(0);
    let has_cob_id = count >= 1 && compiler.has(Address { index: communication, sub: Some(1) });
    let mapped = u8::try_from(compiler.number(slots, 0)).unwrap_or(0);
    let objects = (1..=mapped).filter_map(|sub| {
        let object = MappedObject::from_number(u32::try_from(compiler.number(slots, sub)).ok()?);
        (!object.is_unused()).then_some((sub, object))
    });
    PdoState {
        pdo,
        cob_id: if has_cob_id { u32::try_from(number(1)).unwrap_or(CobId::BIT_31) } else { CobId::BIT_31 },
        is_enabled: true,
        transmission: u8::try_from(number(2)).unwrap_or(0),
        inhibit_time: if is_tpdo { u16::try_from(number(3)).unwrap_or(0) } else { 0 },
        event_timer: if is_tpdo { timer } else { 0 },
        deadline: if is_tpdo { 0 } else { timer },
        sync_start: if is_tpdo { u8::try_from(number(6)).unwrap_or(0) } else { 0 },
        count: mapped,
        mapping: objects.collect(),
    }
}

/// The PDOs in the effective dictionary. The manager's counterparts are known only from the requests.
pub(super) fn effective(compiler: &Compiler<'_, '_>, requested: &[PdoState]) -> Vec<PdoState> {
    let mut pdos = states(compiler);
    for (state, requested) in pdos.iter_mut().zip(requested) {
        match state.pdo.kind {
            PdoKind::Tpdo => state.deadline = requested.deadline,
            PdoKind::Rpdo => {
                let PdoState { inhibit_time, event_timer, sync_start, .. } = *requested;
                *state = PdoState { inhibit_time, event_timer, sync_start, ..state.clone() };
            }
        }
    }
    pdos
}

/// Configures a PDO: off, parameters, mapping, on.
pub(super) fn configure(
    compiler: &mut Compiler<'_, '_>,
    states: &mut [PdoState],
    request: &PdoRequest,
    lock: &NetworkLock,
    pool: &mut dyn Iterator<Item = u32>,
) {
    let Some(state) = states.iter_mut().find(|state| state.pdo == request.pdo) else {
        let message =
            say!("`{}` has no {} {}", compiler.node.name.value, request.pdo.kind, request.pdo.number);
        let finding = Diagnostic::new(&MISSING_ENTRY, request.at, message);
        compiler.findings.push(finding.help("remove the PDO, or use one that the node has"));
        return;
    };
    let (communication, _) = indexes(request.pdo);
    let cob_id_at = Address { index: communication, sub: Some(1) };
    let before = state.cob_id;
    let said = request.cob_id.map_or(request.at, |cob_id| cob_id.at);
    match request.cob_id.map(|cob_id| cob_id.value) {
        Some(RequestedCobId::Number(number)) => state.cob_id = number,
        Some(RequestedCobId::Auto) => match automatic(request.pdo, compiler, lock, pool) {
            Some(cob_id) => state.cob_id = cob_id,
            None => {
                let message = say!(
                    "no CAN-ID is left for {} {} of `{}`",
                    request.pdo.kind,
                    request.pdo.number,
                    compiler.node.name.value
                );
                let finding = Diagnostic::new(&NO_FREE_CAN_ID, said, message);
                compiler.findings.push(finding.help("assign a CAN-ID by number"));
            }
        },
        None => {}
    }
    let off = state.cob_id | CobId::BIT_31;
    // a PDO that cannot be disabled can have different times
    let stays = state.cob_id == before && request.enabled && request.mapping.is_none();
    let stays = stays && compiler.mode == DcfgenMode::Corrected && compiler.is_constant(cob_id_at);
    if before != off && !stays {
        compiler.write(cob_id_at, off.into(), said, Severity::Error);
    }
    if state.cob_id & CobId::BIT_31 != 0 {
        if request.enabled && request.cob_id.is_none() && request.has_parameters() {
            idle(compiler, request);
        }
        return;
    }
    parameters(compiler, state, request, communication);
    if let Some(objects) = &request.mapping {
        map(compiler, state, objects, request);
    }
    state.is_enabled = request.enabled;
    if request.enabled && !stays {
        compiler.write(cob_id_at, state.cob_id.into(), said, Severity::Error);
    }
}

/// Reports that settings of a PDO are not sent.
fn idle(compiler: &mut Compiler<'_, '_>, request: &PdoRequest) {
    let PdoName { kind, number } = request.pdo;
    let name = &compiler.node.name.value;
    let message =
        say!("{} {} of `{}` has no valid COB-ID, so its settings have no effect", kind, number, name);
    let finding = Diagnostic::new(&IDLE_PDO, request.at, message).help("add its COB-ID, or `auto`");
    let place = compiler.node.device.value_place(indexes(request.pdo).0, 1);
    compiler.findings.push(finding.label(At::Node(compiler.position, place), "the COB-ID"));
}

/// The CAN-ID of a PDO: predefined for PDO 1 to 4, otherwise the one of an earlier build or the next of the
/// pool.
fn automatic(
    pdo: PdoName,
    compiler: &Compiler<'_, '_>,
    lock: &NetworkLock,
    pool: &mut dyn Iterator<Item = u32>,
) -> Option<u32> {
    match pdo.kind.predefined_can_id(pdo.number) {
        Some(base) => Some(u32::from(base) + u32::from(compiler.node_id)),
        None => {
            let locked = lock.pdo(&compiler.node.name.value, pdo).map(|locked| locked.can_id);
            locked.filter(|id| POOL.contains(id)).or_else(|| pool.next())
        }
    }
}

/// The sub-indexes 2 to 6. Parameters that do not apply to a receiver describe the sender, the manager.
fn parameters(compiler: &mut Compiler<'_, '_>, state: &mut PdoState, request: &PdoRequest, index: u16) {
    let is_tpdo = request.pdo.kind == PdoKind::Tpdo;
    let mut set = |sub, request: Option<Said<u16>>, present: &mut u16, is_own: bool| {
        let Some(request) = request.filter(|request| request.value != *present) else { return };
        *present = request.value;
        if is_own {
            compiler.write(
                Address { index, sub: Some(sub) },
                request.value.into(),
                request.at,
                Severity::Error,
            );
        }
    };
    let wide =
        |request: Option<Said<u8>>| request.map(|request| Said::new(u16::from(request.value), request.at));
    let mut transmission = state.transmission.into();
    set(2, wide(request.transmission), &mut transmission, true);
    set(3, request.inhibit_time, &mut state.inhibit_time, is_tpdo);
    set(5, request.event_timer, &mut state.event_timer, is_tpdo);
    set(5, request.deadline, &mut state.deadline, !is_tpdo);
    let mut sync_start = state.sync_start.into();
    set(6, wide(request.sync_start), &mut sync_start, is_tpdo);
    // both originate from a byte
    state.transmission = transmission as u8;
    state.sync_start = sync_start as u8;
}

fn map(
    compiler: &mut Compiler<'_, '_>,
    state: &mut PdoState,
    objects: &[Said<Address>],
    request: &PdoRequest,
) {
    let (_, index) = indexes(request.pdo);
    let count_at = Address { index, sub: Some(0) };
    if state.count > 0 || !objects.is_empty() {
        state.count = 0;
        state.mapping.clear();
        compiler.write(count_at, 0, request.at, Severity::Error);
    }
    let mut bits = 0;
    for object in objects {
        let Some(mapped) = mapped(compiler, request.pdo.kind, object) else { continue };
        bits += u32::from(mapped.bits);
        let Some(sub) = state.count.checked_add(1) else { break };
        state.count = sub;
        state.mapping.insert(sub, mapped);
        compiler.write(
            Address { index, sub: Some(sub) },
            mapped.to_number().into(),
            object.at,
            Severity::Error,
        );
    }
    if bits > 64 {
        let message = say!(
            "{} {} of `{}` maps {} bits, but a frame has 64",
            request.pdo.kind,
            request.pdo.number,
            compiler.node.name.value,
            bits
        );
        compiler.findings.push(
            Diagnostic::new(&PDO_TOO_LONG, request.at, message)
                .help("move entries to another PDO")
                .understood(),
        );
    }
    if state.count > 0 {
        compiler.write(count_at, state.count.into(), request.at, Severity::Error);
    }
}

/// The content of a mapping entry.
fn mapped(compiler: &mut Compiler<'_, '_>, kind: PdoKind, object: &Said<Address>) -> Option<MappedObject> {
    let Address { index, sub } = object.value;
    let sub = sub.unwrap_or(0);
    let device = &compiler.node.device;
    let data_type = DataType(index);
    if index < 0x20 && compiler.mode == DcfgenMode::Corrected {
        let usage = device.dummy_usage.as_ref().and_then(|usage| usage.types.get(&data_type));
        let is_allowed = kind == PdoKind::Rpdo && data_type.is_dummy() && usage != Some(&false);
        if let Some(bits) = data_type.bit_length().filter(|_| is_allowed) {
            return Some(MappedObject { index, sub, bits });
        }
        let message =
            say!("{} of `{}` cannot be a dummy of this {}", data_type, compiler.node.name.value, kind);
        let place = Place::of(Part::DummyUsage).field(Field::Named(format!("Dummy{index:04X}").into()));
        let refused = (usage == Some(&false)).then(|| compiler.place(place));
        let finding =
            Diagnostic::new(&UNMAPPABLE_ENTRY, object.at, message).label_each(refused, "not allowed");
        compiler.findings.push(finding.help("use a data type that `DummyUsage` of the node allows"));
        return None;
    }
    let Some(entry) = device.entry(index, sub) else {
        let finding = Diagnostic::new(&MISSING_ENTRY, object.at, super::missing(compiler.node, object.value))
            .help("correct index and sub-index");
        compiler.findings.push(because(finding, compiler.position, Place::object(index)));
        return None;
    };
    let reason = if !entry.is_mappable() {
        Some("does not support PDO mapping")
    } else if !entry.fits_pdo(kind) {
        Some(if kind == PdoKind::Rpdo { "cannot be written by an RPDO" } else { "cannot be read by a TPDO" })
    } else {
        None
    };
    if let Some(reason) = reason {
        let message = say!("{:04X}h:{:02X} of `{}` {}", index, sub, compiler.node.name.value, reason);
        let finding = Diagnostic::new(&UNMAPPABLE_ENTRY, object.at, message).help("map a different entry");
        compiler.report(finding.understood(), object.value, refusing_field(&entry, kind));
    }
    let bits = transferred_type(device, index, sub).and_then(DataType::bit_length);
    if bits.is_none() {
        let message =
            say!("{:04X}h:{:02X} of `{}` has no fixed length", index, sub, compiler.node.name.value);
        let finding = Diagnostic::new(&UNMAPPABLE_ENTRY, object.at, message).help("map a different entry");
        compiler.report(finding, object.value, Field::DataType);
    }
    Some(MappedObject { index, sub, bits: bits? })
}
