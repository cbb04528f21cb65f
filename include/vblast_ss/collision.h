/**
 * @file collision.h
 * @brief Closest points, continuous collision tests, and the search for candidate pairs.
 *
 * There are three interfaces, each usable alone:
 * - pure functions for one question: #vbss_collision_closest_segments and its kin, #vbss_collision_test_edges,
 *   #vbss_collision_test_point_triangle;
 * - batches of questions in rows: #vbss_collision_test_batch;
 * - shapes (chains, capsules, triangle meshes) that move: #vbss_collision_set_motion, then
 *   #vbss_collision_find_candidates, then #vbss_collision_find_impacts.
 *
 * A continuous test asks whether two features, whose vertices move evenly from their start to their end
 * positions from time 0 to time 1, come within the contact distance D of each other. With
 * VBSS_COLLISION_METHOD_CONSERVATIVE a miss is a proof, rounding included: docs/explanation/collision.md.
 *
 * Coordinates are at most 1e30 in magnitude; D is zero or from 1e-30 to 1e30. Lengths are in m, but
 * only the default unit of the paper's method depends on it.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_COLLISION_H
#define VBLAST_SS_COLLISION_H

#include <vblast_ss/base.h>
#include <vblast_ss/baseline.h>

/** Shapes, their candidates and impacts, batches, counters. */
typedef struct vbss_collision vbss_collision;

/** How continuous tests decide: a VBSS_COLLISION_METHOD_ constant. */
typedef int32_t vbss_collision_method;

/** The constants of #vbss_collision_method. */
enum {
    /** Directional conservative advancement, the default: never misses. For D = 0, hits and misses are
     * exact. */
    VBSS_COLLISION_METHOD_CONSERVATIVE = 0,
    /** The usual method: roots of the coplanarity cubic, an inside test at each root, and the distance at
     * the end. May miss. */
    VBSS_COLLISION_METHOD_CUBIC = 1,
    /** Algorithm 1 of VBLaST-SS (Qi et al. 2017): distance at the end, then a sign test and a linear time
     * of impact. Often misses. */
    VBSS_COLLISION_METHOD_VBLAST = 2
};

/** Kinds of the two features of a continuous test: a VBSS_COLLISION_PAIR_ constant. */
typedef int32_t vbss_collision_pair_kind;

/** The constants of #vbss_collision_pair_kind, with their four vertices. */
enum {
    VBSS_COLLISION_PAIR_EDGE_EDGE = 0,     /**< a0, a1 of edge a, then b0, b1 of edge b. */
    VBSS_COLLISION_PAIR_POINT_TRIANGLE = 1 /**< The point (a), then b0, b1, b2 of the triangle. */
};

/** Evidence for an answer: a VBSS_COLLISION_DECISION_ constant. */
typedef int32_t vbss_collision_decision;

/** The constants of #vbss_collision_decision. */
enum {
    /** Miss: planes that separate the features by more than D at all times. Hit: at `time` the
     * distance is at most D plus the tolerance. */
    VBSS_COLLISION_DECISION_PROVED = 0,
    VBSS_COLLISION_DECISION_EXACT =
        1, /**< D = 0: true for the given numbers, without any tolerance. */
    /** Neither could be shown, so the answer is a hit. D > 0: the test reached pass_limit, or no direction
     * was exact enough, which takes a D below about 1e-8 of the size. D = 0: the bits of the coordinates
     * spread over more binary places than there is memory for. A call without an object has memory for
     * about 250 places; with an object, all doubles tried so far have fitted. */
    VBSS_COLLISION_DECISION_UNDECIDED = 2,
    VBSS_COLLISION_DECISION_CLAIMED = 3 /**< CUBIC and VBLAST: not proved. */
};

/** Two closest points. */
typedef struct vbss_collision_closest {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t reserved;    /**< Zero. */
    double distance;     /**< Distance, m; minus the penetration depth for capsules that overlap. */
    double normal[3];    /**< Unit vector from a to b; zero if undefined (axes that meet). */
    double point_a[3];   /**< On a, m. */
    double point_b[3];   /**< On b, m. */
    double weights_a[3]; /**< Weights of the vertices of a, or of its axis, that give point_a. */
    double weights_b[3]; /**< Weights of the vertices of b, or of its axis, that give point_b. */
} vbss_collision_closest;

