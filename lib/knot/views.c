/* Public queries of a detector. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "knot/knot.h"

#include <string.h>

_Static_assert(sizeof(vbss_knot_state) == 120, "published size");
_Static_assert(sizeof(vbss_knot_throw) == 88, "published size");
_Static_assert(sizeof(vbss_knot_winding) == 64, "published size");
_Static_assert(sizeof(vbss_knot_detector_statistics) == 104, "published size");
_Static_assert(sizeof(knot_event) == 16, "four numbers side by side");

static const uint32_t state_sizes[] = {120, 0};
static const vbss_layout state_layout = {"vbss_knot_state", NULL, state_sizes};
static const uint32_t throw_sizes[] = {88, 0};
static const vbss_layout throw_layout = {"vbss_knot_throw", NULL, throw_sizes};
static const uint32_t winding_sizes[] = {64, 0};
static const vbss_layout winding_layout = {"vbss_knot_winding", NULL, winding_sizes};
static const uint32_t statistics_sizes[] = {104, 0};
static const vbss_layout statistics_layout = {"vbss_knot_detector_statistics", NULL,
                                              statistics_sizes};

vbss_result vbss_knot_detector_get_state(vbss_knot_detector *detector, vbss_knot_state *state,
                                         uint32_t struct_size)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(detector, &d));
    return vbss_struct_write(d->context, &state_layout, &d->state, state, struct_size);
}

vbss_result vbss_knot_detector_get_throw(vbss_knot_detector *detector, uint32_t number,
                                         vbss_knot_throw *knot_throw, uint32_t struct_size)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(detector, &d));
    if (number >= d->classification.throw_count) {
        return vbss_fail(d->context, VBSS_ERROR_NOT_FOUND, "throw %u of %u", number,
                         d->classification.throw_count);
    }
    return vbss_struct_write(d->context, &throw_layout, &d->classification.throws[number],
                             knot_throw, struct_size);
}

vbss_result vbss_knot_detector_get_winding(vbss_knot_detector *detector, uint32_t tool,
                                           vbss_knot_winding *winding, uint32_t struct_size)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(detector, &d));
    if (tool >= d->input.tool_count) {
        return vbss_fail(d->context, VBSS_ERROR_NOT_FOUND, "tool %u of %u", tool,
                         d->input.tool_count);
    }
    const knot_winding *w = &d->tools[tool].winding;
    const vbss_knot_winding own = {.struct_size = sizeof own,
                                   .wrapped = d->tools[tool].wrapped,
                                   .turns = w->turns,
                                   .run_turns = w->run_turns,
                                   .run_places = {w->run_places[0], w->run_places[1]},
                                   .run_heights = {w->run_heights[0], w->run_heights[1]},
                                   .sense = w->sense,
                                   .runs = w->runs};
    return vbss_struct_write(d->context, &winding_layout, &own, winding, struct_size);
}

vbss_result vbss_knot_detector_get_notation(vbss_knot_detector *detector, char *text,
                                            uint64_t capacity)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    char own[KNOT_NOTATION];
    VBSS_TRY(vbss_knot_open(detector, &d));
    VBSS_TRY(vbss_check_pointer(d->context, text, "text"));
    vbss_knot_notation_of(&d->classification, own);
    size_t bytes = strlen(own) + 1;
    if (bytes > capacity) {
        return vbss_fail(d->context, VBSS_ERROR_CAPACITY, "%llu bytes of text, and room for %llu",
                         (unsigned long long)bytes, (unsigned long long)capacity);
    }
    memcpy(text, own, bytes);
    return VBSS_OK;
}

vbss_result vbss_knot_detector_get_view(vbss_knot_detector *detector, vbss_knot_field field,
                                        vbss_view *view, uint32_t struct_size)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(detector, &d));
    vbss_view own = {0, VBSS_VIEW_TYPE_U32, 4, sizeof(knot_event), 0, NULL, d->generation};
    if (field == VBSS_KNOT_VIEW_EVENTS) {
        own.count = d->event_count;
        own.data = d->events;
    } else if (field == VBSS_KNOT_VIEW_LOOPS) {
        own.count = d->loop_count;
        own.data = d->loop_rows;
    } else {
        return vbss_fail(d->context, VBSS_ERROR_OUT_OF_RANGE, "a knot detector has no field %d",
                         field);
    }
    return vbss_struct_write(d->context, &vbss_view_layout, &own, view, struct_size);
}

vbss_result vbss_knot_detector_get_statistics(vbss_knot_detector *detector,
                                              vbss_knot_detector_statistics *statistics,
                                              uint32_t struct_size)
{
    VBSS_ENTER(detector);
    knot_detector *d;
    VBSS_TRY(vbss_knot_open(detector, &d));
    vbss_knot_detector_statistics own = d->statistics;
    if (vbss_knot_job_is_active(&d->job)) {
        vbss_knot_count_job(&d->job, &own);
    }
    return vbss_struct_write(d->context, &statistics_layout, &own, statistics, struct_size);
}
