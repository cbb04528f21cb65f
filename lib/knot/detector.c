/* Detectors: creation, destruction and step: input -> winding -> method -> result. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/snapshot.h"
#include "knot/knot.h"
#include "knot/tuning.h"

#include <string.h>

/* ---- creation and destruction */

vbss_result vbss_knot_detector_create(vbss_context *context,
                                      const vbss_knot_detector_config *config,
                                      vbss_knot_detector **detector)
{
    VBSS_ENTER_WITH_RESULT(context, detector);
    if (detector == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, detector, "detector");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_knot_detector_config own;
    VBSS_TRY(vbss_config_init(&vbss_knot_config_layout, &own, sizeof own));
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_knot_config_layout, config, &own));
    }
    VBSS_TRY(vbss_knot_check_config(context, &own));

    knot_detector *d;
    vbss_slot *slot = NULL;
    VBSS_TRY(vbss_knot_allocate(context, &own, &d));
    vbss_result result = vbss_slot_create(context, &vbss_knot_kind, d, &slot);
    if (result != VBSS_OK) {
        vbss_knot_free(context, d);
        return result;
    }
    *detector = (vbss_knot_detector *)slot;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_destroy(vbss_knot_detector *detector)
{
    VBSS_ENTER(detector);
    return vbss_slot_destroy(detector, &vbss_knot_kind);
}

vbss_result vbss_knot_detector_reset(vbss_knot_detector *detector)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_edit(detector, &d));
    vbss_knot_reset_state(d);
    d->generation++;
    return VBSS_OK;
}

/* ---- the step */

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
        vbss_knot_emit_event(d, VBSS_KNOT_EVENT_WRONG_DIRECTION, tool, 0, 0);
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

static vbss_result run_step(vbss_knot_detector *detector, const vbss_knot_input *input,
                            bool immediate)
{
    knot_detector *d;
    VBSS_TRY(vbss_knot_edit(detector, &d));
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
    VBSS_ENTER(detector);
    return run_step(detector, input, false);
}

vbss_result vbss_knot_detector_judge(vbss_knot_detector *detector, const vbss_knot_input *input)
{
    VBSS_ENTER(detector);
    return run_step(detector, input, true);
}

vbss_result vbss_knot_detector_save(vbss_knot_detector *detector, uint8_t *bytes, uint64_t capacity,
                                    uint64_t *written)
{
    VBSS_ENTER(detector);
    return vbss_object_save(detector, &vbss_knot_kind, bytes, capacity, written);
}

vbss_result vbss_knot_detector_restore(vbss_knot_detector *detector, const uint8_t *bytes,
                                       uint64_t count)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(detector, &d));
    VBSS_TRY(vbss_object_restore(detector, &vbss_knot_kind, bytes, count));
    d->event_count = d->events_lost = d->loop_count = 0; /* results of the last step */
    d->generation++;
    return VBSS_OK;
}

vbss_result vbss_knot_detector_get_hash(vbss_knot_detector *detector, uint64_t *hash)
{
    VBSS_ENTER(detector);
    return vbss_object_hash(detector, &vbss_knot_kind, hash);
}
