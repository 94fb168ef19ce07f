//! What a node is set to now.

use objdict_bus::Abort;
use objdict_model::model::Device;
use objdict_node::parameter::{NoParameter, is_saved, no_parameter};

use crate::client::{BusClient, ClientError, unless_refused};

/// The values of a node, by index and sub-index.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SavedValues {
    /// The values as they were transferred.
    pub values: Vec<((u16, u8), Vec<u8>)>,
    /// The entries that are no parameters, which were not read.
    pub left_out: Vec<((u16, u8), NoParameter)>,
    /// The entries that the node does not let read.
    pub refused: Vec<((u16, u8), Abort)>,
}

/// Indexes and sub-indexes.
type EntryPlaces = Vec<(u16, u8)>;

impl BusClient {
    /// Reads every parameter that a description lets be read and written.
    ///
    /// # Errors
    /// When the node does not answer, another client interferes, the user interrupts or the adapter is lost.
    pub fn save(&mut self, node_id: u8, device: &Device) -> Result<SavedValues, ClientError> {
        let mut saved = SavedValues::default();
        for (&index, object) in device.objects.range(0x1000..) {
            for (sub, _) in object.entries().filter(|(_, entry)| is_saved(entry)) {
                if let Some(reason) = no_parameter(device, index, sub) {
                    saved.left_out.push(((index, sub), reason));
                    continue;
                }
                match self.upload(node_id, index, sub) {
                    Ok(bytes) => saved.values.push(((index, sub), bytes)),
                    Err(ClientError::Refused { abort, .. }) => saved.refused.push(((index, sub), abort)),
                    Err(error) => return Err(error),
                }
            }
        }
        Ok(saved)
    }

    /// Writes saved values that a node no longer has, for example because a reset cleared them. Returns the written entries, and the
    /// entries that do not take their value.
    ///
    /// # Errors
    /// As [`save`](Self::save).
    pub fn put_back(
        &mut self,
        node_id: u8,
        saved: &SavedValues,
    ) -> Result<(EntryPlaces, EntryPlaces), ClientError> {
        let (mut written, mut lost) = (Vec::new(), Vec::new());
        for ((index, sub), bytes) in &saved.values {
            if unless_refused(self.upload(node_id, *index, *sub))?.as_ref() == Some(bytes) {
                continue;
            }
            let is_written = unless_refused(self.download(node_id, *index, *sub, bytes))?.is_some()
                && unless_refused(self.upload(node_id, *index, *sub))?.as_ref() == Some(bytes);
            if is_written { &mut written } else { &mut lost }.push((*index, *sub));
        }
        Ok((written, lost))
    }
}
