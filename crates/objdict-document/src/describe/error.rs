//! Errors: the register, the history, and the effect on the NMT state.

use super::decoder::Decoder;
use crate::{Language, profile};

/// The bits of 1001h; bit 6 is reserved.
const REGISTER: [(u32, &str, &str); 7] = [
    (0, "generic error", "allgemeiner Fehler"),
    (1, "current", "Strom"),
    (2, "voltage", "Spannung"),
    (3, "temperature", "Temperatur"),
    (4, "communication", "Kommunikation"),
    (5, "device-profile-specific", "des Geräteprofils"),
    (7, "manufacturer-specific", "des Herstellers"),
];

/// Error codes by leading bits: mask, code, text. The first match applies.
const CODES: [(u32, u32, &str, &str); 31] = [
    (0xFFFF, 0x8110, "CAN overrun", "CAN-Überlauf"),
    (0xFFFF, 0x8120, "CAN error passive", "CAN Error-Passive"),
    (0xFFFF, 0x8130, "heartbeat or guarding lost", "Heartbeat oder Guarding ausgeblieben"),
    (0xFFFF, 0x8140, "recovered from bus-off", "Bus-Off überwunden"),
    (0xFFFF, 0x8150, "CAN-ID collision", "CAN-ID doppelt benutzt"),
    (0xFFFF, 0x8210, "PDO too short, not processed", "PDO zu kurz, nicht verarbeitet"),
    (0xFFFF, 0x8220, "PDO longer than mapped", "PDO länger als das Mapping"),
    (0xFFFF, 0x8230, "MPDO without destination", "MPDO ohne Ziel"),
    (0xFFFF, 0x8240, "wrong length of SYNC", "falsche Länge von SYNC"),
    (0xFFFF, 0x8250, "RPDO timed out", "RPDO ausgeblieben"),
    (0xFF00, 0x0000, "no error", "kein Fehler"),
    (0xFF00, 0x1000, "generic error", "allgemeiner Fehler"),
    (0xFF00, 0x2100, "current, input side", "Strom, Eingangsseite"),
    (0xFF00, 0x2200, "current, inside the device", "Strom im Gerät"),
    (0xFF00, 0x2300, "current, output side", "Strom, Ausgangsseite"),
    (0xFF00, 0x3100, "mains voltage", "Netzspannung"),
    (0xFF00, 0x3200, "voltage inside the device", "Spannung im Gerät"),
    (0xFF00, 0x3300, "output voltage", "Ausgangsspannung"),
    (0xFF00, 0x4100, "ambient temperature", "Umgebungstemperatur"),
    (0xFF00, 0x4200, "device temperature", "Gerätetemperatur"),
    (0xFF00, 0x6100, "internal software", "interne Software"),
    (0xFF00, 0x6200, "user software", "Anwendersoftware"),
    (0xFF00, 0x6300, "data set", "Datensatz"),
    (0xFF00, 0x8100, "communication", "Kommunikation"),
    (0xFF00, 0x8200, "protocol", "Protokoll"),
    (0xF000, 0x2000, "current", "Strom"),
    (0xF000, 0x3000, "voltage", "Spannung"),
    (0xF000, 0x4000, "temperature", "Temperatur"),
    (0xF000, 0x5000, "hardware", "Hardware"),
    (0xF000, 0x6000, "software", "Software"),
    (0xF000, 0x7000, "additional modules", "Zusatzmodule"),
];

/// The error codes of communication that a document names individually.
pub(crate) fn single_codes(language: Language) -> impl Iterator<Item = (u32, &'static str)> {
    let single = CODES.into_iter().filter(|(mask, ..)| *mask == 0xFFFF);
    single.map(move |(_, code, english, german)| (code, language.pick(english, german)))
}

/// The error codes with specific text, and their English text.
pub(crate) fn error_codes() -> impl Iterator<Item = (i128, &'static str)> {
    CODES.into_iter().map(|(_, code, english, _)| (i128::from(code), english))
}

impl Decoder<'_> {
    pub(super) fn error_register(&self, number: u32) -> String {
        let set = REGISTER.into_iter().filter(|(bit, ..)| number >> bit & 1 == 1);
        let names: Vec<&str> = set.map(|(_, english, german)| self.pick(english, german)).collect();
        if names.is_empty() { self.pick("no error", "kein Fehler").to_owned() } else { names.join(", ") }
    }

    pub(super) fn error_field(&self, number: u32) -> String {
        let (code, additional) = (number & 0xFFFF, number >> 16);
        if number == 0 {
            return self.pick("no error", "kein Fehler").to_owned();
        }
        let information = self.pick("additional information", "Zusatzinformation");
        format!("0x{code:04X} ({}), {information} 0x{additional:04X}", self.error_code(code))
    }

    /// The error code of an emergency message: the device profile is more exact than CiA 301.
    pub(super) fn error_code(&self, code: u32) -> &'static str {
        if let Some(text) = profile::of_device(self.device).and_then(|profile| profile.error(code.into())) {
            return text;
        }
        let known = CODES.into_iter().find(|(mask, of, ..)| code & mask == *of);
        match (known, code >> 8) {
            (Some((.., english, german)), _) => self.pick(english, german),
            (None, 0x80..=0x8F) => self.pick("monitoring", "Überwachung"),
            (None, 0x90..=0x9F) => self.pick("external error", "externer Fehler"),
            (None, 0xF0..=0xFE) => self.pick("additional functions", "Zusatzfunktionen"),
            (None, 0xFF) => self.pick("of the device", "gerätespezifisch"),
            (None, _) => self.pick("reserved", "reserviert"),
        }
    }

    /// The error behaviour (1029h).
    pub(crate) fn error_reaction(&self, reaction: u32) -> String {
        let (english, german) = match reaction {
            0 => {
                ("changes from operational to pre-operational", "wechselt von operational in pre-operational")
            }
            1 => ("the NMT state does not change", "der NMT-Zustand ändert sich nicht"),
            2 => ("the device stops", "das Gerät wechselt in stopped"),
            0x80..=0xFF => ("manufacturer-specific", "herstellerspezifisch"),
            _ => ("reserved", "reserviert"),
        };
        self.pick(english, german).to_owned()
    }
}
