/* The inside of knot detectors, shared by the files of lib/knot.
 *
 * From the host's polyline to the verdict: input.c copies what is shown; winding.c looks at it in every
 * step. A reading of the topology is a job (job.c) on a copy: core.c reduces the thread once with all that
 * its ends will be closed by as obstacles, closure.c closes it this way and that, and curve.c reads one closed curve:
 * reduction.c shortens it by moves that hit nothing (triangle.c), projection.c makes a diagram, gauss_code.c and untangle.c
 * simplify it, twist_regions.c takes it apart into torus knots, determinant.c, signature.c and vassiliev.c compute
 * invariants, catalogue.c compares. throw_locator.c finds where the throws lie (throw_places.c, sub_chains.c), classification.c makes of it
 * what hosts see, detector.c is the step. paper_step.c, paper_loops.c and paper_throws.c are method PROJECTION. */
#ifndef VBSS_KNOT_KNOT_H
#define VBSS_KNOT_KNOT_H

#include <vblast_ss/knot.h>

#include "base/config.h"
#include "base/linear.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/slot.h"

enum { KNOT_THROWS = 8, KNOT_AXIS_POINTS = 4 };

/* Operations left to spend, each about a nanosecond. A stage goes on while this is above zero and takes off what
 * it did, at least 1 a piece, so that where it stops does not depend on how the work was sliced. */
typedef int64_t knot_ops;

/* ---- what is shown (input.c) */

typedef struct knot_tool {
    uint32_t point_count;
    vbss_knot_held held;
    vec3 axis[KNOT_AXIS_POINTS];
    double radius[KNOT_AXIS_POINTS - 1];
    double held_place; /* HELD_NEEDLE: that of the last point */
} knot_tool;

/* Points run from the tail's end on; where two successive ones were the same only one is kept. */
typedef struct knot_input {
    uint32_t point_count, tool_count;
    bool has_holes;
    bool may_have_passed;
    double tissue_place; /* between the holes; -1 when there are none */
    vec3 away;           /* unit; zero when it is to be found */
    vec3 *points;
    double *places; /* of each point in the host's numbers, ascending or descending */
    knot_tool *tools;
} knot_input;

/* The point at a place in the scene's own numbers, and the length of line between two of those, m. */
vec3 vbss_knot_point_at(const knot_input *input, double place);
double vbss_knot_length(const knot_input *input, double from, double to);
/* A range of places in the host's numbers, ascending. */
void vbss_knot_places_to_host(const knot_input *input, const double own[2], double host[2]);

/* ---- winding.c */

typedef struct knot_winding {
    double turns, run_turns;
    double run_places[2],
        run_heights[2]; /* places in the scene's own numbers; host's in the detector */
    uint32_t runs;
    int32_t sense; /* +1: from the tissue's end of the run towards the tip */
} knot_winding;
void vbss_knot_measure_winding(const knot_input *input, uint32_t tool, knot_winding *winding);

/* ---- polygons */

/* `place`: of each vertex on the thread; negative on a closure. `stays`: 1 keeps it through a reduction. A closed
 * polygon has an edge from the last vertex to the first. */
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

/* Whether it is certain that the triangle a, b, c and the segment p, q have no point in common, or only a
 * corner of the triangle that is (to the bit) an end of the segment. False: they may. */
bool vbss_knot_segment_misses_triangle(vec3 a, vec3 b, vec3 c, vec3 p, vec3 q);

/* Removes vertices whose triangle with both neighbours is hit by nothing: no other edge of the polygon and no
 * obstacle, which touch a triangle at most at its corners a and c, where they end. Sweeps until none can go. */
typedef struct knot_reduction {
    uint32_t capacity;     /* of vertices and obstacles together */
    knot_polygon *polygon; /* what is reduced; its arrays hold the result in the end */
    const knot_edge *obstacles;
    uint32_t obstacle_count;
    uint32_t remaining; /* vertices that are still there */
    uint32_t cursor;    /* the vertex looked at next */
    uint32_t removed_in_sweep;
    uint64_t removed; /* since the begin of the reduction */
    /* What else it takes is its own: */
    uint32_t first_edge, timestamp;
    knot_ops deferred_ops;
    int16_t *boxes;     /* of edges and obstacles, side by side in lanes */
    uint32_t *blockers; /* of each vertex: the edge that was in its way, and when that was found */
    uint32_t *links;
} knot_reduction;
enum { KNOT_REDUCTION_ARRAYS = 3 };
void vbss_knot_reduction_arrays(knot_reduction *r, uint32_t capacity,
                                vbss_array arrays[KNOT_REDUCTION_ARRAYS]);
