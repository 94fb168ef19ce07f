//! Where the values are in the array of bytes: behind the node-ID, as an SDO transfers them, those of a storage group
//! in a row.

use crate::resolve::ValueShape;
use crate::table::DeviceTable;
use crate::{GenerateError, Note};

/// Offsets in rows have 19 bits.
const LARGEST: usize = 1 << 19;

/// The places of all values.
pub(super) struct ValuePlaces {
    /// The offset of each row; 0 for a value in flash.
    pub(super) rows: Vec<usize>,
    /// The first offset of each storage group.
    pub(super) groups: Vec<usize>,
    /// Size of the array, with the node-ID.
    pub(super) total: usize,
}

impl ValuePlaces {
    pub(super) fn new(table: &DeviceTable) -> Result<Self, GenerateError> {
        let mut places = Self { rows: vec![0; table.rows.len()], groups: Vec::new(), total: 1 };
        places.put(table, None);
        for group in 0..table.groups.len() {
            places.groups.push(places.total);
            places.put(table, Some(group));
        }
        if places.total.max(table.rom.len()) > LARGEST {
            let text = format!("the tables are larger than {LARGEST} bytes");
            return Err(GenerateError::Inexpressible(vec![Note::new(crate::model::Place::device(), text)]));
        }
        Ok(places)
    }

    fn put(&mut self, table: &DeviceTable, group: Option<usize>) {
        for field in table.members(group) {
            for row in field.rows.clone() {
                self.rows[row] = self.total;
                self.total += value_size(field.shape);
            }
        }
    }
}

/// Size of a value in the array: a text is behind its length.
pub(super) fn value_size(shape: ValueShape) -> usize {
    crate::stored::image_length(shape)
}
