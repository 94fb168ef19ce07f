//! PDOs of a device as text, with their frame layout.

use super::anchor::Anchor;
use super::diagram::Diagram;
use super::layout::{FRAME_BITS, FieldKind, FrameContent, FrameLayout, LayoutField};
use super::sentence::{self, ChangedCobId, Clause};
use crate::Language;
use crate::describe::{Decoder, time};
use crate::model::{Entry, Pdo, PdoKind};
use objdict_model::diagnostic::plural;

/// View of a PDO.
pub(crate) struct PdoView {
    /// `TPDO 1`.
    pub(crate) title: String,
    /// `tpdo1`: its anchor in the page.
    pub(crate) id: String,
    /// Whether bit 31 of the COB-ID is set (not valid).
    pub(crate) is_off: bool,
    /// Communication and mapping parameter, if described.
    pub(crate) objects: Vec<Anchor>,
    /// The sentence.
    pub(crate) parts: Vec<Clause>,
    /// Problems of the mapping.
    pub(crate) remarks: Vec<String>,
    pub(crate) diagram: Option<Diagram>,
    pub(crate) rows: Vec<MappedObjectRow>,
}

/// A mapped object in the table.
pub(crate) struct MappedObjectRow {
    /// `0.0–1.7`; empty if outside the frame.
    pub(crate) span: String,
    /// The entry, if the description has it.
    pub(crate) anchor: Option<Anchor>,
    /// `0x6000:01`; empty for a mapping entry without an object.
    pub(crate) place: String,
    pub(crate) name: String,
    /// Empty if unknown.
    pub(crate) data_type: String,
    pub(crate) bits: u32,
    /// Whether a DCF maps a different object from the default.
    pub(crate) is_changed: bool,
}

/// All PDOs, RPDOs first. `name` supplies the names of entries.
pub(crate) fn pdos(decoder: &Decoder<'_>, name: &dyn Fn(&Entry) -> String) -> Vec<PdoView> {
    decoder.device.pdos().map(|pdo| view(decoder, &pdo, name)).collect()
}

/// The anchor of the PDO with this title: `tpdo1`.
pub(crate) fn anchor(title: &str) -> String {
    title.replace(' ', "").to_lowercase()
}

fn view(decoder: &Decoder<'_>, pdo: &Pdo<'_>, name: &dyn Fn(&Entry) -> String) -> PdoView {
    let layout = FrameLayout::new(decoder.device, pdo, name);
    let title = pdo.to_string();
    let objects = [(pdo.communication_index(), pdo.communication), (pdo.mapping_index(), pdo.mapping)];
    let objects = objects.into_iter().filter(|(_, object)| object.is_some());
    PdoView {
        id: anchor(&title),
        is_off: pdo.is_valid() == Some(false),
        objects: objects.map(|(index, _)| Anchor::object(index)).collect(),
        parts: PdoSentence { decoder, pdo, parts: Vec::new() }.all(&layout),
        remarks: remarks(decoder, pdo, &layout),
        diagram: Diagram::new(&title, &layout, decoder.language),
        rows: layout.fields.iter().map(|field| row(decoder, pdo, field)).collect(),
        title,
    }
}

/// Builder for the sentence about a PDO.
struct PdoSentence<'a> {
    decoder: &'a Decoder<'a>,
    pdo: &'a Pdo<'a>,
    parts: Vec<Clause>,
}

