//! The CAN-IDs of a node: the predefined connection set (CiA 301 §7.3.5) with its current configuration, and
//! all further CAN-IDs in use.

use super::anchor::Anchor;
use super::sentence::{self, ChangedCobId, is_same};
use super::services::emcy_consumers;
use super::texts::LanguageTexts;
use crate::describe::{Decoder, can_id};
use crate::model::{CobId, PdoKind, SdoChannel, Services, predefined};

/// A row of the table.
pub(crate) struct ConnectionRow {
    /// `TPDO 1`.
    pub(crate) service: String,
    /// From the perspective of the device.
    pub(crate) direction: Direction,
    /// The CAN-ID of the predefined connection set; empty for other services.
    pub(crate) predefined: String,
    /// The CAN-ID of this device; empty if there is none or the description does not state it.
    pub(crate) own: String,
    pub(crate) state: ServiceUse,
    /// The object that states it.
    pub(crate) anchor: Option<Anchor>,
    /// Whether the configured CAN-ID, or whether the service is valid, differs from the default.
    pub(crate) is_changed: bool,
}

/// The sender, from the view of the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// The device sends.
    Sends,
    /// Other devices send.
    Receives,
    /// The device and other devices send.
    Both,
}

impl Direction {
    /// An arrow out of the device, into it, or both ways.
    pub(crate) const fn arrow(self) -> &'static str {
        match self {
            Self::Sends => "→",
            Self::Receives => "←",
            Self::Both => "↔",
        }
    }

    /// The role of the device, as text.
    pub(crate) const fn word(self, texts: &LanguageTexts) -> &'static str {
        match self {
            Self::Sends => texts.sends,
            Self::Receives => texts.receives,
            Self::Both => texts.sends_and_receives,
        }
    }
}

/// How the device uses a service.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ServiceUse {
    /// Uses the predefined CAN-ID, or the service has none.
    Used,
    /// Uses a CAN-ID other than the predefined one.
    Differs,
    /// Marked as not valid by bit 31.
    Off,
    /// The CAN-ID is not stated in the description.
    Unstated,
    /// The description does not contain the service.
    Absent,
}

impl ServiceUse {
    /// The CSS class.
    pub(crate) const fn class(self) -> &'static str {
        match self {
            Self::Used => "used",
            Self::Differs => "differs",
            Self::Off => "off",
            Self::Unstated => "unstated",
            Self::Absent => "absent",
        }
    }

    /// A remark next to, or instead of, the CAN-ID; empty if none is needed.
    pub(crate) const fn word(self, texts: &LanguageTexts) -> &'static str {
        match self {
            Self::Used => "",
            Self::Differs => texts.differs,
            Self::Off => texts.not_valid,
            Self::Unstated => texts.not_stated,
            Self::Absent => texts.absent,
        }
    }
}

/// The CAN-IDs of a node.
pub(crate) fn connections(decoder: &Decoder<'_>) -> Vec<ConnectionRow> {
    let services = decoder.device.services();
    let mut table = ServiceTable { decoder, lines: Vec::new() };
    table.network(&services);
    table.pdos();
    table.sdo(&services);
    table.error_control(&services);
    table.lss();
    table.others(&services);
    table.lines
}

struct ServiceTable<'a> {
    decoder: &'a Decoder<'a>,
    lines: Vec<ConnectionRow>,
}

/// A COB-ID not set by any object.
const FIXED: Option<(u16, u8)> = None;

