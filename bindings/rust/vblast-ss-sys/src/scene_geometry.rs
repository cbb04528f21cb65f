// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Configuration of a static mesh. Fill it with vbss_scene_static_mesh_config_init, then change
/// fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_static_mesh_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of vertices, 3 to 65536.
    pub vertex_count: u32,
    /// Number of triangles, 1 to 131072.
    pub triangle_count: u32,
    /// 0: bodies touch it from both sides (default). 1: only from the front, which is the side from
    /// which the corners of a triangle are counter-clockwise. What is behind is left alone, also
    /// within the thickness, and passes to the front. There it is pushed out to the contact distance.
    /// What is in front at the start of a step does not get behind, unless it goes round a free edge.
    /// Each edge of such a mesh belongs to one triangle, or to two that list it in opposite
    /// directions.
    pub one_sided: u32,
    /// Vertices in the world, m: vertex_count times x, y, z, each at most 1e3 in magnitude; the
    /// library copies them.
    pub vertices: *const f64,
    /// Corners of triangles: triangle_count times three different indices of vertices, in any
    /// order. Triangles may share vertices and edges, and need not form a closed surface; the
    /// library copies them.
    pub triangles: *const u32,
    /// Friction coefficient of its surface, 0 to 10; default 0.15. A contact with a thread has this
    /// coefficient, any other contact the geometric mean of both.
    pub friction: f64,
    /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The triangles are its middle: other
    /// bodies touch it at half the thickness from them.
    pub thickness: f64,
}

/// Configuration of a height field. Fill it with vbss_scene_height_field_config_init, then change
/// fields. In its frame the heights are along y, the columns along x, and the rows along z.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_height_field_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of heights of a row, 2 or more.
    pub column_count: u32,
    /// Number of rows, 2 or more.
    pub row_count: u32,
    /// Number of heights: column_count times row_count, at most 65536.
    pub height_count: u32,
    /// 0: bodies touch it from both sides (default). 1: only from above, as a one-sided mesh.
    pub one_sided: u32,
    /// Zero.
    pub reserved: u32,
    /// Heights, m, at most 1e3 in magnitude, row by row; the library copies them.
    pub heights: *const f64,
    /// Position of the first height of the first row at height 0, m; default 0.
    pub position: [f64; 3],
    /// Orientation of its frame, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0,
    /// 0.
    pub orientation: [f64; 4],
    /// Spacing of columns and of rows, m, 1e-6 to 1e3; default 1e-3.
    pub spacing: [f64; 2],
    /// Friction coefficient, 0 to 10; default 0.15. A contact with a thread has this coefficient, any
    /// other contact the geometric mean of both.
    pub friction: f64,
    /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The heights are its middle: other bodies
    /// touch it at half the thickness from them.
    pub thickness: f64,
}

/// Configuration of a distance field. Fill it with vbss_scene_distance_field_config_init, then change
/// fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_distance_field_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of distances: the product of the three counts.
    pub distance_count: u32,
    /// Numbers of distances along x, y and z, each 2 to 2048.
    pub counts: [u32; 3],
    /// 1: bodies touch it only from outside, as a one-sided mesh (default). 0: from both sides.
    pub one_sided: u32,
    /// Signed distances from the surface at the points of a grid, m: negative inside, positive
    /// outside, x fastest, z slowest. The library copies them not, but the surface.
    pub distances: *const f64,
    /// Position of the first point of the grid, m, each coordinate at most 1e3 in magnitude; default
    /// 0.
    pub position: [f64; 3],
    /// Orientation of the grid, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.
    pub orientation: [f64; 4],
    /// Spacing of the grid along x, y and z, m, 1e-6 to 1e3; default 1e-3.
    pub spacing: [f64; 3],
    /// Friction coefficient, 0 to 10; default 0.15. A contact with a thread has this coefficient, any
    /// other contact the geometric mean of both.
    pub friction: f64,
    /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. Its outer face is where the distance is
    /// 0, and its middle where it is minus half the thickness. Parts of the solid that are thinner do
    /// not exist.
    pub thickness: f64,
}

/// Configuration of a plane. Fill it with vbss_scene_plane_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_plane_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Direction out of the half-space that the plane bounds, of any length from 1e-100 to 1e100;
    /// default 0, 1, 0.
    pub normal: [f64; 3],
    /// Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.
    pub height: f64,
    /// Coefficient of friction, 0 to 10; default 0.3. A contact with a thread has this coefficient,
    /// any other contact the geometric mean of both.
    pub friction: f64,
}

