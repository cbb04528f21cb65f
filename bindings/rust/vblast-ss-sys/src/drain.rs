// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Mesh of a drain: a VBSS_DRAIN_MESH_ constant. All meshes are graded toward the slit, and have nodes
/// at its tips and at both marks.
pub type vbss_drain_mesh = i32;

/// Kind of an attachment: a VBSS_DRAIN_ATTACHMENT_ constant.
pub type vbss_drain_attachment_kind = i32;

/// An array of a drain: a VBSS_DRAIN_VIEW_ constant.
pub type vbss_drain_field = i32;

// The constants of vbss_drain_mesh.
/// 137 nodes, 240 triangles.
pub const VBSS_DRAIN_MESH_137: vbss_drain_mesh = 0;
/// 159 nodes, 280 triangles.
pub const VBSS_DRAIN_MESH_159: vbss_drain_mesh = 1;
/// 181 nodes, 320 triangles.
pub const VBSS_DRAIN_MESH_181: vbss_drain_mesh = 2;
/// 225 nodes, 400 triangles: for walls thinner than 0.6 mm.
pub const VBSS_DRAIN_MESH_225: vbss_drain_mesh = 3;

// The constants of vbss_drain_attachment_kind.
/// The node is at `position`.
pub const VBSS_DRAIN_ATTACHMENT_PIN: vbss_drain_attachment_kind = 0;
/// `force` pulls at the node.
pub const VBSS_DRAIN_ATTACHMENT_FORCE: vbss_drain_attachment_kind = 1;
/// A spring from `position` to the node.
pub const VBSS_DRAIN_ATTACHMENT_SPRING: vbss_drain_attachment_kind = 2;

// The constants of vbss_drain_field. n nodes, m triangles.
/// n x 3 doubles, m, on the middle surface.
pub const VBSS_DRAIN_VIEW_POSITIONS: vbss_drain_field = 0;
/// n x 3 doubles, m/s.
pub const VBSS_DRAIN_VIEW_VELOCITIES: vbss_drain_field = 1;
/// n x 3 doubles, m, in the drain's frame.
pub const VBSS_DRAIN_VIEW_REST_POSITIONS: vbss_drain_field = 2;
/// m x 3 uint32_t, nodes counter-clockwise seen from outside.
pub const VBSS_DRAIN_VIEW_TRIANGLES: vbss_drain_field = 3;
/// uint32_t: nodes of the slit's edge on the left (-z), with both tips, along x.
pub const VBSS_DRAIN_VIEW_SLIT_LEFT: vbss_drain_field = 4;
/// uint32_t: nodes of the slit's edge on the right (+z), with both tips, along x.
pub const VBSS_DRAIN_VIEW_SLIT_RIGHT: vbss_drain_field = 5;
/// uint32_t: nodes of the bottom strip; method VBLAST: none.
pub const VBSS_DRAIN_VIEW_ANCHORS: vbss_drain_field = 6;
/// 3 doubles for each of VBSS_DRAIN_VIEW_ANCHORS, N: the force of the anchor on the drain; zero once it is
/// torn off.
pub const VBSS_DRAIN_VIEW_ANCHOR_FORCES: vbss_drain_field = 7;
/// m x 3 doubles: strains of the middle surface along and across the triangle's first side, and shear
/// (2 e12). Method VBLAST reports strains and curvatures too, although it does not resist them.
pub const VBSS_DRAIN_VIEW_STRAINS: vbss_drain_field = 8;
/// m x 3 doubles, 1/m: changes of curvature along and across the triangle's first side, and
/// twist (2 k12).
pub const VBSS_DRAIN_VIEW_CURVATURES: vbss_drain_field = 9;

