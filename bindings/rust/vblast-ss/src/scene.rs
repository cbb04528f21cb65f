use std::mem::size_of;
use std::ptr;

use crate::{sys, Context, DrainConfig, GrasperConfig, NeedleConfig, Result, SceneConfig, Thread, ThreadMut, ThreadRef};

/// Bodies in contact, advanced together. The scene owns its bodies; each has a number.
#[derive(Debug)]
pub struct Scene<'c> {
    context: &'c Context,
    raw: *mut sys::vbss_scene,
}

impl<'c> Scene<'c> {
    /// Creates an empty scene.
    pub fn new(context: &'c Context, config: &SceneConfig) -> Result<Self> {
        let mut raw = ptr::null_mut();
        context.check(unsafe { sys::vbss_scene_create(context.raw(), &config.raw, &mut raw) })?;
        Ok(Scene { context, raw })
    }

    /// The handle, for functions of [`sys`].
    pub fn raw(&self) -> *mut sys::vbss_scene {
        self.raw
    }

    /// The context that the scene belongs to.
    pub fn context(&self) -> &'c Context {
        self.context
    }

    /// Gives a thread to the scene; its number. The thread of another context is refused. A refused thread is destroyed.
    pub fn add_thread(&mut self, thread: Thread<'_>) -> Result<u32> {
        let mut body = 0;
        self.context.check(unsafe { sys::vbss_scene_add_thread(self.raw, thread.raw(), &mut body) })?;
        Ok(body)
    }

    /// Adds a drain; its number.
    pub fn add_drain(&mut self, config: &DrainConfig) -> Result<u32> {
        self.add(
            |context, out| unsafe { sys::vbss_drain_create(context, &config.raw, out) },
            sys::vbss_scene_add_drain,
            sys::vbss_drain_discard,
        )
    }

    /// Adds a needle; its number.
    pub fn add_needle(&mut self, config: &NeedleConfig) -> Result<u32> {
        self.add(
            |context, out| unsafe { sys::vbss_needle_create(context, &config.raw, out) },
            sys::vbss_scene_add_needle,
            sys::vbss_needle_discard,
        )
    }

    /// Adds a grasper; its number.
    pub fn add_grasper(&mut self, config: &GrasperConfig) -> Result<u32> {
        self.add(
            |context, out| unsafe { sys::vbss_grasper_create(context, &config.raw, out) },
            sys::vbss_scene_add_grasper,
            sys::vbss_grasper_discard,
        )
    }

    /// Creates a body, adds it, and leaves it to the scene; if the scene refuses it, the body is destroyed.
    fn add<T>(
        &mut self,
        create: impl FnOnce(*mut sys::vbss_context, *mut *mut T) -> sys::vbss_result,
        add: unsafe extern "C" fn(*mut sys::vbss_scene, *mut T, *mut u32) -> sys::vbss_result,
        discard: unsafe extern "C" fn(*mut T) -> sys::vbss_result,
    ) -> Result<u32> {
        let (mut raw, mut body) = (ptr::null_mut(), 0);
        self.context.check(create(self.context.raw(), &mut raw))?;
        let added = self.context.check(unsafe { add(self.raw, raw, &mut body) });
        unsafe { discard(raw) };
        added.map(|()| body)
    }

    /// Removes a body, and destroys it.
    pub fn remove(&mut self, body: u32) -> Result<()> {
        self.context.check(unsafe { sys::vbss_scene_remove(self.raw, body) })
    }

    /// Cuts a thread in two at an arc length from its node 0, m; the number of the far part.
    pub fn cut_thread(&mut self, thread: u32, arc_length: f64) -> Result<u32> {
        let mut piece = 0;
        self.context.check(unsafe { sys::vbss_scene_cut_thread(self.raw, thread, arc_length, &mut piece) })?;
        let raw = self.handle_of_thread(piece)?;
        self.context.check(unsafe { sys::vbss_thread_discard(raw) })?;
        Ok(piece)
    }

    fn handle_of_thread(&self, body: u32) -> Result<*mut sys::vbss_thread> {
        let mut raw = ptr::null_mut();
        self.context.check(unsafe { sys::vbss_scene_get_thread(self.raw, body, &mut raw) })?;
        Ok(raw)
    }

    /// A thread of the scene, to read from.
    pub fn thread(&self, body: u32) -> Result<ThreadRef<'_>> {
        Ok(ThreadRef { context: self.context, raw: self.handle_of_thread(body)? })
    }

    /// A thread of the scene, to change.
    pub fn thread_mut(&mut self, body: u32) -> Result<ThreadMut<'_>> {
        Ok(ThreadMut { context: self.context, raw: self.handle_of_thread(body)?, only: Default::default() })
    }

    /// Target of a driven or coupled body for the end of the next step: position, m, and orientation (w, x, y, z).
    pub fn set_rigid_target(&mut self, body: u32, position: [f64; 3], orientation: Option<[f64; 4]>) -> Result<()> {
        let orientation = orientation.as_ref().map_or(ptr::null(), |orientation| orientation.as_ptr());
        self.context.check(unsafe { sys::vbss_scene_set_rigid_target(self.raw, body, position.as_ptr(), orientation) })
    }

    fn handle_of_grasper(&self, body: u32) -> Result<*mut sys::vbss_grasper> {
        let mut raw = ptr::null_mut();
        self.context.check(unsafe { sys::vbss_scene_get_grasper(self.raw, body, &mut raw) })?;
        Ok(raw)
    }

    /// Target of a grasper for the end of the next step: position of its tip, m, and orientation (w, x, y, z).
    pub fn set_grasper_target(&mut self, body: u32, position: [f64; 3], orientation: Option<[f64; 4]>) -> Result<()> {
        let orientation = orientation.as_ref().map_or(ptr::null(), |orientation| orientation.as_ptr());
        let raw = self.handle_of_grasper(body)?;
        self.context.check(unsafe { sys::vbss_grasper_set_target(raw, position.as_ptr(), orientation) })
    }

    /// Commanded opening of a grasper's jaws, 0 to 1.
    pub fn set_grasper_opening(&mut self, body: u32, opening: f64) -> Result<()> {
        let raw = self.handle_of_grasper(body)?;
        self.context.check(unsafe { sys::vbss_grasper_set_opening(raw, opening) })
    }

    /// State of a rigid body.
    pub fn rigid(&self, body: u32) -> Result<sys::vbss_scene_rigid_state> {
        self.context.fill(|out, size| unsafe { sys::vbss_scene_get_rigid(self.raw, body, out, size) })
    }

    /// Advances the scene by one step of h seconds.
    pub fn step(&mut self, h: f64) -> Result<()> {
        self.context.check(unsafe { sys::vbss_scene_step(self.raw, h) })
    }

    /// Takes the events since the last call, and the number of those that were lost.
    pub fn take_events(&mut self) -> Result<(Vec<sys::vbss_scene_event>, u64)> {
        let (size, mut count, mut lost) = (size_of::<sys::vbss_scene_event>() as u32, 0, 0);
        let take = |events, capacity, count: &mut u32, lost: &mut u64| unsafe {
            self.context.check(sys::vbss_scene_take_events(self.raw, events, size, capacity, count, lost))
        };
        take(ptr::null_mut(), 0, &mut count, &mut lost)?;
        let mut events = Vec::with_capacity(count as usize);
        if count > 0 {
            take(events.as_mut_ptr(), count, &mut count, &mut lost)?;
            unsafe { events.set_len(count as usize) };
        }
        Ok((events, lost))
    }

    /// Counters of the last step and since the beginning.
    pub fn statistics(&self) -> Result<sys::vbss_scene_statistics> {
        self.context.fill(|out, size| unsafe { sys::vbss_scene_get_statistics(self.raw, out, size) })
    }

    /// Hash of the state; equal states have equal hashes on every machine.
    pub fn hash(&self) -> Result<u64> {
        let mut hash = 0;
        self.context.check(unsafe { sys::vbss_scene_get_hash(self.raw, &mut hash) })?;
        Ok(hash)
    }

    /// The state.
    pub fn save(&self) -> Result<Vec<u8>> {
        self.context.bytes(|bytes, capacity, written| unsafe { sys::vbss_scene_save(self.raw, bytes, capacity, written) })
    }

    /// Restores a state of [`Scene::save`], completely or not at all.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<()> {
        self.context.check(unsafe { sys::vbss_scene_restore(self.raw, bytes.as_ptr(), bytes.len() as u64) })
    }
}

impl Drop for Scene<'_> {
    fn drop(&mut self) {
        unsafe { sys::vbss_scene_destroy(self.raw) };
    }
}
