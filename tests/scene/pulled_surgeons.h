/* A surgeon's knot round a cylinder that is pulled tight with 2 N: steps that take much work. */
#ifndef VBSS_TESTS_SCENE_PULLED_SURGEONS_H
#define VBSS_TESTS_SCENE_PULLED_SURGEONS_H

#include "harness/harness.h"
#include "fixtures/contact_scenes.h"

static inline void pulled_surgeons_init(contact_scene_options *o)
{
    expect_ok(contact_scene_init(o, CONTACT_SCENE_PULLED));
    o->knot.kind = KNOT_SURGEON;
    o->knot.cylinder = true;
    o->knot.length = 0.12;
    o->knot.finest = 0.4e-3;
    o->pull.force = 2.0;
    o->pull.speed = 0.05;
}

#endif
