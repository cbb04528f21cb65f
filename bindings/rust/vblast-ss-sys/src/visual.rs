// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Kind of a part: a VBSS_VISUAL_KIND_ constant.
pub type vbss_visual_kind = i32;

/// Kind of a spot: a VBSS_VISUAL_SPOT_ constant.
pub type vbss_visual_spot_kind = i32;

/// An array: a VBSS_VISUAL_VIEW_ constant.
pub type vbss_visual_field = i32;

// The constants of vbss_visual_kind.
/// A thread, or a piece of one.
pub const VBSS_VISUAL_KIND_THREAD: vbss_visual_kind = 1;
/// A drain.
pub const VBSS_VISUAL_KIND_DRAIN: vbss_visual_kind = 2;
/// A needle.
pub const VBSS_VISUAL_KIND_NEEDLE: vbss_visual_kind = 3;
/// A grasper that is a needle driver.
pub const VBSS_VISUAL_KIND_DRIVER: vbss_visual_kind = 4;
/// A grasper that is shears.
pub const VBSS_VISUAL_KIND_SHEARS: vbss_visual_kind = 5;
/// Another rigid body of a scene: its capsules.
pub const VBSS_VISUAL_KIND_RIGID: vbss_visual_kind = 6;
/// The floor of a scene.
pub const VBSS_VISUAL_KIND_FLOOR: vbss_visual_kind = 7;

// The constants of vbss_visual_spot_kind.
/// One of the two marks, on the outer face.
pub const VBSS_VISUAL_SPOT_MARK: vbss_visual_spot_kind = 1;
/// A hole with a needle or a thread in it, through the wall.
pub const VBSS_VISUAL_SPOT_HOLE: vbss_visual_spot_kind = 2;

// The constants of vbss_visual_field.
/// x 12 float: position, m from `origin`; unit normal, outward; texture; material; value.
/// *Texture*: on tubes and tools, 0 to 1 around the section, and m along; on drains, m along the tube, and
/// m around it from the middle of the slit before it was opened; on floors, m in the plane.
/// *Material*, x 3, m: position in the undeformed body. On drains it is the position at rest in the drain's
/// frame (VBSS_DRAIN_VIEW_REST_POSITIONS); on tubes and tools, along and across the axis; on floors, the texture
/// and 0.
/// *Value*: on threads, the tension, N; on drains, 1 on the outer face, -1 on the inner face, 0 on rims; on
/// graspers, 0 shaft, 1 neck, 2 jaws; else 0.
pub const VBSS_VISUAL_VIEW_VERTICES: vbss_visual_field = 0;
/// x 3 uint32_t: vertices, counter-clockwise seen from outside.
pub const VBSS_VISUAL_VIEW_TRIANGLES: vbss_visual_field = 1;
/// x 8 uint32_t: vbss_visual_kind, source, number of the body in its scene or 0, first vertex, number of
/// vertices, first triangle, number of triangles, 0. Parts have the order of their sources, and within a
/// scene that of its bodies.
pub const VBSS_VISUAL_VIEW_PARTS: vbss_visual_field = 2;
/// x 6 float: index of the drain in VBSS_VISUAL_VIEW_PARTS, vbss_visual_spot_kind, material x 3, radius in m.
pub const VBSS_VISUAL_VIEW_SPOTS: vbss_visual_field = 3;

/// Meshes of scenes and bodies.
#[repr(C)]
pub struct vbss_visual {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a visual. Fill it with vbss_visual_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_visual_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Largest number of scenes and bodies, 1 to 256; default 8.
    pub source_capacity: u32,
    /// Largest number of drawn bodies, 1 to 4096; default 32.
    pub part_capacity: u32,
    /// Largest number of vertices, 16 to 2^24; default 65536. The visual allocates two such meshes.
    pub vertex_capacity: u32,
    /// Largest number of triangles, 16 to 2^24; default 131072.
    pub triangle_capacity: u32,
    /// Largest number of spots, 0 to 4096; default 32.
    pub spot_capacity: u32,
    /// Largest number of nodes of a thread or a drain, 2 to 65537; default 4096.
    pub node_capacity: u32,
    /// Largest number of sides of a tube's section, 6 to 64; default 32. The smallest number is 6.
    pub side_limit: u32,
    /// Largest number of parts of a segment, or of a side of a triangle, 1 to 32; default 12.
    pub division_limit: u32,
    /// Zero.
    pub reserved: u32,
    /// Tubes, tools and needles: largest deviation of chords from the centre line, and of polygons from
    /// sections, m, 1e-8 to 1; default 5e-6.
    pub tube_tolerance: f64,
    /// Drains: largest deviation of chords from curved sides of patches, m, 1e-8 to 1; default 2e-5.
    pub surface_tolerance: f64,
    /// Radius of the marks of drains, m, 0 to 0.1; default 1e-3.
    pub mark_radius: f64,
    /// Length over which a needle tapers to its tip, m, 0 to 1; default 4e-3. At most half the needle's
    /// length is used.
    pub tip_length: f64,
    /// Side of the square that shows a floor, m, 1e-3 to 1e3; default 0.3.
    pub floor_size: f64,
    /// Point in the world that vertices are relative to, m, each at most 1e3; default 0. Choose it near the
    /// bodies, because vertices have single precision (24 bits). The square of the floor is centred on it
    /// too.
    pub origin: [f64; 3],
}