impl PdoSentence<'_> {
    fn all(mut self, layout: &FrameLayout) -> Vec<Clause> {
        self.cob_id();
        match self.pdo.transmission_type {
            Some(number) => {
                let text = self.decoder.transmission_type(self.pdo.kind, number.into());
                self.put(2, text);
            }
            None => self.say(2, ("transmission type not stated", "Übertragungsart nicht angegeben")),
        }
        self.times();
        self.mapping(layout);
        self.parts
    }

    fn put(&mut self, sub: u8, text: String) {
        self.parts.push(Clause::of(self.decoder, self.pdo.communication_index(), sub, text));
    }

    fn say(&mut self, sub: u8, (english, german): (&str, &str)) {
        self.put(sub, self.decoder.language.pick(english, german).to_owned());
    }

    fn cob_id(&mut self) {
        let Some(id) = self.pdo.cob_id else {
            return self.say(1, ("COB-ID not stated", "COB-ID nicht angegeben"));
        };
        let change = ChangedCobId::of(self.decoder, self.pdo.communication_index(), 1);
        self.put(1, sentence::cob_id(self.decoder, id));
        // for a PDO that the configuration makes valid, only this part can show the change
        self.only_if(change.can_id || (change.bit_31 && id.is_valid()));
        if !id.is_valid() {
            self.put(1, self.decoder.validity(id).to_owned());
            self.only_if(change.bit_31);
        }
        if self.pdo.kind == PdoKind::Tpdo {
            self.say(1, if id.bit_30() { ("no RTR", "kein RTR") } else { ("RTR allowed", "RTR erlaubt") });
            self.only_if(change.bit_30);
        }
    }

    /// Restricts the change mark of the last part.
    fn only_if(&mut self, is_changed: bool) {
        let last = self.parts.pop().map(|part| part.only_if(is_changed));
        self.parts.extend(last);
    }

    fn times(&mut self) {
        let language = self.decoder.language;
        let is_tpdo = self.pdo.kind == PdoKind::Tpdo;
        match self.pdo.inhibit_time {
            Some(0) if is_tpdo => self.say(3, ("inhibit time off", "Inhibit-Time aus")),
            Some(time @ 1..) => {
                let name = language.pick("inhibit time", "Inhibit-Time");
                self.put(3, format!("{name} {}", time::of_tenths(time.into(), language)));
            }
            _ => {}
        }
        match (self.pdo.event_timer, is_tpdo) {
            (Some(0), true) => self.say(5, ("event timer off", "Event-Timer aus")),
            (Some(0), false) => self.say(5, ("no deadline", "keine Überwachungszeit")),
            (Some(timer), true) => {
                let name = language.pick("event timer", "Event-Timer");
                self.put(5, format!("{name} {timer} ms"));
            }
            (Some(timer), false) => {
                let name = language.pick("expected every", "erwartet alle");
                self.put(5, format!("{name} {timer} ms"));
            }
            (None, _) => {}
        }
        if let Some(start @ 1..) = self.pdo.sync_start_value {
            let name = language.pick("counts from SYNC counter", "zählt ab SYNC-Zähler");
            self.put(6, format!("{name} {start}"));
        }
    }

    /// The mapping, and whether it can be changed.
    fn mapping(&mut self, layout: &FrameLayout) {
        let (language, index) = (self.decoder.language, self.pdo.mapping_index());
        let text = match (layout.content, layout.bits()) {
            _ if self.pdo.mapping.is_none() => {
                language.pick("mapping not described", "Mapping nicht beschrieben").to_owned()
            }
            (FrameContent::Nothing, _) => language.pick("carries nothing", "ohne Inhalt").to_owned(),
            (FrameContent::SourceMultiplexed, _) => {
                language.pick("multiplexed, names its source", "Multiplex-PDO, nennt seine Quelle").to_owned()
            }
            (FrameContent::DestinationMultiplexed, _) => language
                .pick("multiplexed, names its destination", "Multiplex-PDO, nennt sein Ziel")
                .to_owned(),
            (FrameContent::Reserved(_) | FrameContent::Unstated, _) | (_, None) => {
                language.pick("mapping not known", "Mapping nicht bekannt").to_owned()
            }
            (FrameContent::Objects, Some(bits)) => carries(bits, language),
        };
        self.parts.push(Clause::of(self.decoder, index, 0, text));
        let count = self.pdo.mapping.and_then(|mapping| mapping.entry(0));
        if let Some(access) = count.and_then(|count| count.access) {
            let (english, german) = match access.is_writable() {
                true => ("mapping variable", "Mapping änderbar"),
                false => ("mapping fixed", "Mapping fest"),
            };
            let part = Clause::of(self.decoder, index, 0, language.pick(english, german));
            self.parts.push(part.only_if(false));
        }
    }
}

