//! Network managers: the start of the network and the assigned slaves.

use crate::Facts;
use crate::demands::{self, Against, Applied};
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, Text, say};
use crate::model::{DeviceKind, Field, Part, Place};
use crate::rule::rules;

rules! {
    "cia302/contradictory-startup" = CONTRADICTORY_STARTUP, Warning, Against(contradictory_startup);
    summary: "bits of 1F80h contradict each other or the slave assignment",
    checks: "1F80h must not have both bits 4 and 6 set, because bit 6 takes precedence. It must not have both bits 1 and 3 set, because bit 1 has no effect with bit 3. In a configuration that assigns slaves (1F81h, bit 0), bit 0 of 1F80h (NMT master) must be set.",
    why: "The device performs one of the two actions, but the author may expect the other one.",
    example: "`[1F80]` with `DefaultValue=0x00000051`: on an error of a mandatory slave all nodes are reset (bit 4) and all are stopped (bit 6)",
    remedy: "Clear bit 4 to stop all nodes or bit 6 to reset them; clear bit 1 when slaves are not started (bit 3).",
    source: "CiA 302-2 (1F80h)",

    "cia302/flying-master-time-slots" = FLYING_MASTER_TIME_SLOTS, Error, Against(flying_master_time_slots);
    summary: "the time slots of a flying master overlap",
    checks: "The priority time slot of 1F90h (sub-index 4) must be longer than 127 times the device time slot (sub-index 5).",
    why: "Before a device claims the master role, it waits for the priority time slot times its priority plus the device time slot times its node-ID. If the slots overlap, a device of low priority claims the role before one of high priority.",
    example: "`[1F90sub4]` with `DefaultValue=1000` and `[1F90sub5]` with `DefaultValue=10`: 127 times 10 is 1270",
    remedy: "Increase the priority time slot or reduce the device time slot. The defaults of the document are 1500 and 10.",
    source: "CiA 302-2 (1F90h)",

    "cia302/incomplete-guarding" = INCOMPLETE_GUARDING, Warning, Against(incomplete_guarding);
    summary: "the guarding of a slave has only one of guard time and retry factor",
    checks: "Each entry of 1F81h for a slave of this master (bit 0) must have both a guard time (bits 16 to 31) and a retry factor (bits 8 to 15), or neither.",
    why: "With only one of the two, guarding is off and the loss of a node is not detected.",
    example: "`[1F81sub5]` with `DefaultValue=0x01F40001`: 500 ms and no retries",
    remedy: "Set both, or clear both and use heartbeat.",
    source: "CiA 302-2 (1F81h)",

    "cia302/manager-not-marked" = MANAGER_NOT_MARKED, Note, Applied(manager_not_marked), fix Unsafe;
    summary: "the device has objects of a network manager but is not marked as one",
    checks: "Reports a device with lists of nodes (1F20h, 1F22h, 1F23h, 1F25h, 1F81h to 1F88h) and `SimpleBootUpMaster=0`.",
    why: "A tool that searches for the network manager ignores the device.",
    example: "`[1F81]` with `SimpleBootUpMaster=0`",
    remedy: "Write `SimpleBootUpMaster=1` if the device can boot a network.",
    source: "CiA 306-1 §4.4; CiA 302-2",

    "cia302/master-without-slaves" = MASTER_WITHOUT_SLAVES, Warning, Against(master_without_slaves);
    summary: "an NMT master has no list of slaves",
    checks: "If bit 0 of 1F80h makes the device NMT master, it must have the slave assignment, 1F81h. Modular devices are not checked, because a module may provide the object.",
    why: "The master does not know which nodes to expect: it boots none of them and detects no missing node.",
    example: "`[1F80]` with `DefaultValue=0x00000001`, without `[1F81]`",
    remedy: "Describe 1F81h, or clear bit 0 of 1F80h if the device is not a master.",
    source: "CiA 302-2 (1F80h, 1F81h)",

    "cia302/self-starting-not-marked" = SELF_STARTING_NOT_MARKED, Note,
        Against(self_starting_not_marked), fix Unsafe;
    summary: "the device starts by itself but is not marked as a simple boot-up slave",
    checks: "Reports `SimpleBootUpSlave=0` in a device that enters operational without a master (bits 0 and 2 of 1F80h are clear).",
    why: "A master that relies on the description configures the node while it already transmits. Some drives have 0 in 1F80h and still wait for their master, so the finding is a note.",
    example: "`[1F80]` with `DefaultValue=0x00000000`, and `SimpleBootUpSlave=0`",
    remedy: "Write `SimpleBootUpSlave=1`, or set bit 2 of 1F80h if the device waits for its master.",
    source: "CiA 302-2 (1F80h); CiA 306-1 §4.4",

    "cia302/slave-not-assigned" = SLAVE_NOT_ASSIGNED, Warning, Against(slave_not_assigned);
    summary: "an entry of 1F81h configures a node that is not a slave",
    checks: "Bit 0 (slave of this master) must be set in each entry of 1F81h that is not 0. In a DCF, no entry may make the node its own slave. The rule reports one finding, which lists every such entry.",
    why: "Without bit 0 the manager ignores all other bits. It does not boot a node that is marked as mandatory and does not guard it.",
    example: "`[1F81sub5]` with `DefaultValue=0x00000008`, a mandatory node that is not a slave",
    remedy: "Set bit 0, or write 0 if the node is not a slave of this master.",
    source: "CiA 302-2 (1F81h)",
}