impl ServiceTable<'_> {
    fn pick(&self, english: &'static str, german: &'static str) -> &'static str {
        self.decoder.language.pick(english, german)
    }

    /// Adds a row for a service that the device has.
    fn put(
        &mut self,
        service: impl Into<String>,
        direction: Direction,
        predefined: Option<CobId>,
        own: Option<CobId>,
        place: Option<(u16, u8)>,
    ) {
        let node_id = self.decoder.node_id;
        let state = match (own, predefined) {
            (None, _) => ServiceUse::Unstated,
            (Some(own), _) if !own.is_valid() => ServiceUse::Off,
            (Some(own), Some(predefined)) if !is_same(own, predefined, node_id) => ServiceUse::Differs,
            _ => ServiceUse::Used,
        };
        self.lines.push(ConnectionRow {
            service: service.into(),
            direction,
            predefined: predefined.map(|id| can_id(id, node_id)).unwrap_or_default(),
            own: own.filter(|_| state != ServiceUse::Off).map(|id| can_id(id, node_id)).unwrap_or_default(),
            state,
            anchor: place.and_then(|(index, sub)| sentence::anchor(self.decoder.device, index, sub)),
            is_changed: place.is_some_and(|place| self.is_changed(place)),
        });
    }

    /// Whether the configured value changes the CAN-ID or makes the service valid or not valid.
    fn is_changed(&self, (index, sub): (u16, u8)) -> bool {
        match index {
            // these objects only set times
            0x100C | 0x1017 | 0x1300 => false,
            0x1016 => sentence::is_changed(self.decoder, index, sub),
            _ => {
                let change = ChangedCobId::of(self.decoder, index, sub);
                change.can_id || (change.bit_31 && index != 0x1005)
            }
        }
    }

    /// Adds a row for a service of the predefined connection set with a configuration object, which may be
    /// missing.
    fn described(
        &mut self,
        service: &str,
        direction: Direction,
        predefined: CobId,
        own: Option<CobId>,
        (index, sub): (u16, u8),
    ) {
        self.put(service, direction, Some(predefined), own, Some((index, sub)));
        if self.decoder.device.object(index).is_none()
            && let Some(line) = self.lines.last_mut()
        {
            line.state = ServiceUse::Absent;
        }
    }

    fn network(&mut self, services: &Services) {
        let info = self.decoder.device.device_info.as_ref();
        let is_master = info
            .is_some_and(|info| info.simple_boot_up_master == Some(true) || info.flying_master == Some(true));
        let direction = if is_master { Direction::Both } else { Direction::Receives };
        self.put("NMT", direction, Some(CobId::new(0)), Some(CobId::new(0)), FIXED);
        if self.decoder.device.object(0x1300).is_some() {
            let id = Some(CobId::new(1));
            self.put("GFC", Direction::Both, id, id, Some((0x1300, 0)));
        }
        let sync = match services.sync.is_some_and(CobId::bit_30) {
            true => Direction::Sends,
            false => Direction::Receives,
        };
        let id_of = |base: u16| CobId::new(base.into());
        // bit 31 has no meaning for SYNC, and for TIME it does not mean "not valid"
        let flagless = CobId::enabled;
        self.described("SYNC", sync, id_of(predefined::SYNC), services.sync.map(flagless), (0x1005, 0));
        let time = services.time;
        let roles = time.map(|id| (!id.is_valid(), id.bit_30()));
        let direction = match roles {
            Some((false, true)) => Direction::Sends,
            Some((true, true)) => Direction::Both,
            _ => Direction::Receives,
        };
        self.described("TIME", direction, id_of(predefined::TIME), time.map(flagless), (0x1012, 0));
        if roles == Some((false, false))
            && let Some(line) = self.lines.last_mut()
        {
            line.state = ServiceUse::Off;
            line.own.clear();
        }
        let emcy = predefined::per_node(predefined::EMCY);
        self.described("EMCY", Direction::Sends, emcy, services.emcy, (0x1014, 0));
    }

    fn pdos(&mut self) {
        for number in 1..=4 {
            for kind in [PdoKind::Tpdo, PdoKind::Rpdo] {
                let base = kind.predefined_can_id(number).map(predefined::per_node);
                let (Some(base), Some(index)) = (base, kind.communication_index(number)) else { continue };
                let own = self.decoder.device.pdo(kind, number).and_then(|pdo| pdo.cob_id);
                self.described(&format!("{kind} {number}"), direction(kind), base, own, (index, 1));
            }
        }
    }

    fn sdo(&mut self, services: &Services) {
        let first = services.sdo_servers.iter().find(|channel| channel.number == 1);
        let request = predefined::per_node(predefined::SDO_REQUEST);
        let response = predefined::per_node(predefined::SDO_RESPONSE);
        let own = |of: fn(&SdoChannel) -> Option<CobId>, implied| first.map_or(Some(implied), of);
        let place = |sub| first.map(|channel| (channel.index, sub));
        let name = self.pick("SDO 1, request", "SDO 1, Anfrage");
        let id = own(|channel| channel.request, request);
        self.put(name, Direction::Receives, Some(request), id, place(1));
        let name = self.pick("SDO 1, response", "SDO 1, Antwort");
        let id = own(|channel| channel.response, response);
        self.put(name, Direction::Sends, Some(response), id, place(2));
    }

    /// Heartbeat, boot-up and guarding. Boot-up is always sent.
    fn error_control(&mut self, services: &Services) {
        let id = Some(predefined::per_node(predefined::ERROR_CONTROL));
        let heartbeat = services.heartbeat_time.is_some_and(|time| time > 0);
        let guarding = self.decoder.number(0x100C, 0).is_some_and(|time| time > 0);
        let (name, index) = match (heartbeat, guarding) {
            (true, _) => (self.pick("Heartbeat, boot-up", "Heartbeat, Boot-up"), Some(0x1017)),
            (false, true) => (self.pick("Guarding, boot-up", "Guarding, Boot-up"), Some(0x100C)),
            (false, false) => {
                let has = |index| self.decoder.device.object(index).is_some();
                (self.pick("Boot-up, error control", "Boot-up, Überwachung"), has(0x1017).then_some(0x1017))
            }
        };
        self.put(name, Direction::Sends, id, id, index.map(|index| (index, 0)));
    }

    fn lss(&mut self) {
        let info = self.decoder.device.device_info.as_ref();
        let is_slave = info.is_some_and(|info| info.lss_supported == Some(true));
        let is_master = info.is_some_and(|info| info.lss_master == Some(true));
        let (from_master, from_slave) = match (is_slave, is_master) {
            (true, false) => (Direction::Receives, Direction::Sends),
            (false, true) => (Direction::Sends, Direction::Receives),
            (true, true) => (Direction::Both, Direction::Both),
            (false, false) => return,
        };
        let (response, request) = (Some(CobId::new(0x7E4)), Some(CobId::new(0x7E5)));
        self.put(self.pick("LSS, response", "LSS, Antwort"), from_slave, response, response, FIXED);
        self.put(self.pick("LSS, request", "LSS, Anfrage"), from_master, request, request, FIXED);
    }

    /// Services outside the predefined connection set that are valid.
    fn others(&mut self, services: &Services) {
        for pdo in self.decoder.device.pdos().filter(|pdo| pdo.number > 4) {
            if let Some(id) = pdo.cob_id.filter(|id| id.is_valid()) {
                let place = Some((pdo.communication_index(), 1));
                self.put(pdo.to_string(), direction(pdo.kind), None, Some(id), place);
            }
        }
        let (server, client) = (self.pick("SDO", "SDO"), self.pick("SDO client", "SDO-Client"));
        for channel in services.sdo_servers.iter().filter(|channel| channel.number > 1) {
            self.channel(server, channel, (Direction::Receives, Direction::Sends));
        }
        for channel in &services.sdo_clients {
            self.channel(client, channel, (Direction::Sends, Direction::Receives));
        }
        let of = self.pick("of node", "von Knoten");
        for (node, id) in emcy_consumers(self.decoder) {
            self.put(format!("EMCY {of} {node}"), Direction::Receives, None, Some(id), Some((0x1028, node)));
        }
        for consumer in &services.heartbeat_consumers {
            let id = CobId::new(u32::from(predefined::ERROR_CONTROL) + u32::from(consumer.node_id));
            let service = format!("Heartbeat {of} {}", consumer.node_id);
            self.put(service, Direction::Receives, None, Some(id), Some((0x1016, consumer.sub)));
        }
        self.srdos();
    }

    fn channel(&mut self, name: &str, channel: &SdoChannel, (request, response): (Direction, Direction)) {
        let both = [
            (1, channel.request, request, self.pick("request", "Anfrage")),
            (2, channel.response, response, self.pick("response", "Antwort")),
        ];
        for (sub, id, direction, what) in both {
            if let Some(id) = id.filter(|id| id.is_valid()) {
                let service = format!("{name} {}, {what}", channel.number);
                self.put(service, direction, None, Some(id), Some((channel.index, sub)));
            }
        }
    }

    /// Each SRDO has two frames (CiA 304).
    fn srdos(&mut self) {
        for number in 1..=64 {
            let index = 0x1300 + number;
            let direction = match self.decoder.number(index, 1) {
                Some(1) => Direction::Sends,
                Some(2) => Direction::Receives,
                _ => continue,
            };
            for (sub, what) in [(5, ""), (6, self.pick(", inverted", ", invertiert"))] {
                let entry = self.decoder.device.entry(index, sub);
                let id = entry.and_then(|entry| CobId::from_value(entry.value()?));
                self.put(format!("SRDO {number}{what}"), direction, None, id, Some((index, sub)));
            }
        }
    }
}

