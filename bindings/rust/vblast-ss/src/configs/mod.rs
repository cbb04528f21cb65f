//! Configurations: each starts with the library's defaults, and a method for each field changes it. Fields that are pointers in C
//! are left out, but for the arrays of [`ThreadArrays`].
use std::mem::{size_of, MaybeUninit};

use crate::sys;

mod drain_config;
mod grasper_config;
mod needle_config;
mod scene_config;
mod session_config;
mod thread_attachment;
mod thread_config;

pub use drain_config::DrainConfig;
pub use grasper_config::GrasperConfig;
pub use needle_config::NeedleConfig;
pub use scene_config::SceneConfig;
pub use session_config::SessionConfig;
pub use thread_attachment::ThreadAttachment;
pub use thread_config::ThreadConfig;

fn defaults<T>(init: unsafe extern "C" fn(*mut T, u32) -> sys::vbss_result) -> T {
    let mut raw = MaybeUninit::<T>::zeroed();
    // The only failures are a null pointer and a size that the library does not know: a library of another version.
    let status = unsafe { init(raw.as_mut_ptr(), size_of::<T>() as u32) };
    assert_eq!(status, sys::VBSS_OK, "the library is not the one that this crate was made for");
    unsafe { raw.assume_init() }
}

/// Arrays that a [`ThreadConfig`] borrows.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ThreadArrays<'a> {
    pub(crate) positions: Option<&'a [[f64; 3]]>,
    pub(crate) rest_lengths: Option<&'a [f64]>,
}

impl<'a> ThreadConfig<'a> {
    /// Positions of the nodes, m. The number of segments becomes one less than their number.
    pub fn positions(mut self, positions: &'a [[f64; 3]]) -> Self {
        self.arrays.positions = Some(positions);
        self.raw.segment_count = positions.len().saturating_sub(1) as u32;
        self
    }

    /// Length of each segment without load, m. The number of segments becomes their number.
    pub fn rest_lengths(mut self, lengths: &'a [f64]) -> Self {
        self.arrays.rest_lengths = Some(lengths);
        self.raw.segment_count = lengths.len() as u32;
        self
    }

    /// The struct with its arrays; None if their sizes do not fit the number of segments.
    pub(crate) fn checked(&self) -> Option<sys::vbss_thread_config> {
        let (mut raw, count) = (self.raw, self.raw.segment_count as usize);
        if let Some(positions) = self.arrays.positions {
            raw.positions = positions.as_ptr().cast();
            if positions.len() != count + 1 {
                return None;
            }
        }
        if let Some(lengths) = self.arrays.rest_lengths {
            raw.rest_lengths = lengths.as_ptr();
            if lengths.len() != count {
                return None;
            }
        }
        Some(raw)
    }
}
