// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use crate::sys;

/// Configuration of a scene. Fill it with vbss_scene_config_init, then change fields.
#[derive(Debug, Clone)]
pub struct SceneConfig {
    pub(crate) raw: sys::vbss_scene_config,
}

impl Default for SceneConfig {
    fn default() -> Self {
        SceneConfig { raw: defaults(sys::vbss_scene_config_init) }
    }
}

impl SceneConfig {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Method; default VBSS_METHOD_IMPLICIT. Bodies of the scene must have the same method.
    pub fn method(mut self, value: sys::vbss_method) -> Self {
        self.raw.method = value;
        self
    }

    /// Mode; default VBSS_SCENE_MODE_REAL_TIME.
    pub fn mode(mut self, value: sys::vbss_scene_mode) -> Self {
        self.raw.mode = value;
        self
    }

    /// Largest number of threads at a time, 0 to 64; default 4.
    pub fn thread_capacity(mut self, value: u32) -> Self {
        self.raw.thread_capacity = value;
        self
    }

    /// Largest number of nodes of all threads, 0 to 8192; default 1024.
    pub fn node_capacity(mut self, value: u32) -> Self {
        self.raw.node_capacity = value;
        self
    }

    /// Largest number of rigid bodies and graspers, 0 to 256; default 4.
    pub fn rigid_capacity(mut self, value: u32) -> Self {
        self.raw.rigid_capacity = value;
        self
    }

    /// Largest number of capsules of these bodies, 0 to 4096; default 16.
    pub fn capsule_capacity(mut self, value: u32) -> Self {
        self.raw.capsule_capacity = value;
        self
    }

    /// Largest number of pins at a time, 0 to 256; default 8.
    pub fn pin_capacity(mut self, value: u32) -> Self {
        self.raw.pin_capacity = value;
        self
    }

    /// Largest number of contacts that may close at a time, 0 to 65536; default 1024.
    pub fn contact_capacity(mut self, value: u32) -> Self {
        self.raw.contact_capacity = value;
        self
    }

    /// Largest number of candidate pairs, 0 to 1e7; default 16384.
    pub fn candidate_capacity(mut self, value: u32) -> Self {
        self.raw.candidate_capacity = value;
        self
    }

    /// Largest number of events that are kept until the host takes them (scene_event.h), and of those of
    /// a step, 0 to 65536; default 256.
    pub fn event_capacity(mut self, value: u32) -> Self {
        self.raw.event_capacity = value;
        self
    }

    /// 1: a floor fills the half-space below a plane; default 0.
    pub fn floor(mut self, value: i32) -> Self {
        self.raw.floor = value;
        self
    }

    /// Direction up, of any length from 1e-100 to 1e100; default (0, 1, 0).
    pub fn floor_normal(mut self, value: [f64; 3]) -> Self {
        self.raw.floor_normal = value;
        self
    }

    /// Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.
    pub fn floor_height(mut self, value: f64) -> Self {
        self.raw.floor_height = value;
        self
    }

    /// Coefficient of friction of the floor, 0 to 10; default 0.3.
    pub fn floor_friction(mut self, value: f64) -> Self {
        self.raw.floor_friction = value;
        self
    }

    /// Coefficient of friction between threads, 0 to 10; default 0.3 (silk on silk; the literature
    /// has 0.1 to 0.4).
    pub fn thread_friction(mut self, value: f64) -> Self {
        self.raw.thread_friction = value;
        self
    }

    /// Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default 2e5: 5 um at 1 N.
    pub fn contact_stiffness(mut self, value: f64) -> Self {
        self.raw.contact_stiffness = value;
        self
    }

    /// Largest number of grasped places of threads at a time, 0 to 256; default 8. Places that jaws
    /// have released but not cleared count too, and so do the two ends at each cut of blades.
    /// Without capacity the jaws stay open.
    pub fn grasp_capacity(mut self, value: u32) -> Self {
        self.raw.grasp_capacity = value;
        self
    }

    /// Largest number of drains at a time, 0 to 16; default 1.
    pub fn drain_capacity(mut self, value: u32) -> Self {
        self.raw.drain_capacity = value;
        self
    }

    /// Largest number of holes of needles and threads in walls at a time, 0 to 256; default 16.
    pub fn hole_capacity(mut self, value: u32) -> Self {
        self.raw.hole_capacity = value;
        self
    }

    /// Treatment of overlapping new bodies; default VBSS_SCENE_OVERLAP_WARN.
    pub fn overlap(mut self, value: sys::vbss_scene_overlap_policy) -> Self {
        self.raw.overlap = value;
        self
    }

    /// Largest speed of any point of a driven or coupled body, or of a grasper, on the way to
    /// its target, m/s, 0 to 1e6; 0: no limit; default 20. A body approaches a target that is
    /// farther away at this speed, over several steps. A pose in the wrong unit, or a jump of a
    /// device, then causes no long step and no extreme force. Method IMPLICIT only. Logs and
    /// snapshots store the limit, and a scene with another one rejects them. One exception:
    /// scenes without a limit and with the default limit accept each other's snapshots.
    pub fn speed_limit(mut self, value: f64) -> Self {
        self.raw.speed_limit = value;
        self
    }

    /// Method IMPLICIT: capacity of the linear system's matrix and its factor for threads and rigid
    /// bodies, in blocks of 3 x 3 numbers of 96 bytes, 0 to 1e7; 0 (default): 4096, and 20 for each
    /// node of node_capacity and 40 for each body of rigid_capacity. A node without contact takes up
    /// to 12 blocks, one of a tight knot 42; each drain adds its own. A step that needs more returns
    /// VBSS_ERROR_CAPACITY. See docs/reference/memory.md.
    pub fn matrix_capacity(mut self, value: u32) -> Self {
        self.raw.matrix_capacity = value;
        self
    }
}
