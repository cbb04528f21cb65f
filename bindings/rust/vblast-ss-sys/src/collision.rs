// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// How continuous tests decide: a VBSS_COLLISION_METHOD_ constant.
pub type vbss_collision_method = i32;

/// Kinds of the two features of a continuous test: a VBSS_COLLISION_PAIR_ constant.
pub type vbss_collision_pair_kind = i32;

/// Evidence for an answer: a VBSS_COLLISION_DECISION_ constant.
pub type vbss_collision_decision = i32;

/// An array of a collision object: a VBSS_COLLISION_VIEW_ constant.
pub type vbss_collision_field = i32;

/// Direction and depth of the paper's response: a VBSS_COLLISION_RESPONSE_ constant.
pub type vbss_collision_response_variant = i32;

// The constants of vbss_collision_method.
/// Directional conservative advancement, the default: never misses. For D = 0, hits and misses are
/// exact.
pub const VBSS_COLLISION_METHOD_CONSERVATIVE: vbss_collision_method = 0;
/// The usual method: roots of the coplanarity cubic, an inside test at each root, and the distance at
/// the end. May miss.
pub const VBSS_COLLISION_METHOD_CUBIC: vbss_collision_method = 1;
/// Algorithm 1 of VBLaST-SS (Qi et al. 2017): distance at the end, then a sign test and a linear time
/// of impact. Often misses.
pub const VBSS_COLLISION_METHOD_VBLAST: vbss_collision_method = 2;

// The constants of vbss_collision_pair_kind, with their four vertices.
/// a0, a1 of edge a, then b0, b1 of edge b.
pub const VBSS_COLLISION_PAIR_EDGE_EDGE: vbss_collision_pair_kind = 0;
/// The point (a), then b0, b1, b2 of the triangle.
pub const VBSS_COLLISION_PAIR_POINT_TRIANGLE: vbss_collision_pair_kind = 1;

// The constants of vbss_collision_decision.
/// Miss: planes that separate the features by more than D at all times. Hit: at `time` the
/// distance is at most D plus the tolerance.
pub const VBSS_COLLISION_DECISION_PROVED: vbss_collision_decision = 0;
/// D = 0: true for the given numbers, without any tolerance.
pub const VBSS_COLLISION_DECISION_EXACT: vbss_collision_decision = 1;
/// Neither could be shown, so the answer is a hit. D > 0: the test reached pass_limit, or no direction
/// was exact enough, which takes a D below about 1e-8 of the size. D = 0: the bits of the coordinates
/// spread over more binary places than there is memory for. A call without an object has memory for
/// about 250 places; with an object, all doubles tried so far have fitted.
pub const VBSS_COLLISION_DECISION_UNDECIDED: vbss_collision_decision = 2;
/// CUBIC and VBLAST: not proved.
pub const VBSS_COLLISION_DECISION_CLAIMED: vbss_collision_decision = 3;

// The constants of vbss_collision_field.
/// x 5 uint32_t: vbss_collision_pair_kind, shape and feature a, shape and feature b. A feature is an edge, a
/// point (node) or a triangle. Sorted by these five numbers.
pub const VBSS_COLLISION_VIEW_CANDIDATES: vbss_collision_field = 0;
/// uint32_t: index of the candidate, ascending.
pub const VBSS_COLLISION_VIEW_IMPACTS: vbss_collision_field = 1;
/// vbss_collision_impact.time.
pub const VBSS_COLLISION_VIEW_TIMES: vbss_collision_field = 2;
/// x 3: vbss_collision_impact.normal.
pub const VBSS_COLLISION_VIEW_NORMALS: vbss_collision_field = 3;
/// x 4: vbss_collision_impact.weights.
pub const VBSS_COLLISION_VIEW_WEIGHTS: vbss_collision_field = 4;
/// uint32_t: vbss_collision_impact.decision.
pub const VBSS_COLLISION_VIEW_DECISIONS: vbss_collision_field = 5;
/// vbss_collision_impact.distance, m.
pub const VBSS_COLLISION_VIEW_DISTANCES: vbss_collision_field = 6;

