//! CAN-IDs of PDOs, SYNC, EMCY and TIME, and node guarding.

use super::{CanId, Configurator, PdoName, Wrong};
use crate::model::{Address, CobId, PdoKind, predefined, restricted};

/// 1005h, COB-ID of SYNC. Bit 30: the node produces it.
const SYNC: Address = Address { index: 0x1005, sub: None };

/// 1006h, the period of SYNC in microseconds.
const SYNC_PERIOD: Address = Address { index: 0x1006, sub: None };

/// 1012h, COB-ID of TIME. Bit 31: the node consumes it; bit 30: the node produces it.
const TIME: Address = Address { index: 0x1012, sub: None };

/// 1014h, COB-ID of EMCY. Bit 31: the node does not send EMCY.
const EMCY: Address = Address { index: 0x1014, sub: None };

/// CAN-IDs that neither CiA 301 nor the predefined connection set of any node uses (§7.3.5).
const POOL: std::ops::RangeInclusive<u32> = 0x680..=0x6DF;

impl Configurator<'_> {
    /// Sets the CAN-ID of a PDO. Bit 30 of a TPDO (no RTR) is preserved.
    pub(super) fn cob_id(&mut self, pdo: PdoName, id: CanId) -> Result<(), Wrong> {
        let at = Address { index: self.communication_of(pdo)?, sub: Some(1) };
        let present = self.present(at);
        let kept = present.map_or(0, CobId::number) & CobId::BIT_30;
        let cob_id = match id {
            CanId::Off => present.unwrap_or(CobId::new(0)).disabled(),
            CanId::Auto => self.first_free(pdo, kept)?,
            id => numbered(id, kept)?,
        };
        if id != CanId::Off {
            self.free(at, cob_id)?;
        }
        self.put_cob_id(at, cob_id)
    }

    /// Sets up SYNC.
    pub(super) fn sync(
        &mut self,
        id: Option<CanId>,
        producer: Option<bool>,
        period: Option<&str>,
    ) -> Result<(), Wrong> {
        if let Some(period) = period {
            self.set_implied(SYNC_PERIOD, period)?;
        }
        if id.is_some() || producer.is_some() {
            self.service(SYNC, id, CobId::new(predefined::SYNC.into()), [producer, None])?;
        }
        if producer == Some(true) && self.device.object(SYNC_PERIOD.index).is_none() {
            return Err(self.no_object(SYNC_PERIOD.index));
        }
        let is_stopped = producer == Some(true) && self.number(SYNC_PERIOD.index, 0) == Some(0);
        if is_stopped {
            let wrong = Wrong::new("the node produces no SYNC while its period (1006h) is 0");
            return Err(wrong.help("add the period, as in `producer,33ms`"));
        }
        Ok(())
    }

    /// Sets the CAN-ID of EMCY.
    pub(super) fn emcy(&mut self, id: CanId) -> Result<(), Wrong> {
        let usual = predefined::per_node(predefined::EMCY);
        if id == CanId::Off {
            let present = self.present(EMCY).unwrap_or(usual);
            return self.put_cob_id(EMCY, present.disabled()).map_err(|wrong| wrong.about(EMCY));
        }
        self.service(EMCY, Some(id), usual, [None, Some(false)])
    }

    /// Sets up TIME.
    pub(super) fn time_stamp(
        &mut self,
        id: Option<CanId>,
        producer: Option<bool>,
        consumer: Option<bool>,
    ) -> Result<(), Wrong> {
        let (id, roles) = match id {
            Some(CanId::Off) => (None, [Some(false); 2]),
            id => (id, [producer, consumer]),
        };
        self.service(TIME, id, CobId::new(predefined::TIME.into()), roles)
    }

    /// Sets up node guarding.
    pub(super) fn guard(&mut self, milliseconds: u16, factor: u8) -> Result<(), Wrong> {
        self.set_implied(Address { index: 0x100C, sub: None }, &milliseconds.to_string())?;
        self.set_implied(Address { index: 0x100D, sub: None }, &factor.to_string())
    }

    /// Sets the COB-ID of a service whose CAN-ID is usually `usual`. `flags` are bits 30 and 31; `None` keeps a
    /// bit.
    fn service(
        &mut self,
        at: Address,
        id: Option<CanId>,
        usual: CobId,
        flags: [Option<bool>; 2],
    ) -> Result<(), Wrong> {
        let present = self.present(at).unwrap_or(usual);
        let mut kept = present.number() & (CobId::BIT_30 | CobId::BIT_31);
        for (bit, flag) in [CobId::BIT_30, CobId::BIT_31].into_iter().zip(flags) {
            kept = match flag {
                Some(true) => kept | bit,
                Some(false) => kept & !bit,
                None => kept,
            };
        }
        let can_id = |cob_id: CobId| cob_id.number() & (CobId::FRAME | 0x1FFF_FFFF);
        let cob_id = match id {
            Some(CanId::Auto) => flagged(usual, kept | can_id(usual)),
            Some(id) => Some(numbered(id, kept)?),
            None => flagged(present, kept | can_id(present)),
        };
        let cob_id = cob_id.ok_or_else(|| Wrong::new("the present COB-ID is not valid").about(at))?;
        self.free(at, cob_id)?;
        self.put_cob_id(at, cob_id).map_err(|wrong| wrong.about(at))
    }

    /// The COB-ID of an entry.
    fn present(&self, at: Address) -> Option<CobId> {
        self.value(at.index, at.sub.unwrap_or_default()).as_ref().and_then(CobId::from_value)
    }

    /// Sets a COB-ID. An entry that cannot be written may have the value already.
    fn put_cob_id(&mut self, at: Address, cob_id: CobId) -> Result<(), Wrong> {
        match self.writable(at) {
            Ok((sub, entry)) => self.put(at.index, sub, &entry, cob_id.to_value()),
            Err(_)
                if self
                    .present(at)
                    .is_some_and(|present| present.on_node(self.node_id) == cob_id.on_node(self.node_id)) =>
            {
                Ok(())
            }
            Err(wrong) => Err(wrong),
        }
    }

    /// The CAN-ID of the predefined connection set, otherwise the first one that CiA 301 does not assign.
    fn first_free(&self, pdo: PdoName, kept: u32) -> Result<CobId, Wrong> {
        let at = Address { index: self.communication_of(pdo)?, sub: Some(1) };
        let predefined =
            pdo.kind.predefined_can_id(pdo.number).and_then(|id| CobId::per_node(kept | u32::from(id)));
        let mut ids = predefined.into_iter().chain(POOL.map(|id| CobId::new(kept | id)));
        ids.find(|&id| self.free(at, id).is_ok())
            .ok_or_else(|| Wrong::new("no CAN-ID is free").help("write a CAN-ID"))
    }

    /// Rejects a CAN-ID that another service of the node uses or that is not allowed.
    fn free(&self, at: Address, cob_id: CobId) -> Result<(), Wrong> {
        let can_id = cob_id.can_id(self.node_id);
        if !cob_id.is_extended() && cob_id.stray_bits() != 0 {
            return Err(Wrong::new(format!("`{cob_id}` is above 7FFh, the highest 11-bit CAN-ID")));
        }
        if let Some(owner) = restricted(can_id).filter(|_| !cob_id.is_extended()) {
            return Err(Wrong::new(format!("the CAN-ID `0x{can_id:X}` is reserved: {owner}")));
        }
        let is_same = |other: CobId| {
            other.can_id(self.node_id) == can_id && other.is_extended() == cob_id.is_extended()
        };
        let Some(user) =
            self.users().find(|(user, other)| *user != at && is_same(*other)).map(|(user, _)| user)
        else {
            return Ok(());
        };
        let (name, help) = match PdoKind::of_communication(user.index) {
            Some((kind, number)) => {
                let pdo = PdoName { kind, number };
                let help = format!("disable it first with `--cob-id {pdo}=off`, or change its CAN-ID");
                (pdo.to_string(), help)
            }
            None => (service_name(user).to_owned(), "choose a different CAN-ID".to_owned()),
        };
        Err(Wrong::new(format!("{name} already has the CAN-ID `0x{can_id:X}`")).help(help))
    }

    /// The PDOs and services in use, with their COB-IDs.
    fn users(&self) -> impl Iterator<Item = (Address, CobId)> {
        let pdos = self.device.pdos().map(|pdo| Address { index: pdo.communication_index(), sub: Some(1) });
        let users = pdos.chain([SYNC, TIME, EMCY]).filter_map(|at| Some((at, self.present(at)?)));
        users.filter(|(at, cob_id)| match *at {
            SYNC => true,
            TIME => cob_id.number() & (CobId::BIT_30 | CobId::BIT_31) != 0,
            _ => cob_id.is_valid(),
        })
    }
}

/// The name of a service with one COB-ID.
const fn service_name(at: Address) -> &'static str {
    match at.index {
        0x1005 => "SYNC",
        0x1012 => "TIME",
        _ => "EMCY",
    }
}

/// A CAN-ID with flags.
fn numbered(id: CanId, flags: u32) -> Result<CobId, Wrong> {
    let too_large = || Wrong::new(format!("`{id}` is too large for a CAN-ID"));
    match id {
        CanId::Number(number) => Ok(CobId::new(flags | framed(number))),
        CanId::PerNode(number) => CobId::per_node(flags | framed(number)).ok_or_else(too_large),
        CanId::Off | CanId::Auto => Err(Wrong::new(format!("`{id}` is not possible here"))),
    }
}

/// A COB-ID with a different number.
fn flagged(cob_id: CobId, number: u32) -> Option<CobId> {
    if cob_id.depends_on_node_id() { CobId::per_node(number) } else { Some(CobId::new(number)) }
}

/// Sets bit 29 if the CAN-ID needs 29 bits.
fn framed(can_id: u32) -> u32 {
    if can_id > 0x7FF { can_id | CobId::FRAME } else { can_id }
}
