/* The step of method PROJECTION: loops around each tool, and the segments that cross them. */
#include "base/error.h"
#include "base/memory.h"
#include "baseline/knots.h"

#include <string.h>

static uint32_t shown_segment(const knot_input *scene, uint32_t segment)
{
    double begin = scene->places[segment], end = scene->places[segment + 1];
    return (uint32_t)(end > begin ? end - 1.0 : end);
}

static void show_loops(knot_detector *d)
{
    const baseline_loops *p = &d->baseline->loops;
    d->loop_count = p->loop_count;
    for (uint32_t i = 0; i < p->loop_count; i++) {
        const baseline_loop *loop = &p->loops[i];
        const uint32_t row[] = {loop->tool, shown_segment(&d->input, loop->first),
                                shown_segment(&d->input, loop->last), loop->inside};
        memcpy(d->baseline->rows + 4 * (size_t)i, row, sizeof row);
    }
}

/* The throw belongs to the tool with the largest number of tied loops. It has as many wraps as
 * loops, and no handedness. */
static void step_detector(knot_detector *d, bool immediate)
{
    (void)immediate; /* a step is never divided */
    baseline_loops *p = &d->baseline->loops;
    vbss_knot_state *s = &d->state;
    const uint32_t before = s->loops;
    s->loops = s->undone = 0;
    p->loop_count = 0;
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        vbss_baseline_find_loops(p, &d->config, &d->input, i);
    }
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        baseline_throw t = vbss_baseline_find_throws(p, &d->config, &d->input, i);
        s->undone += t.undone;
        if (t.loops > s->loops) {
            s->loops = t.loops;
            s->next_tool = i;
        }
    }
    show_loops(d);
    s->next_wraps = (int32_t)s->loops;
    s->next_verdict = s->loops > 0 ? VBSS_KNOT_VERDICT_PASSED : VBSS_KNOT_VERDICT_NONE;
    if (s->loops > 0 && s->loops != before) {
        vbss_knot_emit_event(d, VBSS_KNOT_EVENT_FORMED, 0, s->loops, 0);
    } else if (s->loops == 0 && before > 0) {
        d->statistics.revoked++;
        vbss_knot_emit_event(d, VBSS_KNOT_EVENT_REVOKED, 0, before, 0);
    }
}

/* ---- life */

enum { ARRAY_COUNT = BASELINE_LOOP_ARRAYS + 1 };

static void list_arrays(knot_detector *d, vbss_array arrays[ARRAY_COUNT])
{
    baseline_detector *own = d->baseline;
    vbss_baseline_list_loop_arrays(&own->loops, d->config.point_capacity, arrays);
    arrays[BASELINE_LOOP_ARRAYS] =
        (vbss_array){&own->rows, 4 * (size_t)own->loops.loop_capacity, sizeof *own->rows};
}

static vbss_result create_detector(knot_detector *d)
{
    vbss_array arrays[ARRAY_COUNT];
    d->baseline = vbss_allocate(d->context, 1, sizeof *d->baseline, "knot detector");
    if (d->baseline == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    list_arrays(d, arrays);
    VBSS_TRY(vbss_allocate_arrays(d->context, arrays, ARRAY_COUNT, "knot detector"));
    d->baseline->loops.random = &d->random;
    d->loop_rows = d->baseline->rows;
    return VBSS_OK;
}

static void destroy_detector(vbss_context *context, knot_detector *d)
{
    vbss_array arrays[ARRAY_COUNT];
    if (d->baseline != NULL) {
        list_arrays(d, arrays);
        vbss_release_arrays(context, arrays, ARRAY_COUNT);
        vbss_release(context, d->baseline, 1, sizeof *d->baseline);
    }
}

const knot_method vbss_baseline_knots = {create_detector, destroy_detector, step_detector};
