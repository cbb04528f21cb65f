use std::mem::size_of;
use std::slice;

use crate::{sys, Context, Error, Result};

/// Values of the library that a slice may have.
pub(crate) trait Item: Copy {
    const TYPE: sys::vbss_view_type;
    const COMPONENTS: u32;
}

impl Item for f64 {
    const TYPE: sys::vbss_view_type = sys::VBSS_VIEW_TYPE_F64;
    const COMPONENTS: u32 = 1;
}

impl Item for [f64; 3] {
    const TYPE: sys::vbss_view_type = sys::VBSS_VIEW_TYPE_F64;
    const COMPONENTS: u32 = 3;
}

/// An array of the library.
///
/// # Safety
/// `call` fills the view of an object that neither a step nor an edit changes while the context is borrowed.
pub(crate) unsafe fn items<T: Item>(
    context: &Context,
    call: impl FnOnce(*mut sys::vbss_view, u32) -> sys::vbss_result,
) -> Result<&[T]> {
    let view = context.fill(call)?;
    if view.r#type != T::TYPE || view.components != T::COMPONENTS || view.stride_bytes as usize != size_of::<T>() {
        return Err(Error::plain(sys::VBSS_ERROR_INCOMPATIBLE));
    }
    Ok(slice::from_raw_parts(view.data.cast(), view.count as usize))
}
