/* Ties a knot of the gallery step by step and keeps frames and figures of it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/error.h"
#include "knots/gallery.h"
#include "oracle/knot_type.h"

#define STEP 1e-3
enum { MAX_STEPS = 5000, HELD_STEPS = 300, FRAME_EVERY = 10 };

double gallery_processor_us(void)
{
    struct timespec now;
    return clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0
               ? 1e6 * (double)now.tv_sec + 1e-3 * (double)now.tv_nsec
               : 0.0;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(double *times, uint32_t count, double share)
{
    qsort(times, count, sizeof *times, compare);
    return count == 0 ? 0.0 : times[(uint32_t)(share * (count - 1))];
}

static const vec3 *positions(const gallery_knot *g)
{
    vbss_view view;
    return vbss_thread_get_view(g->knot.thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view) ==
                   VBSS_OK
               ? view.data
               : NULL;
}

static vbss_result keep_frame(gallery_knot *g)
{
    size_t bytes = g->knot.node_count * sizeof(vec3);
    const vec3 *x = positions(g);
    if (x == NULL || g->frame_count == GALLERY_FRAMES) {
        return VBSS_ERROR_CAPACITY;
    }
    gallery_frame *f = &g->frames[g->frame_count];
    f->stage = tied_knot_stage(&g->knot);
    f->shows_pegs = g->knot.withdrawn == 0.0;
    f->x = malloc(bytes);
    if (f->x == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    g->frame_count++;
    memcpy(f->x, x, bytes);
    for (int k = 0; k < TIED_KNOT_PEGS && g->knot.peg_radius > 0.0; k++) {
        vbss_scene_rigid_state state;
        VBSS_TRY(vbss_scene_get_rigid(g->knot.scene, g->knot.peg_bodies[k], &state, sizeof state));
        f->pegs[k] = vec3_load(state.position);
    }
    return VBSS_OK;
}

/* A frame every few steps, and when a throw has been laid. */
static vbss_result step(gallery_knot *g, double *us)
{
    uint32_t stage = tied_knot_stage(&g->knot);
    double begin = gallery_processor_us();
    VBSS_TRY(tied_knot_step(&g->knot, STEP));
    *us = gallery_processor_us() - begin;
    bool laid = tied_knot_stage(&g->knot) != stage;
    return laid || g->knot.steps % FRAME_EVERY == 0 ? keep_frame(g) : VBSS_OK;
}

static vbss_result measure(gallery_knot *g)
{
    vbss_scene_statistics s;
    knot_type found, right = knot_type_of_kind(g->kind, false);
    const vec3 *x = positions(g);
    VBSS_TRY(vbss_scene_get_statistics(g->knot.scene, &s, sizeof s));
    g->force = tied_knot_felt(&g->knot);
    g->taken_up = g->knot.length - vec3_distance(x[0], x[g->knot.node_count - 1]);
    g->penetration = s.penetration;
    g->stretch = s.stretch_error;
    g->retries = s.rejected_states + s.rejected_stretch + s.rejected_depth + s.rejected_guard +
                 s.rejected_singular;
    g->clamped = s.clamped;
    g->topology_kept = knot_type_of(x, g->knot.node_count, &found) && knot_type_same(found, right);
    return VBSS_OK;
}

static vbss_result tie(gallery_knot *g)
{
    static double times[MAX_STEPS];
    tied_knot_options options;
    VBSS_TRY(vbss_context_create(NULL, &g->context));
    VBSS_TRY(tied_knot_init(&options, g->kind));
    options.knot.cylinder = g->cylinder;
    VBSS_TRY(tied_knot_create(g->context, &options, &g->knot));
    VBSS_TRY(keep_frame(g));
    uint32_t steps = 0;
    while (steps < MAX_STEPS && !tied_knot_done(&g->knot)) {
        VBSS_TRY(step(g, &times[steps++]));
    }
    g->tight = tied_knot_done(&g->knot);
    g->seconds = STEP * steps;
    g->median = quantile(times, steps, 0.5);
    g->p99 = quantile(times, steps, 0.99);
    for (steps = 0; steps < HELD_STEPS; steps++) {
        VBSS_TRY(step(g, &times[steps]));
    }
    g->held = quantile(times, HELD_STEPS, 0.5);
    VBSS_TRY(keep_frame(g));
    return measure(g);
}

void gallery_complain(const gallery_knot *g, vbss_result result)
{
    const char *text = "";
    if (g->context != NULL) {
        (void)vbss_context_get_last_error(g->context, NULL, &text);
    }
    fprintf(stderr, "%s: %s %s\n", g->title, vbss_result_name(result), text);
}

bool gallery_tie(gallery_knot *g)
{
    vbss_result result = tie(g);
    if (result != VBSS_OK) {
        gallery_complain(g, result);
    }
    return result == VBSS_OK;
}

void gallery_end(gallery_knot *g)
{
    for (uint32_t i = 0; i < g->frame_count; i++) {
        free(g->frames[i].x);
    }
    g->frame_count = 0;
    vbss_context_destroy(g->context);
    g->context = NULL;
}
