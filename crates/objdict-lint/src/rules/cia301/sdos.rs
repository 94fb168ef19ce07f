//! The SDO servers and clients.

use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say, sub_index};
use crate::model::{DataType, Device, DeviceKind, Field, Object, Part, Place, TypeKind, predefined};
use crate::rule::rules;
use crate::{CobIdService, CobIdUse, Facts, stated};

rules! {
    source: "CiA 301 §7.5.2.33, §7.5.2.34";

    "cia301/default-sdo-cob-id" = DEFAULT_SDO_COB_ID, Error, Facts(default_sdo_cob_id), fix Unsafe;
    summary: "the CAN-ID of the default SDO differs from CiA 301",
    checks: "1200h sub-index 1 must be 600h plus the node-ID, and sub-index 2 must be 580h plus the node-ID. An EDS must use formulas. A DCF may use formulas or numbers for the node.",
    why: "Every tool reaches the device through the default SDO, and its CAN-IDs cannot be changed. A tool that uses the CAN-IDs of the description gets no response or addresses a different node.",
    example: "`[1200sub1]` with `DefaultValue=0x600`",
    remedy: "Write `$NODEID+0x600` and `$NODEID+0x580`.",
    source: "CiA 301 §7.5.2.33, §7.3.5",

    "cia301/default-sdo-node-id" = DEFAULT_SDO_NODE_ID, Warning, Device(default_sdo_node_id), fix Unsafe;
    summary: "the default SDO specifies a client",
    checks: "Reports 1200h, the default SDO, if it has sub-index 3, the node-ID of the client.",
    why: "The default SDO is reserved for the network manager and has no specific client. CiA 301 defines the entry for additional channels only, and a conformance test rejects it.",
    example: "`[1200sub3]`",
    remedy: "Remove the sub-index and reduce `SubNumber` and sub-index 0 by one.",
    source: "CiA 301 §7.5.2.33",

    "cia301/gap-in-sdo-numbers" = GAP_IN_SDO_NUMBERS, Note, Device(gap_in_sdo_numbers);
    summary: "the numbers of the SDO channels have a gap",
    checks: "Each additional SDO server (1201h to 127Fh) and SDO client (1280h to 12FFh) must follow the previous one. For objects that are not SDO parameters, see `cia301/incomplete-sdo-parameter`.",
    why: "CiA 301 calls 1201h the second server, 1202h the third and so on. It does not forbid gaps, but managers that assign channels stop at the first missing index.",
    example: "`[1281]` without `[1280]`",
    remedy: "Use the next free index, or describe the missing channels.",

    "cia301/incomplete-sdo-parameter" = INCOMPLETE_SDO_PARAMETER, Error, Against(incomplete_sdo_parameter);
    summary: "an SDO parameter lacks a sub-index",
    checks: "Each SDO server (1200h to 127Fh) must have sub-indexes 1 and 2, the COB-IDs of both directions. Each SDO client (1280h to 12FFh) must also have sub-index 3, the node-ID of its server. An object whose types are wrong for an SDO parameter, such as a string, is reported once, as a vendor's object in the range of SDOs.",
    why: "An SDO channel needs both identifiers, and a client needs the node-ID of its server.",
    example: "`[1280]` with only sub-indexes 0 to 2",
    remedy: "Describe the missing sub-index; move a vendor-specific object to 2000h to 5FFFh.",

    "cia301/partly-valid-sdo" = PARTLY_VALID_SDO, Error, Facts(partly_valid_sdo);
    summary: "only one direction of an SDO channel is valid",
    checks: "The two COB-IDs of an SDO server or client (1201h to 12FFh) must be both valid or both not valid. A COB-ID is not valid if bit 31 is set or if it is 0, which many stacks write to an unconfigured channel.",
    why: "A channel works only if both COB-IDs are valid. One valid COB-ID occupies a CAN-ID without providing an SDO.",
    example: "`[1280sub1]` with `DefaultValue=0x605` and `[1280sub2]` with `DefaultValue=0x80000585`",
    remedy: "Set bit 31 in both, or clear it in both.",

    "cia301/sdo-cob-ids-exchanged" = SDO_COB_IDS_EXCHANGED, Error, Facts(sdo_cob_ids_exchanged), fix Unsafe;
    summary: "the COB-IDs of an SDO channel are swapped",
    checks: "If an active SDO client or additional SDO server uses the CAN-IDs of default SDOs, its client must transmit with 600h to 67Fh and receive with 580h to 5FFh, not the reverse.",
    why: "The client sends its requests with the CAN-ID of the server's responses and waits for a response with the CAN-ID of its requests. Every transfer times out.",
    example: "`[1280sub1]` with `DefaultValue=0x585` and `[1280sub2]` with `DefaultValue=0x605`",
    remedy: "Write 600h plus the node-ID of the server to sub-index 1 and 580h plus the node-ID to sub-index 2.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34; §7.3.5",

    "cia301/sdo-node-id" = SDO_NODE_ID, Warning, Facts(sdo_node_id);
    summary: "an SDO channel has the wrong node-ID",
    checks: "Sub-index 3 of each active SDO channel except the default SDO must be a node-ID from 1 to 127 and must differ from the node-ID of the DCF itself. If a client uses the CAN-IDs of a default SDO, 600h and 580h plus a node-ID, both must belong to one node, and sub-index 3 must specify that node.",
    why: "Tools find the peer of the channel by the node-ID. With a wrong node-ID, the channel reaches no node or is shown for the wrong one.",
    example: "`[1280sub1]` with `DefaultValue=0x605` and `[1280sub3]` with `DefaultValue=6`",
    remedy: "Write the node-ID of the peer.",

    "cia301/sdo-valid-by-default" = SDO_VALID_BY_DEFAULT, Warning, Facts(sdo_valid_by_default);
    summary: "an additional SDO channel is valid by default",
    checks: "In an EDS, the COB-IDs of the additional SDO channels (1201h to 12FFh) must be not valid (bit 31 set) or 0.",
    why: "The predefined connection set has no CAN-ID for them: two devices of the type on one network use the same CAN-ID. The default in CiA 301 is 80000000h.",
    example: "`[1201sub1]` with `DefaultValue=0x640`",
    remedy: "Write `0x80000000`.",
}

