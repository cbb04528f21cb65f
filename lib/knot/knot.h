/* The inside of knot detectors, shared by the files of lib/knot.
 *
 * From the host's polyline to the verdict: input.c copies what is shown; winding.c looks at it in every
 * step. A reading of the topology is a job (job.c) on a copy: core.c reduces the thread once with all that
 * its ends will be closed by as obstacles, closure.c closes it this way and that, and curve.c reads one closed curve:
 * reduction.c shortens it by moves that hit nothing (triangle.c), projection.c makes a diagram, gauss_code.c and untangle.c
 * simplify it, twist_regions.c takes it apart into torus knots, determinant.c, signature.c, vassiliev.c and jones.c
 * (kauffman_bracket.c) compute invariants, catalogue.c compares. throw_locator.c finds where the throws lie (throw_places.c, sub_chains.c), classification.c makes of it
 * what hosts see, topology_method.c starts and continues readings, detector.c
 * is the step. Method PROJECTION is in lib/baseline. */
#ifndef VBSS_KNOT_KNOT_H
#define VBSS_KNOT_KNOT_H

#include <vblast_ss/knot.h>

#include "base/config.h"
#include "base/linear.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/slot.h"
#include "knot/tuning.h"

enum { KNOT_THROWS = 8, KNOT_AXIS_POINTS = 4 };

/* Budget of operations, each about one nanosecond. A stage continues while the budget is positive
 * and subtracts the operations it has done, at least 1 per piece of work. The point where it stops
 * is therefore independent of how the work was split. */
typedef int64_t knot_ops;

/* ---- input (input.c) */

typedef struct knot_tool {
    uint32_t point_count;
    vbss_knot_held held;
    vec3 axis[KNOT_AXIS_POINTS];
    double radius[KNOT_AXIS_POINTS - 1];
    double held_place; /* place on the thread; for HELD_NEEDLE that of the last point */
} knot_tool;

/* Copy of the host's input. Points start at the tail's end; only one of several successive equal
 * points is kept. A place is the number of a point plus the fraction of the segment after it. */
typedef struct knot_input {
    uint32_t point_count, tool_count;
    bool has_holes;
    bool may_have_passed;
    double tissue_place; /* place between the holes; -1 if there are none */
    vec3 away;           /* unit direction away from the tissue; zero if unknown */
    vec3 *points;
    double *places; /* point -> its place in the host's numbering, ascending or descending */
    knot_tool *tools;
} knot_input;

/* Point at a place, and arc length between two places, m; both in the numbering of this copy. */
vec3 vbss_knot_point_at(const knot_input *input, double place);
double vbss_knot_length(const knot_input *input, double from, double to);
/* Converts a range of places to the host's numbering, ascending. */
void vbss_knot_places_to_host(const knot_input *input, const double own[2], double host[2]);

/* ---- winding about a tool (winding.c) */

typedef struct knot_winding {
    double turns, run_turns;
    /* range of the run with most turns: places, and heights along the axis, m. Places are in the
     * numbering of the copy, and in the host's once the detector stores them. */
    double run_places[2], run_heights[2];
    uint32_t runs;
    /* +1 if the run winds from its tissue end toward the tip, -1 for the reverse, 0 if undecided */
    int32_t sense;
} knot_winding;
/* Measures the winding of the thread about one tool. */
void vbss_knot_measure_winding(const knot_input *input, uint32_t tool, knot_winding *winding);

/* ---- polygons and their reduction (reduction.c) */

/* Polygon with the place of each vertex on the thread; negative on a closure. A vertex with
 * is_fixed = 1 survives a reduction. A closed polygon has an edge from the last vertex to the
 * first. */
typedef struct knot_polygon {
    vec3 *x;
    double *place;
    uint8_t *is_fixed;
    uint32_t count, capacity;
    bool closed;
} knot_polygon;

typedef struct knot_edge {
    vec3 start, end;
} knot_edge;

/* Whether the triangle a, b, c and the segment p, q certainly have no point in common, except a
 * corner that equals an end of the segment to the bit. False means that they may. */
