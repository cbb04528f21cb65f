/* Work at drains that is counted and limited: what cannot be done in time waits, and is not lost. */
#include "scene/drains_rig.h"

enum { STEPS = 160 };

typedef struct limited {
    small s;
    drain_hands hands;
    vbss_scene_statistics before;
} limited;

static void begin(limited *l, uint32_t work_limit, uint32_t attempt_limit)
{
    expect_ok(drain_hands_init(&l->hands));
    l->hands.config.work_limit = work_limit;
    l->hands.config.attempt_limit = attempt_limit;
    (void)drains_rig_begin(&l->s, &l->hands);
}

static vbss_scene_statistics step(limited *l)
{
    l->before = small_statistics(&l->s);
    drains_rig_steps(&l->s, 1);
    return small_statistics(&l->s);
}

static void steps_with_hardly_any_work_pause(void **state)
{
    (void)state;
    const uint32_t limits[] = {1, 20000};
    for (int k = 0; k < 2; k++) {
        limited l;
        uint32_t event[4], paused = 0;
        begin(&l, limits[k], 1);
        for (int i = 0; i < STEPS; i++) {
            vbss_scene_statistics now = step(&l);
            bool waits = now.paused > l.before.paused;
            paused += waits;
            assert_true(!waits || now.time_paused > l.before.time_paused);
            assert_true(now.operations > l.before.operations);
            assert_int_equal(small_events(&l.s, VBSS_EVENT_CLAMPED, event),
                             waits + now.clamped - l.before.clamped);
            assert_int_equal(now.steps, l.before.steps + 1);
        }
        vbss_scene_statistics s = small_statistics(&l.s);
        vbss_drain_statistics d;
        expect_ok(vbss_drain_get_statistics(l.hands.drain, &d, sizeof d));
        assert_int_equal(s.paused, paused);
        assert_true(paused > STEPS / 4);
        assert_true(s.time_paused <= 1e-3 * paused);
        assert_int_equal(d.steps, STEPS);
        assert_int_equal(d.inverted, 0);
        assert_int_equal(d.torn, 0);
        small_end(&l.s);
    }
}

/* The default limit is above what this takes. */
static void with_the_default_nothing_waits(void **state)
{
    (void)state;
    limited l;
    begin(&l, 250000, 3);
    for (int i = 0; i < STEPS; i++) {
        vbss_scene_statistics now = step(&l);
        assert_int_equal(now.paused, 0);
    }
    vbss_scene_statistics s = small_statistics(&l.s);
    assert_true(s.most_operations < 250000);
    assert_true(s.operations / STEPS > 1000);
    small_end(&l.s);
}

/* Whoever waits all of a step rests where it is, the drain with its attachments too. */
static void a_drain_that_waits_rests_where_it_is(void **state)
{
    (void)state;
    limited l;
    uint32_t rested = 0;
    begin(&l, 1, 1);
    drain_object *d = drains_rig_object(l.hands.drain);
    for (int i = 0; i < STEPS; i++) {
        static vec3 x[256], v[256];
        memcpy(x, d->x, d->mesh.node_count * sizeof *x);
        memcpy(v, d->v, d->mesh.node_count * sizeof *v);
        vbss_scene_statistics now = step(&l);
        if (now.parts == l.before.parts) {
            assert_memory_equal(x, d->x, d->mesh.node_count * sizeof *x);
            assert_memory_equal(v, d->v, d->mesh.node_count * sizeof *v);
            rested++;
        }
    }
    assert_true(rested > 0);
    small_end(&l.s);
}

/* A hand that pulls a node along is not left behind for good, nor does the node jump after it. */
static void what_is_held_follows_evenly_after_a_pause(void **state)
{
    (void)state;
    limited l;
    vbss_drain_attachment a;
    vbss_drain_places places;
    uint32_t id, late = 0;
    begin(&l, 1, 1);
    vbss_drain *drain = l.hands.drain;
    expect_ok(vbss_drain_get_places(drain, &places, sizeof places));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = places.marks[0];
    vec3 from = drains_rig_object(drain)->x[a.node];
    vec3_store(a.position, from);
    expect_ok(vbss_drain_attach(drain, &a, &id));
    for (int i = 0; i < STEPS; i++) {
        double to[3] = {from.x, from.y, from.z - 2e-5 * greater(lesser(i, STEPS - 60), 0.0)};
        expect_ok(vbss_drain_move(drain, id, to));
        vec3 here = drains_rig_object(drain)->x[a.node];
        vbss_scene_statistics now = step(&l);
        vec3 there = drains_rig_object(drain)->x[a.node];
        double left = vec3_distance(vec3_load(to), here), went = vec3_distance(there, here);
        double share = 1.0 - (now.time_paused - l.before.time_paused) / 1e-3;
        expect_near(share * left, went,
                    1e-9); /* no more than the share of the step that was made */
        late += share < 1.0 && left > 0.0;
    }
    assert_true(late > 10);
    expect_near(from.z - 2e-5 * (STEPS - 60), drains_rig_object(drain)->x[a.node].z, 1e-6);
    small_end(&l.s);
}

/* A tool would go through the wall in one step, which has to wait: what the attempt that was thrown away would have done to
 * the drain tears no anchor, and no hand feels it. */
static void attempts_that_are_thrown_away_tear_nothing(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    small_begin(&s);
    s.config.work_limit = 1;
    small_create(&s);
    small_drain(&s, &drain);
    uint32_t tool = small_stick(&s, VBSS_RIGID_DRIVEN, vec3_make(10e-3, 8.2e-3, 0.0),
                                vec3_make(0.0, 0.0, 8e-3), 1e-3);
    small_steps(&s, 1, 1e-3); /* the first is finished whatever it takes */
    small_move(&s, tool, vec3_make(10e-3, -3e-3, 0.0));
    small_steps(&s, 1, 1e-3);
    const vbss_drain_statistics *d = &drains_rig_object(drain)->statistics;
    assert_int_equal(small_statistics(&s).paused, 1);
    assert_true(d->last_move == 0.0);
    assert_int_equal(d->torn, 0);
    small_end(&s);
}

int test_drains_work(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_with_hardly_any_work_pause),
        cmocka_unit_test(with_the_default_nothing_waits),
        cmocka_unit_test(a_drain_that_waits_rests_where_it_is),
        cmocka_unit_test(what_is_held_follows_evenly_after_a_pause),
        cmocka_unit_test(attempts_that_are_thrown_away_tear_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
