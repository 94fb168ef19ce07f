//! Services of a device other than PDOs, as text.

use super::sentence::{self, ChangedCobId, Clause};
use crate::Language;
use crate::describe::{Decoder, time};
use crate::model::{CobId, Entry, Object, SdoChannel, Services};

/// View of a service.
pub(crate) struct ServiceView {
    pub(crate) name: String,
    /// The sentence.
    pub(crate) parts: Vec<Clause>,
}

/// The services in the description. `name` supplies the names of entries.
pub(crate) fn services(decoder: &Decoder<'_>, name: &dyn Fn(&Entry) -> String) -> Vec<ServiceView> {
    if decoder.device.is_ethercat() {
        return Vec::new();
    }
    let facts = decoder.device.services();
    let speaker = Speaker { decoder, facts: &facts, entry_name: name };
    let mut all = vec![
        speaker.service("NMT", speaker.nmt()),
        speaker.service("SYNC", speaker.sync()),
        speaker.service("TIME", speaker.time()),
        speaker.service("EMCY", speaker.emcy()),
        speaker.service(speaker.pick("EMCY consumer", "EMCY-Empfänger"), speaker.emcy_consumers()),
        speaker.service(speaker.pick("Heartbeat producer", "Heartbeat-Sender"), speaker.heartbeat()),
        speaker.service(speaker.pick("Heartbeat consumer", "Heartbeat-Empfänger"), speaker.watched()),
        speaker.service(speaker.pick("Node guarding", "Node-Guarding"), speaker.guarding()),
    ];
    let servers = facts.sdo_servers.iter().map(|channel| speaker.sdo("SDO-Server", "SDO server", channel));
    let clients = facts.sdo_clients.iter().map(|channel| speaker.sdo("SDO-Client", "SDO client", channel));
    all.extend(servers.chain(clients));
    all.extend((1..=64).map(|number| speaker.srdo(number)));
    all.push(speaker.service(speaker.pick("On errors", "Bei Fehlern"), speaker.each(0x1029)));
    all.push(speaker.service(speaker.pick("Storing", "Speichern"), speaker.each(0x1010)));
    all.push(speaker.service(speaker.pick("Restoring", "Wiederherstellen"), speaker.each(0x1011)));
    all.push(speaker.service("LSS", speaker.lss()));
    all.retain(|service| !service.parts.is_empty());
    all
}

/// Builds the sentences.
struct Speaker<'a> {
    decoder: &'a Decoder<'a>,
    facts: &'a Services,
    entry_name: &'a dyn Fn(&Entry) -> String,
}

