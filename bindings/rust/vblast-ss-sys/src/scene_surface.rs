// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_void};
#[allow(unused_imports)]
use crate::*;


/// An array of a host surface: a VBSS_SCENE_SURFACE_VIEW_ constant.
pub type vbss_scene_surface_field = i32;

// The constants of vbss_scene_surface_field.
/// Positions of the vertices after the last step, m: vertex_count times x, y, z. They differ from
/// the targets while a step is suspended, and after a step of which the scene left out a part.
pub const VBSS_SCENE_SURFACE_VIEW_POSITIONS: vbss_scene_surface_field = 1;
/// Positions that the host gave last, m: vertex_count times x, y, z.
pub const VBSS_SCENE_SURFACE_VIEW_TARGETS: vbss_scene_surface_field = 2;
/// Forces of contacts and holes on the vertices at the end of the last step, friction included, N: vertex_count
/// times x, y, z. Each contact force acts at a point of the middle of the wall, and the corners of
/// the triangle or edge there share it by its barycentric coordinates. So the forces on the
/// vertices have the sum and the torque of the contact forces at these points. The corners of the triangle
/// in which a hole is share its force in the same way. After a step of which
/// the scene left out a part they are those of the step before.
pub const VBSS_SCENE_SURFACE_VIEW_FORCES: vbss_scene_surface_field = 3;

/// Says where on the new mesh of a host surface a hole is (vbss_scene_remesh_surface). It runs on the thread
/// that remeshes, once for each hole of the surface, in ascending order of the entries of vbss_scene_get_hole. The scene still has
/// the mesh from before; calls that change the context return VBSS_ERROR_BUSY.
///
/// @param user           as given to vbss_scene_remesh_surface
/// @param hole           the hole and its place on the mesh before; valid during the call
/// @param\[in,out\] triangle  triangle of the new mesh. It comes with that of the nearest place, which the function may leave
/// @param\[in,out\] weights   three barycentric coordinates of the hole in it, each 0 to 1, with a sum of 1; likewise
/// @return VBSS_OK; any other status if the new mesh has no place for the hole: it then is refused
/// @since 1.0
pub type vbss_scene_place_hole_fn = Option<unsafe extern "C" fn(user: *mut c_void, hole: *const vbss_scene_hole_place, triangle: *mut u32, weights: *mut f64) -> vbss_result>;

/// Configuration of a host surface. Fill it with vbss_scene_surface_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_surface_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of vertices, 3 to 65536.
    pub vertex_count: u32,
    /// Number of triangles, 1 to 131072.
    pub triangle_count: u32,
    /// 0: both sides are solid. Other values are refused: the guard does not yet hold for one side of a
    /// surface that moves.
    pub one_sided: u32,
    /// First positions of the vertices in the world, m: vertex_count times x, y, z, each at most 1e3
    /// in magnitude; the library copies them.
    pub vertices: *const f64,
    /// Corners of triangles: triangle_count times three different indices of vertices, in any order.
    /// No triangle may be so thin that the cross product of two of its sides is zero. The library
    /// copies them.
    pub triangles: *const u32,
    /// Friction coefficient of its surface, 0 to 10; default 0.15. A contact with a thread has this
    /// coefficient, any other contact the geometric mean of both.
    pub friction: f64,
    /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The triangles are its middle: other
    /// bodies touch it at half the thickness from them.
    pub thickness: f64,
    /// Largest distance between two positions of a vertex that the host gives one after the other, m,
    /// 1e-6 to 1e3; default 20e-3: 20 m/s at steps of 1 ms. vbss_scene_move_surface refuses a longer
    /// one.
    pub jump_limit: f64,
    /// Numbers with which the host states how far each vertex gives way to a force: 0 (default): none, all
    /// vertices are exactly where the host says; 1: one compliance for all directions; 9: a symmetric matrix of
    /// 3 x 3. Values are set by vbss_scene_set_surface_compliance, and are zero before.
    pub compliance_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Force along the direction of a tip at which it enters the wall, N, 1e-3 to 1e3; 0 (default): no tip
    /// enters by force, and holes are those of vbss_scene_make_hole only.
    pub puncture_force: f64,
    /// Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25.
    pub hole_force: f64,
    /// Coefficient of the additional friction from the force across the suture, 0 to 10; default 0.3.
    pub hole_friction: f64,
    /// Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7; default 2e4.
    pub hole_stiffness: f64,
    /// Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05.
    pub hole_damping: f64,
    /// Length of a tip's path through the wall over which the force against its advance falls from puncture_force
    /// to hole_force, and that against drawing it back grows from 0 to hole_force; m, 0 to 0.1; default 0.5e-3.
    pub tip_length: f64,
    /// Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02.
    pub thread_force: f64,
    /// Energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads do not tear the wall at their
    /// holes. Otherwise as vbss_drain_config::tear_energy.
    pub tear_energy: f64,
}

