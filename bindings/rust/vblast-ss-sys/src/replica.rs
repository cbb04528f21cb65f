// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Kind of a body in a replica: a VBSS_REPLICA_ constant, with the numbers of vbss_visual_kind.
pub type vbss_replica_kind = i32;

/// An array of the state that was taken last: a VBSS_REPLICA_VIEW_ constant.
pub type vbss_replica_field = i32;

// The constants of vbss_replica_kind.
/// A thread, or a piece of one.
pub const VBSS_REPLICA_KIND_THREAD: vbss_replica_kind = 1;
/// A drain.
pub const VBSS_REPLICA_KIND_DRAIN: vbss_replica_kind = 2;
/// A needle.
pub const VBSS_REPLICA_KIND_NEEDLE: vbss_replica_kind = 3;
/// A grasper that is a needle driver.
pub const VBSS_REPLICA_KIND_DRIVER: vbss_replica_kind = 4;
/// A grasper that is shears.
pub const VBSS_REPLICA_KIND_SHEARS: vbss_replica_kind = 5;
/// Another rigid body.
pub const VBSS_REPLICA_KIND_RIGID: vbss_replica_kind = 6;

// The constants of vbss_replica_field. Bodies have the order of the scene's table of bodies.
/// x 8 uint32_t: vbss_replica_kind, number of the body in its scene, first node, number of nodes,
/// first triangle, number of triangles, first capsule, number of capsules.
pub const VBSS_REPLICA_VIEW_BODIES: vbss_replica_field = 0;
/// x 7, one row per body: position of the frame that vbss_scene_get_rigid reports, m, and
/// orientation w, x, y, z. Threads and drains have 0, 0, 0 and 1, 0, 0, 0.
pub const VBSS_REPLICA_VIEW_POSES: vbss_replica_field = 1;
/// x 2, one row per body: radius of a thread or of a needle's wire, or half the thickness of a
/// drain's wall, m, otherwise 0; angle of each jaw of a grasper from the middle, rad, otherwise
/// 0.
pub const VBSS_REPLICA_VIEW_SIZES: vbss_replica_field = 2;
/// x 3: positions of the nodes of threads and drains, m.
pub const VBSS_REPLICA_VIEW_NODES: vbss_replica_field = 3;
/// x 1, one row per node: tension of the segment of a thread that begins at this node, N, without the
/// part of bending, as visuals show it. It is 0 at the last node of a thread and at nodes of
/// drains.
pub const VBSS_REPLICA_VIEW_TENSIONS: vbss_replica_field = 4;
/// x 3 uint32_t: nodes of the triangles of drains, counted from the drain's first node,
/// counter-clockwise seen from outside.
pub const VBSS_REPLICA_VIEW_TRIANGLES: vbss_replica_field = 5;
/// x 7: both ends of the axis and the radius of the capsules of rigid bodies, needles and graspers,
/// m.
pub const VBSS_REPLICA_VIEW_CAPSULES: vbss_replica_field = 6;
/// x 4 uint32_t, one row per hole: its id, number of the needle in it or 0, number of the thread in
/// it or 0, number of the drain.
pub const VBSS_REPLICA_VIEW_HOLES: vbss_replica_field = 7;
/// x 8, one row per hole: position, position on the drain at rest, radius of the suture in it, arc
/// length of the suture there, m.
pub const VBSS_REPLICA_VIEW_HOLE_PLACES: vbss_replica_field = 8;
/// x 5 uint32_t: as VBSS_SCENE_VIEW_CONTACTS.
pub const VBSS_REPLICA_VIEW_CONTACTS: vbss_replica_field = 9;
/// x 3: point between the two surfaces, m.
pub const VBSS_REPLICA_VIEW_CONTACT_POINTS: vbss_replica_field = 10;
/// x 3: unit normal from b to a.
pub const VBSS_REPLICA_VIEW_CONTACT_NORMALS: vbss_replica_field = 11;
/// x 3: force of b on a, N.
pub const VBSS_REPLICA_VIEW_CONTACT_FORCES: vbss_replica_field = 12;
/// x 1: distance of the surfaces, m.
pub const VBSS_REPLICA_VIEW_CONTACT_GAPS: vbss_replica_field = 13;

