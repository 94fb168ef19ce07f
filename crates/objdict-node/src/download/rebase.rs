//! A configuration relative to the defaults of another description.

use crate::model::{Device, Entry};

impl super::ConciseDcf {
    /// Returns `device` with the default values of `base`. A value of `device`, configured or default, that
    /// differs from the default in `base` becomes a configured value. So a plan starts from the defaults of
    /// the EDS, even if a tool changed them in the DCF. Entries missing in `base` are unchanged.
    pub fn rebased(device: &Device, base: &Device) -> Device {
        let mut rebased = device.expanded().into_owned();
        for (&index, object) in rebased.objects.iter_mut() {
            if !object.object_type().has_subs() {
                if let Some(entry) = base.entry(index, 0) {
                    rebase(&mut object.main, &entry);
                }
                continue;
            }
            for (sub, entry) in object.subs.iter_mut() {
                if let Some(of_base) = base.entry(index, sub) {
                    rebase(entry, &of_base);
                }
            }
        }
        rebased
    }
}

fn rebase(entry: &mut Entry, base: &Entry) {
    let wanted = entry.value().cloned();
    entry.default.clone_from(&base.default);
    if let Some(wanted) = wanted.filter(|wanted| Some(wanted) != base.default.as_ref()) {
        entry.configured_mut().value = Some(wanted);
    }
}

#[cfg(test)]
mod tests {
    use crate::download::{ConciseDcf, Download, PlanOptions};
    use crate::model::{Access, DataType, Device, Entry, Object, Value};

    #[test]
    fn a_default_that_a_tool_changed_is_configured() {
        let device = |default| {
            let main = Entry {
                data_type: Some(DataType::UNSIGNED16),
                access: Some(Access::Rw),
                default: Some(Value::Unsigned(default)),
                ..Entry::default()
            };
            let mut device = Device::default();
            device.objects.insert(0x1017, Object { main, ..Object::default() });
            device
        };
        let rebased = ConciseDcf::rebased(&device(250), &device(0));
        let plan = ConciseDcf::plan(&rebased, &PlanOptions::default()).unwrap();
        let stream = plan.into_concise(|_| Err(())).unwrap();
        assert_eq!(stream.0, [Download::new(0x1017, 0, [250, 0])]);
        let same = ConciseDcf::rebased(&device(0), &device(0));
        assert!(ConciseDcf::plan(&same, &PlanOptions::default()).unwrap().steps.is_empty());
    }
}
