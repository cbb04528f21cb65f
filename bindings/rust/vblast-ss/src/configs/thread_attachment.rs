// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use crate::sys;

/// An attachment acts on one node. Fill it with vbss_thread_attachment_init.
#[derive(Debug, Clone)]
pub struct ThreadAttachment {
    pub(crate) raw: sys::vbss_thread_attachment,
}

impl Default for ThreadAttachment {
    fn default() -> Self {
        ThreadAttachment { raw: defaults(sys::vbss_thread_attachment_init) }
    }
}

impl ThreadAttachment {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Kind; default VBSS_THREAD_ATTACHMENT_PIN.
    pub fn kind(mut self, value: sys::vbss_thread_attachment_kind) -> Self {
        self.raw.kind = value;
        self
    }

    /// Node, 0 to segment_count; default 0.
    pub fn node(mut self, value: u32) -> Self {
        self.raw.node = value;
        self
    }

    /// PIN, CLAMP: target of the node in the next step; SPRING: its fixed end; m, each coordinate
    /// at most 1e3 in magnitude.
    pub fn position(mut self, value: [f64; 3]) -> Self {
        self.raw.position = value;
        self
    }

    /// CLAMP: direction of the thread towards higher nodes, of any length from 1e-100 to 1e100;
    /// default (1, 0, 0). A thread with another direction turns there in the next step.
    pub fn direction(mut self, value: [f64; 3]) -> Self {
        self.raw.direction = value;
        self
    }

    /// FORCE: force, N, each component at most 1e6 in magnitude.
    pub fn force(mut self, value: [f64; 3]) -> Self {
        self.raw.force = value;
        self
    }

    /// SPRING: stiffness, N/m, 0 to 1e9.
    pub fn stiffness(mut self, value: f64) -> Self {
        self.raw.stiffness = value;
        self
    }

    /// SPRING: damping of the velocity relative to the moving end, N s/m, 0 to 1e6.
    pub fn damping(mut self, value: f64) -> Self {
        self.raw.damping = value;
        self
    }

    /// MASS: mass, kg, 0 to 1e3.
    pub fn mass(mut self, value: f64) -> Self {
        self.raw.mass = value;
        self
    }
}
