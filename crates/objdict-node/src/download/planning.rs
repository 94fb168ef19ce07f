//! Plans the downloads of a node.

use super::order::{arrange, dcfgen};
use super::settings::WritableEntries;
use super::{ConciseDcf, Order, Plan, PlanError, PlanOptions, Scope};
use crate::model::{Device, Moment, Object};

impl ConciseDcf {
    /// Plans the downloads that configure a node as `device` describes.
    ///
    /// The node is assumed to have its default values. The target is the configured value, otherwise the default.
    /// Read-only entries, commands, and entries that reject a download are skipped; those with a configured value are
    /// listed in the plan. [`Device::downloads`] are performed as stated, before and after. Services are disabled using
    /// their present identifier, changed, and enabled again (CiA 301 §7.5.2).
    ///
    /// # Errors
    /// Lists every entry with an unknown value, a value outside its data type or limits, or a missing
    /// node-ID.
    pub fn plan(device: &Device, options: &PlanOptions) -> Result<Plan, PlanError> {
        if let Some(node_id) = options.node_id.filter(|node_id| !(1..=127).contains(node_id)) {
            return Err(PlanError::NodeId(node_id));
        }
        // application objects are written only if they have a configured value
        let is_needed = |(index, object): &(&u16, &Object)| {
            object.compact.as_ref().is_some_and(|compact| {
                let has_values = !compact.values.is_empty() || !compact.invalid_values.is_empty();
                **index < 0x2000 || options.scope == Scope::All || has_values
            })
        };
        let compact = device.objects.iter().filter(is_needed);
        let expanded = compact.map(|(&index, object)| (index, object.expanded().into_owned())).collect();
        let mut settings = WritableEntries::collect(device, &expanded, options);
        let mut steps = settings.explicit(Moment::Before);
        steps.extend(match options.order {
            Order::Safe => arrange(&mut settings),
            Order::Dcfgen => dcfgen::arrange(&mut settings),
        });
        steps.extend(settings.explicit(Moment::After));
        settings.finish(steps)
    }
}
