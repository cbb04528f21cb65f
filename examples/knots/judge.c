/* What the knot detector says of every frame of a knot of the gallery. */
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "knots/gallery.h"

enum { TIMES = 5 };

/* The thread alone: nobody tells how it was tied. Under the tube is what a detector calls tissue. */
static void show(const gallery_knot *g, const gallery_frame *f, vbss_knot_input *input)
{
    const vec3 at = g->knot.line.cylinder_begin;
    input->points = &f->x[0].x;
    input->point_count = g->knot.node_count;
    if (g->cylinder) {
        input->hole_count = 1;
        input->holes[0][0] = at.x;
        input->holes[0][2] = at.z - g->knot.options.knot.cylinder_radius;
        input->away[2] = -1.0;
    }
}

static vbss_result read(vbss_knot_detector *detector, const gallery_knot *g, const gallery_frame *f,
                        gallery_reading *r)
{
    vbss_knot_input input;
    VBSS_TRY(vbss_knot_input_init(&input, sizeof input));
    show(g, f, &input);
    VBSS_TRY(vbss_knot_detector_judge(detector, &input));
    VBSS_TRY(vbss_knot_detector_get_state(detector, &r->state, sizeof r->state));
    VBSS_TRY(vbss_knot_detector_get_notation(detector, r->notation, sizeof r->notation));
    for (uint32_t i = 0; i < r->state.throw_count; i++) {
        VBSS_TRY(vbss_knot_detector_get_throw(detector, i, &r->throws[i], sizeof r->throws[i]));
    }
    return VBSS_OK;
}

/* The least of some times, us. */
static vbss_result time_reading(vbss_knot_detector *detector, const gallery_knot *g,
                                const gallery_frame *f, gallery_reading *r)
{
    r->us = 1e9;
    for (int i = 0; i < TIMES; i++) {
        double begin = gallery_processor_us();
        VBSS_TRY(read(detector, g, f, r));
        r->us = vbss_min(r->us, gallery_processor_us() - begin);
    }
    return VBSS_OK;
}

static vbss_result judge(gallery_knot *g)
{
    vbss_knot_detector *detector;
    gallery_reading r;
    VBSS_TRY(vbss_knot_detector_create(g->context, NULL, &detector));
    g->frames_judged = g->frame_count;
    g->frames_right = g->frames_certified = 0;
    for (uint32_t i = 0; i < g->frame_count; i++) {
        VBSS_TRY(read(detector, g, &g->frames[i], &r));
        bool right =
            strcmp(r.notation, g->notation) == 0 && r.state.verdict != VBSS_KNOT_VERDICT_UNCERTAIN;
        g->frames_right += right;
        g->frames_certified += right && r.state.verdict == VBSS_KNOT_VERDICT_CERTIFIED;
    }
    VBSS_TRY(time_reading(detector, g, &g->frames[0], &g->loose_reading));
    return time_reading(detector, g, &g->frames[g->frame_count - 1], &g->tight_reading);
}

bool gallery_judge(gallery_knot *g)
{
    vbss_result result = judge(g);
    if (result != VBSS_OK) {
        gallery_complain(g, result);
    }
    return result == VBSS_OK;
}