/// Two bits and the effect of setting both.
const CONTRADICTIONS: [(u8, u8, &str); 2] = [
    (
        4,
        6,
        "on an error of a mandatory slave all nodes are reset (bit 4) or stopped (bit 6); bit 6 takes precedence",
    ),
    (1, 3, "slaves are started simultaneously (bit 1) or not at all (bit 3); bit 1 has no effect"),
];

fn contradictory_startup(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let value = at.object.value(0).filter(|_| at.index == 0x1F80 && at.has_its_shape());
    let Some(value) = value.and_then(|value| value.as_integer()) else { return };
    let is_set = |bit: u8| value >> bit & 1 == 1;
    for (first, second, meaning) in CONTRADICTIONS {
        if is_set(first) && is_set(second) {
            let message = say!("bits {} and {} of 1F80h are set: {}", first, second, Text::from(meaning));
            let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
            findings.push(finding.help(say!("clear bit {} or bit {}", first, second)));
        }
    }
    let is_assigned = |&node: &u8| {
        at.device.value(0x1F81, node).and_then(|slave| slave.as_integer()).is_some_and(|slave| slave & 1 == 1)
    };
    let slave = (1..=127).find(is_assigned).filter(|_| at.device.kind == DeviceKind::Node && !is_set(0));
    if let Some(node) = slave {
        let message =
            say!("1F81h assigns node {}, but bit 0 of 1F80h is 0: the device is not NMT master", node);
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
        let finding = finding.label(at.device.value_place(0x1F81, node), "a slave");
        findings.push(finding.help("set bit 0, or remove the slaves"));
    }
}

/// The highest node-ID.
const HIGHEST_NODE_ID: i128 = 127;

fn flying_master_time_slots(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.index != 0x1F90 || !at.has_its_shape() {
        return;
    }
    let value = |sub: u8| at.object.value(sub)?.as_integer();
    let (Some(priority), Some(node)) = (value(4), value(5)) else { return };
    if priority <= HIGHEST_NODE_ID * node {
        let message = say!(
            "the priority time slot of `{}` ms is not longer than 127 device time slots ({} ms)",
            priority,
            HIGHEST_NODE_ID * node
        );
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 4), message);
        let finding = finding.label(at.device.value_place(at.index, 5), "the device time slot");
        findings.push(finding.help(say!("write a value greater than {}", HIGHEST_NODE_ID * node)));
    }
}