void vbss_knot_reduction_begin(knot_reduction *r, knot_polygon *polygon, const knot_edge *obstacles,
                               uint32_t obstacle_count);
/* True when it is done. */
bool vbss_knot_reduction_resume(knot_reduction *r, knot_ops *budget);

/* ---- diagrams: Gauss codes of a closed polygon */

/* 2 n entries in the order of the curve from vertex 0 on. */
typedef struct knot_gauss_code {
    uint32_t n, capacity; /* crossings */
    uint16_t *crossing;   /* of each entry: 0 to n - 1 */
    uint8_t *over;        /* of each entry: 1 over, 0 under */
    double *position;     /* of each entry: vertex of the polygon + fraction of the edge after it */
    int8_t *sign;         /* of each crossing: +1 right-handed (that of right-handed 3_1) */
    uint16_t *scratch;    /* 4 a crossing */
} knot_gauss_code;
enum { KNOT_GAUSS_CODE_ARRAYS = 5 };
void vbss_knot_gauss_code_arrays(knot_gauss_code *code, uint32_t capacity,
                                 vbss_array arrays[KNOT_GAUSS_CODE_ARRAYS]);
void vbss_knot_gauss_code_copy(knot_gauss_code *to,
                               const knot_gauss_code *from); /* of equal capacity at least */

typedef enum knot_diagram_status {
    KNOT_DIAGRAM_REGULAR,    /* every crossing is certain, planarity was checked */
    KNOT_DIAGRAM_DEGENERATE, /* some crossing is not: another direction may do */
    KNOT_DIAGRAM_FULL        /* more than capacity crossings */
} knot_diagram_status;

/* projection.c: what is nearer to the eye, which looks against `direction` (unit), is over. */
typedef struct knot_projector {
    uint32_t capacity; /* of vertices */
    double *flat;      /* what it takes */
    double *boxes;
    uint32_t *order;
} knot_projector;
enum { KNOT_PROJECTOR_ARRAYS = 3 };
void vbss_knot_projector_arrays(knot_projector *p, uint32_t capacity,
                                vbss_array arrays[KNOT_PROJECTOR_ARRAYS]);
knot_diagram_status vbss_knot_project(knot_projector *p, const knot_polygon *polygon,
                                      vec3 direction, knot_gauss_code *code, knot_ops *budget);
/* The k-th of a fixed sequence of generic directions, unit. */
vec3 vbss_knot_direction(uint32_t k);

/* gauss_code.c: faces = crossings + 2. */
bool vbss_knot_gauss_code_is_planar(const knot_gauss_code *code);
/* Reidemeister moves I and II that lower the number of crossings, until there is none. `at` of what stays is kept. */
void vbss_knot_gauss_code_simplify(knot_gauss_code *code, knot_ops *budget);
/* untangle.c: lays the first strand that passes over (or under) all it meets and can meet less where it does, and
 * simplifies; looks at `tries` strands at most, and takes off those. False when there is none: call it until then.
 * `at` of passages that were laid anew is between those of their neighbours, ascending, no more. Nothing is done when
 * n + 2 is more than the capacity of `spare`, which is overwritten. */
bool vbss_knot_gauss_code_untangle(knot_gauss_code *code, knot_gauss_code *spare, uint32_t *tries,
                                   knot_ops *budget);

/* ---- invariants of a code of a knot */

/* Memory for them, for n crossings at most. */
typedef struct knot_algebra {
    uint32_t capacity;
    double *real;      /* (n + 2)^2 */
    uint64_t *modular; /* (n + 2)^2 */
    uint32_t *index;   /* 16 (n + 2) */
} knot_algebra;
enum { KNOT_ALGEBRA_ARRAYS = 3 };
void vbss_knot_algebra_arrays(knot_algebra *a, uint32_t capacity,
                              vbss_array arrays[KNOT_ALGEBRA_ARRAYS]);

