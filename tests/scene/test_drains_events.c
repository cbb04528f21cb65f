/* Who touches a drain, and parts from it: a tool, a thread, the drain itself, another drain, the floor. */
#include "scene/drains_rig.h"

typedef struct story {
    uint32_t touched, parted;
    bool touches; /* now */
} story;

/* Events of a pair of bodies come in turn, and tell what the contacts show. */
static void listen(const small *s, uint32_t a, uint32_t b, story *y)
{
    const step_events events = step_events_of(s->scene);
    vbss_view contacts = small_view(s, VBSS_SCENE_VIEW_CONTACTS);
    bool shown = false;
    for (uint32_t i = 0; i < events.count; i++) {
        const vbss_scene_event *e = &events.of[i];
        if (e->body_a != a || e->body_b != b) {
            continue;
        }
        assert_true(e->kind == VBSS_SCENE_EVENT_TOUCH || e->kind == VBSS_SCENE_EVENT_PART);
        assert_int_equal(e->kind == VBSS_SCENE_EVENT_PART, y->touches);
        assert_int_equal(e->id, 0);
        y->touches = !y->touches;
        y->touched += y->touches;
        y->parted += !y->touches;
    }
    for (uint64_t i = 0; i < contacts.count; i++) {
        uint32_t f[5];
        memcpy(f, (const char *)contacts.data + i * contacts.stride_bytes, sizeof f);
        shown = shown || (f[1] == a && f[3] == b);
    }
    assert_true(!shown || y->touches);
}

static void tools_and_threads_touch_and_separate(void **state)
{
    (void)state;
    small s;
    drain_hands hands;
    story tool = {0}, thread = {0}, itself = {0};
    expect_ok(drain_hands_init(&hands));
    (void)drains_rig_begin(&s, &hands);
    for (int i = 0; i < 320; i++) {
        drains_rig_steps(&s, 1);
        listen(&s, DRAIN_HANDS_TOOL, DRAIN_HANDS_DRAIN, &tool);
        listen(&s, DRAIN_HANDS_THREAD, DRAIN_HANDS_DRAIN, &thread);
        listen(&s, DRAIN_HANDS_DRAIN, DRAIN_HANDS_DRAIN, &itself);
        if (i == 120) { /* it pushes; it is up in the air */
            assert_true(tool.touches);
        } else if (i == 299) {
            assert_false(tool.touches);
        }
    }
    assert_in_range(tool.touched, 1, 3);
    assert_int_equal(tool.parted, tool.touched - tool.touches);
    assert_true(thread.touched > 0);
    assert_int_equal(small_statistics(&s).clamped, 0);
    small_end(&s);
}

static uint32_t hold(vbss_drain *drain, uint32_t node)
{
    vbss_drain_attachment a;
    uint32_t id = 0;
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = node;
    vec3_store(a.position, drains_rig_object(drain)->x[node]);
    expect_ok(vbss_drain_attach(drain, &a, &id));
    return id;
}

/* Both edges of the slit are drawn to each other, and let go. */
static void shut_slit_touches_itself(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    vbss_drain_places places;
    story y = {0};
    uint32_t ids[2];
    small_begin_scene(&s);
    uint32_t body = small_drain(&s, &drain);
    expect_ok(vbss_drain_get_places(drain, &places, sizeof places));
    vec3 ends[2];
    for (int k = 0; k < 2; k++) {
        ids[k] = hold(drain, places.marks[k]);
        ends[k] = drains_rig_object(drain)->x[places.marks[k]];
    }
    for (int i = 0; i < 160; i++) {
        double travel = vbss_min(4e-5 * (i + 1), 2.6e-3);
        for (int k = 0; k < 2 && i < 80; k++) {
            double to[3] = {ends[k].x, ends[k].y, ends[k].z + (k == 0 ? travel : -travel)};
            expect_ok(vbss_drain_set_attachment_target(drain, ids[k], to));
        }
        if (i == 80) {
            assert_true(y.touches);
            expect_ok(vbss_drain_detach(drain, ids[0]));
            expect_ok(vbss_drain_detach(drain, ids[1]));
        }
        small_steps(&s, 1, 1e-3);
        listen(&s, body, body, &y);
    }
    assert_in_range(y.touched, 1, 4);
    assert_false(y.touches);
    assert_int_equal(small_view(&s, VBSS_SCENE_VIEW_CONTACTS).count, 0);
    assert_int_equal(small_statistics(&s).clamped, 0);
    small_end(&s);
}

/* A drain that tears off its block as it is heavier than its glue bears. */
static uint32_t drop(small *s, vec3 from, vbss_drain **drain)
{
    vec3_store(s->drain.position, from);
    s->drain.tear_stress = 1.0;
    s->drain.gravity[1] = -9.81;
    return small_drain(s, drain);
}

static void falling_drain_touches_floor(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    story y = {0};
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -7.2e-3;
    small_create(&s);
    uint32_t body = drop(&s, vec3_zero(), &drain);
    for (int i = 0; i < 150; i++) {
        small_steps(&s, 1, 1e-3);
        listen(&s, body, 0, &y);
    }
    assert_true(y.touches);
    expect_ok(vbss_scene_remove(s.scene, body)); /* who leaves has parted */
    small_steps(&s, 1, 1e-3);
    listen(&s, body, 0, &y);
    assert_false(y.touches);
    small_end(&s);
}

static void two_drains_touch(void **state)
{
    (void)state;
    small s;
    vbss_drain *falling;
    story y = {0};
    small_begin(&s);
    s.config.drain_capacity = 2;
    small_create(&s);
    uint32_t below = small_drain(&s, NULL);
    s.drain.orientation[0] = s.drain.orientation[2] = 1.0; /* across */
    uint32_t above = drop(&s, vec3_make(0.0, 14.2e-3, 0.0), &falling);
    for (int i = 0; i < 200; i++) {
        small_steps(&s, 1, 1e-3);
        listen(&s, below, above, &y);
    }
    assert_true(y.touched > 0);
    assert_int_equal(drains_rig_object(falling)->statistics.torn,
                     drains_rig_object(falling)->mesh.anchor_count);
    small_end(&s);
}

int test_drains_events(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tools_and_threads_touch_and_separate),
        cmocka_unit_test(shut_slit_touches_itself),
        cmocka_unit_test(falling_drain_touches_floor),
        cmocka_unit_test(two_drains_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
