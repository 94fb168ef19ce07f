//! Contents of PDO frames for the targets `rust` and `c`: a struct for each PDO of the default mapping.
//!
//! A frame is a single number of at most 64 bits whose bytes are transmitted lowest first (CiA 301 §7.2.2.2), so fields
//! of any length are packed by shifting.

use super::Note;
use super::names::{NameScope, words};
use super::notes::once_per_device;
use super::resolve::{EntryPlan, ValueShape};
use super::table::{DeviceTable, Row};
use crate::model::{Access, CobId, DataType, Device, MappedObject, Pdo, PdoKind, Place, TypeKind};

/// A PDO with the contents of its frame.
#[derive(Debug)]
pub(crate) struct PdoFrame {
    /// `RPDO 1`, for comments.
    pub(crate) title: String,
    /// `rpdo1`: the base of identifiers.
    pub(crate) name: String,
    pub(crate) communication_index: u16,
    pub(crate) mapping_index: u16,
    /// If stated in the description.
    pub(crate) cob_id: Option<CobId>,
    /// If stated in the description.
    pub(crate) transmission_type: Option<u8>,
    /// Length in bytes, 1 to 8.
    pub(crate) length: u32,
    /// In frame order, without dummy entries.
    pub(crate) fields: Vec<FrameField>,
}

/// A mapped entry.
#[derive(Debug)]
pub(crate) struct FrameField {
    /// Unique in the frame; not a keyword.
    pub(crate) name: String,
    /// The number of its row.
    pub(crate) row: usize,
    /// Its type in the struct.
    pub(crate) carried: CarriedType,
    /// Its lowest bit in the frame.
    pub(crate) first: u32,
    /// The number of bits of its value, 1 to 64: the mapped length, at most the length of the type.
    pub(crate) bits: u32,
}

/// The type of a mapped entry in the struct.
#[derive(Debug)]
pub(crate) enum CarriedType {
    /// A number of this type.
    Number(DataType),
    /// This many bytes.
    Bytes(u32),
}

impl FrameField {
    /// Whether the highest bit is a sign.
    pub(crate) fn is_signed(&self) -> bool {
        matches!(self.carried, CarriedType::Number(data_type) if matches!(data_type.kind(), TypeKind::Signed(_)))
    }
}

impl PdoFrame {
    /// Whether the node-ID is added to the COB-ID.
    pub(crate) fn depends_on_node_id(&self) -> bool {
        self.cob_id.is_some_and(CobId::depends_on_node_id)
    }
}

/// Makes PDO mappings read-only, because the structs of PDOs would not follow a changed one. Those with a hook
/// are left to the application. `unless` names the option that allows SDOs to write them.
pub(crate) fn freeze_mappings(table: &mut DeviceTable, unless: &str) -> Vec<Note> {
    let is_mapping = |index| matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF);
    let rows = table.rows.iter_mut();
    let frozen = rows.filter(|row| is_mapping(row.index) && !row.hooked && row.access().is_writable());
    let notes = frozen.map(|row| {
        row.resolved.access = Access::Ro;
        row.resolved.rpdo = false;
        let text = format!("SDOs cannot write PDO mappings; {unless}");
        Note::new(Place::entry(row.index, row.sub), text)
    });
    once_per_device(notes.collect())
}

/// The frames of the default mapping. PDOs that cannot become a struct are noted.
pub(crate) fn frames(device: &Device, table: &DeviceTable, notes: &mut Vec<Note>) -> Vec<PdoFrame> {
    device.pdos().filter_map(|pdo| frame(&pdo, table, notes)).collect()
}