/** Result of a continuous test. */
typedef struct vbss_collision_impact {
    uint32_t struct_size;             /**< Bytes of this struct that the library filled. */
    int32_t hit;                      /**< 1: they come within D; 0: they do not. */
    vbss_collision_decision decision; /**< Evidence for `hit`. */
    uint32_t passes; /**< CONSERVATIVE: evaluations of the closest points; else of roots. */
    /** Hit: 0 to 1; with CONSERVATIVE there is no contact before. PROVED: at `time` the features are within
     * D plus the tolerance. EXACT: `time` is as near to the first contact as the advancement came.
     * `distance` says how near: about 1e-14 of the size, but more where features graze. Miss: 1. */
    double time;
    /** Hit: distance of the features at `time`, m; CUBIC and VBLAST: distance of the assumed points of
     * contact. Miss: 0. */
    double distance;
    double normal[3];  /**< Hit: unit vector from a to b, or zero if none is known. Miss: 0. */
    double weights[4]; /**< Hit: weights of the four vertices, sum 1 on either feature. Miss: 0. */
    double point_a[3]; /**< Hit: point on a at `time`, m. Miss: 0. */
    double point_b[3]; /**< Hit: point on b at `time`, m. Miss: 0. */
} vbss_collision_impact;

/** Method of the tests, and capacities. Fill it with #vbss_collision_config_init. */
typedef struct vbss_collision_config {
    uint32_t struct_size;         /**< Size of this struct in bytes, set by the init function. */
    vbss_collision_method method; /**< Default VBSS_COLLISION_METHOD_CONSERVATIVE. */
    /** Contact distance D, m: 0, or 1e-30 to 1e30; default 0. Between shapes their radii are added. */
    double thickness;
    /** Share of D, 1e-12 to 1; default 1e-3. A test may report a hit for features that only come within
     * D (1 + tolerance). Rounding sets a lower limit: docs/explanation/collision.md. No effect on the answer when
     * D = 0. */
    double tolerance;
    /** CONSERVATIVE: passes before a test gives up and reports a hit, 1 to 1000000; default 10000. Most
     * tests take one or two; edges that turn about each other just above D take hundreds. With D = 0 a test
     * makes at most 256. The limit does not apply to exact decisions. They take about 10 us, milliseconds
     * where bits spread over hundreds of binary places, and up to a second with subnormal numbers beside
     * 1. */
    uint32_t pass_limit;
    uint32_t shape_capacity;  /**< Largest number of shapes ever added, 0 to 65536; default 16. */
    uint32_t pair_capacity;   /**< Largest number of candidates, 0 to 1e8; default 16384. */
    uint32_t impact_capacity; /**< Largest number of impacts, 0 to 1e8; default 4096. */
    /** Excludes two segments of one chain from the candidates if the arc between their nearest ends is
     * shorter than `exclusion` times the D of the pair; 0 to 1e3. Neighbours are always excluded. Default
     * 1.6: a tube bent until it touches itself needs pi/2. */
    double exclusion;
    /** Added to D in the search for candidates, m, 0 to 1e3; default 0. */
    double margin;
    /** VBLAST: its parameters; NULL (default): their defaults. The library copies them. */
    const vbss_baseline_config *baseline;
} vbss_collision_config;

/** Questions in rows, answers in rows. Fill it with #vbss_collision_batch_init. */
typedef struct vbss_collision_batch {
    uint32_t struct_size;          /**< Size of this struct in bytes, set by the init function. */
    vbss_collision_pair_kind kind; /**< Kinds of the features of all questions. */
    uint32_t count;                /**< Questions, at most 1e8. */
    uint32_t stride; /**< Elements from one row to the next in every array, at least count. */
    /** Positions at time 0, m. 12 rows: x of vertex 0 of every question, y of vertex 0, z, x of vertex 1,
     * and so on. No two arrays of a batch overlap. */
    const double *start;
    const double *end;       /**< Positions at time 1, m, in rows as for `start`. */
    const double *thickness; /**< D of each question, m; NULL: D of the configuration. */
    int32_t *hit;            /**< Receives #vbss_collision_impact.hit of each question. */
    int32_t *decision;       /**< Receives #vbss_collision_impact.decision; may be NULL. */
    double *time;            /**< Receives #vbss_collision_impact.time; may be NULL. */
    double *normal;          /**< Receives 3 rows; may be NULL. */
    double *weights;         /**< Receives 4 rows; may be NULL. */
} vbss_collision_batch;

