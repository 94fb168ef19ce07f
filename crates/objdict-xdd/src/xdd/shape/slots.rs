//! The values of an entry that an element may hold.

use crate::model::{Entry, Field, Value};

/// One of the values of an entry.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slots {
    Default,
    Actual,
    Low,
    High,
}

impl Slots {
    pub(crate) const fn field(self) -> Field {
        match self {
            Self::Default => Field::DefaultValue,
            Self::Actual => Field::ParameterValue,
            Self::Low => Field::LowLimit,
            Self::High => Field::HighLimit,
        }
    }

    pub(crate) fn get(self, entry: &Entry) -> Option<&Value> {
        match self {
            Self::Default => entry.default.as_ref(),
            Self::Actual => entry.configured_value(),
            Self::Low => entry.low_limit.as_ref(),
            Self::High => entry.high_limit.as_ref(),
        }
    }

    pub(crate) fn set(self, entry: &mut Entry, value: Value) {
        match self {
            Self::Default => entry.default = Some(value),
            Self::Actual => entry.configured_mut().value = Some(value),
            Self::Low => entry.low_limit = Some(value),
            Self::High => entry.high_limit = Some(value),
        }
    }
}
