/* A drain that is alone in a scene moves to the bit as one that no scene has: the same order of elimination, the same looks
 * at the forces, the same halves. */
#include "drain/drain.h"
#include "scene/small.h"
#include "fixtures/drain_scenes.h"

enum { STEPS = 300 };
#define STEP 1e-3

typedef struct twins {
    small s;
    drain_scene alone, member;
} twins;

static void begin(twins *t, drain_scene_kind kind, vbss_scene_mode mode)
{
    small *s = &t->s;
    uint32_t body;
    small_begin(s);
    s->config.mode = mode;
    small_create(s);
    expect_ok(drain_scene_config(kind, &s->drain));
    expect_ok(drain_scene_create(s->context, kind, &s->drain, &t->alone));
    expect_ok(drain_scene_create(s->context, kind, &s->drain, &t->member));
    expect_ok(vbss_scene_add_drain(s->scene, t->member.drain, &body));
}

static void step(twins *t)
{
    expect_ok(drain_scene_step(&t->alone, STEP));
    expect_ok(drain_scene_drive(&t->member, STEP));
    small_steps(&t->s, 1, STEP);
}

static uint64_t hash_of(const drain_scene *d)
{
    uint64_t hash = 0;
    expect_ok(vbss_drain_get_hash(d->drain, &hash));
    return hash;
}

static vec3 node_of(const drain_scene *d, uint32_t node)
{
    vbss_view v;
    expect_ok(vbss_drain_get_view(d->drain, VBSS_DRAIN_VIEW_POSITIONS, &v, sizeof v));
    assert_true(node < v.count);
    return ((const vec3 *)v.data)[node];
}

static double farthest(const twins *t)
{
    vbss_drain_places places;
    double far = 0.0;
    expect_ok(vbss_drain_get_places(t->alone.drain, &places, sizeof places));
    for (uint32_t i = 0; i < places.node_count; i++) {
        far = vbss_max(vec3_distance(node_of(&t->alone, i), node_of(&t->member, i)), far);
    }
    return far;
}

/* Until something comes near itself, which it feels in a scene only. What is near is eliminated last: the same up to
 * rounding, in the step in which nothing touches yet. */
static void motion_equals_standalone_drain(void **state)
{
    (void)state;
    const uint32_t first_near[DRAIN_SCENE_KINDS] = {50, STEPS, 100}; /* at least */
    for (int mode = VBSS_SCENE_MODE_REAL_TIME; mode <= VBSS_SCENE_MODE_OFFLINE; mode++) {
        for (int kind = 0; kind < DRAIN_SCENE_KINDS; kind++) {
            twins t;
            uint32_t i = 0;
            begin(&t, (drain_scene_kind)kind, mode);
            step(&t);
            for (; i < STEPS && small_statistics(&t.s).rows == 0; i++) {
                if (hash_of(&t.alone) != hash_of(&t.member)) {
                    fail_msg("%s differs at step %u", drain_scene_names[kind], i);
                }
                step(&t);
            }
            assert_true(i >= first_near[kind]);
            if (small_statistics(&t.s).contacts == 0) {
                assert_true(farthest(&t) < 1e-15);
            }
            small_end(&t.s);
        }
    }
}

/* Another body far away is none of its business, nor is a floor below it. */
static void distant_body_changes_nothing(void **state)
{
    (void)state;
    twins t;
    begin(&t, DRAIN_SCENE_POKED, VBSS_SCENE_MODE_REAL_TIME);
    expect_ok(vbss_scene_destroy(t.s.scene));
    t.s.config.floor = 1;
    t.s.config.floor_height = -0.1;
    small_create(&t.s);
    small_thread(&t.s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.05, 0.1, 0.0), 20, NULL);
    uint32_t body;
    expect_ok(vbss_scene_add_drain(t.s.scene, t.member.drain, &body));
    small_stick(&t.s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.2, 0.0), vec3_zero(), 1e-3);
    for (int i = 0; i < 100; i++) {
        step(&t);
        expect_near(0.0, farthest(&t), 1e-12);
    }
    small_end(&t.s);
}

/* In the scene and out of it again, in the middle of a motion. */
static void drain_can_leave_and_return(void **state)
{
    (void)state;
    twins t;
    begin(&t, DRAIN_SCENE_POKED, VBSS_SCENE_MODE_REAL_TIME);
    uint32_t body = 1;
    for (int i = 0; i < 200; i++) {
        if (i % 40 == 20) {
            expect_ok(vbss_scene_remove(t.s.scene, body));
        }
        if (i % 40 < 20) {
            step(&t);
        } else {
            expect_ok(drain_scene_step(&t.alone, STEP));
            expect_ok(drain_scene_step(&t.member, STEP));
        }
        if (i % 40 == 39) {
            expect_ok(vbss_scene_add_drain(t.s.scene, t.member.drain, &body));
        }
        assert_true(hash_of(&t.alone) == hash_of(&t.member));
    }
    small_end(&t.s);
}

int test_drain_standalone(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(motion_equals_standalone_drain),
        cmocka_unit_test(distant_body_changes_nothing),
        cmocka_unit_test(drain_can_leave_and_return),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