bool vbss_knot_segment_misses_triangle(vec3 a, vec3 b, vec3 c, vec3 p, vec3 q);

/* Reduction: removes vertices whose triangle with both neighbours is hit neither by another edge of
 * the polygon nor by an obstacle. Such an edge may touch the triangle only at its corners a and c,
 * where it ends. Sweeps repeat until no vertex can be removed. */
typedef struct knot_reduction {
    uint32_t capacity;     /* vertices and obstacles together */
    knot_polygon *polygon; /* the polygon to reduce; its arrays receive the result */
    const knot_edge *obstacles;
    uint32_t obstacle_count;
    uint32_t remaining; /* number of vertices that remain */
    uint32_t cursor;    /* next vertex to test */
    uint32_t removed_in_sweep;
    uint64_t removed; /* number of vertices removed since the start */
    /* private state: */
    uint32_t first_edge, timestamp;
    knot_ops deferred_ops;
    int16_t *boxes;     /* boxes of edges and obstacles, in lanes */
    uint32_t *blockers; /* per vertex: the blocking edge, and when it was found */
    uint32_t *links;
} knot_reduction;
enum { KNOT_REDUCTION_ARRAYS = 3 };
void vbss_knot_reduction_arrays(knot_reduction *r, uint32_t capacity,
                                vbss_array arrays[KNOT_REDUCTION_ARRAYS]);
void vbss_knot_reduction_begin(knot_reduction *r, knot_polygon *polygon, const knot_edge *obstacles,
                               uint32_t obstacle_count);
/* Continues the reduction. Returns true when it is complete. */
bool vbss_knot_reduction_resume(knot_reduction *r, knot_ops *budget);

/* ---- diagrams: Gauss codes of closed polygons */

/* Gauss code: 2 n entries in the order of the curve from vertex 0 on. */
typedef struct knot_gauss_code {
    uint32_t n, capacity; /* number of crossings, and its limit */
    uint16_t *crossing;   /* entry -> crossing, 0 to n - 1 */
    uint8_t *over;        /* entry -> 1 for the over strand, 0 for the under strand */
    double *position;     /* entry -> vertex of the polygon + fraction of the edge after it */
    /* crossing -> +1 if right-handed (as in the right-handed 3_1), otherwise -1 */
    int8_t *sign;
    uint16_t *scratch; /* 4 entries for each crossing */
} knot_gauss_code;
enum { KNOT_GAUSS_CODE_ARRAYS = 5 };
void vbss_knot_gauss_code_arrays(knot_gauss_code *code, uint32_t capacity,
                                 vbss_array arrays[KNOT_GAUSS_CODE_ARRAYS]);
/* `to` must have the capacity for it */
void vbss_knot_gauss_code_copy(knot_gauss_code *to, const knot_gauss_code *from);

typedef enum knot_diagram_status {
    KNOT_DIAGRAM_REGULAR,    /* every crossing is certain and planarity is checked */
    KNOT_DIAGRAM_DEGENERATE, /* a crossing is uncertain; another direction may succeed */
    KNOT_DIAGRAM_FULL        /* more crossings than the capacity */
} knot_diagram_status;

/* Projects a polygon (projection.c). The eye looks against the unit vector `direction`; the strand
 * closer to the eye is over. */
typedef struct knot_projector {
    uint32_t capacity; /* number of vertices */
    double *flat;      /* scratch */
    double *boxes;
    uint32_t *order;
} knot_projector;
enum { KNOT_PROJECTOR_ARRAYS = 3 };
void vbss_knot_projector_arrays(knot_projector *p, uint32_t capacity,
                                vbss_array arrays[KNOT_PROJECTOR_ARRAYS]);
knot_diagram_status vbss_knot_project(knot_projector *p, const knot_polygon *polygon,
                                      vec3 direction, knot_gauss_code *code, knot_ops *budget);
/* The k-th of a fixed sequence of generic unit directions. */
vec3 vbss_knot_direction(uint32_t k);

/* Whether the number of faces is that of a planar diagram, n + 2 (gauss_code.c). */
bool vbss_knot_gauss_code_is_planar(const knot_gauss_code *code);
/* Applies Reidemeister moves I and II that remove crossings, until there are none. Remaining
 * entries keep their positions. */