extern "C" {
    /// Fills a configuration of a static mesh with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_static_mesh_config_init(config: *mut vbss_scene_static_mesh_config, struct_size: u32) -> vbss_result;
    /// Adds a mesh of triangles that never moves: anatomy, a table, a phantom. Threads, needles, tools and
    /// drains touch it from both sides, or from the front alone (one_sided). It counts as one of the
    /// scene's rigid bodies (rigid_capacity). Two static meshes do not touch each other. A driven body
    /// that overlaps it when it is added is held back by it. The call allocates all memory that steps
    /// need for the mesh, and builds its bounding volume hierarchy; no step allocates or builds either.
    /// Holes cannot be made in it, and no node be pinned to it. Rays and overlaps find it from both
    /// sides. vbss_scene_get_rigid reports the contact force on it.
    ///
    /// @param scene      the scene, of method VBSS_METHOD_IMPLICIT
    /// @param config     the configuration; not NULL, because a mesh needs triangles
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: a triangle with a vertex that
    /// does not exist or occurs twice, triangles of a one-sided mesh that are not wound alike,
    /// or an overlap, if the scene refuses it),
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_static_mesh(scene: *mut vbss_scene, config: *const vbss_scene_static_mesh_config, body: *mut u32) -> vbss_result;
    /// Adds a rigid body whose shape is a mesh of triangles: another instrument, a trocar, a bone. It moves as a
    /// rigid body of capsules does (vbss_scene_set_rigid_target, and for its kind of motion forces, velocities
    /// and poses), and vbss_scene_get_rigid reports the forces on it. Threads, needles, tools and drains touch
    /// its surface from both sides, with friction, and the guard (CCD) tests its moving triangles. During a part of a
    /// step its vertices move along straight lines. A set of convex hulls is a mesh with the faces of all of them.
    /// Meshes, static ones and host surfaces included, do not touch each other, nor a mesh the floor or a
    /// plane. A driven body of capsules that overlaps a driven mesh when one of them is added is held back by it. No node can be
    /// pinned to it, and no hole be made in it. Its kind is VBSS_SCENE_BODY_RIGID, and it counts as one of the scene's
    /// rigid bodies (rigid_capacity) without capsules. The call allocates all memory that steps need for it, and
    /// builds its bounding volume hierarchy, which steps never rebuild or refit.
    ///
    /// @param scene      the scene, of method VBSS_METHOD_IMPLICIT
    /// @param motion     pose, kind of motion, mass and coupling; NULL for the defaults. It has no capsules, and its
    /// friction is not used. The mass is spread evenly over the area of the triangles.
    /// @param geometry   triangles, in the frame of the body, thickness and friction; not NULL, because a mesh needs
    /// triangles. one_sided must be 0.
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: capsules, one_sided, a triangle with a
    /// vertex that does not exist or occurs twice, triangles without area, or an overlap, if the
    /// scene refuses it), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_INCOMPATIBLE (another method),
    /// VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_rigid_mesh(scene: *mut vbss_scene, motion: *const vbss_scene_rigid_config, geometry: *const vbss_scene_static_mesh_config, body: *mut u32) -> vbss_result;
    /// Fills a configuration of a height field with defaults.
    ///
    /// @param config  the struct to fill
    /// @param struct_size  sizeof(*config) in the host's version of the struct
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_height_field_config_init(config: *mut vbss_scene_height_field_config, struct_size: u32) -> vbss_result;
    /// Adds a height field that never moves: a static mesh with two triangles for each cell of the grid. All
    /// that vbss_scene_add_static_mesh says holds for it, and its kind is VBSS_SCENE_BODY_STATIC_MESH. The
    /// triangles of a cell meet on its diagonal from the first corner. Feature 2 n is the triangle of cell n
    /// on the side of the rows, 2 n + 1 that on the side of the columns.
    ///
    /// @param scene      the scene, of method VBSS_METHOD_IMPLICIT
    /// @param config     the configuration; not NULL, because a field needs heights
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: height_count is not the product of
    /// columns and rows, or an overlap, if the scene refuses it), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_height_field(scene: *mut vbss_scene, config: *const vbss_scene_height_field_config, body: *mut u32) -> vbss_result;
    /// Fills a configuration of a distance field with defaults.
    ///
    /// @param config  the struct to fill
    /// @param struct_size  sizeof(*config) in the host's version of the struct
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_distance_field_config_init(config: *mut vbss_scene_distance_field_config, struct_size: u32) -> vbss_result;
    /// Adds the surface of a solid that is given by signed distances at the points of a grid, and never moves.
    /// The call finds the surface on which the trilinear interpolation of the distances is minus half the
    /// thickness, with one vertex for each cell of the grid that the surface passes, and adds it as a static
    /// mesh. All that vbss_scene_add_static_mesh says holds for it, and its kind is
    /// VBSS_SCENE_BODY_STATIC_MESH. The surface is open where it leaves the grid. A surface that passes a cell
    /// more than once is refused, because the grid is too coarse for it. Parts that lie between the points of
    /// the grid are not in the distances, and so not in the surface.
    ///
    /// @param scene      the scene, of method VBSS_METHOD_IMPLICIT
    /// @param config     the configuration; not NULL, because a field needs distances
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: distance_count is not the product
    /// of the counts, no surface, one that passes a cell twice or has more triangles than a static
    /// mesh, or an overlap, if the scene refuses it), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_distance_field(scene: *mut vbss_scene, config: *const vbss_scene_distance_field_config, body: *mut u32) -> vbss_result;
    /// Fills a configuration of a plane with defaults.
    ///
    /// @param config  the struct to fill
    /// @param struct_size  sizeof(*config) in the host's version of the struct
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_plane_config_init(config: *mut vbss_scene_plane_config, struct_size: u32) -> vbss_result;
    /// Adds a plane that never moves. It bounds a half-space, as the floor does, and has the rules of the
    /// floor: nodes of threads, ends of capsules and nodes of drains touch it. Its contacts have the kinds
    /// of those with the floor, and its number as body b. It counts as one of the scene's rigid bodies
    /// (rigid_capacity) without capsules. No node can be pinned to it. A driven body that is in the
    /// half-space when the plane is added is held back by it. vbss_scene_get_rigid reports the contact
    /// force on it.
    ///
    /// @param scene      the scene, of method VBSS_METHOD_IMPLICIT
    /// @param config     the configuration
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: an overlap, if the scene refuses
    /// it), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_plane(scene: *mut vbss_scene, config: *const vbss_scene_plane_config, body: *mut u32) -> vbss_result;
}
