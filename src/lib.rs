//! objdict