void vbss_knot_gauss_code_simplify(knot_gauss_code *code, knot_ops *budget);
/* Makes one pass move (untangle.c): reroutes the first strand that passes over (or under)
 * everything it meets and can do so with fewer crossings, then simplifies. It tests at most *tries
 * strands and subtracts them. Returns false if there is no such strand; callers repeat it until
 * then. The positions of rerouted entries are only in order between those of their neighbours. Does
 * nothing if n + 2 exceeds the capacity of `spare`, which is overwritten. */
bool vbss_knot_gauss_code_untangle(knot_gauss_code *code, knot_gauss_code *spare, uint32_t *tries,
                                   knot_ops *budget);

/* ---- invariants of a knot from its code */

/* Memory for the invariants of codes with at most `capacity` crossings. */
typedef struct knot_algebra {
    uint32_t capacity;
    double *real;      /* (n + 2)^2 numbers */
    uint64_t *modular; /* (n + 2)^2 numbers */
    uint32_t *index;   /* 16 (n + 2) numbers */
} knot_algebra;
enum { KNOT_ALGEBRA_ARRAYS = 3 };
void vbss_knot_algebra_arrays(knot_algebra *a, uint32_t capacity,
                              vbss_array arrays[KNOT_ALGEBRA_ARRAYS]);

/* Determinant (determinant.c), exact below 2^30; 1 for the unknot. */
int64_t vbss_knot_determinant(knot_algebra *algebra, const knot_gauss_code *code, knot_ops *budget);
/* Levine-Tristram signature at theta = 2 acos(x) (signature.c), by Kashaev's matrix. Two
 * factorisations prove its inertia, with shifts that exceed the effect of rounding on an
 * eigenvalue. Returns false if that fails. KNOT_X_ORDINARY_10000 gives the ordinary signature, at
 * -1. */
#define KNOT_X_TRISTRAM_10000 9114 /* chosen: theta = 0.27000 pi, between pi/5 and 3 pi/11 */
#define KNOT_X_ORDINARY_10000 0
bool vbss_knot_signature(knot_algebra *algebra, const knot_gauss_code *code, uint32_t x_10000,
                         int32_t *signature, knot_ops *budget);
/* Vassiliev invariants v2 and v3 by Gauss diagram formulas (vassiliev.c); both are 1 for the
 * right-handed 3_1. */
void vbss_knot_vassiliev(const knot_gauss_code *code, int64_t *v2, int64_t *v3, knot_ops *budget);

/* The Kauffman bracket of a code, at elements A of the field of integers modulo 2^31 - 1
 * (kauffman_bracket.c). */
enum {
    KNOT_JONES_POINTS = 4,
    KNOT_CROSSING_ARCS = 4,
    KNOT_SMOOTHINGS = 2,
    KNOT_SMOOTHING_LOOPS = 3, /* a smoothing closes at most two loops */
    KNOT_BRACKET_ARRAYS = 5,
    KNOT_BRACKET_ENDS = 20,      /* capacity: 16 open arcs, and those of the crossing under way */
    KNOT_BRACKET_PAIRINGS = 1430 /* capacity: Catalan(8), the planar pairings of 16 ends */
};

typedef struct knot_bracket_crossing {
    uint16_t arcs[KNOT_CROSSING_ARCS]; /* over strand: in, out; under strand: in, out */
    int8_t sign;
    bool is_swept;
} knot_bracket_crossing;

/* A pairing of the ends of open arcs, and the sum over all states of the swept crossings with it. */
typedef struct knot_bracket_pairing {
    uint8_t mate[KNOT_BRACKET_ENDS]; /* the other end of the pair; 0 for an unused end */
    uint32_t value[KNOT_JONES_POINTS];
} knot_bracket_pairing;