// The constants of vbss_collision_response_variant.
/// Algorithm 2 as printed: along the shortest vector at the end of the step.
pub const VBSS_COLLISION_RESPONSE_END_OF_STEP: vbss_collision_response_variant = 0;
/// Along the normal at the time of impact, by D: the features are then D apart in the positions of that
/// time.
pub const VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT: vbss_collision_response_variant = 1;

/// Shapes, their candidates and impacts, batches, counters.
#[repr(C)]
pub struct vbss_collision {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Two closest points.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_collision_closest {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Distance, m; minus the penetration depth for capsules that overlap.
    pub distance: f64,
    /// Unit vector from a to b; zero if undefined (axes that meet).
    pub normal: [f64; 3],
    /// On a, m.
    pub point_a: [f64; 3],
    /// On b, m.
    pub point_b: [f64; 3],
    /// Weights of the vertices of a, or of its axis, that give point_a.
    pub weights_a: [f64; 3],
    /// Weights of the vertices of b, or of its axis, that give point_b.
    pub weights_b: [f64; 3],
}

/// Result of a continuous test.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_collision_impact {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: they come within D; 0: they do not.
    pub hit: i32,
    /// Evidence for `hit`.
    pub decision: vbss_collision_decision,
    /// CONSERVATIVE: evaluations of the closest points; else of roots.
    pub passes: u32,
    /// Hit: 0 to 1; with CONSERVATIVE there is no contact before. PROVED: at `time` the features are within
    /// D plus the tolerance. EXACT: `time` is as near to the first contact as the advancement came.
    /// `distance` says how near: about 1e-14 of the size, but more where features graze. Miss: 1.
    pub time: f64,
    /// Hit: distance of the features at `time`, m; CUBIC and VBLAST: distance of the assumed points of
    /// contact. Miss: 0.
    pub distance: f64,
    /// Hit: unit vector from a to b, or zero if none is known. Miss: 0.
    pub normal: [f64; 3],
    /// Hit: weights of the four vertices, sum 1 on either feature. Miss: 0.
    pub weights: [f64; 4],
    /// Hit: point on a at `time`, m. Miss: 0.
    pub point_a: [f64; 3],
    /// Hit: point on b at `time`, m. Miss: 0.
    pub point_b: [f64; 3],
}

/// Method of the tests, and capacities. Fill it with vbss_collision_config_init.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_collision_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Default VBSS_COLLISION_METHOD_CONSERVATIVE.
    pub method: vbss_collision_method,
    /// Contact distance D, m: 0, or 1e-30 to 1e30; default 0. Between shapes their radii are added.
    pub thickness: f64,
    /// Share of D, 1e-12 to 1; default 1e-3. A test may report a hit for features that only come within
    /// D (1 + tolerance). Rounding sets a lower limit: docs/explanation/collision.md. No effect on the answer when
    /// D = 0.
    pub tolerance: f64,
    /// CONSERVATIVE: passes before a test gives up and reports a hit, 1 to 1000000; default 10000. Most
    /// tests take one or two; edges that turn about each other just above D take hundreds. With D = 0 a test
    /// makes at most 256. The limit does not apply to exact decisions. They take about 10 us, milliseconds
    /// where bits spread over hundreds of binary places, and up to a second with subnormal numbers beside
    /// 1.
    pub pass_limit: u32,
    /// Largest number of shapes ever added, 0 to 65536; default 16.
    pub shape_capacity: u32,
    /// Largest number of candidates, 0 to 1e8; default 16384.
    pub pair_capacity: u32,
    /// Largest number of impacts, 0 to 1e8; default 4096.
    pub impact_capacity: u32,
    /// Excludes two segments of one chain from the candidates if the arc between their nearest ends is
    /// shorter than `exclusion` times the D of the pair; 0 to 1e3. Neighbours are always excluded. Default
    /// 1.6: a tube bent until it touches itself needs pi/2.
    pub exclusion: f64,
    /// Added to D in the search for candidates, m, 0 to 1e3; default 0.
    pub margin: f64,
    /// VBLAST: its parameters; NULL (default): their defaults. The library copies them.
    pub baseline: *const vbss_baseline_config,
}

