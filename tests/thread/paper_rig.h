/* What the tests of method VBLAST share. */
#ifndef VBSS_TESTS_THREAD_PAPER_RIG_H
#define VBSS_TESTS_THREAD_PAPER_RIG_H

#include "fixtures/baseline_of.h"
#include "thread/rig.h"

static const vec3 along = {1.0, 0.0, 0.0};

/* 150 mm, without damping. */
static inline vbss_thread_config paper(uint32_t segments)
{
    vbss_thread_config config = rig_config(0.15, segments);
    config.method = VBSS_METHOD_VBLAST;
    baseline_of(&config.baseline)->thread_damping = 0.0;
    return config;
}

#endif
