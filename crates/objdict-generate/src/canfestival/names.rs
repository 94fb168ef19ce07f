//! Variable names as in objdictgen: words of letters, digits and `_`, joined by `_`.

use std::collections::HashSet;

use crate::c_words::is_reserved_at_file_scope;
use crate::dictionary::{ResolvedEntry, ResolvedObject};

/// Names are only cut beyond the maximum of the standard.
const LONGEST: usize = 240;

/// How macros, types and functions of the stack begin.
const BEGINS: &str = "
    BLOCK_ CAN CANFESTIVAL_ CO_ DCF_ DOWNLOAD_ EMCY_ INITIATE_ INT16 INT24 INT32 INT40 INT48 INT56 INT64 INTEGER LSS MSG NMT
    OD_ PDO REPEAT_ SDELAY_ SDO TIMER TRANS_ UNS16 UNS24 UNS32 UNS40 UNS48 UNS56 UNS64 UNS8 UPLOAD_ can lss_ post_ proceed
    readNetworkDict send sizeof_ valueRange writeNetworkDict
";

/// The other reserved words.
const WORDS: &str = "
    ABORT_TRANSFER_REQUEST Connecting CopyBits CreateReceiveTask DLL_CALL DelAlarm Disconnected ERROR_DATA_INITIALIZER
    EnterMutex Error_free Error_occurred FCT_PTR_INIT GET_FUNCTION_CODE GET_NODE_ID Initialisation LIBAPI LIBPUBLIC
    LIB_HANDLE LeaveMutex LoadCanDriver MAX_CAN_BUS_ID MAX_NB_TIMER MLSS_ADRESS MS_TO_TIMEVAL Message
    Message_Initializer NODE_GUARD NOT_A_REQUEST ODCallback_t Operational Pre_operational Preparing REAL32 REAL64
    REQUEST RO RW RegisterSetODentryCallBack Rx SLSS_ADRESS SYNC SetAlarm StartTimerLoop StopTimerLoop Stopped
    TASK_HANDLE TIMEVAL TIMEVAL_MAX TIME_STAMP TO_BE_SAVE TimeDispatch Tx UNIX_H_ US_TO_TIMEVAL UnLoadCanDriver
    Unknown_state WO WaitReceiveTaskEnd accessDictionaryError boolean buildPDO closeSDOtransfer domain e_errorState
    e_nodeState emergencyInit emergencyStop failedSDO getElapsedTime getNodeId getNodeState getODentry
    getReadResultNetworkDict getSDOfreeLine getSDOlineOnUse getSDOlineRestBytes getSDOlineToClose getState
    getWriteResultNetworkDict heartbeatInit heartbeatStop identity indextable initPreOperationalMode initSDOline int16
    int24 int32 int40 int48 int56 int64 int8 lifeGuardInit lifeGuardStop lineToSDO masterRequestNodeState
    masterSendNMTnodeguard masterSendNMTstateChange nodeGuardStatus_Initializer nodeguardInit nodeguardStop
    objdictToSDOline octet_string pdo_communication_parameter pdo_mapping quick_index readLocalDict real32 real64
    resetSDO resetSDOline s_BOARD s_PDO_status s_PDO_status_Initializer s_errors s_state_communication s_timer_entry
    s_transfer s_transfer_Initializer scanIndexOD sdo_parameter setNodeId setODentry setSDOlineRestBytes setState
    setTimer slaveSendBootUp startSYNC state1 state10 state11 state2 state3 state4 state5 state6 state7 state8 state9
    stopSYNC struct_CO_Data struct_s_PDO_status struct_s_transfer subindex td_indextable td_subindex enum_errorState
    enum_nodeState time_difference time_of_day uint16 uint24 uint32 uint40 uint48 uint56 uint64 uint8
    unicode_string visible_string writeLocalDict
    ConsumerHeartbeatAlarm GetSDOClientFromNodeId GuardTimeAlarm OnCOB_ID_SyncUpdate OnHeartbeatProducerUpdate
    OnNodeGuardUpdate OnNumberOfErrorsUpdate ProducerHeartbeatAlarm SaveNode SyncAlarm
    check_and_start_node get_next_DCF_data init_consise_dcf last_timer_raw start_and_seek_node start_node
    switchCommunicationState tdcount timers total_sleep_time