/// `8 bytes`, `12 bits in 2 bytes`.
fn carries(bits: u32, language: Language) -> String {
    let bytes = bits.div_ceil(8);
    let bytes_text = match language {
        Language::English => plural(bytes as usize, "byte"),
        Language::German => format!("{bytes} Byte"),
    };
    let bit = if bits == 1 { language.pick("bit", "Bit") } else { language.pick("bits", "Bit") };
    match bits {
        _ if bits > FRAME_BITS => format!("{bits} {bit}"),
        _ if bits.is_multiple_of(8) => bytes_text,
        _ => format!("{bits} {bit} in {bytes_text}"),
    }
}

/// Problems of a mapping.
fn remarks(decoder: &Decoder<'_>, pdo: &Pdo<'_>, layout: &FrameLayout) -> Vec<String> {
    let mut remarks = Vec::new();
    match (layout.content, decoder.language) {
        (FrameContent::Reserved(count), Language::English) => {
            remarks.push(format!("{count} is not a valid number of mapped objects"));
        }
        (FrameContent::Reserved(count), Language::German) => {
            remarks.push(format!("{count} ist keine Anzahl gemappter Objekte"));
        }
        (FrameContent::Unstated, language) if pdo.mapping.is_some() => {
            let text = language.pick(
                "The description does not say how many objects are mapped.",
                "Die Beschreibung sagt nicht, wie viele Objekte gemappt sind.",
            );
            remarks.push(text.to_owned());
        }
        _ => {}
    }
    if let Some(bits) = layout.bits().filter(|&bits| bits > FRAME_BITS) {
        remarks.push(match decoder.language {
            Language::English => format!("{bits} bits are mapped, a frame has 64."),
            Language::German => format!("{bits} Bit sind gemappt, ein Frame hat 64."),
        });
    }
    if let Some(gap) = layout.fields.iter().find(|field| field.object.is_none()) {
        remarks.push(match decoder.language {
            Language::English => format!(
                "Sub-index {} of the mapping has no value, so the positions of the following objects are unknown.",
                gap.slot
            ),
            Language::German => format!(
                "Sub-Index {} des Mappings hat keinen Wert: Wo die Objekte danach liegen, ist nicht bekannt.",
                gap.slot
            ),
        });
    }
    remarks
}

