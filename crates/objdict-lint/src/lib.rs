//! The linter: rules about the model. A rule is independent of files and formats; it checks a [`Device`] and
//! reports [`Place`](crate::model::Place)s.

#[cfg(feature = "catalogue")]
pub mod changes;
#[cfg(feature = "catalogue")]
mod channels;
mod configured;
mod demands;
#[cfg(feature = "catalogue")]
mod drive;
mod facts;
mod index_set;
mod objects;
mod options;
#[doc(hidden)] // for the crates that read recordings
pub mod recorded;
mod respell;
mod rule;
mod rules;
mod severities;
#[cfg(feature = "catalogue")]
mod srdo;
#[cfg(feature = "catalogue")]
mod stack;
mod stated;

use std::borrow::Cow;
use std::cell::LazyCell;

use objdict_model::{diagnostic, literal, model};
use objdict_profile as profile;

use crate::diagnostic::{Findings, MAX_PER_RULE, RuleInfo};
use crate::model::Device;

use configured::ConfiguredDevice;
#[cfg(feature = "catalogue")]
pub(crate) use drive::{Drive, MODES};
pub(crate) use facts::{CobIdService, CobIdUse, Facts, MappedTo, PdoFacts, is_unstated};
pub(crate) use index_set::IndexSet;
#[doc(hidden)] // for the language server
pub use objects::KnownObjects;
pub use options::Options;
pub(crate) use respell::{ListFixes, respell, sub_0, with_members};
pub use rule::Rule;
pub(crate) use rule::{Check, EntryAt, EntryOwner};
pub(crate) use rules::rules_of;
pub use rules::{rules, without_disabled};
pub use severities::{Level, Severities, UnknownLevel};
#[cfg(feature = "catalogue")]
pub(crate) use srdo::Srdo;

/// The group of the rules about other tools.
pub const PORTABILITY: &str = "portability";

/// Rule groups that do not apply to an EtherCAT device: CANopen communication, EDS information about CAN, and
/// mandatory EDS sections.
const OF_CANOPEN: &str = " cia301 cia302 cia304 cia305 cia306/reserved-index cia306/no-baud-rate cia306/command-without-flag cia306/missing-section cia402/cyclic-mode-without-sync ";

/// Applies all rules to one device, without disabled objects.
pub fn check(described: &Device, options: &Options) -> Findings {
    check_some(described, options, &|_| true, &|_| true)
}

/// Like [`check`], with some of the rules; those about single objects and entries check only some of the
/// objects.
pub fn check_some(
    described: &Device,
    options: &Options,
    is_wanted: &dyn Fn(&RuleInfo) -> bool,
    is_asked: &dyn Fn(u16) -> bool,
) -> Findings {
    check_with(described, options, is_wanted, is_asked, None)
}

/// Like [`check`], reusing results for unchanged objects from before an edit, which are then updated.
#[doc(hidden)] // for the language server
pub fn check_after(described: &Device, options: &Options, known: &mut KnownObjects) -> Findings {
    let findings = check_with(described, options, &|_| true, &|_| true, Some(known));
    if findings.len() < MAX_PER_RULE as usize {
        return findings;
    }
    // with more findings, checks are less thorough
    *known = KnownObjects::default();
    check(described, options)
}

fn check_with(
    described: &Device,
    options: &Options,
    is_wanted: &dyn Fn(&RuleInfo) -> bool,
    is_asked: &dyn Fn(u16) -> bool,
    known: Option<&mut KnownObjects>,
) -> Findings {
    let is_ethercat = described.is_ethercat();
    let is_wanted = &|rule: &RuleInfo| {
        let is_of_canopen = |name: &str| OF_CANOPEN.contains(&format!(" {name} "));
        is_wanted(rule) && !(is_ethercat && [rule.group(), rule.id].into_iter().any(is_of_canopen))
    };
    let rules: Vec<&Rule> = asked_for(options).filter(|rule| is_wanted(&rule.info)).collect();
    let mut findings = Findings::new();
    let enabled = described.without_disabled();
    let device = &*enabled;
    let facts = Facts::new(device, options);
    for rule in &rules {
        match rule.check {
            Check::Device(check) => check(device, &mut findings),
            Check::Described(check) => check(described, &mut findings),
            Check::Facts(check) => check(&facts, &mut findings),
            Check::Pdo(check) => facts.pdos.iter().for_each(|pdo| check(&facts, pdo, &mut findings)),
            _ => {}
        }
    }
    check_demands(&facts, is_wanted, is_asked, &mut findings);
    objects::check(device, &rules, is_asked, known, &mut findings);
    match enabled {
        Cow::Owned(_) => rules::renumbered(described, findings),
        Cow::Borrowed(_) => findings,
    }
}

/// Applies the rules about a configuration to the device of a node and its type description, into which the labels at
/// [`At::Node`](crate::diagnostic::At::Node) point.
pub fn check_configured(device: &Device, origin: &Device) -> Findings {
    let mut findings = Findings::new();
    let configured = ConfiguredDevice { device, origin: &origin.with_implicit_pdos(), written: origin };
    let is_same = rules::is_same_product(device, origin);
    for rule in rules_of(|group| group == "configuration") {
        if let Check::Configured(check) = rule.check
            && (is_same || rule.info.name() == "other-device")
        {
            check(&configured, &mut findings);
        }
    }
    findings
}

/// The rules that apply; rules about other tools only if tools are selected.
fn asked_for(options: &Options) -> impl Iterator<Item = &'static Rule> + use<> {
    let for_tools = !options.tools.is_empty();
    rules_of(move |group| for_tools || group != PORTABILITY)
}

/// One walk over the applicable documents, for all rules of their groups.
fn check_demands(
    facts: &Facts<'_>,
    is_wanted: &dyn Fn(&RuleInfo) -> bool,
    is_asked: &dyn Fn(u16) -> bool,
    findings: &mut Findings,
) {
    let applied = demands::applied(facts.device, facts.options);
    for one in &applied {
        let rules = rules_of(|group| group == one.profile.group).filter(|rule| is_wanted(&rule.info));
        let rules: Vec<&Rule> = rules.collect();
        for rule in &rules {
            match rule.check {
                Check::Applied(check) => check(facts, one, findings),
                #[cfg(feature = "catalogue")]
                Check::Demand(check) => check(&rule.info, facts, one, findings),
                #[cfg(feature = "catalogue")]
                Check::Drive(check) => check(Drive::new(facts, one), findings),
                _ => {}
            }
        }
        let is_of_objects = |rule: &&Rule| matches!(rule.check, Check::Against(_) | Check::Expected(_));
        let rules: Vec<&Rule> = rules.into_iter().filter(is_of_objects).collect();
        if rules.is_empty() {
            continue;
        }
        // a finding about an object may be reported for one that it is compared with
        let against = demands::against(facts.device, one)
            .filter(|against| is_asked(against.index) || against.counterparts().any(is_asked));
        for against in against {
            let first = findings.len();
            let entries = LazyCell::new(|| against.entries().collect::<Vec<_>>());
            for rule in &rules {
                match rule.check {
                    Check::Against(check) => check(&rule.info, &against, findings),
                    Check::Expected(check) => {
                        entries.iter().for_each(|at| check(&rule.info, at, findings));
                    }
                    _ => {}
                }
            }
            findings.limit_from(first, demands::highest_severity(against.facts.confidence));
        }
    }
}
