//! Any values of the parts.
