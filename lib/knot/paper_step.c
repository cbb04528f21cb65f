/* The step of method PROJECTION: loops about each tool, and the segments that cross them. */
#include "knot/knot.h"

#include <string.h>

static uint32_t shown_segment(const knot_input *scene, uint32_t segment)
{
    double begin = scene->places[segment], end = scene->places[segment + 1];
    return (uint32_t)(end > begin ? end - 1.0 : end);
}

static void show_loops(knot_detector *d)
{
    for (uint32_t i = 0; i < d->paper.loop_count; i++) {
        const knot_loop *loop = &d->paper.loops[i];
        const uint32_t row[] = {loop->tool, shown_segment(&d->input, loop->first),
                                shown_segment(&d->input, loop->last), loop->inside};
        memcpy(d->loop_rows + 4 * (size_t)i, row, sizeof row);
    }
}

/* Selects the tool with the most tied loops. The throw has as many wraps, and no handedness. */
void vbss_knot_paper_step(knot_detector *d)
{
    vbss_knot_state *s = &d->state;
    const uint32_t before = s->loops;
    s->loops = s->undone = 0;
    d->paper.loop_count = 0;
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        vbss_knot_paper_loops(&d->paper, &d->config, &d->input, i);
    }
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        knot_paper_throw t = vbss_knot_paper_throws(&d->paper, &d->config, &d->input, i);
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