impl Speaker<'_> {
    fn service(&self, name: &str, parts: Vec<Clause>) -> ServiceView {
        ServiceView { name: name.to_owned(), parts }
    }

    fn pick(&self, english: &'static str, german: &'static str) -> &'static str {
        self.decoder.language.pick(english, german)
    }

    fn part(&self, index: u16, sub: u8, text: impl Into<String>) -> Clause {
        Clause::of(self.decoder, index, sub, text)
    }

    fn has(&self, index: u16) -> bool {
        self.decoder.device.object(index).is_some()
    }

    /// The meaning of the number in an object, with specific text for 0; `None` without a number.
    fn number(
        &self,
        index: u16,
        number: Option<u32>,
        (english, german): (&'static str, &'static str),
        words: impl FnOnce(u32) -> String,
    ) -> Option<Clause> {
        let text = match number? {
            0 => self.pick(english, german).to_owned(),
            number => words(number),
        };
        Some(self.part(index, 0, text))
    }

    /// The COB-ID of an object, or a note that it is not stated; `None` if the object does not exist.
    fn cob_id(&self, index: u16, sub: u8, id: Option<CobId>) -> Option<Clause> {
        let text = match id {
            Some(id) => sentence::cob_id(self.decoder, id),
            None => self.pick("COB-ID not stated", "COB-ID nicht angegeben").to_owned(),
        };
        let change = ChangedCobId::of(self.decoder, index, sub);
        let is_switched_on = index == 0x1014 && change.bit_31 && id.is_some_and(CobId::is_valid);
        let is_changed = change.can_id || is_switched_on;
        self.has(index).then(|| self.part(index, sub, text).only_if(is_changed))
    }

    fn nmt(&self) -> Vec<Clause> {
        let Some(info) = &self.decoder.device.device_info else { return Vec::new() };
        self.roles(&[
            (info.simple_boot_up_slave, "boots up as a slave", "startet als Slave"),
            (info.simple_boot_up_master, "can be the master", "kann Master sein"),
            (info.self_starting, "enters operational by itself", "geht selbst in operational"),
            (info.flying_master, "flying master", "Flying-Master"),
        ])
    }

    /// Roles of a device.
    fn roles(&self, roles: &[(Option<bool>, &'static str, &'static str)]) -> Vec<Clause> {
        let roles = roles.iter().filter(|(is_so, ..)| *is_so == Some(true));
        roles.map(|(_, english, german)| Clause::plain(self.pick(english, german))).collect()
    }

    fn sync(&self) -> Vec<Clause> {
        let Some(cob_id) = self.cob_id(0x1005, 0, self.facts.sync) else { return Vec::new() };
        let language = self.decoder.language;
        let change = ChangedCobId::of(self.decoder, 0x1005, 0);
        let produces = self.facts.sync.is_some_and(CobId::bit_30);
        let role = if produces {
            self.pick("produced", "wird gesendet")
        } else {
            self.pick("consumed", "wird empfangen")
        };
        let mut parts = vec![cob_id];
        parts.extend(self.facts.sync.map(|_| self.part(0x1005, 0, role).only_if(change.bit_30)));
        let period = self.facts.communication_cycle_period.filter(|&period| produces || period > 0);
        parts.extend(self.number(0x1006, period, ("cycle off", "Zyklus aus"), |period| {
            format!("{} {}", self.pick("every", "alle"), time::of_microseconds(period, language))
        }));
        if let Some(window @ 1..) = self.facts.synchronous_window {
            let name = self.pick("window", "Fenster");
            parts.push(self.part(0x1007, 0, format!("{name} {}", time::of_microseconds(window, language))));
        }
        let counter = self.facts.sync_counter_overflow;
        parts.extend(counter.map(|highest| self.part(0x1019, 0, self.decoder.sync_counter(highest.into()))));
        parts
    }

    fn time(&self) -> Vec<Clause> {
        let Some(cob_id) = self.cob_id(0x1012, 0, self.facts.time) else { return Vec::new() };
        let roles = self.facts.time.map(|id| {
            let change = ChangedCobId::of(self.decoder, 0x1012, 0);
            self.part(0x1012, 0, self.decoder.time_roles(id)).only_if(change.bit_31 || change.bit_30)
        });
        std::iter::once(cob_id).chain(roles).collect()
    }

    fn emcy(&self) -> Vec<Clause> {
        let mut parts: Vec<Clause> = self.cob_id(0x1014, 0, self.facts.emcy).into_iter().collect();
        if let Some(id) = self.facts.emcy.filter(|id| !id.is_valid()) {
            let change = ChangedCobId::of(self.decoder, 0x1014, 0);
            parts.push(self.part(0x1014, 0, self.decoder.validity(id)).only_if(change.bit_31));
        }
        let inhibit = self.facts.emcy_inhibit_time.map(u32::from);
        parts.extend(self.number(0x1015, inhibit, ("inhibit time off", "Inhibit-Time aus"), |time| {
            let name = self.pick("inhibit time", "Inhibit-Time");
            format!("{name} {}", time::of_tenths(time, self.decoder.language))
        }));
        let history = self.decoder.device.object(0x1003).and_then(Object::highest_sub);
        if let Some(errors @ 1..) = history {
            let text = match (errors, self.decoder.language) {
                (1, Language::English) => "keeps the last error".to_owned(),
                (1, Language::German) => "merkt sich den letzten Fehler".to_owned(),
                (_, Language::English) => format!("keeps the last {errors} errors"),
                (_, Language::German) => format!("merkt sich die letzten {errors} Fehler"),
            };
            parts.push(self.part(0x1003, 0, text));
        }
        parts
    }

    fn emcy_consumers(&self) -> Vec<Clause> {
        let consumers = emcy_consumers(self.decoder).into_iter().map(|(node, id)| {
            let of = self.pick("node", "Knoten");
            self.part(0x1028, node, format!("{of} {node}: {}", sentence::cob_id(self.decoder, id)))
        });
        self.or_unused(0x1028, consumers.collect())
    }

    /// The parts, or a note that no entry of the object is in use.
    fn or_unused(&self, index: u16, parts: Vec<Clause>) -> Vec<Clause> {
        if parts.is_empty() && self.has(index) {
            return vec![self.part(index, 0, self.pick("none in use", "keiner in Gebrauch"))];
        }
        parts
    }

    fn heartbeat(&self) -> Vec<Clause> {
        if !self.has(0x1017) {
            return Vec::new();
        }
        let text = match self.facts.heartbeat_time {
            None => self.pick("time not stated", "Zeit nicht angegeben").to_owned(),
            Some(0) => self.pick("off", "aus").to_owned(),
            Some(time) => format!("{} {time} ms", self.pick("every", "alle")),
        };
        vec![self.part(0x1017, 0, text)]
    }

    fn watched(&self) -> Vec<Clause> {
        let consumers = self.facts.heartbeat_consumers.iter().map(|consumer| {
            let (node, time) = (consumer.node_id, consumer.time);
            let text = match self.decoder.language {
                Language::English => format!("node {node} within {time} ms"),
                Language::German => format!("Knoten {node} innerhalb von {time} ms"),
            };
            self.part(0x1016, consumer.sub, text)
        });
        self.or_unused(0x1016, consumers.collect())
    }

    fn guarding(&self) -> Vec<Clause> {
        let [guard, factor] = [0x100C, 0x100D].map(|index| self.decoder.number(index, 0));
        let time = self.number(0x100C, guard, ("guard time off", "Guard-Time aus"), |guard| {
            format!("{} {guard} ms", self.pick("guard time", "Guard-Time"))
        });
        let life = self.number(0x100D, factor, ("no life guarding", "kein Life-Guarding"), |factor| {
            let name = self.pick("life time factor", "Life-Time-Faktor");
            let life = guard.filter(|&guard| guard > 0 && guard <= 0xFFFF);
            let life = life.map(|guard| format!(" ({} ms)", guard.saturating_mul(factor)));
            format!("{name} {factor}{}", life.unwrap_or_default())
        });
        time.into_iter().chain(life).collect()
    }

    fn sdo(&self, german: &'static str, english: &'static str, channel: &SdoChannel) -> ServiceView {
        let direction = |sub, id: Option<CobId>, english, german| {
            let name = self.pick(english, german);
            let text = match id {
                Some(id) if id.is_valid() => sentence::cob_id(self.decoder, id),
                Some(id) => self.decoder.validity(id).to_owned(),
                None => self.pick("COB-ID not stated", "COB-ID nicht angegeben").to_owned(),
            };
            self.part(channel.index, sub, format!("{name} {text}"))
        };
        let mut parts = vec![
            direction(1, channel.request, "client to server", "Client zu Server"),
            direction(2, channel.response, "server to client", "Server zu Client"),
        ];
        let other = channel.node_id.and_then(|node| self.decoder.other_node(channel.index, node.into()));
        parts.extend(other.map(|text| self.part(channel.index, 3, text)));
        let name = format!("{} {}", self.pick(english, german), channel.number);
        self.service(&name, parts)
    }

    /// An SRDO (CiA 304), if the device has it.
    fn srdo(&self, number: u16) -> ServiceView {
        let index = 0x1300 + number;
        let values = (1..=6).filter_map(|sub| {
            let entry = self.decoder.device.entry(index, sub)?;
            let text = self.decoder.of(index, sub, entry.value()?)?;
            let name = match sub {
                2 => self.pick("refresh time or SCT ", "Refresh-Time oder SCT "),
                3 => "SRVT ",
                _ => "",
            };
            Some(self.part(index, sub, format!("{name}{text}")))
        });
        self.service(&format!("SRDO {number}"), values.collect())
    }

    /// The value of each sub-index with its name; only the name without a value.
    fn each(&self, index: u16) -> Vec<Clause> {
        let Some(object) = self.decoder.device.object(index) else { return Vec::new() };
        let entries = object.entries().filter(|(sub, _)| *sub > 0);
        let parts = entries.map(|(sub, entry)| {
            let name = (self.entry_name)(&entry);
            let meaning = entry.value().and_then(|value| self.decoder.of(index, sub, value));
            self.part(index, sub, meaning.map(|meaning| format!("{name}: {meaning}")).unwrap_or(name))
        });
        parts.collect()
    }

    fn lss(&self) -> Vec<Clause> {
        let Some(info) = &self.decoder.device.device_info else { return Vec::new() };
        self.roles(&[
            (
                info.lss_supported,
                "node-ID and bit rate can be set by LSS",
                "Knotennummer und Bitrate über LSS einstellbar",
            ),
            (info.lss_master, "can be the LSS master", "kann LSS-Master sein"),
        ])
    }
}