/// Questions in rows, answers in rows. Fill it with vbss_collision_batch_init.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_collision_batch {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Kinds of the features of all questions.
    pub kind: vbss_collision_pair_kind,
    /// Questions, at most 1e8.
    pub count: u32,
    /// Elements from one row to the next in every array, at least count.
    pub stride: u32,
    /// Positions at time 0, m. 12 rows: x of vertex 0 of every question, y of vertex 0, z, x of vertex 1,
    /// and so on. No two arrays of a batch overlap.
    pub start: *const f64,
    /// Positions at time 1, m, in rows as for `start`.
    pub end: *const f64,
    /// D of each question, m; NULL: D of the configuration.
    pub thickness: *const f64,
    /// Receives vbss_collision_impact.hit of each question.
    pub hit: *mut i32,
    /// Receives vbss_collision_impact.decision; may be NULL.
    pub decision: *mut i32,
    /// Receives vbss_collision_impact.time; may be NULL.
    pub time: *mut f64,
    /// Receives 3 rows; may be NULL.
    pub normal: *mut f64,
    /// Receives 4 rows; may be NULL.
    pub weights: *mut f64,
}

/// Counters of a collision object since its creation. Searches and tests that fail are not counted.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_collision_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Candidates of the last search.
    pub candidates: u32,
    /// Impacts of the last search.
    pub impacts: u32,
    /// Zero.
    pub reserved: u32,
    /// Continuous tests.
    pub queries: u64,
    /// Continuous tests that were hits.
    pub hits: u64,
    /// Continuous tests that were undecided.
    pub undecided: u64,
    /// Tests that needed exact arithmetic.
    pub exact: u64,
    /// CONSERVATIVE: evaluations of the closest points.
    pub passes: u64,
    /// Pairs of boxes that the searches tested; not part of the state.
    pub boxes_tested: u64,
    /// Searches for candidates.
    pub searches: u64,
}

/// Displacements by the paper's response.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_collision_response {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: the paper leaves this case open, and a rule of docs/explanation/paper-collision.md was used. Examples are no
    /// relative motion along the direction, and features that meet at the end.
    pub completed: i32,
    /// q: unit vector from edge b to edge a, on the side of the start.
    pub direction: [f64; 3],
    /// u: distance to restore along q, m.
    pub depth: f64,
    /// Share of u that a moves along q; b moves -(1 - share_a) u q.
    pub share_a: f64,
    /// Displacements of the four vertices at time 1, m.
    pub displacement: [f64; 12],
}