/// Counts of the last update.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_visual_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Scenes and bodies that the host has added.
    pub sources: u32,
    /// Bodies drawn.
    pub parts: u32,
    /// Vertices of all parts.
    pub vertices: u32,
    /// Triangles of all parts.
    pub triangles: u32,
    /// Marks and holes.
    pub spots: u32,
    /// Calls of vbss_visual_update that succeeded.
    pub updates: u64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_visual_config_init(config: *mut vbss_visual_config, struct_size: u32) -> vbss_result;
    /// Creates a visual without sources. Only this call allocates memory.
    ///
    /// @param context      owner
    /// @param config       the configuration; NULL for the defaults
    /// @param visual  the new visual; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_create(context: *mut vbss_context, config: *const vbss_visual_config, visual: *mut *mut vbss_visual) -> vbss_result;
    /// Destroys a visual. Scenes and bodies that it showed do not change.
    ///
    /// @param visual  the visual; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_destroy(visual: *mut vbss_visual) -> vbss_result;
    /// Shows a scene from the next update on: all its bodies, also bodies and pieces of threads added later, its
    /// floor and its holes. A destroyed scene is no longer shown.
    ///
    /// @param visual       the visual
    /// @param scene        a scene of the same context
    /// @param source  its number, from 1 on, never reused; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a scene of another context),
    /// VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_add_scene(visual: *mut vbss_visual, scene: *mut vbss_scene, source: *mut u32) -> vbss_result;
    /// Shows a replica (replica.h): the scene as it was when the state that the reader took last was
    /// published. The replica belongs to the context of its scene, which may be another one than the
    /// visual's. The thread that updates the visual must be the reader of the replica. A destroyed replica
    /// is no longer shown; remove it before its context is destroyed.
    ///
    /// @param visual       the visual
    /// @param replica      a replica of any context
    /// @param source  its number, from 1 on, never reused; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context of the visual, at the same time as any call on the context
    /// of the replica
    /// @since 1.0
    pub fn vbss_visual_add_replica(visual: *mut vbss_visual, replica: *mut vbss_replica, source: *mut u32) -> vbss_result;
    /// Shows a thread from the next update on, until it is removed from the visual or destroyed.
    ///
    /// @param visual       the visual
    /// @param thread       a thread of the same context
    /// @param source  its number, from 1 on, never reused; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a thread of another context),
    /// VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_add_thread(visual: *mut vbss_visual, thread: *mut vbss_thread, source: *mut u32) -> vbss_result;
    /// Shows a drain from the next update on, without holes, until it is removed from the visual or destroyed.
    ///
    /// @param visual       the visual
    /// @param drain        a drain of the same context
    /// @param source  its number, from 1 on, never reused; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a drain of another context),
    /// VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_add_drain(visual: *mut vbss_visual, drain: *mut vbss_drain, source: *mut u32) -> vbss_result;
    /// Shows a needle from the next update on, until it is removed from the visual or destroyed.
    ///
    /// @param visual       the visual
    /// @param needle       a needle of the same context
    /// @param source  its number, from 1 on, never reused; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a needle of another context),
    /// VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_add_needle(visual: *mut vbss_visual, needle: *mut vbss_needle, source: *mut u32) -> vbss_result;
    /// Shows a grasper from the next update on, until it is removed from the visual or destroyed.
    ///
    /// @param visual       the visual
    /// @param grasper      a grasper of the same context
    /// @param source  its number, from 1 on, never reused; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a grasper of another context),
    /// VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_add_grasper(visual: *mut vbss_visual, grasper: *mut vbss_grasper, source: *mut u32) -> vbss_result;
    /// Removes a scene or a body. It is not shown from the next update on.
    ///
    /// @param visual  the visual
    /// @param source  number of the scene or the body in the visual
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such source) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_remove(visual: *mut vbss_visual, source: u32) -> vbss_result;
    /// Computes the meshes of all sources in their current state. The call allocates nothing. Earlier
    /// views keep their content until the update after this one. On failure the meshes do not change.
    ///
    /// @param visual  the visual
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (the error text names it),
    /// VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY (also: another thread reads a replica that is
    /// shown)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_update(visual: *mut vbss_visual) -> vbss_result;
    /// Returns a view of one of the arrays of the last update.
    ///
    /// @param visual       the visual
    /// @param field        the array
    /// @param view    receives the address and the shape of the array
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_get_view(visual: *mut vbss_visual, field: vbss_visual_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns the counts of the last update.
    ///
    /// @param visual           the visual
    /// @param statistics  receives the numbers
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_visual_get_statistics(visual: *mut vbss_visual, statistics: *mut vbss_visual_statistics, struct_size: u32) -> vbss_result;
}