fn frame(pdo: &Pdo<'_>, table: &DeviceTable, notes: &mut Vec<Note>) -> Option<PdoFrame> {
    let place = Place::object(pdo.mapping_index());
    if pdo.is_multiplexed() {
        notes.push(Note::new(place, format!("{pdo} is multiplexed, so it has no struct")));
        return None;
    }
    let bits = pdo.bit_length();
    if bits > Pdo::FRAME_BITS {
        let text = format!("{pdo} maps {bits} bits, but a frame has 64; it has no struct");
        notes.push(Note::new(place, text));
        return None;
    }
    let mut scope = NameScope::of_lower_case("");
    let mut fields = Vec::new();
    let placed = MappedObject::placed(pdo.mapped_slots(), |(_, object)| object.bits);
    for (first, (sub, object)) in placed.filter(|(_, (_, object))| !object.is_dummy()) {
        let place = Place::entry(pdo.mapping_index(), sub);
        match field(object, first, table, &mut scope) {
            Ok(field) => fields.push(field),
            Err(why) => notes.push(Note::new(place, format!("{object} is not a field of {pdo}: {why}"))),
        }
    }
    let name = format!("{}{}", if pdo.kind == PdoKind::Rpdo { "rpdo" } else { "tpdo" }, pdo.number);
    (!fields.is_empty()).then(|| PdoFrame {
        title: pdo.to_string(),
        name,
        communication_index: pdo.communication_index(),
        mapping_index: pdo.mapping_index(),
        cob_id: pdo.cob_id,
        transmission_type: pdo.transmission_type,
        length: bits.div_ceil(8),
        fields,
    })
}

fn field(
    object: MappedObject,
    first: u32,
    table: &DeviceTable,
    scope: &mut NameScope,
) -> Result<FrameField, &'static str> {
    let key = (object.index, object.sub);
    let row = table.rows.binary_search_by_key(&key, |row| (row.index, row.sub));
    let row = row.map_err(|_| "the entry does not exist")?;
    let (carried, bits) = carried(&table.rows[row].resolved, u32::from(object.bits))?;
    let name = name_of(table, &table.rows[row]);
    let name = scope.claim(&words(&name), format_args!("{:04x}_{:02x}", object.index, object.sub));
    Ok(FrameField { name, row, carried, first, bits })
}

/// Packs a value of an entry into this many bits of a frame.
fn carried(resolved: &EntryPlan, bits: u32) -> Result<(CarriedType, u32), &'static str> {
    let size = u32::try_from(resolved.shape.size()).unwrap_or(u32::MAX).saturating_mul(8);
    match resolved.shape {
        _ if bits == 0 => Err("it has no bits"),
        ValueShape::Word(data_type) => {
            let is_whole =
                !matches!(data_type.kind(), TypeKind::Boolean | TypeKind::Signed(_) | TypeKind::Unsigned(_));
            if is_whole && bits < size {
                return Err("a part of such a value has no meaning");
            }
            let own = if data_type.kind() == TypeKind::Boolean { 1 } else { size };
            Ok((CarriedType::Number(data_type), bits.min(own)))
        }
        ValueShape::Bytes(..) | ValueShape::Block(_) if !bits.is_multiple_of(8) => {
            Err("it ends within a byte")
        }
        ValueShape::Bytes(..) | ValueShape::Block(_) => {
            let bits = bits.min(size);
            if bits == 0 {
                Err("it has no room in the table")
            } else {
                Ok((CarriedType::Bytes(bits / 8), bits))
            }
        }
    }
}