/* The change by one crossing. */
typedef struct knot_bracket_addition {
    uint8_t ends[KNOT_CROSSING_ARCS];
    bool opens[KNOT_CROSSING_ARCS];  /* the arc is not open before */
    bool closes[KNOT_CROSSING_ARCS]; /* the arc is not open afterwards */
    /* by smoothing, and by the number of loops that it closes */
    uint32_t factors[KNOT_SMOOTHINGS][KNOT_SMOOTHING_LOOPS][KNOT_JONES_POINTS];
} knot_bracket_addition;

typedef struct knot_bracket {
    uint32_t crossing_capacity;
    uint32_t a[KNOT_JONES_POINTS], inverse_a[KNOT_JONES_POINTS]; /* A and 1 / A */
    uint32_t loop[KNOT_JONES_POINTS];                            /* -A^2 - A^-2 */
    uint32_t crossing_count, swept_count, pairing_count;
    knot_bracket_crossing *crossing; /* the crossing under way; NULL: none */
    knot_bracket_addition addition;  /* addition of that crossing */
    uint32_t cursor, old_count;      /* next pairing without that crossing; number of these */
    knot_bracket_crossing *crossings;
    uint8_t *ends; /* arc -> its end; KNOT_BRACKET_ENDS if the arc is not open */
    bool is_end_used[KNOT_BRACKET_ENDS];
    bool is_full; /* more open arcs or pairings than the capacity: there is no result */
    knot_bracket_pairing *pairings, *next_pairings;
    uint16_t *index; /* hash table of `next_pairings` */
} knot_bracket;
void vbss_knot_bracket_arrays(knot_bracket *b, uint32_t crossing_capacity,
                              vbss_array arrays[KNOT_BRACKET_ARRAYS]);
/* Starts the sweep over a code of 1 to crossing_capacity crossings. */
void vbss_knot_bracket_begin(knot_bracket *b, const knot_gauss_code *code,
                             const uint32_t a[KNOT_JONES_POINTS]);
/* Returns true when the sweep is done or full. The bracket is then the value of the only pairing; a
 * loop without crossings has the bracket `loop`. */
bool vbss_knot_bracket_resume(knot_bracket *b, knot_ops *budget);

typedef struct knot_invariants {
    int64_t determinant, v2, v3;
    int32_t signature, signature_tristram;
    uint32_t jones[KNOT_JONES_POINTS]; /* values of the Jones polynomial */
    bool known;                        /* false if a signature could not be determined */
    bool jones_known;                  /* false if the Jones polynomial was not computed */
} knot_invariants;

/* Values of the Jones polynomial (jones.c): starts the sweep for a code with crossings. */
void vbss_knot_jones_begin(knot_bracket *b, const knot_gauss_code *code, knot_ops *budget);
/* Stores the values after the sweep. Returns false if the diagram did not fit the bracket. */
bool vbss_knot_jones_end(const knot_bracket *b, knot_invariants *invariants);

/* ---- decomposition of a code (twist_regions.c), and sums with given invariants (catalogue.c) */

/* A summand T(2, 2 wraps + 1) of a connected sum. Its entries in the code are within [first, last];
 * its two strands are first to strand_end and strand_begin to last, as numbers of entries. */
typedef struct knot_factor {
    int32_t wraps, handedness;
    uint32_t first, strand_end, strand_begin, last;
} knot_factor;
typedef struct knot_factors {
    uint32_t count;
    /* each is in the middle of the next one: the order of stacked throws from the inside out */
    bool nested;
    knot_factor factors[KNOT_THROWS];
} knot_factors;
/* Decomposes a code that is a connected sum of at most KNOT_THROWS standard diagrams of such
 * summands; an empty code is the unknot. Returns false for any other code. Entry 0 follows the
 * point at infinity, so the inside is defined. */
bool vbss_knot_decompose(const knot_gauss_code *code, knot_factors *factors);

/* Invariants of a connected sum of throws, all but the Jones polynomial. */
knot_invariants vbss_knot_invariants_of(const knot_factors *factors);
/* Adds the values of the Jones polynomial of that sum (jones.c). */
void vbss_knot_jones_of(const knot_factors *factors, knot_invariants *invariants);
/* The Jones polynomials are compared only if both are known. Other unknown invariants are never
 * the same. */