fn incomplete_guarding(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.index != 0x1F81 || !at.has_its_shape() {
        return;
    }
    for node in 1..=127 {
        let Some(value) = at.object.value(node).and_then(|value| value.as_integer()) else { continue };
        let (retries, time) = (value >> 8 & 0xFF, value >> 16 & 0xFFFF);
        let message = match (value & 1 == 1, time > 0, retries > 0) {
            (true, true, false) => {
                say!("1F81h sub-index {} has a guard time of {} ms but a retry factor of 0", node, time)
            }
            (true, false, true) => {
                say!("1F81h sub-index {} has a retry factor of {} but a guard time of 0", node, retries)
            }
            _ => continue,
        };
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, node), message);
        findings.push(finding.help("set both, or clear both and use the heartbeat"));
    }
}

/// Lists needed only by a device that boots or configures other nodes.
const MANAGER_LISTS: [u16; 12] =
    [0x1F20, 0x1F22, 0x1F23, 0x1F25, 0x1F81, 0x1F82, 0x1F83, 0x1F84, 0x1F85, 0x1F86, 0x1F87, 0x1F88];

fn manager_not_marked(facts: &Facts<'_>, _: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let marked = device.device_info.as_ref().and_then(|info| info.simple_boot_up_master);
    let list = MANAGER_LISTS.iter().find(|&&index| device.object(index).is_some_and(|object| !object.orphan));
    if let Some(&index) = list.filter(|_| marked == Some(false)) {
        let message = say!("the device has {:04X}h, a list of nodes, but `{SimpleBootUpMaster=0}`", index);
        let place = Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster);
        let finding = MANAGER_NOT_MARKED.at(place.clone(), message);
        let finding = finding.label(Place::object(index), "a list of nodes");
        let finding = finding.help(say!("write `{SimpleBootUpMaster=1}` if the device can boot a network"));
        findings.push(finding.fix(Fix::risky(say!("write `{SimpleBootUpMaster=1}`")).set(place, "1")));
    }
}

fn master_without_slaves(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let value = at.object.value(0).filter(|_| at.index == 0x1F80 && at.has_its_shape());
    let is_master = value.and_then(|value| value.as_integer()).is_some_and(|value| value & 1 == 1);
    if is_master && !demands::is_there(at.device, 0x1F81) {
        let message = "1F80h makes the device NMT master, but it has no slave assignment (1F81h)";
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
        findings.push(finding.help("describe 1F81h, or clear bit 0"));
    }
}

fn self_starting_not_marked(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let value = at.object.value(0).filter(|_| at.index == 0x1F80 && at.has_its_shape());
    let value = value.and_then(|value| value.as_integer());
    let starts = value.is_some_and(|value| value & 0b101 == 0);
    let marked = at.device.device_info.as_ref().and_then(|info| info.simple_boot_up_slave);
    if starts && marked == Some(false) {
        let message = say!("1F80h makes the device enter operational by itself, but `{SimpleBootUpSlave=0}`");
        let place = Place::of(Part::DeviceInfo).field(Field::SimpleBootUpSlave);
        let finding = Diagnostic::new(rule, place.clone(), message);
        let finding = finding.label(at.device.value_place(at.index, 0), "bit 2 is clear");
        let fix = Fix::risky(say!("write `{SimpleBootUpSlave=1}`")).set(place, "1");
        let waiting = value.unwrap_or_default() | 0b100;
        let help = say!("write `{SimpleBootUpSlave=1}`, or set bit 2 of 1F80h (`0x{:08X}`)", waiting);
        findings.push(finding.help(help).fix(fix));
    }
}

fn slave_not_assigned(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.index != 0x1F81 || !at.has_its_shape() {
        return;
    }
    let slaves = (1..=127).filter_map(|node| Some((node, at.object.value(node)?.as_integer()?)));
    for (node, value) in slaves {
        let is_own = at.device.node_id() == Some(node);
        let what = match (value & 1 == 1, is_own) {
            (true, true) => say!("node {} is its own slave", node),
            (false, false) if value != 0 => {
                say!("`0x{:08X}` of node {} does not set bit 0 (slave of this master)", value, node)
            }
            _ => continue,
        };
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, node), what);
        findings.push(finding.help("set bit 0 of each slave, and write 0 for other nodes"));
    }
}
