/* Creation, destruction and step of detectors: input -> winding -> some work on the topology ->
 * result. */
#include "base/check.h"
#include "base/error.h"
#include "knot/knot.h"
#include "knot/tuning.h"

#include <string.h>

/* ---- memory: one table lists all arrays */

enum {
    ARRAY_COUNT = 6 + 2 + 2 * (3 + KNOT_REDUCTION_ARRAYS) + KNOT_PROJECTOR_ARRAYS +
                  KNOT_CODES * KNOT_GAUSS_CODE_ARRAYS + KNOT_ALGEBRA_ARRAYS + 1 + 3
};

static uint32_t list_input_arrays(knot_input *input, const vbss_knot_config *c, vbss_array *arrays)
{
    arrays[0] = (vbss_array){&input->points, c->point_capacity, sizeof *input->points};
    arrays[1] = (vbss_array){&input->places, c->point_capacity, sizeof *input->places};
    arrays[2] = (vbss_array){&input->tools, c->tool_capacity, sizeof *input->tools};
    return 3;
}

static uint32_t list_polygon_arrays(knot_polygon *polygon, uint32_t capacity, vbss_array *arrays)
{
    polygon->capacity = capacity;
    arrays[0] = (vbss_array){&polygon->x, capacity, sizeof *polygon->x};
    arrays[1] = (vbss_array){&polygon->place, capacity, sizeof *polygon->place};
    arrays[2] = (vbss_array){&polygon->is_fixed, capacity, sizeof *polygon->is_fixed};
    return 3;
}

static uint32_t list_arrays(knot_detector *d, vbss_array arrays[ARRAY_COUNT])
{
    const vbss_knot_config *c = &d->config;
    const uint32_t vertices = c->point_capacity + KNOT_FIXED_VERTICES + KNOT_CLOSURE_VERTICES;
    knot_curve *curve = &d->job.reader;
    knot_core *core = &d->job.core;
    uint32_t n = list_input_arrays(&d->input, c, arrays);
    n += list_input_arrays(&d->job.input, c, arrays + n);
    arrays[n++] = (vbss_array){&d->tools, c->tool_capacity, sizeof *d->tools};
    arrays[n++] = (vbss_array){&d->events, c->event_capacity, sizeof *d->events};
    n += list_polygon_arrays(&core->polygon, vertices, arrays + n);
    vbss_knot_reduction_arrays(&core->reduction, vertices + KNOT_OBSTACLES, arrays + n);
    n += KNOT_REDUCTION_ARRAYS;
    n += list_polygon_arrays(&curve->polygon, vertices, arrays + n);
    vbss_knot_reduction_arrays(&curve->reduction, vertices, arrays + n);
    n += KNOT_REDUCTION_ARRAYS;
    vbss_knot_projector_arrays(&curve->projector, vertices, arrays + n);
    n += KNOT_PROJECTOR_ARRAYS;
    for (int i = 0; i < KNOT_CODES; i++) {
        vbss_knot_gauss_code_arrays(&curve->codes[i], c->crossing_capacity, arrays + n);
        n += KNOT_GAUSS_CODE_ARRAYS;
    }
    vbss_knot_algebra_arrays(&curve->algebra, c->crossing_capacity / 4, arrays + n);
    n += KNOT_ALGEBRA_ARRAYS;
    arrays[n++] = (vbss_array){&core->obstacles, KNOT_OBSTACLES, sizeof *core->obstacles};
    n += list_polygon_arrays(&d->job.locator.polygon, vertices, arrays + n);
    return n;
}

static vbss_result create_topology(knot_detector *d)
{
    static const uint32_t no_rows[4]; /* data of a view is never NULL */
    d->loop_rows = no_rows;
    return VBSS_OK;
}

static void destroy_topology(vbss_context *context, knot_detector *d)
{
    (void)context;
    (void)d;
}

static void step_topology(knot_detector *d, bool immediate);

static const knot_method topology = {create_topology, destroy_topology, step_topology};

static void free_detector(vbss_context *context, void *object)
{
    knot_detector *d = object;
    vbss_array arrays[ARRAY_COUNT];
    d->method->destroy_detector(context, d);
    vbss_release_arrays(context, arrays, list_arrays(d, arrays));
    vbss_release(context, d, 1, sizeof *d);
}