bool vbss_knot_invariants_same(knot_invariants a, knot_invariants b);
/* Finds the only sum of at most KNOT_THROWS throws of at most three wraps that has these
 * invariants. Returns false if there is none. */
bool vbss_knot_match(knot_invariants invariants, knot_factors *factors);

/* Name, faults and notation of the throws, from the tissue outward. They depend only on wraps,
 * handedness and flags. */
typedef struct knot_classification {
    uint32_t throw_count;
    vbss_knot_throw throws[KNOT_THROWS];
    bool other; /* a knot that is not a stack of throws */
    vbss_knot_reason reason;
} knot_classification;
vbss_knot_name vbss_knot_name_of(const knot_classification *classification);
uint32_t vbss_knot_faults_of(const knot_classification *classification);
enum { KNOT_NOTATION = 32 };
void vbss_knot_notation_of(const knot_classification *classification, char text[KNOT_NOTATION]);

/* ---- one closed curve (curve.c) */

typedef struct knot_reading {
    vbss_knot_reason reason; /* NONE if the curve was read */
    uint32_t crossings;
    bool certified; /* decomposed into twist regions */
    /* `factors` are valid: certified, or only one sum of throws has these invariants */
    bool throws;
    knot_factors factors;
    knot_invariants invariants; /* if checked, or not certified */
} knot_reading;

/* Whether the curve was read and consists of throws, or of nothing. */
static inline bool knot_was_read(const knot_reading *r)
{
    return r->reason == VBSS_KNOT_REASON_NONE && r->throws;
}

typedef struct knot_counts {
    uint64_t closures, certified, projections, degenerate, overflows, removed;
} knot_counts;

typedef enum knot_curve_stage {
    KNOT_CURVE_REDUCE,
    KNOT_CURVE_PROJECT,
    KNOT_CURVE_UNTANGLE,
    KNOT_CURVE_COMPUTE,
    KNOT_CURVE_CONFIRM, /* by the Jones polynomial: the other invariants are those of throws */
    KNOT_CURVE_READ
} knot_curve_stage;

enum { KNOT_CODES = 3 };

typedef struct knot_curve {
    knot_polygon polygon; /* set by the caller before vbss_knot_curve_begin */
    knot_reduction reduction;
    knot_projector projector;
    knot_gauss_code codes[KNOT_CODES]; /* the present one, the best so far, and a spare one */
    knot_algebra algebra;
    knot_bracket bracket;
    knot_curve_stage stage;
    bool checked; /* compute invariants even if the curve is certified */
    bool overflowed, has_best;
    uint32_t direction, direction_limit, best;
    /* strands left to try in UNTANGLE; invariants computed so far in COMPUTE */
    uint32_t tries, computed;
    knot_reading reading;
    knot_counts counts;
} knot_curve;
/* Starts reading curve->polygon. */
void vbss_knot_curve_begin(knot_curve *curve, bool checked);
/* Continues. Returns true when the reading is complete. */
bool vbss_knot_curve_resume(knot_curve *curve, knot_ops *budget);
/* Whether both readings are certain and have the same result. */
bool vbss_knot_readings_agree(const knot_reading *a, const knot_reading *b);

/* ---- extensions and closures (closure.c) */

enum {
    KNOT_CLOSURES = 16,
    /* extensions of both ends in all directions, the ray away from the tissue, two paths through
     * tools */
    KNOT_OBSTACLES = 2 * (1 + KNOT_CLOSURES) + 1 + 2 * (KNOT_AXIS_POINTS + 1),
    /* vertices that a core has beside those of the thread: tissue, two grasps */
    KNOT_FIXED_VERTICES = 3,
    /* additional vertices that close a curve */
    KNOT_CLOSURE_VERTICES = 2 * (KNOT_AXIS_POINTS + 1) + 4
};

/* Extension from a point of the thread to infinity: a polyline and a final direction. */
typedef struct knot_extension {
    uint32_t count;
    vec3 points[KNOT_AXIS_POINTS + 1]; /* the first is on the thread */
    vec3 direction;                    /* unit vector */
} knot_extension;

