/* Memory of detectors, where one table lists all arrays, and their initial state. */
#include "base/error.h"
#include "knot/knot.h"

#include <string.h>

enum {
    ARRAY_COUNT = 6 + 2 + 2 * (3 + KNOT_REDUCTION_ARRAYS) + KNOT_PROJECTOR_ARRAYS +
                  KNOT_CODES * KNOT_GAUSS_CODE_ARRAYS + KNOT_ALGEBRA_ARRAYS + KNOT_BRACKET_ARRAYS +
                  1 + 3
};

static uint32_t list_input_arrays(knot_input *input, const vbss_knot_detector_config *c,
                                  vbss_array *arrays)
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
    const vbss_knot_detector_config *c = &d->config;
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
    vbss_knot_bracket_arrays(&curve->bracket, c->crossing_capacity / 4, arrays + n);
    n += KNOT_BRACKET_ARRAYS;
    arrays[n++] = (vbss_array){&core->obstacles, KNOT_OBSTACLES, sizeof *core->obstacles};
    n += list_polygon_arrays(&d->job.locator.polygon, vertices, arrays + n);
    return n;
}

void vbss_knot_free(vbss_context *context, void *object)
{
    knot_detector *d = object;
    vbss_array arrays[ARRAY_COUNT];
    d->method->destroy_detector(context, d);
    vbss_release_arrays(context, arrays, list_arrays(d, arrays));
    vbss_release(context, d, 1, sizeof *d);
}

void vbss_knot_reset_state(knot_detector *d)
{
    d->steps = d->job_start_step = 0;
    d->reading_due = true;
    d->thread_may_differ = false;
    d->input.point_count = d->input.tool_count = 0;
    d->event_count = d->events_lost = 0;
    d->job.stage = KNOT_JOB_IDLE;
    d->state = (vbss_knot_state){.struct_size = sizeof d->state};
    d->classification = (knot_classification){.throw_count = 0};
    d->statistics = (vbss_knot_detector_statistics){.struct_size = sizeof d->statistics};
    d->loop_count = 0;
    vbss_random_seed(&d->random, d->config.seed, 0);
    memset(d->tools, 0, d->config.tool_capacity * sizeof *d->tools);
    d->state.faults = vbss_knot_faults_of(&d->classification);
}

vbss_result vbss_knot_allocate(vbss_context *context, const vbss_knot_detector_config *config,
                               knot_detector **detector)
{
    knot_detector *d = vbss_allocate(context, 1, sizeof *d, "knot detector");
    vbss_array arrays[ARRAY_COUNT];
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    d->method =
        config->method == VBSS_KNOT_METHOD_PROJECTION ? &vbss_baseline_knots : &vbss_knot_topology;
    d->context = context;
    d->config = *config;
    vbss_result result =
        vbss_allocate_arrays(context, arrays, list_arrays(d, arrays), "knot detector");
    if (result == VBSS_OK) {
        result = d->method->create_detector(d);
    }
    if (result != VBSS_OK) {
        vbss_knot_free(context, d);
        return result;
    }
    vbss_knot_reset_state(d);
    *detector = d;
    return VBSS_OK;
}