const vbss_kind vbss_knot_kind = {"knot detector", VBSS_CODE('K', 'N', 'O', 'T'), 1, free_detector,
                                  vbss_knot_serialise};

static void reset_state(knot_detector *d)
{
    d->steps = d->job_start_step = 0;
    d->reading_due = true;
    d->thread_may_differ = false;
    d->input.point_count = d->input.tool_count = 0;
    d->event_count = d->events_lost = 0;
    d->job.stage = KNOT_JOB_IDLE;
    d->state = (vbss_knot_state){.struct_size = sizeof d->state};
    d->classification = (knot_classification){.throw_count = 0};
    d->statistics = (vbss_knot_statistics){.struct_size = sizeof d->statistics};
    d->loop_count = 0;
    vbss_random_seed(&d->random, d->config.seed, 0);
    memset(d->tools, 0, d->config.tool_capacity * sizeof *d->tools);
    d->state.faults = vbss_knot_faults_of(&d->classification);
}

static vbss_result allocate(vbss_context *context, const vbss_knot_config *config,
                            knot_detector **detector)
{
    knot_detector *d = vbss_allocate(context, 1, sizeof *d, "knot detector");
    vbss_array arrays[ARRAY_COUNT];
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    d->method = config->method == VBSS_KNOT_PROJECTION ? &vbss_baseline_knots : &topology;
    d->context = context;
    d->config = *config;
    vbss_result result =
        vbss_allocate_arrays(context, arrays, list_arrays(d, arrays), "knot detector");
    if (result == VBSS_OK) {
        result = d->method->create_detector(d);
    }
    if (result != VBSS_OK) {
        free_detector(context, d);
        return result;
    }
    reset_state(d);
    *detector = d;
    return VBSS_OK;
}

/* ---- creation and destruction */

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

static vbss_result open_for_edit(vbss_knot_detector *handle, knot_detector **detector)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_knot_kind, &slot));
    *detector = slot->object;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_reset(vbss_knot_detector *detector)
{
    knot_detector *d;
    VBSS_TRY(open_for_edit(detector, &d));
    reset_state(d);
    d->generation++;
    return VBSS_OK;
}

/* ---- the step */

void vbss_knot_emit_event(knot_detector *d, vbss_knot_event kind, uint32_t a, uint32_t b,
                          uint32_t c)
{
    if (d->event_count < d->config.event_capacity) {
        d->events[d->event_count++] = (knot_event){(uint32_t)kind, {a, b, c}};
        return;
    }
    d->events_lost++;
    d->events[d->event_count - 1] = (knot_event){VBSS_KNOT_EVENT_LOST, {d->events_lost + 1, 0, 0}};
}

/* A tool is wrapped from wrap_turns on, with a hysteresis of a quarter turn. Returns whether that
 * has changed. */
static bool update_winding(knot_detector *d, uint32_t tool)
{
    knot_tool_state *t = &d->tools[tool];
    double places[2];
    vbss_knot_measure_winding(&d->input, tool, &t->winding);
    vbss_knot_places_to_host(&d->input, t->winding.run_places, places);
    memcpy(t->winding.run_places, places, sizeof places);
    double turns = fabs(t->winding.run_turns);
    bool was = t->wrapped;
    t->wrapped = turns >= d->config.wrap_turns - (was ? KNOT_UNWRAP_HYSTERESIS : 0.0);
    if (t->wrapped && !was) {
        vbss_knot_emit_event(d, VBSS_KNOT_EVENT_WRAPPED, tool, 1 + (t->winding.run_turns > 0.0), 0);
    } else if (was && !t->wrapped) {
        vbss_knot_emit_event(d, VBSS_KNOT_EVENT_UNWRAPPED, tool, 0, 0);
    }
    bool wrong = t->wrapped && t->winding.sense < 0;
    if (wrong && !t->wrong_sense) {
        vbss_knot_emit_event(d, VBSS_KNOT_EVENT_WRONG_WAY, tool, 0, 0);
    }
    t->wrong_sense = wrong || (t->wrapped && t->wrong_sense && t->winding.sense == 0);
    return was != t->wrapped;
}

