/* Stepped scenes: threads that move are told to a collision object, which lists the pairs of segments
 * worth testing, and tests them.
 *
 * collision/search: the search alone on the coil of N segments, whose neighbours do not depend on N.
 * Every step is a new motion, so boxes and tree are made again. Beside it the tree of FCL, fitted to the
 * same boxes, and all pairs of boxes, each told in the same way.
 *   candidates: pairs of a step, of each segment (the peers' hold those that are near along the thread);
 *   boxes_tested: pairs of boxes looked at, of each segment.
 * The bar: up to N = 10000 time grows at most as N^1.1.
 *
 * collision/knot and collision/coil: search and tests of a thread of 240 segments, by each method. The
 * deadline is what the guard may take of a step of 1 ms. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/error.h"
#include "base/hash.h"
#include "collision/bench_collision.h"
#include "collision/moving.h"
#include "vblast_ss/collision.h"
#if defined(VBSS_HAVE_FCL)
#include "collision/fcl_reference.h"
#endif

enum { SIZES = 6, FEW = 1000, STEPS = 50, WHOLE = 240, WHOLE_STEPS = 200 };
static const uint32_t sizes[SIZES] = {250, 500, FEW, 2500, 5000, 10000};

#define STEP_S 1e-3
#define GUARD_US 80.0

typedef struct walk walk;

/* What is done in a step. */
typedef struct walk_method {
    const char *name;
    vbss_collision_method test;
    bool tests; /* the search is followed by tests */
    int (*begin)(walk *w);
    int (*step)(walk *w, uint32_t index);
    void (*end)(walk *w);
    uint32_t n_max; /* 0: none */
} walk_method;

struct walk {
    char name[64];
    const walk_method *method;
    moving_kind kind;
    uint32_t segments, steps;
    moving motion;
    double *boxes; /* low and high of each segment */
    vbss_context *context;
    vbss_collision *collision;
    uint32_t thread;
    void *tree;
    uint64_t pairs, found, sum; /* of the step: number, told by impacts, and a hash of them */
    uint64_t all_pairs, all_found, counted; /* of all steps */
};

/* ---- ours */

static void end_ours(walk *w)
{
    vbss_context_destroy(w->context);
    w->context = NULL;
    w->collision = NULL;
}