fn default_sdo_cob_id(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        let (base, direction) = match cob_id.service {
            CobIdService::ServerRequest(1) => (predefined::SDO_REQUEST, "from client to server"),
            CobIdService::ServerResponse(1) => (predefined::SDO_RESPONSE, "from server to client"),
            _ => continue,
        };
        let expected = predefined::per_node(base);
        let is_right = match facts.device.node_id() {
            Some(node) => cob_id.cob_id.on_node(node) == expected.on_node(node),
            None => cob_id.cob_id == expected,
        };
        if !is_right {
            let message = say!(
                "the COB-ID of the default SDO {} is `{}`; it must be `{!}`",
                direction,
                cob_id.cob_id,
                expected
            );
            let place = facts.device.value_place(cob_id.index, cob_id.sub);
            let title = say!("write `{}`", expected);
            let fix = Fix::risky(title.clone()).set(place.clone(), expected.to_string());
            findings.push(DEFAULT_SDO_COB_ID.at(place, message).help(title).fix(fix));
        }
    }
}

fn default_sdo_node_id(device: &Device, findings: &mut Findings) {
    let index = 0x1200;
    let Some(object) = device.object(index).filter(|object| object.subs.get(3).is_some()) else { return };
    if object.compact.is_some() {
        return;
    }
    let message = "1200h has sub-index 3, but the default SDO has no specific client";
    let finding = DEFAULT_SDO_NODE_ID.at(Place::entry(index, 3), message);
    let finding = finding.help(say!("remove `{[1200sub3]}`"));
    let is_whole = object.sub_number == Some(4) && object.highest_sub() == Some(3) && object.subs.len() == 4;
    findings.push(if is_whole {
        let fix = Fix::risky("remove sub-index 3 and update the number of entries")
            .remove(Place::entry(index, 3))
            .set(Place::object(index).field(Field::SubNumber), "3")
            .set(Place::entry(index, 0).field(Field::DefaultValue), "2");
        finding.fix(fix)
    } else {
        finding
    });
}

