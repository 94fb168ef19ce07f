//! The rules about the model, one file each. A new rule is a file and a line here.

macro_rules! rules {
    ($($group:ident { $($rule:ident,)* })*) => {
        $(mod $group { $(pub(super) mod $rule;)* })*

        /// Every rule about the model.
        pub(crate) static RULES: &[&crate::lint::Rule] = &[$($(&$group::$rule::RULE,)*)*];
    };
}

rules! {
    cia301 {
        cob_id_collision,
        cob_id_not_predefined,
        default_sdo_cob_id,
        device_type_without_value,
        emergency_disabled,
        emergency_without_cob_id,
        fixed_node_id,
        granularity_against_access,
        half_valid_sdo,
        incomplete_node_guarding,
        incomplete_pdo_parameter,
        incomplete_sdo_parameter,
        inhibit_above_event_timer,
        invalid_cob_id,
        invalid_consumer_heartbeat,
        invalid_dummy_mapping,
        invalid_sync_counter,
        invalid_sync_start_value,
        mapped_communication_object,
        mapped_object_missing,
        mapped_object_not_mappable,
        mapping_beyond_count,
        mapping_granularity,
        mapping_of_count,
        missing_mandatory_object,
        missing_vendor_id,
        mixed_mapping_access,
        no_error_control,
        object_mapped_twice,
        obsolete_object,
        pdo_length_exceeded,
        pdo_valid_by_default,
        pdo_without_mapping,
        reserved_pdo_sub_index,
        reserved_transmission_type,
        restricted_can_id,
        rtr_pdo_without_rtr,
        sub_0_out_of_range,
        sync_object_without_sync,
        sync_producer_without_period,
        synchronous_pdo_without_sync,
        undefined_sub_index,
        valid_pdo_without_mapping,
        vendor_id_zero,
        wrong_access,
        wrong_data_type,
        wrong_mapping_count,
        wrong_mapping_direction,
        wrong_mapping_length,
        wrong_object_type,
    }
    cia306 {
        invalid_value,
        sub_without_object,
    }
}