typedef struct knot_closure {
    /* m; the distance of all of the thread from `centre` is at most an eighth of it */
    double far_distance;
    vec3 centre;
    bool ends_free;             /* extensions of both ends in direction 0 certainly hit nothing */
    uint32_t alternative_count; /* number of other directions for comparison */
    vec3 tail_directions[1 + KNOT_CLOSURES], long_directions[1 + KNOT_CLOSURES];
    bool has_tissue;
    vec3 away;
    /* Extensions through the tools, from the place that each holds; a negative place means that no
     * tool holds that limb near its end. */
    double tail_hold, long_hold;
    knot_extension tail_extension, long_extension;
} knot_closure;
void vbss_knot_closure_init(knot_closure *closure, const vbss_knot_detector_config *config,
                            const knot_input *input);
knot_extension vbss_knot_straight_extension(vec3 from, vec3 out);
/* Close a polygon far outside: vbss_knot_close_begin starts it with the tail's extension; after the
 * thread's vertices, vbss_knot_close_end adds the extension of the other end. */
void vbss_knot_close_begin(const knot_closure *closure, knot_polygon *polygon,
                           const knot_extension *tail);
void vbss_knot_close_end(const knot_closure *closure, knot_polygon *polygon,
                         const knot_extension *tail, const knot_extension *end);
void vbss_knot_polygon_add(knot_polygon *polygon, vec3 x, double place, bool is_fixed);
/* Appends the thread between two places. */
void vbss_knot_polygon_add_thread(knot_polygon *polygon, const knot_input *input, double from,
                                  double to);

/* ---- reduced thread for all closures (core.c) */

typedef struct knot_core {
    knot_polygon polygon; /* open polygon */
    knot_reduction reduction;
    knot_edge *obstacles;
} knot_core;
void vbss_knot_core_begin(knot_core *core, const knot_closure *closure, const knot_input *input);
bool vbss_knot_core_resume(knot_core *core, knot_ops *budget);

/* ---- places and order of the throws (throw_locator.c) */

typedef struct knot_located {
    bool located, ordered, stray;
    int32_t wraps, handedness;
    double tail_places[2], long_places[2]; /* places in the numbering of the copy */
} knot_located;

/* Slip of the throws of a reading (slip.c): (cT - cL) / (cT + cL) of each, where c is the mean
 * curvature of the tail or long limb at the crossings of both limbs, seen from all directions. */
enum { KNOT_LIMB_PIECES = 48 };
typedef struct knot_limb_piece {
    vec3 from, to;
    double length, distance; /* m; along the thread between the tissue and the middle */
    double curvature;        /* mean, 1/m */
} knot_limb_piece;
typedef struct knot_limb {
    uint32_t count;
    knot_limb_piece pieces[KNOT_LIMB_PIECES];
} knot_limb;
typedef struct knot_slip_room {
    knot_limb limbs[2]; /* tail, long */
    double crossings[KNOT_LIMB_PIECES][KNOT_LIMB_PIECES];
} knot_slip_room;
void vbss_knot_measure_slips(const knot_input *input, const knot_located *throws, uint32_t count,
                             knot_slip_room *room, double slips[KNOT_THROWS]);

typedef enum knot_locate_stage {
    KNOT_LOCATE_REDUCE,  /* reduce the thread between fixed vertices, so that places stay known */
    KNOT_LOCATE_PROJECT, /* make diagrams, whose crossings have places */
    KNOT_LOCATE_UNTANGLE,
    KNOT_LOCATE_CHECK, /* confirm the order by sub-chains between the throws */
    KNOT_LOCATE_DONE
} knot_locate_stage;

