/* How detectors begin and end, and their step: shown -> winding -> topology, some of it -> verdict. */
#include "base/check.h"
#include "base/error.h"
#include "knot/knot.h"

#include <string.h>

/* ---- memory: one table says what there is */

enum {
    PARTS = 6 + 2 + 2 * (3 + KNOT_REDUCTION_ARRAYS) + KNOT_PROJECTOR_ARRAYS +
            KNOT_CODES * KNOT_CODE_ARRAYS + KNOT_ALGEBRA_ARRAYS + 1 + 3 + KNOT_PAPER_ARRAYS + 1
};

static uint32_t list_scene(knot_scene *scene, const vbss_knot_config *c, vbss_array *parts)
{
    parts[0] = (vbss_array){&scene->points, c->point_capacity, sizeof *scene->points};
    parts[1] = (vbss_array){&scene->places, c->point_capacity, sizeof *scene->places};
    parts[2] = (vbss_array){&scene->tools, c->tool_capacity, sizeof *scene->tools};
    return 3;
}

static uint32_t list_polygon(knot_polygon *polygon, uint32_t capacity, vbss_array *parts)
{
    polygon->capacity = capacity;
    parts[0] = (vbss_array){&polygon->x, capacity, sizeof *polygon->x};
    parts[1] = (vbss_array){&polygon->place, capacity, sizeof *polygon->place};
    parts[2] = (vbss_array){&polygon->stays, capacity, sizeof *polygon->stays};
    return 3;
}

static uint32_t list_parts(knot_detector *d, vbss_array parts[PARTS])
{
    const vbss_knot_config *c = &d->config;
    const uint32_t vertices = c->point_capacity + KNOT_FIXED + KNOT_CLOSING;
    knot_curve *curve = &d->job.reader;
    knot_core *core = &d->job.core;
    uint32_t n = list_scene(&d->shown, c, parts);
    n += list_scene(&d->job.scene, c, parts + n);
    parts[n++] = (vbss_array){&d->tools, c->tool_capacity, sizeof *d->tools};
    parts[n++] = (vbss_array){&d->events, c->event_capacity, sizeof *d->events};
    n += list_polygon(&core->polygon, vertices, parts + n);
    vbss_knot_reduction_arrays(&core->reduction, vertices + KNOT_OBSTACLES, parts + n);
    n += KNOT_REDUCTION_ARRAYS;
    n += list_polygon(&curve->polygon, vertices, parts + n);
    vbss_knot_reduction_arrays(&curve->reduction, vertices, parts + n);
    n += KNOT_REDUCTION_ARRAYS;
    vbss_knot_projector_arrays(&curve->projector, vertices, parts + n);
    n += KNOT_PROJECTOR_ARRAYS;
    for (int i = 0; i < KNOT_CODES; i++) {
        vbss_knot_code_arrays(&curve->codes[i], c->crossing_capacity, parts + n);
        n += KNOT_CODE_ARRAYS;
    }
    vbss_knot_algebra_arrays(&curve->algebra, c->crossing_capacity / 4, parts + n);
    n += KNOT_ALGEBRA_ARRAYS;
    parts[n++] = (vbss_array){&core->obstacles, KNOT_OBSTACLES, sizeof *core->obstacles};
    n += list_polygon(&d->job.locating.polygon, vertices, parts + n);
    vbss_knot_paper_arrays(&d->paper, c->method == VBSS_KNOT_PROJECTION ? c->point_capacity : 2,
                           parts + n);
    n += KNOT_PAPER_ARRAYS;
    parts[n++] =
        (vbss_array){&d->loop_rows, 4 * (size_t)d->paper.loop_capacity, sizeof *d->loop_rows};
    return n;
}

static void free_detector(vbss_context *context, void *object)
{
    knot_detector *d = object;
    vbss_array parts[PARTS];
    vbss_release_arrays(context, parts, list_parts(d, parts));
    vbss_release(context, d, 1, sizeof *d);
}

const vbss_kind vbss_knot_kind = {"knot detector", VBSS_CODE('K', 'N', 'O', 'T'), 1, free_detector,
                                  vbss_knot_serialise};

