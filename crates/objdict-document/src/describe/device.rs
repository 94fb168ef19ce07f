//! Device type, error control and parameter storage.

use super::decoder::Decoder;
use super::time;
use crate::model::{HeartbeatConsumer, Value};
use crate::{Language, profile};

/// The signatures for 1010h, 1011h and 1F25h, which prevent accidental writes.
const SIGNATURES: [(u16, u32, &str); 3] =
    [(0x1010, 0x6576_6173, "save"), (0x1011, 0x6461_6F6C, "load"), (0x1F25, 0x666E_6F63, "conf")];

/// Whether CiA assigns the number to a device profile: these are the documents CiA 4xx.
pub(crate) const fn is_of_cia(profile: u32) -> bool {
    matches!(profile, 400..=499)
}

impl Decoder<'_> {
    pub(super) fn device_type(&self, number: u32) -> String {
        let (additional, profile) = (number >> 16, number & 0xFFFF);
        let information = self.pick("additional information", "Zusatzinformation");
        if profile == 0 {
            return self.pick("no device profile", "kein Geräteprofil").to_owned();
        }
        if profile == 0xFFFF {
            let several = self.pick("several devices in one", "mehrere Geräte in einem");
            return format!("{several}, {information} 0x{additional:04X}");
        }
        let name = self.profile_name(profile).map(|name| format!(" ({name})")).unwrap_or_default();
        let of = if is_of_cia(profile) { self.pick("device profile ", "Geräteprofil ") } else { "" };
        let profile = self.numbered(profile);
        format!("{of}{profile}{name}, {information} 0x{additional:04X}") + &self.additional(number)
    }

    /// The device profile: `CiA 402`; `None` for a device without one.
    pub fn device_profile(&self) -> Option<String> {
        match self.device.profile()? {
            0 => None,
            0xFFFF => Some(self.pick("several device profiles", "mehrere Geräteprofile").to_owned()),
            profile => Some(self.numbered(profile.into())),
        }
    }

    /// `CiA 402`; different text for a number without a CiA document.
    fn numbered(&self, profile: u32) -> String {
        if is_of_cia(profile) {
            return format!("CiA {profile}");
        }
        let (number, remark) = (
            self.pick("profile number", "Profilnummer"),
            self.pick("not a CiA profile", "kein Profil von CiA"),
        );
        format!("{number} {profile} ({remark})")
    }

    /// The subject of a device profile.
    fn profile_name(&self, profile: u32) -> Option<&'static str> {
        let (english, german) = match profile {
            401 => ("I/O modules", "E/A-Module"),
            402 => ("drives", "Antriebe"),
            404 => ("measuring devices and closed-loop controllers", "Messgeräte und Regler"),
            405 => ("programmable devices", "programmierbare Geräte"),
            406 => ("encoders", "Drehgeber"),
            408 => ("hydraulic drives", "hydraulische Antriebe"),
            410 => ("inclinometers", "Neigungssensoren"),
            412 => ("medical devices", "medizinische Geräte"),
            413 => ("truck gateways", "Lkw-Gateways"),
            414 => ("yarn feeding units", "Fadenlieferwerke"),
            417 => ("lifts", "Aufzüge"),
            418 => ("battery modules", "Batteriemodule"),
            419 => ("battery chargers", "Batterieladegeräte"),
            _ => return None,
        };
        Some(self.language.pick(english, german))
    }

    /// The high word as defined by the device profile.
    fn additional(&self, number: u32) -> String {
        let high_word = Value::Unsigned(u64::from(number & 0xFFFF_0000));
        let meaning = profile::meaning(self.device, 0x1000, 0, &high_word).filter(|_| number >> 16 != 0);
        meaning.map(|meaning| format!(" ({meaning})")).unwrap_or_default()
    }

    pub(super) fn revision(&self, number: u32) -> String {
        let (major, minor) = (number >> 16, number & 0xFFFF);
        match self.language {
            Language::English => format!("major {major}, minor {minor}"),
            Language::German => format!("Hauptrevision {major}, Nebenrevision {minor}"),
        }
    }

    pub(super) fn life_time(&self, factor: u32) -> String {
        match (factor, self.number(0x100C, 0)) {
            (0, _) => self.pick("off", "aus").to_owned(),
            (_, Some(guard @ 1..=0xFFFF)) => {
                let life = self.pick("life time", "Lebenszeit");
                format!("{life} {}", time::of_milliseconds(guard.saturating_mul(factor), self.language))
            }
            _ => format!("{factor} × {}", self.pick("guard time", "Guard-Time")),
        }
    }

    pub(super) fn heartbeat_consumer(&self, sub: u8, number: u32) -> String {
        match HeartbeatConsumer::from_number(sub, number) {
            None => self.pick("unused", "unbenutzt").to_owned(),
            Some(HeartbeatConsumer { node_id, time, .. }) => {
                format!("{} {node_id}, {time} ms", self.pick("node", "Knoten"))
            }
        }
    }

    pub(crate) fn sync_counter(&self, highest: u32) -> String {
        match (highest, self.language) {
            (0, Language::English) => "SYNC has no counter".to_owned(),
            (0, Language::German) => "SYNC ohne Zähler".to_owned(),
            (2..=240, Language::English) => format!("SYNC counts from 1 to {highest}"),
            (2..=240, Language::German) => format!("SYNC zählt von 1 bis {highest}"),
            _ => self.pick("reserved", "reserviert").to_owned(),
        }
    }

    pub(super) fn configuration_date(&self, days: u32) -> String {
        if days == 0 {
            return self.pick("not configured", "nicht konfiguriert").to_owned();
        }
        time::date(days).unwrap_or_else(|| format!("1984-01-01 + {days} d"))
    }

    pub(crate) fn other_node(&self, index: u16, node: u32) -> Option<String> {
        let (english, german) = match index {
            0x1200..=0x127F => ("the client is node", "der Client ist Knoten"),
            _ => ("the server is node", "der Server ist Knoten"),
        };
        (1..=127).contains(&node).then(|| format!("{} {node}", self.pick(english, german)))
    }

    /// The capabilities that a read returns, or the signature that triggers the action.
    pub(super) fn storage(&self, index: u16, number: u32) -> Option<String> {
        let mut signatures = SIGNATURES.into_iter();
        if let Some((.., text)) = signatures.find(|&(of, signature, _)| (of, signature) == (index, number)) {
            return Some(format!("{} `{text}`", self.pick("signature", "Signatur")));
        }
        let (english, german) = match (index, number & 3) {
            (0x1010, 0) => ("does not store parameters", "speichert keine Parameter"),
            (0x1010, 1) => ("stores on command", "speichert auf Befehl"),
            (0x1010, 2) => ("stores automatically", "speichert automatisch"),
            (0x1010, _) => ("stores on command and automatically", "speichert auf Befehl und automatisch"),
            (0x1011, 0 | 2) => ("does not restore defaults", "stellt keine Vorgaben wieder her"),
            (0x1011, _) => ("restores defaults on command", "stellt Vorgaben auf Befehl wieder her"),
            _ => return None,
        };
        Some(self.pick(english, german).to_owned())
    }
}