/// A copy of a scene for another thread.
#[repr(C)]
pub struct vbss_replica {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a replica. Fill it with vbss_replica_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_replica_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Largest number of nodes of all drains, 0 to 2^20. Default 0: the nodes of the drains that the
    /// scene has when the replica is created. All other capacities are those of the scene.
    pub drain_node_capacity: u32,
}

/// The state that was taken last.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_replica_state {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: this call took a state; 0: none was published since the last take, so it is the same as
    /// before.
    pub is_new: i32,
    /// Number of the state: 1 for the first that was published; 0: none was published yet, and all
    /// arrays are empty.
    pub number: u64,
    /// Published states that the reader has never taken, up to this one.
    pub missed: u64,
    /// Steps of the scene: vbss_scene_statistics::steps.
    pub steps: u64,
    /// Simulated time of the scene, s: vbss_scene_statistics::time.
    pub time: f64,
    /// Bytes that the call copied that published this state.
    pub bytes: u64,
    /// 1: the scene has a floor; otherwise 0.
    pub floor: i32,
    /// Zero.
    pub reserved: u32,
    /// Direction up of the floor, unit.
    pub floor_normal: [f64; 3],
    /// Height of the floor along its normal, m.
    pub floor_height: f64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_replica_config_init(config: *mut vbss_replica_config, struct_size: u32) -> vbss_result;
    /// Creates a replica in the context of a scene, with the scene's capacities. Only this call allocates
    /// memory. Add drains to the scene first, or state drain_node_capacity.
    ///
    /// @param scene         the scene whose capacities the replica gets
    /// @param config        the configuration; NULL for the defaults
    /// @param replica  the new replica, without a state; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replica_create(scene: *mut vbss_scene, config: *const vbss_replica_config, replica: *mut *mut vbss_replica) -> vbss_result;
    /// Destroys a replica. Its views become invalid, so the reader must have finished with it. A visual
    /// does not show it any more. Destroying the context destroys the replica too; the reader must have
    /// finished before that, and visuals of other contexts must have removed it.
    ///
    /// @param replica  the replica; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY (also: the reader is in a call)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replica_destroy(replica: *mut vbss_replica) -> vbss_result;
    /// Publishes the state of a scene as it is after the last step or edit. The call copies the state,
    /// allocates nothing and never waits for the reader. The constant mesh of a drain is copied only into
    /// buffers that do not have it yet. On failure the reader keeps the state that was published before.
    ///
    /// @param replica  the replica
    /// @param scene    a scene of the same context
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a scene of another context), VBSS_ERROR_CAPACITY
    /// (the scene has more of something than the replica has room for) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replica_publish(replica: *mut vbss_replica, scene: *mut vbss_scene) -> vbss_result;
    /// Takes the newest published state. Earlier views become invalid if there is a new one. The call
    /// stores no error text, and never waits for the stepping thread.
    ///
    /// @param replica      the replica
    /// @param state   receives what describes the state; may be NULL
    /// @param struct_size  `sizeof *state` as the caller was compiled; not used if state is NULL
    /// @return VBSS_OK (also: nothing is new), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_BUSY (a second thread reads at the same time)
    /// @threads the reader thread, at the same time as any call on the context
    /// @since 1.0
    pub fn vbss_replica_take(replica: *mut vbss_replica, state: *mut vbss_replica_state, struct_size: u32) -> vbss_result;
    /// Returns a view of one of the arrays of the state that was taken last. It is valid until the next
    /// take, or until the replica is destroyed. The call stores no error text.
    ///
    /// @param replica      the replica
    /// @param field        the array
    /// @param view    receives the address and the shape of the array; its generation is the number
    /// of the state
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_OUT_OF_RANGE (no such field) or VBSS_ERROR_BUSY (a second thread reads at the
    /// same time)
    /// @threads the reader thread, at the same time as any call on the context
    /// @since 1.0
    pub fn vbss_replica_get_view(replica: *mut vbss_replica, field: vbss_replica_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
}