/* Updates the winding about all tools. Returns whether the topology should be read again. */
static bool update_windings(knot_detector *d)
{
    bool changed = false;
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        knot_tool_state *t = &d->tools[i];
        changed |= update_winding(d, i) || t->held != d->input.tools[i].held;
        t->held = d->input.tools[i].held;
    }
    for (uint32_t i = d->input.tool_count; i < d->config.tool_capacity; i++) {
        d->tools[i] = (knot_tool_state){.wrapped = false};
    }
    return changed;
}

/* Whether the thread is wrapped about a tool or held by one, so that a throw may follow. */
static bool is_tying(const knot_detector *d)
{
    bool tying = false;
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        tying |= d->tools[i].wrapped || d->tools[i].held == VBSS_KNOT_HELD_THREAD;
    }
    return tying;
}

static bool is_due(const knot_detector *d)
{
    uint32_t interval = d->config.interval;
    if (interval == 0 && is_tying(d)) {
        interval = KNOT_TYING_INTERVAL;
    }
    return d->reading_due || (interval > 0 && d->steps >= d->job_start_step + interval);
}

static void begin_reading(knot_detector *d)
{
    if (vbss_knot_job_is_active(&d->job)) { /* the reading is dropped, but its work counts */
        vbss_knot_count_job(&d->job, &d->statistics);
    }
    vbss_knot_input_copy(&d->job.input, &d->input);
    vbss_knot_job_begin(&d->job, &d->config, d->steps);
    d->job.input.may_have_passed = d->thread_may_differ;
    d->job_start_step = d->steps;
    d->reading_due = d->thread_may_differ = false;
}

static void end_reading(knot_detector *d, bool follows)
{
    vbss_knot_classify(d, follows);
    d->thread_may_differ |= !follows && d->classification.reason != VBSS_KNOT_REASON_NONE;
    d->job.stage = KNOT_JOB_IDLE;
}

/* A reading starts in one step and continues from the next on, so that no step pays for both. */
static void read_topology(knot_detector *d)
{
    if (vbss_knot_job_is_active(&d->job)) {
        knot_ops budget = d->config.work_limit, before = d->job.ops_used;
        bool done = vbss_knot_job_resume(&d->job, &d->config, &budget);
        uint64_t ops = (uint64_t)(d->job.ops_used - before);
        d->statistics.most_step_work =
            ops > d->statistics.most_step_work ? ops : d->statistics.most_step_work;
        if (done) {
            end_reading(d, !d->job.input.may_have_passed);
        }
    } else if (is_due(d)) {
        begin_reading(d);
    }
}

static void read_immediately(knot_detector *d)
{
    knot_ops budget = INT64_MAX;
    begin_reading(d);
    vbss_knot_job_resume(&d->job, &d->config, &budget);
    end_reading(d, false);
}

static void step_topology(knot_detector *d, bool immediate)
{
    vbss_knot_classify_next(d);
    if (immediate) {
        read_immediately(d);
    } else {
        read_topology(d);
    }
}

/* ---- the step of both methods */

static vbss_result run_step(vbss_knot_detector *detector, const vbss_knot_input *input,
                            bool immediate)
{
    knot_detector *d;
    VBSS_TRY(open_for_edit(detector, &d));
    VBSS_TRY(vbss_check_arithmetic(d->context));
    const uint32_t points = d->input.point_count;
    VBSS_TRY(vbss_knot_read_input(d, input, &d->input));
    d->generation++;
    d->steps++;
    d->event_count = d->events_lost = 0;
    d->thread_may_differ |= d->input.may_have_passed;
    d->reading_due |= d->input.may_have_passed || d->input.point_count != points;
    d->reading_due |= update_windings(d);
    d->method->step_detector(d, immediate);
    d->state.steps = d->steps;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_step(vbss_knot_detector *detector, const vbss_knot_input *input)
{
    return run_step(detector, input, false);
}

vbss_result vbss_knot_detector_judge(vbss_knot_detector *detector, const vbss_knot_input *input)
{
    return run_step(detector, input, true);
}