/// The nodes whose EMCY the device consumes (1028h), with the COB-IDs.
pub(super) fn emcy_consumers(decoder: &Decoder<'_>) -> Vec<(u8, CobId)> {
    let Some(object) = decoder.device.object(0x1028) else { return Vec::new() };
    let consumers =
        (1..=127).filter_map(|node| Some((node, CobId::from_value(object.value(node)?.as_ref())?)));
    consumers.filter(|(_, id)| id.is_valid() && id.can_id(0) != 0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::tests::record;
    use crate::model::{Device, DeviceInfo, Value};

    fn texts(device: &Device, node_id: Option<u8>, language: Language) -> Vec<String> {
        let decoder = Decoder { language, ..Decoder::english(device, node_id) };
        let services = services(&decoder, &|entry| entry.name.to_string());
        services
            .iter()
            .map(|service| format!("{}: {}", service.name, sentence::joined(&service.parts)))
            .collect()
    }

    fn device() -> Device {
        let mut device = Device::default();
        let var = |value| {
            let mut object = Object::default();
            object.main.default = Some(value);
            object
        };
        let number = |number| var(Value::Unsigned(number));
        device.device_info = Some(DeviceInfo { lss_supported: Some(true), ..DeviceInfo::default() });
        device.objects.insert(0x1003, record(&[(0, None), (1, None), (2, None)]));
        device.objects.insert(0x1005, number(0x4000_0080));
        device.objects.insert(0x1006, number(10_000));
        device.objects.insert(0x1014, var(Value::NodeId(0x80)));
        device.objects.insert(0x1015, number(105));
        device.objects.insert(0x1016, record(&[(0, Some(2)), (1, Some(0x0003_01F4)), (2, Some(0))]));
        device.objects.insert(0x1017, number(0));
        device.objects.insert(0x1028, record(&[(0, Some(2)), (1, Some(0x8000_0081)), (2, Some(0x82))]));
        device.objects.insert(0x1029, record(&[(0, Some(1)), (1, Some(0))]));
        device
            .objects
            .insert(0x1280, record(&[(0, Some(3)), (1, Some(0x8000_0000)), (2, None), (3, Some(7))]));
        device
    }

    #[test]
    fn services_in_english() {
        assert_eq!(
            texts(&device(), Some(5), Language::English),
            [
                "SYNC: COB-ID 0x080, produced, every 10 ms",
                "EMCY: COB-ID 0x085 with node-ID 5, inhibit time 10.5 ms, keeps the last 2 errors",
                "EMCY consumer: node 2: COB-ID 0x082",
                "Heartbeat producer: off",
                "Heartbeat consumer: node 3 within 500 ms",
                "SDO client 1: client to server not valid, server to client COB-ID not stated, the server is node 7",
                "On errors: : changes from operational to pre-operational",
                "LSS: node-ID and bit rate can be set by LSS",
            ]
        );
    }

    #[test]
    fn services_in_german() {
        let texts = texts(&device(), None, Language::German);
        assert_eq!(
            texts[..2],
            [
                "SYNC: COB-ID 0x080, wird gesendet, alle 10 ms",
                "EMCY: COB-ID $NODEID+0x80, Inhibit-Time 10,5 ms, merkt sich die letzten 2 Fehler",
            ]
        );
    }
}
