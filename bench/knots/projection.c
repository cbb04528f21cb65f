/* Method PROJECTION: throws being tied by formula, of which it is told whether they are; and the eight cases in which
 * its loops are miscounted, beside what winding about the tool says of them. */
#include <stdio.h>
#include <string.h>

#include "knots/bench_knots.h"

#include "fixtures/paper_knot_cases.h"
#include "fixtures/paper_tying.h"

/* ---- what both have */

typedef struct watcher {
    vbss_context *context;
    vbss_knot_detector *detector;
    vbss_knot_tool tool;
    vec3 points[PAPER_TYING_POINTS];
    vbss_knot_input input;
} watcher;

static int begin(watcher *w, vbss_knot_method method)
{
    vbss_knot_detector_config config;
    w->tool = paper_knot_tool();
    (void)vbss_knot_input_init(&w->input, sizeof w->input);
    w->input.points = &w->points[0].x;
    w->input.tools = &w->tool;
    w->input.tool_count = 1;
    if (vbss_knot_detector_config_init(&config, sizeof config) != VBSS_OK ||
        vbss_context_create(NULL, &w->context) != VBSS_OK) {
        return 1;
    }
    config.method = method;
    config.interval = UINT32_MAX; /* TOPOLOGY: winding only */
    if (vbss_knot_detector_create(w->context, &config, &w->detector) != VBSS_OK) {
        vbss_context_destroy(w->context);
        return 1;
    }
    return 0;
}

/* ---- throws being tied */

#define TILT 0.26
enum { SEEDS = 1000, QUICK_SEEDS = 20, SEGMENTS = 4, FAMILIES_TIED = 10 };
static const double segments[SEGMENTS] = {5e-3, 2.5e-3, 1e-3, 0.5e-3};

static const struct tied_family {
    const char *name;
    paper_tying_stage stage;
    uint32_t wraps;
    bool towards_handle;
} tied_families[FAMILIES_TIED] = {
    {"wrapped-none", PAPER_TYING_WRAPPED, 0, false},
    {"wrapped-single", PAPER_TYING_WRAPPED, 1, false},
    {"wrapped-double", PAPER_TYING_WRAPPED, 2, false},
    {"grasped-single", PAPER_TYING_GRASPED, 1, false},
    {"grasped-double", PAPER_TYING_GRASPED, 2, false},
    {"drawn-none", PAPER_TYING_DRAWN, 0, false},
    {"drawn-single", PAPER_TYING_DRAWN, 1, false},
    {"drawn-double", PAPER_TYING_DRAWN, 2, false},
    {"drawn-wrong-way-single", PAPER_TYING_DRAWN, 1, true},
    {"drawn-wrong-way-double", PAPER_TYING_DRAWN, 2, true},
};

typedef struct tying_row {
    char name[64];
    paper_tying tying;
    uint32_t steps, at;
    bool counted;
    uint32_t observed, right, wrong, undone;
    watcher watcher;
} tying_row;

static tying_row tying_rows[FAMILIES_TIED][SEGMENTS];

static void show_tying(tying_row *r)
{
    r->watcher.input.point_count =
        paper_tying_make(&r->tying, r->at + 1, r->watcher.points); /* from seed 1 on */
}

static int set_up_tying(void *user)
{
    tying_row *r = user;
    r->counted = false;
    r->at = r->observed = r->right = r->wrong = r->undone = 0;
    return begin(&r->watcher, VBSS_KNOT_METHOD_PROJECTION);
}

static int restore_tying(void *user)
{
    tying_row *r = user;
    r->counted = r->observed > 0;
    r->at = 0;
    show_tying(r);
    return vbss_knot_detector_reset(r->watcher.detector) == VBSS_OK ? 0 : 1;
}

static int step_watcher(watcher *w)
{
    return vbss_knot_detector_step(w->detector, &w->input) == VBSS_OK ? 0 : 1;
}

static int step_tying(void *user, uint32_t index)
{
    tying_row *r = user;
    (void)index;
    return step_watcher(&r->watcher);
}

/* Drawn through, the turns tie; before, and the wrong way, nothing does. */
static uint32_t truth_of(const paper_tying *tying)
{
    return tying->stage == PAPER_TYING_DRAWN && !tying->towards_handle ? tying->wraps : 0;
}

static uint64_t hash_tying(void *user)
{
    tying_row *r = user;
    vbss_knot_state s;
    (void)vbss_knot_detector_get_state(r->watcher.detector, &s, sizeof s);
    if (!r->counted) {
        bool right = s.loops == truth_of(&r->tying);
        r->observed++;
        r->right += right;
        r->wrong += !right;
        r->undone += s.undone > 0;
    }
    if (++r->at < r->steps) {
        show_tying(r);
    }
    return 1000 * s.loops + s.undone;
}

static void finish_tying(void *user, bench_result *result)
{
    tying_row *r = user;
    bench_counter(result, "configurations", r->observed);
    bench_counter(result, "right", r->right);
    bench_counter(result, "wrong", r->wrong);
    bench_counter(result, "uncertain", 0.0); /* it never is */
    bench_counter(result, "undone", r->undone);
}

static void end_watcher(watcher *w)
{
    vbss_context_destroy(w->context);
    w->context = NULL;
}

static void tear_down_tying(void *user)
{
    tying_row *r = user;
    end_watcher(&r->watcher);
}

/* About how many segments its threads have. */
static uint32_t usual_segments(const paper_tying *tying)
{
    static vec3 points[PAPER_TYING_POINTS];
    uint32_t sum = 0;
    enum { SAMPLES = 50 };
    for (uint64_t seed = 1; seed <= SAMPLES; seed++) {
        sum += paper_tying_make(tying, seed, points) - 1;
    }
    return sum / SAMPLES;
}

