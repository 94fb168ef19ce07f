//! The judgement as a page.
