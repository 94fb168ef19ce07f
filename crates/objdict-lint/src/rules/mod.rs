//! The rules about the model, one file each: a new rule is a file and a line here. A rule that only adds a
//! page to a shared check is a row in `demands.rs` of its group.

use crate::Rule;

macro_rules! rules {
    ($($(#[$when:meta])? $group:ident $(: $demands:ident)? { $($rule:ident,)* })*) => {
        $(
            $(#[$when])?
            mod $group {
                $(pub(super) mod $demands;)?
                $(pub(super) mod $rule;)*

                pub(super) static RULES: &[&[&crate::Rule]] = &[$($demands::RULES,)? &[$(&$rule::RULE,)*]];
            }
        )*

        /// The groups by their names.
        static RULES: &[(&str, &[&[&Rule]])] = &[$($(#[$when])? (stringify!($group), $group::RULES),)*];
    };
}

pub use self::cia306::disabled_object::without_disabled;
pub(crate) use self::configuration::other_device::is_same as is_same_product;

/// Every rule about the model.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    rules_of(|_| true)
}

/// The rules of some groups.
pub(crate) fn rules_of(is_meant: impl Fn(&str) -> bool) -> impl Iterator<Item = &'static Rule> {
    let groups = RULES.iter().filter(move |(group, _)| is_meant(group));
    groups.flat_map(|(_, rules)| rules.iter().copied().flatten().copied())
}

rules! {
    cia301: demands {
        can_id_in_both_directions,
        can_id_of_other_service,
        cob_id_collision,
        cob_id_not_predefined,
        default_error_register,
        default_sdo_cob_id,
        default_sdo_node_id,
        device_type_without_value,
        emergency_consumer_of_other_node,
        emergency_disabled,
        emergency_without_cob_id,
        fixed_node_id,
        gap_in_mapping,
        gap_in_sdo_numbers,
        granularity_against_access,
        heartbeat_beside_guarding,
        heartbeat_switched_off,
        incomplete_eds_storage,
        incomplete_life_guarding,
        incomplete_node_guarding,
        incomplete_pdo_parameter,
        incomplete_sdo_parameter,
        inhibit_above_event_timer,
        invalid_cob_id,
        invalid_configuration_date,
        invalid_consumer_heartbeat,
        invalid_device_type,
        invalid_dummy_mapping,
        invalid_error_behavior,
        invalid_sync_counter,
        invalid_sync_start_value,
        listed_entry_missing,
        mappable_without_pdo,
        mapped_object_missing,
        mapped_object_not_mappable,
        mapping_beyond_count,
        mapping_granularity,
        mapping_of_count,
        mapping_of_variable_length,
        mapping_without_count,
        mapping_without_valid_bit,
        missing_mandatory_object,
        missing_module_list,
        missing_vendor_id,
        mixed_mapping_access,
        module_list_without_modules,
        multiplexed_pdo_transmission_type,
        multiplexed_pdo_without_list,
        no_error_control,
        object_mapped_twice,
        obsolete_object,
        partly_valid_sdo,
        pdo_length_exceeded,
        pdo_parameter_without_value,
        pdo_valid_by_default,
        pdo_without_mapping,
        reserved_pdo_sub_index,
        reserved_transmission_type,
        restricted_can_id,
        rtr_only_pdo,
        rtr_pdo_without_rtr,
        sdo_cob_ids_exchanged,
        sdo_node_id,
        sdo_valid_by_default,
        service_cob_id_not_predefined,
        short_can_id_in_extended_frame,
        storage_signature_as_default,
        storage_without_function,
        store_without_restore,
        sync_object_without_sync,
        sync_producer_without_period,
        sync_window_above_period,
        synchronous_pdo_without_sync,
        time_producer_and_consumer,
        timer_without_effect,
        tpdo_of_other_node,
        unaligned_mapping,
        valid_pdo_without_mapping,
        vendor_id_zero,
        wrong_mapping_count,
        wrong_mapping_direction,
        wrong_mapping_length,
    }
    #[cfg(feature = "catalogue")]
    cia302: demands {
        contradictory_startup,
        flying_master_time_slots,
        incomplete_guarding,
        manager_not_marked,
        master_without_slaves,
        self_starting_not_marked,
        slave_not_assigned,
    }
    #[cfg(feature = "catalogue")]
    cia304 {
        checksum_missing,
        cob_id_collision,
        incomplete_srdo_parameter,
        invalid_cob_id_pair,
        invalid_direction,
        invalid_inverted_object,
        invalid_time,
        mapped_object_missing,
        missing_safety_object,
        object_not_safe,
        safety_flag,
        srdo_length_exceeded,
        srdo_without_mapping,
        unequal_pair,
        wrong_checksum,
        wrong_mapping_count,
        wrong_mapping_length,
        wrong_transmission_type,
    }
    #[cfg(feature = "catalogue")]
    cia305 {
        incomplete_address,
        serial_number_in_eds,
        serial_number_without_lss,
        unconfigured_without_address,
        unconfigured_without_lss,
    }
    cia306 {
        access_without_mapping,
        array_of_mixed_access,
        array_of_mixed_types,
        boot_up_master_without_startup,
        command_without_flag,
        compact_and_sub_number,
        configuration_in_eds,
        contradictory_sub_0,
        described_network_variable,
        described_standard_type,
        disabled_object,
        domain_mismatch,
        dummy_below_granularity,
        dummy_type,
        duplicate_name,
        dynamic_channels_flag,
        eds_version,
        fixed_by_limits,
        formula_out_of_range,
        gap_in_array,
        group_messaging_flag,
        identity_mismatch,
        implausible_date,
        invalid_baud_rate,
        invalid_extension_limit,
        invalid_node_id,
        invalid_object_flags,
        invalid_segment,
        invalid_value,
        limits_on_text,
        link_to_missing_object,
        listed_object_missing,
        low_limit_above_high,
        lss_serial_number,
        lss_without_identity,
        manager_without_nmt_master,
        mapping_not_possible,
        misplaced_file,
        missing_commissioning,
        missing_constant,
        missing_device_info_key,
        missing_file_info_key,
        missing_key,
        missing_last_eds,
        missing_module_info,
        missing_module_object,
        missing_name,
        missing_node_name,
        missing_obj_extend,
        missing_section,
        missing_sub_0,
        modified_before_created,
        module_conflict,
        module_list_mismatch,
        module_numbering,
        module_overlap,
        module_without_objects,
        nested_structure,
        no_baud_rate,
        null_object,
        object_listed_twice,
        object_not_listed,
        object_without_entries,
        read_only_value,
        repeated_link,
        reserved_index,
        reserved_key,
        single_limit,
        sub_0_type,
        sub_number_mismatch,
        sub_of_var,
        sub_without_object,
        undefined_data_type,
        unknown_connected_module,
        unsorted_list,
        unsupported_key,
        value_of_no_download,
        value_outside_limits,
        write_only_default,
        wrong_compact_pdo,
        wrong_highest_sub_index,
        wrong_object_list,
        wrong_pdo_count,
        wrong_structure_entry,
    }
    #[cfg(feature = "catalogue")]
    cia311 {
        unfitting_type,
        value_without_name,
    }
    #[cfg(feature = "catalogue")]
    cia401: demands {
        analogue_events_off,
        channels_not_in_device_type,
        channels_without_pdo,
        device_type_without_channels,
        digital_events_off,
        error_mode_without_value,
        interrupt_limits_crossed,
        wrong_default_mapping,
        wrong_transmission_type,
        zero_scaling,
    }
    #[cfg(feature = "catalogue")]
    cia402: demands {
        axis_without_device_type,
        controlword_not_mappable,
        controlword_not_mapped,
        cyclic_mode_without_sync,
        cyclic_target_not_mappable,
        device_type_without_drive,
        different_device_type,
        enabled_by_default,
        homing_method_not_supported,
        incomplete_touch_probe,
        interpolation_time_differs,
        interpolation_without_data,
        limit_min_above_max,
        limit_outside_range,
        mode_not_stated,
        mode_without_display,
        no_drive_mode,
        no_mode_selection,
        no_supported_modes,
        notation_without_dimension,
        reserved_drive_mode,
        set_point_above_limit,
        target_outside_limits,
        target_without_actual_value,
        time_without_window,
        unsupported_mode,
        value_beyond_support,
        zero_factor,
        zero_speed,
    }
    #[cfg(feature = "catalogue")]
    cia404: demands {
        incomplete_scaling,
        limit_min_above_max,
    }
    #[cfg(feature = "catalogue")]
    cia406: demands {
        cam_without_limits,
        contradictory_copy,
        cyclic_timer_mismatch,
        different_measuring_range,
        incomplete_class_2,
        limit_min_above_max,
        position_too_long,
        preset_outside_range,
        revolutions_of_single_turn,
        scaling_off,
        unsupported_alarm,
        value_beyond_resolution,
        wrong_default_mapping,
        wrong_transmission_type,
        zero_resolution,
    }
    #[cfg(feature = "catalogue")]
    custom: demands {}
    #[cfg(feature = "catalogue")]
    naming {
        duplicate_denotation,
        duplicate_module,
        duplicate_object_name,
        long_name,
        name_of_other_object,
        placeholder,
        repeated_blanks,
        same_identifier,
        type_in_name,
        unordered_numbering,
        wrong_pdo_direction,
    }
    #[cfg(feature = "catalogue")]
    portability {
        auto_baud_rate,
        compact_denotations,
        compact_names,
        compact_parameter_value,
        compact_storage,
        compact_values,
        denotation,
        domain_without_type,
        dynamic_channels,
        empty_text,
        file_reference,
        implicit_pdo,
        long_value,
        mapped_bits,
        mapping_of_structure,
        modules,
        no_error_history,
        object_flags,
        object_links,
        parameter_reference,
        safety_key,
        service_count,
        service_gap,
        service_object_missing,
        sub_index_255,
        time_value,
        tool_list,
        type_definition,
        unclear_direction,
        unused_mapping_slot,
    }
    configuration {
        different_access,
        different_default,
        different_limits,
        different_type,
        other_device,
        other_revision,
        unknown_entry,
        value_outside_limits,
    }
}
