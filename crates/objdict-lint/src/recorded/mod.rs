//! The rules about recordings: what a device answered, and the traffic of a bus. What reads recordings raises them.

pub mod probe;
pub mod traffic;
