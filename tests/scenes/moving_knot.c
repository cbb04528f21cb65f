#include "scenes/moving_knot.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/linear.h"
#include "base/stream.h"

#include <string.h>

#define TURN 6.28318530717958648
#define COIL_RADIUS 2.5e-3
#define TOOL_RADIUS 1.5e-3
#define TOOL_LENGTH 0.2
#define TISSUE_DEPTH 0.03

enum { TAIL = 12, DRAIN = 4, LIMB = 8, COIL = 36, NEEDLE = 12 }; /* segments of the parts */
_Static_assert(TAIL + DRAIN + LIMB + COIL + NEEDLE + 1 == MOVING_KNOT_POINTS, "all of the thread");

/* ---- the script */

/* Signed turns about the grasper, looking from its tip to its handle, that a throw is wound with. */
static const double turns_of[] = {1.5, -2.5, -1.5, 2.5};
enum { THROWS = 4, WRONG_WAY = 2 };

static uint64_t throw_at(uint64_t step)
{
    return step / MOVING_KNOT_PERIOD % THROWS;
}

static double turns_at(uint64_t step)
{
    return turns_of[throw_at(step)];
}

int32_t moving_knot_wraps(uint64_t step)
{
    return throw_at(step) == WRONG_WAY ? 0 : fabs(turns_at(step)) > 2.0 ? 2 : 1;
}

int32_t moving_knot_handedness(uint64_t step)
{
    return turns_at(step) > 0.0 ? -1 : 1;
}

/* How much of a part of the script is done: 0 before it, 1 after it. */
static double done(uint64_t step, int first, int end)
{
    double at = (double)(step % MOVING_KNOT_PERIOD);
    return vbss_min(vbss_max((at - first) / (double)(end - first), 0.0), 1.0);
}

static double tail_end_at(uint64_t step)
{
    double x = 0.03 - 0.029 * done(step, MOVING_KNOT_TAKEN, MOVING_KNOT_DRAWN);
    x -= 0.036 * done(step, MOVING_KNOT_DRAWN, MOVING_KNOT_RELEASED);
    return x + 0.065 * done(step, MOVING_KNOT_SLIPPING, MOVING_KNOT_PERIOD);
}

/* ---- the thread */

typedef struct line {
    moving_knot *shown;
    uint32_t count;
} line;

static void put(line *l, vec3 x)
{
    vec3_store(l->shown->points[l->count++], x);
}

/* So many segments to a point; the last one put is where they begin. */
static void go_to(line *l, vec3 end, uint32_t segments)
{
    vec3 begin = vec3_load(l->shown->points[l->count - 1]);
    for (uint32_t i = 1; i <= segments; i++) {
        put(l, vec3_lerp(begin, end, (double)i / segments));
    }
}

/* Never quite the same from step to step. */
static vec3 swayed(vec3 x, double phase, uint64_t step)
{
    double by = 2e-4 * vbss_sin(0.37 * (double)step + phase);
    return vec3_add(x, vec3_make(0.3 * by, by, -0.5 * by));
}

static vec3 beside_tool(double x, double radius, double turns)
{
    double sine, cosine; /* from below on; positive: seen from the tip, from y to z */
    vbss_sincos(TURN * (turns - 0.25), &sine, &cosine);
    return vec3_make(x, radius * cosine, radius * sine);
}

static void lay_thread(uint64_t step, moving_knot *shown)
{
    line l = {shown, 0};
    double turns = -turns_at(step) * done(step, 0, MOVING_KNOT_TAKEN), t = (double)step;
    put(&l, vec3_make(tail_end_at(step), 1e-4 * vbss_sin(0.21 * t), 0.0));
    go_to(&l, vec3_make(0.006, 0.0, 0.0), TAIL / 4);
    go_to(&l, swayed(vec3_make(0.01, 0.0, -0.004), 1.0, step), TAIL / 4);
    go_to(&l, vec3_make(0.004, 0.0, -TISSUE_DEPTH), TAIL / 2);
    go_to(&l, vec3_make(-0.004, 0.0, -TISSUE_DEPTH), DRAIN);
    bool wrong = throw_at(step) == WRONG_WAY;
    const double from = wrong ? -0.004 : -0.014, to = wrong ? -0.014 : -0.004;
    go_to(&l, swayed(beside_tool(from, COIL_RADIUS, 0.0), 2.0, step), LIMB);
    for (uint32_t i = 1; i <= COIL; i++) {
        double share = (double)i / COIL;
        vec3 x = beside_tool(from + share * (to - from), COIL_RADIUS, turns * share);
        put(&l, swayed(x, 2.0 + share, step));
    }
    go_to(&l, beside_tool(to, 0.07, turns), NEEDLE);
}

/* ---- the tools */

static void point_tool(vbss_knot_tool *tool, vec3 tip, vec3 handle)
{
    vec3 wrist = vec3_lerp(tip, handle, 0.1);
    tool->point_count = 3;
    tool->radius[0] = TOOL_RADIUS;
    tool->radius[1] = 0.8 * TOOL_RADIUS;
    vec3_store(tool->axis[0], handle);
    vec3_store(tool->axis[1], wrist);
    vec3_store(tool->axis[2], tip);
}