fn gap_in_sdo_numbers(device: &Device, findings: &mut Findings) {
    for (first, last, what) in [(0x1201_u16, 0x127F, "SDO server"), (0x1280, 0x12FF, "SDO client")] {
        let channels =
            device.objects.range(first + 1..=last).filter(|(_, object)| foreign_entry(object).is_none());
        for (&index, _) in channels {
            if !stated::is_there(device, index - 1) {
                let message = say!(
                    "{:04X}h is described, but the previous {} ({:04X}h) is missing",
                    index,
                    what,
                    index - 1
                );
                let finding = GAP_IN_SDO_NUMBERS.at(Place::object(index), message);
                findings.push(finding.help("use the next free index, or describe the missing channels"));
                break;
            }
        }
    }
}

/// An entry whose type shows that the object is not an SDO parameter, which only contains numbers.
fn foreign_entry(object: &Object) -> Option<(u8, DataType)> {
    let is_number = |kind| matches!(kind, TypeKind::Unsigned(_) | TypeKind::Signed(_) | TypeKind::Structure);
    let typed = object.subs.iter().filter_map(|(sub, entry)| Some((sub, entry.data_type?)));
    typed.take_while(|(sub, _)| *sub < 4).find(|(_, data_type)| !is_number(data_type.kind()))
}

fn incomplete_sdo_parameter(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let (index, object) = (at.index, at.object);
    if !(0x1200..=0x12FF).contains(&index) || object.orphan || !object.object_type().has_subs() {
        return;
    }
    if let Some((sub, data_type)) = foreign_entry(object) {
        let message = say!(
            "{:04X}h is in the range of SDO parameters, but its sub-index {} is {}",
            index,
            sub_index(sub),
            data_type
        );
        let finding = Diagnostic::new(rule, Place::object(index), message);
        findings.push(finding.help("move the object to 2000h to 5FFFh"));
        return;
    }
    let needed = at.facts.entries().filter(|entry| entry.is_mandatory() && entry.first > 0);
    for entry in needed.filter(|entry| !object.has(entry.first)) {
        let (sub, name) = (entry.first, entry.name);
        let message = say!("{} is missing sub-index {} ({})", at, sub, name);
        let finding = Diagnostic::new(rule, Place::object(index), message);
        findings.push(finding.help(say!("add `{}`", Part::Entry(index, sub))));
    }
}

fn partly_valid_sdo(facts: &Facts<'_>, findings: &mut Findings) {
    let channels =
        facts.sdo_channels().filter(|(request, _)| request.service != CobIdService::ServerRequest(1));
    for (request, response) in channels.filter(|(one, other)| one.is_in_use() != other.is_in_use()) {
        let (valid, invalid) = if request.is_in_use() { (request, response) } else { (response, request) };
        let message = say!(
            "{} has a valid COB-ID `{}` in sub-index {}, but the one in sub-index {} is not valid",
            request.service,
            valid.cob_id,
            valid.sub,
            invalid.sub
        );
        let device = facts.device;
        let finding = PARTLY_VALID_SDO
            .at(device.value_place(valid.index, valid.sub), message)
            .label(device.value_place(invalid.index, invalid.sub), "not valid");
        findings.push(finding.help("set bit 31 in both, or clear it in both"));
    }
}

fn sdo_cob_ids_exchanged(facts: &Facts<'_>, findings: &mut Findings) {
    let node = *facts.node_ids().start();
    let can_id = |cob_id: &CobIdUse| cob_id.cob_id.can_id(node);
    for (request, response) in facts.sdo_channels() {
        let is_active = request.is_in_use() && response.is_in_use();
        let is_exchanged = (0x580..0x600).contains(&can_id(request))
            && (0x600..0x680).contains(&can_id(response))
            && !request.cob_id.is_extended()
            && !response.cob_id.is_extended();
        // the default SDO has its own rule
        if !is_active || !is_exchanged || request.service == CobIdService::ServerRequest(1) {
            continue;
        }
        let place = |cob_id: &CobIdUse| facts.device.value_place(cob_id.index, cob_id.sub);
        let message = say!(
            "{} has `{}` from client to server and `{}` from server to client; the predefined connection set is the reverse",
            request.service,
            request.cob_id,
            response.cob_id
        );
        let fix = Fix::risky("swap the COB-IDs")
            .set(place(request), response.cob_id.to_string())
            .set(place(response), request.cob_id.to_string());
        let finding =
            SDO_COB_IDS_EXCHANGED.at(place(request), message).label(place(response), "the other direction");
        findings.push(finding.help("swap the COB-IDs").fix(fix));
    }
}

