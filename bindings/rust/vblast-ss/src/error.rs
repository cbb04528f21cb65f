use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;

use crate::sys;

/// A failure of a call of the library.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    status: sys::vbss_result,
    text: String,
}

/// What functions return that can fail.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    pub(crate) fn new(status: sys::vbss_result, text: String) -> Self {
        Error { status, text }
    }

    /// The status without a text of a context.
    pub(crate) fn plain(status: sys::vbss_result) -> Self {
        Error::new(status, unsafe { owned(sys::vbss_result_string(status)) })
    }

    /// The status, such as `sys::VBSS_ERROR_OUT_OF_RANGE`.
    pub fn status(&self) -> sys::vbss_result {
        self.status
    }

    /// The name of the status, such as "VBSS_ERROR_OUT_OF_RANGE".
    pub fn name(&self) -> String {
        unsafe { owned(sys::vbss_result_name(self.status)) }
    }

    /// What the library says about the failure.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.name(), self.text)
    }
}

impl std::error::Error for Error {}

/// A copy of a text of the library.
///
/// # Safety
/// The text ends with a zero.
pub(crate) unsafe fn owned(text: *const c_char) -> String {
    CStr::from_ptr(text).to_string_lossy().into_owned()
}
