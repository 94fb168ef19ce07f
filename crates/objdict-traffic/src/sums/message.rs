//! What was seen of a CAN-ID, and PDOs that fall silent.

use super::cycle::Cycle;
use super::deviations::ExpectedFrames;
use super::{LastFrame, SECOND, SYNCS, milliseconds};
use crate::Bus;
use crate::log::LoggedFrame;
use objdict_document::describe::frames::{DecodedFrame, FrameKind};
use objdict_model::model::PdoKind;
use objdict_network::Service;

/// What was seen of a CAN-ID.
#[derive(Clone, Debug)]
pub(super) struct MessageSums {
    pub(super) can_id: u32,
    pub(super) is_extended: bool,
    pub(super) kind: FrameKind,
    pub(super) service: Option<Service>,
    /// Whether a description or the node itself gives the service this CAN-ID.
    pub(super) is_described: bool,
    pub(super) node_id: Option<u8>,
    pub(super) cycle: Cycle,
    pub(super) expected: ExpectedFrames,
    /// The data of the last PDO, and how often they were those of the one before.
    pub(super) data: u64,
    pub(super) repeats: u64,
    /// The distances since the PDO was silent.
    pub(super) steady: Cycle,
    /// The last frame of a PDO that may be silent from then on.
    pub(super) last: Option<LastFrame>,
}

impl MessageSums {
    /// Those of a CAN-ID whose first frame this is, without it.
    pub(super) fn new(decoded: &DecodedFrame, frame: &LoggedFrame) -> Self {
        let DecodedFrame { kind, service, node_id, .. } = *decoded;
        Self {
            can_id: frame.can_id,
            is_extended: frame.is_extended,
            kind,
            service,
            is_described: !decoded.is_predefined(),
            node_id,
            cycle: Cycle::default(),
            expected: ExpectedFrames::default(),
            data: 0,
            repeats: 0,
            steady: Cycle::default(),
            last: None,
        }
    }

    fn is_sent_pdo(&self) -> bool {
        matches!(self.service, Some(Service::Pdo(pdo)) if pdo.kind == PdoKind::Tpdo)
    }

    /// Whether it is a PDO that its node sends again and again. One that is sent on changes alone does not repeat its data.
    pub(super) fn is_cyclic(&self) -> bool {
        self.is_sent_pdo() && self.repeats >= SYNCS
    }

    /// What is said of a cyclic PDO that is silent until a time.
    pub(super) fn silence(&self, until: i64, bus: &Bus<'_>) -> Option<String> {
        let period = self.steady.regular(SYNCS).filter(|_| self.is_cyclic())?;
        let gap = until.saturating_sub(self.steady.last?);
        (gap > SECOND.max(period.saturating_mul(10))).then(|| {
            let [gap, period] = [gap, period].map(milliseconds);
            let (name, service) = (bus.reader.name(self.node_id.unwrap_or(0)), self.service);
            let service = service.map_or_else(String::new, |service| service.to_string());
            format!("{name} {service}: not sent for {gap} ms, before that every {period} ms")
        })
    }
}

/// The first eight bytes as a number.
pub(super) fn first_bytes(frame: &LoggedFrame) -> u64 {
    frame.data().iter().take(8).fold(frame.data().len() as u64, |number, byte| number << 8 | u64::from(*byte))
}