fn sdo_node_id(facts: &Facts<'_>, findings: &mut Findings) {
    for (request, response) in facts.sdo_channels() {
        let ends = (server_of(facts, request, 0x600), server_of(facts, response, 0x580));
        if let (Some(asked), Some(heard)) = ends
            && asked != heard
        {
            let message = say!(
                "{} sends requests to node {}, but expects responses from node {}",
                request.service,
                asked,
                heard
            );
            let finding = SDO_NODE_ID.at(facts.device.value_place(response.index, response.sub), message);
            let finding = finding.label(facts.device.value_place(request.index, request.sub), "the request");
            findings.push(finding.help("write the CAN-IDs of one node"));
        }
    }
    let requests = facts.cob_ids.iter().filter(|cob_id| match cob_id.service {
        CobIdService::ServerRequest(number) => number > 1,
        service => matches!(service, CobIdService::ClientRequest(_)),
    });
    for request in requests.filter(|request| request.is_in_use()) {
        let Some(node) = facts.number(request.index, 3) else { continue };
        let own = facts.device.node_id().map(i128::from);
        let service = request.service;
        let message = if !(1..=127).contains(&node) {
            say!("{} has the node-ID `{}`, but node-IDs are 1 to 127", service, node)
        } else if own == Some(node) {
            say!("{} has the node-ID {}, which is the node itself", service, node)
        } else if let Some(server) = server_of(facts, request, 0x600).filter(|&server| server != node) {
            say!("{} uses the default SDO of node {}, but has the node-ID {}", service, server, node)
        } else {
            continue;
        };
        let finding = SDO_NODE_ID
            .at(facts.device.value_place(request.index, 3), message)
            .label(facts.device.value_place(request.index, 1), "the COB-ID");
        findings.push(finding.help("write the node-ID of the peer"));
    }
}

/// The node whose default SDO has the CAN-ID of a client, which is this `base` plus its node-ID.
fn server_of(facts: &Facts<'_>, cob_id: &CobIdUse, base: u32) -> Option<i128> {
    let is_client =
        matches!(cob_id.service, CobIdService::ClientRequest(_) | CobIdService::ClientResponse(_));
    let is_known = !cob_id.cob_id.depends_on_node_id() || facts.device.node_id().is_some();
    let node = cob_id.cob_id.can_id(*facts.node_ids().start()).checked_sub(base)?;
    (is_client && is_known && cob_id.is_in_use() && (1..=127).contains(&node)).then_some(node.into())
}

fn sdo_valid_by_default(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.device.kind != DeviceKind::Type {
        return;
    }
    for cob_id in facts.cob_ids.iter().filter(|cob_id| cob_id.is_in_use() && cob_id.wrong_bits() == 0) {
        let is_additional = match cob_id.service {
            CobIdService::ServerRequest(number) => number > 1,
            service => matches!(service, CobIdService::ClientRequest(_)),
        };
        // other rules report a restricted CAN-ID and a channel with only one valid COB-ID
        let pair = facts.cob_ids.iter().find(|other| other.index == cob_id.index && other.sub == 2);
        let is_half = pair.is_none_or(|other| !other.is_in_use());
        if !is_additional || is_half || facts.is_restricted(cob_id) {
            continue;
        }
        let message = say!("`{}` makes {} valid by default", cob_id.cob_id, cob_id.service);
        let finding = SDO_VALID_BY_DEFAULT.at(facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help("write `0x80000000` to both COB-IDs"));
    }
}
