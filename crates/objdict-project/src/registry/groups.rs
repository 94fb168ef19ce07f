//! The groups of rules: the only list, which determines the pages, the links of rules and the shares of a
//! corpus.

/// A group of rules.
#[derive(Debug)]
pub struct RuleGroup {
    /// The name, such as `cia306`: the first half of the ids of its rules.
    pub name: &'static str,
    /// The subject as a short Markdown phrase.
    pub about: &'static str,
    /// The condition, beyond checking one EDS, DCF, XDD or XDC, without which no rule of the group applies;
    /// `None` if each rule can.
    pub needs: Option<&'static str>,
}

/// Calls a macro with the groups, sorted by name: the name, the subject, and the condition of each.
#[doc(hidden)] // the pages of the rules are in the documentation of `objdict`, which has their texts
#[macro_export]
macro_rules! with_rule_groups {
    ($call:ident) => {
        $call! {
            change: "changes between two descriptions, reported by `objdict diff`", Some("a second description");
            cia301: "communication objects (CiA 301)", None;
            cia302: "network managers (CiA 302)", None;
            cia304: "safety-relevant data objects (CiA 304)", None;
            cia305: "layer setting services (CiA 305)", None;
            cia306: "EDS and DCF files (CiA 306)", None;
            cia311: "XDD and XDC files (CiA 311)", None;
            cia401: "I/O modules (CiA 401)", None;
            cia402: "drives (CiA 402)", None;
            cia404: "measuring devices and controllers (CiA 404)", None;
            cia406: "encoders (CiA 406)", None;
            configuration: "configured nodes compared with their EDS", Some("the EDS of a DCF");
            custom: "custom profiles", Some("a custom profile");
            esi: "EtherCAT slave information (ESI)", Some("an ESI");
            keys: "TOML and YAML files", Some("a TOML or YAML file");
            naming: "names", None;
            network: "networks and their files", Some("a network file");
            objdict: "the configuration of objdict", Some("`objdict.toml`, a comment `objdict: allow`, or data that objdict embedded");
            objdictgen: "projects of objdictgen", Some("a project of objdictgen");
            patch: "patches of description files", Some("a patch");
            portability: "what other tools reject or misread", None;
            probe: "answers of a device, reported by `objdict probe`", Some("a device");
            traffic: "bus traffic that contradicts the descriptions, reported by `objdict decode --check`", Some("a log");
            xml: "well-formed XML", None;
        }
    };
}

macro_rules! list {
    ($($name:ident: $about:literal, $needs:expr;)+) => {
        /// The groups of rules, sorted by name.
        pub static GROUPS: &[RuleGroup] = &[$(RuleGroup { name: stringify!($name), about: $about, needs: $needs }),+];
    };
}

with_rule_groups!(list);