/* determinant.c: exact if below 2^30; 1 for the unknot. */
int64_t vbss_knot_determinant(knot_algebra *algebra, const knot_gauss_code *code, knot_ops *budget);
/* signature.c: at theta = 2 acos(x); by Kashaev's matrix, its inertia proved by two factorisations, shifted by more
 * than rounding moves an eigenvalue. False when that cannot be done. X_ORDINARY: at -1, where it is the signature. */
#define KNOT_X_TRISTRAM_1000 911 /* thousandths: theta = 0.2704 pi, between pi/5 and 3 pi/11 */
#define KNOT_X_ORDINARY_1000 0
bool vbss_knot_signature(knot_algebra *algebra, const knot_gauss_code *code, uint32_t x_1000,
                         int32_t *signature, knot_ops *budget);
/* vassiliev.c: v2 and v3 by Gauss diagram formulas; right-handed 3_1: 1, 1. */
void vbss_knot_vassiliev(const knot_gauss_code *code, int64_t *v2, int64_t *v3, knot_ops *budget);

typedef struct knot_invariants {
    int64_t determinant, v2, v3;
    int32_t signature, signature_tristram;
    bool known; /* false when a signature could not be told */
} knot_invariants;

/* ---- what a code is made of (twist_regions.c) and what invariants allow (catalogue.c) */

/* A summand T(2, 2 wraps + 1) of a connected sum. Its entries of the code lie in [first, last], each
 * of its two strands in one half: first ... strand_end, strand_begin ... last (as entry numbers). */
typedef struct knot_factor {
    int32_t wraps, handedness;
    uint32_t first, strand_end, strand_begin, last;
} knot_factor;
typedef struct knot_factors {
    uint32_t count;
    bool
        nested; /* each within the middle of the next: the order of stacked throws from the inside out */
    knot_factor factors[KNOT_THROWS];
} knot_factors;
/* True when the code is, as it stands, a connected sum of such diagrams (none: the unknot) and no more than KNOT_THROWS.
 * Entry 0 follows the point at infinity, so what is inside is known. */
bool vbss_knot_decompose(const knot_gauss_code *code, knot_factors *factors);

/* Invariants of a connected sum of throws. */
knot_invariants vbss_knot_invariants_of(const knot_factors *factors);
bool vbss_knot_invariants_same(knot_invariants a, knot_invariants b);
/* The only sum of at most KNOT_THROWS throws of at most three wraps with these invariants; false when there is none. */
bool vbss_knot_match(knot_invariants invariants, knot_factors *factors);

/* Name, faults and notation of throws from the tissue outward. Only wraps, handedness and flags are read. */
typedef struct knot_classification {
    uint32_t throw_count;
    vbss_knot_throw throws[KNOT_THROWS];
    bool other; /* a knot that is no stack of throws */
    vbss_knot_reason reason;
} knot_classification;
vbss_knot_name vbss_knot_name_of(const knot_classification *classification);
uint32_t vbss_knot_faults_of(const knot_classification *classification);
enum { KNOT_NOTATION = 32 };
void vbss_knot_notation_of(const knot_classification *classification, char text[KNOT_NOTATION]);

/* slip.c: (kT - kL) / (kT + kL), k the total turning of the line between two places. */
double vbss_knot_slip(const knot_input *input, const double tail_places[2],
                      const double long_places[2]);

/* ---- method PROJECTION */

typedef struct knot_loop {
    uint32_t tool, first, last, inside; /* as the view shows them */
    vec3 meeting[2];                    /* where the pair's projections cross, on each segment */
    bool first_is_above;
} knot_loop;
typedef struct knot_paper {
    uint32_t capacity; /* of points */
    uint32_t loop_count, loop_capacity;
    knot_loop *loops;
    double *flat; /* 2 a point, then heights */
    vbss_random random;
} knot_paper;
enum { KNOT_PAPER_ARRAYS = 2 };
void vbss_knot_paper_arrays(knot_paper *p, uint32_t capacity, vbss_array arrays[KNOT_PAPER_ARRAYS]);
/* What is found about one tool: appends its loops to p->loops (all of them, inside or not). */
void vbss_knot_paper_loops(knot_paper *p, const vbss_knot_config *config, const knot_input *scene,
                           uint32_t tool);
