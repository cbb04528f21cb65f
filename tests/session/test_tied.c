/* Throws of a real thread above a real drain: what the detector makes of them becomes events of the task. */
#include "rig.h"

static void run(uint32_t crossings, uint32_t steps, session_scene *s, vbss_context *context,
                vbss_session **session)
{
    expect_ok(session_scene_tying(context, crossings, s));
    s->config.seat_gap = 1e-3;
    s->config.seat_release = 2e-3;
    expect_ok(vbss_session_create(s->scene, &s->config, session));
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(session_scene_tie(s, *session, NULL));
    }
}

static void show(vbss_session *session)
{
    vbss_session_status t;
    expect_ok(vbss_session_get_status(session, &t, sizeof t));
    for (uint64_t i = t.first_event; i < t.event_count; i++) {
        vbss_session_event e;
        expect_ok(vbss_session_get_event(session, i, &e, sizeof e));
        printf("%6.3f kind %d number %u undone %u stage %d wraps %d hand %d phase %d amount %g\n", e.time,
               e.kind, e.number, e.undone, e.stage, e.wraps, e.handedness, e.phase, e.amount);
    }
    printf("phase %d stage %d throws %u seated %u tail %g gap %g tension %g %g\n", t.phase, t.stage,
           t.throws, t.seated, t.tail, t.gap, t.tension[0], t.tension[1]);
}

static void look(void **state)
{
    (void)state;
    for (uint32_t c = 1; c <= 5; c += 2) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        static session_scene s;
        vbss_session *session;
        run(c, STITCH_TIE_STEPS, &s, context, &session);
        show(session);
        harness_context_end(context, &memory);
    }
}

int test_tied(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(look),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
