//! The COB-ID of TIME, which the node does not serve (CiA 301 §7.2.6, §7.5.2.15).

use super::bench::Bench;
use super::{CheckStep, checks};

checks! { "TIME":
    "7.5.2.15" "1012h: bit 30 is rejected" |bench| refused(bench, 0x4000_0100);
    "7.5.2.15" "1012h: bit 31 is rejected" |bench| refused(bench, 0x8000_0100);
    "7.3.5" "1012h: a restricted CAN-ID in use is rejected" |bench| refused(bench, 0x8000_0601);
    "7.5.2.15" "1012h: a CAN-ID of 29 bits is rejected" |bench| refused(bench, 0x2000_0100);
}

fn refused(bench: &mut Bench<'_>, cob_id: u64) -> CheckStep {
    super::unserved::refused(bench, 0x1012, 0, cob_id)
}