static void forget(knot_detector *d)
{
    d->steps = d->job_began = 0;
    d->due = true;
    d->doubted = false;
    d->shown.point_count = d->shown.tool_count = 0;
    d->event_count = d->events_lost = 0;
    d->job.stage = KNOT_JOB_IDLE;
    d->state = (vbss_knot_state){.struct_size = sizeof d->state};
    d->verdict = (knot_verdict){.throw_count = 0};
    d->figures = (vbss_knot_statistics){.struct_size = sizeof d->figures};
    d->paper.loop_count = 0;
    vbss_random_seed(&d->paper.random, d->config.seed, 0);
    memset(d->tools, 0, d->config.tool_capacity * sizeof *d->tools);
    d->state.faults = vbss_knot_faults_of(&d->verdict);
}

static vbss_result allocate(vbss_context *context, const vbss_knot_config *config,
                            knot_detector **detector)
{
    knot_detector *d = vbss_allocate(context, 1, sizeof *d, "knot detector");
    vbss_array parts[PARTS];
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    d->context = context;
    d->config = *config;
    vbss_result result =
        vbss_allocate_arrays(context, parts, list_parts(d, parts), "knot detector");
    if (result != VBSS_OK) {
        free_detector(context, d);
        return result;
    }
    forget(d);
    *detector = d;
    return VBSS_OK;
}

/* ---- life */

vbss_result vbss_knot_detector_create(vbss_context *context, const vbss_knot_config *config,
                                      vbss_knot_detector **detector)
{
    if (detector == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, detector, "detector");
    }
    *detector = NULL;
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_knot_config own;
    VBSS_TRY(vbss_config_init(&vbss_knot_config_layout, &own, sizeof own));
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_knot_config_layout, config, &own));
    }
    VBSS_TRY(vbss_knot_check_config(context, &own));

    knot_detector *d;
    vbss_slot *slot = NULL;
    VBSS_TRY(allocate(context, &own, &d));
    vbss_result result = vbss_slot_create(context, &vbss_knot_kind, d, &slot);
    if (result != VBSS_OK) {
        free_detector(context, d);
        return result;
    }
    *detector = (vbss_knot_detector *)slot;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_destroy(vbss_knot_detector *detector)
{
    return vbss_slot_destroy(detector, &vbss_knot_kind);
}

vbss_result vbss_knot_open(const vbss_knot_detector *handle, knot_detector **detector)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_knot_kind, &slot));
    *detector = slot->object;
    return VBSS_OK;
}

static vbss_result edit(vbss_knot_detector *handle, knot_detector **detector)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_knot_kind, &slot));
    *detector = slot->object;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_reset(vbss_knot_detector *detector)
{
    knot_detector *d;
    VBSS_TRY(edit(detector, &d));
    forget(d);
    d->generation++;
    return VBSS_OK;
}

/* ---- the step */

void vbss_knot_tell(knot_detector *d, vbss_knot_event kind, uint32_t a, uint32_t b, uint32_t c)
{
    if (d->event_count < d->config.event_capacity) {
        d->events[d->event_count++] = (knot_event){(uint32_t)kind, {a, b, c}};
        return;
    }
    d->events_lost++;
    d->events[d->event_count - 1] = (knot_event){VBSS_KNOT_EVENT_LOST, {d->events_lost + 1, 0, 0}};
}

/* Wrapped from wrap_turns on, until a quarter of a turn less; `true` when that has changed. */
static bool wind(knot_detector *d, uint32_t tool)
{
    knot_tool_state *t = &d->tools[tool];
    double places[2];
    vbss_knot_wind(&d->shown, tool, &t->winding);
    vbss_knot_show_places(&d->shown, t->winding.run_places, places);
    memcpy(t->winding.run_places, places, sizeof places);
    double turns = fabs(t->winding.run_turns);
    bool was = t->wrapped;
    t->wrapped = turns >= d->config.wrap_turns - (was ? 0.25 : 0.0);
    if (t->wrapped && !was) {
        vbss_knot_tell(d, VBSS_KNOT_EVENT_WRAPPED, tool, 1 + (t->winding.run_turns > 0.0), 0);
    } else if (was && !t->wrapped) {
        vbss_knot_tell(d, VBSS_KNOT_EVENT_UNWRAPPED, tool, 0, 0);
    }
    bool wrong = t->wrapped && t->winding.sense < 0;
    if (wrong && !t->wrong_way) {
        vbss_knot_tell(d, VBSS_KNOT_EVENT_WRONG_WAY, tool, 0, 0);
    }
    t->wrong_way = wrong || (t->wrapped && t->wrong_way && t->winding.sense == 0);
    return was != t->wrapped;
}

