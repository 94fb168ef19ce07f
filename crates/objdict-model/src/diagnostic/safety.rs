//! How safe fixes are.

named! {
    /// Whether a fix may be applied without review.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
    pub enum Applicability {
        /// The meaning is unchanged for every tool, or only content that no tool could understand is removed.
        Safe = "safe",
        /// The most likely intention; needs review.
        Unsafe = "unsafe",
    }
}

named! {
    /// The safety of the fixes that the findings of a rule have.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
    pub enum FixSafety {
        /// All fixes are safe.
        Safe = "safe",
        /// All fixes need review.
        Unsafe = "unsafe",
        /// Some fixes are safe, others need review; each fix is marked.
        Mixed = "mixed",
    }
}

impl FixSafety {
    /// Whether a finding of the rule may have a fix of this safety.
    pub fn has(self, safety: Applicability) -> bool {
        match self {
            Self::Safe => safety == Applicability::Safe,
            Self::Unsafe => safety == Applicability::Unsafe,
            Self::Mixed => true,
        }
    }
}
