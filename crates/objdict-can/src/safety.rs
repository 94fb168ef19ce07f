//! When a node must not be changed.

use objdict_model::model::Device;
use objdict_network::answered;

use crate::client::{BusClient, ClientError, unless_refused};

/// Why a node must not be configured now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Danger {
    /// It is operational.
    Operational,
    /// Its drive is enabled; the index of the statusword and its value.
    Enabled(u16, u16),
    /// It has safety-relevant objects (SRDO, EN 50325-5), which are configured by the tool of their vendor. Nothing overrides this.
    Safety,
}

objdict_model::messages! { Danger: {
    Self::Operational => "it is operational";
    Self::Enabled(index, word) => "its drive is enabled ({index:04X}h is {word:04X}h)";
    Self::Safety => "it has SRDOs, so it is part of a safety function";
} }

impl Danger {
    /// Whether a user who knows better may write nevertheless.
    pub const fn can_be_forced(self) -> bool {
        !matches!(self, Self::Safety)
    }
}

/// Whether a description has SRDOs. Such a device is not written.
pub fn has_srdos(device: &Device) -> bool {
    device.objects.keys().any(|index| matches!(index, 0x1301..=0x1340 | 0x13FE))
}

/// An entry of the identity with another value than the description has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(clippy::exhaustive_structs, reason = "an entry and its two values, which tests make too")]
pub struct OtherIdentity {
    /// The index.
    pub index: u16,
    /// The sub-index.
    pub sub: u8,
    /// The described value.
    pub expected: u32,
    /// The value that was read; `None` if the node does not let read it.
    pub found: Option<u32>,
}

objdict_model::messages! { OtherIdentity: {
    Self { index, sub, expected, found: None } =>
        "{index:04X}h sub-index {sub} is missing, expected {expected:X}h";
    Self { index, sub, expected, found: Some(found) } =>
        "{index:04X}h sub-index {sub} is {found:X}h, expected {expected:X}h";
} }

impl BusClient {
    /// Reads whether a node may be configured.
    ///
    /// # Errors
    /// When the node does not answer, another client interferes or the adapter is lost.
    pub fn dangers(&mut self, node_id: u8, device: &Device) -> Result<Vec<Danger>, ClientError> {
        let mut dangers = Vec::new();
        if self.states().get(&node_id) == Some(&Some(5)) {
            dangers.push(Danger::Operational);
        }
        if has_srdos(device) || unless_refused(self.upload(node_id, 0x13FE, 0))?.is_some() {
            dangers.push(Danger::Safety);
        }
        for axis in 0..8 {
            let index = 0x6041 + 0x800 * axis;
            // without a description the first axis is asked
            if !device.objects.contains_key(&index) && (axis > 0 || !device.objects.is_empty()) {
                continue;
            }
            let word = unless_refused(self.number(node_id, index, 0))?.map(|word| word as u16);
            // operation enabled, quick stop active: bit 2 without fault and without switch-on disabled
            dangers.extend(word.filter(|word| word & 0x4C == 4).map(|word| Danger::Enabled(index, word)));
        }
        Ok(dangers)
    }

    /// The first entry of the identity (device type, vendor-ID, product code) that differs from the description.
    ///
    /// # Errors
    /// As [`dangers`](Self::dangers).
    pub fn other_identity(
        &mut self,
        node_id: u8,
        device: &Device,
    ) -> Result<Option<OtherIdentity>, ClientError> {
        let number = |sub: u8| answered(device, sub, node_id);
        let device_type = device.value(0x1000, 0).and_then(|value| u32::try_from(value.as_integer()?).ok());
        let expected = [(0x1000, 0, device_type), (0x1018, 1, number(1)), (0x1018, 2, number(2))];
        for (index, sub, expected) in expected {
            let Some(expected) = expected.filter(|number| *number != 0) else { continue };
            let found = unless_refused(self.number(node_id, index, sub))?;
            let found = found.and_then(|number| u32::try_from(number).ok());
            if found != Some(expected) {
                return Ok(Some(OtherIdentity { index, sub, expected, found }));
            }
        }
        Ok(None)
    }
}