/// A drain.
#[repr(C)]
pub struct vbss_drain {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// A triangulated sheet or tube, which a drain may be in place of the tube with a slit: a pad of skin, a
/// vessel, a bowel. Fill it with vbss_drain_surface_init, then set the arrays. The library copies them
/// when the drain is created.
///
/// The triangles are those of the middle surface at rest, without stress. Each edge belongs to one
/// triangle (a free edge) or to two, which list it in opposite directions; where triangles meet in their
/// interior, more than three meet at a node.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_surface {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of nodes, 3 to 2048.
    pub node_count: u32,
    /// Number of triangles, 1 to 4096.
    pub triangle_count: u32,
    /// Number of anchored nodes, 0 to node_count; default 0.
    pub anchor_count: u32,
    /// node_count x 3: positions of the nodes at rest, in the drain's frame, m, each at most 1 in
    /// magnitude.
    pub positions: *const f64,
    /// triangle_count x 3: nodes of each triangle, counter-clockwise seen from outside. Needles enter
    /// from either side.
    pub triangles: *const u32,
    /// anchor_count: nodes that are glued to their place at rest, each once; NULL if there are none.
    /// They tear off above vbss_drain_config::tear_stress.
    pub anchors: *const u32,
    /// triangle_count: thickness of the wall that stiffness and mass of each triangle have, m, 1e-6 to
    /// 0.1; NULL (default): vbss_drain_config::thickness. Contacts use that one thickness everywhere.
    pub thickness: *const f64,
    /// triangle_count: Young's modulus of each triangle, Pa, 1e3 to 1e12; NULL (default):
    /// vbss_drain_config::young_modulus.
    pub young_modulus: *const f64,
}

/// Configuration of a drain. Fill it with vbss_drain_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Method; default VBSS_METHOD_IMPLICIT.
    pub method: vbss_method,
    /// Method IMPLICIT: mesh; default VBSS_DRAIN_MESH_137.
    pub mesh: vbss_drain_mesh,
    /// Method IMPLICIT: divisions of each cell in each direction, 1 to 4; default 1.
    pub mesh_divisions: u32,
    /// Largest number of attachments, 0 to 256; default 8.
    pub attachment_capacity: u32,
    /// Method IMPLICIT: largest number of linearisations in a step, 1 to 50; default 1. A step with a larger
    /// limit stops at position_tolerance; this serves reference solutions.
    pub iteration_limit: u32,
    /// Method IMPLICIT: how often a step may be halved, 0 to 10; default 4.
    pub halving_limit: u32,
    /// Zero.
    pub reserved: u32,
    /// Radius of the middle surface, m, 1e-4 to 1; default 6.5e-3.
    pub radius: f64,
    /// Length of the tube, m, 2 to 7 radii; default 32e-3.
    pub length: f64,
    /// Thickness of the wall, m, 0.01 to 0.3 radii, or with a surface 1e-6 to 0.1; default 1e-3.
    pub thickness: f64,
    /// Length of the slit, m, one radius to 0.7 lengths; default 10e-3.
    pub slit_length: f64,
    /// Width of the slit at its middle, along the surface, m, 0 to 0.4 slit lengths and one radius; default
    /// 3e-3.
    pub slit_opening: f64,
    /// Arc from the middle of the slit to each mark, along the surface before the slit was opened, m. It is
    /// longer than half the opening and lies between 20 and 90 degrees. Default 4.5e-3.
    pub mark_arc: f64,
    /// Method IMPLICIT: Young's modulus, Pa, 1e3 to 1e12; default 1.2e6 (not verified for real
    /// drains).
    pub young_modulus: f64,
    /// Method IMPLICIT: Poisson's ratio, 0 to 0.49; default 0.47.
    pub poisson_ratio: f64,
    /// Density, kg/m^3, 1 to 1e5; default 950.
    pub density: f64,
    /// Drag coefficient, 1/s, 0 to 1e6; default 20. The force is -drag * mass * velocity.
    pub drag: f64,
    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
    /// because the rest shape is that of a drain that lies on its block.
    pub gravity: [f64; 3],
    /// Origin of the drain's frame in the world, m, each at most 1e3; default 0.
    pub position: [f64; 3],
    /// Quaternion (w, x, y, z) of any length from 1e-100 to 1e100; default (1, 0, 0, 0).
    pub orientation: [f64; 4],
    /// Method IMPLICIT: strength of the glue of the strip, Pa, 1 to 1e12; default 5e4 (not verified). The anchor
    /// of a node tears off permanently above this stress times the node's area of the strip. Each step tears
    /// off at most one anchor: the one with the largest overload.
    pub tear_stress: f64,
    /// Method IMPLICIT: largest increment of the last linearisation, m, 1e-15 to 1; default 1e-6.
    pub position_tolerance: f64,
    /// Method IMPLICIT: a step in which a node would move farther than this gets one more linearisation. A step
    /// in which it would move four times as far is halved. m, 1e-9 to 1; default 1e-3.
    pub move_limit: f64,
    /// Method VBLAST: its parameters; NULL (default): their defaults. The library copies them.
    pub baseline: *const vbss_baseline_config,
    /// In a scene: coefficient of friction with threads, 0 to 10. Friction with other bodies, the floor and
    /// the drain itself uses the geometric mean of both coefficients. Default 0.3 (not verified).
    pub friction: f64,
    /// Force along the direction of a tip at which it enters a wall, N, 1e-3 to 1e3; default 1 (the
    /// published range for both walls of a Penrose drain is 0.85 to 2.92).
    pub puncture_force: f64,
    /// Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25 (not verified).
    pub hole_force: f64,
    /// Coefficient of the additional friction from the force across the suture, 0 to 10; default 0.3 (not
    /// verified).
    pub hole_friction: f64,
    /// Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7; default 2e4.
    pub hole_stiffness: f64,
    /// Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05.
    pub hole_damping: f64,
    /// Length of a tip's path through the wall over which the force against its advance falls from puncture_force
    /// to hole_force, and that against drawing it back grows from 0 to hole_force; m, 0 to 0.1; default 0.5e-3.
    pub tip_length: f64,
    /// Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02 (not verified). A tight
    /// thread has capstan friction: docs/explanation/stitch.md.
    pub thread_force: f64,
    /// Method IMPLICIT: sheet or tube in place of the tube with a slit; NULL (default): that tube. With a
    /// surface the fields mesh, mesh_divisions, radius, length, slit_length, slit_opening and mark_arc have
    /// no meaning, and the drain has neither marks nor a slit. The library copies the surface.
    pub surface: *const vbss_drain_surface,
    /// In a scene, method IMPLICIT: energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads
    /// do not tear the wall at their holes. With it, a thread cuts through the wall when the force across
    /// it in the plane of the wall exceeds this energy times the thickness (of the triangle, where the surface
    /// states it): docs/explanation/tearing.md has published values. The mesh stays whole: the cut behind
    /// the thread is not opened.
    pub tear_energy: f64,
}