/* Loops of `tool` that one segment crosses so that they tie, and crossings that do not. */
typedef struct knot_paper_throw {
    uint32_t loops, undone;
    bool first_is_above, inside_out; /* of the crossing that ties most */
    uint32_t segment;
} knot_paper_throw;
knot_paper_throw vbss_knot_paper_throws(knot_paper *p, const vbss_knot_config *config,
                                        const knot_input *scene, uint32_t tool);

/* ---- one closed curve (curve.c) */

typedef struct knot_reading {
    vbss_knot_reason reason; /* NONE: it was read */
    uint32_t crossings;
    bool certified; /* taken apart into twist regions */
    bool
        throws; /* `factors` hold: certified, or the invariants are those of one sum of throws only */
    knot_factors factors;
    knot_invariants invariants; /* when checked, or not certified */
} knot_reading;

/* It was read, and what it has are throws (or nothing). */
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
    KNOT_CURVE_READ
} knot_curve_stage;

enum { KNOT_CODES = 3, KNOT_TRIES = 400 /* strands that are laid anew in a diagram */ };

typedef struct knot_curve {
    knot_polygon polygon; /* filled by whoever begins */
    knot_reduction reduction;
    knot_projector projector;
    knot_gauss_code codes[KNOT_CODES]; /* the one being made, the best so far, and a spare one */
    knot_algebra algebra;
    knot_curve_stage stage;
    bool checked; /* invariants are computed even if it is certified */
    bool overflowed, has_best;
    uint32_t direction, direction_limit, best;
    uint32_t tries, computed; /* UNTANGLE: strands left to look at; COMPUTE: invariants so far */
    knot_reading reading;
    knot_counts counts;
} knot_curve;
void vbss_knot_curve_begin(knot_curve *curve, bool checked);
bool vbss_knot_curve_resume(knot_curve *curve, knot_ops *budget);
/* The same certain answer. */
bool vbss_knot_readings_agree(const knot_reading *a, const knot_reading *b);

/* ---- closing (closure.c): how a thread is continued to infinity */

enum {
    KNOT_CLOSURES = 16,
    /* Rays of both ends, one of the tissue, two paths through tools. */
    KNOT_OBSTACLES = 2 * (1 + KNOT_CLOSURES) + 1 + 2 * (KNOT_AXIS_POINTS + 1),
    KNOT_FIXED_VERTICES = 3, /* vertices that a core has besides the thread's: tissue, two holds */
    KNOT_CLOSURE_VERTICES = 2 * (KNOT_AXIS_POINTS + 1) + 4 /* and those that close a curve */
};

/* From a point on the thread to infinity: a polyline and the direction in which it goes on. */
typedef struct knot_extension {
    uint32_t count;
    vec3 points[KNOT_AXIS_POINTS + 1]; /* the first lies on the thread */
    vec3 direction;                    /* unit */
} knot_extension;

typedef struct knot_closure {
    double far_distance; /* m; all of the thread is within an eighth of it of `centre` */
    vec3 centre;
    bool ends_free;             /* closing in the direction 0 of each end is beyond doubt */
    uint32_t alternative_count; /* other directions to compare with */
    vec3 tail_directions[1 + KNOT_CLOSURES], long_directions[1 + KNOT_CLOSURES];
    bool has_tissue;
    vec3 away;
    /* Through the tools: from where they hold; place < 0: none holds that limb near its end. */
    double tail_hold, long_hold;
    knot_extension tail_extension, long_extension;
} knot_closure;
void vbss_knot_closure_init(knot_closure *closure, const vbss_knot_config *config,
                            const knot_input *input);
knot_extension vbss_knot_straight_extension(vec3 from, vec3 out);
/* Appends the thread's continuation before its first and after its last vertex, and closes it far outside.
 * The polygon's first vertices are left free for it: see begin. */
