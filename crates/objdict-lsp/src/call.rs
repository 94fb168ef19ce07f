//! A request, and the one answer that it gets.

use lsp_server::{ErrorCode, Request, Response};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A request that is answered by the first handler of its method.
pub(super) struct Call {
    request: Option<Request>,
    response: Option<Response>,
}

impl Call {
    pub(super) fn new(request: Request) -> Self {
        Self { request: Some(request), response: None }
    }

    /// Answers the request if it is of this method.
    pub(super) fn on<P: DeserializeOwned, R: Serialize>(
        self,
        method: &str,
        answer: impl FnOnce(P) -> R,
    ) -> Self {
        self.try_on(method, |params| Ok(answer(params)))
    }

    /// The same where the answer may be an error, in words for the user.
    pub(super) fn try_on<P: DeserializeOwned, R: Serialize>(
        mut self,
        method: &str,
        answer: impl FnOnce(P) -> Result<R, String>,
    ) -> Self {
        if let Some(request) = self.request.take_if(|request| request.method == method) {
            let (id, failed) = (request.id, |id, code, text| Response::new_err(id, code as i32, text));
            self.response = Some(match serde_json::from_value(request.params).map(answer) {
                Ok(Ok(result)) => Response::new_ok(id, result),
                Ok(Err(reason)) => failed(id, ErrorCode::RequestFailed, reason),
                Err(error) => failed(id, ErrorCode::InvalidParams, error.to_string()),
            });
        }
        self
    }

    /// The answer; an error for a method that nothing handles.
    pub(super) fn answer(self) -> Option<Response> {
        self.response.or_else(|| {
            let request = self.request?;
            let message = format!("`{}` is not supported", request.method);
            Some(Response::new_err(request.id, ErrorCode::MethodNotFound as i32, message))
        })
    }
}
