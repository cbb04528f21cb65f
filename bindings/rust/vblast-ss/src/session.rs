use std::ptr;

use crate::{sys, Context, Result, Scene, SessionConfig};

/// The suturing task on a scene, which it borrows. Devices, knot detector, metrics and records are objects of [`sys`].
#[derive(Debug)]
pub struct Session<'s, 'c> {
    scene: &'s mut Scene<'c>,
    raw: *mut sys::vbss_session,
}

impl<'s, 'c> Session<'s, 'c> {
    /// Creates a session. The configuration names the needle, the thread, the drain and both tools by their numbers.
    pub fn new(scene: &'s mut Scene<'c>, config: &SessionConfig) -> Result<Self> {
        let mut raw = ptr::null_mut();
        scene.context().check(unsafe { sys::vbss_session_create(scene.raw(), &config.raw, &mut raw) })?;
        Ok(Session { scene, raw })
    }

    fn context(&self) -> &'c Context {
        self.scene.context()
    }

    /// The handle, for functions of [`sys`].
    pub fn raw(&self) -> *mut sys::vbss_session {
        self.raw
    }

    /// The scene, to read from.
    pub fn scene(&self) -> &Scene<'c> {
        self.scene
    }

    /// The scene, to move its tools.
    pub fn scene_mut(&mut self) -> &mut Scene<'c> {
        self.scene
    }

    /// Makes one step of the task, of h seconds. `now` is the host's clock, s, for devices.
    pub fn step(&mut self, now: f64, h: f64) -> Result<()> {
        self.context().check(unsafe { sys::vbss_session_step(self.raw, now, h) })
    }

    /// Status of the task.
    pub fn status(&self) -> Result<sys::vbss_session_status> {
        self.context().fill(|out, size| unsafe { sys::vbss_session_get_status(self.raw, out, size) })
    }

    /// The coach's goal and the newest mistake; `coaching` of the configuration is 1.
    pub fn coaching(&self) -> Result<sys::vbss_session_coaching> {
        self.context().fill(|out, size| unsafe { sys::vbss_session_get_coaching(self.raw, out, size) })
    }

    /// An event by its ordinal: those from `first_event` to `event_count - 1` of the status are kept.
    pub fn event(&self, index: u64) -> Result<sys::vbss_session_event> {
        self.context().fill(|out, size| unsafe { sys::vbss_session_get_event(self.raw, index, out, size) })
    }

    /// Hash of the state; equal histories give equal hashes on every machine.
    pub fn hash(&self) -> Result<u64> {
        let mut hash = 0;
        self.context().check(unsafe { sys::vbss_session_get_hash(self.raw, &mut hash) })?;
        Ok(hash)
    }

    /// The state of the task, without that of the scene.
    pub fn save(&self) -> Result<Vec<u8>> {
        self.context().bytes(|bytes, capacity, written| unsafe { sys::vbss_session_save(self.raw, bytes, capacity, written) })
    }

    /// Restores a state of [`Session::save`], completely or not at all. Restore the scene first.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<()> {
        self.context().check(unsafe { sys::vbss_session_restore(self.raw, bytes.as_ptr(), bytes.len() as u64) })
    }
}

impl Drop for Session<'_, '_> {
    fn drop(&mut self) {
        unsafe { sys::vbss_session_destroy(self.raw) };
    }
}