";

/// The names in use; names of the stack begin with the name of the node.
pub(super) struct ReservedNames<'a> {
    node: &'a str,
    /// Whether an application uses the names: then names that only might conflict with the stack are kept.
    in_use: bool,
    taken: HashSet<String>,
}

impl<'a> ReservedNames<'a> {
    pub(super) fn new(node: &'a str, in_use: bool) -> Self {
        Self { node, in_use, taken: HashSet::new() }
    }

    /// The name of the node.
    pub(super) fn node(&self) -> &'a str {
        self.node
    }

    /// The name of the variable of an entry, or of an array of them (`None`).
    pub(super) fn claim(&mut self, object: &ResolvedObject<'_>, entry: Option<&ResolvedEntry<'_>>) -> String {
        let index = object.index;
        let node = self.node;
        let of_object = format!("{node}_obj{index:04X}");
        let is_single = object.is_single();
        let mapped = (0x2000..0xC000).contains(&index);
        let sub = entry.filter(|_| !is_single);
        let plain = match sub {
            Some(entry) if entry.sub == 0 => format!("{node}_highestSubIndex_obj{index:04X}"),
            Some(entry) => {
                let parent = if mapped { words(&object.name) } else { of_object };
                format!("{parent}_{}", words(&entry.name))
            }
            None if mapped => words(&object.name),
            None => of_object,
        };
        let suffix = sub.map_or(format!("{index:04X}"), |entry| format!("{index:04X}_{:02X}", entry.sub));
        self.free(plain, mapped, &suffix)
    }

    fn free(&mut self, mut plain: String, mapped: bool, suffix: &str) -> String {
        plain.truncate(LONGEST); // ASCII
        if plain.starts_with(|c: char| c.is_ascii_digit()) {
            plain.insert(0, '_');
        }
        let is_taken = plain.trim_matches('_').is_empty() || (mapped && self.is_of_the_stack(&plain));
        let mut candidate = if is_taken { format!("{plain}_{suffix}") } else { plain.clone() };
        if candidate.starts_with('_') && is_taken {
            candidate.insert(0, 'x');
        }
        for number in 2_u32.. {
            if self.taken.insert(candidate.clone()) {
                break;
            }
            candidate = match number {
                2 => format!("{plain}_{suffix}"),
                _ => format!("{plain}_{suffix}_{number}"),
            };
        }
        candidate
    }

    fn is_of_the_stack(&self, name: &str) -> bool {
        let begins = |begin: &str| !self.in_use && name.strip_prefix(begin).is_some();
        let is_of_node = |node: &str| name.strip_prefix(node).is_some_and(|rest| rest.starts_with('_'));
        is_reserved_at_file_scope(name)
            || (!self.in_use && name.ends_with("_t"))
            || (!self.in_use && (is_of_node(self.node) || is_of_node(&self.node.to_ascii_uppercase())))
            || BEGINS.split_ascii_whitespace().any(begins)
            || WORDS.split_ascii_whitespace().any(|word| word == name)
    }
}

/// The words of a name, joined by `_`.
pub(super) fn words(name: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_objdictgen() {
        assert_eq!(words("COB-ID SYNC message"), "COB_ID_SYNC_message");
        let mut names = ReservedNames::new("Node", false);
        let mut free = |plain: &str| names.free(plain.to_owned(), true, "2000");
        assert_eq!(free("Setpoint"), "Setpoint");
        assert_eq!(free("Setpoint"), "Setpoint_2000");
        assert_eq!(free("2nd_axis"), "_2nd_axis");
        assert_eq!(free("time"), "time_2000");
        assert_eq!(free("Rx"), "Rx_2000");
        assert_eq!(free("SDO_x"), "SDO_x_2000");
        assert_eq!(free("Node_Data"), "Node_Data_2000");
        assert_eq!(free(""), "x_2000");
        let mut names = ReservedNames::new("Node", true);
        let mut free = |plain: &str| names.free(plain.to_owned(), true, "2000");
        assert_eq!(free("SDO_x"), "SDO_x");
        assert_eq!(free("Rx"), "Rx_2000");
    }
}