/* Winding about all tools; whether there is a reason to read the topology anew. */
static bool look_at_tools(knot_detector *d)
{
    bool changed = false;
    for (uint32_t i = 0; i < d->shown.tool_count; i++) {
        knot_tool_state *t = &d->tools[i];
        changed |= wind(d, i) || t->held != d->shown.tools[i].held;
        t->held = d->shown.tools[i].held;
    }
    for (uint32_t i = d->shown.tool_count; i < d->config.tool_capacity; i++) {
        d->tools[i] = (knot_tool_state){.wrapped = false};
    }
    return changed;
}

/* Something is on a tool or in its jaws: a throw may be coming. */
static bool is_tying(const knot_detector *d)
{
    bool tying = false;
    for (uint32_t i = 0; i < d->shown.tool_count; i++) {
        tying |= d->tools[i].wrapped || d->tools[i].held == VBSS_KNOT_HELD_THREAD;
    }
    return tying;
}

enum { TYING_INTERVAL = 20 };

static bool is_due(const knot_detector *d)
{
    uint32_t interval = d->config.interval;
    if (interval == 0 && is_tying(d)) {
        interval = TYING_INTERVAL;
    }
    return d->due || (interval > 0 && d->steps >= d->job_began + interval);
}

static void begin_reading(knot_detector *d)
{
    if (vbss_knot_job_is_active(&d->job)) { /* dropped, but its work was done */
        vbss_knot_count_job(&d->job, &d->figures);
    }
    vbss_knot_scene_copy(&d->job.scene, &d->shown);
    vbss_knot_job_begin(&d->job, &d->config, d->steps);
    d->job.scene.may_have_passed = d->doubted;
    d->job_began = d->steps;
    d->due = d->doubted = false;
}

static void end_reading(knot_detector *d, bool follows)
{
    vbss_knot_conclude(d, follows);
    d->doubted |= !follows && d->verdict.reason != VBSS_KNOT_REASON_NONE;
    d->job.stage = KNOT_JOB_IDLE;
}

/* A reading begins in one step and goes on from the next one, so that no step pays for both. */
static void read_topology(knot_detector *d)
{
    if (vbss_knot_job_is_active(&d->job)) {
        knot_work work = d->config.work_limit, before = d->job.spent;
        bool done = vbss_knot_job_go_on(&d->job, &d->config, &work);
        uint64_t spent = (uint64_t)(d->job.spent - before);
        d->figures.most_step_work =
            spent > d->figures.most_step_work ? spent : d->figures.most_step_work;
        if (done) {
            end_reading(d, !d->job.scene.may_have_passed);
        }
    } else if (is_due(d)) {
        begin_reading(d);
    }
}

static void read_at_once(knot_detector *d)
{
    knot_work work = INT64_MAX;
    begin_reading(d);
    vbss_knot_job_go_on(&d->job, &d->config, &work);
    end_reading(d, false);
}

/* ---- both methods */

static vbss_result look(vbss_knot_detector *detector, const vbss_knot_input *input, bool at_once)
{
    knot_detector *d;
    VBSS_TRY(edit(detector, &d));
    VBSS_TRY(vbss_check_arithmetic(d->context));
    const uint32_t points = d->shown.point_count;
    VBSS_TRY(vbss_knot_show(d, input, &d->shown));
    d->generation++;
    d->steps++;
    d->event_count = d->events_lost = 0;
    d->doubted |= d->shown.may_have_passed;
    d->due |= d->shown.may_have_passed || d->shown.point_count != points;
    d->due |= look_at_tools(d);
    if (d->config.method == VBSS_KNOT_PROJECTION) {
        vbss_knot_paper_step(d);
    } else if (at_once) {
        vbss_knot_conclude_next(d);
        read_at_once(d);
    } else {
        vbss_knot_conclude_next(d);
        read_topology(d);
    }
    d->state.steps = d->steps;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_step(vbss_knot_detector *detector, const vbss_knot_input *input)
{
    return look(detector, input, false);
}

vbss_result vbss_knot_detector_judge(vbss_knot_detector *detector, const vbss_knot_input *input)
{
    return look(detector, input, true);
}
