//! Answers as JSON.

use std::fmt::Display;

use objdict::format::ReadError;
use serde::Serialize;
use serde_json::json;

/// Why a request was refused.
#[derive(Debug, Serialize)]
pub(crate) struct BadRequest {
    /// The problem, as the command would print it.
    pub(crate) message: String,
    /// The advice.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) help: Option<String>,
}

impl BadRequest {
    pub(crate) fn new(message: impl Display) -> Self {
        Self { message: message.to_string(), help: None }
    }

    pub(crate) fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

impl From<ReadError> for BadRequest {
    fn from(error: ReadError) -> Self {
        Self { help: error.help(), ..Self::new(error) }
    }
}

/// What a request gives, as JSON.
pub(crate) type Answer = Result<String, BadRequest>;

/// Data as an answer. It is written at once: as a tree, a list of many objects takes longer than the check of them.
pub(crate) fn data(value: impl Serialize) -> Answer {
    serde_json::to_string(&value).map_err(BadRequest::new)
}

/// The text of an answer.
pub(crate) fn of(answer: Answer) -> String {
    match answer {
        Ok(value) => format!("{{\"ok\":{value}}}"),
        Err(refusal) => json!({ "error": refusal }).to_string(),
    }
}