fn row(decoder: &Decoder<'_>, pdo: &Pdo<'_>, field: &LayoutField) -> MappedObjectRow {
    let language = decoder.language;
    let object = field.object.filter(|object| !object.is_unused());
    let (english, german) = match field.kind {
        FieldKind::Object => ("", ""),
        FieldKind::Dummy => ("unused (dummy)", "unbenutzt (Dummy)"),
        FieldKind::Missing => ("not in the description", "nicht in der Beschreibung"),
        FieldKind::Gap if field.object.is_some() => ("nothing", "nichts"),
        FieldKind::Gap => ("not stated", "nicht angegeben"),
    };
    MappedObjectRow {
        span: field.span().map(|span| span.to_string()).unwrap_or_default()
            + if field.is_cut() && field.span().is_some() { "…" } else { "" },
        anchor: field.anchor(),
        place: object.map(|object| Anchor::entry(object.index, object.sub).spoken()).unwrap_or_default(),
        name: if field.kind == FieldKind::Object {
            field.name.clone()
        } else {
            language.pick(english, german).to_owned()
        },
        data_type: field.data_type.map(|data_type| data_type.to_string()).unwrap_or_default(),
        bits: field.bits,
        is_changed: sentence::is_changed(decoder, pdo.mapping_index(), field.slot),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::tests::{device, record};
    use crate::model::{Device, Value};

    fn views(device: &Device, node_id: Option<u8>, language: Language) -> Vec<PdoView> {
        let decoder = Decoder { language, ..Decoder::english(device, node_id) };
        pdos(&decoder, &|entry| entry.name.to_string())
    }

    fn with_communication(mut device: Device, cob_id: Value, rest: &[(u8, u64)]) -> Device {
        let mut values: Vec<(u8, Option<u64>)> = vec![(0, Some(5)), (1, None)];
        values.extend(rest.iter().map(|&(sub, value)| (sub, Some(value))));
        let mut object = record(&values);
        if let Some(entry) = object.subs.get_mut(1) {
            entry.default = Some(cob_id);
        }
        device.objects.insert(0x1800, object);
        device
    }

    #[test]
    fn a_pdo_in_words() {
        let device = device(Some(2), &[Some(0x6000_0108), Some(0x6000_0204)]);
        let rest = [(2, 255), (3, 100), (5, 0), (6, 0)];
        let device = with_communication(device, Value::NodeId(0x180), &rest);
        let view = &views(&device, Some(5), Language::English)[0];
        assert_eq!((view.title.as_str(), view.id.as_str(), view.is_off), ("TPDO 1", "tpdo1", false));
        assert_eq!(
            sentence::joined(&view.parts),
            "COB-ID 0x185 with node-ID 5, RTR allowed, event-driven, events of the device profile, \
             inhibit time 10 ms, event timer off, 12 bits in 2 bytes"
        );
        assert_eq!(view.parts[0].anchor, Some(Anchor::entry(0x1800, 1)));
        let rows: Vec<_> =
            view.rows.iter().map(|row| format!("{} {} {}", row.span, row.place, row.name)).collect();
        assert_eq!(rows, ["0.0–0.7 0x6000:01 Input 1", "1.0–1.3 0x6000:02 Input 2"]);
        assert!(view.remarks.is_empty());
    }

    #[test]
    fn a_pdo_that_does_not_exist_in_german() {
        let device =
            with_communication(device(Some(0), &[]), Value::Unsigned(0xC000_0285), &[(2, 3), (3, 15)]);
        let view = &views(&device, None, Language::German)[0];
        assert!(view.is_off && view.diagram.is_none());
        assert_eq!(
            sentence::joined(&view.parts),
            "COB-ID 0x285, ungültig, kein RTR, synchron, mit jedem 3. SYNC, \
             Inhibit-Time 1,5 ms, ohne Inhalt"
        );
    }

    #[test]
    fn what_is_configured_is_marked() {
        let mut device =
            with_communication(device(Some(0), &[]), Value::Unsigned(0x8000_0285), &[(2, 1), (3, 10)]);
        let mut configure = |sub, value| {
            let entry = device.objects.get_mut(&0x1800).and_then(|object| object.subs.get_mut(sub));
            if let Some(entry) = entry {
                entry.configured_mut().value = Some(Value::Unsigned(value));
            }
        };
        configure(1, 0xC000_0285);
        configure(3, 50);
        let view = &views(&device, Some(5), Language::English)[0];
        let marked: Vec<_> = view.parts.iter().filter(|part| part.is_changed).collect();
        let texts: Vec<_> =
            marked.iter().map(|part| (&*part.text, part.default.as_deref().unwrap_or(""))).collect();
        assert_eq!(texts, [("no RTR", "CAN-ID 0x285, 11 bits, not valid"), ("inhibit time 5 ms", "1 ms"),]);
    }

    #[test]
    fn what_is_odd_is_noted() {
        let remarks = |count, mapped: &[Option<u64>]| {
            views(&device(count, mapped), None, Language::English)[0].remarks.join(" ")
        };
        assert_eq!(remarks(Some(70), &[]), "70 is not a valid number of mapped objects");
        let long = remarks(Some(2), &[Some(0x6000_0140), Some(0x6000_0208)]);
        assert_eq!(long, "72 bits are mapped, a frame has 64.");
        assert!(remarks(None, &[Some(0x6000_0108)]).starts_with("The description does not say"));
        assert!(
            remarks(Some(2), &[Some(0x6000_0108)]).starts_with("Sub-index 2 of the mapping has no value")
        );
    }
}
