//! Addresses of buses.

use std::path::PathBuf;
use std::str::FromStr;

/// The bus that a command works on.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BusAddress {
    /// `socketcan:can0`: a network interface of Linux.
    SocketCan(String),
    /// `slcan:/dev/ttyACM0@500`: a serial adapter, with the bit rate in kbit/s.
    Slcan {
        /// The serial port.
        port: String,
        /// The bit rate in kbit/s; `None` for the one at which frames are heard (`@auto`).
        bit_rate: Option<u16>,
    },
    /// `candump:FILE`: a log, which is replayed. Nothing can be sent.
    Candump(PathBuf),
    /// `sim:network.toml`: simulated nodes.
    Simulated {
        /// The network with the nodes.
        network: PathBuf,
        /// `,memory=FILE`: a log of all frames that were sent, so that the next command finds the nodes as this one left them.
        memory: Option<PathBuf>,
        /// `,new=N`: nodes that come from the factory, without a node-ID.
        new: Vec<u8>,
    },
}

/// A text that is not the address of a bus.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoBusAddress {
    text: String,
    expected: &'static str,
}

objdict_model::error_messages! { NoBusAddress: { Self { text, expected } => "`{text}` is not the address of a bus: {expected}"; } }

const FORMS: &str = "write `socketcan:can0`, `slcan:/dev/ttyACM0@500`, `candump:FILE` or `sim:network.toml`";

/// The bit rates of SLCAN in kbit/s, by the digit of the command `S`.
pub(crate) const SLCAN_RATES: [u16; 9] = [10, 20, 50, 100, 125, 250, 500, 800, 1000];

impl FromStr for BusAddress {
    type Err = NoBusAddress;

    fn from_str(text: &str) -> Result<Self, NoBusAddress> {
        let wrong = |expected| NoBusAddress { text: text.to_owned(), expected };
        let (kind, rest) = text.split_once(':').filter(|(_, rest)| !rest.is_empty()).ok_or(wrong(FORMS))?;
        match kind {
            "socketcan" => Ok(Self::SocketCan(rest.to_owned())),
            "slcan" => {
                let (port, rate) =
                    rest.rsplit_once('@').ok_or(wrong("add the bit rate in kbit/s, as in `@500`"))?;
                let bit_rate = rate.parse().ok().filter(|rate| SLCAN_RATES.contains(rate));
                if bit_rate.is_none() && rate != "auto" {
                    return Err(wrong(
                        "the bit rate is 10, 20, 50, 100, 125, 250, 500, 800, 1000 kbit/s or `auto`",
                    ));
                }
                Ok(Self::Slcan { port: port.to_owned(), bit_rate })
            }
            "candump" => Ok(Self::Candump(rest.into())),
            "sim" => simulated(rest).ok_or(wrong("write `sim:network.toml`, `,memory=FILE` and `,new=NODE`")),
            _ => Err(wrong(FORMS)),
        }
    }
}

fn simulated(text: &str) -> Option<BusAddress> {
    let mut parts = text.split(',');
    let network = parts.next().filter(|path| !path.is_empty())?.into();
    let (mut memory, mut new) = (None, Vec::new());
    for part in parts {
        match part.split_once('=')? {
            ("memory", path) if !path.is_empty() => memory = Some(path.into()),
            ("new", node) => new.push(node.parse().ok().filter(|id| (1..=127).contains(id))?),
            _ => return None,
        }
    }
    Some(BusAddress::Simulated { network, memory, new })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_read() {
        let parsed = |text: &str| text.parse::<BusAddress>();
        assert_eq!(parsed("socketcan:can0"), Ok(BusAddress::SocketCan("can0".into())));
        for (text, bit_rate) in [("slcan:/dev/a@b@125", Some(125)), ("slcan:/dev/a@b@auto", None)] {
            assert_eq!(parsed(text), Ok(BusAddress::Slcan { port: "/dev/a@b".into(), bit_rate }));
        }
        let network =
            BusAddress::Simulated { network: "C:/n.toml".into(), memory: Some("m.log".into()), new: vec![5] };
        assert_eq!(parsed("sim:C:/n.toml,memory=m.log,new=5"), Ok(network));
        for wrong in
            ["can0", "slcan:/dev/ttyACM0", "slcan:COM3@300", "sim:", "sim:a,new=0", "sim:a,x", "udp:x"]
        {
            assert!(parsed(wrong).is_err(), "{wrong}");
        }
    }
}
