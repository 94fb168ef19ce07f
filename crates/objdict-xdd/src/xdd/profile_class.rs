//! The profiles of a container.

/// The subject of a profile (`ProfileClassID`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ProfileClass {
    /// The device.
    Device,
    /// The communication network.
    Network,
}

impl ProfileClass {
    /// Both classes.
    pub(crate) const ALL: [Self; 2] = [Self::Device, Self::Network];

    /// One of two values.
    pub(crate) const fn pick<T: Copy>(self, device: T, network: T) -> T {
        match self {
            Self::Device => device,
            Self::Network => network,
        }
    }

    /// `ProfileClassID`.
    pub(crate) const fn name(self) -> &'static str {
        self.pick("Device", "CommunicationNetwork")
    }

    /// `xsi:type` of the `ProfileBody`, without a prefix.
    pub(crate) const fn type_name(self) -> &'static str {
        self.pick("ProfileBody_Device_CANopen", "ProfileBody_CommunicationNetwork_CANopen")
    }
}
