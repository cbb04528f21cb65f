/* Kernels: what a linearisation of a falling cantilever of 120 segments spends its time on. Each
 * stage comes with those before it, as it uses up what they leave:
 *   assemble: the thread sets the numbers of the system;
 *   condense: and the runs are eliminated;
 *   solve: and the increments are worked out, which is a whole linearisation but for its update.
 * Those called plain are the hot loops for any processor. */
#include <stdio.h>
#include <stdlib.h>

#include "base/error.h"
#include "thread/bench_thread.h"
#include "thread/thread.h"

enum { SEGMENTS = 120, FALL_STEPS = 50 };
#define STEP_S 1e-3

typedef enum last_stage { ASSEMBLE, CONDENSE, SOLVE } last_stage;

typedef struct linearisation {
    const char *name;
    vbss_context *context;
    thread_object *thread;
    vbss_integration integration;
    last_stage last;
    bool plain, failed;
} linearisation;

static linearisation cases[] = {
    {.name = "thread/stages/assemble/120", .last = ASSEMBLE},
    {.name = "thread/stages/assemble-plain/120", .last = ASSEMBLE, .plain = true},
    {.name = "thread/stages/condense/120", .last = CONDENSE},
    {.name = "thread/stages/condense-plain/120", .last = CONDENSE, .plain = true},
    {.name = "thread/stages/solve/120", .last = SOLVE},
    {.name = "thread/stages/solve-plain/120", .last = SOLVE, .plain = true},
};

static vbss_result make(linearisation *l)
{
    vbss_thread_config config;
    vbss_thread_attachment clamp;
    vbss_thread *thread;
    uint32_t id;
    VBSS_TRY(vbss_context_create(NULL, &l->context));
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = SEGMENTS;
    VBSS_TRY(vbss_thread_create(l->context, &config, &thread));
    VBSS_TRY(vbss_thread_attachment_init(&clamp, sizeof clamp));
    clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    VBSS_TRY(vbss_thread_attach(thread, &clamp, &id));
    for (int i = 0; i < FALL_STEPS; i++) {
        VBSS_TRY(vbss_thread_step(thread, STEP_S));
    }
    VBSS_TRY(vbss_thread_edit(thread, &l->thread));
    l->thread->system->wide = l->thread->system->wide && !l->plain;
    l->integration = vbss_integration_generalised_alpha(STEP_S, config.spectral_radius);
    l->failed = false;
    return VBSS_OK;
}

static void end_linearisation(void *user)
{
    linearisation *l = user;
    vbss_context_destroy(l->context);
    l->context = NULL;
}

static int begin_linearisation(void *user)
{
    linearisation *l = user;
    vbss_result result = make(l);
    if (result != VBSS_OK) {
        end_linearisation(l); /* teardown is not called then */
    }
    return (int)result;
}

/* Of the state that the last step left, over and over. */
static void run_linearisation(void *user)
{
    linearisation *l = user;
    vbss_system *system = l->thread->system;
    const thread_substep stage = {.integration = &l->integration,
                                  .step_length = l->integration.h,
                                  .end_fraction = 1.0,
                                  .min_tension = -1e30}; /* all of the compression, as in a step */
    vbss_system_clear(system);
    VBSS_WIDE_CALL(system->wide, vbss_thread_assemble, l->thread, &stage, system, 0);
    if (l->last >= CONDENSE) {
        l->failed = !vbss_system_condense(system) || l->failed;
    }
    if (l->last >= SOLVE) {
        vbss_system_load_schur_complement(system);
        l->failed = !vbss_system_solve(system) || l->failed;
    }
}

static void finish_linearisation(void *user, bench_result *result)
{
    const linearisation *l = user;
    if (l->failed) {
        bench_fail(result, "a pivot was too small");
    }
    double ns = bench_counter_value(result, "ns");
    bench_counter(result, "ns_per_node", ns / (SEGMENTS + 1));
}

void add_stage_cases(bench *b)
{
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        if (cases[i].plain && !vbss_wide_is_available()) {
            bench_add_skipped(b, cases[i].name, "no AVX2: there is the plain one only");
            continue;
        }
        bench_add_batch(b, &(bench_batch){.name = cases[i].name,
                                          .user = &cases[i],
                                          .items = 1,
                                          .setup = begin_linearisation,
                                          .run = run_linearisation,
                                          .finish = finish_linearisation,
                                          .teardown = end_linearisation});
    }
}