typedef struct knot_locator {
    const knot_input *input;
    const knot_closure *closure;
    const knot_reading *whole; /* reading of the whole thread: the throws to locate */
    /* Readings of the tail and of the long limb, each closed by the ray away from the tissue.
     * Throws in one limb alone are stray. */
    const knot_reading *limbs[2];
    knot_polygon polygon; /* the closed thread */
    knot_edge ray;        /* ray away from the tissue */
    knot_locate_stage stage;
    uint32_t round; /* in REDUCE */
    uint32_t direction, direction_limit;
    uint32_t level;   /* in CHECK: number of throws inside the sub-chain */
    bool reading;     /* a sub-chain is being read */
    bool certified;   /* a diagram of the whole thread was decomposed, which also proves the type */
    uint32_t tries;   /* in UNTANGLE: strands left to try */
    bool is_rerouted; /* the diagram has rerouted strands */
    bool has_spare;   /* `spare` holds the places of the best diagram */
    bool spare_is_rerouted; /* those places come from diagrams with rerouted strands */
    uint32_t count;
    knot_located throws[KNOT_THROWS], spare[KNOT_THROWS];
} knot_locator;
/* Number of throws with these wraps and this handedness among factors, and among the first `until`
 * located throws (throw_places.c). */
uint32_t vbss_knot_count_factors(const knot_factors *factors, int32_t wraps, int32_t handedness);
uint32_t vbss_knot_count_located(const knot_locator *locator, uint32_t until, int32_t wraps,
                                 int32_t handedness);
/* Whether a reading consists of exactly the first `count` located throws. */
bool vbss_knot_has_first_throws(const knot_locator *locator, const knot_reading *reading,
                                uint32_t count);
/* Locates the throws in a decomposed diagram. Returns false if a crossing is beyond the ends of the
 * thread. */
bool vbss_knot_locate_throws(knot_locator *locator, const knot_gauss_code *code,
                             const knot_factors *factors);
/* Whether the located stray throws agree with the readings of both limbs. */
bool vbss_knot_strays_agree(const knot_locator *locator);
/* Whether a is between the strands of b. */
bool vbss_knot_is_inside(const knot_located *a, const knot_located *b);
/* Length of the thread that a throw spans, in segments. */
double vbss_knot_extent_of(const knot_located *located);
/* One piece of work of stage CHECK (sub_chains.c); it sets the next stage when done. */
void vbss_knot_check_order(knot_locator *locator, knot_curve *curve, knot_ops *budget);
/* Starts locating the throws (throw_locator.c). */
void vbss_knot_locator_begin(knot_locator *locator, knot_curve *curve, const knot_input *input,
                             const knot_closure *closure, const knot_reading *whole,
                             const knot_reading *tail, const knot_reading *long_limb,
                             uint32_t direction_limit);
/* Continues, with `curve` for its own readings. Returns true when done. */
bool vbss_knot_locator_resume(knot_locator *locator, knot_curve *curve, knot_ops *budget);

/* ---- one reading of the topology (job.c) */

typedef enum knot_job_stage {
    KNOT_JOB_IDLE,
    KNOT_JOB_CORE,
    KNOT_JOB_CURVES,
    KNOT_JOB_LOCATE,
    KNOT_JOB_DONE
} knot_job_stage;

/* Closed curves of a reading, in this order. */
typedef enum knot_curve_kind {
    KNOT_CURVE_OUTWARD,
    KNOT_CURVE_TAIL,  /* the tail limb, closed by the ray away from the tissue */
    KNOT_CURVE_LONG,  /* the long limb, closed by the ray away from the tissue */
    KNOT_CURVE_TOOLS, /* the thread, extended through the tools that hold its ends */
    KNOT_CURVE_OTHERS /* from here on: the other directions */
} knot_curve_kind;

typedef struct knot_job {
    knot_input input; /* copy of the input */
    uint64_t step;    /* step of that input */
    knot_job_stage stage;
    uint32_t curve; /* in KNOT_JOB_CURVES: a knot_curve_kind or more */
    bool curve_began;
    knot_closure closure;
    knot_core core;
    knot_curve reader;
    knot_locator locator;
    knot_ops ops_used;
    /* results */
    knot_reading outward, tail, long_limb, tools;
    bool has_tools;
    uint32_t agreeing;
    double slips[KNOT_THROWS]; /* of the located throws */
    knot_slip_room slip_room;
} knot_job;
/* Whether a reading has started and is not complete. */
bool vbss_knot_job_is_active(const knot_job *job);
/* Starts a reading of job->input. */
void vbss_knot_job_begin(knot_job *job, const vbss_knot_detector_config *config, uint64_t step);
/* Continues. Returns true when the reading is complete; the rest of the budget stays. */
bool vbss_knot_job_resume(knot_job *job, const vbss_knot_detector_config *config, knot_ops *budget);

