/* Methods ours, ours-local and paper: this library's thread, each with its defaults. The clamp is the
 * library's own, at node 0: N segments of L / N. */
#include <math.h>
#include <stdlib.h>

#include <vblast_ss/thread.h>

#include "thread/peer.h"

typedef struct ours {
    vbss_context *context; /* owns the thread */
    vbss_thread *thread;
    uint32_t segments;
    double dt;
} ours;

static void destroy(void *thread)
{
    ours *o = thread;
    if (o != NULL) {
        vbss_context_destroy(o->context);
        free(o);
    }
}

static vbss_result make(ours *o, const cantilever_setup *setup, vbss_method method,
                        vbss_thread_bending bending)
{
    vbss_thread_config config;
    vbss_thread_attachment clamp;
    uint32_t id;
    vbss_result result = vbss_context_create(NULL, &o->context);
    if (result == VBSS_OK) {
        result = vbss_thread_config_init(&config, sizeof config);
    }
    if (result != VBSS_OK) {
        return result;
    }
    config.method = method;
    config.bending = bending;
    config.segment_count = setup->segments;
    config.length = CANTILEVER_LENGTH;
    config.radius = CANTILEVER_RADIUS;
    config.linear_density = CANTILEVER_LINEAR_DENSITY;
    config.axial_stiffness = CANTILEVER_STRETCH_STIFFNESS;
    config.bending_stiffness = CANTILEVER_BENDING_STIFFNESS;
    config.gravity[1] = -CANTILEVER_GRAVITY;
    config.drag = setup->drag;
    result = vbss_thread_create(o->context, &config, &o->thread);
    if (result == VBSS_OK) {
        result = vbss_thread_attachment_init(&clamp, sizeof clamp);
    }
    if (result == VBSS_OK) {
        clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
        result = vbss_thread_attach(o->thread, &clamp, &id);
    }
    return result;
}

static void *create(const cantilever_setup *setup, vbss_method method, vbss_thread_bending bending)
{
    ours *o = calloc(1, sizeof *o);
    if (o == NULL) {
        return NULL;
    }
    o->segments = setup->segments;
    o->dt = setup->dt;
    if (make(o, setup, method, bending) != VBSS_OK) {
        destroy(o);
        return NULL;
    }
    return o;
}

static void *create_spline(const cantilever_setup *setup)
{
    return create(setup, VBSS_METHOD_IMPLICIT, VBSS_THREAD_BENDING_SPLINE);
}

static void *create_local(const cantilever_setup *setup)
{
    return create(setup, VBSS_METHOD_IMPLICIT, VBSS_THREAD_BENDING_LOCAL);
}

static void *create_paper(const cantilever_setup *setup)
{
    return create(setup, VBSS_METHOD_VBLAST, VBSS_THREAD_BENDING_SPLINE);
}

static int step(void *thread)
{
    ours *o = thread;
    return (int)vbss_thread_step(o->thread, o->dt);
}

static void tip(void *thread, double tip[3])
{
    ours *o = thread;
    vbss_view view;
    if (vbss_thread_get_view(o->thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view) ==
        VBSS_OK) {
        const double *positions = view.data;
        for (uint32_t k = 0; k < 3; k++) {
            tip[k] = positions[3 * o->segments + k];
        }
    }
}

static double stretch(void *thread)
{
    ours *o = thread;
    vbss_thread_statistics statistics;
    return vbss_thread_get_statistics(o->thread, &statistics, sizeof statistics) == VBSS_OK
               ? statistics.stretch_error
               : (double)NAN;
}

/* By trial among 1, 2, 5, 10, 20, 50 and 100 ms, which is the longest that the library takes: all of
 * them settle as exactly as 1 ms does. Timed is what a haptic device asks for. */
#define LONGEST_STEPS      \
    {                      \
        0.1, 0.1, 0.1, 0.1 \
    }
#define HAPTIC_STEPS           \
    {                          \
        1e-3, 1e-3, 1e-3, 1e-3 \
    }

const cantilever_method cantilever_ours = {.name = "ours",
                                           .note =
                                               "method IMPLICIT with its defaults: spline bending, "
                                               "generalised alpha with its default radius",
                                           .create = create_spline,
                                           .step = step,
                                           .tip = tip,
                                           .stretch = stretch,
                                           .destroy = destroy,
                                           .largest_dt = LONGEST_STEPS,
                                           .dt = HAPTIC_STEPS};

const cantilever_method cantilever_ours_local = {
    .name = "ours-local",
    .note = "method IMPLICIT with BENDING_LOCAL: each node sees its two neighbours only",
    .create = create_local,
    .step = step,
    .tip = tip,
    .stretch = stretch,
    .destroy = destroy,
    .largest_dt = LONGEST_STEPS,
    .dt = HAPTIC_STEPS};

/* Its explicit steps are 0.9 of the stable ones, 1 ms (l / 5 mm)^2, and it makes as many as it takes in
 * a longer one, which is cheaper than one by one. The timed step takes whole numbers of them. */
#define PAPER_STEP (0.1 / 112.0)

const cantilever_method cantilever_paper = {
    .name = "paper",
    .note = "method VBLAST with its defaults but no damping: that of VBLaST-SS, explicit in time",
    .create = create_paper,
    .step = step,
    .tip = tip,
    .stretch = stretch,
    .destroy = destroy,
    .largest_dt = {PAPER_STEP, PAPER_STEP / 4.0, PAPER_STEP / 16.0, PAPER_STEP / 64.0},
    .dt = {PAPER_STEP, PAPER_STEP, PAPER_STEP, PAPER_STEP},
    .divides = true};