/// An attachment acts on one node. Fill it with vbss_drain_attachment_init.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_attachment {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Kind; default VBSS_DRAIN_ATTACHMENT_PIN.
    pub kind: vbss_drain_attachment_kind,
    /// Node, which is not anchored.
    pub node: u32,
    /// Zero.
    pub reserved: u32,
    /// PIN: target of the node in the next step; SPRING: its fixed end; m, each coordinate at most
    /// 1e3 in magnitude.
    pub position: [f64; 3],
    /// FORCE: force, N, each component at most 1e6 in magnitude.
    pub force: [f64; 3],
    /// SPRING: stiffness, N/m, 0 to 1e9.
    pub stiffness: f64,
}

/// Places on a drain, as nodes.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_places {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Number of nodes of the mesh.
    pub node_count: u32,
    /// Number of triangles of the mesh.
    pub triangle_count: u32,
    /// The marks, left and right.
    pub marks: [u32; 2],
    /// The middles of the slit's edges, left and right, which are the paper's points.
    pub gap_points: [u32; 2],
    /// Zero.
    pub reserved: u32,
}

/// Opening of the slit.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_gap {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Index of the opposite nodes that `largest` is between, along x.
    pub largest_pair: u32,
    /// Distance between the middles of the edges, m: the paper's measure.
    pub gap: f64,
    /// Largest distance between opposite nodes of the edges, m.
    pub largest: f64,
    /// Component of the vector between the middles, left to right, along that vector at rest, which moves
    /// with the drain's frame, m. It is negative when the edges have crossed.
    pub signed_gap: f64,
    /// Distance between the lips at the middles of the edges, m, measured between the lines
    /// through the wall there. At rest it is about the gap. Where lips meet it is 0 to a fifth of
    /// the wall's thickness, for any rotation of the lips. Raised lips meet with their inner
    /// corners or face to face, while `gap` is up to a whole wall. The opening is 0 (shut) where
    /// one lip lies on the other. Method VBLAST measures it in the same manner.
    pub opening: f64,
    /// Largest opening between opposite nodes of the edges, m.
    pub widest_opening: f64,
    /// End points of `opening`, left and right, m.
    pub lips: [[f64; 3]; 2],
}

