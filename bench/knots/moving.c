/* The same work spread over steps, as a host has it: what a step costs at most, and how many steps later a verdict is
 * told. A knot that sways (an affine map of space, which changes no type), and throws being tied. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "knot/judge.h"
#include "knots/bench_knots.h"
#include "knots/reported.h"
#include "fixtures/wrap_scripts.h"

#define TURN 6.28318530717958648

enum { STEPS = 10000, QUICK_STEPS = 200, SIZES = 5, STORY_STEPS = 2000 };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240, 300};
/* A swaying knot: "three throws" of this seed. */
enum { SWAYING_SEED = 93 };

typedef enum moving_kind {
    MOVING_SWAYING, /* the ends are in tools */
    MOVING_OPEN,    /* an end lies inside: all closures are read, and there is no truth */
    MOVING_TYING    /* stories, one after the other */
} moving_kind;
static const char *const kind_names[] = {"swaying", "swaying-open", "tying"};

static const struct {
    uint32_t script, variant;
} stories[] = {{1, 0}, {1, 1}, {2, 0}, {3, 0}, {3, 3}};
enum { STORIES = sizeof stories / sizeof stories[0] };
_Static_assert((int)STORIES *(int)STORY_STEPS == (int)STEPS, "one after the other");

typedef struct row {
    char name[64];
    moving_kind kind;
    uint32_t segments, steps;
    uint32_t at; /* step, of a run */

    vbss_context *context;
    vbss_knot_detector *detector;
    family_case *base, *shown; /* what sways, and where it is; or only its truth */
    script_frame *frame;
    vbss_knot_tool tools[SCRIPT_TOOLS];
    vbss_knot_input input;
    /* counted in the first repetition */
    uint64_t reading_step;
    reported_counts reported;
    double steps_sum, steps_max;    /* delay from a knot to its report */
    uint32_t passed_at, passed_max; /* delay from a throw to its report */
    uint32_t readings;
    bool counted;
} row;

static row rows[2 * SIZES + 1];

/* ---- what is shown */

static vec3 swayed(vec3 x, double t)
{
    double a = vbss_sin(TURN * 0.31 * t), b = vbss_sin(TURN * 0.53 * t + 1.0), sine, cosine;
    vec3 y = vec3_make(x.x * (1.0 + 0.15 * a), x.y * (1.0 - 0.1 * b) + 0.2 * b * x.x,
                       x.z * (1.0 + 0.1 * b) + 0.1 * a * x.y);
    vbss_sincos(0.5 * t, &sine, &cosine);
    return vec3_make(cosine * y.x - sine * y.y, sine * y.x + cosine * y.y, y.z);
}

static void put_tool(vbss_knot_tool *tool, const thread_line *line, uint32_t last, uint32_t before)
{
    vec3 tip = line->x[last];
    vec3 out = vec3_unit_or(vec3_sub(tip, line->x[before]), vec3_make(1.0, 0.0, 0.0));
    *tool = (vbss_knot_tool){.point_count = 3, .radius = {2e-3, 1e-3}};
    vec3_store(tool->axis[0], vec3_add_scaled(tip, 0.3, out));
    vec3_store(tool->axis[1], vec3_add_scaled(tip, 0.01, out));
    vec3_store(tool->axis[2], tip);
    tool->held = last > before ? VBSS_KNOT_HELD_NEEDLE : VBSS_KNOT_HELD_THREAD;
    tool->held_place = 0.0;
}

static void show_swaying(row *r, uint32_t step)
{
    const double t = 1e-3 * step;
    const thread_line *from = &r->base->line;
    thread_line *to = &r->shown->line;
    for (uint32_t i = 0; i < from->count; i++) {
        to->x[i] = swayed(from->x[i], t);
    }
    for (int i = 0; i < 2; i++) {
        to->holes[i] = swayed(from->holes[i], t);
    }
    to->away = swayed(from->away, t);
    r->input = judge_input_of(to);
    put_tool(&r->tools[0], to, 0, 1);
    put_tool(&r->tools[1], to, to->count - 1, to->count - 2);
}