/// The name of the field for the entry, with the array element as suffix; for a constant the names of object
/// and entry.
fn name_of(table: &DeviceTable, row: &Row) -> String {
    if let Some(slot) = row.slot {
        let field = &table.fields[slot.field].name;
        return match slot.element {
            Some(_) => format!("{field}_{:02x}", row.sub),
            None => field.clone(),
        };
    }
    table.words_of(row)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Options;
    use crate::model::{Access, Entry, Object, ObjectType, Value};

    /// A device with a TPDO that maps these objects, and entries 2000h to 2003h.
    fn device(mapped: &[u32]) -> Device {
        let mut device = Device::default();
        let entry = |name: &str, data_type, default| Entry {
            name: name.into(),
            data_type: Some(data_type),
            access: Some(Access::Rw),
            default,
            ..Entry::default()
        };
        let var = |main: Entry| Object { main, ..Object::default() };
        let record = |subs: Vec<(u8, Entry)>| {
            let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
            Object { main, subs: subs.into_iter().collect(), ..Object::default() }
        };
        device.objects.insert(0x2000, var(entry("Switch", DataType::BOOLEAN, None)));
        device.objects.insert(0x2001, var(entry("Speed", DataType::INTEGER16, None)));
        device.objects.insert(0x2002, var(entry("Gain", DataType::REAL32, None)));
        device.objects.insert(0x2003, var(entry("Label", DataType::VISIBLE_STRING, None)));
        let number = |number: u32| Some(Value::Unsigned(number.into()));
        let subs = mapped
            .iter()
            .zip(1..)
            .map(|(&object, sub)| (sub, entry("m", DataType::UNSIGNED32, number(object))));
        let count = entry("n", DataType::UNSIGNED8, number(u32::try_from(mapped.len()).unwrap()));
        device.objects.insert(0x1A00, record(std::iter::once((0, count)).chain(subs).collect()));
        let cob_id = entry("c", DataType::UNSIGNED32, Some(Value::NodeId(0x180)));
        device.objects.insert(0x1800, record(vec![(1, cob_id)]));
        device
    }

    fn frames_of(mapped: &[u32]) -> (Vec<PdoFrame>, Vec<Note>) {
        let device = device(mapped);
        let table = DeviceTable::new(&device, &Options::default()).unwrap();
        let mut notes = Vec::new();
        (frames(&device, &table, &mut notes), notes)
    }

    #[test]
    fn fields_follow_each_other_bit_by_bit() {
        let (frames, notes) = frames_of(&[0x2000_0001, 0x0005_0008, 0x2001_000C, 0x2002_0020]);
        assert_eq!(notes, []);
        let [frame] = frames.as_slice() else { panic!("{frames:?}") };
        assert_eq!(
            (frame.name.as_str(), frame.length, frame.cob_id.map(CobId::number)),
            ("tpdo1", 7, Some(0x180))
        );
        let places: Vec<_> =
            frame.fields.iter().map(|field| (&*field.name, field.first, field.bits)).collect();
        assert_eq!(places, [("switch_", 0, 1), ("speed", 9, 12), ("gain", 21, 32)]);
        assert!(frame.fields[1].is_signed());
    }

    #[test]
    fn what_is_no_field_is_noted() {
        let (frames, notes) = frames_of(&[0x2001_0010, 0x2002_0010, 0x2009_0008, 0x2003_0004]);
        assert_eq!(frames[0].fields.len(), 1);
        let notes: Vec<String> = notes.iter().map(Note::to_string).collect();
        assert_eq!(
            notes,
            [
                "0x1A00sub2: 2002h:00, 16 bits is not a field of TPDO 1: a part of such a value has no meaning",
                "0x1A00sub3: 2009h:00, 8 bits is not a field of TPDO 1: the entry does not exist",
                "0x1A00sub4: 2003h:00, 4 bits is not a field of TPDO 1: it ends within a byte",
            ]
        );
        let (frames, notes) = frames_of(&[0x2003_0040, 0x2001_0010]);
        assert!(frames.is_empty());
        assert_eq!(notes[0].message, "TPDO 1 maps 80 bits, but a frame has 64; it has no struct");
    }

    #[test]
    fn longer_mappings_carry_the_value_in_their_lowest_bits() {
        let (frames, _) = frames_of(&[0x2000_0008, 0x2001_0020]);
        let bits: Vec<_> = frames[0].fields.iter().map(|field| (field.first, field.bits)).collect();
        assert_eq!(bits, [(0, 1), (8, 16)]);
    }
}