void vbss_knot_close_begin(const knot_closure *closure, knot_polygon *polygon,
                           const knot_extension *tail);
void vbss_knot_close_end(const knot_closure *closure, knot_polygon *polygon,
                         const knot_extension *tail, const knot_extension *end);
void vbss_knot_polygon_add(knot_polygon *polygon, vec3 x, double place, bool is_fixed);
/* The thread between two places. */
void vbss_knot_polygon_add_thread(knot_polygon *polygon, const knot_input *input, double from,
                                  double to);

/* ---- core.c: the thread reduced once, with all the ways its ends are closed by in the way */

typedef struct knot_core {
    knot_polygon polygon; /* open */
    knot_reduction reduction;
    knot_edge *obstacles;
} knot_core;
void vbss_knot_core_begin(knot_core *core, const knot_closure *closure, const knot_input *input);
bool vbss_knot_core_resume(knot_core *core, knot_ops *budget);

/* ---- throw_locator.c: where the throws lie and in which order, found on the thread itself */

typedef struct knot_located {
    bool located, ordered, stray;
    int32_t wraps, handedness;
    double tail_places[2], long_places[2]; /* in the scene's own numbers */
} knot_located;

typedef enum knot_locate_stage {
    KNOT_LOCATE_REDUCE, /* the whole thread, only so far that its vertices tell places well enough */
    KNOT_LOCATE_PROJECT, /* whose crossings then have their places */
    KNOT_LOCATE_UNTANGLE,
    KNOT_LOCATE_CHECK, /* sub-chains between the throws confirm the order */
    KNOT_LOCATE_DONE
} knot_locate_stage;

typedef struct knot_locator {
    const knot_input *input;
    const knot_closure *closure;
    const knot_reading *whole; /* what there is to find */
    /* Tail and long limb with the tissue's ray: what is in them alone is stray. */
    const knot_reading *limbs[2];
    knot_polygon polygon; /* the thread closed */
    knot_edge ray;        /* away from the tissue */
    knot_locate_stage stage;
    uint32_t round; /* REDUCE */
    uint32_t direction, direction_limit;
    uint32_t level;   /* CHECK: throws inside the sub-chain */
    bool reading;     /* a sub-chain is being read */
    bool certified;   /* a diagram of the whole thread came apart: that too proves what it is */
    uint32_t tries;   /* UNTANGLE: strands left to look at */
    bool is_rerouted; /* the diagram has strands that were laid anew */
    bool has_spare;   /* `spare` are the places that the best diagram shows */
    bool spare_is_rerouted; /* only such as have strands that were laid anew */
    uint32_t count;
    knot_located throws[KNOT_THROWS], spare[KNOT_THROWS];
} knot_locator;
/* throw_places.c: throws of a kind among factors, and among the first ones located. */
uint32_t vbss_knot_count_factors(const knot_factors *factors, int32_t wraps, int32_t handedness);
uint32_t vbss_knot_count_located(const knot_locator *locator, uint32_t until, int32_t wraps,
                                 int32_t handedness);
/* Whether a reading has just the first throws located. */
bool vbss_knot_has_first_throws(const knot_locator *locator, const knot_reading *reading,
                                uint32_t count);
/* Locates the throws as a diagram shows them; false when something crosses beyond the ends. */
bool vbss_knot_locate_throws(knot_locator *locator, const knot_gauss_code *code,
                             const knot_factors *factors);
bool vbss_knot_strays_agree(const knot_locator *locator);
/* Whether a lies between the strands of b. */
bool vbss_knot_is_inside(const knot_located *a, const knot_located *b);
/* How much of the thread it takes, in segments. */
double vbss_knot_extent_of(const knot_located *located);
/* sub_chains.c: one piece of work; it sets the stage when it is done. */
void vbss_knot_check_order(knot_locator *locator, knot_curve *curve, knot_ops *budget);
/* throw_locator.c */
void vbss_knot_locator_begin(knot_locator *locator, knot_curve *curve, const knot_input *input,
                             const knot_closure *closure, const knot_reading *whole,
                             const knot_reading *tail, const knot_reading *long_limb,
                             uint32_t direction_limit);
