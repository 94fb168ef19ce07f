use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia401/analogue-events-off", Note, Applied(check);
    summary: "a configuration maps analogue inputs into an event-driven TPDO but leaves their events disabled",
    checks: "Whether a configuration (DCF or XDC) sets 6423h, and selects an event in 6421h, when a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries analogue inputs. In a device description this is not a finding: the profile disables the events by default.",
    why: "The device never sends the TPDO: while 6423h is false or 6421h is 0, a change of an analogue input is not an event. This is the most common reason for missing analogue values.",
    example: "`[1801sub2]` with 255, `[1801sub5]` with 0, and `[6423]` with `DefaultValue=0` and no `ParameterValue`",
    remedy: "Set `ParameterValue=1` at 6423h, select an event in 6421h, set an event timer, or send the TPDO on SYNC.",
    source: "CiA 401 (6421h, 6423h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let switches = [(0x6423, 0, "is true"), (0x6421, 1, "selects one")];
    let off = switches.into_iter().find(|&(index, ..)| facts.is_configured_off(at(index)));
    let Some((index, sub, condition)) = off else { return };
    let Some(pdo) = facts.waiting_tpdo(&(at(0x6400)..=at(0x6404))) else { return };
    let message =
        say!("{} is never sent: analogue inputs raise no events until {:04X}h {}", pdo, at(index), condition);
    let finding = Diagnostic::new(rule, device.value_place(at(index), sub), message);
    let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
    let help =
        if sub == 0 { say!("write `{ParameterValue=1}`") } else { say!("select an event, such as 7,") };
    findings.push(finding.help(say!("{} or set the event timer of the TPDO", help)));
}
