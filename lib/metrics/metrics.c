/* Creation and destruction of measurements. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"
#include "metrics/metrics.h"

/* ---- memory: one table lists all arrays */

enum { HAND_ARRAYS = 6, ARRAY_COUNT = METRICS_HANDS * HAND_ARRAYS + 5 };

static void list_hand_arrays(metrics_hand *h, size_t ticks, vbss_array *arrays)
{
    const vbss_array own[HAND_ARRAYS] = {{&h->ring, METRICS_RING_SIZE, sizeof *h->ring},
                                         {&h->speed, ticks, sizeof *h->speed},
                                         {&h->jerk, ticks, sizeof *h->jerk},
                                         {&h->seen, ticks, sizeof *h->seen},
                                         {&h->impulse, ticks, sizeof *h->impulse},
                                         {&h->peak, ticks, sizeof *h->peak}};
    for (int i = 0; i < HAND_ARRAYS; i++) {
        arrays[i] = own[i];
    }
}

static void list_arrays(metrics_object *m, vbss_array arrays[ARRAY_COUNT])
{
    const vbss_metrics_config *c = &m->config;
    for (int i = 0; i < METRICS_HANDS; i++) {
        list_hand_arrays(&m->hands[i], (size_t)m->tick_capacity,
                         arrays + (size_t)HAND_ARRAYS * (size_t)i);
    }
    vbss_array *others = arrays + (size_t)METRICS_HANDS * HAND_ARRAYS;
    others[0] = (vbss_array){&m->kernel, 1, sizeof *m->kernel};
    others[1] = (vbss_array){&m->throws, c->throw_capacity, sizeof *m->throws};
    others[2] = (vbss_array){&m->incidents, c->incident_capacity, sizeof *m->incidents};
    others[3] = (vbss_array){&m->phases, c->phase_capacity, sizeof *m->phases};
    others[4] = (vbss_array){&m->spectrum_buffer, METRICS_SPECTRUM_BUFFER_LENGTH,
                             sizeof *m->spectrum_buffer};
}

static void free_metrics(vbss_context *context, void *object)
{
    metrics_object *m = object;
    vbss_array arrays[ARRAY_COUNT];
    list_arrays(m, arrays);
    vbss_release_arrays(context, arrays, ARRAY_COUNT);
    vbss_release(context, m, 1, sizeof *m);
}

const vbss_kind vbss_metrics_kind = {"metrics",    VBSS_CODE('M', 'E', 'T', 'R'), 2,
                                     free_metrics, vbss_metrics_serialise,        NULL};

static vbss_result allocate_metrics(vbss_context *context, const vbss_metrics_config *config,
                                    metrics_object **metrics)
{
    vbss_array arrays[ARRAY_COUNT];
    metrics_object *m = vbss_allocate(context, 1, sizeof *m, "metrics");
    if (m == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    m->context = context;
    m->config = *config;
    m->tick_capacity = (uint64_t)ceil(config->duration * METRICS_TICK_RATE);
    list_arrays(m, arrays);
    vbss_result result = vbss_allocate_arrays(context, arrays, ARRAY_COUNT, "metrics");
    if (result != VBSS_OK) {
        free_metrics(context, m);
        return result;
    }
    vbss_metrics_make_kernel(m->kernel);
    *metrics = m;
    return VBSS_OK;
}

/* ---- creation and destruction */

vbss_result vbss_metrics_create(vbss_context *context, const vbss_metrics_config *config,
                                vbss_metrics **metrics)
{
    VBSS_ENTER_WITH_RESULT(context, metrics);
    if (metrics == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, metrics, "metrics");
    }
    VBSS_TRY(vbss_context_edit(context));
    vbss_metrics_config own;
    metrics_object *m = NULL;
    vbss_slot *slot = NULL;
    VBSS_TRY(vbss_metrics_read_config(context, config, &own));
    VBSS_TRY(allocate_metrics(context, &own, &m));
    vbss_result result = vbss_slot_create(context, &vbss_metrics_kind, m, &slot);
    if (result != VBSS_OK) {
        free_metrics(context, m);
        return result;
    }
    *metrics = (vbss_metrics *)slot;
    return VBSS_OK;
}

vbss_result vbss_metrics_destroy(vbss_metrics *metrics)
{
    VBSS_ENTER(metrics);
    return vbss_slot_destroy(metrics, &vbss_metrics_kind);
}

vbss_result vbss_metrics_open(const vbss_metrics *handle, metrics_object **metrics)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_metrics_kind, &slot));
    *metrics = slot->object;
    return VBSS_OK;
}

vbss_result vbss_metrics_edit(vbss_metrics *handle, metrics_object **metrics)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_metrics_kind, &slot));
    *metrics = slot->object;
    return VBSS_OK;
}
