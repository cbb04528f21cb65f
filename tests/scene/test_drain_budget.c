/* Work at drains that is counted and limited: what cannot be done in time waits, and is not lost. */
#include "fixtures/solver_of.h"
#include "scene/drains_rig.h"

enum { STEPS = 60 };

typedef struct limited {
    small s;
    vbss_scene_statistics before;
} limited;

static drain_object *begin(limited *l, vbss_scene_mode mode, uint32_t step_budget)
{
    small_begin(&l->s);
    l->s.config.mode = mode;
    set_step_operations(&l->s.config, step_budget);
    set_call_operations(&l->s.config,
                        0); /* a call makes its step: what of it waits is seen by the step */
    leap_begin(&l->s);
    return drains_rig_object(drains_rig_of(l->s.scene));
}

static vbss_scene_statistics step(limited *l)
{
    l->before = small_statistics(&l->s);
    expect_ok(leap_step(l->s.scene));
    return small_statistics(&l->s);
}

static void steps_over_budget_pause(void **state)
{
    (void)state;
    const uint32_t limits[] = {1, 20000, 60000};
    for (int k = 0; k < 3; k++) {
        limited l;
        vbss_scene_event event;
        uint32_t paused = 0;
        const drain_object *d = begin(&l, VBSS_SCENE_MODE_REAL_TIME, limits[k]);
        for (int i = 0; i < STEPS; i++) {
            vbss_scene_statistics now = step(&l);
            bool waits = now.paused > l.before.paused;
            paused += waits;
            assert_true(waits ? now.time_paused > l.before.time_paused
                              : now.time_paused == l.before.time_paused);
            assert_true(now.operations > l.before.operations);
            assert_int_equal(small_events(&l.s, VBSS_SCENE_EVENT_PAUSED, &event), waits);
            assert_int_equal(small_events(&l.s, VBSS_SCENE_EVENT_TRUNCATED, &event),
                             now.clamped - l.before.clamped);
            assert_int_equal(now.steps, l.before.steps + 1);
        }
        vbss_scene_statistics s = small_statistics(&l.s);
        assert_int_equal(s.paused, paused);
        assert_true(paused > 5);
        assert_true(s.time_paused <= 1e-3 * paused);
        assert_int_equal(d->statistics.steps, STEPS);
        small_end(&l.s);
    }
}

/* The smallest part has the limit, too, and is halved further, a step each. When it was finished whatever it took, these steps took up to 1.7
 * million. */
static void substep_stays_near_budget(void **state)
{
    (void)state;
    const uint32_t limits[] = {50000, 100000, 150000, 250000};
    const uint64_t min_part = 200000; /* for which there is no limit */
    for (int k = 0; k < 4; k++) {
        limited l;
        uint64_t largest = 0;
        (void)begin(&l, VBSS_SCENE_MODE_REAL_TIME, limits[k]);
        step(&l); /* the first is finished */
        for (int i = 1; i < 5 * STEPS; i++) {
            vbss_scene_statistics now = step(&l);
            uint64_t work = now.operations - l.before.operations;
            largest = work > largest ? work : largest;
        }
        assert_true(small_statistics(&l.s).paused > 100);
        assert_in_range(largest, 1, 250000 + min_part);
        small_end(&l.s);
    }
}

/* With as much as there is by default hands that work at leisure never wait. */
static void default_budget_never_pauses(void **state)
{
    (void)state;
    small s;
    drain_hands hands;
    expect_ok(drain_hands_init(&hands));
    (void)drains_rig_begin(&s, &hands);
    drains_rig_steps(&s, 300);
    vbss_scene_statistics c = small_statistics(&s);
    assert_int_equal(c.paused, 0);
    assert_int_equal(c.clamped, 0);
    assert_true(c.most_operations < step_operations(&hands.config));
    assert_true(c.operations / 300 > 1000);
    small_end(&s);
}

/* Whoever waits all of a step rests where it is. */
static void paused_drain_is_static(void **state)
{
    (void)state;
    limited l;
    uint32_t rested = 0;
    const drain_object *d = begin(&l, VBSS_SCENE_MODE_REAL_TIME, 50000);
    const size_t bytes = d->mesh.node_count * sizeof *d->x;
    for (int i = 0; i < STEPS; i++) {
        static vec3 x[256], v[256];
        memcpy(x, d->x, bytes);
        memcpy(v, d->v, bytes);
        vbss_scene_statistics now = step(&l);
        if (now.parts == l.before.parts) {
            assert_memory_equal(x, d->x, bytes);
            assert_memory_equal(v, d->v, bytes);
            rested++;
        }
    }
    assert_true(rested > 2);
    small_end(&l.s);
}

/* A hand that draws a node along is not left behind for good, nor does the node jump after it: in what is made of a step it
 * goes that share of what is left of its way. */
static void held_node_follows_evenly_after_pause(void **state)
{
    (void)state;
    limited l;
    uint32_t late = 0;
    const drain_object *d = begin(&l, VBSS_SCENE_MODE_REAL_TIME, 50000);
    const drain_attachment *hand = &d->attachments[0];
    for (int i = 0; i < STEPS; i++) {
        vec3 here = d->x[hand->node];
        vbss_scene_statistics now = step(&l);
        double left = vec3_distance(hand->target, here);
        double share = 1.0 - (now.time_paused - l.before.time_paused) / 1e-3;
        if (now.clamped > l.before.clamped) {
            break; /* it is cut short, not late */
        }
        expect_near(share * left, vec3_distance(d->x[hand->node], here), 1e-9);
        late += share > 0.0 && share < 1.0 && left > 0.0;
    }
    assert_true(late > 3);
    small_end(&l.s);
}

/* Of the glue's strength, what the wall does to the anchor that bears most. */
static double largest_load(drain_object *d)
{
    double largest = 0.0;
    vbss_drain_compute_internal_forces(d, d->x);
    for (uint32_t k = 0; k < d->mesh.anchor_count; k++) {
        double load =
            vec3_norm(vbss_drain_anchor_force(d, k, d->internal_forces)) / d->anchor_strength[k];
        largest = vbss_max(load, largest);
    }
    return largest;
}

/* Parts are cut short where the rod would pass: what attempts that were thrown away would have done to the drain tears no
 * anchor. */
static void rejected_attempts_tear_nothing(void **state)
{
    (void)state;
    limited l;
    drain_object *d = begin(&l, VBSS_SCENE_MODE_OFFLINE, 0);
    expect_ok(vbss_drain_detach(drains_rig_of(l.s.scene), 1));
    for (int i = 0; i < LEAP_AT + 3; i++) {
        step(&l);
        assert_true(largest_load(d) < 1.0);
        assert_int_equal(d->statistics.torn, 0);
    }
    assert_true(small_statistics(&l.s).clamped > 10);
    small_end(&l.s);
}

int test_drain_budget(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_over_budget_pause),
        cmocka_unit_test(substep_stays_near_budget),
        cmocka_unit_test(default_budget_never_pauses),
        cmocka_unit_test(paused_drain_is_static),
        cmocka_unit_test(held_node_follows_evenly_after_pause),
        cmocka_unit_test(rejected_attempts_tear_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