/// A hole of a host surface that gets another mesh, as vbss_scene_place_hole_fn receives it.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_hole_place {
    /// Size of this struct in bytes.
    pub struct_size: u32,
    /// Id of the hole, as vbss_scene_make_hole gave it.
    pub hole: u32,
    /// Triangle of the mesh before in which the hole is.
    pub triangle: u32,
    /// Zero.
    pub reserved: u32,
    /// Barycentric coordinates of the hole in that triangle.
    pub weights: [f64; 3],
    /// Where the hole is now, in the world, m.
    pub position: [f64; 3],
    /// Unit normal of that triangle now: along (b - a) x (c - a) for its corners a, b, c.
    pub normal: [f64; 3],
}

extern "C" {
    /// Fills a configuration of a host surface with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_surface_config_init(config: *mut vbss_scene_surface_config, struct_size: u32) -> vbss_result;
    /// Adds a host surface: a static mesh that moves (vbss_scene_add_static_mesh). It counts as one of the
    /// scene's rigid bodies (rigid_capacity). It touches neither itself nor static meshes nor other host
    /// surfaces. No node can be pinned to it. Needles and threads pass through it by holes, as through a drain
    /// (vbss_scene_make_hole, puncture_force). A driven body and the surface do not press on each other, because both follow the host exactly: the guard holds both back.
    /// Vertices with a compliance (vbss_scene_set_surface_compliance) give way to it, and a coupled tool gives
    /// way itself. The call allocates all memory that steps need for the surface.
    /// vbss_scene_get_rigid reports the sum of the contact forces on it.
    ///
    /// @param scene      the scene, of method VBSS_METHOD_IMPLICIT
    /// @param config     the configuration; not NULL, because a surface needs triangles
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: a triangle without area, with a
    /// vertex that does not exist or occurs twice, triangles of a one-sided surface that are not
    /// wound alike, or an overlap, if the scene refuses it), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_surface(scene: *mut vbss_scene, config: *const vbss_scene_surface_config, body: *mut u32) -> vbss_result;
    /// Sets the positions of the vertices at the end of the next step that begins. Without a call the
    /// surface stays where it is. Velocities follow from the positions. A refused call changes nothing.
    ///
    /// The positions are an input of the scene. Snapshots save them. A log stores the state of the whole
    /// scene with each call (vbss_scene_set_recorder), and so replays without the host's model; it grows by
    /// the size of a snapshot each time.
    ///
    /// @param scene         the scene
    /// @param body          a host surface
    /// @param vertices      vertex_count times x, y, z, m, each at most 1e3 in magnitude
    /// @param vertex_count  number of vertices, as the surface was added
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
    /// body), VBSS_ERROR_INCOMPATIBLE (the body is no host surface), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_RANGE (another number of vertices; a vertex that is farther than
    /// jump_limit from its last position; a triangle that has lost its area or whose normal has
    /// turned by 90 degrees or more since the last positions), VBSS_ERROR_CAPACITY (the record has
    /// no room) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_move_surface(scene: *mut vbss_scene, body: u32, vertices: *const f64, vertex_count: u32) -> vbss_result;
    /// Sets how far each vertex of a host surface gives way to a contact force: the scene finds contacts at the
    /// position that the host has given plus compliance times force. So it solves for the force that the host's
    /// model bears at the end of the step, and a light or soft surface stays stable
    /// (docs/guides/host-surface.md). The best value is the displacement in the host's model by a unit force that
    /// acts during the whole next step: h^2 / mass for a free particle, or the block of the inverse of the host's
    /// system matrix. The host gives the positions that its vertices reach without contact force, and then applies
    /// the returned forces during the same step. The vertices then end where VBSS_SCENE_SURFACE_VIEW_POSITIONS
    /// says. Vertices that no contact touches stay where the host says. At most 1,024 vertices of a surface are
    /// touched at a time, or the step returns VBSS_ERROR_CAPACITY.
    ///
    /// The call ends a suspended step. Snapshots save the compliance, and a log stores the state with each call.
    ///
    /// @param scene       the scene
    /// @param body        a host surface that was added with compliance_size 1 or 9
    /// @param compliance  vertex_count times compliance_size numbers, m/N: for each vertex a number, or the rows of a
    /// symmetric, positive definite matrix of which no pivot is below 1e-6 of the largest number. The largest
    /// number of a vertex is 1e-9 to 1e6; all zero: the vertex is exactly where the host says
    /// @param count       number of these numbers
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
    /// body), VBSS_ERROR_INCOMPATIBLE (no host surface, or one of compliance_size 0),
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_OUT_OF_MEMORY (only while a step is
    /// suspended), VBSS_ERROR_CAPACITY (the record has no room) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_surface_compliance(scene: *mut vbss_scene, body: u32, compliance: *const f64, count: u32) -> vbss_result;
    /// Gives a host surface another mesh. The body keeps its number, filter, friction, thickness, the parameters of
    /// holes, compliance_size and jump_limit. Its holes keep their ids, their needles and threads, and their forces: each goes to the
    /// place on the new mesh that `place` returns. The new vertices are where the surface is from now on. So they must be on the
    /// surface of VBSS_SCENE_SURFACE_VIEW_POSITIONS, as exactly as forces shall stay the same: a hole
    /// that moves by d across its suture changes its force by up to hole_stiffness times d.
    ///
    /// - A move that no step has used yet is dropped. The next one starts from the new vertices.
    /// - All vertices are prescribed until the host states their compliance again
    /// (vbss_scene_set_surface_compliance). Their forces are zero until the next step.
    /// - Contacts, unlike holes, start the next step without the forces of the last one.
    /// - Bodies that the new mesh overlaps, except sutures at its holes, are treated as the scene's `overlap` says. A body
    /// that lies wholly on the other side of the new mesh is not found.
    ///
    /// The call ends a suspended step, and allocates all memory that steps need. A refused or failed call changes
    /// nothing. It compares each hole, and for overlaps each part of the other bodies near the surface, with all new triangles.
    ///
    /// A snapshot from before cannot be restored into the scene any more; vbss_scene_load creates a scene with the mesh of its
    /// snapshot. A log stores the state of the whole scene, so a replay needs no callback; only a scene of
    /// vbss_replay_load_scene follows it.
    ///
    /// @param scene           the scene
    /// @param body            a host surface
    /// @param vertices        vertex_count times x, y, z, m, each at most 1e3 in magnitude; the library copies them
    /// @param vertex_count    number of vertices, 3 to 65536
    /// @param triangles       triangle_count times three different indices of vertices; as in vbss_scene_surface_config
    /// @param triangle_count  number of triangles, 1 to 131072
    /// @param place           says where each hole goes; NULL: to the nearest place on the new mesh
    /// @param user            passed to `place`
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
    /// body, or `place` returned another status than VBSS_OK), VBSS_ERROR_INCOMPATIBLE (the body is no host
    /// surface), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE (a count; a triangle that vbss_scene_add_surface
    /// would refuse; a triangle or weights from `place` that do not exist; a hole that would move by more than the radius of
    /// its suture and half the thickness of the wall; an overlap, if the scene refuses it),
    /// VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_CAPACITY (the record has no room) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_remesh_surface(scene: *mut vbss_scene, body: u32, vertices: *const f64, vertex_count: u32, triangles: *const u32, triangle_count: u32, place: vbss_scene_place_hole_fn, user: *mut c_void) -> vbss_result;
    /// Describes an array of a host surface without copying it.
    ///
    /// @param scene        the scene
    /// @param body         a host surface
    /// @param field        the array
    /// @param view    where it is; valid until the next step, move or edit of the scene
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
    /// body), VBSS_ERROR_INCOMPATIBLE (the body is no host surface), VBSS_ERROR_OUT_OF_RANGE (no
    /// such array), VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_surface_view(scene: *mut vbss_scene, body: u32, field: vbss_scene_surface_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
}