/// Energies of a drain, J.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_energies {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Kinetic energy of the lumped masses.
    pub kinetic: f64,
    /// Elastic energy of stretching; method VBLAST: zero.
    pub membrane: f64,
    /// Elastic energy of bending; method VBLAST: zero.
    pub bending: f64,
    /// Energy of SPRING attachments; method VBLAST: also of the springs to the rest positions.
    pub springs: f64,
    /// Potential, zero at the origin.
    pub gravity: f64,
    /// Sum of the energies.
    pub total: f64,
}

/// Counters since creation, and results of the last step.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_drain_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Anchors that have torn off.
    pub torn: u32,
    /// Triangles that are inverted or collapsed at present.
    pub inverted: u32,
    /// Zero.
    pub reserved: u32,
    /// Calls of vbss_drain_step that succeeded, and steps of its scene.
    pub steps: u64,
    /// Accepted parts of steps, equal to `steps` if none was halved; method VBLAST: explicit
    /// steps.
    pub parts: u64,
    /// Linearisations assembled and solved.
    pub linearisations: u64,
    /// Corrections that were not small against the increment, and were left out.
    pub corrections_dropped: u64,
    /// Parts that moved a node beyond four move_limits at the last halving.
    pub forced: u64,
    /// Largest displacement of a node in a part of the last step, m.
    pub last_move: f64,
    /// Largest displacement by the last correction of the last part, m: the remaining error is smaller.
    pub last_correction: f64,
    /// Simulated time, s.
    pub time: f64,
    /// New matrices: a linearisation keeps the matrix of an earlier one while no node is farther than
    /// 0.05 move_limit from where it was then. Method VBLAST: zero.
    pub matrices: u64,
}