/** An array of a collision object: a VBSS_COLLISION_VIEW_ constant. */
typedef int32_t vbss_collision_field;

/** The constants of #vbss_collision_field. */
enum {
    /** x 5 uint32_t: #vbss_collision_pair_kind, shape and feature a, shape and feature b. A feature is an edge, a
     * point (node) or a triangle. Sorted by these five numbers. */
    VBSS_COLLISION_VIEW_CANDIDATES = 0,
    VBSS_COLLISION_VIEW_IMPACTS = 1,   /**< uint32_t: index of the candidate, ascending. */
    VBSS_COLLISION_VIEW_TIMES = 2,     /**< #vbss_collision_impact.time. */
    VBSS_COLLISION_VIEW_NORMALS = 3,   /**< x 3: #vbss_collision_impact.normal. */
    VBSS_COLLISION_VIEW_WEIGHTS = 4,   /**< x 4: #vbss_collision_impact.weights. */
    VBSS_COLLISION_VIEW_DECISIONS = 5, /**< uint32_t: #vbss_collision_impact.decision. */
    VBSS_COLLISION_VIEW_DISTANCES = 6  /**< #vbss_collision_impact.distance, m. */
};

/** Counters of a collision object since its creation. Searches and tests that fail are not counted. */
typedef struct vbss_collision_statistics {
    uint32_t struct_size;  /**< Bytes of this struct that the library filled. */
    uint32_t candidates;   /**< Candidates of the last search. */
    uint32_t impacts;      /**< Impacts of the last search. */
    uint32_t reserved;     /**< Zero. */
    uint64_t queries;      /**< Continuous tests. */
    uint64_t hits;         /**< Continuous tests that were hits. */
    uint64_t undecided;    /**< Continuous tests that were undecided. */
    uint64_t exact;        /**< Tests that needed exact arithmetic. */
    uint64_t passes;       /**< CONSERVATIVE: evaluations of the closest points. */
    uint64_t boxes_tested; /**< Pairs of boxes that the searches tested; not part of the state. */
    uint64_t searches;     /**< Searches for candidates. */
} vbss_collision_statistics;

/** Direction and depth of the paper's response: a VBSS_COLLISION_RESPONSE_ constant. */
typedef int32_t vbss_collision_response_variant;

/** The constants of #vbss_collision_response_variant. */
enum {
    /** Algorithm 2 as printed: along the shortest vector at the end of the step. */
    VBSS_COLLISION_RESPONSE_END_OF_STEP = 0,
    /** Along the normal at the time of impact, by D: the features are then D apart in the positions of that
     * time. */
    VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT = 1
};

/** Displacements by the paper's response. */
typedef struct vbss_collision_response {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** 1: the paper leaves this case open, and a rule of docs/explanation/paper-collision.md was used. Examples are no
     * relative motion along the direction, and features that meet at the end. */
    int32_t completed;
    double direction[3];     /**< q: unit vector from edge b to edge a, on the side of the start. */
    double depth;            /**< u: distance to restore along q, m. */
    double share_a;          /**< Share of u that a moves along q; b moves -(1 - share_a) u q. */
    double displacement[12]; /**< Displacements of the four vertices at time 1, m. */
} vbss_collision_response;