static void lay_tools(uint64_t step, moving_knot *shown)
{
    uint64_t at = step % MOVING_KNOT_PERIOD;
    vbss_knot_tool *grasper = &shown->tools[0], *driver = &shown->tools[1];
    double tip = 0.0;
    *grasper = *driver = (vbss_knot_tool){.held = VBSS_KNOT_HELD_NOTHING};
    if (at >= MOVING_KNOT_DRAWN) { /* a millimetre of the tail is between the jaws */
        tip = tail_end_at(step) + 1e-3;
    }
    if (at >= MOVING_KNOT_DRAWN && at < MOVING_KNOT_RELEASED) {
        vec3 first = vec3_load(shown->points[0]), second = vec3_load(shown->points[1]);
        grasper->held = VBSS_KNOT_HELD_THREAD;
        grasper->held_place = vbss_min(1e-3 / vbss_max(vec3_distance(first, second), 1e-4), 1.0);
    } else if (at >= MOVING_KNOT_RELEASED) {
        tip = -0.036 - 0.05 * done(step, MOVING_KNOT_RELEASED, MOVING_KNOT_SLIPPING);
    }
    point_tool(grasper, vec3_make(tip, 0.0, 0.0), vec3_make(tip - TOOL_LENGTH, 0.0, 0.0));
    vec3 needle = vec3_load(shown->points[MOVING_KNOT_POINTS - 1]);
    driver->held = VBSS_KNOT_HELD_NEEDLE;
    point_tool(driver, needle, vec3_scale(needle, 3.0));
}

vbss_result moving_knot_show(uint64_t step, moving_knot *shown)
{
    lay_thread(step, shown);
    lay_tools(step, shown);
    VBSS_TRY(vbss_knot_input_init(&shown->input, sizeof shown->input));
    shown->input.points = shown->points[0];
    shown->input.point_count = MOVING_KNOT_POINTS;
    shown->input.tools = shown->tools;
    shown->input.tool_count = MOVING_KNOT_TOOLS;
    shown->input.hole_count = 2;
    for (uint32_t i = 0; i < 2; i++) {
        shown->input.hole_places[i] = TAIL + (i == 0 ? 0.0 : DRAIN);
        shown->input.away[2] = -1.0;
    }
    /* A new throw begins with another thread, as it were. */
    shown->input.may_have_passed = step % MOVING_KNOT_PERIOD == 0;
    return VBSS_OK;
}

/* ---- the detector */

vbss_result moving_knot_config(vbss_knot_config *config)
{
    VBSS_TRY(vbss_knot_config_init(config, sizeof *config));
    config->point_capacity = MOVING_KNOT_POINTS;
    config->tool_capacity = MOVING_KNOT_TOOLS;
    config->crossing_capacity = 64;
    config->closure_tolerance = 0; /* so that some readings are uncertain */
    config->interval = 3;
    return VBSS_OK;
}

vbss_result moving_knot_step(vbss_knot_detector *detector)
{
    vbss_knot_state state;
    moving_knot shown;
    VBSS_TRY(vbss_knot_detector_get_state(detector, &state, sizeof state));
    VBSS_TRY(moving_knot_show(state.steps, &shown));
    return vbss_knot_detector_step(detector, &shown.input);
}

/* ---- what hosts see */

static void add_events(vbss_stream *stream, const vbss_view *view)
{
    for (uint64_t i = 0; i < view->count; i++) {
        const uint8_t *row = (const uint8_t *)view->data + i * view->stride_bytes;
        uint32_t numbers[4];
        memcpy(numbers, row, sizeof numbers);
        vbss_stream_u32(stream, 2, numbers, 4);
    }
}

static void add_throw(vbss_stream *stream, vbss_knot_throw *t)
{
    vbss_stream_i32(stream, 3, &t->verdict, 3);
    vbss_stream_u32(stream, 4, &t->flags, 1);
    vbss_stream_f64(stream, 5, t->tail_places, 2);
    vbss_stream_f64(stream, 6, t->long_places, 2);
    vbss_stream_f64(stream, 7, &t->slip, 1);
    vbss_stream_f64(stream, 8, &t->tail_length, 1);
}

static void add_winding(vbss_stream *stream, vbss_knot_winding *w)
{
    vbss_stream_f64(stream, 9, &w->turns, 1);
    vbss_stream_f64(stream, 10, &w->run_turns, 1);
    vbss_stream_f64(stream, 11, w->run_places, 2);
    vbss_stream_f64(stream, 12, w->run_heights, 2);
    vbss_stream_i32(stream, 13, &w->sense, 1);
}

vbss_result moving_knot_hash(vbss_knot_detector *detector, uint64_t *hash)
{
    vbss_stream stream;
    uint64_t own;
    vbss_knot_state state;
    vbss_stream_begin_hash(&stream);
    VBSS_TRY(vbss_knot_detector_get_hash(detector, &own));
    vbss_stream_u64(&stream, 1, &own, 1);
    for (vbss_knot_field field = VBSS_KNOT_VIEW_EVENTS; field <= VBSS_KNOT_VIEW_LOOPS; field++) {
        vbss_view view;
        VBSS_TRY(vbss_knot_detector_get_view(detector, field, &view, sizeof view));
        add_events(&stream, &view);
    }
    VBSS_TRY(vbss_knot_detector_get_state(detector, &state, sizeof state));
    for (uint32_t i = 0; i < state.throw_count; i++) {
        vbss_knot_throw t;
        VBSS_TRY(vbss_knot_detector_get_throw(detector, i, &t, sizeof t));
        add_throw(&stream, &t);
    }
    vbss_knot_winding w;
    for (uint32_t i = 0; vbss_knot_detector_get_winding(detector, i, &w, sizeof w) == VBSS_OK;
         i++) {
        add_winding(&stream, &w);
    }
    *hash = vbss_hash_end(&stream.hash);
    return stream.result;
}