extern "C" {
    /// Fills a drain configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_drain_config_init(config: *mut vbss_drain_config, struct_size: u32) -> vbss_result;
    /// Fills a surface with the defaults: no nodes, and NULL for all arrays.
    ///
    /// @param surface  the surface to fill
    /// @param struct_size   `sizeof *surface` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_drain_surface_init(surface: *mut vbss_drain_surface, struct_size: u32) -> vbss_result;
    /// Creates a drain at rest.
    ///
    /// @param context     owner
    /// @param config      the configuration; NULL for the defaults
    /// @param drain  the new drain; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (a field, or a surface that does not meet
    /// the rules of vbss_drain_surface), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_INCOMPATIBLE (a surface
    /// with method VBLAST), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_create(context: *mut vbss_context, config: *const vbss_drain_config, drain: *mut *mut vbss_drain) -> vbss_result;
    /// Destroys a drain.
    ///
    /// @param drain  the drain; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_destroy(drain: *mut vbss_drain) -> vbss_result;
    /// Destroys a drain now, or when it leaves the scene that it belongs to: on vbss_scene_remove and on
    /// vbss_scene_destroy. Until then the handle is valid. A host that has discarded all bodies of a
    /// scene needs to destroy only the scene.
    ///
    /// @param drain  the drain; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_discard(drain: *mut vbss_drain) -> vbss_result;
    /// Advances a drain by one step. The call allocates nothing. If the new state is not finite, the
    /// call fails and the drain keeps its state from before the step. With method VBLAST the call also
    /// fails if a node is farther from its rest position than 100 times the length of the drain plus the
    /// largest such distance of an attachment: the explicit steps have diverged, and the error text
    /// states it.
    ///
    /// @param drain  the drain
    /// @param h length of the step, s, 1e-7 to 0.1
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_step(drain: *mut vbss_drain, h: f64) -> vbss_result;
    /// Sets positions and velocities of the nodes. Anchored nodes that have not torn off must keep their
    /// position and have no velocity.
    ///
    /// @param drain       the drain
    /// @param positions   3 doubles per node, m, each at most 1e3 in magnitude; NULL keeps them
    /// @param velocities  3 doubles per node, m/s, each at most 1e5 in magnitude; NULL keeps them
    /// @param node_count  number of nodes in the arrays, equal to the drain's
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_IN_USE (an anchored node would move) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_set_state(drain: *mut vbss_drain, positions: *const f64, velocities: *const f64, node_count: u32) -> vbss_result;
    /// Fills an attachment with the defaults.
    ///
    /// @param attachment  the attachment to fill
    /// @param struct_size      `sizeof *attachment` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_drain_attachment_init(attachment: *mut vbss_drain_attachment, struct_size: u32) -> vbss_result;
    /// Attaches something to a node. A node takes one PIN, and any number of the others. All fields must be in
    /// their ranges, also those that the kind does not read.
    ///
    /// @param drain       the drain
    /// @param attachment  the attachment
    /// @param id     identifier of the attachment, from 1 on, never reused in this drain
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_IN_USE (the node is pinned
    /// or anchored already), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_attach(drain: *mut vbss_drain, attachment: *const vbss_drain_attachment, id: *mut u32) -> vbss_result;
    /// Sets the target of an attachment for the end of the next step. A PIN, or the end of a SPRING,
    /// moves there at constant velocity during the step, and then stays.
    ///
    /// @param drain   the drain
    /// @param id      the attachment
    /// @param target  PIN, SPRING: position, m; FORCE: the force, N, which changes at once
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such attachment), VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_set_attachment_target(drain: *mut vbss_drain, id: u32, target: *const f64) -> vbss_result;
    /// Removes an attachment.
    ///
    /// @param drain  the drain
    /// @param id     the attachment
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such attachment) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_detach(drain: *mut vbss_drain, id: u32) -> vbss_result;
    /// Returns the force of an attachment on the drain at the end of the last step; zero before its first step.
    ///
    /// @param drain       the drain
    /// @param id          the attachment
    /// @param force  receives the force, N
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_NOT_FOUND (no
    /// such attachment)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_reaction(drain: *mut vbss_drain, id: u32, force: *mut f64) -> vbss_result;
    /// Returns the nodes of the marks and of the points between which the gap is measured.
    ///
    /// @param drain        the drain
    /// @param places  receives the numbers
    /// @param struct_size  `sizeof *places` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_places(drain: *mut vbss_drain, places: *mut vbss_drain_places, struct_size: u32) -> vbss_result;
    /// Returns the opening of the slit.
    ///
    /// @param drain        the drain
    /// @param gap     receives the numbers
    /// @param struct_size  `sizeof *gap` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_INCOMPATIBLE (a drain with a surface, which has no slit)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_gap(drain: *mut vbss_drain, gap: *mut vbss_drain_gap, struct_size: u32) -> vbss_result;
    /// Returns a view of one of the drain's arrays.
    ///
    /// @param drain        the drain
    /// @param field        the array
    /// @param view    receives the address and the shape of the array
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_view(drain: *mut vbss_drain, field: vbss_drain_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns the drain's energies.
    ///
    /// @param drain          the drain
    /// @param energies  receives the numbers
    /// @param struct_size    `sizeof *energies` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_energies(drain: *mut vbss_drain, energies: *mut vbss_drain_energies, struct_size: u32) -> vbss_result;
    /// Returns the drain's counters.
    ///
    /// @param drain            the drain
    /// @param statistics  receives the numbers
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_statistics(drain: *mut vbss_drain, statistics: *mut vbss_drain_statistics, struct_size: u32) -> vbss_result;
    /// Saves the drain's state. A drain that restores it continues with identical bits, on any machine.
    ///
    /// @param drain         the drain
    /// @param bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of the buffer
    /// @param written  bytes of the state, also when it does not fit
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_save(drain: *mut vbss_drain, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a saved state into this drain or an equally configured one. On failure the drain is
    /// unchanged.
    ///
    /// @param drain  the drain
    /// @param bytes  the state
    /// @param count  its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
    /// or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_restore(drain: *mut vbss_drain, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns the XXH64 of the drain's state, its counters included; equal states have equal hashes on
    /// every machine.
    ///
    /// @param drain      the drain
    /// @param hash  the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_drain_get_hash(drain: *mut vbss_drain, hash: *mut u64) -> vbss_result;
}