static void copy_tool(const script_tool *from, vbss_knot_tool *to)
{
    *to = (vbss_knot_tool){.point_count = from->points, .held_place = from->held_place};
    to->held = from->held == SCRIPT_HELD_NOTHING  ? VBSS_KNOT_HELD_NOTHING
               : from->held == SCRIPT_HELD_THREAD ? VBSS_KNOT_HELD_THREAD
                                                  : VBSS_KNOT_HELD_NEEDLE;
    for (uint32_t i = 0; i < from->points; i++) {
        vec3_store(to->axis[i], from->axis[i]);
    }
    for (uint32_t i = 0; i + 1 < from->points; i++) {
        to->radius[i] = from->radius[i];
    }
}

/* Where a step is in its story. */
static bool set_frame(row *r, uint32_t step)
{
    uint32_t k = step / STORY_STEPS;
    double t = (double)(step % STORY_STEPS) / (STORY_STEPS - 1);
    return wrap_script_frame(stories[k].script, stories[k].variant, t, r->segments, r->frame);
}

static void show_tying(row *r, uint32_t step)
{
    (void)set_frame(r, step);
    r->input = judge_input_of(&r->frame->line);
    r->input.may_have_passed = step % STORY_STEPS == 0; /* another story */
    for (int i = 0; i < SCRIPT_TOOLS; i++) {
        copy_tool(&r->frame->tools[i], &r->tools[i]);
    }
}

static void show(row *r)
{
    if (r->kind == MOVING_TYING) {
        show_tying(r, r->at);
    } else {
        show_swaying(r, r->at);
    }
    r->input.tools = r->tools;
    r->input.tool_count = SCRIPT_TOOLS;
}

/* ---- what is told */

/* Of the thread of a step; false: there is no telling. */
static bool set_truth(row *r, uint32_t step)
{
    const script_frame *f = r->frame;
    if (r->kind != MOVING_TYING) {
        return r->kind == MOVING_SWAYING;
    }
    (void)set_frame(r, step);
    family_case *truth = r->shown;
    truth->truth = FAMILY_THROWS;
    truth->line.count = f->line.count;
    truth->line.tissue_place = f->line.tissue_place;
    truth->throws = f->throws;
    memcpy(truth->wraps, f->throw_wraps, sizeof truth->wraps);
    memcpy(truth->signs, f->throw_signs, sizeof truth->signs);
    return f->stage != SCRIPT_OPEN && f->stage != SCRIPT_PASSED;
}

/* A throw that would be tied if the tools withdrew now: how long until that, or that it is tied, is told. */
static void watch_passing(row *r, const vbss_knot_state *s)
{
    const script_frame *f = r->frame;
    bool passed = f->stage == SCRIPT_PASSED;
    bool is_reported = s->next_verdict == VBSS_KNOT_VERDICT_PASSED || s->throw_count > f->throws;
    uint32_t now = r->at + 1;
    if (!passed) {
        r->passed_at = 0;
        return;
    }
    if (r->passed_at == 0) {
        r->passed_at = now;
    }
    if (!is_reported && now - r->passed_at + 1 > r->passed_max) {
        r->passed_max = now - r->passed_at + 1;
    }
}

static void count(row *r)
{
    vbss_knot_state s;
    if (vbss_knot_detector_get_state(r->detector, &s, sizeof s) != VBSS_OK) {
        return;
    }
    if (r->kind == MOVING_TYING) {
        watch_passing(r, &s);
    }
    if (s.reading_step == r->reading_step) {
        return;
    }
    double late = (double)(s.steps - s.reading_step);
    r->reading_step = s.reading_step;
    r->readings++;
    r->steps_sum += late;
    r->steps_max = vbss_max(late, r->steps_max);
    if (set_truth(r, (uint32_t)s.reading_step - 1)) {
        reported t = reported_by_judge(r->detector, r->shown);
        reported_add(&r->reported, &t);
    }
}

/* ---- the cases */