const fn direction(kind: PdoKind) -> Direction {
    match kind {
        PdoKind::Rpdo => Direction::Receives,
        PdoKind::Tpdo => Direction::Sends,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::tests::record;
    use crate::model::{Device, DeviceInfo, Value};

    fn lines(device: &Device, node_id: Option<u8>) -> Vec<String> {
        let decoder = Decoder::english(device, node_id);
        let line = |line: &ConnectionRow| {
            format!(
                "{} {} {} {} {:?}",
                line.service,
                line.direction.arrow(),
                line.predefined,
                line.own,
                line.state
            )
        };
        connections(&decoder).iter().map(line).collect()
    }

    #[test]
    fn the_predefined_set_of_an_empty_device() {
        let lines = lines(&Device::default(), None);
        assert_eq!(lines.len(), 15);
        assert_eq!(lines[0], "NMT ← 0x000 0x000 Used");
        assert_eq!(lines[1], "SYNC ← 0x080  Absent");
        assert_eq!(lines[4], "TPDO 1 → $NODEID+0x180  Absent");
        assert_eq!(lines[13], "SDO 1, response → $NODEID+0x580 $NODEID+0x580 Used");
    }

    #[test]
    fn what_a_device_makes_of_it() {
        let mut device = Device::default();
        let mut rpdo = record(&[(0, Some(2)), (1, None)]);
        if let Some(entry) = rpdo.subs.get_mut(1) {
            entry.default = Some(Value::NodeId(0x200));
        }
        device.objects.insert(0x1400, rpdo);
        device.objects.insert(0x1800, record(&[(1, Some(0x1A5))]));
        device.objects.insert(0x1801, record(&[(1, Some(0x8000_0285))]));
        device.objects.insert(0x1804, record(&[(1, Some(0x4000_0333))]));
        device.objects.insert(0x1805, record(&[(1, Some(0x8000_0334))]));
        device.objects.insert(0x1016, record(&[(0, Some(1)), (1, Some(0x0003_01F4))]));
        device.objects.insert(0x1301, record(&[(1, Some(1)), (5, Some(0x109)), (6, Some(0x10A))]));
        device.device_info = Some(DeviceInfo { lss_supported: Some(true), ..DeviceInfo::default() });
        let lines = lines(&device, Some(5));
        for expected in [
            "RPDO 1 ← 0x205 0x205 Used",
            "TPDO 1 → 0x185 0x1A5 Differs",
            "TPDO 2 → 0x285  Off",
            "LSS, response → 0x7E4 0x7E4 Used",
            "TPDO 5 →  0x333 Used",
            "Heartbeat of node 3 ←  0x703 Used",
            "SRDO 1, inverted →  0x10A Used",
        ] {
            assert!(lines.iter().any(|line| line == expected), "{expected}: {lines:#?}");
        }
        assert!(!lines.iter().any(|line| line.starts_with("TPDO 6")));
    }
}