static vbss_result make_ours(walk *w)
{
    vbss_collision_config config;
    VBSS_TRY(vbss_context_create(NULL, &w->context));
    VBSS_TRY(vbss_collision_config_init(&config, sizeof config));
    config.method = w->method->test;
    config.pair_capacity = 64 * w->segments;
    config.impact_capacity = 64 * w->segments;
    VBSS_TRY(vbss_collision_create(w->context, &config, &w->collision));
    double *rest = malloc(w->segments * sizeof *rest);
    if (rest == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (uint32_t i = 0; i < w->segments; i++) {
        rest[i] = w->motion.length;
    }
    vbss_result result =
        vbss_collision_add_chain(w->collision, w->segments + 1, rest, MOVING_RADIUS, &w->thread);
    free(rest);
    VBSS_TRY(result);
    const double *first = moving_at(&w->motion, 0);
    return vbss_collision_set_motion(w->collision, w->thread, first, first, w->segments + 1);
}

static int begin_ours(walk *w)
{
    end_ours(w);
    return (int)make_ours(w);
}

static uint64_t hash_view(vbss_collision *collision, vbss_collision_field field, uint64_t *count)
{
    vbss_view view;
    vbss_hash hash;
    vbss_hash_begin(&hash);
    if (vbss_collision_get_view(collision, field, &view, sizeof view) == VBSS_OK) {
        *count = view.count;
        vbss_hash_add(&hash, view.data, (size_t)view.count * view.stride_bytes);
    }
    return vbss_hash_end(&hash);
}

static int step_ours(walk *w, uint32_t index)
{
    vbss_result result = vbss_collision_set_motion(
        w->collision, w->thread, NULL, moving_at(&w->motion, index + 1), w->segments + 1);
    if (result == VBSS_OK) {
        result = vbss_collision_find_candidates(w->collision);
    }
    if (result == VBSS_OK && w->method->tests) {
        result = vbss_collision_find_impacts(w->collision);
    }
    return (int)result;
}

/* ---- boxes, told pair by pair */

static void count_pair(void *user, uint32_t i, uint32_t j)
{
    walk *w = user;
    if (j - i > 1) {
        w->pairs++;
        w->sum += ((uint64_t)i << 32 | j) * 0x9e3779b97f4a7c15u; /* in whatever order */
    }
}

static void end_boxes(walk *w)
{
    free(w->boxes);
    w->boxes = NULL;
}

static int begin_boxes(walk *w)
{
    end_boxes(w);
    w->boxes = calloc(6 * (size_t)w->segments, sizeof *w->boxes);
    return w->boxes != NULL ? 0 : 1;
}

static bool overlap(const double *a, const double *b)
{
    return a[0] <= b[3] && b[0] <= a[3] && a[1] <= b[4] && b[1] <= a[4] && a[2] <= b[5] &&
           b[2] <= a[5];
}

static int step_boxes(walk *w, uint32_t index)
{
    w->pairs = w->sum = 0;
    for (uint32_t i = 0; i < w->segments; i++) {
        double *box = w->boxes + 6 * (size_t)i;
        moving_box(&w->motion, index, i, box, box + 3);
    }
    for (uint32_t i = 0; i < w->segments; i++) {
        for (uint32_t j = i + 2; j < w->segments; j++) {
            if (overlap(w->boxes + 6 * (size_t)i, w->boxes + 6 * (size_t)j)) {
                count_pair(w, i, j);
            }
        }
    }
    return 0;
}

#if defined(VBSS_HAVE_FCL)
static void end_fcl(walk *w)
{
    fcl_boxes_destroy(w->tree);
    w->tree = NULL;
}

static int begin_fcl(walk *w)
{
    end_fcl(w);
    w->tree = fcl_boxes_create(w->segments);
    return w->tree != NULL ? 0 : 1;
}

static int step_fcl(walk *w, uint32_t index)
{
    w->pairs = w->sum = 0;
    for (uint32_t i = 0; i < w->segments; i++) {
        double low[3], high[3];
        moving_box(&w->motion, index, i, low, high);
        fcl_boxes_set(w->tree, i, low, high);
    }
    fcl_boxes_find_pairs(w->tree, count_pair, w);
    return 0;
}
#endif

/* ---- a scene */

static int setup_walk(void *user)
{
    walk *w = user;
    return moving_make(&w->motion, w->kind, w->segments, w->steps) ? 0 : 1;
}

static int begin_walk(void *user)
{
    walk *w = user;
    w->all_pairs = w->all_found = w->counted = 0;
    return w->method->begin(w);
}

static int step_walk(void *user, uint32_t index)
{
    walk *w = user;
    return w->method->step(w, index);
}

/* Looks at what the step found, too, as that is not timed. */
static uint64_t hash_walk(void *user)
{
    walk *w = user;
    if (w->collision != NULL) {
        w->found = 0;
        w->sum = hash_view(w->collision, VBSS_COLLISION_VIEW_CANDIDATES, &w->pairs);
        if (w->method->tests) {
            w->sum ^= hash_view(w->collision, VBSS_COLLISION_VIEW_IMPACTS, &w->found);
            w->sum += hash_view(w->collision, VBSS_COLLISION_VIEW_TIMES, &w->found);
        }
    }
    w->all_pairs += w->pairs;
    w->all_found += w->found;
    w->counted++;
    return w->sum + w->pairs;
}

static void finish_walk(void *user, bench_result *result)
{
    const walk *w = user;
    double steps = (double)w->counted, segments = w->segments;
    vbss_collision_statistics statistics;
    bench_counter(result, "ns_per_segment",
                  1e3 * bench_counter_value(result, "median_us") / segments);
    bench_counter(result, "candidates", (double)w->all_pairs / steps / segments);
    if (w->method->tests) {
        bench_counter(result, "impacts", (double)w->all_found / steps);
    }
    if (w->collision != NULL &&
        vbss_collision_get_statistics(w->collision, &statistics, sizeof statistics) == VBSS_OK) {
        bench_counter(result, "boxes_tested",
                      (double)statistics.boxes_tested / (double)statistics.searches / segments);
    }
}

static void end_walk(void *user)
{
    walk *w = user;
    w->method->end(w);
    moving_release(&w->motion);
}

/* ---- cases */

static const walk_method searches[] = {
    {.name = "ours", .begin = begin_ours, .step = step_ours, .end = end_ours},
#if defined(VBSS_HAVE_FCL)
    {.name = "fcl-tree", .begin = begin_fcl, .step = step_fcl, .end = end_fcl},
#else
    {.name = "fcl-tree"},
#endif
    {.name = "all-pairs", .begin = begin_boxes, .step = step_boxes, .end = end_boxes, .n_max = FEW},
};
enum { SEARCHES = sizeof searches / sizeof searches[0] };

static const walk_method wholes[] = {
    {.name = "conservative",
     .test = VBSS_COLLISION_METHOD_CONSERVATIVE,
     .tests = true,
     .begin = begin_ours,
     .step = step_ours,
     .end = end_ours},
    {.name = "paper",
     .test = VBSS_COLLISION_METHOD_VBLAST,
     .tests = true,
     .begin = begin_ours,
     .step = step_ours,
     .end = end_ours},
    {.name = "cubic",
     .test = VBSS_COLLISION_METHOD_CUBIC,
     .tests = true,
     .begin = begin_ours,
     .step = step_ours,
     .end = end_ours},
    {.name = "search", .begin = begin_ours, .step = step_ours, .end = end_ours},
};
enum { WHOLES = sizeof wholes / sizeof wholes[0] };

static void add_walk(bench *b, walk *w, double deadline_us)
{
    if (w->method->begin == NULL) {
        bench_add_skipped(b, w->name, "not installed");
        return;
    }
    bench_add_stepped(b, &(bench_stepped){.name = w->name,
                                          .user = w,
                                          .steps = w->steps,
                                          .dt_us = STEP_S * 1e6,
                                          .deadline_us = deadline_us,
                                          .setup = setup_walk,
                                          .restore = begin_walk,
                                          .step = step_walk,
                                          .hash = hash_walk,
                                          .finish = finish_walk,
                                          .teardown = end_walk});
}

static void add_searches(bench *b)
{
    static walk walks[SIZES][SEARCHES];
    for (size_t i = 0; i < SIZES; i++) {
        for (size_t m = 0; m < SEARCHES; m++) {
            walk *w = &walks[i][m];
            if (searches[m].n_max != 0 && sizes[i] > searches[m].n_max) {
                continue;
            }
            *w = (walk){
                .method = &searches[m], .kind = MOVING_COIL, .segments = sizes[i], .steps = STEPS};
            snprintf(w->name, sizeof w->name, "collision/search/%s/%u", searches[m].name,
                     (unsigned)sizes[i]);
            add_walk(b, w, 0.0);
        }
    }
    bench_add_growth(
        b, &(bench_growth){.name = "collision/search/ours", .family = "collision/search/ours"});
}

void add_broad_cases(bench *b)
{
    static walk walks[2][WHOLES];
    for (size_t scene = 0; scene < 2; scene++) {
        for (size_t m = 0; m < WHOLES; m++) {
            walk *w = &walks[scene][m];
            *w = (walk){.method = &wholes[m],
                        .kind = scene == 0 ? MOVING_KNOT : MOVING_COIL,
                        .segments = WHOLE,
                        .steps = WHOLE_STEPS};
            snprintf(w->name, sizeof w->name, "collision/%s/%s/%u", scene == 0 ? "knot" : "coil",
                     wholes[m].name, (unsigned)WHOLE);
            add_walk(b, w, GUARD_US);
        }
    }
    add_searches(b);
}