#ifdef __cplusplus
extern "C" {
#endif

/* ---- closest points */

/**
 * Closest points of two segments. Segments of length zero are points.
 *
 * @param a             two end points, m
 * @param b             two end points, m
 * @param[out] closest  receives points, distance, normal
 * @param struct_size   `sizeof *closest` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_NOT_FINITE or
 *         VBSS_ERROR_OUT_OF_RANGE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_closest_segments(const double a[6], const double b[6],
                                                     vbss_collision_closest *closest,
                                                     uint32_t struct_size);

/**
 * Closest points of a point (a) and a triangle (b). A triangle without area is its edges.
 *
 * @param point         m
 * @param triangle      three corners, m
 * @param[out] closest  receives points, distance, normal
 * @param struct_size   `sizeof *closest` as the caller was compiled
 * @return as #vbss_collision_closest_segments
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_closest_point_triangle(const double point[3],
                                                           const double triangle[9],
                                                           vbss_collision_closest *closest,
                                                           uint32_t struct_size);

/**
 * Closest points of a segment (a) and a triangle (b); distance 0 where the segment goes through.
 *
 * @param segment       two end points, m
 * @param triangle      three corners, m
 * @param[out] closest  receives points, distance, normal
 * @param struct_size   `sizeof *closest` as the caller was compiled
 * @return as #vbss_collision_closest_segments
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_closest_segment_triangle(const double segment[6],
                                                             const double triangle[9],
                                                             vbss_collision_closest *closest,
                                                             uint32_t struct_size);

/**
 * Closest points of the surfaces of two capsules, on the line between the closest points of their axes.
 * The distance is negative when they overlap. Where the axes meet there is no such line: the points
 * are those of the axes and the normal is zero.
 *
 * @param a             axis, two end points, m
 * @param radius_a      m, 0 to 1e30
 * @param b             axis, two end points, m
 * @param radius_b      m, 0 to 1e30
 * @param[out] closest  receives points, distance, normal; weights are those of the axes' points
 * @param struct_size   `sizeof *closest` as the caller was compiled
 * @return as #vbss_collision_closest_segments
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_closest_capsules(const double a[6], double radius_a,
                                                     const double b[6], double radius_b,
                                                     vbss_collision_closest *closest,
                                                     uint32_t struct_size);

/* ---- continuous tests */

/**
 * Fills a configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_config_init(vbss_collision_config *config,
                                                uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_collision_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_collision_config vbss_collision_config_default(void)
{
    vbss_collision_config vbss_filled;
    (void)vbss_collision_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Tests whether two moving edges come within D of each other. Edges of length zero are points. The test
 * answers all cases, also parallel and degenerate ones, and needs no object.
 *
 * @param config       method, thickness, tolerance; NULL for the defaults. Capacities are not read.
 * @param start        a0, a1, b0, b1 at time 0, m
 * @param end          these vertices at time 1, m
 * @param[out] impact  receives the answer
 * @param struct_size  `sizeof *impact` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_ARITHMETIC_MODE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_test_edges(const vbss_collision_config *config,
                                               const double start[12], const double end[12],
                                               vbss_collision_impact *impact, uint32_t struct_size);

/**
 * Tests whether a moving point and a moving triangle come within D of each other. Needs no object.
 *
 * @param config       method, thickness, tolerance; NULL for the defaults. Capacities are not read.
 * @param start        the point, then the corners b0, b1, b2 at time 0, m
 * @param end          these vertices at time 1, m
 * @param[out] impact  receives the answer
 * @param struct_size  `sizeof *impact` as the caller was compiled
 * @return as #vbss_collision_test_edges
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_test_point_triangle(const vbss_collision_config *config,
                                                        const double start[12],
                                                        const double end[12],
                                                        vbss_collision_impact *impact,
                                                        uint32_t struct_size);

/**
 * Computes the paper's response to a hit (algorithm 2): displacements of the four vertices at the
 * end of the step after which the features are D apart, on the side they came from. With
 * TIME_OF_IMPACT they are D apart in the positions of that time, and at the end nearer by their
 * approach since then. Weights and inverse masses distribute the shift of the contact point over
 * the two vertices of an edge, or the three of a triangle. docs/explanation/paper-collision.md has the source,
 * the signs, and the rules for cases that the paper leaves open.
 *
 * @param kind            kinds of the features
 * @param variant         as printed, or at the time of impact
 * @param impact          the hit, as reported by a test of the same vertices. TIME_OF_IMPACT needs it.
 *                        END_OF_STEP uses its normal if there is no other; NULL is allowed
 * @param start           four vertices at time 0, m
 * @param end             four vertices at time 1, m
 * @param thickness       D, m, 0 to 1e30
 * @param inverse_masses  one for each vertex, 1/kg, 0 to 1e30; 0 for a vertex that cannot move. If no
 *                        vertex of a feature can move, the other feature takes the whole correction. At
 *                        least one inverse mass is above 0.
 * @param[out] response   receives the displacements
 * @param struct_size     `sizeof *response` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_OUT_OF_RANGE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_get_vblast_response(
    vbss_collision_pair_kind kind, vbss_collision_response_variant variant,
    const vbss_collision_impact *impact, const double start[12], const double end[12],
    double thickness, const double inverse_masses[4], vbss_collision_response *response,
    uint32_t struct_size);

/* ---- the object */

/**
 * Creates a collision object without shapes.
 *
 * @param context         owner
 * @param config          the configuration; NULL for the defaults
 * @param[out] collision  the new object; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_create(vbss_context *context,
                                           const vbss_collision_config *config,
                                           vbss_collision **collision);

/**
 * Destroys a collision object with its shapes.
 *
 * @param collision  the object; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_destroy(vbss_collision *collision);

/**
 * Runs one test with the method and the thickness of the object, and counts it in the statistics.
 *
 * @param collision    the object
 * @param kind         kinds of the features
 * @param start        four vertices at time 0, m
 * @param end          four vertices at time 1, m
 * @param[out] impact  receives the answer
 * @param struct_size  `sizeof *impact` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_ARITHMETIC_MODE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_test(vbss_collision *collision, vbss_collision_pair_kind kind,
                                         const double start[12], const double end[12],
                                         vbss_collision_impact *impact, uint32_t struct_size);

/**
 * Fills a batch with the defaults: no questions.
 *
 * @param[out] batch   the batch to fill
 * @param struct_size  `sizeof *batch` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_batch_init(vbss_collision_batch *batch, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_collision_batch_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_collision_batch vbss_collision_batch_default(void)
{
    vbss_collision_batch vbss_filled;
    (void)vbss_collision_batch_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Runs many tests, four at a time. The answers have the bits of #vbss_collision_test. The call
 * allocates nothing.
 *
 * @param collision  the object: method, tolerance, counters
 * @param batch      questions, and arrays for the answers
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on failure no answer is written
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_test_batch(vbss_collision *collision,
                                               const vbss_collision_batch *batch);

/* ---- shapes and the search */

/**
 * Adds a chain of capsules, such as a thread: node_count nodes, edge i joins the nodes i and i + 1.
 * The call clears candidates and impacts, as with any new shape. It allocates. The nodes are at the origin
 * until #vbss_collision_set_motion.
 *
 * @param collision     the object
 * @param node_count    2 to 65537
 * @param rest_lengths  rest lengths of the node_count - 1 edges, m, 0 to 1e30, which the call copies.
 *                      `exclusion` measures the arc by them. NULL excludes neighbours only.
 * @param radius        m, 0 or 1e-30 to 1e29
 * @param[out] shape    identifier of the shape, from 0 on, never reused in this object
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_add_chain(vbss_collision *collision, uint32_t node_count,
                                              const double *rest_lengths, double radius,
                                              uint32_t *shape);

/**
 * Adds capsules that move independently and collide with each other: edge i joins the nodes 2 i and
 * 2 i + 1. The call allocates. The nodes are at the origin until #vbss_collision_set_motion.
 *
 * @param collision      the object
 * @param capsule_count  1 to 32768
 * @param radius         radius of all capsules, m, 0 or 1e-30 to 1e29
 * @param[out] shape     identifier of the shape, from 0 on, never reused in this object
 * @return as #vbss_collision_add_chain
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_add_capsules(vbss_collision *collision, uint32_t capsule_count,
                                                 double radius, uint32_t *shape);

/**
 * Adds a triangle mesh, open or closed. Its edges are those of its triangles, each once, sorted by
 * their two nodes. Features that share a node are never candidates. The call allocates. The nodes are
 * at the origin until #vbss_collision_set_motion.
 *
 * @param collision       the object
 * @param node_count      3 to 65536
 * @param triangles       three different nodes each
 * @param triangle_count  1 to 131072
 * @param radius          half the thickness of the sheet, m, 0 or 1e-30 to 1e29
 * @param[out] shape      identifier of the shape, from 0 on, never reused in this object
 * @return as #vbss_collision_add_chain
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_add_mesh(vbss_collision *collision, uint32_t node_count,
                                             const uint32_t *triangles, uint32_t triangle_count,
                                             double radius, uint32_t *shape);

/**
 * Removes a shape; the others keep their identifiers. The call clears candidates and impacts.
 *
 * @param collision  the object
 * @param shape identifier of the shape
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such shape) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_remove(vbss_collision *collision, uint32_t shape);

/**
 * Sets the category and the mask of a shape. The search pairs two shapes if each one's category has a bit
 * in the other's mask. A shape is also paired with itself by this rule: without a common bit, a thread or
 * a mesh does not collide with itself. The call clears candidates and impacts.
 *
 * @param collision  the object
 * @param shape identifier of the shape
 * @param category   bits; 1 when the shape was added
 * @param mask       bits; all when the shape was added
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such shape) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_set_filter(vbss_collision *collision, uint32_t shape,
                                               uint32_t category, uint32_t mask);

/**
 * Sets the motion of a shape for the next searches. The call clears candidates and impacts.
 *
 * @param collision   the object
 * @param shape identifier of the shape
 * @param start       3 doubles per node at time 0, m; NULL: the end of the last move
 * @param end         3 doubles per node at time 1, m
 * @param node_count  number of nodes in the arrays, equal to the shape's
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such shape), VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_set_motion(vbss_collision *collision, uint32_t shape,
                                               const double *start, const double *end,
                                               uint32_t node_count);

/**
 * Lists the pairs of features whose boxes overlap. Boxes are swept over the motion, and inflated by
 * the radii, `thickness`, the tolerance and `margin`. Pairs are edges with edges, and points with
 * triangles where a mesh takes part: points of chains, capsules and other meshes, and of the mesh
 * itself. The list is complete and depends on the positions alone, not on earlier searches. The
 * call allocates nothing. The call clears the impacts.
 *
 * @param collision  the object
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (pair_capacity: there are no
 *         candidates then), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_find_candidates(vbss_collision *collision);

/**
 * Tests all candidates of the last search; the hits are the impacts. The call allocates nothing.
 * The tests see edges with edges and points with triangles only. They report no impact for a
 * feature that went through a triangle earlier, is not near its edges, and has no point near its
 * inside.
 *
 * @param collision  the object
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (impact_capacity: there are no
 *         impacts then), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_find_impacts(vbss_collision *collision);

/**
 * Returns a view of the candidates or the impacts.
 *
 * @param collision    the object
 * @param field        the array
 * @param[out] view    receives the address and the shape of the array
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_get_view(vbss_collision *collision, vbss_collision_field field,
                                             vbss_view *view, uint32_t struct_size);

/**
 * Returns the nodes of an edge of a shape.
 *
 * @param collision   the object
 * @param shape identifier of the shape
 * @param edge index of the edge, as in candidates
 * @param[out] nodes  receives two nodes
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such shape) or VBSS_ERROR_OUT_OF_RANGE (no such edge)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_get_edge(vbss_collision *collision, uint32_t shape,
                                             uint32_t edge, uint32_t nodes[2]);

/**
 * Returns the object's counters.
 *
 * @param collision        the object
 * @param[out] statistics  receives the numbers
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_get_statistics(vbss_collision *collision,
                                                   vbss_collision_statistics *statistics,
                                                   uint32_t struct_size);

/**
 * Returns what method VBLAST counts in a collision object.
 *
 * @param collision       the object
 * @param[out] statistics  receives the counters
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INCOMPATIBLE if the object uses another method, VBSS_ERROR_INVALID_HANDLE,
 * VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_get_baseline_statistics(vbss_collision *collision,
                                                            vbss_baseline_statistics *statistics,
                                                            uint32_t struct_size);

/**
 * Saves the state: shapes, their motion, counters. Candidates and impacts are not saved; search again.
 *
 * @param collision     the object
 * @param[out] bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of the buffer
 * @param[out] written  bytes of the state, also when it does not fit
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_save(vbss_collision *collision, uint8_t *bytes,
                                         uint64_t capacity, uint64_t *written);

/**
 * Restores a saved state into this object or an equally configured one, with the same shapes added
 * and removed. On failure the object is unchanged. The call clears candidates and impacts.
 *
 * @param collision  the object
 * @param bytes      the state
 * @param count      its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_restore(vbss_collision *collision, const uint8_t *bytes,
                                            uint64_t count);

/**
 * Returns a hash of the whole state; equal states have equal hashes on every machine.
 *
 * @param collision  the object
 * @param[out] hash  receives the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_collision_get_hash(vbss_collision *collision, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
