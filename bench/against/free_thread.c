/* thread/free-120: a thread of 120 segments without contacts, clamped at one end, falls from the horizontal and swings. */
#include "base/error.h"
#include "against/subject.h"

enum { SEGMENTS = 120, STEPS = 2000 };
#define SEGMENT_LENGTH 1.25e-3 /* m */

static struct {
    vbss_context *context;
    vbss_thread *thread;
    uint32_t steps;
} own;

static vbss_result begin(uint64_t seed)
{
    vbss_thread_config config;
    vbss_thread_attachment clamp;
    uint32_t id;
    (void)seed;
    VBSS_TRY(vbss_context_create(NULL, &own.context));
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = SEGMENTS;
    config.length = SEGMENTS * SEGMENT_LENGTH;
    VBSS_TRY(vbss_thread_create(own.context, &config, &own.thread));
    VBSS_TRY(vbss_thread_attachment_init(&clamp, sizeof clamp));
    clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    return vbss_thread_attach(own.thread, &clamp, &id);
}

static bool goes_on(void)
{
    return own.steps < STEPS;
}

static vbss_result step(void)
{
    own.steps++;
    return vbss_thread_step(own.thread, SUBJECT_STEP);
}

static vbss_result hash(uint64_t *value)
{
    return vbss_thread_get_hash(own.thread, value);
}

static void end(void)
{
    (void)vbss_context_destroy(own.context);
}

const subject free_thread = {.name = "thread/free-120",
                             .begin = begin,
                             .goes_on = goes_on,
                             .step = step,
                             .hash = hash,
                             .end = end};
