// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_void};
#[allow(unused_imports)]
use crate::*;


/// Kind of a body: a VBSS_SCENE_BODY_ constant.
pub type vbss_scene_body_kind = i32;

// The constants of vbss_scene_body_kind.
/// A thread.
pub const VBSS_SCENE_BODY_THREAD: vbss_scene_body_kind = 1;
/// A drain.
pub const VBSS_SCENE_BODY_DRAIN: vbss_scene_body_kind = 2;
/// A rigid body that is neither a needle nor a grasper.
pub const VBSS_SCENE_BODY_RIGID: vbss_scene_body_kind = 3;
/// A needle.
pub const VBSS_SCENE_BODY_NEEDLE: vbss_scene_body_kind = 4;
/// A grasper.
pub const VBSS_SCENE_BODY_GRASPER: vbss_scene_body_kind = 5;
/// The floor, body 0.
pub const VBSS_SCENE_BODY_FLOOR: vbss_scene_body_kind = 6;
/// A static mesh.
pub const VBSS_SCENE_BODY_STATIC_MESH: vbss_scene_body_kind = 7;
/// A host surface (scene_surface.h).
pub const VBSS_SCENE_BODY_SURFACE: vbss_scene_body_kind = 8;
/// A plane that the host added.
pub const VBSS_SCENE_BODY_PLANE: vbss_scene_body_kind = 9;

/// Properties of a body in a scene.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_body_info {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Number of the body.
    pub body: u32,
    /// Kind of the body.
    pub kind: vbss_scene_body_kind,
    /// Kind of motion of rigid bodies, needles and graspers; 0 for other bodies.
    pub motion: vbss_scene_rigid_kind,
    /// Categories of its contact filter (vbss_scene_set_filter).
    pub category: u32,
    /// Mask of its contact filter.
    pub mask: u32,
    /// Coefficient of friction. For a thread, the one between threads.
    pub friction: f64,
    /// Gravitational acceleration, m/s^2; 0 for the floor.
    pub gravity: [f64; 3],
}

/// First surface that a ray hits.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_ray_hit {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: the ray hits something; 0: all other fields are 0.
    pub is_hit: u32,
    /// Number of the body; 0: the floor.
    pub body: u32,
    /// Segment, capsule or triangle of the body; 0 for the floor.
    pub feature: u32,
    /// Place on the ray, 0 at its origin to 1 at its end.
    pub fraction: f64,
    /// Point on the surface, m.
    pub point: [f64; 3],
    /// Outward unit normal of the surface there.
    pub normal: [f64; 3],
}

/// Body nearest to a point.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_nearest {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: a surface is within the radius; 0: all other fields are 0.
    pub is_found: u32,
    /// Number of the body; 0: the floor.
    pub body: u32,
    /// Segment, capsule or triangle of the body; 0 for the floor.
    pub feature: u32,
    /// Distance of its surface, m; negative inside the body.
    pub distance: f64,
    /// Nearest point of that surface, m.
    pub point: [f64; 3],
    /// Outward unit normal of the surface there.
    pub normal: [f64; 3],
}

extern "C" {
    /// Lists the numbers of all bodies of a scene in ascending order.
    ///
    /// @param scene         the scene
    /// @param numbers  receives the numbers; NULL with capacity 0 asks for their count
    /// @param capacity      room in `numbers`
    /// @param count    number of bodies, also when they do not fit
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_bodies(scene: *mut vbss_scene, numbers: *mut u32, capacity: u32, count: *mut u32) -> vbss_result;
    /// Returns the properties of a body.
    ///
    /// @param scene        the scene
    /// @param body         its number; 0: the floor
    /// @param info    receives the properties
    /// @param struct_size  `sizeof *info` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such body)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_body(scene: *mut vbss_scene, body: u32, info: *mut vbss_scene_body_info, struct_size: u32) -> vbss_result;
    /// Returns the handle of a drain in the scene.
    ///
    /// @param scene       the scene
    /// @param body        number of the drain in the scene
    /// @param drain  its handle; NULL when there is no such drain
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body) or VBSS_ERROR_INCOMPATIBLE (no drain)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_drain(scene: *mut vbss_scene, body: u32, drain: *mut *mut vbss_drain) -> vbss_result;
    /// Returns the handle of a needle in the scene.
    ///
    /// @param scene        the scene
    /// @param body         number of the needle in the scene
    /// @param needle  its handle; NULL when there is no such needle
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body) or VBSS_ERROR_INCOMPATIBLE (no needle)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_needle(scene: *mut vbss_scene, body: u32, needle: *mut *mut vbss_needle) -> vbss_result;
    /// Returns the handle of a grasper in the scene.
    ///
    /// @param scene         the scene
    /// @param body          number of the grasper in the scene
    /// @param grasper  its handle; NULL when there is no such grasper
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body) or VBSS_ERROR_INCOMPATIBLE (no grasper)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_grasper(scene: *mut vbss_scene, body: u32, grasper: *mut *mut vbss_grasper) -> vbss_result;
    /// Stores a pointer of the host with a body. The library never follows it. It is no part of the
    /// state: snapshots and logs do not contain it, and vbss_scene_restore leaves it. A new body and a
    /// piece that is cut from a thread have NULL.
    ///
    /// @param scene  the scene
    /// @param body   number of a body, not 0
    /// @param data   the pointer, or an integer of its size; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_user_data(scene: *mut vbss_scene, body: u32, data: *mut c_void) -> vbss_result;
    /// Returns the pointer that the host has stored with a body.
    ///
    /// @param scene      the scene
    /// @param body       number of a body, not 0
    /// @param data  receives the pointer; NULL if none was stored, and on failure
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_NOT_FOUND
    /// (no such body)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_user_data(scene: *mut vbss_scene, body: u32, data: *mut *mut c_void) -> vbss_result;
    /// Finds the first surface that a ray hits. A ray that begins inside a body hits it at fraction 0.
    ///
    /// @param scene        the scene
    /// @param origin       where the ray begins, m, each coordinate at most 1e3 in magnitude
    /// @param translation  vector from there to its end, m, each component at most 1e4 in magnitude, not
    /// zero
    /// @param mask         categories of bodies that count (vbss_scene_set_filter); 0xffffffff: all
    /// @param hit     receives the hit
    /// @param struct_size  `sizeof *hit` as the caller was compiled
    /// @return VBSS_OK (also without a hit), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
    /// VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_cast_ray(scene: *mut vbss_scene, origin: *const f64, translation: *const f64, mask: u32, hit: *mut vbss_scene_ray_hit, struct_size: u32) -> vbss_result;
    /// Finds the body whose surface is nearest to a point, within a radius. Inside several bodies it is
    /// the one with the deepest surface.
    ///
    /// @param scene         the scene
    /// @param point         the point, m, each coordinate at most 1e3 in magnitude
    /// @param radius        largest distance, m, 0 to 1e4
    /// @param mask          categories of bodies that count (vbss_scene_set_filter); 0xffffffff: all
    /// @param nearest  receives the body
    /// @param struct_size   `sizeof *nearest` as the caller was compiled
    /// @return VBSS_OK (also without such a body), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
    /// VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_find_nearest(scene: *mut vbss_scene, point: *const f64, radius: f64, mask: u32, nearest: *mut vbss_scene_nearest, struct_size: u32) -> vbss_result;
}