extern "C" {
    /// Closest points of two segments. Segments of length zero are points.
    ///
    /// @param a             two end points, m
    /// @param b             two end points, m
    /// @param closest  receives points, distance, normal
    /// @param struct_size   `sizeof *closest` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_NOT_FINITE or
    /// VBSS_ERROR_OUT_OF_RANGE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_closest_segments(a: *const f64, b: *const f64, closest: *mut vbss_collision_closest, struct_size: u32) -> vbss_result;
    /// Closest points of a point (a) and a triangle (b). A triangle without area is its edges.
    ///
    /// @param point         m
    /// @param triangle      three corners, m
    /// @param closest  receives points, distance, normal
    /// @param struct_size   `sizeof *closest` as the caller was compiled
    /// @return as vbss_collision_closest_segments
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_closest_point_triangle(point: *const f64, triangle: *const f64, closest: *mut vbss_collision_closest, struct_size: u32) -> vbss_result;
    /// Closest points of a segment (a) and a triangle (b); distance 0 where the segment goes through.
    ///
    /// @param segment       two end points, m
    /// @param triangle      three corners, m
    /// @param closest  receives points, distance, normal
    /// @param struct_size   `sizeof *closest` as the caller was compiled
    /// @return as vbss_collision_closest_segments
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_closest_segment_triangle(segment: *const f64, triangle: *const f64, closest: *mut vbss_collision_closest, struct_size: u32) -> vbss_result;
    /// Closest points of the surfaces of two capsules, on the line between the closest points of their axes.
    /// The distance is negative when they overlap. Where the axes meet there is no such line: the points
    /// are those of the axes and the normal is zero.
    ///
    /// @param a             axis, two end points, m
    /// @param radius_a      m, 0 to 1e30
    /// @param b             axis, two end points, m
    /// @param radius_b      m, 0 to 1e30
    /// @param closest  receives points, distance, normal; weights are those of the axes' points
    /// @param struct_size   `sizeof *closest` as the caller was compiled
    /// @return as vbss_collision_closest_segments
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_closest_capsules(a: *const f64, radius_a: f64, b: *const f64, radius_b: f64, closest: *mut vbss_collision_closest, struct_size: u32) -> vbss_result;
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_config_init(config: *mut vbss_collision_config, struct_size: u32) -> vbss_result;
    /// Tests whether two moving edges come within D of each other. Edges of length zero are points. The test
    /// answers all cases, also parallel and degenerate ones, and needs no object.
    ///
    /// @param config       method, thickness, tolerance; NULL for the defaults. Capacities are not read.
    /// @param start        a0, a1, b0, b1 at time 0, m
    /// @param end          these vertices at time 1, m
    /// @param impact  receives the answer
    /// @param struct_size  `sizeof *impact` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_ARITHMETIC_MODE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_test_edges(config: *const vbss_collision_config, start: *const f64, end: *const f64, impact: *mut vbss_collision_impact, struct_size: u32) -> vbss_result;
    /// Tests whether a moving point and a moving triangle come within D of each other. Needs no object.
    ///
    /// @param config       method, thickness, tolerance; NULL for the defaults. Capacities are not read.
    /// @param start        the point, then the corners b0, b1, b2 at time 0, m
    /// @param end          these vertices at time 1, m
    /// @param impact  receives the answer
    /// @param struct_size  `sizeof *impact` as the caller was compiled
    /// @return as vbss_collision_test_edges
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_test_point_triangle(config: *const vbss_collision_config, start: *const f64, end: *const f64, impact: *mut vbss_collision_impact, struct_size: u32) -> vbss_result;
    /// Computes the paper's response to a hit (algorithm 2): displacements of the four vertices at the
    /// end of the step after which the features are D apart, on the side they came from. With
    /// TIME_OF_IMPACT they are D apart in the positions of that time, and at the end nearer by their
    /// approach since then. Weights and inverse masses distribute the shift of the contact point over
    /// the two vertices of an edge, or the three of a triangle. docs/explanation/paper-collision.md has the source,
    /// the signs, and the rules for cases that the paper leaves open.
    ///
    /// @param kind            kinds of the features
    /// @param variant         as printed, or at the time of impact
    /// @param impact          the hit, as reported by a test of the same vertices. TIME_OF_IMPACT needs it.
    /// END_OF_STEP uses its normal if there is no other; NULL is allowed
    /// @param start           four vertices at time 0, m
    /// @param end             four vertices at time 1, m
    /// @param thickness       D, m, 0 to 1e30
    /// @param inverse_masses  one for each vertex, 1/kg, 0 to 1e30; 0 for a vertex that cannot move. If no
    /// vertex of a feature can move, the other feature takes the whole correction. At
    /// least one inverse mass is above 0.
    /// @param response   receives the displacements
    /// @param struct_size     `sizeof *response` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
    /// VBSS_ERROR_NOT_FINITE or VBSS_ERROR_OUT_OF_RANGE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_get_vblast_response(kind: vbss_collision_pair_kind, variant: vbss_collision_response_variant, impact: *const vbss_collision_impact, start: *const f64, end: *const f64, thickness: f64, inverse_masses: *const f64, response: *mut vbss_collision_response, struct_size: u32) -> vbss_result;
    /// Creates a collision object without shapes.
    ///
    /// @param context         owner
    /// @param config          the configuration; NULL for the defaults
    /// @param collision  the new object; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_create(context: *mut vbss_context, config: *const vbss_collision_config, collision: *mut *mut vbss_collision) -> vbss_result;
    /// Destroys a collision object with its shapes.
    ///
    /// @param collision  the object; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_destroy(collision: *mut vbss_collision) -> vbss_result;
    /// Runs one test with the method and the thickness of the object, and counts it in the statistics.
    ///
    /// @param collision    the object
    /// @param kind         kinds of the features
    /// @param start        four vertices at time 0, m
    /// @param end          four vertices at time 1, m
    /// @param impact  receives the answer
    /// @param struct_size  `sizeof *impact` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_ARITHMETIC_MODE or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_test(collision: *mut vbss_collision, kind: vbss_collision_pair_kind, start: *const f64, end: *const f64, impact: *mut vbss_collision_impact, struct_size: u32) -> vbss_result;
    /// Fills a batch with the defaults: no questions.
    ///
    /// @param batch   the batch to fill
    /// @param struct_size  `sizeof *batch` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_collision_batch_init(batch: *mut vbss_collision_batch, struct_size: u32) -> vbss_result;
    /// Runs many tests, four at a time. The answers have the bits of vbss_collision_test. The call
    /// allocates nothing.
    ///
    /// @param collision  the object: method, tolerance, counters
    /// @param batch      questions, and arrays for the answers
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on failure no answer is written
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_test_batch(collision: *mut vbss_collision, batch: *const vbss_collision_batch) -> vbss_result;
    /// Adds a chain of capsules, such as a thread: node_count nodes, edge i joins the nodes i and i + 1.
    /// The call clears candidates and impacts, as with any new shape. It allocates. The nodes are at the origin
    /// until vbss_collision_set_motion.
    ///
    /// @param collision     the object
    /// @param node_count    2 to 65537
    /// @param rest_lengths  rest lengths of the node_count - 1 edges, m, 0 to 1e30, which the call copies.
    /// `exclusion` measures the arc by them. NULL excludes neighbours only.
    /// @param radius        m, 0 or 1e-30 to 1e29
    /// @param shape    identifier of the shape, from 0 on, never reused in this object
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_add_chain(collision: *mut vbss_collision, node_count: u32, rest_lengths: *const f64, radius: f64, shape: *mut u32) -> vbss_result;
    /// Adds capsules that move independently and collide with each other: edge i joins the nodes 2 i and
    /// 2 i + 1. The call allocates. The nodes are at the origin until vbss_collision_set_motion.
    ///
    /// @param collision      the object
    /// @param capsule_count  1 to 32768
    /// @param radius         radius of all capsules, m, 0 or 1e-30 to 1e29
    /// @param shape     identifier of the shape, from 0 on, never reused in this object
    /// @return as vbss_collision_add_chain
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_add_capsules(collision: *mut vbss_collision, capsule_count: u32, radius: f64, shape: *mut u32) -> vbss_result;
    /// Adds a triangle mesh, open or closed. Its edges are those of its triangles, each once, sorted by
    /// their two nodes. Features that share a node are never candidates. The call allocates. The nodes are
    /// at the origin until vbss_collision_set_motion.
    ///
    /// @param collision       the object
    /// @param node_count      3 to 65536
    /// @param triangles       three different nodes each
    /// @param triangle_count  1 to 131072
    /// @param radius          half the thickness of the sheet, m, 0 or 1e-30 to 1e29
    /// @param shape      identifier of the shape, from 0 on, never reused in this object
    /// @return as vbss_collision_add_chain
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_add_mesh(collision: *mut vbss_collision, node_count: u32, triangles: *const u32, triangle_count: u32, radius: f64, shape: *mut u32) -> vbss_result;
    /// Removes a shape; the others keep their identifiers. The call clears candidates and impacts.
    ///
    /// @param collision  the object
    /// @param shape identifier of the shape
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such shape) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_remove(collision: *mut vbss_collision, shape: u32) -> vbss_result;
    /// Sets the category and the mask of a shape. The search pairs two shapes if each one's category has a bit
    /// in the other's mask. A shape is also paired with itself by this rule: without a common bit, a thread or
    /// a mesh does not collide with itself. The call clears candidates and impacts.
    ///
    /// @param collision  the object
    /// @param shape identifier of the shape
    /// @param category   bits; 1 when the shape was added
    /// @param mask       bits; all when the shape was added
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such shape) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_set_filter(collision: *mut vbss_collision, shape: u32, category: u32, mask: u32) -> vbss_result;
    /// Sets the motion of a shape for the next searches. The call clears candidates and impacts.
    ///
    /// @param collision   the object
    /// @param shape identifier of the shape
    /// @param start       3 doubles per node at time 0, m; NULL: the end of the last move
    /// @param end         3 doubles per node at time 1, m
    /// @param node_count  number of nodes in the arrays, equal to the shape's
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such shape), VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_set_motion(collision: *mut vbss_collision, shape: u32, start: *const f64, end: *const f64, node_count: u32) -> vbss_result;
    /// Lists the pairs of features whose boxes overlap. Boxes are swept over the motion, and inflated by
    /// the radii, `thickness`, the tolerance and `margin`. Pairs are edges with edges, and points with
    /// triangles where a mesh takes part: points of chains, capsules and other meshes, and of the mesh
    /// itself. The list is complete and depends on the positions alone, not on earlier searches. The
    /// call allocates nothing. The call clears the impacts.
    ///
    /// @param collision  the object
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (pair_capacity: there are no
    /// candidates then), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_find_candidates(collision: *mut vbss_collision) -> vbss_result;
    /// Tests all candidates of the last search; the hits are the impacts. The call allocates nothing.
    /// The tests see edges with edges and points with triangles only. They report no impact for a
    /// feature that went through a triangle earlier, is not near its edges, and has no point near its
    /// inside.
    ///
    /// @param collision  the object
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (impact_capacity: there are no
    /// impacts then), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_find_impacts(collision: *mut vbss_collision) -> vbss_result;
    /// Returns a view of the candidates or the impacts.
    ///
    /// @param collision    the object
    /// @param field        the array
    /// @param view    receives the address and the shape of the array
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_get_view(collision: *mut vbss_collision, field: vbss_collision_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns the nodes of an edge of a shape.
    ///
    /// @param collision   the object
    /// @param shape identifier of the shape
    /// @param edge index of the edge, as in candidates
    /// @param nodes  receives two nodes
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such shape) or VBSS_ERROR_OUT_OF_RANGE (no such edge)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_get_edge(collision: *mut vbss_collision, shape: u32, edge: u32, nodes: *mut u32) -> vbss_result;
    /// Returns the object's counters.
    ///
    /// @param collision        the object
    /// @param statistics  receives the numbers
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_get_statistics(collision: *mut vbss_collision, statistics: *mut vbss_collision_statistics, struct_size: u32) -> vbss_result;
    /// Returns what method VBLAST counts in a collision object.
    ///
    /// @param collision       the object
    /// @param statistics  receives the counters
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INCOMPATIBLE if the object uses another method, VBSS_ERROR_INVALID_HANDLE,
    /// VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_get_baseline_statistics(collision: *mut vbss_collision, statistics: *mut vbss_baseline_statistics, struct_size: u32) -> vbss_result;
    /// Saves the state: shapes, their motion, counters. Candidates and impacts are not saved; search again.
    ///
    /// @param collision     the object
    /// @param bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of the buffer
    /// @param written  bytes of the state, also when it does not fit
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_save(collision: *mut vbss_collision, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a saved state into this object or an equally configured one, with the same shapes added
    /// and removed. On failure the object is unchanged. The call clears candidates and impacts.
    ///
    /// @param collision  the object
    /// @param bytes      the state
    /// @param count      its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_restore(collision: *mut vbss_collision, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns a hash of the whole state; equal states have equal hashes on every machine.
    ///
    /// @param collision  the object
    /// @param hash  receives the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_collision_get_hash(collision: *mut vbss_collision, hash: *mut u64) -> vbss_result;
}