static void tear_down(void *user)
{
    row *r = user;
    vbss_context_destroy(r->context);
    free(r->base);
    free(r->shown);
    free(r->frame);
    r->context = NULL;
    r->base = r->shown = NULL;
    r->frame = NULL;
}

static int set_up(void *user)
{
    row *r = user;
    const family *of = family_named(r->kind == MOVING_OPEN ? "ends inside" : "three throws");
    r->base = calloc(1, sizeof *r->base);
    r->shown = calloc(1, sizeof *r->shown);
    r->frame = calloc(1, sizeof *r->frame);
    r->counted = false;
    r->reported = (reported_counts){0};
    r->reading_step = 0;
    r->readings = r->passed_at = r->passed_max = 0;
    r->steps_sum = r->steps_max = 0.0;
    bool made = r->base != NULL && r->shown != NULL && r->frame != NULL &&
                vbss_context_create(NULL, &r->context) == VBSS_OK &&
                vbss_knot_detector_create(r->context, NULL, &r->detector) == VBSS_OK;
    for (uint64_t seed = SWAYING_SEED; made && r->kind != MOVING_TYING; seed++) {
        if (of->make(seed, r->segments, r->base)) {
            *r->shown = *r->base;
            break;
        }
    }
    if (!made) {
        tear_down(r);
    }
    return made ? 0 : 1;
}

static int restore(void *user)
{
    row *r = user;
    r->counted = r->at > 0;
    r->at = 0;
    show(r);
    return vbss_knot_detector_reset(r->detector) == VBSS_OK ? 0 : 1;
}

static int step(void *user, uint32_t index)
{
    row *r = user;
    (void)index;
    return vbss_knot_detector_step(r->detector, &r->input) == VBSS_OK ? 0 : 1;
}

/* Looks, then shows the next step. */
static uint64_t hash(void *user)
{
    row *r = user;
    uint64_t value = 0;
    (void)vbss_knot_detector_get_hash(r->detector, &value);
    if (!r->counted) {
        count(r);
    }
    if (++r->at < r->steps) {
        show(r);
    }
    return value;
}

static void finish(void *user, bench_result *result)
{
    row *r = user;
    vbss_knot_detector_statistics s;
    if (vbss_knot_detector_get_statistics(r->detector, &s, sizeof s) != VBSS_OK ||
        r->readings == 0) {
        bench_fail(result, "nothing was read");
        return;
    }
    bench_simulated_step(result, 1e3);
    bench_counter(result, "readings", r->readings);
    bench_counter(result, "verdict_steps_mean", r->steps_sum / r->readings);
    bench_counter(result, "verdict_steps_max", r->steps_max);
    bench_counter(result, "step_work_max", (double)s.most_step_work);
    if (r->reported.configurations > 0) {
        reported_report(&r->reported, result);
    }
    if (r->kind == MOVING_TYING) {
        bench_counter(result, "passed_steps_max", r->passed_max);
    }
}

static void add(bench *b, row *r, moving_kind kind, uint32_t segments)
{
    *r =
        (row){.kind = kind, .segments = segments, .steps = bench_is_quick(b) ? QUICK_STEPS : STEPS};
    snprintf(r->name, sizeof r->name, "knots/%s/topology/%u", kind_names[kind], (unsigned)segments);
    bench_add_stepped(b, &(bench_stepped){.name = r->name,
                                          .user = r,
                                          .steps = r->steps,
                                          .dt_us = 1e3,
                                          .deadline_us = 20.0,
                                          .setup = set_up,
                                          .restore = restore,
                                          .step = step,
                                          .hash = hash,
                                          .finish = finish,
                                          .teardown = tear_down});
}

void add_moving_cases(bench *b)
{
    for (int i = 0; i < SIZES; i++) {
        if (!bench_is_quick(b) || sizes[i] == 240) {
            add(b, &rows[i], MOVING_SWAYING, sizes[i]);
            add(b, &rows[(size_t)SIZES + (size_t)i], MOVING_OPEN, sizes[i]);
        }
    }
    add(b, &rows[2 * (size_t)SIZES], MOVING_TYING, 240);
}