static void add_tying(bench *b, tying_row *r, const struct tied_family *of, double segment)
{
    *r = (tying_row){.tying = {of->stage, of->wraps, of->towards_handle, TILT, segment},
                     .steps = bench_is_quick(b) ? QUICK_SEEDS : SEEDS};
    snprintf(r->name, sizeof r->name, "knots/%s/projection/%u", of->name,
             (unsigned)usual_segments(&r->tying));
    bench_add_stepped(b, &(bench_stepped){.name = r->name,
                                          .user = r,
                                          .steps = r->steps,
                                          .setup = set_up_tying,
                                          .restore = restore_tying,
                                          .step = step_tying,
                                          .hash = hash_tying,
                                          .finish = finish_tying,
                                          .teardown = tear_down_tying});
}

/* ---- the eight cases */

enum { CASE_STEPS = 100, METHODS = 2 };
static const char *const case_names[PAPER_KNOT_KINDS] = {
    "case-A", "case-B", "case-C", "case-C2", "case-D", "case-E", "case-F", "case-G", "case-H"};

typedef struct case_row {
    char name[64];
    paper_knot_kind kind;
    vbss_knot_method method;
    watcher watcher;
} case_row;

static case_row case_rows[PAPER_KNOT_KINDS][METHODS];

static int set_up_case(void *user)
{
    case_row *r = user;
    watcher *w = &r->watcher;
    uint32_t count = paper_knot_make(r->kind, w->points);
    if (begin(w, r->method) != 0) {
        return 1;
    }
    w->input.point_count = count;
    if (r->method == VBSS_KNOT_METHOD_TOPOLOGY &&
        vbss_knot_detector_judge(r->watcher.detector, &r->watcher.input) != VBSS_OK) {
        end_watcher(&r->watcher);
        return 1;
    }
    return 0;
}

static int step_case(void *user, uint32_t index)
{
    case_row *r = user;
    (void)index;
    return step_watcher(&r->watcher);
}

/* Loops with the tool inside. */
static uint32_t count_loops(vbss_knot_detector *detector)
{
    vbss_view view;
    uint32_t inside = 0;
    if (vbss_knot_detector_get_view(detector, VBSS_KNOT_VIEW_LOOPS, &view, sizeof view) ==
        VBSS_OK) {
        for (uint64_t i = 0; i < view.count; i++) {
            uint32_t loop[4];
            memcpy(loop, (const unsigned char *)view.data + i * view.stride_bytes, sizeof loop);
            inside += loop[3];
        }
    }
    return inside;
}

/* PROJECTION is right when it counts the whole turns about the tool that there is (of E it counts one, of the wrong
 * pair); TOPOLOGY, when it tells the turns to a fiftieth. */
static void finish_case(void *user, bench_result *result)
{
    case_row *r = user;
    const paper_knot_case *c = &paper_knot_cases[r->kind];
    double turns = c->beside_tool ? c->turns : 0.0, reported = 0.0;
    bool right, as_paper = true;
    if (r->method == VBSS_KNOT_METHOD_PROJECTION) {
        reported = count_loops(r->watcher.detector);
        as_paper = (uint32_t)reported == c->loops;
        right = reported == floor(fabs(turns) + 0.5);
        bench_counter(result, "paper_count", reported);
    } else {
        vbss_knot_winding winding = {.turns = 0.0};
        (void)vbss_knot_detector_get_winding(r->watcher.detector, 0, &winding, sizeof winding);
        reported = winding.turns;
        right = fabs(reported - turns) <= 0.02;
        bench_counter(result, "told_turns", reported);
    }
    bench_counter(result, "truth_turns", turns);
    bench_counter(result, "configurations", 1.0);
    bench_counter(result, "right", right ? 1.0 : 0.0);
    bench_counter(result, "wrong", right ? 0.0 : 1.0);
    bench_counter(result, "uncertain", 0.0);
    if (!as_paper) {
        bench_fail(result, "%g loops instead of %u", reported, (unsigned)c->loops);
    } else if (!right && r->method == VBSS_KNOT_METHOD_TOPOLOGY) {
        bench_fail(result, "%g turns instead of %g", reported, turns);
    }
}

static void tear_down_case(void *user)
{
    case_row *r = user;
    end_watcher(&r->watcher);
}

static void add_case(bench *b, case_row *r, paper_knot_kind kind, vbss_knot_method method)
{
    static vec3 points[PAPER_KNOT_POINTS];
    *r = (case_row){.kind = kind, .method = method};
    snprintf(r->name, sizeof r->name, "knots/%s/%s/%u", case_names[kind],
             method == VBSS_KNOT_METHOD_TOPOLOGY ? "winding" : "projection",
             (unsigned)paper_knot_make(kind, points) - 1);
    bench_add_stepped(b, &(bench_stepped){.name = r->name,
                                          .user = r,
                                          .steps = CASE_STEPS,
                                          .setup = set_up_case,
                                          .step = step_case,
                                          .finish = finish_case,
                                          .teardown = tear_down_case});
}

void add_projection_cases(bench *b)
{
    for (int i = 0; i < FAMILIES_TIED; i++) {
        for (int k = 0; k < SEGMENTS; k++) {
            if (!bench_is_quick(b) || k == 0) {
                add_tying(b, &tying_rows[i][k], &tied_families[i], segments[k]);
            }
        }
    }
    for (paper_knot_kind kind = 0; kind < PAPER_KNOT_KINDS; kind++) {
        add_case(b, &case_rows[kind][0], kind, VBSS_KNOT_METHOD_TOPOLOGY);
        add_case(b, &case_rows[kind][1], kind, VBSS_KNOT_METHOD_PROJECTION);
    }
}