/* Uses the curve for its own readings. */
bool vbss_knot_locator_resume(knot_locator *locator, knot_curve *curve, knot_ops *budget);

/* ---- job.c: one reading of the topology */

typedef enum knot_job_stage {
    KNOT_JOB_IDLE,
    KNOT_JOB_CORE,
    KNOT_JOB_CURVES,
    KNOT_JOB_LOCATE,
    KNOT_JOB_DONE
} knot_job_stage;

/* The closed curves of a reading, in the order in which they are read. */
typedef enum knot_curve_kind {
    KNOT_CURVE_OUTWARD,
    KNOT_CURVE_TAIL,  /* the tail limb and the ray away from the tissue */
    KNOT_CURVE_LONG,  /* the same of the long limb */
    KNOT_CURVE_TOOLS, /* ends continued through the tools that hold them */
    KNOT_CURVE_OTHERS /* and the following: other directions */
} knot_curve_kind;

typedef struct knot_job {
    knot_input input; /* a copy of what was shown */
    uint64_t step;    /* when */
    knot_job_stage stage;
    uint32_t curve; /* KNOT_JOB_CURVES: a knot_curve_kind or more */
    bool curve_began;
    knot_closure closure;
    knot_core core;
    knot_curve reader;
    knot_locator locator;
    knot_ops ops_used;
    /* What was read. */
    knot_reading outward, tail, long_limb, tools;
    bool has_tools;
    uint32_t agreeing;
} knot_job;
bool vbss_knot_job_is_active(const knot_job *job);
/* Reads the scene in it. */
void vbss_knot_job_begin(knot_job *job, const vbss_knot_config *config, uint64_t step);
/* True when it is done; what is then left of `work` stays. */
bool vbss_knot_job_resume(knot_job *job, const vbss_knot_config *config, knot_ops *budget);

/* ---- the detector (detector.c) */

typedef struct knot_tool_state {
    bool wrapped;
    bool wrong_sense; /* told since it was wrapped */
    vbss_knot_held held;
    knot_winding winding;
} knot_tool_state;

typedef struct knot_event {
    uint32_t kind, numbers[3];
} knot_event;

typedef struct knot_detector {
    vbss_context *context;
    vbss_knot_config config;
    knot_input input; /* in the last step */
    knot_tool_state *tools;
    knot_job job;
    knot_paper paper;
    bool reading_due;               /* a reading is wanted as soon as there is none under way */
    bool thread_may_differ;         /* it may not be the thread that was read before */
    uint64_t steps, job_start_step; /* job_began: step, of the last */
    vbss_knot_state state;
    knot_classification classification;
    knot_event *events;
    uint32_t event_count, events_lost;
    vbss_knot_statistics statistics; /* without those of the reading under way */
    uint32_t *loop_rows;             /* x 4, for the view */
    uint64_t generation;
} knot_detector;
extern const vbss_kind vbss_knot_kind;
vbss_result vbss_knot_open(const vbss_knot_detector *handle, knot_detector **detector);
/* config.c */
extern const vbss_layout vbss_knot_config_layout;
vbss_result vbss_knot_check_config(vbss_context *context, const vbss_knot_config *config);
/* paper_step.c */
void vbss_knot_paper_step(knot_detector *detector);
/* input.c: checks all of it, then copies it to `scene`, which has room. */
vbss_result vbss_knot_read_input(const knot_detector *detector, const vbss_knot_input *input,
                                 knot_input *copy);
void vbss_knot_input_copy(knot_input *to, const knot_input *from);
void vbss_knot_emit_event(knot_detector *detector, vbss_knot_event kind, uint32_t a, uint32_t b,
                          uint32_t c);
/* classification.c: what a reading that ended changes. `follows`: the thread is the one of the last reading, moved. */
void vbss_knot_classify(knot_detector *detector, bool follows);
/* What is being tied, from winding and the last reading. */
void vbss_knot_classify_next(knot_detector *detector);
/* Adds the counts of a reading that ended, or is under way, to figures. */
void vbss_knot_count_job(const knot_job *job, vbss_knot_statistics *statistics);
void vbss_knot_serialise(vbss_stream *stream, void *object);

#endif
