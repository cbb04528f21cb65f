use std::mem::{size_of, MaybeUninit};
use std::ptr;

use crate::error::owned;
use crate::{sys, Error, Result};

/// Version of the library: 10000 major + 100 minor + patch.
pub fn version() -> u32 {
    unsafe { sys::vbss_version() }
}

/// Version with its suffix, source revision, compiler and flags of the library.
pub fn build_info() -> String {
    unsafe { owned(sys::vbss_build_info()) }
}

/// The owner of all objects. Contexts are independent of each other. A context moves between threads of the host as long as it has
/// no objects, which borrow it.
#[derive(Debug)]
pub struct Context {
    raw: *mut sys::vbss_context,
}

// The library binds no context to the thread that created it; it needs calls one after another, which `!Sync` gives.
unsafe impl Send for Context {}

impl Context {
    /// A context with the C library's allocator and without a log.
    pub fn new() -> Result<Self> {
        // A later minor version has all that this crate uses.
        let made_for = sys::VBSS_VERSION_MAJOR * 10000 + sys::VBSS_VERSION_MINOR * 100;
        if version() / 10000 != sys::VBSS_VERSION_MAJOR || version() < made_for {
            return Err(Error::plain(sys::VBSS_ERROR_INCOMPATIBLE));
        }
        let mut raw = ptr::null_mut();
        match unsafe { sys::vbss_context_create(ptr::null(), &mut raw) } {
            sys::VBSS_OK => Ok(Context { raw }),
            status => Err(Error::plain(status)),
        }
    }

    /// The handle, for functions of [`sys`].
    pub fn raw(&self) -> *mut sys::vbss_context {
        self.raw
    }

    /// Memory and objects of the context.
    pub fn statistics(&self) -> Result<sys::vbss_context_statistics> {
        self.fill(|out, size| unsafe { sys::vbss_context_get_statistics(self.raw, out, size) })
    }

    /// A failure with the text that the context keeps of it.
    pub(crate) fn check(&self, status: sys::vbss_result) -> Result<()> {
        if status == sys::VBSS_OK {
            return Ok(());
        }
        let (mut last, mut text) = (sys::VBSS_OK, ptr::null());
        let known = unsafe { sys::vbss_context_get_last_error(self.raw, &mut last, &mut text) };
        if known == sys::VBSS_OK && last == status && !text.is_null() {
            return Err(Error::new(status, unsafe { owned(text) }));
        }
        Err(Error::plain(status))
    }

    /// A struct that a call fills.
    pub(crate) fn fill<T: Copy>(&self, call: impl FnOnce(*mut T, u32) -> sys::vbss_result) -> Result<T> {
        let mut value = MaybeUninit::<T>::zeroed();
        self.check(call(value.as_mut_ptr(), size_of::<T>() as u32))?;
        // Structs of the library have numbers and pointers only, for which zeros are values.
        Ok(unsafe { value.assume_init() })
    }

    /// The bytes that a call saves, which says their number when it has no room.
    pub(crate) fn bytes(&self, call: impl Fn(*mut u8, u64, *mut u64) -> sys::vbss_result) -> Result<Vec<u8>> {
        let mut size = 0;
        match call(ptr::null_mut(), 0, &mut size) {
            sys::VBSS_OK | sys::VBSS_ERROR_CAPACITY => {}
            status => self.check(status)?,
        }
        let mut bytes = vec![0; size as usize];
        self.check(call(bytes.as_mut_ptr(), size, &mut size))?;
        bytes.truncate(size as usize);
        Ok(bytes)
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        unsafe { sys::vbss_context_destroy(self.raw) };
    }
}
