#include "scene/bend_case.h"

bend_outcome bend_case_run(bend_kind kind, double friction, double step, double segment,
                           vbss_scene_mode mode)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    bend_options options;
    expect_ok(bend_options_init(&options, kind));
    options.scene.thread_friction = friction;
    options.scene.mode = mode;
    options.step = step;
    options.segment = segment;
    bend b;
    expect_ok(bend_create(context, &options, &b));
    bend_outcome outcome = {.result = BEND_PULLED};
    while (outcome.result == BEND_PULLED) {
        expect_ok(bend_pull(&b, &outcome.result));
    }
    vbss_scene_statistics statistics;
    expect_ok(vbss_scene_get_statistics(b.scene, &statistics, sizeof statistics));
    outcome.force = bend_slip_force(&b);
    outcome.overlap = statistics.penetration / (2.0 * options.thread.radius);
    outcome.clamped = statistics.clamped;
    expect_ok(bend_destroy(&b));
    harness_context_end(context, &memory);
    return outcome;
}
