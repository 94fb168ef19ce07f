use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::PdoKind;
use crate::{Facts, Service, rule};

rule! {
    "cia301/emergency-consumer-of-other-node", Warning, Facts(check);
    summary: "an EMCY consumer entry uses the COB-ID of another node or service",
    checks: "Whether each valid COB-ID of 1028h between 81h and FFh is 80h plus its sub-index, which is the node-ID of the producer, whether no entry has a CAN-ID of the PDOs of the predefined connection set, and whether no entry of a DCF refers to the node itself.",
    why: "The device attributes the error of one node to another.",
    example: "`[1028sub5]` with `DefaultValue=0x86`",
    remedy: "Write 80h plus the sub-index, or set bit 31 to disable the entry.",
    source: "CiA 301 §7.5.2.31",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let consumers = facts.cob_ids.iter().filter(|cob_id| cob_id.service == Service::EmcyConsumer);
    for consumer in consumers.filter(|consumer| consumer.is_in_use() && consumer.wrong_bits() == 0) {
        if consumer.cob_id.depends_on_node_id() && facts.device.node_id().is_none() {
            continue;
        }
        let can_id = consumer.cob_id.can_id(*facts.node_ids().start());
        let node = u32::from(consumer.sub);
        let is_of_pdo = (0x181..0x580).contains(&can_id) && can_id & 0x7F != 0 && !facts.is_shared(consumer);
        if consumer.cob_id.is_extended() || !(is_of_pdo || (0x81..=0xFF).contains(&can_id)) {
            continue;
        }
        let message = if is_of_pdo {
            let kind = if can_id & 0x80 == 0 { PdoKind::Rpdo } else { PdoKind::Tpdo };
            let number = (can_id - 0x80) >> 8;
            say!(
                "sub-index {} of 1028h is for an EMCY, but `{}` belongs to {} {} of node {}",
                sub_index(consumer.sub),
                consumer.cob_id,
                kind,
                number,
                can_id & 0x7F
            )
        } else if can_id != 0x80 + node {
            let sub = sub_index(consumer.sub);
            say!(
                "sub-index {} of 1028h is for node {}, but `{}` is the EMCY of node {}",
                sub,
                node,
                consumer.cob_id,
                can_id - 0x80
            )
        } else if facts.device.node_id() == Some(consumer.sub) {
            say!("sub-index {} of 1028h makes node {} consume its own EMCY", sub_index(consumer.sub), node)
        } else {
            continue;
        };
        let place = facts.device.value_place(consumer.index, consumer.sub);
        let finding = Diagnostic::new(&RULE.info, place, message);
        let is_own = facts.device.node_id() == Some(consumer.sub) && can_id == 0x80 + node;
        findings.push(match is_own {
            true => finding.help("set bit 31 to disable the entry"),
            false => finding.help("write 80h plus the sub-index, or set bit 31 to disable the entry"),
        });
    }
}