/* ---- the detector (detector.c) */

typedef struct knot_tool_state {
    bool wrapped;
    bool wrong_sense; /* reported since the thread was wrapped */
    vbss_knot_held held;
    knot_winding winding;
} knot_tool_state;

typedef struct knot_event {
    uint32_t kind, numbers[3];
} knot_event;

typedef struct knot_detector knot_detector;

/* What the method of a detector does. The table is chosen once, when a detector is created. */
typedef struct knot_method {
    /* Memory of the method; destroy_detector follows also when this fails. */
    vbss_result (*create_detector)(knot_detector *d);
    void (*destroy_detector)(vbss_context *context, knot_detector *d);
    /* Reads the input of a step, when winding about the tools is known. `immediate`: all of it, at once. */
    void (*step_detector)(knot_detector *d, bool immediate);
} knot_method;
extern const knot_method vbss_knot_topology;  /* topology_method.c */
extern const knot_method vbss_baseline_knots; /* defined in lib/baseline */

struct knot_detector {
    const knot_method *method;
    vbss_context *context;
    vbss_knot_detector_config config;
    knot_input input; /* input in the last step */
    knot_tool_state *tools;
    knot_job job;
    struct baseline_detector *baseline; /* state of lib/baseline; NULL by method TOPOLOGY */
    vbss_random random;                 /* used by method PROJECTION, saved by both */
    bool reading_due;                   /* a reading should start as soon as none is in progress */
    bool thread_may_differ;             /* the thread may not be the one that was read before */
    /* number of steps, and the step in which the last job started */
    uint64_t steps, job_start_step;
    vbss_knot_state state;
    knot_classification classification;
    knot_event *events;
    uint32_t event_count, events_lost;
    vbss_knot_detector_statistics statistics; /* without the reading in progress */
    const uint32_t *loop_rows;                /* 4 numbers for each loop, for the view */
    uint32_t loop_count;
    uint64_t generation;
};
/* Memory (memory.c): creates a detector in its initial state, without a handle, from a checked
 * configuration. */
vbss_result vbss_knot_allocate(vbss_context *context, const vbss_knot_detector_config *config,
                               knot_detector **detector);
void vbss_knot_free(vbss_context *context, void *object);
/* Returns a detector to its initial state. */
void vbss_knot_reset_state(knot_detector *detector);
/* Handles (handle.c): the kind of all handles of detectors, and the detector behind a handle, for a
 * query or for a change. */
extern const vbss_kind vbss_knot_kind;
vbss_result vbss_knot_open(const vbss_knot_detector *handle, knot_detector **detector);
vbss_result vbss_knot_edit(vbss_knot_detector *handle, knot_detector **detector);
/* Configuration (config.c) */
extern const vbss_layout vbss_knot_config_layout;
vbss_result vbss_knot_check_config(vbss_context *context, const vbss_knot_detector_config *config);
/* input.c: checks all of it, then copies it to `scene`, which has room. */
vbss_result vbss_knot_read_input(const knot_detector *detector, const vbss_knot_input *input,
                                 knot_input *copy);
void vbss_knot_input_copy(knot_input *to, const knot_input *from);
/* Adds an event of this step (events.c). Without room, the last event counts those that are lost. */
void vbss_knot_emit_event(knot_detector *detector, vbss_knot_event kind, uint32_t a, uint32_t b,
                          uint32_t c);
/* Updates the public state after a complete reading (classification.c). `follows`: the thread is
 * the one of the last reading, moved. */
void vbss_knot_classify(knot_detector *detector, bool follows);
/* Updates the throw that is being tied, from winding and the last reading. */
void vbss_knot_classify_next(knot_detector *detector);
/* Adds the counters of a reading, complete or in progress, to the statistics. */
void vbss_knot_count_job(const knot_job *job, vbss_knot_detector_statistics *statistics);
void vbss_knot_serialise(vbss_stream *stream, void *object);

#endif
