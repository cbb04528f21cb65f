use std::ptr;

use crate::view::{items, Item};
use crate::{sys, Context, Error, Result, ThreadAttachment, ThreadConfig};

/// A thread that belongs to no scene.
#[derive(Debug)]
pub struct Thread<'c> {
    context: &'c Context,
    raw: *mut sys::vbss_thread,
}

/// A thread to read from.
#[derive(Debug, Clone, Copy)]
pub struct ThreadRef<'a> {
    pub(crate) context: &'a Context,
    pub(crate) raw: *mut sys::vbss_thread,
}

/// A thread to change.
#[derive(Debug)]
pub struct ThreadMut<'a> {
    pub(crate) context: &'a Context,
    pub(crate) raw: *mut sys::vbss_thread,
    pub(crate) only: std::marker::PhantomData<&'a mut ()>,
}

impl<'c> Thread<'c> {
    /// Creates a thread.
    pub fn new(context: &'c Context, config: &ThreadConfig<'_>) -> Result<Self> {
        let filled = config.checked().ok_or_else(|| Error::plain(sys::VBSS_ERROR_OUT_OF_RANGE))?;
        let mut raw = ptr::null_mut();
        context.check(unsafe { sys::vbss_thread_create(context.raw(), &filled, &mut raw) })?;
        Ok(Thread { context, raw })
    }

    /// The handle, for functions of [`sys`].
    pub fn raw(&self) -> *mut sys::vbss_thread {
        self.raw
    }

    /// The context that the thread belongs to.
    pub fn context(&self) -> &'c Context {
        self.context
    }

    /// Advances the thread by one step of h seconds.
    pub fn step(&mut self, h: f64) -> Result<()> {
        self.context.check(unsafe { sys::vbss_thread_step(self.raw, h) })
    }

    /// Cuts the thread in two at an arc length from node 0, m; the far part.
    pub fn cut(&mut self, arc_length: f64) -> Result<Thread<'c>> {
        let mut raw = ptr::null_mut();
        self.context.check(unsafe { sys::vbss_thread_cut(self.raw, arc_length, &mut raw) })?;
        Ok(Thread { context: self.context, raw })
    }

    /// Restores a state of [`ThreadRef::save`], completely or not at all.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<()> {
        self.context.check(unsafe { sys::vbss_thread_restore(self.raw, bytes.as_ptr(), bytes.len() as u64) })
    }

    /// The thread, to read from.
    pub fn read(&self) -> ThreadRef<'_> {
        ThreadRef { context: self.context, raw: self.raw }
    }

    /// The thread, to change.
    pub fn edit(&mut self) -> ThreadMut<'_> {
        ThreadMut { context: self.context, raw: self.raw, only: Default::default() }
    }

    /// Positions of the nodes, m.
    pub fn positions(&self) -> Result<&[[f64; 3]]> {
        self.read().positions()
    }
}

impl Drop for Thread<'_> {
    fn drop(&mut self) {
        // In a scene the thread lives on until it is removed or the scene ends.
        unsafe { sys::vbss_thread_discard(self.raw) };
    }
}

impl<'a> ThreadRef<'a> {
    fn array<T: Item>(self, field: sys::vbss_thread_field) -> Result<&'a [T]> {
        // The borrow of the thread's owner, which steps and edits need for themselves, lasts as long as the slice.
        unsafe { items(self.context, |view, size| sys::vbss_thread_get_view(self.raw, field, view, size)) }
    }

    /// Positions of the nodes, m.
    pub fn positions(self) -> Result<&'a [[f64; 3]]> {
        self.array(sys::VBSS_THREAD_VIEW_POSITIONS)
    }

    /// Velocities of the nodes, m/s.
    pub fn velocities(self) -> Result<&'a [[f64; 3]]> {
        self.array(sys::VBSS_THREAD_VIEW_VELOCITIES)
    }

    /// Force along each segment at the end of the last step, N.
    pub fn tensions(self) -> Result<&'a [f64]> {
        self.array(sys::VBSS_THREAD_VIEW_TENSIONS)
    }

    /// Energies at the end of the last step.
    pub fn energies(self) -> Result<sys::vbss_thread_energies> {
        self.context.fill(|out, size| unsafe { sys::vbss_thread_get_energies(self.raw, out, size) })
    }

    /// Reaction of an attachment in the last step.
    pub fn reaction(self, id: u32) -> Result<sys::vbss_thread_reaction> {
        self.context.fill(|out, size| unsafe { sys::vbss_thread_get_reaction(self.raw, id, out, size) })
    }

    /// Hash of the state; equal states have equal hashes on every machine.
    pub fn hash(self) -> Result<u64> {
        let mut hash = 0;
        self.context.check(unsafe { sys::vbss_thread_get_hash(self.raw, &mut hash) })?;
        Ok(hash)
    }

    /// The state.
    pub fn save(self) -> Result<Vec<u8>> {
        self.context.bytes(|bytes, capacity, written| unsafe { sys::vbss_thread_save(self.raw, bytes, capacity, written) })
    }
}

impl ThreadMut<'_> {
    /// Attaches a node; the number of the attachment.
    pub fn attach(&mut self, attachment: &ThreadAttachment) -> Result<u32> {
        let mut id = 0;
        self.context.check(unsafe { sys::vbss_thread_attach(self.raw, &attachment.raw, &mut id) })?;
        Ok(id)
    }

    /// Moves a pin or a clamp, with a direction for a clamp.
    pub fn set_attachment_target(&mut self, id: u32, target: [f64; 3], direction: Option<[f64; 3]>) -> Result<()> {
        let direction = direction.as_ref().map_or(ptr::null(), |direction| direction.as_ptr());
        self.context.check(unsafe { sys::vbss_thread_set_attachment_target(self.raw, id, target.as_ptr(), direction) })
    }

    /// Removes an attachment.
    pub fn detach(&mut self, id: u32) -> Result<()> {
        self.context.check(unsafe { sys::vbss_thread_detach(self.raw, id) })
    }
}
